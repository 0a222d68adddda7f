//! Template files: text to template, and its proof against the problem that it names.

use std::sync::LazyLock;
use std::time::Duration;

use eliminant_generator::generate::{GenerateError, plan};
use eliminant_generator::problem::Problem;
use eliminant_generator::template::file::{TemplateFile, TemplateFileError};

use crate::mutate::Kind;
use crate::outcome::Outcome;
use crate::target::Target;

const WORDS: [&str; 44] = [
    "problem",
    "fingerprint",
    "solutions",
    "presolve",
    "roots",
    "rows",
    "columns",
    "action",
    "basis",
    "reducible",
    "excess",
    "[[shifts]]",
    "equation",
    "multipliers",
    "[provenance]",
    "\"none\"",
    "\"constant\"",
    "\"linear\"",
    "\"square\"",
    "\"combined\"",
    "\"combined_linear\"",
    "\"combined_square\"",
    "\"eigenvalues\"",
    "\"determinant\"",
    "\"1\"",
    "\"x\"",
    "\"y\"",
    "\"x*y\"",
    "\"x^2\"",
    "\"1/x\"",
    "\"y/x^2\"",
    "\"x^127\"",
    "\"1/x^127\"",
    "[",
    "]",
    "=",
    ",",
    "\"",
    "'''",
    "\"\"\"",
    "#",
    "{",
    "}",
    ".",
];

/// The problem that templates of the corpus are for.
const PROBLEM: &str = "fn two_conics(p: [f64; 6], q: [f64; 6]) -> (x, y) {
    let monomials = [x * x, x * y, y * y, x, y, 1];
    dot(p, monomials) == 0;
    dot(q, monomials) == 0;
}";

static READ: LazyLock<Option<Problem>> = LazyLock::new(|| Problem::parse("two_conics.rs", PROBLEM).ok());

pub(super) fn target() -> Target {
    Target {
        name: "template",
        what: "template files: text to template, back to text, and the plan of the solver",
        kind: Kind::Text(&WORDS),
        longest: 4096,
        bound: Duration::from_secs(1),
        run,
    }
}

fn run(input: &[u8]) -> Outcome {
    let mut outcome = Outcome::default();
    let Some(problem) = &*READ else {
        outcome.demand(false, || "the problem cannot be read".into());
        return outcome;
    };
    let mut file = match TemplateFile::parse(&String::from_utf8_lossy(input), &problem.unknowns) {
        Ok(file) => file,
        Err(TemplateFileError::Syntax(message)) => {
            // What is wrong stands in the last line, after the place and the input.
            message.lines().next_back().into_iter().for_each(|line| outcome.see(line));
            return outcome;
        }
        Err(error) => {
            outcome.see(&error.to_string());
            return outcome;
        }
    };
    outcome.accepted = true;
    let again = TemplateFile::parse(&file.to_text(&problem.unknowns), &problem.unknowns);
    outcome.demand(again.as_ref() == Ok(&file), || format!("read back as {again:?}"));
    // Whatever problem the text names, the template is tried on this one.
    outcome.see(if file.fingerprint == problem.fingerprint() { "fresh" } else { "stale" });
    file.fingerprint = problem.fingerprint();
    file.problem.clone_from(&problem.name);
    outcome.count("rows", file.template.rows());
    outcome.count("basis", file.template.basis.len());
    match plan(problem, &file) {
        Ok(planned) => {
            outcome.see(&format!("{:?} {:?}", file.presolve, file.roots));
            outcome.count("operations", planned.plan.operations().total());
        }
        Err(error) => {
            let is_ours = matches!(error, GenerateError::PlanDiffers | GenerateError::Emit(_));
            outcome.demand(!is_ours, || error.to_string());
            outcome.see(&format!("{:?} {error}", file.presolve));
        }
    }
    outcome
}
