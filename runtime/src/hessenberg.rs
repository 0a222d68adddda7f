//! Reduction of a real matrix to Hessenberg form.

use crate::error::SolveError;
use crate::float;
use crate::scalar::{Over, Real};

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
/// Balancing (Parlett and Reinsch 1969, with 2-norms as James, Langou and Lowery 2014 recommend; no permutation) makes
/// the norms of row i and column i of D^-1 A D comparable, so that the errors of the eigenvalue iteration are relative
/// to the small entries, too. It is kept where it takes much off the norm: elsewhere it gains nothing and can lose all,
/// because it scales up rows and columns that are rounding errors (Watkins 2006). Where |B| exceeds the number of
/// solutions there are such. The QR iteration and the characteristic polynomial start from H; eigenvectors are found
/// on H and taken back through Q and D.
#[derive(Clone, Debug)]
pub struct Hessenberg<const N: usize, R = f64, O = Full> {
    /// How many of the N rows and columns are in use.
    pub(crate) order: O,
    /// H: zero below the subdiagonal.
    pub(crate) matrix: [[R; N]; N],
    /// The power of two taken out of A, so that its largest entry is near 1 when it was far from it.
    pub(crate) unit: f64,
    /// The diagonal of D.
    balance: [f64; N],
    /// Row k: the reflection I - tau v v^T that cleared column k; v lives in k+1..N, v[k+1] = 1.
    reflectors: [[R; N]; N],
    /// The tau of each reflection; 0 where the column was clear already.
    tau: [R; N],
    /// The largest sum of moduli in a row of H.
    pub(crate) norm: f64,
}

/// How many rows and columns of an array are in use.
pub trait Order: Copy {
    /// Their number, at most `capacity`.
    fn of(self, capacity: usize) -> usize;
}

/// All of them: loops have bounds that the compiler knows.
#[derive(Clone, Copy, Debug)]
pub struct Full;

impl Order for Full {
    #[inline]
    fn of(self, capacity: usize) -> usize {
        capacity
    }
}

/// The leading ones: the code serves all orders up to the capacity. The other entries are zero.
impl Order for usize {
    #[inline]
    fn of(self, capacity: usize) -> usize {
        self.min(capacity)
    }
}

/// So many sums of products are computed side by side.
const ROWS_AT_ONCE: usize = 4;

/// row -= tau (row v) v^T for some rows.
#[inline]
fn reflect<R: Real, const N: usize, const M: usize>(
    rows: &mut [[R; N]; M],
    columns: core::ops::Range<usize>,
    v: &[R; N],
    tau: R,
) {
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

/// Sweeps of balancing: each multiplies by powers of two only, so a few suffice and stopping early is harmless.
const BALANCE_SWEEPS: usize = 16;
/// Balancing is kept where it reduces the norm by this: so many digits may it gain, at most.
const WORTHWHILE: f64 = 1e3;

impl<const N: usize> Hessenberg<N> {
    /// Balances and reduces a copy of `matrix`.
    ///
    /// # Errors
    /// [`SolveError::NonFiniteInput`] when an entry is infinite or NaN.
    #[inline]
    pub fn reduce(matrix: &[[f64; N]; N]) -> Result<Self, SolveError> {
        let mut reduced = Hessenberg::zero(Full);
        reduced.matrix = *matrix;
        reduced.reduce_in_place()?;
        Ok(reduced)
    }

    /// Makes the matrix zero again.
    pub(crate) fn clear(&mut self) {
        self.matrix.as_flattened_mut().fill(0.0);
        self.unit = 1.0;
        self.balance.fill(1.0);
        self.reflectors.as_flattened_mut().fill(0.0);
        self.tau.fill(0.0);
        self.norm = 0.0;
    }
}

impl<const N: usize, R: Real, O: Order> Hessenberg<N, R, O> {
    /// A zero matrix. A large one is filled in where it stands, and then reduced, to take its place on the stack once.
    #[inline]
    pub(crate) fn zero(order: O) -> Self {
        Hessenberg {
            order,
            matrix: [[R::ZERO; N]; N],
            unit: 1.0,
            balance: [1.0; N],
            reflectors: [[R::ZERO; N]; N],
            tau: [R::ZERO; N],
            norm: 0.0,
        }
    }

    /// Balances and reduces the matrix, which was filled in. Entries that are not in use are zero.
    ///
    /// # Errors
    /// [`SolveError::NonFiniteInput`] when an entry is infinite or NaN.
    pub(crate) fn reduce_in_place(&mut self) -> Result<(), SolveError> {
        if !float::all_finite(&self.matrix) {
            return Err(SolveError::NonFiniteInput);
        }
        self.normalize();
        self.balance();
        for k in 0..self.order.of(N).saturating_sub(2) {
            self.clear_column(k);
        }
        let size = |row: &[R; N]| row.iter().map(|x| x.modulus()).sum::<f64>();
        self.norm = self.matrix.iter().map(size).fold(0.0, f64::max);
        Ok(())
    }

    /// Takes out a power of two where squares of entries could overflow, or vanish although they matter.
    #[inline]
    fn normalize(&mut self) {
        let mut largest = 0.0_f64;
        for row in &self.matrix {
            for &entry in row {
                largest = if entry.modulus() > largest { entry.modulus() } else { largest };
            }
        }
        if largest == 0.0 || (1e-60..1e60).contains(&largest) {
            return;
        }
        // Clamped for subnormal entries: the inverse must be a normal number, too.
        self.unit = float::power_of_two(float::exponent(largest).clamp(-1021, 1021));
        let inverse = 1.0 / self.unit;
        for entry in self.matrix.as_flattened_mut() {
            *entry = entry.scale(inverse);
        }
    }

    /// matrix := D^-1 matrix D, unless its norm stays of the same size.
    #[inline]
    fn balance(&mut self) {
        let before = self.squares();
        self.scale_rows_and_columns();
        if before < WORTHWHILE * WORTHWHILE * self.squares() {
            // Back again: powers of two round nothing.
            let inverse = self.balance.map(|factor| 1.0 / factor);
            for (row, factor) in self.matrix.iter_mut().zip(&self.balance) {
                for (entry, inverse) in row.iter_mut().zip(&inverse) {
                    *entry = entry.scale(factor * inverse);
                }
            }
            self.balance = [1.0; N];
        }
    }

    /// The sum of the squares of all entries.
    #[inline]
    fn squares(&self) -> f64 {
        self.matrix.as_flattened().iter().map(|x| x.modulus_squared()).sum()
    }

    #[inline]
    fn scale_rows_and_columns(&mut self) {
        const RADIX: f64 = 2.0;
        let n = self.order.of(N);
        for _ in 0..BALANCE_SWEEPS {
            let mut changed = false;
            for i in 0..n {
                let (mut column, mut row) = (0.0, 0.0);
                for j in 0..n {
                    column += self.matrix[j][i].modulus_squared();
                    row += self.matrix[i][j].modulus_squared();
                }
                if !(column > 1e-250 && row > 1e-250) {
                    continue;
                }
                // Squared norms: a factor of RADIX in D moves their ratio by RADIX^4.
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
        let n = self.order.of(N);
        let h = &mut self.matrix;
        let tail = (k + 2..n).map(|i| h[i][k] * h[i][k]).fold(R::ZERO, |sum, square| sum + square);
        // Exactly zero or below 1e-154 of the largest entry, whose square underflowed: dropped.
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
        let mut v = [R::ZERO; N];
        v[k + 1] = R::ONE;
        for i in k + 2..n {
            v[i] = h[i][k] * inverse;
            h[i][k] = R::ZERO;
        }
        h[k + 1][k] = beta;

        // From the left: H -= tau v (v^T H), columns k+1.. only, the others are done.
        let mut product = [R::ZERO; N];
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
        // From the right: H -= tau (H v) v^T. Each sum waits for its last addition: several rows at once.
        let (groups, rest) = h[..n].as_chunks_mut::<ROWS_AT_ONCE>();
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
    pub(crate) fn transform_back<S: Over<R>>(&self, vector: &mut [S; N]) {
        let n = self.order.of(N);
        for k in (0..n.saturating_sub(2)).rev() {
            if self.tau[k] == R::ZERO {
                continue;
            }
            let v = &self.reflectors[k];
            let mut dot = S::ZERO;
            for i in k + 1..n {
                dot += vector[i].times(v[i]);
            }
            let dot = dot.times(self.tau[k]);
            for i in k + 1..n {
                vector[i] -= dot.times(v[i]);
            }
        }
        for i in 0..n {
            vector[i] = vector[i].scale(self.balance[i]);
        }
    }
}

impl<const N: usize> Hessenberg<N> {
    /// The coefficients of the characteristic polynomial det(x I - A) = x^N + c\[N-1\] x^(N-1) + .. + c\[0\], by La
    /// Budde's recurrence on H (Wilkinson 1965, chapter 7, section 11; Rehman and Ipsen 2011):
    ///
    /// p_i = (x - h_ii) p_(i-1) - sum over m of h_(i-m,i) b_i .. b_(i-m+1) p_(i-m-1),  b_i = h_(i,i-1).
    ///
    /// For N up to about 10, to find real eigenvalues alone by [`real_roots_monic`](crate::real_roots_monic); the
    /// coefficients lose digits as N grows. They overflow to infinity when A is very large.
    #[must_use]
    pub fn characteristic_polynomial(&self) -> [f64; N] {
        let h = &self.matrix;
        // partial[i]: the characteristic polynomial of the leading i x i block, monic, coefficients below i.
        let mut partial = [[0.0; N]; N];
        let mut next = [0.0; N];
        for i in 0..N {
            let previous = partial[i];
            next = [0.0; N];
            // x * p_(i-1): the leading coefficient of p_(i-1) is an implicit 1 at degree i.
            next[1..=i].copy_from_slice(&previous[..i]);
            for j in 0..i {
                next[j] -= h[i][i] * previous[j];
            }
            next[i] -= h[i][i];
            let mut product = 1.0;
            for start in (0..i).rev() {
                product *= h[start + 1][start];
                let factor = product * h[start][i];
                for j in 0..start {
                    next[j] -= factor * partial[start][j];
                }
                next[start] -= factor;
            }
            if i + 1 < N {
                partial[i + 1] = next;
            }
        }
        if self.unit != 1.0 {
            let mut power = 1.0;
            for coefficient in next.iter_mut().rev() {
                power *= self.unit;
                *coefficient *= power;
            }
        }
        next
    }
}
