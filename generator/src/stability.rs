//! Runs an interpreted plan on random real instances and measures what it finds.

mod shared_value;

use std::ops::Range;

use nalgebra::{Complex, DMatrix, DVector, Schur};

use crate::arithmetic::Float64;
use crate::instance::{Random, draw_inputs};
use crate::interpret::{Eliminated, coefficients, eliminate};
use crate::plan::{KnownMonomial, Plan, Term};

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
/// Newton steps at most.
const POLISH_STEPS: usize = 8;
/// A relative residual above this after a step has a cause other than rounding.
const STALLED: f64 = 1e-12;
/// An unknown this small relative to the largest one may be the rounding noise of zero.
const NOISE: f64 = 1e-12;
/// A step that shrinks all unknowns to this part may lead to the origin, of which no point nearby has a small relative residual if it is a solution.
const TOWARDS_ORIGIN: f64 = 1e-2;
/// A step that would change an unknown by more than this part of it, where the residual is no rounding error or stays below [`FLAT`], shows that
/// there is no solution near by.
const FAR: f64 = 0.1;
/// Unknowns at least this large may be on the way to infinity: they are if half of them gives a residual that is rounding, too.
const LARGE: f64 = 1e6;
/// A relative residual below this after a long step shows a direction in which the equations are nearly constant.
const FLAT: f64 = 1e-6;
/// Two solutions are the same when every unknown agrees to this relative distance.
const SAME: f64 = 1e-8;
/// An unknown this small relative to the largest one may be the rounding noise of zero.
const SAME_FLOOR: f64 = 1e-13;
/// QR iterations at most.
const MAX_ITERATIONS: usize = 10_000;

/// All complex solutions of one instance with their relative residuals; `None` where a step fails.
pub fn solve(plan: &Plan, inputs: &[f64]) -> Option<Vec<(Point, f64)>> {
    let c = coefficients(plan, Float64, inputs)?;
    let Eliminated { action, read } = eliminate(plan, Float64, &c)?;
    let matrix =
        |rows: &[Vec<f64>]| DMatrix::from_fn(rows.len(), plan.elimination.basis, |i, j| Complex::new(rows[i][j], 0.0));
    let (complex, read) = (matrix(&action), matrix(&read));
    if complex.iter().any(|x| !x.re.is_finite()) {
        return None;
    }
    let schur = SchurForm::new(&complex)?;
    let values = schur.values();
    let solution = |(value, vector): (Complex<f64>, DVector<Complex<f64>>)| {
        let mut point = unknowns(plan, &c, value, &vector, &(&read * &vector))?;
        let residual = polish(plan, &c, &mut point);
        // A product of unknowns is never small relative to its terms.
        let noise = NOISE * point.iter().map(|x| x.norm()).fold(0.0, f64::max);
        let without_noise = point.iter().map(|&x| if x.norm() <= noise { Complex::ZERO } else { x }).collect();
        let admissible = plan.nonzero.iter().all(|factor| {
            let (value, scale, _) = evaluate(factor, &c, &without_noise);
            value.norm() > VANISHING * scale
        });
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
    if found.len() < values.len() * (1 + plan.flips.len()) {
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

/// A matrix as Q T Q*, with T upper triangular.
struct SchurForm {
    q: DMatrix<Complex<f64>>,
    t: DMatrix<Complex<f64>>,
}

impl SchurForm {
    /// In complex arithmetic: the real form of nalgebra gives NaN for blocks that hold two real eigenvalues. Where the iteration stalls, as it can
    /// on spectra that are symmetric about zero, a complex shift breaks the symmetry.
    fn new(matrix: &DMatrix<Complex<f64>>) -> Option<Self> {
        let n = matrix.nrows();
        let shift = Complex::new(0.3, 0.7) * matrix.norm();
        [Complex::ZERO, shift].into_iter().find_map(|shift| {
            let shifted = matrix + DMatrix::from_diagonal_element(n, n, shift);
            let (q, t) = Schur::try_new(shifted, f64::EPSILON, MAX_ITERATIONS)?.unpack();
            Some(Self { q, t: t - DMatrix::from_diagonal_element(n, n, shift) })
        })
    }

    fn values(&self) -> DVector<Complex<f64>> {
        self.t.diagonal()
    }

    /// Two steps of inverse iteration. The eigenvalue is moved by a few units of rounding, further where the shifted matrix is still singular to
    /// the last bit.
    fn vector(&self, value: Complex<f64>) -> Option<DVector<Complex<f64>>> {
        let unit = self.t.norm().max(f64::MIN_POSITIVE) * f64::EPSILON;
        let factors = [1.0, 4.0, 16.0, 64.0].into_iter();
        factors.map(|factor| value + factor * unit).find_map(|shift| self.inverse_iteration(shift))
    }

    fn inverse_iteration(&self, shift: Complex<f64>) -> Option<DVector<Complex<f64>>> {
        let n = self.t.nrows();
        let mut vector = self.q.ad_mul(&DVector::from_fn(n, |i, _| Complex::new(1.0 / (1.0 + i as f64), 0.0)));
        for _ in 0..2 {
            for i in (0..n).rev() {
                let pivot = self.t[(i, i)] - shift;
                if pivot == Complex::ZERO {
                    return None;
                }
                let solved = vector[i] / pivot;
                vector[i] = solved;
                for k in 0..i {
                    vector[k] -= self.t[(k, i)] * solved;
                }
            }
            let norm = vector.norm();
            if !(norm.is_finite() && norm > 0.0) {
                return None;
            }
            vector /= Complex::new(norm, 0.0);
        }
        Some(&self.q * vector)
    }
}

fn unknowns(
    plan: &Plan,
    c: &[f64],
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
    for recovery in &plan.recoveries {
        point[recovery.unknown] = evaluate(&recovery.terms, c, &point).0;
    }
    point.iter().all(|x| x.re.is_finite() && x.im.is_finite()).then_some(point)
}

/// Value, sum of the moduli of the terms, and gradient.
fn evaluate(terms: &[Term], c: &[f64], x: &Point) -> (Complex<f64>, f64, Point) {
    let (mut value, mut scale) = (Complex::ZERO, 0.0);
    let mut gradient = vec![Complex::ZERO; x.len()];
    for term in terms {
        let coefficient = Complex::new(c[usize::from(term.coefficient.0)], 0.0);
        let power = |j: usize, e: u8| x[j].powu(u32::from(e));
        let factors: Vec<Complex<f64>> = term.exponents.iter().enumerate().map(|(j, &e)| power(j, e)).collect();
        let product = factors.iter().fold(coefficient, |product, factor| product * factor);
        value += product;
        scale += product.norm();
        for (j, &e) in term.exponents.iter().enumerate().filter(|(_, e)| **e > 0) {
            let others = (0..x.len()).filter(|&k| k != j).fold(coefficient, |product, k| product * factors[k]);
            gradient[j] += others * power(j, e - 1) * f64::from(e);
        }
    }
    (value, scale, gradient)
}

/// Gauss-Newton on all equations while it lowers the relative residual, which is returned. A step that leaves a high residual is tried again
/// with unknowns at the level of noise set to zero. Infinity where the last step is large and the residual high, or small after it, too.
fn polish(plan: &Plan, c: &[f64], point: &mut Point) -> f64 {
    let evaluate_all = |x: &Point| plan.equations.iter().map(|terms| evaluate(terms, c, x)).collect::<Vec<_>>();
    let worst = |all: &[(Complex<f64>, f64, Point)]| {
        let relative = |&(value, scale, _): &(Complex<f64>, f64, Point)| match scale > 0.0 {
            true => value.norm() / scale,
            false => value.norm(),
        };
        // A NaN must not pass for a small residual.
        all.iter().map(relative).fold(0.0, |worst: f64, r| if worst.is_nan() || r <= worst { worst } else { r })
    };
    let weight = |(_, scale, gradient): &(Complex<f64>, f64, Point)| {
        let size = if *scale > 0.0 { *scale } else { gradient.iter().map(|x| x.norm()).fold(0.0, f64::max) };
        Complex::new(if size > 0.0 { 1.0 / size } else { 0.0 }, 0.0)
    };
    let mut all = evaluate_all(point);
    let mut best = worst(&all);
    let mut last = vec![Complex::ZERO; point.len()];
    let mut flat = false;
    for _ in 0..POLISH_STEPS {
        let weights: Vec<Complex<f64>> = all.iter().map(weight).collect();
        let jacobian = DMatrix::from_fn(all.len(), point.len(), |e, j| all[e].2[j] * weights[e]);
        let right = DVector::from_fn(all.len(), |e, _| all[e].0 * weights[e]);
        let qr = jacobian.qr();
        let Some(step) = qr.r().solve_upper_triangular(&(qr.q().adjoint() * right)) else { break };
        last = step.iter().copied().collect();
        let mut moved: Point = point.iter().zip(step.iter()).map(|(x, s)| x - s).collect();
        let mut next = evaluate_all(&moved);
        let mut residual = worst(&next);
        if best > STALLED && (residual.is_nan() || residual >= best) {
            let largest = |x: &Point| x.iter().map(|x| x.norm()).fold(0.0, f64::max);
            let size = largest(&moved);
            let noise = if size <= TOWARDS_ORIGIN * largest(point) { size } else { NOISE * size };
            moved.iter_mut().filter(|x| x.norm() <= noise).for_each(|x| *x = Complex::ZERO);
            next = evaluate_all(&moved);
            residual = worst(&next);
        }
        flat = best <= STALLED && residual <= FLAT;
        let lower = residual < best;
        if !lower {
            break;
        }
        (best, all) = (residual, next);
        *point = moved;
    }
    let is_large = |x: &Complex<f64>| x.norm() >= LARGE;
    let halved = || point.iter().map(|x| if is_large(x) { x * 0.5 } else { *x }).collect();
    if point.iter().any(is_large) && worst(&evaluate_all(&halved())) <= STALLED {
        return f64::INFINITY;
    }
    let noise = NOISE * point.iter().map(|x| x.norm()).fold(0.0, f64::max);
    let is_far = |(x, step): (&Complex<f64>, &Complex<f64>)| step.norm() > FAR * x.norm() + noise;
    let far: Vec<bool> = point.iter().zip(&last).map(is_far).collect();
    // An unknown that is zero up to noise is free to change by as much.
    let without = || point.iter().zip(&far).map(|(&x, &far)| if far { Complex::ZERO } else { x }).collect();
    let is_noise = || worst(&evaluate_all(&without())) <= STALLED;
    match far.contains(&true) && (best > STALLED || (flat && !is_noise())) {
        true => f64::INFINITY,
        false => best,
    }
}
