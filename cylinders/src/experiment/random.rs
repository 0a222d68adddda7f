//! Seeds of instances, and random choices.

use crate::random::Random;

/// The seed of one instance. The generator hashes it, so that neighbours have nothing in common;
/// factor and rotation keep apart what sums would make equal, such as instance 1 of seed 0 and
/// instance 0 of seed 1.
pub(super) fn instance_seed(seed: u64, instance: u64) -> u64 {
    const ODD: u64 = 0x9e37_79b9_7f4a_7c15;
    seed.wrapping_add(1).wrapping_mul(ODD).rotate_left(32) ^ instance
}

/// So many different numbers below `all`, at most all of them, in random order (Fisher and Yates).
pub(super) fn some_of(count: usize, all: usize, random: &mut Random) -> Vec<usize> {
    let mut numbers: Vec<_> = (0..all).collect();
    for place in 0..count.min(all) {
        let other = random.uniform(place as f64, all as f64) as usize;
        numbers.swap(place, other.min(all - 1));
    }
    numbers.truncate(count);
    numbers
}
