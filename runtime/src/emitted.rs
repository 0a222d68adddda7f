//! The interface that emitted code and the interpreted plans of the generator call. It changes with
//! every version: people should not call it.

pub use crate::batch::solve_batch;
pub use crate::batch::solver::{BatchData, BatchSizes, BatchSizesOf, BatchSolver};
pub use crate::continuation::family::{Condition, Family};
pub use crate::derived::{least, null_space, null_space_small, solve_linear, solve_small, square_root};
pub use crate::determinant::real_solutions_by_determinant;
pub use crate::driver::{VANISHING, complex_solutions, real_solutions};
#[cfg(feature = "alloc")]
pub use crate::dynamic_size::{BoundedVec, Dynamic};
pub use crate::elimination::lu::{
    BlockError, BlockMemory, Eliminated, solve_block, solve_block_trailing, solve_large_block,
};
pub use crate::elimination::program::{
    Operation, PolynomialProduct, ProductSum, ProductSums, Program, Run, join_into, joined,
};
pub use crate::elimination::quotients::Quotients;
pub use crate::elimination::template::{ActionRow, Block, Entry, action_matrix, check_coefficients, fill, solved_rows};
pub use crate::fill_entries;
pub use crate::memory::Memory;
#[cfg(feature = "alloc")]
pub use crate::memory::{HeapList, HeapMatrix, HeapRows, OnHeap, Precise};
pub use crate::number::double_double::DoubleDouble;
pub use crate::number::{Arithmetic, Over, Real};
pub use crate::scaling::{MOST_SCALINGS, Scalings, scaled, unscale, unscaled};
pub use crate::size::{AtMost, Element, Fixed, List, Matrix, Size, Square, Vector, filled_matrix};
pub use crate::solution::candidates::MAX_RESIDUAL;
pub use crate::solution::chart::{chart_entry, from_chart, to_chart, unscale_in_chart, unscale_vector, vector_of};
pub use crate::solution::dense_system::{DenseSystem, rows, rows_of};
pub use crate::solution::distinct::{Candidate, push_distinct};
pub use crate::solution::extract::{monomial_value, monomial_values, ratio};
pub use crate::solution::inequality::{Inequality, is_wanted};
pub use crate::solution::least_squares::{MOST_LINEAR, least_squares};
pub use crate::solution::polish::{POLISH_STEPS, polish};
pub use crate::solution::refine::{error_bound, polish_precisely};
pub use crate::solution::symmetries::{Image, Symmetries};
pub use crate::solution::system::{
    FixedTables, Monomials, PolynomialSystem, PreciseSystem, Product, System, Tables, Term, Values,
};
pub use crate::solver_instance::{BasisVector, HiddenVariableSolver, Point, Points, Sizes, SizesOf, SolverInstance};
pub use crate::spectrum::hessenberg::Hessenberg;
pub use crate::spectrum::hidden_variable::{ChainTable, ChainedBasis, entry, value_at};
pub use crate::spectrum::real_roots::{RealRoots, real_roots};
pub use crate::unpolished::{eigenvalues, unpolished_points};

/// The version of this interface. Emitted code states the one that it was written for.
pub const VERSION: u32 = 14;

/// The handshake of emitted code, evaluated when it is compiled.
///
/// ```compile_fail,E0080
/// const _: () = eliminant::emitted::check_version(eliminant::emitted::VERSION + 1);
/// ```
///
/// # Panics
/// If the code was emitted for another version. In a constant, this is a compile error with the
/// message.
pub const fn check_version(of_generator: u32) {
    assert!(
        of_generator == VERSION,
        "this solver was emitted by another version of eliminant-generator than the `eliminant` it is compiled with: \
         use equal versions of both crates and build again"
    );
}
