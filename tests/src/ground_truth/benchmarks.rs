//! Benchmark systems without data.

use super::{KnownInstance, Make, Maker, relative_error};

pub(super) fn makers() -> Vec<Maker> {
    vec![Maker {
        name: "katsura_5",
        // The only rational solution: v is 1, all others vanish.
        make: Make::Scene(|_| KnownInstance { data: vec![], truths: vec![vec![0.0, 0.0, 1.0, 0.0, 0.0, 0.0]] }),
        error: |_, solution, truth| relative_error(solution, truth),
    }]
}
