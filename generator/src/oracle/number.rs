//! Numbers of 237 bits: IEEE octuple precision, about 71 decimal digits.

use eliminant::Complex;
use f256::f256;

use crate::expression::arithmetic::Arithmetic;
use crate::expression::rational::Rational;

/// A complex number of 237 bits.
pub(super) type WideComplex = Complex<f256>;

/// Real numbers of 237 bits, as a field to interpret plans in.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wide;

/// The bits of the significand, the leading one included.
pub const BITS: u32 = f256::SIGNIFICANT_DIGITS;

/// The bits of the fraction in the upper half of the encoding, below the 19 of the exponent and the
/// sign.
const UPPER_FRACTION: u32 = 108;
/// What is added to exponents in the encoding.
const BIAS: i32 = 262_143;

/// The number, rounded to `f64`; infinite or 0 beyond its range.
pub(super) fn rounded(value: f256) -> f64 {
    let sign = if value.is_sign_negative() { -1.0 } else { 1.0 };
    if !value.is_finite() {
        return if value.is_nan() { f64::NAN } else { sign * f64::INFINITY };
    }
    let (upper, _) = value.to_bits();
    let exponent = ((upper >> UPPER_FRACTION) & 0x7_ffff) as i32;
    // 0, and numbers far below the range of `f64`.
    if exponent == 0 {
        return 0.0;
    }
    // The leading 64 bits say all that the 53 of the result can hold.
    let leading = 1 << 63 | ((upper << (128 - UPPER_FRACTION)) >> 65) as u64;
    sign * power_of_two(leading as f64, exponent - BIAS - 63)
}

/// `value` 2^`exponent`, in two steps, so that no factor leaves the range of `f64` before the
/// product does.
fn power_of_two(value: f64, exponent: i32) -> f64 {
    let half = (exponent / 2).clamp(-1000, 1000);
    let rest = (exponent - half).clamp(-1000, 1000);
    value * 2f64.powi(half) * 2f64.powi(rest)
}

/// |z| in `f64`: where sizes are compared, no more digits are needed.
pub(super) fn modulus(z: WideComplex) -> f64 {
    rounded(z.re).hypot(rounded(z.im))
}

/// The square root with a real part that is not negative.
pub(super) fn square_root(z: WideComplex) -> WideComplex {
    // The part without cancellation comes first, the other follows from the product of both.
    let larger = ((z.norm_sqr().sqrt() + z.re.abs()) / f256::TWO).sqrt();
    if larger == f256::ZERO {
        return z;
    }
    let smaller = z.im.abs() / (larger + larger);
    let (re, im) = if z.re.is_sign_negative() { (smaller, larger) } else { (larger, smaller) };
    Complex::new(re, if z.im.is_sign_negative() { -im } else { im })
}

/// A complex number of `f64`, exactly.
pub(super) fn widened(z: Complex<f64>) -> WideComplex {
    Complex::new(f256::from(z.re), f256::from(z.im))
}

impl Arithmetic for Wide {
    type Value = f256;

    fn constant(self, value: Rational) -> Option<f256> {
        Some(f256::from(value.numerator()) / f256::from(value.denominator()))
    }
    fn add(self, a: f256, b: f256) -> f256 {
        a + b
    }
    fn sub(self, a: f256, b: f256) -> f256 {
        a - b
    }
    fn mul(self, a: f256, b: f256) -> f256 {
        a * b
    }
    fn div(self, a: f256, b: f256) -> Option<f256> {
        (b != f256::ZERO).then(|| a / b)
    }
    fn pivot_size(self, a: f256) -> f64 {
        rounded(a.abs())
    }
    fn rounding(self) -> f64 {
        2f64.powi(1 - BITS as i32)
    }
    fn zero(self) -> f256 {
        f256::ZERO
    }
    fn one(self) -> f256 {
        f256::ONE
    }
    fn neg(self, a: f256) -> f256 {
        -a
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_returns_what_was_widened() {
        for x in [0.0, 1.0, -1.0, 0.1, -3.75e-300, 1.7e308, f64::MIN_POSITIVE, 2f64.powi(-1040), f64::EPSILON] {
            assert_eq!(rounded(f256::from(x)), x, "{x}");
        }
        let third = f256::ONE / f256::from(3);
        assert!((rounded(third) - 1.0 / 3.0).abs() <= f64::EPSILON / 4.0);
        assert_eq!(rounded(f256::from(f64::MAX) * f256::from(f64::MAX)), f64::INFINITY);
        assert_eq!(rounded(-f256::from(f64::MIN_POSITIVE) * f256::from(f64::MIN_POSITIVE)), 0.0);
        assert!(rounded(f256::NAN).is_nan());
    }

    #[test]
    fn square_roots_have_all_digits() {
        for (re, im) in [(2.0, 0.0), (-2.0, 0.0), (0.3, -1.7), (-5.0, 1e-30)] {
            let z = widened(Complex::new(re, im));
            let root = square_root(z);
            assert!(modulus(root * root - z) <= 1e-69 * modulus(z), "{re} {im}");
            assert!(!root.re.is_sign_negative());
        }
    }
}
