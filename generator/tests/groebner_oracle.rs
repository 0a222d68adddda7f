//! Reduced Gröbner bases against those of the crate `groebner`, which shares no code with this one.
#![cfg(feature = "search")]

#[allow(dead_code)] // each test uses a part of it
mod systems;

use eliminant_generator::algebra::{Limits, MonomialOrder, Polynomial, PrimeField, groebner_basis};
use groebner::{MonomialOrder as OracleOrder, groebner_basis_f4};
use systems::{PRIME, System, cyclic, eco, from_oracle, katsura, noon, positive_dimensional};

/// A monomial order in both crates.
fn orders(unknowns: usize) -> [(MonomialOrder, OracleOrder); 4] {
    let weights: Vec<u16> = (0..unknowns).map(|i| 1 + (i % 3) as u16).collect();
    let oracle_weights: Vec<u32> = weights.iter().map(|&w| u32::from(w)).collect();
    let first: Vec<u32> = (0..unknowns).map(|i| u32::from(i < 2)).collect();
    [
        (MonomialOrder::GrevLex, OracleOrder::GRevLex),
        (MonomialOrder::weighted(&weights), OracleOrder::weighted(oracle_weights, OracleOrder::GRevLex)),
        (MonomialOrder::eliminating(0..2), OracleOrder::weighted(first, OracleOrder::GRevLex)),
        (MonomialOrder::Lex, OracleOrder::Lex),
    ]
}

fn check(system: &System, order: &MonomialOrder, oracle_order: &OracleOrder) {
    let basis = groebner_basis(PrimeField::new(PRIME), &system.polynomials, order, &Limits::default()).unwrap();
    let oracle = groebner_basis_f4(system.for_oracle(oracle_order), true).unwrap();
    let canonical = |mut polynomials: Vec<Polynomial<u32>>| {
        polynomials.sort_by(|a, b| a.monomials().cmp(b.monomials()));
        polynomials
    };
    let expected = canonical(oracle.iter().map(from_oracle).collect());
    assert_eq!(canonical(basis.polynomials()), expected, "{} {order:?}", system.name);
}

#[test]
fn grevlex_bases_of_known_systems() {
    let systems = [3, 4, 5, 6]
        .map(katsura)
        .into_iter()
        .chain([4, 5, 6].map(cyclic))
        .chain([3, 4].map(noon))
        .chain([5, 6].map(eco));
    for system in systems {
        check(&system, &MonomialOrder::GrevLex, &OracleOrder::GRevLex);
    }
}

#[test]
fn bases_in_all_orders() {
    for system in [katsura(3), cyclic(4), eco(4), eco(5), positive_dimensional()] {
        for (order, oracle_order) in orders(system.unknowns) {
            check(&system, &order, &oracle_order);
        }
    }
}

#[test]
fn the_oracle_rejects_a_wrong_basis() {
    // The comparison can fail: another system has another basis.
    let basis = |system: &System| {
        groebner_basis(PrimeField::new(PRIME), &system.polynomials, &MonomialOrder::GrevLex, &Limits::default())
            .unwrap()
    };
    let oracle = groebner_basis_f4(katsura(3).for_oracle(&OracleOrder::GRevLex), true).unwrap();
    let expected: Vec<_> = oracle.iter().map(from_oracle).collect();
    assert!(basis(&katsura(3)).polynomials().iter().all(|polynomial| expected.contains(polynomial)));
    assert!(!basis(&cyclic(4)).polynomials().iter().all(|polynomial| expected.contains(polynomial)));
}
