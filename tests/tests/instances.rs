//! Ten thousand random instances of every problem, fewer of the largest, drawn on the data's variety.

use eliminant::Complex;
use eliminant_generator::algebra::Random;
use eliminant_generator::expression::arithmetic::Float64;
use eliminant_generator::plan::Plan;
use eliminant_generator::plan::interpret;
use eliminant_generator::problem::instance::draw_inputs;
use eliminant_tests::measure::{SAME, WORK_OF_TESTING, affordable, are_distinct, residual};
use eliminant_tests::statistics::{complex, log10, quantile, same_set};
use eliminant_tests::{Case, cases};
use rayon::prelude::*;

const INSTANCES: u64 = 10_000;
/// On how many of 1000 instances a claim may fail.
const EXCEPTIONS_PER_THOUSAND: usize = 1;
/// The same for problems of which more is not reached.
const MORE_EXCEPTIONS: [(&str, usize); 1] = [
    // 68 solutions, by 25 equations whose coefficients are determinants.
    ("relpose_7pt_focal_radial", 5),
];
/// An imaginary part that is rounding, relative to the largest unknown.
const REAL: f64 = 1e-9;

type Point = Vec<Complex<f64>>;

/// What one instance gave.
struct Outcome {
    /// Every complex solution was found, no two of them the same.
    complete: bool,
    /// The complex conjugate of every solution is a solution.
    conjugate: bool,
    /// `solve` returns exactly the real ones among `solve_complex`.
    real_agree: bool,
    complex_residuals: Vec<f64>,
    real_residuals: Vec<f64>,
}

fn outcome(case: &Case, plan: &Plan, seed: u64) -> Outcome {
    let data = draw_inputs(&plan.data, Float64, &mut Random::new(seed));
    let coefficients = interpret::coefficients(plan, Float64, &data).expect("random data have coefficients");
    let all: Vec<Point> = (case.solve_complex)(&data).unwrap_or_default();
    let real: Vec<Point> = (case.solve)(&data).unwrap_or_default().iter().map(|x| complex(x)).collect();
    let conjugates: Vec<Point> = all.iter().map(|x| x.iter().map(Complex::conj).collect()).collect();
    let is_real = |x: &&Point| {
        let largest = |part: fn(&Complex<f64>) -> f64| x.iter().map(part).fold(0.0, f64::max);
        largest(|z| z.im.abs()) <= REAL * largest(|z| z.norm())
    };
    let real_of_all: Vec<Point> = all.iter().filter(is_real).cloned().collect();
    let residuals = |points: &[Point]| points.iter().map(|x| residual(plan, &coefficients, x)).collect();
    Outcome {
        complete: all.len() == plan.solutions && are_distinct(&all),
        conjugate: same_set(&all, &conjugates, SAME),
        real_agree: same_set(&real, &real_of_all, SAME),
        complex_residuals: residuals(&all),
        real_residuals: residuals(&real),
    }
}

#[test]
fn every_solution_is_found_and_precise() {
    let mut faults = Vec::new();
    for case in cases() {
        let plan = case.planned().plan;
        let instances = affordable(&plan, INSTANCES, WORK_OF_TESTING);
        let outcomes: Vec<Outcome> =
            (0..instances).into_par_iter().map(|k| outcome(&case, &plan, 50_000_000 + k)).collect();
        for (claim, holds) in [
            ("all complex solutions found", (|o| o.complete) as fn(&Outcome) -> bool),
            ("conjugates are solutions", |o| o.conjugate),
            ("solve gives the real ones", |o| o.real_agree),
        ] {
            let exceptions = outcomes.iter().filter(|o| !holds(o)).count();
            println!("{}: {claim} on {} of {instances}", case.name, outcomes.len() - exceptions);
            let more = MORE_EXCEPTIONS.iter().find(|(name, _)| *name == case.name);
            let allowed = more.map_or(EXCEPTIONS_PER_THOUSAND, |&(_, allowed)| allowed);
            if exceptions * 1000 > outcomes.len() * allowed {
                faults.push(format!("{}: {claim}: {exceptions} exceptions", case.name));
            }
        }
        for (function, residuals) in [
            ("solve_complex", (|o| &o.complex_residuals) as fn(&Outcome) -> &Vec<f64>),
            ("solve", |o| &o.real_residuals),
        ] {
            let mut all: Vec<f64> = outcomes.iter().flat_map(residuals).copied().collect();
            let [median, p999, max] = [0.5, 0.999, 1.0].map(|q| log10(quantile(&mut all, q)));
            let count = all.len();
            println!("{} {function}: {count} solutions, log10 residual {median:.2} {p999:.2} {max:.2}", case.name);
            let precise = median < -14.5 && p999 < -10.0;
            if !precise {
                faults.push(format!("{} {function}: median {median}, p99.9 {p999}", case.name));
            }
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
}
