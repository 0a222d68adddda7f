//! Prints the catalogue: every problem in `templates/`, its template and what its solver does,
//! beside what is published.
//!
//! With `--update` the page `templates/README.md` is written anew, and the histograms of
//! `templates/histograms.csv`.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use clap::{Parser, ValueEnum};
use comfy_table::{CellAlignment, Table, presets};
use eliminant_tests::catalogue_page::{self, Row};
use eliminant_tests::comparison::Comparison;
use eliminant_tests::families::Family;
use eliminant_tests::histograms::{self, Counts, Histograms, counts};
use eliminant_tests::measure::{WORK_OF_MEASURING, affordable, measure, measure_forward, measure_unpolished};
use eliminant_tests::published::{Published, fewest_rows, published, published_name};
use eliminant_tests::statistics::quantile;
use eliminant_tests::{Case, cases};

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
    /// Writes templates/README.md, in Markdown, and templates/histograms.csv, and prints nothing.
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

/// Instances on which points before the polish are measured: as many as of published solvers.
const UNPOLISHED: u64 = 1_000;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments = Arguments::parse();
    let published = published()?;
    let path = catalogue_page::path();
    let written = if arguments.update { fs::read_to_string(&path)? } else { String::new() };
    let (mut rows, mut drawn) = (Vec::new(), Histograms::default());
    let known = if arguments.update { Histograms::read(&histograms::path())? } else { Histograms::default() };
    for case in cases() {
        let measured = if arguments.problems.is_empty() || arguments.problems.iter().any(|name| name == case.name) {
            eprintln!("{}", case.name);
            let (cells, of_case) = measured(&case, &arguments);
            drawn.insert(case.name, of_case);
            cells
        } else if arguments.update {
            drawn.counts.extend(known.of(case.name));
            catalogue_page::row(&written, case.name).ok_or_else(|| format!("{} is not in the page", case.name))?
        } else {
            continue;
        };
        rows.push(with_published(measured, &case, &published)?);
    }
    let comparison = Comparison::new(&cases())?.listed();
    if arguments.update {
        write(&histograms::path(), &drawn.text()?)?;
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

/// The cells that are measured, and the size of the template that they were measured with, and the
/// histograms.
fn measured(case: &Case, arguments: &Arguments) -> (Row, [(&'static str, Counts); 2]) {
    let (template, plan) = (case.template().template, case.planned().plan);
    let (instances, seed) = (affordable(&plan, arguments.instances, WORK_OF_MEASURING), arguments.seed);
    let random = measure(case, &plan, Family::Random, instances, seed);
    let scenes = measure(case, &plan, Family::Scene, instances, seed);
    let forward = measure_forward(case, instances, seed);
    let unpolished = measure_unpolished(&plan, instances.min(UNPOLISHED), seed);
    let cells = [
        ("solutions", plan.solutions.to_string()),
        ("template", format!("{}x{}", template.rows(), template.columns())),
        ("basis", template.basis.len().to_string()),
        ("operations", plan.operations().total().to_string()),
        ("n", random.instances.to_string()),
        ("median", at(&random.residuals_log10, 0.5)),
        ("p99", at(&random.residuals_log10, 0.99)),
        ("failures", share(random.failures, random.instances)),
        ("scenes", scenes.instances.to_string()),
        ("of a scene", scenes.solutions.to_string()),
        ("scene median", at(&scenes.residuals_log10, 0.5)),
        ("scene p99", at(&scenes.residuals_log10, 0.99)),
        ("scene failures", share(scenes.failures, scenes.instances)),
        ("recovered", share(forward.recovered, scenes.instances)),
        ("forward median", at(&forward.errors_log10, 0.5)),
        ("forward p99", at(&forward.errors_log10, 0.99)),
        ("unpolished n", unpolished.instances.to_string()),
        ("unpolished median", at(&unpolished.errors_log10, 0.5)),
        ("unpolished p99", at(&unpolished.errors_log10, 0.99)),
        ("unpolished failures", share(unpolished.failures, unpolished.instances)),
    ];
    let histograms = [("error", counts(&forward.errors_log10)), ("residual", counts(&random.residuals_log10))];
    (cells.into_iter().map(|(head, cell)| (head.to_owned(), cell)).collect(), histograms)
}

fn share(part: usize, whole: usize) -> String {
    format!("{:.4}", part as f64 / whole as f64)
}

/// A quantile.
fn at(values: &[f64], q: f64) -> String {
    format!("{:.1}", quantile(&mut values.to_vec(), q))
}

/// Adds what follows from committed files. It replaces what the page has of them.
fn with_published(mut row: Row, case: &Case, published: &[Published]) -> Result<Row, csv::Error> {
    let name = published_name(case).unwrap_or_default();
    let theirs = published.iter().find(|p| p.name == name).cloned().unwrap_or_default();
    let cells = [
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
    ];
    row.extend(cells.into_iter().map(|(head, cell)| (head.to_owned(), cell)));
    Ok(row)
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
        row.entry(PROBLEM.to_owned()).and_modify(|name| *name = format!("[`{name}`]({name}.rs)"));
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
        are. The distributions, of which the tables have quantiles, are in `histograms.csv`: log10 of\n\
        the residuals of random data, and of the forward errors of scenes.\n",
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
    let partial = path.with_extension("partial");
    fs::write(&partial, text)?;
    Ok(fs::rename(partial, path)?)
}
