//! What the eigenpairs give before the polish: for measurements only, no solver returns it.

use num_complex::Complex;

use crate::error::SolveError;
use crate::solution::candidates::flips;
use crate::solution::extract::unknowns;
use crate::solution::sign_changes::flipped;
use crate::solver_instance::{Point, SolverInstance};
use crate::spectrum::hessenberg::Hessenberg;

/// Hands over the point of every eigenpair of one attempt in `f64`: neither polished nor judged, so
/// that points of eigenpairs that belong to no solution are among them. Points that differ by the
/// signs of unknowns follow each other. A solution that is known beforehand is left out, and so is
/// an eigenpair whose unknowns cannot be read.
///
/// # Errors
/// Those of the action matrix and of the QR iteration.
pub fn unpolished_points<I: SolverInstance>(
    solver: &mut I,
    mut each: impl FnMut(&Point<I, Complex<f64>>),
) -> Result<(), SolveError> {
    let mut spectrum = Hessenberg::zero(solver.sizes().basis);
    spectrum.matrix = solver.action_matrix::<f64>()?;
    spectrum.reduce_in_place()?;
    let values = spectrum.eigenvalues()?;
    for &value in values.as_ref() {
        let Some(point) = unknowns(solver, value, &spectrum.eigenvector(value)) else { continue };
        each(&point);
        for flip in flips(solver) {
            each(&flipped(&point, flip));
        }
    }
    Ok(())
}
