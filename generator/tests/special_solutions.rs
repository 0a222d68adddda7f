//! Solutions at which unknowns are 0, or share the values of other solutions, are found with the
//! others.
#![cfg(feature = "oracle")]

use eliminant::emitted::vector_of;
use eliminant_generator::algebra::Random;
use eliminant_generator::check::check;
use eliminant_generator::generate::plan;
use eliminant_generator::oracle::Truths;
use eliminant_generator::presolve::Presolve;
use eliminant_generator::problem::Problem;
use eliminant_generator::search::choose::{Choice, Measured, Measuring, Verdict, choose};
use eliminant_generator::search::measuring::interpreted::InterpretedSolver;
use eliminant_generator::search::measuring::random_instance;
use eliminant_generator::search::monitor::Unmonitored;
use eliminant_generator::search::{Found, SearchOptions, candidates, traced_candidates};
use eliminant_generator::template::file::TemplateFile;

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

/// A point at given distances from three known points. The two differences of its equations give x
/// and y, if the known points are not in certain planes.
const TRILATERATION: &str = include_str!("../../templates/trilateration.rs");

/// Two cameras with the same vertical, from an affine correspondence. There is a template without
/// quotients from which t\[1\]^2 is read as s t\[1\]^2 / s: 0 / 0 without a turn.
const AFFINE: &str = "fn affine(x1: [f64; 2], x2: [f64; 2], a: [[f64; 2]; 2]) -> (c, s, t: [f64; 3]) {
    let e = skew(t) * [[c, 0, s], [0, 1, 0], [-s, 0, c]];
    let [first, second] = [concat(x1, 1), concat(x2, 1)];
    c * c + s * s == 1;
    dot(t, t) == 1;
    dot(second, e * first) == 0;
    (e.t() * second)[0..2] + a.t() * (e * first)[0..2] == 0;
}";

/// The points of two conics, up to scale.
const CONICS: &str = "fn conics(c: [[[f64; 3]; 3]; 2]) -> (#[projective] x: [f64; 3]) {
    for k in 0..2 {
        dot(x, c[k] * x) == 0;
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
    let plan =
        &accepted.find(|measured| measured.candidate.plan.zeros.lacks_pairs).expect("one by 1/s^2").candidate.plan;
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

/// All templates of a problem that are accepted.
fn accepted(text: &str) -> Vec<Measured> {
    let problem = Problem::parse("problem.rs", text).unwrap_or_else(|messages| panic!("{}", messages.render()));
    let count = check(&problem).expect("finitely many solutions");
    let options = SearchOptions { shuffles: 0, ..SearchOptions::default() };
    let found = candidates(&problem, &count, &options, &Unmonitored).expect("templates");
    let measured = chosen(&found, &options).measured;
    measured.into_iter().filter(|measured| measured.verdict != Verdict::Rejected).collect()
}

/// Presolve divides by a difference of coordinates, which is 0, or 0 up to rounding, where known
/// points lie on axes or in planes.
#[test]
fn solutions_are_found_where_presolve_divides_by_zero() {
    let mut templates = accepted(TRILATERATION);
    templates.retain(|measured| !measured.candidate.plan.quotients().is_empty());
    assert!(!templates.is_empty(), "a template with quotients");
    let layouts = [
        [[0.0, 0.0, 1.0], [0.0, 3.0, 0.0], [4.0, 0.0, 0.0]],
        [[0.0, 0.0, 0.0], [0.0, 3.0, 0.0], [4.0, 0.0, 0.0]],
        [[0.0, 0.0, 1.0], [4.0, 0.0, 0.0], [0.0, 3.0, 0.0]],
        [[0.0, 1.0, 2.0], [0.0, -1.0, 0.5], [0.0, 0.3, -1.0]],
    ];
    for template in &templates {
        let (solver, mut random) = (InterpretedSolver::of(&template.candidate.plan), Random::new(2));
        for (layout, noise) in layouts
            .iter()
            .flat_map(|layout| [0.0, 1e-300, 1e-30, 1e-17, 1e-12, 1e-8, 1e-5].map(|noise| (layout, noise)))
        {
            for _ in 0..10 {
                let centres =
                    layout.map(|centre| centre.map(|x| if x == 0.0 { noise * random.symmetric_unit() } else { x }));
                let point: [f64; 3] = std::array::from_fn(|_| 2.0 * random.symmetric_unit());
                let distance =
                    |centre: &[f64; 3]| centre.iter().zip(point).map(|(c, x)| (c - x) * (c - x)).sum::<f64>().sqrt();
                let data = [centres.concat(), centres.iter().map(distance).collect()].concat();
                let found = solver.solve(&data).unwrap_or_else(|error| panic!("{data:?}: {error}"));
                let is_truth = |x: &Vec<f64>| x.iter().zip(point).all(|(x, truth)| (x - truth).abs() < 1e-7);
                assert!(found.len() == 2 && found.iter().any(is_truth), "no {point:?} among {found:?} of {data:?}");
            }
        }
    }
}

/// Without a turn one unknown vanishes, and another one is the ratio of zeros.
#[test]
fn solutions_are_found_where_an_unknown_cannot_be_read() {
    let mut templates = accepted(AFFINE);
    templates.retain(|measured| measured.candidate.plan.zeros.is_misread);
    assert!(!templates.is_empty(), "a template that misreads zeros");
    for template in &templates {
        let (solver, mut random) = (InterpretedSolver::of(&template.candidate.plan), Random::new(3));
        for instance in 0..100 {
            let mut number = || random.symmetric_unit();
            let (x1, t) = ([number(), number()], [number(), number(), number()]);
            let length = t.iter().map(|x| x * x).sum::<f64>().sqrt();
            // A plane n x = 1, with a depth of about 3, and the second camera moved by t.
            let n = [0.1 * number(), 0.1 * number(), 0.33];
            let depth = 1.0 / (n[0] * x1[0] + n[1] * x1[1] + n[2]);
            let moved = [depth * x1[0] + t[0], depth * x1[1] + t[1], depth + t[2]];
            let x2 = [moved[0] / moved[2], moved[1] / moved[2]];
            // The derivatives of x2 by x1: the depth changes by -depth^2 n.
            let a = |i: usize, j: usize| {
                let change = -depth * depth * n[j];
                let of_image = x1[i] * change + if i == j { depth } else { 0.0 };
                (of_image - x2[i] * change) / moved[2]
            };
            let data = [x1[0], x1[1], x2[0], x2[1], a(0, 0), a(0, 1), a(1, 0), a(1, 1)];
            let found = solver.solve(&data).unwrap_or_else(|error| panic!("{data:?}: {error}"));
            let is_truth = |x: &Vec<f64>| {
                let turn = (x[0] - 1.0).abs().max(x[1].abs());
                (0..3).fold(turn, |worst, k| worst.max((x[2 + k] - t[k] / length).abs())) < 1e-6
            };
            assert!(found.iter().any(is_truth), "{instance}: no {t:?} among {found:?} of {data:?}");
        }
    }
}

/// A camera that is not turned: six of nine unknowns are zero, and so are all terms of some
/// equations at the end of a path.
#[test]
fn paths_end_where_many_unknowns_vanish() {
    let problem = Problem::parse("problem.rs", include_str!("raw/upright_pose.rs"));
    let problem = problem.unwrap_or_else(|messages| panic!("{}", messages.render()));
    let template = TemplateFile::parse(include_str!("raw/upright_pose.template.toml"), &problem.unknowns);
    let planned = plan(&problem, &template.expect("a template")).expect("it belongs to the problem");
    assert!(!planned.plan.quotients().is_empty());
    let (solver, mut random) = (InterpretedSolver::of(&planned.plan), Random::new(4));
    for instance in 0..60 {
        let points: [f64; 6] = std::array::from_fn(|_| random.symmetric_unit());
        let rays = points.chunks(3).flat_map(|x| [x[0] / (x[2] + 6.0), x[1] / (x[2] + 6.0), 1.0]);
        let data: Vec<f64> = rays.chain(points).chain([0.0, 0.0, 1.0]).collect();
        let found = solver.solve(&data).unwrap_or_else(|error| panic!("{instance}: {error}"));
        let truth = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 6.0];
        let is_truth = |x: &Vec<f64>| x.iter().zip(truth).all(|(x, truth)| (x - truth).abs() < 1e-7);
        assert!(found.iter().any(is_truth), "{instance}: {found:?}");
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

/// A coordinate of a vector up to scale is 0 in a chart that is general: an action monomial with
/// its reciprocal, or a basis whose monomials all hold it, loses nothing.
#[test]
fn vectors_up_to_scale_may_have_zeros() {
    let templates = accepted(CONICS);
    let divides = |measured: &Measured| {
        let template = &measured.candidate.template;
        (0..3).any(|x| template.action.exponent(x) < 0 || template.basis.iter().all(|m| m.exponent(x) > 0))
    };
    assert!(templates.iter().any(divides), "a template that divides by a coordinate");
    for template in &templates {
        let plan = &template.candidate.plan;
        assert!(!plan.zeros.lacks_pairs && !plan.zeros.is_misread);
        let chart = plan.fields[0].chart().expect("a vector up to scale");
        let (solver, mut random) = (InterpretedSolver::of(plan), Random::new(4));
        for truth in [[0.0, 0.6, 0.8], [0.6, 0.0, 0.8], [0.6, 0.8, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]] {
            let mut conic = || {
                let mut c: [[f64; 3]; 3] = std::array::from_fn(|_| std::array::from_fn(|_| random.symmetric_unit()));
                let at_truth: f64 = (0..9).map(|k| c[k / 3][k % 3] * truth[k / 3] * truth[k % 3]).sum();
                // The truth has length 1.
                (0..3).for_each(|k| c[k][k] -= at_truth);
                c.concat()
            };
            for instance in 0..20 {
                let found = solver.solve(&[conic(), conic()].concat()).expect("no error");
                let is_truth = |coordinates: &Vec<f64>| {
                    let mut x = [0.0; 3];
                    vector_of(&chart, coordinates, &mut x);
                    let product: f64 = x.iter().zip(truth).map(|(x, truth)| x * truth).sum();
                    x.iter().zip(truth).all(|(x, truth)| (x - product * truth).abs() < 1e-9)
                };
                assert!(found.iter().any(is_truth), "{instance}: no {truth:?} among {found:?}");
            }
        }
    }
}
