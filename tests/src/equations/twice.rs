//! Numbers of 31 digits: sums of two `f64`.

use std::ops::{Add, Mul, Sub};

use eliminant::Complex;
use eliminant_generator::expression::arithmetic::Arithmetic;
use eliminant_generator::expression::rational::Rational;
use qd::Quad;

/// The arithmetic of [`Quad`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Twice;

impl Arithmetic for Twice {
    type Value = Quad;

    fn constant(self, value: Rational) -> Option<Quad> {
        Some(exact(value.numerator()) / exact(value.denominator()))
    }
    fn add(self, a: Quad, b: Quad) -> Quad {
        a + b
    }
    fn sub(self, a: Quad, b: Quad) -> Quad {
        a - b
    }
    fn mul(self, a: Quad, b: Quad) -> Quad {
        a * b
    }
    fn div(self, a: Quad, b: Quad) -> Option<Quad> {
        (b.0 != 0.0).then(|| a / b)
    }
    fn pivot_size(self, a: Quad) -> f64 {
        a.0.abs()
    }
    fn rounding(self) -> f64 {
        f64::EPSILON * f64::EPSILON
    }
    fn zero(self) -> Quad {
        Quad::ZERO
    }
    fn one(self) -> Quad {
        Quad::ONE
    }
}

pub(super) fn exact(integer: i64) -> Quad {
    let high = integer as f64;
    Quad(high, (i128::from(integer) - high as i128) as f64)
}

/// A complex number of 31 digits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wide {
    re: Quad,
    im: Quad,
}

impl Wide {
    pub(super) const ZERO: Self = Self { re: Quad::ZERO, im: Quad::ZERO };
    pub(super) const ONE: Self = Self { re: Quad::ONE, im: Quad::ZERO };

    pub(super) fn times(self, factor: Quad) -> Self {
        Self { re: self.re * factor, im: self.im * factor }
    }

    pub(super) fn reciprocal(self) -> Self {
        let square = self.re * self.re + self.im * self.im;
        Self { re: self.re / square, im: Quad::ZERO - self.im / square }
    }

    pub(super) fn rounded(self) -> Complex<f64> {
        Complex::new(self.re.0, self.im.0)
    }
}

impl From<Complex<f64>> for Wide {
    fn from(x: Complex<f64>) -> Self {
        Self { re: Quad(x.re, 0.0), im: Quad(x.im, 0.0) }
    }
}

impl Add for Wide {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl Sub for Wide {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, im: self.im - other.im }
    }
}

impl Mul for Wide {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self { re: self.re * other.re - self.im * other.im, im: self.re * other.im + self.im * other.re }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_digit_of_31_is_lost() {
        let third = Twice.constant(Rational::new(1, 3).expect("a fraction")).expect("its value");
        assert!((third + third + third - Quad::ONE).0.abs() < 1e-31);
        assert_eq!(exact(i64::MAX) + Quad::ONE, Quad(9_223_372_036_854_775_808.0, 0.0));
        // (1/3 + i)^2 = 1/9 - 1 + 2/3 i.
        let square = Wide { re: third, im: Quad::ONE };
        let square = square * square;
        let difference = square - Wide { re: exact(-8) / exact(9), im: third + third };
        assert!(difference.re.0.abs().max(difference.im.0.abs()) < 1e-30, "{difference:?}");
    }
}
