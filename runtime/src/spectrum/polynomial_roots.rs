//! Real roots of univariate polynomials.
//!
//! Between two neighbouring critical points a polynomial is monotone and has at most one root. A
//! sign change shows it, and safeguarded Newton iteration finds it. The critical points are the
//! roots of the derivative, found the same way, down to a quadratic (Yuksel, "High-Performance
//! Polynomial Root Finding for Graphics", 2022). This implementation departs from the paper in
//! three points. The variable is scaled by a power of two. Roots with |x| > 1 are found as 1/y on
//! the reversed polynomial, so that nothing overflows and small and large roots have the same
//! relative accuracy. A critical point at which the polynomial vanishes up to rounding counts as a
//! root, so that double roots are not lost.

use crate::number::float;
use crate::size::{Fixed, List, Size};
use arrayvec::ArrayVec;

/// The largest number of Newton steps. They fall back to bisection, so about 60 end at neighbouring
/// numbers unless the root is tiny. After this many the best point so far is taken.
const MOST_STEPS: usize = 200;

/// After this many Newton steps, a value at rounding level ends the search: a multiple root gets no
/// better.
const PATIENCE: usize = 8;

/// The last step to a critical point, relative to it. The polynomial there is off by the square of
/// the remaining error, which after a step of this size is far below rounding.
const CRITICAL_TOLERANCE: f64 = 1e-7;

/// A leading coefficient counts as zero if its root would exceed the bound on all other roots by
/// more than 2 to this power.
const VANISHING: i32 = 52;

/// The real roots of c\[0\] + c\[1\] x + .. + c\[D1-1\] x^(D1-1), ascending. D1 is the degree plus
/// one.
///
/// A multiple root comes out once or as several close ones. The degree is lowered if the leading
/// coefficient is zero, or so small that its root would exceed the bound on all others 2^52 times.
/// The result is empty for constants, for the zero polynomial, and if a coefficient is infinite or
/// NaN. A root that overflows is left out.
#[must_use]
pub fn real_roots<const D1: usize>(coefficients: &[f64; D1]) -> ArrayVec<f64, D1> {
    match coefficients.split_last() {
        Some((&leading, _)) => Polynomial { size: Fixed, lower: *coefficients, leading, degree: D1 - 1 }.real_roots(),
        None => ArrayVec::new_const(),
    }
}

/// The real roots of the monic polynomial c\[0\] + c\[1\] x + .. + c\[D-1\] x^(D-1) + x^D,
/// ascending; otherwise as [`real_roots`].
/// `Hessenberg::characteristic_polynomial` gives such coefficients.
#[must_use]
pub fn real_roots_monic<Z: Size>(size: Z, lower: &Z::Vector<f64>) -> Z::List<f64> {
    Polynomial { size, lower: lower.clone(), leading: 1.0, degree: size.get() }.real_roots()
}

/// lower\[0\] + .. + lower\[degree-1\] x^(degree-1) + leading x^degree. Entries of `lower` from
/// `degree` on are not read.
///
/// The leading coefficient is stored apart because arrays of D + 1 entries are beyond stable const
/// generics.
struct Polynomial<Z: Size> {
    size: Z,
    lower: Z::Vector<f64>,
    leading: f64,
    degree: usize,
}

impl<Z: Size> Clone for Polynomial<Z> {
    #[inline]
    fn clone(&self) -> Self {
        Self { lower: self.lower.clone(), ..*self }
    }
}

impl<Z: Size> Polynomial<Z> {
    fn zero(size: Z) -> Self {
        Polynomial { size, lower: size.filled(0.0), leading: 0.0, degree: 0 }
    }

    /// The coefficients below the leading one.
    #[inline]
    fn below(&self) -> &[f64] {
        &self.lower.as_ref()[..self.degree]
    }

    fn real_roots(mut self) -> Z::List<f64> {
        let mut roots = self.size.list();
        if !(self.leading.is_finite() && self.below().iter().all(|c| c.is_finite())) {
            return roots;
        }
        self.drop_vanishing_leading();
        if self.divide_by_power_of_x() {
            push(&mut roots, 0.0);
        }
        match self.degree {
            0 => {}
            1 => push(&mut roots, -self.lower[0] / self.leading),
            2 => {
                let shift = self.scale_variable();
                for root in quadratic_roots(self.leading, self.lower[1], self.lower[0]) {
                    push(&mut roots, scaled(root, shift));
                }
            }
            _ => {
                let shift = self.scale_variable();
                let ends = [self.value(-1.0).0, self.value(1.0).0];
                let inner = self.roots_in_unit_interval(ends);
                for &root in inner.roots.iter() {
                    push(&mut roots, scaled(root, shift));
                }
                let reversed_ends = [if self.degree.is_multiple_of(2) { ends[0] } else { -ends[0] }, ends[1]];
                let outer = self.reversed().roots_in_unit_interval(reversed_ends);
                for &root in outer.roots.iter() {
                    push(&mut roots, scaled(1.0 / root, shift));
                }
                for (end, side) in [(-1.0, 0), (1.0, 1)] {
                    if !(inner.at_end[side] || outer.at_end[side]) && ends[side].abs() <= self.rounding(end) {
                        push(&mut roots, scaled(end, shift));
                    }
                }
            }
        }
        roots.sort_unstable_by(f64::total_cmp);
        roots
    }

    /// Lowers the degree past leading coefficients that are zero or negligible relative to the
    /// rest.
    fn drop_vanishing_leading(&mut self) {
        while self.degree > 0 && self.leading == 0.0 {
            self.truncate(self.degree - 1);
        }
        if let Some(degree) = (1..self.degree).find(|&m| self.vanishes_above(m)) {
            self.truncate(degree);
        }
    }

    fn truncate(&mut self, degree: usize) {
        self.degree = degree;
        self.leading = self.lower[degree];
    }

    /// Whether all coefficients above degree m are negligible: the roots that they add, of size
    /// |c[m] / c[j]|^(1/(j-m)), exceed Fujiwara's bound 2 max |c[k] / c[m]|^(1/(m-k)) on the others
    /// 2^52 times. The comparison is one of binary exponents.
    fn vanishes_above(&self, m: usize) -> bool {
        let exponent = |k: usize| float::exponent(if k == self.degree { self.leading } else { self.lower[k] });
        let middle = exponent(m);
        if self.lower[m] == 0.0 || self.lower.as_ref()[..m].iter().all(|&c| c == 0.0) {
            return false;
        }
        (m + 1..=self.degree).all(|j| {
            (0..m).rev().filter(|&k| self.lower[k] != 0.0).all(|k| {
                let (above, below) = ((j - m) as i32, (m - k) as i32);
                // The 2 covers the factor of the bound and the exponents rounded down.
                (middle - exponent(j)) * below > above * ((VANISHING + 2) * below + exponent(k) - middle)
            })
        })
    }

    /// Divides by the largest power of x. Returns false if the constant term is not zero.
    fn divide_by_power_of_x(&mut self) -> bool {
        let power = self.below().iter().take_while(|&&c| c == 0.0).count();
        self.lower.as_mut().copy_within(power..self.degree, 0);
        self.degree -= power;
        power > 0
    }

    /// Substitutes x = 2^shift y, which brings the geometric mean of the moduli of the roots to
    /// about 1, and scales the largest coefficient to about 1. Nothing is rounded, except
    /// coefficients that underflow and do not matter.
    fn scale_variable(&mut self) -> i32 {
        let degree = self.degree as i32;
        let shift = (float::exponent(self.lower[0]) - float::exponent(self.leading)).div_euclid(degree);
        let mut largest = float::exponent(self.leading) + degree * shift;
        for (c, k) in self.below().iter().zip(0..) {
            if *c != 0.0 {
                largest = largest.max(float::exponent(*c) + k * shift);
            }
        }
        for (c, k) in self.lower.as_mut()[..self.degree].iter_mut().zip(0..) {
            *c = scaled(*c, k * shift - largest);
        }
        self.leading = scaled(self.leading, degree * shift - largest);
        shift
    }

    /// y^degree p(1/y).
    fn reversed(&self) -> Self {
        let mut reversed = self.clone();
        reversed.leading = self.lower[0];
        reversed.lower[0] = self.leading;
        if self.degree > 1 {
            reversed.lower.as_mut()[1..self.degree].reverse();
        }
        reversed
    }

    /// A constant multiple of the derivative, with coefficients of the size of those of p.
    fn derivative(&self) -> Self {
        let mut derivative = Self::zero(self.size);
        let inverse = 1.0 / self.degree as f64;
        for k in 1..self.degree {
            derivative.lower[k - 1] = self.lower[k] * (k as f64 * inverse);
        }
        derivative.leading = self.leading;
        derivative.degree = self.degree - 1;
        derivative
    }

    /// p(x) and p'(x) by Horner's rule.
    #[inline]
    fn value(&self, x: f64) -> (f64, f64) {
        let (mut value, mut slope) = (self.leading, 0.0);
        for &c in self.below().iter().rev() {
            slope = slope * x + value;
            value = value * x + c;
        }
        (value, slope)
    }

    /// A bound on the rounding error of p(x), with coefficients that were rounded once.
    #[inline]
    fn rounding(&self, x: f64) -> f64 {
        let x = x.abs();
        let sum = self.below().iter().rev().fold(self.leading.abs(), |sum, c| sum * x + c.abs());
        sum * (self.degree as f64 * f64::EPSILON)
    }

    /// The roots between -1 and 1, for a degree of at least 3. `ends` are p(-1) and p(1). They are
    /// arguments, so that p and its reverse agree about their signs, and no root falls between the
    /// two or is found by both.
    fn roots_in_unit_interval(&self, ends: [f64; 2]) -> UnitInterval<Z> {
        // derivatives[k] is the k-th one, down to the quadratic.
        let mut derivatives = self.size.filled(Self::zero(self.size));
        derivatives[0] = self.clone();
        let quadratic = self.degree - 2;
        for k in 1..=quadratic {
            derivatives[k] = derivatives[k - 1].derivative();
        }
        let mut critical = self.size.list();
        let bottom = &derivatives[quadratic];
        for root in quadratic_roots(bottom.leading, bottom.lower[1], bottom.lower[0]) {
            if root.abs() < 1.0 {
                push(&mut critical, root);
            }
        }
        critical.sort_unstable_by(f64::total_cmp);
        for polynomial in derivatives.as_ref()[1..quadratic].iter().rev() {
            let ends = [polynomial.value(-1.0).0, polynomial.value(1.0).0];
            critical = polynomial.roots_between(&critical, ends, CRITICAL_TOLERANCE).roots;
        }
        self.roots_between(&critical, ends, f64::EPSILON)
    }

    /// The roots in the intervals into which `critical` (ascending) divides (-1, 1).
    #[inline]
    fn roots_between(&self, critical: &[f64], ends: [f64; 2], tolerance: f64) -> UnitInterval<Z> {
        let mut result = UnitInterval { roots: self.size.list(), at_end: [false; 2] };
        let (mut left, mut left_value, mut crossed) = (-1.0, ends[0], true);
        for (k, right) in critical.iter().copied().chain([1.0]).enumerate() {
            let right_value = if k < critical.len() { self.value(right).0 } else { ends[1] };
            let crosses = (left_value < 0.0 && right_value > 0.0) || (left_value > 0.0 && right_value < 0.0);
            // A double root up to rounding: the curve touches zero at a critical point without
            // crossing on either side.
            if !crossed && !crosses && left_value.abs() <= self.rounding(left) {
                push(&mut result.roots, left);
            }
            if crosses {
                push(&mut result.roots, self.refine((left, left_value), (right, right_value), tolerance));
            }
            if k == 0 {
                result.at_end[0] = crosses;
            }
            (left, left_value, crossed) = (right, right_value, crosses);
        }
        result.at_end[1] = crossed;
        result
    }

    /// The root between two points at which p has opposite signs. Newton's method, with bisection
    /// if a step leaves the bracket or does not halve the step before, until a step is at most
    /// `tolerance` of the root.
    #[inline]
    fn refine(&self, (mut a, a_value): (f64, f64), (mut b, b_value): (f64, f64), tolerance: f64) -> f64 {
        let rising = a_value < 0.0;
        // The start is the secant of the bracket, kept off its ends.
        let fraction = (a_value / (a_value - b_value)).clamp(0.05, 0.95);
        let mut x = a + (b - a) * fraction;
        let mut previous = b - a;
        for step in 0..MOST_STEPS {
            let (value, slope) = self.value(x);
            if value == 0.0 || (step > PATIENCE && value.abs() <= 0.25 * self.rounding(x)) {
                return x;
            }
            if (value < 0.0) == rising {
                a = x;
            } else {
                b = x;
            }
            let correction = value / slope;
            let newton = x - correction;
            // The comparisons are written so that a NaN from slope zero leads to bisection.
            let next = if newton > a && newton < b && 2.0 * correction.abs() < previous.abs() {
                previous = correction;
                newton
            } else {
                previous = 0.5 * (b - a);
                a + previous
            };
            if (next - x).abs() <= tolerance * next.abs() || next == a || next == b {
                return next;
            }
            x = next;
        }
        x
    }
}

/// The result of [`Polynomial::roots_between`].
struct UnitInterval<Z: Size> {
    /// The roots, ascending.
    roots: Z::List<f64>,
    /// Whether p changes sign in the first and in the last interval, next to -1 and to 1.
    at_end: [bool; 2],
}

/// x * 2^exponent, even if 2^exponent itself is out of range.
#[inline]
fn scaled(x: f64, exponent: i32) -> f64 {
    let half = exponent / 2;
    x * float::power_of_two(half) * float::power_of_two(exponent - half)
}

/// Appends a root. A root that overflowed is dropped, and so are roots beyond the capacity, which
/// can only be copies due to rounding.
#[inline]
fn push(roots: &mut impl List<f64>, root: f64) {
    if root.is_finite() {
        roots.push(root);
    }
}

/// The real roots of a x^2 + b x + c, for coefficients of moderate size. A discriminant that is
/// zero up to rounding gives the double root.
#[inline]
fn quadratic_roots(a: f64, b: f64, c: f64) -> ArrayVec<f64, 2> {
    let mut roots = ArrayVec::new_const();
    let half = -0.5 * b;
    let discriminant = half * half - a * c;
    let rounding = 2.0 * f64::EPSILON * (half * half + (a * c).abs());
    if discriminant.abs() <= rounding {
        push(&mut roots, half / a);
    } else if discriminant > 0.0 {
        let sum = half + float::sqrt(discriminant).copysign(half);
        push(&mut roots, sum / a);
        push(&mut roots, c / sum);
    }
    roots
}
