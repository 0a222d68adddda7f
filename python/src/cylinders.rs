//! Cylinder triangulation: a scene as JSON to a report as JSON.

use eliminant_cylinders::direction::estimate_direction;
use eliminant_cylinders::matching_report::MatchingReport;
use eliminant_cylinders::report::Report;
use eliminant_cylinders::{
    CylinderLines, Estimate, MatchError, MatchOptions, Matching, Method, ParallelError, RansacOptions, References,
    RobustOptions, Scene, View, default_direction_options, estimate, estimate_direction_robustly, estimate_from,
    match_cylinders, parallel_estimates, parse_scene, triangulate_parallel,
};
use nalgebra::{Unit, Vector3};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use serde::Serialize;

use crate::errors::CylinderError;
use crate::threads::on_all_cores;

/// What messages about a scene begin with.
const SCENE: &str = "scene";

/// How cylinders are estimated.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Estimator {
    method: String,
    is_parallel: bool,
    threshold: Option<f64>,
    seed: u64,
    confidence: f64,
}

/// The cylinders of a scene, one for each label: a JSON list of reports.
#[pyfunction]
pub(crate) fn triangulate_cylinders(py: Python<'_>, scene: &str, estimator: Estimator) -> PyResult<String> {
    estimator.check()?;
    let reports = on_all_cores(py, || -> Result<Vec<Report>, String> {
        let scene = parse_scene(scene, SCENE).map_err(|error| error.to_string())?;
        let cylinders = scene.cylinders();
        let estimates = estimator.estimates(&cylinders)?;
        Ok(cylinders.iter().zip(&estimates).map(|(lines, of)| Report::new(lines, of, &scene.points)).collect())
    });
    json(&reports.map_err(CylinderError::new_err)?)
}

fn json(value: &impl Serialize) -> PyResult<String> {
    serde_json::to_string(value).map_err(|error| CylinderError::new_err(error.to_string()))
}

impl Estimator {
    fn check(&self) -> PyResult<()> {
        let wrong = |text: &str| Err(PyValueError::new_err(text.to_owned()));
        if !["least_squares", "refined", "robust"].contains(&self.method.as_str()) {
            return wrong("expected the method least_squares, refined or robust");
        }
        if self.is_parallel && self.method != "least_squares" {
            return wrong("parallel cylinders are estimated by least_squares");
        }
        if !(self.confidence > 0.0 && self.confidence < 1.0) {
            return wrong("expected a confidence between 0 and 1");
        }
        check_threshold(self.threshold)
    }

    fn estimates(&self, cylinders: &[CylinderLines]) -> Result<Vec<Estimate>, String> {
        if self.is_parallel {
            let views: Vec<Vec<View>> = cylinders.iter().map(|lines| lines.views.clone()).collect();
            let result = triangulate_parallel(&views).map_err(|error| match error {
                ParallelError::Cylinder { cylinder, error } => of_label(cylinders.get(cylinder), &error),
                ParallelError::Direction(_) => of_label(None, &error),
            })?;
            return Ok(parallel_estimates(result, &views));
        }
        let of_lines = |lines: &CylinderLines| {
            estimate(&lines.views, &self.method(&lines.views)).map_err(|error| of_label(Some(lines), &error))
        };
        cylinders.iter().map(of_lines).collect()
    }

    fn method(&self, views: &[View]) -> Method {
        match self.method.as_str() {
            "robust" => {
                let default = RobustOptions::of(views);
                let threshold = self.threshold.unwrap_or(default.ransac.threshold);
                let Self { seed, confidence, .. } = *self;
                let ransac = RansacOptions { threshold, seed, confidence, ..default.ransac };
                Method::Robust(RobustOptions { ransac, ..default })
            }
            "refined" => Method::Refined,
            _ => Method::LeastSquares,
        }
    }
}

/// An error with the label of the cylinder that it is about.
fn of_label(lines: Option<&CylinderLines>, error: &dyn std::fmt::Display) -> String {
    match lines.and_then(|lines| lines.label.as_ref()) {
        Some(label) => format!("{SCENE}: cylinder `{label}`: {error}"),
        None => format!("{SCENE}: {error}"),
    }
}

fn check_threshold(threshold: Option<f64>) -> PyResult<()> {
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
    direction: Option<[f64; 3]>,
}

/// What a search found: direction, threshold, cylinders.
type Found = (Unit<Vector3<f64>>, f64, Matching);

/// The parallel cylinders of a scene without labels: a JSON report.
#[pyfunction]
pub(crate) fn match_cylinder_lines(py: Python<'_>, scene: &str, matcher: Matcher) -> PyResult<String> {
    check_threshold(matcher.threshold)?;
    if matcher.count == Some(0) || matcher.least_support.is_some_and(|least| least < 4) {
        return Err(PyValueError::new_err("expected a count of 1 or more, and a least support of 4 or more"));
    }
    let report = on_all_cores(py, || -> Result<MatchingReport, String> {
        let scene = parse_scene(scene, SCENE).map_err(|error| error.to_string())?;
        let found = matcher.find(&scene.views)?;
        Ok(refined(&scene, &found))
    });
    json(&report.map_err(CylinderError::new_err)?)
}

/// The report of what was found, with each cylinder refined on its matches.
fn refined(scene: &Scene, (direction, threshold, matching): &Found) -> MatchingReport {
    let views = &scene.views;
    let reports = matching.cylinders.iter().enumerate().map(|(at, found)| {
        let lines = found.lines(views, &(at + 1).to_string());
        estimate_from(&lines.views, &found.cylinder).map(|estimate| Report::new(&lines, &estimate, &scene.points))
    });
    MatchingReport::new(views, (direction, *threshold), matching).with_refined(reports.collect())
}

impl Matcher {
    /// The cylinders along the first direction that has some. Without a threshold the default is
    /// doubled once, because lines drawn by hand may need more.
    fn find(&self, views: &[View]) -> Result<Found, String> {
        let defaults = MatchOptions::of(views);
        let factors: &[f64] = if self.threshold.is_some() { &[1.0] } else { &[1.0, 2.0] };
        let directions = self.directions(views)?;
        let mut last = MatchError::NoPair;
        for factor in factors {
            let options = MatchOptions {
                threshold: factor * self.threshold.unwrap_or(defaults.threshold),
                references: if self.is_first_image { References::First } else { References::Every },
                count: self.count,
                least_support: self.least_support,
                ..defaults
            };
            for direction in &directions {
                match match_cylinders(views, direction, &options) {
                    Ok(matching) => return Ok((*direction, options.threshold, matching)),
                    Err(error @ MatchError::NoCylinder { .. }) => last = error,
                    Err(error) => return Err(of_label(None, &error)),
                }
            }
        }
        Err(of_label(None, &last))
    }

    /// The given direction; otherwise that on which most lines agree, and that of all lines.
    fn directions(&self, views: &[View]) -> Result<Vec<Unit<Vector3<f64>>>, String> {
        if let Some(direction) = self.direction {
            let vector = Vector3::from(direction);
            let scaled = vector / vector.amax();
            let wrong = || "expected a direction of three finite numbers, not all 0".to_owned();
            return Unit::try_new(scaled, 0.5).map(|direction| vec![direction]).ok_or_else(wrong);
        }
        let planes: Vec<_> = views.iter().flat_map(View::planes).collect();
        let found = estimate_direction_robustly(&planes, &default_direction_options());
        let found = found.map_err(|error| of_label(None, &error))?;
        let of_all = estimate_direction(&planes).ok().map(|direction| direction.direction);
        Ok([found.direction.direction].into_iter().chain(of_all).collect())
    }
}
