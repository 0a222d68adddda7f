//! The tables, for the terminal, for README.md and for the book.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;
use std::{env, fs, io};

use comfy_table::{CellAlignment, Table, presets};

use crate::instructions::Executed;
use crate::stages::STAGES;

/// The marks in README.md between which the table stands.
const MARKS: [&str; 2] = ["<!-- peers:begin -->\n", "<!-- peers:end -->\n"];

/// One side of a row.
pub(crate) struct Measured {
    /// Nanoseconds per solve.
    pub(crate) nanoseconds: f64,
    /// The share of instances of which the truth was found.
    pub(crate) found: f64,
    /// What a solve executes, where it was counted.
    pub(crate) executed: Option<Executed>,
}

/// A peer's side of a row.
pub(crate) struct Theirs {
    pub(crate) measured: Measured,
    /// Time of the peer / our time: the median over the chunks.
    pub(crate) ratio: f64,
    /// How the peer was compiled.
    pub(crate) build: &'static str,
}

/// One row of the table.
pub(crate) struct Row {
    pub(crate) title: &'static str,
    pub(crate) peer: &'static str,
    pub(crate) ours: Measured,
    pub(crate) theirs: Option<Theirs>,
    pub(crate) note: &'static str,
}

/// Heads of the columns; those after the first two are figures.
const HEADS: [&str; 9] = [
    "case",
    "peer",
    "ours, ns",
    "peer, ns",
    "ratio",
    "ours found",
    "peer found",
    "ours, instructions",
    "peer, instructions",
];

/// The names of the peers, by their drivers.
fn name(driver: &str) -> &str {
    if driver == "circles" { "authors' C++" } else { "PoseLib" }
}

/// The table in Markdown, and the notes below it. `instructions`: whether they were counted.
pub(crate) fn markdown(rows: &[Row], instructions: bool) -> String {
    let columns = if instructions { 9 } else { 7 };
    let mut table = Table::new();
    table.load_preset(presets::ASCII_MARKDOWN).set_header(&HEADS[..columns]);
    for row in rows {
        let cell = |value: Option<String>| value.unwrap_or_default();
        let theirs = row.theirs.as_ref();
        let share = |measured: &Measured| format!("{:.2} %", 100.0 * measured.found);
        let count = |measured: &Measured| measured.executed.map(|executed| format!("{:.0}", executed.instructions));
        let cells = [
            row.title.to_owned(),
            name(row.peer).to_owned(),
            format!("{:.0}", row.ours.nanoseconds),
            cell(theirs.map(|theirs| format!("{:.0}", theirs.measured.nanoseconds))),
            cell(theirs.map(|theirs| format!("{:.2}", theirs.ratio))),
            share(&row.ours),
            cell(theirs.map(|theirs| share(&theirs.measured))),
            cell(count(&row.ours)),
            cell(theirs.and_then(|theirs| count(&theirs.measured))),
        ];
        table.add_row(&cells[..columns]);
    }
    table.column_iter_mut().skip(2).for_each(|column| column.set_cell_alignment(CellAlignment::Right));
    let mut text = format!("{table}\n");
    for row in rows.iter().filter(|row| !row.note.is_empty()) {
        // A string takes all that is written.
        let _ = write!(text, "\n- {}:\n  {}.", row.title, row.note);
    }
    text.push('\n');
    text
}

/// Where the instructions of our side go, in Markdown, and what is left if only operations count.
pub(crate) fn stages(rows: &[Row]) -> String {
    let mut table = Table::new();
    let heads = ["ours", "operations", "peer", "operations"];
    let heads = STAGES.iter().map(|&(_, head)| head).chain(heads);
    table.load_preset(presets::ASCII_MARKDOWN).set_header(["case"].into_iter().chain(heads));
    for row in rows {
        let Some(ours) = row.ours.executed else { continue };
        let theirs = row.theirs.as_ref().and_then(|theirs| theirs.measured.executed);
        let counts = ours.stages.unwrap_or_default().into_iter().chain([ours.instructions, ours.operations]);
        let counts = counts.map(Some).chain([theirs.map(|it| it.instructions), theirs.map(|it| it.operations)]);
        let cells = counts.map(|count| count.map_or_else(String::new, |count| format!("{count:.0}")));
        table.add_row([row.title.to_owned()].into_iter().chain(cells));
    }
    table.column_iter_mut().skip(1).for_each(|column| column.set_cell_alignment(CellAlignment::Right));
    format!("{table}\n")
}

/// Writes the table of stages into the book.
pub(crate) fn update_book(table: &str) -> io::Result<()> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/book/src/speed.md");
    replace_between(&path, ["<!-- stages:begin -->\n", "<!-- stages:end -->\n"], &format!("\n{table}\n"))
}

/// Replaces what stands between two marks of a file.
fn replace_between(path: &Path, marks: [&str; 2], new: &str) -> io::Result<()> {
    let text = fs::read_to_string(path)?;
    let missing = || io::Error::other(format!("{} has no marks for the table", path.display()));
    let (before, rest) = text.split_once(marks[0]).ok_or_else(missing)?;
    let (_, after) = rest.split_once(marks[1]).ok_or_else(missing)?;
    fs::write(path, [before, marks[0], new, marks[1], after].concat())
}

/// Writes the table into README.md, with machine and date.
pub(crate) fn update_readme(table: &str, instances: u64, rounds: u64) -> io::Result<()> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../README.md");
    let machine = format!(
        "One core of {}, {};\n{}, {}.\n{instances} instances a row, {rounds} chunks:\n\n",
        processor(),
        line_of("date", &["-u", "+%F"]),
        line_of("rustc", &["--version"]).split(" (").next().unwrap_or_default(),
        line_of(&env::var("CXX").unwrap_or_else(|_| "c++".to_owned()), &["--version"]),
    );
    replace_between(&path, MARKS, &format!("{machine}{table}"))
}

/// The name of the processor, where the system tells it.
fn processor() -> String {
    let text = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = text.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": "));
    name.map_or_else(|| "a processor without a name".to_owned(), |(_, name)| name.to_owned())
}

/// The first line that a program prints.
fn line_of(program: &str, arguments: &[&str]) -> String {
    let output = Command::new(program).args(arguments).output();
    let text = output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned()).unwrap_or_default();
    text.lines().next().unwrap_or_default().to_owned()
}
