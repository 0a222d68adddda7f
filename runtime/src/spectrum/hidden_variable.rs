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

use crate::size::{Matrix, Size, Square, filled_matrix};

/// How the basis falls into chains.
#[derive(Clone, Copy, Debug)]
pub struct Chains<'a, C, P, M> {
    /// The number of chains that stay.
    pub count: C,
    /// |B| + 1, the number of coefficients of the determinant.
    pub coefficients: P,
    /// 2^count, the number of minors.
    pub minors: M,
    /// The positions of the basis: those of the chains that stay, chain after chain from head to
    /// end, then those of the eliminated chains.
    pub order: &'a [u16],
    /// The lengths of the chains that stay. The first ones are those whose rows eliminate others.
    pub lengths: &'a [u16],
    /// The number of eliminated chains, of one monomial each.
    pub eliminated: u16,
}

/// M(x), and how the eliminated heads follow.
pub(crate) struct HiddenVariable<'a, C: Size, P: Size, M> {
    chains: Chains<'a, C, P, M>,
    /// The degree of each column.
    degrees: C::Vector<usize>,
    /// M(x): entry (i, j) is a polynomial, lowest coefficient first.
    matrix: Matrix<C, C, P::Vector<f64>>,
    /// The first rows are -D^-1 R(x).
    eliminated: Matrix<C, C, P::Vector<f64>>,
}

impl<'a, C: Size, P: Size, M: Size> HiddenVariable<'a, C, P, M> {
    /// From the rows of the action matrix; `None` if D is singular.
    pub(crate) fn new<B: Size>(chains: Chains<'a, C, P, M>, action: &Square<B, f64>) -> Option<Self> {
        let (count, k) = (chains.count.get(), usize::from(chains.eliminated));
        let zero = chains.coefficients.filled(0.0);
        let mut degrees = chains.count.filled(0);
        let mut matrix = filled_matrix(chains.count, chains.count, zero.clone());
        let mut eliminated = filled_matrix(chains.count, chains.count, zero.clone());
        let mut replaced = filled_matrix(chains.count, chains.count, zero);
        let (kept, heads) = chains.order.split_at(chains.order.len() - k);
        let mut first = 0;
        for j in 0..count {
            let length = usize::from(chains.lengths[j]);
            degrees[j] = length + usize::from(j < k);
            let positions = &kept[first..first + length];
            first += length;
            let mut ends = 0;
            for i in 0..count {
                ends += usize::from(chains.lengths[i]);
                let row = action.as_ref()[usize::from(kept[ends - 1])].as_ref();
                let target = if i < k { &mut eliminated[i][j] } else { &mut matrix[i][j] };
                for (power, &position) in positions.iter().enumerate() {
                    target[power] = -row[usize::from(position)];
                }
                if i == j {
                    target[length] += 1.0;
                }
            }
            for (i, &head) in heads.iter().enumerate() {
                let row = action.as_ref()[usize::from(head)].as_ref();
                for (power, &position) in positions.iter().enumerate() {
                    replaced[i][j][power] = -row[usize::from(position)];
                }
            }
        }
        let mut this = Self { chains, degrees, matrix, eliminated };
        if k > 0 {
            this.solve_for_heads::<B>(action, kept, heads)?;
            this.replace_rows::<B>(action, heads, &replaced);
        }
        Some(this)
    }

    /// `eliminated` := -D^-1 R, by elimination with row pivoting; `None` if D is singular.
    fn solve_for_heads<B: Size>(&mut self, action: &Square<B, f64>, kept: &[u16], heads: &[u16]) -> Option<()> {
        let k = heads.len();
        let mut d = filled_matrix(self.chains.count, self.chains.count, 0.0);
        let mut ends = 0;
        for i in 0..k {
            ends += usize::from(self.chains.lengths[i]);
            let row = action.as_ref()[usize::from(kept[ends - 1])].as_ref();
            for (j, &head) in heads.iter().enumerate() {
                // Both signs: -D = row of T.
                d[i][j] = row[usize::from(head)];
            }
        }
        for pivot in 0..k {
            let larger = |a: &usize, b: &usize| d[*a][pivot].abs().total_cmp(&d[*b][pivot].abs());
            let best = (pivot..k).max_by(larger)?;
            if !(d[best][pivot].abs() > 0.0) {
                return None;
            }
            d.as_mut().swap(pivot, best);
            self.eliminated.as_mut().swap(pivot, best);
            let inverse = 1.0 / d[pivot][pivot];
            for i in 0..k {
                let factor = if i == pivot { 0.0 } else { d[i][pivot] * inverse };
                if factor != 0.0 {
                    for j in pivot + 1..k {
                        d[i][j] -= factor * d[pivot][j];
                    }
                    self.subtract_row(i, pivot, factor);
                }
            }
        }
        for i in 0..k {
            let inverse = 1.0 / d[i][i];
            for j in 0..self.chains.count.get() {
                let entry = self.eliminated[i][j].as_mut();
                entry[..=self.degrees[j]].iter_mut().for_each(|c| *c *= inverse);
            }
        }
        Some(())
    }

    /// Row i of `eliminated` minus a multiple of row `pivot`.
    fn subtract_row(&mut self, i: usize, pivot: usize, factor: f64) {
        for j in 0..self.chains.count.get() {
            for power in 0..=self.degrees[j] {
                let subtrahend = factor * self.eliminated[pivot][j][power];
                self.eliminated[i][j][power] -= subtrahend;
            }
        }
    }

    /// Rows of the eliminated heads: (x I - A) (-D^-1 R) + C.
    fn replace_rows<B: Size>(
        &mut self,
        action: &Square<B, f64>,
        heads: &[u16],
        constant: &Matrix<C, C, P::Vector<f64>>,
    ) {
        for (i, &head) in heads.iter().enumerate() {
            let row = action.as_ref()[usize::from(head)].as_ref();
            for j in 0..self.chains.count.get() {
                let degree = self.degrees[j];
                for power in 0..=degree {
                    let mut sum = constant[i][j][power];
                    if power > 0 {
                        sum += self.eliminated[i][j][power - 1];
                    }
                    for (other, &head) in heads.iter().enumerate() {
                        sum -= row[usize::from(head)] * self.eliminated[other][j][power];
                    }
                    self.matrix[i][j][power] = sum;
                }
            }
        }
        // The rows that stay lose their constants times w.
        let mut ends = 0;
        let kept = &self.chains.order[..self.chains.order.len() - heads.len()];
        for i in 0..self.chains.count.get() {
            ends += usize::from(self.chains.lengths[i]);
            if i < heads.len() {
                continue;
            }
            let row = action.as_ref()[usize::from(kept[ends - 1])].as_ref();
            for j in 0..self.chains.count.get() {
                for power in 0..=self.degrees[j] {
                    for (other, &head) in heads.iter().enumerate() {
                        let subtrahend = row[usize::from(head)] * self.eliminated[other][j][power];
                        self.matrix[i][j][power] -= subtrahend;
                    }
                }
            }
        }
    }

    /// det M(x), lowest coefficient first: minors of the first r rows by expansion along row r,
    /// where minors of r - 1 rows are shared. A minor is kept under the set of its columns.
    pub(crate) fn determinant(&self) -> P::Vector<f64> {
        let count = self.chains.count.get();
        let mut minors = self.chains.minors.filled(self.chains.coefficients.filled(0.0));
        minors[0][0] = 1.0;
        for set in 1_usize..1 << count {
            let row = set.count_ones() as usize - 1;
            let columns = (0..count).filter(|column| set & (1 << column) != 0);
            let mut minor = self.chains.coefficients.filled(0.0);
            for (place, column) in columns.enumerate() {
                let others = set & !(1 << column);
                let degree: usize = (0..count).filter(|j| others & (1 << j) != 0).map(|j| self.degrees[j]).sum();
                let sign = if (row + place).is_multiple_of(2) { 1.0 } else { -1.0 };
                let factor = &self.matrix[row][column].as_ref()[..=self.degrees[column]];
                for (shift, &c) in factor.iter().enumerate() {
                    let c = sign * c;
                    let known = &minors[others].as_ref()[..=degree];
                    for (sum, &value) in minor.as_mut()[shift..].iter_mut().zip(known) {
                        *sum += c * value;
                    }
                }
            }
            minors[set] = minor;
        }
        minors[(1 << count) - 1].clone()
    }

    /// The eigenvector of a root x. For |x| > 1 all is divided by powers of x, so that nothing
    /// overflows.
    pub(crate) fn vector<B: Size>(&self, basis: B, x: f64) -> B::Vector<f64> {
        let is_outer = x.abs() > 1.0;
        let t = if is_outer { 1.0 / x } else { x };
        let count = self.chains.count.get();
        let value = |polynomial: &P::Vector<f64>, degree: usize| {
            let used = &polynomial.as_ref()[..=degree];
            match is_outer {
                true => used.iter().fold(0.0, |sum, c| sum * t + c),
                false => used.iter().rev().fold(0.0, |sum, c| sum * t + c),
            }
        };
        let mut matrix = filled_matrix(self.chains.count, self.chains.count, 0.0);
        for i in 0..count {
            for j in 0..count {
                matrix[i][j] = value(&self.matrix[i][j], self.degrees[j]);
            }
        }
        let heads = null_vector(self.chains.count, &mut matrix);
        let mut vector = basis.filled(0.0);
        let mut at = 0;
        for j in 0..count {
            let length = usize::from(self.chains.lengths[j]);
            // Entry l is m_j x^l, or m_j x^(l - degree).
            let (mut entry, excess) = (heads[j], self.degrees[j] - length);
            for _ in 0..if is_outer { excess } else { 0 } {
                entry *= t;
            }
            for k in 0..length {
                entry *= if is_outer || k > 0 { t } else { 1.0 };
                let place = if is_outer { length - 1 - k } else { k };
                vector[usize::from(self.chains.order[at + place])] = entry;
            }
            at += length;
        }
        for (i, &position) in self.chains.order[at..].iter().enumerate() {
            vector[usize::from(position)] =
                (0..count).map(|j| value(&self.eliminated[i][j], self.degrees[j]) * heads[j]).sum();
        }
        vector
    }
}

/// The vector that a matrix of rank c - 1 takes to zero, with an entry of 1, by elimination with
/// complete pivoting. The matrix is overwritten. The entries are not finite if the rank is lower.
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

    const ORDER: [u16; 10] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9];

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
    fn check<const C: usize, const M: usize>(lengths: [u16; C], eliminated: u16) {
        let mut random = Xoshiro256PlusPlus::seed_from_u64(u64::from(eliminated) + 10 * C as u64);
        let mut checked = 0;
        for size in [0.3, 1.0, 3.0].repeat(30) {
            let all = lengths.iter().map(|&l| usize::from(l)).chain((0..eliminated).map(|_| 1));
            let action = random_action(&mut random, &all.collect::<std::vec::Vec<_>>(), size);
            let (count, coefficients, minors) = (Fixed::<C>, Fixed::<11>, Fixed::<M>);
            let chains = Chains { count, coefficients, minors, order: &ORDER, lengths: &lengths, eliminated };
            let variable = HiddenVariable::new::<Fixed<10>>(chains, &action).unwrap();
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
                let vector = variable.vector(Fixed::<10>, value.re);
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
        check::<1, 2>([10], 0);
        check::<2, 4>([4, 6], 0);
        check::<3, 8>([3, 3, 4], 0);
        check::<3, 8>([1, 2, 7], 0);
        check::<3, 8>([2, 2, 3], 3);
        check::<3, 8>([2, 3, 4], 1);
        check::<4, 16>([2, 2, 2, 2], 2);
        check::<5, 32>([2, 2, 2, 2, 2], 0);
        check::<6, 64>([2, 1, 1, 1, 1, 3], 1);
    }

    #[test]
    fn a_singular_matrix_eliminates_nothing() {
        let mut action = random_action(&mut Xoshiro256PlusPlus::seed_from_u64(1), &[4, 5, 1], 1.0);
        action[3][9] = 0.0;
        let chains = Chains {
            count: Fixed::<2>,
            coefficients: Fixed::<11>,
            minors: Fixed::<4>,
            order: &ORDER,
            lengths: &[4, 5],
            eliminated: 1,
        };
        assert!(HiddenVariable::new::<Fixed<10>>(chains, &action).is_none());
    }
}
