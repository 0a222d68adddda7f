//! Algebra over Z_p: the prime field, monomials, polynomials, row echelon form, Gröbner bases, quotient rings.

mod echelon;
mod field;
mod matrix;
mod monomial;
mod polynomial;

pub use echelon::Echelon;
pub use field::{PRIMES, PrimeField};
pub use matrix::DenseMatrix;
pub use monomial::{MAX_UNKNOWNS, Monomial};
pub use polynomial::Polynomial;
