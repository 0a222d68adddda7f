//! The second part of `table1`, as in the paper: views drawn among 18 fixed photographs, whose
//! noise is drawn once, and the circle of all 18 photographs as the truth.

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector, Matrix3, Point2, Vector2, Vector3};

use super::can::PHOTOGRAPHS;
use super::error::ExperimentError;
use super::instances::{instances, seeded_instances};
use super::options::Options;
use super::outcome::Outcome;
use super::proposed::proposed;
use super::quantile::Sorted;
use super::random::{instance_seed, some_of};
use super::section_scene::Sight as Photograph;
use super::table::Table;
use crate::cross_section::sight::Sight;
use crate::random::Random;
use crate::{Circle, LeastSquares, Navab, Section, SectionLine, SectionSolver};

/// Numbers of photographs.
pub(super) const IMAGES: [usize; 5] = [2, 3, 5, 10, 15];

/// The circle has radius 1 and is ten radii from the origin of the coordinates.
const TRUTH: Circle = Circle { centre: Point2::new(10.0, 0.0), radius: 1.0 };

/// Distances of the cameras from the axis, radii: those of the simulated can.
const DISTANCES: [f64; 2] = [450.0 / 33.0, 600.0 / 33.0];

/// Standard deviation of the angle of a line, radians.
const NOISE: f64 = 0.002;

/// Limit on the iterations of the singular value decomposition.
const SVD_ITERATIONS: usize = 500;

/// Singular values below this, relative to the largest, count as zero.
const RANK: f64 = 1e-12;

/// Sets of photographs for the spread of the means, each with its own cameras and noise.
const SETS: usize = 200;

pub(super) const SETUP: &str = "Tables 'fixed' and 'fixed_sets': the set-up of the paper. A circle of radius 1, ten radii from \
the origin of the coordinates; 18 cameras around it, one in each sector of 20 degrees, 13.6 to \
18.2 radii from its centre; each of the 36 lines is turned about its camera by normal noise of \
0.002 rad, drawn once for all runs. Each run draws photographs among the 18. Truth: the least \
squares circle of all 18 photographs. Linear: least squares for d6 = -1 in these coordinates, \
the solution of minimum norm with two images. Nearest: of all stationary circles of least squares \
the one nearest to the truth. Axis equations: another reading of Navab's method, linear in axis \
and radius. 'above 10' and 'none': parts of the runs with such a distance, and without result. \
'fixed' has one set of photographs, 'fixed_sets' the quantiles over 200 sets of the mean over \
their runs. 'paper': the figure of the paper's Table 1.";

const METHODS: [&str; 5] = ["proposed", "nearest", "linear", "navab", "axis equations"];

/// The paper's Table 1, by method and number of images.
const PAPER: [[f64; IMAGES.len()]; METHODS.len()] = [
    [1.447, 0.497, 0.294, 0.148, 0.072],
    [1.447, 0.497, 0.294, 0.148, 0.072],
    [50.53, 0.556, 0.299, 0.151, 0.074],
    [0.885, 0.512, 0.389, 0.302, 0.278],
    [0.885, 0.512, 0.389, 0.302, 0.278],
];

/// Distances by number of images and method; infinite if the method failed.
type Distances = [[f64; METHODS.len()]; IMAGES.len()];

/// The lines of all photographs, two of each, with their cameras.
struct Set {
    lines: Vec<SectionLine>,
    sights: Vec<Sight>,
    truth: Matrix3<f64>,
}

impl Set {
    /// `None` if all photographs together determine no circle.
    fn new(random: &mut Random) -> Option<Self> {
        let mut set = Self { lines: Vec::new(), sights: Vec::new(), truth: Matrix3::zeros() };
        for view in 0..PHOTOGRAPHS {
            let angle = TAU * (view as f64 + random.uniform(0.0, 0.8)) / PHOTOGRAPHS as f64;
            let outward = Vector2::new(angle.cos(), angle.sin());
            let camera = TRUTH.centre + outward * random.uniform(DISTANCES[0], DISTANCES[1]);
            let photograph = Photograph::new(camera, view, random);
            set.lines.extend(photograph.lines(&TRUTH, NOISE));
            set.sights.extend([photograph.seen(&TRUTH); 2]);
        }
        set.truth = proposed(&set.lines, &set.sights)?.dual_conic;
        Some(set)
    }

    fn distances(&self, random: &mut Random) -> Distances {
        let drawn = some_of(PHOTOGRAPHS, PHOTOGRAPHS, random);
        IMAGES.map(|images| {
            let indices = || drawn[..images].iter().flat_map(|photograph| [2 * photograph, 2 * photograph + 1]);
            let lines: Vec<_> = indices().map(|index| self.lines[index]).collect();
            let sights: Vec<_> = indices().map(|index| self.sights[index]).collect();
            let navab = Navab.solve(&lines).ok().and_then(|sections| Some(sections.first()?.dual_conic));
            let proposed = proposed(&lines, &sights).map(|section| section.dual_conic);
            let distance = |conic: Matrix3<f64>| (conic - self.truth).norm();
            let stationary = LeastSquares.solve(&lines).unwrap_or_default();
            let nearest = stationary.iter().map(|section| distance(section.dual_conic)).fold(f64::INFINITY, f64::min);
            let [proposed, linear, navab, equations] =
                [proposed, linear(&lines), navab, axis_equations(&lines, &sights)]
                    .map(|conic| conic.map_or(f64::INFINITY, distance));
            [proposed, nearest, linear, navab, equations]
        })
    }
}

/// The dual conic by least squares for `d6 = -1`: the solution of minimum norm if the lines leave
/// several.
fn linear(lines: &[SectionLine]) -> Option<Matrix3<f64>> {
    let row = |line: &SectionLine| {
        let (a, b, c) = (line.line.normal.x, line.line.normal.y, line.line.offset);
        [a * a, 2.0 * a * b, 2.0 * a * c, b * b, 2.0 * b * c]
    };
    let matrix = DMatrix::from_row_iterator(lines.len(), 5, lines.iter().flat_map(row));
    let right = DVector::from_iterator(lines.len(), lines.iter().map(|line| line.line.offset.powi(2)));
    let svd = matrix.try_svd(true, true, f64::EPSILON, SVD_ITERATIONS)?;
    let d = svd.solve(&right, RANK * svd.singular_values.max()).ok()?;
    Some(Matrix3::new(d[0], d[1], d[2], d[1], d[3], d[4], d[2], d[4], -1.0))
}

/// Another reading of Navab's canonical representation: half of the angle between the planes of a
/// view is `theta` with `sin(theta) = r / d`, so that with the unit vector `e` from the camera `C`
/// towards the axis
///
/// ```text
///   p - (r / sin(theta)) e = C
/// ```
///
/// are two equations for each view, linear in the axis `p` and the radius. All have weight 1.
fn axis_equations(lines: &[SectionLine], sights: &[Sight]) -> Option<Matrix3<f64>> {
    let (mut matrix, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for (pair, sight) in lines.chunks_exact(2).zip(sights.iter().step_by(2)) {
        let [first, second] = [0, 1].map(|side| pair[side].line.normal);
        let second = if first.dot(&second) > 0.0 { -second } else { second };
        let half = (first + second) / 2.0;
        let half = if half.dot(&sight.ray?) > 0.0 { half } else { -half };
        for axis in 0..2 {
            let mut row = Vector3::new(0.0, 0.0, -half[axis] / half.norm_squared());
            row[axis] = 1.0;
            matrix += row * row.transpose();
            right += row * sight.camera[axis];
        }
    }
    let found = matrix.try_inverse()? * right;
    let circle = Circle { centre: Point2::new(found.x, found.y), radius: found.z };
    Some(Section::from_circle(circle, lines).dual_conic)
}

/// Adds both tables and the picture.
pub(super) fn add(outcome: &mut Outcome, options: &Options) -> Result<(), ExperimentError> {
    let runs = outcome.runs;
    // Seeds from the upper end, so that they are not those of the runs.
    let set = |index: usize| Set::new(&mut Random::new(instance_seed(options.seed, u64::MAX - 1 - index as u64)));
    let unsolved = || ExperimentError::Unsolved("the 18 photographs of `table1` determine no circle".to_owned());
    let fixed = set(0).ok_or_else(unsolved)?;
    let results = instances(options, runs, |random| fixed.distances(random));
    let columns = ["images", "method", "mean", "median", "above 10", "none", "paper"];
    let mut table = Table::new("fixed", &columns);
    for (count, images) in IMAGES.into_iter().enumerate() {
        for (method, name) in METHODS.into_iter().enumerate() {
            let all = Sorted::new(results.iter().map(|result| result[count][method]));
            let found = Sorted::new(results.iter().map(|result| result[count][method]).filter(|one| one.is_finite()));
            let none = all.count_above(f64::MAX) as f64 / runs as f64;
            let far = found.count_above(10.0) as f64 / runs as f64;
            let numbers = [found.mean(), found.median(), far, none, PAPER[method][count]];
            table.push([images.into(), name.into()].into_iter().chain(numbers.map(Into::into)));
        }
    }
    outcome.tables.push(table);
    outcome.tables.push(of_many_sets(options, runs));
    Ok(())
}

/// The spread of the means over sets of photographs.
fn of_many_sets(options: &Options, runs: usize) -> Table {
    let each = runs.div_ceil(SETS);
    let means = seeded_instances(options, SETS, |seed| {
        let random = &mut Random::new(seed);
        let set = Set::new(random)?;
        let results: Vec<_> = (0..each).map(|_| set.distances(random)).collect();
        let mean = |count: usize, method: usize| {
            let found = results.iter().map(|result| result[count][method]).filter(|one| one.is_finite());
            Sorted::new(found).mean()
        };
        Some(std::array::from_fn::<_, { IMAGES.len() }, _>(|count| {
            std::array::from_fn::<_, { METHODS.len() }, _>(|method| mean(count, method))
        }))
    });
    let mut table = Table::new("fixed_sets", &["images", "method", "10 %", "50 %", "90 %", "paper"]);
    for (count, images) in IMAGES.into_iter().enumerate() {
        for (method, name) in METHODS.into_iter().enumerate() {
            let sample = Sorted::new(means.iter().flatten().map(|mean| mean[count][method]));
            let [low, median, high] = [0.1, 0.5, 0.9].map(|part| sample.quantile(part));
            let numbers = [low, median, high, PAPER[method][count]];
            table.push([images.into(), name.into()].into_iter().chain(numbers.map(Into::into)));
        }
    }
    table
}
