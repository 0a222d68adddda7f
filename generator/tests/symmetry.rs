//! Templates that make use of changes of sign: as many basis monomials as solutions up to sign, and
//! all solutions found.
#![cfg(feature = "search")]

use eliminant_generator::check::check;
use eliminant_generator::generate::{GenerateError, plan};
use eliminant_generator::presolve::exchange::exchanged;
use eliminant_generator::presolve::symmetry::Symmetry;
use eliminant_generator::presolve::{Presolve, presolve};
use eliminant_generator::problem::Problem;
use eliminant_generator::search::choose::{Measuring, choose};
use eliminant_generator::search::measuring::stability;
use eliminant_generator::search::monitor::Unmonitored;
use eliminant_generator::search::{SearchOptions, TemplateCandidate, candidates};

/// What is found is what a template file may say: neither fewer solutions nor more.
fn assert_counted(problem: &Problem, candidate: &TemplateCandidate, options: &SearchOptions) {
    let mut file = candidate.to_file(problem, options);
    let solutions = file.solutions;
    assert!(plan(problem, &file).is_ok(), "{}", problem.name);
    for wrong in [solutions - 1, solutions + 1] {
        file.solutions = wrong;
        match plan(problem, &file) {
            Err(GenerateError::Solutions { found, .. }) => {
                assert_eq!((found.least, found.most), (solutions, solutions))
            }
            Err(GenerateError::Schedule(_)) if wrong > solutions => {}
            other => panic!("{}: {wrong} solutions: {:?}", problem.name, other.map(|planned| planned.plan.solutions)),
        }
    }
}

struct Subject {
    /// Number of sign changes, that of no unknown included.
    order: usize,
    solutions: usize,
    text: &'static str,
}

const SUBJECTS: [Subject; 5] = [
    Subject {
        order: 4,
        solutions: 4,
        text: "fn axes(a: [f64; 6]) -> (x, y) { a[0]*x*x + a[1]*y*y == a[2]; a[3]*x*x + a[4]*y*y == a[5]; }",
    },
    Subject {
        order: 2,
        solutions: 4,
        text: "fn conics(a: [f64; 6]) -> (x, y) { a[0]*x*x + a[1]*x*y + y*y == a[2]; x*x + a[3]*x*y + a[4]*y*y == a[5]; }",
    },
    Subject {
        order: 2,
        solutions: 8,
        // z keeps its sign.
        text: "fn mixed(a: [f64; 8]) -> (x, y, z) { x*y + a[0]*z + z*z == a[1]; x*x + a[2]*y*y == a[3] + a[4]*z; a[5]*x + a[6]*y*z + a[7]*x*z == 0; }",
    },
    Subject {
        order: 2,
        solutions: 8,
        // Presolve eliminates s, whose sign follows.
        text: "fn linear(a: [f64; 9]) -> (s, x, y, z) { s == a[0]*x + a[1]*y; s*s + a[2]*y*z == a[3]; x*x + a[4]*x*z + y*y == a[5]; z*z + a[6]*x*y + a[7]*s*x == a[8]; }",
    },
    Subject {
        order: 4,
        solutions: 12,
        // x and y together, y and z together.
        text: "fn pairs(a: [f64; 7]) -> (x, y, z) { x*x + a[0]*y*y == a[1]; y*y + a[2]*z*z == a[3]; x*y*z + a[4]*x*x + a[5]*y*y == a[6]; }",
    },
];

#[test]
fn a_basis_of_the_solutions_up_to_sign_finds_all() {
    for Subject { order, solutions, text } in SUBJECTS {
        let problem = Problem::parse("subject.rs", text).unwrap_or_else(|errors| panic!("{errors:?}"));
        let name = &problem.name;
        assert_eq!(
            (Symmetry::of_problem(&problem).order(), check(&problem).unwrap().solutions),
            (order, solutions),
            "{name}"
        );
        let found = candidates(&problem, &check(&problem).unwrap(), &SearchOptions::default(), &Unmonitored).unwrap();
        let best = &found.candidates[0];
        assert_eq!((best.plan.images.len() + 1, best.template.basis.len()), (order, solutions / order), "{name}");
        assert_counted(&problem, best, &SearchOptions::default());
        let measured = stability(&best.plan, 500, 1);
        assert_eq!(
            (measured.failures, measured.incomplete),
            (0, 0),
            "{name}: {} of {}",
            measured.found,
            measured.expected
        );
    }
}

/// Exchanges of unknowns become changes of sign.
const EXCHANGES: [Subject; 6] = [
    Subject {
        order: 2,
        solutions: 4,
        text: "fn two(a: [f64; 4]) -> (x, y) { x*y + a[0]*(x + y) == a[1]; x*x + y*y + a[2]*(x + y) == a[3]; }",
    },
    Subject {
        order: 2,
        solutions: 6,
        // The equations are exchanged, too.
        text: "fn apart(a: [f64; 3]) -> (x, y) { x*x*x + a[0]*y == a[1]*y*y + a[2]; y*y*y + a[0]*x == a[1]*x*x + a[2]; x - y != 0; }",
    },
    Subject {
        order: 2,
        solutions: 8,
        // x with -y, and z changes its sign.
        text: "fn signed(a: [f64; 6]) -> (x, y, z) { x*y + a[0]*(x - y) + z*z == a[1]; x*x + y*y + a[2]*z*(x + y) == a[3]; z*z + a[4]*z*(x + y) == a[5]; }",
    },
    Subject {
        order: 4,
        solutions: 16,
        // Two pairs, each by itself.
        text: "fn apiece(a: [f64; 6]) -> (x, y, z, w) { x*y + a[0]*z*w == a[1]; x + y + z + w == a[2]; x*x + y*y + a[3]*z*z + a[3]*w*w == a[4]; z*z*w*w + a[5]*z + a[5]*w == 1; }",
    },
    Subject {
        order: 2,
        solutions: 18,
        // Two pairs together, and no single one.
        text: "fn together(a: [f64; 4]) -> (x, y, z, w) { x*z + y*w == a[0]; x*y + a[1]*z + a[1]*w == 1; z*w + a[2]*x + a[2]*y == 1; x*w*w + y*z*z == a[3]; }",
    },
    Subject {
        order: 2,
        solutions: 4,
        // Factors are exchanged, and the sum is eliminated.
        text: "fn factors(a: [f64; 4]) -> (x, y, z) { x + y == a[0]; x*y*z + x*x + y*y == a[1]; z*z*x*y + a[2]*z == a[3]; x + a[0] != 0; y + a[0] != 0; }",
    },
];

#[test]
fn a_basis_of_the_solutions_up_to_exchanges_finds_all() {
    for Subject { order, solutions, text } in EXCHANGES {
        let problem = Problem::parse("subject.rs", text).unwrap_or_else(|errors| panic!("{errors:?}"));
        let (name, count) = (&problem.name, check(&problem).unwrap());
        let paired = presolve(&problem, Presolve::Paired);
        assert_eq!((paired.symmetry.order(), count.solutions), (order, solutions), "{name}");
        let found = candidates(&problem, &count, &SearchOptions::default(), &Unmonitored).unwrap();
        let best = &found.candidates[0];
        let sizes = (best.presolve, best.plan.images.len() + 1, best.template.basis.len());
        assert_eq!(sizes, (Presolve::Paired, order, solutions / order), "{name}");
        assert!(best.template.columns() >= count.least_columns(&problem), "{name}");
        assert_counted(&problem, best, &SearchOptions::default());
        let measured = stability(&best.plan, 500, 1);
        let of = (measured.found, measured.expected);
        assert_eq!((measured.failures, measured.incomplete), (0, 0), "{name}: {of:?}");
    }
}

/// Solutions with x = y are lost to a template up to exchanges: the choice measures that.
#[test]
fn solutions_that_an_exchange_does_not_move_are_not_lost() {
    for text in [
        "fn cubics(a: [f64; 3]) -> (x, y) { x*x*x + a[0]*y == a[1]*y*y + a[2]; y*y*y + a[0]*x == a[1]*x*x + a[2]; }",
        "fn reversed(a: [f64; 4]) -> (x, y, z, w) { x*x + a[0]*y*z == a[1]*w; w*w + a[0]*z*y == a[1]*x; y*y + a[2]*x == a[3]; z*z + a[2]*w == a[3]; }",
    ] {
        let problem = Problem::parse("fixed.rs", text).unwrap();
        assert!(!exchanged(&problem).is_empty(), "{}", problem.name);
        let options = SearchOptions::default();
        let found = candidates(&problem, &check(&problem).unwrap(), &options, &Unmonitored).unwrap();
        let measuring = Measuring { trials: 300, confirm: 1000, seed: 1 };
        let choice = choose(&found.candidates, options.prefer, measuring, &|_| None, &Unmonitored).unwrap();
        let chosen = &choice.measured[choice.chosen];
        let measured = stability(&chosen.candidate.plan, 500, 1);
        assert_eq!((measured.failures, measured.incomplete), (0, 0), "{}", problem.name);
    }
}

/// The origin is known beforehand, however often it counts: no template need give it, and signs can
/// be changed at all other solutions.
#[test]
fn the_origin_takes_no_basis_monomial() {
    for (text, [solutions, different, at_origin, basis]) in [
        // x and y change their signs together.
        ("fn odd(a: [f64; 4]) -> (x, y) { x*x*x + a[0]*x*y*y == a[1]*y; y*y*y + a[2]*x*x*y == a[3]*x; }", [9, 9, 1, 4]),
        (
            "fn conics(a: [f64; 5], b: [f64; 5]) -> (x, y) { dot(a, [x*x, x*y, y*y, x, y]) == 0; dot(b, [x*x, x*y, y*y, x, y]) == 0; }",
            [4, 4, 1, 3],
        ),
        (
            "fn cusps(a: [f64; 4]) -> (x, y) { a[0]*x*x + y*y == a[1]*x*y*y + x*x*y; x*y + y*y == a[2]*x*x*x + a[3]*y*y*y; }",
            [9, 6, 4, 5],
        ),
    ] {
        let problem = Problem::parse("origin.rs", text).unwrap();
        let algebra = check(&problem).unwrap();
        let counts = [algebra.solutions, algebra.different, algebra.at_origin];
        assert_eq!((problem.has_origin(), counts), (true, [solutions, different, at_origin]), "{}", problem.name);
        let found = candidates(&problem, &algebra, &SearchOptions::default(), &Unmonitored).unwrap();
        let best = &found.candidates[0];
        assert_eq!((best.plan.solutions, best.template.basis.len()), (different, basis), "{}", problem.name);
        assert_counted(&problem, best, &SearchOptions::default());
        let measured = stability(&best.plan, 500, 1);
        let of = (measured.found, measured.expected);
        assert_eq!((measured.failures, measured.incomplete), (0, 0), "{}: {of:?}", problem.name);
    }
    // Excluded, it is no solution.
    let text = "fn odd(a: [f64; 4]) -> (x, y) { x*x*x + a[0]*x*y*y == a[1]*y; y*y*y + a[2]*x*x*y == a[3]*x; x != 0; }";
    let problem = Problem::parse("odd.rs", text).unwrap();
    assert_eq!((problem.has_origin(), check(&problem).unwrap().solutions), (false, 8));
}

#[test]
fn a_template_that_claims_more_solutions_than_its_basis_gives_is_refused() {
    let problem = Problem::parse("axes.rs", SUBJECTS[0].text).unwrap();
    let options = SearchOptions::default();
    let found = candidates(&problem, &check(&problem).unwrap(), &options, &Unmonitored).unwrap();
    let mut file = found.candidates[0].to_file(&problem, &options);
    assert!(plan(&problem, &file).is_ok());
    file.solutions = 5;
    let error = plan(&problem, &file).unwrap_err();
    assert!(error.is_stale_template());
    assert!(error.to_string().contains("5 solutions, but its basis gives 4 at most"), "{error}");
}
