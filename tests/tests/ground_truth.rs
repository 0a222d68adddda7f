//! Solutions that are known from geometry are found.

use eliminant::Complex;
use eliminant_generator::algebra::Random;
use eliminant_tests::ground_truth::{Circle, FOUND, Line, gram, makers, minimal_conic, minimal_data, normalised};
use eliminant_tests::measure::{WORK_OF_TESTING, affordable};
use eliminant_tests::statistics::{log10, quantile, same_set, worst};
use eliminant_tests::{Case, cases};
use rayon::prelude::*;

const INSTANCES: u64 = 10_000;
/// On how many of 1000 instances all known solutions must be found.
const RECOVERED: usize = 999;
/// Problems whose scenes often come close to data for which the basis does not span, or the truth is nearly a double solution, whatever template
/// is taken.
const HARD: &[&str] = &[
    // The linear equations of the points are often close to dependent in the unknowns that they are solved for: coefficients of thousands.
    "calibration_6_receivers_4_senders",
    "fundamental_8pt_radial_one_side",
    "relpose_7pt_focal_radial_one_side",
    "relpose_7pt_focal_radial_one_side_eliminated",
    // Where the angles at the receivers are alike, their equations are close to dependent in the centre.
    "pose_5tdoa_two_receivers",
];
/// The same for those: what hand-written solvers of five- and six-point relative pose reach.
const RECOVERED_HARD: usize = 980;

fn case(name: &str) -> Case {
    cases().into_iter().find(|case| case.name == name).unwrap_or_else(|| panic!("no case {name}"))
}

#[test]
fn every_problem_has_a_maker() {
    let made: Vec<&str> = makers().iter().map(|maker| maker.name).collect();
    let solved: Vec<&str> = cases().iter().map(|case| case.name).collect();
    assert_eq!(made, solved);
}

#[test]
fn known_solutions_are_found() {
    let mut misses = Vec::new();
    for maker in makers() {
        let case = case(maker.name);
        let instances = affordable(&case.planned().plan, INSTANCES, WORK_OF_TESTING);
        let mut errors: Vec<f64> = (0..instances)
            .into_par_iter()
            .map(|k| maker.worst_error(&case, &mut Random::new(10_000_000 + k)))
            .collect();
        let found = errors.iter().filter(|&&error| error <= FOUND).count();
        let quantiles = [0.5, 0.9, 0.99, 0.999].map(|q| log10(quantile(&mut errors, q)));
        println!("{}: {found} of {instances} found, log10 error {quantiles:.1?}", case.name);
        let demanded = if HARD.contains(&case.name) { RECOVERED_HARD } else { RECOVERED };
        if found * 1000 < instances as usize * demanded {
            misses.push(format!("{}: {found} of {instances}", case.name));
        }
    }
    assert!(misses.is_empty(), "{misses:?}");
    let unknown: Vec<&&str> = HARD.iter().filter(|name| cases().iter().all(|case| case.name != **name)).collect();
    assert!(unknown.is_empty(), "{unknown:?}");
}

/// Three lines have an incircle and three excircles: all four real, all truly tangent.
#[test]
fn all_circles_of_three_lines_are_tangent() {
    let case = case("circle_minimal");
    let results: Vec<(usize, f64)> = (0..INSTANCES)
        .into_par_iter()
        .map(|k| {
            let mut random = Random::new(20_000_000 + k);
            let lines = Circle::draw(&mut random).tangents(&mut random, 3);
            let data = minimal_data(&lines);
            let found = (case.solve)(&data).unwrap_or_default();
            let errors = found.iter().map(|solution| tangency(&minimal_conic(&data, solution), &lines));
            (found.len(), worst(errors))
        })
        .collect();
    let complete = results.iter().filter(|(count, _)| *count == 4).count();
    let mut errors: Vec<f64> = results.iter().map(|&(_, error)| error).collect();
    let quantiles = [0.5, 0.99, 0.999, 1.0].map(|q| log10(quantile(&mut errors, q)));
    println!("four real circles on {complete} of {INSTANCES}; log10 of the distance from tangency {quantiles:.1?}");
    assert!(complete * 1000 >= INSTANCES as usize * 999);
    assert!(quantiles[2] <= FOUND.log10());
}

/// Largest | |distance of centre and line| - radius |, relative to the largest length involved.
fn tangency(conic: &[f64], lines: &[Line]) -> f64 {
    let (x, y) = (-conic[2], -conic[4]);
    let radius = (0.5 * (conic[0] + x * x + conic[3] + y * y)).max(0.0).sqrt();
    let error = |line: &Line| {
        let distance = (line.normal.x * x + line.normal.y * y + line.offset).abs();
        (distance - radius).abs() / radius.max(x.hypot(y)).max(line.offset.abs())
    };
    worst(lines.iter().map(error))
}

/// The cost of the known circle vanishes at the solution that is found.
#[test]
fn an_exact_circle_costs_nothing() {
    let case = case("circle_least_squares");
    let mut costs: Vec<f64> = (0..INSTANCES)
        .into_par_iter()
        .map(|k| {
            let mut random = Random::new(30_000_000 + k);
            let circle = Circle::draw(&mut random);
            let (lines, _) = normalised(&circle.tangents(&mut random, 12), &circle);
            let found = (case.solve)(&gram(&lines)).unwrap_or_default();
            found.iter().map(|s| cost(s, &lines)).fold(f64::INFINITY, f64::min)
        })
        .collect();
    let quantiles = [0.5, 0.99, 0.999].map(|q| log10(quantile(&mut costs, q)));
    println!("log10 of the root mean square of l^T D l {quantiles:.1?}");
    // The square root of the rounding of the Gram matrix, at worst.
    assert!(quantiles[2] <= -8.0);
}

/// Root mean square over the lines of l^T D l, relative to the size of D.
fn cost(d: &[f64], lines: &[Line]) -> f64 {
    let value = |line: &Line| {
        let (a, b, c) = (line.normal.x, line.normal.y, line.offset);
        d[0] * a * a + 2.0 * d[1] * a * b + 2.0 * d[2] * a * c + d[3] * b * b + 2.0 * d[4] * b * c - c * c
    };
    let size = d[..5].iter().fold(1.0, |size: f64, x| size.max(x.abs()));
    (lines.iter().map(|line| value(line).powi(2)).sum::<f64>() / lines.len() as f64).sqrt() / size
}

/// Seven unknowns with multipliers or three without: the same stationary points (d3, d4, d5).
#[test]
fn both_least_squares_formulations_agree() {
    let (lagrangian, dual) = (case("circle_least_squares"), case("circle_least_squares_dual"));
    let same = (0..INSTANCES)
        .into_par_iter()
        .filter(|&k| {
            let mut random = Random::new(40_000_000 + k);
            let circle = Circle::draw(&mut random);
            let count = 5 + random.below(16) as usize;
            let mut lines = circle.tangents(&mut random, count);
            lines.iter_mut().for_each(|line| line.offset += 0.05 * random.symmetric_unit());
            let data = gram(&normalised(&lines, &circle).0);
            let seven = (lagrangian.solve_complex)(&data).unwrap_or_default();
            let seven: Vec<Vec<Complex<f64>>> = seven.iter().map(|s| s[2..5].to_vec()).collect();
            let three = (dual.solve_complex)(&data).unwrap_or_default();
            three.len() == 9 && same_set(&seven, &three, FOUND)
        })
        .count();
    println!("the same 9 stationary points on {same} of {INSTANCES}");
    assert!(same * 1000 >= INSTANCES as usize * 999);
}
