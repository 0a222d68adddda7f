//! `residuals`: residuals and errors of the solvers on noise-free instances. The paper shows the
//! histogram of the decimal logarithm of the largest absolute residual.

use std::f64::consts::TAU;

use nalgebra::Point2;

use super::error::ExperimentError;
use super::instances::instances;
use super::options::Options;
use super::outcome::Outcome;
use super::quantile::Sorted;
use super::section_scene::{least_errors, tangent};
use super::table::Table;
use crate::picture::Histogram;
use crate::random::Random;
use crate::{Circle, ClosedForm, LeastSquares, LinearConic, Minimal, Section, SectionLine, SectionSolver};

const RUNS: usize = 100_000;

/// The logarithm of exact results is drawn as this value, below all others.
const ZERO: f64 = 1e-18;

/// Number of lines for the methods that take any number. The other methods take the first three.
const LINES: usize = 20;

const SETUP: &str = "Noise-free: circle with centre uniform in [0, 10]^2 and radius uniform in [1, 2], 20 tangents \
at uniform angles, the first 3 for methods that take three.\n\
Residual: largest |l^T C* l| over the lines and all exact solutions, with C* of unit Frobenius \
norm and l = (a, b, c) of unit length.\n\
Error: for the solution nearest to the truth, the larger of the distance of the centres and \
the difference of the radii, relative to the radius.";

const METHODS: [(&dyn SectionSolver, usize); 4] =
    [(&Minimal, 3), (&ClosedForm, 3), (&LeastSquares, LINES), (&LinearConic, LINES)];

/// Largest residual and relative error; infinite if the method failed.
#[derive(Clone, Copy)]
struct Accuracy {
    residual: f64,
    error: f64,
}

pub(super) fn run(options: &Options) -> Result<Outcome, ExperimentError> {
    let runs = options.runs_or(RUNS);
    let results = instances(options, runs, |random| {
        let (truth, lines) = instance(random);
        METHODS.map(|(solver, count)| accuracy(solver, &lines[..count], &truth))
    });
    let mut outcome = Outcome::new(SETUP, runs);
    for (title, of) in [("residual", (|one| one.residual) as fn(&Accuracy) -> f64), ("error", |one| one.error)] {
        let columns = ["method", "lines", "50 %", "90 %", "99 %", "99.9 %", "largest", "above 1e-8"];
        let mut table = Table::new(title, &columns);
        for (method, (solver, lines)) in METHODS.into_iter().enumerate() {
            let sample = Sorted::new(results.iter().map(|result| of(&result[method])));
            let quantiles = [0.5, 0.9, 0.99, 0.999, 1.0].map(|part| sample.quantile(part).into());
            let name = [solver.name().into(), lines.into()];
            table.push(name.into_iter().chain(quantiles).chain([sample.count_above(1e-8).into()]));
        }
        outcome.tables.push(table);
        let logarithms = |method: usize| results.iter().map(move |result| of(&result[method]).max(ZERO).log10());
        let samples = |(method, (solver, _)): (usize, (&dyn SectionSolver, _))| {
            (solver.name().to_owned(), logarithms(method).collect())
        };
        let samples: Vec<(String, Vec<f64>)> = METHODS.into_iter().enumerate().map(samples).collect();
        let label = format!(
            "log10 of the {} (0 as 1e-18)",
            if title == "error" { "relative error" } else { "largest absolute residual" }
        );
        let histogram = Histogram { title: format!("noise-free {title}s, {runs} runs"), label, samples, bins: 80 };
        outcome.draw(title, &histogram)?;
        if title == "residual" {
            // The figure of the paper has its two solvers.
            let samples = [0, 2].map(|method| histogram.samples[method].clone()).into();
            outcome.draw("solvers", &Histogram { samples, bins: 40, ..histogram })?;
        }
    }
    Ok(outcome)
}

fn instance(random: &mut Random) -> (Circle, Vec<SectionLine>) {
    let centre = Point2::new(random.uniform(0.0, 10.0), random.uniform(0.0, 10.0));
    let circle = Circle { centre, radius: random.uniform(1.0, 2.0) };
    let lines = (0..LINES).map(|_| tangent(&circle, random.uniform(0.0, TAU), 0)).collect();
    (circle, lines)
}

fn accuracy(solver: &dyn SectionSolver, lines: &[SectionLine], truth: &Circle) -> Accuracy {
    let sections = solver.solve(lines).unwrap_or_default();
    // Least squares also returns stationary points that are not minima. For three lines all are
    // exact.
    let exact = if lines.len() == 3 { &sections[..] } else { &sections[..sections.len().min(1)] };
    let residual = exact.iter().map(|section| residual(section, lines)).fold(0.0, f64::max);
    let [centre, radius] = least_errors(exact.iter().filter_map(Section::circle), truth);
    let residual = if exact.is_empty() { f64::INFINITY } else { residual };
    Accuracy { residual, error: centre.max(radius) / truth.radius }
}

fn residual(section: &Section, lines: &[SectionLine]) -> f64 {
    let dual_conic = section.dual_conic / section.dual_conic.norm();
    let residual = |line: &SectionLine| {
        let line = line.line.normal.push(line.line.offset).normalize();
        line.dot(&(dual_conic * line)).abs()
    };
    lines.iter().map(residual).fold(0.0, f64::max)
}
