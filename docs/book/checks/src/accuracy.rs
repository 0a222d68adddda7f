//! The part of the page `accuracy.md` that is written from `templates/README.md`: how accurate
//! solvers are, beside what they were before they were made faster.

use std::fmt::Write as _;

use crate::measured::Measured;
use crate::replaced;

/// What stands before and after the part in the page.
const MARKS: [&str; 2] = ["<!-- accuracy:begin -->\n", "<!-- accuracy:end -->\n"];

/// The columns of `templates/README.md` at commit 373cead, of 23 November 2026, that are compared.
const BEFORE: &str = include_str!("accuracy_before.csv");

/// A figure: its column, its name here, whether more is better, and what counts as a difference.
struct Figure {
    column: &'static str,
    name: &'static str,
    more_is_better: bool,
    step: f64,
}

/// Shares have four decimals, of 10,000 scenes as a rule: one scene is no difference. Logarithms
/// have one decimal.
const FIGURES: [Figure; 4] = [
    Figure { column: "recovered", name: "known solution found", more_is_better: true, step: 1.5e-4 },
    Figure { column: "p99", name: "p99 residual, random", more_is_better: false, step: 0.25 },
    Figure { column: "scene p99", name: "p99 residual, scenes", more_is_better: false, step: 0.25 },
    Figure { column: "forward p99", name: "p99 error, scenes", more_is_better: false, step: 0.25 },
];

/// The page with its part written anew.
///
/// # Errors
/// A message, where the page has no such part.
pub fn accuracy(catalogue: &str, page: &str) -> Result<String, String> {
    let [before, now] = [rows(BEFORE), rows_of(&Measured::of(catalogue))];
    let part = format!("{}\n{}", counts(&before, &now), table(&before, &now));
    replaced(page, MARKS, &part).ok_or_else(|| "accuracy.md: the part does not begin or does not end".to_owned())
}

/// A problem, with the cells of all figures.
type Row = (String, [String; FIGURES.len()]);

/// The rows of a file whose first line names the columns.
fn rows(text: &str) -> Vec<Row> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let columns: Vec<usize> = {
        let header = reader.headers().expect("the file is committed");
        let position = |figure: &Figure| header.iter().position(|column| column == figure.column);
        FIGURES.iter().map(|figure| position(figure).expect("a column of this figure")).collect()
    };
    let row = |record: csv::StringRecord| {
        let cells = std::array::from_fn(|figure| record[columns[figure]].to_owned());
        (record[0].to_owned(), cells)
    };
    reader.records().map(|record| row(record.expect("the file is committed"))).collect()
}

/// The rows of all problems that are measured.
fn rows_of(measured: &Measured) -> Vec<Row> {
    let cell = |problem: &str, figure: &Figure| measured.cell(problem, figure.column).unwrap_or_default().to_owned();
    let row = |problem: &str| (problem.to_owned(), FIGURES.each_ref().map(|figure| cell(problem, figure)));
    measured.problems().map(row).collect()
}

/// The same problem in both, with its cells before and now.
fn pairs<'a>(before: &'a [Row], now: &'a [Row]) -> impl Iterator<Item = (&'a Row, &'a Row)> {
    before.iter().filter_map(|row| Some((row, now.iter().find(|other| other.0 == row.0)?)))
}

/// How much better a figure is now: in its unit, below 0 if it is worse.
fn gain(figure: &Figure, before: &str, now: &str) -> Option<f64> {
    let difference = now.parse::<f64>().ok()? - before.parse::<f64>().ok()?;
    Some(if figure.more_is_better { difference } else { -difference })
}

/// For each figure the number of problems for which it is better, alike and worse, and which ones
/// are worse.
fn counts(before: &[Row], now: &[Row]) -> String {
    let mut table =
        "| figure | problems | better | alike | worse | those that are worse |\n|---|---|---|---|---|---|\n".to_owned();
    for (at, figure) in FIGURES.iter().enumerate() {
        let gains: Vec<(&str, f64)> = pairs(before, now)
            .filter_map(|(one, other)| Some((one.0.as_str(), gain(figure, &one.1[at], &other.1[at])?)))
            .collect();
        let better = gains.iter().filter(|(_, gain)| *gain > figure.step).count();
        let worse: Vec<String> =
            gains.iter().filter(|(_, gain)| *gain < -figure.step).map(|(name, _)| format!("`{name}`")).collect();
        let count = gains.len();
        let alike = count - better - worse.len();
        let _ = writeln!(
            table,
            "| {} | {count} | {better} | {alike} | {} | {} |",
            figure.name,
            worse.len(),
            worse.join(", ")
        );
    }
    table
}

/// All figures, before and now.
fn table(before: &[Row], now: &[Row]) -> String {
    let names: Vec<&str> = FIGURES.iter().map(|figure| figure.name).collect();
    let mut table = format!("| problem | {} |\n|---|---|---|---|---|\n", names.join(" | "));
    for (one, other) in pairs(before, now) {
        let cells: Vec<String> = one
            .1
            .iter()
            .zip(&other.1)
            .map(|(before, now)| if before.is_empty() { "–".into() } else { format!("{before} → {now}") })
            .collect();
        let _ = writeln!(table, "| [`{}`](gallery.md#{}) | {} |", one.0, one.0, cells.join(" | "));
    }
    table
}
