//! Real and complex numbers under one trait, for code that serves `solve` and `solve_complex`
//! alike.

use super::float;
use crate::size::Size;
use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};
use num_complex::Complex;

pub(crate) mod sealed {
    pub trait Sealed {}
    impl Sealed for f64 {}
    impl Sealed for num_complex::Complex<f64> {}
}

/// `f64` or `Complex<f64>`, or a real or complex number of twice the precision.
pub trait Scalar:
    sealed::Sealed
    + Copy
    + Debug
    + PartialEq
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + 'static
{
    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;
    /// The real number `x`.
    fn from_f64(x: f64) -> Self;
    /// The number `x`, or its real part where `Self` is real.
    fn from_complex(x: Complex<f64>) -> Self;
    /// The number as a complex number of usual precision.
    fn to_complex(self) -> Complex<f64>;
    /// The real part.
    fn real(self) -> f64;
    /// The complex conjugate; a real number is its own.
    fn conj(self) -> Self;
    /// |x|, without overflow.
    fn modulus(self) -> f64;
    /// |x|^2; overflows when |x| exceeds about 1e154.
    fn modulus_squared(self) -> f64;
    /// |re| + |im|: within a factor of sqrt 2 of the modulus, without its square root.
    fn magnitude(self) -> f64;
    /// Product with a real number.
    fn scale(self, factor: f64) -> Self;
    /// 1/x, without overflow of intermediate results.
    fn reciprocal(self) -> Self;
    /// The principal square root; NaN for a negative real number.
    fn sqrt(self) -> Self;
    /// Whether the number is neither infinite nor NaN.
    fn is_finite(self) -> bool;
}

/// A real number: `f64`, or one of twice its precision.
pub trait Real: Scalar + Over<Self> {
    /// The distance from 1 to the next number.
    const EPSILON: f64;
    /// Returns the `known` numbers if this is their precision; otherwise computes them anew.
    fn of<Z: Size>(known: &Z::Vector<f64>, compute: impl FnOnce() -> Z::Vector<Self>) -> Z::Vector<Self>;
    /// |self| with the sign of `other`.
    fn with_sign_of(self, other: Self) -> Self;
}

impl Real for f64 {
    const EPSILON: f64 = f64::EPSILON;
    #[inline]
    fn of<Z: Size>(known: &Z::Vector<f64>, _: impl FnOnce() -> Z::Vector<f64>) -> Z::Vector<f64> {
        known.clone()
    }
    #[inline]
    fn with_sign_of(self, other: f64) -> f64 {
        self.copysign(other)
    }
}

/// The vector of f(x) for every entry x.
///
/// The standard library's `map` compiles to several times as much code, for each closure and size.
#[inline]
pub(crate) fn mapped<Z: Size, A: Copy, S: Scalar>(size: Z, x: &Z::Vector<A>, f: impl Fn(A) -> S) -> Z::Vector<S> {
    let mut mapped = size.filled(S::ZERO);
    for j in 0..size.get() {
        mapped[j] = f(x[j]);
    }
    mapped
}

/// A number whose parts are of type `R`: real, or real and imaginary.
pub trait Over<R>: Scalar {
    /// The real number `x`.
    fn from_real(x: R) -> Self;
    /// Product with a real number.
    fn times(self, factor: R) -> Self;
}

impl<S: Scalar> Over<f64> for S {
    #[inline]
    fn from_real(x: f64) -> Self {
        S::from_f64(x)
    }
    #[inline]
    fn times(self, factor: f64) -> Self {
        self.scale(factor)
    }
}

impl Scalar for f64 {
    const ZERO: f64 = 0.0;
    const ONE: f64 = 1.0;
    #[inline]
    fn from_f64(x: f64) -> f64 {
        x
    }
    #[inline]
    fn from_complex(x: Complex<f64>) -> f64 {
        x.re
    }
    #[inline]
    fn to_complex(self) -> Complex<f64> {
        self.into()
    }
    #[inline]
    fn real(self) -> f64 {
        self
    }
    #[inline]
    fn conj(self) -> f64 {
        self
    }
    #[inline]
    fn modulus(self) -> f64 {
        self.abs()
    }
    #[inline]
    fn modulus_squared(self) -> f64 {
        self * self
    }
    #[inline]
    fn magnitude(self) -> f64 {
        self.abs()
    }
    #[inline]
    fn scale(self, factor: f64) -> f64 {
        self * factor
    }
    #[inline]
    fn reciprocal(self) -> f64 {
        1.0 / self
    }
    #[inline]
    fn sqrt(self) -> f64 {
        float::sqrt(self)
    }
    #[inline]
    fn is_finite(self) -> bool {
        f64::is_finite(self)
    }
}

impl Scalar for Complex<f64> {
    const ZERO: Self = Complex { re: 0.0, im: 0.0 };
    const ONE: Self = Complex { re: 1.0, im: 0.0 };
    #[inline]
    fn from_f64(x: f64) -> Self {
        Complex { re: x, im: 0.0 }
    }
    #[inline]
    fn from_complex(x: Complex<f64>) -> Self {
        x
    }
    #[inline]
    fn to_complex(self) -> Complex<f64> {
        self
    }
    #[inline]
    fn real(self) -> f64 {
        self.re
    }
    #[inline]
    fn conj(self) -> Self {
        Complex { re: self.re, im: -self.im }
    }
    #[inline]
    fn modulus(self) -> f64 {
        float::hypot(self.re, self.im)
    }
    #[inline]
    fn modulus_squared(self) -> f64 {
        self.re * self.re + self.im * self.im
    }
    #[inline]
    fn magnitude(self) -> f64 {
        self.re.abs() + self.im.abs()
    }
    #[inline]
    fn scale(self, factor: f64) -> Self {
        Complex { re: self.re * factor, im: self.im * factor }
    }
    #[inline]
    fn reciprocal(self) -> Self {
        // Smith 1962: the larger part is divided by first.
        if self.re.abs() >= self.im.abs() {
            let quotient = self.im / self.re;
            let denominator = self.re + self.im * quotient;
            Complex { re: 1.0 / denominator, im: -quotient / denominator }
        } else {
            let quotient = self.re / self.im;
            let denominator = self.re * quotient + self.im;
            Complex { re: quotient / denominator, im: -1.0 / denominator }
        }
    }
    #[inline]
    fn sqrt(self) -> Self {
        // The larger part is a sum of terms of one sign. The smaller part follows from im = 2 re'
        // im'.
        let large = float::sqrt(0.5 * (self.modulus() + self.re.abs()));
        let small = if large > 0.0 { 0.5 * self.im.abs() / large } else { 0.0 };
        let (re, im) = if self.re >= 0.0 { (large, small) } else { (small, large) };
        Complex { re, im: if self.im < 0.0 { -im } else { im } }
    }
    #[inline]
    fn is_finite(self) -> bool {
        self.re.is_finite() && self.im.is_finite()
    }
}
