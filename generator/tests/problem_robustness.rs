//! No text makes the parser panic, overflow the stack or run for long.

use std::time::{Duration, Instant};

use eliminant_generator::problem::Problem;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// A problem text takes half a second at most, and tests run without optimisation, side by side.
const SOON: Duration = Duration::from_secs(20);

const PROBLEMS: [&str; 4] = [
    "/// Two conics.
fn two_conics(a: [f64; 6], b: [f64; 6]) -> (x, y) {
    let m = [x * x, x * y, y.pow(2), x, y, 1];
    dot(a, m) == 0;
    dot(b, m) / 2 == 0.5;
    x - y != 0;
}
",
    "const N: usize = 3;
fn essential(basis: [[[f64; N]; N]; 4], #[unit] u: [f64; 3]) -> (x, y, z) {
    let e = x * basis[0] + y * basis[1] + z * basis[2] + basis[3];
    det(e) == 0;
    2 * e * e.t() * e - trace(e * e.t()) * e == 0;
}
",
    "fn sum(v: [_; 2]) -> f64 {
    let mut s = 0;
    for e in v { s += e; }
    s
}
fn stationary(#[symmetric] g: [[f64; 2]; 2]) -> (x, y) {
    let [p, q] = g;
    for i in 0..=1 { let t = skew([i, x, y]); }
    gradient(sum([x * x * p[0], y * y * q[1]]) + x * (1 - y)) == 0;
}
",
    "fn eigenvector(#[symmetric] m: [[f64; 3]; 3]) -> (v: [f64; 3], value, w: [[f64; 2]; 1]) {
    m * v == value * v;
    dot(v, v) == 1;
    w * w.t() == [[value]];
    gradient(w[0][1] * v[0], w) == [[v[1], v[2]]];
}
",
];

const PIECES: [&str; 38] = [
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ";",
    ",",
    "==",
    "!=",
    "=",
    "+=",
    "-",
    "*",
    "/",
    "%",
    "^",
    "**",
    ".t()",
    ".pow(3)",
    "..",
    "0",
    "-1",
    "9999999999",
    "0.5e9",
    "2x",
    "x",
    "let ",
    "for i in 0..3 ",
    "#[unit]",
    "'a",
    "\"",
    "/*",
    "é",
    "-> ",
    ": [f64; 3]",
    ":",
    "#",
];

proptest! {
    #![proptest_config(ProptestConfig { cases: 1500, failure_persistence: None, rng_seed: RngSeed::Fixed(1), ..ProptestConfig::default() })]

    #[test]
    fn mutated_problems_are_parsed_or_refused(
        which in 0..PROBLEMS.len(),
        edits in prop::collection::vec((any::<prop::sample::Index>(), 0..4usize, 0..PIECES.len(), any::<char>()), 1..6),
    ) {
        let mut text: Vec<char> = PROBLEMS[which].chars().collect();
        for (at, kind, piece, c) in edits {
            let at = at.index(text.len());
            match kind {
                0 => { text.remove(at); }
                1 => text[at] = c,
                2 => text.insert(at, c),
                _ => { text.splice(at..at, PIECES[piece].chars()); }
            }
        }
        let text: String = text.into_iter().collect();
        if let Err(diagnostics) = Problem::parse("mutated.rs", &text) {
            prop_assert!(!diagnostics.messages.is_empty());
            let rendered = diagnostics.render();
            prop_assert!(rendered.contains("mutated.rs:"), "{rendered}");
        }
    }
}

/// Text in which one construct is nested or chained very often.
fn repeated(before: &str, piece: &str, count: usize, after: &str) -> String {
    format!("fn deep(a: f64) -> (x, y) {{ {before}{}{after} }}", piece.repeat(count))
}

#[test]
fn long_chains_and_deep_nesting_are_refused_or_parsed_without_overflow() {
    for count in [600, 100_000] {
        let texts = [
            repeated("", "(", count, ""),
            repeated("", "(", count, &format!("x{} == 1;", ")".repeat(count))),
            repeated("let v = ", "[", count, &format!("x{};", "]".repeat(count))),
            repeated("", "{", count, &"}".repeat(count)),
            repeated("x == ", "-", count, "y;"),
            repeated("x == ", "- #[a] ", count, "y;"),
            repeated("x == ", "!&*", count, "y;"),
            repeated("x == y", " + x", count, ";"),
            repeated("x == y", ".t()", count, ";"),
            repeated("x == y", "[0]", count, ";"),
            repeated("", "x = ", count, "y;"),
            repeated("", "return ", count, "y;"),
            repeated("", "|t| ", count, "y;"),
            repeated("", "if x { } else ", count, "{ }"),
            repeated("", "if 1 > 2 { } else ", count, "{ x == y; }"),
            repeated("", "if 1 < 2 { ", count, &"}".repeat(count)),
            repeated("if ", "!", count, "true { x == y; }"),
            repeated("if ", "true && ", count, "true { x == y; }"),
            repeated("", "for i in 0..1 { ", count, &"}".repeat(count)),
            repeated("let z: ", "&", count, "f64 = x;"),
            repeated("let ", "z @ ", count, "_ = x;"),
            repeated("let ", "[", count, &format!("z{} = x;", "]".repeat(count))),
            repeated("x == ", "2 * (x + ", count, &format!("1{};", ")".repeat(count))),
            repeated("", "x == y; ", count, ""),
            repeated("", "/// doc\n", count, "x == y;"),
            repeated("x == y; x * y == a;", "", 0, "").replace("fn", &format!("{}fn", "/// doc\n".repeat(count))),
            format!("fn deep(a: f64) -> {}v: [f64; 2]{} {{ v == [a, 1]; }}", "(".repeat(count), ")".repeat(count)),
            format!("fn deep(a: f64) -> (v: {}f64{}) {{ v == a; }}", "[".repeat(count), "; 1]".repeat(count)),
            format!("fn deep(a: f64) {} (x, y) {{ x == a; }}", "-> ".repeat(count)),
        ];
        for text in texts {
            let parsed = Problem::parse("deep.rs", &text);
            if let Err(diagnostics) = parsed {
                assert!(diagnostics.render().contains("deep.rs:"));
            }
        }
    }
}

#[test]
fn chains_of_helpers_do_not_exhaust_the_stack() {
    for (length, nesting, message) in [(60, 1, "helpers call each other"), (20, 300, "nested too deeply")] {
        let mut text = String::from("fn f0(a: _) -> f64 { a }\n");
        for i in 1..length {
            let (open, close) = ("(1 + ".repeat(nesting), ")".repeat(nesting));
            text += &format!("fn f{i}(a: _) -> f64 {{ {open}f{}(a){close} }}\n", i - 1);
        }
        text += &format!("fn problem(a: f64) -> x {{ x * x == f{}(x); }}", length - 1);
        let messages = Problem::parse("chain.rs", &text).unwrap_err().messages;
        assert_eq!(messages.len(), 1);
        assert!(messages[0].message.contains(message), "{}", messages[0].message);
    }
}

/// Refused, with this message among others, in a time that hours or minutes exceed, whatever else
/// runs.
fn assert_refused_soon(what: &str, text: &str, message: &str) {
    let start = Instant::now();
    let shown = Problem::parse("large.rs", text).expect_err(what).render();
    assert!(shown.contains(message), "{what}: {}", shown.chars().take(2000).collect::<String>());
    assert!(start.elapsed() < SOON, "{what}: {:?}", start.elapsed());
}

#[test]
fn work_is_counted_wherever_it_is_done() {
    let chain = |length: usize, parameter: &str, first: &str| {
        let helper = |k: usize| format!("fn f{k}(x: {parameter}) -> f64 {{ f{0}(x) + f{0}(x) }}\n", k - 1);
        let helpers: String = (1..=length).map(helper).collect();
        format!("fn f0(x: {parameter}) -> f64 {{ {first} }}\n{helpers}")
    };
    let problem = "fn p(a: [[[f64; 3]; 255]; 4]) -> x";
    let state = |statements: &str| format!("fn p(a: f64) -> (x, y, z, u, v, w) {{ {statements} }}");
    let copies: String = (0..400).map(|k| format!("let c{k} = b;")).collect();
    let too_large = "error: the problem is too large to be expanded";
    for (what, text) in [
        ("calls", format!("{problem} {{ f18(x) == a[0][0][0]; }}\n{}", chain(18, "f64", "x * x"))),
        ("too many calls", format!("{problem} {{ f30(x) == a[0][0][0]; }}\n{}", chain(30, "f64", "x * x"))),
        ("arrays", format!("{problem} {{ f10(a) == x; }}\n{}", chain(10, "[[[f64; 3]; 255]; 4]", "x[0][0][0]"))),
        ("terms that are copied", state(&format!("let b = [(x + y + z + u + a).pow(8); 10000]; {copies}"))),
        ("a power of many terms", state("(x + y + z + u + v + w + a).pow(32) == 0;")),
        ("empty loops", state("for i in 0..10000 { for j in 0..10000 { } }")),
        ("equations", state("let q = (x + y + z + u + a).pow(10); for i in 0..1000 { q + i * a == 0; }")),
    ] {
        assert_refused_soon(what, &text, too_large);
    }
    let mistakes = state("for i in 0..10000 { for j in 0..10000 { let b = xx * i; } }");
    assert_refused_soon("one mistake in a loop", &mistakes, "unknown name `xx`");
    // More calls than may be nested.
    let deep = format!("{problem} {{ f60(x) == a[0][0][0]; }}\n{}", chain(60, "f64", "x * x"));
    assert_refused_soon("a chain", &deep, "error: more than 32 helpers call each other");
}

#[test]
fn of_many_mistakes_the_first_are_shown() {
    let (a, b) = ("b".repeat(300_000), "c".repeat(300_000));
    let long_names = format!("fn p(a: f64) -> x {{ let {a} = 1; x == a * {b}; }}");
    assert_refused_soon("long names", &long_names, "error: unknown name");
    let all = |each: fn(usize) -> String| (0..45_000).map(each).collect::<String>();
    let names = all(|k| format!("let b{k} = 1;"));
    let unknown = all(|k| format!("c{k};"));
    let functions = all(|k| format!("fn B{k}() {{}}"));
    for text in [
        format!("fn p(a: f64) -> x {{ x == a; {names}{unknown} }}"),
        format!("fn p(a: f64) -> x {{ x == a; }} {functions}"),
    ] {
        assert_refused_soon("mistakes", &text, "error: there are more than 100 mistakes");
        let count = Problem::parse("large.rs", &text).expect_err("mistakes").messages.len();
        assert_eq!(count, 101);
    }
}
