//! What a problem returns beside its unknowns.

use std::ops::Range;

use crate::expression::ExpressionId;

/// What a problem returns beside its unknowns: `Pose { rotation: r, depth: d }`.
///
/// Its values depend on data and on coordinates of a solution: the unknowns, and after them one
/// more for each vector that is given up to scale, the last coordinate of that vector, of length 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Output {
    /// The name of the struct.
    pub name: String,
    /// The name in snake case, after which the functions are named that return it.
    pub function: String,
    /// Its fields.
    pub fields: Vec<OutputField>,
    /// Where it stands.
    pub span: Range<usize>,
}

/// A field of an output.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OutputField {
    /// Its name.
    pub name: String,
    /// Outermost dimension first; empty for a scalar. The last one of complex numbers is 2.
    pub shape: Vec<usize>,
    /// Whether it is complex: real parts, each with its imaginary part behind it.
    pub is_complex: bool,
    /// `#[projective]`: any multiple says the same.
    pub is_projective: bool,
    /// Its scalars, row by row, in the graph of the problem.
    pub elements: Vec<ExpressionId>,
}

impl Output {
    /// The scalars of all fields, one field after another.
    pub fn elements(&self) -> impl Iterator<Item = ExpressionId> + '_ {
        self.fields.iter().flat_map(|field| field.elements.iter().copied())
    }
}
