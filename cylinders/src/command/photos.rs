//! `cylinders photos`: photographs and cameras to cylinders.

use std::fs;
use std::path::PathBuf;

use nalgebra::{Point3, Unit, Vector3};

use super::drawings::{DrawingArguments, Drawn, Findings};
use super::error::CommandError;
use super::files::write_all;
use super::found::Found;
use super::matching::{at_least, parse_direction, positive};
use super::output::Output;
use super::triangulate::reports;
use crate::photograph::Photograph;
use crate::photos::decode::decode_photograph;
use crate::photos::{LineOptions, PhotoOptions, Seen, find_in_photographs, seen, snapped};
use crate::{CylinderLines, JointEstimate, Method, Scene, View, estimate, read_colmap, read_scene};

/// Find cylinders in photographs whose cameras are known
#[derive(clap::Args, Debug)]
#[command(after_help = "Examples:
  cylinders photos --colmap model --images photographs --json
  cylinders photos scene.json --images photographs --silhouettes pictures --ply cylinders.ply
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
    /// Largest number of directions of cylinders
    #[arg(long, value_name = "N", value_parser = at_least::<1>, conflicts_with = "direction")]
    directions: Option<usize>,
    /// Direction of all axes, world frame; by default the directions with evidence for cylinders
    #[arg(long, value_name = "X,Y,Z", value_parser = parse_direction, allow_hyphen_values = true)]
    direction: Option<Unit<Vector3<f64>>>,
    /// Do not search: move the lines of the scene to the edges that are detected within 5 pixels,
    /// and refine the cylinder of each label on them
    #[arg(long, conflicts_with_all = ["colmap", "threshold", "direction", "directions"])]
    snap: bool,
    /// Points of the scene near a surface are evidence for it, too, as far as they gather there
    #[arg(long, conflicts_with = "snap")]
    points: bool,
    /// Also write the result to this file, as JSON
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    #[command(flatten)]
    drawings: DrawingArguments,
}

pub(super) fn run(arguments: &Arguments, command: &str) -> Result<Output, CommandError> {
    let scene = scene(arguments)?;
    if arguments.points && scene.points.is_empty() {
        let file = arguments.scene.as_ref().or(arguments.colmap.as_ref()).unwrap_or(&arguments.images);
        return Err(CommandError::NoPoints { scene: file.clone() });
    }
    let photographs = photographs(arguments, &scene)?;
    let seen = photographs.iter().map(|photograph| look(arguments, photograph)).collect::<Result<Vec<_>, _>>()?;
    let Found { output, scene, cylinders, tables } = match arguments.snap {
        true => snap(arguments, scene, &seen)?,
        false => search(arguments, scene.points, &seen)?,
    };
    let findings = Findings { command: command.to_owned(), warnings: output.warnings.clone(), tables };
    let drawn = Drawn { scene: &scene, found: &cylinders, folders: vec![arguments.images.clone()] };
    let mut files = arguments.drawings.draw(drawn, findings)?;
    files.extend(arguments.out.iter().map(|path| (path.clone(), output.json.clone().into_bytes())));
    write_all(arguments.drawings.folder().as_slice(), &files)?;
    Ok(output)
}

/// The scene of the file; of a model only the points.
fn scene(arguments: &Arguments) -> Result<Scene, CommandError> {
    let points = match &arguments.colmap {
        Some(model) => read_colmap(model)?.points,
        None => Vec::new(),
    };
    match &arguments.scene {
        Some(scene) => Ok(read_scene(scene)?),
        None => Ok(Scene { views: Vec::new(), points }),
    }
}

/// The photographs of the model, or of the views of the scene.
fn photographs(arguments: &Arguments, scene: &Scene) -> Result<Vec<Photograph>, CommandError> {
    if let Some(model) = &arguments.colmap {
        return Ok(read_colmap(model)?.photographs);
    }
    scene.photographs().map_err(|view| CommandError::NoImageName { view })
}

/// Reads a photograph and detects its candidates for silhouettes.
fn look(arguments: &Arguments, photograph: &Photograph) -> Result<Seen, CommandError> {
    let path = arguments.images.join(&photograph.name);
    let file = fs::read(&path).map_err(|source| CommandError::Read { path: path.clone(), source })?;
    let image = decode_photograph(&file).map_err(|source| CommandError::Photograph { path: path.clone(), source })?;
    Ok(seen(photograph, &image, &LineOptions::default())?)
}

/// Cylinders without labels.
fn search(arguments: &Arguments, points: Vec<Point3<f64>>, seen: &[Seen]) -> Result<Found, CommandError> {
    let views: Vec<View> = seen.iter().map(|seen| seen.view.clone()).collect();
    let mut options = PhotoOptions::of(&views);
    options.matching.threshold = arguments.threshold;
    options.directions = arguments.directions.unwrap_or(options.directions);
    let found = find_in_photographs(seen, arguments.direction, &options)
        .map_err(|error| CommandError::Match { scene: arguments.images.clone(), error })?;
    Ok(Found::new((found.views, points), arguments.points, options.matching.threshold, &found.matching))
}

/// The cylinder of each label of the scene, on the edges near its lines.
fn snap(arguments: &Arguments, scene: Scene, seen: &[Seen]) -> Result<Found, CommandError> {
    let (mut views, mut moved, mut marked) = (Vec::new(), 0, 0);
    for (view, edges) in scene.views.iter().zip(seen) {
        let (snapped, count) = snapped(view, &edges.view).unwrap_or_else(|| (view.clone(), 0));
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
    let cylinders =
        lines.into_iter().zip(&estimate.cylinders).map(|(lines, estimate)| (lines, estimate.cylinder)).collect();
    Ok(Found { output, scene, cylinders, tables: reports.tables() })
}
