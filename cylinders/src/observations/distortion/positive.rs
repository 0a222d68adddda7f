//! Whether a polynomial is positive on an interval.

/// Parts of the interval that are looked at before the answer is no. Each is half of another.
const MAX_PARTS: usize = 400;

/// Whether `sum of coefficients[i] s^i` is certainly positive for `0 <= s <= end`.
///
/// In the basis of Bernstein polynomials the value lies between the least and the largest
/// coefficient, and the first and the last coefficients are the values at the ends. Where that does
/// not decide, the interval is halved (de Casteljau). A polynomial that touches zero is not
/// positive.
pub(super) fn is_positive<const COUNT: usize>(coefficients: &[f64; COUNT], end: f64) -> bool {
    let degree = (COUNT - 1) as f64;
    let mut scaled = *coefficients;
    let mut power = 1.0;
    for (index, coefficient) in scaled.iter_mut().enumerate() {
        // b_i = sum_j C(i, j) / C(n, j) a_j, by differences: c_j = a_j / C(n, j).
        *coefficient *= power;
        power *= end * (index as f64 + 1.0) / (degree - index as f64).max(1.0);
    }
    for level in 1..COUNT {
        for index in (level..COUNT).rev() {
            scaled[index] += scaled[index - 1];
        }
    }
    let mut parts = vec![scaled];
    for _ in 0..MAX_PARTS {
        let Some(part) = parts.pop() else { return true };
        if part.iter().all(|&value| value > 0.0) {
            continue;
        }
        // The negation also catches NaN.
        if !(part[0] > 0.0 && part[COUNT - 1] > 0.0) {
            return false;
        }
        parts.extend(halves(part));
    }
    false
}

fn halves<const COUNT: usize>(mut part: [f64; COUNT]) -> [[f64; COUNT]; 2] {
    let mut left = part;
    for level in 1..COUNT {
        for index in 0..COUNT - level {
            part[index] = 0.5 * (part[index] + part[index + 1]);
        }
        left[level] = part[0];
    }
    [left, part]
}

#[cfg(test)]
mod tests {
    use super::is_positive;

    #[test]
    fn roots_in_the_interval_are_found() {
        // (s - 1) (s - 2) = 2 - 3 s + s^2
        for (end, expected) in [(0.5, true), (0.999_999, true), (1.000_001, false), (1.5, false), (5.0, false)] {
            assert_eq!(is_positive(&[2.0, -3.0, 1.0], end), expected, "{end}");
        }
        // (s - 1)^2 + 1e-6 has no root, (s - 1)^2 touches zero.
        assert!(is_positive(&[1.0 + 1e-6, -2.0, 1.0], 3.0));
        assert!(!is_positive(&[1.0, -2.0, 1.0], 3.0));
        assert!(!is_positive(&[1.0, f64::NAN], 3.0) && !is_positive(&[1.0, 0.0], f64::INFINITY));
        // 1 + s - s^3 has its root at 1.3247.
        assert!(is_positive(&[1.0, 1.0, 0.0, -1.0], 1.3247) && !is_positive(&[1.0, 1.0, 0.0, -1.0], 1.3248));
    }
}
