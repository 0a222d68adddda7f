//! From the action matrix to eigenpairs.
//!
//! 1. [`hessenberg`] reduces the matrix, and [`eigenvalues`] runs the QR iteration on the result,
//!    by sweeps of [`reflection`]s.
//! 2. `inverse_iteration` gives the eigenvector of one eigenvalue at a time.
//! 3. `invariant_subspace` gives the subspace of eigenvalues that are too close to be told apart.
//! 4. `precise_spectrum` does 1 and 2 at twice the precision, for any size up to 256.
//! 5. [`hidden_variable`] does without the iteration: the real eigenvalues are the [`real_roots`]
//!    of the determinant of a small matrix of polynomials, whose null vectors give the
//!    eigenvectors. `closed_form` has those of degree 2 to 4.

pub(crate) mod closed_form;
pub(crate) mod eigenvalues;
pub(crate) mod hessenberg;
pub(crate) mod hidden_variable;
pub(crate) mod invariant_subspace;
pub(crate) mod inverse_iteration;
pub(crate) mod precise_spectrum;
pub(crate) mod real_roots;
pub(crate) mod reflection;
pub(crate) mod root_count;

#[cfg(all(test, feature = "alloc"))]
mod same_bits;
