//! Points of the scene as evidence for cylinders, beside lines.
//!
//! A sparse model has points on the surface of a cylinder and points of other things near it. Along
//! the distance `d` from the surface the first are normal with a deviation that is not known, the
//! others uniform:
//!
//! ```text
//!   p(d) = s N(d; 0, sigma^2) + (1 - s) / (2 b),    |d| < b
//! ```
//!
//! Share and deviation are those of greatest likelihood (expectation-maximisation), anew after each
//! refinement. A point counts with the probability that it is on the surface, and relative to a
//! line by the ratio of their variances. The variances are estimated, too, each from the squared
//! residuals of its kind over what the parameters leave of their number (Förstner, "Ein Verfahren
//! zur Schätzung von Varianz- und Kovarianzkomponenten", 1979).

use nalgebra::{Matrix5, Point3, Vector5};

use super::alternatives::PlausibleCylinders;
use super::estimate::{Estimate, SurfacePoints};
use super::joint::{Directions, JointRefinement, Model, Radii, refine_together};
use super::joint_estimate::{JointError, JointEstimate, JointMethod, metric};
use super::refine::{RefineError, Refinement};
use super::silhouette_cost::{Observed, PARAMETERS, WeightedPoint};
use super::warnings::Warning;
use crate::observations::copies::IndependentLines;
use crate::observations::view::View;
use crate::space::cylinder::Cylinder;
use crate::space::extent::visible_extent;
use crate::space::silhouette_distance::MeasuredLine;

/// Points further from the surface than this part of the radius are not looked at.
const BAND: f64 = 0.25;
/// Fewer points on a surface are no evidence.
const ENOUGH: f64 = 10.0;
/// If their deviation is a larger part of the band, points do not gather at the surface.
const SPREAD: f64 = 1.0 / 3.0;
/// Points lean to another cylinder if this ratio of squares (an F statistic) is larger: by chance
/// it is one in a million.
const LEANING: f64 = 10.0;
/// The least deviation, relative to the radius: below it are rounding errors.
const EXACT: f64 = 1e-9;
/// A cylinder with so many times the points of each other one is the one.
const DECISIVE: f64 = 2.0;
/// Limits on the steps of expectation-maximisation, and on refinements.
const STEPS: usize = 50;
const ROUNDS: usize = 30;
/// The variances are known well enough if they change by less than this part.
const SETTLED: f64 = 1e-3;

/// Refines cylinders on the lines that agree with them and on the points near their surfaces.
/// `cylinders` are the views from which each was estimated, `method` says what they share. Of
/// several cylinders that explain the lines about equally well, that with most points is taken, if
/// it has twice as many as each of the others. Where points and lines do not agree, the estimate
/// has a warning.
///
/// # Errors
/// [`JointError`], also if lines alone do not determine the cylinders.
pub fn with_points(
    mut estimate: JointEstimate,
    cylinders: &[Vec<View>],
    points: &[Point3<f64>],
    method: &JointMethod,
) -> Result<JointEstimate, JointError> {
    let model = method.model();
    let (metric, mut subjects) = (metric(cylinders), Vec::new());
    for (index, (estimate, views)) in estimate.cylinders.iter().zip(cylinders).enumerate() {
        method.interrupt.check()?;
        let views = estimate.agreeing(views);
        let lines = metric
            .measured(&IndependentLines::of(&views))
            .map_err(|error| JointError::Cylinder { cylinder: index, error: RefineError::from(error).into() })?;
        subjects.push(Subject { views, lines, points: Vec::new(), found: SurfacePoints::default() });
    }
    for (subject, estimate) in subjects.iter_mut().zip(&mut estimate.cylinders) {
        method.interrupt.check()?;
        subject.decide(estimate, points);
    }
    let start: Vec<_> = estimate.cylinders.iter().map(|estimate| estimate.cylinder).collect();
    let of_lines = refine_together(&observed(&subjects), &start, &model)?;
    let JointRefinement { cylinders: refined, radius } = settled(&mut subjects, of_lines.clone(), points, &model)?;
    let mut estimates = Vec::with_capacity(subjects.len());
    let parts = estimate.cylinders.into_iter().zip(subjects).zip(of_lines.cylinders.iter().zip(refined));
    for (index, ((estimate, subject), (before, after))) in parts.enumerate() {
        let failure = |error: RefineError| JointError::Cylinder { cylinder: index, error: error.into() };
        let disagrees = subject.found.count > 0.0 && (!before.is_near(&after.cylinder) || subject.leans(&after));
        let disagrees = disagrees.then_some(Warning::PointsDisagree);
        let estimate = estimate.with_refinement(&cylinders[index], after, metric.unit).map_err(failure)?;
        let warnings = estimate.warnings.iter().copied().chain(disagrees).collect();
        estimates.push(Estimate { surface_points: Some(subject.found), warnings, ..estimate });
    }
    Ok(JointEstimate { cylinders: estimates, radius })
}

/// A cylinder with what is known of it.
struct Subject {
    /// With the lines that agree.
    views: Vec<View>,
    lines: Vec<MeasuredLine>,
    points: Vec<WeightedPoint>,
    found: SurfacePoints,
}

fn observed(subjects: &[Subject]) -> Vec<Observed<'_>> {
    subjects.iter().map(|subject| Observed { lines: &subject.lines, points: &subject.points }).collect()
}

/// Cylinders, points on them and variances that belong together.
fn settled(
    subjects: &mut [Subject],
    mut joint: JointRefinement,
    points: &[Point3<f64>],
    model: &Model<'_>,
) -> Result<JointRefinement, JointError> {
    let mut noise = joint.cylinders.first().map_or(0.0, |first| first.noise);
    for _ in 0..ROUNDS {
        let cylinders: Vec<_> = joint.cylinders.iter().map(|refinement| refinement.cylinder).collect();
        for (index, subject) in subjects.iter_mut().enumerate() {
            model.interrupt.check()?;
            subject.look(&cylinders, index, points, noise);
        }
        joint = refine_together(&observed(subjects), &cylinders, model)?;
        let variances = Variances::of(subjects, &joint, model);
        let change = (variances.of_lines.sqrt() / noise - 1.0).abs();
        let moved = subjects.iter_mut().zip(&variances.of_points).map(|(subject, variance)| {
            let before = std::mem::replace(&mut subject.found.deviation, variance.sqrt());
            (before / variance.sqrt() - 1.0).abs()
        });
        let settled = moved.filter(|moved| !moved.is_nan()).fold(change, f64::max) < SETTLED;
        noise = variances.of_lines.sqrt();
        if settled || subjects.iter().all(|subject| subject.points.is_empty()) {
            break;
        }
    }
    Ok(joint)
}

impl Subject {
    /// Of the cylinders that explain the lines, takes the one with most points.
    fn decide(&mut self, estimate: &mut Estimate, points: &[Point3<f64>]) {
        let Some(plausible) = estimate.plausible.as_ref().filter(|plausible| plausible.is_ambiguous()) else { return };
        let mut counts = Vec::with_capacity(plausible.cylinders.len());
        for alternative in &plausible.cylinders {
            self.found = SurfacePoints::default();
            self.look(&[alternative.cylinder], 0, points, 1.0);
            counts.push((self.found.count, *alternative));
        }
        (self.points, self.found) = (Vec::new(), SurfacePoints::default());
        counts.sort_by(|a, b| b.0.total_cmp(&a.0));
        let second = counts.get(1).map_or(0.0, |(count, _)| *count);
        let Some((_, best)) = counts.first().filter(|(count, _)| *count > 0.0 && *count >= DECISIVE * second) else {
            return;
        };
        estimate.cylinder = best.cylinder;
        estimate.plausible = Some(PlausibleCylinders { cylinders: vec![*best], found: Some(0) });
        // What was said of the choice is no longer so.
        let is_decided = |warning: &Warning| {
            matches!(
                warning,
                Warning::Ambiguous { .. } | Warning::NotTheBest | Warning::ThreeLines | Warning::FarFromRefined { .. }
            )
        };
        estimate.warnings.retain(|warning| !is_decided(warning));
    }

    /// Finds the points on the surface of the cylinder with this index, and weighs them against
    /// lines of this noise.
    fn look(&mut self, cylinders: &[Cylinder], index: usize, points: &[Point3<f64>], noise: f64) {
        let (cylinder, band) = (&cylinders[index], BAND * cylinders[index].radius);
        let extent = visible_extent(cylinder, &self.views, &[]);
        let is_candidate = |point: &&Point3<f64>| {
            let distance = cylinder.distance(point).abs();
            let height = cylinder.height(point);
            distance < band
                && extent.is_none_or(|[low, high]| (low..=high).contains(&height))
                && self.views.iter().any(|view| faces(cylinder, point, &view.camera().centre()))
                // Of two surfaces a point is on the nearer one.
                && cylinders.iter().enumerate().all(|(at, other)| at == index || distance <= other.distance(point).abs())
        };
        let near: Vec<_> = points.iter().filter(is_candidate).collect();
        let distances: Vec<f64> = near.iter().map(|point| cylinder.distance(point)).collect();
        let mixture = Mixture::of(&distances, band, EXACT * cylinder.radius);
        let count = mixture.as_ref().map_or(0.0, |mixture| mixture.share * distances.len() as f64);
        let Some(mixture) = mixture.filter(|mixture| count >= ENOUGH && mixture.deviation < SPREAD * band) else {
            (self.points, self.found) = (Vec::new(), SurfacePoints::default());
            return;
        };
        // The deviation about the cylinder that is known now; that of all rounds before is better.
        let known = self.found.deviation;
        let deviation = if known > 0.0 { known } else { mixture.deviation };
        let weighted = |(position, &distance): (&Point3<f64>, &f64)| {
            let share = mixture.on_surface(distance);
            WeightedPoint { position: *position, share, weight: share * (noise / deviation).powi(2) }
        };
        self.points = near.into_iter().zip(&distances).map(weighted).collect();
        self.found = SurfacePoints { count, deviation };
    }
}

/// Whether the surface at a point is turned to a camera.
fn faces(cylinder: &Cylinder, point: &Point3<f64>, centre: &Point3<f64>) -> bool {
    cylinder.vector_to_axis(point).dot(&(centre - point)) < 0.0
}

/// Distances from a surface: of points on it, and of others.
struct Mixture {
    share: f64,
    deviation: f64,
    band: f64,
}

impl Mixture {
    /// That of greatest likelihood, by expectation-maximisation; `None` without distances. The
    /// deviation is at least `least`.
    fn of(distances: &[f64], band: f64, least: f64) -> Option<Self> {
        if distances.is_empty() {
            return None;
        }
        let mut mixture = Self { share: 0.5, deviation: (SPREAD * band).max(least), band };
        for _ in 0..STEPS {
            let (mut sum, mut squares) = (0.0, 0.0);
            for &distance in distances {
                let share = mixture.on_surface(distance);
                sum += share;
                squares += share * distance * distance;
            }
            if sum <= 0.0 {
                break;
            }
            mixture.share = sum / distances.len() as f64;
            mixture.deviation = (squares / sum).sqrt().max(least);
        }
        Some(mixture)
    }

    /// The probability that a point at this distance is on the surface.
    fn on_surface(&self, distance: f64) -> f64 {
        let normal =
            (-(distance / self.deviation).powi(2) / 2.0).exp() / (self.deviation * std::f64::consts::TAU.sqrt());
        let [surface, other] = [self.share * normal, (1.0 - self.share) / (2.0 * self.band)];
        if surface > 0.0 { surface / (surface + other) } else { 0.0 }
    }
}

/// The variances of the distances of lines in the images, and of points from each surface.
struct Variances {
    of_lines: f64,
    of_points: Vec<f64>,
}

impl Variances {
    /// Squared residuals over their number less what the parameters take. The points of cylinder k
    /// take `tr(N_k N^-1)`, where `N_k` is their part of the normal matrix `N`.
    fn of(subjects: &[Subject], joint: &JointRefinement, &Model { directions, radii, .. }: &Model<'_>) -> Self {
        let (mut squares, mut lines, mut taken) = (0.0, 0.0, 0.0);
        let mut of_points = Vec::with_capacity(subjects.len());
        for (subject, refinement) in subjects.iter().zip(&joint.cylinders) {
            squares += refinement.rms.powi(2) * 2.0 * subject.lines.len() as f64;
            lines += 2.0 * subject.lines.len() as f64;
            let OfPoints { normal_matrix, squares: of_distances, count, .. } = subject.points_of(refinement);
            let weight = 1.0 / subject.found.deviation.powi(2);
            let part = if count > 0.0 { (normal_matrix * refinement.covariance * weight).trace() } else { 0.0 };
            let part = part.clamp(0.0, count);
            taken += part;
            of_points.push(of_distances / (count - part).max(1.0));
        }
        let cylinders = subjects.len() as f64;
        let own = |is_own: bool, is_shared: bool| if is_own { cylinders } else { f64::from(u8::from(is_shared)) };
        let parameters = 2.0 * cylinders
            + 2.0 * own(directions == Directions::Own, directions == Directions::Shared)
            + own(radii == Radii::Own, radii == Radii::Shared);
        Self { of_lines: squares / (lines - (parameters - taken).max(0.0)).max(1.0), of_points }
    }
}

/// What the distances of points from a refined cylinder say of it, in its local parameters: sums
/// over the points, each with the probability that it is on the surface.
#[derive(Default)]
struct OfPoints {
    /// Of the derivatives, `j j^T`.
    normal_matrix: Matrix5<f64>,
    /// Of the products `j d`.
    gradient: Vector5<f64>,
    /// Of the squares `d^2`.
    squares: f64,
    /// Of the probabilities.
    count: f64,
}

impl Subject {
    fn points_of(&self, refinement: &Refinement) -> OfPoints {
        let mut sum = OfPoints::default();
        for point in &self.points {
            let place = (&refinement.reference, &refinement.across);
            let Some((distance, derivatives)) = point.distance(&refinement.cylinder, place) else { continue };
            sum.normal_matrix += derivatives * derivatives.transpose() * point.share;
            sum.gradient += derivatives * (point.share * distance);
            sum.squares += point.share * distance * distance;
            sum.count += point.share;
        }
        sum
    }

    /// Whether the points alone would move the cylinder by far more than their noise: if the
    /// squares that the five parameters take away are many times those that five points keep.
    fn leans(&self, refinement: &Refinement) -> bool {
        let OfPoints { normal_matrix, gradient, squares, count } = self.points_of(refinement);
        let step = normal_matrix.cholesky().map(|cholesky| cholesky.solve(&gradient));
        let taken = step.map_or(0.0, |step| step.dot(&gradient));
        let kept = (squares - taken).max(0.0) / (count - PARAMETERS as f64);
        taken / PARAMETERS as f64 > LEANING * kept
    }
}
