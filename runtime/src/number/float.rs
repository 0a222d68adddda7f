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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hypotenuses_neither_overflow_nor_vanish() {
        for unit in [1.0, 1e-100, 1e-140, 1e-160, 1e-300, 1e140, 1e150, 1e160, 1e300] {
            for (x, y) in [(3.0, 4.0), (-3.0, 4.0), (4.0, -3.0), (-4.0, -3.0)] {
                let exact = 5.0 * unit;
                assert!((hypot(x * unit, y * unit) - exact).abs() <= 4.0 * f64::EPSILON * exact, "{x} {y} {unit}");
            }
            assert_eq!([hypot(unit, 0.0), hypot(0.0, -unit)], [unit; 2]);
            // The smaller part is below rounding.
            assert_eq!([hypot(unit, 1e-20 * unit), hypot(1e-20 * unit, unit)], [unit; 2]);
        }
        // Their quotient overflows when it is squared.
        for (large, small) in [(1e160, 1e-10), (-1e160, 1e-10), (1e160, -1e-10), (-1e160, -1e-10)] {
            assert_eq!([hypot(large, small), hypot(small, large)], [1e160; 2]);
        }
        assert_eq!(hypot(0.0, -0.0), 0.0);
        assert_eq!([hypot(f64::INFINITY, f64::INFINITY), hypot(f64::NEG_INFINITY, 0.0)], [f64::INFINITY; 2]);
        assert_eq!(hypot(f64::INFINITY, f64::NEG_INFINITY), f64::INFINITY);
        assert_eq!([hypot(f64::INFINITY, 1.0), hypot(-1.0, f64::NEG_INFINITY)], [f64::INFINITY; 2]);
        assert!(hypot(f64::NAN, 1.0).is_nan() && hypot(1.0, f64::NAN).is_nan());
    }

    #[test]
    fn square_roots() {
        assert_eq!([0.0, 1.0, 2.25, 1e300, f64::INFINITY].map(sqrt), [0.0, 1.0, 1.5, 1e150, f64::INFINITY]);
        assert!(sqrt(-1.0).is_nan());
    }

    #[test]
    fn exponents_and_powers_of_two() {
        for exponent_of in [-1022, -1021, -1, 0, 1, 52, 1022, 1023] {
            let power = power_of_two(exponent_of);
            assert_eq!(power, 2.0_f64.powi(exponent_of));
            for x in [power, -power, 1.5 * power, 1.999 * power] {
                assert_eq!(exponent(x), exponent_of, "{x:e}");
            }
        }
        assert_eq!([-1023, -5000, 1024, 5000].map(power_of_two), [-1022, -1022, 1023, 1023].map(|k| 2.0_f64.powi(k)));
        assert_eq!([0.0, -0.0, 1e-310].map(exponent), [-1023; 3]);
        assert_eq!([f64::INFINITY, f64::NEG_INFINITY, f64::NAN].map(exponent), [1024; 3]);
    }
}
