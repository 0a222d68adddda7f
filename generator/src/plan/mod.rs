//! What an emitted solver does, with no algebra left: the last form before printing.
//!
//! ```text
//! data --program--> coefficients --fill, eliminate--> action matrix T --roots--> eigenpairs (a, v)
//!                        |                                                              |
//!                        |                                                           extract
//!                        v                                                              v
//!            polish on all equations <----- recover eliminated unknowns <------- kept unknowns
//! ```
//!
//! Every decision is taken here. [`crate::emit`] prints a plan and [`crate::plan::interpret`]
//! executes it, and the two must agree.

mod block_triangular;
pub mod chains;
mod check;
mod coefficients;
mod constant_pivots;
pub mod interpret;
mod memory;
pub mod output;
pub mod picture;
pub mod program;
pub mod program_table;
mod residues;
pub mod schedule;
pub mod solution_count;
pub mod statements;
pub(crate) mod straight_line;
pub mod system_table;
mod term;
pub mod time;
pub mod value_layout;
mod zeros;

pub use check::PlanError;
pub use term::{CoefficientId, Term};

use std::collections::BTreeSet;

use crate::expression::derivation::Derivation;
use crate::presolve::exchange::Image;
use crate::problem::scene::Scene;
use crate::problem::{DataParameter, Scaling, SolutionField};
use crate::template::RootMethod;
use output::PlannedOutput;
use program::{Operation, Program, ProgramForm, ValueId};

/// Position among the eliminated monomials (excess and reducible) in the order of solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PivotId(pub u16);

/// Position in the basis B.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BasisId(pub u16);

/// An entry of a table that is filled from the coefficients.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Row, counted as the table says.
    pub row: u16,
    /// Column, counted as the table says.
    pub column: u16,
    /// The value of the entry.
    pub coefficient: CoefficientId,
}

/// One diagonal block of the block-triangular template.
///
/// ```text
///                    pivots solved before   pivots first..first+size    basis
/// row first + i   [        coupling       |      diagonal            |  right  ]
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    /// First row and pivot.
    pub first: usize,
    /// Number of rows and pivots.
    pub size: usize,
    /// How many of its last pivots are read by later blocks, by the action matrix or for an
    /// unknown. The others only serve the elimination.
    pub needed: usize,
    /// Entries of the square block; rows and columns count from `first`.
    pub diagonal: Vec<Entry>,
    /// Entries at pivots solved before; rows count from `first`, columns are absolute pivots.
    pub coupling: Vec<Entry>,
}

/// The elimination: rows and pivot columns of the template, permuted to block-triangular form.
///
/// ```text
///               pivots of block 0, 1, 2, ..     basis
///   block 0  [ D0                          |  right  ]      D: square diagonal blocks
///   block 1  [ c   D1                      |    ..   ]      c: couplings to earlier blocks
///   block 2  [ c   c   D2                  |    ..   ]
/// ```
///
/// The blocks are solved from the top. Rows with constant pivots may have been eliminated
/// beforehand; then they and their pivot columns are not among these.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Elimination {
    /// Number of rows, which is the number of pivots.
    pub rows: usize,
    /// |B|.
    pub basis: usize,
    /// Entries in the basis columns; rows are absolute.
    pub right: Vec<Entry>,
    /// The diagonal blocks; block k couples only to blocks before it.
    pub blocks: Vec<Block>,
    /// For each row, the number of its shift in the template. No step reads it; people do.
    pub row_shifts: Vec<usize>,
    /// For each pivot, the number of its column in the template: excess columns first, then
    /// reducible ones. No step reads it; people do.
    pub pivot_columns: Vec<usize>,
}

impl Elimination {
    /// Number of columns: pivots and basis.
    pub fn columns(&self) -> usize {
        self.rows + self.basis
    }
}

/// Where a row of the action matrix comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ActionRow {
    /// a b is this basis monomial: a unit row.
    Unit(BasisId),
    /// a b is this pivot: the row is minus its solved row.
    Solved(PivotId),
}

/// A monomial whose value follows from an eigenpair (a, v).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KnownMonomial {
    /// The entry of v at this position.
    Basis(BasisId),
    /// a times the entry of v at this position.
    Image(BasisId),
    /// The product of v with minus the solved row of the pivot at this position of [`Plan::read`].
    Read(u16),
}

/// How a template loses solutions at which some unknown vanishes, unless it is stated that it does
/// not vanish.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Zeros {
    /// They have no eigenpair: the action monomial is divided by the unknown, or all basis
    /// monomials are multiples of it.
    pub lacks_pairs: bool,
    /// Another unknown cannot be read from their eigenpair: of each pair (m, s m) that it is read
    /// from, m has a higher power of the unknown that vanishes than some basis monomial.
    pub is_misread: bool,
}

/// How an unknown x is read from pairs of monomials (m_k, s m_k): by the least-squares ratio of
/// their values,
///
/// s = sum of conj(m_k) (s m_k) / sum of |m_k|^2
///
/// The monomial s is x where no signs can be changed. Otherwise it is x^2, or x times unknowns that
/// are square roots or their reciprocals.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Extraction {
    /// The unknown.
    pub unknown: usize,
    /// The exponents of s, one per unknown.
    pub step: Vec<i8>,
    /// (m, s m).
    pub pairs: Vec<(KnownMonomial, KnownMonomial)>,
}

impl Extraction {
    /// Whether the unknown is the square root of the ratio.
    pub fn is_square(&self) -> bool {
        self.step.get(self.unknown) == Some(&2)
    }

    /// The other unknowns in s, with their exponents.
    pub fn others(&self) -> impl Iterator<Item = (usize, i8)> + '_ {
        self.step.iter().copied().enumerate().filter(|&(other, e)| e != 0 && other != self.unknown)
    }
}

/// `unknown = sum of terms`, in unknowns that are known by then.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlannedRecovery {
    /// The unknown that presolve eliminated.
    pub unknown: usize,
    /// Its value.
    pub terms: Vec<Term>,
}

/// Unknowns x that follow together, by least squares, from A x + b = 0 with no fewer rows than
/// unknowns. The entries are sums of terms in the unknowns that are read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlannedBlock {
    /// The unknowns that presolve eliminated.
    pub unknowns: Vec<usize>,
    /// The rows of A and b.
    pub rows: Vec<Vec<Vec<Term>>>,
}

/// Where presolve solves equations for monomials, pivots must be more than this. The coefficients
/// of the template have then half of the digits, and the polish brings the others. Where they are
/// not, twice the precision may do, or the solutions are followed from data nearby.
pub const LEAST_PIVOT_OF_PRESOLVE: f64 = 1e-7;

/// Data that are derived from the inputs before them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlannedDerivation {
    /// What is done to which values of the program.
    pub derivation: Derivation<ValueId>,
    /// From the inputs to the operands.
    pub program: Program,
    /// Whether only what is returned beside the unknowns depends on them: a solve leaves them 0.
    pub is_for_results: bool,
    /// Whether only choices read the results: where there are none, a matrix having lost rank, they
    /// are NaN, and something else is chosen. They are 0 for a solve.
    pub is_tentative: bool,
}

/// What one measurement gives, of which data are the mean.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlannedMeasurement {
    /// The name of the function of the problem.
    pub name: String,
    /// Its doc comment.
    pub docs: Vec<String>,
    /// A measurement.
    pub data: Vec<DataParameter>,
    /// The shape of the mean.
    pub shape: Vec<usize>,
    /// From the measurement to what it gives.
    pub program: Program,
    /// What it gives, row by row.
    pub elements: Vec<ValueId>,
}

/// Floating-point operations of one solve. An addition, a multiplication and a division count as
/// one each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OperationCount {
    /// Operations of the straight-line program.
    pub coefficients: usize,
    /// Elimination and back-substitution.
    pub elimination: usize,
    /// Hessenberg form and eigenvalues, by the usual estimate 10 |B|^3. A determinant takes fewer;
    /// [`time`] knows it.
    pub roots: usize,
}

impl OperationCount {
    /// The sum.
    pub fn total(&self) -> usize {
        self.coefficients + self.elimination + self.roots
    }
}

/// The chains of a basis.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chains {
    /// The basis: the chains that stay one after another, each from head to end, then the
    /// eliminated ones.
    pub order: Vec<BasisId>,
    /// The lengths of the chains that stay. Those whose rows eliminate others come first.
    pub lengths: Vec<usize>,
    /// The number of eliminated chains, of one monomial each.
    pub eliminated: usize,
}

/// A solver with all decisions taken.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Plan {
    /// Name of the problem and of the emitted module.
    pub name: String,
    /// Doc comment of the problem.
    pub docs: Vec<String>,
    /// The data that are given.
    pub data: Vec<DataParameter>,
    /// The data that are derived from them, which follow them among the inputs: first those of the
    /// problem, then those of presolve, which only the template reads.
    pub derived: Vec<PlannedDerivation>,
    /// What measurements give, of which data are means.
    pub measurements: Vec<PlannedMeasurement>,
    /// The number of scalars in the data of the problem: those that are given, and those that it
    /// derives from them.
    pub stated: usize,
    /// Names of the unknowns.
    pub unknowns: Vec<String>,
    /// The fields of the solution: the unknowns with their shapes.
    pub fields: Vec<SolutionField>,
    /// The number of different complex solutions of a generic instance.
    pub solutions: usize,
    /// Whether the origin, where all unknowns are 0 but those that presolve eliminated, is one of
    /// them. It is known, and no template need give it.
    pub has_origin: bool,
    /// How it loses solutions at which some unknown vanishes.
    pub zeros: Zeros,
    /// From the data to the coefficients.
    pub program: Program,
    /// The value of each coefficient.
    pub coefficients: Vec<ValueId>,
    /// The elimination.
    pub elimination: Elimination,
    /// The rows of the action matrix, |B| of them.
    pub action: Vec<ActionRow>,
    /// The exponents of the action monomial; empty if something else than an unknown stands in the
    /// place of one.
    pub action_monomial: Vec<i8>,
    /// Pivots outside the image a B of the basis from which unknowns are read.
    pub read: Vec<PivotId>,
    /// How real solutions are found: by the determinant over these chains, or by eigenvalues.
    pub chains: Option<Chains>,
    /// How the unknowns that presolve kept follow from an eigenpair; square roots come first.
    pub extractions: Vec<Extraction>,
    /// Symmetries that map solutions to solutions with the same eigenpair, without the identity:
    /// for each, the image of each unknown.
    pub images: Vec<Vec<Image>>,
    /// The unknowns that presolve eliminated by determinants: they follow first.
    pub linear: Option<PlannedBlock>,
    /// How the other unknowns that presolve eliminated follow, in this order.
    pub recoveries: Vec<PlannedRecovery>,
    /// All equations as stated in the problem, for the polish and the residual.
    pub equations: Vec<Vec<Term>>,
    /// Polynomials that must not vanish at a solution.
    pub nonzero: Vec<Vec<Term>>,
    /// Polynomials that are positive at the solutions that `solve` returns.
    pub positive: Vec<Vec<Term>>,
    /// What the solver returns beside the unknowns.
    pub output: Option<PlannedOutput>,
    /// How data come about that users have, for measurements. No solver depends on it.
    pub scene: Option<Scene>,
    /// Scalings under which the problem stays the same, if some change unknowns.
    pub scalings: Vec<Scaling>,
}

/// Larger blocks than this are eliminated by code that is not compiled for their size: it is as
/// fast.
const LARGE_BLOCK: usize = 24;

impl Block {
    /// Whether the block is eliminated by code that is not compiled for its size.
    pub fn is_large(&self) -> bool {
        self.size > LARGE_BLOCK
    }

    /// Floating-point operations of its elimination and back-substitution.
    fn operations(&self, basis: usize) -> usize {
        let n = self.size;
        let factor: usize = (0..n).map(|k| (n - k - 1) * (1 + 2 * (n - k - 1))).sum();
        let (forward, backward) = (n * (n - 1) * basis, self.needed * self.needed * basis);
        factor + forward + backward + 2 * self.coupling.len() * basis
    }
}

impl Plan {
    /// The data that the problem derives, or those that presolve derives.
    pub fn derived_by(&self, presolve: bool) -> impl Iterator<Item = (usize, &PlannedDerivation)> {
        let is_own = move |(_, d): &(usize, &PlannedDerivation)| (d.derivation.first_input >= self.stated) == presolve;
        self.derived.iter().enumerate().filter(is_own)
    }

    /// Whether presolve derives data.
    pub fn is_presolved_at_run_time(&self) -> bool {
        self.inputs() > self.stated
    }

    /// The coefficients of what the problem states, in increasing order, without those that only
    /// the template has.
    pub fn coefficients_of_statements(&self) -> BTreeSet<CoefficientId> {
        let statements = self.equations.iter().chain(&self.nonzero).chain(&self.positive);
        statements.flatten().map(|term| term.coefficient).collect()
    }

    /// The coefficients that only the template has and that are quotients of data, in increasing
    /// order: presolve divided equations by data, or solved them for monomials. Quotients that the
    /// problem states, and products of them, are none.
    pub fn quotients(&self) -> BTreeSet<CoefficientId> {
        let (stated, operations) = (self.coefficients_of_statements(), &self.program.operations);
        let mut is_stated = vec![false; operations.len()];
        stated.iter().for_each(|id| is_stated[self.coefficients[usize::from(id.0)].0 as usize] = true);
        for (at, &operation) in operations.iter().enumerate().rev() {
            if is_stated[at] {
                self.program.operands(operation).for_each(|operand| is_stated[operand.0 as usize] = true);
            }
        }
        let mut is_quotient: Vec<bool> = Vec::with_capacity(operations.len());
        for (&operation, is_stated) in operations.iter().zip(is_stated) {
            let is_own = match operation {
                Operation::Divide(..) => true,
                Operation::Input(input) => input as usize >= self.stated,
                _ => false,
            };
            let inherits = || self.program.operands(operation).any(|operand| is_quotient[operand.0 as usize]);
            is_quotient.push(!is_stated && (is_own || inherits()));
        }
        let all = self.coefficients.iter().zip(0..).map(|(value, at)| (CoefficientId(at), value.0 as usize));
        all.filter(|&(id, value)| is_quotient[value] && !stated.contains(&id)).map(|(id, _)| id).collect()
    }

    /// The coefficients that must be finite, if not all: those of what the problem states.
    /// Quotients are not finite at data at which presolve divides by zero, or cannot solve for its
    /// monomials. Solutions are then followed from data nearby.
    pub fn required_coefficients(&self) -> Option<BTreeSet<CoefficientId>> {
        (!self.quotients().is_empty()).then(|| self.coefficients_of_statements())
    }

    /// Whether an elimination at twice the precision computes the coefficients anew: tables can be
    /// executed in it, what presolve divides by may be zero up to rounding in `f64`, and
    /// determinants may lose all digits there.
    pub fn has_precise_coefficients(&self) -> bool {
        self.program.form == ProgramForm::Table || !self.quotients().is_empty() || self.linear.is_some()
    }

    /// The number of scalars in the data that are given.
    pub fn given(&self) -> usize {
        self.data.iter().map(DataParameter::len).sum()
    }

    /// The number of scalars in all data, those that are derived included.
    pub fn inputs(&self) -> usize {
        self.derived.last().map_or_else(|| self.given(), |last| last.derivation.inputs().end)
    }

    /// The weights of the data in all scalings, those of the first datum first.
    pub fn weights_of_data(&self) -> Vec<i8> {
        let weights = |input: usize| {
            // What presolve derives is computed from scaled data.
            self.scalings.iter().map(move |scaling| scaling.data.get(input).copied().unwrap_or(0))
        };
        (0..self.inputs()).flat_map(weights).collect()
    }

    /// The weights of the unknowns in all scalings, those of the first unknown first.
    pub fn weights_of_unknowns(&self) -> Vec<i8> {
        let weights = |unknown: usize| self.scalings.iter().map(move |scaling| scaling.unknowns[unknown]);
        (0..self.unknowns.len()).flat_map(weights).collect()
    }

    /// The vectors up to scale whose elements have different units.
    pub fn vectors_with_units(&self) -> impl Iterator<Item = &SolutionField> {
        let has_weight = |unknown: usize| self.scalings.iter().any(|scaling| scaling.unknowns[unknown] != 0);
        self.fields.iter().filter(move |field| field.is_projective && field.unknowns().any(has_weight))
    }

    /// The unknowns that are elements of vectors up to scale: bit k stands for unknown k.
    pub fn unknowns_in_vectors(&self) -> u32 {
        self.fields.iter().filter(|field| field.is_projective).flat_map(SolutionField::unknowns).map(|k| 1 << k).sum()
    }

    /// For each unknown the exponents of the monomial s of its extraction; zeros if it is not read.
    pub fn steps(&self) -> Vec<Vec<i8>> {
        let step = |unknown: usize| {
            let found = self.extractions.iter().find(|x| x.unknown == unknown);
            found.map_or_else(|| vec![0; self.unknowns.len()], |x| x.step.clone())
        };
        (0..self.unknowns.len()).map(step).collect()
    }

    /// Whether some eigenvalues belong to no solution, or to one that is known beforehand.
    pub fn has_spurious_values(&self) -> bool {
        self.elimination.basis * (1 + self.images.len()) + usize::from(self.has_origin) > self.solutions
    }

    /// The unknowns that are recovered, in this order: those that presolve eliminated, and those in
    /// whose places something else stands in the template.
    pub fn recovered(&self) -> impl Iterator<Item = usize> + '_ {
        let linear = self.linear.iter().flat_map(|block| block.unknowns.iter().copied());
        linear.chain(self.recoveries.iter().map(|recovery| recovery.unknown))
    }

    /// The unknowns that are recovered and not read from an eigenpair, each once.
    pub fn eliminated(&self) -> Vec<usize> {
        let all: Vec<usize> = self.recovered().filter(|&unknown| !self.is_read(unknown)).collect();
        (0..all.len()).filter(|&at| !all[..at].contains(&all[at])).map(|at| all[at]).collect()
    }

    /// The unknowns in whose places linear forms stand in the template: read, and then recovered.
    pub fn replaced(&self) -> Vec<usize> {
        self.recoveries.iter().map(|recovery| recovery.unknown).filter(|&unknown| self.is_read(unknown)).collect()
    }

    fn is_read(&self, unknown: usize) -> bool {
        self.extractions.iter().any(|x| x.unknown == unknown)
    }

    /// How real solutions are found.
    pub fn roots(&self) -> RootMethod {
        if self.chains.is_some() { RootMethod::Determinant } else { RootMethod::Eigenvalues }
    }

    /// Operations of a solve that derive data.
    pub fn operations_of_derived(&self) -> usize {
        let derived = self.derived.iter().filter(|derived| !derived.is_for_results);
        derived.map(|d| d.program.steps() + d.derivation.kind.operations()).sum()
    }

    /// Operations of one solve.
    pub fn operations(&self) -> OperationCount {
        let coefficients = self.program.steps() + self.operations_of_derived();
        let width = self.elimination.basis;
        let elimination = self.elimination.blocks.iter().map(|block| block.operations(width));
        OperationCount { coefficients, elimination: elimination.sum(), roots: 10 * width * width * width }
    }
}
