//! Where an emitted solver comes from: the header of its module, and labels for its tables.

use super::storage;
use super::wrap::wrapped;
use crate::algebra::Monomial;
use crate::expression::ExpressionId;
use crate::plan::Plan;
use crate::presolve::{Presolve, ReducedProblem};
use crate::problem::{Problem, Statement};
use crate::template::file::TemplateFile;
use crate::template::{EliminationTemplate, Shift};

/// The most characters of a statement that are quoted.
const MOST_QUOTED: usize = 60;

/// Where an emitted solver comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Provenance {
    /// Lines of Markdown.
    pub(super) lines: Vec<String>,
    /// For each row of the elimination: the multiple of which equation it is.
    pub(super) rows: Vec<String>,
    /// The monomials that the elimination solves for, in the order of their columns.
    pub(super) pivots: Vec<String>,
    /// The basis monomials.
    pub(super) basis: Vec<String>,
    /// The equations of the problem as it states them.
    pub(super) equations: Vec<String>,
    /// The factors of the problem that must not vanish, as it states them.
    pub(super) nonzero: Vec<String>,
}

impl Provenance {
    /// The provenance of the solver of `problem` that is planned from `file`. `reduced` is the form
    /// of the problem that the template is for.
    pub fn of(problem: &Problem, file: &TemplateFile, reduced: &ReducedProblem, plan: &Plan) -> Self {
        let stated = |statements: &[Statement]| statements.iter().map(|statement| quoted(problem, statement)).collect();
        let t = &file.template;
        let display = |m: &Monomial| m.display(&problem.unknowns).to_string();
        let columns: Vec<String> = t.excess.iter().chain(&t.reducible).map(display).collect();
        Self {
            lines: header(problem, file, reduced, plan).iter().flat_map(|line| wrapped(line, "  ")).collect(),
            rows: plan.elimination.row_shifts.iter().map(|&shift| row_label(problem, &t.shifts[shift])).collect(),
            pivots: plan.elimination.pivot_columns.iter().map(|&column| columns[column].clone()).collect(),
            basis: t.basis.iter().map(display).collect(),
            equations: stated(&problem.equations),
            nonzero: stated(&problem.nonzero),
        }
    }
}

/// Which linear form stands in the place of an unknown, if one does.
fn linear_form(problem: &Problem, reduced: &ReducedProblem) -> Option<String> {
    let (separated, form) = (reduced.separated?, &reduced.recoveries.first()?.value);
    let name = &problem.unknowns[separated];
    let term = |&(m, c): &(Monomial, ExpressionId)| {
        let factor = reduced.problem.graph.as_constant(c)?;
        Some(match m == Monomial::unknown(separated) {
            true => "t".to_owned(),
            false => format!("({factor}) {}", m.display(&problem.unknowns)),
        })
    };
    let terms: Option<Vec<String>> = form.terms().iter().map(term).collect();
    Some(format!("- `{name}` stands for t in all monomials, where {name} = {}", terms?.join(" + ")))
}

/// The header of the emitted module: sizes, counts, and where every row comes from.
fn header(problem: &Problem, file: &TemplateFile, reduced: &ReducedProblem, plan: &Plan) -> Vec<String> {
    let mut lines = vec![
        format!("Solver of the problem `{}`: {} complex solutions.", problem.name, plan.solutions),
        String::new(),
        format!("- generator: eliminant-generator {}", env!("CARGO_PKG_VERSION")),
        format!("- problem: fingerprint {:016x}", file.fingerprint),
    ];
    lines.extend(sizes(&file.template, plan));
    lines.push(storage::described(plan));
    lines.push(format!("- action monomial: {}", listed(&[file.template.action], &problem.unknowns)));
    lines.push(format!("- basis: {}", listed(&file.template.basis, &problem.unknowns)));
    if plan.has_origin {
        let whose = if plan.recovered().next().is_none() {
            "all unknowns"
        } else {
            "all unknowns but those that are recovered"
        };
        lines.push(format!("- {whose} 0 is a solution, whatever the data, and is returned without an eigenvalue"));
    }
    lines.extend(linear_form(problem, reduced));
    for [x, y] in reduced.pairs.iter().map(|pair| pair.map(|unknown| &problem.unknowns[unknown])) {
        lines.push(format!("- `{x}` and `{y}` stand for ({x} + {y}) / 2 and ({x} - {y}) / 2 in all monomials"));
    }
    let names: Vec<_> = plan.eliminated().iter().map(|&unknown| format!("`{}`", problem.unknowns[unknown])).collect();
    if !names.is_empty() {
        lines.push(format!("- eliminated beforehand and recovered afterwards: {}", names.join(", ")));
    }
    let (equations, from) = match file.presolve {
        Presolve::None => ("the equations".to_owned(), ""),
        presolve => (format!("the equations that presolve (`{}`) leaves", presolve.name()), "from "),
    };
    lines.extend([String::new(), format!("Rows are multiples of {equations}:"), String::new()]);
    for group in file.template.shifts.chunk_by(|a, b| a.equation == b.equation) {
        let multipliers: Vec<Monomial> = group.iter().map(|shift| shift.multiplier).collect();
        let (equation, multipliers) = (group[0].equation, listed(&multipliers, &problem.unknowns));
        let statement = quoted(problem, &reduced.problem.equations[equation]);
        lines.push(format!("- equation {}, {from}{statement}, times {multipliers}", equation + 1));
    }
    lines
}

/// Sizes of the template as it is written and as it is eliminated, and operations of one solve.
fn sizes(template: &EliminationTemplate, plan: &Plan) -> [String; 3] {
    let (e, operations) = (&plan.elimination, plan.operations());
    let largest = e.blocks.iter().map(|block| block.size).max().unwrap_or(0);
    [
        format!(
            "- template: {} x {} ({} excess, {} reducible, {} basis columns)",
            template.rows(),
            template.columns(),
            template.excess.len(),
            template.reducible.len(),
            template.basis.len(),
        ),
        format!(
            "- at run time: {} x {} ({} rows are eliminated beforehand), {} diagonal blocks, the largest of size {largest}",
            e.rows,
            e.columns(),
            template.rows() - e.rows,
            e.blocks.len()
        ),
        format!(
            "- operations: {} for coefficients, {} for the elimination, about {} for the roots",
            operations.coefficients, operations.elimination, operations.roots
        ),
    ]
}

/// `x * equation 2`.
fn row_label(problem: &Problem, shift: &Shift) -> String {
    let equation = format!("equation {}", shift.equation + 1);
    match shift.multiplier {
        Monomial::ONE => equation,
        multiplier => format!("{} * {equation}", multiplier.display(&problem.unknowns)),
    }
}

/// A statement as the problem writes it, without comments, on one line: `` `dot(p, x) == 0` ``.
fn quoted(problem: &Problem, statement: &Statement) -> String {
    let text = problem.source.text.get(statement.span.clone()).unwrap_or_default();
    let lines = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    let words: Vec<&str> = lines.flat_map(str::split_whitespace).collect();
    let mut text = words.join(" ");
    if let Some((end, _)) = text.char_indices().nth(MOST_QUOTED) {
        text.truncate(end);
        text.push_str(" ..");
    }
    match statement.element.as_str() {
        "" => format!("`{text}`"),
        element => format!("`{element}` of `{text}`"),
    }
}

/// Monomials as code, separated by commas.
fn listed(monomials: &[Monomial], unknowns: &[String]) -> String {
    monomials.iter().map(|m| format!("`{}`", m.display(unknowns))).collect::<Vec<_>>().join(", ")
}
