//! Complex data and unknowns: what they stand for, and the solutions of problems posed with them.

#![cfg(feature = "search")]

use eliminant::Complex;
use eliminant_generator::algebra::{PRIMES, PrimeField, Random};
use eliminant_generator::check::check;
use eliminant_generator::generate::plan;
use eliminant_generator::problem::draw::draw_inputs;
use eliminant_generator::problem::{DataAttribute, Problem};
use eliminant_generator::search::measuring::interpreted::InterpretedSolver;
use eliminant_generator::template::file::TemplateFile;

const LINKAGE: [&str; 2] = [
    include_str!("../../examples/own-library/problems/linkage_5_poses.rs"),
    include_str!("../../examples/own-library/problems/linkage_5_poses.template.toml"),
];

fn parsed(text: &str) -> Problem {
    Problem::parse("test.rs", text).unwrap_or_else(|messages| panic!("{}", messages.render()))
}

/// The values of all equations over Z_p, at random data and a random point.
fn residuals(text: &str) -> Vec<u32> {
    const FIELD: PrimeField = PrimeField::new(PRIMES[0]);
    let problem = parsed(text);
    let mut random = Random::new(7);
    // Half of all data have a square root.
    let drawn = (0..100).find_map(|_| {
        let data = draw_inputs(&problem.data, FIELD, &mut random);
        problem.graph.evaluate(FIELD, &data)
    });
    let nodes = drawn.expect("data with all square roots");
    let point: Vec<u32> = problem.unknowns.iter().map(|_| FIELD.reduce(random.bits())).collect();
    let values = problem.polynomials().map(|polynomial| {
        polynomial.terms().iter().fold(0, |sum, (monomial, coefficient)| {
            let powers = point.iter().zip(monomial.exponents());
            let term = powers.fold(nodes[coefficient.index()], |product, (&x, &e)| {
                FIELD.mul(product, FIELD.pow(x, u32::from(e.unsigned_abs())))
            });
            FIELD.add(sum, term)
        })
    });
    values.collect()
}

/// Problems whose data and unknowns have the same places: complex ones, and real ones with the real
/// and the imaginary part of each equation written out.
#[test]
fn complex_equations_are_those_of_their_parts() {
    let parameters = ["a: Complex<f64>, m: [[Complex<f64>; 2]; 2]", "a: [f64; 2], m: [[[f64; 2]; 2]; 2]"];
    let unknowns = ["z: Complex<f64>, w: [Complex<f64>; 2]", "z: [f64; 2], w: [[f64; 2]; 2]"];
    let helpers = "
        fn times(u: [f64; 2], v: [f64; 2]) -> [f64; 2] { [u[0] * v[0] - u[1] * v[1], u[0] * v[1] + u[1] * v[0]] }
        fn bar(u: [f64; 2]) -> [f64; 2] { [u[0], -u[1]] }
        fn square(u: [f64; 2]) -> f64 { dot(u, u) }
        fn over(u: [f64; 2], v: [f64; 2]) -> [f64; 2] { times(u, bar(v)) * (1 / square(v)) }
        fn complex_det(m: [[[f64; 2]; 2]; 2]) -> [f64; 2] { times(m[0][0], m[1][1]) - times(m[0][1], m[1][0]) }";
    let cases = [
        ("z * w[0] == a;", "times(z, w[0]) == a;"),
        ("z.pow(3) == a * conj(z);", "times(z, times(z, z)) == times(a, bar(z));"),
        ("m * w == [a, z];", "times(m[0][0], w[0]) + times(m[0][1], w[1]) == a; times(m[1][0], w[0]) + times(m[1][1], w[1]) == z;"),
        ("dot(w, m[0]) == z.re;", "times(w[0], m[0][0]) + times(w[1], m[0][1]) == [z[0], 0];"),
        ("det(m) * z == w[1];", "times(complex_det(m), z) == w[1];"),
        ("z / a + 1 / (a * m[0][0]) == w[0];", "over(z, a) + over([1, 0], times(a, m[0][0])) == w[0];"),
        ("z * conj(z) == a.im; z.re * w[0].im == 2;", "square(z) == a[1]; z[0] * w[0][1] == 2;"),
        ("complex(z.im, a.re) * w[1] == complex(0, 1);", "times([z[1], a[0]], w[1]) == [0, 1];"),
        ("norm([a, m[0][1]]) * z == w[0];", "sqrt(square(a) + square(m[0][1])) * z == w[0];"),
        // x = inverse(m) [a, 1] by Cramer's rule.
        (
            "let x = solve(m, [a, complex(1, 0)]); x * z == w;",
            "let x = over(times(a, m[1][1]) - m[0][1], complex_det(m)); let y = over(m[0][0] - times(a, m[1][0]), complex_det(m));
             times(x, z) == w[0]; times(y, z) == w[1];",
        ),
        (
            "inverse(m)[1] * z == w;",
            "let f = over(z, complex_det(m)); -times(f, m[1][0]) == w[0]; times(f, m[0][0]) == w[1];",
        ),
    ];
    // Every problem needs enough equations, and reads all data and unknowns.
    let rest = [
        "z * a + w[0] * w[1] == m[0][1]; w[0] * m[0][0] == m[1][0] * w[1] + m[1][1];",
        "times(z, a) + times(w[0], w[1]) == m[0][1]; times(w[0], m[0][0]) == times(m[1][0], w[1]) + m[1][1];",
    ];
    for (complex, real) in cases {
        let [complex, real] = [(0, complex, ""), (1, real, helpers)].map(|(at, statements, helpers)| {
            let (parameters, unknowns, rest) = (parameters[at], unknowns[at], rest[at]);
            residuals(&format!("fn p({parameters}) -> ({unknowns}) {{ {statements} {rest} {rest} }} {helpers}"))
        });
        assert_eq!(complex, real);
    }
}

#[test]
fn parts_have_names() {
    let problem = parsed(
        "fn p(a: [Complex<f64>; 2], #[unit] turn: Complex<f64>) -> (z: Complex<f64>, w: [Complex<f64>; 1]) {
            z * w[0] == a[0]; turn * z == a[1] * w[0];
        }",
    );
    assert_eq!(problem.unknowns, ["z.re", "z.im", "w[0].re", "w[0].im"]);
    assert_eq!((&problem.data[0].shape[..], problem.data[0].is_complex), (&[2, 2][..], true));
    assert_eq!((problem.data[1].attribute, problem.data[1].is_number()), (DataAttribute::Unit, true));
}

/// 15 unknowns beside i, whatever brings it.
#[test]
fn there_is_room_for_15_unknowns() {
    let problem = |count: usize, constant: &str, body: &str| {
        let unknowns: Vec<String> = (0..count).map(|k| format!("x{k}")).collect();
        let equations: String = unknowns.iter().map(|x| format!("{x} * {x} == a + {body};")).collect();
        Problem::parse("test.rs", &format!("{constant} fn p(a: f64) -> ({}) {{ {equations} }}", unknowns.join(", ")))
    };
    for (constant, body) in
        [("", "(complex(0, 1) * complex(0, 1)).re"), ("const I: f64 = complex(0, 1);", "(I * I).re")]
    {
        assert_eq!(problem(15, constant, body).map(|problem| problem.equations.len()).ok(), Some(15));
        let refused = problem(16, constant, body).expect_err("no room").render();
        assert!(refused.contains("there is no room for complex numbers"), "{refused}");
    }
    assert!(problem(16, "", "1").is_ok());
}

/// A holomorphic problem: its solutions, and their combinations with conjugates of others.
#[test]
fn solutions_are_counted_with_their_conjugates() {
    let quadratic =
        parsed("fn roots(b: Complex<f64>, c: Complex<f64>) -> z: Complex<f64> { z.pow(2) + b * z + c == 0; }");
    assert_eq!(check(&quadratic).expect("finitely many").solutions, 4);
    let excluded = parsed("fn roots(b: Complex<f64>) -> z: Complex<f64> { z.pow(2) + b * z == 0; z != 0; }");
    assert_eq!(check(&excluded).expect("finitely many").solutions, 1);
    assert_eq!(check(&parsed(LINKAGE[0])).expect("finitely many").solutions, 4);
}

/// A bar that passes through five poses is found, for 1000 linkages.
#[test]
fn a_linkage_is_found() {
    let problem = parsed(LINKAGE[0]);
    let file = TemplateFile::parse(LINKAGE[1], &problem.unknowns).expect("a template");
    let solver = InterpretedSolver::of(&plan(&problem, &file).unwrap_or_else(|error| panic!("{error}")).plan);
    let mut random = Random::new(29);
    let mut point = || Complex::new(random.symmetric_unit(), random.symmetric_unit());
    for instance in 0..1000 {
        let [on_body, on_frame] = [point(), point()];
        let poses: Vec<[Complex<f64>; 2]> = (0..4)
            .map(|_| {
                let turn = Complex::from_polar(1.0, 3.0 * point().re);
                let bar = (on_body - on_frame) * Complex::from_polar(1.0, 3.0 * point().re);
                [turn, on_frame + bar - turn * on_body]
            })
            .collect();
        let data: Vec<f64> =
            [0, 1].iter().flat_map(|&k| poses.iter().map(move |pose| pose[k])).flat_map(|z| [z.re, z.im]).collect();
        let found = solver.solve(&data).expect("general data");
        let truth = [on_body.re, on_body.im, on_frame.re, on_frame.im];
        let error = |point: &Vec<f64>| point.iter().zip(truth).map(|(x, t)| (x - t).abs()).fold(0.0, f64::max);
        let best = found.iter().map(error).fold(f64::INFINITY, f64::min);
        assert!(best < 1e-6, "instance {instance}: {best:e}");
    }
}
