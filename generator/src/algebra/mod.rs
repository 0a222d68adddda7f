//! Algebra over Z_p: the prime field, monomials, polynomials, row echelon form, eigenpairs; Gröbner
//! bases and quotient rings with the feature `search`.

mod echelon;
mod eigenpair;
mod field;
#[cfg(feature = "search")]
mod groebner;
mod hessenberg;
mod matrix;
mod monomial;
mod polynomial;
mod random;
mod univariate;

pub use echelon::Echelon;
pub use eigenpair::Eigenpair;
pub use field::{PRIMES, PrimeField};
#[cfg(feature = "search")]
pub use groebner::{
    BasisElement, GeneratorMultiple, GroebnerBasis, GroebnerError, Limits, MonomialOrder, OrderKey, QuotientRing,
    TracedBasis, change_order, count_points, groebner_basis, saturate, zero_sets,
};
pub use matrix::DenseMatrix;
pub use monomial::{MAX_UNKNOWNS, Monomial, MonomialMap, MonomialSet};
pub use polynomial::Polynomial;
pub use random::Random;
pub use univariate::Univariate;
