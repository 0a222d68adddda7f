//! M(x) of several instances, its determinants, and eigenvectors at a root of each instance: see
//! [`HiddenVariable`](crate::spectrum::hidden_variable::HiddenVariable).

use fearless_simd::prelude::*;

use crate::batch::lanes::Lanes;
use crate::batch::shared_pivots;
use crate::number::Arithmetic;
use crate::size::{Matrix, Size, Square, filled_matrix};
use crate::spectrum::hidden_variable::{ChainTable, ChainedBasis, replace_rows, rows_of_ends};

/// A row of M(x) for each chain that stays.
type Rows<S, H> = Matrix<<H as ChainedBasis>::Count, <H as ChainedBasis>::Width, Lanes<S>>;

/// M(x), and how the eliminated heads follow.
pub(super) struct HiddenPairs<S: Simd, H: ChainedBasis> {
    chains: H,
    rows: Rows<S, H>,
    /// The first rows are -D^-1 R(x).
    eliminated: Rows<S, H>,
}

impl<S: Simd, H: ChainedBasis> HiddenPairs<S, H> {
    /// From the rows of the action matrices. Numbers of an instance with a singular D are NaN.
    #[inline(always)]
    pub(super) fn new(chains: H, action: &Square<H::Basis, Lanes<S>>) -> Self {
        let rows = rows_of_ends(&chains, action);
        let eliminated = rows.clone();
        let eliminates = !chains.table().heads.is_empty();
        let mut this = Self { chains, rows, eliminated };
        if eliminates {
            this.solve_for_heads(action);
            replace_rows(&this.chains, action, &mut this.rows, &this.eliminated);
        }
        this
    }

    /// `eliminated` := -D^-1 R, with the same row pivots for all instances.
    #[inline(always)]
    fn solve_for_heads(&mut self, action: &Square<H::Basis, Lanes<S>>) {
        let zero = action[0][0].constant(0.0);
        let (_, count, width, _) = self.chains.sizes();
        let ChainTable { ends, heads, .. } = self.chains.table();
        let k = heads.len();
        let mut d = filled_matrix(count, count, zero);
        for i in 0..k {
            for j in 0..k {
                // Both signs: -D = row of T.
                d[i][j] = action[usize::from(ends[i])][usize::from(heads[j])];
            }
        }
        for pivot in 0..k {
            // The sizes of rows of solved pivots are comparable: none is scaled.
            let mut candidates = count.filled(zero);
            for i in pivot..k {
                let mut largest = zero;
                for j in 0..k {
                    largest = d[i][j].abs().max(largest);
                }
                candidates[i] = d[i][pivot].abs() / largest;
            }
            let (best, is_good) = shared_pivots::choose::<S, H::Count>((pivot, k), &candidates, zero);
            let value = is_good.select(d[best][pivot], zero.constant(f64::NAN));
            d.as_mut().swap(pivot, best);
            self.eliminated.as_mut().swap(pivot, best);
            let inverse = zero.constant(1.0) / value;
            for j in 0..k {
                d[pivot][j] = d[pivot][j] * inverse;
            }
            for at in 0..width.get() {
                self.eliminated[pivot][at] = self.eliminated[pivot][at] * inverse;
            }
            for i in 0..k {
                if i != pivot {
                    let factor = d[i][pivot];
                    for j in 0..k {
                        d[i][j] = d[i][j].minus(factor, d[pivot][j]);
                    }
                    for at in 0..width.get() {
                        self.eliminated[i][at] = self.eliminated[i][at].minus(factor, self.eliminated[pivot][at]);
                    }
                }
            }
        }
    }

    /// det M(x), lowest coefficient first.
    #[inline(always)]
    pub(super) fn determinant(&self) -> <H::Coefficients as Size>::Vector<Lanes<S>> {
        self.chains.determinant(&self.rows)
    }

    /// The eigenvectors of a root x of each instance. For |x| > 1 each column of M(x) is divided by
    /// the power of x that is its degree, so that columns have comparable sizes.
    #[inline(always)]
    pub(super) fn vector(&self, x: Lanes<S>) -> <H::Basis as Size>::Vector<Lanes<S>> {
        let (_, count, ..) = self.chains.sizes();
        let ChainTable { degrees, heads: removed, .. } = self.chains.table();
        let (zero, one) = (x.constant(0.0), x.constant(1.0));
        let inverse = x.abs().above(one).select(one / x, one);
        let mut scale = count.filled(one);
        for j in 0..count.get() {
            for _ in 0..degrees[j] {
                scale[j] = scale[j] * inverse;
            }
        }
        let mut matrix = filled_matrix(count, count, zero);
        for i in 0..count.get() {
            matrix[i] = self.chains.row_at(&self.rows[i], x);
            let mut size = zero;
            for j in 0..count.get() {
                matrix[i][j] = matrix[i][j] * scale[j];
                size = matrix[i][j].abs().max(size);
            }
            let inverse = one / size;
            for j in 0..count.get() {
                matrix[i][j] = matrix[i][j] * inverse;
            }
        }
        let mut heads = null_vector(count, &matrix, one);
        for j in 0..count.get() {
            heads[j] = heads[j] * scale[j];
        }
        let mut eliminated = count.filled(zero);
        for i in 0..removed.len() {
            let row = self.chains.row_at(&self.eliminated[i], x);
            for j in 0..count.get() {
                eliminated[i] += row[j] * heads[j];
            }
        }
        self.chains.vector(x, &heads, &eliminated)
    }
}

/// The vector that a matrix of at most [`MOST_CHAINS`] rows and of rank c - 1 takes to zero: the
/// largest row of its adjugate. It needs no pivots, so instances need not agree on any.
#[inline(always)]
fn null_vector<S: Simd, C: Size>(size: C, m: &Square<C, Lanes<S>>, one: Lanes<S>) -> C::Vector<Lanes<S>> {
    let mut vector = size.filled(one);
    match size.get() {
        2 => {
            let is_first = size_of(&[m[0][0], m[0][1]]).above(size_of(&[m[1][0], m[1][1]]));
            vector[0] = is_first.select(-m[0][1], -m[1][1]);
            vector[1] = is_first.select(m[0][0], m[1][0]);
        }
        3 => {
            let cross = |a: usize, b: usize| {
                core::array::from_fn::<_, 3, _>(
                    #[inline(always)]
                    |j| {
                        let (k, l) = ((j + 1) % 3, (j + 2) % 3);
                        m[a][k] * m[b][l] - m[a][l] * m[b][k]
                    },
                )
            };
            let mut best = cross(0, 1);
            for other in [cross(1, 2), cross(2, 0)] {
                let is_larger = size_of(&other).above(size_of(&best));
                for j in 0..3 {
                    best[j] = is_larger.select(other[j], best[j]);
                }
            }
            for j in 0..3 {
                vector[j] = best[j];
            }
        }
        _ => {}
    }
    vector
}

/// The squared length.
#[inline(always)]
fn size_of<S: Simd, const N: usize>(vector: &[Lanes<S>; N]) -> Lanes<S> {
    let mut sum = vector[0] * vector[0];
    for j in 1..N {
        sum += vector[j] * vector[j];
    }
    sum
}
