//! A reduced echelon form that is kept up to date while rows of the matrix are deleted and columns change their order.
//!
//! Both changes cost one row operation for each row, where a new elimination would cost one for each pair of rows.

use super::shift_matrix::ShiftMatrix;
use crate::algebra::{DenseMatrix, PrimeField};

/// The reduced echelon form of a [`ShiftMatrix`] for an order of its columns, and each row as a combination of the shifts.
///
/// ```text
///              columns, where they stand in the matrix    shifts
///   row k    [ 0 at other pivots, 1 at its own, * ..   |   U[k]   ]      U M = the left part
/// ```
///
/// A row leads at its pivot: every other column with an entry has a larger rank. The row space decides everything, so whether a monomial
/// t can be expressed by others B that are no pivots is read off: it can if t is a pivot and the other entries of its row are in B.
#[derive(Clone, Debug)]
pub struct Tableau {
    field: PrimeField,
    columns: usize,
    width: usize,
    /// Rows of `width` values, one after another.
    data: Vec<u32>,
    /// Pivot column of each row.
    pivots: Vec<usize>,
    /// The row that leads in each column.
    row_of: Vec<Option<usize>>,
    /// Where each column stands in the order.
    ranks: Vec<usize>,
}

impl Tableau {
    /// For columns in the order of their ranks, which must differ. With `tracked`, rows of the matrix that depend on lower ones take no part,
    /// and combinations are kept so that rows can be deleted.
    pub fn new(matrix: &ShiftMatrix, ranks: Vec<usize>, tracked: bool) -> Self {
        let columns = matrix.monomials.len();
        let mut order: Vec<usize> = (0..columns).collect();
        order.sort_unstable_by_key(|&column| ranks[column]);
        let mut position = vec![0; columns];
        order.iter().enumerate().for_each(|(at, &column)| position[column] = at);
        let chosen = if tracked { independent_rows(matrix) } else { (0..matrix.rows.len()).collect() };
        let width = columns + if tracked { matrix.rows.len() } else { 0 };
        let mut dense = DenseMatrix::zeros(matrix.field, chosen.len(), width);
        for (at, &row) in chosen.iter().enumerate() {
            let target = dense.row_mut(at);
            matrix.rows[row].iter().for_each(|&(column, value)| target[position[column]] = value);
            if tracked {
                target[columns + row] = 1;
            }
        }
        let leading = dense.reduce_to_echelon();
        let mut tableau = Self {
            field: matrix.field,
            columns,
            width,
            data: Vec::with_capacity(leading.len() * width),
            pivots: Vec::with_capacity(leading.len()),
            row_of: vec![None; columns],
            ranks,
        };
        for (row, &at) in leading.iter().enumerate().filter(|&(_, &at)| at < columns) {
            let from = dense.row(row);
            tableau.data.extend(position.iter().map(|&at| from[at]));
            tableau.data.extend(&from[columns..]);
            tableau.row_of[order[at]] = Some(tableau.pivots.len());
            tableau.pivots.push(order[at]);
        }
        tableau
    }

    /// Number of rows, which is the rank.
    pub fn rows(&self) -> usize {
        self.pivots.len()
    }

    /// The pivot columns, in no particular order.
    pub fn pivots(&self) -> &[usize] {
        &self.pivots
    }

    /// Whether a row leads in the column.
    pub fn is_pivot(&self, column: usize) -> bool {
        self.row_of[column].is_some()
    }

    /// The other columns with an entry in the row that leads in `column`; `None` where none leads.
    pub fn dependence(&self, column: usize) -> Option<impl Iterator<Item = usize> + '_> {
        let row = self.row(self.row_of[column]?);
        Some((0..self.columns).filter(move |&other| row[other] != 0 && other != column))
    }

    /// The shifts that the row that leads in `column` is made of; none where none leads.
    pub fn shifts_of(&self, column: usize) -> impl Iterator<Item = usize> + '_ {
        let combination = self.row_of[column].map_or(&[][..], |row| &self.row(row)[self.columns..]);
        combination.iter().enumerate().filter(|(_, value)| **value != 0).map(|(shift, _)| shift)
    }

    fn row(&self, row: usize) -> &[u32] {
        &self.data[row * self.width..(row + 1) * self.width]
    }

    /// Takes a shift out: of the rows that hold it the one that leads last is subtracted from the others and goes. Nothing happens if none does.
    pub fn delete_shift(&mut self, shift: usize) {
        let at = self.columns + shift;
        if let Some(row) = self.last_row_with(at, 0) {
            self.eliminate(row, at);
            self.remove_row(row);
        }
    }

    /// Moves a column forward in the order. If it was no pivot and rows that lead behind its new place have an entry there, the last
    /// of them leads there from now on.
    pub fn move_forward(&mut self, column: usize, rank: usize) {
        debug_assert!(rank < self.ranks[column]);
        self.ranks[column] = rank;
        if self.row_of[column].is_some() {
            return;
        }
        if let Some(row) = self.last_row_with(column, rank) {
            self.eliminate(row, column);
            self.row_of[self.pivots[row]] = None;
            self.row_of[column] = Some(row);
            self.pivots[row] = column;
        }
    }

    /// The row that leads last, behind `rank` or there, among those with an entry at position `at`.
    fn last_row_with(&self, at: usize, rank: usize) -> Option<usize> {
        let candidates = (0..self.rows()).filter(|&row| self.data[row * self.width + at] != 0);
        candidates
            .map(|row| (self.ranks[self.pivots[row]], row))
            .filter(|&(leading, _)| leading >= rank)
            .max()
            .map(|(_, row)| row)
    }

    /// Scales the row to 1 at position `at` and subtracts it from all others with an entry there.
    fn eliminate(&mut self, row: usize, at: usize) {
        let field = self.field;
        let inverse = field.inverse(self.row(row)[at]).unwrap_or(0);
        let pivot: Vec<u32> = self.row(row).iter().map(|&value| field.mul(value, inverse)).collect();
        for (other, entries) in self.data.chunks_exact_mut(self.width).enumerate() {
            if other == row {
                entries.copy_from_slice(&pivot);
            } else if entries[at] != 0 {
                field.add_multiple(entries, field.neg(entries[at]), &pivot);
            }
        }
    }

    fn remove_row(&mut self, row: usize) {
        let last = self.rows() - 1;
        self.row_of[self.pivots[row]] = None;
        if row != last {
            self.data.copy_within(last * self.width..(last + 1) * self.width, row * self.width);
            self.row_of[self.pivots[last]] = Some(row);
        }
        self.pivots.swap_remove(row);
        self.data.truncate(last * self.width);
    }
}

/// Rows that do not depend on lower ones.
fn independent_rows(matrix: &ShiftMatrix) -> Vec<usize> {
    let mut order: Vec<usize> = (0..matrix.rows.len()).collect();
    order.sort_unstable_by_key(|&row| (matrix.shifts[row].multiplier, matrix.shifts[row].equation));
    let mut dense = DenseMatrix::zeros(matrix.field, order.len(), matrix.monomials.len());
    for (at, &row) in order.iter().enumerate() {
        let target = dense.row_mut(at);
        matrix.rows[row].iter().for_each(|&(column, value)| target[column] = value);
    }
    dense.independent_rows().into_iter().map(|at| order[at]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{PRIMES, Polynomial};
    use crate::instance::{Draw, Random};
    use crate::template::grow::{Growth, Shifts, monomials_up_to};

    const UNKNOWNS: [usize; 2] = [0, 1];

    /// Two quadrics and their multiples by the unknowns: rows that are independent.
    fn matrix(random: &mut Random) -> ShiftMatrix {
        let field = PrimeField::new(PRIMES[0]);
        let mut quadric = || {
            let monomials = monomials_up_to(&UNKNOWNS, &[1, 1], 2);
            Polynomial::from_terms(monomials.into_iter().map(|m| (m, field.draw(random))).collect())
        };
        let equations = [quadric(), quadric()];
        let shifts = Shifts::new(&equations, &UNKNOWNS, Growth::Degree(vec![1, 1]), 100).nth(1).unwrap();
        ShiftMatrix::new(field, &equations, &shifts)
    }

    /// Pivot and entries of each row, in the order of the columns.
    fn content(tableau: &Tableau) -> Vec<(usize, Vec<u32>)> {
        let mut rows: Vec<_> = (0..tableau.rows())
            .map(|row| (tableau.ranks[tableau.pivots[row]], tableau.row(row)[..tableau.columns].to_vec()))
            .collect();
        rows.sort_unstable();
        rows
    }

    #[test]
    fn updates_give_what_a_new_elimination_gives() {
        let mut random = Random::new(1);
        for _ in 0..50 {
            let mut matrix = matrix(&mut random);
            let columns = matrix.monomials.len();
            let ranks: Vec<usize> = (columns..2 * columns).collect();
            let mut tableau = Tableau::new(&matrix, ranks.clone(), true);
            let mut ranks = ranks;
            let mut kept = vec![true; matrix.rows.len()];
            for step in 0..6 {
                let column = random.below(columns as u64) as usize;
                if ranks[column] >= columns {
                    ranks[column] = step;
                    tableau.move_forward(column, step);
                }
                let row = random.below(matrix.rows.len() as u64) as usize;
                kept[row] = false;
                tableau.delete_shift(row);
            }
            matrix.rows.iter_mut().zip(&kept).filter(|(_, kept)| !**kept).for_each(|(row, _)| row.clear());
            assert_eq!(content(&tableau), content(&Tableau::new(&matrix, ranks, false)));
        }
    }

    #[test]
    fn rows_are_the_combinations_of_shifts_that_they_say() {
        let matrix = matrix(&mut Random::new(2));
        let columns = matrix.monomials.len();
        let mut tableau = Tableau::new(&matrix, (columns..2 * columns).collect(), true);
        tableau.delete_shift(3);
        tableau.move_forward(columns - 1, 0);
        for row in 0..tableau.rows() {
            let mut sum = vec![0; columns];
            for (shift, &factor) in tableau.row(row)[columns..].iter().enumerate() {
                for &(column, value) in &matrix.rows[shift] {
                    sum[column] = matrix.field.add(sum[column], matrix.field.mul(factor, value));
                }
            }
            assert_eq!(sum, tableau.row(row)[..columns]);
            assert!(tableau.shifts_of(tableau.pivots[row]).all(|shift| shift != 3));
        }
    }
}
