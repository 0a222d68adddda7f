//! Dense matrices over Z_p.

use super::{Echelon, PrimeField};

/// A dense matrix over Z_p, row by row.
///
/// ```text
///            column 0   1   2   ..
///   row 0         [ d0  d1  d2  .. ]      entry (i, j) = data[i * columns + j], in 0..p
///   row 1         [ dc  ..         ]
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DenseMatrix {
    field: PrimeField,
    rows: usize,
    columns: usize,
    data: Vec<u32>,
}

impl DenseMatrix {
    /// The zero matrix.
    pub fn zeros(field: PrimeField, rows: usize, columns: usize) -> Self {
        Self { field, rows, columns, data: vec![0; rows * columns] }
    }

    /// The identity.
    pub fn identity(field: PrimeField, size: usize) -> Self {
        let mut matrix = Self::zeros(field, size, size);
        for i in 0..size {
            matrix.row_mut(i)[i] = 1;
        }
        matrix
    }

    /// From rows of `columns` values each; shorter rows are filled up with zeros, longer ones cut.
    pub fn from_rows<R: AsRef<[u32]>>(field: PrimeField, columns: usize, rows: &[R]) -> Self {
        let mut matrix = Self::zeros(field, rows.len(), columns);
        for (i, row) in rows.iter().enumerate() {
            debug_assert_eq!(row.as_ref().len(), columns);
            matrix.row_mut(i).iter_mut().zip(row.as_ref()).for_each(|(entry, &value)| *entry = value);
        }
        matrix
    }

    /// The field of the entries.
    pub fn field(&self) -> PrimeField {
        self.field
    }

    /// The number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// The number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// One row.
    #[inline]
    pub fn row(&self, row: usize) -> &[u32] {
        &self.data[row * self.columns..(row + 1) * self.columns]
    }

    /// One row, to write.
    #[inline]
    pub fn row_mut(&mut self, row: usize) -> &mut [u32] {
        &mut self.data[row * self.columns..(row + 1) * self.columns]
    }

    /// One entry.
    #[inline]
    pub fn get(&self, row: usize, column: usize) -> u32 {
        self.row(row)[column]
    }

    /// The matrix product; `None` where the shapes do not fit.
    pub fn times(&self, other: &Self) -> Option<Self> {
        if self.columns != other.rows {
            return None;
        }
        let mut product = Self::zeros(self.field, self.rows, other.columns);
        for i in 0..self.rows {
            let row = self.row_times(self.row(i), other);
            product.row_mut(i).copy_from_slice(&row);
        }
        Some(product)
    }

    fn row_times(&self, left: &[u32], other: &Self) -> Vec<u32> {
        let mut row = vec![0; other.columns];
        for (k, &factor) in left.iter().enumerate().filter(|&(_, &factor)| factor != 0) {
            for (entry, &value) in row.iter_mut().zip(other.row(k)) {
                *entry = self.field.add(*entry, self.field.mul(factor, value));
            }
        }
        row
    }

    /// Brings the matrix to reduced row echelon form: leading entries 1, pivot columns zero elsewhere, rows by increasing pivot
    /// column, zero rows removed. Returns the pivot columns; the matrix keeps as many rows.
    pub fn reduce_to_echelon(&mut self) -> Vec<usize> {
        // The result does not depend on the order of the rows; short rows make cheap pivots.
        let mut order: Vec<(usize, usize)> =
            (0..self.rows).map(|i| (self.row(i).iter().filter(|&&value| value != 0).count(), i)).collect();
        order.sort_unstable();
        let mut echelon = Echelon::new(self.field, self.columns);
        for (_, i) in order {
            echelon.insert_dense(self.row(i));
        }
        echelon.back_reduce();
        *self = echelon.to_dense();
        echelon.pivot_columns()
    }

    /// The rows, scanned from the top, that are independent of the rows kept before them.
    pub fn independent_rows(&self) -> Vec<usize> {
        let mut echelon = Echelon::new(self.field, self.columns);
        (0..self.rows).filter(|&i| echelon.insert_dense(self.row(i)).is_some()).collect()
    }
}
