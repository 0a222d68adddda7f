//! How far a problem is presolved, and the result.

use crate::expression::SymbolicPolynomial;
use crate::problem::Problem;

/// How far to presolve.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Presolve {
    /// Keep every unknown.
    None,
    /// Eliminate an unknown if its coefficient is a constant.
    Constant,
    /// Eliminate an unknown if its coefficient depends on data only.
    Linear,
    /// As [`Presolve::Linear`]. Then all other equations are divided by those that give the square
    /// of an unknown: the unknowns are kept, and these equations go.
    Square,
    /// As [`Presolve::Constant`], after constant multiples of equations are subtracted from others
    /// with the same highest term.
    Combined,
    /// As [`Presolve::Linear`], after the same subtractions.
    CombinedLinear,
    /// As [`Presolve::Square`], after the same subtractions.
    CombinedSquare,
}

impl Presolve {
    /// All with their names, in the order in which a search tries them.
    pub const ALL: [(&'static str, Self); 7] = [
        ("none", Self::None),
        ("constant", Self::Constant),
        ("linear", Self::Linear),
        ("square", Self::Square),
        ("combined", Self::Combined),
        ("combined_linear", Self::CombinedLinear),
        ("combined_square", Self::CombinedSquare),
    ];

    /// Its name in template files and reports.
    pub fn name(self) -> &'static str {
        Self::ALL.into_iter().find(|(_, presolve)| *presolve == self).map_or("", |(name, _)| name)
    }

    /// Whether equations are combined first.
    pub(crate) fn combines(self) -> bool {
        matches!(self, Self::Combined | Self::CombinedLinear | Self::CombinedSquare)
    }

    /// Whether other equations are divided by those that give squares.
    pub(super) fn divides(self) -> bool {
        matches!(self, Self::Square | Self::CombinedSquare)
    }

    /// Whether an unknown is eliminated only if its coefficient is a constant.
    pub(super) fn is_constant(self) -> bool {
        matches!(self, Self::Constant | Self::Combined)
    }
}

/// `unknown = value`, where `value` holds unknowns that are kept or recovered earlier.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Recovery {
    /// Index of the unknown that was eliminated.
    pub unknown: usize,
    /// Its value.
    pub value: SymbolicPolynomial,
}

/// A problem with some unknowns substituted away. Monomials keep the indices of the original
/// unknowns.
#[derive(Clone, Debug)]
pub struct ReducedProblem {
    /// The problem with the remaining equations; `unknowns` still lists all of them.
    pub problem: Problem,
    /// Indices of the unknowns that are left, in increasing order.
    pub kept: Vec<usize>,
    /// The values of the eliminated unknowns, each in terms of kept ones and of those before it.
    pub recoveries: Vec<Recovery>,
}

/// No substitution may make an equation longer than this.
pub(super) const MAX_TERMS: usize = 2_000;
