//! `conditioning`: cameras that see the cylinder from one side only. The linear estimate is then
//! badly conditioned and turns into a hyperbola; the constrained estimate remains a circle.

use nalgebra::{Matrix3, Point2};

use super::error::ExperimentError;
use super::instances::instances;
use super::options::Options;
use super::outcome::Outcome;
use super::quantile::Sorted;
use super::random::instance_seed;
use super::section_scene::{Sight, errors};
use super::table::Table;
use crate::picture::{Axis, ConicPicture, Plot, Series};
use crate::random::Random;
use crate::{Circle, LeastSquares, LinearConic, Section, SectionLine, SectionShape, SectionSolver};

const RUNS: usize = 2_000;

const CAMERAS: usize = 10;
const RADIUS: f64 = 1.0;

/// Angles between the outermost viewing directions, degrees.
const RANGES: [f64; 11] = [5.0, 10.0, 20.0, 30.0, 45.0, 60.0, 90.0, 120.0, 180.0, 270.0, 360.0];

/// Standard deviations of the angle of a line, radians.
const NOISE: [f64; 5] = [0.0005, 0.001, 0.002, 0.005, 0.01];

/// Indices of the range and the noise of the scene that is drawn.
const DRAWN: (usize, usize) = (3, 2);

const SETUP: &str = "Circle of radius 1; 10 cameras at distances uniform in [5, 15], in directions uniform within a \
sector of the given range (degrees). Each has both tangents, turned about the camera by normal \
noise sigma (radians).\n\
Linear: part of the runs in which the conic is a hyperbola or has no real points. For an \
ellipse, error of the radius of the circle nearest to its tangents, as a quantile over all \
runs ('-' if the quantile falls on a run without ellipse). Least squares: part of the runs \
without a circle; error of its radius. All levels of noise have the same scenes.";

/// The results for one range and one noise.
#[derive(Clone, Copy, Debug)]
struct Estimates {
    linear: Option<SectionShape>,
    /// Infinite if there is no circle.
    linear_error: f64,
    circle_error: f64,
}

pub(super) fn run(options: &Options) -> Result<Outcome, ExperimentError> {
    let runs = options.runs_or(RUNS);
    let results = instances(options, runs, |random| {
        let scene = Scene::new(random);
        RANGES.map(|range| NOISE.map(|noise| estimates(&scene.lines(range, noise))))
    });
    let mut outcome = Outcome::new(SETUP, runs);
    let columns = [
        "range",
        "sigma",
        "linear hyperbola",
        "linear imaginary",
        "linear median error",
        "least squares none",
        "least squares median error",
    ];
    let mut table = Table::new("conditioning", &columns);
    let mut rates: Vec<Series> = Vec::new();
    let mut medians: Vec<Series> = Vec::new();
    for (level, noise) in NOISE.into_iter().enumerate() {
        let series = |label: String| Series { label, points: Vec::new(), band: None };
        let [mut rate, mut circle] =
            [format!("linear, sigma {noise}"), format!("least-squares, sigma {noise}")].map(series);
        for (range, degrees) in RANGES.into_iter().enumerate() {
            let here = || results.iter().map(|result| &result[range][level]);
            let part = |is: &dyn Fn(&Estimates) -> bool| here().filter(|found| is(found)).count() as f64 / runs as f64;
            let hyperbola = part(&|found| found.linear == Some(SectionShape::Hyperbola));
            let imaginary = part(&|found| found.linear == Some(SectionShape::Imaginary));
            let none = part(&|found| found.circle_error.is_infinite());
            let [linear, constrained] = [
                Sorted::new(here().map(|found| found.linear_error)).median(),
                Sorted::new(here().map(|found| found.circle_error)).median(),
            ];
            let numbers = [degrees, noise, hyperbola, imaginary, linear, none, constrained];
            table.push(numbers.map(Into::into));
            rate.points.push([degrees, hyperbola]);
            circle.points.push([degrees, constrained]);
        }
        rates.push(rate);
        medians.push(circle);
    }
    outcome.tables.push(table);
    let x = || Axis::logarithmic("viewing range / degrees");
    let y = Axis::linear("part of the runs");
    let title = format!("linear estimate is a hyperbola, {runs} runs");
    outcome.draw("hyperbolas", &Plot { title, x: x(), y, series: rates })?;
    let y = Axis::logarithmic("median error of the radius / radius");
    let title = format!("constrained least squares, {runs} runs");
    outcome.draw("least_squares", &Plot { title, x: x(), y, series: medians })?;
    if let Some(picture) = example(options, runs) {
        outcome.draw("example", &picture)?;
    }
    Ok(outcome)
}

/// Cameras at random places of a sector of unit width, with the deviations of their lines.
struct Scene(Vec<Place>);

/// Position in the sector, from -1/2 to 1/2, distance, and deviations of the lines.
struct Place {
    direction: f64,
    distance: f64,
    deviations: [f64; 2],
}

impl Scene {
    fn new(random: &mut Random) -> Self {
        let place = |_| Place {
            direction: random.uniform(-0.5, 0.5),
            distance: random.uniform(5.0, 15.0),
            deviations: [random.normal(), random.normal()],
        };
        Self((0..CAMERAS).map(place).collect())
    }

    fn lines(&self, range: f64, noise: f64) -> Vec<SectionLine> {
        let lines = |(view, place): (usize, &Place)| {
            let (sine, cosine) = (range.to_radians() * place.direction).sin_cos();
            let camera = Point2::new(cosine, sine) * place.distance;
            Sight { camera, view, deviations: place.deviations }.lines(&truth(), noise)
        };
        self.0.iter().enumerate().flat_map(lines).collect()
    }
}

fn truth() -> Circle {
    Circle { centre: Point2::origin(), radius: RADIUS }
}

fn estimates(lines: &[SectionLine]) -> Estimates {
    let first = |solver: &dyn SectionSolver| solver.solve(lines).ok().and_then(|sections| sections.into_iter().next());
    let error = |section: Option<Section>| {
        section.and_then(|section| section.circle()).map_or(f64::INFINITY, |circle| errors(&circle, &truth())[1])
    };
    let linear = first(&LinearConic);
    Estimates {
        linear: linear.map(|section| section.shape),
        linear_error: error(linear),
        circle_error: error(first(&LeastSquares)),
    }
}

/// The first instance in which the linear estimate is a hyperbola.
fn example(options: &Options, runs: usize) -> Option<ConicPicture> {
    let (range, level) = DRAWN;
    (0..runs).find_map(|instance| {
        let scene = Scene::new(&mut Random::new(instance_seed(options.seed, instance as u64)));
        let lines = scene.lines(RANGES[range], NOISE[level]);
        let linear = *LinearConic.solve(&lines).ok()?.first()?;
        let circle = *LeastSquares.solve(&lines).ok()?.first()?;
        let conics = [
            ("truth", Section::from_circle(truth(), &lines).dual_conic),
            ("least squares: circle", circle.dual_conic),
            ("linear: hyperbola", linear.dual_conic),
        ];
        let conics: Vec<(String, Matrix3<f64>)> =
            conics.into_iter().map(|(name, conic)| (name.to_owned(), conic)).collect();
        let title = format!("range {} degrees, sigma {}", RANGES[range], NOISE[level]);
        let lines = lines.iter().map(|line| line.line).collect();
        (linear.shape == SectionShape::Hyperbola).then_some(ConicPicture {
            title,
            lines,
            conics,
            middle: Point2::origin(),
            half_side: 3.0 * RADIUS,
        })
    })
}
