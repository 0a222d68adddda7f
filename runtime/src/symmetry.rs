//! Solutions that differ by signs only and share an eigenpair.

use crate::scalar::Scalar;

/// Changes of sign that map solutions to solutions, where the template tells no sign of them: an eigenpair gives the solutions up to these changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Symmetry<const N: usize> {
    /// For each unknown x the exponents of the monomial by which its pairs differ: x^2, or x times unknowns of which the squares are
    /// known, or their reciprocals. None for an unknown that is not read.
    pub steps: [[i8; N]; N],
    /// All changes but that of no unknown: for each, which unknowns it changes.
    pub flips: &'static [[bool; N]],
}

impl<const N: usize> Symmetry<N> {
    /// The unknowns from the ratios of their pairs. Not finite where there is no real root, or where a factor is zero.
    #[inline]
    pub(crate) fn resolve<S: Scalar>(&self, ratios: &mut [S; N]) {
        for unknown in 0..N {
            if self.steps[unknown][unknown] == 2 {
                ratios[unknown] = ratios[unknown].sqrt();
            }
        }
        for unknown in (0..N).filter(|&unknown| self.steps[unknown][unknown] == 1) {
            for other in (0..N).filter(|&other| other != unknown) {
                match self.steps[unknown][other] {
                    0 => {}
                    1 => ratios[unknown] *= ratios[other].reciprocal(),
                    _ => ratios[unknown] *= ratios[other],
                }
            }
        }
    }
}

/// The same with the signs of some unknowns changed.
#[inline]
pub(crate) fn flipped<S: Scalar, const N: usize>(unknowns: &[S; N], flip: &[bool; N]) -> [S; N] {
    core::array::from_fn(|at| if flip[at] { -unknowns[at] } else { unknowns[at] })
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_complex::Complex;

    /// (x, y, z) with x^2, x y and z / x known.
    const SYMMETRY: Symmetry<3> = Symmetry { steps: [[2, 0, 0], [1, 1, 0], [-1, 0, 1]], flips: &[[true, true, true]] };

    #[test]
    fn unknowns_follow_up_to_sign() {
        let mut x = [4.0, -6.0, 2.5];
        SYMMETRY.resolve(&mut x);
        assert_eq!(x, [2.0, -3.0, 5.0]);
        assert_eq!(flipped(&x, &SYMMETRY.flips[0]), [-2.0, 3.0, -5.0]);
        let mut imaginary = [-4.0, -6.0, 2.5].map(Complex::from);
        SYMMETRY.resolve(&mut imaginary);
        assert_eq!(imaginary, [(0.0, 2.0), (0.0, 3.0), (0.0, 5.0)].map(|(re, im)| Complex { re, im }));
    }

    #[test]
    fn without_a_root_nothing_is_finite() {
        for first in [-4.0, 0.0, f64::NAN, f64::INFINITY] {
            let mut x = [first, -6.0, 2.5];
            SYMMETRY.resolve(&mut x);
            assert!(!x.iter().all(|x| x.is_finite()), "{x:?}");
        }
    }
}
