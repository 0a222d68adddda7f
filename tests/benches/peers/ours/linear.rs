//! Small dense linear algebra with sizes known to the compiler.

pub(crate) type Vector = [f64; 3];
pub(crate) type Matrix = [Vector; 3];

#[inline]
pub(crate) fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    (0..N).map(|i| a[i] * b[i]).sum()
}

#[inline]
pub(crate) fn cross(a: &Vector, b: &Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[inline]
pub(crate) fn minus(a: &Vector, b: &Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline]
pub(crate) fn times(m: &Matrix, v: &Vector) -> Vector {
    [dot(&m[0], v), dot(&m[1], v), dot(&m[2], v)]
}

/// An orthonormal basis of the null space of M independent rows, K = N - M vectors: the last
/// columns of the orthogonal factor of the transposed rows, by Householder reflections.
pub(crate) fn null_space<const M: usize, const N: usize, const K: usize>(mut rows: [[f64; N]; M]) -> [[f64; N]; K] {
    const { assert!(M + K == N) };
    let mut scales = [0.0; M];
    for at in 0..M {
        let square: f64 = (at..N).map(|i| rows[at][i] * rows[at][i]).sum();
        let norm = square.sqrt().copysign(rows[at][at]);
        rows[at][at] += norm;
        // 2 / |v|^2 of the reflection's vector v, zero for a row that vanishes.
        scales[at] = if norm == 0.0 { 0.0 } else { (norm * rows[at][at]).recip() };
        let (done, rest) = rows.split_at_mut(at + 1);
        for row in rest {
            reflect(&done[at], at, scales[at], row);
        }
    }
    let mut basis = [[0.0; N]; K];
    for k in 0..K {
        basis[k][M + k] = 1.0;
        for at in (0..M).rev() {
            reflect(&rows[at], at, scales[at], &mut basis[k]);
        }
    }
    basis
}

#[inline]
fn reflect<const N: usize>(v: &[f64; N], from: usize, scale: f64, x: &mut [f64; N]) {
    let along: f64 = (from..N).map(|i| v[i] * x[i]).sum::<f64>() * scale;
    for i in from..N {
        x[i] -= along * v[i];
    }
}

/// The X with `matrix` X = `right`, by elimination with row pivoting; not finite where the matrix
/// is singular.
pub(crate) fn solve<const N: usize, const R: usize>(
    mut matrix: [[f64; N]; N],
    mut right: [[f64; R]; N],
) -> [[f64; R]; N] {
    for at in 0..N {
        let pivot = (at..N).fold(at, |best, i| if matrix[i][at].abs() > matrix[best][at].abs() { i } else { best });
        matrix.swap(at, pivot);
        right.swap(at, pivot);
        let inverse = matrix[at][at].recip();
        for i in at + 1..N {
            let factor = matrix[i][at] * inverse;
            for j in at + 1..N {
                matrix[i][j] -= factor * matrix[at][j];
            }
            for j in 0..R {
                right[i][j] -= factor * right[at][j];
            }
        }
    }
    for at in (0..N).rev() {
        let inverse = matrix[at][at].recip();
        for j in 0..R {
            let sum: f64 = (at + 1..N).map(|i| matrix[at][i] * right[i][j]).sum();
            right[at][j] = (right[at][j] - sum) * inverse;
        }
    }
    right
}
