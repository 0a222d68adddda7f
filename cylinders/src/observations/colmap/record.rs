//! Records of cameras and images, from text or binary files, to photographs.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::{Matrix3, Matrix3x4, Quaternion, UnitQuaternion, Vector3};

use super::camera::CameraModel;
use super::error::{ColmapError, Location};
use crate::observations::distortion::Distortion;
use crate::observations::photograph::Photograph;
use crate::observations::view::{Calibration, Camera};

/// A camera: one lens, shared by any number of images.
pub(super) struct CameraRecord {
    pub(super) at: Location,
    pub(super) id: u32,
    pub(super) model: CameraModel,
    pub(super) parameters: Vec<f64>,
}

/// An image with its pose.
pub(super) struct ImageRecord {
    pub(super) at: Location,
    pub(super) id: u32,
    /// Rotation, world to camera: `w, x, y, z`.
    pub(super) quaternion: [f64; 4],
    /// Translation, world to camera.
    pub(super) translation: [f64; 3],
    pub(super) camera: u32,
    pub(super) name: String,
}

type Lens = (Calibration, Distortion);

/// The images with their cameras.
pub(super) fn photographs(cameras: &[CameraRecord], images: Vec<ImageRecord>) -> Result<Vec<Photograph>, ColmapError> {
    let mut lenses = BTreeMap::new();
    for camera in cameras {
        if lenses.insert(camera.id, lens(camera)?).is_some() {
            return Err(ColmapError::Repeated { at: camera.at.clone(), record: format!("camera {}", camera.id) });
        }
    }
    let (mut ids, mut names) = (BTreeSet::new(), BTreeSet::new());
    let mut photographs = Vec::with_capacity(images.len());
    for image in images {
        if !ids.insert(image.id) {
            return Err(ColmapError::Repeated { at: image.at, record: format!("image {}", image.id) });
        }
        if !names.insert(image.name.clone()) {
            return Err(ColmapError::Repeated { at: image.at, record: format!("image named `{}`", image.name) });
        }
        photographs.push(photograph(image, &lenses)?);
    }
    Ok(photographs)
}

fn lens(camera: &CameraRecord) -> Result<Lens, ColmapError> {
    let (at, model) = (camera.at.clone(), camera.model);
    let record = format!("camera {}", camera.id);
    if !camera.parameters.iter().all(|parameter| parameter.is_finite()) {
        return Err(ColmapError::Value { at, record, what: "a parameter that is not a finite number" });
    }
    let (expected, found) = (model.parameter_count(), camera.parameters.len());
    match model.lens(&camera.parameters) {
        Some(Ok(lens)) => Ok(lens),
        Some(Err(source)) => Err(ColmapError::Invalid { at, record, source }),
        None => Err(ColmapError::ParameterCount { at, camera: camera.id, model: model.name(), expected, found }),
    }
}

fn photograph(image: ImageRecord, lenses: &BTreeMap<u32, Lens>) -> Result<Photograph, ColmapError> {
    let ImageRecord { at, quaternion: [w, x, y, z], translation, camera, name, .. } = image;
    let Some((calibration, distortion)) = lenses.get(&camera) else {
        return Err(ColmapError::UnknownCamera { at, image: name, camera });
    };
    let record = format!("image `{name}`");
    // Any multiple of the quaternion means the same rotation, as in COLMAP.
    let rotation = match UnitQuaternion::try_new(Quaternion::new(w, x, y, z), f64::MIN_POSITIVE) {
        Some(rotation) if rotation.coords.iter().all(|entry| entry.is_finite()) => rotation.to_rotation_matrix(),
        _ => return Err(ColmapError::Value { at, record, what: "a rotation that is zero or not finite" }),
    };
    let pose = pose(rotation.matrix(), &Vector3::from(translation));
    match Camera::from_normalised(&pose) {
        Ok(pose) => Ok(Photograph { name, camera: pose.with_calibration(*calibration), distortion: *distortion }),
        Err(source) => Err(ColmapError::Invalid { at, record, source }),
    }
}

/// `[R t]`
fn pose(rotation: &Matrix3<f64>, translation: &Vector3<f64>) -> Matrix3x4<f64> {
    let mut pose = Matrix3x4::zeros();
    pose.fixed_columns_mut::<3>(0).copy_from(rotation);
    pose.set_column(3, translation);
    pose
}
