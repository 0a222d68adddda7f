//! Sums whose terms do not wait for each other.

use crate::number::Scalar;

/// The sum of `count` terms.
#[inline(always)]
pub(crate) fn sum_of<T: Copy + core::ops::Add<Output = T>>(count: usize, zero: T, term: impl Fn(usize) -> T) -> T {
    folded(count, zero, term, |a, b| a + b)
}

/// The sum of the products of `count` pairs.
#[inline(always)]
pub(crate) fn dot_of<S: Scalar>(count: usize, pair: impl Fn(usize) -> (S, S)) -> S {
    let mut parts = [S::ZERO; 4];
    let whole = count / 4 * 4;
    for first in (0..whole).step_by(4) {
        for (lane, part) in parts.iter_mut().enumerate() {
            let (a, b) = pair(first + lane);
            *part = part.plus_product(a, b);
        }
    }
    for (part, at) in parts.iter_mut().zip(whole..count) {
        let (a, b) = pair(at);
        *part = part.plus_product(a, b);
    }
    (parts[0] + parts[2]) + (parts[1] + parts[3])
}

/// `count` terms joined in four parts side by side: none of them waits for the others.
#[inline(always)]
pub(crate) fn folded<T: Copy>(count: usize, start: T, term: impl Fn(usize) -> T, join: impl Fn(T, T) -> T) -> T {
    let mut parts = [start; 4];
    let whole = count / 4 * 4;
    for first in (0..whole).step_by(4) {
        for (lane, part) in parts.iter_mut().enumerate() {
            *part = join(*part, term(first + lane));
        }
    }
    for (part, at) in parts.iter_mut().zip(whole..count) {
        *part = join(*part, term(at));
    }
    join(join(parts[0], parts[2]), join(parts[1], parts[3]))
}
