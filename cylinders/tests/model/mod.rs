//! Writes COLMAP models, text and binary, into folders for tests.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

/// A camera: id, name and number of its model, parameters.
pub(crate) type TestCamera = (u32, &'static str, i32, Vec<f64>);

/// An image: id, quaternion `w x y z`, translation, camera id, name, observed points `x y id`.
#[derive(Clone)]
pub(crate) struct TestImage {
    pub(crate) id: u32,
    pub(crate) quaternion: [f64; 4],
    pub(crate) translation: [f64; 3],
    pub(crate) camera: u32,
    pub(crate) name: String,
    pub(crate) observations: Vec<(f64, f64, i64)>,
}

/// A point: id, position, and its track of image ids and indices.
pub(crate) type TestPoint = (u64, [f64; 3], Vec<(u32, u32)>);

/// A model.
#[derive(Clone)]
pub(crate) struct TestModel {
    pub(crate) cameras: Vec<TestCamera>,
    pub(crate) images: Vec<TestImage>,
    pub(crate) points: Vec<TestPoint>,
}

/// Names of the files, and their content.
pub(crate) type Files = [(&'static str, Vec<u8>); 3];

impl TestModel {
    pub(crate) fn text(&self) -> Files {
        let (mut cameras, mut images, mut points) = (String::new(), String::new(), String::new());
        // Writing to a string cannot fail.
        let _ = writeln!(cameras, "# Camera list\n# Number of cameras: {}", self.cameras.len());
        for (id, model, _, parameters) in &self.cameras {
            let _ = writeln!(cameras, "{id} {model} 4000 3000 {}", joined(parameters));
        }
        let _ = writeln!(images, "# Image list\n# Number of images: {}, mean observations: 1", self.images.len());
        for TestImage { id, quaternion, translation, camera, name, observations } in &self.images {
            let pose = [&quaternion[..], translation].concat();
            let _ = writeln!(images, "{id} {} {camera} {name}", joined(&pose));
            let observations: Vec<_> = observations.iter().map(|(x, y, id)| format!("{x} {y} {id}")).collect();
            let _ = writeln!(images, "{}", observations.join(" "));
        }
        let _ = writeln!(points, "# 3D point list\n# Number of points: {}, mean track length: 2", self.points.len());
        for (id, position, track) in &self.points {
            let track: String = track.iter().map(|(image, index)| format!(" {image} {index}")).collect();
            let _ = writeln!(points, "{id} {} 10 20 30 0.5{track}", joined(position));
        }
        [("cameras.txt", cameras), ("images.txt", images), ("points3D.txt", points)]
            .map(|(name, text)| (name, text.into_bytes()))
    }

    pub(crate) fn binary(&self) -> Files {
        let [mut cameras, mut images, mut points] = [self.cameras.len(), self.images.len(), self.points.len()]
            .map(|count| (count as u64).to_le_bytes().to_vec());
        for (id, _, model, parameters) in &self.cameras {
            cameras.extend(id.to_le_bytes().into_iter().chain(model.to_le_bytes()));
            cameras.extend([4000u64, 3000].map(u64::to_le_bytes).concat());
            cameras.extend(bytes(parameters));
        }
        for TestImage { id, quaternion, translation, camera, name, observations } in &self.images {
            images.extend(id.to_le_bytes());
            images.extend(bytes(quaternion).into_iter().chain(bytes(translation)));
            images.extend(camera.to_le_bytes());
            images.extend(name.bytes().chain([0]));
            images.extend((observations.len() as u64).to_le_bytes());
            for (x, y, id) in observations {
                images.extend(bytes(&[*x, *y]).into_iter().chain(id.to_le_bytes()));
            }
        }
        for (id, position, track) in &self.points {
            points.extend(id.to_le_bytes());
            points.extend(bytes(position));
            points.extend([10, 20, 30]);
            points.extend(0.5f64.to_le_bytes());
            points.extend((track.len() as u64).to_le_bytes());
            for (image, index) in track {
                points.extend(image.to_le_bytes().into_iter().chain(index.to_le_bytes()));
            }
        }
        [("cameras.bin", cameras), ("images.bin", images), ("points3D.bin", points)]
    }
}

/// A folder of this name with these files and no others, in the folder that cargo gives to tests.
pub(crate) fn folder(name: &str, files: &Files) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a writable folder for tests");
    for (name, content) in files {
        fs::write(folder.join(name), content).expect("a writable folder for tests");
    }
    folder
}

fn bytes(numbers: &[f64]) -> Vec<u8> {
    numbers.iter().flat_map(|number| number.to_le_bytes()).collect()
}

fn joined(numbers: &[f64]) -> String {
    numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(" ")
}
