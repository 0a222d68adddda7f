//! Runs an interpreted plan on random real instances and measures what it finds.

mod polish;
mod precise;
mod schur_form;
mod shared_value;
mod twice;

use std::ops::Range;

use nalgebra::{Complex, DMatrix, DVector};

use crate::algebra::Random;
use crate::expression::arithmetic::Float64;
use crate::plan::code::CodeForm;
use crate::plan::interpret::{Eliminated, coefficients, eliminate};
use crate::plan::{KnownMonomial, Plan};
use crate::problem::instance::draw_inputs;
use polish::{Polynomials, polish, without_noise};
use precise::{Hessenberg, round};
use qd::Quad;
use schur_form::SchurForm;
use twice::{Twice, rounded};

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
    /// Instances on which the first attempt failed or lacked a solution. What the second one found is in the others.
    pub repeated: usize,
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
        self.repeated += other.repeated;
        self.residuals_log10.extend(other.residuals_log10);
        self.residuals_log10.sort_by(f64::total_cmp);
    }

    fn add(&mut self, expected: usize, (residuals, is_repeated): (Option<Vec<f64>>, bool)) {
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
pub fn stability(plan: &Plan, trials: usize, seed: u64, each: &(dyn Fn() + Sync)) -> Stability {
    measure(plan, 0..trials, seed, each)
}

/// Solves instances drawn on the data's variety; instance k depends on (seed, k) only. `each` is called after each.
pub fn measure(plan: &Plan, instances: Range<usize>, seed: u64, each: &(dyn Fn() + Sync)) -> Stability {
    use rayon::prelude::*;
    let results: Vec<(Option<Vec<f64>>, bool)> = instances
        .into_par_iter()
        .map(|k| {
            let mut random = Random::new(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15).wrapping_add(k as u64));
            let inputs = draw_inputs(&plan.data, Float64, &mut random);
            let (found, is_repeated) = attempts(plan, &inputs);
            each();
            (found.map(|solutions| solutions.into_iter().map(|(_, residual)| residual).collect()), is_repeated)
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
    attempts(plan, inputs).0
}

/// What [`solve`] returns, and whether it took a second attempt, as in emitted code: with an elimination at twice the precision, and so the coefficients
/// where they come from a table, and the eigenvalues where those in `f64` do not do.
fn attempts(plan: &Plan, inputs: &[f64]) -> (Option<Vec<(Point, f64)>>, bool) {
    let Some(c) = coefficients(plan, Float64, inputs) else { return (None, false) };
    let instance = Instance::new(plan, &c);
    let origin = plan.has_origin.then(|| (vec![Complex::ZERO; plan.unknowns.len()], 0.0));
    let mut found = Vec::from_iter(origin);
    let first = eliminate(plan, Float64, &c).and_then(|eliminated| instance.add_all(&eliminated, &mut found));
    let has_precise_coefficients = plan.code.form == CodeForm::Table;
    if found.len() >= plan.solutions || (first.is_none() && !has_precise_coefficients) {
        found.truncate(plan.solutions);
        return (first.map(|()| found), false);
    }
    let lifted = |values: &[f64]| values.iter().map(|&value| value.into()).collect::<Vec<_>>();
    let c = if has_precise_coefficients { coefficients(plan, Twice, &lifted(inputs)) } else { Some(lifted(&c)) };
    let second = c.and_then(|c| eliminate(plan, Twice, &c)).and_then(|e| instance.add_all_precisely(e, &mut found));
    found.truncate(plan.solutions);
    (first.or(second).map(|()| found), true)
}

/// The equations of a plan with the coefficients of one instance.
struct Instance<'a> {
    plan: &'a Plan,
    equations: Polynomials<'a>,
    nonzero: Polynomials<'a>,
    recoveries: Vec<Polynomials<'a>>,
}

impl<'a> Instance<'a> {
    fn new(plan: &'a Plan, c: &[f64]) -> Self {
        let recoveries = plan.recoveries.iter().map(|recovery| Polynomials::new([&recovery.terms], c)).collect();
        let (equations, nonzero) = (Polynomials::new(&plan.equations, c), Polynomials::new(&plan.nonzero, c));
        Self { plan, equations, nonzero, recoveries }
    }

    /// Adds the solutions of all eigenpairs; `None` where there are none to be had.
    fn add_all(&self, eliminated: &Eliminated<f64>, found: &mut Vec<(Point, f64)>) -> Option<()> {
        let columns = self.plan.elimination.basis;
        let action = matrix(&eliminated.action, columns);
        if action.iter().any(|x| !x.is_finite()) {
            return None;
        }
        let schur = SchurForm::of_real(&action)?;
        let (complex, read) = (action.map(Complex::from), matrix(&eliminated.read, columns).map(Complex::from));
        let values = schur.values();
        for value in values.iter() {
            let Some(vector) = schur.vector(*value) else { continue };
            self.add(*value, &vector, &read, found);
        }
        if found.len() < self.plan.solutions {
            for (value, vector) in shared_value::eigenpairs(&complex, &read, &self.plan.extractions, &values) {
                self.add(value, &vector, &read, found);
            }
        }
        Some(())
    }

    /// The same from what is known to twice the precision.
    fn add_all_precisely(&self, eliminated: Eliminated<Quad>, found: &mut Vec<(Point, f64)>) -> Option<()> {
        let in_f64 = |rows: &[Vec<Quad>]| -> Vec<Vec<f64>> {
            rows.iter().map(|row| row.iter().map(|&x| rounded(x)).collect()).collect()
        };
        let usual = Eliminated { action: in_f64(&eliminated.action), read: in_f64(&eliminated.read) };
        let first = self.add_all(&usual, found);
        if found.len() >= self.plan.solutions {
            return first;
        }
        let hessenberg = Hessenberg::of(eliminated.action);
        let Some(values) = hessenberg.eigenvalues() else { return first };
        let read = matrix(&usual.read, self.plan.elimination.basis).map(Complex::from);
        for value in values {
            if let Some(vector) = hessenberg.vector(value) {
                self.add(round(value), &vector, &read, found);
            }
        }
        Some(())
    }

    /// Adds the solution of an eigenpair, if it gives one, with those that differ by signs only.
    fn add(
        &self,
        value: Complex<f64>,
        vector: &DVector<Complex<f64>>,
        read: &DMatrix<Complex<f64>>,
        found: &mut Vec<(Point, f64)>,
    ) {
        let Some(mut point) = unknowns(self.plan, &self.recoveries, value, vector, &(read * vector)) else { return };
        let residual = polish(&self.equations, &mut point);
        // A product of unknowns is never small relative to its terms.
        let factors = self.nonzero.values(&without_noise(&point));
        let is_admissible = factors.iter().all(|(value, scale)| value.norm() > VANISHING * scale);
        // A NaN is no small residual.
        let is_solution = residual <= MAX_RESIDUAL && is_admissible;
        if !is_solution {
            return;
        }
        for flip in &self.plan.flips {
            let flipped = point.iter().zip(flip).map(|(&x, &changes)| if changes { -x } else { x }).collect();
            add(found, (flipped, residual));
        }
        add(found, (point, residual));
    }
}

fn matrix(rows: &[Vec<f64>], columns: usize) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), columns, |i, j| rows[i][j])
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
