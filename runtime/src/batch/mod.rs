//! Several instances side by side: a number of each instance in each lane of a register.
//!
//! ```text
//!   instance        0  1  2  3  4  5  6  7
//!   coefficients  [ .  .  .  .  .  .  .  . ]   all lanes take the same steps
//!   elimination   [ .  .  .  .  .  .  .  . ]   and the same pivots
//!   determinant   [ .  .  .  .  .  .  .  . ]
//!   roots         [ .  .  .  .  .  .  .  . ]   intervals of all instances share the lanes
//!   vectors       [ .  .  .  .  .  .  .  . ]   the first root of each, the second, ..
//!   polish        [ .  .  .  .  .  .  .  . ]
//! ```
//!
//! An instance whose pivots, roots or solutions need care is solved by itself. So is every instance
//! without the feature `lanes`, and on processors without AVX2, AVX-512 or NEON.

#[cfg(feature = "lanes")]
mod group;
#[cfg(feature = "lanes")]
mod hidden_pairs;
#[cfg(feature = "lanes")]
mod lanes;
#[cfg(all(test, feature = "lanes"))]
mod levels;
#[cfg(feature = "lanes")]
mod polish;
#[cfg(feature = "lanes")]
mod roots;
#[cfg(feature = "lanes")]
mod shared_pivots;
pub(crate) mod solver;

use crate::batch::solver::{BatchData, BatchSolver};

/// Solves all instances for which there is a place for the result. Without the feature `lanes`, one
/// after another.
#[inline]
pub fn solve_batch<I: BatchSolver, D: BatchData<I>>(data: &[D], results: &mut [D::Result]) {
    #[cfg(feature = "lanes")]
    if group::solve_all::<I, D>(data, results) {
        return;
    }
    for (data, result) in data.iter().zip(results) {
        *result = data.solve();
    }
}
