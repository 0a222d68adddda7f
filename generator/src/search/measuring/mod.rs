//! Runs an interpreted plan on random real instances and measures what it finds: the numbers are
//! those of the emitted solver, bit by bit.

pub mod interpreted;
mod interpreted_chains;
mod interpreted_elimination;
mod interpreted_program;
pub mod results;
pub mod scene_check;

use std::ops::Range;
use std::sync::OnceLock;
use std::sync::atomic::AtomicBool;

use rayon::ThreadPool;

use crate::algebra::Random;
use crate::expression::arithmetic::Float64;
use crate::plan::Plan;
use crate::problem::draw::draw_inputs;
use crate::search::monitor::is_set;
use interpreted::InterpretedSolver;
use results::has_known;

/// What a solver does on many instances.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "command", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Stability {
    /// log10 of the relative residual of every solution found, to three decimals, increasing.
    pub residuals_log10: Vec<f64>,
    /// Number of instances.
    pub trials: usize,
    /// Number of different complex solutions found, over all instances.
    pub found: usize,
    /// Number of solutions there are: trials times the number of solutions of the problem.
    pub expected: usize,
    /// Number of instances with fewer solutions, or with a scene of which the known solution was
    /// not found.
    pub incomplete: usize,
    /// Number of scenes whose solution is known: one beside every instance, or none.
    pub scenes: usize,
    /// Number of those whose known solution was not found.
    pub scenes_missed: usize,
    /// Number of those on which there was a second attempt.
    pub scenes_repeated: usize,
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
        self.scenes += other.scenes;
        self.scenes_missed += other.scenes_missed;
        self.scenes_repeated += other.scenes_repeated;
        self.failures += other.failures;
        self.repeated += other.repeated;
        self.residuals_log10.extend(other.residuals_log10);
        self.residuals_log10.sort_by(f64::total_cmp);
    }

    fn add(&mut self, expected: usize, Solved { residuals, is_repeated, scene }: Solved) {
        self.trials += 1;
        self.repeated += usize::from(is_repeated);
        self.expected += expected;
        let is_missed = scene.as_ref().is_some_and(|scene| !scene.is_known_found);
        self.scenes += usize::from(scene.is_some());
        self.scenes_missed += usize::from(is_missed);
        self.scenes_repeated += usize::from(scene.is_some_and(|scene| scene.is_repeated));
        let Some(residuals) = residuals else {
            self.failures += 1;
            return;
        };
        self.found += residuals.len();
        self.incomplete += usize::from(residuals.len() < expected || is_missed);
        self.residuals_log10
            .extend(residuals.iter().map(|residual| (1000.0 * residual.max(1e-17).log10()).round() / 1000.0));
    }
}

/// Solves the first `trials` instances; see [`measure`].
pub fn stability(plan: &Plan, trials: usize, seed: u64) -> Stability {
    measure(plan, 0..trials, seed, None)
}

/// Solves instances drawn on the data's variety; instance k depends on (seed, k) only. If the
/// problem has a scene that says what solves it, a scene is solved with each. Where the flag is set
/// no further instance is begun, and only those before the first that was not begun are counted.
pub fn measure(plan: &Plan, instances: Range<usize>, seed: u64, interruption: Option<&AtomicBool>) -> Stability {
    use rayon::prelude::*;
    let solver = InterpretedSolver::of(plan);
    let solve = |k: usize| (!is_set(interruption)).then(|| Solved::of_instance(plan, &solver, (seed, k)));
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

/// What the solver does on one instance, and on the scene beside it.
struct Solved {
    /// The relative residuals of all complex solutions; `None` if the solver returned an error.
    residuals: Option<Vec<f64>>,
    /// Whether there was a second attempt.
    is_repeated: bool,
    /// The scene, if there is one.
    scene: Option<SolvedScene>,
}

/// What the solver does on a scene.
struct SolvedScene {
    /// Whether the known solution is among the real ones that are returned.
    is_known_found: bool,
    /// Whether there was a second attempt.
    is_repeated: bool,
}

impl Solved {
    fn of_instance(plan: &Plan, solver: &InterpretedSolver, (seed, k): (u64, usize)) -> Self {
        let scene = SolvedScene::beside(plan, solver, seed_of(seed, k));
        let none = Self { residuals: None, is_repeated: false, scene };
        let Ok(mut instance) = solver.instance(&random_instance(plan, seed, k)) else { return none };
        let found = instance.solve_complex();
        let residuals = found.map(|found| found.iter().map(|point| instance.residual(point)).collect()).ok();
        Self { residuals, is_repeated: instance.attempts() > 1, ..none }
    }
}

impl SolvedScene {
    /// The scene of this seed, if the problem has one that says what solves it.
    fn beside(plan: &Plan, solver: &InterpretedSolver, seed: u64) -> Option<Self> {
        let scene = plan.scene.as_ref().filter(|scene| scene.has_truth())?.draw(&mut Random::new(seed))?;
        let Ok(mut instance) = solver.instance(&scene.data) else {
            return Some(Self { is_known_found: false, is_repeated: false });
        };
        let is_known_found = instance.solve().is_ok_and(|points| has_known(plan, &points, &scene));
        Some(Self { is_known_found, is_repeated: instance.attempts() > 1 })
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
