//! Prints the catalogue: every problem in `templates/`, its template and what its solver does,
//! beside what is published.
//!
//! With `--update` the page `templates/README.md` is written anew.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use clap::{Parser, ValueEnum};
use comfy_table::{CellAlignment, Table, presets};
use eliminant_tests::comparison::Comparison;
use eliminant_tests::families::Family;
use eliminant_tests::measure::{WORK_OF_MEASURING, affordable, measure, measure_forward, measure_unpolished};
use eliminant_tests::published::{Published, fewest_rows, published, published_name};
use eliminant_tests::statistics::quantile;
use eliminant_tests::{Case, cases, templates_folder};

/// The catalogue of problems, measured, beside published templates.
#[derive(Parser)]
struct Arguments {
    /// Only these problems; with `--update` the measured cells of all others stay as they are.
    problems: Vec<String>,
    /// The form in which it is printed.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    /// Random instances of each problem.
    #[arg(long, default_value_t = 10_000, value_parser = clap::value_parser!(u64).range(1..))]
    instances: u64,
    /// Seed of the first instance.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Writes templates/README.md, in Markdown, and prints nothing.
    #[arg(long)]
    update: bool,
}

#[derive(Clone, Copy, Default, ValueEnum)]
enum Format {
    #[default]
    Text,
    Csv,
    Markdown,
}

/// One table of the page.
struct Group {
    title: &'static str,
    /// What its columns mean.
    definitions: &'static str,
    columns: &'static [&'static str],
    /// The first columns are words, the others figures.
    words: usize,
}

const PROBLEM: &str = "problem";
const TEMPLATES: &str = "Templates";

const GROUPS: [Group; 5] = [
    Group {
        title: TEMPLATES,
        definitions: include_str!("../catalogue_text/templates.md"),
        columns: &[
            PROBLEM,
            "published as",
            "solutions",
            "template",
            "basis",
            "operations",
            "fewest rows",
            "Larsson 2017",
            "greedy 2022",
            "redundant 2023",
        ],
        words: 2,
    },
    Group {
        title: "Solutions of random data",
        definitions: include_str!("../catalogue_text/returned.md"),
        columns: &[PROBLEM, "n", "median", "p99", "failures"],
        words: 1,
    },
    Group {
        title: "Solutions of scenes",
        definitions: include_str!("../catalogue_text/scenes.md"),
        columns: &[
            PROBLEM,
            "scenes",
            "of a scene",
            "scene median",
            "scene p99",
            "scene failures",
            "recovered",
            "forward median",
            "forward p99",
        ],
        words: 1,
    },
    Group {
        title: "Before the polish",
        definitions: include_str!("../catalogue_text/unpolished.md"),
        columns: &[PROBLEM, "unpolished n", "unpolished median", "unpolished p99", "unpolished failures"],
        words: 1,
    },
    Group {
        title: "Published solvers",
        definitions: include_str!("../catalogue_text/published.md"),
        columns: &[PROBLEM, "shipped 2023", "its basis", "its n", "its median", "its p99", "its failures"],
        words: 1,
    },
];

/// Columns that are measured. Of a problem that is not measured they stay as the page has them; all
/// others follow from committed files.
const MEASURED: [&str; 20] = [
    "solutions",
    "template",
    "basis",
    "operations",
    "n",
    "median",
    "p99",
    "failures",
    "scenes",
    "of a scene",
    "scene median",
    "scene p99",
    "scene failures",
    "recovered",
    "forward median",
    "forward p99",
    "unpolished n",
    "unpolished median",
    "unpolished p99",
    "unpolished failures",
];

/// Instances on which points before the polish are measured: as many as of published solvers.
const UNPOLISHED: u64 = 1_000;

/// The cells of a problem by the heads of their columns.
type Row = BTreeMap<&'static str, String>;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments = Arguments::parse();
    let published = published()?;
    let path = templates_folder().join("README.md");
    let written = if arguments.update { fs::read_to_string(&path)? } else { String::new() };
    let mut rows = Vec::new();
    for case in cases() {
        let measured = if arguments.problems.is_empty() || arguments.problems.iter().any(|name| name == case.name) {
            eprintln!("{}", case.name);
            measured(&case, &arguments)
        } else if arguments.update {
            written_cells(&written, case.name).ok_or_else(|| format!("{} is not in the page", case.name))?
        } else {
            continue;
        };
        rows.push(with_published(measured, &case, &published)?);
    }
    let comparison = Comparison::new(&cases())?.listed();
    if arguments.update {
        return write(&path, &page(&rows, &comparison, &arguments));
    }
    match arguments.format {
        Format::Text => {
            GROUPS.iter().for_each(|group| println!("{}\n", table(group, &rows, presets::NOTHING)));
            print!("{comparison}");
        }
        Format::Markdown => print!("{}", page(&rows, &comparison, &arguments)),
        Format::Csv => {
            let mut heads: Vec<&str> = GROUPS.iter().flat_map(|group| group.columns).copied().collect();
            let mut known = BTreeSet::new();
            heads.retain(|head| known.insert(*head));
            let mut writer = csv::Writer::from_writer(std::io::stdout());
            writer.write_record(&heads)?;
            rows.iter().try_for_each(|row| writer.write_record(heads.iter().map(|head| cell(row, head))))?;
            writer.flush()?;
        }
    }
    Ok(())
}

fn cell<'a>(row: &'a Row, head: &str) -> &'a str {
    row.get(head).map_or("", String::as_str)
}

/// The cells of [`MEASURED`].
fn measured(case: &Case, arguments: &Arguments) -> Row {
    let (template, plan) = (case.template().template, case.planned().plan);
    let (instances, seed) = (affordable(&plan, arguments.instances, WORK_OF_MEASURING), arguments.seed);
    let random = measure(case, &plan, Family::Random, instances, seed);
    let scenes = measure(case, &plan, Family::Scene, instances, seed);
    let forward = measure_forward(case, instances, seed);
    let mut unpolished = measure_unpolished(&plan, instances.min(UNPOLISHED), seed);
    unpolished.errors_log10.sort_by(f64::total_cmp);
    let size = [
        plan.solutions.to_string(),
        format!("{}x{}", template.rows(), template.columns()),
        template.basis.len().to_string(),
        plan.operations().total().to_string(),
    ];
    let returned = [
        random.instances.to_string(),
        at(&random.residuals_log10, 0.5),
        at(&random.residuals_log10, 0.99),
        share(random.failures, random.instances),
    ];
    let of_scenes = [
        scenes.instances.to_string(),
        scenes.solutions.to_string(),
        at(&scenes.residuals_log10, 0.5),
        at(&scenes.residuals_log10, 0.99),
        share(scenes.failures, scenes.instances),
        share(forward.recovered, scenes.instances),
        at(&forward.log10, 0.5),
        at(&forward.log10, 0.99),
    ];
    let before_polish = [
        unpolished.instances.to_string(),
        at(&unpolished.errors_log10, 0.5),
        at(&unpolished.errors_log10, 0.99),
        share(unpolished.failures, unpolished.instances),
    ];
    MEASURED.into_iter().zip(size.into_iter().chain(returned).chain(of_scenes).chain(before_polish)).collect()
}

fn share(part: usize, whole: usize) -> String {
    format!("{:.4}", part as f64 / whole as f64)
}

/// A quantile of increasing values.
fn at(values: &[f64], q: f64) -> String {
    format!("{:.1}", quantile(&mut values.to_vec(), q))
}

/// Adds what follows from committed files.
fn with_published(mut row: Row, case: &Case, published: &[Published]) -> Result<Row, csv::Error> {
    let name = published_name(case).unwrap_or_default();
    let theirs = published.iter().find(|p| p.name == name).cloned().unwrap_or_default();
    row.extend([
        (PROBLEM, case.name.to_owned()),
        ("published as", name),
        ("fewest rows", fewest_rows(case.name)?.unwrap_or_default()),
        ("Larsson 2017", theirs.larsson_2017),
        ("greedy 2022", theirs.greedy_2022),
        ("redundant 2023", theirs.smallest_2023),
        ("shipped 2023", theirs.shipped_2023),
        ("its basis", theirs.basis),
        ("its n", theirs.instances),
        ("its median", theirs.median),
        ("its p99", theirs.p99),
        ("its failures", theirs.failure_rate),
    ]);
    Ok(row)
}

/// The cells of [`MEASURED`] of a problem in the page as it was written before, from all tables
/// that have a row of it. A column is known by its head, so that it may stand elsewhere now.
fn written_cells(page: &str, name: &str) -> Option<Row> {
    let link = format!("({name}.rs)");
    let (mut heads, mut found) = (Vec::new(), None);
    for line in page.lines() {
        let Some(line) = line.trim().strip_prefix('|').and_then(|line| line.strip_suffix('|')) else {
            heads.clear();
            continue;
        };
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        if heads.is_empty() {
            heads = cells;
        } else if cells[0].ends_with(&link) {
            let row = found.get_or_insert_with(Row::new);
            let is_measured = |head: &str| MEASURED.into_iter().find(|measured| *measured == head);
            let known =
                heads.iter().zip(&cells).filter_map(|(head, cell)| Some((is_measured(head)?, (*cell).to_owned())));
            row.extend(known);
        }
    }
    found
}

fn table(group: &Group, rows: &[Row], preset: &str) -> Table {
    let cells = |row: &Row| group.columns.iter().map(|head| cell(row, head).to_owned()).collect::<Vec<_>>();
    let mut table = Table::new();
    table.load_preset(preset).set_header(group.columns.iter().copied()).add_rows(rows.iter().map(cells));
    table.column_iter_mut().skip(group.words).for_each(|column| column.set_cell_alignment(CellAlignment::Right));
    table
}

/// `templates/README.md`.
fn page(rows: &[Row], comparison: &str, arguments: &Arguments) -> String {
    let linked = |row: &Row| {
        let mut row = row.clone();
        row.entry(PROBLEM).and_modify(|name| *name = format!("[`{name}`]({name}.rs)"));
        row
    };
    let rows: Vec<Row> = rows.iter().map(linked).collect();
    let mut text = format!(
        "# The catalogue\n\n\
        Every problem with a committed template, beside published templates for the same problem. The\n\
        tables are written by\n\n\
        ```sh\ncargo run --release -p eliminant-tests --bin catalogue -- --update\n```\n\n\
        which solves up to {} random instances of each problem, and as many scenes whose solution is\n\
        known. With names of problems before `--update` the measured cells of all others stay as they\n\
        are.\n",
        arguments.instances
    );
    for group in &GROUPS {
        text += &format!(
            "\n## {}\n\n{}\n{}\n",
            group.title,
            group.definitions,
            table(group, &rows, presets::ASCII_MARKDOWN)
        );
        if group.title == TEMPLATES {
            text += &format!("\n{comparison}");
        }
    }
    text
}

/// Writes beside the file and renames, so that it is never half-written.
fn write(path: &Path, text: &str) -> Result<(), Box<dyn std::error::Error>> {
    let partial = path.with_extension("md.partial");
    fs::write(&partial, text)?;
    Ok(fs::rename(partial, path)?)
}
