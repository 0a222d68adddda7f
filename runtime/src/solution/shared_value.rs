//! Solutions that share a value of the action monomial.
//!
//! Such solutions share an eigenvalue, whose eigenvectors are arbitrary combinations of theirs.
//! Other monomials tell them apart (as in Möller and Stetter 1995; here only on the subspace in
//! question):
//!
//! ```text
//!       [ | .. | ]   basis of the invariant subspace    V_m:  its values at monomials m
//!   V = [ v1.. vk]   v = V u for every solution         V_(x m):  its values at the monomials x m
//!       [ | .. | ]
//!                    V_(x m) = V_m A_x (least squares): u is an eigenvector of A_x
//!                                                       for the eigenvalue x
//! ```
//!
//! All A_x have the same eigenvectors, so a combination of them over the unknowns x tells apart
//! solutions that differ in any unknown. V and A_x are real; u is complex if the solution is
//! complex.

use num_complex::Complex;

use crate::error::SolveError;
use crate::number::{Scalar, float};
use crate::size::{Matrix, Size, Square, filled_matrix};
use crate::solver_instance::{EigenpairSource, SolverInstance};
use crate::spectrum::hessenberg::Hessenberg;
use crate::spectrum::invariant_subspace::Cluster;

/// An unknown takes part only if V_m has no singular value below about the square root of this,
/// relative to the largest. Otherwise A_x would consist of rounding errors.
const RANK: f64 = 1e-10;

/// The vectors u = 1, w, w^2, .. that are tried if the values of monomials do not determine u:
/// these are the values w, in all directions.
const PROBES: [Complex<f64>; 12] = [
    Complex { re: 0.2, im: 0.0 },
    Complex { re: -0.2, im: 0.0 },
    Complex { re: 0.7, im: 0.0 },
    Complex { re: -0.7, im: 0.0 },
    Complex { re: 1.5, im: 0.0 },
    Complex { re: -1.5, im: 0.0 },
    Complex { re: 5.0, im: 0.0 },
    Complex { re: -5.0, im: 0.0 },
    Complex { re: 0.0, im: 0.5 },
    Complex { re: 0.0, im: 2.0 },
    Complex { re: 1.0, im: 1.0 },
    Complex { re: -1.0, im: 1.0 },
];

/// The function that is called for each eigenvalue of a source.
type Solve<'a, B> = dyn FnMut(&dyn EigenpairSource<B>, Complex<f64>) + 'a;

/// The solutions with one value of the action monomial, or with a value and its conjugate.
pub(crate) struct SharedValue<'a, B: Size> {
    size: B,
    action: &'a Square<B, f64>,
    /// V, transposed; `dimension` rows.
    basis: &'a mut Square<B, f64>,
    dimension: usize,
    /// A combination of the A_x in the leading rows and columns. Behind it is a diagonal matrix
    /// that shares no eigenvalue with it.
    combination: &'a mut Hessenberg<B>,
    /// Whether some A_x is undetermined.
    incomplete: bool,
}

impl<'a, B: Size> SharedValue<'a, B> {
    /// No solutions yet. `basis` and `combination` are memory that serves one cluster after
    /// another.
    #[inline]
    pub(crate) fn new(
        size: B,
        action: &'a Square<B, f64>,
        basis: &'a mut Square<B, f64>,
        combination: &'a mut Hessenberg<B>,
    ) -> Self {
        SharedValue { size, action, basis, dimension: 0, combination, incomplete: false }
    }

    /// Finds the subspace and the combined A_x of the solutions of a cluster.
    ///
    /// # Errors
    /// As [`Hessenberg::reduce`], if values overflow.
    #[inline(never)]
    pub(crate) fn find<I: SolverInstance<Basis = B>>(
        &mut self,
        solver: &I,
        spectrum: &Hessenberg<B>,
        cluster: &Cluster,
    ) -> Result<(), SolveError> {
        spectrum.invariant_subspace(cluster, self.basis);
        self.dimension = cluster.dimension.min(self.size.get());
        self.combine(solver)
    }

    /// Combines the A_x.
    #[inline(never)]
    fn combine<I: SolverInstance<Basis = B>>(&mut self, solver: &I) -> Result<(), SolveError> {
        let (size, dimension) = (self.size, self.dimension);
        let known = self.monomial_values(solver);
        self.combination.clear();
        self.incomplete = false;
        let (sum, mut total) = (&mut self.combination.matrix, 0.0);
        let mut weight = 1.0;
        for unknown in 0..solver.sizes().unknowns.get() {
            let pairs = solver.ratios(unknown);
            if pairs.is_empty() {
                continue;
            }
            let (mut gram, mut matrix) = (filled_matrix(size, size, 0.0), filled_matrix(size, size, 0.0));
            let (gram, matrix) = (&mut Rows::<B>(&mut gram), &mut Rows::<B>(&mut matrix));
            if !multiplication(&|row, monomial| known.at(row, monomial), (dimension, pairs), gram, matrix) {
                self.incomplete = true;
                continue;
            }
            let entries = || matrix.0.as_ref().iter().flat_map(|row| row.as_ref());
            let norm = float::sqrt(entries().map(|entry| entry * entry).sum());
            if norm > 0.0 {
                for (row, values) in sum.as_mut().iter_mut().zip(matrix.0.as_ref()) {
                    for (entry, value) in row.as_mut().iter_mut().zip(values.as_ref()) {
                        *entry += weight / norm * value;
                    }
                }
                total += weight;
                // Weights are neither equal nor in a rational ratio, as differences of solutions
                // could be.
                weight *= 0.786_151_377_757_423_3;
            }
        }
        for k in dimension..size.get() {
            sum[k][k] = 2.0 * total;
        }
        self.combination.reduce_in_place()
    }

    /// The values of the monomials on the basis, a row for each basis vector.
    ///
    /// They are linear in the vector; those of the image are linear in the action's value, too,
    /// which here is the matrix: K0 V + K1 T V, where K(value, v) = K0 v + value K1 v.
    fn monomial_values<I: SolverInstance<Basis = B>>(&self, solver: &I) -> MonomialValues<B, I::Values> {
        let count = solver.sizes().values;
        let mut rows = filled_matrix(self.size, count, 0.0);
        for (values, vector) in rows.as_mut().iter_mut().zip(self.basis.as_ref()) {
            let mut image = self.size.filled(0.0);
            for (entry, row) in image.as_mut().iter_mut().zip(self.action.as_ref()) {
                *entry = row.as_ref().iter().zip(vector.as_ref()).map(|(a, b)| a * b).sum();
            }
            let (without, with) = (solver.monomial_values(0.0, &image), solver.monomial_values(1.0, &image));
            *values = solver.monomial_values(0.0, vector);
            for i in 0..count.get() {
                values[i] += with[i] - without[i];
            }
        }
        MonomialValues { rows }
    }

    /// Calls `solve` for the eigenpair of each solution, given as a source and the value under
    /// which the source lists it.
    ///
    /// If the known monomials do not determine the A_x of all unknowns, `solve` is also called for
    /// some other combinations of the solutions, from which the polish may find them.
    #[inline(never)]
    pub(crate) fn for_each(&self, solve: &mut Solve<'_, B>) {
        if let Ok(values) = self.combination.eigenvalues() {
            let separated = Combinations { shared: self, separated: true };
            // The eigenvalues of diagonal blocks come in the order of the blocks.
            for &value in &values.as_ref()[..self.dimension] {
                solve(&separated, value);
            }
        }
        if self.incomplete {
            let probes = Combinations { shared: self, separated: false };
            for value in PROBES {
                solve(&probes, value);
            }
        }
    }
}

/// Combinations V u of the solutions with a shared value: u is an eigenvector of the combined A_x,
/// or 1, w, w^2, ..
struct Combinations<'a, B: Size> {
    shared: &'a SharedValue<'a, B>,
    separated: bool,
}

impl<B: Size> EigenpairSource<B> for Combinations<'_, B> {
    fn real(&self, value: f64) -> (f64, B::Vector<f64>) {
        self.eigenpair(value)
    }

    fn complex(&self, value: Complex<f64>) -> (Complex<f64>, B::Vector<Complex<f64>>) {
        self.eigenpair(value)
    }
}

impl<B: Size> Combinations<'_, B> {
    fn eigenpair<S: Scalar>(&self, value: S) -> (S, B::Vector<S>) {
        let SharedValue { size, action, basis, dimension, combination, .. } = self.shared;
        let n = size.get();
        let u = if self.separated {
            combination.eigenvector(value)
        } else {
            let mut powers = size.filled(S::ONE);
            for k in 1..n {
                powers[k] = powers[k - 1] * value;
            }
            powers
        };
        let mut vector = size.filled(S::ZERO);
        for k in 0..*dimension {
            for i in 0..n {
                vector[i] += u[k].scale(basis[k][i]);
            }
        }
        // The value of the action is the Rayleigh quotient.
        let (mut numerator, mut denominator) = (S::ZERO, 0.0);
        for i in 0..n {
            let image = (0..n).fold(S::ZERO, |sum, j| sum + vector[j].scale(action[i][j]));
            numerator += vector[i].conj() * image;
            denominator += vector[i].modulus_squared();
        }
        (numerator.scale(1.0 / denominator), vector)
    }
}

/// The values of the monomials on the basis: a row for each basis vector.
struct MonomialValues<B: Size, K: Size> {
    rows: Matrix<B, K, f64>,
}

impl<B: Size, K: Size> MonomialValues<B, K> {
    /// The value of a monomial on a basis vector; NaN if there is no such monomial.
    fn at(&self, row: usize, monomial: u16) -> f64 {
        self.rows[row].as_ref().get(usize::from(monomial)).copied().unwrap_or(f64::NAN)
    }
}

/// A matrix of any size behind a reference, so that code that runs rarely is compiled once for all
/// solvers.
trait Entries {
    fn at(&mut self, row: usize, column: usize) -> &mut f64;
}

struct Rows<'a, B: Size>(&'a mut Square<B, f64>);

impl<B: Size> Entries for Rows<'_, B> {
    fn at(&mut self, row: usize, column: usize) -> &mut f64 {
        &mut self.0[row][column]
    }
}

/// Computes A_x in the leading rows and columns of `right`, by the normal equations V_m^T V_m A_x =
/// V_m^T V_(x m) and Cholesky's factorisation. Returns false if V_m lacks rank. The polish recovers
/// the digits that normal equations lose. `value(row, monomial)` is the value of a monomial on a
/// basis vector; `gram` is working memory. Both matrices must be zero before the call.
#[inline(never)]
fn multiplication(
    value: &dyn Fn(usize, u16) -> f64,
    (dimension, pairs): (usize, &[(u16, u16)]),
    gram: &mut dyn Entries,
    right: &mut dyn Entries,
) -> bool {
    for i in 0..dimension {
        for j in 0..dimension {
            for &(from, to) in pairs {
                let factor = value(i, from);
                *gram.at(i, j) += factor * value(j, from);
                *right.at(i, j) += factor * value(j, to);
            }
        }
    }
    // gram = L L^T, with L in its lower half; right := L^-1 right.
    for i in 0..dimension {
        let size = *gram.at(i, i);
        for j in 0..i {
            let dot: f64 = (0..j).map(|k| *gram.at(i, k) * *gram.at(j, k)).sum();
            *gram.at(i, j) = (*gram.at(i, j) - dot) / *gram.at(j, j);
        }
        let square = size - (0..i).map(|k| *gram.at(i, k) * *gram.at(i, k)).sum::<f64>();
        if !(square > RANK * size) {
            return false;
        }
        *gram.at(i, i) = float::sqrt(square);
        for j in 0..dimension {
            let dot: f64 = (0..i).map(|k| *gram.at(i, k) * *right.at(k, j)).sum();
            *right.at(i, j) = (*right.at(i, j) - dot) / *gram.at(i, i);
        }
    }
    for i in (0..dimension).rev() {
        for j in 0..dimension {
            let dot: f64 = (i + 1..dimension).map(|k| *gram.at(k, i) * *right.at(k, j)).sum();
            *right.at(i, j) = (*right.at(i, j) - dot) / *gram.at(i, i);
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::size::Fixed;

    /// V_m of 3 basis vectors at 4 monomials, and V_(x m) = V_m A_x, with the scale of each basis
    /// vector.
    struct Known {
        values: [[f64; 4]; 3],
        images: [[f64; 4]; 3],
    }

    const A: [[f64; 3]; 3] = [[2.0, -1.0, 0.5], [0.25, 3.0, 1.0], [-4.0, 1.5, -2.0]];
    /// The monomials and their products.
    const PAIRS: [(u16, u16); 4] = [(0, 4), (1, 5), (2, 6), (3, 7)];

    impl Known {
        /// From a matrix with a row for each monomial and a column for each basis vector.
        fn new(v: [[f64; 3]; 4]) -> Self {
            let values = core::array::from_fn(|k| core::array::from_fn(|m| v[m][k]));
            let images = core::array::from_fn(|k| core::array::from_fn(|m| (0..3).map(|l| v[m][l] * A[l][k]).sum()));
            Self { values, images }
        }

        /// A_x, or nothing; in the leading part of a matrix of four rows.
        fn multiplication(&self, pairs: &[(u16, u16)]) -> Option<[[f64; 4]; 4]> {
            let (mut gram, mut right) = ([[0.0; 4]; 4], [[0.0; 4]; 4]);
            let value = |row: usize, monomial: u16| match usize::from(monomial) {
                at @ 0..4 => self.values[row][at],
                at => self.images[row][at - 4],
            };
            let (gram, matrix) = (&mut Rows::<Fixed<4>>(&mut gram), &mut Rows::<Fixed<4>>(&mut right));
            multiplication(&value, (3, pairs), gram, matrix).then_some(right)
        }
    }

    /// The difference of A_x from A, relative to its entries.
    fn difference(found: Option<[[f64; 4]; 4]>) -> f64 {
        let Some(found) = found else { return f64::INFINITY };
        let expected = |i: usize, j: usize| if i < 3 && j < 3 { A[i][j] } else { 0.0 };
        let pairs = (0..4).flat_map(|i| (0..4).map(move |j| (i, j)));
        pairs.map(|(i, j)| (found[i][j] - expected(i, j)).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn multiplication_by_an_unknown_follows_from_enough_monomials() {
        let regular = [[1.0, 0.5, -2.0], [3.0, -1.0, 0.25], [-0.5, 2.0, 1.0], [0.1, 0.2, 0.3]];
        assert!(difference(Known::new(regular).multiplication(&PAIRS)) < 1e-13);
        assert!(difference(Known::new(regular).multiplication(&PAIRS[..3])) < 1e-13);
        assert_eq!(Known::new(regular).multiplication(&PAIRS[1..3]), None, "two monomials for three vectors");
        assert_eq!(Known::new(regular).multiplication(&[]), None);
    }

    /// The third vector is within e of the first: the square of e, relative, is compared with
    /// 1e-10.
    #[test]
    fn a_basis_without_rank_determines_nothing() {
        for unit in [1e-3, 1.0, 1e3] {
            let at = |e: f64| {
                let regular = [[1.0, 0.0, 1.0], [0.0, 1.0, e], [0.0, 0.0, e], [0.0, 2.0, 0.0]];
                Known::new(regular.map(|row| row.map(|x| x * unit))).multiplication(&PAIRS)
            };
            assert!(difference(at(1e-4)) < 1e-6, "{unit}");
            assert_eq!([at(1e-6), at(0.0)], [None, None], "{unit}");
        }
        assert_eq!(Known::new([[f64::NAN; 3]; 4]).multiplication(&PAIRS), None);
    }
}
