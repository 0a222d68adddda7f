//! Runs an interpreted plan on random real instances and measures what it finds.

mod polish;
mod schur_form;
mod shared_value;

use std::ops::Range;

use nalgebra::{Complex, DMatrix, DVector};

use crate::arithmetic::Float64;
use crate::instance::{Random, draw_inputs};
use crate::interpret::{Eliminated, coefficients, eliminate};
use crate::plan::{KnownMonomial, Plan};
use polish::{Polynomials, polish, without_noise};
use schur_form::SchurForm;

/// What many instances gave.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stability {
    /// log10 of the relative residual of every solution found, to three decimals, increasing.
    pub residuals_log10: Vec<f64>,
    /// Instances drawn.
    pub trials: usize,
    /// Different complex solutions found, over all instances.
    pub found: usize,
    /// Solutions there are: trials times the number of solutions of the problem.
    pub expected: usize,
    /// Instances with fewer solutions than the problem has.
    pub incomplete: usize,
    /// Instances on which the elimination or the eigenvalue iteration failed.
    pub failures: usize,
}

impl Stability {
    /// The q-quantile of the log10 relative residuals; `None` where nothing was found.
    pub fn quantile(&self, q: f64) -> Option<f64> {
        let last = self.residuals_log10.len().checked_sub(1)?;
        self.residuals_log10.get((q * last as f64).round() as usize).copied()
    }

    /// Adds what other instances gave.
    pub fn join(&mut self, other: Self) {
        self.trials += other.trials;
        self.found += other.found;
        self.expected += other.expected;
        self.incomplete += other.incomplete;
        self.failures += other.failures;
        self.residuals_log10.extend(other.residuals_log10);
        self.residuals_log10.sort_by(f64::total_cmp);
    }

    fn add(&mut self, expected: usize, residuals: Option<Vec<f64>>) {
        self.trials += 1;
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
pub fn stability(plan: &Plan, trials: usize, seed: u64, each: &(dyn Fn() + Sync)) -> Stability {
    measure(plan, 0..trials, seed, each)
}

/// Solves instances drawn on the data's variety; instance k depends on (seed, k) only. `each` is called after each.
pub fn measure(plan: &Plan, instances: Range<usize>, seed: u64, each: &(dyn Fn() + Sync)) -> Stability {
    use rayon::prelude::*;
    let results: Vec<Option<Vec<f64>>> = instances
        .into_par_iter()
        .map(|k| {
            let mut random = Random::new(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15).wrapping_add(k as u64));
            let inputs = draw_inputs(&plan.data, Float64, &mut random);
            let found = solve(plan, &inputs);
            each();
            found.map(|solutions| solutions.into_iter().map(|(_, residual)| residual).collect())
        })
        .collect();
    let mut stability = Stability::default();
    results.into_iter().for_each(|residuals| stability.add(plan.solutions, residuals));
    stability.residuals_log10.sort_by(f64::total_cmp);
    stability
}

type Point = Vec<Complex<f64>>;

/// Solutions whose relative residual is above this after the polish are discarded, as in emitted code.
const MAX_RESIDUAL: f64 = 1e-10;
/// A factor that must not vanish does if it is below this, relative to its terms.
const VANISHING: f64 = 1e-8;
/// Two solutions are the same when every unknown agrees to this relative distance.
const SAME: f64 = 1e-8;
/// An unknown this small relative to the largest one may be the rounding noise of zero.
const SAME_FLOOR: f64 = 1e-13;

/// All complex solutions of one instance with their relative residuals; `None` where a step fails.
pub fn solve(plan: &Plan, inputs: &[f64]) -> Option<Vec<(Point, f64)>> {
    let c = coefficients(plan, Float64, inputs)?;
    let Eliminated { action, read } = eliminate(plan, Float64, &c)?;
    let matrix = |rows: &[Vec<f64>]| DMatrix::from_fn(rows.len(), plan.elimination.basis, |i, j| rows[i][j]);
    let action = matrix(&action);
    if action.iter().any(|x| !x.is_finite()) {
        return None;
    }
    let schur = SchurForm::of_real(&action)?;
    let (complex, read) = (action.map(Complex::from), matrix(&read).map(Complex::from));
    let values = schur.values();
    let (equations, nonzero) = (Polynomials::new(&plan.equations, &c), Polynomials::new(&plan.nonzero, &c));
    let recoveries: Vec<Polynomials<'_>> =
        plan.recoveries.iter().map(|recovery| Polynomials::new([&recovery.terms], &c)).collect();
    let solution = |(value, vector): (Complex<f64>, DVector<Complex<f64>>)| {
        let mut point = unknowns(plan, &recoveries, value, &vector, &(&read * &vector))?;
        let residual = polish(&equations, &mut point);
        // A product of unknowns is never small relative to its terms.
        let factors = nonzero.values(&without_noise(&point, &point));
        let admissible = factors.iter().all(|(value, scale)| value.norm() > VANISHING * scale);
        (residual <= MAX_RESIDUAL && admissible).then_some((point, residual))
    };
    let mut found = Vec::new();
    let add = |found: &mut Vec<(Point, f64)>, (point, residual): (Point, f64)| {
        for flip in &plan.flips {
            let flipped = point.iter().zip(flip).map(|(&x, &changes)| if changes { -x } else { x }).collect();
            add(found, (flipped, residual));
        }
        add(found, (point, residual));
    };
    let eigenpairs = values.iter().filter_map(|&value| Some((value, schur.vector(value)?)));
    eigenpairs.filter_map(solution).for_each(|solution| add(&mut found, solution));
    if found.len() < plan.solutions {
        let eigenpairs = shared_value::eigenpairs(&complex, &read, &plan.extractions, &values);
        eigenpairs.into_iter().filter_map(solution).for_each(|solution| add(&mut found, solution));
    }
    found.truncate(plan.solutions);
    Some(found)
}

/// Of two that are the same the one with the smaller residual stays.
fn add(found: &mut Vec<(Point, f64)>, solution: (Point, f64)) {
    match found.iter_mut().find(|(known, _)| is_same(known, &solution.0)) {
        Some(known) if solution.1 < known.1 => *known = solution,
        Some(_) => {}
        None => found.push(solution),
    }
}

fn is_same(a: &Point, b: &Point) -> bool {
    let floor = SAME_FLOOR * a.iter().chain(b).map(|x| x.norm()).fold(0.0, f64::max);
    a.iter().zip(b).all(|(x, y)| (x - y).norm() <= floor + SAME * x.norm().max(y.norm()))
}

fn unknowns(
    plan: &Plan,
    recoveries: &[Polynomials<'_>],
    value: Complex<f64>,
    vector: &DVector<Complex<f64>>,
    read: &DVector<Complex<f64>>,
) -> Option<Point> {
    let known = |monomial: &KnownMonomial| match monomial {
        KnownMonomial::Basis(b) => vector[usize::from(b.0)],
        KnownMonomial::Image(b) => vector[usize::from(b.0)] * value,
        KnownMonomial::Read(at) => read[usize::from(*at)],
    };
    let mut point = vec![Complex::ZERO; plan.unknowns.len()];
    for extraction in &plan.extractions {
        let (mut numerator, mut denominator) = (Complex::ZERO, 0.0);
        for (m, xm) in &extraction.pairs {
            numerator += known(m).conj() * known(xm);
            denominator += known(m).norm_sqr();
        }
        let ratio: Complex<f64> = numerator / denominator;
        let root = if extraction.is_square() { ratio.sqrt() } else { ratio };
        let others = extraction.others().map(|(other, e)| point[other].powi(-i32::from(e)));
        point[extraction.unknown] = others.fold(root, |product, factor| product * factor);
    }
    for (recovery, polynomial) in plan.recoveries.iter().zip(recoveries) {
        point[recovery.unknown] = polynomial.values(&point).first()?.0;
    }
    point.iter().all(|x| x.re.is_finite() && x.im.is_finite()).then_some(point)
}
