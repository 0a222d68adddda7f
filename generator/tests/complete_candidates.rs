//! Every candidate of a search is a template that a build accepts: it gives all solutions, also
//! those at which many monomials vanish.
#![cfg(feature = "search")]

use eliminant_generator::check::check;
use eliminant_generator::generate::plan;
use eliminant_generator::problem::Problem;
use eliminant_generator::search::monitor::Unmonitored;
use eliminant_generator::search::{SearchOptions, candidates};

/// Katsura's systems have the solution (1, 0, .., 0). A template whose basis is made of multiples
/// of an unknown that vanishes there has no eigenvector for it.
const PROBLEMS: [(usize, &str); 2] = [
    (
        8,
        "fn katsura_3() -> (a, b, c, d) {
            a + 2 * b + 2 * c + 2 * d == 1;
            a * a + 2 * b * b + 2 * c * c + 2 * d * d == a;
            2 * a * b + 2 * b * c + 2 * c * d == b;
            b * b + 2 * a * c + 2 * b * d == c;
        }",
    ),
    (
        4,
        "fn on_an_axis(p: [f64; 5]) -> (x, y) {
            x * x + p[0] * x * y == p[1] * x;
            y * y + p[2] * x * y + p[3] * x == p[4];
        }",
    ),
];

#[test]
fn every_candidate_gives_all_solutions() {
    for (solutions, text) in PROBLEMS {
        let problem = Problem::parse("problem.rs", text).unwrap_or_else(|messages| panic!("{}", messages.render()));
        let count = check(&problem).expect("finitely many solutions");
        assert_eq!(count.different, solutions, "{}", problem.name);
        let options = SearchOptions::default();
        let found = candidates(&problem, &count, &options, &Unmonitored).expect("templates exist").candidates;
        println!("{}: {} candidates", problem.name, found.len());
        for candidate in &found {
            let file = candidate.to_file(&problem, &options);
            let planned = plan(&problem, &file).map(|planned| planned.plan.solutions);
            let (rows, columns) = (candidate.template.rows(), candidate.template.columns());
            assert!(
                planned.as_ref().is_ok_and(|&given| given == solutions),
                "{} {rows} x {columns}: {planned:?}",
                problem.name
            );
        }
    }
}
