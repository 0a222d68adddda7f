//! Cylinders from samples of three lines, for RANSAC.
//!
//! ```text
//!   3 lines --> direction, unless known --> 3 tangent lines --> up to 4 circles --> cylinders
//! ```
//!
//! Two planes determine the direction, and the third improves it. Three lines give six numbers for
//! the five parameters of a cylinder, so a sample whose own lines do not agree is rejected before
//! other lines are tested.

use nalgebra::{Unit, Vector3};

use super::refine::{Loss, optimise};
use super::triangulate::fit_cylinder;
use crate::axis::direction::estimate_direction;
use crate::axis::robust_direction::PARALLEL_PAIR;
use crate::cross_section::closed_form::tangent_circles;
use crate::cross_section::rectify::Rectification;
use crate::numerics::ransac::Estimator;
use crate::observations::scene::LineId;
use crate::observations::view::ViewingPlane;
use crate::space::cylinder::Cylinder;
use crate::space::silhouette_distance::MeasuredLine;

/// Steps of Levenberg-Marquardt in a local optimisation.
const LOCAL_STEPS: usize = 5;

/// Independent lines, from which samples are drawn.
pub(crate) struct CylinderEstimator {
    pub(crate) planes: Vec<(LineId, ViewingPlane)>,
    pub(crate) measured: Vec<MeasuredLine>,
    /// Direction of the axis, if it is known.
    pub(crate) direction: Option<Unit<Vector3<f64>>>,
    /// Square of the largest distance between the lines of a sample and its cylinder.
    pub(crate) square_threshold: f64,
}

impl CylinderEstimator {
    /// Some of the lines.
    pub(crate) fn measured(&self, data: &[usize]) -> Vec<MeasuredLine> {
        data.iter().map(|&index| self.measured[index]).collect()
    }

    /// Whether all lines of a sample agree with a cylinder.
    fn agree(&self, cylinder: &Cylinder, sample: &[usize]) -> bool {
        let square = |&datum: &usize| Some(self.measured[datum].square(&self.measured[datum].silhouettes(cylinder)?));
        sample.iter().all(|datum| square(datum).is_some_and(|square| square < self.square_threshold))
    }

    /// The mean square distance of each line.
    pub(crate) fn squares(&self, cylinder: &Cylinder) -> Vec<f64> {
        let mut squares = vec![0.0; self.count()];
        self.write_squares(cylinder, &mut squares, |_| true);
        squares
    }

    /// The lines within a distance.
    pub(crate) fn within(&self, cylinder: &Cylinder, distance: f64) -> Vec<usize> {
        let squares = self.squares(cylinder);
        (0..squares.len()).filter(|&datum| squares[datum] < distance * distance).collect()
    }

    /// The known direction, or the least squares direction of the three planes of the sample. The
    /// latter is one step of inverse iteration from the direction of the two planes that are
    /// furthest from parallel; its error is of the square of the noise. Up to scale, the inverse of
    /// `N^T N` is the sum of `c c^T` over the cross products `c` of its rows (Cauchy-Binet).
    fn direction(&self, sample: &[usize]) -> Option<Unit<Vector3<f64>>> {
        if self.direction.is_some() {
            return self.direction;
        }
        let normal = |index: usize| &self.planes[sample[index]].1.normal;
        let crosses = [[0, 1], [0, 2], [1, 2]].map(|[first, second]| normal(first).cross(normal(second)));
        let mut widest = crosses[0];
        for cross in &crosses[1..] {
            if cross.norm_squared() > widest.norm_squared() {
                widest = *cross;
            }
        }
        let widest = Unit::try_new(widest, PARALLEL_PAIR)?;
        Unit::try_new(crosses.iter().map(|cross| cross * cross.dot(&widest)).sum(), 0.0)
    }
}

impl Estimator for CylinderEstimator {
    type Model = Cylinder;
    const SAMPLE: usize = 3;

    fn count(&self) -> usize {
        self.planes.len()
    }

    fn add_models(&self, sample: &[usize], models: &mut Vec<Cylinder>) {
        let Some(direction) = self.direction(sample) else { return };
        let rectification = Rectification::new(&direction, self.planes[sample[0]].1.centre);
        let line = |index: usize| rectification.line(&self.planes[sample[index]].1);
        let [Some(first), Some(second), Some(third)] = [line(0), line(1), line(2)] else { return };
        let Ok(circles) = tangent_circles(&[first, second, third]) else { return };
        let cylinder = |circle| Cylinder::from_circle(&circle, &rectification, direction);
        models.extend(circles.into_iter().map(cylinder).filter(|cylinder| self.agree(cylinder, sample)));
    }

    /// The silhouettes of a view are computed once for all its lines, which are a part.
    fn write_squares(&self, cylinder: &Cylinder, squares: &mut [f64], mut go_on: impl FnMut(&[f64]) -> bool) {
        let mut rest = squares;
        for of_view in self.measured.chunk_by(|a, b| a.view == b.view) {
            let silhouettes = of_view[0].silhouettes(cylinder);
            let (part, others) = rest.split_at_mut(of_view.len());
            for (line, square) in of_view.iter().zip(&mut *part) {
                *square = silhouettes.as_ref().map_or(f64::INFINITY, |silhouettes| line.square(silhouettes));
            }
            if !go_on(part) {
                return;
            }
            rest = others;
        }
    }

    /// Constrained least squares, followed by a few steps on the silhouette distance.
    fn fitted(&self, model: &Cylinder, data: &[usize]) -> Option<Cylinder> {
        let identified: Vec<_> = data.iter().map(|&index| self.planes[index]).collect();
        if let Some(direction) = self.direction {
            return fit_cylinder(&identified, &direction).ok().map(|(cylinder, _)| cylinder);
        }
        let planes: Vec<_> = identified.iter().map(|&(_, plane)| plane).collect();
        let direct =
            estimate_direction(&planes).ok().and_then(|direction| fit_cylinder(&identified, &direction.direction).ok());
        let start = direct.map_or(*model, |(cylinder, _)| cylinder);
        optimise(&self.measured(data), &start, Loss::Quadratic, LOCAL_STEPS).ok().map(|optimised| optimised.cylinder)
    }
}
