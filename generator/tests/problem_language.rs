//! The equations that problem files stand for, compared over Z_p with formulas written out by hand.

use eliminant_generator::algebra::Random;
use eliminant_generator::algebra::{PRIMES, PrimeField};
use eliminant_generator::expression::{Expression, ExpressionId, SymbolicPolynomial};
use eliminant_generator::problem::draw::draw_inputs;
use eliminant_generator::problem::instance::Instance;
use eliminant_generator::problem::output::Output;
use eliminant_generator::problem::{DataAttribute, Problem};

const FIELD: PrimeField = PrimeField::new(PRIMES[0]);

/// A problem at random data and a random point.
struct Sample {
    problem: Problem,
    /// The values of all inputs.
    data: Vec<u32>,
    /// The values of the unknowns.
    point: Vec<u32>,
    nodes: Vec<u32>,
}

impl Sample {
    fn new(text: &str) -> Self {
        let problem = Problem::parse("test.rs", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        let mut random = Random::new(7);
        let data = draw_inputs(&problem.data, FIELD, &mut random);
        let point = problem.unknowns.iter().map(|_| FIELD.reduce(random.bits())).collect();
        let nodes = problem.graph.evaluate(FIELD, &data).unwrap();
        Self { problem, data, point, nodes }
    }

    fn value(&self, polynomial: &SymbolicPolynomial) -> u32 {
        polynomial.terms().iter().fold(0, |sum, (monomial, coefficient)| {
            let powers = self.point.iter().zip(monomial.exponents());
            let term = powers.fold(self.nodes[coefficient.index()], |product, (&x, &e)| {
                FIELD.mul(product, FIELD.pow(x, u32::from(e.unsigned_abs())))
            });
            FIELD.add(sum, term)
        })
    }

    /// The value of a node that may depend on the solution.
    fn result(&self, id: ExpressionId) -> Z {
        let of = |id| self.result(id);
        match self.problem.graph.node(id) {
            Expression::Unknown(number) => Z(self.point[number as usize]),
            Expression::Add(a, b) => of(a) + of(b),
            Expression::Subtract(a, b) => of(a) - of(b),
            Expression::Multiply(a, b) => of(a) * of(b),
            Expression::Divide(a, b) => over(of(a), of(b)),
            Expression::Negate(a) => Z(0) - of(a),
            _ => Z(self.nodes[id.index()]),
        }
    }

    /// The values of the equations, left - right.
    fn residuals(&self) -> Vec<u32> {
        self.problem.equations.iter().map(|equation| self.value(&equation.polynomial)).collect()
    }

    /// The elements that the equations come from.
    fn elements(&self) -> Vec<&str> {
        self.problem.equations.iter().map(|equation| equation.element.as_str()).collect()
    }

    fn input(&self, parameter: &str, index: usize) -> Z {
        let parameter = self.problem.data.iter().find(|data| data.name == parameter).unwrap();
        Z(self.data[parameter.first_input + index])
    }

    fn unknown(&self, name: &str) -> Z {
        Z(self.point[self.problem.unknowns.iter().position(|unknown| unknown == name).unwrap()])
    }
}

/// An element of Z_p with operators.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Z(u32);

impl std::ops::Add for Z {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(FIELD.add(self.0, other.0))
    }
}

impl std::ops::Sub for Z {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(FIELD.sub(self.0, other.0))
    }
}

impl std::ops::Mul for Z {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(FIELD.mul(self.0, other.0))
    }
}

fn z(value: i64) -> Z {
    Z(FIELD.from_integer(value))
}

type Matrix = [[Z; 3]; 3];

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let entry = |i: usize, j: usize| (0..3).fold(z(0), |sum, k| sum + a[i][k] * b[k][j]);
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
}

fn transpose(a: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

fn det(m: &Matrix) -> Z {
    m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
        + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
}

#[test]
fn parts_of_arrays_and_arrays_joined() {
    let sample = Sample::new(
        "fn parts(a: [f64; 5], m: [[f64; 2]; 3]) -> (x, y) {
    concat(a[0..2], x) == concat([y, x], a[2..=2]);
    x * m[0..2][1][..1] == concat(concat(x, y), a[4])[2..];
    y * concat(m[1..], [x, y]) == x * [m[0], m[0], m[2]];
    a[3] * x == a[3] * y + 1;
}
",
    );
    let (x, y) = (sample.unknown("x"), sample.unknown("y"));
    let (a, m) = (|k: usize| sample.input("a", k), |i: usize, j: usize| sample.input("m", 2 * i + j));
    let wanted = [
        a(0) - y,
        a(1) - x,
        x - a(2),
        x * m(1, 0) - a(4),
        // Rows m1, m2, (x, y) and m0, m0, m2.
        y * m(1, 0) - x * m(0, 0),
        y * m(1, 1) - x * m(0, 1),
        y * m(2, 0) - x * m(0, 0),
        y * m(2, 1) - x * m(0, 1),
        y * x - x * m(2, 0),
        y * y - x * m(2, 1),
        a(3) * x - a(3) * y - z(1),
    ];
    assert_eq!(sample.residuals(), wanted.map(|Z(value)| value));
}

#[test]
fn conditions_on_constants_choose_statements_and_values() {
    let sample = Sample::new(
        "const LAST: f64 = 3;
fn chosen(a: [f64; 4]) -> (x, y) {
    for k in 0..=LAST {
        let sign = if k % 2 == 0 { 1 } else { -1 };
        if k < 1 || (k > 2.5 && !(k != LAST)) {
            x * x + sign * a[k] * y == k;
        } else if k == 1 {
            x * y + sign * a[k] == if true && k >= 1 { 7 } else { 8 };
        }
    }
}
",
    );
    let (x, y) = (sample.unknown("x"), sample.unknown("y"));
    let a = |k| sample.input("a", k);
    let wanted = [x * x + a(0) * y, x * y - a(1) - z(7), x * x - a(3) * y - z(3)];
    assert_eq!(sample.residuals(), wanted.map(|Z(value)| value));
}

#[test]
fn circle_least_squares_is_the_lagrangian_of_the_paper() {
    let sample = Sample::new(
        "/// Circle tangent to n lines in the least-squares sense (constrained dual conic).
///
///   Indented.
fn circle_least_squares(#[symmetric] gram: [[f64; 6]; 6]) -> (d1, d2, d3, d4, d5, lambda1, lambda2) {
    let d6 = -1;
    let d = [d1, 2 * d2, 2 * d3, d4, 2 * d5, d6];
    let cost = dot(d, gram * d);
    let lagrangian = cost
        + lambda1 * (d3 * d5 - d2 * d6)
        + lambda2 * (d5 * d5 - d3 * d3 + d1 * d6 - d4 * d6);
    gradient(lagrangian) == 0;
}
",
    );
    let problem = &sample.problem;
    assert_eq!(problem.name, "circle_least_squares");
    assert_eq!(
        problem.docs[..2],
        ["Circle tangent to n lines in the least-squares sense (constrained dual conic).", ""]
    );
    assert_eq!(problem.docs[2], "  Indented.");
    assert_eq!(problem.unknowns, ["d1", "d2", "d3", "d4", "d5", "lambda1", "lambda2"]);
    assert_eq!((problem.data[0].name.as_str(), &problem.data[0].shape[..]), ("gram", &[6, 6][..]));
    assert_eq!(problem.data[0].attribute, DataAttribute::Symmetric);
    assert_eq!(&problem.source.text[problem.span.clone()], "(d1, d2, d3, d4, d5, lambda1, lambda2)");
    assert_eq!(&problem.source.text[problem.equations[0].span.clone()], "gradient(lagrangian) == 0");
    assert_eq!(sample.elements(), ["[0]", "[1]", "[2]", "[3]", "[4]", "[5]", "[6]"]);

    let [d1, d2, d3, d4, d5, l1, l2] = std::array::from_fn(|i| Z(sample.point[i]));
    let two = z(2);
    let d = [d1, two * d2, two * d3, d4, two * d5, z(-1)];
    // Half the gradient of the cost by its six arguments.
    let g: [Z; 6] = std::array::from_fn(|i| (0..6).fold(z(0), |sum, j| sum + sample.input("gram", 6 * i + j) * d[j]));
    let four = z(4);
    let expected = [
        two * g[0] - l2,
        four * g[1] + l1,
        four * g[2] + l1 * d5 - two * l2 * d3,
        two * g[3] + l2,
        four * g[4] + l1 * d3 + two * l2 * d5,
        d3 * d5 + d2,
        d5 * d5 - d3 * d3 - d1 + d4,
    ];
    assert_eq!(sample.residuals(), expected.map(|value| value.0));
}

#[test]
fn five_point_relative_pose_is_the_essential_matrix_constraints() {
    let sample = Sample::new(
        "fn relpose_5pt(basis: [[[f64; 3]; 3]; 4]) -> (x, y, z) {
            let e = x * basis[0] + y * basis[1] + z * basis[2] + basis[3];
            det(e) == 0;
            2 * e * e.t() * e - trace(e * e.t()) * e == 0;
        }",
    );
    let coefficients = [sample.unknown("x"), sample.unknown("y"), sample.unknown("z"), z(1)];
    let entry = |i: usize, j: usize| {
        (0..4).fold(z(0), |sum, k| sum + coefficients[k] * sample.input("basis", 9 * k + 3 * i + j))
    };
    let e: Matrix = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
    let eet = product(&e, &transpose(&e));
    let trace = eet[0][0] + eet[1][1] + eet[2][2];
    let eete = product(&eet, &e);
    let mut expected = vec![det(&e).0];
    for i in 0..3 {
        for j in 0..3 {
            expected.push((z(2) * eete[i][j] - trace * e[i][j]).0);
        }
    }
    assert_eq!(sample.residuals(), expected);
    assert_eq!(sample.elements()[..3], ["", "[0][0]", "[0][1]"]);
}

#[test]
fn helpers_loops_constants_and_assignments() {
    let sample = Sample::new(
        "const N: usize = 3;
        const WEIGHTS: [f64; N] = [0.5, 1.25e0, -2];

        fn square(v: [_; N]) -> _ {
            let mut sum = 0;
            for entry in v {
                sum += entry * entry;
            }
            sum
        }

        fn shifted(v: [f64; N], by: f64) -> [f64; N] {
            let mut result = [0; N];
            for i in 0..=N - 1 {
                result[(i + 1) % N] = v[i] + by;
            }
            result
        }

        fn spheres(#[unit] n: [[f64; N]; 2], a: f64) -> (x, y, z) {
            let p = [x, y, z];
            let mut total = 1 / 3 * a;
            for i in 0..N {
                let q = WEIGHTS[i] * p[i];
                total += q;
                total -= i * a / 4;
                total *= 2;
            }
            let [first, second] = n;
            total == { let s = square(p); s.pow(2) };
            dot(shifted(p, a), first) == 1;
            p * [[1, 2], [3, 4], [5, 6]] == [0, a];
            for row in n { dot(cross(row, second), p) * x - y != 0; }
        }",
    );
    let p = ["x", "y", "z"].map(|name| sample.unknown(name));
    let a = sample.input("a", 0);
    let inverse = |n: i64| Z(FIELD.inverse(FIELD.from_integer(n)).unwrap());
    let weights = [inverse(2), z(5) * inverse(4), z(-2)];
    let mut total = inverse(3) * a;
    for i in 0..3 {
        total = (total + weights[i] * p[i] - z(i as i64) * a * inverse(4)) * z(2);
    }
    let square = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
    let n = |i: usize| sample.input("n", i);
    let expected = [
        total - square * square,
        (p[2] + a) * n(0) + (p[0] + a) * n(1) + (p[1] + a) * n(2) - z(1),
        p[0] + z(3) * p[1] + z(5) * p[2],
        z(2) * p[0] + z(4) * p[1] + z(6) * p[2] - a,
    ];
    assert_eq!(sample.residuals(), expected.map(|value| value.0));

    let cross =
        |u: [Z; 3], v: [Z; 3]| [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let c = cross([n(0), n(1), n(2)], [n(3), n(4), n(5)]);
    let volume = (c[0] * p[0] + c[1] * p[1] + c[2] * p[2]) * p[0] - p[1];
    let nonzero: Vec<u32> = sample.problem.nonzero.iter().map(|factor| sample.value(&factor.polynomial)).collect();
    assert_eq!(nonzero, [volume.0, (z(0) - p[1]).0]);
}

#[test]
fn determinants_of_all_sizes_match_the_vandermonde_product() {
    for n in 1..=6usize {
        let rows: Vec<String> = (0..n)
            .map(|i| format!("[{}]", (0..n).map(|j| format!("v[{i}].pow({j})")).collect::<Vec<_>>().join(", ")))
            .collect();
        let text = format!("fn vandermonde(v: [f64; {n}]) -> x {{ det([{}]) * x == v[0]; }}", rows.join(", "));
        let sample = Sample::new(&text);
        let mut expected = sample.unknown("x");
        for i in 0..n {
            for j in 0..i {
                expected = expected * (sample.input("v", i) - sample.input("v", j));
            }
        }
        assert_eq!(sample.residuals(), [(expected - sample.input("v", 0)).0], "{n}x{n}");
    }
}

#[test]
fn attributes_make_relations_hold_identically() {
    let sample = Sample::new(
        "fn rotated(
            #[rotation] r: [[[f64; 3]; 3]; 2],
            #[unit] u: [f64; 4],
            #[symmetric] s: [[f64; 2]; 2],
            #[rank(2)] f: [[[f64; 4]; 3]; 2],
            #[plucker] l: [[[f64; 3]; 2]; 2],
        ) -> (x, y) {
            let [first, second] = r;
            let g = f[1] * f[0].t();
            [x, y] * (first * first.t() - identity(3))[0][0] + [x, y] * dot(u, u) == s * [1, 2];
            x * det(second) * (s[0][1] - s[1][0] + 1) - y + det(g) + dot(l[1][0], l[1][1]) != 0;
            // All else cancels, and data must be read.
            x + r[0][0][0] + u[0] + f[0][0][0] + l[0][0][0] != 0;
        }",
    );
    let (x, y) = (sample.unknown("x"), sample.unknown("y"));
    let s = |i: usize| sample.input("s", i);
    assert_eq!(sample.residuals(), [x - s(0) - z(2) * s(1), y - s(2) - z(2) * s(3)].map(|value| value.0));
    assert_eq!(sample.value(&sample.problem.nonzero[0].polynomial), (x - y).0);
    // The coefficients were seen to be 1 when the problem was read.
    assert_eq!(sample.problem.nonzero[0].polynomial.terms().len(), 2);
    assert_eq!(sample.problem.equations[0].polynomial.terms().len(), 2);
}

#[test]
fn mirrored_and_empty_elements_state_nothing() {
    let sample = Sample::new(
        "fn commuting(#[symmetric] s: [[f64; 2]; 2], a: f64) -> (x, y, z) {
            let m = [[x, y], [y, z]];
            m * s - s * m == 0;
            m == m.t() + skew([0, 0, x * y - a])[0][1] * [[0, 1], [-1, 0]];
            for i in 0..2 {
                for j in 0..2 {
                    m[i][j] * s[j][i] == m[j][i] * s[i][j] + (i - j) * (x + y - 1);
                }
            }
        }",
    );
    // The commutator is skew: one element; the second is skew; the loop states one equation twice,
    // up to its sign.
    assert_eq!(sample.elements(), ["[0][1]", "[0][1]", ""]);
}

#[test]
fn one_unknown_may_stand_alone() {
    for output in ["x", "(x)", "(x,)"] {
        let text = format!("fn root(a: f64) -> {output} {{ x.pow(2) == a; }}");
        assert_eq!(Problem::parse("root.rs", &text).unwrap().unknowns, ["x"]);
    }
}

/// Arrays of unknowns are the arrays of their elements.
#[test]
fn arrays_of_unknowns_have_elements_like_scalars() {
    let body = "
        m * v == s * v + offset;
        gradient(dot(v, v) + m[1][0] * s, v) == m * offset;
        for row in m { dot(row, v) * s - 1 == 0; }
        trace(m) == 2;
        v[0] - v[1] != 0;
    }";
    let arrays =
        format!("const N: usize = 2; fn same(offset: [f64; 2]) -> (v: [f64; N], s, m: [[f64; 2]; N]) {{ {body}");
    let scalars = format!(
        "fn same(offset: [f64; 2]) -> (v0, v1, s, m00, m01, m10, m11) {{
            let v = [v0, v1];
            let m = [[m00, m01], [m10, m11]]; {body}"
    );
    let (arrays, scalars) = (Sample::new(&arrays), Sample::new(&scalars));
    assert_eq!(arrays.problem.unknowns, ["v[0]", "v[1]", "s", "m[0][0]", "m[0][1]", "m[1][0]", "m[1][1]"]);
    assert_eq!(arrays.residuals(), scalars.residuals());
    assert_eq!(arrays.elements(), scalars.elements());
    assert_eq!(
        arrays.value(&arrays.problem.nonzero[0].polynomial),
        (arrays.unknown("v[0]") - arrays.unknown("v[1]")).0
    );
    let fields = arrays.problem.fields.iter();
    let fields: Vec<_> = fields.map(|field| (field.name.as_str(), &field.shape[..], field.first_unknown)).collect();
    assert_eq!(fields, [("v", &[2][..], 0), ("s", &[], 2), ("m", &[2, 2], 3)]);
    assert_ne!(arrays.problem.fingerprint(), scalars.problem.fingerprint());
}

/// A vector that is given up to scale is Q (u, 1) with 4571 Q = 4571 - 2 v v^T and
/// v = (37, 41, 39), times 4571 / 8192. The unknowns are u.
#[test]
fn a_vector_given_up_to_scale_is_read_in_a_chart() {
    let of_vector = |signature: &str, point: &str| {
        Sample::new(&format!(
            "fn conics(a: [f64; 6], b: [f64; 6]) -> ({signature}, s) {{
                let [x, y, z] = {point};
                let monomials = [x * x, x * y, y * y, x * z, y * z, z * z];
                dot(a, monomials) == s * x * y;
                s * dot(b, monomials) == s * s * z * z;
                s * x == y;
                x - 2 * y != 0;
            }}"
        ))
    };
    let chart = of_vector("#[projective] point: [f64; 3]", "point");
    let affine = of_vector(
        "u, v",
        "[1833 * u - 3034 * v - 2886, -3034 * u + 1209 * v - 3198, -2886 * u - 3198 * v + 1529] / 8192",
    );
    assert_eq!(chart.problem.unknowns, ["point[0]", "point[1]", "s"]);
    assert_eq!(chart.residuals(), affine.residuals());
    assert_eq!(chart.value(&chart.problem.nonzero[0].polynomial), affine.value(&affine.problem.nonzero[0].polynomial));
    let fields = chart.problem.fields.iter();
    let fields: Vec<_> = fields.map(|field| (field.name.as_str(), field.unknowns(), field.is_projective)).collect();
    assert_eq!(fields, [("point", 0..2, true), ("s", 2..3, false)]);
    let q = chart.problem.fields[0].chart().unwrap();
    let expected = [-2886.0, -3198.0, 1529.0].map(|entry| entry / 4571.0);
    assert!((0..3).all(|row| (q[row][2] - expected[row]).abs() < 1e-15), "{q:?}");
}

#[test]
fn one_array_of_unknowns_may_stand_alone() {
    for output in ["v: [f64; 2]", "(v: [f64; 2])", "((v: [f64; 2],))", "(v: [f64; 2],)", "(v: [f64; 1 + 1])"] {
        let text = format!("fn roots(a: f64) -> {output} {{ v[0] * v[1] == a; v[0] + v[1] == 1; }}");
        let problem = Problem::parse("roots.rs", &text).unwrap_or_else(|messages| panic!("{output}: {messages}"));
        assert_eq!(problem.unknowns, ["v[0]", "v[1]"], "{output}");
    }
    let text = "fn root(a: f64) -> (x: f64, y) { x * y == a; x + y == 1; }";
    assert_eq!(Problem::parse("root.rs", text).unwrap().unknowns, ["x", "y"]);
}

#[test]
fn gradients_by_some_unknowns() {
    let sample = Sample::new(
        "fn saddle(a: f64) -> (x, y, z) {
            let f = x.pow(3) * y + a * y * z;
            gradient(f, [z, x]) == 0;
            gradient(f, y) == z;
        }",
    );
    let (x, y, w) = (sample.unknown("x"), sample.unknown("y"), sample.unknown("z"));
    let a = sample.input("a", 0);
    assert_eq!(sample.residuals(), [a * y, z(3) * x * x * y, x * x * x + a * w - w].map(|value| value.0));
}

/// What is divided, multiplied or passed to a helper is one node, the same one where it is
/// repeated.
#[test]
fn fields_of_results_divide_in_helpers() {
    let sample = Sample::new(
        "fn parts(a: f64) -> (x, y) {
            x * y == a;
            x + y == 1;
            Ratio {
                value: ratio(x + a, y) + ratio(x + a, y) * x,
                both: [(x + y) * (x - a), 1 / (x + a)],
                root: sqrt((x + y) / a),
                norm: norm([x, a]),
                unit: normalise([x, a]),
            }
        }

        fn ratio(p: f64, q: f64) -> f64 {
            q / (p + q)
        }",
    );
    let (x, y, a) = (sample.unknown("x"), sample.unknown("y"), sample.input("a", 0));
    let graph = &sample.problem.graph;
    let elements: Vec<ExpressionId> = sample.problem.output.iter().flat_map(Output::elements).collect();
    let sum = over(y * (x + z(1)), x + a + y);
    let square = |id| match graph.node(id) {
        Expression::Root(square) => sample.result(square),
        other => panic!("no root: {other:?}"),
    };
    let found = [sample.result(elements[0]), sample.result(elements[1]), sample.result(elements[2])];
    assert_eq!((found, square(elements[3])), ([sum, (x + y) * (x - a), over(z(1), x + a)], over(x + y, a)));
    assert_eq!(square(elements[4]), x * x + a * a);
    let needed = graph.needed(&elements);
    let needed = || graph.nodes().iter().zip(&needed).filter(|(_, needed)| **needed).map(|(node, _)| node);
    assert_eq!(needed().filter(|node| matches!(node, Expression::Root(_))).count(), 2, "the norm is taken once");
    assert_eq!(needed().filter(|node| matches!(node, Expression::Divide(..))).count(), 4, "and the ratio");
    assert!(elements.iter().all(|&id| graph.is_of_solution(id)) && !graph.is_of_solution(graph.input(0)));
}

/// What stands before the struct is computed for results as it is written, though equations expand
/// it; a derivative of a product takes the expanded one.
#[test]
fn what_stands_before_results_is_not_expanded_for_them() {
    let text = |field: &str| {
        format!(
            "fn product(a: f64, b: f64) -> (x, y) {{
                let p = (x + a) * (y + b) * (x + y);
                p == 1;
                x - y == a;
                Product {{ value: {field} }}
            }}"
        )
    };
    let products = |sample: &Sample| {
        let elements: Vec<ExpressionId> = sample.problem.output.iter().flat_map(Output::elements).collect();
        let (graph, needed) = (&sample.problem.graph, sample.problem.graph.needed(&elements));
        let nodes = graph.nodes().iter().zip(&needed).filter(|(_, needed)| **needed);
        let products = nodes.filter(|(node, _)| matches!(node, Expression::Multiply(..))).count();
        (sample.result(elements[0]), products)
    };
    let sample = Sample::new(&text("p"));
    let (x, y) = (sample.unknown("x"), sample.unknown("y"));
    let (a, b) = (sample.input("a", 0), sample.input("b", 0));
    assert_eq!(products(&sample), ((x + a) * (y + b) * (x + y), 2));
    let sample = Sample::new(&text("gradient(p, [x])[0]"));
    let (derivative, products) = products(&sample);
    assert_eq!(derivative, (y + b) * (x + y) + (x + a) * (y + b));
    assert!(products > 2, "{products}");
}

/// A result that does not depend on the solution after all is an expression in the data, and one
/// that is written with a solution is no coefficient.
#[test]
fn results_do_not_hide_data() {
    let sample = Sample::new(
        "fn hidden(a: f64, b: f64) -> (x, y) {
            let plain = a * b;
            x + y == a;
            x * y == b;
            Sums { first: square(x + a) - x * x - 2 * a * x, second: square(x + b) - square(x + b) + plain }
        }

        fn square(p: f64) -> f64 {
            p * p
        }",
    );
    let (a, b) = (sample.input("a", 0), sample.input("b", 0));
    let elements: Vec<ExpressionId> = sample.problem.output.iter().flat_map(Output::elements).collect();
    assert_eq!([0, 1].map(|at| sample.result(elements[at])), [a * a, a * b]);
    assert!(!sample.problem.graph.is_of_solution(elements[1]));
}

#[test]
fn line_endings_and_byte_order_mark_do_not_matter() {
    let text = "/// Text.\nfn line(a: f64) -> (x, y) {\n    x + y == a;\n    x == 2 * y;\n}\n";
    let plain = Problem::parse("line.rs", text).unwrap();
    let windows = Problem::parse("line.rs", &format!("\u{feff}{}", text.replace('\n', "\r\n"))).unwrap();
    assert_eq!(plain.equations[1].polynomial, windows.equations[1].polynomial);
    assert_eq!(&windows.source.text[windows.equations[1].span.clone()], "x == 2 * y");
    assert_eq!(plain.docs, windows.docs);
}

/// x / y in Z_p.
fn over(x: Z, y: Z) -> Z {
    x * Z(FIELD.inverse(y.0).unwrap())
}

#[test]
fn quotients_and_systems_of_data() {
    let sample = Sample::new(
        "fn derived(a: [[f64; 2]; 2], b: [f64; 2], c: f64) -> (x, y, z, v) {
            let [s, t] = solve(a, b);
            let inverse = inverse(a);
            x == s / c;
            y == t;
            z == (inverse * b)[0] + c / b[1];
            v == reshape(inverse, [4])[2];
        }",
    );
    let ([x, y], [z, v]) = (["x", "y"].map(|name| sample.unknown(name)), ["z", "v"].map(|name| sample.unknown(name)));
    let a = |i: usize, j: usize| sample.input("a", 2 * i + j);
    let (b, c) = ([0, 1].map(|i| sample.input("b", i)), sample.input("c", 0));
    let determinant = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
    let s = over(b[0] * a(1, 1) - a(0, 1) * b[1], determinant);
    let t = over(a(0, 0) * b[1] - b[0] * a(1, 0), determinant);
    let expected = [x - over(s, c), y - t, z - s - over(c, b[1]), v - over(Z(0) - a(1, 0), determinant)];
    assert_eq!(sample.residuals(), expected.map(|Z(value)| value));
}

/// Null vectors are annihilated, and no two are the same; equal matrices have one null space.
#[test]
fn null_spaces_of_data() {
    let sample = Sample::new(
        "fn derived(a: [[f64; 4]; 2]) -> (x, y, z, v) {
            let n = null_space(a);
            let again = null_space([a[0], a[1]]);
            [x, y, z, v] == [n[0][0], n[0][1], n[0][2], n[0][3]];
            x + y + z + v == n[1][0] + n[1][1] + n[1][2] + again[1][3];
        }",
    );
    assert_eq!(sample.problem.graph.derivations().len(), 1);
    let values = sample.problem.graph.all_inputs(FIELD, &sample.data).unwrap();
    let (a, vectors) = values.split_at(8);
    assert_eq!(vectors.len(), 8);
    for (row, vector) in a.chunks(4).flat_map(|row| vectors.chunks(4).map(move |vector| (row, vector))) {
        let product = row.iter().zip(vector).fold(Z(0), |sum, (&a, &v)| sum + Z(a) * Z(v));
        assert_eq!(product, Z(0));
    }
    let minor = Z(vectors[0]) * Z(vectors[5]) - Z(vectors[1]) * Z(vectors[4]);
    assert_ne!(minor, Z(0));
    let names = ["x", "y", "z", "v"];
    let differences = names.iter().zip(vectors).map(|(name, &value)| sample.unknown(name) - Z(value));
    let residuals = sample.residuals();
    assert_eq!(residuals[..4], differences.map(|Z(value)| value).collect::<Vec<_>>());
}

/// A choice is a mixture of all values, with weights of sum 1, and what is derived for it alone is
/// tentative.
#[test]
fn choices_among_data() {
    let sample = Sample::new(
        "fn chosen(keys: [f64; 3], a: [[[f64; 2]; 2]; 3], b: f64) -> (x, y, z) {
            let mut values = [[0; 3]; 3];
            for k in 0..3 {
                values[k] = concat(solve(a[k], [1, 0]), b);
            }
            [x, y, z] == least(keys, values);
        }",
    );
    let derivations = sample.problem.graph.derivations();
    assert_eq!(derivations.len(), 4);
    let values = sample.problem.graph.all_inputs(FIELD, &sample.data).unwrap();
    let (solved, chosen) = values[16..].split_at(6);
    // All share the last value; the others are on no line with two of them.
    assert_eq!(chosen[2], values[15]);
    let difference = |k: usize, of: &[u32]| Z(of[k]) - Z(solved[k]);
    let cross = |a: &[u32], b: &[u32]| difference(0, a) * difference(1, b) - difference(1, a) * difference(0, b);
    let (second, third) = (&solved[2..4], &solved[4..6]);
    let area = cross(second, third);
    let weights = [over(cross(chosen, third), area), over(cross(second, chosen), area)];
    assert!(weights.iter().all(|&weight| weight != Z(0) && weight != Z(1)));
    assert_ne!(weights[0] + weights[1], Z(1));
}

/// Lengths of many vectors: a point of the data is found at which all roots exist, here and in
/// instances.
#[test]
fn lengths_and_square_roots_of_data() {
    let text = "fn derived(a: [[f64; 3]; 12], b: f64) -> (x, y) {
        let mut sum = 0;
        for row in a {
            let v = normalise(row);
            dot(v, v) * x == sum * y + norm(row) + sqrt(norm(row) * b + 1);
            sum += v[0];
        }
    }";
    let problem = Problem::parse("roots.rs", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    for seed in 0..3 {
        let instance = Instance::draw(&problem, FIELD, seed).unwrap();
        let values = problem.graph.all_inputs(FIELD, &instance.inputs).unwrap();
        let (given, roots) = values.split_at(37);
        assert_eq!(roots.len(), 24);
        for (row, roots) in given.chunks(3).zip(roots.chunks(2)) {
            let square = row.iter().fold(Z(0), |sum, &x| sum + Z(x) * Z(x));
            assert_eq!(Z(roots[0]) * Z(roots[0]), square);
            assert_eq!(Z(roots[1]) * Z(roots[1]), Z(roots[0]) * Z(given[36]) + Z(1));
        }
        // A normalised vector has length 1: the coefficient of x is 1.
        let first = &instance.equations[0];
        assert!(first.terms().iter().any(|&(m, c)| m.exponent(0) == 1 && c == 1), "{first:?}");
    }
}
