//! The second part of `one_sided`: one silhouette in each image, and cameras on one side only. The
//! linear method then fails although its tangents agree with the lines.

use nalgebra::{Point2, Vector2};

use super::error::ExperimentError;
use super::instances::instances;
use super::options::Options;
use super::outcome::Outcome;
use super::proposed::proposed;
use super::quantile::Sorted;
use super::random::instance_seed;
use super::section_scene::Sight;
use super::table::Table;
use crate::picture::{Axis, ConicPicture, Plot, Series};
use crate::random::Random;
use crate::{Circle, LeastSquares, LinearConic, Section, SectionLine, SectionShape, SectionSolver};

const IMAGES: usize = 15;

/// Angles between the outermost viewing directions, degrees.
const RANGES: [f64; 6] = [45.0, 60.0, 90.0, 120.0, 180.0, 360.0];

/// Standard deviations of the angle of a line, radians.
const NOISE: [f64; 4] = [0.0001, 0.0002, 0.0005, 0.001];

/// Indices of the range and the noise of the scene that is drawn.
const DRAWN: (usize, usize) = (2, 2);

/// Distances of the cameras from the axis, radii.
const DISTANCES: [f64; 2] = [10.0, 20.0];

const TRUTH: Circle = Circle { centre: Point2::new(0.0, 0.0), radius: 1.0 };

pub(super) const SETUP: &str = "Table 'ranges': circle of radius 1 at the origin; 15 cameras at distances uniform in [10, 20], \
in directions uniform within a sector of the given range (degrees), each with its left tangent \
only, turned about the camera by normal noise sigma (radians). Distance as above; errors of axis \
and radius in radii. Proposed: of the stationary circles of least squares that lie to the right \
of every line, as the side of the silhouettes tells, the one of least cost. In front: as in \
triangulation, which does not know the side, the best minimum of the cost in front of all \
cameras. 'times': median distance over that of the proposed method. All ranges and levels of \
noise have the same scenes.";

const METHODS: [&str; 3] = ["proposed", "in front", "linear"];

/// Distance of the dual conics, errors of axis and radius (infinite if the conic is not an
/// ellipse).
#[derive(Clone, Copy)]
struct Estimate {
    distance: f64,
    axis: f64,
    radius: f64,
    real: bool,
}

/// Results by range, noise and method; `None` if the method failed.
type Estimates = [[[Option<Estimate>; METHODS.len()]; NOISE.len()]; RANGES.len()];

/// For each camera its position in the sector from -1/2 to 1/2, its distance, and the deviation of
/// its line.
struct Scene(Vec<[f64; 3]>);

impl Scene {
    fn new(random: &mut Random) -> Self {
        let camera = |_| {
            let place = random.uniform(-0.5, 0.5);
            [place, random.uniform(DISTANCES[0], DISTANCES[1]), random.normal()]
        };
        Self((0..IMAGES).map(camera).collect())
    }

    fn sights(&self, range: f64) -> impl Iterator<Item = Sight> {
        self.0.iter().enumerate().map(move |(view, &[place, distance, deviation])| {
            let (sine, cosine) = (range.to_radians() * place).sin_cos();
            let camera = Point2::from(Vector2::new(cosine, sine) * distance);
            Sight { camera, view, deviations: [deviation; 2] }
        })
    }

    /// The section that each method finds, and the lines.
    fn solve(&self, range: f64, noise: f64) -> ([Option<Section>; METHODS.len()], Vec<SectionLine>) {
        let lines: Vec<_> = self.sights(range).map(|sight| sight.lines(&TRUTH, noise)[0]).collect();
        let seen: Vec<_> = self.sights(range).map(|sight| sight.seen(&TRUTH)).collect();
        let linear = LinearConic.solve(&lines).ok().and_then(|sections| sections.into_iter().next());
        // The normal of a left silhouette points at the cylinder.
        let on_its_side = |circle: &Circle| lines.iter().all(|line| line.line.distance(&circle.centre) > 0.0);
        let stationary = LeastSquares.solve(&lines).unwrap_or_default();
        let constrained = stationary.into_iter().find(|section| section.circle().as_ref().is_some_and(on_its_side));
        ([constrained, proposed(&lines, &seen), linear], lines)
    }
}

fn estimate(section: &Section) -> Estimate {
    let circle = section.circle();
    Estimate {
        distance: (section.dual_conic - Section::from_circle(TRUTH, &[]).dual_conic).norm(),
        axis: circle.map_or(f64::INFINITY, |circle| circle.centre.coords.norm()),
        radius: circle.map_or(f64::INFINITY, |circle| (circle.radius - 1.0).abs()),
        real: matches!(section.shape, SectionShape::Circle(_) | SectionShape::Ellipse { .. }),
    }
}

/// Adds the table and the pictures.
pub(super) fn add(outcome: &mut Outcome, options: &Options) -> Result<(), ExperimentError> {
    let runs = outcome.runs;
    let results: Vec<Estimates> = instances(options, runs, |random| {
        let scene = Scene::new(random);
        RANGES.map(|range| NOISE.map(|noise| scene.solve(range, noise).0.map(|found| found.as_ref().map(estimate))))
    });
    let columns = [
        "range",
        "sigma",
        "method",
        "median distance",
        "90 % distance",
        "median axis",
        "median radius",
        "no ellipse",
        "none",
        "times",
    ];
    let mut table = Table::new("ranges", &columns);
    let mut series: Vec<Series> = Vec::new();
    for (level, noise) in NOISE.into_iter().enumerate() {
        let mut points: [Vec<[f64; 2]>; METHODS.len()] = Default::default();
        for (range, degrees) in RANGES.into_iter().enumerate() {
            let mut medians = [f64::NAN; METHODS.len()];
            for (method, name) in METHODS.into_iter().enumerate() {
                let found: Vec<_> = results.iter().filter_map(|result| result[range][level][method]).collect();
                let sorted = |of: fn(&Estimate) -> f64| Sorted::new(found.iter().map(of));
                let distances = sorted(|one| one.distance);
                medians[method] = distances.median();
                let unreal = found.iter().filter(|one| !one.real).count() as f64 / found.len() as f64;
                let none = (runs - found.len()) as f64 / runs as f64;
                let [axis, radius] = [sorted(|one| one.axis).median(), sorted(|one| one.radius).median()];
                let times = medians[method] / medians[0];
                let numbers = [medians[method], distances.quantile(0.9), axis, radius, unreal, none, times];
                table.push([degrees.into(), noise.into(), name.into()].into_iter().chain(numbers.map(Into::into)));
                points[method].push([degrees, medians[method]]);
            }
        }
        if level == DRAWN.1 {
            for (name, points) in METHODS.into_iter().zip(points) {
                series.push(Series { label: name.to_owned(), points, band: None });
            }
        }
    }
    outcome.tables.push(table);
    let plot = Plot {
        title: format!("fifteen left silhouettes, sigma {}, {runs} runs", NOISE[DRAWN.1]),
        x: Axis::logarithmic("viewing range / degrees"),
        y: Axis::logarithmic("median distance to the true conic"),
        series,
    };
    outcome.draw("ranges", &plot)?;
    match example(options, runs) {
        Some(picture) => outcome.draw("example", &picture),
        None => Ok(()),
    }
}

/// The first instance in which both methods find a conic and the linear one is no ellipse.
fn example(options: &Options, runs: usize) -> Option<ConicPicture> {
    let (range, noise) = (RANGES[DRAWN.0], NOISE[DRAWN.1]);
    (0..runs).find_map(|instance| {
        let scene = Scene::new(&mut Random::new(instance_seed(options.seed, instance as u64)));
        let ([circle, _, linear], lines) = scene.solve(range, noise);
        let linear = linear.filter(|section| section.shape == SectionShape::Hyperbola)?;
        let truth = Section::from_circle(TRUTH, &lines);
        let conics = [("truth", truth), ("proposed: circle", circle?), ("linear: hyperbola", linear)];
        Some(ConicPicture {
            title: format!("left silhouettes, range {range} degrees, sigma {noise}"),
            lines: lines.iter().map(|line| line.line).collect(),
            conics: conics.map(|(name, section)| (name.to_owned(), section.dual_conic)).into(),
            middle: Point2::origin(),
            half_side: 3.0 * TRUTH.radius,
        })
    })
}
