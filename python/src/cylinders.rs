//! Cylinder triangulation: a scene as JSON to a report as JSON.

use eliminant_cylinders::matching::{RefinedMatch, refined_matches};
use eliminant_cylinders::matching_report::MatchingReport;
use eliminant_cylinders::report::Report;
use eliminant_cylinders::{
    CylinderLines, Estimate, Interrupt, Interrupted, JointError, JointEstimate, JointMethod, Loss, MatchOptions,
    Matching, Method, Radii, RansacOptions, References, RobustOptions, Scene, Side, View, estimate, estimate_on_side,
    estimate_together, match_candidate_with, match_cylinders, match_directions_with, match_with_wider_bound,
    parse_scene, with_points,
};
use nalgebra::{Point3, Unit, Vector3};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use serde::Serialize;

use crate::errors::CylinderError;
use crate::threads::interruptible;

/// What messages about a scene begin with.
pub(crate) const SCENE: &str = "scene";

/// How cylinders are estimated.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Estimator {
    method: String,
    is_parallel: bool,
    is_radius_shared: bool,
    radius: Option<f64>,
    side: Option<String>,
    has_points: bool,
    threshold: Option<f64>,
    seed: u64,
    confidence: f64,
}

/// The cylinders of a scene, one for each label: a JSON list of reports.
#[pyfunction]
pub(crate) fn triangulate_cylinders(py: Python<'_>, scene: &str, estimator: Estimator) -> PyResult<String> {
    estimator.check()?;
    let reports = until_interrupted(py, |interrupt| -> Result<Vec<Report>, String> {
        let scene = parse_scene(scene, SCENE).map_err(|error| error.to_string())?;
        let cylinders = scene.cylinders();
        let estimates = estimator.estimates(&cylinders, interrupt)?;
        let estimates = match estimator.has_points {
            true => {
                let method = estimator.joint_method(interrupt);
                on_points(estimates, &cylinders, evidence(&scene, true)?, &method)?
            }
            false => estimates,
        };
        Ok(cylinders.iter().zip(&estimates).map(|(lines, of)| Report::new(lines, of, &scene.points)).collect())
    });
    json(&reports?.map_err(CylinderError::new_err)?)
}

/// Does work that a signal ends, such as Ctrl-C.
pub(crate) fn until_interrupted<T: Send>(py: Python<'_>, work: impl FnOnce(Interrupt<'_>) -> T + Send) -> PyResult<T> {
    interruptible(py, |is_over| work(Interrupt::by(is_over)), |_| Ok(()))
}

pub(crate) fn json(value: &impl Serialize) -> PyResult<String> {
    serde_json::to_string(value).map_err(|error| CylinderError::new_err(error.to_string()))
}

impl Estimator {
    fn check(&self) -> PyResult<()> {
        let wrong = |text: &str| Err(PyValueError::new_err(text.to_owned()));
        if !["least_squares", "refined", "robust"].contains(&self.method.as_str()) {
            return wrong("expected the method least_squares, refined or robust");
        }
        let is_joint = self.is_parallel || self.radii() != Radii::Own;
        if is_joint && self.method == "robust" {
            return wrong("cylinders that share a direction or a radius are estimated by least_squares or refined");
        }
        match self.radius {
            Some(_) if self.is_radius_shared => return wrong("expected either a shared radius or a known one"),
            Some(radius) if !(radius > 0.0 && radius.is_finite()) => return wrong("expected a radius above 0"),
            _ => {}
        }
        match self.side.as_deref() {
            None => {}
            Some("left" | "right") if !is_joint && self.method != "robust" => {}
            Some("left" | "right") => return wrong("a side is for single cylinders by least_squares or refined"),
            Some(_) => return wrong("expected the side left or right"),
        }
        if !(self.confidence > 0.0 && self.confidence < 1.0) {
            return wrong("expected a confidence between 0 and 1");
        }
        check_threshold(self.threshold)
    }

    fn radii(&self) -> Radii {
        match self.radius {
            Some(radius) => Radii::Known(radius),
            None if self.is_radius_shared => Radii::Shared,
            None => Radii::Own,
        }
    }

    fn estimates(&self, cylinders: &[CylinderLines], interrupt: Interrupt<'_>) -> Result<Vec<Estimate>, String> {
        if self.is_parallel || self.radii() != Radii::Own {
            return self.together(cylinders, interrupt);
        }
        let of_lines = |lines: &CylinderLines| {
            interrupt.check().map_err(of_interruption)?;
            let views = &lines.views;
            let estimate = match self.side.as_deref() {
                Some("left") => estimate_on_side(views, Side::Left),
                Some(_) => estimate_on_side(views, Side::Right),
                None => estimate(views, &self.method(views, interrupt)),
            };
            estimate.map_err(|error| of_label(Some(lines), &error))
        };
        cylinders.iter().map(of_lines).collect()
    }

    /// What cylinders share.
    fn joint_method<'a>(&self, interrupt: Interrupt<'a>) -> JointMethod<'a> {
        let radii = self.radii();
        let refines = self.method == "refined" || radii != Radii::Own;
        JointMethod { parallel: self.is_parallel, refinement: refines.then_some((radii, Loss::Quadratic)), interrupt }
    }

    /// Cylinders that share a direction or a radius.
    fn together(&self, cylinders: &[CylinderLines], interrupt: Interrupt<'_>) -> Result<Vec<Estimate>, String> {
        let views: Vec<Vec<View>> = cylinders.iter().map(|lines| lines.views.clone()).collect();
        let joint = estimate_together(&views, &self.joint_method(interrupt));
        Ok(joint.map_err(|error| of_joint(cylinders, error))?.cylinders)
    }

    fn method<'a>(&self, views: &[View], interrupt: Interrupt<'a>) -> Method<'a> {
        match self.method.as_str() {
            "robust" => {
                let default = RobustOptions::of(views);
                let threshold = self.threshold.unwrap_or(default.ransac.threshold);
                let Self { seed, confidence, .. } = *self;
                let ransac = RansacOptions { threshold, seed, confidence, interrupt, ..default.ransac };
                Method::Robust(RobustOptions { ransac, ..default })
            }
            "refined" => Method::Refined,
            _ => Method::LeastSquares,
        }
    }
}

/// The estimates on these points, too.
fn on_points(
    estimates: Vec<Estimate>,
    cylinders: &[CylinderLines],
    points: &[Point3<f64>],
    method: &JointMethod<'_>,
) -> Result<Vec<Estimate>, String> {
    let views: Vec<_> = cylinders.iter().map(|lines| lines.views.clone()).collect();
    let estimates = JointEstimate { cylinders: estimates, radius: None };
    let joint = with_points(estimates, &views, points, method);
    Ok(joint.map_err(|error| of_joint(cylinders, error))?.cylinders)
}

/// Nobody reads it: the error of the signal takes its place.
pub(crate) fn of_interruption(error: Interrupted) -> String {
    error.to_string()
}

/// An error of one cylinder, or of all together, which has no label.
fn of_joint(cylinders: &[CylinderLines], error: JointError) -> String {
    match error {
        JointError::Cylinder { cylinder, error } => of_label(cylinders.get(cylinder), &error),
        error => of_label(None, &error),
    }
}

/// An error with the label of the cylinder that it is about.
pub(crate) fn of_label(lines: Option<&CylinderLines>, error: &dyn std::fmt::Display) -> String {
    match lines.and_then(|lines| lines.label.as_ref()) {
        Some(label) => format!("{SCENE}: cylinder `{label}`: {error}"),
        None => format!("{SCENE}: {error}"),
    }
}

pub(crate) fn check_directions(directions: Option<usize>) -> PyResult<()> {
    match directions {
        Some(0) => Err(PyValueError::new_err("expected 1 direction or more")),
        _ => Ok(()),
    }
}

pub(crate) fn check_threshold(threshold: Option<f64>) -> PyResult<()> {
    match threshold {
        Some(threshold) if !(threshold > 0.0 && threshold.is_finite()) => {
            Err(PyValueError::new_err("expected a threshold above 0"))
        }
        _ => Ok(()),
    }
}

/// How cylinders are found among lines without labels.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Matcher {
    threshold: Option<f64>,
    count: Option<usize>,
    least_support: Option<usize>,
    is_first_image: bool,
    directions: Option<usize>,
    direction: Option<[f64; 3]>,
    has_points: bool,
}

/// The cylinders of a scene without labels: a JSON report.
#[pyfunction]
pub(crate) fn match_cylinder_lines(py: Python<'_>, scene: &str, matcher: Matcher) -> PyResult<String> {
    check_threshold(matcher.threshold)?;
    if matcher.count == Some(0) || matcher.least_support.is_some_and(|least| least < 4) {
        return Err(PyValueError::new_err("expected a count of 1 or more, and a least support of 4 or more"));
    }
    check_directions(matcher.directions)?;
    let report = until_interrupted(py, |interrupt| -> Result<MatchingReport, String> {
        let scene = parse_scene(scene, SCENE).map_err(|error| error.to_string())?;
        let points = evidence(&scene, matcher.has_points)?;
        let (threshold, matching) = matcher.find(&scene.views, interrupt)?;
        refined(&scene, (threshold, &matching), points, interrupt)
    });
    json(&report?.map_err(CylinderError::new_err)?)
}

/// The points that are evidence: those of the scene, if they are asked.
pub(crate) fn evidence(scene: &Scene, is_asked: bool) -> Result<&[Point3<f64>], String> {
    match &scene.points[..] {
        [] if is_asked => Err(format!("{SCENE}: there are no points, which would be evidence")),
        points => Ok(if is_asked { points } else { &[] }),
    }
}

/// The report of what was found within a threshold, with the cylinders refined on their matches and
/// these points.
pub(crate) fn refined(
    scene: &Scene,
    (threshold, matching): (f64, &Matching),
    points: &[Point3<f64>],
    interrupt: Interrupt<'_>,
) -> Result<MatchingReport, String> {
    let views = &scene.views;
    let of_match = |RefinedMatch { lines, estimate, is_parallel }: RefinedMatch| {
        estimate.map(|estimate| (Report::new(&lines, &estimate, &scene.points), is_parallel))
    };
    let refined = refined_matches(views, matching, points, interrupt).map_err(of_interruption)?;
    let reports = refined.into_iter().map(of_match).collect();
    Ok(MatchingReport::new(views, threshold, matching).with_refined(reports))
}

impl Matcher {
    /// The threshold and the cylinders. Without a threshold the default may be doubled.
    fn find(&self, views: &[View], interrupt: Interrupt<'_>) -> Result<(f64, Matching), String> {
        let defaults = MatchOptions::of(views);
        let direction = self.direction.map(unit).transpose()?;
        let options = MatchOptions {
            threshold: self.threshold.unwrap_or(defaults.threshold),
            references: if self.is_first_image { References::First } else { References::Every },
            count: self.count,
            least_support: self.least_support,
            interrupt,
            ..defaults
        };
        // A number of cylinders would be found in any direction.
        let most = if self.count.is_some() { 1 } else { self.directions.unwrap_or(usize::MAX) };
        let search = |options: &MatchOptions| match &direction {
            Some(direction) => match_cylinders(views, direction, options),
            None => match_directions_with(views, most, options, |views, direction| {
                match_candidate_with(views, direction, options, &|_| {})
            }),
        };
        let found = match self.threshold {
            Some(threshold) => search(&options).map(|matching| (threshold, matching)),
            None => match_with_wider_bound(views, &options, search),
        };
        found.map_err(|error| of_label(None, &error))
    }
}

type Direction = Unit<Vector3<f64>>;

/// A direction from three numbers.
pub(crate) fn unit(numbers: [f64; 3]) -> Result<Direction, String> {
    let vector = Vector3::from(numbers);
    let wrong = || "expected a direction of three finite numbers, not all 0".to_owned();
    Unit::try_new(vector / vector.amax(), 0.5).ok_or_else(wrong)
}
