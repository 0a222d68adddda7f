//! The sum of squared distances of lines from the silhouettes of a cylinder, and of points from its
//! surface, as a function of five local parameters.
//!
//! A step turns the direction `w`, moves the point `A` of the axis across it and adds to the
//! radius:
//!
//! ```text
//!   (f1^T dw, f2^T dw, f1^T dA, f2^T dA, dr),    f1, f2: unit vectors across the axis
//! ```
//!
//! `A` is in the middle of the part that the lines see, so that a turn moves the silhouettes
//! little.

use nalgebra::{Point3, SVector, U5, Unit, Vector3};

use super::loss::Loss;
use super::refine_error::RefineError;
use crate::numerics::levenberg_marquardt::{LeastSquares, Linearised};
use crate::space::cylinder::Cylinder;
use crate::space::silhouette_distance::{CylinderTangent, MeasuredLine};

/// Number of parameters of a cylinder.
pub(super) const PARAMETERS: usize = 5;

/// Coordinates `(X - origin) / unit`. The origin is the point of the axis in the middle of the part
/// that the lines see.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    pub(super) origin: Point3<f64>,
    /// The mean distance of the cameras from the axis.
    pub(super) unit: f64,
}

impl Frame {
    pub(super) fn of(cylinder: &Cylinder, lines: &[MeasuredLine]) -> Result<Self, RefineError> {
        let w = cylinder.direction.into_inner();
        let (mut heights, mut unit) = (Vec::with_capacity(lines.len()), 0.0);
        for of_view in lines.chunk_by(|a, b| a.view == b.view) {
            let MeasuredLine { view, centre, .. } = of_view[0];
            let silhouettes = of_view[0].silhouettes(cylinder).ok_or(RefineError::CameraInside { view })?;
            for line in of_view {
                let distance = line.distance_from(cylinder, &silhouettes);
                heights.push(w.dot(&(line.contact(&distance) - cylinder.axis_point)));
            }
            unit += cylinder.vector_to_axis(&centre).norm() * of_view.len() as f64 / lines.len() as f64;
        }
        // The median is used because the ray to a line that is not a silhouette may run along the
        // axis.
        heights.sort_by(f64::total_cmp);
        // The mean of the two middle heights does not depend on the sign of the direction.
        let median = (heights[(heights.len() - 1) / 2] + heights[heights.len() / 2]) / 2.0;
        Ok(Self { origin: cylinder.axis_point + w * median, unit })
    }

    /// The cylinder in the coordinates of the frame; its axis point becomes that nearest to the
    /// origin.
    pub(super) fn local(&self, cylinder: &Cylinder) -> Cylinder {
        let nearest = Point3::from(cylinder.vector_to_axis(&self.origin) / self.unit);
        Cylinder { axis_point: nearest, radius: cylinder.radius / self.unit, ..*cylinder }
    }

    pub(super) fn world(&self, local: &Cylinder) -> Cylinder {
        let point = self.origin + local.axis_point.coords * self.unit;
        Cylinder::new(&point, local.direction, local.radius * self.unit)
    }
}

/// Two unit vectors across a direction, and across each other.
pub(super) fn across(direction: &Unit<Vector3<f64>>) -> [Vector3<f64>; 2] {
    let first = direction.cross(&Vector3::ith(direction.iamin(), 1.0)).normalize();
    [first, direction.cross(&first)]
}

/// Derivatives of a cylinder by the local parameters.
pub(super) fn tangents(cylinder: &Cylinder) -> [CylinderTangent; PARAMETERS] {
    let ([first, second], zero) = (across(&cylinder.direction), Vector3::zeros());
    [(first, zero, 0.0), (second, zero, 0.0), (zero, first, 0.0), (zero, second, 0.0), (zero, zero, 1.0)]
}

/// The cylinder that a step in the local parameters reaches.
pub(super) fn moved(cylinder: &Cylinder, step: &SVector<f64, PARAMETERS>) -> Cylinder {
    let [first, second] = across(&cylinder.direction);
    Cylinder {
        axis_point: cylinder.axis_point + first * step[2] + second * step[3],
        direction: Unit::new_normalize(cylinder.direction.into_inner() + first * step[0] + second * step[1]),
        radius: cylinder.radius + step[4],
    }
}

/// A point in space that is known to lie near the surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct WeightedPoint {
    pub(super) position: Point3<f64>,
    /// The probability that it lies on the surface.
    pub(super) share: f64,
    /// By how much its squared distance from the surface counts, beside the squared distances of
    /// lines: squared unit of these over squared unit of length.
    pub(super) weight: f64,
}

impl WeightedPoint {
    /// The distance from the surface, positive outside, and its derivatives by the local
    /// parameters of a cylinder, which turns about `pivot`, a point of its axis. With the unit
    /// vector `u` away from the axis and the height `h` above the pivot:
    ///
    /// ```text
    ///   d = |X - axis| - r,    (-h f1^T u, -h f2^T u, -f1^T u, -f2^T u, -1)
    /// ```
    ///
    /// `None` on the axis.
    pub(super) fn distance(
        &self,
        cylinder: &Cylinder,
        (pivot, [first, second]): (&Point3<f64>, &[Vector3<f64>; 2]),
    ) -> Option<(f64, SVector<f64, PARAMETERS>)> {
        let to_axis = cylinder.vector_to_axis(&self.position);
        let outwards = -to_axis.try_normalize(0.0)?;
        let height = cylinder.direction.dot(&(self.position - pivot));
        let [first, second] = [first, second].map(|across| -across.dot(&outwards));
        let derivatives = SVector::from([height * first, height * second, first, second, -1.0]);
        Some((to_axis.norm() - cylinder.radius, derivatives))
    }
}

/// The lines and the points of a cylinder.
#[derive(Clone, Copy)]
pub(super) struct Observed<'a> {
    pub(super) lines: &'a [MeasuredLine],
    pub(super) points: &'a [WeightedPoint],
}

impl<'a> Observed<'a> {
    pub(super) fn lines(lines: &'a [MeasuredLine]) -> Self {
        Self { lines, points: &[] }
    }
}

/// The cost of a cylinder. Its axis point is any point of the axis.
pub(super) struct SilhouetteCost {
    pub(super) lines: Vec<MeasuredLine>,
    pub(super) points: Vec<WeightedPoint>,
    /// The loss of the distances of lines.
    pub(super) loss: Loss,
}

impl SilhouetteCost {
    /// The cost of what is observed in the coordinates of a frame.
    pub(super) fn new(Observed { lines, points }: Observed<'_>, frame: &Frame, loss: Loss) -> Self {
        let Frame { origin, unit } = *frame;
        let lines = lines.iter().map(|line| line.in_frame(&origin, unit)).collect();
        let points = points.iter().map(|&WeightedPoint { position, share, weight }| WeightedPoint {
            position: Point3::from((position - origin) / unit),
            share,
            weight: weight * unit * unit,
        });
        Self { lines, points: points.collect(), loss }
    }

    /// Distances of points and their derivatives, with the weights of the points.
    pub(super) fn distances_of_points(
        &self,
        cylinder: &Cylinder,
    ) -> impl Iterator<Item = (f64, f64, SVector<f64, PARAMETERS>)> {
        let pivot = (cylinder.axis_point, across(&cylinder.direction));
        self.points.iter().filter_map(move |point| {
            let (distance, derivatives) = point.distance(cylinder, (&pivot.0, &pivot.1))?;
            Some((point.weight, distance, derivatives))
        })
    }
}

impl LeastSquares<U5> for SilhouetteCost {
    type State = Cylinder;
    type Error = RefineError;

    fn linearise(&self, cylinder: &Cylinder) -> Result<Linearised<U5>, RefineError> {
        if cylinder.radius <= 0.0 {
            return Err(RefineError::NoRadius);
        }
        let tangents = tangents(cylinder);
        let mut sum: Linearised<U5> =
            Linearised { cost: 0.0, gradient: Default::default(), normal_matrix: Default::default() };
        for of_view in self.lines.chunk_by(|a, b| a.view == b.view) {
            let view = of_view[0].view;
            let silhouettes = of_view[0].silhouettes(cylinder).ok_or(RefineError::CameraInside { view })?;
            for line in of_view {
                let distance = line.distance_from(cylinder, &silhouettes);
                let derivatives = line.derivatives(cylinder, &distance, &tangents);
                let (cost, weight) = self.loss.value_and_weight(distance.mean_square());
                sum.cost += cost;
                for (row, derivative) in derivatives.iter().enumerate() {
                    let weighted = derivative * (weight / 2.0);
                    sum.gradient[row] += weighted.dot(&distance.distances);
                    for (column, other) in derivatives.iter().enumerate().take(row + 1) {
                        sum.normal_matrix[(row, column)] += weighted.dot(other);
                    }
                }
            }
        }
        for (weight, distance, derivatives) in self.distances_of_points(cylinder) {
            // A line has two distances, and counts with the mean of their squares.
            let weight = weight / 2.0;
            sum.cost += weight * distance * distance;
            sum.gradient += derivatives * (weight * distance);
            sum.normal_matrix += derivatives * derivatives.transpose() * weight;
        }
        sum.normal_matrix.fill_upper_triangle_with_lower_triangle();
        Ok(sum)
    }

    fn moved(&self, cylinder: &Cylinder, step: &SVector<f64, PARAMETERS>) -> Cylinder {
        moved(cylinder, step)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observations::view::{Calibration, Camera, View};
    use crate::space::silhouette_distance::Metric;
    use nalgebra::{Matrix3, Matrix3x4, Rotation3};

    /// Three views with skew and unequal focal lengths. Each has two lines a little off the
    /// silhouettes.
    fn example() -> (Vec<View>, Cylinder) {
        let direction = Unit::new_normalize(Vector3::new(0.2, 1.0, -0.3));
        let cylinder = Cylinder::new(&Point3::new(0.3, 0.1, -0.2), direction, 0.8);
        let calibration = Calibration::new(&Matrix3::new(900.0, 3.0, 500.0, 0.0, 950.0, 400.0, 0.0, 0.0, 1.0));
        let calibration = calibration.expect("a calibration");
        let view = |angle: f64| {
            let rotation = Rotation3::from_euler_angles(0.1 * angle, angle, 0.2).into_inner();
            let matrix = Matrix3x4::from_columns(&[
                rotation.column(0).into_owned(),
                rotation.column(1).into_owned(),
                rotation.column(2).into_owned(),
                Vector3::new(0.1, -0.2, 6.0),
            ]);
            let camera = Camera::from_normalised(&matrix).expect("a camera").with_calibration(calibration);
            let lines = cylinder.silhouette(&camera).expect("a silhouette");
            View::from_normalised_lines(camera, &lines.map(|line| line + Vector3::new(0.004, -0.01, 0.007)))
        };
        let views = [0.0, 1.1, 2.5].map(view).into_iter().collect::<Result<_, _>>().expect("views");
        (views, cylinder)
    }

    #[test]
    fn the_jacobian_is_the_derivative() {
        let (views, cylinder) = example();
        for unit in [crate::DistanceUnit::Pixels, crate::DistanceUnit::Radians] {
            let metric = Metric { unit, ..Metric::of(&views) };
            let lines = metric.measured_lines(&views).expect("lines");
            let frame = Frame::of(&cylinder, &lines).expect("a frame");
            let points = [Point3::new(0.9, 1.0, 0.5), Point3::new(-0.4, -1.5, -0.6)];
            let points = points.map(|position| WeightedPoint { position, share: 1.0, weight: 2.0 });
            let observed = Observed { lines: &lines, points: &points };
            let (problem, model) = (SilhouetteCost::new(observed, &frame, Loss::Quadratic), frame.local(&cylinder));
            for (index, (_, _, derivatives)) in problem.distances_of_points(&model).enumerate() {
                for (parameter, found) in derivatives.iter().enumerate() {
                    let at = |step: f64| {
                        let mut theta = SVector::zeros();
                        theta[parameter] = step;
                        let of_points: Vec<_> = problem.distances_of_points(&moved(&model, &theta)).collect();
                        of_points[index].1
                    };
                    let expected = (at(1e-5) - at(-1e-5)) / 2e-5;
                    assert!((found - expected).abs() < 1e-8, "{index}, {parameter}: {found} {expected}");
                }
            }
            for line in &problem.lines {
                let distance = line.distance(&model).expect("a camera outside");
                let derivatives = line.derivatives(&model, &distance, &tangents(&model));
                for (index, found) in derivatives.into_iter().enumerate() {
                    let step = 1e-5;
                    let at = |sign: f64| {
                        let mut theta = SVector::zeros();
                        theta[index] = sign * step;
                        line.distance(&moved(&model, &theta)).expect("outside").distances
                    };
                    let expected = (at(1.0) - at(-1.0)) / (2.0 * step);
                    let size = problem.linearise(&model).expect("a cost").normal_matrix.amax().sqrt();
                    assert!((found - expected).norm() < 1e-8 * size, "{unit:?}, {index}: {found} {expected}");
                }
            }
        }
    }
}
