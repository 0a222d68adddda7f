//! `table1`: distance of the methods from the true conic, with few and with many photographs.

use nalgebra::Matrix3;

use super::can::{self, Can, Noise, PHOTOGRAPHS};
use super::error::ExperimentError;
use super::instances::instances;
use super::options::Options;
use super::outcome::Outcome;
use super::proposed::proposed;
use super::quantile::Sorted;
use super::random::some_of;
use super::table::Table;
use super::table1_fixed::{self, IMAGES};
use crate::picture::{Axis, Plot, Series};
use crate::random::Random;
use crate::{LinearConic, Navab, Section, SectionShape, SectionSolver};

const RUNS: usize = 10_000;

/// Standard deviations of the coordinates of an end point, pixels.
const PIXELS: [f64; 3] = [0.5, 2.0, 8.0];

/// The first method is least squares with the choice of the circle in front of the cameras, not the
/// solver alone.
const METHODS: [(&str, Option<&dyn SectionSolver>); 3] =
    [("proposed", None), ("linear", Some(&LinearConic)), ("navab", Some(&Navab))];

const SETUP: &str = "In each run the photographs are drawn at random without repetition. For all methods the \
direction of the axis is estimated from their lines. Both silhouettes of each photograph are \
used. Proposed: as in triangulation, the best minimum of the cost in front of all cameras, or \
the global minimum if there is none.\n\
Distance: Frobenius norm of the difference between estimated and true dual conic, each scaled \
so that its last entry is -1, in the plane across the estimated direction, with the true axis \
in the origin and the true radius as unit; the truth is diag(1, 1, -1). 'unit norm': both \
conics are scaled to norm 1 instead, so that the distance is at most 2.\n\
The linear method needs five lines, hence three photographs. 'no ellipse': part of the runs in \
which its conic is not an ellipse. 'none': part of the runs in which the method failed; they \
are excluded from the means.";

/// The result of one method; `None` if it failed.
type Found = Option<Estimate>;

#[derive(Clone, Copy, Debug)]
struct Estimate {
    distance: f64,
    distance_of_unit: f64,
    real: bool,
}

/// Results by noise, number of photographs and method.
type Estimates = [[[Found; METHODS.len()]; IMAGES.len()]; PIXELS.len()];

pub(super) fn run(options: &Options) -> Result<Outcome, ExperimentError> {
    let runs = options.runs_or(RUNS);
    let can = Can::of_seed(options.seed)?;
    let results: Vec<Estimates> = instances(options, runs, |random| instance(&can, random));
    let mut outcome = Outcome::new(format!("{}\n{SETUP}\n{}", can::SETUP, table1_fixed::SETUP), runs);
    let mut means =
        Table::new("table1", &["pixels", "method", "2 images", "3 images", "5 images", "10 images", "15 images"]);
    let columns = ["pixels", "images", "method", "mean", "median", "90 %", "mean, unit norm", "no ellipse", "none"];
    let mut details = Table::new("details", &columns);
    for (noise, pixels) in PIXELS.into_iter().enumerate() {
        let mut series = Vec::new();
        for (method, (name, _)) in METHODS.into_iter().enumerate() {
            let mut points = Vec::new();
            for (count, images) in IMAGES.into_iter().enumerate() {
                let found: Vec<Estimate> = results.iter().filter_map(|result| result[noise][count][method]).collect();
                let distances = Sorted::new(found.iter().map(|one| one.distance));
                let of_units = Sorted::new(found.iter().map(|one| one.distance_of_unit));
                let unreal = found.iter().filter(|one| !one.real).count() as f64 / found.len() as f64;
                let none = (runs - found.len()) as f64 / runs as f64;
                let numbers =
                    [distances.mean(), distances.median(), distances.quantile(0.9), of_units.mean(), unreal, none];
                let row = [pixels.into(), images.into(), name.into()];
                details.push(row.into_iter().chain(numbers.map(Into::into)));
                points.push([images as f64, distances.mean()]);
            }
            let row = points.iter().map(|&[_, mean]| mean.into());
            means.push([pixels.into(), name.into()].into_iter().chain(row));
            series.push(Series { label: name.to_owned(), points, band: None });
        }
        let plot = Plot {
            title: format!("distance to the true conic, noise of {pixels} pixels, {runs} runs"),
            x: Axis::linear("images"),
            y: Axis::logarithmic("mean Frobenius norm of the difference"),
            series,
        };
        outcome.draw(&format!("noise_{pixels}"), &plot)?;
    }
    outcome.tables.extend([means, details]);
    table1_fixed::add(&mut outcome, options)?;
    Ok(outcome)
}

fn instance(can: &Can, random: &mut Random) -> Estimates {
    let drawn = some_of(PHOTOGRAPHS, PHOTOGRAPHS, random);
    let noise = Noise::new(random);
    PIXELS.map(|pixels| {
        let view = |&photograph: &usize| can.view(photograph, &[0, 1], &noise, pixels);
        let views: Vec<_> = drawn.iter().filter_map(view).collect();
        IMAGES.map(|images| {
            let lines = views.get(..images).and_then(can::cross_section);
            METHODS.map(|(_, solver)| {
                let section = lines.as_ref()?;
                match solver {
                    Some(solver) => solver.solve(&section.lines).ok()?.first().map(estimate),
                    None => proposed(&section.lines, &section.sights).map(|section| estimate(&section)),
                }
            })
        })
    })
}

fn estimate(section: &Section) -> Estimate {
    let truth = can::true_dual_conic();
    let [found_unit, true_unit] = [section.dual_conic, truth].map(|conic: Matrix3<f64>| conic / conic.norm());
    Estimate {
        distance: (section.dual_conic - truth).norm(),
        distance_of_unit: (found_unit - true_unit).norm(),
        real: matches!(section.shape, SectionShape::Circle(_) | SectionShape::Ellipse { .. }),
    }
}
