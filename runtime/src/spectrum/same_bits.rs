//! Tests: all kinds of sizes give the same bits, and so do the results of both precisions.

extern crate alloc;

use alloc::vec::Vec;

use num_complex::Complex;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

use crate::dynamic_size::Dynamic;
use crate::error::SolveError;
use crate::memory::{Memory, OnHeap};
use crate::number::double_double::{DoubleComplex, DoubleDouble};
use crate::number::{Over, Real, Scalar};
use crate::size::{AtMost, Fixed, Size, filled_matrix};
use crate::spectrum::hessenberg::Hessenberg;

/// The bits of numbers, in the order in which they were computed.
#[derive(Debug, Default, PartialEq)]
struct Bits(Vec<u64>);

impl Bits {
    /// Both parts of a number of twice the precision.
    fn add<S: Scalar>(&mut self, numbers: &[S]) {
        for &number in numbers {
            let high = number.to_complex();
            let low = (number - S::from_complex(high)).to_complex();
            self.0.extend([high.re, high.im, low.re, low.im].map(f64::to_bits));
        }
    }
}

/// The matrix with these entries, row by row, reduced.
fn reduced<Z: Size, R: Real>(size: Z, entries: &[f64]) -> Result<Hessenberg<Z, R>, SolveError> {
    let mut form = Hessenberg::zero(size);
    for (row, entries) in form.matrix.as_mut().iter_mut().zip(entries.chunks_exact(size.get())) {
        row.as_mut().iter_mut().zip(entries).for_each(|(place, &entry)| *place = R::from_f64(entry));
    }
    form.reduce_in_place()?;
    Ok(form)
}

/// The form, its eigenvalues and eigenvectors.
fn eigenpairs<Z: Size, R: Real, C: Scalar + Over<R>>(size: Z, entries: &[f64]) -> Result<Bits, SolveError> {
    let form = reduced::<Z, R>(size, entries)?;
    let (n, mut bits) = (size.get(), Bits::default());
    form.matrix.as_ref()[..n].iter().for_each(|row| bits.add(&row.as_ref()[..n]));
    bits.add(&[form.norm, form.unit]);
    let values = form.eigenvalues()?;
    for &value in &values.as_ref()[..n] {
        bits.add(&[value]);
        bits.add(&form.eigenvector(C::from_complex(value)).as_ref()[..n]);
        if value.im == 0.0 {
            bits.add(&form.eigenvector(R::from_f64(value.re)).as_ref()[..n]);
        }
    }
    Ok(bits)
}

/// What only the first attempt computes: invariant subspaces.
fn first_attempt_alone<Z: Size>(size: Z, entries: &[f64]) -> Result<Bits, SolveError> {
    let (form, mut bits) = (reduced::<Z, f64>(size, entries)?, Bits::default());
    let mut basis = filled_matrix(size, size, 0.0);
    for cluster in form.clusters(&form.eigenvalues()?).iter() {
        form.invariant_subspace(cluster, &mut basis);
        basis.as_ref()[..cluster.dimension].iter().for_each(|vector| bits.add(vector.as_ref()));
    }
    Ok(bits)
}

fn compare<const N: usize>(entries: &[f64]) {
    let constant = eigenpairs::<_, f64, Complex<f64>>(Fixed::<N>, entries);
    assert_eq!(constant, eigenpairs::<_, f64, Complex<f64>>(Dynamic(N), entries));
    assert_eq!(constant, eigenpairs::<_, f64, Complex<f64>>(AtMost::<9>(N), entries));
    let precise = eigenpairs::<_, DoubleDouble, DoubleComplex>(Fixed::<N>, entries);
    assert_eq!(precise, eigenpairs::<_, DoubleDouble, DoubleComplex>(Dynamic(N), entries));
    assert_eq!(precise, eigenpairs::<_, DoubleDouble, DoubleComplex>(AtMost::<9>(N), entries));
    let memory = &Memory::new();
    let on_heap = OnHeap { size: Fixed::<N>, memory };
    // The second time in memory that was in use before.
    for _ in 0..2 {
        assert_eq!(constant, eigenpairs::<_, f64, Complex<f64>>(on_heap, entries));
        let partly_in_use = OnHeap { size: AtMost::<9>(N), memory };
        assert_eq!(precise, eigenpairs::<_, DoubleDouble, DoubleComplex>(partly_in_use, entries));
        assert_eq!(first_attempt_alone(Fixed::<N>, entries), first_attempt_alone(on_heap, entries));
    }
    assert_eq!(first_attempt_alone(Fixed::<N>, entries), first_attempt_alone(Dynamic(N), entries));
}

/// Entries of which many are 0 or 1, so that clusters and deflations are likely, and some far from
/// 1.
fn entry() -> impl Strategy<Value = f64> {
    prop_oneof![
        3 => (-1..2_i32).prop_map(f64::from),
        3 => -1.0..1.0_f64,
        1 => (-1.0..1.0_f64, -30..30_i32).prop_map(|(x, exponent)| x * 2.0_f64.powi(exponent)),
    ]
}

/// The same cases every time.
fn config() -> ProptestConfig {
    ProptestConfig { cases: 200, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..Default::default() }
}

proptest! {
    #![proptest_config(config())]
    #[test]
    fn spectra(entries in prop::collection::vec(entry(), 81), unit in prop::sample::select(alloc::vec![1.0, 1e-80, 1e90])) {
        let entries: Vec<f64> = entries.iter().map(|entry| entry * unit).collect();
        compare::<1>(&entries[..1]);
        compare::<2>(&entries[..4]);
        compare::<5>(&entries[..25]);
        compare::<9>(&entries);
    }
}
