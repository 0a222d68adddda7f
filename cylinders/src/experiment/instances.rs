//! Seeded instances, on all processors.

use rayon::prelude::*;

use super::options::Options;
use super::random::instance_seed;
use crate::progress::progress_bar;
use crate::random::Random;

/// The results of all instances, in their order.
pub(super) fn instances<T: Send>(options: &Options, runs: usize, solve: impl Fn(&mut Random) -> T + Sync) -> Vec<T> {
    seeded_instances(options, runs, |seed| solve(&mut Random::new(seed)))
}

/// Like [`instances`], for instances that make random numbers from a seed themselves. If standard
/// error is a terminal, a progress bar shows how many are done.
pub(super) fn seeded_instances<T: Send>(options: &Options, runs: usize, solve: impl Fn(u64) -> T + Sync) -> Vec<T> {
    let bar = progress_bar(runs);
    let instance = |instance: usize| {
        let result = solve(instance_seed(options.seed, instance as u64));
        bar.inc(1);
        result
    };
    let results = (0..runs).into_par_iter().map(instance).collect();
    bar.finish_and_clear();
    results
}
