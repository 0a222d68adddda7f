//! `cylinders match`: cylinders and their silhouettes among lines without labels.

use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

use nalgebra::{Unit, Vector3};

use super::drawings::DrawingArguments;
use super::error::CommandError;
use super::files::write_all;
use super::output::Output;
use super::scene::SceneArguments;
use crate::direction::estimate_direction;
use crate::matching_report::MatchingReport;
use crate::progress::progress_bar;
use crate::report::Report;
use crate::{
    CylinderLines, Estimate, MatchError, MatchOptions, MatchedCylinder, Matching, Progress, References, RefineError,
    TriangulateError, View, default_direction_options, estimate_direction_robustly, estimate_from,
    match_cylinders_with,
};

/// Find parallel cylinders and their silhouettes among unlabelled lines
#[derive(clap::Args, Debug)]
#[command(after_help = "Examples:
  cylinders match scene.json
  cylinders match --colmap model --segments lines.csv --count 7 --json

Every pair of lines in an image is tried with every line of the other images. Labels are not looked at.")]
pub(super) struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// Upper bound of the distance of a line from its silhouette: pixels if all cameras have a
    /// calibration (default 12), radians otherwise (default 0.004); the default is doubled once if
    /// there is no cylinder. Less is allowed where the lines show less noise
    #[arg(long, value_name = "DISTANCE", value_parser = positive)]
    threshold: Option<f64>,
    /// Largest number of cylinders; by default all that are unlikely to be chance
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
    /// Direction of all axes, world frame; by default the one on which most lines agree
    #[arg(long, value_name = "X,Y,Z", value_parser = parse_direction, allow_hyphen_values = true)]
    direction: Option<Unit<Vector3<f64>>>,
    /// Also write the result to this file, as JSON
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    #[command(flatten)]
    drawings: DrawingArguments,
}

pub(super) fn run(arguments: &Arguments) -> Result<Output, CommandError> {
    let read = arguments.scene.read()?;
    let views = &read.views;
    let directions = directions(arguments, views)?;
    let defaults = MatchOptions::of(views);
    let options = MatchOptions {
        threshold: arguments.threshold.unwrap_or(defaults.threshold),
        references: if arguments.first_image { References::First } else { References::Every },
        count: arguments.count,
        least_support: arguments.least_support,
        ..defaults
    };
    let scene = || arguments.scene.path().to_owned();
    // Hand-drawn lines may need more than the default.
    let factors: &[f64] = if arguments.threshold.is_some() { &[1.0] } else { &[1.0, 2.0] };
    let mut found = Err(MatchError::NoPair);
    for factor in factors {
        let options = MatchOptions { threshold: factor * options.threshold, ..options };
        for direction in &directions {
            found = search(views, direction, &options).map(|matching| (*direction, options.threshold, matching));
            if !matches!(found, Err(MatchError::NoCylinder { .. })) {
                break;
            }
        }
        if !matches!(found, Err(MatchError::NoCylinder { .. })) {
            break;
        }
    }
    let (direction, threshold, matching) = found.map_err(|error| CommandError::Match { scene: scene(), error })?;
    let lines: Vec<_> = (1..).zip(&matching.cylinders).map(|(n, found)| found.lines(views, &n.to_string())).collect();
    let refine = |(lines, found): (&CylinderLines, &MatchedCylinder)| estimate_from(&lines.views, &found.cylinder);
    let estimates: Vec<_> = lines.iter().zip(&matching.cylinders).map(refine).collect();
    let reports = lines.iter().zip(&estimates).map(|(lines, estimate)| match estimate {
        Ok(estimate) => Ok(Report::new(lines, estimate, &read.points)),
        Err(error) => Err(*error),
    });
    let report = MatchingReport::new(views, (&direction, threshold), &matching).with_refined(reports.collect());
    let output = Output::of(&report).with_warnings(report.warnings);
    let cylinder = |(found, estimate): (&MatchedCylinder, &Result<Estimate, RefineError>)| match estimate {
        Ok(estimate) => estimate.cylinder,
        Err(_) => found.cylinder,
    };
    let cylinders: Vec<_> = matching.cylinders.iter().zip(&estimates).map(cylinder).collect();
    let found: Vec<_> = lines.into_iter().zip(cylinders).collect();
    let mut files = arguments.drawings.draw(&read, &found)?;
    files.extend(arguments.out.iter().map(|path| (path.clone(), output.json.clone().into_bytes())));
    write_all(arguments.drawings.folder().as_slice(), &files)?;
    Ok(output)
}

/// Shows a progress bar: the pairs searched and the cylinders found so far.
fn search(views: &[View], direction: &Unit<Vector3<f64>>, options: &MatchOptions) -> Result<Matching, MatchError> {
    let bar = progress_bar(0);
    let found = AtomicUsize::new(0);
    let matching = match_cylinders_with(views, direction, options, &|progress| match progress {
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

/// The directions to try one after the other: the given one; otherwise that on which most lines
/// agree, and that of all lines.
fn directions(arguments: &Arguments, views: &[View]) -> Result<Vec<Unit<Vector3<f64>>>, CommandError> {
    if let Some(direction) = arguments.direction {
        return Ok(vec![direction]);
    }
    let planes: Vec<_> = views.iter().flat_map(View::planes).collect();
    let failure = |error| CommandError::Estimate {
        scene: arguments.scene.path().to_owned(),
        label: None,
        error: TriangulateError::Direction(error).into(),
    };
    let found = estimate_direction_robustly(&planes, &default_direction_options()).map_err(failure)?;
    let of_all = estimate_direction(&planes).ok().map(|direction| direction.direction);
    Ok([found.direction.direction].into_iter().chain(of_all).collect())
}

pub(super) fn positive(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|number: &f64| *number > 0.0 && number.is_finite());
    number.ok_or_else(|| "the threshold must be a number greater than 0".to_owned())
}

fn at_least<const LEAST: usize>(text: &str) -> Result<usize, String> {
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
