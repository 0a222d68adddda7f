//! `cylinders photos`: photographs and cameras to cylinders.

use std::fs;
use std::path::{Path, PathBuf};

use nalgebra::{Point3, Unit, Vector3};

use super::drawings::DrawingArguments;
use super::error::CommandError;
use super::files::write_all;
use super::matching::{parse_direction, positive};
use super::output::Output;
use crate::distortion::Distortion;
use crate::matching_report::MatchingReport;
use crate::photograph::Photograph;
use crate::photos::decode::decode_photograph;
use crate::photos::{
    LineOptions, PhotoMatching, PhotoOptions, candidate_lines, find_cylinders, undistorted_segments,
};
use crate::{Cylinder, CylinderLines, Scene, View, read_colmap, read_scene};

/// Find parallel cylinders in photographs whose cameras are known
#[derive(clap::Args, Debug)]
#[command(after_help = "Examples:
  cylinders photos --colmap model --images photographs --json
  cylinders photos scene.json --images photographs --silhouettes pictures --ply cylinders.ply

Lines of the scene are not looked at, only its cameras.")]
pub(super) struct Arguments {
    /// Scene with the cameras and the names of their images, JSON
    #[arg(required_unless_present = "colmap", conflicts_with = "colmap")]
    scene: Option<PathBuf>,
    /// Folder of a COLMAP model with the cameras: cameras, images and points3D, binary or text
    #[arg(long, value_name = "FOLDER")]
    colmap: Option<PathBuf>,
    /// Folder of the photographs, JPEG or PNG, under the names of the images
    #[arg(long, value_name = "FOLDER")]
    images: PathBuf,
    /// Largest distance between a line and its silhouette, pixels
    #[arg(long, value_name = "PIXELS", default_value_t = 2.0, value_parser = positive)]
    threshold: f64,
    /// Direction of all axes, world frame; by default the one with the most evidence for cylinders
    #[arg(long, value_name = "X,Y,Z", value_parser = parse_direction, allow_hyphen_values = true)]
    direction: Option<Unit<Vector3<f64>>>,
    /// Also write the result to this file, as JSON
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    #[command(flatten)]
    drawings: DrawingArguments,
}

pub(super) fn run(arguments: &Arguments) -> Result<Output, CommandError> {
    let (photographs, points) = photographs(arguments)?;
    let views = photographs.iter().map(|photograph| view(arguments, photograph)).collect::<Result<Vec<_>, _>>()?;
    let defaults = PhotoOptions::of(&views);
    let mut options = defaults;
    options.matching.threshold = arguments.threshold;
    let found = find_cylinders(&views, arguments.direction, &options)
        .map_err(|error| CommandError::Match { scene: arguments.images.clone(), error })?;
    let report = MatchingReport::new(&found.views, (&found.direction, options.matching.threshold), &found.matching);
    let output = Output::of(&report).with_warnings(report.warnings);
    let (scene, cylinders) = labelled(found, points);
    let mut files = arguments.drawings.draw(&scene, &cylinders)?;
    files.extend(arguments.out.iter().map(|path| (path.clone(), output.json.clone().into_bytes())));
    write_all(arguments.drawings.folder().as_slice(), &files)?;
    Ok(output)
}

fn photographs(arguments: &Arguments) -> Result<(Vec<Photograph>, Vec<Point3<f64>>), CommandError> {
    match (&arguments.scene, &arguments.colmap) {
        (_, Some(model)) => {
            let model = read_colmap(model)?;
            Ok((model.photographs, model.points))
        }
        (Some(scene), None) => {
            let scene = read_scene(scene)?;
            let photograph = |view: &View| {
                let name = view.image()?.to_owned();
                Some(Photograph { name, camera: *view.camera(), distortion: Distortion::default() })
            };
            Ok((scene.views.iter().filter_map(photograph).collect(), scene.points))
        }
        // The parser of the command line rejects it.
        (None, None) => Err(CommandError::NoScene),
    }
}

fn view(arguments: &Arguments, photograph: &Photograph) -> Result<View, CommandError> {
    let path = arguments.images.join(Path::new(&photograph.name));
    let bytes = fs::read(&path).map_err(|source| CommandError::Read { path: path.clone(), source })?;
    let image = decode_photograph(&bytes).map_err(|source| CommandError::Photograph { path, source })?;
    let segments = undistorted_segments(photograph, &image)?;
    let diagonal = (image.width() as f64).hypot(image.height() as f64);
    Ok(candidate_lines(photograph, &segments, diagonal, &LineOptions::default())?)
}

/// The scene with the number of its cylinder, from 1, as the label of each matched line.
fn labelled(found: PhotoMatching, points: Vec<Point3<f64>>) -> (Scene, Vec<(CylinderLines, Cylinder)>) {
    let PhotoMatching { views, matching, .. } = found;
    let labels = |index: usize, view: &View| {
        let mut labels = vec![None; view.lines().len()];
        for (number, cylinder) in matching.cylinders.iter().enumerate() {
            for residual in cylinder.matches.iter().filter(|residual| residual.view == index) {
                labels[residual.line] = Some((number + 1).to_string());
            }
        }
        labels
    };
    let views = views.iter().enumerate().map(|(index, view)| {
        let labels = labels(index, view);
        // There is one label for each line.
        view.clone().with_labels(labels).unwrap_or_else(|_| view.clone())
    });
    let scene = Scene { views: views.collect(), points };
    let lines = scene.cylinders();
    let of_number = |number: usize| {
        let label = (number + 1).to_string();
        lines.iter().find(|lines| lines.label.as_deref() == Some(&label)).cloned()
    };
    let cylinders = matching.cylinders.iter().enumerate();
    let cylinders = cylinders.filter_map(|(number, found)| Some((of_number(number)?, found.cylinder))).collect();
    (scene, cylinders)
}
