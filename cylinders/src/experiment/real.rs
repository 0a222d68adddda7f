//! `real`: the cylinder of a scene file by every method, refined, and compared with the sparse
//! points of the scene, which the fit does not use.

use std::path::{Path, PathBuf};

use nalgebra::{Point2, Point3, Unit, Vector3};

use super::error::ExperimentError;
use super::options::Options;
use super::outcome::Outcome;
use super::quantile::Sorted;
use super::table::Table;
use crate::cross_section::sight::Sight;
use crate::page::photograph_overlay;
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

const SETUP: &str = "All lines of a label, or of the scene if it has no labels, are taken as silhouettes of one \
cylinder. Minimal and closed form: of the circles of the first three lines, the one of least cost \
on all lines. Linear: the circle nearest to the tangents of its ellipse. Least squares: the best \
minimum in front of all cameras, as in triangulation. Least cost: the global minimum. In front: \
whether the cylinder is in front of all its cameras.\n\
Pixels: root mean square distance of silhouettes and lines. Points: number of scene points \
within a quarter of the radius of the surface; quartiles of their distance to it, positive \
outside, as a part of the radius; number of points within 5 %.\n\
Files overlay_N.svg: the photograph of view N, if it is there, with the given lines and the \
silhouettes of the refined cylinders.";

pub(super) fn run(options: &Options) -> Result<Outcome, ExperimentError> {
    let path = options.scene.clone().unwrap_or(PathBuf::from(SCENE));
    let scene = read_scene(&path)?;
    let mut outcome = Outcome::new(SETUP, 1);
    let columns = [
        "cylinder",
        "method",
        "in front",
        "radius",
        "pixels",
        "points near",
        "25 %",
        "median",
        "75 %",
        "points within 5 %",
    ];
    let mut table = Table::new("methods", &columns);
    let columns = ["cylinder", "direction / rad", "axis / radius", "radius / radius", "steps"];
    let mut uncertainty = Table::new("refined", &columns);
    let mut samples = Vec::new();
    let mut refined = Vec::new();
    for lines in scene.cylinders() {
        let label = lines.label.clone().unwrap_or("-".to_owned());
        let reason = |error: &dyn std::fmt::Display| match &lines.label {
            Some(label) => unsolved(&path, format!("cylinder {label}: {error}")),
            None => unsolved(&path, error.to_string()),
        };
        let views = &lines.views;
        let found = triangulate(views).map_err(|error| reason(&error))?;
        let refine_options = RefineOptions { metric: Metric::of(views), loss: Loss::Quadratic };
        let refinement = refine(views, &found.cylinder, &refine_options).map_err(|error| reason(&error))?;
        let mut cylinders = sections(views, &found.direction.direction);
        cylinders.push(("least-squares", Some(found.cylinder)));
        cylinders.push(("refined", Some(refinement.cylinder)));
        for (name, cylinder) in cylinders {
            let names = [label.as_str().into(), name.into()];
            let Some(cylinder) = cylinder else {
                let none = [f64::NAN; 7].map(Into::into);
                table.push(names.into_iter().chain(["-".into()]).chain(none));
                continue;
            };
            let distances = distances(&cylinder, &scene.points);
            let sorted = Sorted::new(distances.iter().copied());
            let [low, median, high] = [0.25, 0.5, 0.75].map(|part| sorted.quantile(part).into());
            let within = scene.points.iter().filter(|point| cylinder.is_near(point)).count();
            let in_front = if is_in_front(&cylinder, views) { "yes" } else { "no" };
            let fit = [in_front.into(), cylinder.radius.into(), pixels(&cylinder, views).into()];
            let near = [distances.len().into(), low, median, high, within.into()];
            table.push(names.into_iter().chain(fit).chain(near));
            if !scene.points.is_empty() && ["least-squares", "navab", "refined"].contains(&name) {
                let name = lines.label.as_ref().map_or(name.to_owned(), |label| format!("{label}: {name}"));
                samples.push((name, distances));
            }
        }
        let deviation = refinement.deviation;
        let [axis, radius] = [deviation.position, deviation.radius].map(|one| one / refinement.cylinder.radius);
        let row = [deviation.direction.into(), axis.into(), radius.into(), refinement.iterations.into()];
        uncertainty.push([label.as_str().into()].into_iter().chain(row));
        refined.push((lines, refinement.cylinder));
    }
    outcome.tables.extend([table, uncertainty]);

    if !samples.is_empty() {
        let title = "sparse points near the cylinder".to_owned();
        let label = "signed distance to the surface / radius".to_owned();
        outcome.draw("points", &Histogram { title, label, samples, bins: 50 })?;
    }
    draw(&mut outcome, &path, &scene, &refined)?;
    Ok(outcome)
}

fn unsolved(path: &Path, reason: String) -> ExperimentError {
    ExperimentError::Scene { path: path.to_owned(), reason }
}

/// Cross-sections, reprojected silhouettes, and silhouettes over the photographs that lie beside
/// the scene file.
fn draw(
    outcome: &mut Outcome,
    path: &Path,
    scene: &Scene,
    refined: &[(CylinderLines, Cylinder)],
) -> Result<(), ExperimentError> {
    for (index, (lines, cylinder)) in refined.iter().enumerate() {
        let (name, title) = match &lines.label {
            Some(label) => (format!("section_{index}"), format!("refined cylinder {label}")),
            None => ("section".to_owned(), "refined cylinder".to_owned()),
        };
        outcome.draw(&name, &SectionPicture::new(title, cylinder, &lines.views))?;
    }
    let folders: Vec<_> = path.parent().map(Path::to_owned).into_iter().collect();
    for index in 0..scene.views.len() {
        if let Some(picture) = SilhouettePicture::new(scene, refined, index) {
            outcome.draw(&format!("silhouettes_{index}"), &picture)?;
        }
        // The photograph is optional: most scenes have none.
        if let Some(overlay) = photograph_overlay(scene, refined, index, &folders) {
            outcome.pictures.push((format!("overlay_{index}.svg"), overlay.into_bytes()));
        }
    }
    Ok(())
}

/// Whether the cylinder is in front of all cameras with lines of it.
fn is_in_front(cylinder: &Cylinder, views: &[View]) -> bool {
    let rectification = Rectification::new(&cylinder.direction, cylinder.axis_point);
    let circle = Circle { centre: Point2::origin(), radius: cylinder.radius };
    let mut planes = views.iter().flat_map(View::planes);
    planes.all(|plane| Sight::of(&plane, &cylinder.direction, &rectification).has_in_front(&circle))
}

/// The cylinder of each method along a direction; `None` if the method finds none.
fn sections(views: &[View], direction: &Unit<Vector3<f64>>) -> Vec<(&'static str, Option<Cylinder>)> {
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
    let methods: [(&str, &dyn SectionSolver, usize); 5] = [
        (Minimal.name(), &Minimal, 3),
        (ClosedForm.name(), &ClosedForm, 3),
        (LinearConic.name(), &LinearConic, lines.len()),
        (Navab.name(), &Navab, lines.len()),
        ("least cost", &LeastSquares, lines.len()),
    ];
    let cylinder = |circle: Circle| Cylinder::from_circle(&circle, &rectification, *direction);
    methods.map(|(name, solver, most)| (name, circle(solver, most).map(cylinder))).into()
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
