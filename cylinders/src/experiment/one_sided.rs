//! `one_sided`: photographs that each show the left silhouette only.

use super::can::{self, Can, Noise, PHOTOGRAPHS, RADIUS};
use super::error::ExperimentError;
use super::instances::instances;
use super::one_sided_range;
use super::options::Options;
use super::outcome::Outcome;
use super::quantile::Sorted;
use super::random::some_of;
use super::table::Table;
use crate::picture::{Axis, Band, Plot, Series};
use crate::random::Random;
use crate::{LeastSquares, LinearConic, SectionShape, SectionSolver};

const RUNS: usize = 10_000;

/// Photographs of a run.
const IMAGES: usize = 15;

/// The left silhouette only.
const LEFT: usize = 1;

/// Standard deviations of the coordinates of an end point, pixels.
const PIXELS: [f64; 6] = [0.25, 0.5, 1.0, 2.0, 4.0, 8.0];

const METHODS: [(&str, &dyn SectionSolver); 2] = [("proposed", &LeastSquares), ("linear", &LinearConic)];

const SETUP: &str = "In each run 15 photographs are drawn at random, with only the left silhouette of each; the \
direction of the axis is estimated from these lines. Distance: Frobenius norm of the \
difference between estimated and true dual conic, each scaled so that its last entry is -1, \
with the true axis in the origin and the true radius as unit. Errors of axis and radius are in \
millimetres; for an ellipse they are those of the circle nearest to its tangents. 'no \
ellipse': part of the runs in which the conic is not an ellipse. 'none': part of the runs in \
which the method failed.";

#[derive(Clone, Copy, Debug)]
struct Estimate {
    distance: f64,
    /// Infinite if the conic is not an ellipse.
    axis: f64,
    radius: f64,
    real: bool,
}

/// Results by noise and method; `None` if the method failed.
type Estimates = [[Option<Estimate>; METHODS.len()]; PIXELS.len()];

pub(super) fn run(options: &Options) -> Result<Outcome, ExperimentError> {
    let runs = options.runs_or(RUNS);
    let can = Can::of_seed(options.seed)?;
    let results: Vec<Estimates> = instances(options, runs, |random| instance(&can, random));
    let mut outcome = Outcome::new(format!("{}\n{SETUP}\n{}", can::SETUP, one_sided_range::SETUP), runs);
    let columns = [
        "pixels",
        "method",
        "mean distance",
        "median distance",
        "median axis / mm",
        "median radius / mm",
        "no ellipse",
        "none",
    ];
    let mut table = Table::new("one_sided", &columns);
    let mut series = Vec::new();
    for (method, (name, _)) in METHODS.into_iter().enumerate() {
        let mut points = Vec::new();
        let mut limits = Vec::new();
        for (level, pixels) in PIXELS.into_iter().enumerate() {
            let found: Vec<Estimate> = results.iter().filter_map(|result| result[level][method]).collect();
            let sorted = |of: fn(&Estimate) -> f64| Sorted::new(found.iter().map(of));
            let distances = sorted(|one| one.distance);
            let unreal = found.iter().filter(|one| !one.real).count() as f64 / found.len() as f64;
            let none = (runs - found.len()) as f64 / runs as f64;
            let [axis, radius] = [sorted(|one| one.axis).median(), sorted(|one| one.radius).median()];
            let numbers = [distances.mean(), distances.median(), axis, radius, unreal, none];
            table.push([pixels.into(), name.into()].into_iter().chain(numbers.map(Into::into)));
            points.push([pixels, distances.median()]);
            limits.push([pixels, distances.quantile(0.1), distances.quantile(0.9)]);
        }
        let band = Some(Band { label: "10 % to 90 %".to_owned(), limits });
        series.push(Series { label: format!("{name}, median"), points, band });
    }
    outcome.tables.push(table);
    let plot = Plot {
        title: format!("fifteen left silhouettes, {runs} runs"),
        x: Axis::logarithmic("noise of the end points / pixels"),
        y: Axis::logarithmic("Frobenius norm of the difference to the true conic"),
        series,
    };
    outcome.draw("one_sided", &plot)?;
    one_sided_range::add(&mut outcome, options)?;
    Ok(outcome)
}

fn instance(can: &Can, random: &mut Random) -> Estimates {
    let drawn = some_of(IMAGES, PHOTOGRAPHS, random);
    let noise = Noise::new(random);
    PIXELS.map(|pixels| {
        let view = |&photograph: &usize| can.view(photograph, &[LEFT], &noise, pixels);
        let views: Vec<_> = drawn.iter().filter_map(view).collect();
        let section = can::cross_section(&views);
        METHODS.map(|(_, solver)| {
            let section = *solver.solve(&section.as_ref()?.lines).ok()?.first()?;
            let circle = section.circle();
            Some(Estimate {
                distance: (section.dual_conic - can::true_dual_conic()).norm(),
                axis: circle.map_or(f64::INFINITY, |circle| circle.centre.coords.norm() * RADIUS),
                radius: circle.map_or(f64::INFINITY, |circle| (circle.radius - 1.0).abs() * RADIUS),
                real: matches!(section.shape, SectionShape::Circle(_) | SectionShape::Ellipse { .. }),
            })
        })
    })
}
