//! `real`: the cylinder of a scene file by every method, refined, and compared with the sparse
//! points of the scene, which the fit does not use.

use std::path::{Path, PathBuf};

use nalgebra::{Point3, Unit, Vector3};

use super::error::ExperimentError;
use super::options::Options;
use super::outcome::Outcome;
use super::quantile::Sorted;
use super::table::Table;
use crate::picture::{Histogram, SectionPicture, SilhouettePicture};
use crate::rectify::Rectification;
use crate::{
    Circle, ClosedForm, Cylinder, CylinderLines, LeastSquares, LinearConic, Loss, Metric, Minimal, Navab,
    RefineOptions, Scene, Section, SectionLine, SectionSolver, View, read_scene, refine, triangulate,
};

/// The default scene.
const SCENE: &str = "../shared/data/kungshuset.json";

/// Points further from the surface than this part of the radius belong to other objects.
const NEAR: f64 = 0.25;

const SETUP: &str = "All lines of the scene are taken as silhouettes of one cylinder. Minimal and closed form: of \
the circles of the first three lines, the one of least cost on all lines. Linear: the circle \
nearest to the tangents of its ellipse.\n\
Pixels: root mean square distance of silhouettes and lines. Points: number of scene points \
within a quarter of the radius of the surface; quartiles of their distance to it, positive \
outside, as a part of the radius; number of points within 5 %.";

pub(super) fn run(options: &Options) -> Result<Outcome, ExperimentError> {
    let path = options.scene.clone().unwrap_or(PathBuf::from(SCENE));
    let scene = read_scene(&path)?;
    let views = &scene.views;
    let found = triangulate(views).map_err(|error| unsolved(&path, error.to_string()))?;
    let refine_options = RefineOptions { metric: Metric::of(views), loss: Loss::Quadratic };
    let refinement =
        refine(views, &found.cylinder, &refine_options).map_err(|error| unsolved(&path, error.to_string()))?;

    let mut cylinders = sections(views, &found.direction.direction);
    cylinders.push(("refined".to_owned(), Some(refinement.cylinder)));
    let mut outcome = Outcome::new(SETUP, 1);
    let columns = ["method", "radius", "pixels", "points near", "25 %", "median", "75 %", "points within 5 %"];
    let mut table = Table::new("methods", &columns);
    let mut samples = Vec::new();
    for (name, cylinder) in &cylinders {
        let Some(cylinder) = cylinder else {
            let none = [f64::NAN; 7].map(Into::into);
            table.push([name.as_str().into()].into_iter().chain(none));
            continue;
        };
        let distances = distances(cylinder, &scene.points);
        let sorted = Sorted::new(distances.iter().copied());
        let [low, median, high] = [0.25, 0.5, 0.75].map(|part| sorted.quantile(part).into());
        let within = scene.points.iter().filter(|point| cylinder.is_near(point)).count();
        let fit = [name.as_str().into(), cylinder.radius.into(), pixels(cylinder, views).into()];
        table.push(fit.into_iter().chain([distances.len().into(), low, median, high, within.into()]));
        if ["least-squares", "navab", "refined"].contains(&name.as_str()) {
            samples.push((name.clone(), distances));
        }
    }
    let deviation = refinement.deviation;
    let mut uncertainty = Table::new("refined", &["direction / rad", "axis / radius", "radius / radius", "steps"]);
    let [axis, radius] = [deviation.position, deviation.radius].map(|one| one / refinement.cylinder.radius);
    uncertainty.push([deviation.direction.into(), axis.into(), radius.into(), refinement.iterations.into()]);
    outcome.tables.extend([table, uncertainty]);

    let title = "sparse points near the cylinder".to_owned();
    let label = "signed distance to the surface / radius".to_owned();
    outcome.draw("points", &Histogram { title, label, samples, bins: 50 })?;
    draw(&mut outcome, &scene, &refinement.cylinder)?;
    Ok(outcome)
}

fn unsolved(path: &Path, reason: String) -> ExperimentError {
    ExperimentError::Scene { path: path.to_owned(), reason }
}

/// Cross-section and reprojected silhouettes.
fn draw(outcome: &mut Outcome, scene: &Scene, cylinder: &Cylinder) -> Result<(), ExperimentError> {
    outcome.draw("section", &SectionPicture::new("refined cylinder".to_owned(), cylinder, &scene.views))?;
    // Labels are ignored.
    let lines = CylinderLines { label: None, views: scene.views.clone(), lines: Vec::new() };
    let found = [(lines, *cylinder)];
    for view in 0..scene.views.len() {
        if let Some(picture) = SilhouettePicture::new(scene, &found, view) {
            outcome.draw(&format!("silhouettes_{view}"), &picture)?;
        }
    }
    Ok(())
}

/// The cylinder of each method along a direction; `None` if the method finds none.
fn sections(views: &[View], direction: &Unit<Vector3<f64>>) -> Vec<(String, Option<Cylinder>)> {
    let centres = || views.iter().map(|view| view.camera().centre().coords);
    let middle = Point3::from(centres().sum::<Vector3<f64>>() / centres().count().max(1) as f64);
    let rectification = Rectification::new(direction, middle);
    let line = |(view, content): (usize, &View)| {
        let lines = content.planes().filter_map(|plane| rectification.line(&plane));
        lines.map(|line| SectionLine { line, weight: 1.0, view }).collect::<Vec<_>>()
    };
    let lines: Vec<SectionLine> = views.iter().enumerate().flat_map(line).collect();
    let circle = |solver: &dyn SectionSolver, most: usize| -> Option<Circle> {
        let sections = solver.solve(&lines[..most.min(lines.len())]).ok()?;
        if most == 3 {
            let circles = sections.iter().filter_map(Section::circle);
            let cost = |circle: &Circle| Section::from_circle(*circle, &lines).cost;
            return circles.min_by(|left, right| cost(left).total_cmp(&cost(right)));
        }
        sections.first()?.circle()
    };
    let methods: [(&dyn SectionSolver, usize); 5] = [
        (&Minimal, 3),
        (&ClosedForm, 3),
        (&LinearConic, lines.len()),
        (&Navab, lines.len()),
        (&LeastSquares, lines.len()),
    ];
    let cylinder = |circle: Circle| Cylinder::from_circle(&circle, &rectification, *direction);
    methods.map(|(solver, most)| (solver.name().to_owned(), circle(solver, most).map(cylinder))).into()
}

/// Root mean square distance in pixels; NaN without calibration, or if a camera is inside.
fn pixels(cylinder: &Cylinder, views: &[View]) -> f64 {
    let mut squares = Vec::new();
    for (index, view) in views.iter().enumerate() {
        match cylinder.residuals(index, view) {
            Some(residuals) => {
                squares.extend(residuals.iter().map(|line| line.pixels.map_or(f64::NAN, |one| one * one)))
            }
            None => return f64::NAN,
        }
    }
    (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
}

/// Signed distances of the points near the surface, as parts of the radius.
fn distances(cylinder: &Cylinder, points: &[Point3<f64>]) -> Vec<f64> {
    let distance = |point: &Point3<f64>| cylinder.distance(point) / cylinder.radius;
    points.iter().map(distance).filter(|distance| distance.abs() <= NEAR).collect()
}
