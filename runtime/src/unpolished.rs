//! What the eigenpairs give before the polish: for measurements only, no solver returns it.

use num_complex::Complex;

use crate::error::SolveError;
use crate::size::{Size, Square};
use crate::solution::candidates::images;
use crate::solution::extract::unknowns;
use crate::solution::symmetries::mapped_by;
use crate::solver_instance::{Point, SolverInstance};
use crate::spectrum::hessenberg::Hessenberg;

/// Hands over the point of every eigenpair of one attempt in `f64`: neither polished nor judged, so
/// that points of eigenpairs that belong to no solution are among them. Points that a symmetry
/// maps to each other follow each other. A solution that is known beforehand is left out, and so is
/// an eigenpair whose unknowns cannot be read.
///
/// # Errors
/// Those of the action matrix and of the QR iteration.
pub fn unpolished_points<I: SolverInstance>(
    solver: &mut I,
    mut each: impl FnMut(&Point<I, Complex<f64>>),
) -> Result<(), SolveError> {
    let action = solver.action_matrix::<f64>()?;
    let (spectrum, values) = spectrum(solver.sizes().basis, &action)?;
    for &value in values.as_ref() {
        let Some(point) = unknowns(solver, value, &spectrum.eigenvector(value)) else { continue };
        each(&point);
        for images in images(solver) {
            each(&mapped_by(images, &point));
        }
    }
    Ok(())
}

/// The eigenvalues of a matrix, as a solver computes them, in no order.
///
/// # Errors
/// [`SolveError::Overflow`] if an entry is infinite or NaN, [`SolveError::NoConvergence`] if the QR
/// iteration does not end.
pub fn eigenvalues<Z: Size>(size: Z, matrix: &Square<Z, f64>) -> Result<Z::Vector<Complex<f64>>, SolveError> {
    Ok(spectrum(size, matrix)?.1)
}

/// The reduced matrix, and its eigenvalues.
type Spectrum<Z> = (Hessenberg<Z>, <Z as Size>::Vector<Complex<f64>>);

fn spectrum<Z: Size>(size: Z, matrix: &Square<Z, f64>) -> Result<Spectrum<Z>, SolveError> {
    let mut spectrum = Hessenberg::zero(size);
    spectrum.matrix = matrix.clone();
    spectrum.reduce_in_place()?;
    let values = spectrum.eigenvalues()?;
    Ok((spectrum, values))
}
