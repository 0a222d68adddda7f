//! How many rectangles as good as one are expected by chance (LSD, section 2.6).
//!
//! ```text
//!   NFA = (number of rectangles in the image) * P(B(n, p) >= k)
//! ```
//!
//! for `n` pixels in the rectangle, `k` of them aligned with it within the tolerance `p pi`. In an
//! image of `w x h` pixels there are about `(w h)^(5/2)` rectangles, for each of 11 tolerances.

use std::f64::consts::{LN_10, TAU};

/// Number of tolerances that are tried.
const TOLERANCES: f64 = 11.0;

/// Terms of the tail that add less than this part of it are left out.
const NEGLIGIBLE: f64 = 1e-10;

/// Decimal logarithm of the number of rectangles in an image.
pub(super) fn log_tests(width: usize, height: usize) -> f64 {
    2.5 * ((width as f64).log10() + (height as f64).log10()) + TOLERANCES.log10()
}

/// `-log10` of the number of false alarms: greater than 0 is not by chance.
pub(super) fn significance(log_tests: f64, pixels: usize, aligned: usize, probability: f64) -> f64 {
    if pixels == 0 || aligned == 0 {
        return -log_tests;
    }
    let (n, k) = (pixels as f64, aligned as f64);
    let log_first = ln_factorial(n) - ln_factorial(k) - ln_factorial(n - k)
        + k * probability.ln()
        + (n - k) * (-probability).ln_1p();
    // Each term of the tail from the one before it, all relative to the first.
    let odds = probability / (1.0 - probability);
    let (mut term, mut sum) = (1.0, 1.0);
    for i in aligned + 1..=pixels {
        let ratio = (n - i as f64 + 1.0) / i as f64 * odds;
        term *= ratio;
        sum += term;
        // From here on the rest is less than a geometric series.
        if ratio < 1.0 && term * ratio / (1.0 - ratio) < NEGLIGIBLE * sum {
            break;
        }
    }
    -(log_first + sum.ln()).min(0.0) / LN_10 - log_tests
}

/// `ln n!` by Stirling's series at 10 or above, and by the product below.
fn ln_factorial(n: f64) -> f64 {
    if n < 10.0 {
        return (2..=n as usize).map(|factor| (factor as f64).ln()).sum();
    }
    n * n.ln() - n + 0.5 * (TAU * n).ln() + 1.0 / (12.0 * n) - 1.0 / (360.0 * n.powi(3))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tail_is_the_sum_of_its_terms() {
        for (n, k, p) in [(5_usize, 3_usize, 0.125_f64), (40, 10, 0.125), (40, 3, 0.5), (300, 200, 0.0625)] {
            let term = |i: usize| {
                let choose: f64 = (1..=i).map(|j| (n - i + j) as f64 / j as f64).product();
                choose * p.powi(i as i32) * (1.0 - p).powi((n - i) as i32)
            };
            let tail: f64 = (k..=n).map(term).sum();
            assert!((significance(0.0, n, k, p) + tail.log10()).abs() < 1e-6, "{n} {k} {p}");
        }
    }
}
