//! Prints the catalogue: every problem in `templates/`, its template and what its solver does, beside what is published.
//!
//! With `--update` the page `templates/README.md` is written anew.

use std::fs;
use std::path::Path;

use clap::{Parser, ValueEnum};
use comfy_table::{CellAlignment, Table, presets};
use eliminant_generator::algebra::Random;
use eliminant_tests::ground_truth::{FOUND, Maker, makers};
use eliminant_tests::measure::{WORK_OF_MEASURING, affordable, measure};
use eliminant_tests::published::{Published, published, published_name};
use eliminant_tests::statistics::quantile;
use eliminant_tests::{Case, cases, templates_folder};
use rayon::prelude::*;

/// The catalogue of problems, measured, beside published templates.
#[derive(Parser)]
struct Arguments {
    /// Only these problems; with `--update` the rows of all others stay as they are.
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

const HEAD: [&str; 16] = [
    "problem",
    "published as",
    "solutions",
    "template",
    "basis",
    "operations",
    "median",
    "p99",
    "failures",
    "recovered",
    "Larsson 2017",
    "greedy 2022",
    "redundant 2023",
    "its median",
    "its p99",
    "its failures",
];
/// The first columns are words, the others figures.
const WORDS: usize = 2;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments = Arguments::parse();
    let published = published()?;
    let path = templates_folder().join("README.md");
    let written = if arguments.update { fs::read_to_string(&path)? } else { String::new() };
    let mut rows = Vec::new();
    for case in cases() {
        if arguments.problems.is_empty() || arguments.problems.iter().any(|name| name == case.name) {
            eprintln!("{}", case.name);
            rows.push(row(&case, &published, &arguments));
        } else if arguments.update {
            rows.push(written_row(&written, &case).ok_or_else(|| format!("{} is not in the page", case.name))?);
        }
    }
    if arguments.update {
        return write(&path, &page(rows, &arguments));
    }
    match arguments.format {
        Format::Text => println!("{}", table(rows, presets::NOTHING)),
        Format::Markdown => print!("{}", page(rows, &arguments)),
        Format::Csv => {
            let mut writer = csv::Writer::from_writer(std::io::stdout());
            writer.write_record(HEAD)?;
            rows.iter().try_for_each(|row| writer.write_record(row))?;
            writer.flush()?;
        }
    }
    Ok(())
}

fn row(case: &Case, published: &[Published], arguments: &Arguments) -> Vec<String> {
    let (template, plan) = (case.template().template, case.planned().plan);
    let instances = affordable(&plan, arguments.instances, WORK_OF_MEASURING);
    let mut measured = measure(case, &plan, instances, arguments.seed);
    let name = published_name(case).unwrap_or_default();
    let theirs = published.iter().find(|p| p.name == name).cloned().unwrap_or_default();
    let mut residual = |q: f64| format!("{:.1}", quantile(&mut measured.residuals_log10, q));
    vec![
        case.name.to_owned(),
        name,
        plan.solutions.to_string(),
        format!("{}x{}", template.rows(), template.columns()),
        template.basis.len().to_string(),
        plan.operations().total().to_string(),
        residual(0.5),
        residual(0.99),
        format!("{:.4}", measured.failures as f64 / measured.instances as f64),
        format!("{:.4}", recovered(case, instances, arguments.seed)),
        theirs.larsson_2017,
        theirs.greedy_2022,
        theirs.redundant_2023,
        theirs.median,
        theirs.p99,
        theirs.failure_rate,
    ]
}

/// The row of a problem in the page as it was written before.
fn written_row(page: &str, case: &Case) -> Option<Vec<String>> {
    let line = page.lines().find(|line| line.contains(&format!("({}.rs)", case.name)))?;
    let cells: Vec<&str> = line.trim().strip_prefix('|')?.strip_suffix('|')?.split('|').map(str::trim).collect();
    let mut row: Vec<String> = cells.into_iter().map(str::to_owned).collect();
    *row.first_mut()? = case.name.to_owned();
    (row.len() == HEAD.len()).then_some(row)
}

/// The share of scenes on which all known solutions are found.
fn recovered(case: &Case, instances: u64, first_seed: u64) -> f64 {
    let makers = makers();
    let makers = makers.iter().filter(|maker| maker.name == case.name);
    let is_found = |maker: &&Maker, k| maker.worst_error(case, &mut Random::new(first_seed + k)) <= FOUND;
    let found: usize =
        makers.map(|maker| (0..instances).into_par_iter().filter(|&k| is_found(&maker, k)).count()).sum();
    found as f64 / instances as f64
}

fn table(rows: Vec<Vec<String>>, preset: &str) -> Table {
    let mut table = Table::new();
    table.load_preset(preset).set_header(HEAD).add_rows(rows);
    table.column_iter_mut().skip(WORDS).for_each(|column| column.set_cell_alignment(CellAlignment::Right));
    table
}

/// `templates/README.md`.
fn page(mut rows: Vec<Vec<String>>, arguments: &Arguments) -> String {
    for row in &mut rows {
        row[0] = format!("[`{0}`]({0}.rs)", row[0]);
    }
    format!(
        "# The catalogue\n\n\
        Every problem with a committed template, beside published templates for the same problem. The table is written by\n\n\
        ```sh\ncargo run --release -p eliminant-tests --bin catalogue -- --update\n```\n\n\
        which solves {} random instances of each problem (fewer of the largest), drawn on the variety of its data, with the emitted solver (all\n\
        complex solutions), and as many scenes whose solution is known.\n\
        Templates are rows x columns; basis is the size of the eigenvalue problem; operations are floating-point operations of one solve before\n\
        the polish. Median and p99 are quantiles of log10 of the relative residual over all solutions found. Failures are the share of instances on\n\
        which a solution is missing, or found twice, or none is returned; those of the published solvers are as measured with their code.\n\
        Recovered is the share of the scenes whose known solutions are among the real ones, to 1e-6.\n\
        `tests/src/published.rs` cites the publications.\n\n{}\n",
        arguments.instances,
        table(rows, presets::ASCII_MARKDOWN)
    )
}

/// Writes beside the file and renames, so that it is never half-written.
fn write(path: &Path, text: &str) -> Result<(), Box<dyn std::error::Error>> {
    let partial = path.with_extension("md.partial");
    fs::write(&partial, text)?;
    Ok(fs::rename(partial, path)?)
}
