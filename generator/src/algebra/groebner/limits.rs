//! Bounds on the work of Gröbner bases, and the errors where one is reached.

use crate::algebra::MAX_UNKNOWNS;

/// Bounds on the work of a Gröbner basis and what is derived from it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Limits {
    /// The total degree of a critical pair.
    pub max_degree: i32,
    /// Critical pairs waiting at one time.
    pub max_pairs: usize,
    /// Nonzero entries of one F4 matrix before elimination.
    pub max_matrix_entries: usize,
    /// The number of F4 matrices.
    pub max_rounds: usize,
    /// The dimension of a quotient ring: the number of solutions.
    pub max_quotient_dimension: usize,
}

impl Default for Limits {
    /// Enough for minimal problems with a few hundred solutions.
    fn default() -> Self {
        Self {
            max_degree: 60,
            max_pairs: 200_000,
            max_matrix_entries: 20_000_000,
            max_rounds: 5_000,
            max_quotient_dimension: 2_000,
        }
    }
}

/// Why a Gröbner basis, normal form or quotient ring cannot be computed.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum GroebnerError {
    /// A bound of [`Limits`] was reached.
    #[error("the Gröbner basis needs more than the limit of {limit} {what}")]
    LimitReached {
        /// The quantity that is bounded.
        what: &'static str,
        /// The bound.
        limit: usize,
    },
    /// An exponent is negative, or left the range of [`crate::algebra::Monomial`].
    #[error("an exponent is negative or larger than 127")]
    ExponentOutOfRange,
    /// The ideal has infinitely many solutions over the algebraic closure.
    #[error("the solutions form a set of dimension {dimension}")]
    NotZeroDimensional {
        /// The dimension of the solution set.
        dimension: usize,
    },
    /// The extra unknowns of a saturation do not fit beside those of the problem.
    #[error("{needed} unknowns are needed, more than the limit of {limit}", limit = MAX_UNKNOWNS)]
    TooManyUnknowns {
        /// Unknowns of the problem and extra ones.
        needed: usize,
    },
}
