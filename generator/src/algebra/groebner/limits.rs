//! Bounds on the work of Gröbner bases, and the errors where one is reached.

use std::sync::atomic::{AtomicBool, Ordering};

use crate::algebra::MAX_UNKNOWNS;

/// Bounds on the work of a Gröbner basis and what is derived from it.
#[derive(Clone, Debug)]
pub struct Limits<'a> {
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
    /// Multiples of elements of a trace that are looked at for one set of monomials.
    pub max_multiples: usize,
    /// Another thread sets this flag where the work must end before its end.
    pub is_over: Option<&'a AtomicBool>,
}

impl Limits<'_> {
    /// # Errors
    /// [`GroebnerError::Ended`] if the flag is set.
    pub(super) fn go_on(&self) -> Result<(), GroebnerError> {
        match self.is_over.is_some_and(|is_over| is_over.load(Ordering::Relaxed)) {
            true => Err(GroebnerError::Ended),
            false => Ok(()),
        }
    }
}

impl Default for Limits<'_> {
    /// Enough for minimal problems with a few hundred solutions.
    fn default() -> Self {
        Self {
            max_degree: 60,
            max_pairs: 200_000,
            max_matrix_entries: 20_000_000,
            max_rounds: 5_000,
            max_quotient_dimension: 2_000,
            max_multiples: 1_000_000,
            is_over: None,
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
    /// [`Limits::is_over`] was set.
    #[error("the work was ended before its end")]
    Ended,
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
