//! Solutions that are known from geometry are found.

use eliminant::Complex;
use eliminant_generator::algebra::Random;
use eliminant_tests::bounds::{Bounds, share};
use eliminant_tests::equations::Equations;
use eliminant_tests::ground_truth::{
    Circle, FOUND, KnownInstance, Line, Maker, gram, makers, minimal_conic, minimal_data, normalised,
};
use eliminant_tests::measure::{WORK_OF_TESTING, affordable};
use eliminant_tests::statistics::{complex, distance, log10, quantile, same_set, worst};
use eliminant_tests::{Case, cases};
use rayon::prelude::*;

const INSTANCES: u64 = 4_000;
/// Scenes of the circle solvers, which the cylinders stand on.
const MANY: u64 = 1_000_000;
/// A returned solution at most this far from a known one is the known one with fewer digits.
const COARSE: f64 = 1e-2;
/// The smallest singular value of the scaled Jacobian below which a solution counts as
/// ill-conditioned: an error of the equations at the level of rounding, 1e-15 of their terms, moves
/// it by 1e-8 of its norm or more.
const ILL_CONDITIONED: f64 = 1e-7;

const NOT_FOUND: Bounds = Bounds { what: "share of known solutions that are not found", usual: 1e-3, exceptions: &[] };
const NOT_FOUND_WITHOUT_REASON: Bounds = Bounds {
    what: "share of known solutions that are not found although they are well-conditioned",
    usual: 5e-4,
    exceptions: &[],
};

/// What became of a known solution. Errors are those of the solver: they are measured from the
/// exact solution of the rounded data next to the known one.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Fate {
    /// `solve` returns it, with an error of at most 1e-6.
    Found,
    /// `solve` returns it, with an error of at most 1e-2.
    Inaccurate,
    /// `solve` does not return it, `solve_complex` does.
    Unnoticed,
    /// Neither returns it.
    Lost,
}

/// A known solution that is not found.
#[derive(Clone, Copy, Debug)]
struct Miss {
    fate: Fate,
    /// The smallest singular value of the Jacobian there: rows in units of their equations' terms,
    /// columns in units of the solution's norm.
    condition: f64,
    error: f64,
}

/// The known solutions of an instance that are not found.
fn misses(maker: &Maker, case: &Case, instance: &KnownInstance) -> Vec<Miss> {
    let found = (case.solve)(&instance.data).unwrap_or_default();
    let error_from = |truth: &[f64]| {
        found.iter().map(|solution| (maker.error)(&instance.data, solution, truth)).fold(f64::INFINITY, f64::min)
    };
    let is_found = |truth: &&Vec<f64>| error_from(truth) <= FOUND;
    let missed: Vec<&Vec<f64>> = instance.truths.iter().filter(|truth| !is_found(truth)).collect();
    if missed.is_empty() {
        return Vec::new();
    }
    let equations = Equations::new(&case.problem(), &instance.data).expect("no divisor vanishes");
    let all = (case.solve_complex)(&instance.data).unwrap_or_default();
    let fate = |truth: &&Vec<f64>| {
        let exact = equations.refined(&complex(truth));
        let real: Vec<f64> = exact.point.iter().map(|x| x.re).collect();
        let size = truth.iter().map(|x| x * x).sum::<f64>().sqrt();
        let condition = equations.smallest_singular_value(&exact.point, &vec![size; truth.len()]);
        let error = error_from(&real);
        let fate = match error {
            ..=FOUND => Fate::Found,
            ..=COARSE => Fate::Inaccurate,
            _ if all.iter().any(|x| distance(x, &exact.point) <= COARSE) => Fate::Unnoticed,
            _ => Fate::Lost,
        };
        Miss { fate, condition, error }
    };
    missed.iter().map(fate).filter(|miss| miss.fate != Fate::Found).collect()
}

fn case(name: &str) -> Case {
    cases().into_iter().find(|case| case.name == name).unwrap_or_else(|| panic!("no case {name}"))
}

#[test]
fn every_problem_has_a_maker() {
    let made: Vec<&str> = makers().iter().map(|maker| maker.name).collect();
    let solved: Vec<&str> = cases().iter().map(|case| case.name).collect();
    assert_eq!(made, solved);
}

/// What makers call a solution is one: the data are rounded, and that is all.
#[test]
fn known_solutions_satisfy_the_equations() {
    for maker in makers() {
        let problem = case(maker.name).problem();
        let mut residuals: Vec<f64> = (0..100)
            .flat_map(|k| {
                let instance = maker.make.draw(&mut Random::new(11_000_000 + k));
                let equations = Equations::new(&problem, &instance.data).expect("no divisor vanishes");
                assert!(instance.truths.iter().all(|truth| truth.len() == problem.unknowns.len()), "{}", maker.name);
                instance.truths.iter().map(|truth| equations.residual(&complex(truth))).collect::<Vec<f64>>()
            })
            .collect();
        let [median, p90] = [0.5, 0.9].map(|q| quantile(&mut residuals, q));
        println!(
            "{}: log10 residual of known solutions: median {:.1}, p90 {:.1}",
            maker.name,
            log10(median),
            log10(p90)
        );
        // Data are null spaces and solutions of linear equations, which lose some digits.
        assert!(median <= 1e-13 && p90 <= 1e-10, "{}: {median:e} {p90:e}", maker.name);
    }
}

#[test]
fn known_solutions_are_found() {
    let mut faults = Vec::new();
    for maker in makers() {
        let case = case(maker.name);
        let instances = affordable(&case.planned().plan, INSTANCES, WORK_OF_TESTING);
        let results: Vec<(usize, Vec<Miss>)> = (0..instances)
            .into_par_iter()
            .map(|k| {
                let instance = maker.make.draw(&mut Random::new(10_000_000 + k));
                (instance.truths.len(), misses(&maker, &case, &instance))
            })
            .collect();
        let known: usize = results.iter().map(|(truths, _)| truths).sum();
        let misses: Vec<Miss> = results.into_iter().flat_map(|(_, misses)| misses).collect();
        let count = |fate: Fate| misses.iter().filter(|miss| miss.fate == fate).count();
        let without_reason = misses.iter().filter(|miss| miss.condition >= ILL_CONDITIONED).count();
        let [inaccurate, unnoticed, lost] = [Fate::Inaccurate, Fate::Unnoticed, Fate::Lost].map(count);
        println!(
            "{}: {} of {known} found; {inaccurate} inaccurate, {unnoticed} by solve_complex only, {lost} lost",
            case.name,
            known - misses.len()
        );
        for fate in [Fate::Inaccurate, Fate::Unnoticed, Fate::Lost] {
            let conditions: Vec<String> = misses
                .iter()
                .filter(|miss| miss.fate == fate)
                .take(12)
                .map(|miss| format!("{:.0e} ({:.0e})", miss.condition, miss.error))
                .collect();
            if !conditions.is_empty() {
                println!("    {fate:?}: smallest singular values (errors) {}", conditions.join(", "));
            }
        }
        NOT_FOUND.check(case.name, share(misses.len(), known), &mut faults);
        NOT_FOUND_WITHOUT_REASON.check(case.name, share(without_reason, known), &mut faults);
    }
    let names: Vec<&str> = cases().iter().map(|case| case.name).collect();
    NOT_FOUND.check_names(&names, &mut faults);
    NOT_FOUND_WITHOUT_REASON.check_names(&names, &mut faults);
    assert!(faults.is_empty(), "{faults:#?}");
}

/// The circle solvers miss nothing, and every solution is one, on a million scenes each.
#[test]
fn a_million_circles_are_found() {
    for maker in makers().iter().filter(|maker| maker.name.starts_with("circle")) {
        let case = case(maker.name);
        let (missed, residual) = (0..MANY)
            .into_par_iter()
            .map(|k| {
                let instance = maker.make.draw(&mut Random::new(70_000_000 + k));
                let found = (case.solve)(&instance.data).unwrap_or_default();
                let residual = |solution: &Vec<f64>| (case.residual)(&instance.data, &complex(solution));
                let residuals = found.iter().map(|solution| residual(solution).unwrap_or(f64::INFINITY));
                (misses(maker, &case, &instance).len(), worst(residuals))
            })
            .reduce(|| (0, 0.0), |(missed, residual), (m, r)| (missed + m, residual.max(r)));
        println!("{}: {missed} missed on {MANY} scenes, worst relative residual {residual:.1e}", case.name);
        assert!(missed == 0 && residual <= 1e-12, "{}: {missed} missed, {residual:e}", case.name);
    }
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
