//! Units of data and unknowns: scalings under which a problem stays the same.
//!
//! Data in other units than those that a template likes lose digits: the monomials of its basis
//! differ by powers of the unit. A problem stays the same under
//!
//! ```text
//!   data d_i -> 2^(w_i . s) d_i,   unknowns x_j -> 2^(u_j . s) x_j       s: one number per scaling
//! ```
//!
//! with weights w and u that the generator finds. The s that makes the data about 1 is a problem of
//! least squares, in the logarithms e_i = log2 |d_i|:
//!
//! ```text
//!   minimise the sum of a_i (e_i + w_i . s)^2
//! ```
//!
//! Factors are powers of two, so that no digit changes. Entries that are far below the others, as
//! zeros are after rounding, say nothing of the unit: their parts a_i are small.

use crate::number::Scalar;
use crate::number::float::{exponent, power_of_two};

/// Solvers have no more scalings.
pub const MOST_SCALINGS: usize = 8;

/// What most solvers have at most.
const FEW_SCALINGS: usize = 4;

/// Data from 2^-this to 2^this are left as they are.
const ORDINARY: i32 = 10;
/// Unknowns that would change by a smaller power of two are left as they are, with the data.
const LEAST: i32 = 3;
/// As [`LEAST`], for elements of a vector up to scale. The chart in which it is solved for mixes
/// them, so that in another unit small ones lose the digits that they have beside the largest.
const LEAST_OF_VECTORS: i32 = ORDINARY;
/// 2^LEAST
const NEAR: f64 = (1_u64 << LEAST) as f64;
/// Unknowns and data are not changed by larger powers of two.
const MOST: i32 = 500;
/// An entry so many powers of two below the unit has half a part in it.
const LOW: f64 = 6.0;
/// The parts follow from the unit, and the unit from the parts, so many times.
const ROUNDS: usize = 8;
/// Scaled data that are further from 1, by so many powers of two in the mean square, have not been
/// explained by units.
const EXPLAINED: f64 = 6.0;
/// The part of the identity in the normal equations: directions without data stay as they are.
const RIDGE: f64 = 1e-6;

/// The scalings of a problem.
#[derive(Clone, Copy, Debug)]
pub struct Scalings<'a> {
    /// How many there are, up to [`MOST_SCALINGS`].
    pub count: usize,
    /// The weights of each datum: `count` for the first, then those of the next.
    pub data: &'a [i8],
    /// The weights of each unknown.
    pub unknowns: &'a [i8],
    /// The unknowns that are elements of vectors up to scale: bit k stands for unknown k.
    pub in_vectors: u32,
}

/// A number per scaling.
type Scales = [f64; MOST_SCALINGS];

impl Scalings<'_> {
    /// Scales data that are far from 1. Returns the exponents of the powers of two by which the
    /// unknowns of the scaled problem exceed those of the given one.
    #[inline]
    pub fn apply<const N: usize>(&self, data: &mut [f64]) -> [i16; N] {
        let mut exponents = [0; N];
        self.apply_into(data, &mut exponents);
        exponents
    }

    /// As [`Scalings::apply`], for a number of unknowns that is known at run time.
    #[inline]
    pub fn apply_into(&self, data: &mut [f64], exponents: &mut [i16]) {
        const LARGE: f64 = (1_u64 << ORDINARY) as f64;
        // Counted, with no early end, so that it is done with vector instructions.
        let is_ordinary = |size: f64| (size <= LARGE) & ((size >= 1.0 / LARGE) | (size == 0.0));
        if data.iter().map(|x| u64::from(!is_ordinary(x.abs()))).sum::<u64>() > 0 {
            self.fit(data, exponents);
        }
    }

    #[cold]
    #[inline(never)]
    fn fit(&self, data: &mut [f64], exponents: &mut [i16]) {
        // Data that are not finite have no unit, and `check_coefficients` refuses them.
        if self.count == 0 || self.count > MOST_SCALINGS || !data.iter().all(|x| x.is_finite()) {
            return;
        }
        if self.is_near_in_all_units(data) {
            return;
        }
        let largest_change = |scales: &Scales| {
            let change = |weights: &[i8]| weights.iter().zip(scales).map(|(&w, s)| f64::from(w) * s).sum::<f64>();
            self.unknowns.chunks_exact(self.count).map(change).map(f64::abs).fold(0.0, f64::max)
        };
        // Most data with an entry out of range have no other unit: an entry is small by chance.
        // Where a unit explains the data, the first step finds it, whatever the parts are.
        if largest_change(&self.step(data, &[0.0; MOST_SCALINGS], LOW).0) < f64::from(LEAST) - 1.0 {
            return;
        }
        let (scales, rest) = self.scales(data);
        if rest > EXPLAINED * EXPLAINED {
            return;
        }
        let scales = scales.map(rounded);
        let shift = |weights: &[i8]| weights.iter().zip(scales).map(|(&w, s)| i32::from(w) * s).sum::<i32>();
        let of_unknowns = || self.unknowns.chunks_exact(self.count).map(shift);
        let largest = of_unknowns().map(i32::abs).max().unwrap_or(0);
        let least = |unknown: usize| if self.in_vectors >> unknown & 1 == 1 { LEAST_OF_VECTORS } else { LEAST };
        let changes = of_unknowns().enumerate().any(|(unknown, shift)| shift.abs() >= least(unknown));
        let fits = |(x, weights): (&f64, &[i8])| {
            let shift = shift(weights);
            shift.abs() <= MOST && (*x == 0.0 || (exponent(*x) + shift).abs() < 1000)
        };
        let weights = || self.data.chunks_exact(self.count);
        if !changes || largest > MOST || !data.iter().zip(weights()).all(fits) {
            return;
        }
        for (x, weights) in data.iter_mut().zip(weights()) {
            *x *= power_of_two(shift(weights));
        }
        for (exponent, shift) in exponents.iter_mut().zip(of_unknowns()) {
            *exponent = shift as i16;
        }
    }

    /// Whether the largest of data with equal weights, one after another, is always near 1. A unit
    /// changes all of them alike: those that are far from 1 are small by chance.
    fn is_near_in_all_units(&self, data: &[f64]) -> bool {
        let is_near = |largest: f64| largest == 0.0 || (1.0 / NEAR..=NEAR).contains(&largest);
        let (mut weights, mut largest): (&[i8], f64) = (&[], 0.0);
        for (x, of_datum) in data.iter().zip(self.data.chunks_exact(self.count)) {
            if of_datum != weights {
                if !is_near(largest) {
                    return false;
                }
                (weights, largest) = (of_datum, 0.0);
            }
            // What no equation reads has no weights, and may have any size.
            if of_datum.iter().any(|&w| w != 0) {
                largest = largest.max(x.abs());
            }
        }
        is_near(largest)
    }

    /// The scalings that make data about 1, and the mean square of the logarithms of what these
    /// make of the data.
    fn scales(&self, data: &[f64]) -> (Scales, f64) {
        let (mut scales, mut rest) = ([0.0; MOST_SCALINGS], 0.0);
        for round in 0..=ROUNDS {
            // All count alike at first.
            let (new, rest_now) = self.step(data, &scales, if round == 0 { f64::INFINITY } else { LOW });
            rest = rest_now;
            if round == ROUNDS || new.iter().zip(&scales).all(|(a, b)| (a - b).abs() < 0.25) {
                break;
            }
            scales = new;
        }
        (scales, rest)
    }

    /// The scalings that make data about 1 with the parts that follow from these scales, and the
    /// mean square of the logarithms of what these make of the data. An entry `low` powers of two
    /// below 1 has half a part.
    fn step(&self, data: &[f64], scales: &Scales, low: f64) -> (Scales, f64) {
        // Most problems have few; the compiler knows the lengths of these loops.
        match self.count <= FEW_SCALINGS {
            true => self.step_of::<FEW_SCALINGS>(data, scales, low),
            false => self.step_of::<MOST_SCALINGS>(data, scales, low),
        }
    }

    /// As [`Self::step`], for at most P scalings.
    #[inline(always)]
    fn step_of<const P: usize>(&self, data: &[f64], scales: &Scales, low: f64) -> (Scales, f64) {
        let (mut normal, mut right) = ([[0.0; P]; P], [0.0; P]);
        let [mut squares, mut parts] = [0.0; 2];
        for (&x, weights) in data.iter().zip(self.data.chunks_exact(self.count)) {
            // A datum without weights says nothing: measurements from which others are derived have
            // none, as no equation reads them.
            if x == 0.0 || weights.iter().all(|&w| w == 0) {
                continue;
            }
            let mut all = [0.0; P];
            all.iter_mut().zip(weights).for_each(|(all, &w)| *all = f64::from(w));
            let size = f64::from(exponent(x)) + 0.5;
            let scaled = all.iter().zip(scales).fold(size, |sum, (w, scale)| sum + w * scale);
            let below = scaled.min(0.0) / low;
            let part = 1.0 / (1.0 + below * below);
            squares += part * scaled * scaled;
            parts += part;
            for i in 0..P {
                let w = all[i] * part;
                right[i] -= w * size;
                for at in 0..P {
                    normal[i][at] += w * all[at];
                }
            }
        }
        let mut new = [0.0; MOST_SCALINGS];
        new[..P].copy_from_slice(&solved(&mut normal, &mut right, self.count));
        (new, if parts > 0.0 { squares / parts } else { 0.0 })
    }
}

/// The nearest integer; 0 for what is no number.
fn rounded(x: f64) -> i32 {
    (x + if x < 0.0 { -0.5 } else { 0.5 }) as i32
}

/// The solution of positive semidefinite equations with a small part of the identity added.
fn solved<const P: usize>(a: &mut [[f64; P]; P], b: &mut [f64; P], count: usize) -> [f64; P] {
    for (i, row) in a.iter_mut().enumerate() {
        row[i] += RIDGE;
    }
    for k in 0..count {
        let (row, of_row) = (a[k], b[k]);
        for i in k + 1..count {
            let factor = a[i][k] / row[k];
            for (entry, above) in a[i].iter_mut().zip(row).skip(k) {
                *entry -= factor * above;
            }
            b[i] -= factor * of_row;
        }
    }
    let mut x = [0.0; P];
    for k in (0..count).rev() {
        let known = (k + 1..count).fold(b[k], |sum, j| sum - a[k][j] * x[j]);
        x[k] = known / a[k][k];
    }
    x
}

/// The unknowns of the problem as it was given, from those of the scaled one, in place.
#[inline]
pub fn unscale<T: Scalar>(exponents: &[i16], unknowns: &mut [T]) {
    for (x, &exponent) in unknowns.iter_mut().zip(exponents) {
        *x = x.scale(power_of_two(-i32::from(exponent)));
    }
}

/// As [`unscale`], of an array.
#[inline]
pub fn unscaled<T: Scalar, const N: usize>(exponents: &[i16; N], mut unknowns: [T; N]) -> [T; N] {
    unscale(exponents, &mut unknowns);
    unknowns
}

/// The unknowns of the scaled problem.
#[inline]
pub fn scaled<T: Scalar, const N: usize>(exponents: &[i16; N], unknowns: [T; N]) -> [T; N] {
    unscaled(&exponents.map(|exponent| -exponent), unknowns)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// x^2 d0 + x d1 + d2 and y d3 + d4: x and y have units, and each equation has a factor.
    const SCALINGS: Scalings<'static> = Scalings {
        count: 4,
        data: &[-2, 0, 1, 0, -1, 0, 1, 0, 0, 0, 1, 0, 0, -1, 0, 1, 0, 0, 0, 1],
        unknowns: &[1, 0, 0, 0, 0, 1, 0, 0],
        in_vectors: 0,
    };

    fn applied(mut data: [f64; 5]) -> ([f64; 5], [i16; 2]) {
        let exponents = SCALINGS.apply(&mut data);
        (data, exponents)
    }

    #[test]
    fn ordinary_data_stay_as_they_are() {
        for data in [[1.0, -2.0, 3.0, 1e3, 1e-3], [0.0; 5], [0.0, 1.0, 0.0, -1.0, 0.0]] {
            assert_eq!(applied(data), (data, [0, 0]));
        }
    }

    #[test]
    fn the_largest_of_equal_weights_tells_of_a_unit() {
        // Two data of one weight, one without any, and one of another weight.
        let scalings = Scalings { count: 2, data: &[1, 0, 1, 0, 0, 0, 0, 1], unknowns: &[1, 1], in_vectors: 0 };
        for (data, is_near) in [
            ([1.0, 1e-9, 1e9, 1.0], true),
            ([1e-9, -1.0, 0.0, -4.0], true),
            ([0.0, 0.0, 1e-9, 1.0], true),
            ([1e-9, 1e-9, 1.0, 1.0], false),
            ([1.0, 100.0, 1.0, 1.0], false),
            ([1.0, 1.0, 1.0, 1e-3], false),
        ] {
            assert_eq!(scalings.is_near_in_all_units(&data), is_near, "{data:?}");
        }
    }

    #[test]
    fn units_are_found_and_change_nothing() {
        for unit in [1e-60, 1e-12, 1e-8, 1e8, 1e12, 1e60_f64] {
            // Roots are 1 and 2 units, and -3.
            let (data, exponents) = applied([1.0, -3.0 * unit, 2.0 * unit * unit, 1.0, 3.0]);
            let binary = unit.log2();
            assert!(
                (f64::from(exponents[0]) + binary).abs() < 2.0 && exponents[1].abs() < 2,
                "{unit:e}: {exponents:?}"
            );
            assert!(data.iter().all(|x| x.abs() > 0.05 && x.abs() < 20.0), "{unit:e}: {data:?}");
            let x = scaled(&exponents, [unit, -3.0]);
            assert!((data[3] * x[1] + data[4]).abs() == 0.0);
            assert!((data[0] * x[0] * x[0] + data[1] * x[0] + data[2]).abs() < 1e-14 * data[2].abs());
            assert_eq!(unscaled(&exponents, x), [unit, -3.0]);
        }
    }

    #[test]
    fn elements_of_vectors_change_by_large_powers_only() {
        for (unit, in_vectors, changes) in [(200.0, 0, true), (200.0, 1, false), (200.0, 2, true), (2000.0, 1, true)] {
            let mut data = [1.0, -3.0 * unit, 2.0 * unit * unit, 1.0, 3.0];
            let exponents: [i16; 2] = Scalings { in_vectors, ..SCALINGS }.apply(&mut data);
            assert_eq!(exponents != [0, 0], changes, "{unit} {in_vectors:b}: {exponents:?}");
        }
    }

    #[test]
    fn what_should_be_zero_says_nothing_of_the_unit() {
        let (data, exponents) = applied([1.0, -3e-17, 2.0, 1.0, 3.0]);
        assert_eq!((data, exponents), ([1.0, -3e-17, 2.0, 1.0, 3.0], [0, 0]));
        let (_, exponents) = applied([1.0, -3e-25, 2e-16, 1.0, 3.0]);
        assert!((25..29).contains(&exponents[0]), "{exponents:?}");
    }

    #[test]
    fn data_that_are_no_numbers_stay_as_they_are() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let (data, exponents) = applied([1e20, bad, 1.0, 1.0, 1.0]);
            assert_eq!((data[0], exponents), (1e20, [0, 0]));
        }
        for extreme in [f64::MAX, f64::MIN_POSITIVE, 5e-324] {
            let (data, exponents) = applied([extreme, 1.0, 1.0 / extreme.max(1e-300), 1.0, 1.0]);
            assert!(data.iter().all(|x| x.is_finite()), "{data:?} {exponents:?}");
        }
    }
}
