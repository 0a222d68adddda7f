//! What single precision would cost: coefficients are rounded to `f32`, the template is eliminated
//! in it, and the rest of a solve is as it is.
//!
//! `cargo bench -p eliminant-tests --bench single -- [PROBLEM...]`. One attempt is made in each
//! precision, on scenes. Coefficients and eigenvalues that are computed in `f32` would lose more.

use clap::Parser;
use comfy_table::{CellAlignment, Table, presets};
use eliminant::emitted::{self, Dynamic, SizesOf, SolverInstance};
use eliminant::{Complex, Scalar, SolveError};
use eliminant_generator::expression::arithmetic::Arithmetic;
use eliminant_generator::expression::rational::Rational;
use eliminant_generator::plan::Plan;
use eliminant_generator::plan::interpret::eliminate;
use eliminant_generator::plan::value_layout::ValueLayout;
use eliminant_generator::search::measuring::interpreted::{InterpretedInstance, InterpretedSolver};
use eliminant_tests::families::{DataSource, Family};
use eliminant_tests::statistics::quantile;
use eliminant_tests::{Case, cases};

/// Compares the precisions.
#[derive(Parser)]
struct Arguments {
    /// Only these problems.
    problems: Vec<String>,
    /// Scenes of each problem.
    #[arg(long, default_value_t = 200)]
    instances: u64,
    /// Seed of the first instance.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Set by `cargo bench`.
    #[arg(long, hide = true)]
    bench: bool,
}

/// A solution counts as found within this distance, relative to its largest unknown.
const FOUND: f64 = 1e-6;

/// IEEE single precision.
#[derive(Clone, Copy)]
struct Float32;

impl Arithmetic for Float32 {
    type Value = f32;

    fn constant(self, value: Rational) -> Option<f32> {
        Some(value.numerator() as f32 / value.denominator() as f32)
    }
    fn add(self, a: f32, b: f32) -> f32 {
        a + b
    }
    fn sub(self, a: f32, b: f32) -> f32 {
        a - b
    }
    fn mul(self, a: f32, b: f32) -> f32 {
        a * b
    }
    fn div(self, a: f32, b: f32) -> Option<f32> {
        Some(a / b)
    }
    fn pivot_size(self, a: f32) -> f64 {
        f64::from(a.abs())
    }
    fn rounding(self) -> f64 {
        f64::from(f32::EPSILON)
    }
    fn zero(self) -> f32 {
        0.0
    }
    fn one(self) -> f32 {
        1.0
    }
}

/// One attempt on an instance.
struct Once<'a> {
    instance: InterpretedInstance<'a>,
    /// The plan and its layout, if the template is eliminated in `f32`.
    single: Option<(&'a Plan, ValueLayout)>,
    read: Vec<Vec<f64>>,
}

impl SolverInstance for Once<'_> {
    type Basis = Dynamic;
    type Unknowns = Dynamic;
    type Values = Dynamic;
    type Solutions = Dynamic;

    fn sizes(&self) -> SizesOf<Self> {
        self.instance.sizes()
    }
    fn ratios(&self, unknown: usize) -> &[(u16, u16)] {
        self.instance.ratios(unknown)
    }
    fn has_origin(&self) -> bool {
        self.instance.has_origin()
    }
    fn symmetries(&self) -> Option<emitted::Symmetries<'_>> {
        self.instance.symmetries()
    }
    fn allows_second_attempt(&self) -> bool {
        false
    }
    fn action_matrix<R: emitted::Real>(&mut self) -> Result<Vec<Vec<R>>, SolveError> {
        let Some((plan, _)) = &self.single else { return self.instance.action_matrix() };
        let coefficients: Vec<f32> = self.instance.coefficients().iter().map(|&c| c as f32).collect();
        let eliminated = eliminate(plan, Float32, &coefficients).ok_or(SolveError::Overflow)?;
        self.read = wide(eliminated.read, |x| x);
        Ok(wide(eliminated.action, R::from_f64))
    }
    fn monomial_values<S: Scalar>(&self, value: S, vector: &Vec<S>) -> Vec<S> {
        match &self.single {
            None => self.instance.monomial_values(value, vector),
            Some((_, layout)) => {
                emitted::monomial_values(Dynamic(layout.len()), (value, vector), layout.has_image, &self.read)
            }
        }
    }
    fn recover<S: Scalar>(&self, unknowns: &mut Vec<S>) {
        self.instance.recover(unknowns);
    }
    fn polish<S: Scalar>(&self, unknowns: &mut Vec<S>, steps: usize) -> f64 {
        self.instance.polish(unknowns, steps)
    }
    fn is_admissible<S: Scalar>(&self, unknowns: &Vec<S>) -> bool {
        self.instance.is_admissible(unknowns)
    }
}

/// The same rows with other numbers.
fn wide<R>(rows: Vec<Vec<f32>>, number: impl Fn(f64) -> R + Copy) -> Vec<Vec<R>> {
    rows.into_iter().map(|row| row.into_iter().map(|x| number(x.into())).collect()).collect()
}

type Found = Vec<Vec<Complex<f64>>>;

/// The distance to the nearest point, relative to the largest unknown.
fn distance(to: &[Complex<f64>], points: &Found) -> f64 {
    let size = to.iter().map(|x| x.norm()).fold(0.0, f64::max);
    let of_point = |point: &Vec<Complex<f64>>| point.iter().zip(to).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
    points.iter().map(of_point).fold(f64::INFINITY, f64::min) / size
}

/// What one attempt gives: the share of the solutions, and distances before the polish.
#[derive(Default)]
struct Share {
    found: usize,
    distances: Vec<f64>,
}

impl Share {
    fn add<'a>(&mut self, make: impl Fn() -> Result<Once<'a>, SolveError>, truths: &Found) {
        let solved = make().and_then(|mut instance| emitted::complex_solutions(&mut instance));
        let found: Found = solved.map_or_else(|_| Vec::new(), |found| found.to_vec());
        let mut unpolished = Vec::new();
        // An attempt that fails has no points.
        let _ = make()
            .and_then(|mut instance| emitted::unpolished_points(&mut instance, |point| unpolished.push(point.clone())));
        for truth in truths {
            self.found += usize::from(distance(truth, &found) < FOUND);
            self.distances.push(distance(truth, &unpolished).clamp(1e-17, 1.0).log10());
        }
    }

    fn cells(&mut self) -> [String; 3] {
        let part = 100.0 * self.found as f64 / self.distances.len() as f64;
        let [median, p90] = [0.5, 0.9].map(|part| quantile(&mut self.distances, part));
        [format!("{part:.2}"), format!("{median:.1}"), format!("{p90:.1}")]
    }
}

fn cells(case: &Case, arguments: &Arguments) -> Vec<String> {
    let (plan, source) = (case.planned().plan, DataSource::new(case));
    let solver = InterpretedSolver::of(&plan);
    let (mut double, mut single) = (Share::default(), Share::default());
    for k in 0..arguments.instances {
        let data = source.draw(Family::Scene, arguments.seed + k);
        let Ok(mut instance) = solver.instance(&data) else { continue };
        let Ok(truths) = emitted::complex_solutions(&mut instance) else { continue };
        let truths = truths.to_vec();
        let once = |single| Ok(Once { instance: solver.instance(&data)?, single, read: Vec::new() });
        double.add(|| once(None), &truths);
        single.add(|| once(Some((&plan, ValueLayout::of(&plan)))), &truths);
    }
    let [of_double, of_single] = [double.cells(), single.cells()];
    [vec![case.name.to_owned(), arguments.instances.to_string()], of_double.to_vec(), of_single.to_vec()].concat()
}

fn main() {
    let arguments = Arguments::parse();
    let is_wanted =
        |case: &Case| arguments.problems.is_empty() || arguments.problems.iter().any(|name| name == case.name);
    let mut table = Table::new();
    table.load_preset(presets::ASCII_MARKDOWN);
    let of = |precision: &str| ["% found", "median", "90 %"].map(|what| format!("{precision}: {what}"));
    let header = [vec!["problem".to_owned(), "scenes".to_owned()], of("f64").to_vec(), of("f32").to_vec()].concat();
    table.set_header(header);
    table.add_rows(cases().iter().filter(|case| is_wanted(case)).map(|case| cells(case, &arguments)));
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    println!("{table}");
    println!("found: solutions after the polish; median and 90 %: log10 of errors before it");
}
