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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::size::Fixed;
    use std::vec;
    use std::vec::Vec;

    fn c(re: f64, im: f64) -> Complex<f64> {
        Complex { re, im }
    }

    fn clusters(values: &[Complex<f64>], norm: f64) -> Vec<Cluster> {
        let mut found = Vec::new();
        find_clusters(values, norm, &mut vec![0; values.len()], &mut |cluster| found.push(cluster));
        found
    }

    /// The dimensions of the clusters of real values.
    fn dimensions(values: &[f64], norm: f64) -> Vec<usize> {
        let values: Vec<_> = values.iter().map(|&x| c(x, 0.0)).collect();
        clusters(&values, norm).iter().map(|cluster| cluster.dimension).collect()
    }

    #[test]
    fn close_values_are_a_cluster() {
        assert!(dimensions(&[1.0, 2.0, -1.0, -2.0], 1.0).is_empty());
        for unit in [0.01, 1.0, 100.0, -1.0] {
            assert_eq!(dimensions(&[unit, 0.9991 * unit], 0.0), [2]);
            assert_eq!(dimensions(&[0.9991 * unit, unit], 0.0), [2]);
            assert!(dimensions(&[unit, 0.9989 * unit], 0.0).is_empty());
            assert!(dimensions(&[0.9989 * unit, unit], 0.0).is_empty());
        }
        // Tiny values are compared with the norm.
        assert_eq!(dimensions(&[0.0, 0.9e-8], 100.0), [2]);
        assert!(dimensions(&[0.0, 1.1e-8], 100.0).is_empty());
        assert_eq!(dimensions(&[0.0, 0.0], 0.0), [2], "all eigenvalues of zero");
    }

    #[test]
    fn clusters_that_share_a_member_are_one() {
        let chain = [1.0, 1.0008, 1.0016, 1.0024];
        for order in [[0, 1, 2, 3], [3, 2, 1, 0], [0, 2, 3, 1], [0, 3, 1, 2], [1, 3, 0, 2]] {
            assert_eq!(dimensions(&order.map(|k| chain[k]), 1.0), [4], "{order:?}");
            let [a, b, c, d] = order.map(|k| chain[k]);
            assert_eq!(dimensions(&[5.0, a, 7.0, b, c, 7.001, d], 1.0), [4, 2], "{order:?}");
        }
        assert_eq!(dimensions(&[1.0, 3.0, 1.0008, 3.001, 2.0], 1.0), [2, 2]);
    }

    /// The centre is the mean. The shift is a thousandth of the distance of the next value, but not
    /// within the cluster.
    #[test]
    fn shifts_keep_away_from_the_cluster_and_from_others() {
        let [wide] = clusters(&[c(1.0, 0.0), c(4.0, 0.0), c(1.0008, 0.0)], 9.0)[..] else { panic!() };
        assert!((wide.centre - c(1.0004, 0.0)).norm() < 1e-15);
        assert!((wide.shift - 2.9996e-3).abs() < 1e-15, "{}", wide.shift);
        let [near] = clusters(&[c(1.0, 0.0), c(1.01, 0.0), c(1.0008, 0.0)], 9.0)[..] else { panic!() };
        assert!((near.shift - 0.8e-3).abs() < 1e-15, "{}", near.shift);
        // Without another value the norm is the distance.
        assert!((clusters(&[c(1.0, 0.0); 2], 9.0)[0].shift - 9e-3).abs() < 1e-15);
        assert!((clusters(&[c(1.0, 0.0); 2], 0.0)[0].shift - 1e-3).abs() < 1e-15);
    }

    #[test]
    fn of_conjugate_clusters_one_counts_for_both() {
        let values = [c(2.0, 1.0), c(2.0, -1.0), c(2.0, 1.001), c(2.0, -1.001), c(5.0, 1.0)];
        for order in [[0, 1, 2, 3, 4], [1, 0, 3, 2, 4], [4, 3, 2, 1, 0]] {
            let [both] = clusters(&order.map(|k| values[k]), 9.0)[..] else { panic!() };
            assert!((both.centre - c(2.0, 1.0005)).norm() < 1e-15 && both.dimension == 4, "{both:?}");
            // The conjugates are not others.
            assert!((both.shift - 3e-3).abs() < 1e-8, "{both:?}");
        }
        let three = [1.0, 1.0002, 0.9999].map(|im| [c(2.0, im), c(2.0, -im)]);
        let [three] = clusters(three.as_flattened(), 9.0)[..] else { panic!() };
        assert_eq!(three.dimension, 6);
        // A pair that is nearly real is its own conjugate.
        let [pair] = clusters(&[c(2.0, 5e-4), c(2.0, -5e-4), c(5.0, 0.0)], 9.0)[..] else { panic!() };
        assert!(pair.centre == c(2.0, 0.0) && pair.dimension == 2, "{pair:?}");
        // Only values and exact conjugates are left out of the distance.
        let [lone] = clusters(&[c(2.0, 1.0), c(2.0, 1.0), c(2.0, -0.99)], 9.0)[..] else { panic!() };
        assert!((lone.shift - 1.99e-3).abs() < 1e-15 && lone.dimension == 4, "{lone:?}");
    }

    /// A = S D S^-1 with D of eigenvalues 2, 2 (defective), 1 +- 2 i twice, and -3: S is triangular
    /// with ones.
    #[test]
    fn bases_are_orthonormal_and_invariant() {
        const N: usize = 7;
        let mut block = [[0.0; N]; N];
        for (i, row) in [[2.0, 1.0], [0.0, 2.0]].into_iter().enumerate() {
            block[i][..2].copy_from_slice(&row);
        }
        for k in [2, 4] {
            (block[k][k], block[k + 1][k + 1], block[k][k + 1], block[k + 1][k]) = (1.0, 1.0, 2.0, -2.0);
        }
        block[6][6] = -3.0;
        // S = 1 + s: s of the first subdiagonal and beyond, so that S^-1 is a finite sum.
        let s = |i: usize, j: usize| if i > j { 0.1 * ((3 * i + 5 * j) % 7) as f64 - 0.3 } else { 0.0 };
        for unit in [1.0, 2.0_f64.powi(250)] {
            let mut matrix = block;
            for k in 0..N {
                for i in k + 1..N {
                    // Row i += s row k, column k -= s column i.
                    let factor = s(i, k);
                    for j in 0..N {
                        matrix[i][j] += factor * matrix[k][j];
                    }
                    for row in &mut matrix {
                        row[k] -= factor * row[i];
                    }
                }
            }
            let scaled = matrix.map(|row| row.map(|x| x * unit));
            let form = Hessenberg::<Fixed<N>>::reduce(&scaled).unwrap();
            let clusters = form.clusters(&form.eigenvalues().unwrap());
            let mut found: Vec<_> = clusters.iter().map(|cluster| (cluster.dimension, cluster.centre)).collect();
            found.sort_by_key(|(dimension, _)| *dimension);
            let centres = found.iter().zip([c(2.0, 0.0), c(1.0, 2.0)]);
            assert!(found.len() == 2 && found[0].0 == 2 && found[1].0 == 4, "{found:?}");
            let in_unit = |z: Complex<f64>| z * (form.unit / unit);
            assert!(
                centres.map(|((_, z), exact)| (in_unit(*z) - exact).norm()).fold(0.0, f64::max) < 1e-7,
                "{found:?}"
            );
            for cluster in clusters.iter() {
                let mut basis = [[0.0; N]; N];
                form.invariant_subspace(cluster, &mut basis);
                let dot = |x: &[f64; N], y: &[f64; N]| x.iter().zip(y).map(|(x, y)| x * y).sum::<f64>();
                assert!(basis[cluster.dimension..].iter().flatten().all(|x| *x == 0.0), "the other rows stay");
                let basis = &basis[..cluster.dimension];
                for (k, vector) in basis.iter().enumerate() {
                    let mut image: [f64; N] = core::array::from_fn(|i| dot(&matrix[i], vector));
                    for (l, other) in basis.iter().enumerate() {
                        let expected = f64::from(u8::from(k == l));
                        assert!((dot(vector, other) - expected).abs() < 1e-14, "{k} {l}");
                        let part = dot(&image, other);
                        (0..N).for_each(|i| image[i] -= part * other[i]);
                    }
                    let rest = dot(&image, &image).sqrt();
                    assert!(rest < 1e-10, "dimension {}: vector {k} leaves by {rest:e}", cluster.dimension);
                }
            }
        }
    }
}
