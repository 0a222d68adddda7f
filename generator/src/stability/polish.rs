//! The polish of the interpreted solver: what the run-time library does, in complex arithmetic. Its `polish` says how and why.

use nalgebra::{Complex, DMatrix, DVector};

use super::Point;
use crate::plan::{Plan, Term};

/// Newton steps at most.
const STEPS: usize = 24;
/// A step that does not lower a high residual is shortened by this factor so many times at most.
const SHORTER: f64 = 0.35;
const SHORTER_STEPS: usize = 6;
/// A relative residual at most this is rounding: no step could lower it by much.
const ROUNDING: f64 = 4.0 * f64::EPSILON;
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

/// Value, sum of the moduli of the terms, and gradient of a polynomial.
type Evaluated = (Complex<f64>, f64, Point);

/// The powers of the unknowns that polynomials hold.
pub(super) struct Powers(Vec<Vec<Complex<f64>>>);

impl Powers {
    pub(super) fn of(x: &Point, highest: &[u8]) -> Self {
        let powers = |(&x, &highest): (&Complex<f64>, &u8)| {
            std::iter::successors(Some(Complex::ONE), |power| Some(power * x)).take(usize::from(highest) + 1).collect()
        };
        Self(x.iter().zip(highest).map(powers).collect())
    }

    fn get(&self, unknown: usize, exponent: u8) -> Complex<f64> {
        self.0[unknown][usize::from(exponent)]
    }
}

/// The highest power of each unknown in some polynomials.
pub(super) fn highest<'a>(polynomials: impl IntoIterator<Item = &'a Vec<Term>>, unknowns: usize) -> Vec<u8> {
    let mut highest = vec![0; unknowns];
    for term in polynomials.into_iter().flatten() {
        highest.iter_mut().zip(&term.exponents).for_each(|(highest, &e)| *highest = e.max(*highest));
    }
    highest
}

/// A polynomial at a point; `c` are the coefficients of the plan.
pub(super) fn evaluate(terms: &[Term], c: &[f64], powers: &Powers) -> Evaluated {
    let (mut value, mut scale) = (Complex::ZERO, 0.0);
    let mut gradient = vec![Complex::ZERO; powers.0.len()];
    // The unknowns of a term, with the product of the coefficient and the powers before.
    let mut factors: Vec<(usize, u8, Complex<f64>)> = Vec::with_capacity(powers.0.len());
    for term in terms {
        let mut product = Complex::new(c[usize::from(term.coefficient.0)], 0.0);
        factors.clear();
        for (j, &e) in term.exponents.iter().enumerate().filter(|(_, e)| **e > 0) {
            factors.push((j, e, product));
            product *= powers.get(j, e);
        }
        value += product;
        scale += modulus(product);
        let mut after = Complex::ONE;
        for &(j, e, before) in factors.iter().rev() {
            gradient[j] += before * after * powers.get(j, e - 1) * f64::from(e);
            after *= powers.get(j, e);
        }
    }
    (value, scale, gradient)
}

/// |x|, without the care for overflow where none threatens.
fn modulus(x: Complex<f64>) -> f64 {
    let square = x.norm_sqr();
    if square > 1e-280 && square < 1e300 { square.sqrt() } else { x.norm() }
}

/// Gauss-Newton on all equations while it lowers the relative residual, which is returned. A step that leaves a high residual is tried again
/// with unknowns at the level of noise set to zero, then shortened. Infinity where the last step is large and the residual high, or small after it, too.
pub(super) fn polish(plan: &Plan, c: &[f64], point: &mut Point) -> f64 {
    let highest = highest(&plan.equations, point.len());
    let evaluate_all = |x: &Point| {
        let powers = Powers::of(x, &highest);
        plan.equations.iter().map(|terms| evaluate(terms, c, &powers)).collect::<Vec<_>>()
    };
    let mut all = evaluate_all(point);
    let mut best = worst(&all);
    let mut last = vec![Complex::ZERO; point.len()];
    let mut flat = false;
    for _ in 0..STEPS {
        let Some(step) = newton_step(&all) else { break };
        let shortened = |fraction: f64| point.iter().zip(&step).map(|(x, s)| x - s * fraction).collect::<Point>();
        let tried = |x: Point| {
            let all = evaluate_all(&x);
            (worst(&all), x, all)
        };
        let mut next = tried(shortened(1.0));
        // A NaN is no small residual.
        let is_lower = |residual: f64| residual < best;
        if best > STALLED && !is_lower(next.0) {
            next = tried(without_noise(&next.1, point));
            let fractions = (1..=SHORTER_STEPS as i32).map(|k| SHORTER.powi(k));
            for fraction in fractions {
                if is_lower(next.0) {
                    break;
                }
                next = tried(shortened(fraction));
            }
        }
        last = step;
        flat = best <= STALLED && next.0 <= FLAT;
        if !is_lower(next.0) {
            break;
        }
        (best, *point, all) = next;
        // After a long step the next one tells a badly determined solution, which it leaves in place, from none.
        if best <= ROUNDING && !far(point, &last).contains(&true) {
            break;
        }
    }
    let residual_of = |x: Point| worst(&evaluate_all(&x));
    let is_large = |x: &Complex<f64>| x.norm() >= LARGE;
    let halved = || point.iter().map(|x| if is_large(x) { x * 0.5 } else { *x }).collect();
    if point.iter().any(is_large) && residual_of(halved()) <= STALLED.max(best) {
        return f64::INFINITY;
    }
    let far = far(point, &last);
    // An unknown that is zero up to noise is free to change by as much.
    let without = || point.iter().zip(&far).map(|(&x, &far)| if far { Complex::ZERO } else { x }).collect();
    match far.contains(&true) && (best > STALLED || (flat && residual_of(without()) > STALLED)) {
        true => f64::INFINITY,
        false => best,
    }
}

/// The largest relative residual; a NaN if there is one.
fn worst(all: &[Evaluated]) -> f64 {
    let relative = |&(value, scale, _): &Evaluated| if scale > 0.0 { value.norm() / scale } else { value.norm() };
    all.iter().map(relative).fold(0.0, |worst: f64, r| if worst.is_nan() || r <= worst { worst } else { r })
}

/// The least-squares step, each equation divided by its scale; where all terms vanish, by the size of its gradient.
fn newton_step(all: &[Evaluated]) -> Option<Point> {
    let weight = |(_, scale, gradient): &Evaluated| {
        let size = if *scale > 0.0 { *scale } else { gradient.iter().map(|x| x.norm()).fold(0.0, f64::max) };
        Complex::new(if size > 0.0 { 1.0 / size } else { 0.0 }, 0.0)
    };
    let weights: Vec<Complex<f64>> = all.iter().map(weight).collect();
    let unknowns = all.first().map_or(0, |(_, _, gradient)| gradient.len());
    let jacobian = DMatrix::from_fn(all.len(), unknowns, |e, j| all[e].2[j] * weights[e]);
    let right = DVector::from_fn(all.len(), |e, _| all[e].0 * weights[e]);
    let qr = jacobian.qr();
    let step = qr.r().solve_upper_triangular(&(qr.q().adjoint() * right))?;
    Some(step.iter().copied().collect())
}

/// Which unknowns a step changes by more than the part [`FAR`], other than rounding noise of zero.
fn far(point: &Point, step: &Point) -> Vec<bool> {
    let noise = NOISE * largest(point);
    point.iter().zip(step).map(|(x, step)| step.norm() > FAR * x.norm() + noise).collect()
}

/// The unknowns that may be the rounding noise of zero set to zero: all of them where the step from `before` leads towards the origin.
pub(super) fn without_noise(point: &Point, before: &Point) -> Point {
    let size = largest(point);
    let noise = if size <= TOWARDS_ORIGIN * largest(before) { size } else { NOISE * size };
    point.iter().map(|&x| if x.norm() <= noise { Complex::ZERO } else { x }).collect()
}

fn largest(point: &Point) -> f64 {
    point.iter().map(|x| x.norm()).fold(0.0, f64::max)
}
