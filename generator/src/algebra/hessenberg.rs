//! Hessenberg form over Z_p, and the characteristic polynomials of its blocks.

use super::{DenseMatrix, Random, Univariate};

/// What a square matrix T is similar to, as far as its eigenvalues go.
///
/// ```text
///   S^-1 T S  =  [ H_1  *   *  ]     H_k = [ *  *  *  * ]     no + is 0: an eigenvalue of H_k
///                [  0  H_2  *  ]           [ +  *  *  * ]     has one eigenvector of H_k, up
///                [  0   0   .. ]           [ 0  +  *  * ]     to a factor
///                                          [ 0  0  +  * ]
/// ```
///
/// H_1 is T on the space of w, T w, T^2 w, .. for a random vector w, which is the first column of
/// S. The others are T on such spaces of the quotients.
#[derive(Clone, Debug)]
pub(super) struct CyclicBlocks {
    /// w.
    pub(super) start: Vec<u32>,
    /// The characteristic polynomials of H_1, H_2, .. , monic.
    pub(super) polynomials: Vec<Univariate>,
}

impl CyclicBlocks {
    /// The blocks of a square matrix.
    pub(super) fn of(matrix: &DenseMatrix, random: &mut Random) -> Self {
        let (field, size) = (matrix.field(), matrix.rows());
        let mut h = matrix.clone();
        let (mut start, mut polynomials) = (Vec::new(), Vec::new());
        let mut first = 0;
        for column in 0..size {
            if column == first {
                let draw = |at: usize, random: &mut Random| match at > first {
                    true => random.below(u64::from(field.modulus())) as u32,
                    false => 0,
                };
                let factors: Vec<u32> = (0..size).map(|at| draw(at, random)).collect();
                conjugate(&mut h, first, &factors);
                if first == 0 {
                    // Later conjugations leave the first column of S as it is.
                    start = factors;
                    start[0] = 1;
                }
            }
            if !clear_below_subdiagonal(&mut h, column) {
                polynomials.push(characteristic_polynomial(&h, first, column + 1));
                first = column + 1;
            }
        }
        Self { start, polynomials }
    }
}

/// S^-1 h S for S = I + f e^T, where e is the unit vector `at` and f holds the factors, 0 up to
/// this position: multiples of row `at` are subtracted from the rows below, and those columns added
/// to column `at`.
fn conjugate(h: &mut DenseMatrix, at: usize, factors: &[u32]) {
    let (field, size) = (h.field(), h.rows());
    let pivot = h.row(at).to_vec();
    for row in at + 1..size {
        if factors[row] != 0 {
            field.add_multiple(h.row_mut(row), field.neg(factors[row]), &pivot);
        }
    }
    for row in 0..size {
        let sum = field.dot(&h.row(row)[at + 1..], &factors[at + 1..]);
        let entry = &mut h.row_mut(row)[at];
        *entry = field.add(*entry, sum);
    }
}

/// Makes the entries of a column below the one just below the diagonal 0; returns whether that one
/// is not.
fn clear_below_subdiagonal(h: &mut DenseMatrix, column: usize) -> bool {
    let (field, size) = (h.field(), h.rows());
    let below = column + 1;
    let Some(pivot) = (below..size).find(|&row| h.get(row, column) != 0) else { return false };
    if pivot != below {
        for at in 0..size {
            let (a, b) = (h.get(below, at), h.get(pivot, at));
            (h.row_mut(below)[at], h.row_mut(pivot)[at]) = (b, a);
        }
        (0..size).for_each(|row| h.row_mut(row).swap(below, pivot));
    }
    let Some(inverse) = field.inverse(h.get(below, column)) else { return false };
    let factor = |row: usize| if row > below { field.mul(h.get(row, column), inverse) } else { 0 };
    let factors: Vec<u32> = (0..size).map(factor).collect();
    conjugate(h, below, &factors);
    true
}

/// det(t I - H) for the diagonal block `first..end` of a Hessenberg matrix, by expansion along its
/// last column:
///
/// p_(k+1) = (t - h_kk) p_k - sum over i < k of h_ik h_(i+1,i) .. h_(k,k-1) p_i
fn characteristic_polynomial(h: &DenseMatrix, first: usize, end: usize) -> Univariate {
    let field = h.field();
    let mut leading = vec![Univariate::constant(1)];
    for k in first..end {
        let last = &leading[k - first];
        let mut next = last.times(field, &Univariate::t());
        next.add_multiple(field, (field.neg(h.get(k, k)), 0), last);
        let mut subdiagonal = 1;
        for i in (first..k).rev() {
            subdiagonal = field.mul(subdiagonal, h.get(i + 1, i));
            let factor = field.neg(field.mul(h.get(i, k), subdiagonal));
            next.add_multiple(field, (factor, 0), &leading[i - first]);
        }
        leading.push(next);
    }
    leading.pop().unwrap_or_else(|| Univariate::constant(1))
}
