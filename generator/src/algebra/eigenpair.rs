//! Eigenvalues and eigenvectors of a matrix over Z_p, all at once and without leaving the field.
//!
//! Eigenvalues lie in extensions of Z_p. None is computed: they stay the roots of a polynomial, and
//! an eigenvector is a vector of polynomials v(t) that is an eigenvector at each root t.

use super::hessenberg::CyclicBlocks;
use super::{DenseMatrix, PrimeField, Random, Univariate};

/// The eigenvectors of a matrix T that have one eigenvalue each, as polynomials in the eigenvalue.
///
/// Let w be a random vector and m(t) = t^d + .. + m_1 t + m_0 the polynomial of least degree with
/// m(T) w = 0. With probability about 1 - n / p it is the minimal polynomial of T, and its roots
/// are all eigenvalues. Then
///
/// ```text
///   v(t) = sum over i of t^i sum over j of m_(i+j+1) T^j w
///
///   (t - T) v(t) = m(t) w - m(T) w = m(t) w
/// ```
///
/// so that v(t) is an eigenvector at each root t of m. It is not 0 there: a polynomial in T of a
/// degree below d would annihilate w. Where an eigenvalue has one eigenvector up to a factor, this
/// is it.
#[derive(Clone, Debug)]
pub struct Eigenpair {
    field: PrimeField,
    /// w, T w, .. , T^(d-1) w.
    krylov: Vec<Vec<u32>>,
    /// m.
    minimal: Univariate,
    /// The characteristic polynomials of the other cyclic blocks.
    others: Vec<Univariate>,
}

impl Eigenpair {
    /// The eigenpairs of a square matrix.
    pub fn of(matrix: &DenseMatrix, random: &mut Random) -> Self {
        let field = matrix.field();
        let CyclicBlocks { start, polynomials } = CyclicBlocks::of(matrix, random);
        let mut polynomials = polynomials.into_iter();
        let minimal = polynomials.next().unwrap_or_else(|| Univariate::constant(1));
        let mut krylov = Vec::with_capacity(minimal.degree());
        let mut power = start;
        for _ in 0..minimal.degree() {
            let next = matrix.times_column(&power);
            krylov.push(std::mem::replace(&mut power, next));
        }
        Self { field, krylov, minimal, others: polynomials.collect() }
    }

    /// The minimal polynomial m.
    pub fn minimal(&self) -> &Univariate {
        &self.minimal
    }

    /// Further polynomials, such that no eigenvalue has more independent eigenvectors than 1 plus
    /// the number of these of which it is a root.
    pub fn others(&self) -> &[Univariate] {
        &self.others
    }

    /// One entry of v(t).
    pub fn entry(&self, at: usize) -> Univariate {
        self.polynomial(self.krylov.iter().map(|power| power[at]).collect())
    }

    /// The product of a row vector with v(t).
    pub fn combination(&self, row: &[u32]) -> Univariate {
        self.polynomial(self.krylov.iter().map(|power| self.field.dot(row, power)).collect())
    }

    /// sum over i of t^i sum over j of m_(i+j+1) sequence_j.
    fn polynomial(&self, sequence: Vec<u32>) -> Univariate {
        let m = self.minimal.coefficients();
        Univariate::new((1..m.len()).map(|first| self.field.dot(&m[first..], &sequence)).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::PRIMES;

    const F: PrimeField = PrimeField::new(PRIMES[0]);

    fn of(coefficients: &[i64]) -> Univariate {
        Univariate::new(coefficients.iter().map(|&value| F.from_integer(value)).collect())
    }

    fn matrix(rows: &[&[i64]]) -> DenseMatrix {
        let rows: Vec<Vec<u32>> =
            rows.iter().map(|row| row.iter().map(|&value| F.from_integer(value)).collect()).collect();
        DenseMatrix::from_rows(F, rows.len(), &rows)
    }

    /// T v(t) = t v(t) modulo m, and v has no factor in common with m.
    fn check(matrix: &DenseMatrix) -> Eigenpair {
        let pair = Eigenpair::of(matrix, &mut Random::new(7));
        let m = pair.minimal().clone();
        let mut common = m.clone();
        for row in 0..matrix.rows() {
            let entry = pair.entry(row);
            common = common.gcd(F, &entry);
            assert_eq!(pair.combination(matrix.row(row)).modulo(F, &m), entry.times(F, &Univariate::t()).modulo(F, &m));
        }
        assert_eq!(common.degree(), 0);
        let degrees = pair.others().iter().map(Univariate::degree).sum::<usize>() + m.degree();
        assert_eq!(degrees, matrix.rows());
        pair
    }

    #[test]
    fn eigenvectors_are_found_at_simple_and_at_multiple_eigenvalues() {
        // Eigenvalues 2, 3 and 5; then 2 twice with one eigenvector; then 2 twice with two.
        let simple = check(&matrix(&[&[2, 1, 0], &[0, 3, 4], &[0, 0, 5]]));
        assert_eq!((simple.minimal(), simple.others()), (&of(&[-30, 31, -10, 1]), [].as_slice()));
        let defective = check(&matrix(&[&[2, 1, 0], &[0, 2, 0], &[0, 0, 5]]));
        assert_eq!((defective.minimal(), defective.others()), (&of(&[-20, 24, -9, 1]), [].as_slice()));
        let shared = check(&matrix(&[&[2, 0, 0], &[0, 2, 0], &[0, 0, 5]]));
        assert_eq!((shared.minimal(), shared.others()), (&of(&[10, -7, 1]), [of(&[-2, 1])].as_slice()));
    }

    #[test]
    fn eigenvectors_of_random_matrices_are_eigenvectors() {
        let mut random = Random::new(5);
        for size in [1, 2, 7, 20] {
            let rows: Vec<Vec<u32>> =
                (0..size).map(|_| (0..size).map(|_| random.below(1 << 30) as u32).collect()).collect();
            let pair = check(&DenseMatrix::from_rows(F, size, &rows));
            assert_eq!(pair.minimal().degree(), size);
        }
        check(&DenseMatrix::zeros(F, 4, 4));
        check(&DenseMatrix::identity(F, 5));
    }
}
