//! Our side of each case: from the data that a peer's function takes to what it returns. What
//! stands before and after the emitted solver is here, without allocation, and its time counts.

pub(crate) mod absolute_pose;
pub(crate) mod circles;
pub(crate) mod essential;
pub(crate) mod generalized;
pub(crate) mod linear;
pub(crate) mod quadrics;
pub(crate) mod relative_pose;

/// One instance in the types that the solver takes.
pub(crate) trait Instance: Sized {
    /// From flat values, as the file of instances has them.
    fn load(data: &[f64]) -> Self;
    /// Appends all solutions, one after the other, as [`crate::cases::Case::parts`] describes them.
    fn solve(&self, found: &mut Vec<f64>);
}

/// Vectors from their coordinates.
pub(crate) fn vectors<const N: usize, const COUNT: usize>(data: &[f64]) -> [[f64; N]; COUNT] {
    std::array::from_fn(|k| std::array::from_fn(|i| data[N * k + i]))
}
