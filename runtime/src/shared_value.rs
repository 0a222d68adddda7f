//! Solutions that share a value of the action monomial.
//!
//! They share an eigenvalue, whose eigenvectors are arbitrary combinations of theirs. Other monomials tell them apart
//! (as in Möller and Stetter 1995; here only on the subspace in question):
//!
//! ```text
//!       [ | .. | ]   basis of the invariant subspace             V_m:  its values at monomials m
//!   V = [ v1.. vk]   v = V u for every solution              V_(x m):  its values at the monomials x m
//!       [ | .. | ]
//!                    V_(x m) = V_m A_x    (least squares):  u is an eigenvector of A_x for the eigenvalue x
//! ```
//!
//! All A_x have the same eigenvectors, so a combination of them over the unknowns x tells apart solutions that differ in
//! any of them. V and A_x are real; u is complex where the solution is.

use num_complex::Complex;

use crate::driver::ActionMethod;
use crate::error::SolveError;
use crate::extract::Eigenpairs;
use crate::float;
use crate::hessenberg::Hessenberg;
use crate::invariant_subspace::Cluster;
use crate::scalar::{Scalar, mapped};

/// An unknown takes part only where V_m has no singular value below about the square root of this, relative to the
/// largest: otherwise rounding errors would make up its A_x.
const RANK: f64 = 1e-10;

/// What u to try, as 1, w, w^2, .., where the values of monomials do not determine them: in all directions.
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

/// The solutions with one value of the action monomial, or with conjugate values.
pub(crate) struct SharedValue<'a, const B: usize> {
    action: &'a [[f64; B]; B],
    /// V, transposed; `dimension` rows.
    basis: &'a mut [[f64; B]; B],
    dimension: usize,
    /// A combination of the A_x in the leading rows and columns; behind it a diagonal matrix with no eigenvalue of it.
    combination: &'a mut Hessenberg<B>,
    /// Whether some A_x is not determined.
    incomplete: bool,
}

impl<'a, const B: usize> SharedValue<'a, B> {
    /// None yet; `basis` and `combination` are memory for one after the other.
    #[inline]
    pub(crate) fn new(
        action: &'a [[f64; B]; B],
        basis: &'a mut [[f64; B]; B],
        combination: &'a mut Hessenberg<B>,
    ) -> Self {
        SharedValue { action, basis, dimension: 0, combination, incomplete: false }
    }

    /// Finds what the solutions of a cluster are combinations of.
    ///
    /// # Errors
    /// As [`Hessenberg::reduce`], where values overflow.
    #[inline(never)]
    pub(crate) fn find<const N: usize, const K: usize, M: ActionMethod<B, N, K>>(
        &mut self,
        method: &M,
        spectrum: &Hessenberg<B>,
        cluster: &Cluster,
    ) -> Result<(), SolveError> {
        spectrum.invariant_subspace(cluster, self.basis);
        self.dimension = cluster.dimension.min(B);
        self.combine(method)
    }

    /// Combines the A_x.
    #[inline(never)]
    fn combine<const N: usize, const K: usize, M: ActionMethod<B, N, K>>(
        &mut self,
        method: &M,
    ) -> Result<(), SolveError> {
        let Self { action, basis, dimension, .. } = &*self;
        let dimension = *dimension;
        // Known monomials are linear in the vector, those of the image also in the action's value, which here is the
        // matrix: K0 V + K1 T V, where K(value, v) = K0 v + value K1 v.
        let mut known = [[0.0; K]; B];
        for (values, vector) in known.iter_mut().zip(basis.iter()) {
            let image = mapped(action, |row| (0..B).map(|i| row[i] * vector[i]).sum());
            let (without, with) = (method.known(0.0, &image), method.known(1.0, &image));
            *values = method.known(0.0, vector);
            for i in 0..K {
                values[i] += with[i] - without[i];
            }
        }
        self.combination.clear();
        self.incomplete = false;
        let (sum, mut total) = (&mut self.combination.matrix, 0.0);
        let mut weight = 1.0;
        for pairs in M::PAIRS.iter().filter(|pairs| !pairs.is_empty()) {
            let (mut gram, mut matrix) = ([[0.0; B]; B], [[0.0; B]; B]);
            let values = Values { known: known.as_flattened(), width: K };
            if !values.multiplication(dimension, pairs, gram.as_flattened_mut(), matrix.as_flattened_mut(), B) {
                self.incomplete = true;
                continue;
            }
            let norm = float::sqrt(matrix.as_flattened().iter().map(|entry| entry * entry).sum());
            if norm > 0.0 {
                for (entry, value) in sum.as_flattened_mut().iter_mut().zip(matrix.as_flattened()) {
                    *entry += weight / norm * value;
                }
                total += weight;
                // Neither equal nor of a rational ratio, which differences of solutions could have, too.
                weight *= 0.786_151_377_757_423_3;
            }
        }
        for k in dimension..B {
            sum[k][k] = 2.0 * total;
        }
        self.combination.reduce_in_place()
    }

    /// Calls `solve` for the eigenpairs of all solutions, as a source and what it lists them under.
    ///
    /// Where the known monomials do not determine the A_x of all unknowns, also for some other combinations of the
    /// solutions, from which the polish may find them.
    #[inline(never)]
    pub(crate) fn for_each(&self, solve: &mut dyn FnMut(&dyn Eigenpairs<B>, Complex<f64>)) {
        if let Ok(values) = self.combination.eigenvalues() {
            let separated = Combinations { shared: self, separated: true };
            // Eigenvalues of diagonal blocks come in the order of the blocks.
            for &value in &values[..self.dimension] {
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

/// Combinations V u of the solutions with a shared value: for an eigenvalue of the combined A_x its eigenvector u, or
/// u = 1, w, w^2, ..
struct Combinations<'a, const B: usize> {
    shared: &'a SharedValue<'a, B>,
    separated: bool,
}

impl<const B: usize> Eigenpairs<B> for Combinations<'_, B> {
    fn real(&self, value: f64) -> (f64, [f64; B]) {
        self.eigenpair(value)
    }

    fn complex(&self, value: Complex<f64>) -> (Complex<f64>, [Complex<f64>; B]) {
        self.eigenpair(value)
    }
}

impl<const B: usize> Combinations<'_, B> {
    fn eigenpair<S: Scalar>(&self, value: S) -> (S, [S; B]) {
        let SharedValue { action, basis, dimension, combination, .. } = self.shared;
        let u = if self.separated {
            combination.eigenvector(value)
        } else {
            let mut powers = [S::ONE; B];
            for k in 1..B {
                powers[k] = powers[k - 1] * value;
            }
            powers
        };
        let mut vector = [S::ZERO; B];
        for k in 0..*dimension {
            for i in 0..B {
                vector[i] += u[k].scale(basis[k][i]);
            }
        }
        // The Rayleigh quotient.
        let (mut numerator, mut denominator) = (S::ZERO, 0.0);
        for i in 0..B {
            let image = (0..B).fold(S::ZERO, |sum, j| sum + vector[j].scale(action[i][j]));
            numerator += vector[i].conj() * image;
            denominator += vector[i].modulus_squared();
        }
        (numerator.scale(1.0 / denominator), vector)
    }
}

/// The values of the known monomials on the basis: a row of `width` for each basis vector.
struct Values<'a> {
    known: &'a [f64],
    width: usize,
}

impl Values<'_> {
    /// The value of a monomial on basis vector `row`; NaN where there is none.
    fn at(&self, row: usize, monomial: u16) -> f64 {
        self.known.get(row * self.width + usize::from(monomial)).copied().unwrap_or(f64::NAN)
    }

    /// A_x in the leading rows and columns of `right`, by the normal equations V_m^T V_m A_x = V_m^T V_(x m) and Cholesky's
    /// factorisation; false where V_m lacks rank. The polish gives back the digits that this costs. `gram` is working memory; both are
    /// zero before, with rows of `stride`.
    ///
    /// On slices, because it runs rarely: compiled once for all solvers.
    #[inline(never)]
    fn multiplication(
        &self,
        dimension: usize,
        pairs: &[(u16, u16)],
        gram: &mut [f64],
        right: &mut [f64],
        stride: usize,
    ) -> bool {
        let at = |i: usize, j: usize| i * stride + j;
        for i in 0..dimension {
            for j in 0..dimension {
                for &(from, to) in pairs {
                    let value = self.at(i, from);
                    gram[at(i, j)] += value * self.at(j, from);
                    right[at(i, j)] += value * self.at(j, to);
                }
            }
        }
        // gram = L L^T, L over its lower half; right := L^-1 right.
        for i in 0..dimension {
            let size = gram[at(i, i)];
            for j in 0..i {
                let dot: f64 = (0..j).map(|k| gram[at(i, k)] * gram[at(j, k)]).sum();
                gram[at(i, j)] = (gram[at(i, j)] - dot) / gram[at(j, j)];
            }
            let square = size - (0..i).map(|k| gram[at(i, k)] * gram[at(i, k)]).sum::<f64>();
            if !(square > RANK * size) {
                return false;
            }
            gram[at(i, i)] = float::sqrt(square);
            for j in 0..dimension {
                let dot: f64 = (0..i).map(|k| gram[at(i, k)] * right[at(k, j)]).sum();
                right[at(i, j)] = (right[at(i, j)] - dot) / gram[at(i, i)];
            }
        }
        for i in (0..dimension).rev() {
            for j in 0..dimension {
                let dot: f64 = (i + 1..dimension).map(|k| gram[at(k, i)] * right[at(k, j)]).sum();
                right[at(i, j)] = (right[at(i, j)] - dot) / gram[at(i, i)];
            }
        }
        true
    }
}
