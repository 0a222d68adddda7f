//! Systems with finitely many solutions for which growing sets of shifts finds nothing within the
//! usual bounds: the trace of a Gröbner basis gives a template that a build accepts.
#![cfg(feature = "search")]

use eliminant_generator::check::{SolutionCount, check};
use eliminant_generator::generate::plan;
use eliminant_generator::problem::Problem;
use eliminant_generator::search::monitor::{Monitor, Stage, Unmonitored};
use eliminant_generator::search::preference::Preference;
use eliminant_generator::search::{SearchError, SearchOptions, candidates, traced_candidates};

/// As many dense quadrics as unknowns.
fn quadrics(unknowns: usize) -> String {
    let names: Vec<String> = (0..unknowns).map(|at| format!("x{at}")).collect();
    let mut monomials: Vec<String> =
        (0..unknowns).flat_map(|i| (i..unknowns).map(move |j| format!("x{i} * x{j}"))).collect();
    monomials.extend(names.iter().cloned());
    monomials.push("1".to_owned());
    let (list, terms) = (names.join(", "), monomials.len());
    format!(
        "fn quadrics(c: [[f64; {terms}]; {unknowns}]) -> ({list}) {{ for q in c {{ dot(q, [{}]) == 0; }} }}",
        monomials.join(", ")
    )
}

/// Two dense curves of a degree in the plane.
fn curves(degree: usize) -> String {
    let monomials: Vec<String> = (0..=degree)
        .flat_map(|i| (0..=degree - i).map(move |j| (i, j)))
        .map(|(i, j)| match (i, j) {
            (0, 0) => "1".to_owned(),
            (0, _) => format!("y.pow({j})"),
            (_, 0) => format!("x.pow({i})"),
            _ => format!("x.pow({i}) * y.pow({j})"),
        })
        .collect();
    let terms = monomials.len();
    format!(
        "fn curves(c: [[f64; {terms}]; 2]) -> (x, y) {{ for f in c {{ dot(f, [{}]) == 0; }} }}",
        monomials.join(", ")
    )
}

fn read(text: &str) -> (Problem, SolutionCount) {
    let problem = Problem::parse("problem.rs", text).unwrap_or_else(|messages| panic!("{}", messages.render()));
    let count = check(&problem).unwrap_or_else(|messages| panic!("{}", messages.render()));
    (problem, count)
}

/// A monitor to which the search is over before it begins.
struct Over;

impl Monitor for Over {
    fn say(&self, _: &str) {}

    fn is_over(&self, stage: Stage) -> bool {
        stage == Stage::Searching
    }
}

/// The rows of the smallest template by the trace. A build accepts all templates.
fn traced_rows(problem: &Problem, count: &SolutionCount, monitor: &dyn Monitor) -> usize {
    let options = SearchOptions { shuffles: 0, prefer: Preference::Size, ..SearchOptions::default() };
    let found = traced_candidates(problem, count, &options, monitor).unwrap_or_else(|error| panic!("{error}"));
    for candidate in &found.candidates {
        let planned = plan(problem, &candidate.to_file(problem, &options));
        assert_eq!(planned.map(|planned| planned.plan.solutions).ok(), Some(count.different), "{}", problem.name);
        assert!(candidate.template.columns() >= count.least_columns(problem));
    }
    found.candidates[0].template.rows()
}

#[test]
fn dense_quadrics_have_templates() {
    for (unknowns, macaulay_columns) in [(3, 35), (4, 126), (5, 462)] {
        let (problem, count) = read(&quadrics(unknowns));
        assert_eq!(count.solutions, 1 << unknowns);
        let rows = traced_rows(&problem, &count, &Unmonitored);
        // Macaulay's matrix of all multiples up to the regularity is square but for the solutions.
        assert!(rows <= macaulay_columns - count.solutions, "{unknowns} unknowns: {rows} rows");
    }
}

#[test]
fn dense_curves_have_templates() {
    let (problem, count) = read(&curves(8));
    assert_eq!((count.solutions, count.least_columns(&problem)), (64, 65));
    // Sylvester's matrix with the other unknown hidden has 2 * 8 rows for each of about 8 powers.
    let rows = traced_rows(&problem, &count, &Unmonitored);
    assert!(rows <= 72, "{rows}");
}

#[test]
fn a_template_is_found_even_if_there_is_no_time() {
    let (problem, count) = read(&quadrics(4));
    let [with_time, without] = [&Unmonitored as &dyn Monitor, &Over].map(|m| traced_rows(&problem, &count, m));
    assert!(with_time <= without && without <= 110, "{with_time}, {without}");
}

#[test]
fn sign_changes_are_used() {
    // All terms of an equation have the same parity. With 70 solutions cyclic 5 has none of these.
    let text = "fn even(a: [[f64; 7]; 3]) -> (x, y, z) {
        for c in a { dot(c, [x * x, x * y, x * z, y * y, y * z, z * z, 1]) == 0; }
    }";
    let (problem, count) = read(text);
    assert_eq!((count.solutions, count.least_columns(&problem)), (8, 5));
    let options = SearchOptions { shuffles: 0, ..SearchOptions::default() };
    let found = traced_candidates(&problem, &count, &options, &Unmonitored).unwrap();
    assert!(found.candidates.iter().any(|candidate| candidate.template.basis.len() == 4));
    traced_rows(&problem, &count, &Unmonitored);
}

#[test]
fn too_few_columns_are_refused_at_once() {
    let (problem, count) = read(&curves(30));
    assert_eq!((count.solutions, count.least_columns(&problem)), (900, 901));
    let error = candidates(&problem, &count, &SearchOptions::default(), &Unmonitored).unwrap_err();
    assert_eq!(error, SearchError::TooFewColumns { max_columns: 600, least: 901 });
    assert!(error.to_string().contains("at least 901 columns"), "{error}");
}

#[test]
fn without_finitely_many_zeros_there_is_no_trace() {
    // Where x is 0 all y are solutions, which the last statement excludes.
    let text = "fn axis(a: [f64; 4]) -> (x, y) {
        x * (y * y - a[0]) == 0;
        x * (x * x + a[1] * x * y + a[2] * y * y - a[3]) == 0;
        x != 0;
    }";
    let (problem, count) = read(text);
    assert_eq!(count.solutions, 4);
    let found = traced_candidates(&problem, &count, &SearchOptions::default(), &Unmonitored);
    assert!(matches!(found, Err(SearchError::NotFound { .. })));
    assert!(candidates(&problem, &count, &SearchOptions::default(), &Unmonitored).is_ok());
}

/// The factor that must not vanish goes with the unknown that is eliminated.
#[test]
fn what_determinants_eliminate_leaves_finitely_many_zeros() {
    let (problem, count) =
        read("fn axis(a: [f64; 3]) -> (x, y) { x * (y * y - a[0]) == 0; x * (x + a[1] * y - a[2]) == 0; x != 0; }");
    assert_eq!(count.solutions, 2);
    let found = traced_candidates(&problem, &count, &SearchOptions::default(), &Unmonitored).unwrap();
    assert!(found.candidates.iter().any(|found| (found.template.rows(), found.template.basis.len()) == (1, 2)));
}
