//! Eigenpairs at twice the precision, for the second attempt of all solvers.
//!
//! Code that runs rarely should be small: it is compiled for a few sizes of arrays and not for each
//! |B|, and a program holds those that its solvers need.

use num_complex::Complex;

use crate::error::SolveError;
use crate::memory::Memory;
#[cfg(feature = "alloc")]
use crate::memory::OnHeap;
use crate::number::double_double::{DoubleComplex, DoubleDouble};
use crate::number::{Over, Scalar};
use crate::size::{AtMost, Size};
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

impl<Z: Size> Eigenvectors for Hessenberg<Z, DoubleDouble> {
    fn eigenvector(&self, value: Complex<f64>, vector: &mut [Complex<f64>]) {
        // Complex products are four real ones.
        match value.im == 0.0 {
            true => self.write_eigenvector(DoubleDouble::from_f64(value.re), vector),
            false => self.write_eigenvector(DoubleComplex::from_complex(value), vector),
        }
    }
}

impl<Z: Size> Hessenberg<Z, DoubleDouble> {
    fn write_eigenvector<S: Scalar + Over<DoubleDouble>>(&self, value: S, vector: &mut [Complex<f64>]) {
        let precise = self.eigenvector(value);
        for (entry, known) in vector.iter_mut().zip(precise.as_ref()) {
            *entry = known.to_complex();
        }
    }
}

/// The rows of a matrix, wherever they are kept: the code below is compiled once, and not for each
/// solver.
pub(crate) type Row<'a> = &'a dyn Fn(usize) -> &'a [DoubleDouble];

/// What is called with a spectrum.
pub(crate) type Reader<'a> = &'a mut dyn FnMut(&PreciseSpectrum<'_>);

/// Functions that reserve memory for matrices up to each of these sizes, in increasing order, and
/// the one that takes the first that suffices. They are no instances of a generic function, which
/// each solver would compile; and where the order is constant, only one of them is called, and the
/// linker leaves out the others.
macro_rules! capacities {
    ($all:ident: $($name:ident $capacity:literal)*, $memory:ident: $place:ty, |$order:ident| $size:expr) => {
        $(#[inline(never)]
        fn $name($order: usize, row: Row<'_>, $memory: $place, with: Reader<'_>) -> Result<(), SolveError> {
            const CAPACITY: usize = $capacity;
            of_size($size, row, with)
        })*

        #[inline(always)]
        fn $all(order: usize, row: Row<'_>, memory: $place, with: Reader<'_>) -> Result<(), SolveError> {
            $(if order <= $capacity {
                return $name(order, row, memory, with);
            })*
            Err(SolveError::TooLarge)
        }
    };
}

capacities!(on_stack: stack_16 16 stack_24 24, _memory: (), |order| AtMost::<CAPACITY>(order));

#[cfg(feature = "alloc")]
capacities!(
    on_heap: heap_32 32 heap_64 64 heap_96 96 heap_128 128 heap_160 160 heap_192 192 heap_256 256,
    memory: &Memory,
    |order| OnHeap { size: AtMost::<CAPACITY>(order), memory }
);

/// Calls `with` for the spectrum of the square matrix with these rows. Its memory has the next
/// larger of the sizes listed above.
///
/// # Errors
/// As [`Hessenberg::reduce`] and [`Hessenberg::eigenvalues`]; [`SolveError::TooLarge`] beyond 256
/// rows, and beyond 24 rows without `memory` on the heap: it would take too much of the stack.
#[inline(always)]
pub(crate) fn with_precise_spectrum(
    order: usize,
    row: Row<'_>,
    memory: Option<&Memory>,
    with: Reader<'_>,
) -> Result<(), SolveError> {
    #[cfg(feature = "alloc")]
    if let Some(memory) = memory {
        return on_heap(order, row, memory, with);
    }
    let _ = memory;
    on_stack(order, row, (), with)
}

#[inline(always)]
fn of_size<Z: Size>(size: Z, row: Row<'_>, with: Reader<'_>) -> Result<(), SolveError> {
    let order = size.get();
    let mut form = Hessenberg::<Z, DoubleDouble>::zero(size);
    for (at, place) in form.matrix.as_mut().iter_mut().enumerate().take(order) {
        for (entry, &known) in place.as_mut().iter_mut().zip(row(at)) {
            *entry = known;
        }
    }
    form.reduce_in_place()?;
    let eigenvalues = form.eigenvalues()?;
    with(&PreciseSpectrum { eigenvalues: &eigenvalues.as_ref()[..order], eigenvectors: &form });
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

    /// Checks all eigenpairs of the matrix of that order.
    fn check(n: usize, memory: Option<&Memory>) {
        const LARGEST: usize = 129;
        let mut matrix = [[DoubleDouble::ZERO; LARGEST]; LARGEST];
        let matrix = &mut matrix[..n];
        companion(n, matrix);
        let mut found = 0;
        with_precise_spectrum(n, &|at| &matrix[at], memory, &mut |spectrum| {
            for &value in spectrum.eigenvalues {
                assert!((value.powi(n as i32) - 2.0).norm() < 1e-12, "{n}: {value}");
                let mut vector = [Complex::ZERO; LARGEST];
                spectrum.eigenvector(value, &mut vector);
                for i in 1..n {
                    assert!((vector[i] - vector[i - 1] * value).norm() < 1e-13, "{n}: entry {i} of that of {value}");
                }
                found += 1;
            }
        })
        .unwrap();
        assert_eq!(found, n);
    }

    #[test]
    fn every_order_has_its_eigenpairs() {
        [2, 15, 16, 17, 24].into_iter().for_each(|n| check(n, None));
        assert_eq!(with_precise_spectrum(25, &|_| &[], None, &mut |_| ()), Err(SolveError::TooLarge));
        #[cfg(feature = "alloc")]
        {
            let memory = Memory::new();
            [2, 32, 33, 65, 96, 97, 128, 129].into_iter().for_each(|n| check(n, Some(&memory)));
            let too_large = with_precise_spectrum(257, &|_| &[], Some(&memory), &mut |_| ());
            assert_eq!(too_large, Err(SolveError::TooLarge));
        }
    }
}
