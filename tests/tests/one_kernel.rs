//! Emitted solvers and interpreted plans are one kernel: the same bits, or the same error, second
//! attempts included.
//!
//! So what a search measures on interpreted plans is what the emitted solver does.

use eliminant::emitted::{to_chart, vector_of};
use eliminant::{Scalar, SolveError};
use eliminant_generator::algebra::Random;
use eliminant_generator::expression::arithmetic::Float64;
use eliminant_generator::plan::Plan;
use eliminant_generator::problem::SolutionField;
use eliminant_generator::problem::draw::draw_inputs;
use eliminant_generator::search::measuring::interpreted::InterpretedSolver;
use eliminant_tests::ground_truth::makers;
use eliminant_tests::measure::affordable;
use eliminant_tests::{Case, cases};
use rayon::prelude::*;

/// Instances of each family and problem, if they are affordable.
const INSTANCES: u64 = 100;
/// Operations for all instances of one problem and family.
const WORK: u64 = 100_000_000;

/// What was compared.
#[derive(Clone, Copy, Default)]
struct Counts {
    instances: usize,
    solutions: usize,
    errors: usize,
    second_attempts: usize,
}

impl Counts {
    fn plus(self, other: Self) -> Self {
        Self {
            instances: self.instances + other.instances,
            solutions: self.solutions + other.solutions,
            errors: self.errors + other.errors,
            second_attempts: self.second_attempts + other.second_attempts,
        }
    }
}

/// A solver's answer with every number as its bits, so that -0 is not 0 and a NaN is itself.
fn bits<T: Into<eliminant::Complex<f64>> + Copy>(
    found: &Result<Vec<Vec<T>>, SolveError>,
) -> Result<Vec<Vec<[u64; 2]>>, SolveError> {
    let number = |x: &T| {
        let x: eliminant::Complex<f64> = (*x).into();
        [x.re.to_bits(), x.im.to_bits()]
    };
    found.clone().map(|found| found.iter().map(|point| point.iter().map(number).collect()).collect())
}

/// Vectors that are given up to scale as solvers return them, then their unknowns again: a solution
/// of an emitted solver takes both ways. So does one of an interpreted plan where the elements of
/// the vector are in another unit.
fn returned<T: Scalar>(fields: &[SolutionField], exponents: &[i16], mut point: Vec<T>) -> Vec<T> {
    for field in fields {
        let is_returned = exponents[field.unknowns()].iter().any(|&exponent| exponent != 0);
        if let Some(chart) = field.chart().filter(|_| !is_returned) {
            let mut vector = vec![T::ZERO; field.scalars()];
            vector_of(&chart, &point[field.unknowns()], &mut vector);
            to_chart(&chart, &vector, &mut point[field.unknowns()]);
        }
    }
    point
}

/// Compares `solve` and `solve_complex` on one instance.
fn compare(case: &Case, (plan, solver): (&Plan, &InterpretedSolver), data: &[f64]) -> Counts {
    let (real, complex) = ((case.solve)(data), (case.solve_complex)(data));
    let exponents = solver.instance(data).map_or_else(|_| Vec::new(), |instance| instance.exponents().to_vec());
    let fields = &plan.fields;
    let of_plan = solver.solve(data);
    let of_plan = of_plan.map(|found| found.into_iter().map(|x| returned(fields, &exponents, x)).collect());
    assert_eq!(bits(&real), bits(&of_plan), "{}: solve of {data:?}", case.name);
    let instance = solver.instance(data);
    let mut second_attempts = 0;
    let interpreted = instance.and_then(|mut instance| {
        let found = instance.solve_complex();
        let found = found.map(|found| found.into_iter().map(|x| returned(fields, &exponents, x)).collect());
        second_attempts = usize::from(instance.attempts() > 1);
        found
    });
    assert_eq!(bits(&complex), bits(&interpreted), "{}: solve_complex of {data:?}", case.name);
    Counts {
        instances: 1,
        solutions: complex.as_ref().map_or(0, Vec::len),
        errors: usize::from(complex.is_err()),
        second_attempts,
    }
}

/// Compares on all instances that are affordable, and prints what was compared.
fn compare_all(case: &Case, plan: &Plan, family: &str, draw: impl Fn(u64) -> Vec<f64> + Sync) -> Counts {
    let solver = InterpretedSolver::of(plan);
    // A second attempt takes some twenty times as long: of large problems a few instances must do.
    let instances = affordable(plan, INSTANCES, WORK).clamp(4, INSTANCES);
    let compared = (0..instances).into_par_iter().map(|k| compare(case, (plan, &solver), &draw(k)));
    let counts = compared.reduce(Counts::default, Counts::plus);
    println!(
        "{} ({family}): {} instances, {} solutions, {} errors, {} second attempts",
        case.name, counts.instances, counts.solutions, counts.errors, counts.second_attempts
    );
    counts
}

#[test]
fn on_random_data() {
    let mut second_attempts = 0;
    for case in cases() {
        let plan = case.planned().plan;
        let draw = |k| draw_inputs(&plan.data, Float64, &mut Random::new(7_000_000 + k));
        let counts = compare_all(&case, &plan, "random", draw);
        assert!(counts.solutions * 2 > plan.solutions * counts.instances, "{}: few solutions", case.name);
        second_attempts += counts.second_attempts;
    }
    assert!(second_attempts > 0, "no instance took a second attempt");
}

#[test]
fn on_scenes() {
    let cases = cases();
    let mut second_attempts = 0;
    for maker in makers() {
        let case = cases.iter().find(|case| case.name == maker.name).expect("every maker has a case");
        let plan = case.planned().plan;
        let draw = |k| maker.make.draw(&mut Random::new(8_000_000 + k)).data;
        let counts = compare_all(case, &plan, "scenes", draw);
        assert!(counts.errors * 20 <= counts.instances, "{}: {} errors", case.name, counts.errors);
        second_attempts += counts.second_attempts;
    }
    assert!(second_attempts > 0, "no scene took a second attempt");
}

/// Degenerate data: the errors are the same.
#[test]
fn on_special_data() {
    let mut errors = 0;
    for case in cases() {
        let plan = case.planned().plan;
        if plan.data.is_empty() {
            continue;
        }
        let draw = |k| {
            let mut random = Random::new(9_000_000 + k);
            let mut data = draw_inputs(&plan.data, Float64, &mut random);
            for at in 0..data.len() {
                match random.below(6) {
                    0 => data[at] = 0.0,
                    1 => data[at] = 1.0,
                    2 => data[at] = data[random.below(at as u64 + 1) as usize],
                    _ => {}
                }
            }
            data
        };
        errors += compare_all(&case, &plan, "special", draw).errors;
    }
    assert!(errors > 0, "no special data were refused");
}
