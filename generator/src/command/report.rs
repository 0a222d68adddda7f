//! What the subcommands print: text for people, or one JSON object.

use std::fmt;

use serde::Serialize;

use super::error::CommandError;
use super::folded::folded;
use crate::plan::Plan;
use crate::problem::Problem;
use crate::template::EliminationTemplate;

/// A result as text and as JSON, each with its final line break.
pub(super) struct Output {
    pub(super) text: String,
    pub(super) json: String,
    /// Whether the report says that a file is at fault, which the exit status tells.
    pub(super) is_at_fault: bool,
}

impl Output {
    /// A report as text and as JSON. Long lines of the text are folded.
    pub(super) fn of(report: &(impl Serialize + fmt::Display)) -> Self {
        Self { text: folded(&report.to_string()), ..Self::verbatim(report) }
    }

    /// As [`Output::of`], with the text as it is: code and scripts.
    pub(super) fn verbatim(report: &(impl Serialize + fmt::Display)) -> Self {
        Self { text: report.to_string(), json: to_json(report), is_at_fault: false }
    }

    /// The same report, with the exit status of a fault if there is one.
    pub(super) fn at_fault_if(self, is_at_fault: bool) -> Self {
        Self { is_at_fault, ..self }
    }
}

/// `{"error": ".."}`
pub(super) fn error_json(error: &CommandError) -> String {
    to_json(&serde_json::json!({ "error": error.to_string() }))
}

/// Numbers that are not finite become `null`.
pub(super) fn to_json(value: &impl Serialize) -> String {
    // Only a map with keys other than strings, or a writer, can fail.
    serde_json::to_string_pretty(value).unwrap_or_default() + "\n"
}

/// The beginning of every report on a template.
#[derive(Debug, Serialize)]
pub(super) struct Summary {
    problem: String,
    unknowns: usize,
    unknown_names: Vec<String>,
    equations: usize,
    solutions: usize,
    rows: usize,
    columns: usize,
    excess: usize,
    reducible: usize,
    /// |B|.
    basis: usize,
    /// Rows and columns at run time, without the rows and pivots that are eliminated
    /// beforehand.
    online_rows: usize,
    online_columns: usize,
    basis_monomials: Vec<String>,
    action: String,
    /// The unknowns in whose places linear forms stand in monomials.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    linear_forms: Vec<String>,
    operations: usize,
    operation_counts: OperationCounts,
    /// Predicted nanoseconds of a solve without a second attempt.
    nanoseconds: f64,
}

#[derive(Debug, Serialize)]
struct OperationCounts {
    coefficients: usize,
    elimination: usize,
    roots: usize,
}

impl Summary {
    pub(super) fn new(problem: &Problem, template: &EliminationTemplate, plan: &Plan) -> Self {
        let operations = plan.operations();
        let names = &problem.unknowns;
        Self {
            problem: problem.name.clone(),
            unknowns: names.len(),
            unknown_names: names.clone(),
            equations: problem.equations.len(),
            solutions: plan.solutions,
            rows: template.rows(),
            columns: template.columns(),
            excess: template.excess.len(),
            reducible: template.reducible.len(),
            basis: template.basis.len(),
            online_rows: plan.elimination.rows,
            online_columns: plan.elimination.columns(),
            basis_monomials: template.basis.iter().map(|m| m.display(names).to_string()).collect(),
            action: template.action.display(names).to_string(),
            linear_forms: plan.replaced().iter().map(|&unknown| names[unknown].clone()).collect(),
            operations: operations.total(),
            operation_counts: OperationCounts {
                coefficients: operations.coefficients,
                elimination: operations.elimination,
                roots: operations.roots,
            },
            nanoseconds: plan.predicted_nanoseconds(0.0).round(),
        }
    }
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let counts = &self.operation_counts;
        writeln!(f, "problem     {}: {}", self.problem, counted(self.solutions, "solution"))?;
        writeln!(f, "unknowns    {} ({})", self.unknowns, self.unknown_names.join(", "))?;
        writeln!(f, "equations   {}", self.equations)?;
        writeln!(
            f,
            "template    {} x {}: {} excess, {} reducible, {} basis columns",
            self.rows, self.columns, self.excess, self.reducible, self.basis
        )?;
        if self.online_rows < self.rows {
            let constant = counted(self.rows - self.online_rows, "constant row");
            let (rows, columns) = (self.online_rows, self.online_columns);
            writeln!(f, "at run time {rows} x {columns}: {constant} eliminated beforehand")?;
        }
        writeln!(f, "action      {}", self.action)?;
        match &self.linear_forms[..] {
            [] => {}
            [one] => writeln!(f, "form        a linear form stands in the place of {one} in all monomials")?,
            more => {
                writeln!(f, "forms       linear forms stand in the places of {} in all monomials", more.join(", "))?;
            }
        }
        writeln!(f, "basis       {}", self.basis_monomials.join(", "))?;
        writeln!(
            f,
            "operations  {} = {} for coefficients + {} for the elimination + about {} for the roots",
            self.operations, counts.coefficients, counts.elimination, counts.roots
        )?;
        writeln!(f, "time        {} ns, predicted", self.nanoseconds)
    }
}

/// `1 solution`, `4 solutions`.
pub(super) fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}

/// Seconds to the millisecond, for people.
pub(super) fn seconds(seconds: f64) -> String {
    format!("{seconds:.3} s")
}

/// A number to one decimal, or `-` if there is no number.
pub(super) fn one_decimal(value: Option<f64>) -> String {
    value.map_or_else(|| "-".to_owned(), |value| format!("{value:.1}"))
}

/// Rows of cells under a head, columns aligned: the first `left` of them to the left, the others to
/// the right.
pub(super) fn table(head: &[&str], rows: &[Vec<String>], left: usize) -> String {
    let head: Vec<String> = head.iter().map(|&cell| cell.to_owned()).collect();
    let all = || std::iter::once(&head).chain(rows);
    let width =
        |column: usize| all().filter_map(|row| row.get(column)).map(|cell| cell.chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..head.len()).map(width).collect();
    let line = |row: &Vec<String>| {
        let cells = row.iter().zip(&widths).enumerate().map(|(column, (cell, &width))| match column < left {
            true => format!("{cell:<width$}"),
            false => format!("{cell:>width$}"),
        });
        cells.collect::<Vec<_>>().join("  ").trim_end().to_owned() + "\n"
    };
    all().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn code_is_not_folded() {
        let wide = "x".repeat(90);
        let code = format!("/// A comment  {wide} {wide}\n");
        assert_eq!(Output::verbatim(&code).text, code);
        assert_ne!(Output::of(&code).text, code);
    }
}
