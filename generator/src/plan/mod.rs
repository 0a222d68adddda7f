//! What an emitted solver does, with no algebra left: the last form before printing.
//!
//! ```text
//! data --code--> coefficients --fill, eliminate--> action matrix T --roots--> eigenpairs (a, v) --extract--> kept unknowns
//!                      |                                                                                        |
//!                      +------------------------------ polish on all equations <---- recover eliminated unknowns
//! ```
//!
//! Every decision is taken here; [`crate::emit`] prints and [`crate::plan::interpret`] executes, and the two must agree.

mod block_triangular;
mod constant_rows;
pub mod interpret;
pub mod program;
pub mod program_table;
mod residues;
pub mod schedule;
pub mod solution_count;
pub mod statements;
mod straight_line;
pub mod system_table;
pub mod value_layout;

use crate::problem::{DataParameter, SolutionField};
use crate::template::RootMethod;
use program::{Program, ValueId};

/// Position in the array of coefficients that the tables refer to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CoefficientId(pub u16);

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
    /// What stands there.
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
    /// How many of its last pivots are read by later blocks or by the action matrix; the others only serve the elimination.
    pub needed: usize,
    /// The square block; rows and columns count from `first`.
    pub diagonal: Vec<Entry>,
    /// Entries at pivots solved before; rows count from `first`, columns are absolute pivots.
    pub coupling: Vec<Entry>,
}

/// The elimination: the template's rows and pivot columns permuted to block-triangular form, blocks in order of solution. Constant rows may
/// have been eliminated beforehand: they and their pivot columns are not among these.
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
    /// For each row, which of the template's shifts it is. Only for people: no step reads it.
    pub row_shifts: Vec<usize>,
    /// For each pivot, which of the template's excess and, behind them, reducible columns it is. Only for people.
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
    /// a b is the basis monomial itself.
    Unit(BasisId),
    /// a b is this pivot: minus its solved row.
    Solved(PivotId),
}

/// A monomial whose value follows from an eigenpair (a, v).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KnownMonomial {
    /// v at this position.
    Basis(BasisId),
    /// a times v at this position.
    Image(BasisId),
    /// Minus the solved row of [`Plan::read`] at this position, times v.
    Read(u16),
}

/// An unknown x from the least-squares ratio of monomial values, s = sum conj(m_k) (s m_k) / sum |m_k|^2 for a monomial s, which is x but where signs
/// can be changed: then it is x^2, or x times unknowns that are square roots, or their reciprocals.
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

/// A term of a polynomial in the unknowns: coefficient and exponent of each unknown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Term {
    /// The coefficient.
    pub coefficient: CoefficientId,
    /// One exponent per unknown, not negative.
    pub exponents: Vec<u8>,
}

/// `unknown = sum of terms`, in unknowns that are known by then.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlannedRecovery {
    /// The unknown that presolve eliminated.
    pub unknown: usize,
    /// Its value.
    pub terms: Vec<Term>,
}

/// Floating-point operations of one solve, additions and multiplications counted alike; divisions count as one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OperationCount {
    /// Straight-line program.
    pub coefficients: usize,
    /// Elimination and back-substitution.
    pub elimination: usize,
    /// Hessenberg form and eigenvalues, by the usual estimate 10 |B|^3.
    pub roots: usize,
}

impl OperationCount {
    /// The sum.
    pub fn total(&self) -> usize {
        self.coefficients + self.elimination + self.roots
    }
}

/// A solver with all decisions taken.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Plan {
    /// Name of the problem and of the emitted module.
    pub name: String,
    /// Doc comment of the problem.
    pub docs: Vec<String>,
    /// The data.
    pub data: Vec<DataParameter>,
    /// Names of the unknowns.
    pub unknowns: Vec<String>,
    /// The fields of the solution: the unknowns with their shapes.
    pub fields: Vec<SolutionField>,
    /// Number of different complex solutions of a generic instance.
    pub solutions: usize,
    /// Whether the origin is one of them. It is known, and no template need give it.
    pub has_origin: bool,
    /// From the data to the coefficients.
    pub program: Program,
    /// The value of each coefficient.
    pub coefficients: Vec<ValueId>,
    /// The elimination.
    pub elimination: Elimination,
    /// The rows of the action matrix, |B| of them.
    pub action: Vec<ActionRow>,
    /// Pivots outside the image of the basis from which unknowns are read.
    pub read: Vec<PivotId>,
    /// How real roots are found.
    pub roots: RootMethod,
    /// How kept unknowns follow from an eigenpair, those that are square roots first.
    pub extractions: Vec<Extraction>,
    /// Changes of sign that map solutions to solutions with the same eigenpair: for each, whether it changes an unknown.
    pub flips: Vec<Vec<bool>>,
    /// How eliminated unknowns follow, in this order.
    pub recoveries: Vec<PlannedRecovery>,
    /// All equations as stated in the problem, for the polish and the residual.
    pub equations: Vec<Vec<Term>>,
    /// Polynomials that must not vanish at a solution.
    pub nonzero: Vec<Vec<Term>>,
}

/// Blocks of more rows are eliminated by code that is not compiled for their size: it is as fast.
const LARGE_BLOCK: usize = 24;

impl Block {
    /// Whether the block is eliminated by code that is not compiled for its size.
    pub fn is_large(&self) -> bool {
        self.size > LARGE_BLOCK
    }
}

impl Plan {
    /// How many scalars the data have.
    pub fn inputs(&self) -> usize {
        self.data.iter().map(DataParameter::len).sum()
    }

    /// For each unknown the exponents of the monomial by which its pairs differ; zeros if it is not read.
    pub fn steps(&self) -> Vec<Vec<i8>> {
        let step = |unknown: usize| {
            let found = self.extractions.iter().find(|x| x.unknown == unknown);
            found.map_or_else(|| vec![0; self.unknowns.len()], |x| x.step.clone())
        };
        (0..self.unknowns.len()).map(step).collect()
    }

    /// Operations of one solve.
    pub fn operations(&self) -> OperationCount {
        let coefficients = self.program.steps();
        let width = self.elimination.basis;
        let elimination = self.elimination.blocks.iter().map(|block| {
            let n = block.size;
            let factor: usize = (0..n).map(|k| (n - k - 1) * (1 + 2 * (n - k - 1))).sum();
            let forward = n * (n - 1) * width;
            let backward = block.needed * block.needed * width;
            factor + forward + backward + 2 * block.coupling.len() * width
        });
        OperationCount { coefficients, elimination: elimination.sum(), roots: 10 * width * width * width }
    }

    /// Checks that every table stays in range and that every value and pivot is written before it is read.
    pub fn check(&self) -> Result<(), PlanError> {
        let program_ok = self.program.is_ordered(self.data.iter().map(DataParameter::len).sum());
        let coefficient_ok = |id: CoefficientId| usize::from(id.0) < self.coefficients.len();
        let e = &self.elimination;
        let mut next = 0;
        let mut blocks_ok = true;
        for block in &e.blocks {
            let inside = |entry: &Entry, columns: usize| {
                usize::from(entry.row) < block.size
                    && usize::from(entry.column) < columns
                    && coefficient_ok(entry.coefficient)
            };
            blocks_ok &= block.first == next && block.size > 0 && block.needed <= block.size;
            blocks_ok &= block.diagonal.iter().all(|entry| inside(entry, block.size));
            blocks_ok &= block.coupling.iter().all(|entry| inside(entry, block.first));
            next += block.size;
        }
        let right_ok = e.right.iter().all(|entry| {
            usize::from(entry.row) < e.rows && usize::from(entry.column) < e.basis && coefficient_ok(entry.coefficient)
        });
        let reads_needed = |pivot: u16| {
            e.blocks.iter().any(|block| {
                let end = block.first + block.size;
                (end - block.needed..end).contains(&usize::from(pivot))
            })
        };
        let couplings_ok = e.blocks.iter().flat_map(|block| &block.coupling).all(|entry| reads_needed(entry.column));
        let action_ok = self.action.len() == e.basis
            && self.action.iter().all(|row| match row {
                ActionRow::Unit(b) => usize::from(b.0) < e.basis,
                ActionRow::Solved(p) => reads_needed(p.0),
            });
        let known_ok = self.read.iter().all(|pivot| reads_needed(pivot.0))
            && self.extractions.iter().flat_map(|x| &x.pairs).flat_map(|&(m, xm)| [m, xm]).all(|known| match known {
                KnownMonomial::Basis(b) | KnownMonomial::Image(b) => usize::from(b.0) < e.basis,
                KnownMonomial::Read(at) => usize::from(at) < self.read.len(),
            });
        let mut known = vec![false; self.unknowns.len()];
        let mut steps_ok = true;
        for x in &self.extractions {
            let own = x.step.get(x.unknown);
            steps_ok &= x.step.len() == known.len() && (x.is_square() || own == Some(&1));
            steps_ok &= x.others().all(|(other, e)| known[other] && matches!(e, 1 | -1));
            known[x.unknown] |= !x.pairs.is_empty();
        }
        steps_ok &= self.flips.iter().all(|flip| flip.len() == known.len());
        let enough = self.solutions <= e.basis * (1 + self.flips.len()) + usize::from(self.has_origin);
        let mut terms_ok = true;
        for recovery in &self.recoveries {
            let reads_known = |t: &Term| t.exponents.iter().zip(&known).all(|(&e, &k)| e == 0 || k);
            terms_ok &= recovery.terms.iter().all(reads_known);
            known[recovery.unknown] = true;
        }
        let all_terms =
            self.equations.iter().chain(&self.nonzero).chain(self.recoveries.iter().map(|r| &r.terms)).flatten();
        terms_ok &=
            all_terms.clone().all(|t| coefficient_ok(t.coefficient) && t.exponents.len() == self.unknowns.len());
        let values_ok = self.coefficients.iter().all(|id| (id.0 as usize) < self.program.operations.len());
        for (ok, what) in [
            (program_ok, "a value is read before it is written"),
            (values_ok, "a coefficient has no value"),
            (blocks_ok && next == e.rows, "the blocks do not tile the rows"),
            (e.row_shifts.len() == e.rows && e.pivot_columns.len() == e.rows, "a row has no shift or no pivot column"),
            (couplings_ok, "a block reads a pivot that is not solved"),
            (right_ok, "a basis entry is out of range"),
            (action_ok, "a row of the action matrix is out of range"),
            (known_ok, "an unknown is read from a monomial that is not known"),
            (steps_ok, "an unknown is read with one that is not known"),
            (enough, "the basis is smaller than the number of solutions"),
            (terms_ok, "a term reads something unknown"),
            (known.iter().all(|&k| k), "an unknown is never recovered"),
        ] {
            if !ok {
                return Err(PlanError(what));
            }
        }
        Ok(())
    }
}

/// A plan that contradicts itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("inconsistent plan: {0}")]
pub struct PlanError(pub &'static str);
