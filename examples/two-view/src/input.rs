//! Correspondences and cameras, and their files.
//!
//! A file is text with commas. `pair,NAME` begins a pair of images; two lines `camera,fx,fy,cx,cy`
//! in pixels follow, as COLMAP's model `PINHOLE` has them; then, where it is known, `truth` with
//! the rotation, row by row, and the translation; then a line `x1,y1,x2,y2` for each
//! correspondence. Lines that begin with `#` are comments.

use std::fmt::Write as _;

use inlier::types::DataMatrix;
use nalgebra::{Matrix3, Rotation3, Unit, Vector3};
use thiserror::Error;

use crate::pose::Pose;

/// Focal lengths and the principal point, in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Focal lengths along x and y.
    pub focal: [f64; 2],
    /// The principal point.
    pub centre: [f64; 2],
}

impl Camera {
    fn ray(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [(x - self.centre[0]) / self.focal[0], (y - self.centre[1]) / self.focal[1]]
    }
}

/// Two images of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Pair {
    /// What it is called.
    pub name: String,
    /// The cameras.
    pub cameras: [Camera; 2],
    /// A point in both images: `x1, y1, x2, y2`.
    pub points: Vec<[f64; 4]>,
    /// The true pose, if it is known.
    pub truth: Option<Pose>,
}

/// A line that cannot be read.
#[derive(Clone, Debug, Error, PartialEq)]
#[error("line {line}: {message}")]
pub struct ReadError {
    /// Counted from 1.
    pub line: usize,
    /// What is wrong.
    pub message: &'static str,
}

impl Pair {
    /// The correspondences at a focal length of one: a row `x1, y1, x2, y2` for each.
    pub fn rays(&self) -> DataMatrix {
        let rays: Vec<[f64; 4]> = self.points.iter().map(|point| self.ray(point)).collect();
        DataMatrix::from_fn(rays.len(), 4, |row, column| rays[row][column])
    }

    fn ray(&self, &[a, b, c, d]: &[f64; 4]) -> [f64; 4] {
        let ([a, b], [c, d]) = (self.cameras[0].ray([a, b]), self.cameras[1].ray([c, d]));
        [a, b, c, d]
    }

    /// The length of a pixel at a focal length of one, the mean of both cameras.
    pub fn pixel(&self) -> f64 {
        let pixel = |camera: &Camera| 2.0 / (camera.focal[0] + camera.focal[1]);
        0.5 * (pixel(&self.cameras[0]) + pixel(&self.cameras[1]))
    }

    /// The pair as part of a file. Numbers are read back exactly.
    pub fn to_text(&self) -> String {
        let mut text = format!("pair,{}\n", self.name);
        for Camera { focal: [fx, fy], centre: [cx, cy] } in self.cameras {
            let _ = writeln!(text, "camera,{fx},{fy},{cx},{cy}");
        }
        if let Some(truth) = &self.truth {
            let _ = writeln!(text, "truth,{}", join(&pose_to_array(truth)));
        }
        for point in &self.points {
            let _ = writeln!(text, "{}", join(point));
        }
        text
    }

    /// The pairs of a file.
    ///
    /// # Errors
    /// The first line that cannot be read.
    pub fn read_all(text: &str) -> Result<Vec<Self>, ReadError> {
        let mut pairs: Vec<Draft> = Vec::new();
        for (index, line) in text.lines().enumerate().filter(|(_, line)| !line.is_empty() && !line.starts_with('#')) {
            read_line(&mut pairs, line).map_err(|message| ReadError { line: index + 1, message })?;
        }
        let last = text.lines().count();
        pairs.into_iter().map(|draft| draft.finish().map_err(|message| ReadError { line: last, message })).collect()
    }
}

/// A pair of which some lines are read.
struct Draft {
    name: String,
    cameras: Vec<Camera>,
    points: Vec<[f64; 4]>,
    truth: Option<Pose>,
}

impl Draft {
    fn finish(self) -> Result<Pair, &'static str> {
        let Self { name, cameras, points, truth } = self;
        let cameras = cameras.try_into().map_err(|_| "a pair has two lines `camera,fx,fy,cx,cy`")?;
        Ok(Pair { name, cameras, points, truth })
    }
}

fn read_line(pairs: &mut Vec<Draft>, line: &str) -> Result<(), &'static str> {
    let (word, rest) = line.split_once(',').ok_or("a line has values with commas between them")?;
    if word == "pair" {
        pairs.push(Draft { name: rest.to_string(), cameras: Vec::new(), points: Vec::new(), truth: None });
        return Ok(());
    }
    let pair = pairs.last_mut().ok_or("the first line is `pair,NAME`")?;
    match word {
        "camera" => {
            let [fx, fy, cx, cy] = numbers(rest).ok_or("a camera has four numbers: fx, fy, cx, cy")?;
            if !(fx > 0.0 && fy > 0.0) {
                return Err("a focal length is above zero");
            }
            pair.cameras.push(Camera { focal: [fx, fy], centre: [cx, cy] });
        }
        "truth" => {
            let values: [f64; 12] = numbers(rest).ok_or("a truth has twelve numbers")?;
            let rotation = Rotation3::from_matrix_unchecked(Matrix3::from_row_slice(&values[..9]));
            let translation = Vector3::from_column_slice(&values[9..]);
            pair.truth = Some(Pose { rotation, translation: Unit::new_normalize(translation) });
        }
        _ => pair.points.push(numbers(line).ok_or("a correspondence has four numbers: x1, y1, x2, y2")?),
    }
    Ok(())
}

fn numbers<const N: usize>(text: &str) -> Option<[f64; N]> {
    let values: Result<Vec<f64>, _> = text.split(',').map(|value| value.trim().parse()).collect();
    values.ok()?.try_into().ok()
}

/// Values with commas between them.
pub fn join(values: &[f64]) -> String {
    values.iter().map(f64::to_string).collect::<Vec<_>>().join(",")
}

/// The rotation, row by row, and the translation.
pub fn pose_to_array(pose: &Pose) -> [f64; 12] {
    let rotation = pose.rotation.matrix();
    std::array::from_fn(|k| if k < 9 { rotation[(k / 3, k % 3)] } else { pose.translation[k - 9] })
}
