//! Algebra over Z_p: the prime field, monomials, polynomials, row echelon form, Gröbner bases, quotient rings.

mod echelon;
mod f4;
mod fglm;
mod field;
mod groebner;
mod matrix;
mod monomial;
mod monomial_table;
mod order;
mod pairs;
mod points;
mod polynomial;
mod polynomial_arithmetic;
mod quotient;
mod saturation;
mod symbolic;

pub use echelon::Echelon;
pub use fglm::change_order;
pub use field::{PRIMES, PrimeField};
pub use groebner::{BasisElement, GroebnerBasis, GroebnerError, Limits, groebner_basis};
pub use matrix::DenseMatrix;
pub use monomial::{MAX_UNKNOWNS, Monomial, MonomialMap, MonomialSet};
pub use order::{MonomialOrder, OrderKey};
pub use points::count_points;
pub use polynomial::Polynomial;
pub use quotient::QuotientRing;
pub use saturation::saturate;
