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

    /// The matrix with these rows of `columns` values each. Shorter rows are filled up with zeros,
    /// longer ones cut.
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

    /// The matrix product; `None` if the shapes do not fit.
    pub fn times(&self, other: &Self) -> Option<Self> {
        if self.columns != other.rows {
            return None;
        }
        let mut product = Self::zeros(self.field, self.rows, other.columns);
        for i in 0..self.rows {
            product.row_mut(i).copy_from_slice(&other.row_vector_times(self.row(i)));
        }
        Some(product)
    }

    /// The product of a row vector with as many values as the matrix has rows, from the left, with
    /// the matrix.
    pub fn row_vector_times(&self, vector: &[u32]) -> Vec<u32> {
        debug_assert_eq!(vector.len(), self.rows);
        let square = u64::from(self.field.modulus()).pow(2);
        // Sums stay below p^2 < 2^62: one reduction modulo p for each entry, at the end.
        let mut sums = vec![0u64; self.columns];
        for (k, &factor) in vector.iter().enumerate().filter(|&(_, &factor)| factor != 0) {
            for (sum, &value) in sums.iter_mut().zip(self.row(k)) {
                let next = *sum + u64::from(factor) * u64::from(value);
                *sum = if next >= square { next - square } else { next };
            }
        }
        sums.into_iter().map(|sum| self.field.reduce(sum)).collect()
    }

    /// The product of the matrix with a column vector of as many values as it has columns.
    pub fn times_column(&self, vector: &[u32]) -> Vec<u32> {
        debug_assert_eq!(vector.len(), self.columns);
        (0..self.rows).map(|row| self.field.dot(self.row(row), vector)).collect()
    }

    /// The inverse; `None` for a singular matrix or one that is not square.
    pub fn inverse(&self) -> Option<Self> {
        let size = self.rows;
        if self.columns != size {
            return None;
        }
        // [A | I] reduces to [I | A^-1].
        let mut augmented = Self::zeros(self.field, size, 2 * size);
        for i in 0..size {
            let row = augmented.row_mut(i);
            row[..size].copy_from_slice(self.row(i));
            row[size + i] = 1;
        }
        let pivots = augmented.reduce_to_echelon();
        if !pivots.iter().copied().eq(0..size) {
            return None;
        }
        let mut inverse = Self::zeros(self.field, size, size);
        for i in 0..size {
            inverse.row_mut(i).copy_from_slice(&augmented.row(i)[size..]);
        }
        Some(inverse)
    }

    /// Brings the matrix to reduced row echelon form: leading entries are 1, pivot columns zero
    /// elsewhere, rows sorted by pivot column and zero rows removed. Returns the pivot columns, one
    /// for each row that is left.
    pub fn reduce_to_echelon(&mut self) -> Vec<usize> {
        // The result does not depend on the order of the rows. Short rows first: they make cheap
        // pivots.
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

impl Echelon {
    /// The rows as a dense matrix, by increasing leading column.
    pub fn to_dense(&self) -> DenseMatrix {
        let pivots = self.pivot_columns();
        let mut matrix = DenseMatrix::zeros(self.field(), pivots.len(), self.columns());
        for (at, pivot) in pivots.into_iter().enumerate() {
            let target = matrix.row_mut(at);
            self.row(pivot).into_iter().for_each(|(column, value)| target[column as usize] = value);
        }
        matrix
    }
}
