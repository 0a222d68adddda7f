//! Prints the C header.

use std::fmt::Write as _;

use crate::interface::{Field, Interface, MEASURES, Mean, Parameter, Row};

/// What all libraries declare; `@name@` and `@NAME@` stand for the prefix.
const PRELUDE: &str = include_str!("prelude.h");
/// The most columns of a line.
const COLUMNS: usize = 100;

/// The header `PREFIX.h` of a library: codes, and the functions of all problems.
#[must_use]
pub fn header(prefix: &str, interfaces: &[Interface]) -> String {
    let (start, end) = PRELUDE.split_once("@problems@\n").unwrap_or((PRELUDE, ""));
    let problems: String = interfaces.iter().map(|interface| problem(prefix, interface)).collect();
    [&with_prefix(start, prefix), problems.as_str(), &with_prefix(end, prefix)].concat()
}

/// A prelude with the prefix put in.
pub(crate) fn with_prefix(prelude: &str, prefix: &str) -> String {
    let text = prelude.replace("@name@", prefix).replace("@NAME@", &prefix.to_uppercase());
    text.replace("@version@", env!("CARGO_PKG_VERSION"))
}

fn problem(prefix: &str, interface: &Interface) -> String {
    let mut text = format!("/*\n * {}\n *\n", interface.name);
    comment(&mut text, &interface.docs);
    let mut facts = String::new();
    fact(&mut facts, "Data", &interface.data);
    for row in &interface.rows {
        let what = if row.suffix.is_empty() { "unknowns".to_owned() } else { format!("result {}", row.what) };
        fact(&mut facts, &format!("A row of {} numbers, the {what}", row.len()), &row.fields);
    }
    if !interface.docs.is_empty() {
        text.push_str(" *\n");
    }
    text.push_str(&facts);
    text.push_str(" */\n");
    for (name, value) in constants(prefix, interface) {
        let _ = writeln!(text, "#define {name} {value}");
    }
    for row in &interface.rows {
        for (name, parameters) in [interface.solve(row), interface.solve_with(row), interface.solve_batch(row)] {
            text.push_str(&declaration(prefix, &name, &parameters));
        }
    }
    for measure in MEASURES {
        let (name, parameters) = interface.measure(measure);
        text.push_str(&declaration(prefix, &name, &parameters));
    }
    let _ = writeln!(text, "uint64_t {prefix}_{}(void);", interface.second_attempt_operations());
    for mean in &interface.means {
        let (name, parameters) = interface.mean(mean);
        text.push_str(&mean_comment(mean));
        text.push_str(&declaration(prefix, &name, &parameters));
    }
    text.push('\n');
    text
}

/// What stands before the function of a mean.
fn mean_comment(mean: &Mean) -> String {
    let mut text = "/*\n".to_owned();
    comment(&mut text, &mean.docs);
    let shape: String = mean.shape.iter().map(|length| format!("[{length}]")).collect();
    fact(&mut text, &format!("Mean mean{shape} over measurements of"), &mean.measurement);
    text.push_str(" */\n");
    text
}

/// All macros of a problem.
pub(crate) fn constants(prefix: &str, interface: &Interface) -> Vec<(String, usize)> {
    let name = |what: &str| format!("{prefix}_{}_{what}", interface.name).to_uppercase();
    let lists = interface.data.iter().filter(|field| !field.shape.is_empty());
    let lengths = lists.map(|field| (name(&format!("{}_length", field.name)), field.len()));
    let rows = interface.rows.iter().map(|row| (name(&length_of_row(row)), row.len()));
    let solutions = (name("max_solutions"), interface.solutions);
    lengths.chain(rows).chain([solutions]).collect()
}

/// What the macro of a row's length ends in.
fn length_of_row(row: &Row) -> String {
    if row.suffix.is_empty() { "unknowns".to_owned() } else { format!("length_of_{}", row.what) }
}

/// Lines of a comment that does not end before its end.
fn comment(text: &mut String, lines: &[String]) {
    for line in lines {
        let line = line.replace("*/", "* /").replace("/*", "/ *");
        let _ = writeln!(text, " * {}", line.trim());
    }
    while text.ends_with(" * \n") {
        text.truncate(text.len() - " * \n".len());
    }
    *text = text.replace(" * \n", " *\n");
}

/// A list of arrays with their shapes, in lines that are not too long.
fn fact(text: &mut String, what: &str, fields: &[Field]) {
    let mut line = format!(" * {what}:");
    if fields.is_empty() {
        line.push_str(" none");
    }
    for (at, field) in fields.iter().enumerate() {
        let note = if field.note.is_empty() { String::new() } else { format!(" ({})", field.note) };
        let end = if at + 1 < fields.len() { "," } else { "" };
        let word = format!(" {}{note}{end}", field.declaration());
        if line.len() + word.len() >= COLUMNS {
            let _ = writeln!(text, "{line}");
            line = " *  ".to_owned();
        }
        line.push_str(&word);
    }
    let _ = writeln!(text, "{line}.");
}

fn declaration(prefix: &str, name: &str, parameters: &[Parameter]) -> String {
    let mut text = format!("int32_t {prefix}_{name}(\n");
    let mut line = String::from("   ");
    for (at, parameter) in parameters.iter().enumerate() {
        let end = if at + 1 < parameters.len() { "," } else { ");" };
        let word = format!(" {}{end}", parameter.in_c());
        if line.len() + word.len() > COLUMNS {
            let _ = writeln!(text, "{line}");
            line = "   ".to_owned();
        }
        line.push_str(&word);
    }
    let _ = writeln!(text, "{line}");
    text
}
