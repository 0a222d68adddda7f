//! Numbers of twice the precision, for the rare instances on which `f64` loses solutions.

use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};
use num_complex::Complex;

use super::float;
use super::scalar::{Over, Real, Scalar, sealed};
use crate::size::Size;

/// The sum of two `f64`, the second at most half a unit in the last place of the first: about 31
/// digits.
///
/// Algorithms of Dekker (1971) and Knuth as collected by Hida, Li and Bailey, "Algorithms for
/// quad-double precision floating point arithmetic", ARITH 2001. The range is that of `f64`;
/// products are exact to the last digits only if their parts neither overflow nor underflow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

/// a + b and its rounding error.
#[inline]
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let of_b = sum - a;
    (sum, (a - (sum - of_b)) + (b - of_b))
}

/// The same for |a| >= |b|.
#[inline]
fn renormalized(a: f64, b: f64) -> DoubleDouble {
    let high = a + b;
    DoubleDouble { high, low: b - (high - a) }
}

/// Splits a into two parts of 26 bits.
#[inline]
fn split(a: f64) -> (f64, f64) {
    const FACTOR: f64 = 134_217_729.0; // 2^27 + 1
    let scaled = FACTOR * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

/// a b and its rounding error, without a fused multiply-add, which some machines lack.
#[inline]
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let ((a1, a2), (b1, b2)) = (split(a), split(b));
    (product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2)
}

impl Add for DoubleDouble {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        let (high, error) = two_sum(self.high, other.high);
        let (low, rest) = two_sum(self.low, other.low);
        let sum = renormalized(high, error + low);
        renormalized(sum.high, sum.low + rest)
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let (high, error) = two_product(self.high, other.high);
        renormalized(high, error + (self.high * other.low + self.low * other.high))
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    #[inline(never)]
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - other.scale(first);
        let second = rest.high / other.high;
        let third = (rest - other.scale(second)).high / other.high;
        let sum = renormalized(first, second);
        sum + Self::from_f64(third)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

/// The operators that follow from addition, multiplication and negation.
macro_rules! derived_operators {
    ($number:ty) => {
        impl Sub for $number {
            type Output = Self;
            #[inline]
            fn sub(self, other: Self) -> Self {
                self + -other
            }
        }
        impl AddAssign for $number {
            #[inline]
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }
        impl SubAssign for $number {
            #[inline]
            fn sub_assign(&mut self, other: Self) {
                *self = *self - other;
            }
        }
        impl MulAssign for $number {
            #[inline]
            fn mul_assign(&mut self, other: Self) {
                *self = *self * other;
            }
        }
        impl sealed::Sealed for $number {}
    };
}

derived_operators!(DoubleDouble);

/// Moduli are those of the first part.
impl Scalar for DoubleDouble {
    const ZERO: Self = Self { high: 0.0, low: 0.0 };
    const ONE: Self = Self { high: 1.0, low: 0.0 };
    #[inline]
    fn from_f64(x: f64) -> Self {
        Self { high: x, low: 0.0 }
    }
    #[inline]
    fn from_complex(x: Complex<f64>) -> Self {
        Self::from_f64(x.re)
    }
    #[inline]
    fn to_complex(self) -> Complex<f64> {
        self.high.into()
    }
    #[inline]
    fn real(self) -> f64 {
        self.high
    }
    #[inline]
    fn conj(self) -> Self {
        self
    }
    #[inline]
    fn modulus(self) -> f64 {
        self.high.abs()
    }
    #[inline]
    fn modulus_squared(self) -> f64 {
        self.high * self.high
    }
    #[inline]
    fn magnitude(self) -> f64 {
        self.high.abs()
    }
    #[inline]
    fn scale(self, factor: f64) -> Self {
        self * Self::from_f64(factor)
    }
    #[inline]
    fn reciprocal(self) -> Self {
        Self::ONE / self
    }
    #[inline]
    fn sqrt(self) -> Self {
        if self.high == 0.0 {
            return self;
        }
        let root = float::sqrt(self.high);
        let (square, error) = two_product(root, root);
        let rest = self - Self { high: square, low: error };
        renormalized(root, 0.5 * rest.high / root)
    }
    #[inline]
    fn is_finite(self) -> bool {
        self.high.is_finite() && self.low.is_finite()
    }
}

impl Real for DoubleDouble {
    /// 2^-104.
    const EPSILON: f64 = f64::EPSILON * f64::EPSILON;
    #[inline]
    fn of<Z: Size>(_: &Z::Rows<f64>, compute: impl FnOnce() -> Z::Rows<Self>) -> Z::Rows<Self> {
        compute()
    }
    #[inline]
    fn by_precision<A, T>(argument: A, _: impl FnOnce(A) -> T, precise: impl FnOnce(A) -> T) -> T {
        precise(argument)
    }
    #[inline]
    fn with_sign_of(self, other: Self) -> Self {
        if self.high.is_sign_negative() == other.high.is_sign_negative() { self } else { -self }
    }
}

/// A complex number with [`DoubleDouble`] parts. (`num_complex` requires remainders and parsing of
/// its parts.)
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleComplex {
    re: DoubleDouble,
    im: DoubleDouble,
}

impl Over<DoubleDouble> for DoubleDouble {
    #[inline]
    fn from_real(x: DoubleDouble) -> Self {
        x
    }
    #[inline]
    fn times(self, factor: DoubleDouble) -> Self {
        self * factor
    }
}

impl Over<DoubleDouble> for DoubleComplex {
    #[inline]
    fn from_real(re: DoubleDouble) -> Self {
        Self { re, im: DoubleDouble::ZERO }
    }
    #[inline]
    fn times(self, factor: DoubleDouble) -> Self {
        Self { re: self.re * factor, im: self.im * factor }
    }
}

impl Add for DoubleComplex {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl Mul for DoubleComplex {
    type Output = Self;
    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        Self { re: self.re * other.re - self.im * other.im, im: self.re * other.im + self.im * other.re }
    }
}

impl Div for DoubleComplex {
    type Output = Self;
    #[inline]
    // A quotient is a product with the reciprocal.
    #[allow(clippy::suspicious_arithmetic_impl)]
    fn div(self, other: Self) -> Self {
        self * other.reciprocal()
    }
}

impl Neg for DoubleComplex {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { re: -self.re, im: -self.im }
    }
}

derived_operators!(DoubleComplex);

/// Moduli are those of the first parts.
impl Scalar for DoubleComplex {
    const ZERO: Self = Self { re: DoubleDouble::ZERO, im: DoubleDouble::ZERO };
    const ONE: Self = Self { re: DoubleDouble::ONE, im: DoubleDouble::ZERO };
    #[inline]
    fn from_f64(x: f64) -> Self {
        Self::from_real(DoubleDouble::from_f64(x))
    }
    #[inline]
    fn from_complex(x: Complex<f64>) -> Self {
        Self { re: DoubleDouble::from_f64(x.re), im: DoubleDouble::from_f64(x.im) }
    }
    #[inline]
    fn to_complex(self) -> Complex<f64> {
        Complex { re: self.re.high, im: self.im.high }
    }
    #[inline]
    fn real(self) -> f64 {
        self.re.high
    }
    #[inline]
    fn conj(self) -> Self {
        Self { re: self.re, im: -self.im }
    }
    #[inline]
    fn modulus(self) -> f64 {
        self.to_complex().modulus()
    }
    #[inline]
    fn modulus_squared(self) -> f64 {
        self.to_complex().modulus_squared()
    }
    #[inline]
    fn magnitude(self) -> f64 {
        self.to_complex().magnitude()
    }
    #[inline]
    fn scale(self, factor: f64) -> Self {
        Self { re: self.re.scale(factor), im: self.im.scale(factor) }
    }
    fn reciprocal(self) -> Self {
        // One Newton step doubles the digits.
        let near = Self::from_complex(self.to_complex().reciprocal());
        near + near * (Self::ONE - self * near)
    }
    fn sqrt(self) -> Self {
        let near = self.to_complex().sqrt();
        if near == Complex::ZERO {
            return Self::ZERO;
        }
        let near = Self::from_complex(near);
        (near + self / near).scale(0.5)
    }
    #[inline]
    fn is_finite(self) -> bool {
        self.re.is_finite() && self.im.is_finite()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// |x - y| relative to |y|.
    fn difference(x: DoubleDouble, y: DoubleDouble) -> f64 {
        (x - y).modulus() / y.modulus()
    }

    fn number(high: f64, low: f64) -> DoubleDouble {
        renormalized(high, low)
    }

    #[test]
    fn parts_do_not_overlap_and_no_digit_is_lost() {
        let tiny = f64::from_bits(0x3c90_0000_0000_0000) * f64::EPSILON;
        let sum = DoubleDouble::ONE + DoubleDouble::from_f64(tiny);
        assert_eq!(sum, DoubleDouble { high: 1.0, low: tiny });
        assert_eq!(sum - DoubleDouble::ONE, DoubleDouble::from_f64(tiny));
        // (2^27 + 1)^2 = 2^54 + 2^28 + 1 has 55 bits.
        let product = DoubleDouble::from_f64(134_217_729.0) * DoubleDouble::from_f64(134_217_729.0);
        assert_eq!(product - DoubleDouble::from_f64(18_014_398_777_917_440.0), DoubleDouble::ONE);
    }

    #[test]
    fn quotients_roots_and_reciprocals_invert_products() {
        for (a, b) in [(number(3.0, 1e-17), number(7.0, -2e-16)), (number(-1e40, 3e23), number(0.1, 5e-18))] {
            assert!(difference(a / b * b, a) < 4.0 * DoubleDouble::EPSILON, "{a:?} / {b:?}");
            assert!(difference((b * b).sqrt(), b) < 4.0 * DoubleDouble::EPSILON, "{b:?}");
            let z = DoubleComplex { re: a, im: b.scale(a.modulus()) };
            let one = z * z.reciprocal();
            assert!((one - DoubleComplex::ONE).magnitude() < 16.0 * DoubleDouble::EPSILON, "{z:?}");
            let root = z.sqrt();
            assert!((root * root - z).magnitude() < 32.0 * DoubleDouble::EPSILON * z.magnitude(), "{z:?}");
        }
    }

    #[test]
    fn every_part_of_a_sum_counts() {
        let tiny = 2f64.powi(-60);
        for (a, b, exact) in [
            (number(1.0, tiny), number(1.0, -tiny), number(2.0, 0.0)),
            (number(1.0, tiny), number(-1.0, tiny), number(2.0 * tiny, 0.0)),
            (number(1.0, tiny), number(-1.0, tiny * tiny), number(tiny, tiny * tiny)),
            (number(1e20, 0.0), number(1.0, tiny), number(1e20, 1.0)),
            (number(1.0, tiny), number(tiny, 2f64.powi(-100)), number(1.0, 2.0 * tiny + 2f64.powi(-100))),
        ] {
            assert!(difference(a + b, exact) <= 0.25 * DoubleDouble::EPSILON, "{a:?} + {b:?}: {:?}", a + b);
        }
    }

    #[test]
    fn quotients_have_all_digits() {
        for divisor in [3.0, -7.0, 0.1, 1e10] {
            for dividend in [1.0, -2.0, 1e-5] {
                let (a, b) = (number(dividend, dividend * 1e-17), number(divisor, divisor * 3e-17));
                let rest = a / b * b - a;
                assert!(rest.modulus() <= 2.0 * DoubleDouble::EPSILON * a.modulus(), "{a:?} / {b:?}: {rest:?}");
            }
        }
        assert_eq!(number(6.0, 0.0) / number(-3.0, 0.0), number(-2.0, 0.0));
    }

    #[test]
    fn sizes_are_those_of_the_first_parts() {
        let (x, z) = (number(-3.0, 1e-17), DoubleComplex { re: number(-3.0, 1e-17), im: number(4.0, -1e-17) });
        assert_eq!([x.modulus(), x.magnitude(), x.modulus_squared(), x.real()], [3.0, 3.0, 9.0, -3.0]);
        assert_eq!([z.modulus(), z.magnitude(), z.modulus_squared(), z.real()], [5.0, 7.0, 25.0, -3.0]);
        assert_eq!(z.conj(), DoubleComplex { re: z.re, im: -z.im });
        assert_eq!(z.times(number(2.0, 0.0)), z + z);
        assert_eq!((z.scale(2.0), x.times(number(2.0, 0.0))), (z + z, x + x));
        assert_eq!([x.with_sign_of(DoubleDouble::ONE), (-x).with_sign_of(DoubleDouble::ONE)], [-x; 2]);
        assert_eq!(x.with_sign_of(-DoubleDouble::ONE), x);
    }

    #[test]
    fn all_parts_must_be_finite() {
        let bad = DoubleDouble { high: 1.0, low: f64::NAN };
        assert!(!bad.is_finite() && DoubleDouble::ONE.is_finite() && DoubleComplex::ONE.is_finite());
        assert!(!DoubleDouble { high: f64::INFINITY, low: 0.0 }.is_finite());
        assert!(!DoubleComplex { re: bad, im: DoubleDouble::ONE }.is_finite());
        assert!(!DoubleComplex { re: DoubleDouble::ONE, im: bad }.is_finite());
    }

    #[test]
    fn what_is_not_finite_stays_so() {
        let infinite = DoubleDouble::ONE / DoubleDouble::ZERO;
        assert!(!infinite.is_finite());
        assert!(!(infinite * DoubleDouble::ZERO).is_finite());
        assert!(!DoubleDouble::from_f64(-1.0).sqrt().is_finite());
        assert_eq!(DoubleDouble::ZERO.sqrt(), DoubleDouble::ZERO);
    }
}
