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
        let image = b.checked_mul(&template.action).ok_or(VerifyError::Columns)?;
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::PRIMES;
    use crate::template::Shift;

    const F: PrimeField = PrimeField::new(PRIMES[0]);

    /// Monomials in w, x, y.
    fn m(w: i8, x: i8, y: i8) -> Monomial {
        Monomial::from_exponents(&[w, x, y])
    }

    /// A residue from a small integer.
    fn residue(value: i64) -> u32 {
        value.rem_euclid(i64::from(F.modulus())) as u32
    }

    fn polynomial(terms: &[(Monomial, i64)]) -> Polynomial<u32> {
        Polynomial::from_terms(terms.iter().map(|&(m, c)| (m, residue(c))).collect())
    }

    /// Two equations whose difference is x^2 - x - 2, with the roots 2 and -1.
    fn equations() -> Vec<Polynomial<u32>> {
        let first = polynomial(&[(m(1, 0, 0), 1), (m(0, 0, 1), 3), (m(0, 2, 0), 1)]);
        let second = polynomial(&[(m(1, 0, 0), 1), (m(0, 0, 1), 3), (m(0, 1, 0), 1), (Monomial::ONE, 2)]);
        vec![first, second]
    }

    /// w is an excess column; y is no column and cancels with it.
    fn template() -> EliminationTemplate {
        EliminationTemplate {
            shifts: (0..2).map(|equation| Shift { equation, multiplier: Monomial::ONE }).collect(),
            action: m(0, 1, 0),
            excess: vec![m(1, 0, 0)],
            reducible: vec![m(0, 2, 0)],
            basis: vec![m(0, 1, 0), Monomial::ONE],
        }
    }

    fn action(template: &EliminationTemplate, equations: &[Polynomial<u32>]) -> Result<Vec<Vec<u32>>, VerifyError> {
        let matrix = verify(template, F, equations)?;
        assert_eq!((matrix.rows(), matrix.columns()), (template.basis.len(), template.basis.len()));
        Ok((0..matrix.rows()).map(|row| matrix.row(row).to_vec()).collect())
    }

    /// What `verify` says of the template after one change.
    fn after(change: impl Fn(&mut EliminationTemplate)) -> Option<VerifyError> {
        let mut changed = template();
        change(&mut changed);
        action(&changed, &equations()).err()
    }

    #[test]
    fn the_action_matrix_is_that_of_the_quotient_ring() {
        assert_eq!(action(&template(), &equations()), Ok(vec![vec![1, 2], vec![1, 0]]));
        // The columns may stand in any order, and the template may be multiplied by a monomial.
        let mut other = template();
        other.basis.reverse();
        for list in [&mut other.excess, &mut other.reducible, &mut other.basis] {
            list.iter_mut().for_each(|column| *column = column.times(&m(0, 3, 1)));
        }
        other.shifts.iter_mut().for_each(|shift| shift.multiplier = m(0, 3, 1));
        assert_eq!(action(&other, &equations()), Ok(vec![vec![0, 1], vec![2, 1]]));
    }

    /// y = 2 x and x^2 = 3 x: 1 is in no row, and its image x is in the basis.
    #[test]
    fn a_basis_monomial_may_be_in_no_row() {
        let equations =
            [polynomial(&[(m(0, 0, 1), 1), (m(0, 1, 0), -2)]), polynomial(&[(m(0, 2, 0), 1), (m(0, 1, 0), -3)])];
        let shift = |equation| Shift { equation, multiplier: Monomial::ONE };
        let template = EliminationTemplate {
            shifts: vec![shift(0), shift(1)],
            action: m(0, 1, 0),
            excess: vec![m(0, 0, 1)],
            reducible: vec![m(0, 2, 0)],
            basis: vec![Monomial::ONE, m(0, 1, 0)],
        };
        assert_eq!(action(&template, &equations), Ok(vec![vec![0, 1], vec![0, 3]]));
    }

    #[test]
    fn a_shift_out_of_range_is_refused() {
        assert_eq!(after(|t| t.shifts[1].equation = 2), Some(VerifyError::Shift));
        // x^2 x^126 has an exponent beyond 127.
        assert_eq!(after(|t| t.shifts[0].multiplier = m(0, 126, 0)), Some(VerifyError::Shift));
    }

    /// x^127 follows from x^-128 by x = 2. It is not the image of x^-128 under 1/x, which has an
    /// exponent below -128.
    #[test]
    fn an_image_out_of_range_is_refused() {
        let powers = |range: std::ops::RangeInclusive<i8>| range.map(|e| m(0, e, 0)).collect::<Vec<_>>();
        let shift = |multiplier| Shift { equation: 0, multiplier };
        let mut template = EliminationTemplate {
            shifts: powers(-128..=126).into_iter().map(shift).collect(),
            action: m(0, 0, 1),
            excess: powers(-127..=126),
            reducible: powers(127..=127),
            basis: powers(-128..=-128),
        };
        let equations = [polynomial(&[(m(0, 1, 0), 1), (Monomial::ONE, -2)])];
        for action in [m(0, -1, 0), m(0, 1, 0)] {
            template.action = action;
            assert_eq!(self::action(&template, &equations), Err(VerifyError::Columns));
        }
    }

    #[test]
    fn columns_that_are_repeated_or_missing_are_refused() {
        let refused = Some(VerifyError::Columns);
        // As many columns as rows, but one of them twice.
        assert_eq!(after(|t| t.excess = t.reducible.clone()), refused);
        // More or fewer columns than rows.
        assert_eq!(after(|t| t.excess.push(m(0, 0, 1))), refused);
        assert_eq!(after(|t| t.excess.clear()), refused);
        // Columns that no row has.
        assert_eq!(after(|t| t.excess[0] = m(5, 0, 0)), refused);
        assert_eq!(after(|t| t.reducible[0] = m(5, 0, 0)), refused);
        // A basis monomial twice, and one that is a pivot, too.
        assert_eq!(after(|t| t.basis.push(Monomial::ONE)), refused);
        assert_eq!(after(|t| t.basis.push(m(1, 0, 0))), refused);
        // x y is neither reducible nor in the basis.
        assert_eq!(after(|t| t.basis.push(m(0, 0, 1))), refused);
        assert_eq!(after(|t| t.action = m(0, 0, 1)), refused);
    }

    #[test]
    fn dependent_rows_are_refused() {
        assert_eq!(after(|t| t.shifts[1].equation = 0), Some(VerifyError::Singular));
        // Independent rows, but not in the pivot columns: both have w and 3 y.
        assert_eq!(after(|t| t.reducible[0] = m(0, 0, 1)), Some(VerifyError::Singular));
    }

    /// With 4 y in the second equation the difference has y, which is no column.
    #[test]
    fn a_monomial_that_does_not_cancel_is_refused() {
        let [first, second] = equations().try_into().unwrap();
        let y = m(0, 0, 1);
        let changed = second.terms().iter().map(|&(m, c)| (m, if m == y { 4 } else { c }));
        let other = Polynomial::from_terms(changed.collect());
        assert_eq!(action(&template(), &[first.clone(), other.clone()]), Err(VerifyError::Remainder));
        // The same if y stands in the row of the reducible monomial from the start.
        let mut swapped = template();
        swapped.shifts.reverse();
        assert_eq!(action(&swapped, &[first.clone(), other.clone()]), Err(VerifyError::Remainder));
        // And if another reducible monomial, w^2 = x, does not need y.
        let mut more = template();
        more.shifts.push(Shift { equation: 2, multiplier: Monomial::ONE });
        more.reducible.push(m(2, 0, 0));
        let square = polynomial(&[(m(2, 0, 0), 1), (m(0, 1, 0), -1)]);
        assert_eq!(action(&more, &[first, other, square]), Err(VerifyError::Remainder));
    }
}
