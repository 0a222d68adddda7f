//! Reduction of a real matrix to Hessenberg form.

use crate::elimination::lu::all_finite;
use crate::error::SolveError;
use crate::number::scalar::mapped;
use crate::number::sums::{folded, sum_of};
use crate::number::{Over, Real, Scalar, float};
use crate::size::{Element, Fixed, Size, Square, Vector, filled_matrix};

/// A real N x N matrix A, balanced and reduced by orthogonal similarity:
///
/// ```text
///                                 [ x x x x x ]
///   A = s * D Q H Q^T D^-1,   H = [ x x x x x ]   s, D: powers of two
///                                 [   x x x x ]   Q: product of N - 2 Householder reflections
///                                 [     x x x ]
///                                 [       x x ]
/// ```
///
/// Balancing (Parlett and Reinsch 1969, with 2-norms as James, Langou and Lowery 2014 recommend; no
/// permutation) makes the norms of row i and column i of D^-1 A D comparable, so that the errors of
/// the eigenvalue iteration are relative to the small entries, too. It is kept only if it lowers
/// the norm much. Otherwise it gains nothing and can lose all digits, because it scales up rows and
/// columns that are rounding errors (Watkins 2006). Such rows and columns exist if |B| exceeds the
/// number of solutions. The QR iteration starts from H. Eigenvectors are found on H and taken back
/// through Q and D.
pub struct Hessenberg<Z: Size, R: Element = f64> {
    /// The number of rows and columns in use.
    pub(crate) size: Z,
    /// H: zero below the subdiagonal.
    pub(crate) matrix: Square<Z, R>,
    /// The power of two taken out of A. It brings the largest entry near 1 if that was far from it.
    pub(crate) unit: f64,
    /// The diagonal of D.
    balance: Z::Vector<f64>,
    /// Row k: the vector v of the reflection I - tau v v^T that cleared column k; v lives in
    /// k+1..N, v[k+1] = 1.
    reflectors: Square<Z, R>,
    /// The tau of each reflection; 0 if the column was clear already.
    tau: Z::Vector<R>,
    /// The largest sum of moduli in a row of H.
    pub(crate) norm: f64,
}

/// The number of rows that are reflected side by side. Each sum waits for its last addition; four
/// sums do not wait for each other.
const ROWS_AT_ONCE: usize = 4;

/// Reflects M rows: row -= tau (row v) v^T.
#[inline]
fn reflect<R: Real, V: Vector<R>, const M: usize>(rows: &mut [V; M], columns: core::ops::Range<usize>, v: &V, tau: R) {
    let mut dots = [R::ZERO; M];
    for j in columns.clone() {
        for i in 0..M {
            dots[i] += rows[i][j] * v[j];
        }
    }
    for i in 0..M {
        let dot = dots[i] * tau;
        for j in columns.clone() {
            rows[i][j] -= dot * v[j];
        }
    }
}

/// Sweeps of balancing. Each sweep multiplies by powers of two only, so a few suffice, and stopping
/// early is harmless.
const BALANCE_SWEEPS: usize = 16;
/// Balancing is kept only if it lowers the norm a thousandfold.
const WORTHWHILE: f64 = 1e3;

impl<const N: usize> Hessenberg<Fixed<N>> {
    /// Balances and reduces a copy of `matrix`.
    ///
    /// # Errors
    /// [`SolveError::Overflow`] if an entry is infinite or NaN.
    #[inline]
    pub fn reduce(matrix: &[[f64; N]; N]) -> Result<Self, SolveError> {
        let mut reduced = Hessenberg::zero(Fixed);
        reduced.matrix = *matrix;
        reduced.reduce_in_place()?;
        Ok(reduced)
    }
}

impl<Z: Size, R: Real> Hessenberg<Z, R> {
    /// A zero matrix. A large matrix is filled in and reduced in place, so that it takes its size
    /// from the stack once.
    #[inline]
    pub(crate) fn zero(size: Z) -> Self {
        Hessenberg {
            size,
            matrix: filled_matrix(size, size, R::ZERO),
            unit: 1.0,
            balance: size.filled(1.0),
            reflectors: filled_matrix(size, size, R::ZERO),
            tau: size.filled(R::ZERO),
            norm: 0.0,
        }
    }

    /// Makes the matrix zero again.
    pub(crate) fn clear(&mut self) {
        self.matrix.as_mut().iter_mut().for_each(|row| row.as_mut().fill(R::ZERO));
        self.unit = 1.0;
        self.balance.as_mut().fill(1.0);
        self.reflectors.as_mut().iter_mut().for_each(|row| row.as_mut().fill(R::ZERO));
        self.tau.as_mut().fill(R::ZERO);
        self.norm = 0.0;
    }

    /// Balances and reduces the matrix, which was filled in before. Entries that are not in use are
    /// zero.
    ///
    /// # Errors
    /// [`SolveError::Overflow`] if an entry is infinite or NaN.
    pub(crate) fn reduce_in_place(&mut self) -> Result<(), SolveError> {
        if !all_finite(self.matrix.as_ref()) {
            return Err(SolveError::Overflow);
        }
        self.normalize();
        self.balance();
        for k in 0..self.size.get().saturating_sub(2) {
            self.clear_column(k);
        }
        let size = |row: &Z::Vector<R>| sum_of(row.as_ref().len(), 0.0, |j| row[j].modulus());
        self.norm = self.matrix.as_ref().iter().map(size).fold(0.0, f64::max);
        Ok(())
    }

    /// Takes out a power of two if squares of entries could overflow, or underflow although they
    /// matter.
    #[inline]
    fn normalize(&mut self) {
        let larger = |a: f64, b: f64| if b > a { b } else { a };
        let of_row = |row: &Z::Vector<R>| folded(row.as_ref().len(), 0.0, |j| row[j].modulus(), larger);
        let largest = self.matrix.as_ref().iter().map(of_row).fold(0.0, larger);
        if largest == 0.0 || (1e-60..1e60).contains(&largest) {
            return;
        }
        // The exponent is clamped for subnormal entries: the inverse must be a normal number, too.
        self.unit = float::power_of_two(float::exponent(largest).clamp(-1021, 1021));
        let inverse = 1.0 / self.unit;
        for row in self.matrix.as_mut() {
            row.as_mut().iter_mut().for_each(|entry| *entry = entry.scale(inverse));
        }
    }

    /// matrix := D^-1 matrix D, unless this leaves the norm at the same size.
    #[inline]
    fn balance(&mut self) {
        let before = self.squares();
        self.scale_rows_and_columns();
        if before < WORTHWHILE * WORTHWHILE * self.squares() {
            // The scaling is undone without rounding, because its factors are powers of two.
            let inverse = mapped(self.size, &self.balance, |factor: f64| 1.0 / factor);
            for (row, factor) in self.matrix.as_mut().iter_mut().zip(self.balance.as_ref()) {
                for (entry, inverse) in row.as_mut().iter_mut().zip(inverse.as_ref()) {
                    *entry = entry.scale(factor * inverse);
                }
            }
            self.balance.as_mut().fill(1.0);
        }
    }

    /// The sum of the squares of all entries.
    #[inline]
    fn squares(&self) -> f64 {
        let of_row = |row: &Z::Vector<R>| sum_of(row.as_ref().len(), 0.0, |j| row[j].modulus_squared());
        self.matrix.as_ref().iter().map(of_row).sum()
    }

    #[inline]
    fn scale_rows_and_columns(&mut self) {
        const RADIX: f64 = 2.0;
        let n = self.size.get();
        for _ in 0..BALANCE_SWEEPS {
            let mut changed = false;
            for i in 0..n {
                let column = sum_of(n, 0.0, |j| self.matrix[j][i].modulus_squared());
                let row = sum_of(n, 0.0, |j| self.matrix[i][j].modulus_squared());
                if !(column > 1e-250 && row > 1e-250) {
                    continue;
                }
                // The norms are squared: a factor of RADIX in D moves their ratio by RADIX^4.
                let sum = column + row;
                let mut factor = 1.0;
                let mut scaled = column;
                while scaled * (RADIX * RADIX) < row {
                    scaled *= RADIX * RADIX * RADIX * RADIX;
                    factor *= RADIX;
                }
                while scaled > row * (RADIX * RADIX) {
                    scaled /= RADIX * RADIX * RADIX * RADIX;
                    factor /= RADIX;
                }
                let (column, row) = (column * factor * factor, row / (factor * factor));
                if factor != 1.0 && column + row < 0.9 * sum {
                    changed = true;
                    self.balance[i] *= factor;
                    let inverse = 1.0 / factor;
                    for j in 0..n {
                        self.matrix[i][j] = self.matrix[i][j].scale(inverse);
                    }
                    for j in 0..n {
                        self.matrix[j][i] = self.matrix[j][i].scale(factor);
                    }
                }
            }
            if !changed {
                break;
            }
        }
    }

    /// Clears column k below the subdiagonal by a Householder reflection from both sides.
    #[inline]
    fn clear_column(&mut self, k: usize) {
        let n = self.size.get();
        let h = &mut self.matrix;
        let tail = sum_of(n - k - 2, R::ZERO, |i| h[k + 2 + i][k] * h[k + 2 + i][k]);
        // The tail is exactly zero, or below 1e-154 of the largest entry, so that its square
        // underflowed. It is dropped.
        if tail == R::ZERO {
            for i in k + 2..n {
                h[i][k] = R::ZERO;
            }
            return;
        }
        let head = h[k + 1][k];
        let beta = -(head * head + tail).sqrt().with_sign_of(head);
        let tau = (beta - head) / beta;
        let inverse = (head - beta).reciprocal();
        let mut v = self.size.filled(R::ZERO);
        v[k + 1] = R::ONE;
        for i in k + 2..n {
            v[i] = h[i][k] * inverse;
            h[i][k] = R::ZERO;
        }
        h[k + 1][k] = beta;

        // From the left: H -= tau v (v^T H). Only columns from k+1 on change; the others are done.
        let mut product = self.size.filled(R::ZERO);
        for i in k + 1..n {
            for j in k + 1..n {
                product[j] += v[i] * h[i][j];
            }
        }
        for i in k + 1..n {
            let factor = tau * v[i];
            for j in k + 1..n {
                h[i][j] -= factor * product[j];
            }
        }
        // From the right: H -= tau (H v) v^T.
        let (groups, rest) = h.as_mut()[..n].as_chunks_mut::<ROWS_AT_ONCE>();
        for rows in groups {
            reflect(rows, k + 1..n, &v, tau);
        }
        for row in rest {
            reflect(core::array::from_mut(row), k + 1..n, &v, tau);
        }
        self.reflectors[k] = v;
        self.tau[k] = tau;
    }

    /// Takes an eigenvector of H back to one of A: D Q y.
    #[inline]
    pub(crate) fn transform_back<S: Scalar + Over<R>>(&self, vector: &mut Z::Vector<S>) {
        let n = self.size.get();
        for k in (0..n.saturating_sub(2)).rev() {
            if self.tau[k] == R::ZERO {
                continue;
            }
            let (v, first) = (&self.reflectors[k], k + 1);
            let dot = sum_of(n - first, S::ZERO, |i| vector[first + i].times(v[first + i])).times(self.tau[k]);
            for i in k + 1..n {
                vector[i] -= dot.times(v[i]);
            }
        }
        for i in 0..n {
            vector[i] = vector[i].scale(self.balance[i]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use proptest::test_runner::RngSeed;

    const N: usize = 5;

    /// Not reduced yet.
    fn filled(matrix: [[f64; N]; N]) -> Hessenberg<Fixed<N>> {
        Hessenberg { matrix, ..Hessenberg::zero(Fixed) }
    }

    /// The squared norms of column i and of row i.
    fn norms(matrix: &[[f64; N]; N], i: usize) -> [f64; 2] {
        [(0..N).map(|j| matrix[j][i].powi(2)).sum(), (0..N).map(|j| matrix[i][j].powi(2)).sum()]
    }

    /// The same cases every time.
    fn config() -> ProptestConfig {
        ProptestConfig { cases: 1_000, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..Default::default() }
    }

    proptest! {
        #![proptest_config(config())]
        /// Balancing is a similarity by powers of two. A further factor of 2 or 1/2 in any place
        /// takes less than a tenth off the squared norms of its row and column.
        #[test]
        fn balancing_is_done_when_no_factor_gains(
            entries in prop::array::uniform5(prop::array::uniform5(-1.0..1.0_f64)),
            exponents in prop::array::uniform5(-30..30_i32),
        ) {
            let scale = exponents.map(|exponent| 2.0_f64.powi(exponent));
            let matrix = core::array::from_fn(|i| core::array::from_fn(|j| entries[i][j] * scale[i] / scale[j]));
            let mut form = filled(matrix);
            form.scale_rows_and_columns();
            for i in 0..N {
                prop_assert_eq!(form.balance[i], float::power_of_two(float::exponent(form.balance[i])));
                for j in 0..N {
                    prop_assert_eq!(form.matrix[i][j], matrix[i][j] * (form.balance[j] / form.balance[i]));
                }
                let [column, row] = norms(&form.matrix, i);
                for square in [4.0, 0.25] {
                    let gained = column * square + row / square;
                    prop_assert!(gained >= 0.9 * (column + row), "{i}: {column} {row}");
                }
            }
        }

        /// A = D Q H Q^T D^-1 in the unit: what H maps, A maps likewise after the way back.
        #[test]
        fn the_form_is_similar_to_the_matrix(
            entries in prop::array::uniform5(prop::array::uniform5(-1.0..1.0_f64)),
            vector in prop::array::uniform5(-1.0..1.0_f64),
            exponent in prop::sample::select(std::vec![0, 12, -12, 250, -250]),
        ) {
            // Balanced if rows and columns differ much; in a unit of its own if the entries are
            // extreme.
            let unit = 2.0_f64.powi(exponent);
            let spread = if exponent.abs() == 12 { unit } else { 1.0 };
            let scale: [f64; N] = core::array::from_fn(|i| spread.powi(i as i32));
            let matrix: [[f64; N]; N] =
                core::array::from_fn(|i| core::array::from_fn(|j| entries[i][j] * scale[i] / scale[j] * unit));
            let form = Hessenberg::reduce(&matrix).unwrap();
            let norm = form.matrix.iter().map(|row| sum_of(N, 0.0, |j| row[j].abs())).fold(0.0, f64::max);
            prop_assert_eq!(form.norm, norm);
            let mut image: [f64; N] = core::array::from_fn(|i| (0..N).map(|j| form.matrix[i][j] * vector[j]).sum());
            let mut vector = vector;
            form.transform_back(&mut vector);
            form.transform_back(&mut image);
            for i in 0..N {
                let (mut sum, mut size) = (0.0, 0.0);
                for j in 0..N {
                    let term = matrix[i][j] / form.unit * vector[j];
                    (sum, size) = (sum + term, size + term.abs());
                }
                // Rounding in H is relative to its norm, on the way back in the scale of the row.
                let bound = 1e-13 * (size + norm * form.balance[i]);
                prop_assert!((sum - image[i]).abs() <= bound, "row {i}: {sum} {}", image[i]);
            }
        }
    }

    /// Balancing [[1, 2^k], [2^-k, 1]] takes a factor of about 2^k / 2 off the norm. It is kept
    /// from a thousand on.
    #[test]
    fn balancing_is_undone_if_it_gains_little() {
        for (k, is_kept) in [(1, false), (10, false), (13, true), (30, true)] {
            let large = 2.0_f64.powi(k);
            for [b, c] in [[large, 1.0 / large], [1.0 / large, large]] {
                let mut form = Hessenberg::<Fixed<2>> { matrix: [[1.0, b], [c, 1.0]], ..Hessenberg::zero(Fixed) };
                form.balance();
                let ratio = form.balance[0] / form.balance[1];
                assert_eq!((form.matrix[0], ratio != 1.0), ([1.0, b / ratio], is_kept), "{k}");
                assert_eq!(form.matrix[1], [c * ratio, 1.0]);
                assert!(is_kept || form.balance == [1.0; 2]);
                assert!(!is_kept || (0.5..=2.0).contains(&form.matrix[0][1]), "{:?}", form.matrix);
            }
        }
    }

    /// Column 1 and row r, or the converse, have 1 + r of squared norms. A factor of 2 makes that 4
    /// + r / 4, which is less by a tenth from r = 4.77 on.
    #[test]
    fn factors_that_gain_less_than_a_tenth_are_not_taken() {
        for (r, is_taken) in [(4.0, false), (4.2, false), (4.7, false), (4.9, true), (9.0, true)] {
            let root = f64::sqrt(r);
            for ([b, c], factor) in [([root, 1.0], 2.0), ([1.0, root], 0.5)] {
                let mut form = Hessenberg::<Fixed<2>> { matrix: [[0.0, b], [c, 0.0]], ..Hessenberg::zero(Fixed) };
                form.scale_rows_and_columns();
                let expected = if is_taken { factor } else { 1.0 };
                assert_eq!(form.balance[0] / form.balance[1], expected, "{r}");
            }
        }
    }

    #[test]
    fn rows_and_columns_of_zeros_are_left_alone() {
        let mut matrix = [[0.0; N]; N];
        (matrix[0][1], matrix[0][2], matrix[3][2]) = (1e20, 1e-20, 1e9);
        let mut form = filled(matrix);
        form.scale_rows_and_columns();
        assert_eq!((form.matrix, form.balance), (matrix, [1.0; N]));
    }

    /// Entries far from 1 are divided by a power of two, which brings the largest one to between 1
    /// and 2.
    #[test]
    fn only_extreme_units_are_taken_out() {
        for (largest, unit) in [
            (1.0, 1.0),
            (1e59, 1.0),
            (1e-59, 1.0),
            (0.0, 1.0),
            (1.5 * 2.0_f64.powi(300), 2.0_f64.powi(300)),
            (-1.5 * 2.0_f64.powi(-300), 2.0_f64.powi(-300)),
            (f64::MAX, 2.0_f64.powi(1021)),
            (5e-324, 2.0_f64.powi(-1021)),
        ] {
            let mut matrix = [[0.0; N]; N];
            (matrix[1][2], matrix[0][4]) = (0.25 * largest, largest);
            let form = Hessenberg::reduce(&matrix).unwrap();
            assert_eq!(form.unit, unit, "{largest}");
            let mut cleared = form;
            cleared.clear();
            let zero = Hessenberg::<Fixed<N>>::zero(Fixed);
            assert_eq!((cleared.matrix, cleared.unit, cleared.norm), (zero.matrix, zero.unit, zero.norm));
            assert_eq!((cleared.balance, cleared.reflectors, cleared.tau), (zero.balance, zero.reflectors, zero.tau));
        }
    }
}
