//! Why a set of shifts does not solve.

use super::vanishing::Vanishing;
use super::{Dependencies, Requirements};
use crate::presolve::symmetry::Reading;
use crate::template::shift_matrix::ShiftMatrix;

/// What is missing for a solving set.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// No set of monomials is closed under the action.
    NoClosedSet,
    /// All closed sets are smaller than the number of solutions.
    TooFew {
        /// |B| of the largest closed set.
        basis: usize,
        /// The number of solutions.
        solutions: usize,
    },
    /// All closed sets that are large enough are larger than allowed.
    TooMany {
        /// |B| of the smallest of these.
        basis: usize,
        /// The largest |B| allowed.
        limit: usize,
    },
    /// All monomials of the closed sets of the right size vanish at some solution.
    Vanishing {
        /// |B| of the smallest of these closed sets.
        basis: usize,
    },
    /// An unknown cannot be read from the closed sets of the right size.
    Unreadable {
        /// Index of the unknown.
        unknown: usize,
        /// |B| of the smallest of these closed sets.
        basis: usize,
    },
}

impl Obstacle {
    /// Distance from a solving set: (kind, how much is missing). Smaller is closer.
    pub fn distance(&self) -> (usize, usize) {
        match *self {
            Self::Unreadable { basis, .. } | Self::Vanishing { basis } => (1, basis),
            Self::TooMany { basis, limit } => (2, basis.saturating_sub(limit)),
            Self::TooFew { basis, solutions } => (3, solutions.saturating_sub(basis)),
            Self::NoClosedSet => (4, 0),
        }
    }
}

impl Dependencies<'_> {
    /// What keeps the closest closed set from meeting the requirements. The answer is of use only
    /// if no set meets them.
    pub fn obstacle(&self, matrix: &ShiftMatrix, requirements: &Requirements<'_>) -> Obstacle {
        let Requirements { readings, solutions, max_basis: limit, .. } = *requirements;
        let any = Requirements { solutions: 1, max_basis: usize::MAX, ..requirements.clone() };
        let vanishing = Vanishing::new(matrix, requirements.zero_sets);
        let first = readings.first().map_or(&[][..], Vec::as_slice);
        let obstacle = |set: Vec<usize>| match set.len() {
            basis if basis < solutions => Obstacle::TooFew { basis, solutions },
            basis if basis > limit => Obstacle::TooMany { basis, limit },
            basis if vanishing.somewhere(&set) => Obstacle::Vanishing { basis },
            basis => {
                let is_unreadable = |reading: &&Reading| {
                    self.readable(matrix, &set, std::slice::from_ref(*reading), &vanishing).is_none()
                };
                // If each unknown can be read by itself, the last one fails because of columns
                // added for the others.
                let unreadable = first.iter().find(is_unreadable).or(first.last());
                Obstacle::Unreadable { unknown: unreadable.map_or(0, |reading| reading.unknown), basis }
            }
        };
        let obstacles = self.closed_sets(&any, &Vanishing::new(matrix, &[])).into_iter().map(obstacle);
        obstacles.min_by_key(Obstacle::distance).unwrap_or(Obstacle::NoClosedSet)
    }
}
