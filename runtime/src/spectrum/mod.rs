//! From the action matrix to eigenpairs.
//!
//! 1. [`hessenberg`] reduces the matrix, and [`eigenvalues`] runs the QR iteration on the result.
//! 2. `inverse_iteration` gives the eigenvector of one eigenvalue at a time.
//! 3. `invariant_subspace` gives the subspace of eigenvalues that are too close to be told apart.
//! 4. `precise_spectrum` does 1 and 2 at twice the precision, for any size up to 256.
//! 5. [`polynomial_roots`] gives the real eigenvalues alone, from the characteristic polynomial.

pub(crate) mod eigenvalues;
pub(crate) mod hessenberg;
pub(crate) mod invariant_subspace;
pub(crate) mod inverse_iteration;
pub(crate) mod polynomial_roots;
pub(crate) mod precise_spectrum;

#[cfg(all(test, feature = "alloc"))]
mod same_bits;
