//! All real roots of a polynomial, with their number certain.
//!
//! The positive and the negative real axis are cut at the modulus 1 of a scaled variable, and what
//! lies beyond is turned inside out by x = 1/t. On each of the four unit intervals the polynomial
//! is written in the Bernstein basis,
//!
//! q(t) = sum over j of b_j C(n, j) t^j (1 - t)^(n-j),
//!
//! whose coefficients change their sign as often as q has roots in (0, 1), or an even number of
//! times more often (Descartes' rule). Intervals with two and more changes are halved by de
//! Casteljau's algorithm until each has one change, which is one root, or none (Lane and Riesenfeld
//! 1981). An interval that still has two changes when it is short holds two roots that are close to
//! each other, or a pair close to the real axis: nobody can tell from rounded coefficients, and the
//! result says so.

use crate::number::float;
use crate::size::{List, Size};

/// An interval is halved at most this often. Roots of one interval are then at most 2^-12 = 2e-4
/// apart, relative to the scaled variable, and coefficients that are wrong by 2e-4 squared may make
/// them a complex pair.
const HALVINGS: u32 = 12;

/// A factor of the scaled variable: the square root of 3/4. Without it, numbers such as 1 and 3/8
/// would lie where intervals meet, and they are the roots of many polynomials that people write.
const UNIT: f64 = 0.866_025_403_784_438_6;

/// The value where an interval is halved must exceed this, relative to the largest Bernstein
/// coefficient: it is about the square of the distance 2^-12.
const CLEAR_MIDDLE: f64 = 1e-7;

/// The largest number of steps to a root. They are Newton's, or halve the bracket.
const MOST_STEPS: usize = 100;

/// A Newton step of this size, relative to the root, is the last one: the next one would be its
/// square.
const LAST_STEP: f64 = 1e-9;

/// The real roots of a polynomial.
pub struct RealRoots<Z: Size> {
    /// The roots, in no order. A root at infinity is left out.
    pub roots: Z::List<f64>,
    /// Whether these are all of them and all are simple. Otherwise roots may be missing: some are
    /// close to each other or to their conjugates, or a number is not finite.
    pub is_certain: bool,
    /// The least |b_j| of the intervals without a root, relative to the largest coefficient of the
    /// unit interval: relative errors below this make none.
    pub clearance: f64,
}

/// The real roots of c\[0\] + c\[1\] x + .. + c\[n\] x^n. The vector has n + 1 entries; the degree
/// is lowered if the last ones are zero.
#[must_use]
pub fn real_roots<Z: Size>(size: Z, coefficients: &Z::Vector<f64>) -> RealRoots<Z> {
    let mut result = RealRoots { roots: size.list(), is_certain: false, clearance: f64::INFINITY };
    let Some(degree) = coefficients.as_ref().iter().rposition(|&c| c != 0.0) else { return result };
    if !coefficients.as_ref().iter().all(|c| c.is_finite()) {
        return result;
    }
    let lowest = coefficients.as_ref().iter().position(|&c| c != 0.0).unwrap_or(0);
    result.is_certain = lowest <= 1;
    if lowest > 0 {
        result.roots.push(0.0);
    }
    let mut isolation = Isolation { size, degree: degree - lowest, power: size.filled(0.0), result };
    let shift = isolation.scaled(&coefficients.as_ref()[lowest..=degree]);
    match isolation.degree {
        0 => {}
        1 => {
            let root = -isolation.power[0] / isolation.power[1];
            isolation.result.roots.push(root);
        }
        _ => isolation.all(),
    }
    let Isolation { mut result, .. } = isolation;
    for root in result.roots.iter_mut() {
        *root = times_power_of_two(*root * UNIT, shift);
        result.is_certain &= root.is_finite();
    }
    result
}

/// The polynomial in the scaled variable, lowest coefficient first, and the roots found so far.
struct Isolation<Z: Size> {
    size: Z,
    degree: usize,
    power: Z::Vector<f64>,
    result: RealRoots<Z>,
}

/// One of the four unit intervals.
struct Piece<'a, Z: Size> {
    /// q, lowest coefficient first, `degree + 1` entries in use.
    power: &'a Z::Vector<f64>,
    /// x is this times t, or this over t.
    sign: f64,
    is_outer: bool,
    /// The largest |b_j|.
    size: f64,
}

impl<Z: Size> Isolation<Z> {
    /// Takes the coefficients with x = 2^shift UNIT y, which brings the geometric mean of the
    /// moduli of the roots to about 1. Returns the shift.
    fn scaled(&mut self, coefficients: &[f64]) -> i32 {
        let degree = self.degree as i32;
        if degree == 0 {
            return 0;
        }
        let exponent = |k: usize| float::exponent(coefficients[k]);
        let shift = (exponent(0) - exponent(self.degree)).div_euclid(degree);
        let exponents = (0..=self.degree).filter(|&k| coefficients[k] != 0.0).map(|k| exponent(k) + k as i32 * shift);
        let largest = exponents.max().unwrap_or(0);
        let mut unit = 1.0;
        for (k, &c) in coefficients.iter().enumerate() {
            self.power[k] = unit * times_power_of_two(c, k as i32 * shift - largest);
            unit *= UNIT;
        }
        shift
    }

    fn all(&mut self) {
        let n = self.degree;
        // 1 / C(n, j)
        let mut weight = self.size.filled(1.0);
        for j in 0..n {
            weight[j + 1] = weight[j] * (j + 1) as f64 / (n - j) as f64;
        }
        for sign in [1.0, -1.0] {
            let mut inner = self.power.clone();
            if sign < 0.0 {
                (1..=n).step_by(2).for_each(|k| inner[k] = -inner[k]);
            }
            let mut outer = inner.clone();
            outer.as_mut()[..=n].reverse();
            // Both have the same value at t = 1, and must agree about its sign.
            let at_one: f64 = inner.as_ref()[..=n].iter().sum();
            for (power, is_outer) in [(&inner, false), (&outer, true)] {
                let mut bernstein = self.bernstein(power, &weight);
                bernstein[n] = at_one;
                let size = largest(&bernstein.as_ref()[..=n]);
                self.result.is_certain &= at_one.abs() > CLEAR_MIDDLE * size;
                self.isolate(&Piece { power, sign, is_outer, size }, &mut bernstein, (0.0, 1.0), HALVINGS);
            }
        }
    }

    /// b_j = sum over i <= j of C(j, i) q_i / C(n, i), by Pascal's rule.
    #[inline]
    fn bernstein(&self, power: &Z::Vector<f64>, weight: &Z::Vector<f64>) -> Z::Vector<f64> {
        let n = self.degree;
        let mut bernstein = power.clone();
        for j in 0..=n {
            bernstein[j] *= weight[j];
        }
        for pass in 1..=n {
            for j in (pass..=n).rev() {
                bernstein[j] += bernstein[j - 1];
            }
        }
        bernstein
    }

    /// Adds the roots between the ends of an interval, on which q has these Bernstein coefficients.
    fn isolate(&mut self, piece: &Piece<'_, Z>, right: &mut Z::Vector<f64>, ends: (f64, f64), halvings: u32) {
        let n = self.degree;
        match sign_changes(&right.as_ref()[..=n]) {
            0 => self.result.clearance = self.result.clearance.min(least(&right.as_ref()[..=n]) / piece.size),
            1 => {
                let t = self.refine(piece.power, right, ends);
                let root = if piece.is_outer { piece.sign / t } else { piece.sign * t };
                self.result.is_certain &= self.result.roots.push(root);
            }
            _ if halvings == 0 => self.result.is_certain = false,
            _ => {
                // De Casteljau: after pass k, the first entry is the k-th coefficient of the left
                // half, and the last one that changed is final in the right half.
                let mut left = right.clone();
                for pass in 1..=n {
                    for j in 0..=n - pass {
                        right[j] = 0.5 * (right[j] + right[j + 1]);
                    }
                    left[pass] = right[0];
                }
                // Two close roots in the middle, or a pair, show in neither half.
                let size = largest(&left.as_ref()[..=n]).max(largest(&right.as_ref()[..=n]));
                self.result.is_certain &= right[0].abs() > CLEAR_MIDDLE * size;
                let middle = 0.5 * (ends.0 + ends.1);
                self.isolate(piece, &mut left, (ends.0, middle), halvings - 1);
                self.isolate(piece, right, (middle, ends.1), halvings - 1);
            }
        }
    }

    /// The one root between the ends: Newton's method from the zero of the control polygon, with
    /// bisection where a step leaves the bracket.
    fn refine(&self, power: &Z::Vector<f64>, bernstein: &Z::Vector<f64>, (low, high): (f64, f64)) -> f64 {
        let n = self.degree;
        let rises = bernstein[0] < 0.0;
        let crossing = (0..n).find(|&j| (bernstein[j + 1] < 0.0) != rises).unwrap_or(0);
        let (before, after) = (bernstein[crossing], bernstein[crossing + 1]);
        let part = (crossing as f64 + before / (before - after)) / n as f64;
        let mut t = low + (high - low) * part;
        let (mut low, mut high) = (low, high);
        for _ in 0..MOST_STEPS {
            let (mut value, mut slope) = (power[n], 0.0);
            for k in (0..n).rev() {
                slope = slope * t + value;
                value = value * t + power[k];
            }
            if value == 0.0 {
                return t;
            }
            if (value < 0.0) == rises {
                low = t;
            } else {
                high = t;
            }
            let newton = t - value / slope;
            // A NaN from a slope of zero leads to bisection.
            let is_newton = newton >= low && newton <= high;
            let next = if is_newton { newton } else { 0.5 * (low + high) };
            let step = (next - t).abs();
            t = next;
            if step <= if is_newton { LAST_STEP * t } else { 0.0 } {
                return t;
            }
        }
        t
    }
}

/// How often the sign changes along a list. Zeros do not count.
#[inline]
fn sign_changes(values: &[f64]) -> usize {
    let (mut changes, mut last) = (0, 0.0);
    for &value in values {
        changes += usize::from(value * last < 0.0);
        last = if value == 0.0 { last } else { value.signum() };
    }
    changes
}

/// min |b_j|
#[inline]
fn least(values: &[f64]) -> f64 {
    values.iter().fold(f64::INFINITY, |least, b| least.min(b.abs()))
}

/// max |b_j|
#[inline]
fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest, b| largest.max(b.abs()))
}

/// x * 2^exponent, even if 2^exponent itself is out of range.
#[inline]
fn times_power_of_two(x: f64, exponent: i32) -> f64 {
    let half = exponent / 2;
    x * float::power_of_two(half) * float::power_of_two(exponent - half)
}
