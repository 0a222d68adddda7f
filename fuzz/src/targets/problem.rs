//! The problem language: text to problem, and random data for what was read.

use std::time::Duration;

use eliminant_generator::algebra::{PRIMES, PrimeField};
use eliminant_generator::problem::Problem;
use eliminant_generator::problem::instance::Instance;

use crate::mutate::Kind;
use crate::outcome::Outcome;
use crate::target::Target;

const WORDS: [&str; 84] = [
    "fn",
    "let",
    "mut",
    "for",
    "in",
    "const",
    "if",
    "else",
    "while",
    "return",
    "as",
    "f64",
    "usize",
    "Complex<f64>",
    "complex(",
    "conj(",
    ".re",
    ".im",
    "_",
    "det(",
    "trace(",
    "dot(",
    "cross(",
    "skew(",
    "identity(",
    "gradient(",
    "concat(",
    "reshape(",
    "solve(",
    "inverse(",
    "null_space(",
    "least(",
    "sqrt(",
    "norm(",
    "normalise(",
    "#[mean(of)]",
    "> 0;",
    "x: [f64; 3]",
    "Pose { x: x }",
    ".pow(2)",
    ".pow(",
    ".t()",
    "..",
    "..=",
    "==",
    "!=",
    "= 0;",
    "== 0;",
    "->",
    "#[symmetric]",
    "#[rotation]",
    "#[unit]",
    "#[plucker]",
    "#[integer]",
    "#[rank(2)]",
    "#[projective]",
    "[f64; 3]",
    "[[f64; 3]; 3]",
    "[x, y]",
    "(x, y)",
    "x",
    "y",
    "{",
    "}",
    "(",
    ")",
    "[",
    "]",
    ";",
    ",",
    "+",
    "-",
    "*",
    "/",
    "%",
    "+=",
    "*=",
    "&",
    "!",
    "^",
    "// \n",
    "/// \n",
    "\"",
    "é",
];

/// Problems with more expressions are expensive.
const MANY_NODES: usize = 5000;

pub(super) fn target() -> Target {
    Target {
        name: "problem",
        what: "the problem language: text to problem or messages, fingerprint, random data",
        kind: Kind::Text(&WORDS),
        longest: 4096,
        bound: Duration::from_secs(1),
        run,
    }
}

fn run(input: &[u8]) -> Outcome {
    let mut outcome = Outcome::default();
    match Problem::parse("problem.rs", &String::from_utf8_lossy(input)) {
        Ok(problem) => {
            outcome.accepted = true;
            outcome.expensive = problem.graph.nodes().len() > MANY_NODES;
            outcome.count("equations", problem.equations.len());
            outcome.count("exclusions", problem.nonzero.len());
            outcome.count("unknowns", problem.unknowns.len());
            outcome.count("fields", problem.fields.len());
            outcome.count("inputs", problem.input_count());
            outcome.count("nodes", problem.graph.nodes().len());
            outcome.count("product sums", problem.graph.product_sums().len());
            outcome.count("terms", problem.polynomials().map(|polynomial| polynomial.terms().len()).sum());
            outcome.count("degree", problem.polynomials().map(|p| p.degree().max(0) as usize).max().unwrap_or(0));
            problem.data.iter().for_each(|data| outcome.see(&format!("{:?} {}", data.attribute, data.shape.len())));
            outcome.see(if problem.has_origin() { "origin" } else { "no origin" });
            let drawn = Instance::draw(&problem, PrimeField::new(PRIMES[0]), 1);
            outcome.see(if drawn.is_some() { "instance" } else { "no instance" });
            outcome.demand(problem.fingerprint() == problem.clone().fingerprint(), || "two fingerprints".into());
        }
        Err(diagnostics) => {
            outcome.demand(!diagnostics.messages.is_empty(), || "refused without a message".into());
            outcome.demand(!diagnostics.render().is_empty(), || "the message is empty".into());
            outcome.count("messages", diagnostics.messages.len());
            for message in &diagnostics.messages {
                outcome.expensive |= message.message == "the problem is too large to be expanded";
                outcome.see(&message.message);
                outcome.see(&message.label);
                message.hints.iter().for_each(|hint| outcome.see(hint));
                message.context.iter().for_each(|(_, label)| outcome.see(label));
            }
        }
    }
    outcome
}
