//! Real and complex numbers under one trait, for code that serves `solve` and `solve_complex`
//! alike.

use super::arithmetic::Arithmetic;
use super::float;
use crate::size::{Element, Size};
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
    + Send
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

impl<S: Scalar> Arithmetic for S {
    #[inline(always)]
    fn constant(self, x: f64) -> Self {
        S::from_f64(x)
    }

    /// Together: values stay in registers from one part to the next. At twice the precision, where
    /// an operation is dozens of instructions, long code is a table: [`Real::by_precision`].
    #[inline(always)]
    fn apart(self, compute: impl FnOnce()) {
        compute();
    }

    /// It is a call, because a determinant has many products, and few lengths.
    #[inline(never)]
    fn add_product<const A: usize, const B: usize, const N: usize>(sum: &mut [S; N], a: &[S; A], b: &[S; B]) {
        for (shift, &factor) in a.iter().enumerate() {
            for (sum, &value) in sum[shift..].iter_mut().zip(b) {
                *sum += factor * value;
            }
        }
    }

    #[inline(never)]
    fn subtract_product<const A: usize, const B: usize, const N: usize>(sum: &mut [S; N], a: &[S; A], b: &[S; B]) {
        for (shift, &factor) in a.iter().enumerate() {
            for (sum, &value) in sum[shift..].iter_mut().zip(b) {
                *sum -= factor * value;
            }
        }
    }
}

/// A real number: `f64`, or one of twice its precision.
pub trait Real: Scalar + Over<Self> {
    /// The distance from 1 to the next number.
    const EPSILON: f64;
    /// Returns the `known` numbers if this is their precision; otherwise computes them anew.
    fn of<Z: Size>(known: &Z::Rows<f64>, compute: impl FnOnce() -> Z::Rows<Self>) -> Z::Rows<Self>;
    /// Computes one way for `f64` and another way at twice the precision, where what is rarely run
    /// should take little time to compile. Only the way that is taken is compiled.
    fn by_precision<A, T>(argument: A, usual: impl FnOnce(A) -> T, precise: impl FnOnce(A) -> T) -> T;
    /// |self| with the sign of `other`.
    fn with_sign_of(self, other: Self) -> Self;
}

impl Real for f64 {
    const EPSILON: f64 = f64::EPSILON;
    #[inline]
    fn of<Z: Size>(known: &Z::Rows<f64>, _: impl FnOnce() -> Z::Rows<f64>) -> Z::Rows<f64> {
        known.clone()
    }
    #[inline(always)]
    fn by_precision<A, T>(argument: A, usual: impl FnOnce(A) -> T, _: impl FnOnce(A) -> T) -> T {
        usual(argument)
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
pub(crate) fn mapped<Z: Size, A: Element + Copy, S: Scalar>(
    size: Z,
    x: &Z::Vector<A>,
    f: impl Fn(A) -> S,
) -> Z::Vector<S> {
    let mut mapped = size.filled(S::ZERO);
    for j in 0..size.get() {
        mapped[j] = f(x[j]);
    }
    mapped
}

/// A number whose parts are of type `R`: real, or real and imaginary.
pub trait Over<R>: Arithmetic {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn c(re: f64, im: f64) -> Complex<f64> {
        Complex { re, im }
    }

    /// |x - y| relative to |y|.
    fn difference(x: Complex<f64>, y: Complex<f64>) -> f64 {
        (x - y).modulus() / y.modulus()
    }

    #[test]
    fn reciprocals_do_not_overflow_in_between() {
        for z in [c(3.0, 4.0), c(-4.0, 3.0), c(0.5, -0.25), c(-1e-3, -7.0), c(0.0, 2.0), c(0.0, -2.0), c(-2.0, 0.0)] {
            for unit in [1.0, 1e-200, 1e200, 1e300] {
                let z = Scalar::scale(z, unit);
                let product = z.reciprocal() * z;
                assert!(difference(product, Complex::ONE) < 4.0 * f64::EPSILON, "{z}: {product}");
            }
        }
        assert_eq!(Scalar::reciprocal(4.0), 0.25);
    }

    #[test]
    fn square_roots_are_principal() {
        for (re, im) in [(3.0, 4.0), (-3.0, 4.0), (3.0, -4.0), (-3.0, -4.0), (0.0, 2.0), (0.0, -2.0), (5.0, 0.0)] {
            for unit in [1.0, 1e-200, 1e200] {
                let (z, root) = (c(re, im).scale(unit), Scalar::sqrt(c(re, im).scale(unit)));
                assert!(difference(root * root, z) < 4.0 * f64::EPSILON, "{z}: {root}");
                assert!(root.re > 0.0 && (root.im > 0.0) == (im > 0.0) && (root.im < 0.0) == (im < 0.0), "{z}: {root}");
            }
        }
        assert_eq!(Scalar::sqrt(c(-9.0, 0.0)), c(0.0, 3.0));
        assert_eq!(Scalar::sqrt(Complex::ZERO), Complex::ZERO);
        assert!(Scalar::sqrt(-9.0).is_nan());
    }

    #[test]
    fn real_numbers_are_complex_ones_without_imaginary_part() {
        assert_eq!([f64::from_complex(c(2.0, 3.0)), f64::from_f64(2.0), f64::from_real(2.0)], [2.0; 3]);
        assert_eq!(Complex::from_complex(c(2.0, 3.0)), c(2.0, 3.0));
        assert_eq!([Complex::from_f64(2.0), Complex::from_real(2.0), Scalar::to_complex(2.0)], [c(2.0, 0.0); 3]);
        assert_eq!((c(2.0, 3.0).to_complex(), c(2.0, 3.0).real(), 2.0.real()), (c(2.0, 3.0), 2.0, 2.0));
        assert_eq!((Scalar::conj(c(2.0, 3.0)), Scalar::conj(2.0)), (c(2.0, -3.0), 2.0));
    }

    #[test]
    fn sizes() {
        let z = c(-3.0, 4.0);
        assert_eq!((z.modulus(), z.modulus_squared(), z.magnitude()), (5.0, 25.0, 7.0));
        assert_eq!(((-3.0).modulus(), (-3.0).modulus_squared(), (-3.0).magnitude()), (3.0, 9.0, 3.0));
        assert_eq!((Scalar::scale(z, 2.0), z.times(2.0), 3.0.scale(2.0)), (c(-6.0, 8.0), c(-6.0, 8.0), 6.0));
        assert_eq!([3.0.with_sign_of(-0.0), (-3.0).with_sign_of(1.0), (-3.0).with_sign_of(-1.0)], [-3.0, 3.0, -3.0]);
    }

    #[test]
    fn both_parts_must_be_finite() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(![c(bad, 1.0), c(1.0, bad), c(bad, bad)].iter().any(|z| Scalar::is_finite(*z)));
            assert!(!Scalar::is_finite(bad));
        }
        assert!(Scalar::is_finite(c(1e308, -1e308)) && Scalar::is_finite(1e308));
    }
}
