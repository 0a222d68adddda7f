//! Eigenvalues and eigenvectors of the action matrices of interpreted solvers, by their Schur form.

use nalgebra::{Complex, DMatrix, DVector, Schur};

/// QR iterations for each eigenvalue at most, where there is another way to go on.
const MAX_ITERATIONS: usize = 30;
/// QR iterations at most in the end.
const LAST_ITERATIONS: usize = 10_000;

/// A matrix as Q T Q*, with T upper triangular.
pub(super) struct SchurForm {
    q: DMatrix<Complex<f64>>,
    t: DMatrix<Complex<f64>>,
}

impl SchurForm {
    /// Of a real matrix. The real iteration takes a quarter of the time of the complex one, which is there for where it stalls.
    pub(super) fn of_real(matrix: &DMatrix<f64>) -> Option<Self> {
        match Schur::try_new(matrix.clone(), f64::EPSILON, MAX_ITERATIONS * matrix.nrows()) {
            Some(schur) => {
                let (q, t) = schur.unpack();
                let mut form = Self { q: q.map(Complex::from), t: t.map(Complex::from) };
                (1..matrix.nrows()).rev().for_each(|row| form.rotate(row));
                Some(form)
            }
            None => Self::new(&matrix.map(Complex::from)),
        }
    }

    /// In complex arithmetic. Where the iteration stalls, as it can on spectra that are symmetric about zero, a complex shift breaks the symmetry.
    pub(super) fn new(matrix: &DMatrix<Complex<f64>>) -> Option<Self> {
        let n = matrix.nrows();
        let shift = Complex::new(0.3, 0.7) * matrix.norm();
        [(Complex::ZERO, MAX_ITERATIONS * n), (shift, LAST_ITERATIONS)].into_iter().find_map(|(shift, iterations)| {
            let shifted = matrix + DMatrix::from_diagonal_element(n, n, shift);
            let (q, t) = Schur::try_new(shifted, f64::EPSILON, iterations)?.unpack();
            Some(Self { q, t: t - DMatrix::from_diagonal_element(n, n, shift) })
        })
    }

    /// Makes T zero below the diagonal in this row by a rotation of it and the row above:
    ///
    /// ```text
    ///   [ a b ]      [ u*  v ] [ a b ] [ u  -v ]
    ///   [ c d ]  ->  [ -v  u ] [ c d ] [ v  u* ]      (u, v) along (l - d, c) for an eigenvalue l
    /// ```
    fn rotate(&mut self, row: usize) {
        let above = row - 1;
        let block = |i: usize, j: usize| self.t[(i, j)];
        let (b, c, d) = (block(above, row), block(row, above), block(row, row));
        if c == Complex::ZERO {
            return;
        }
        let half = (block(above, above) - d) * 0.5;
        let root = (half * half + b * c).sqrt();
        let (plus, minus) = (half + root, half - root);
        let difference = if plus.norm() >= minus.norm() { plus } else { minus };
        let length = difference.norm().hypot(c.norm());
        let (u, v) = (difference / length, c / length);
        for column in above..self.t.ncols() {
            let (x, y) = (self.t[(above, column)], self.t[(row, column)]);
            self.t[(above, column)] = u.conj() * x + v * y;
            self.t[(row, column)] = u * y - v * x;
        }
        let rotate_columns = |matrix: &mut DMatrix<Complex<f64>>, rows: usize| {
            for i in 0..rows {
                let (x, y) = (matrix[(i, above)], matrix[(i, row)]);
                matrix[(i, above)] = x * u + y * v;
                matrix[(i, row)] = y * u.conj() - x * v;
            }
        };
        rotate_columns(&mut self.t, row + 1);
        let rows = self.q.nrows();
        rotate_columns(&mut self.q, rows);
        self.t[(row, above)] = Complex::ZERO;
    }

    pub(super) fn values(&self) -> DVector<Complex<f64>> {
        self.t.diagonal()
    }

    /// Two steps of inverse iteration. The eigenvalue is moved by a few units of rounding, further where the shifted matrix is still singular to
    /// the last bit.
    pub(super) fn vector(&self, value: Complex<f64>) -> Option<DVector<Complex<f64>>> {
        let unit = self.t.norm().max(f64::MIN_POSITIVE) * f64::EPSILON;
        let factors = [1.0, 4.0, 16.0, 64.0].into_iter();
        factors.map(|factor| value + factor * unit).find_map(|shift| self.inverse_iteration(shift))
    }

    fn inverse_iteration(&self, shift: Complex<f64>) -> Option<DVector<Complex<f64>>> {
        let n = self.t.nrows();
        let mut vector = DVector::from_fn(n, |i, _| Complex::new(1.0 / (1.0 + i as f64), 0.0));
        for _ in 0..2 {
            for i in (0..n).rev() {
                let pivot = self.t[(i, i)] - shift;
                if pivot == Complex::ZERO {
                    return None;
                }
                let solved = vector[i] / pivot;
                vector[i] = solved;
                let column = self.t.column(i);
                vector.rows_mut(0, i).axpy(-solved, &column.rows(0, i), Complex::ONE);
            }
            let norm = vector.norm();
            if !(norm.is_finite() && norm > 0.0) {
                return None;
            }
            vector /= Complex::new(norm, 0.0);
        }
        Some(&self.q * vector)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// || M Q - Q T || relative to || M ||, and the largest entry of T below the diagonal.
    fn errors(matrix: &DMatrix<f64>, form: &SchurForm) -> (f64, f64) {
        let matrix = matrix.map(Complex::from);
        let below = (0..matrix.nrows()).flat_map(|i| (0..i).map(move |j| (i, j))).map(|at| form.t[at].norm());
        ((&matrix * &form.q - &form.q * &form.t).norm() / matrix.norm(), below.fold(0.0, f64::max))
    }

    #[test]
    fn a_real_matrix_becomes_triangular() {
        for n in 1..20 {
            // Most of these have real and complex eigenvalues.
            let matrix = DMatrix::from_fn(n, n, |i, j| ((1 + i * i + 5 * i * j + 3 * j) as f64).sqrt().fract() - 0.5);
            let form = SchurForm::of_real(&matrix).unwrap();
            let (error, below) = errors(&matrix, &form);
            let rounding = 10.0 * n as f64 * f64::EPSILON;
            assert!(error < rounding && below == 0.0, "{n}: {error:e} {below:e}");
            for &value in form.values().iter() {
                let vector = form.vector(value).unwrap();
                let residual = (matrix.map(Complex::from) * &vector - &vector * value).norm();
                assert!(residual < rounding * matrix.norm(), "{n}: {residual:e}");
            }
        }
    }

    #[test]
    fn a_cyclic_permutation_does_not_stall() {
        // Its eigenvalues are the roots of unity: shifts of the real iteration stay at zero.
        for n in 3..12 {
            let matrix = DMatrix::from_fn(n, n, |i, j| f64::from(u8::from((i + 1) % n == j)));
            let form = SchurForm::of_real(&matrix).unwrap();
            assert!(form.values().iter().all(|value| (value.norm() - 1.0).abs() < 1e-13), "{n}");
        }
    }
}
