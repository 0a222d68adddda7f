//! A reduced echelon form that is kept up to date while rows of the matrix are deleted and columns
//! are given up.
//!
//! Each change costs one row operation for each row that is kept. A new elimination would cost one
//! for each pair of rows of the matrix.

use std::sync::atomic::AtomicBool;

use super::index_set::IndexSet;
use super::monitor::is_set;
use crate::algebra::{Echelon, PrimeField};
use crate::template::shift_matrix::ShiftMatrix;

/// The rows of the reduced echelon form of a [`ShiftMatrix`] that do not lead in the excess, each
/// with the combination of shifts that gives it.
///
/// ```text
///            excess      other columns, by rank          shifts
///   row 1  [ 0 ... 0  |  1  0  *  0  *  *  ...  *  |  u11  u12  ...  ]
///   row 2  [ 0 ... 0  |  0  1  *  0  *  *  ...  *  |  u21  u22  ...  ]
///   row 3  [ 0 ... 0  |  0  0  0  1  *  *  ...  *  |  u31  u32  ...  ]
///                        ^  ^     ^  pivots
/// ```
///
/// With M for the rows of the matrix, U M is the left part.
///
/// The columns are ordered by rank, and the excess comes first. A row leads at its pivot: it is 1
/// there, all other entries of the row have a larger rank, and all other rows are 0 in that column.
/// Such a form is determined by the row space and the order. It tells what is expressible: a
/// monomial t is a combination of monomials B that are no pivots if and only if t is a pivot and
/// all other entries of its row are in B.
///
/// Rows that lead in the excess are not kept, and they are most of the matrix. They are of no use
/// for the others: a row that is kept is 0 in all excess columns, and each change adds kept rows to
/// kept rows only.
#[derive(Clone, Debug)]
pub struct Tableau {
    field: PrimeField,
    /// The columns of the matrix that have an entry in some row at the start, by their position
    /// here. Changes only add rows to rows, so no other column ever gets an entry.
    columns: Vec<usize>,
    /// Position of each column of the matrix among `columns`.
    place: Vec<Option<usize>>,
    /// The shifts, by their position behind the columns.
    shifts: Vec<usize>,
    /// Position of each shift, counted from the first column.
    place_of_shift: Vec<Option<usize>>,
    /// The rows one after another, each with a value for every one of `columns` and `shifts`.
    data: Vec<u32>,
    /// Pivot column of each row.
    pivots: Vec<usize>,
    /// The row that leads in each column.
    row_of: Vec<Option<usize>>,
    /// Rank of each column.
    ranks: Vec<usize>,
}

impl Tableau {
    /// The tableau of some rows of the matrix, which must be independent. Ranks must differ;
    /// columns of rank below `excess` are the excess. `None` if the flag was set meanwhile.
    pub fn new(
        matrix: &ShiftMatrix,
        rows: &[usize],
        ranks: Vec<usize>,
        excess: usize,
        interruption: Option<&AtomicBool>,
    ) -> Option<Self> {
        let count = matrix.monomials.len();
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_unstable_by_key(|&column| ranks[column]);
        let mut position = vec![0; count];
        order.iter().enumerate().for_each(|(at, &column)| position[column] = at);
        // Each row carries a unit vector behind its columns, which elimination turns into its
        // combination of shifts.
        let width = count + rows.len();
        let mut echelon = Echelon::new(matrix.field, width);
        for (at, &row) in rows.iter().enumerate() {
            if is_set(interruption) {
                return None;
            }
            let mut entries: Vec<(u32, u32)> =
                matrix.rows[row].iter().map(|&(column, value)| (position[column] as u32, value)).collect();
            entries.push(((count + at) as u32, 1));
            echelon.insert_sparse(&entries);
        }
        let is_kept = |at: &usize| *at < count && ranks[order[*at]] >= excess;
        let leading: Vec<usize> = echelon.pivot_columns().into_iter().filter(is_kept).collect();
        // Back substitution, from the last row up: each row is reduced by all that lead behind it.
        // Only kept rows take part, which is what makes it cheap.
        let mut reduced = Echelon::new(matrix.field, width);
        for &at in leading.iter().rev() {
            if is_set(interruption) {
                return None;
            }
            reduced.insert_sparse_reduced(&echelon.row(at));
        }
        let kept: Vec<(usize, Vec<(u32, u32)>)> = leading.iter().map(|&at| (order[at], reduced.row(at))).collect();
        let mut is_used = vec![false; width];
        kept.iter().flat_map(|(_, row)| row).for_each(|&(at, _)| is_used[at as usize] = true);
        let columns: Vec<usize> = (0..count).filter(|&column| is_used[position[column]]).collect();
        let shifts: Vec<usize> = (count..width).filter(|&at| is_used[at]).map(|at| rows[at - count]).collect();
        let mut tableau = Self {
            field: matrix.field,
            place: inverse(&columns, 0, count),
            place_of_shift: inverse(&shifts, columns.len(), matrix.rows.len()),
            data: Vec::with_capacity(kept.len() * (columns.len() + shifts.len())),
            pivots: kept.iter().map(|&(column, _)| column).collect(),
            row_of: inverse(&kept.iter().map(|&(column, _)| column).collect::<Vec<_>>(), 0, count),
            columns,
            shifts,
            ranks,
        };
        for (_, row) in &kept {
            let start = tableau.data.len();
            tableau.data.resize(start + tableau.width(), 0);
            for &(at, value) in row {
                let at = at as usize;
                let place =
                    if at < count { tableau.place[order[at]] } else { tableau.place_of_shift[rows[at - count]] };
                if let Some(place) = place {
                    tableau.data[start + place] = value;
                }
            }
        }
        Some(tableau)
    }

    /// The same tableau with the combinations of these shifts only.
    ///
    /// The left part decides what is expressible, and deleting a shift needs only that shift's part
    /// of the combinations. Most of the work of a change is in the combinations, so a deletion can
    /// be tested on this part much faster.
    pub(super) fn narrowed(&self, shifts: &[usize]) -> Self {
        let shifts: Vec<usize> = shifts.iter().copied().filter(|&shift| self.place_of_shift[shift].is_some()).collect();
        let mut data = Vec::with_capacity(self.rows() * (self.columns.len() + shifts.len()));
        for row in self.data.chunks_exact(self.width().max(1)) {
            data.extend_from_slice(&row[..self.columns.len()]);
            data.extend(shifts.iter().filter_map(|&shift| self.place_of_shift[shift]).map(|at| row[at]));
        }
        Self {
            field: self.field,
            columns: self.columns.clone(),
            place: self.place.clone(),
            place_of_shift: inverse(&shifts, self.columns.len(), self.place_of_shift.len()),
            shifts,
            data,
            pivots: self.pivots.clone(),
            row_of: self.row_of.clone(),
            ranks: self.ranks.clone(),
        }
    }

    fn width(&self) -> usize {
        self.columns.len() + self.shifts.len()
    }

    /// Number of rows.
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

    /// The other columns with an entry in the row that leads in `column`; `None` if no row leads
    /// there.
    pub fn dependence(&self, column: usize) -> Option<impl Iterator<Item = usize> + '_> {
        let entries = &self.row(self.row_of[column]?)[..self.columns.len()];
        let others = entries.iter().zip(&self.columns).filter(|&(value, _)| *value != 0).map(|(_, &other)| other);
        Some(others.filter(move |&other| other != column))
    }

    /// The shifts that the row that leads in `column` is a combination of. The set is empty if no
    /// row leads there.
    pub(super) fn shifts_of(&self, column: usize) -> IndexSet {
        let mut shifts = self.no_shifts();
        if let Some(row) = self.row_of[column] {
            let combination = self.row(row)[self.columns.len()..].iter().zip(&self.shifts);
            combination.filter(|(value, _)| **value != 0).for_each(|(_, &shift)| {
                shifts.insert(shift);
            });
        }
        shifts
    }

    /// The empty set of shifts.
    pub(super) fn no_shifts(&self) -> IndexSet {
        IndexSet::new(self.place_of_shift.len())
    }

    fn row(&self, row: usize) -> &[u32] {
        &self.data[row * self.width()..(row + 1) * self.width()]
    }

    /// Deletes a shift.
    ///
    /// The rows that are left span the combinations in which the shift has coefficient 0. The row
    /// that leads last among those with the shift is subtracted from the others and removed. It
    /// must be the last one: subtracting it changes the other rows at and behind its pivot only, so
    /// that they still lead where they did.
    pub fn delete_shift(&mut self, shift: usize) {
        if let Some(at) = self.place_of_shift[shift] {
            self.remove_last_row_with(at, None);
        }
    }

    /// Moves a column to the end of the excess.
    ///
    /// If a row leads there it is removed: it leads in the excess now. Otherwise the last row with
    /// an entry in the column is subtracted from the others, which makes them 0 there, and is
    /// removed.
    pub fn give_up(&mut self, column: usize) {
        if let Some(at) = self.place[column] {
            self.remove_last_row_with(at, self.row_of[column]);
        }
    }

    /// Moves a column that is not in the excess forward in the order.
    ///
    /// If the column is no pivot, and rows that lead behind its new place have an entry in it, the
    /// last of these rows leads there from now on. Rows that lead before the new place keep their
    /// pivots.
    pub fn move_forward(&mut self, column: usize, rank: usize) {
        debug_assert!(rank <= self.ranks[column]);
        self.ranks[column] = rank;
        let (None, Some(at)) = (self.row_of[column], self.place[column]) else { return };
        if let Some(row) = self.last_row_with(at, rank) {
            self.eliminate(row, at);
            self.row_of[self.pivots[row]] = None;
            self.row_of[column] = Some(row);
            self.pivots[row] = column;
        }
    }

    fn remove_last_row_with(&mut self, at: usize, known: Option<usize>) {
        if let Some(row) = known.or_else(|| self.last_row_with(at, 0)) {
            self.eliminate(row, at);
            self.remove_row(row);
        }
    }

    /// The row that leads last among those with an entry at position `at` and a pivot of at least
    /// this rank.
    fn last_row_with(&self, at: usize, rank: usize) -> Option<usize> {
        let width = self.width();
        let candidates = (0..self.rows()).filter(|&row| self.data[row * width + at] != 0);
        candidates
            .map(|row| (self.ranks[self.pivots[row]], row))
            .filter(|&(leading, _)| leading >= rank)
            .max()
            .map(|(_, row)| row)
    }

    /// Scales the row to 1 at position `at` and subtracts it from all others with an entry there.
    fn eliminate(&mut self, row: usize, at: usize) {
        let (field, width) = (self.field, self.width());
        let inverse = field.inverse(self.row(row)[at]).unwrap_or(0);
        let pivot: Vec<u32> = self.row(row).iter().map(|&value| field.mul(value, inverse)).collect();
        for (other, entries) in self.data.chunks_exact_mut(width).enumerate() {
            if other == row {
                entries.copy_from_slice(&pivot);
            } else if entries[at] != 0 {
                field.add_multiple(entries, field.neg(entries[at]), &pivot);
            }
        }
    }

    fn remove_row(&mut self, row: usize) {
        let (last, width) = (self.rows() - 1, self.width());
        self.row_of[self.pivots[row]] = None;
        if row != last {
            self.data.copy_within(last * width..(last + 1) * width, row * width);
            self.row_of[self.pivots[last]] = Some(row);
        }
        self.pivots.swap_remove(row);
        self.data.truncate(last * width);
    }
}

/// The position of each of `count` indices in a list, counted from `first`.
fn inverse(list: &[usize], first: usize, count: usize) -> Vec<Option<usize>> {
    let mut place = vec![None; count];
    list.iter().enumerate().for_each(|(at, &index)| place[index] = Some(first + at));
    place
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{PRIMES, Polynomial, Random};
    use crate::problem::draw::Draw;
    use crate::search::grow::{Growth, Shifts, monomials_up_to};

    const UNKNOWNS: [usize; 2] = [0, 1];

    /// Two quadrics and their multiples by the unknowns. The rows are independent.
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
        let entry = |row: usize, column: usize| tableau.place[column].map_or(0, |at| tableau.row(row)[at]);
        let mut rows: Vec<_> = (0..tableau.rows())
            .map(|row| {
                let entries = (0..tableau.place.len()).map(|column| entry(row, column)).collect();
                (tableau.ranks[tableau.pivots[row]], entries)
            })
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
            let all: Vec<usize> = (0..matrix.rows.len()).collect();
            // Columns of rank below `columns` are the excess. Columns of rank 2 * columns and above
            // have not moved yet.
            let mut ranks: Vec<usize> =
                (0..columns).map(|at| if at % 7 == 0 { at } else { 2 * columns + at }).collect();
            let mut tableau = Tableau::new(&matrix, &all, ranks.clone(), columns, None).unwrap();
            let mut kept = vec![true; matrix.rows.len()];
            for step in 0..4 {
                let column = random.below(columns as u64) as usize;
                if ranks[column] >= 2 * columns {
                    ranks[column] = columns + step;
                    tableau.move_forward(column, columns + step);
                }
                let row = random.below(matrix.rows.len() as u64) as usize;
                kept[row] = false;
                tableau.delete_shift(row);
                let column = random.below(columns as u64) as usize;
                ranks[column] = column;
                tableau.give_up(column);
            }
            matrix.rows.iter_mut().zip(&kept).filter(|(_, kept)| !**kept).for_each(|(row, _)| row.clear());
            assert_eq!(content(&tableau), content(&Tableau::new(&matrix, &all, ranks, columns, None).unwrap()));
        }
    }

    #[test]
    fn rows_are_the_combinations_of_shifts_that_they_say() {
        let matrix = matrix(&mut Random::new(2));
        let columns = matrix.monomials.len();
        let all: Vec<usize> = (0..matrix.rows.len()).collect();
        let mut tableau = Tableau::new(&matrix, &all, (columns + 1..2 * columns + 1).collect(), columns, None).unwrap();
        tableau.delete_shift(3);
        tableau.give_up(1);
        tableau.move_forward(columns - 1, columns);
        assert!(tableau.rows() > 2);
        for row in 0..tableau.rows() {
            let mut sum = vec![0; columns];
            for (&shift, &factor) in tableau.shifts.iter().zip(&tableau.row(row)[tableau.columns.len()..]) {
                for &(column, value) in &matrix.rows[shift] {
                    sum[column] = matrix.field.add(sum[column], matrix.field.mul(factor, value));
                }
            }
            // The column that was given up is 0 in all rows, and so is the excess.
            let entries = (0..columns).map(|column| tableau.place[column].map_or(0, |at| tableau.row(row)[at]));
            assert!(sum.iter().copied().eq(entries));
            assert!(tableau.shifts_of(tableau.pivots[row]).iter().all(|shift| shift != 3));
        }
    }
}
