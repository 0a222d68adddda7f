//! Time of Gröbner bases, beside the crate `groebner` (on one thread too), in one run.
//!
//! Both compute the reduced grevlex basis over the same prime field. The calls alternate, so that a
//! machine that slows down slows both, and the median of the ratios is what counts.

#[allow(dead_code)] // the tests use the rest
#[path = "../tests/systems/mod.rs"]
mod systems;

use std::hint::black_box;
use std::time::Instant;

use eliminant_generator::algebra::{Limits, MonomialOrder, PrimeField, groebner_basis};
use groebner::{MonomialOrder as OracleOrder, groebner_basis_f4};
use systems::{PRIME, System, cyclic, eco, katsura, noon};

fn seconds<R>(f: impl FnOnce() -> R) -> f64 {
    let start = Instant::now();
    black_box(f());
    start.elapsed().as_secs_f64()
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn compare(system: &System, repetitions: usize) {
    let field = PrimeField::new(PRIME);
    let limits = Limits::default();
    let input = system.for_oracle(&OracleOrder::GRevLex);
    let ours = || groebner_basis(field, &system.polynomials, &MonomialOrder::GrevLex, &limits);
    let theirs = |input| groebner_basis_f4(input, true);
    let times: Vec<(f64, f64)> = (0..repetitions)
        .map(|_| {
            let copy = input.clone();
            (seconds(ours), seconds(|| theirs(copy)))
        })
        .collect();
    println!(
        "{:<12} eliminant {:>9.3} ms   groebner {:>9.3} ms   ratio {:>5.2}",
        system.name,
        1e3 * median(times.iter().map(|t| t.0).collect()),
        1e3 * median(times.iter().map(|t| t.1).collect()),
        median(times.iter().map(|t| t.0 / t.1).collect())
    );
}

fn main() {
    for system in [katsura(4), katsura(5), katsura(6), cyclic(4), cyclic(5), cyclic(6), noon(4), eco(6)] {
        compare(&system, 101);
    }
    for system in [katsura(8), cyclic(7), eco(8)] {
        compare(&system, 5);
    }
}
