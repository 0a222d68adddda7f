//! The reflections of a sweep of the QR iteration.

use core::ops::Range;

use crate::number::{Real, float};
use crate::size::Size;

/// The reflection I - tau w w^T, w = (1, w1, w2), that maps v to (beta, 0, 0). Returns beta, tau,
/// w1, w2.
#[inline]
pub(super) fn reflection<R: Real>(v: [R; 3]) -> (R, R, R, R) {
    let size = v[0].modulus().max(v[1].modulus()).max(v[2].modulus());
    // Squares of numbers of usual size need no scaling; tiny numbers need it.
    let scale = if size < 1e-140 && size > 0.0 { float::power_of_two(float::exponent(size).max(-1021)) } else { 1.0 };
    let inverse = 1.0 / scale;
    let [x, y, z] = if scale == 1.0 { v } else { v.map(|entry| entry.scale(inverse)) };
    let tail = y * y + z * z;
    if tail == R::ZERO {
        return (v[0], R::ZERO, R::ZERO, R::ZERO);
    }
    let beta = -(x * x + tail).sqrt().with_sign_of(x);
    let inverse = (x - beta).reciprocal();
    (beta.scale(scale), (beta - x) / beta, y * inverse, z * inverse)
}

/// tau, tau v1, tau v2, v1, v2.
pub(super) type Reflection<R> = (R, R, R, R, R);

/// Reflects three rows of the block from both sides: row `at` of it and the next two, and the three
/// columns from `columns.start` on, down to the row below them.
#[inline(always)]
pub(super) fn reflect_three<Z: Size, R: Real>(
    block: &mut [Z::Vector<R>],
    (at, columns): (usize, Range<usize>),
    (tau, t1, t2, v1, v2): Reflection<R>,
) {
    // Slices of one length: the compiler need not check each index, and takes several at once.
    if let Some([row0, row1, row2]) = block[at..].first_chunk_mut::<3>() {
        let (row0, row1) = (&mut row0.as_mut()[columns.clone()], &mut row1.as_mut()[columns.clone()]);
        let row2 = &mut row2.as_mut()[columns.clone()];
        for ((x, y), z) in row0.iter_mut().zip(row1).zip(row2) {
            let sum = *x + v1 * *y + v2 * *z;
            *x -= sum * tau;
            *y -= sum * t1;
            *z -= sum * t2;
        }
    }
    let last = block.len().min(at + 4);
    for row in &mut block[..last] {
        if let Some([x, y, z]) = row.as_mut()[columns.start..].first_chunk_mut::<3>() {
            let sum = *x + v1 * *y + v2 * *z;
            *x -= sum * tau;
            *y -= sum * t1;
            *z -= sum * t2;
        }
    }
}

/// The same for the last two rows and columns.
#[inline(always)]
pub(super) fn reflect_two<Z: Size, R: Real>(
    block: &mut [Z::Vector<R>],
    (at, columns): (usize, Range<usize>),
    (tau, t1, _, v1, _): Reflection<R>,
) {
    if let Some([row0, row1]) = block[at..].first_chunk_mut::<2>() {
        let (row0, row1) = (&mut row0.as_mut()[columns.clone()], &mut row1.as_mut()[columns.clone()]);
        for (x, y) in row0.iter_mut().zip(row1) {
            let sum = *x + v1 * *y;
            *x -= sum * tau;
            *y -= sum * t1;
        }
    }
    for row in block {
        if let Some([x, y]) = row.as_mut()[columns.start..].first_chunk_mut::<2>() {
            let sum = *x + v1 * *y;
            *x -= sum * tau;
            *y -= sum * t1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use proptest::test_runner::RngSeed;

    /// The same cases every time.
    fn config() -> ProptestConfig {
        ProptestConfig { cases: 2_000, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..Default::default() }
    }

    /// Numbers that are often 0 or 1.
    fn entry() -> impl Strategy<Value = f64> {
        prop_oneof![1 => Just(0.0), 1 => Just(1.0), 4 => -1.0..1.0_f64]
    }

    proptest! {
        #![proptest_config(config())]
        /// A reflection maps v to (beta, 0, 0), whatever its size.
        #[test]
        fn reflections_clear_all_but_the_head(v in prop::array::uniform3(entry()), exponent in -290..150_i32) {
            let unit = 10.0_f64.powi(exponent);
            let v = v.map(|x| x * unit);
            let (beta, tau, w1, w2) = reflection(v);
            let w = [1.0, w1, w2];
            let v = v.map(|x| x / unit);
            let dot: f64 = tau * v.iter().zip(w).map(|(x, y)| x * y).sum::<f64>();
            let image: [f64; 3] = core::array::from_fn(|i| v[i] - dot * w[i]);
            prop_assert!((image[0] - beta / unit).abs() + image[1].abs() + image[2].abs() <= 1e-14, "{image:?} {beta}");
            prop_assert!(w1.abs() <= 1.0 && w2.abs() <= 1.0, "the head does not cancel: {w:?}");
            prop_assert!(tau == 0.0 || (1.0..=2.0).contains(&tau), "{tau}");
        }
    }
}
