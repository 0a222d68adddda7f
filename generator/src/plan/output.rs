//! What a solver returns beside the unknowns, as it is computed.

use super::program::{Program, ValueId};
use super::term::Term;

/// What a solver returns beside the unknowns. Its terms have an exponent for each unknown, and for
/// the last coordinate of each vector that is given up to scale, and for each part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlannedOutput {
    /// The name of the struct.
    pub name: String,
    /// The name after which the functions are named that return it.
    pub function: String,
    /// Values that the terms hold after the unknowns, each computed from those before it.
    pub parts: Vec<PlannedElement>,
    /// Its fields.
    pub fields: Vec<PlannedField>,
    /// From the data to the coefficients of its terms, which are its own.
    pub program: Program,
    /// The value of each coefficient.
    pub coefficients: Vec<ValueId>,
}

/// A field of an output.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlannedField {
    /// Its name.
    pub name: String,
    /// Outermost dimension first; empty for a scalar. The last one of complex numbers is 2.
    pub shape: Vec<usize>,
    /// Whether it is complex: real parts, each with its imaginary part behind it.
    pub is_complex: bool,
    /// Whether any multiple says the same.
    pub is_projective: bool,
    /// Its scalars, row by row.
    pub elements: Vec<PlannedElement>,
}

/// A scalar of an output.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlannedElement {
    /// The numerator.
    pub numerator: Vec<Term>,
    /// The divisor, if there is one.
    pub denominator: Option<Vec<Term>>,
    /// Whether the square root of the quotient is meant.
    pub is_root: bool,
}
