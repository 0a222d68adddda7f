//! How far a problem is presolved, and the result.

use super::exchange::Pair;
use super::symmetry::Symmetry;
use crate::algebra::MAX_UNKNOWNS;
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
    /// As [`Presolve::CombinedLinear`], after the linear equations are solved together at run time,
    /// with pivots: unknowns are eliminated by them first.
    Eliminated,
    /// As [`Presolve::Constant`]. Then a linear form of the unknowns, whose values tell all
    /// solutions apart, takes the place of one of them.
    Separated,
    /// Half the sum and half the difference take the place of unknowns that can be exchanged. Then
    /// as [`Presolve::Constant`].
    Paired,
    /// As [`Presolve::Eliminated`]. Then the equations are solved for their highest monomials at
    /// run time.
    Solved,
    /// As [`Presolve::Solved`], for the monomials that are highest beside this unknown.
    Hiding(u8),
    /// As [`Presolve::Constant`]. Then the unknowns that occur linearly together with this one are
    /// eliminated by determinants, and the others are divided as by [`Presolve::Square`].
    Determinants(u8),
}

impl Presolve {
    /// Those that are the same for all problems, with their names.
    const FIXED: [(&'static str, Self); 11] = [
        ("none", Self::None),
        ("constant", Self::Constant),
        ("linear", Self::Linear),
        ("square", Self::Square),
        ("combined", Self::Combined),
        ("combined_linear", Self::CombinedLinear),
        ("combined_square", Self::CombinedSquare),
        ("separated", Self::Separated),
        ("paired", Self::Paired),
        ("eliminated", Self::Eliminated),
        ("solved", Self::Solved),
    ];

    /// All for so many unknowns, in the order in which a search tries them.
    pub fn all(unknowns: usize) -> Vec<Self> {
        let each = || 0..unknowns.min(MAX_UNKNOWNS) as u8;
        let of_unknowns = each().map(Self::Hiding).chain(each().map(Self::Determinants));
        Self::FIXED.into_iter().map(|(_, presolve)| presolve).chain(of_unknowns).collect()
    }

    /// Its name in template files and reports.
    pub fn name(self) -> String {
        match self {
            Self::Hiding(unknown) => format!("hiding_{unknown}"),
            Self::Determinants(unknown) => format!("determinants_{unknown}"),
            _ => Self::FIXED.into_iter().find(|(_, known)| *known == self).map_or("", |(name, _)| name).to_owned(),
        }
    }

    /// Whether equations are solved at run time.
    pub(crate) fn solves_at_run_time(self) -> bool {
        matches!(self, Self::Eliminated | Self::Solved | Self::Hiding(_))
    }

    /// The unknown that is hidden when equations are solved for monomials; `None` if they are not.
    pub(super) fn solves_for_leads(self) -> Option<Option<usize>> {
        match self {
            Self::Solved => Some(None),
            Self::Hiding(unknown) => Some(Some(usize::from(unknown))),
            _ => None,
        }
    }

    /// Whether equations are combined first.
    pub(crate) fn combines(self) -> bool {
        let is_symbolic = matches!(self, Self::Combined | Self::CombinedLinear | Self::CombinedSquare);
        is_symbolic || self.solves_at_run_time()
    }

    /// Whether other equations are divided by those that give squares.
    pub(super) fn divides(self) -> bool {
        matches!(self, Self::Square | Self::CombinedSquare)
    }

    /// Whether an unknown is eliminated only if its coefficient is a constant.
    pub(super) fn is_constant(self) -> bool {
        matches!(self, Self::Constant | Self::Combined | Self::Separated | Self::Paired | Self::Determinants(_))
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

/// Unknowns x that follow together, by least squares, from A x + b = 0. Entries hold unknowns that
/// are kept.
///
/// ```text
///           x_1  ..  x_n   1
///   rows  [                     ]
///         [      A         b    ]      n rows or more
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LinearBlock {
    /// Indices of the unknowns, in increasing order.
    pub unknowns: Vec<usize>,
    /// The rows of A and b.
    pub rows: Vec<Vec<SymbolicPolynomial>>,
}

/// A problem with some unknowns substituted away. Monomials keep the indices of the original
/// unknowns.
#[derive(Clone, Debug)]
pub struct ReducedProblem {
    /// The problem with the remaining equations; `unknowns` still lists all of them.
    pub problem: Problem,
    /// Indices of the unknowns that are left, in increasing order.
    pub kept: Vec<usize>,
    /// Unknowns that were eliminated by determinants. They are recovered first.
    pub linear: Option<LinearBlock>,
    /// The values of the other eliminated unknowns, each in terms of kept ones, of those that were
    /// eliminated by determinants, and of those before it.
    pub recoveries: Vec<Recovery>,
    /// The unknown whose place a linear form takes, in equations and monomials alike. It is kept,
    /// and its own value is the first that is recovered.
    pub separated: Option<usize>,
    /// The unknowns whose places half their sum and half their difference take, in equations and
    /// monomials alike. Their own values are recovered last.
    pub pairs: Vec<Pair>,
    /// The changes of sign of all unknowns, or of what has their places.
    pub symmetry: Symmetry,
    /// Whether equations were solved for monomials at run time: their coefficients there are 1.
    pub is_solved_for_leads: bool,
}

impl ReducedProblem {
    /// The unknowns that were eliminated, in the order in which they are recovered.
    pub fn eliminated(&self) -> impl Iterator<Item = usize> + '_ {
        let linear = self.linear.iter().flat_map(|block| block.unknowns.iter().copied());
        // Those of pairs are recovered once more, from sums and differences.
        let count = self.recoveries.len() - 2 * self.pairs.len();
        linear.chain(self.recoveries[..count].iter().map(|recovery| recovery.unknown))
    }
}

/// No substitution may make an equation longer than this.
pub(super) const MAX_TERMS: usize = 2_000;
