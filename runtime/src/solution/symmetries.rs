//! Solutions that share an eigenpair: they differ by signs and by the order of unknowns only.

use crate::number::Scalar;
use crate::size::Vector;

/// The value that an unknown has at another solution: that of the unknown with this position, with
/// the other sign if `true`.
pub type Image = (u8, bool);

/// Changes of sign and exchanges of unknowns that map solutions to solutions. The template does not
/// tell these solutions apart: an eigenpair determines them up to the maps.
///
/// ```text
///   map                  of (x, y, z)     images
///   change of signs      (-x, -y, z)      (0, true), (1, true), (2, false)
///   exchange             (y, x, -z)       (1, false), (0, false), (2, true)
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Symmetries<'a> {
    /// For each unknown x one exponent per unknown: the monomial by which the pairs of x differ.
    /// The monomial is x^2, or x times unknowns whose squares are known, or times their
    /// reciprocals. All exponents are zero for an unknown that is not read.
    pub steps: &'a [&'a [i8]],
    /// All maps except the identity. For each map: the image of each unknown.
    pub images: &'a [&'a [Image]],
}

impl Symmetries<'_> {
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

/// The solution that a map leads to from this one. An unknown without an image keeps its value.
#[inline]
pub(crate) fn mapped_by<S: Scalar, V: Vector<S>>(images: &[Image], unknowns: &V) -> V {
    let mut mapped = unknowns.clone();
    for (unknown, &(of, is_negated)) in mapped.as_mut().iter_mut().zip(images) {
        let Some(&value) = unknowns.as_ref().get(usize::from(of)) else { continue };
        *unknown = if is_negated { -value } else { value };
    }
    mapped
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_complex::Complex;

    /// (x, y, z) with x^2, x y and z / x known.
    const CHANGES: Symmetries<'static> =
        Symmetries { steps: &[&[2, 0, 0], &[1, 1, 0], &[-1, 0, 1]], images: &[&[(0, true), (1, true), (2, true)]] };

    #[test]
    fn unknowns_follow_up_to_sign() {
        let mut x = [4.0, -6.0, 2.5];
        CHANGES.resolve(&mut x);
        assert_eq!(x, [2.0, -3.0, 5.0]);
        assert_eq!(mapped_by(CHANGES.images[0], &x), [-2.0, 3.0, -5.0]);
        let mut imaginary = [-4.0, -6.0, 2.5].map(Complex::from);
        CHANGES.resolve(&mut imaginary);
        assert_eq!(imaginary, [(0.0, 2.0), (0.0, 3.0), (0.0, 5.0)].map(|(re, im)| Complex { re, im }));
    }

    #[test]
    fn unknowns_take_the_values_of_others() {
        let x = [1.0, 2.0, 3.0];
        assert_eq!(mapped_by(&[(1, false), (0, true), (2, true)], &x), [2.0, -1.0, -3.0]);
        assert_eq!(mapped_by(&[(0, true), (9, false)], &x), [-1.0, 2.0, 3.0]);
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
