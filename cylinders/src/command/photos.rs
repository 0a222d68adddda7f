//! `cylinders photos`: photographs and cameras to cylinders.

use std::fs;
use std::path::PathBuf;

use nalgebra::{Point3, Unit, Vector3};

use super::drawings::{DrawingArguments, view_file};
use super::error::CommandError;
use super::files::write_all;
use super::matching::{parse_direction, positive};
use super::output::Output;
use super::triangulate::reports;
use crate::distortion::Distortion;
use crate::matching_report::MatchingReport;
use crate::photograph::Photograph;
use crate::photos::decode::{decode_photograph, encode_png, media_type};
use crate::photos::{
    LineOptions, PhotoMatching, PhotoOptions, candidate_lines, find_cylinders, snapped, undistorted_image,
};
use crate::picture::{PhotographFile, photograph_overlay};
use crate::{
    Cylinder, CylinderLines, JointEstimate, Method, Scene, View, detection::detect_segments, estimate, read_colmap,
    read_scene,
};

/// Find parallel cylinders in photographs whose cameras are known
#[derive(clap::Args, Debug)]
#[command(after_help = "Examples:
  cylinders photos --colmap model --images photographs --json
  cylinders photos scene.json --images photographs --overlays pictures --ply cylinders.ply
  cylinders photos scene.json --images photographs --snap

Lines of the scene are not looked at, only its cameras, unless --snap is given.")]
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
    /// Do not search: move the lines of the scene to the edges that are detected within 5 pixels,
    /// and refine the cylinder of each label on them
    #[arg(long, conflicts_with_all = ["colmap", "threshold", "direction"])]
    snap: bool,
    /// Draw lines and silhouettes over each photograph, to an SVG file in this folder, which is
    /// made if it is not there
    #[arg(long, value_name = "FOLDER")]
    overlays: Option<PathBuf>,
    /// Also write the result to this file, as JSON
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    #[command(flatten)]
    drawings: DrawingArguments,
}

/// The file of a photograph without distortion, and its candidates for silhouettes.
struct Seen {
    file: Vec<u8>,
    media_type: &'static str,
    size: [usize; 2],
    lines: View,
}

/// A scene with the lines of cylinders labelled, and these cylinders.
type Labelled = (Scene, Vec<(CylinderLines, Cylinder)>);

pub(super) fn run(arguments: &Arguments) -> Result<Output, CommandError> {
    let scene = scene(arguments)?;
    let photographs = photographs(arguments, &scene)?;
    let seen = photographs.into_iter().map(|photograph| look(arguments, &photograph)).collect::<Result<Vec<_>, _>>()?;
    let (output, (scene, found)) = match arguments.snap {
        true => snap(arguments, scene, &seen)?,
        false => search(arguments, scene.points, &seen)?,
    };
    let mut files = arguments.drawings.draw(&scene, &found)?;
    if let Some(folder) = &arguments.overlays {
        files.extend(overlays(&scene, &found, &seen).map(|(name, content)| (folder.join(name), content)));
    }
    files.extend(arguments.out.iter().map(|path| (path.clone(), output.json.clone().into_bytes())));
    let folders: Vec<_> = arguments.drawings.folder().into_iter().chain(arguments.overlays.as_deref()).collect();
    write_all(&folders, &files)?;
    Ok(output)
}

/// The scene of the file; of a model only the points.
fn scene(arguments: &Arguments) -> Result<Scene, CommandError> {
    match &arguments.scene {
        Some(scene) => Ok(read_scene(scene)?),
        None => Ok(Scene { views: Vec::new(), points: Vec::new() }),
    }
}

/// The photographs of the model, or of the views of the scene.
fn photographs(arguments: &Arguments, scene: &Scene) -> Result<Vec<Photograph>, CommandError> {
    if let Some(model) = &arguments.colmap {
        return Ok(read_colmap(model)?.photographs);
    }
    let photograph = |(index, view): (usize, &View)| {
        let name = view.image().ok_or(CommandError::NoImageName { view: index })?.to_owned();
        Ok(Photograph { name, camera: *view.camera(), distortion: Distortion::default() })
    };
    scene.views.iter().enumerate().map(photograph).collect()
}

/// Reads a photograph and detects its lines.
fn look(arguments: &Arguments, photograph: &Photograph) -> Result<Seen, CommandError> {
    let path = arguments.images.join(&photograph.name);
    let file = fs::read(&path).map_err(|source| CommandError::Read { path: path.clone(), source })?;
    let image = decode_photograph(&file).map_err(|source| CommandError::Photograph { path: path.clone(), source })?;
    let size = [image.width(), image.height()];
    let straight = undistorted_image(photograph, &image)?;
    let diagonal = (size[0] as f64).hypot(size[1] as f64);
    let lines = candidate_lines(photograph, &detect_segments(&straight), diagonal, &LineOptions::default())?;
    // Lines are drawn over the photograph without distortion.
    let (media_type, file) = match photograph.distortion.is_none() {
        true => (media_type(&file).unwrap_or_default(), file),
        false => {
            let failure = |source: png::EncodingError| CommandError::Picture { path, source: source.into() };
            ("image/png", encode_png(&straight).map_err(failure)?)
        }
    };
    Ok(Seen { file, media_type, size, lines })
}

/// Cylinders without labels.
fn search(arguments: &Arguments, points: Vec<Point3<f64>>, seen: &[Seen]) -> Result<(Output, Labelled), CommandError> {
    let views: Vec<_> = seen.iter().map(|seen| seen.lines.clone()).collect();
    let mut options = PhotoOptions::of(&views);
    options.matching.threshold = arguments.threshold;
    let found = find_cylinders(&views, arguments.direction, &options)
        .map_err(|error| CommandError::Match { scene: arguments.images.clone(), error })?;
    let report = MatchingReport::new(&found.views, (&found.direction, options.matching.threshold), &found.matching);
    let points = match &arguments.colmap {
        Some(model) => read_colmap(model)?.points,
        None => points,
    };
    Ok((Output::of(&report).with_warnings(report.warnings), labelled(found, points)))
}

/// The cylinder of each label of the scene, on the edges near its lines.
fn snap(arguments: &Arguments, scene: Scene, seen: &[Seen]) -> Result<(Output, Labelled), CommandError> {
    let (mut views, mut moved, mut marked) = (Vec::new(), 0, 0);
    for (view, seen) in scene.views.iter().zip(seen) {
        let (snapped, count) = snapped(view, &seen.lines).unwrap_or_else(|| (view.clone(), 0));
        marked += view.lines().len();
        moved += count;
        views.push(snapped);
    }
    let scene = Scene { views, points: scene.points };
    let lines = scene.cylinders();
    let estimate = |lines: &CylinderLines| {
        estimate(&lines.views, &Method::Refined).map_err(|error| CommandError::Estimate {
            scene: arguments.images.clone(),
            label: lines.label.clone(),
            error,
        })
    };
    let cylinders = lines.iter().map(estimate).collect::<Result<Vec<_>, _>>()?;
    let estimate = JointEstimate { cylinders, radius: None };
    let reports = reports(&scene, &lines, &estimate);
    let mut output = Output::of(&reports).with_warnings(reports.warnings());
    if moved < marked {
        let warning = format!("{} of {marked} lines have no edge within reach and stay where they are", marked - moved);
        output.text += &format!("\nwarning: {warning}\n");
        output.warnings.push(warning);
    }
    let found =
        lines.into_iter().zip(&estimate.cylinders).map(|(lines, estimate)| (lines, estimate.cylinder)).collect();
    Ok((output, (scene, found)))
}

/// Name and content of the picture of each photograph.
fn overlays(
    scene: &Scene,
    found: &[(CylinderLines, Cylinder)],
    seen: &[Seen],
) -> impl Iterator<Item = (String, Vec<u8>)> {
    let overlay = move |(view, seen): (usize, &Seen)| {
        let [width, height] = seen.size;
        let file = PhotographFile { media_type: seen.media_type, bytes: &seen.file, width, height };
        let svg = photograph_overlay(&file, scene, found, view)?;
        Some((view_file(scene, view), svg.into_bytes()))
    };
    seen.iter().enumerate().filter_map(overlay)
}

/// The scene with the number of its cylinder, from 1, as the label of each matched line.
fn labelled(found: PhotoMatching, points: Vec<Point3<f64>>) -> Labelled {
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
        // There is one label for each line, so they are not refused.
        view.clone().with_labels(labels(index, view)).unwrap_or_else(|_| view.clone())
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
