//! Inequalities that solutions must satisfy.

/// A polynomial that is positive at the solutions that are wanted: the slot of the coefficient of
/// each term, and the exponents of all unknowns in it.
pub type Inequality<'a> = &'a [(u16, &'a [u8])];

/// Whether all inequalities hold at x.
#[inline]
#[must_use]
pub fn is_wanted(inequalities: &[Inequality<'_>], coefficient: impl Fn(usize) -> f64, x: &[f64]) -> bool {
    inequalities.iter().all(|terms| {
        let mut sum = 0.0;
        for &(slot, exponents) in *terms {
            let mut term = coefficient(usize::from(slot));
            for (&x, &exponent) in x.iter().zip(exponents) {
                (0..exponent).for_each(|_| term *= x);
            }
            sum += term;
        }
        sum > 0.0
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_inequalities_must_hold() {
        // 2 x^2 y - 3 > 0, x > 0
        let (coefficients, inequalities) = ([2.0, -3.0, 1.0], [&[(0, &[2, 1][..]), (1, &[0, 0])][..], &[(2, &[1, 0])]]);
        let is_wanted = |x: [f64; 2]| is_wanted(&inequalities, |slot| coefficients[slot], &x);
        assert!(
            is_wanted([2.0, 1.0]) && !is_wanted([1.0, 1.0]) && !is_wanted([-2.0, 1.0]) && !is_wanted([f64::NAN; 2])
        );
    }
}
