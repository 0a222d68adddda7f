//! Seeds of instances, and random choices.

use crate::random::Random;

/// The seed of one instance. The generator hashes it, so that neighbouring seeds give unrelated
/// numbers. With a sum, instance 1 of seed 0 and instance 0 of seed 1 would be equal; factor and
/// rotation prevent this.
pub(super) fn instance_seed(seed: u64, instance: u64) -> u64 {
    const ODD: u64 = 0x9e37_79b9_7f4a_7c15;
    seed.wrapping_add(1).wrapping_mul(ODD).rotate_left(32) ^ instance
}

/// At most `count` different numbers below `all`, in random order (Fisher and Yates).
pub(super) fn some_of(count: usize, all: usize, random: &mut Random) -> Vec<usize> {
    let mut numbers: Vec<_> = (0..all).collect();
    for place in 0..count.min(all) {
        let other = random.uniform(place as f64, all as f64) as usize;
        numbers.swap(place, other.min(all - 1));
    }
    numbers.truncate(count);
    numbers
}
