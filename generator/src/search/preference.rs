//! What is preferred among templates that solve well, and the order in which candidates are
//! considered.

/// What a search looks for first.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "command", derive(clap::ValueEnum, serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "command", serde(rename_all = "lowercase"))]
pub enum Preference {
    /// Least predicted time of a solve
    #[default]
    Speed,
    /// Fewest missed solutions, then smallest residuals, at a bounded cost
    Stability,
    /// Fewest rows, whatever they cost
    Size,
}

/// A solver that solves equations for monomials at run time must be faster by this factor: it is
/// not computed side by side with others, and takes a second attempt where that system is singular.
pub(super) const BURDEN_OF_PRESOLVE: f64 = 1.25;

/// The cost of a candidate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cost {
    /// Predicted nanoseconds of a solve without a second attempt: [`crate::plan::time`].
    pub nanoseconds: usize,
    /// Predicted nanoseconds of a second attempt.
    pub second_attempt: usize,
    /// Operations of one solve, by which the work of measuring it is bounded.
    pub operations: usize,
    /// Rows of the template.
    pub rows: usize,
    /// |B|.
    pub basis: usize,
}

impl Preference {
    /// The key by which candidates are ordered, least first. Stability does not follow from cost
    /// and is measured: cheap candidates are measured first.
    pub fn key(self, cost: &Cost) -> [usize; 3] {
        match self {
            Self::Speed | Self::Stability => [cost.nanoseconds, cost.rows, cost.basis],
            Self::Size => [cost.rows, cost.basis, cost.operations],
        }
    }
}

impl std::fmt::Display for Preference {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Speed => "speed",
            Self::Stability => "stability",
            Self::Size => "size",
        })
    }
}
