//! Row echelon form over Z_p, for sparse and dense rows alike.
//!
//! A row is reduced in a dense accumulator of 64-bit integers, with the delayed reduction of F4
//! implementations (Monagan & Pearce, "A compact parallel implementation of F4", PASCO 2015).
//! Entries are kept in `0..p^2`, which is below 2^62:
//!
//! ```text
//!   entry - c v            c, v < p, so c v < p^2: the result is above -p^2, and fits 64 bits
//!   + p^2 if negative      no division: p^2 is 0 modulo p, and the entry is in 0..p^2 again
//! ```
//!
//! So an entry is divided by p once per row, and not once for each row that is subtracted. Finished
//! rows are stored sparse, or dense from their pivot on if they have filled in.

use super::PrimeField;

/// Rows in echelon form, built by inserting one row at a time.
///
/// ```text
///             column 0 1 2 3 4 5 6
///  pivot at 0      [ 1 * . * * . * ]     . zero, * anything
///  pivot at 1      [   1 * . * * . ]
///  pivot at 4      [         1 * * ]
/// ```
///
/// Every row has leading entry 1, and no two rows lead in the same column. After
/// [`Echelon::back_reduce`] a pivot column is zero outside its own row: the reduced row echelon
/// form, which depends on the row space only.
#[derive(Clone, Debug)]
pub struct Echelon {
    field: PrimeField,
    /// The pivot row that leads in a column, an index into `rows`, or [`NO_ROW`].
    row_of_column: Vec<u32>,
    rows: Vec<PivotRow>,
    /// The row that is being reduced: one entry in `0..p^2` per column. All entries are zero
    /// between calls.
    accumulator: Vec<i64>,
}

const NO_ROW: u32 = u32::MAX;

/// A stored row with leading entry 1.
#[derive(Clone, Debug)]
enum PivotRow {
    /// Increasing columns and their nonzero values.
    Sparse { columns: Vec<u32>, values: Vec<u32> },
    /// All values from column `first`, where the row leads, to its last nonzero one.
    Dense { first: usize, values: Vec<u32> },
}

impl PivotRow {
    fn leading_column(&self) -> usize {
        match self {
            Self::Sparse { columns, .. } => columns.first().map_or(0, |&column| column as usize),
            Self::Dense { first, .. } => *first,
        }
    }

    /// Calls `visit` with every column, in increasing order, and its nonzero value.
    fn for_each(&self, mut visit: impl FnMut(usize, u32)) {
        match self {
            Self::Sparse { columns, values } => {
                for (&column, &value) in columns.iter().zip(values) {
                    visit(column as usize, value);
                }
            }
            Self::Dense { first, values } => {
                for (offset, &value) in values.iter().enumerate().filter(|&(_, &value)| value != 0) {
                    visit(first + offset, value);
                }
            }
        }
    }

    /// accumulator -= factor * row. Entries stay in `0..square`, where `square` is p^2.
    #[inline]
    fn subtract_from(&self, accumulator: &mut [i64], factor: u32, square: i64) {
        let factor = u64::from(factor);
        let update = |entry: &mut i64, value: u32| {
            // The shifted sign is all ones for a negative difference and 0 otherwise: no branch.
            let difference = *entry - (factor * u64::from(value)) as i64;
            *entry = difference + ((difference >> 63) & square);
        };
        match self {
            Self::Sparse { columns, values } => {
                for (&column, &value) in columns.iter().zip(values) {
                    update(&mut accumulator[column as usize], value);
                }
            }
            Self::Dense { first, values } => {
                for (entry, &value) in accumulator[*first..].iter_mut().zip(values) {
                    update(entry, value);
                }
            }
        }
    }
}

/// How far a row is reduced before it is stored.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Reduction {
    /// A row is reduced until its leading entry is in no pivot column.
    Head,
    /// A row is reduced until none of its entries is in a pivot column.
    Full,
}

impl Echelon {
    /// The empty echelon of rows with this many columns.
    pub fn new(field: PrimeField, columns: usize) -> Self {
        Self { field, row_of_column: vec![NO_ROW; columns], rows: Vec::new(), accumulator: vec![0; columns] }
    }

    /// The field of the entries.
    pub fn field(&self) -> PrimeField {
        self.field
    }

    /// The number of columns.
    pub fn columns(&self) -> usize {
        self.row_of_column.len()
    }

    /// The number of rows, which are independent.
    pub fn rank(&self) -> usize {
        self.rows.len()
    }

    /// Whether some row leads in this column.
    pub fn is_pivot(&self, column: usize) -> bool {
        self.row_of_column[column] != NO_ROW
    }

    /// The columns in which rows lead, increasing.
    pub fn pivot_columns(&self) -> Vec<usize> {
        (0..self.columns()).filter(|&column| self.is_pivot(column)).collect()
    }

    /// Reduces a row by the rows present. It is given by distinct columns in any order, with values
    /// in `0..p`. If it is independent of them it becomes a row, and the column in which it leads
    /// is returned.
    pub fn insert_sparse(&mut self, row: &[(u32, u32)]) -> Option<usize> {
        self.load_sparse(row);
        self.insert_accumulator(Reduction::Head)
    }

    /// As [`Echelon::insert_sparse`], for a row of [`Echelon::columns`] values.
    pub fn insert_dense(&mut self, row: &[u32]) -> Option<usize> {
        self.load_dense(row);
        self.insert_accumulator(Reduction::Head)
    }

    /// As [`Echelon::insert_sparse`], but the stored row has no entry in the pivot columns of the
    /// others.
    pub fn insert_sparse_reduced(&mut self, row: &[(u32, u32)]) -> Option<usize> {
        self.load_sparse(row);
        self.insert_accumulator(Reduction::Full)
    }

    /// Adds a row without reducing it. Its columns increase, its values are not zero, and the first
    /// is 1 and in no pivot column.
    #[cfg(feature = "search")]
    pub(super) fn push_pivot(&mut self, columns: Vec<u32>, values: Vec<u32>) {
        debug_assert!(columns.windows(2).all(|pair| pair[0] < pair[1]) && values.first() == Some(&1));
        if let Some(&leading) = columns.first() {
            debug_assert!(!self.is_pivot(leading as usize));
            self.row_of_column[leading as usize] = self.rows.len() as u32;
            self.rows.push(PivotRow::Sparse { columns, values });
        }
    }

    /// Replaces a row of [`Echelon::columns`] values by its remainder modulo the row space, which
    /// is zero in all pivot columns.
    pub fn reduce_dense(&mut self, row: &mut [u32]) {
        self.load_dense(row);
        self.reduce_accumulator(Reduction::Full);
        for (value, entry) in row.iter_mut().zip(&mut self.accumulator) {
            // A full reduction leaves every entry below p.
            *value = std::mem::take(entry) as u32;
        }
    }

    /// Clears the pivot columns above the pivots: the reduced row echelon form.
    pub fn back_reduce(&mut self) {
        for column in
            (0..self.columns()).rev().filter(|&column| self.row_of_column[column] != NO_ROW).collect::<Vec<_>>()
        {
            self.back_reduce_row(column);
        }
    }

    /// Clears the entries of the row that leads in `column` in the other rows' pivot columns.
    pub(super) fn back_reduce_row(&mut self, column: usize) {
        let row = self.row_of_column[column];
        let mut touched = false;
        self.rows[row as usize].for_each(|at, _| touched |= at != column && self.row_of_column[at] != NO_ROW);
        if touched {
            // The row is taken out of the echelon meanwhile, or it would be subtracted from itself.
            let accumulator = &mut self.accumulator;
            self.rows[row as usize].for_each(|at, value| accumulator[at] = i64::from(value));
            self.row_of_column[column] = NO_ROW;
            self.reduce_accumulator(Reduction::Full);
            self.row_of_column[column] = row;
            self.rows[row as usize] = self.take_accumulator(column);
        }
    }

    /// The entries of the row that leads in `column`: increasing columns and nonzero values, the
    /// first of which is 1. The list is empty if no row leads there.
    pub fn row(&self, column: usize) -> Vec<(u32, u32)> {
        let mut entries = Vec::new();
        if let Some(row) = self.rows.get(self.row_of_column[column] as usize) {
            row.for_each(|column, value| entries.push((column as u32, value)));
        }
        entries
    }

    fn load_sparse(&mut self, row: &[(u32, u32)]) {
        for &(column, value) in row {
            self.accumulator[column as usize] = i64::from(value);
        }
    }

    fn load_dense(&mut self, row: &[u32]) {
        debug_assert_eq!(row.len(), self.columns());
        for (entry, &value) in self.accumulator.iter_mut().zip(row) {
            *entry = i64::from(value);
        }
    }

    fn insert_accumulator(&mut self, reduction: Reduction) -> Option<usize> {
        let column = self.reduce_accumulator(reduction)?;
        let row = self.take_accumulator(column);
        debug_assert_eq!(row.leading_column(), column);
        self.row_of_column[column] = self.rows.len() as u32;
        self.rows.push(row);
        Some(column)
    }

    /// Subtracts pivot rows from the accumulator, from left to right. Returns the column in which
    /// the remainder leads. Entries to the left of it, and all after a full reduction, are below p.
    fn reduce_accumulator(&mut self, reduction: Reduction) -> Option<usize> {
        let square = i64::from(self.field.modulus()).pow(2);
        let mut leading = None;
        for column in 0..self.accumulator.len() {
            if self.accumulator[column] == 0 {
                continue;
            }
            let value = self.field.reduce(self.accumulator[column] as u64);
            self.accumulator[column] = i64::from(value);
            if value == 0 {
                continue;
            }
            if let Some(row) = self.rows.get(self.row_of_column[column] as usize) {
                // The pivot row has 1 in this column and zeros before it: columns to the left stay
                // final.
                row.subtract_from(&mut self.accumulator, value, square);
                debug_assert_eq!(self.accumulator[column], 0);
            } else if leading.is_none() {
                leading = Some(column);
                if reduction == Reduction::Head {
                    break;
                }
            }
        }
        leading
    }

    /// Moves the accumulator, whose first entry that is not zero is in column `first`, into a row
    /// with leading entry 1, and leaves it all zero.
    fn take_accumulator(&mut self, first: usize) -> PivotRow {
        let field = self.field;
        let scale = field.inverse(field.reduce(self.accumulator[first] as u64)).unwrap_or(1);
        let (mut columns, mut values) = (Vec::new(), Vec::new());
        for (column, entry) in self.accumulator.iter_mut().enumerate().skip(first) {
            if *entry != 0 {
                let value = field.reduce(std::mem::take(entry) as u64);
                if value != 0 {
                    columns.push(column as u32);
                    values.push(field.mul(value, scale));
                }
            }
        }
        let span = columns.last().map_or(0, |&last| last as usize + 1 - first);
        // A contiguous update costs about half of a scattered one.
        if 2 * columns.len() < span {
            return PivotRow::Sparse { columns, values };
        }
        let mut dense = vec![0; span];
        for (column, value) in columns.into_iter().zip(values) {
            dense[column as usize - first] = value;
        }
        PivotRow::Dense { first, values: dense }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{DenseMatrix, PRIMES};

    const FIELD: PrimeField = PrimeField::new(PRIMES[0]);

    #[test]
    fn a_small_matrix_by_hand() {
        let mut matrix = DenseMatrix::from_rows(FIELD, 4, &[[0, 2, 4, 6], [1, 1, 1, 1], [1, 2, 3, 4], [2, 3, 4, 6]]);
        assert_eq!(matrix.independent_rows(), [0, 1, 3]);
        let minus_one = FIELD.neg(1);
        assert_eq!(matrix.reduce_to_echelon(), [0, 1, 3]);
        assert_eq!(matrix, DenseMatrix::from_rows(FIELD, 4, &[[1, 0, minus_one, 0], [0, 1, 2, 0], [0, 0, 0, 1]]));
    }

    #[test]
    fn remainders_are_zero_in_pivot_columns() {
        let mut echelon = Echelon::new(FIELD, 3);
        assert_eq!(echelon.insert_sparse(&[(2, 5), (0, 3)]), Some(0));
        assert_eq!(echelon.insert_dense(&[6, 0, 10]), None);
        let mut row = [3, 7, 6];
        echelon.reduce_dense(&mut row);
        assert_eq!(row, [0, 7, 1]);
        assert_eq!(echelon.pivot_columns(), [0]);
    }
}
