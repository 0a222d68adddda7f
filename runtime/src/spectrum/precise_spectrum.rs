//! Eigenpairs at twice the precision, for the second attempt of all solvers.
//!
//! Code that runs rarely should be small: it is compiled for a few sizes of arrays and not for each
//! |B|.

use num_complex::Complex;

use crate::error::SolveError;
use crate::number::Scalar;
use crate::number::double_double::{DoubleComplex, DoubleDouble};
use crate::size::AtMost;
use crate::spectrum::hessenberg::Hessenberg;

/// The spectrum of a matrix. Its eigenvectors are returned in the usual precision, which suffices
/// to read off unknowns.
pub(crate) struct PreciseSpectrum<'a> {
    pub(crate) eigenvalues: &'a [Complex<f64>],
    eigenvectors: &'a dyn Eigenvectors,
}

impl PreciseSpectrum<'_> {
    /// Writes the eigenvector of an eigenvalue.
    pub(crate) fn eigenvector(&self, value: Complex<f64>, vector: &mut [Complex<f64>]) {
        self.eigenvectors.eigenvector(value, vector);
    }
}

trait Eigenvectors {
    fn eigenvector(&self, value: Complex<f64>, vector: &mut [Complex<f64>]);
}

impl<const C: usize> Eigenvectors for Hessenberg<AtMost<C>, DoubleDouble> {
    fn eigenvector(&self, value: Complex<f64>, vector: &mut [Complex<f64>]) {
        let precise = self.eigenvector(DoubleComplex::from_complex(value));
        for (entry, known) in vector.iter_mut().zip(precise) {
            *entry = known.to_complex();
        }
    }
}

/// The rows of a matrix, wherever they are kept: the code below is compiled once, and not for each
/// solver.
pub(crate) type Row<'a> = &'a dyn Fn(usize) -> &'a [DoubleDouble];

/// Calls `with` for the spectrum of the square matrix with these rows. It takes the stack of the
/// next larger of the sizes listed below.
///
/// # Errors
/// As [`Hessenberg::reduce`] and [`Hessenberg::eigenvalues`]; [`SolveError::TooLarge`] beyond 256
/// rows, for which no memory is reserved.
pub(crate) fn with_precise_spectrum(
    order: usize,
    row: Row<'_>,
    with: &mut dyn FnMut(&PreciseSpectrum<'_>),
) -> Result<(), SolveError> {
    match order {
        0..=16 => at_capacity::<16>(order, row, with),
        17..=32 => at_capacity::<32>(order, row, with),
        33..=64 => at_capacity::<64>(order, row, with),
        65..=96 => at_capacity::<96>(order, row, with),
        97..=128 => at_capacity::<128>(order, row, with),
        129..=160 => at_capacity::<160>(order, row, with),
        161..=192 => at_capacity::<192>(order, row, with),
        193..=256 => at_capacity::<256>(order, row, with),
        _ => Err(SolveError::TooLarge),
    }
}

/// A function of its own, so that only the size in use takes its memory from the stack.
#[inline(never)]
fn at_capacity<const C: usize>(
    order: usize,
    row: Row<'_>,
    with: &mut dyn FnMut(&PreciseSpectrum<'_>),
) -> Result<(), SolveError> {
    let mut form = Hessenberg::<AtMost<C>, DoubleDouble>::zero(AtMost(order));
    for (at, place) in form.matrix.iter_mut().enumerate().take(order) {
        for (entry, &known) in place.iter_mut().zip(row(at)) {
            *entry = known;
        }
    }
    form.reduce_in_place()?;
    let eigenvalues = form.eigenvalues()?;
    with(&PreciseSpectrum { eigenvalues: &eigenvalues[..order], eigenvectors: &form });
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The companion matrix of x^n - 2: eigenvalues of modulus 2^(1/n), eigenvectors 1, x, x^2, ..
    fn companion<const N: usize>(n: usize, matrix: &mut [[DoubleDouble; N]]) {
        matrix.as_flattened_mut().fill(DoubleDouble::ZERO);
        (0..n - 1).for_each(|i| matrix[i][i + 1] = DoubleDouble::ONE);
        matrix[n - 1][0] = DoubleDouble::from_f64(2.0);
    }

    #[test]
    fn every_order_has_its_eigenpairs() {
        const LARGEST: usize = 129;
        let mut memory = [[DoubleDouble::ZERO; LARGEST]; LARGEST];
        for n in [2, 15, 16, 17, 33, 65, 96, 97, 128, LARGEST] {
            let matrix = &mut memory[..n];
            companion(n, matrix);
            let mut found = 0;
            with_precise_spectrum(n, &|at| &matrix[at], &mut |spectrum| {
                for &value in spectrum.eigenvalues {
                    assert!((value.powi(n as i32) - 2.0).norm() < 1e-12, "{n}: {value}");
                    let mut vector = [Complex::ZERO; LARGEST];
                    spectrum.eigenvector(value, &mut vector);
                    for i in 1..n {
                        assert!(
                            (vector[i] - vector[i - 1] * value).norm() < 1e-13,
                            "{n}: entry {i} of that of {value}"
                        );
                    }
                    found += 1;
                }
            })
            .unwrap();
            assert_eq!(found, n);
        }
        assert_eq!(with_precise_spectrum(257, &|_| &[], &mut |_| ()), Err(SolveError::TooLarge));
    }
}
