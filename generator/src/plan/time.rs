//! The time of a solve, predicted from its plan: a sum over what is done, each times the
//! nanoseconds that it took on the machine to which the model was fitted.
//!
//! ```text
//!   stage          what is counted                                       n: |B|
//!   coefficients   solves, operations in statements, steps of tables,    d: degree of the
//!                  of roots, systems and null spaces of data, terms of      determinant
//!                  the equations
//!   elimination    entries of the template, operations in small and in   c: its chains
//!                  large blocks                                          r: real solutions,
//!   solutions      n^2 and n^3 for eigenvalues, or d^2 for the roots of     about the square
//!                  a determinant; vectors, r n^2 or r c^3; terms of         root of all
//!                  the polish; operations of second attempts
//! ```
//!
//! The model is deterministic, so that a search chooses the same template on every machine. The
//! command `eliminant bench templates/*.rs --fit` fits it anew and says by how much it is wrong.

use super::program::{Program, ProgramForm};
use super::{Plan, Term};

/// A stage of a solve, as `eliminant bench` times them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// From the data to the coefficients, and one residual.
    Coefficients,
    /// Fill and elimination.
    Elimination,
    /// Roots, vectors, polish, second attempts.
    Solutions,
}

/// The stages in their order.
pub const STAGES: [Stage; 3] = [Stage::Coefficients, Stage::Elimination, Stage::Solutions];

/// What is counted in a stage, and the nanoseconds of one of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weight {
    /// The stage.
    pub stage: Stage,
    /// What is counted.
    pub what: &'static str,
    /// Nanoseconds of one.
    pub nanoseconds: f64,
}

const fn weight(stage: Stage, what: &'static str, nanoseconds: f64) -> Weight {
    Weight { stage, what, nanoseconds }
}

/// The number of weights.
pub const WEIGHTS: usize = 16;

use Stage::{Coefficients, Elimination, Solutions};

/// The model. `eliminant bench templates/*.rs --fit` prints these lines.
pub const MODEL: [Weight; WEIGHTS] = [
    weight(Coefficients, "solve", 29.116),
    weight(Coefficients, "operation in a statement", 0.058),
    weight(Coefficients, "step of a table", 0.352),
    weight(Coefficients, "operation that derives data", 0.900),
    weight(Coefficients, "term of an equation", 0.448),
    weight(Elimination, "entry of the template", 0.946),
    weight(Elimination, "operation in a small block", 0.089),
    weight(Elimination, "operation in a large block", 0.038),
    weight(Solutions, "|B|^2 for eigenvalues", 61.828),
    weight(Solutions, "|B|^3 for eigenvalues", 0.451),
    weight(Solutions, "|B|^2 for eigenvectors", 0.703),
    weight(Solutions, "degree^2 for the roots of a determinant", 13.245),
    weight(Solutions, "chains^3 for its null vectors", 1.773),
    weight(Solutions, "root", 16.059),
    weight(Solutions, "term of the polish", 0.367),
    weight(Solutions, "operation of second attempts", 1.857),
];

/// How often each of it is done in a solve of which the portion `repeated` of all instances takes a
/// second attempt.
pub fn counts(plan: &Plan, repeated: f64) -> [f64; WEIGHTS] {
    let operations = plan.operations();
    let derived = plan.derived.iter().filter(|derived| !derived.is_for_results);
    let programs = std::iter::once(&plan.program).chain(derived.clone().map(|derived| &derived.program));
    let of_form =
        |form| programs.clone().filter(|program| program.form == form).map(Program::steps).sum::<usize>() as f64;
    let derived: usize = derived.map(|derived| derived.derivation.kind.operations()).sum();
    let terms: usize = plan.equations.iter().flatten().map(Term::factors).sum();
    let e = &plan.elimination;
    let entries =
        e.right.len() + e.blocks.iter().map(|block| block.diagonal.len() + block.coupling.len()).sum::<usize>();
    let in_blocks = |is_large: bool| {
        let blocks = e.blocks.iter().filter(|block| block.is_large() == is_large);
        blocks.map(|block| block.operations(e.basis)).sum::<usize>() as f64
    };
    let (n, real) = (e.basis as f64, (plan.solutions as f64).sqrt());
    let by_eigenvalues = if plan.chains.is_some() { 0.0 } else { 1.0 };
    // Where some eigenpairs belong to no solution, all are computed: a complex one counts as two.
    let pairs = if plan.has_spurious_values() { 2.0 * n } else { real };
    let [degree, chains] = plan
        .chains
        .as_ref()
        .map_or([0.0; 2], |chains| [chains.degrees().iter().sum::<usize>() as f64, chains.lengths.len() as f64]);
    [
        1.0,
        of_form(ProgramForm::Statements),
        of_form(ProgramForm::Table),
        derived as f64,
        terms as f64,
        entries as f64,
        in_blocks(false),
        in_blocks(true),
        by_eigenvalues * n.powi(2),
        by_eigenvalues * n.powi(3),
        by_eigenvalues * pairs * n.powi(2),
        degree.powi(2),
        real * chains.powi(3),
        real,
        if plan.has_spurious_values() { pairs } else { real } * terms as f64,
        repeated * (operations.elimination + operations.roots) as f64,
    ]
}

/// Nanoseconds that a model predicts for each stage.
pub fn predicted(model: &[Weight; WEIGHTS], counts: &[f64; WEIGHTS]) -> [f64; STAGES.len()] {
    STAGES.map(|stage| {
        let of_stage = model.iter().zip(counts).filter(|(weight, _)| weight.stage == stage);
        of_stage.map(|(weight, count)| weight.nanoseconds * count).sum()
    })
}

impl Plan {
    /// The predicted nanoseconds of a solve of which the portion `repeated` of all instances takes
    /// a second attempt.
    pub fn predicted_nanoseconds(&self, repeated: f64) -> f64 {
        predicted(&MODEL, &counts(self, repeated)).iter().sum()
    }
}

impl Term {
    /// The factors of the term, its coefficient among them.
    fn factors(&self) -> usize {
        1 + self.exponents.iter().map(|&e| usize::from(e)).sum::<usize>()
    }
}
