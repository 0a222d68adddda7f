//! A polynomial problem: unknowns, data with their variety, equations with coefficients in the
//! data.

pub mod chart;
mod complex;
mod condition;
pub mod data;
mod derived;
pub mod diagnostic;
mod division;
pub mod draw;
mod evaluate;
mod functions;
pub mod instance;
mod interpret;
mod measurement;
mod names;
pub mod output;
mod parse;
mod projective;
mod results;
mod scaling;
pub mod scene;
mod scene_function;
mod scope;
mod signature;
mod slices;
mod syntax;
mod unknown_shapes;
mod value;

use std::ops::Range;

use data::element_names;
use output::Output;
use scene::Scene;

pub(crate) use data::element_name;
pub use data::{DataAttribute, DataParameter, MeanOf};

use crate::algebra::{Monomial, Polynomial};
use crate::expression::{ExpressionGraph, ExpressionId, SymbolicPolynomial};

/// A problem file as it was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SourceFile {
    /// The path to show in messages.
    pub path: String,
    /// The whole text.
    pub text: String,
}

/// A range of bytes of a [`SourceFile`].
pub type Span = Range<usize>;

/// What one measurement gives, of which data are the mean.
#[derive(Clone, Debug)]
pub struct Measurement {
    /// The name of the function that says it.
    pub name: String,
    /// Its doc comment, a line each.
    pub docs: Vec<String>,
    /// A measurement: its parameters.
    pub data: Vec<DataParameter>,
    /// The shape of the mean.
    pub shape: Vec<usize>,
    /// The expressions in the measurement.
    pub graph: ExpressionGraph,
    /// What it gives, row by row.
    pub elements: Vec<ExpressionId>,
}

/// A name of the return type, which is a field of the solution: an unknown, or an array of
/// unknowns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SolutionField {
    /// Its name.
    pub name: String,
    /// Outermost dimension first; empty for a scalar. The last one of complex numbers is 2.
    pub shape: Vec<usize>,
    /// `Complex<f64>`: real parts, each with its imaginary part behind it.
    pub is_complex: bool,
    /// `#[projective]`: a vector that is given up to scale. One of its coordinates in a chart is 1,
    /// the others are unknowns.
    pub is_projective: bool,
    /// Index of its first unknown among all.
    pub first_unknown: usize,
    /// Where it was declared.
    pub span: Span,
}

impl SolutionField {
    /// Number of scalars.
    pub fn scalars(&self) -> usize {
        self.shape.iter().product()
    }

    /// Indices of its unknowns among all, row by row: its scalars, or all coordinates but the last.
    pub fn unknowns(&self) -> Range<usize> {
        self.first_unknown..self.first_unknown + self.scalars() - usize::from(self.is_projective)
    }

    /// The orthogonal matrix that takes the coordinates in the chart, the last of which is 1, to
    /// the vector, up to scale. It is its own inverse.
    pub fn chart(&self) -> Option<Vec<Vec<f64>>> {
        self.is_projective.then(|| chart::chart(self.scalars()))
    }

    /// By how much larger the chart of the equations is than the orthogonal one, inverted: there,
    /// denominators are powers of two.
    pub fn scale_of_chart(&self) -> f64 {
        let (_, denominator) = chart::entry(self.scalars(), 0, 0);
        denominator.cast_unsigned().next_power_of_two() as f64 / denominator as f64
    }

    /// The scalars as a problem file names them.
    pub fn names(&self) -> Vec<String> {
        element_names(&self.name, &self.shape, self.is_complex)
    }
}

/// A direction of scalings: the weights of all data, and of all unknowns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scaling {
    /// One weight per scalar of the data.
    pub data: Vec<i8>,
    /// One weight per unknown. Those of a vector that is given up to scale are the weights of its
    /// elements but the last, whose weight is 0.
    pub unknowns: Vec<i8>,
}

/// A polynomial stated in the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Statement {
    /// `left - right` of an equation, or the factor that must not vanish.
    pub polynomial: SymbolicPolynomial,
    /// Where it was stated.
    pub span: Span,
    /// Element of an element-wise statement, such as `[1][2]`; empty for a scalar one.
    pub element: String,
}

/// A polynomial problem, names resolved and shapes checked.
#[derive(Clone, Debug)]
pub struct Problem {
    /// Name of the function, which is the name of the solver.
    pub name: String,
    /// Doc comment, a line each, without the leading `///`.
    pub docs: Vec<String>,
    /// The data.
    pub data: Vec<DataParameter>,
    /// What measurements give, of which data are means.
    pub measurements: Vec<Measurement>,
    /// Names of the unknowns, elements of arrays one by one: `x`, `v[0]`, `v[1]`. Monomials index
    /// into this. Coordinates of a vector that is given up to scale have the names of its elements,
    /// without the last.
    pub unknowns: Vec<String>,
    /// What the solver returns: the unknowns with their shapes, and vectors given up to scale.
    pub fields: Vec<SolutionField>,
    /// Each polynomial is 0 at a solution.
    pub equations: Vec<Statement>,
    /// No polynomial is 0 at a solution (`!= 0`).
    pub nonzero: Vec<Statement>,
    /// Each polynomial is positive at a solution that `solve` returns (`>`, `<`).
    pub positive: Vec<Statement>,
    /// What it returns beside the unknowns.
    pub output: Option<Output>,
    /// How data come about that users have.
    pub scene: Option<Scene>,
    /// A basis of the scalings under which it stays the same: its units.
    pub scalings: Vec<Scaling>,
    /// The coefficients of all polynomials.
    pub graph: ExpressionGraph,
    /// The file it came from.
    pub source: SourceFile,
    /// Where the unknowns stand, for messages about the whole problem.
    pub span: Span,
}

impl Problem {
    /// Number of scalars in all data that are given.
    pub fn input_count(&self) -> usize {
        self.data.iter().map(DataParameter::len).sum()
    }

    /// The polynomials of the equations.
    pub fn polynomials(&self) -> impl ExactSizeIterator<Item = &Polynomial<ExpressionId>> {
        self.equations.iter().map(|equation| &equation.polynomial)
    }

    /// Whether all equations, and no factor that must not, vanish where all unknowns are 0.
    pub fn has_origin(&self) -> bool {
        let vanishes = |p: &SymbolicPolynomial| !p.monomials().any(|m| m == Monomial::ONE);
        self.polynomials().all(vanishes) && !self.nonzero.iter().any(|factor| vanishes(&factor.polynomial))
    }

    /// A hash (FNV-1a, 64 bit) of what the problem states: names, shapes, equations by value.
    /// Comments and the way an equation is written do not matter.
    pub fn fingerprint(&self) -> u64 {
        let mut words = vec![self.name.clone(), self.unknowns.join(",")];
        words.extend(self.data.iter().map(|d| format!("{}:{:?}:{:?}", d.name, d.shape, d.attribute)));
        for (kind, statements) in [("= 0", &self.equations), ("!= 0", &self.nonzero)] {
            for statement in statements {
                let term = |&(m, c): &(_, _)| format!("{m:?}{:?}", self.graph.fingerprint(c));
                let terms: Vec<String> = statement.polynomial.terms().iter().map(term).collect();
                words.push(format!("{} {kind}", terms.join(" ")));
            }
        }
        words
            .iter()
            .flat_map(|word| word.bytes().chain([b'\n']))
            .fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3))
    }
}
