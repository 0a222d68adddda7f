//! Drops solutions that were found more than once.

use crate::scalar::Scalar;
use crate::solutions::Solutions;

/// Two solutions are the same when every unknown agrees to this relative distance (or to [`FLOOR`]). Simple solutions
/// are found to 1e-12 or better after polish, double ones to about 1e-8; solutions closer than this are taken for one.
pub const TOLERANCE: f64 = 1e-8;

/// An unknown this small relative to the largest one may be the rounding noise of zero: it is not compared to be
/// closer.
pub const FLOOR: f64 = 1e-13;

/// A polished solution and its relative residual.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate<S, const N: usize> {
    /// The values of the unknowns.
    pub unknowns: [S; N],
    /// max over the equations of |f| / sum of |terms|.
    pub residual: f64,
}

impl<S: Scalar, const N: usize> Candidate<S, N> {
    /// Whether both are the same solution up to [`TOLERANCE`].
    #[must_use]
    pub fn same(&self, other: &Self) -> bool {
        let largest = |x: &[S; N]| x.iter().map(|value| value.magnitude()).fold(0.0, f64::max);
        let floor = FLOOR * largest(&self.unknowns).max(largest(&other.unknowns));
        self.unknowns
            .iter()
            .zip(&other.unknowns)
            .all(|(&x, &y)| (x - y).magnitude() <= floor + TOLERANCE * x.magnitude().max(y.magnitude()))
    }
}

/// Adds `candidate` unless its solution is there already; of two that are the same the one with the smaller residual
/// stays. False when it was new and the list is full.
#[inline]
pub fn push_distinct<S: Scalar, const N: usize, const MAX: usize>(
    found: &mut Solutions<Candidate<S, N>, MAX>,
    candidate: Candidate<S, N>,
) -> bool {
    match found.iter_mut().find(|known| known.same(&candidate)) {
        Some(known) => {
            if candidate.residual < known.residual {
                *known = candidate;
            }
            true
        }
        None => found.push(candidate),
    }
}
