//! Why a solve returned nothing.

use core::fmt;

/// Why a solve returned nothing. An empty list of solutions is no error: the data then have no (real) solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SolveError {
    /// The data, or a matrix made from them, hold an infinity or a NaN.
    NonFiniteInput,
    /// The elimination met a column without a usable pivot: the data are degenerate for this template.
    Degenerate {
        /// The column of the eliminated block, counted from zero, where the rank was lost.
        column: usize,
    },
    /// The eigenvalue iteration reached its limit.
    NoConvergence,
}

impl fmt::Display for SolveError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SolveError::NonFiniteInput => write!(formatter, "the data hold an infinite value or a NaN"),
            SolveError::Degenerate { column } => {
                write!(formatter, "degenerate data: the elimination lost rank in column {column}")
            }
            SolveError::NoConvergence => write!(formatter, "the eigenvalue iteration reached its limit"),
        }
    }
}

impl core::error::Error for SolveError {}
