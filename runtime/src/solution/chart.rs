//! Vectors that are given up to scale, and their coordinates in a chart.
//!
//! With an orthogonal matrix Q that is its own inverse, a vector e of n numbers is Q (u, 1) up to
//! scale, where the n - 1 coordinates u are solved for. Vectors with (Q e)_n = 0 have none.

use crate::number::{Scalar, float};
use crate::scaling::unscale;

/// The vector of length 1 with these coordinates: Q (u, 1) / |(u, 1)|.
#[inline]
pub fn from_chart<T: Scalar, const N: usize>(chart: &[[f64; N]; N], coordinates: &[T]) -> [T; N] {
    let mut vector = [T::ZERO; N];
    vector_of(chart, coordinates, &mut vector);
    vector
}

/// As [`from_chart`], for a length that is known at run time: that of `vector`.
pub fn vector_of<T: Scalar, R: AsRef<[f64]>>(chart: &[R], coordinates: &[T], vector: &mut [T]) {
    // Divided by the largest entry, so that no square overflows.
    let largest = coordinates.iter().fold(1.0, |largest: f64, u| largest.max(u.modulus()));
    let last = 1.0 / largest;
    let square = coordinates.iter().fold(last * last, |sum, u| sum + u.scale(last).modulus_squared());
    let scale = last / float::sqrt(square);
    for (entry, row) in vector.iter_mut().zip(chart) {
        let Some((&of_last, row)) = row.as_ref().split_last() else { continue };
        *entry = T::from_f64(of_last * scale);
        for (&u, &factor) in coordinates.iter().zip(row) {
            *entry += u.scale(factor * scale);
        }
    }
}

/// The coordinates of a vector of any length but 0: the entries of Q e but the last, divided by it.
/// A last entry of 0 stands for what rounding leaves of one that is small beside the vector.
#[inline]
pub fn to_chart<T: Scalar, R: AsRef<[f64]>>(chart: &[R], vector: &[T], coordinates: &mut [T]) {
    let entry = |row: &R| chart_entry(row.as_ref(), vector);
    let Some(last) = chart.last() else { return };
    let last = entry(last);
    let rounding = f64::EPSILON * vector.iter().fold(0.0, |largest: f64, x| largest.max(x.modulus()));
    let inverse = if last == T::ZERO { T::from_f64(rounding) } else { last }.reciprocal();
    for (coordinate, row) in coordinates.iter_mut().zip(chart) {
        *coordinate = entry(row) * inverse;
    }
}

/// Multiplies the entries of a vector but the last by 2^-exponent, and the vector by what gives it
/// length 1: one in the units of the given data, from that of the scaled problem.
#[inline]
pub fn unscale_vector<T: Scalar>(exponents: &[i16], vector: &mut [T]) {
    if exponents.iter().all(|&exponent| exponent == 0) {
        return;
    }
    unscale(exponents, vector);
    // Divided by the largest entry first, so that no square overflows.
    let largest = vector.iter().fold(0.0, |largest: f64, x| largest.max(x.modulus()));
    vector.iter_mut().for_each(|x| *x = x.scale(1.0 / largest));
    let square = vector.iter().fold(0.0, |sum, x| sum + x.modulus_squared());
    vector.iter_mut().for_each(|x| *x = x.scale(1.0 / float::sqrt(square)));
}

/// As [`unscale_vector`], from and to the coordinates of the vector, which is of any values. Small
/// entries keep only the digits that they have beside the largest.
pub fn unscale_in_chart<T: Scalar, R: AsRef<[f64]>>(
    chart: &[R],
    exponents: &[i16],
    (coordinates, vector): (&mut [T], &mut [T]),
) {
    if exponents.iter().any(|&exponent| exponent != 0) {
        vector_of(chart, coordinates, vector);
        unscale_vector(exponents, vector);
        to_chart(chart, vector, coordinates);
    }
}

/// An entry of Q e, for a row of Q.
#[inline]
pub fn chart_entry<T: Scalar>(row: &[f64], vector: &[T]) -> T {
    vector.iter().zip(row).fold(T::ZERO, |sum, (&x, &factor)| sum + x.scale(factor))
}

#[cfg(test)]
mod tests {
    use num_complex::Complex;

    use super::*;

    /// I - 2 v v^T / 17 with v = (2, 3, 2).
    fn chart() -> [[f64; 3]; 3] {
        let v = [2.0, 3.0, 2.0];
        core::array::from_fn(|i| core::array::from_fn(|j| f64::from(u8::from(i == j)) - 2.0 * v[i] * v[j] / 17.0))
    }

    #[test]
    fn vectors_have_length_1_and_their_coordinates_back() {
        for coordinates in [[0.3, -2.0], [0.0, 0.0], [1e200, -3e200], [1e-300, 1.0], [5e7, 0.0]] {
            let vector = from_chart(&chart(), &coordinates);
            let square: f64 = vector.iter().map(|x| x * x).sum();
            assert!((square - 1.0).abs() < 1e-15, "{vector:?}");
            let mut back = [0.0; 2];
            to_chart(&chart(), &vector.map(|x| -7.0 * x), &mut back);
            let size = coordinates.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
            if size < 1e100 {
                let error = |k: usize| (back[k] - coordinates[k]).abs();
                assert!((0..2).all(|k| error(k) <= 1e-14 * size * size), "{coordinates:?}: {back:?}");
            }
        }
    }

    #[test]
    fn a_vector_at_infinity_has_large_coordinates() {
        // A reflection that swaps the axes leaves a last entry of exactly 0.
        let mut back = [0.0; 1];
        to_chart(&[[0.0, 1.0], [1.0, 0.0]], &[0.0, -3.0], &mut back);
        assert_eq!(back, [-1.0 / f64::EPSILON]);
        to_chart(&[[0.0, 1.0], [1.0, 0.0]], &[1e-20, -3.0], &mut back);
        assert_eq!(back, [-3.0 / 1e-20]);
    }

    #[test]
    fn complex_vectors() {
        let coordinates = [Complex::new(0.3, 0.7), Complex::new(-1.0, 2.0)];
        let vector = from_chart(&chart(), &coordinates);
        let square: f64 = vector.iter().map(Complex::norm_sqr).sum();
        assert!((square - 1.0).abs() < 1e-15);
        let mut back = [Complex::ZERO; 2];
        to_chart(&chart(), &vector.map(|x| x * Complex::new(0.1, -2.0)), &mut back);
        assert!(back.iter().zip(&coordinates).all(|(x, y)| (x - y).norm() < 1e-14));
    }

    /// Small entries keep their digits where the vector does not go through the chart.
    #[test]
    fn vectors_have_entries_of_several_units() {
        let coordinates = [0.3, -0.7];
        let vector: [f64; 3] = from_chart(&chart(), &coordinates);
        for exponents in [[40, 37], [-900, 3], [0, 0]] {
            let mut scaled = vector;
            unscale_vector(&exponents, &mut scaled);
            assert!((scaled.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-15, "{scaled:?}");
            unscale_vector(&exponents.map(|exponent| -exponent), &mut scaled);
            assert!(scaled.iter().zip(vector).all(|(a, b)| (a - b).abs() < 1e-15), "{scaled:?} {vector:?}");
        }
        let (mut there, exponents) = (coordinates, [10, 12]);
        unscale_in_chart(&chart(), &exponents, (&mut there, &mut [0.0; 3]));
        let mut expected = vector;
        unscale_vector(&exponents, &mut expected);
        let found: [f64; 3] = from_chart(&chart(), &there);
        let sign = (found[2] * expected[2]).signum();
        assert!(found.iter().zip(expected).all(|(a, b)| (a - sign * b).abs() < 1e-15), "{found:?} {expected:?}");
    }
}
