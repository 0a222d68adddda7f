//! `cylinders match`: cylinders and their silhouettes among lines without labels.

use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

use nalgebra::{Unit, Vector3};

use super::drawings::{DrawingArguments, Drawn, Findings};
use super::error::CommandError;
use super::files::write_all;
use super::found::Found;
use super::images::ImageArguments;
use super::output::Output;
use super::scene::SceneArguments;
use crate::progress::progress_bar;
use crate::{
    MatchError, MatchOptions, Matching, Progress, References, View, match_candidate_with, match_cylinders_with,
    match_directions_with, match_with_wider_bound,
};

/// Find cylinders and their silhouettes among unlabelled lines
#[derive(clap::Args, Debug)]
#[command(after_help = "Examples:
  cylinders match scene.json
  cylinders match --colmap model --segments lines.csv --count 7 --json

Pairs of lines of an image or of near ones are tried with every line of the others. Labels are not looked at.")]
pub(super) struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// Largest distance of a line from its silhouette: pixels if all cameras have a calibration
    /// (default 3), radians otherwise (default 0.001); the default is doubled once if there is no
    /// cylinder, or if the lines are so far off that they fill it and more speaks for what is found
    /// then
    #[arg(long, value_name = "DISTANCE", value_parser = positive)]
    threshold: Option<f64>,
    /// Largest number of cylinders, all of one direction; by default all that are unlikely to be
    /// chance
    #[arg(long, value_name = "N", value_parser = at_least::<1>)]
    count: Option<usize>,
    /// Least number of matches of a cylinder, 4 or more; by default more than chance gives, or 4
    /// with --count
    #[arg(long, value_name = "N", value_parser = at_least::<4>)]
    least_support: Option<usize>,
    /// Take pairs of silhouettes in the first image only: faster, but finds only cylinders seen
    /// there
    #[arg(long)]
    first_image: bool,
    /// Largest number of directions of cylinders; by default all that have cylinders
    #[arg(long, value_name = "N", value_parser = at_least::<1>, conflicts_with_all = ["count", "direction"])]
    directions: Option<usize>,
    /// Direction of all axes, world frame; by default the directions on which many lines agree
    #[arg(long, value_name = "X,Y,Z", value_parser = parse_direction, allow_hyphen_values = true)]
    direction: Option<Unit<Vector3<f64>>>,
    /// Points of the scene near a surface are evidence for it, too, as far as they gather there
    #[arg(long)]
    points: bool,
    /// Also write the result to this file, as JSON
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    #[command(flatten)]
    drawings: DrawingArguments,
    #[command(flatten)]
    images: ImageArguments,
}

pub(super) fn run(arguments: &Arguments, command: &str) -> Result<Output, CommandError> {
    let read = arguments.scene.read()?;
    if arguments.points && read.points.is_empty() {
        return Err(CommandError::NoPoints { scene: arguments.scene.path().to_owned() });
    }
    let defaults = MatchOptions::of(&read.views);
    let options = MatchOptions {
        threshold: arguments.threshold.unwrap_or(defaults.threshold),
        references: if arguments.first_image { References::First } else { References::Every },
        count: arguments.count,
        least_support: arguments.least_support,
        ..defaults
    };
    let search = |options: &MatchOptions| search(arguments, &read.views, options);
    let found = match arguments.threshold {
        Some(threshold) => search(&options).map(|matching| (threshold, matching)),
        None => match_with_wider_bound(&read.views, &options, search),
    };
    let failure = |error| CommandError::Match { scene: arguments.scene.path().to_owned(), error };
    let (threshold, matching) = found.map_err(failure)?;
    let Found { output, scene, cylinders, tables } =
        Found::new((read.views, read.points), arguments.points, threshold, &matching);
    let folders = arguments.images.folders(&arguments.scene);
    let findings = Findings { command: command.to_owned(), warnings: output.warnings.clone(), tables };
    let mut files = arguments.drawings.draw(Drawn { scene: &scene, found: &cylinders, folders }, findings)?;
    files.extend(arguments.out.iter().map(|path| (path.clone(), output.json.clone().into_bytes())));
    write_all(arguments.drawings.folder().as_slice(), &files)?;
    Ok(output)
}

/// The cylinders along the given direction, or of all directions.
fn search(arguments: &Arguments, views: &[View], options: &MatchOptions) -> Result<Matching, MatchError> {
    if let Some(direction) = &arguments.direction {
        return with_progress(|progress| match_cylinders_with(views, direction, options, progress));
    }
    // So many cylinders would be found in any direction.
    let most = if arguments.count.is_some() { 1 } else { arguments.directions.unwrap_or(usize::MAX) };
    match_directions_with(views, most, options, |views, direction| {
        with_progress(|progress| match_candidate_with(views, direction, options, progress))
    })
}

/// Shows a progress bar: the pairs searched and the cylinders found so far.
fn with_progress(
    search: impl FnOnce(&(dyn Fn(Progress) + Sync)) -> Result<Matching, MatchError>,
) -> Result<Matching, MatchError> {
    let bar = progress_bar(0);
    let found = AtomicUsize::new(0);
    let matching = search(&|progress| match progress {
        Progress::Pairs(pairs) => {
            bar.reset();
            bar.set_length(pairs as u64);
        }
        Progress::Pair => bar.inc(1),
        Progress::Cylinder => bar.set_message(format!("cylinders: {}", found.fetch_add(1, Ordering::Relaxed) + 1)),
    });
    bar.finish_and_clear();
    matching
}

pub(super) fn positive(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|number: &f64| *number > 0.0 && number.is_finite());
    number.ok_or_else(|| "the threshold must be a number greater than 0".to_owned())
}

pub(super) fn at_least<const LEAST: usize>(text: &str) -> Result<usize, String> {
    let number = text.parse().ok().filter(|&number| number >= LEAST);
    number.ok_or_else(|| format!("not a whole number of {LEAST} or more"))
}

/// Three numbers, not all zero.
pub(super) fn parse_direction(text: &str) -> Result<Unit<Vector3<f64>>, String> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|number| number.trim().parse()).collect();
    match numbers.as_deref() {
        Ok(&[x, y, z]) if [x, y, z].iter().all(|number| number.is_finite()) => {
            let vector = Vector3::new(x, y, z);
            Unit::try_new(vector / vector.amax(), 0.5).ok_or("the direction is zero".to_owned())
        }
        _ => Err("a direction is three numbers with commas between them".to_owned()),
    }
}
