//! Gröbner bases by F4, change of order, saturation, quotient rings.

mod basis;
mod f4;
mod fglm;
mod limits;
mod monomial_table;
mod order;
mod pairs;
mod points;
mod polynomial_arithmetic;
mod quotient;
mod reduced_basis;
mod saturation;
mod symbolic;
mod trace;
mod traced_basis;
mod zero_sets;

pub use basis::{BasisElement, GroebnerBasis};
pub use fglm::change_order;
pub use limits::{GroebnerError, Limits};
pub use order::{MonomialOrder, OrderKey};
pub use points::count_points;
pub use quotient::QuotientRing;
pub use reduced_basis::groebner_basis;
pub use saturation::saturate;
pub use trace::GeneratorMultiple;
pub use traced_basis::TracedBasis;
pub use zero_sets::zero_sets;
