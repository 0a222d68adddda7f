//! Removes solutions that were found more than once.

use crate::number::Scalar;
use crate::size::{List, Size};
use crate::solution::polish::{POLISH_STEPS, largest};

/// Two solutions are the same if every unknown agrees to this relative distance (or to [`FLOOR`]).
/// After the polish, simple solutions are accurate to 1e-12 or better, double ones to about 1e-8.
/// Solutions closer than this count as one.
pub(crate) const TOLERANCE: f64 = 1e-8;

/// An unknown this small relative to the largest unknown may be rounding noise of zero. Unknowns
/// need not agree to less than this.
pub(crate) const FLOOR: f64 = 1e-13;

/// Two solutions may be one double solution if every unknown agrees to this relative distance, or
/// to [`CLOSE_FLOOR`] of the largest unknown.
pub(crate) const CLOSE: f64 = 1e-3;
/// See [`CLOSE`].
pub(crate) const CLOSE_FLOOR: f64 = 1e-6;

/// A relative residual at most this, halfway between two close solutions, shows a double solution.
/// The residual grows with the square of the distance from a double solution, and reaches this at
/// about 1e-6, relative to the unknowns.
pub(crate) const DOUBLE: f64 = 1e-12;

/// A polished solution and its relative residual.
pub struct Candidate<S: Scalar, N: Size> {
    /// The values of the unknowns.
    pub unknowns: N::Vector<S>,
    /// max over the equations of |f| / sum of |terms|.
    pub residual: f64,
}

impl<S: Scalar, N: Size> Clone for Candidate<S, N> {
    #[inline]
    fn clone(&self) -> Self {
        Self { unknowns: self.unknowns.clone(), residual: self.residual }
    }
}

impl<S: Scalar, N: Size> Candidate<S, N> {
    /// Whether both are the same solution up to [`TOLERANCE`].
    #[must_use]
    pub fn same(&self, other: &Self) -> bool {
        self.agrees(other, TOLERANCE, FLOOR)
    }

    /// Whether both may be the same double solution.
    pub(crate) fn close(&self, other: &Self) -> bool {
        self.agrees(other, CLOSE, CLOSE_FLOOR)
    }

    /// Whether every unknown agrees to this relative distance, or to `floor` times the largest one.
    #[inline]
    pub(crate) fn agrees(&self, other: &Self, tolerance: f64, floor: f64) -> bool {
        let (own, others) = (self.unknowns.as_ref(), other.unknowns.as_ref());
        let floor = floor * largest(own).max(largest(others));
        let is_near = |x: S, y: S| (x - y).magnitude() <= floor + tolerance * x.magnitude().max(y.magnitude());
        own.iter().zip(others).all(|(&x, &y)| is_near(x, y))
    }

    /// The largest distance of an unknown, relative to it plus `floor` times the largest one.
    #[inline]
    pub(crate) fn distance(&self, other: &Self, floor: f64) -> f64 {
        let (own, others) = (self.unknowns.as_ref(), other.unknowns.as_ref());
        let floor = floor * largest(own).max(largest(others));
        let part = |x: S, y: S| (x - y).magnitude() / (floor + x.magnitude().max(y.magnitude()));
        let mut distance = 0.0;
        for (&x, &y) in own.iter().zip(others) {
            // A NaN stays; unknowns that are all zero agree.
            let part = if x == y { 0.0 } else { part(x, y) };
            distance = if part <= distance { distance } else { part };
        }
        distance
    }
}

/// Adds `candidate` unless its solution is in the list already. Returns true if it was added. Of
/// two equal solutions the one with the smaller residual stays. If the list is full, one solution
/// must be spurious: the one with the largest residual goes.
///
/// A double solution is found twice, to about half of the digits, and the two may be further apart
/// than `TOLERANCE`. They count as one if the residual halfway between them is at most `DOUBLE`
/// or not larger than theirs. `polish(x, steps)` improves a point and returns its relative
/// residual.
#[inline]
pub fn push_distinct<S: Scalar, N: Size>(
    found: &mut impl List<Candidate<S, N>>,
    candidate: Candidate<S, N>,
    polish: impl Fn(&mut N::Vector<S>, usize) -> f64,
) -> bool {
    !is_among(found, &candidate, &polish) && (found.push(candidate.clone()) || replace_worst(found, candidate))
}

/// A reference to the polish, so that comparisons are compiled once for all problems with the same
/// number of unknowns.
type Polish<'a, S, N> = &'a dyn Fn(&mut <N as Size>::Vector<S>, usize) -> f64;

/// Whether a candidate is one of the solutions. If so, that solution is improved by it.
#[inline(never)]
fn is_among<S: Scalar, N: Size>(
    found: &mut [Candidate<S, N>],
    candidate: &Candidate<S, N>,
    polish: Polish<'_, S, N>,
) -> bool {
    for known in found {
        if known.close(candidate) && merge(known, candidate, polish) {
            return true;
        }
    }
    false
}

/// Puts `candidate` in place of the solution with the largest residual. Returns false if the
/// candidate's residual is not smaller.
#[cold]
#[inline(never)]
fn replace_worst<S: Scalar, N: Size>(found: &mut [Candidate<S, N>], candidate: Candidate<S, N>) -> bool {
    let mut worst: Option<&mut Candidate<S, N>> = None;
    for known in found {
        if worst.as_ref().is_none_or(|worst| worst.residual <= known.residual) {
            worst = Some(known);
        }
    }
    match worst {
        Some(worst) if candidate.residual < worst.residual => {
            *worst = candidate;
            true
        }
        _ => false,
    }
}

/// Merges two close solutions into one. Returns false if they are two.
#[cold]
#[inline(never)]
fn merge<S: Scalar, N: Size>(
    known: &mut Candidate<S, N>,
    candidate: &Candidate<S, N>,
    polish: Polish<'_, S, N>,
) -> bool {
    let better = if candidate.residual < known.residual { candidate.clone() } else { known.clone() };
    if known.same(candidate) {
        *known = better;
        return true;
    }
    let mut halfway = known.unknowns.clone();
    for (middle, &other) in halfway.as_mut().iter_mut().zip(candidate.unknowns.as_ref()) {
        *middle = (*middle + other).scale(0.5);
    }
    let double = polish(&mut halfway, 0) <= DOUBLE.max(known.residual).max(candidate.residual);
    if double {
        let residual = polish(&mut halfway, POLISH_STEPS);
        *known = if residual < better.residual { Candidate { unknowns: halfway, residual } } else { better };
    }
    double
}
