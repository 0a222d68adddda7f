//! Eigenpairs at twice the precision, for the second attempt of all solvers.
//!
//! What runs rarely should be small: the code is compiled for a few sizes of arrays and not for each |B|.

use num_complex::Complex;

use crate::double_double::{DoubleComplex, DoubleDouble};
use crate::error::SolveError;
use crate::extract::Eigenpairs;
use crate::hessenberg::Hessenberg;
use crate::scalar::{Scalar, mapped};

/// The spectrum of a matrix; its eigenvectors in the usual precision, which is enough for what is read off them.
pub(crate) struct PreciseSpectrum<'a> {
    pub(crate) eigenvalues: &'a [Complex<f64>],
    eigenvectors: &'a dyn Eigenvectors,
}

trait Eigenvectors {
    /// Writes the eigenvector of an eigenvalue.
    fn eigenvector(&self, value: Complex<f64>, vector: &mut [Complex<f64>]);
}

impl<const C: usize> Eigenvectors for Hessenberg<C, DoubleDouble, usize> {
    fn eigenvector(&self, value: Complex<f64>, vector: &mut [Complex<f64>]) {
        let precise = self.eigenvector(DoubleComplex::from_complex(value));
        for (entry, known) in vector.iter_mut().zip(precise) {
            *entry = known.to_complex();
        }
    }
}

/// Listed under the eigenvalues.
impl<const B: usize> Eigenpairs<B> for PreciseSpectrum<'_> {
    fn real(&self, value: f64) -> (f64, [f64; B]) {
        let (_, vector) = self.complex(value.into());
        (value, mapped(&vector, |entry: Complex<f64>| entry.re))
    }

    fn complex(&self, value: Complex<f64>) -> (Complex<f64>, [Complex<f64>; B]) {
        let mut vector = [Complex::ZERO; B];
        self.eigenvectors.eigenvector(value, &mut vector);
        (value, vector)
    }
}

/// Calls `with` for the spectrum of a square matrix of `order` rows. Its stack is that of the next larger of these sizes.
///
/// # Errors
/// As [`Hessenberg::reduce`] and [`Hessenberg::eigenvalues`]; [`SolveError::NoConvergence`] beyond 256 rows, for which no memory is set aside.
pub(crate) fn with_precise_spectrum(
    matrix: &[DoubleDouble],
    order: usize,
    with: &mut dyn FnMut(&PreciseSpectrum<'_>),
) -> Result<(), SolveError> {
    match order {
        0..=16 => at_capacity::<16>(matrix, order, with),
        17..=32 => at_capacity::<32>(matrix, order, with),
        33..=64 => at_capacity::<64>(matrix, order, with),
        65..=96 => at_capacity::<96>(matrix, order, with),
        97..=128 => at_capacity::<128>(matrix, order, with),
        129..=160 => at_capacity::<160>(matrix, order, with),
        161..=192 => at_capacity::<192>(matrix, order, with),
        193..=256 => at_capacity::<256>(matrix, order, with),
        _ => Err(SolveError::NoConvergence),
    }
}

/// A function of its own, so that only what is called takes its memory from the stack.
#[inline(never)]
fn at_capacity<const C: usize>(
    matrix: &[DoubleDouble],
    order: usize,
    with: &mut dyn FnMut(&PreciseSpectrum<'_>),
) -> Result<(), SolveError> {
    let mut form = Hessenberg::<C, DoubleDouble, usize>::zero(order);
    for (row, known) in form.matrix.iter_mut().zip(matrix.chunks_exact(order.max(1))) {
        row[..order].copy_from_slice(known);
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
    fn companion(n: usize, matrix: &mut [DoubleDouble]) {
        matrix.fill(DoubleDouble::ZERO);
        (0..n - 1).for_each(|i| matrix[i * n + i + 1] = DoubleDouble::ONE);
        matrix[(n - 1) * n] = DoubleDouble::from_f64(2.0);
    }

    #[test]
    fn every_order_has_its_eigenpairs() {
        const LARGEST: usize = 129;
        let mut memory = [DoubleDouble::ZERO; LARGEST * LARGEST];
        for n in [2, 15, 16, 17, 33, 65, 96, 97, 128, LARGEST] {
            let matrix = &mut memory[..n * n];
            companion(n, matrix);
            let mut found = 0;
            with_precise_spectrum(matrix, n, &mut |spectrum| {
                for &value in spectrum.eigenvalues {
                    assert!((value.powi(n as i32) - 2.0).norm() < 1e-12, "{n}: {value}");
                    let mut vector = [Complex::ZERO; LARGEST];
                    spectrum.eigenvectors.eigenvector(value, &mut vector);
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
        assert_eq!(with_precise_spectrum(&[], 257, &mut |_| ()), Err(SolveError::NoConvergence));
    }
}
