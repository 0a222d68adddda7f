//! The working memory of a solve, predicted from the sizes of a plan, and where it is kept.
//!
//! ```text
//!   elimination   coefficients and the steps of their table, basis columns (rows x |B|),
//!                 the largest block, the action matrix
//!   spectrum      action matrix, Hessenberg form and its reflections, eigenpairs,
//!                 a factorisation for inverse iteration, subspaces of shared values
//! ```
//!
//! Numbers take 8 bytes in the first attempt and 16 in the second, complex ones twice as much.

use super::Plan;
use super::program::ProgramForm;
use super::program_table::ProgramTable;

/// A plan whose arrays take more than this keeps matrices on the heap. Code that is not optimised
/// holds an array up to four times: where it is made, in its result, and where it is moved to. So
/// a solve needs at most 256 KiB of stack in a debug build, and far less in a release build.
const MOST_ON_STACK: usize = 64 * 1024;

/// The orders of the action matrix for which the runtime has arrays on the stack for a second
/// attempt: the next larger one is taken.
const ORDERS_ON_STACK: [usize; 2] = [16, 24];

/// Action matrix, Hessenberg form, reflections, the copy that the QR iteration works on or a
/// factorisation of complex numbers: in matrices of |B|^2 real numbers.
const MATRICES_OF_SPECTRUM: usize = 5;

/// The same with complex eigenvectors, and with the subspaces of solutions that share an
/// eigenvalue.
const MATRICES_OF_FIRST_ATTEMPT: usize = 10;

impl Plan {
    /// Bytes of the largest arrays that a solve needs at the same time, wherever they are.
    pub fn working_memory(&self) -> usize {
        let e = &self.elimination;
        let block = e.blocks.iter().map(|block| block.size).max().unwrap_or(0);
        let table = match self.program.form {
            ProgramForm::Table => ProgramTable::values_of(&self.program, self.inputs()),
            ProgramForm::Statements => 0,
        };
        let square = e.basis * e.basis;
        let elimination = e.rows * e.basis + square + block * block + table + self.coefficients.len();
        let first = 8 * elimination.max(MATRICES_OF_FIRST_ATTEMPT * square);
        let order = ORDERS_ON_STACK.into_iter().find(|&order| order >= e.basis).unwrap_or(e.basis);
        let second = 16 * elimination.max(MATRICES_OF_SPECTRUM * order * order);
        first.max(second)
    }

    /// Whether the matrices of a solve are on the heap.
    pub fn is_on_heap(&self) -> bool {
        let has_room = ORDERS_ON_STACK.into_iter().any(|order| order >= self.elimination.basis);
        !has_room || self.working_memory() > MOST_ON_STACK
    }

    /// Whether matrices of |B| rows are, too. Where a determinant gives the solutions |B| is small.
    pub fn has_basis_on_heap(&self) -> bool {
        self.is_on_heap() && self.chains.is_none()
    }

    /// Operations at twice the precision of a second attempt: coefficients, where they are computed
    /// anew, elimination, Hessenberg form and eigenvalues.
    pub fn operations_of_second_attempt(&self) -> usize {
        let operations = self.operations();
        match self.program.form {
            ProgramForm::Table => operations.total(),
            ProgramForm::Statements => operations.elimination + operations.roots,
        }
    }
}
