//! The time of the slowest solves of every emitted solver beside its median, on scenes.
//!
//! `cargo bench -p eliminant-tests --bench worst -- [PROBLEM...]`. An instance is solved several
//! times and its shortest time counts: what interrupts a solve hits one of them, while a second
//! attempt or a continuation takes its time in each.

use std::time::Duration;

use clap::Parser;
use comfy_table::{CellAlignment, Table, presets};
use eliminant_tests::families::{DataSource, Family};
use eliminant_tests::statistics::quantile;
use eliminant_tests::{Case, cases};

/// Measures the spread of the time of `solve`.
#[derive(Parser)]
struct Arguments {
    /// Only these problems.
    problems: Vec<String>,
    /// Scenes of each problem.
    #[arg(long, default_value_t = 10_000, value_parser = clap::value_parser!(u64).range(8..))]
    instances: u64,
    /// Solves of each instance.
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u64).range(1..))]
    repeats: u64,
    /// Seed of the first instance.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Set by `cargo bench`.
    #[arg(long, hide = true)]
    bench: bool,
}

/// The instances of a problem take at most this long; fewer of them are solved where they would
/// take longer, but at least 8.
const LONGEST: Duration = Duration::from_secs(20);

/// A solve is slow if it takes this many times the median.
const SLOW: f64 = 5.0;

/// Nanoseconds of each instance.
fn nanoseconds(case: &Case, arguments: &Arguments) -> Vec<f64> {
    let source = DataSource::new(case);
    let shortest = |k| {
        let data = [source.draw(Family::Scene, arguments.seed + k)];
        let times = (0..arguments.repeats).map(|_| (case.time)(&data).0);
        times.min().unwrap_or_default().as_nanos() as f64
    };
    let mut times: Vec<f64> = (0..8).map(shortest).collect();
    let each = times.iter().sum::<f64>() * 1e-9 * arguments.repeats as f64 / 8.0;
    let count = arguments.instances.min((LONGEST.as_secs_f64() / each) as u64);
    times.extend((8..count).map(shortest));
    times
}

/// The cells of a problem: instances, median, quantiles, worst, its ratio and the share of slow
/// solves.
fn cells(case: &Case, arguments: &Arguments) -> Vec<String> {
    let mut times = nanoseconds(case, arguments);
    let count = times.len();
    let [median, p99, worst] = [0.5, 0.99, 1.0].map(|part| quantile(&mut times, part));
    let slow = times.iter().filter(|&&time| time > SLOW * median).count() as f64 / count as f64;
    let microseconds = |time: f64| format!("{:.2}", time / 1e3);
    vec![
        case.name.to_owned(),
        count.to_string(),
        microseconds(median),
        microseconds(p99),
        microseconds(worst),
        format!("{:.1}", worst / median),
        format!("{:.2}", 100.0 * slow),
    ]
}

fn main() {
    let arguments = Arguments::parse();
    let is_wanted =
        |case: &Case| arguments.problems.is_empty() || arguments.problems.iter().any(|name| name == case.name);
    let mut table = Table::new();
    table.load_preset(presets::ASCII_MARKDOWN);
    table.set_header(["problem", "scenes", "median us", "p99 us", "worst us", "worst / median", "% slow"]);
    table.add_rows(cases().iter().filter(|case| is_wanted(case)).map(|case| cells(case, &arguments)));
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    println!("{table}");
}
