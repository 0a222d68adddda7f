//! Whether errors of a polynomial's coefficients can change the number of its real roots.
//!
//! The coefficients of a determinant have rounding errors of the elimination before it. The polish
//! shows how large they are: it moves a root x + d of the rounded polynomial p + e to the root x of
//! p. From p(x) = 0 and (p + e)(x + d) = 0 follows |e(x)| = |d p'(x)|, up to the square of d.
//! Relative errors of the coefficients c_k are then at least |d p'(x)| / sum of |c_k x^k|. At the
//! worst of several roots they are not much more, for which [`SAFETY`] stands.
//!
//! Written in the Bernstein basis of an interval, the polynomial with the coefficients |c_k|, times
//! these errors, bounds the errors of the Bernstein coefficients: their signs are beyond doubt, or
//! they have none. Halving an interval takes means of coefficients, so that the means of the bounds
//! are bounds for both halves.

use crate::size::Size;
use crate::spectrum::real_roots::{Isolation, LANES, UNIT, left_half, times_power_of_two};

/// Errors may be larger by this factor than those seen at the roots. With 3 in place of 300, the
/// eigenvalues gave more solutions on 2 of 300,000 scenes of five and six points whose roots were
/// certain, with 30 on none.
pub(crate) const SAFETY: f64 = 300.0;

/// Relative errors of this size are never excluded: those seen at roots may be small by chance.
pub(crate) const LEAST_ERROR: f64 = 1e-10;

/// Relative errors above this leave little to count.
const LARGEST_ERROR: f64 = 1e-2;

/// An interval is halved at most this often.
const HALVINGS: u32 = 14;

/// Whether all polynomials near this one, with coefficients c\[0\] + c\[1\] x + .., have the same
/// number of real roots. `moved` holds the roots, and by which part of itself each is off.
#[cold]
#[inline(never)]
pub(crate) fn count_is_certain<Z: Size>(size: Z, coefficients: &Z::Vector<f64>, moved: &[(f64, f64)]) -> bool {
    let c = coefficients.as_ref();
    if size.get() < 2 || c[0] == 0.0 || c[size.get() - 1] == 0.0 {
        return false;
    }
    let isolation = Isolation::<Z, true>::new(size);
    let (power, shift) = isolation.scaled(c);
    let mut moduli = power.clone();
    moduli.as_mut().iter_mut().for_each(|c| *c = c.abs());
    let (pieces, bounds) = (isolation.pieces(&power), isolation.pieces(&moduli));
    let mut error = 0.0;
    for &(root, part) in moved {
        let y = times_power_of_two(root, -shift) / UNIT;
        let lane = usize::from(y.abs() > 1.0) + if y < 0.0 { 2 } else { 0 };
        let t = if y.abs() > 1.0 { 1.0 / y.abs() } else { y.abs() };
        let (_, slope) = isolation.value_and_slope(&pieces, &[t; LANES]);
        let (size, _) = isolation.value_and_slope(&bounds, &[t; LANES]);
        error = f64::max(error, (part * t * slope[lane] / size[lane % 2]).abs());
    }
    let error = (SAFETY * error).max(LEAST_ERROR);
    let (pieces, bounds) = (isolation.bernstein(&pieces), isolation.bernstein(&bounds));
    error <= LARGEST_ERROR
        && (0..LANES).all(|lane| {
            let (mut of_lane, mut bound) = (size.filled(0.0), size.filled(0.0));
            for k in 0..size.get() {
                // The moduli of the coefficients are the same on both sides of zero.
                (of_lane[k], bound[k]) = (pieces[k][lane], error * bounds[k][lane % 2]);
            }
            is_certain(size, (&mut of_lane, &mut bound), HALVINGS)
        })
}

/// Halves an interval until the number of roots of each part is certain, or it is short. The
/// Bernstein coefficients come with their bounds.
fn is_certain<Z: Size>(size: Z, right: (&mut Z::Vector<f64>, &mut Z::Vector<f64>), halvings: u32) -> bool {
    let (right, bound) = right;
    if has_certain_sign_changes(right.as_ref(), bound.as_ref()) {
        return true;
    }
    if halvings == 0 {
        return false;
    }
    let degree = size.get() - 1;
    let mut left = (left_half::<Z>(degree, right), left_half::<Z>(degree, bound));
    // The end that both share must have a sign.
    right[0].abs() > bound[0]
        && is_certain(size, (&mut left.0, &mut left.1), halvings - 1)
        && is_certain(size, (right, bound), halvings - 1)
}

/// Whether there is no change of sign, or one, if coefficients within their bounds may have any
/// sign.
///
/// ```text
///   + + +        + -          + ? -        + ? ? -        + ? +        ?: may have any sign
///   no root      one root     one root     1 or 3         0 or 2
/// ```
fn has_certain_sign_changes(bernstein: &[f64], bounds: &[f64]) -> bool {
    let (mut changes, mut doubtful, mut sign) = (0, 0, 0.0);
    for (&b, &bound) in bernstein.iter().zip(bounds) {
        if !(b.abs() > bound) {
            doubtful += 1;
            continue;
        }
        let is_change = sign == -b.signum();
        if doubtful > u32::from(is_change) {
            return false;
        }
        changes += u32::from(is_change);
        (sign, doubtful) = (b.signum(), 0);
    }
    doubtful == 0 && changes <= 1
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use rand_xoshiro::Xoshiro256PlusPlus;
    use rand_xoshiro::rand_core::{Rng, SeedableRng};

    use super::*;
    use crate::size::Fixed;
    use crate::spectrum::real_roots::real_roots;

    #[test]
    fn signs_in_doubt() {
        let certain = |bernstein: &[f64]| has_certain_sign_changes(bernstein, &[0.1; 4]);
        for bernstein in [&[1.0, 2.0, 3.0][..], &[1.0, -1.0], &[2.0, 0.05, -1.0, -3.0], &[-2.0, 0.05, 1.0]] {
            assert!(certain(bernstein), "{bernstein:?}");
        }
        let uncertain: [&[f64]; 6] = [
            &[1.0, 0.05, 1.0],
            &[1.0, 0.05, 0.05, -1.0],
            &[1.0, -1.0, 1.0],
            &[0.05, 1.0],
            &[1.0, 0.05],
            &[1.0, f64::NAN, 1.0],
        ];
        for bernstein in uncertain {
            assert!(!certain(bernstein), "{bernstein:?}");
        }
    }

    /// Polynomials of degree 8 with known roots, some of them close pairs, whose coefficients are
    /// then changed: a count that is certain is that of the polynomial before the change.
    #[test]
    fn certain_counts_are_those_of_the_exact_polynomial() {
        let mut random = Xoshiro256PlusPlus::seed_from_u64(3);
        let mut number = || (random.next_u64() >> 11) as f64 * 2.0_f64.powi(-52) - 1.0;
        let (mut certain, mut wrong) = (0, 0);
        let trials = 20_000;
        for _ in 0..trials {
            let mut exact = std::vec![1.0];
            let mut count = 0;
            for pair in 0..4 {
                // x^2 - 2 m x + m^2 - h: real if h is not negative.
                let h = number().powi(3) * if pair == 0 { 1e-4 } else { 2.0 };
                let m = 2.0 * number();
                count += if h >= 0.0 { 2 } else { 0 };
                let mut next = std::vec![0.0; exact.len() + 2];
                for (k, c) in exact.iter().enumerate() {
                    next[k] += (m * m - h) * c;
                    next[k + 1] -= 2.0 * m * c;
                    next[k + 2] += c;
                }
                exact = next;
            }
            let level = 10.0_f64.powf(-7.0 + 2.0 * number());
            let changed: [f64; 9] = core::array::from_fn(|k| exact[k] * (1.0 + level * number()));
            let roots = real_roots(Fixed::<9>, &changed);
            let moved: Vec<(f64, f64)> = roots.roots.iter().map(|&x| (x, newton_step(&exact, x) / x.abs())).collect();
            let is_certain = roots.is_certain && !moved.is_empty() && count_is_certain(Fixed, &changed, &moved);
            certain += u32::from(is_certain);
            wrong += u32::from(roots.roots.len() != count);
            assert!(!is_certain || roots.roots.len() == count, "{level}: {exact:?}");
        }
        assert!(wrong > trials / 20 && certain > trials / 10, "{wrong} wrong and {certain} certain of {trials}");
    }

    /// A root that four solutions share has split into pairs, and no other root shows an error.
    #[test]
    fn a_shared_root_is_not_certain_to_be_none() {
        // (x - 1)^4 (x + 3) (x - 1/3), and a relative error of 1e-12 that splits the roots at 1.
        let mut c = [0.0; 7];
        for (k, of_quartic) in [1.0, -4.0, 6.0, -4.0, 1.0].into_iter().enumerate() {
            for (j, of_quadratic) in [-1.0, 8.0 / 3.0, 1.0].into_iter().enumerate() {
                c[k + j] += of_quartic * of_quadratic;
            }
        }
        c[3] *= 1.0 + 1e-12;
        let roots = real_roots(Fixed::<7>, &c);
        assert!(roots.is_certain && roots.roots.len() == 2, "{:?}", roots.roots);
        assert!(roots.clearance < LEAST_ERROR, "{}", roots.clearance);
        let moved: Vec<(f64, f64)> = roots.roots.iter().map(|&x| (x, 0.0)).collect();
        assert!(!count_is_certain(Fixed, &c, &moved));
    }

    /// |p / p'|
    fn newton_step(coefficients: &[f64], x: f64) -> f64 {
        let (mut value, mut slope) = (0.0, 0.0);
        for c in coefficients.iter().rev() {
            (slope, value) = (slope * x + value, value * x + c);
        }
        (value / slope).abs()
    }
}
