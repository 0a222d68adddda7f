//! What solvers emitted by `eliminant-generator` call at run time.
//!
//! The modules stand in the order in which an emitted solver uses them:
//!
//! 1. [`program`] computes the coefficients of large problems; those of small ones are emitted as statements.
//! 2. [`template`] fills the elimination template and [`lu`] eliminates its diagonal blocks; what is left is the action
//!    matrix.
//! 3. [`hessenberg`] and [`eigenvalues`] give its eigenvalues and, for one eigenvalue at a time, the eigenvector;
//!    [`polynomial_roots`] gives only the real ones, from the characteristic polynomial.
//! 4. [`extract`] reads unknowns off an eigenvector, by [`symmetry`] where it tells them up to sign.
//! 5. [`mod@polish`] improves a solution on the original equations, which [`system`] evaluates from static tables.
//! 6. [`driver`] does 3 to 5 for every eigenvalue; [`distinct`] drops what was found twice. Solutions that share an
//!    eigenvalue are told apart by `shared_value` on its `invariant_subspace`. Where solutions are missing, 2 to 5 are
//!    done once more with the numbers of `double_double`, on a `precise_spectrum`.
//! 7. [`solutions`] and [`error`] are what a solver returns.
//!
//! Nothing here allocates, panics on data, loops without a bound or knows a problem. All sizes are const generic and
//! matrices are arrays of rows, so that the inner loops run over contiguous memory and vectorise.
//!
//! Without the default feature `std` the crate is `no_std`; feature `libm` then supplies the square root.
#![no_std]
#![forbid(unsafe_code)]
// `!(x > y)` where a NaN must take the branch, too.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

#[cfg(feature = "std")]
extern crate std;

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("eliminant needs one of its features `std` (default) and `libm` for square roots");

mod candidates;
pub mod distinct;
mod double_double;
pub mod driver;
pub mod eigenvalues;
pub mod error;
pub mod extract;
mod float;
pub mod hessenberg;
mod invariant_subspace;
mod inverse_iteration;
pub mod lu;
pub mod polish;
pub mod polynomial_roots;
mod precise_spectrum;
pub mod program;
pub mod scalar;
mod shared_value;
pub mod solutions;
pub mod symmetry;
pub mod system;
pub mod template;

pub use arrayvec::ArrayVec;
pub use distinct::{Candidate, push_distinct};
pub use driver::{ActionMethod, complex_solutions, real_solutions, real_solutions_by_polynomial};
pub use error::SolveError;
pub use extract::ratio;
pub use hessenberg::Hessenberg;
pub use lu::{solve_block, solve_block_trailing};
pub use num_complex::Complex;
pub use polish::polish;
pub use polynomial_roots::{real_roots, real_roots_monic};
pub use program::{Operation, PolynomialProduct, ProductSum, ProductSums, Program, Run, joined};
pub use scalar::{Real, Scalar};
pub use solutions::Solutions;
pub use symmetry::Symmetry;
pub use system::{PolynomialSystem, Product, System, Tables, Term};
pub use template::{
    ActionRow, Block, Entry, action_matrix, check_coefficients, eliminate_block, eliminate_large_block, fill,
    solved_rows,
};

/// Includes the solver of that name, which the build script wrote: the emitted file holds `pub mod NAME { .. }`.
///
/// ```text
/// // lib.rs, with problems/five_point.rs and a build script that runs eliminant_generator::Generator:
/// eliminant::include_solver!("five_point");
/// let solutions = five_point::solve(&points)?;
/// ```
#[macro_export]
macro_rules! include_solver {
    ($name:literal) => {
        include!(concat!(env!("OUT_DIR"), "/", $name, ".rs"));
    };
}
