//! Solutions that share an eigenpair and differ by signs only.

use crate::number::Scalar;
use crate::size::Vector;

/// Changes of sign that map solutions to solutions. The template does not tell these solutions
/// apart: an eigenpair determines them up to the changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SignChanges<'a> {
    /// For each unknown x one exponent per unknown: the monomial by which the pairs of x differ.
    /// The monomial is x^2, or x times unknowns whose squares are known, or times their
    /// reciprocals. All exponents are zero for an unknown that is not read.
    pub steps: &'a [&'a [i8]],
    /// All changes except the identity. For each change: which unknowns it negates.
    pub flips: &'a [&'a [bool]],
}

impl SignChanges<'_> {
    /// Computes the unknowns from the ratios of their pairs. The result is not finite if there is
    /// no real root, or if a factor is zero.
    #[inline]
    pub(crate) fn resolve<S: Scalar>(&self, ratios: &mut [S]) {
        let step = |unknown: usize, of: usize| {
            let steps = self.steps.get(unknown).copied().unwrap_or(&[]);
            steps.get(of).copied().unwrap_or(0)
        };
        for unknown in 0..ratios.len() {
            if step(unknown, unknown) == 2 {
                ratios[unknown] = ratios[unknown].sqrt();
            }
        }
        for unknown in (0..ratios.len()).filter(|&unknown| step(unknown, unknown) == 1) {
            for other in (0..ratios.len()).filter(|&other| other != unknown) {
                let factor = ratios[other];
                match step(unknown, other) {
                    0 => {}
                    1 => ratios[unknown] *= factor.reciprocal(),
                    _ => ratios[unknown] *= factor,
                }
            }
        }
    }
}

/// The unknowns, with the signs of some of them changed.
#[inline]
pub(crate) fn flipped<S: Scalar, V: Vector<S>>(unknowns: &V, flip: &[bool]) -> V {
    let mut flipped = unknowns.clone();
    for (unknown, &changes) in flipped.as_mut().iter_mut().zip(flip) {
        *unknown = if changes { -*unknown } else { *unknown };
    }
    flipped
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_complex::Complex;

    /// (x, y, z) with x^2, x y and z / x known.
    const CHANGES: SignChanges<'static> =
        SignChanges { steps: &[&[2, 0, 0], &[1, 1, 0], &[-1, 0, 1]], flips: &[&[true, true, true]] };

    #[test]
    fn unknowns_follow_up_to_sign() {
        let mut x = [4.0, -6.0, 2.5];
        CHANGES.resolve(&mut x);
        assert_eq!(x, [2.0, -3.0, 5.0]);
        assert_eq!(flipped(&x, CHANGES.flips[0]), [-2.0, 3.0, -5.0]);
        let mut imaginary = [-4.0, -6.0, 2.5].map(Complex::from);
        CHANGES.resolve(&mut imaginary);
        assert_eq!(imaginary, [(0.0, 2.0), (0.0, 3.0), (0.0, 5.0)].map(|(re, im)| Complex { re, im }));
    }

    #[test]
    fn without_a_root_nothing_is_finite() {
        for first in [-4.0, 0.0, f64::NAN, f64::INFINITY] {
            let mut x = [first, -6.0, 2.5];
            CHANGES.resolve(&mut x);
            assert!(!x.iter().all(|x| x.is_finite()), "{x:?}");
        }
    }
}
