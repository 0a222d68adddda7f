//! The few floating-point functions that `core` lacks.

/// Square root, correctly rounded.
#[cfg(feature = "std")]
#[inline]
pub(crate) fn sqrt(x: f64) -> f64 {
    x.sqrt()
}

/// Square root, correctly rounded.
#[cfg(all(not(feature = "std"), feature = "libm"))]
#[inline]
pub(crate) fn sqrt(x: f64) -> f64 {
    libm::sqrt(x)
}

/// sqrt(x^2 + y^2) without overflow or harmful underflow, to a few units in the last place.
#[inline]
pub(crate) fn hypot(x: f64, y: f64) -> f64 {
    let square = x * x + y * y;
    if square > 1e-280 && square < 1e300 {
        return sqrt(square);
    }
    let (large, small) = if x.abs() >= y.abs() { (x.abs(), y.abs()) } else { (y.abs(), x.abs()) };
    if large == 0.0 || large == f64::INFINITY {
        return large + small;
    }
    let quotient = small / large;
    large * sqrt(1.0 + quotient * quotient)
}

/// 2^exponent for exponents of normal numbers, clamped to them.
#[inline]
pub(crate) fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((exponent.clamp(-1022, 1023) + 1023) as u64) << 52)
}

/// floor(log2 |x|); -1023 for zero and subnormal numbers, 1024 for infinities and NaN.
#[inline]
pub(crate) fn exponent(x: f64) -> i32 {
    ((x.to_bits() >> 52) & 0x7ff) as i32 - 1023
}
