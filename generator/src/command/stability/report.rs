//! The report as text, JSON and CSV.

use std::collections::BTreeMap;
use std::fmt::{self, Write as _};
use std::path::Path;

use serde::Serialize;

use super::Subject;
use super::baseline::Worse;
use super::figures::{FIRST, Quantiles, Row, WIDTH};
use super::measure::Measured;
use super::outcome::Outcome;
use crate::command::report::{Summary, counted, one_decimal, seconds, table};
use crate::oracle::BITS;

/// All that is printed.
#[derive(Serialize)]
pub(super) struct StabilityReport {
    solvers: Vec<SolverReport>,
    rows: Vec<Row>,
    /// The worst instances of each problem.
    worst: Vec<Seen>,
    /// All instances, of a replay.
    replayed: Vec<Seen>,
    pub(super) check: Option<Checked>,
    pub(super) trials: u64,
    pub(super) seed: u64,
    /// Whether emitted code was run.
    pub(super) is_emitted: bool,
    /// Bits of the numbers of the oracle.
    bits: u32,
    /// The first edge and the width of the bins of histograms, as log10 of a residual.
    bins: [f64; 2],
    pub(super) seconds: f64,
}

#[derive(Serialize)]
struct SolverReport {
    file: String,
    #[serde(flatten)]
    summary: Summary,
}

/// An instance, and what came of it.
#[derive(Serialize)]
struct Seen {
    problem: String,
    family: String,
    level: Option<f64>,
    /// The judgement in words.
    words: String,
    is_faulty: bool,
    /// What the file says of it.
    note: Option<String>,
    #[serde(flatten)]
    outcome: Outcome,
    data: Vec<f64>,
}

/// The comparison with a baseline.
#[derive(Serialize)]
pub(super) struct Checked {
    baseline: String,
    /// Problems and families that were compared.
    compared: usize,
    worse: Vec<Worse>,
}

impl Checked {
    pub(super) fn of(path: &Path, (worse, compared): (Vec<Worse>, usize)) -> Self {
        Self { baseline: path.display().to_string(), compared, worse }
    }
}

/// Problem, family and level.
type Name<'a> = (&'a str, &'a str, Option<f64>);

/// The outcomes of each problem and family, in the order of their first instances; of each level by
/// itself, from the lowest on, if `by_level` says so.
pub(super) fn groups(measured: &[Measured], by_level: bool) -> Vec<(Name<'_>, Vec<&Outcome>)> {
    let mut groups: Vec<(Name<'_>, Vec<&Outcome>)> = Vec::new();
    let mut places: BTreeMap<(&str, &str, Option<u64>), usize> = BTreeMap::new();
    for Measured { instance, outcome } in measured {
        let level = instance.level.filter(|_| by_level);
        let name = (instance.problem.as_str(), instance.family.as_str(), level);
        let place = *places.entry((name.0, name.1, level.map(f64::to_bits))).or_insert_with(|| {
            groups.push((name, Vec::new()));
            groups.len() - 1
        });
        groups[place].1.push(outcome);
    }
    let first = |family: &str| measured.iter().position(|measured| measured.instance.family == family);
    let level = |name: &Name<'_>| name.2.unwrap_or(f64::NEG_INFINITY);
    groups.sort_by(|(a, _), (b, _)| first(a.1).cmp(&first(b.1)).then(level(a).total_cmp(&level(b))));
    groups
}

impl Seen {
    fn of(Measured { instance, outcome }: &Measured) -> Self {
        Self {
            problem: instance.problem.clone(),
            family: instance.family.clone(),
            level: instance.level,
            words: outcome.words(),
            is_faulty: outcome.is_faulty(),
            note: instance.note.clone(),
            outcome: outcome.clone(),
            data: instance.data.clone(),
        }
    }

    fn cells(&self) -> Vec<String> {
        let level = self.level.map_or_else(String::new, |level| level.to_string());
        vec![self.problem.clone(), self.family.clone(), level, self.words.clone()]
    }
}

impl StabilityReport {
    pub(super) fn new(subjects: &[Subject], measured: &[Vec<Measured>], worst: &[&Measured], is_replay: bool) -> Self {
        let solver = |subject: &Subject| SolverReport {
            file: subject.file.display().to_string(),
            summary: Summary::new(&subject.loaded.problem, &subject.loaded.file.template, &subject.loaded.planned.plan),
        };
        let rows = measured.iter().flat_map(|measured| groups(measured, true));
        Self {
            solvers: subjects.iter().map(solver).collect(),
            rows: rows.map(|(name, outcomes)| Row::of(name, &outcomes)).collect(),
            worst: worst.iter().map(|measured| Seen::of(measured)).collect(),
            replayed: measured.iter().flatten().filter(|_| is_replay).map(Seen::of).collect(),
            check: None,
            trials: 0,
            seed: 0,
            is_emitted: false,
            bits: BITS,
            bins: [FIRST, WIDTH],
            seconds: 0.0,
        }
    }

    /// Whether a figure got worse than the baseline.
    pub(super) fn is_worse(&self) -> bool {
        self.check.as_ref().is_some_and(|check| !check.worse.is_empty())
    }

    /// The figures as CSV, a row for each problem, family and level.
    pub(super) fn csv(&self) -> String {
        let mut text = CSV_HEAD.join(",") + "\n";
        for row in &self.rows {
            let number = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
            let mut cells = vec![quoted(&row.problem), quoted(&row.family), number(row.level)];
            let counts = [row.instances, row.failed, row.incomplete, row.wrong, row.uncertain];
            let of = |count: &super::outcome::Count| [count.expected, count.missed, count.spurious];
            let rest = [row.known, row.known_missed, row.repeated, row.repeated_complex];
            let counts = counts.into_iter().chain(of(&row.real)).chain(of(&row.complex)).chain(rest);
            cells.extend(counts.map(|count| count.to_string()));
            for Quantiles { median, p99, max } in
                [row.residual, row.forward_error, row.nanoseconds, row.growth, row.closeness]
            {
                cells.extend([median, p99, max].map(number));
            }
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{}", cells.join(","));
        }
        text
    }
}

const CSV_HEAD: [&str; 33] = [
    "problem",
    "family",
    "level",
    "instances",
    "failed",
    "incomplete",
    "wrong",
    "uncertain",
    "real",
    "real_missed",
    "real_spurious",
    "complex",
    "complex_missed",
    "complex_spurious",
    "known",
    "known_missed",
    "repeated",
    "repeated_complex",
    "residual_log10_median",
    "residual_log10_p99",
    "residual_log10_max",
    "forward_error_log10_median",
    "forward_error_log10_p99",
    "forward_error_log10_max",
    "nanoseconds_median",
    "nanoseconds_p99",
    "nanoseconds_max",
    "growth_log10_median",
    "growth_log10_p99",
    "growth_log10_max",
    "closeness_log10_median",
    "closeness_log10_p99",
    "closeness_log10_max",
];

/// A cell of CSV: names from files may hold commas and quotes.
fn quoted(text: &str) -> String {
    match text.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_owned(),
    }
}

const HEAD_OF_SOLUTIONS: [&str; 9] =
    ["family", "level", "N", "failed", "real missed", "complex missed", "spurious", "uncertain", "repeated"];
const HEAD_OF_ACCURACY: [&str; 8] = ["family", "level", "residual", "p99", "error", "p99", "max", "growth"];
const TIMES: [&str; 3] = ["ns", "p99", "worst"];

fn name_of(row: &Row) -> Vec<String> {
    vec![row.family.clone(), row.level.map_or_else(String::new, |level| level.to_string())]
}

/// What follows them where solutions came with the instances.
const KNOWN: &str = "known missed";

fn cells_of_solutions(row: &Row, has_known: bool) -> Vec<String> {
    let share = |part: usize, whole: usize| format!("{part}/{whole}");
    let mut cells = name_of(row);
    cells.extend([row.instances, row.failed].map(|count| count.to_string()));
    cells.extend([&row.real, &row.complex].map(|count| share(count.missed, count.expected)));
    cells.extend(has_known.then(|| share(row.known_missed, row.known)));
    let spurious = row.real.spurious + row.complex.spurious;
    cells.extend([spurious, row.uncertain, row.repeated_complex].map(|count| count.to_string()));
    cells
}

fn cells_of_accuracy(row: &Row, is_emitted: bool) -> Vec<String> {
    let mut cells = name_of(row);
    let (residual, error) = (row.residual, row.forward_error);
    cells.extend([residual.median, residual.p99, error.median, error.p99, error.max, row.growth.max].map(one_decimal));
    if is_emitted {
        let Quantiles { median, p99, max } = row.nanoseconds;
        cells.extend([median, p99, max].map(|ns| ns.map_or_else(|| "-".to_owned(), |ns| format!("{ns:.0}"))));
    }
    cells
}

/// A table with the name of each problem above its rows, if there are several problems.
fn by_problem(head: &[&str], rows: &[Row], cells: impl Fn(&Row) -> Vec<String>) -> String {
    let table = table(head, &rows.iter().map(cells).collect::<Vec<_>>(), 1);
    let mut lines = table.split_inclusive('\n');
    let mut text = lines.next().unwrap_or_default().to_owned();
    let is_one = rows.iter().all(|row| row.problem == rows[0].problem);
    for (at, (row, line)) in rows.iter().zip(lines).enumerate() {
        if !is_one && (at == 0 || rows[at - 1].problem != row.problem) {
            text += &format!("{}:\n", row.problem);
        }
        text += line;
    }
    text
}

impl fmt::Display for StabilityReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let [SolverReport { summary, .. }] = &self.solvers[..] {
            writeln!(f, "{summary}")?;
        }
        let how = if self.is_emitted { "emitted code" } else { "interpreted plans" };
        writeln!(f, "{how}, seed {}; residuals, errors and growth are log10:\n", self.seed)?;
        let has_known = self.rows.iter().any(|row| row.known > 0);
        let mut head = HEAD_OF_SOLUTIONS.to_vec();
        if has_known {
            head.insert(6, KNOWN);
        }
        writeln!(f, "{}", by_problem(&head, &self.rows, |row| cells_of_solutions(row, has_known)))?;
        let mut head = HEAD_OF_ACCURACY.to_vec();
        head.extend(TIMES.iter().filter(|_| self.is_emitted));
        write!(f, "{}", by_problem(&head, &self.rows, |row| cells_of_accuracy(row, self.is_emitted)))?;
        writeln!(
            f,
            "
missed: true solutions that no returned point approximates, of all that there are{};
spurious: returned points that are no solution;
uncertain: instances whose number of solutions is not certain;
repeated: instances on which all solutions took a second attempt;
growth: the largest of the elimination",
            if has_known { ",\nor of those that came with the instances" } else { "" }
        )?;
        let (title, seen) = match self.replayed.is_empty() {
            true => ("worst instances", self.worst.iter().filter(|seen| seen.is_faulty).collect::<Vec<_>>()),
            false => ("instances", self.replayed.iter().collect()),
        };
        if !seen.is_empty() {
            let rows: Vec<Vec<String>> = seen.iter().map(|seen| seen.cells()).collect();
            writeln!(f, "\n{title}:\n\n{}", table(&["problem", "family", "level", ""], &rows, 4).trim_end())?;
        }
        if let Some(check) = &self.check {
            let compared = counted(check.compared, "set");
            writeln!(f, "\n{compared} of figures compared with {}", check.baseline)?;
            for Worse { problem, family, figure } in &check.worse {
                writeln!(f, "worse: {problem}, {family}: {figure}")?;
            }
        }
        writeln!(f, "\nall took {}", seconds(self.seconds))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command::stability::instance::Instance;

    fn measured(family: &str, level: Option<f64>) -> Measured {
        let instance = Instance {
            problem: "p".into(),
            family: family.into(),
            level,
            data: Vec::new(),
            solutions: Vec::new(),
            results: Vec::new(),
            note: None,
        };
        Measured { instance, outcome: Outcome::default() }
    }

    #[test]
    fn groups_are_in_the_order_of_families_and_levels() {
        let all = [("b", Some(-2.0)), ("b", Some(-4.0)), ("a", None), ("b", Some(-2.0))].map(|(f, l)| measured(f, l));
        let names = |by_level| groups(&all, by_level).into_iter().map(|(n, o)| (n.1, n.2, o.len())).collect::<Vec<_>>();
        assert_eq!(names(true), [("b", Some(-4.0), 1), ("b", Some(-2.0), 2), ("a", None, 1)]);
        assert_eq!(names(false), [("b", None, 3), ("a", None, 1)]);
    }

    #[test]
    fn every_row_has_a_cell_for_each_column() {
        let all = [measured("with, comma", None)];
        let report = StabilityReport::new(&[], &[all.into()], &[], false);
        let csv = report.csv();
        let line = csv.lines().nth(1).unwrap();
        assert!(line.starts_with("p,\"with, comma\",,1,"), "{line}");
        assert_eq!(line.matches(',').count() - 1, CSV_HEAD.len() - 1);
        for has_known in [false, true] {
            let cells = cells_of_solutions(&report.rows[0], has_known);
            assert_eq!(cells.len(), HEAD_OF_SOLUTIONS.len() + usize::from(has_known));
        }
        assert_eq!(cells_of_accuracy(&report.rows[0], true).len(), HEAD_OF_ACCURACY.len() + TIMES.len());
    }
}
