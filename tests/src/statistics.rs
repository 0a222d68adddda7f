//! Quantiles, and sets of solutions compared up to a tolerance.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use eliminant::Complex;

/// The q-quantile of values in any order, by nearest rank; NaN where there are none, which passes
/// no comparison.
pub fn quantile(values: &mut [f64], q: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    match values.len() {
        0 => f64::NAN,
        n => values[(q * (n - 1) as f64).round() as usize],
    }
}

/// log10, with exact zeros at the rounding level, so that they count as good and not as -infinity.
pub fn log10(error: f64) -> f64 {
    error.max(1e-17).log10()
}

/// The largest of some errors, 0 where there are none; NaN counts as infinite.
pub fn worst(errors: impl IntoIterator<Item = f64>) -> f64 {
    errors.into_iter().fold(0.0, |worst, error| if error.is_nan() { f64::INFINITY } else { error.max(worst) })
}

/// The value that occurs most often; of several the smallest.
pub fn most_frequent(values: impl Iterator<Item = usize>) -> Option<usize> {
    let mut counts: BTreeMap<usize, usize> = BTreeMap::new();
    values.for_each(|value| *counts.entry(value).or_default() += 1);
    counts.into_iter().max_by_key(|&(value, count)| (count, Reverse(value))).map(|(value, _)| value)
}

/// How far two points are apart: max over the unknowns of |x - y|, relative to the larger of the
/// two points' norms.
pub fn distance(x: &[Complex<f64>], y: &[Complex<f64>]) -> f64 {
    let norm = |v: &[Complex<f64>]| v.iter().map(|z| z.norm()).fold(0.0, f64::max);
    let difference: Vec<Complex<f64>> = x.iter().zip(y).map(|(a, b)| a - b).collect();
    let scale = norm(x).max(norm(y));
    if scale == 0.0 { 0.0 } else { norm(&difference) / scale }
}

/// A real point as a complex one.
pub fn complex(point: &[f64]) -> Vec<Complex<f64>> {
    point.iter().map(|&x| Complex::new(x, 0.0)).collect()
}

/// Whether each point of either set has its own partner in the other, within `tolerance` by
/// [`distance`].
pub fn same_set(left: &[Vec<Complex<f64>>], right: &[Vec<Complex<f64>>], tolerance: f64) -> bool {
    let mut free: Vec<&Vec<Complex<f64>>> = right.iter().collect();
    left.len() == right.len()
        && left.iter().all(|x| {
            let nearest = (0..free.len()).min_by(|&i, &j| distance(x, free[i]).total_cmp(&distance(x, free[j])));
            nearest.is_some_and(|at| distance(x, free.swap_remove(at)) <= tolerance)
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_most_frequent_value_is_the_smallest_of_several() {
        assert_eq!(most_frequent([3, 2, 2, 3, 1].into_iter()), Some(2));
        assert_eq!(most_frequent([1, 3, 3].into_iter()), Some(3));
        assert_eq!(most_frequent(std::iter::empty()), None);
    }
}
