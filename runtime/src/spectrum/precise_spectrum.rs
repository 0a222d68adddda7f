//! Eigenpairs at twice the precision, for the second attempt of all solvers.
//!
//! Code that runs rarely should be small: it is compiled for a few sizes of arrays and not for each
//! |B|, and a program holds those that its solvers need.

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

/// Functions that reserve memory for matrices up to each of these sizes, in increasing order, and
/// the one that takes the first that suffices. They are no instances of a generic function, which
/// each solver would compile; and where the order is constant, only one of them is called, and the
/// linker leaves out the others.
macro_rules! capacities {
    ($($name:ident $capacity:literal)*) => {
        $(#[inline(never)]
        fn $name(order: usize, row: Row<'_>, with: Reader<'_>) -> Result<(), SolveError> {
            at_capacity::<$capacity>(order, row, with)
        })*

        /// Calls `with` for the spectrum of the square matrix with these rows. It takes the stack
        /// of the next larger of the sizes listed below.
        ///
        /// # Errors
        /// As [`Hessenberg::reduce`] and [`Hessenberg::eigenvalues`]; [`SolveError::TooLarge`]
        /// beyond 256 rows, for which no memory is reserved.
        #[inline(always)]
        pub(crate) fn with_precise_spectrum(
            order: usize,
            row: Row<'_>,
            with: Reader<'_>,
        ) -> Result<(), SolveError> {
            $(if order <= $capacity {
                return $name(order, row, with);
            })*
            Err(SolveError::TooLarge)
        }
    };
}

capacities!(up_to_16 16 up_to_32 32 up_to_64 64 up_to_96 96 up_to_128 128 up_to_160 160 up_to_192 192 up_to_256 256);

/// What is called with a spectrum.
pub(crate) type Reader<'a> = &'a mut dyn FnMut(&PreciseSpectrum<'_>);

#[inline(always)]
fn at_capacity<const C: usize>(order: usize, row: Row<'_>, with: Reader<'_>) -> Result<(), SolveError> {
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
