//! The part of the page `comparison.md` that is written from `templates/README.md`: how many rows
//! templates have beside published ones.

use std::cmp::Ordering;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use crate::measured::{Measured, PUBLISHED, rows};
use crate::{page, replaced};

/// What stands before and after the part in the page.
const MARKS: [&str; 2] = ["<!-- sizes:begin -->\n", "<!-- sizes:end -->\n"];

/// The columns of ours: the committed template, and the one with the fewest rows.
const OURS: [&str; 2] = ["template", "fewest rows"];

/// Templates in code that no generator's publication lists: problem, rows x columns, and where.
const IN_CODE: [(&str, &str, &str); 4] = [
    ("circle_least_squares", "25x34", "the paper on cylinder triangulation; 58x67 in its published code"),
    ("pose_35pt_focal", "25x35", "PoseLib, `p35pf`"),
    ("relpose_6pt_focal", "31x46", "PoseLib, `relpose_6pt_focal`"),
    ("relpose_6pt_generalized", "99x163", "PoseLib, `gen_relpose_6pt`"),
];

/// The page with its part written anew.
///
/// # Errors
/// A message, where the page has no such part or the tables of the catalogue cannot be read.
pub fn comparison(root: &Path) -> Result<String, String> {
    let path = root.join("templates/README.md");
    let text = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    let measured = Measured::of(&text);
    let page = page("comparison.md");
    let part = [
        format!("### Fewer rows, as many, or more\n\n{}", counts(&measured)),
        format!("### Rows x columns by problem\n\n{}", sizes(&measured)),
        format!("### In other code\n\n{}", in_code(&measured)),
        format!("### Errors and failures\n\n{}", accuracy(&measured)),
    ];
    replaced(&page, MARKS, &part.join("\n")).ok_or_else(|| "comparison.md: the part does not begin or end".to_owned())
}

/// A table of how many templates have fewer rows, as many and more than those of each publication.
fn counts(measured: &Measured) -> String {
    let mut table = "| beside | problems | fewer | as many | more | fewest: fewer | as many | more |\n\
                     |---|---|---|---|---|---|---|---|\n"
        .to_owned();
    let mut line = |name: &str, published: &dyn Fn(&str) -> Option<usize>| {
        let compared = OURS.map(|column| {
            let pairs = measured.problems().filter_map(|problem| {
                let ours = measured.cell(problem, column).and_then(rows)?;
                Some(ours.cmp(&published(problem)?))
            });
            pairs.collect::<Vec<Ordering>>()
        });
        let count = |of: &[Ordering], what| of.iter().filter(|&&order| order == what).count();
        let _ = write!(table, "| {name} | {} |", compared[0].len());
        for of in &compared {
            for what in [Ordering::Less, Ordering::Equal, Ordering::Greater] {
                let _ = write!(table, " {} |", count(of, what));
            }
        }
        table.push('\n');
    };
    for column in PUBLISHED {
        line(column, &|problem| measured.cell(problem, column).and_then(rows));
    }
    line("the smallest of them", &|problem| measured.smallest_published(problem).and_then(rows));
    table
}

/// A table of all problems that are published.
fn sizes(measured: &Measured) -> String {
    let mut table =
        format!("| problem | {} | ours | fewest rows |\n|---|---|---|---|---|---|\n", PUBLISHED.join(" | "));
    for problem in measured.problems().filter(|problem| measured.smallest_published(problem).is_some()) {
        let cells = PUBLISHED.iter().chain(&OURS).map(|column| measured.cell(problem, column).unwrap_or("–"));
        let cells: Vec<&str> = cells.collect();
        let _ = writeln!(table, "| [`{problem}`](gallery.md#{problem}) | {} |", cells.join(" | "));
    }
    table
}

/// A table of templates in code.
fn in_code(measured: &Measured) -> String {
    let mut table = "| problem | ours | other | where |\n|---|---|---|---|\n".to_owned();
    for (problem, size, place) in IN_CODE {
        let ours = measured.cell(problem, "template").unwrap_or("–");
        let _ = writeln!(table, "| [`{problem}`](gallery.md#{problem}) | {ours} | {size} | {place} |");
    }
    table
}

/// A table of how many solvers are more precise than the published ones of 2023, and fail less.
fn accuracy(measured: &Measured) -> String {
    let figure = |problem: &str, column: &str| measured.cell(problem, column)?.parse::<f64>().ok();
    let mut table = "| figure | problems | ours better | alike | theirs better |\n|---|---|---|---|---|\n".to_owned();
    let alike = [
        ("median error, to a digit", "unpolished median", "its median", 1.0),
        ("99 % quantile, to a digit", "unpolished p99", "its p99", 1.0),
        ("failures, to 1 in 100", "unpolished failures", "its failures", 0.01),
        ("failures after our polish, to 1 in 100", "failures", "its failures", 0.01),
    ];
    for (name, ours, theirs, step) in alike {
        let differences: Vec<f64> =
            measured.problems().filter_map(|problem| Some(figure(problem, ours)? - figure(problem, theirs)?)).collect();
        let better = differences.iter().filter(|&&difference| difference < -step).count();
        let worse = differences.iter().filter(|&&difference| difference > step).count();
        let count = differences.len();
        let _ = writeln!(table, "| {name} | {count} | {better} | {} | {worse} |", count - better - worse);
    }
    table
}
