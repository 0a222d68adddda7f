//! Proof that a template holds on an instance: its rows express every reducible monomial in the
//! basis.

use super::EliminationTemplate;
use super::shift_matrix::ShiftMatrix;
use crate::algebra::{DenseMatrix, Monomial, Polynomial, PrimeField};

/// Why a template does not hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum VerifyError {
    /// A multiplier times a monomial leaves the range of exponents, or a shift names no equation.
    #[error("a shift is out of range")]
    Shift,
    /// Columns are repeated, or the image of a basis monomial is missing.
    #[error("the columns are repeated or the image of a basis monomial is missing")]
    Columns,
    /// The square part is singular.
    #[error("the square part of the template is singular")]
    Singular,
    /// A monomial that is no column of the template does not cancel.
    #[error("a monomial outside the template's columns does not cancel")]
    Remainder,
}

/// Eliminates over Z_p and returns the action matrix, |B| x |B|.
///
/// Monomials that are no columns of the template stand before the basis. If the template holds, the
/// reducible rows are 0 there, whatever the excess rows are:
///
/// ```text
///   | excess | reducible | all other monomials |  basis  |
///   |   I    |     0     |          *          |    *    |
///   |   0    |     I     |          0          |  -T_R   |
/// ```
pub fn verify(
    template: &EliminationTemplate,
    field: PrimeField,
    equations: &[Polynomial<u32>],
) -> Result<DenseMatrix, VerifyError> {
    let in_range = |equation: usize, multiplier: &Monomial| {
        let f = equations.get(equation)?;
        f.monomials().map(|m| m.checked_mul(multiplier).map(|_| ())).collect::<Option<()>>()
    };
    for shift in &template.shifts {
        in_range(shift.equation, &shift.multiplier).ok_or(VerifyError::Shift)?;
    }
    let matrix = ShiftMatrix::new(field, equations, &template.shifts);
    let columns = matrix.monomials.len();
    let mut position = vec![usize::MAX; columns];
    let mut order = 0;
    let left = template.rows();
    for m in template.excess.iter().chain(&template.reducible) {
        place(&matrix, m, &mut position, &mut order)?;
    }
    if order != left {
        return Err(VerifyError::Columns);
    }
    let basis_columns: Vec<Option<usize>> = template.basis.iter().map(|m| matrix.column_of.get(m).copied()).collect();
    for column in 0..columns {
        if position[column] == usize::MAX && !basis_columns.contains(&Some(column)) {
            position[column] = order;
            order += 1;
        }
    }
    let others = order;
    for m in template.basis.iter().filter(|m| matrix.column_of.contains_key(m)) {
        place(&matrix, m, &mut position, &mut order)?;
    }
    let mut dense = DenseMatrix::zeros(field, left, columns);
    for (row, entries) in matrix.rows.iter().enumerate() {
        entries.iter().for_each(|&(column, value)| dense.row_mut(row)[position[column]] = value);
    }
    let pivots = dense.reduce_to_echelon();
    if !pivots.iter().copied().eq(0..left) {
        return Err(VerifyError::Singular);
    }
    let solved = |at: usize| dense.row(template.excess.len() + at);
    if (0..template.reducible.len()).any(|at| solved(at)[left..others].iter().any(|&value| value != 0)) {
        return Err(VerifyError::Remainder);
    }
    let mut action = DenseMatrix::zeros(field, template.basis.len(), template.basis.len());
    for (row, b) in template.basis.iter().enumerate() {
        let image = b.times(&template.action);
        if let Some(at) = template.basis.iter().position(|m| *m == image) {
            action.row_mut(row)[at] = 1;
            continue;
        }
        let at = template.reducible.iter().position(|m| *m == image).ok_or(VerifyError::Columns)?;
        for (target, column) in action.row_mut(row).iter_mut().zip(&basis_columns) {
            *target = column.map_or(0, |column| field.neg(solved(at)[position[column]]));
        }
    }
    Ok(action)
}

/// Gives the column of a monomial the next position.
fn place(
    matrix: &ShiftMatrix,
    monomial: &Monomial,
    position: &mut [usize],
    next: &mut usize,
) -> Result<(), VerifyError> {
    let column = *matrix.column_of.get(monomial).ok_or(VerifyError::Columns)?;
    if position[column] != usize::MAX {
        return Err(VerifyError::Columns);
    }
    position[column] = *next;
    *next += 1;
    Ok(())
}
