//! Which other cylinders explain the lines about as well.
//!
//! Three lines touch four cylinders, and four lines may have two that are nearly equally good. All
//! local minima of the distances in the images are therefore compared. They are found from the
//! stationary circles of the cross-section and, for few lines, from the circles that touch three of
//! the lines. With Gaussian noise of unknown scale, about which little more is known than its usual
//! size `s`, a cylinder with the sum of squares `c` has the marginal likelihood
//!
//! ```text
//!     L(c) ~ (2 s^2 + c)^(-(nu + 2) / 2),      nu = 2 N - 5 degrees of freedom
//! ```
//!
//! (inverse gamma prior of `sigma^2` with two degrees of freedom). The plausibility of a cylinder
//! is its likelihood over that of the best.

use nalgebra::{Point3, Unit, Vector3};

use super::evidence::Evidence;
use super::triangulate::CrossSection;
use crate::axis::direction::estimate_direction;
use crate::cross_section::closed_form::tangent_circles;
use crate::cross_section::least_squares::StationaryCircles;
use crate::cross_section::section::SectionLine;
use crate::observations::scene::LineId;
use crate::observations::view::ViewingPlane;
use crate::space::cylinder::Cylinder;
use crate::space::silhouette_distance::{DistanceUnit, MeasuredLine};

/// Least plausibility of a cylinder that is listed.
pub(crate) const PLAUSIBLE: f64 = 1e-3;

/// Usual standard deviation of an end point, pixels.
const NOISE_PIXELS: f64 = 0.3;

/// The same in radians: at a focal length of 3000.
const NOISE_RADIANS: f64 = 1e-4;

/// Degrees of freedom that the usual noise is worth.
const PRIOR_FREEDOM: f64 = 2.0;

/// Circles that touch three lines are tried if there are at most so many lines.
const FEW_LINES: usize = 6;

/// Of more than twice as many lines, about so many are looked at first.
const MANY_LINES: usize = 30;

/// Steps of Levenberg-Marquardt to a local minimum.
const STEPS: usize = 1000;

/// Cylinders are the same if radius and axis differ by at most this part of the radius, and the
/// directions by this angle.
const SAME: f64 = 1e-3;

/// A cylinder that explains the lines about as well as the estimate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Alternative {
    /// The cylinder, refined on the distances in the images.
    pub cylinder: Cylinder,
    /// Root mean square distance of the independent lines from its silhouettes, pixels if all
    /// cameras have a calibration, radians otherwise.
    pub rms: f64,
    /// Its likelihood relative to that of the best cylinder.
    pub plausibility: f64,
}

/// All cylinders that explain the lines about as well as the best.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PlausibleCylinders {
    /// The cylinders, the best first. With RANSAC a cylinder on which nearly as many other lines
    /// agree comes after them. Empty if none is in front of all cameras.
    pub cylinders: Vec<Alternative>,
    /// Index of the one near the estimate; `None` if another cylinder explains the lines much
    /// better, or the estimate is not in front of all cameras.
    pub found: Option<usize>,
}

impl PlausibleCylinders {
    /// Whether another cylinder than the estimate is plausible.
    pub fn is_ambiguous(&self) -> bool {
        self.cylinders.len() > usize::from(self.found.is_some())
    }
}

impl Evidence<'_> {
    /// All local minima in front of the cameras, those with less than a thousandth of the
    /// plausibility of the best excepted; the best first. `found` is a cylinder near one of them,
    /// from which it is reached.
    pub(crate) fn plausible_cylinders(&self, found: Option<&Cylinder>) -> PlausibleCylinders {
        // Of many lines, a part decides in most cases.
        if self.measured.len() > 2 * MANY_LINES {
            let step = self.measured.len() / MANY_LINES;
            let planes: Vec<_> = self.planes.iter().step_by(step).copied().collect();
            let measured: Vec<_> = self.measured.iter().step_by(step).copied().collect();
            let part = Evidence { planes: &planes, measured: &measured, distinct: &planes, ..*self };
            let plausible = part.minima(found);
            if !plausible.is_ambiguous() {
                return plausible;
            }
        }
        self.minima(found)
    }

    fn minima(&self, found: Option<&Cylinder>) -> PlausibleCylinders {
        let minimum = |start: &Cylinder| {
            let nearest = self.known.nearest(self.measured, start, STEPS);
            let cylinder = nearest.filter(|cylinder| self.known.has_side(self.measured, cylinder))?;
            Some((cylinder, self.cost(&cylinder)?))
        };
        let of_found = found.and_then(minimum);
        let mut minima: Vec<(Cylinder, f64)> = of_found.into_iter().collect();
        let refined = of_found.map(|(cylinder, _)| cylinder);
        let starts = self.starts(refined.as_ref().or(found));
        let sized = starts.iter().flat_map(|start| self.known.sized(start, &self.cameras()));
        for (cylinder, cost) in sized.filter_map(|start| minimum(&start)) {
            match minima.iter_mut().find(|(known, _)| self.is_same(known, &cylinder)) {
                Some(known) if cost < known.1 => *known = (cylinder, cost),
                Some(_) => {}
                None => minima.push((cylinder, cost)),
            }
        }
        minima.sort_by(|one, other| one.1.total_cmp(&other.1));
        let least = minima.first().map_or(0.0, |&(_, cost)| cost);
        let alternative = |(cylinder, cost): (Cylinder, f64)| Alternative {
            cylinder: cylinder.with_canonical_sign(),
            rms: (cost / (2.0 * self.measured.len() as f64)).sqrt(),
            plausibility: self.likelihood_ratio(least, cost, self.known.parameters()),
        };
        let plausible = |alternative: &Alternative| alternative.plausibility >= PLAUSIBLE;
        let cylinders: Vec<_> = minima.into_iter().map(alternative).filter(plausible).collect();
        let found = of_found.and_then(|(of_found, _)| {
            cylinders.iter().position(|alternative| self.is_same(&alternative.cylinder, &of_found))
        });
        PlausibleCylinders { cylinders, found }
    }

    /// Mean of the camera centres, weighted by their numbers of lines.
    fn cameras(&self) -> Point3<f64> {
        let sum: Vector3<f64> = self.measured.iter().map(|line| line.centre.coords).sum();
        Point3::from(sum / self.measured.len().max(1) as f64)
    }

    /// Likelihood of the sum of squares `cost` relative to that of `least`, for models with this
    /// number of parameters.
    pub(crate) fn likelihood_ratio(&self, least: f64, cost: f64, parameters: f64) -> f64 {
        let prior = PRIOR_FREEDOM * usual_noise(self.unit).powi(2);
        let freedom = 2.0 * self.measured.len() as f64 - parameters;
        ((prior + least) / (prior + cost)).powf((freedom + PRIOR_FREEDOM) / 2.0)
    }

    /// The sum of squares of all distances; `None` if a line is not seen in front of its camera.
    pub(crate) fn cost(&self, cylinder: &Cylinder) -> Option<f64> {
        let square = |line: &MeasuredLine| Some(2.0 * line.square(&line.silhouettes(cylinder)?));
        let cost = self.measured.iter().map(square).sum::<Option<f64>>()?;
        cost.is_finite().then_some(cost)
    }

    /// Whether two cylinders are the same where the lines see them.
    pub(crate) fn is_same(&self, one: &Cylinder, other: &Cylinder) -> bool {
        let size = SAME * one.radius.max(other.radius);
        let Some(line) = self.measured.first() else { return true };
        let Some(at) = line.distance(one).map(|distance| line.contact(&distance)) else { return false };
        (one.radius - other.radius).abs() <= size
            && (one.vector_to_axis(&at) - other.vector_to_axis(&at)).norm() <= size
            && one.direction.cross(&other.direction).norm() <= SAME
    }

    /// Cylinders from which local minima are reached: those along the direction of least squares,
    /// and those along the direction of `found`. The former is poor if lines are short. A known
    /// direction is the only one.
    fn starts(&self, found: Option<&Cylinder>) -> Vec<Cylinder> {
        let mut starts = Vec::new();
        for planes in [self.planes, self.distinct] {
            let all: Vec<_> = planes.iter().map(|&(_, plane)| plane).collect();
            let least_squares = || estimate_direction(&all).ok().map(|direction| direction.direction);
            let directions = match self.known.direction {
                Some(known) => [Some(known), None],
                None => [least_squares(), found.map(|found| found.direction)],
            };
            for direction in directions.iter().flatten() {
                starts.extend(along(planes, direction).into_iter().flatten());
            }
            if self.distinct.len() == self.planes.len() {
                break;
            }
        }
        starts
    }
}

/// Stationary cylinders of the cross-section along a direction, and for few lines those that touch
/// three of them.
fn along(planes: &[(LineId, ViewingPlane)], direction: &Unit<Vector3<f64>>) -> Option<Vec<Cylinder>> {
    let CrossSection { rectification, lines, .. } = CrossSection::of(planes, direction).ok()?;
    let weighted: Vec<_> = lines.iter().map(|&line| SectionLine { line, weight: 1.0, view: 0 }).collect();
    let mut circles: Vec<_> = StationaryCircles::of(&weighted)
        .map(|stationary| stationary.iter().map(|(circle, _)| circle).collect())
        .unwrap_or_default();
    if lines.len() <= FEW_LINES {
        let triples = triples(lines.len());
        circles.extend(triples.flat_map(|triple| tangent_circles(&triple.map(|index| lines[index]))).flatten());
    }
    let cylinder = |circle| Cylinder::from_circle(circle, &rectification, *direction);
    Some(circles.iter().map(cylinder).collect())
}

/// All sets of three indices below `count`.
pub(crate) fn triples(count: usize) -> impl Iterator<Item = [usize; 3]> {
    (0..count)
        .flat_map(move |third| (0..third).flat_map(move |second| (0..second).map(move |first| [first, second, third])))
}

/// The usual standard deviation of an end point, in the unit.
pub(crate) fn usual_noise(unit: DistanceUnit) -> f64 {
    match unit {
        DistanceUnit::Pixels => NOISE_PIXELS,
        DistanceUnit::Radians => NOISE_RADIANS,
    }
}
