//! What a problem returns beside its unknowns.

use std::ops::Range;

use crate::expression::SymbolicPolynomial;

/// What a problem returns beside its unknowns: `Pose { rotation: r, depth: d }`.
///
/// The polynomials hold the unknowns, after them one more for each vector that is given up to
/// scale, the last coordinate of that vector, of length 1, and then the parts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Output {
    /// The name of the struct.
    pub name: String,
    /// The name in snake case, after which the functions are named that return it.
    pub function: String,
    /// Values inside of the fields that are no polynomials, or are computed once. Each may depend
    /// on those before it.
    pub parts: Vec<OutputElement>,
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
    /// Its scalars, row by row.
    pub elements: Vec<OutputElement>,
}

/// A polynomial, a quotient of two, or the square root of such.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OutputElement {
    /// The numerator.
    pub numerator: SymbolicPolynomial,
    /// The divisor, if it depends on unknowns.
    pub denominator: Option<SymbolicPolynomial>,
    /// Whether the square root of the quotient is meant.
    pub is_root: bool,
}

impl Output {
    /// All polynomials that it is computed from.
    pub fn polynomials(&self) -> impl Iterator<Item = &SymbolicPolynomial> {
        let elements = self.parts.iter().chain(self.fields.iter().flat_map(|field| &field.elements));
        elements.flat_map(|element| std::iter::once(&element.numerator).chain(&element.denominator))
    }
}
