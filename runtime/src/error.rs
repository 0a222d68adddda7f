//! Why a solve returned nothing.

use core::fmt;

/// Why a solve returned nothing. An empty list of solutions is not an error: it means that the data
/// have no (real) solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SolveError {
    /// The data hold an infinite value or a NaN.
    NonFiniteInput,
    /// The elimination found no usable pivot in a column: the data are degenerate for this
    /// template.
    Degenerate {
        /// The diagonal block of the template that lost rank, counted from zero in the order of
        /// elimination.
        block: usize,
    },
    /// A matrix that is computed from the data, and from which other data are derived before the
    /// solve, has lost rank: some data depend on others, such as two equal points.
    LostRank,
    /// A number computed from finite data is not finite: a coefficient divides by zero, or a value
    /// exceeds the range of `f64`. Data in other units may help.
    Overflow,
    /// The problem needs larger arrays than are reserved: a second attempt has room for 256 basis
    /// monomials.
    TooLarge,
    /// The eigenvalue iteration reached its limit.
    NoConvergence,
}

impl fmt::Display for SolveError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SolveError::NonFiniteInput => write!(formatter, "the data hold an infinite value or a NaN"),
            SolveError::Degenerate { block } => {
                write!(formatter, "degenerate data: diagonal block {block} of the template lost rank")
            }
            SolveError::LostRank => {
                write!(formatter, "degenerate data: a matrix from which data are derived has lost rank")
            }
            SolveError::Overflow => {
                write!(formatter, "a number computed from the data is not finite: a division by zero or an overflow")
            }
            SolveError::TooLarge => write!(formatter, "the problem needs larger arrays than are set aside"),
            SolveError::NoConvergence => write!(formatter, "the eigenvalue iteration reached its limit"),
        }
    }
}

impl core::error::Error for SolveError {}
