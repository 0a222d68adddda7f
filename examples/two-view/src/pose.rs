//! Relative poses, their essential matrices, and which points are in front of both cameras.

use inlier::types::DataMatrix;
use nalgebra::{Matrix3, Rotation3, Unit, Vector3};

/// A point `x` of the first camera is `rotation * x + translation` in the second. The length of
/// the translation cannot be known from images: it is one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// From the axes of the first camera to those of the second.
    pub rotation: Rotation3<f64>,
    /// The direction of the translation.
    pub translation: Unit<Vector3<f64>>,
}

impl Pose {
    /// The matrix E for which `y . E x = 0` holds for rays `x`, `y` to the same point.
    pub fn essential(&self) -> Matrix3<f64> {
        self.translation.cross_matrix() * self.rotation.matrix()
    }

    /// Whether the rays meet in front of both cameras, at depths above zero.
    pub fn is_in_front(&self, first: Vector3<f64>, second: Vector3<f64>) -> bool {
        // Depths a and b are those of least squares of `b * second = a * turned + translation`.
        let turned = self.rotation * first;
        let (p, q, r) = (turned.norm_squared(), second.norm_squared(), turned.dot(&second));
        let (s, t) = (turned.dot(&self.translation), second.dot(&self.translation));
        r * t - q * s > 0.0 && p * t - r * s > 0.0
    }

    /// Angles between two poses, in degrees: of the rotations, and of the translations.
    pub fn degrees_to(&self, other: &Self) -> [f64; 2] {
        // The length of the difference of two rotations is `sqrt(8) sin(angle / 2)`. Cosines would
        // lose half of the digits of small angles.
        let chord = (self.rotation.matrix() - other.rotation.matrix()).norm() / 8_f64.sqrt();
        let sine = self.translation.cross(&other.translation).norm();
        let cosine = self.translation.dot(&other.translation);
        [2.0 * chord.min(1.0).asin(), sine.atan2(cosine)].map(f64::to_degrees)
    }

    /// Of the four poses of an essential matrix the one with most of these points in front of both
    /// cameras, where it has at least one.
    pub fn from_essential(essential: &Matrix3<f64>, data: &DataMatrix, rows: &[usize]) -> Option<Self> {
        let count = |pose: &Self| rows.iter().filter(|&&row| in_front(pose, data, row)).count();
        let poses = decompose(essential)?.map(|pose| (count(&pose), pose));
        poses.into_iter().max_by_key(|(count, _)| *count).filter(|(count, _)| *count > 0).map(|(_, pose)| pose)
    }
}

/// Whether the point of this row is in front of both cameras.
pub fn in_front(pose: &Pose, data: &DataMatrix, row: usize) -> bool {
    let [first, second] = rays(data, row);
    pose.is_in_front(first, second)
}

/// The rays of a row of the data.
pub fn rays(data: &DataMatrix, row: usize) -> [Vector3<f64>; 2] {
    [0, 2].map(|column| Vector3::new(data[(row, column)], data[(row, column + 1)], 1.0))
}

/// Both rotations of an essential matrix, each with both signs of the translation, or nothing where
/// the singular values do not converge.
fn decompose(essential: &Matrix3<f64>) -> Option<[Pose; 4]> {
    let svd = essential.try_svd(true, true, f64::EPSILON, 100)?;
    let (mut u, mut v_t) = (svd.u?, svd.v_t?);
    // The last singular value is zero: signs that go with it are free.
    if u.determinant() < 0.0 {
        u.column_mut(2).neg_mut();
    }
    if v_t.determinant() < 0.0 {
        v_t.row_mut(2).neg_mut();
    }
    let quarter = Matrix3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
    let rotations = [u * quarter * v_t, u * quarter.transpose() * v_t].map(Rotation3::from_matrix_unchecked);
    let translation = Unit::new_normalize(u.column(2).into_owned());
    let pose =
        |k: usize| Pose { rotation: rotations[k % 2], translation: if k < 2 { translation } else { -translation } };
    Some([0, 1, 2, 3].map(pose))
}
