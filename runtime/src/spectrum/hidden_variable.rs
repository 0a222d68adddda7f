//! The action monomial as a hidden variable: eigenpairs without an eigenvalue iteration.
//!
//! Multiplication by the action monomial x shifts the basis along chains m, x m, x^2 m, ... Only
//! the last monomial of each chain has a row with numbers in the action matrix. With the values m_j
//! of the heads of c chains, these rows are c equations M(x) m = 0, where M(x) is a matrix of
//! polynomials:
//!
//! ```text
//!          [ x^3 + .. , ..        , ..  ]   column j has the degree of its chain's length; the
//!   M(x) = [ ..       , x^2 + ..  , ..  ]   powers shown are the only entries of that degree
//!          [ ..       , ..        , x + ..]
//! ```
//!
//! det M(x) is the characteristic polynomial of the action matrix. At a root of it the null vector
//! of M(x) holds the values of the heads, and they give the whole eigenvector.
//!
//! A chain of one monomial w has constants in its column but for its own row, where x stands. k
//! rows of longer chains, R m + D w = 0, give w = -D^-1 R m if the k x k matrix D is regular. That
//! eliminates k chains: the rows of w, (x I - A) w + C m = 0, take the place of those k rows, and
//! their columns' degrees rise by one. Nistér's solver for five points (PAMI 2004) is the case of
//! chains of 3, 2, 2, 1, 1 and 1 that become 4, 3 and 3.

use crate::number::Arithmetic;
use crate::size::{Matrix, Size, Square, filled_matrix};

/// Where the monomials of a basis are that falls into chains.
#[derive(Clone, Copy, Debug)]
pub struct ChainTable<'a> {
    /// The position in the basis of the last monomial of each chain that stays. Those whose rows
    /// eliminate others come first.
    pub ends: &'a [u16],
    /// For each of them, where x^length stands in its own column: the position in its row of M(x).
    pub leading: &'a [u16],
    /// The degree of each column of M(x).
    pub degrees: &'a [u16],
    /// The positions of the eliminated heads.
    pub heads: &'a [u16],
}

/// A basis of c chains, with the arithmetic whose lengths differ from chain to chain. A row of M(x)
/// is a vector: the polynomials of all columns one after another, lowest coefficient first.
///
/// ```text
///   degrees 3, 3, 4:   [ 1 x x^2 x^3 | 1 x x^2 x^3 | 1 x x^2 x^3 x^4 ]     |B| + c numbers
/// ```
pub trait ChainedBasis {
    /// |B|.
    type Basis: Size;
    /// The number c of chains that stay.
    type Count: Size;
    /// |B| + c.
    type Width: Size;
    /// |B| + 1.
    type Coefficients: Size;

    /// All sizes.
    fn sizes(&self) -> (Self::Basis, Self::Count, Self::Width, Self::Coefficients);

    /// Where the monomials are.
    fn table(&self) -> ChainTable<'_>;

    /// Minus a row of the action matrix, without the eliminated monomials, as a row of M(x).
    fn polynomials<T: Arithmetic>(&self, row: &<Self::Basis as Size>::Vector<T>) -> <Self::Width as Size>::Vector<T>;

    /// det M(x), lowest coefficient first.
    fn determinant<T: Arithmetic>(
        &self,
        rows: &Matrix<Self::Count, Self::Width, T>,
    ) -> <Self::Coefficients as Size>::Vector<T>;

    /// The values of the polynomials of a row.
    fn row_at<T: Arithmetic>(&self, row: &<Self::Width as Size>::Vector<T>, x: T) -> <Self::Count as Size>::Vector<T>;

    /// The values of all basis monomials from those of the heads: of the chains that stay, and the
    /// eliminated ones.
    fn vector<T: Arithmetic>(
        &self,
        x: T,
        heads: &<Self::Count as Size>::Vector<T>,
        eliminated: &<Self::Count as Size>::Vector<T>,
    ) -> <Self::Basis as Size>::Vector<T>;
}

/// The polynomial of degree A - 1 that starts at position F of a row of M(x).
#[inline(always)]
#[must_use]
pub fn entry<const A: usize, const F: usize, const W: usize, T>(row: &[T; W]) -> &[T; A] {
    const { assert!(F + A <= W, "the polynomial is part of the row") };
    loop {
        // Always: the row is long enough.
        if let Some(polynomial) = row[F..].first_chunk() {
            return polynomial;
        }
    }
}

/// The value of a polynomial, by Horner's rule.
#[inline(always)]
#[must_use]
pub fn value_at<const A: usize, T: Arithmetic>(coefficients: &[T; A], x: T) -> T {
    let mut sum = x.constant(0.0);
    for &c in coefficients.iter().rev() {
        sum = sum * x + c;
    }
    sum
}

/// A row of M(x) for each chain that stays.
type Rows<H> = Matrix<<H as ChainedBasis>::Count, <H as ChainedBasis>::Width, f64>;

/// The rows of an action matrix.
type Action<H> = Square<<H as ChainedBasis>::Basis, f64>;

/// M(x), and how the eliminated heads follow.
pub(crate) struct HiddenVariable<'a, H: ChainedBasis> {
    chains: &'a H,
    rows: Rows<H>,
    /// The first rows are -D^-1 R(x).
    eliminated: Rows<H>,
}

impl<'a, H: ChainedBasis> HiddenVariable<'a, H> {
    /// From the rows of the action matrix; `None` if D is singular.
    #[inline]
    pub(crate) fn new(chains: &'a H, action: &Action<H>) -> Option<Self> {
        let rows = rows_of_ends(chains, action);
        let eliminated = rows.clone();
        let mut this = Self { chains, rows, eliminated };
        if !chains.table().heads.is_empty() {
            this.solve_for_heads(action)?;
            replace_rows(chains, action, &mut this.rows, &this.eliminated);
        }
        Some(this)
    }

    /// `eliminated` := -D^-1 R, by elimination with row pivoting; `None` if D is singular.
    #[inline]
    fn solve_for_heads(&mut self, action: &Action<H>) -> Option<()> {
        let (_, count, ..) = self.chains.sizes();
        let ChainTable { ends, heads, .. } = self.chains.table();
        let k = heads.len();
        let mut d = filled_matrix(count, count, 0.0);
        for i in 0..k {
            for j in 0..k {
                // Both signs: -D = row of T.
                d[i][j] = action[usize::from(ends[i])][usize::from(heads[j])];
            }
        }
        for pivot in 0..k {
            let mut best = pivot;
            for i in pivot + 1..k {
                best = if d[i][pivot].abs() > d[best][pivot].abs() { i } else { best };
            }
            if !(d[best][pivot].abs() > 0.0) {
                return None;
            }
            d.as_mut().swap(pivot, best);
            self.eliminated.as_mut().swap(pivot, best);
            let inverse = 1.0 / d[pivot][pivot];
            let (pivot_d, pivot_row) = (d[pivot].clone(), self.eliminated[pivot].clone());
            for i in 0..k {
                if i != pivot {
                    let factor = d[i][pivot] * inverse;
                    subtract::<H::Count>(&mut d[i], factor, &pivot_d);
                    subtract::<H::Width>(&mut self.eliminated[i], factor, &pivot_row);
                }
            }
        }
        for i in 0..k {
            let inverse = 1.0 / d[i][i];
            self.eliminated[i].as_mut().iter_mut().for_each(|c| *c *= inverse);
        }
        Some(())
    }

    /// det M(x), lowest coefficient first.
    #[inline]
    pub(crate) fn determinant(&self) -> <H::Coefficients as Size>::Vector<f64> {
        self.chains.determinant(&self.rows)
    }

    /// The eigenvector of a root x. For |x| > 1 each column of M(x) is divided by the power of x
    /// that is its degree, so that columns have comparable sizes.
    #[inline]
    pub(crate) fn vector(&self, x: f64) -> <H::Basis as Size>::Vector<f64> {
        let (_, count, ..) = self.chains.sizes();
        let ChainTable { degrees, heads: removed, .. } = self.chains.table();
        let inverse = if x.abs() > 1.0 { 1.0 / x } else { 1.0 };
        let mut scale = count.filled(1.0);
        for j in 0..count.get() {
            for _ in 0..degrees[j] {
                scale[j] *= inverse;
            }
        }
        let mut matrix = filled_matrix(count, count, 0.0);
        for i in 0..count.get() {
            matrix[i] = self.chains.row_at(&self.rows[i], x);
            for j in 0..count.get() {
                matrix[i][j] *= scale[j];
            }
        }
        let mut heads = null_vector(count, &mut matrix);
        for j in 0..count.get() {
            heads[j] *= scale[j];
        }
        let mut eliminated = count.filled(0.0);
        for i in 0..removed.len() {
            let row = self.chains.row_at(&self.eliminated[i], x);
            for j in 0..count.get() {
                eliminated[i] += row[j] * heads[j];
            }
        }
        self.chains.vector(x, &heads, &eliminated)
    }
}

/// M(x) before chains are eliminated: a row for each chain that stays.
#[inline(always)]
pub(crate) fn rows_of_ends<H: ChainedBasis, T: Arithmetic>(
    chains: &H,
    action: &Square<H::Basis, T>,
) -> Matrix<H::Count, H::Width, T> {
    let zero = action[0][0].constant(0.0);
    let (_, count, width, _) = chains.sizes();
    let table = chains.table();
    let mut rows = filled_matrix(count, width, zero);
    for i in 0..count.get() {
        rows[i] = chains.polynomials(&action[usize::from(table.ends[i])]);
        rows[i][usize::from(table.leading[i])] += zero.constant(1.0);
    }
    rows
}

/// Rows of the eliminated heads take the place of those that eliminated them:
/// (x I - A) (-D^-1 R) + C. The rows that stay lose their constants times w.
#[inline(always)]
pub(crate) fn replace_rows<H: ChainedBasis, T: Arithmetic>(
    chains: &H,
    action: &Square<H::Basis, T>,
    rows: &mut Matrix<H::Count, H::Width, T>,
    eliminated: &Matrix<H::Count, H::Width, T>,
) {
    let (_, count, width, _) = chains.sizes();
    let ChainTable { ends, heads, .. } = chains.table();
    for i in 0..count.get() {
        let row = &action[usize::from(if i < heads.len() { heads[i] } else { ends[i] })];
        if i < heads.len() {
            rows[i] = chains.polynomials(row);
            // Times x: the last coefficient of each polynomial of R is zero.
            for at in 1..width.get() {
                rows[i][at] += eliminated[i][at - 1];
            }
        }
        for (other, &head) in heads.iter().enumerate() {
            let factor = row[usize::from(head)];
            for at in 0..width.get() {
                rows[i][at] -= factor * eliminated[other][at];
            }
        }
    }
}

/// row -= factor * other
#[inline]
fn subtract<Z: Size>(row: &mut Z::Vector<f64>, factor: f64, other: &Z::Vector<f64>) {
    for (entry, &value) in row.as_mut().iter_mut().zip(other.as_ref()) {
        *entry -= factor * value;
    }
}

/// The vector that a matrix of rank c - 1 takes to zero, with an entry of 1, by elimination with
/// complete pivoting. The matrix is overwritten. The entries are not finite if the rank is lower.
#[inline]
fn null_vector<C: Size>(size: C, matrix: &mut Square<C, f64>) -> C::Vector<f64> {
    let count = size.get();
    let mut column = size.filled(0);
    (0..count).for_each(|j| column[j] = j);
    for row in matrix.as_mut() {
        let largest = row.as_ref().iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        row.as_mut().iter_mut().for_each(|x| *x /= largest);
    }
    for pivot in 0..count.saturating_sub(1) {
        let (mut best, mut at) = (-1.0, (pivot, pivot));
        for i in pivot..count {
            for j in pivot..count {
                if matrix[i][j].abs() > best {
                    (best, at) = (matrix[i][j].abs(), (i, j));
                }
            }
        }
        matrix.as_mut().swap(pivot, at.0);
        matrix.as_mut().iter_mut().for_each(|row| row.as_mut().swap(pivot, at.1));
        column.as_mut().swap(pivot, at.1);
        let inverse = 1.0 / matrix[pivot][pivot];
        for i in pivot + 1..count {
            let factor = matrix[i][pivot] * inverse;
            for j in pivot + 1..count {
                let subtrahend = factor * matrix[pivot][j];
                matrix[i][j] -= subtrahend;
            }
        }
    }
    let (mut solved, mut vector) = (size.filled(1.0), size.filled(0.0));
    for i in (0..count.saturating_sub(1)).rev() {
        let sum: f64 = (i + 1..count).map(|j| matrix[i][j] * solved[j]).sum();
        solved[i] = -sum / matrix[i][i];
    }
    (0..count).for_each(|j| vector[column[j]] = solved[j]);
    vector
}

#[cfg(test)]
mod tests {
    use nalgebra::SMatrix;
    use num_complex::Complex;
    use rand_xoshiro::Xoshiro256PlusPlus;
    use rand_xoshiro::rand_core::{Rng, SeedableRng};

    use super::*;
    use crate::size::Fixed;

    /// A basis of 10 monomials in which chains of these lengths follow one another from head to
    /// end, then the eliminated ones.
    struct InOrder<const C: usize> {
        lengths: [u16; C],
        ends: [u16; C],
        leading: [u16; C],
        degrees: [u16; C],
        heads: std::vec::Vec<u16>,
    }

    impl<const C: usize> InOrder<C> {
        fn new(lengths: [u16; C], eliminated: u16) -> Self {
            let sum = |count: usize| lengths[..count].iter().sum::<u16>();
            let ends = core::array::from_fn(|i| sum(i + 1) - 1);
            let degrees = core::array::from_fn(|i| lengths[i] + u16::from(i < usize::from(eliminated)));
            let first = |i: usize| degrees[..i].iter().map(|degree| degree + 1).sum::<u16>();
            let leading = core::array::from_fn(|i| first(i) + lengths[i]);
            Self { lengths, ends, leading, degrees, heads: (10 - eliminated..10).collect() }
        }

        /// Where the polynomial of each column starts, and its degree.
        fn columns(&self) -> impl Iterator<Item = (usize, usize)> {
            self.degrees.iter().scan(0, |first, &degree| {
                let degree = usize::from(degree);
                *first += degree + 1;
                Some((*first - degree - 1, degree))
            })
        }
    }

    /// The sum over permutations is the determinant by definition.
    fn sum_over_permutations<T: Arithmetic>(rows: &[&[T]], columns: &[(usize, usize)], one: T) -> std::vec::Vec<T> {
        let Some((row, rest)) = rows.split_first() else { return std::vec![one] };
        let mut sum = std::vec![one.constant(0.0); columns.iter().map(|column| column.1).sum::<usize>() + 1];
        for (at, &(first, degree)) in columns.iter().enumerate() {
            let others = [&columns[..at], &columns[at + 1..]].concat();
            let minor = sum_over_permutations(rest, &others, one);
            let sign = one.constant(if at.is_multiple_of(2) { 1.0 } else { -1.0 });
            for (i, &a) in row[first..=first + degree].iter().enumerate() {
                for (j, &b) in minor.iter().enumerate() {
                    sum[i + j] += sign * a * b;
                }
            }
        }
        sum
    }

    impl<const C: usize> ChainedBasis for InOrder<C> {
        type Basis = Fixed<10>;
        type Count = Fixed<C>;
        type Width = Fixed<16>;
        type Coefficients = Fixed<11>;

        fn sizes(&self) -> (Fixed<10>, Fixed<C>, Fixed<16>, Fixed<11>) {
            (Fixed, Fixed, Fixed, Fixed)
        }

        fn table(&self) -> ChainTable<'_> {
            let Self { ends, leading, degrees, heads, .. } = self;
            ChainTable { ends, leading, degrees, heads }
        }

        fn polynomials<T: Arithmetic>(&self, row: &[T; 10]) -> [T; 16] {
            let (mut polynomials, mut at) = ([row[0].constant(0.0); 16], 0);
            for ((first, _), &length) in self.columns().zip(&self.lengths) {
                for power in 0..usize::from(length) {
                    polynomials[first + power] = -row[at];
                    at += 1;
                }
            }
            polynomials
        }

        fn determinant<T: Arithmetic>(&self, rows: &[[T; 16]; C]) -> [T; 11] {
            let one = rows[0][0].constant(1.0);
            let rows: std::vec::Vec<&[T]> = rows.iter().map(|row| &row[..]).collect();
            let sum = sum_over_permutations(&rows, &self.columns().collect::<std::vec::Vec<_>>(), one);
            core::array::from_fn(|power| sum[power])
        }

        fn row_at<T: Arithmetic>(&self, row: &[T; 16], x: T) -> [T; C] {
            let mut columns = self.columns();
            core::array::from_fn(|_| {
                let (first, degree) = columns.next().unwrap();
                row[first..=first + degree].iter().rev().fold(x.constant(0.0), |sum, &c| sum * x + c)
            })
        }

        fn vector<T: Arithmetic>(&self, x: T, heads: &[T; C], eliminated: &[T; C]) -> [T; 10] {
            let chains = self.lengths.iter().zip(heads);
            let kept = chains.flat_map(|(&length, &head)| (0..length).map(move |n| (0..n).fold(head, |y, _| y * x)));
            let all: std::vec::Vec<T> = kept.chain(eliminated[..self.heads.len()].iter().copied()).collect();
            core::array::from_fn(|b| all[b])
        }
    }

    /// An action matrix with chains of these lengths, from head to end, numbers of this size.
    fn random_action(random: &mut Xoshiro256PlusPlus, lengths: &[usize], size: f64) -> [[f64; 10]; 10] {
        let mut action = [[0.0; 10]; 10];
        let mut end = 0;
        for length in lengths {
            (end..end + length - 1).for_each(|row| action[row][row + 1] = 1.0);
            end += length;
            let number = |_| size * ((random.next_u64() >> 11) as f64 * 2.0_f64.powi(-52) - 1.0);
            action[end - 1] = core::array::from_fn(number);
        }
        action
    }

    /// det M(x) has the eigenvalues for roots, and `vector` gives their eigenvectors. `lengths` are
    /// those of the chains that stay; chains of one monomial follow.
    fn check<const C: usize>(lengths: [u16; C], eliminated: u16) {
        let mut random = Xoshiro256PlusPlus::seed_from_u64(u64::from(eliminated) + 10 * C as u64);
        let chains = InOrder::new(lengths, eliminated);
        let mut checked = 0;
        for size in [0.3, 1.0, 3.0].repeat(30) {
            let all = lengths.iter().map(|&l| usize::from(l)).chain((0..eliminated).map(|_| 1));
            let action = random_action(&mut random, &all.collect::<std::vec::Vec<_>>(), size);
            let variable = HiddenVariable::new(&chains, &action).unwrap();
            let determinant = variable.determinant();
            let matrix = SMatrix::<f64, 10, 10>::from_fn(|i, j| action[i][j]);
            for value in matrix.complex_eigenvalues().iter() {
                let powers = |c: &dyn Fn(f64) -> f64| {
                    let terms = determinant.iter().rev();
                    terms.fold((Complex::ZERO, 0.0), |(sum, size): (Complex<f64>, f64), &d| {
                        (sum * value + c(d), size * value.norm() + d.abs())
                    })
                };
                let (sum, scale) = powers(&|d| d);
                assert!(sum.norm() < 1e-9 * scale, "{lengths:?}: {} at {value}", sum.norm() / scale);
                if value.im != 0.0 {
                    continue;
                }
                let vector = variable.vector(value.re);
                let (v, largest) =
                    (nalgebra::SVector::from(vector), vector.iter().fold(0.0, |m: f64, x| m.max(x.abs())));
                let error = (matrix * v - v * value.re).amax() / (largest * (1.0 + matrix.norm()));
                assert!(error < 1e-8, "{lengths:?}: {error} at {value}");
                checked += 1;
            }
        }
        assert!(checked > 100, "{checked} real eigenvalues");
    }

    #[test]
    fn determinants_have_the_eigenvalues_for_roots() {
        check([10], 0);
        check([4, 6], 0);
        check([3, 3, 4], 0);
        check([1, 2, 7], 0);
        check([2, 2, 3], 3);
        check([2, 3, 4], 1);
        check([2, 2, 2, 2], 2);
        check([2, 2, 2, 2, 2], 0);
        check([2, 1, 1, 1, 1, 3], 1);
    }

    #[test]
    fn a_singular_matrix_eliminates_nothing() {
        let mut action = random_action(&mut Xoshiro256PlusPlus::seed_from_u64(1), &[4, 5, 1], 1.0);
        action[3][9] = 0.0;
        assert!(HiddenVariable::new(&InOrder::new([4, 5], 1), &action).is_none());
    }

    #[test]
    fn products_of_polynomials() {
        // (1 + 2 x) (3 - x + x^2) = 3 + 5 x - x^2 + 2 x^3
        let row = [9.0, 1.0, 2.0, 3.0, -1.0, 1.0];
        let (a, b) = (entry::<2, 1, 6, _>(&row), entry::<3, 3, 6, _>(&row));
        let mut sum = [1.0; 4];
        f64::add_product(&mut sum, a, b);
        assert_eq!(sum, [4.0, 6.0, 0.0, 3.0]);
        f64::subtract_product(&mut sum, a, b);
        assert_eq!(sum, [1.0; 4]);
        assert_eq!((value_at(a, 3.0), value_at(b, 2.0)), (7.0, 5.0));
    }
}
