//! `noise`: error of centre and radius against the noise of the lines, for the minimal solver and
//! for least squares.

use nalgebra::Point2;

use super::error::ExperimentError;
use super::instances::instances;
use super::options::Options;
use super::outcome::Outcome;
use super::proposed::proposed;
use super::quantile::Sorted;
use super::section_scene::{Sight, least_errors};
use super::table::Table;
use crate::picture::{Axis, Band, Plot, Series};
use crate::random::Random;
use crate::{Circle, LeastSquares, Minimal, Section, SectionLine, SectionSolver};

const RUNS: usize = 10_000;

/// Number of levels of noise above zero, and the highest level, radians.
const LEVELS: usize = 10;
const HIGHEST: f64 = 0.02;

/// Cameras, each with two lines.
const CAMERAS: usize = 5;

const SETUP: &str = "Circle at the origin, radius uniform in (0.5, 2); cameras uniform in the square of side 40 \
without the inner square of side 6. Each has both tangents, turned about the camera by normal \
noise of standard deviation sigma (radians), sigma from 0 to 0.02.\n\
Minimal: three lines of the first two cameras, and of the four circles the one nearest to the \
truth. Least squares: all lines of the first 2, 3 and 5 cameras. Circle: 'nearest' is the \
stationary circle nearest to the truth, as in the paper; 'in front' the best minimum in front of \
all cameras, as in triangulation; 'least cost' the global minimum.\n\
Errors are in units of the scene. All levels have the same scenes and deviations. Linear \
response: the part of the variation of the medians that a line through the origin does not \
explain (1 - R^2).";

/// Which of the circles of a method counts.
#[derive(Clone, Copy)]
enum Choice {
    /// The one nearest to the truth, as in the paper.
    Nearest,
    /// The best minimum in front of all cameras, as in triangulation.
    InFront,
    /// The one of least cost.
    Best,
}

/// Solver, number of lines, choice and its name. The last is in the tables only.
const METHODS: [(&dyn SectionSolver, usize, Choice, &str); 6] = [
    (&Minimal, 3, Choice::Nearest, "nearest"),
    (&LeastSquares, 4, Choice::Nearest, "nearest"),
    (&LeastSquares, 4, Choice::InFront, "in front"),
    (&LeastSquares, 6, Choice::InFront, "in front"),
    (&LeastSquares, 10, Choice::InFront, "in front"),
    (&LeastSquares, 4, Choice::Best, "least cost"),
];

/// Errors of centre and radius, by level and method.
type Errors = [[[f64; 2]; METHODS.len()]; LEVELS + 1];

pub(super) fn run(options: &Options) -> Result<Outcome, ExperimentError> {
    let runs = options.runs_or(RUNS);
    let results: Vec<Errors> = instances(options, runs, instance);
    let mut outcome = Outcome::new(SETUP, runs);
    let mut linearity = Table::new("linearity", &["error", "method", "lines", "circle", "median / sigma", "1 - R^2"]);
    for (index, error) in ["translation", "radius"].into_iter().enumerate() {
        let columns = ["sigma", "method", "lines", "circle", "25 %", "median", "75 %", "mean"];
        let mut table = Table::new(error, &columns);
        let mut series = Vec::new();
        for (method, (solver, lines, choice, name)) in METHODS.into_iter().enumerate() {
            let mut points = Vec::new();
            let mut limits = Vec::new();
            for level in 0..=LEVELS {
                let sample = Sorted::new(results.iter().map(|result| result[level][method][index]));
                let [low, high] = [0.25, 0.75].map(|part| sample.quantile(part));
                let numbers = [low, sample.median(), high, sample.mean()].map(Into::into);
                let names = [sigma(level).into(), solver.name().into(), lines.into(), name.into()];
                table.push(names.into_iter().chain(numbers));
                points.push([sigma(level), sample.median()]);
                limits.push([sigma(level), low, high]);
            }
            let (slope, unexplained) = line_through_origin(&points);
            let names = [error.into(), solver.name().into(), lines.into(), name.into()];
            linearity.push(names.into_iter().chain([slope.into(), unexplained.into()]));
            if matches!(choice, Choice::Best) {
                continue;
            }
            let label = format!("{}, {lines} lines, {name}", solver.name());
            // Only one band is drawn, because four would hide each other.
            let band = (lines == 10).then(|| Band { label: "its middle half".to_owned(), limits });
            series.push(Series { label, points, band });
        }
        outcome.tables.push(table);
        let plot = Plot {
            title: format!("median {error} error, {runs} runs"),
            x: Axis::linear("noise of the lines sigma / rad"),
            y: Axis::linear(&format!("{error} error / world units")),
            series,
        };
        outcome.draw(error, &plot)?;
    }
    outcome.tables.push(linearity);
    Ok(outcome)
}

fn sigma(level: usize) -> f64 {
    HIGHEST * level as f64 / LEVELS as f64
}

fn instance(random: &mut Random) -> Errors {
    let truth = Circle { centre: Point2::origin(), radius: random.uniform(0.5, 2.0) };
    let sights: [Sight; CAMERAS] = std::array::from_fn(|view| Sight::new(camera(random), view, random));
    let seen: Vec<_> = sights.iter().flat_map(|sight| [sight.seen(&truth); 2]).collect();
    std::array::from_fn(|level| {
        let lines: Vec<SectionLine> = sights.iter().flat_map(|sight| sight.lines(&truth, sigma(level))).collect();
        METHODS.map(|(solver, count, choice, _)| {
            let lines = &lines[..count];
            let found = match choice {
                Choice::InFront => proposed(lines, &seen[..count]).into_iter().collect(),
                Choice::Nearest => solver.solve(lines).unwrap_or_default(),
                Choice::Best => solver.solve(lines).unwrap_or_default().into_iter().take(1).collect(),
            };
            least_errors(found.iter().filter_map(Section::circle), &truth)
        })
    })
}

/// A point uniform in the large square without the small one.
fn camera(random: &mut Random) -> Point2<f64> {
    // Each try fails with a probability of 1 / 44.
    for _ in 0..100 {
        let camera = Point2::new(random.uniform(-20.0, 20.0), random.uniform(-20.0, 20.0));
        if camera.coords.amax() > 3.0 {
            return camera;
        }
    }
    Point2::new(20.0, 20.0)
}

/// Slope of the least squares line through the origin, and the part of the variation of `y` that it
/// does not explain.
fn line_through_origin(points: &[[f64; 2]]) -> (f64, f64) {
    let slope = points.iter().map(|[x, y]| x * y).sum::<f64>() / points.iter().map(|[x, _]| x * x).sum::<f64>();
    let mean = points.iter().map(|[_, y]| y).sum::<f64>() / points.len() as f64;
    let left: f64 = points.iter().map(|[x, y]| (y - slope * x).powi(2)).sum();
    (slope, left / points.iter().map(|[_, y]| (y - mean).powi(2)).sum::<f64>())
}
