//! Unknowns that occur linearly are eliminated by determinants, and all solutions are found.
#![cfg(feature = "oracle")]

use eliminant_generator::check::check;
use eliminant_generator::oracle::Truths;
use eliminant_generator::presolve::Presolve;
use eliminant_generator::problem::Problem;
use eliminant_generator::search::choose::{Measuring, Verdict, choose};
use eliminant_generator::search::measuring::interpreted::InterpretedSolver;
use eliminant_generator::search::measuring::random_instance;
use eliminant_generator::search::monitor::Unmonitored;
use eliminant_generator::search::{SearchOptions, candidates};

/// Relative pose of two rigs with a known vertical direction: the translation is linear.
const RIGS: &str = "fn rigs(a: [[f64; 6]; 4], b: [[f64; 6]; 4]) -> (s, t: [f64; 3]) {
    let r = [[1 - s * s, 0, 2 * s], [0, 1 + s * s, 0], [-2 * s, 0, 1 - s * s]];
    for k in 0..4 {
        let q = r * [a[k][0], a[k][1], a[k][2]];
        let [u, v] = [[b[k][0], b[k][1], b[k][2]], [b[k][3], b[k][4], b[k][5]]];
        dot(u, cross(t, q)) + dot(u, r * [a[k][3], a[k][4], a[k][5]]) + dot(v, q) == 0;
    }
    1 + s * s != 0;
}";

/// Relative pose with a known vertical direction and an unknown focal length. The signs of `s` and
/// `w`, `a` and `b` change together.
const FOCAL: &str = "fn focal(x: [[f64; 2]; 4], y: [[f64; 2]; 4]) -> (s, w, a, b) {
    let r = [[1 - s * s, 0, 2 * s], [0, 1 + s * s, 0], [-2 * s, 0, 1 - s * s]];
    for k in 0..4 {
        let [p, q] = [[x[k][0], x[k][1], w], [y[k][0], y[k][1], w]];
        dot(q, cross([a, b, 1], r * p)) == 0;
    }
    w != 0;
    1 + s * s != 0;
}";

/// Relative pose with a known angle of rotation, cosine and sine of its half given: four points.
const ANGLE: &str = "fn angle(p: [[f64; 3]; 4], q: [[f64; 3]; 4], #[unit] half: [f64; 2]) -> (
    x, y, z, #[projective] t: [f64; 3],
) {
    let c = half[0];
    let r = [
        [c * c + x * x - y * y - z * z, 2 * (x * y - c * z), 2 * (x * z + c * y)],
        [2 * (x * y + c * z), c * c - x * x + y * y - z * z, 2 * (y * z - c * x)],
        [2 * (x * z - c * y), 2 * (y * z + c * x), c * c - x * x - y * y + z * z],
    ];
    for k in 0..4 {
        dot(q[k], cross(t, r * p[k])) == 0;
    }
    x * x + y * y + z * z == half[1] * half[1];
}";

/// The chosen template is by determinants, has these rows, columns and basis monomials, and gives
/// all solutions that the oracle finds.
fn solves(text: &str, solutions: usize, size: (usize, usize, usize)) {
    let problem = Problem::parse("problem.rs", text).unwrap_or_else(|messages| panic!("{}", messages.render()));
    let count = check(&problem).expect("finitely many solutions");
    assert_eq!(count.different, solutions);
    let options = SearchOptions { shuffles: 0, max_columns: 60, max_basis: Some(20), ..SearchOptions::default() };
    let found = candidates(&problem, &count, &options, &Unmonitored).expect("templates");
    let measuring = Measuring { trials: 300, confirm: 1000, seed: 1 };
    let choice = choose(&found.candidates, options.prefer, measuring, &|_| None, &Unmonitored).expect("a candidate");
    let best = &choice.measured[choice.chosen];
    assert_eq!((best.verdict, best.stability.incomplete), (Verdict::Accepted, 0));
    let template = &best.candidate.template;
    assert!(matches!(best.candidate.presolve, Presolve::Determinants(_)));
    assert_eq!((template.rows(), template.columns(), template.basis.len()), size);
    let solver = InterpretedSolver::of(&best.candidate.plan);
    for k in 0..100 {
        let data = random_instance(&best.candidate.plan, 1, k);
        let returned = solver.solve_complex(&data).expect("no error");
        assert_eq!(returned.len(), solutions, "{k}");
        let judged = Truths::of(&best.candidate.plan, &data, &returned).expect("finite coefficients");
        assert!(judged.is_complete() && judged.judge(&returned, false).spurious == 0, "{k}: {returned:?}");
    }
}

#[test]
fn one_minor_leaves_one_unknown() {
    solves(RIGS, 6, (1, 7, 6));
}

#[test]
fn several_minors_leave_two_unknowns_that_change_signs() {
    solves(FOCAL, 10, (4, 9, 5));
}

/// The size of the template for the form that Martyushev and Li reduced by hand, which is that of
/// `relpose_4pt_angle`.
#[test]
fn minors_are_divided_by_an_equation_that_gives_a_square() {
    solves(ANGLE, 20, (16, 36, 20));
}
