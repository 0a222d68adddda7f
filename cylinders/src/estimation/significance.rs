//! Whether lines could agree with a cylinder by chance (Moisan & Stival, "A Probabilistic Criterion
//! to Detect Rigid Point Matches between Two Images", 2004).
//!
//! Three lines determine a cylinder, up to four in fact. If the other `n - 3` lines were anywhere
//! in images as wide as the focal length `f`, and a part `q` of them along the axis, one of them
//! would be within `t` of one of two silhouettes with a probability of at most `p = 4 q t / f`. The
//! expected number of cylinders on which `k` lines agree by chance is
//!
//! ```text
//!   false alarms = 4 (n - 3) C(n, k) C(k, 3) p^(k - 3)
//! ```
//!
//! where the factor `n - 3` is for the choice of `k`. The part `q` is that of the lines that do not
//! agree.

/// Natural logarithm of the expected number of cylinders on which `agreeing` of `lines` lines agree
/// by chance within `threshold`, `q t / f`. Infinite for fewer than four lines.
pub(crate) fn log_false_alarms(agreeing: usize, lines: usize, threshold: f64) -> f64 {
    if agreeing < 4 || lines < agreeing {
        return f64::INFINITY;
    }
    let probability = (4.0 * threshold).clamp(f64::MIN_POSITIVE, 1.0);
    (4.0 * (lines - 3) as f64).ln()
        + log_choices(lines, agreeing)
        + log_choices(agreeing, 3)
        + (agreeing - 3) as f64 * probability.ln()
}

fn log_choices(count: usize, chosen: usize) -> f64 {
    (0..chosen).map(|index| ((count - index) as f64 / (index + 1) as f64).ln()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_lines_of_many_may_agree_by_chance() {
        // 4 * 1 * 1 * 4 * 0.004.
        assert!((log_false_alarms(4, 4, 0.001) - 0.064_f64.ln()).abs() < 1e-12);
        assert!(log_false_alarms(4, 30, 0.001) > 0.0);
        assert!(log_false_alarms(30, 300, 0.001) < -30.0);
        assert!(log_false_alarms(30, 30, 1.0) > 0.0, "everything agrees");
        assert_eq!(log_false_alarms(3, 30, 0.001), f64::INFINITY);
    }
}
