//! Algebra over Z_p: the prime field, monomials, polynomials, row echelon form, Gröbner bases, quotient rings.

mod field;
mod monomial;
mod polynomial;

pub use field::{PRIMES, PrimeField};
pub use monomial::{MAX_UNKNOWNS, Monomial};
pub use polynomial::Polynomial;
