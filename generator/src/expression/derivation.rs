//! Data that are derived from data: by operations that are no polynomials.
//!
//! ```text
//!   inputs    [ given .. | first derivation .. | second derivation .. | .. ]
//!                 |            ^      |               ^
//!                 +- operands -+      +-- operands ---+
//! ```
//!
//! The results of a derivation are inputs of their own to all that follows: a template, the units
//! of a problem and its families of instances are those of a problem to which they are given.

#[cfg(feature = "search")]
use eliminant::{SolveError, emitted};

use crate::algebra::{PrimeField, Random};

/// An operation on data that is no polynomial.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DerivationKind {
    /// The square root of the operand, which is not negative; over Z_p one of its two roots.
    SquareRoot,
    /// The solution X of A X = B. Operands: the entries of A, row by row, then those of B.
    ///
    /// ```text
    ///   [ A | B ]:  size x (size + right)      X:  size x right
    /// ```
    Solve {
        /// The number of rows, and of columns of A.
        size: usize,
        /// The number of columns of B.
        right: usize,
    },
    /// Vectors that span the null space of a matrix of full row rank, orthonormal over the reals.
    /// Over Z_p they are a basis that a random matrix mixes. Operands: the entries, row by row.
    ///
    /// ```text
    ///   A:  rows x columns      result:  (columns - rows) x columns, a vector in each row
    /// ```
    NullSpace {
        /// The number of rows, less than that of the columns.
        rows: usize,
        /// The number of columns.
        columns: usize,
    },
    /// The values whose key is least. Over Z_p, where nothing is least, a mixture of all values
    /// with weights of sum 1. Operands: the keys, then the values of each.
    Least {
        /// The number of keys.
        keys: usize,
        /// The number of values of each.
        size: usize,
    },
}

impl DerivationKind {
    /// The number of operands.
    pub fn operands(self) -> usize {
        match self {
            Self::SquareRoot => 1,
            Self::Solve { size, right } => size * (size + right),
            Self::NullSpace { rows, columns } => rows * columns,
            Self::Least { keys, size } => keys * (1 + size),
        }
    }

    /// The number of results.
    pub fn results(self) -> usize {
        match self {
            Self::SquareRoot => 1,
            Self::Solve { size, right } => size * right,
            Self::NullSpace { rows, columns } => (columns - rows) * columns,
            Self::Least { size, .. } => size,
        }
    }

    /// Floating-point operations, about.
    pub fn operations(self) -> usize {
        match self {
            Self::SquareRoot => 10,
            Self::Solve { size, right } => 2 * size * size * (size + 3 * right) / 3,
            Self::NullSpace { rows, columns } => 4 * rows * columns * (columns - rows) + 2 * rows * rows * columns,
            Self::Least { keys, size } => keys + size,
        }
    }

    /// The results in `f64`, by the kernels that ship. Pivots of a linear system must be more than
    /// `least`.
    #[cfg(feature = "search")]
    pub(crate) fn over_reals(self, mut operands: Vec<f64>, least: f64) -> Result<Vec<f64>, SolveError> {
        let mut results = vec![0.0; self.results()];
        match self {
            Self::SquareRoot => emitted::square_root(&operands, &mut results)?,
            Self::Solve { size, .. } => emitted::solve_linear(&mut operands, size, least, &mut results)?,
            Self::NullSpace { rows, .. } => emitted::null_space(&mut operands, rows, &mut results)?,
            Self::Least { keys, .. } => emitted::least(&operands, keys, &mut results)?,
        }
        Ok(results)
    }

    /// The solution of a linear system whose pivots must be more than `least`, by the kernel that
    /// ships.
    #[cfg(feature = "search")]
    pub(crate) fn solved<R: emitted::Real>(self, mut operands: Vec<R>, least: f64) -> Result<Vec<R>, SolveError> {
        let Self::Solve { size, .. } = self else { return Err(SolveError::LostRank) };
        let mut results = vec![R::ZERO; self.results()];
        emitted::solve_linear(&mut operands, size, least, &mut results)?;
        Ok(results)
    }

    /// The results over Z_p; `None` where a matrix has lost rank, or there is no square root.
    pub(crate) fn over_prime_field(self, f: PrimeField, operands: &[u32]) -> Option<Vec<u32>> {
        match self {
            Self::SquareRoot => f.square_root(*operands.first()?).map(|root| vec![root]),
            Self::Solve { size, right } => {
                let (matrix, of_right) = operands.split_at(size * size);
                let row = |i: usize| [&matrix[i * size..][..size], &of_right[i * right..][..right]].concat();
                let reduced = reduced(f, (0..size).map(row).collect(), size)?;
                (reduced.pivots == (0..size).collect::<Vec<_>>())
                    .then(|| reduced.rows.iter().flat_map(|row| row[size..].to_vec()).collect())
            }
            Self::NullSpace { rows, columns } => {
                let reduced = reduced(f, operands.chunks(columns).map(<[u32]>::to_vec).collect(), columns)?;
                (reduced.pivots.len() == rows).then(|| mixed_null_space(f, &reduced, columns))
            }
            Self::Least { size, .. } => Some(mixed_values(f, operands, size)),
        }
    }
}

/// One derivation: what it does to which values, and where its results stand among the inputs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Derivation<Id> {
    /// What it does.
    pub kind: DerivationKind,
    /// What it reads, see [`DerivationKind`].
    pub operands: Vec<Id>,
    /// The place of its first result among the inputs.
    pub first_input: usize,
}

impl<Id> Derivation<Id> {
    /// The places of its results among the inputs.
    pub fn inputs(&self) -> std::ops::Range<usize> {
        self.first_input..self.first_input + self.kind.results()
    }
}

/// A matrix in reduced row echelon form: the columns of its pivots, increasing, one for each row.
struct Reduced {
    rows: Vec<Vec<u32>>,
    pivots: Vec<usize>,
}

/// Gauss-Jordan elimination, with pivots in the first columns only; `None` for a row without one.
fn reduced(f: PrimeField, mut rows: Vec<Vec<u32>>, columns: usize) -> Option<Reduced> {
    let mut pivots = Vec::with_capacity(rows.len());
    for column in 0..columns {
        let next = pivots.len();
        let Some(pivot) = (next..rows.len()).find(|&row| rows[row][column] != 0) else { continue };
        rows.swap(next, pivot);
        let inverse = f.inverse(rows[next][column])?;
        rows[next].iter_mut().for_each(|entry| *entry = f.mul(*entry, inverse));
        let of_pivot = rows[next].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|&(at, _)| at != next) {
            let factor = row[column];
            row.iter_mut().zip(&of_pivot).for_each(|(entry, &of)| *entry = f.sub(*entry, f.mul(factor, of)));
        }
        pivots.push(column);
    }
    (pivots.len() == rows.len()).then_some(Reduced { rows, pivots })
}

/// The seed of the matrices that mix null vectors; any constant does.
const MIXING_SEED: u64 = 0x6e75_6c6c;

/// Random numbers that depend on these values alone.
fn random_of(values: impl Iterator<Item = u32>) -> Random {
    // The multiplier of a linear congruential generator by Knuth, MMIX.
    let mixed = |seed: u64, value| seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(u64::from(value) + 1);
    Random::new(values.fold(MIXING_SEED, mixed))
}

/// A mixture of the values of all keys. Those of one key would be taken for the result of every
/// choice, and their zeros for structure of the problem. What is the same for all keys stays.
fn mixed_values(f: PrimeField, operands: &[u32], size: usize) -> Vec<u32> {
    let mut random = random_of(operands.iter().copied());
    let (_, values) = operands.split_at(operands.len() / (1 + size));
    let mut of_keys = values.chunks(size);
    let mut results = of_keys.next().unwrap_or_default().to_vec();
    let first = results.clone();
    for values in of_keys {
        let weight = random.below(u64::from(f.modulus())) as u32;
        for ((result, &value), &of_first) in results.iter_mut().zip(values).zip(&first) {
            *result = f.add(*result, f.mul(weight, f.sub(value, of_first)));
        }
    }
    results
}

/// A basis of the null space without the zeros and ones of the one that an echelon form gives:
/// those would be taken for structure of the problem. The mixing matrix depends on the space alone:
/// equal operands have equal results, and no entry is the same for two different spaces, which
/// would be taken for one value.
fn mixed_null_space(f: PrimeField, reduced: &Reduced, columns: usize) -> Vec<u32> {
    let free: Vec<usize> = (0..columns).filter(|column| !reduced.pivots.contains(column)).collect();
    let mut random = random_of(reduced.rows.iter().flatten().copied());
    let mut results = Vec::with_capacity(free.len() * columns);
    for _ in &free {
        let weights: Vec<u32> = free.iter().map(|_| random.below(u64::from(f.modulus())) as u32).collect();
        let mut vector = vec![0; columns];
        for (&column, &weight) in free.iter().zip(&weights) {
            vector[column] = weight;
            for (row, &pivot) in reduced.rows.iter().zip(&reduced.pivots) {
                vector[pivot] = f.sub(vector[pivot], f.mul(weight, row[column]));
            }
        }
        results.extend(vector);
    }
    results
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::PRIMES;

    const F: PrimeField = PrimeField::new(PRIMES[0]);

    fn drawn(random: &mut Random, count: usize) -> Vec<u32> {
        (0..count).map(|_| random.below(u64::from(F.modulus())) as u32).collect()
    }

    fn dot(a: &[u32], b: impl Iterator<Item = u32>) -> u32 {
        a.iter().zip(b).fold(0, |sum, (&a, b)| F.add(sum, F.mul(a, b)))
    }

    #[test]
    fn entries_of_different_null_spaces_are_different() {
        let mut random = Random::new(3);
        let kind = DerivationKind::NullSpace { rows: 1, columns: 3 };
        let [first, second] = [0; 2].map(|_| drawn(&mut random, 3));
        let [a, b] = [&first, &second].map(|row| kind.over_prime_field(F, row).unwrap());
        assert!(a.iter().all(|entry| !b.contains(entry)), "{a:?} {b:?}");
        // That of a multiple is the same space.
        let doubled: Vec<u32> = first.iter().map(|&x| F.add(x, x)).collect();
        assert_eq!(kind.over_prime_field(F, &doubled).unwrap(), a);
    }

    #[test]
    fn solutions_satisfy_their_equations() {
        let mut random = Random::new(1);
        for (size, right) in [(1, 1), (2, 5), (4, 1), (7, 3)] {
            let kind = DerivationKind::Solve { size, right };
            let operands = drawn(&mut random, kind.operands());
            let x = kind.over_prime_field(F, &operands).unwrap();
            assert_eq!(x.len(), kind.results());
            for (row, column) in (0..size).flat_map(|row| (0..right).map(move |column| (row, column))) {
                let product = dot(&operands[row * size..][..size], (0..size).map(|k| x[k * right + column]));
                assert_eq!(product, operands[size * size + row * right + column]);
            }
        }
    }

    #[test]
    fn null_vectors_are_annihilated_and_have_no_zeros() {
        let mut random = Random::new(2);
        for (rows, columns) in [(1, 2), (5, 9), (6, 9), (3, 4)] {
            let kind = DerivationKind::NullSpace { rows, columns };
            let operands = drawn(&mut random, kind.operands());
            let vectors = kind.over_prime_field(F, &operands).unwrap();
            assert_eq!(vectors.len(), kind.results());
            for vector in vectors.chunks(columns) {
                assert!(vector.iter().all(|&entry| entry != 0));
                operands.chunks(columns).for_each(|row| assert_eq!(dot(row, vector.iter().copied()), 0));
            }
        }
    }

    #[test]
    fn choices_are_mixed_but_for_what_all_share() {
        let kind = DerivationKind::Least { keys: 3, size: 2 };
        let chosen = kind.over_prime_field(F, &[5, 6, 7, 10, 9, 20, 9, 30, 9]).unwrap();
        assert_eq!(chosen[1], 9);
        assert!(![0, 10, 20, 30].contains(&chosen[0]), "{chosen:?}");
        assert_eq!((kind.operands(), kind.results()), (9, 2));
    }

    #[test]
    fn lost_rank_is_noticed() {
        let of_rank_1 = [1, 2, 3, 2, 4, 6];
        assert_eq!(DerivationKind::NullSpace { rows: 2, columns: 3 }.over_prime_field(F, &of_rank_1), None);
        assert_eq!(DerivationKind::Solve { size: 2, right: 1 }.over_prime_field(F, &[1, 2, 2, 4, 1, 1]), None);
    }
}
