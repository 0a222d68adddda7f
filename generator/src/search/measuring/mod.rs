//! Runs an interpreted plan on random real instances and measures what it finds: the numbers are
//! those of the emitted solver, bit by bit.

pub mod interpreted;
mod interpreted_chains;
mod interpreted_elimination;
mod interpreted_program;

use std::ops::Range;
use std::sync::OnceLock;
use std::sync::atomic::AtomicBool;

use rayon::ThreadPool;

use crate::algebra::Random;
use crate::expression::arithmetic::Float64;
use crate::plan::Plan;
use crate::problem::instance::draw_inputs;
use crate::search::monitor::is_set;
use interpreted::InterpretedSolver;

/// What a solver does on many instances.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stability {
    /// log10 of the relative residual of every solution found, to three decimals, increasing.
    pub residuals_log10: Vec<f64>,
    /// Number of instances.
    pub trials: usize,
    /// Number of different complex solutions found, over all instances.
    pub found: usize,
    /// Number of solutions there are: trials times the number of solutions of the problem.
    pub expected: usize,
    /// Number of instances with fewer solutions than the problem has.
    pub incomplete: usize,
    /// Number of instances on which the solver returned an error.
    pub failures: usize,
    /// Instances on which the first attempt failed or lacked a solution. What the second one found
    /// is in the others.
    pub repeated: usize,
}

impl Stability {
    /// The q-quantile of the log10 relative residuals; `None` if nothing was found.
    pub fn quantile(&self, q: f64) -> Option<f64> {
        let last = self.residuals_log10.len().checked_sub(1)?;
        self.residuals_log10.get((q * last as f64).round() as usize).copied()
    }

    /// Adds the figures of other instances.
    pub fn join(&mut self, other: Self) {
        self.trials += other.trials;
        self.found += other.found;
        self.expected += other.expected;
        self.incomplete += other.incomplete;
        self.failures += other.failures;
        self.repeated += other.repeated;
        self.residuals_log10.extend(other.residuals_log10);
        self.residuals_log10.sort_by(f64::total_cmp);
    }

    fn add(&mut self, expected: usize, Solved { residuals, is_repeated }: Solved) {
        self.trials += 1;
        self.repeated += usize::from(is_repeated);
        self.expected += expected;
        match residuals {
            None => self.failures += 1,
            Some(residuals) => {
                self.found += residuals.len();
                self.incomplete += usize::from(residuals.len() < expected);
                self.residuals_log10
                    .extend(residuals.iter().map(|residual| (1000.0 * residual.max(1e-17).log10()).round() / 1000.0));
            }
        }
    }
}

/// Solves the first `trials` instances; see [`measure`].
pub fn stability(plan: &Plan, trials: usize, seed: u64) -> Stability {
    measure(plan, 0..trials, seed, None)
}

/// Solves instances drawn on the data's variety; instance k depends on (seed, k) only. Where the
/// flag is set no further instance is begun, and only those before the first that was not begun are
/// counted.
pub fn measure(plan: &Plan, instances: Range<usize>, seed: u64, interruption: Option<&AtomicBool>) -> Stability {
    use rayon::prelude::*;
    let solver = InterpretedSolver::of(plan);
    let solve = |k: usize| (!is_set(interruption)).then(|| Solved::of(&solver, &random_instance(plan, seed, k)));
    let results: Vec<Option<Solved>> = in_pool(|| instances.into_par_iter().map(solve).collect());
    let mut stability = Stability::default();
    results.into_iter().map_while(|solved| solved).for_each(|solved| stability.add(plan.solutions, solved));
    stability.residuals_log10.sort_by(f64::total_cmp);
    stability
}

/// Instance k: data on their variety, which depend on (seed, k) only.
pub fn random_instance(plan: &Plan, seed: u64, k: usize) -> Vec<f64> {
    draw_inputs(&plan.data, Float64, &mut Random::new(seed_of(seed, k)))
}

/// The seed of instance k.
pub fn seed_of(seed: u64, k: usize) -> u64 {
    seed.wrapping_mul(0x9e37_79b9_7f4a_7c15).wrapping_add(k as u64)
}

/// What the solver does on one instance.
struct Solved {
    /// The relative residuals of all complex solutions; `None` if the solver returned an error.
    residuals: Option<Vec<f64>>,
    /// Whether there was a second attempt.
    is_repeated: bool,
}

impl Solved {
    fn of(solver: &InterpretedSolver, inputs: &[f64]) -> Self {
        let Ok(mut instance) = solver.instance(inputs) else { return Self { residuals: None, is_repeated: false } };
        let found = instance.solve_complex();
        let residuals = found.map(|found| found.iter().map(|point| instance.residual(point)).collect()).ok();
        Self { residuals, is_repeated: instance.attempts() > 1 }
    }
}

/// Bytes of stack for each thread that solves. A second attempt with 256 basis monomials takes 8
/// MiB.
const STACK: usize = 32 << 20;

/// Runs parallel work on threads with a stack that is large enough for every solver.
pub(crate) fn in_pool<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    static POOL: OnceLock<Option<ThreadPool>> = OnceLock::new();
    // If threads with such a stack cannot be had, the usual ones serve all but the largest
    // problems.
    match POOL.get_or_init(|| rayon::ThreadPoolBuilder::new().stack_size(STACK).build().ok()) {
        Some(pool) => pool.install(work),
        None => work(),
    }
}
