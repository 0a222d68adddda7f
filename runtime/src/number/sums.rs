//! Sums whose terms do not wait for each other.

/// The sum of `count` terms.
#[inline(always)]
pub(crate) fn sum_of<T: Copy + core::ops::Add<Output = T>>(count: usize, zero: T, term: impl Fn(usize) -> T) -> T {
    folded(count, zero, term, |a, b| a + b)
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
