//! Conics in the plane, six coefficients each, as table-driven systems.

use eliminant::Complex;
use eliminant::emitted::{Fixed, FixedTables, Product, Term};

use super::Random;

/// Monomials 1, x, y, x^2, x y, y^2.
pub(crate) const MONOMIALS: [Product; 6] =
    [product(0, 0), product(0, 0), product(0, 1), product(1, 0), product(1, 1), product(2, 1)];

/// Two conics with a coefficient slot for each of their terms.
pub(crate) const TWO: FixedTables<2, 2, 6> = FixedTables::new::<12>(&MONOMIALS, &[6, 12], &terms::<12>());

/// Three conics: one more equation than unknowns need.
pub(crate) const THREE: FixedTables<2, 3, 6> = FixedTables::new::<18>(&MONOMIALS, &[6, 12, 18], &terms::<18>());

pub(crate) const fn product(parent: u16, unknown: u16) -> Product {
    Product { parent, unknown }
}

pub(crate) const fn term(coefficient: u16, monomial: u16) -> Term {
    Term { coefficient, monomial }
}

/// All monomials of each conic; C slots.
pub(crate) const fn terms<const C: usize>() -> [Term; C] {
    let mut terms = [term(0, 0); C];
    let mut slot = 0;
    while slot < C {
        terms[slot] = term(slot as u16, (slot % 6) as u16);
        slot += 1;
    }
    terms
}

/// Conics through the point: their coefficients are random except for the constant term.
pub(crate) fn through<const C: usize>(random: &mut Random, [x, y]: [f64; 2]) -> [f64; C] {
    let mut c: [f64; C] = std::array::from_fn(|_| random.symmetric());
    for conic in c.chunks_mut(6) {
        conic[0] = -(conic[1] * x + conic[2] * y + conic[3] * x * x + conic[4] * x * y + conic[5] * y * y);
    }
    c
}

/// Conics through a complex point and its conjugate: constant and linear coefficient in x follow
/// from the others.
pub(crate) fn through_complex<const C: usize>(random: &mut Random, [x, y]: [Complex<f64>; 2]) -> [f64; C] {
    let mut c: [f64; C] = std::array::from_fn(|_| random.symmetric());
    for conic in c.chunks_mut(6) {
        let rest = y * conic[2] + x * x * conic[3] + x * y * conic[4] + y * y * conic[5];
        conic[1] = -rest.im / x.im;
        conic[0] = -rest.re - conic[1] * x.re;
    }
    c
}

/// [`eliminant::emitted::polish`] for sizes that the compiler knows.
pub(crate) fn polish<S: eliminant::Scalar, const N: usize, const E: usize>(
    x: &mut [S; N],
    system: &impl eliminant::emitted::System<S, Fixed<N>, Fixed<E>>,
    steps: usize,
) -> f64 {
    eliminant::emitted::polish(x, (Fixed, Fixed), system, steps)
}
