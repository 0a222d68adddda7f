//! Solvers are compiled and executed: with names of problems, data and unknowns that emitted code
//! might use itself, and with arrays of unknowns.

use std::fs;
use std::path::Path;
use std::process::Command;

use eliminant::SolveError;
use eliminant_generator::expression::arithmetic::Float64;
use eliminant_generator::generate::{generate, plan};
use eliminant_generator::plan::interpret;
use eliminant_generator::presolve::Presolve;
use eliminant_generator::problem::Problem;
use eliminant_generator::search::measuring::interpreted::InterpretedSolver;
use eliminant_generator::template::file::TemplateFile;

const TWO_CONICS: [&str; 2] =
    [include_str!("../../templates/two_conics.rs"), include_str!("../../templates/two_conics.template.toml")];

/// The code for its coefficients is a table.
const WEAK_PERSPECTIVE: [&str; 2] = [
    include_str!("../../templates/pose_npt_weak_perspective.rs"),
    include_str!("../../templates/pose_npt_weak_perspective.template.toml"),
];

/// A problem that differs from a committed one in names only, and its solver by the committed
/// template.
fn emitted(problem: &str, text: &str, committed: [&str; 2]) -> String {
    let problem = Problem::parse(&format!("{problem}.rs"), text).unwrap_or_else(|messages| panic!("{messages}"));
    let original = Problem::parse("original.rs", committed[0]).unwrap();
    let mut file = TemplateFile::parse(committed[1], &original.unknowns).unwrap();
    (file.problem, file.fingerprint) = (problem.name.clone(), problem.fingerprint());
    generate(&problem, &file).unwrap_or_else(|error| panic!("{error}"))
}

/// Two conics with a name for each of their twelve coefficients.
fn conics(problem: &str, data: [&str; 12], unknowns: [&str; 2]) -> String {
    let [x, y] = unknowns;
    let parameters: Vec<String> = data.iter().map(|name| format!("{name}: f64")).collect();
    let equation = |data: &[&str]| {
        let [a, b, c, d, e, f] = data else { unreachable!() };
        format!("{a} * {x} * {x} + {b} * {x} * {y} + {c} * {y} * {y} + {d} * {x} + {e} * {y} + {f} == 0;")
    };
    let (p, q) = data.split_at(6);
    let text = format!("fn {problem}({}) -> ({x}, {y}) {{ {} {} }}", parameters.join(", "), equation(p), equation(q));
    emitted(problem, &text, TWO_CONICS)
}

/// The text with words exchanged.
fn renamed(text: &str, names: &[(&str, &str)]) -> String {
    let is_letter = |c: char| c.is_alphanumeric() || c == '_';
    let mut result = String::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let end = if is_letter(c) { rest.find(|c| !is_letter(c)).unwrap_or(rest.len()) } else { c.len_utf8() };
        let (word, after) = rest.split_at(end);
        result.push_str(names.iter().find(|(from, _)| *from == word).map_or(word, |(_, to)| to));
        rest = after;
    }
    result
}

/// Two general conics through (1, 2), by the coefficients of x^2, x y, y^2, x, y, 1.
const P: [f64; 6] = [1.25, -0.5, 0.75, 2.0, -1.5, -2.25];
const Q: [f64; 6] = [-0.375, 1.5, 0.25, -1.0, 0.625, -3.875];

/// A crate with these modules, each in a file of its own, that is built without warnings and runs.
fn run(test: &str, modules: &[(&str, String)], checks: &str) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
    fs::create_dir_all(folder.join("src")).unwrap();
    let runtime = Path::new(env!("CARGO_MANIFEST_DIR")).join("../runtime");
    let manifest = format!(
        "[package]\nname = \"{test}\"\nversion = \"0.1.0\"\nedition = \"2024\"\n\n[dependencies]\neliminant = {{ path = {:?} }}\n\n\
         [workspace]\n",
        runtime.display().to_string()
    );
    fs::write(folder.join("Cargo.toml"), manifest).unwrap();
    // The same versions as in the workspace: nothing is to be downloaded.
    fs::copy(Path::new(env!("CARGO_MANIFEST_DIR")).join("../Cargo.lock"), folder.join("Cargo.lock")).unwrap();
    let mut main = "#![deny(warnings)]\n".to_owned();
    for (name, source) in modules {
        fs::write(folder.join("src").join(format!("{name}.rs")), source).unwrap();
        main.push_str(&format!("include!(\"{name}.rs\");\n"));
    }
    main.push_str(&format!("\nfn main() {{\n{checks}}}\n"));
    fs::write(folder.join("src/main.rs"), main).unwrap();
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("emitted-target");
    let output = Command::new(env!("CARGO"))
        .args(["run", "--quiet", "--offline", "--manifest-path"])
        .arg(folder.join("Cargo.toml"))
        .env("CARGO_TARGET_DIR", target)
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// What the program checks: the known solution is found, and all that are returned solve the
/// problem.
fn check(module: &str, arguments: &str, unknowns: [&str; 2]) -> String {
    let [x, y] = unknowns;
    format!(
        "    let found = {module}::solve({arguments}).expect(\"general data\");\n    \
             assert!(found.iter().any(|s| (s.{x} - 1.0).abs() < 1e-9 && (s.{y} - 2.0).abs() < 1e-9), \"{{found:?}}\");\n    \
             let found = {module}::solve_complex({arguments}).expect(\"general data\");\n    \
             assert_eq!(found.len(), {module}::MAX_SOLUTIONS);\n    \
             assert!(found.iter().all(|s| {module}::relative_residual({arguments}, s).is_ok_and(|r| r < 1e-12)));\n    \
             assert_eq!({module}::UNKNOWNS, [{x:?}, {y:?}]);\n    \
             assert_eq!({module}::Solution::from([1.0, 2.0]).to_array(), <[f64; 2]>::from({module}::Solution {{ {x}: 1.0, {y}: 2.0 }}));\n"
    )
}

#[test]
fn no_name_of_a_problem_collides() {
    let scalars = P.iter().chain(&Q).map(|value| format!("{value:?}")).collect::<Vec<_>>().join(", ");
    let mut modules = Vec::new();
    let mut checks = String::new();
    let locals = ["given", "given_", "given_2", "solution", "solution_", "solution_2", "instance", "instance_"];
    for (problem, data, unknowns) in [
        ("core", [&locals[..], &["coefficients", "v", "v_2", "data"]].concat(), ["to_array", "unknowns"]),
        (
            "std",
            vec!["right", "self_", "eliminant", "core", "std", "emitted", "solve", "f64", "usize", "s", "t", "r"],
            ["clone", "from"],
        ),
        (
            "eliminant_",
            vec!["ok", "some", "option", "result", "found", "value", "vector", "known", "steps", "method", "b", "n"],
            ["solution", "coefficients"],
        ),
        (
            "f64",
            vec!["entry", "block", "tables", "action", "fill", "max", "listing_0_", "a_", "b_", "new", "copy", "main"],
            ["x", "self_"],
        ),
        (
            "solve",
            vec!["f32", "u16", "alloc", "test", "debug", "read", "row", "at", "x", "polish", "recover", "fmt"],
            ["solve_in", "solve_complex"],
        ),
    ] {
        modules.push((problem, conics(problem, data.try_into().unwrap(), unknowns)));
        checks.push_str(&check(problem, &scalars, unknowns));
    }
    // Elements of arrays have local names: of `v` they would be `v_0` to `v_5`.
    let text = "fn solution(v: [f64; 6], v_0: f64, v_1: [f64; 3], v_at_1: f64, v_2: f64) -> (instance, data) {
        dot(v, [instance * instance, instance * data, data * data, instance, data, 1]) == 0;
        dot([v_0, v_1[0], v_1[1], v_1[2], v_at_1, v_2],
            [instance * instance, instance * data, data * data, instance, data, 1]) == 0;
    }";
    modules.push(("solution", emitted("solution", text, TWO_CONICS)));
    let [a, b, c, d, e, f] = Q;
    let arguments = format!("&{P:?}, {a:?}, &[{b:?}, {c:?}, {d:?}], {e:?}, {f:?}");
    checks.push_str(&check("solution", &arguments, ["instance", "data"]));

    // Code that is a table.
    let names = [
        ("pose_npt_weak_perspective", "emitted"),
        ("means", "data"),
        ("covariance", "given"),
        ("square", "solution"),
        ("w", "instance"),
    ];
    let source = emitted("emitted", &renamed(WEAK_PERSPECTIVE[0], &names), WEAK_PERSPECTIVE);
    assert!(source.contains("static PROGRAM"), "{source}");
    modules.push(("emitted", source));
    checks.push_str(
        "    let data = [2.0, 0.5, -0.25, 0.125, 1.5, 0.375, 0.25, 1.0, -0.5, 0.5, -0.25, 0.75, 0.125, 1.0, \
             -0.5, 0.25, 0.0];\n    \
             let found = emitted::solve_complex(&data).expect(\"general data\");\n    \
             assert_eq!(found.len(), emitted::MAX_SOLUTIONS);\n    \
             for s in found { assert!(emitted::relative_residual(&data, &s).is_ok_and(|r| r < 1e-9)); }\n",
    );
    run("emitted_names", &modules, &checks);
}

/// Where one of two systems has no solution the other one is chosen, in emitted code and in both
/// interpreters, whether the key tells or only the values. Where both have none it is an error.
#[test]
fn what_only_choices_read_may_fail() {
    let text = |name: &str, key: &str| {
        format!(
            "fn {name}(a: [[[f64; 2]; 2]; 2], b: [f64; 2], p: [f64; 5], q: [f64; 5]) -> (x, y) {{
                let mut solved = [[0; 2]; 2];
                let mut keys = [0; 2];
                for k in 0..2 {{
                    solved[k] = solve(a[k], b);
                    keys[k] = {key};
                }}
                let [first, second] = least(keys, solved);
                dot(concat(first, p), [x * x, x * y, y * y, x, y, 1]) == 0;
                dot(concat(second, q), [x * x, x * y, y * y, x, y, 1]) == 0;
            }}"
        )
    };
    let (by_size, by_entry) = (text("by_size", "dot(solved[k], solved[k])"), text("by_entry", "-a[k][0][1]"));
    // The first solves for coefficients of P and Q, the second for larger numbers, the third, which
    // has the larger entry, for none.
    let (good, larger, singular) =
        ("[[1.0, 0.0], [0.0, 1.0]]", "[[0.5, 0.0], [0.0, 0.25]]", "[[1.0, 2.0], [0.5, 1.0]]");
    let (b, others) = (format!("&[{:?}, {:?}]", P[0], Q[0]), format!("&{:?}, &{:?}", &P[1..], &Q[1..]));
    let mut checks = String::new();
    for (module, first, second) in [
        ("by_size", good, larger),
        ("by_size", larger, good),
        ("by_size", good, singular),
        ("by_size", singular, good),
        ("by_entry", good, singular),
        ("by_entry", singular, good),
    ] {
        checks.push_str(&check(module, &format!("&[{first}, {second}], {b}, {others}"), ["x", "y"]));
    }
    for module in ["by_size", "by_entry"] {
        checks.push_str(&format!(
            "    assert_eq!({module}::solve(&[{singular}, {singular}], {b}, {others}).unwrap_err(), \
                 eliminant::SolveError::LostRank);\n"
        ));
    }
    let modules = [("by_size", &by_size), ("by_entry", &by_entry)];
    let emit = |(name, text): (&'static str, &String)| (name, emitted(name, text, TWO_CONICS));
    run("emitted_choices", &modules.map(emit), &checks);
    chosen_by_interpreters(&[by_size, by_entry]);
}

/// As [`what_only_choices_read_may_fail`], without compiling.
fn chosen_by_interpreters(texts: &[String]) {
    for text in texts {
        let problem = Problem::parse("chosen.rs", text).unwrap();
        let original = Problem::parse("original.rs", TWO_CONICS[0]).unwrap();
        let mut file = TemplateFile::parse(TWO_CONICS[1], &original.unknowns).unwrap();
        (file.problem, file.fingerprint) = (problem.name.clone(), problem.fingerprint());
        let plan = plan(&problem, &file).unwrap().plan;
        assert_eq!(plan.derived.iter().map(|derived| derived.is_tentative).collect::<Vec<_>>(), [true, true, false]);
        let solver = InterpretedSolver::of(&plan);
        let (good, singular) = ([1.0, 0.0, 0.0, 1.0], [1.0, 2.0, 0.5, 1.0]);
        for [first, second] in [[good, singular], [singular, good]] {
            let data = [&first[..], &second, &[P[0], Q[0]], &P[1..], &Q[1..]].concat();
            let found = solver.solve(&data).expect("the other system has a solution");
            assert!(found.iter().any(|s| (s[0] - 1.0).abs() < 1e-9 && (s[1] - 2.0).abs() < 1e-9), "{found:?}");
            assert!(interpret::coefficients(&plan, Float64, &data).is_some());
        }
        let data = [&singular[..], &singular, &[P[0], Q[0]], &P[1..], &Q[1..]].concat();
        assert_eq!(solver.solve(&data).unwrap_err(), SolveError::LostRank);
        assert_eq!(interpret::coefficients(&plan, Float64, &data), None);
    }
}

/// Parameters of measurements have names that the functions of means use themselves.
#[test]
fn no_name_of_a_measurement_collides() {
    let monomials = "[x * x, x * y, y * y, x, y, 1]";
    let [a, b, c, d, e, f] = Q;
    let text = format!(
        "fn means(#[mean(values)] p: [f64; 6], #[mean(of_number)] q: [f64; 6], #[mean(mean)] r: f64) -> (x, y) {{
             dot(p, {monomials}) == 0;
             r * dot(q, {monomials}) == 0;
         }}
         /// What the values are.
         fn values(measurements: [f64; 2], count: f64, means: [[f64; 1]; 2], values: f64, mean: f64, value: f64)
             -> [f64; 6] {{
             concat(measurements, [count, means[0][0], means[1][0], values + mean * value])
         }}
         fn of_number(one: f64) -> [f64; 6] {{ one * [{a:?}, {b:?}, {c:?}, {d:?}, {e:?}, {f:?}] }}
         fn mean(data: [[f64; 2]; 2]) -> f64 {{ data[0][1] / data[1][0] }}"
    );
    let source = emitted("means", &text, TWO_CONICS);
    assert!(source.contains("/// What the values are.\n    ///\n    /// The mean over measurements ("), "{source}");
    let [a, b, c, d, e, f] = P;
    let checks = format!(
        "    let away = |step: f64| ([{a:?} + step, {b:?} - step], {c:?} - step, [[{d:?} + step], [{e:?}]], {f:?}, step, 0.5);
    let values = [away(0.25), away(-0.25)];
    let p = means::mean_values(values);
    assert_eq!(p, {P:?});
    assert_eq!(p, means::mean_values(values.iter().map(|(m, c, a, v, n, w)| (m, c, a, v, n, w))));
    let q = means::mean_of_number([0.5, 1.5]);
    assert_eq!(q, {Q:?});
    let r = means::mean_mean(&[[[7.0, 3.0], [2.0, 7.0]], [[7.0, 1.0], [4.0, 7.0]]]);
    assert_eq!(r, 0.875);
    assert!(means::mean_of_number(std::iter::empty::<f64>()).iter().all(|x| x.is_nan()));
"
    );
    run("emitted_means", &[("means", source)], &(checks + &check("means", "&p, &q, r", ["x", "y"])));
}

/// An array of unknowns is a field of array type, in template files its elements are `v[0]`,
/// `v[1]`.
#[test]
fn arrays_of_unknowns_are_fields() {
    let monomials = "let terms = [v[0].pow(2), v[0] * v[1], v[1].pow(2), v[0], v[1], 1];";
    let equations = "dot(p, terms) == 0; dot(q, terms) == 0; v[0] != 0;";
    let text = format!("fn vector(p: [f64; 6], q: [f64; 6]) -> (v: [f64; 2]) {{ {monomials} {equations} }}");
    let vector = Problem::parse("vector.rs", &text).unwrap();
    let mut file = TemplateFile::parse(TWO_CONICS[1], &["x".into(), "y".into()]).unwrap();
    (file.problem, file.fingerprint) = (vector.name.clone(), vector.fingerprint());
    let written = file.to_text(&vector.unknowns);
    assert!(written.contains("action = \"1/v[0]\"") && written.contains("\"v[0]*v[1]^2\""), "{written}");
    assert_eq!(TemplateFile::parse(&written, &vector.unknowns).unwrap(), file);
    let source = generate(&vector, &file).unwrap();

    // The same with an array of arrays and a scalar between other unknowns.
    let text = "fn matrix(p: [f64; 6], q: [f64; 6], shift: f64) -> (first, m: [[f64; 1]; 2], last) {
        let [x, y] = [m[0][0], m[1][0]];
        dot(p, [x.pow(2), x * y, y.pow(2), x, y, 1]) == 0;
        dot(q, [x.pow(2), x * y, y.pow(2), x, y, 1]) == 0;
        first == x + shift;
        last == x * y - shift;
    }";
    let matrix = Problem::parse("matrix.rs", text).unwrap();
    let mut file =
        TemplateFile::parse(TWO_CONICS[1], &["first".into(), "x".into(), "y".into(), "last".into()]).unwrap();
    (file.problem, file.fingerprint) = (matrix.name.clone(), matrix.fingerprint());
    file.presolve = Presolve::Linear;
    let modules = [("vector", source), ("matrix", generate(&matrix, &file).unwrap())];

    let checks = format!(
        "    let (p, q) = ({P:?}, {Q:?});
    let found = vector::solve(&p, &q).expect(\"general data\");
    assert!(found.iter().any(|s| (s.v[0] - 1.0).abs() < 1e-9 && (s.v[1] - 2.0).abs() < 1e-9), \"{{found:?}}\");
    assert!(found.iter().all(|s| vector::relative_residual(&p, &q, s).is_ok_and(|r| r < 1e-12)));
    assert_eq!(vector::UNKNOWNS, [\"v[0]\", \"v[1]\"]);
    assert_eq!(vector::Solution::from([3.0, 4.0]), vector::Solution {{ v: [3.0, 4.0] }});

    let found = matrix::solve(&p, &q, 0.5).expect(\"general data\");
    let expected = matrix::Solution {{ first: 1.5, m: [[1.0], [2.0]], last: 1.5 }};
    let distance = |s: &matrix::Solution| {{
        s.to_array().iter().zip(expected.to_array()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    }};
    assert!(found.iter().any(|s| distance(s) < 1e-9), \"{{found:?}}\");
    assert_eq!(matrix::UNKNOWNS, [\"first\", \"m[0][0]\", \"m[1][0]\", \"last\"]);
    assert_eq!(expected.to_array(), [1.5, 1.0, 2.0, 1.5]);
    assert_eq!(matrix::Solution::from(expected.to_array()), expected);
    let complex = matrix::solve_complex(&p, &q, 0.5).expect(\"general data\");
    assert_eq!(complex.len(), matrix::MAX_SOLUTIONS);
    assert!(complex.iter().all(|s| (s.first - s.m[0][0] - 0.5).re.abs() < 1e-9));
"
    );
    run("emitted_arrays", &modules, &checks);
}

/// Values that the problem names are variables of these names, rows say which multiple of which
/// equation they are.
#[test]
fn complex_numbers_are_complex() {
    let problem = include_str!("../../examples/own-library/problems/linkage_5_poses.rs");
    let template = include_str!("../../examples/own-library/problems/linkage_5_poses.template.toml");
    let text = problem
        .replace("linkage_5_poses", "linkage")
        .replace("    #[unit] turns", "    origin: Complex<f64>, #[unit] turns");
    let text = text.replace("let first", "let shifts = shifts + [origin, origin, origin, origin]; let first");
    let linkage = emitted("linkage", &text, [problem, template]);
    let checks = "
        use eliminant::{Complex, Solutions};
        let [body, frame, origin] = [Complex::new(1.0, 0.5), Complex::new(-0.5, -1.0), Complex::new(2.0, -3.0)];
        let angle = |k: usize, step: f64| Complex::from_polar(1.0, step * (k + 1) as f64);
        let turns: [Complex<f64>; 4] = std::array::from_fn(|k| angle(k, 0.3));
        let end = |k: usize| frame + (body - frame) * angle(k * k, 0.2);
        let shifts: [Complex<f64>; 4] = std::array::from_fn(|k| end(k) - turns[k] * body - origin);
        let is_truth = |s: &linkage::Solution| (s.on_body - body).norm() < 1e-9 && (s.on_frame - frame).norm() < 1e-9;
        let found = linkage::solve(origin, &turns, &shifts).expect(\"general data\");
        assert!(found.iter().any(is_truth), \"{found:?}\");
        let all = linkage::solve_complex(origin, &turns, &shifts).expect(\"general data\");
        assert!(all.iter().any(|s| (s.on_body.re - 1.0).norm() < 1e-9 && (s.on_frame.im + 1.0).norm() < 1e-9));
        let bars = linkage::solve_for_bar(origin, &turns, &shifts).expect(\"general data\");
        let length = (body - frame).norm();
        assert!(bars.iter().any(|b| (b.length - length).abs() < 1e-9 && (b.direction - (body - frame) / length).norm() < 1e-9));
        let mut results = [Ok(Solutions::new())];
        linkage::solve_batch(&[linkage::Data { origin, turns, shifts }], &mut results);
        assert!(results[0].as_ref().is_ok_and(|found| found.iter().any(is_truth)));
        assert_eq!(linkage::UNKNOWNS, [\"on_body.re\", \"on_body.im\", \"on_frame.re\", \"on_frame.im\"]);
        let [re, ..] = found.iter().next().expect(\"a solution\").to_array();
        assert!(found.iter().next().is_some_and(|s| s.on_body.re == re));
    ";
    run("complex", &[("linkage", linkage)], checks);
}

#[test]
fn emitted_code_says_what_is_what() {
    let text = "/// Two conics, their equations multiplied by numbers.
    fn named(p: [f64; 6], q: [f64; 6], v: f64) -> (x, y) {
        let scale = v * v + 1;
        let Q = (scale + v) * q;
        let mut changed = scale * scale;
        changed += 1;
        for i in 0..2 { let step = (v + i) * (scale + 3); step * x != 0; }
        let terms = [x.pow(2), x * y, y.pow(2), x, y, 1];
        scale * changed * helped(v) * dot(p, terms) == 0;
        dot(Q, // coefficients
            terms) == 0;
    }
    fn helped(value: f64) -> f64 { let inside = value * value * value; inside + 1 }";
    let source = emitted("named", text, TWO_CONICS);
    for part in [
        "let scale = one.constant(1.0) + v_2[0];",
        "let q_0_2 = ",
        "let step = ",
        "let step_2 = ",
        "    //! - equation 1, `scale * changed * helped(v) * dot(p, terms) == 0`, times `1`, `y`, `x`\n",
        "    //! - equation 2, `dot(Q, terms) == 0`, times `1`, `y`, `x`\n",
        "// columns x^3, x^2*y\n",
        "// columns x*y^2, x^2, x*y, x\n",
        "// row 0: x * equation 1\n",
        "// the action monomial times x*y^2, x^2, x*y, x\n",
        "/// The monomials 1, y, x, y^2, x*y, x^2.\n",
        "// `step * x != 0`\n",
    ] {
        assert!(source.contains(part), "`{part}` is not in\n{source}");
    }
    assert!(!source.contains("changed =") && !source.contains("inside ="), "{source}");
    let is_suffix = |(before, _): (usize, &str)| source[..before].ends_with(|c: char| c.is_ascii_digit());
    assert!(!source.match_indices("usize").any(is_suffix), "{source}");
    let checks = check("named", &format!("&{P:?}, &{Q:?}, 0.75"), ["x", "y"]);
    run("emitted_labels", &[("named", source)], &checks);

    // In a table the coefficients have no names, but their documentation has.
    let source = emitted("pose_npt_weak_perspective", WEAK_PERSPECTIVE[0], WEAK_PERSPECTIVE);
    let line = source.lines().find(|line| line.contains("By name: ")).expect("named coefficients");
    assert!(line.contains("is `covariance[") || line.contains("is `target["), "{line}");
}
