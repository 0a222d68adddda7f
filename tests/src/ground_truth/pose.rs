//! Whether a pose that a solver returns is the known one.

use nalgebra::{Matrix3, Vector3};

use super::maker::FOUND;

/// Whether a pose is the known one; rows are listed, nalgebra lists columns.
pub fn is_pose(known: (&Matrix3<f64>, &Vector3<f64>), rotation: &[[f64; 3]; 3], translation: &[f64; 3]) -> bool {
    (Matrix3::from(*rotation).transpose() - known.0).norm() < FOUND
        && (Vector3::from(*translation) - known.1).norm() < FOUND * known.1.norm()
}

/// Whether rows are those of a rotation, to rounding errors: they are enlarged where solutions have
/// few digits, since these come from several equations.
pub fn is_rotation(rows: &[[f64; 3]; 3]) -> bool {
    let matrix = Matrix3::from(*rows);
    (matrix * matrix.transpose() - Matrix3::identity()).norm() < FOUND && matrix.determinant() > 0.0
}
