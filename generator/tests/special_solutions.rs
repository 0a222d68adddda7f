//! Solutions at which unknowns are 0, or share the values of other solutions, are found with the
//! others.
#![cfg(feature = "oracle")]

use eliminant_generator::algebra::Random;
use eliminant_generator::check::check;
use eliminant_generator::oracle::Truths;
use eliminant_generator::presolve::Presolve;
use eliminant_generator::problem::Problem;
use eliminant_generator::search::choose::{Choice, Measuring, Verdict, choose};
use eliminant_generator::search::measuring::interpreted::InterpretedSolver;
use eliminant_generator::search::measuring::random_instance;
use eliminant_generator::search::monitor::Unmonitored;
use eliminant_generator::search::{Found, SearchOptions, candidates, traced_candidates};

/// Katsura's equations with five unknowns. At one of 16 solutions all but `a` are 0, at one more
/// all but `a` and `e`, and at two all but `a`, `c` and `e`.
const KATSURA_4: &str = "fn katsura_4() -> (a, b, c, d, e) {
    a + 2 * (b + c + d + e) == 1;
    a * a + 2 * (b * b + c * c + d * d + e * e) == a;
    2 * (a * b + b * c + c * d + d * e) == b;
    b * b + 2 * (a * c + b * d + c * e) == c;
    2 * (a * d + b * c + b * e) == d;
}";

/// The equilibria of three species. Half of them have any one species 0.
const SPECIES: &str = include_str!("../../examples/other-fields/species_3.rs");

/// A reaction with a catalyst, three amounts: all three of one kind, all of another, or a mixture.
/// Where `a` and `c` are 0 all terms of an equation vanish.
const REACTION: &str = "fn reaction(k: [f64; 5]) -> (a, b, c) {
    a * (k[0] * b - k[1]) == 0;
    b * (k[2] * c - k[3] * a) == 0;
    a + b + c == k[4];
}";

/// A car with cameras, steered by its front wheels, from rays of two points in each frame: Lee,
/// Fraundorfer, Pollefeys, "Motion estimation for self-driving cars with a generalized camera",
/// CVPR 2013. It goes a way `rho` in the direction of half its turn, whose cosine and sine are
/// unknown.
const CAR: &str = "fn car(#[plucker] first: [[[f64; 3]; 2]; 2], #[plucker] second: [[[f64; 3]; 2]; 2]) -> (c, s, rho) {
    c * c + s * s == 1;
    let r = [[c * c - s * s, -2 * c * s, 0], [2 * c * s, c * c - s * s, 0], [0, 0, 1]];
    let t = rho * [c, s, 0];
    for k in 0..2 {
        let [q, m] = first[k];
        let [u, v] = second[k];
        dot(u, cross(t, r * q)) + dot(u, r * m) + dot(v, r * q) == 0;
    }
}";

fn chosen(found: &Found, options: &SearchOptions) -> Choice {
    let measuring = Measuring { trials: 300, confirm: 1000, seed: 1 };
    choose(&found.candidates, options.prefer, measuring, &|_| None, &Unmonitored).expect("a candidate")
}

#[test]
fn solutions_at_which_unknowns_vanish_are_found() {
    let problem = Problem::parse("problem.rs", KATSURA_4).unwrap_or_else(|messages| panic!("{}", messages.render()));
    let count = check(&problem).expect("finitely many solutions");
    assert_eq!((count.different, count.at_origin, count.shares_values), (16, 0, false));
    assert_eq!(count.zero_sets, [vec![1, 2, 3], vec![1, 2, 3, 4], vec![1, 3]]);
    let options = SearchOptions { shuffles: 0, ..SearchOptions::default() };
    let found = traced_candidates(&problem, &count, &options, &Unmonitored).expect("templates");
    let choice = chosen(&found, &options);
    let best = &choice.measured[choice.chosen];
    assert_eq!((best.verdict, best.stability.incomplete), (Verdict::Accepted, 0));
    // The solution at which all unknowns that presolve keeps are 0 takes no eigenvalue.
    assert_eq!((best.candidate.presolve, best.candidate.template.basis.len()), (Presolve::Constant, 15));
    assert_eq!(best.candidate.zero_sets, [vec![1, 2, 3], vec![1, 3]]);
}

#[test]
fn solutions_that_share_all_values_are_found() {
    let problem = Problem::parse("problem.rs", SPECIES).unwrap_or_else(|messages| panic!("{}", messages.render()));
    let count = check(&problem).expect("finitely many solutions");
    assert_eq!((count.different, count.at_origin, count.shares_values), (8, 1, true));
    assert_eq!(count.zero_sets.len(), 7);
    let options = SearchOptions { shuffles: 0, max_columns: 40, max_basis: Some(7), ..SearchOptions::default() };
    let found = candidates(&problem, &count, &options, &Unmonitored).expect("templates");
    let choice = chosen(&found, &options);
    let best = &choice.measured[choice.chosen];
    assert_eq!((best.verdict, best.stability.incomplete), (Verdict::Accepted, 0));
    assert_eq!((best.candidate.presolve, best.candidate.template.basis.len()), (Presolve::Separated, 7));
    let others = choice.measured.iter().filter(|measured| measured.candidate.presolve != Presolve::Separated);
    let rejected: Vec<bool> = others.map(|measured| measured.verdict == Verdict::Rejected).collect();
    assert!(!rejected.is_empty() && rejected.iter().all(|&is_rejected| is_rejected), "{rejected:?}");
}

#[test]
fn solutions_at_which_all_terms_of_an_equation_vanish_are_found() {
    let problem = Problem::parse("problem.rs", REACTION).unwrap_or_else(|messages| panic!("{}", messages.render()));
    let count = check(&problem).expect("finitely many solutions");
    assert_eq!((count.different, count.shares_values), (3, false));
    let options = SearchOptions { shuffles: 0, max_columns: 20, ..SearchOptions::default() };
    let found = candidates(&problem, &count, &options, &Unmonitored).expect("templates");
    let choice = chosen(&found, &options);
    let best = &choice.measured[choice.chosen];
    assert_eq!((best.verdict, best.stability.trials, best.stability.incomplete), (Verdict::Accepted, 1000, 0));
    // The judge knows these solutions, too.
    let solver = InterpretedSolver::of(&best.candidate.plan);
    for k in 0..300 {
        let data = random_instance(&best.candidate.plan, 1, k);
        let returned = solver.solve_complex(&data).expect("no error");
        let judged = Truths::of(&best.candidate.plan, &data, &returned).expect("finite coefficients");
        assert!(judged.is_complete() && judged.judge(&returned, false).spurious == 0, "{k}: {returned:?}");
    }
}

/// On a straight way the sine is 0, and 1 / s^2 no eigenvalue.
#[test]
fn solutions_without_an_eigenpair_are_followed_from_data_nearby() {
    let problem = Problem::parse("problem.rs", CAR).unwrap_or_else(|messages| panic!("{}", messages.render()));
    let count = check(&problem).expect("finitely many solutions");
    assert_eq!(count.different, 6);
    let options = SearchOptions { shuffles: 0, ..SearchOptions::default() };
    let found = candidates(&problem, &count, &options, &Unmonitored).expect("templates");
    let choice = chosen(&found, &options);
    let mut accepted = choice.measured.iter().filter(|measured| measured.verdict != Verdict::Rejected);
    let plan = &accepted.find(|measured| measured.candidate.plan.loses_zeros).expect("one by 1/s^2").candidate.plan;
    let (solver, mut random) = (InterpretedSolver::of(plan), Random::new(1));
    for instance in 0..60 {
        let rho = 1.0 + random.symmetric_unit();
        let (mut first, mut second) = (Vec::new(), Vec::new());
        for _ in 0..2 {
            let mut vector = || [random.symmetric_unit(), random.symmetric_unit(), random.symmetric_unit()];
            let (point, centres) = (vector().map(|x| 5.0 * x), [vector(), vector()]);
            let moved = [point[0] + rho, point[1], point[2]];
            first.extend(line_through(centres[0], point));
            second.extend(line_through(centres[1], moved));
        }
        let found = solver.solve(&[first, second].concat()).expect("no error");
        let is_truth = |x: &Vec<f64>| [x[0] - 1.0, x[1], x[2] - rho].iter().all(|error| error.abs() < 1e-8);
        assert!(found.iter().any(is_truth), "{instance}: no ({rho}, straight) among {found:?}");
    }
}

/// The direction of a line, from one point to another, and its moment.
fn line_through(from: [f64; 3], to: [f64; 3]) -> [f64; 6] {
    let q: [f64; 3] = std::array::from_fn(|i| to[i] - from[i]);
    let moment = |i: usize| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        from[j] * q[k] - from[k] * q[j]
    };
    [q[0], q[1], q[2], moment(0), moment(1), moment(2)]
}
