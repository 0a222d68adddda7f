//! What a solver returns beside the unknowns, as it is computed.

use super::program::{Program, ValueId};

/// What a solver returns beside the unknowns, from data and a solution in two steps:
///
/// ```text
///   data --[ program ]--> coefficients --+--[ of_solution ]--> scalars of all fields
///                                        |
///   coordinates of a solution -----------+
/// ```
///
/// The coordinates are the unknowns, and of each vector that is given up to scale its last one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlannedOutput {
    /// The name of the struct.
    pub name: String,
    /// The function after which the functions are named that return it.
    pub function: String,
    /// Its fields.
    pub fields: Vec<PlannedField>,
    /// From the data to the coefficients, once for all solutions.
    pub program: Program,
    /// The value of each coefficient.
    pub coefficients: Vec<ValueId>,
    /// From the coefficients and, after them, the coordinates of a solution to the scalars.
    pub of_solution: Program,
    /// The value of each scalar, one field after another, row by row.
    pub scalars: Vec<ValueId>,
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
}

impl PlannedField {
    /// The number of its scalars.
    pub fn scalars(&self) -> usize {
        self.shape.iter().product()
    }
}
