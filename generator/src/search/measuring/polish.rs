//! The polish of the interpreted solver: what the run-time library does, in complex arithmetic. Its `polish` says how and why.

use std::collections::HashMap;

use nalgebra::{Complex, DMatrix, DVector};

use super::Point;
use crate::plan::Term;

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
/// A step that would change an unknown by more than this part of it, where the residual is no rounding error or stays below [`FLAT`], shows that
/// there is no solution near by.
const FAR: f64 = 0.1;
/// Unknowns at least this large may be on the way to infinity: they are if half of them gives a residual that is rounding, too.
const LARGE: f64 = 1e6;
/// A relative residual below this after a long step shows a direction in which the equations are nearly constant.
const FLAT: f64 = 1e-6;

/// Polynomials over a list of their monomials, each of which is evaluated once.
pub(super) struct Polynomials<'a> {
    monomials: Vec<&'a [u8]>,
    /// Of each polynomial (coefficient, position of the monomial).
    terms: Vec<Vec<(f64, usize)>>,
}

/// Value and sum of the moduli of the terms of a polynomial.
type Value = (Complex<f64>, f64);

impl<'a> Polynomials<'a> {
    /// `c` are the coefficients of the plan.
    pub(super) fn new(polynomials: impl IntoIterator<Item = &'a Vec<Term>>, c: &[f64]) -> Self {
        let mut positions: HashMap<&[u8], usize> = HashMap::new();
        let mut monomials = Vec::new();
        let mut term = |term: &'a Term| {
            let position = *positions.entry(&term.exponents).or_insert_with(|| {
                monomials.push(term.exponents.as_slice());
                monomials.len() - 1
            });
            (c[usize::from(term.coefficient.0)], position)
        };
        let terms = polynomials.into_iter().map(|terms| terms.iter().map(&mut term).collect()).collect();
        Self { monomials, terms }
    }

    pub(super) fn values(&self, x: &Point) -> Vec<Value> {
        let value = |monomial: &&[u8]| {
            let value = product(monomial, x);
            (value, value.norm())
        };
        let values: Vec<(Complex<f64>, f64)> = self.monomials.iter().map(value).collect();
        let sum = |terms: &Vec<(f64, usize)>| {
            terms.iter().fold((Complex::ZERO, 0.0), |(sum, scale), &(c, at)| {
                let (value, size) = values[at];
                (sum + value * c, scale + size * c.abs())
            })
        };
        self.terms.iter().map(sum).collect()
    }

    /// One row for each polynomial.
    fn gradients(&self, x: &Point) -> DMatrix<Complex<f64>> {
        // Most monomials are free of most unknowns.
        let of_monomial = |monomial: &&[u8]| -> Vec<(usize, Complex<f64>)> {
            (0..x.len()).filter(|&j| monomial[j] > 0).map(|j| (j, derivative(monomial, j, x))).collect()
        };
        let derivatives: Vec<_> = self.monomials.iter().map(of_monomial).collect();
        let mut gradients = DMatrix::zeros(self.terms.len(), x.len());
        for (e, terms) in self.terms.iter().enumerate() {
            for &(c, at) in terms {
                derivatives[at].iter().for_each(|&(j, derivative)| gradients[(e, j)] += derivative * c);
            }
        }
        gradients
    }
}

fn product(monomial: &[u8], x: &Point) -> Complex<f64> {
    let powers = monomial.iter().zip(x).filter(|(e, _)| **e > 0).map(|(&e, x)| x.powu(u32::from(e)));
    powers.fold(Complex::ONE, |product, power| product * power)
}

/// By an unknown that the monomial holds.
fn derivative(monomial: &[u8], unknown: usize, x: &Point) -> Complex<f64> {
    let exponent = |(j, &e): (usize, &u8)| u32::from(e) - u32::from(j == unknown);
    let powers = monomial.iter().enumerate().map(exponent).zip(x).filter(|(e, _)| *e > 0).map(|(e, x)| x.powu(e));
    powers.fold(f64::from(monomial[unknown]).into(), |product, power| product * power)
}

/// Gauss-Newton on all equations while it lowers the relative residual, which is returned. A step that leaves a high residual is tried again
/// with unknowns at the level of noise set to zero, then shortened. Infinity where the last step is large and the residual high, or small after it, too.
pub(super) fn polish(equations: &Polynomials<'_>, point: &mut Point) -> f64 {
    let mut values = equations.values(point);
    let mut best = worst(&values);
    let mut last = vec![Complex::ZERO; point.len()];
    let mut flat = false;
    for _ in 0..STEPS {
        let Some(step) = newton_step(&values, equations.gradients(point)) else { break };
        let shortened = |fraction: f64| point.iter().zip(&step).map(|(x, s)| x - s * fraction).collect::<Point>();
        let tried = |x: Point| {
            let values = equations.values(&x);
            (worst(&values), x, values)
        };
        let mut next = tried(shortened(1.0));
        // A NaN is no small residual.
        let is_lower = |residual: f64| residual < best;
        if best > STALLED && !is_lower(next.0) {
            next = tried(without_noise(&next.1));
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
        (best, *point, values) = next;
        // After a long step the next one tells a badly determined solution, which it leaves in place, from none.
        if best <= ROUNDING && !far(point, &last).contains(&true) {
            break;
        }
    }
    let residual_of = |x: Point| worst(&equations.values(&x));
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
fn worst(values: &[Value]) -> f64 {
    let relative = |&(value, scale): &Value| if scale > 0.0 { value.norm() / scale } else { value.norm() };
    values.iter().map(relative).fold(0.0, |worst: f64, r| if worst.is_nan() || r <= worst { worst } else { r })
}

/// The least-squares step, each equation divided by its scale; where all terms vanish, by the size of its gradient.
fn newton_step(values: &[Value], mut jacobian: DMatrix<Complex<f64>>) -> Option<Point> {
    let mut right = DVector::from_iterator(values.len(), values.iter().map(|&(value, _)| value));
    for (e, &(_, scale)) in values.iter().enumerate() {
        let size = if scale > 0.0 { scale } else { jacobian.row(e).iter().map(|x| x.norm()).fold(0.0, f64::max) };
        let weight = if size > 0.0 { 1.0 / size } else { 0.0 };
        jacobian.row_mut(e).scale_mut(weight);
        right[e] *= weight;
    }
    let qr = jacobian.qr();
    let step = qr.r().solve_upper_triangular(&(qr.q().adjoint() * right))?;
    Some(step.iter().copied().collect())
}

/// Which unknowns a step changes by more than the part [`FAR`], other than rounding noise of zero.
fn far(point: &Point, step: &Point) -> Vec<bool> {
    let noise = NOISE * largest(point);
    point.iter().zip(step).map(|(x, step)| step.norm() > FAR * x.norm() + noise).collect()
}

/// The unknowns that may be the rounding noise of zero set to zero.
pub(super) fn without_noise(point: &Point) -> Point {
    let noise = NOISE * largest(point);
    point.iter().map(|&x| if x.norm() <= noise { Complex::ZERO } else { x }).collect()
}

fn largest(point: &Point) -> f64 {
    point.iter().map(|x| x.norm()).fold(0.0, f64::max)
}
