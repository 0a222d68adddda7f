//! The part of the page `speed.md` with all solvers: what `eliminant bench` measured, and what they
//! cost to build.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use serde_json::Value;

use crate::measured::Measured;
use crate::replaced;

/// What stands before and after the part in the page.
const MARKS: [&str; 2] = ["<!-- times:begin -->\n", "<!-- times:end -->\n"];

/// Nanoseconds of the stages, with their heads in the table.
const STAGES: [(&str, &str); 6] = [
    ("coefficients", "data"),
    ("elimination", "elimination"),
    ("eigenvalues", "eigenvalues"),
    ("solutions", "solutions"),
    ("second_attempts", "repeats"),
    ("total", "all"),
];

/// The page with its part written anew, from the report of `eliminant bench` and the tables of the
/// catalogue, which have the size of each template.
///
/// # Errors
/// A message, where the report has no time of a problem.
pub(crate) fn times(report: &str, catalogue: &str, page: &str) -> Result<String, String> {
    let report: Value = serde_json::from_str(report).map_err(|error| format!("times.json: {error}"))?;
    let solvers = report["solvers"].as_array().ok_or("times.json: it has no solvers")?;
    let solvers: BTreeMap<&str, &Value> =
        solvers.iter().filter_map(|solver| Some((solver["problem"].as_str()?, solver))).collect();
    let mut table = "| problem |".to_owned();
    STAGES.iter().for_each(|(_, head)| table.push_str(&format!(" {head} |")));
    table.push_str(" found | source KB | program KB | compile s |\n|---|");
    (0..STAGES.len() + 4).for_each(|_| table.push_str("--:|"));
    table.push('\n');
    let measured = Measured::of(catalogue);
    for problem in measured.problems() {
        let solver = solvers.get(problem).ok_or_else(|| format!("times.json: no times of {problem}"))?;
        let _ = writeln!(table, "{}", row(problem, solver, measured.cell(problem, "template")));
    }
    replaced(page, MARKS, &table).ok_or_else(|| "speed.md: the table of all solvers does not begin or end".to_owned())
}

/// The row of a solver. One with another template than now is marked.
fn row(problem: &str, solver: &Value, template: Option<&str>) -> String {
    let number = |key: &str| solver[key].as_f64().unwrap_or(f64::NAN);
    let timed = format!("{}x{}", solver["rows"], solver["columns"]);
    let mark = if template == Some(&*timed) { "" } else { " (an older template)" };
    let mut row = format!("| {problem}{mark} |");
    for (key, _) in STAGES {
        let _ = write!(row, " {:.0} |", number(key));
    }
    let _ = write!(
        row,
        " {:.1} | {:.0} | {:.0} | {:.1} |",
        number("found"),
        number("source_bytes") / 1000.0,
        number("program_bytes") / 1000.0,
        number("compile_seconds")
    );
    row
}

#[cfg(test)]
mod tests {
    use super::*;

    const CATALOGUE: &str = "| problem | template |\n|---|---|\n| [`a`](a.rs) | 1x3 |\n| [`b`](b.rs) | 2x4 |\n";
    const PAGE: &str = "before\n<!-- times:begin -->\nold\n<!-- times:end -->\nafter\n";

    fn report(problems: [&str; 2]) -> String {
        let solver = |problem: &str| {
            format!(
                r#"{{"problem": "{problem}", "rows": 1, "columns": 3, "coefficients": 1.4, "elimination": 2,
                    "eigenvalues": 0, "solutions": 30, "second_attempts": 0, "total": 33.6, "found": 1.5,
                    "source_bytes": 20400, "program_bytes": 10600, "compile_seconds": 1.26}}"#
            )
        };
        format!(r#"{{"solvers": [{}, {}]}}"#, solver(problems[0]), solver(problems[1]))
    }

    #[test]
    fn solvers_are_listed_by_name_and_old_ones_marked() {
        let page = times(&report(["b", "a"]), CATALOGUE, PAGE).unwrap();
        assert!(page.starts_with("before\n<!-- times:begin -->\n\n| problem | data |"), "{page}");
        assert!(
            page.contains("\n| a | 1 | 2 | 0 | 30 | 0 | 34 | 1.5 | 20 | 11 | 1.3 |\n| b (an older template) | 1 |")
        );
        assert!(page.ends_with("<!-- times:end -->\nafter\n"));
    }

    #[test]
    fn a_problem_without_times_is_an_error() {
        assert_eq!(times(&report(["a", "c"]), CATALOGUE, PAGE), Err("times.json: no times of b".to_owned()));
        assert!(times("{", CATALOGUE, PAGE).is_err() && times(&report(["a", "b"]), CATALOGUE, "").is_err());
    }
}
