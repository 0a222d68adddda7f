//! Clusters of nearly equal eigenvalues and the invariant subspaces that belong to them.

use crate::number::Scalar;
use crate::number::scalar::mapped;
use crate::size::{List, Size, Square, Vector};
use crate::spectrum::hessenberg::Hessenberg;
use crate::spectrum::inverse_iteration::{ShiftedLu, normalize};
use num_complex::Complex;

/// Eigenvalues this close, relative to their modulus, belong together: rounding takes five or more
/// digits from their separate eigenvectors.
const NEAR: f64 = 1e-3;

/// Eigenvalues this close, relative to the norm of H, belong together, however small they are.
const NEAR_TO_NORM: f64 = 1e-10;

/// Rounds of inverse iteration. With the shift chosen here two or three suffice; near another
/// cluster more are needed.
const ROUNDS: usize = 6;

/// The distance of the shift from a cluster, relative to the distance of the next eigenvalue. A
/// smaller distance speeds up the convergence. A larger one saves digits if the eigenvalue is
/// defective, because one round then multiplies the directions of the subspace by factors whose
/// ratio is 1 / distance^2.
const SHIFT: f64 = 1e-3;

/// Eigenvalues of H that are equal up to rounding, or nearly equal, together with their conjugates.
/// There are at least two, or a multiple complex one and its conjugate.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cluster {
    /// The mean. If the conjugates form a cluster of their own, the one with positive imaginary
    /// part.
    centre: Complex<f64>,
    /// The distance of the shift of the inverse iteration.
    shift: f64,
    /// The dimension of the invariant subspace: conjugates are counted.
    pub(crate) dimension: usize,
}

impl<Z: Size> Hessenberg<Z> {
    /// The clusters among all eigenvalues of A.
    pub(crate) fn clusters(&self, values: &Z::Vector<Complex<f64>>) -> Z::List<Cluster> {
        let values = mapped(self.size, values, |value: Complex<f64>| value.scale(1.0 / self.unit));
        let mut clusters = self.size.list();
        // There are at most half as many clusters as eigenvalues, so the list has room.
        find_clusters(values.as_ref(), self.norm, self.size.filled(0).as_mut(), &mut |cluster| {
            clusters.push(cluster);
        });
        clusters
    }

    /// Writes an orthonormal basis of the real invariant subspace of A that belongs to a cluster to
    /// the first `dimension` rows of `basis`.
    ///
    /// Block inverse iteration (Golub and Van Loan 2013, section 7.6) with the real operator
    /// Im (H - s I)^-1, which has the eigenvectors of H and, for eigenvalues x near the shift s or
    /// its conjugate, eigenvalues near 1 / |x - s| or above.
    #[inline(never)]
    pub(crate) fn invariant_subspace(&self, cluster: &Cluster, basis: &mut Square<Z, f64>) {
        let shift = cluster.centre + Complex { re: 0.0, im: cluster.shift };
        let mut lu = ShiftedLu::new(self.size);
        lu.factor(self, shift);
        let vectors = &mut basis.as_mut()[..cluster.dimension.min(self.size.get())];
        let mut state = 1_u64;
        for entry in vectors.iter_mut().flat_map(|vector| vector.as_mut()) {
            // Knuth's multiplicative congruential generator: any start without structure serves.
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            *entry = (state >> 40) as f64 * 2.0 / (1_u64 << 24) as f64 - 1.0;
        }
        orthonormalize(vectors);
        for _ in 0..ROUNDS {
            for vector in vectors.iter_mut() {
                let mut solution = mapped(self.size, vector, <Complex<f64> as Scalar>::from_f64);
                lu.forward(&mut solution);
                lu.backward(&mut solution);
                *vector = mapped(self.size, &solution, |entry: Complex<f64>| entry.im);
            }
            orthonormalize(vectors);
        }
        vectors.iter_mut().for_each(|vector| self.transform_back(vector));
        orthonormalize(vectors);
    }
}

/// Calls `found` for the clusters among the eigenvalues of a matrix of that norm. `first` is
/// working memory: the first member of the cluster of each eigenvalue. The function works on slices
/// and is compiled once for all solvers, because it runs rarely.
#[inline(never)]
fn find_clusters(values: &[Complex<f64>], norm: f64, first: &mut [usize], found: &mut dyn FnMut(Cluster)) {
    let distance = |a: Complex<f64>, b: Complex<f64>| (a - b).modulus();
    let n = values.len().min(first.len());
    for i in 0..n {
        first[i] = i;
        for j in 0..i {
            let size = values[i].modulus().max(values[j].modulus());
            if distance(values[i], values[j]) <= NEAR * size + NEAR_TO_NORM * norm {
                let (from, to) = (first[i].max(first[j]), first[i].min(first[j]));
                first[..=i].iter_mut().filter(|label| **label == from).for_each(|label| *label = to);
            }
        }
    }
    for label in 0..n {
        let members = || (0..n).filter(|&i| first[i] == label);
        let size = members().count();
        if size < 2 {
            continue;
        }
        let sum = members().fold(Complex::ZERO, |sum, i| sum + values[i]);
        let mut centre = sum.scale(1.0 / size as f64);
        // A set that is its own conjugate has a real mean, up to rounding. Of two sets that are
        // conjugates one is taken.
        let own_conjugate = members().any(|i| members().any(|j| values[i] == values[j].conj()));
        if own_conjugate {
            centre.im = 0.0;
        } else if centre.im < 0.0 {
            continue;
        }
        let radius = members().map(|i| distance(values[i], centre)).fold(0.0, f64::max);
        let is_other = |i: &usize| first[*i] != label && !members().any(|j| values[j].conj() == values[*i]);
        let others = (0..n).filter(is_other).map(|i| distance(values[i], centre));
        let gap = others.fold(if norm > 0.0 { norm } else { 1.0 }, f64::min);
        let dimension = if own_conjugate { size } else { 2 * size };
        found(Cluster { centre, shift: (SHIFT * gap).max(2.0 * radius), dimension });
    }
}

/// Gram-Schmidt, twice for every vector. A vector that depends on those before it becomes some
/// vector orthogonal to them.
fn orthonormalize<V: Vector<f64>>(vectors: &mut [V]) {
    for k in 0..vectors.len() {
        let (done, rest) = vectors.split_at_mut(k);
        let vector = rest[0].as_mut();
        normalize(vector);
        for _ in 0..2 {
            for other in done.iter() {
                let dot: f64 = other.as_ref().iter().zip(&*vector).map(|(a, b)| a * b).sum();
                for (entry, known) in vector.iter_mut().zip(other.as_ref()) {
                    *entry -= dot * known;
                }
            }
            normalize(vector);
        }
    }
}
