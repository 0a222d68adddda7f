//! The time of `solve` of every emitted solver, on random data and on scenes.
//!
//! `cargo bench -p eliminant-tests --bench solve -- [PROBLEM...]`. All solvers take turns, so that
//! a drifting clock hits all alike. A time is the median over rounds of the mean over the instances
//! of a round.

use std::time::Duration;

use clap::Parser;
use comfy_table::{CellAlignment, Table, presets};
use eliminant_tests::families::{DataSource, Family};
use eliminant_tests::statistics::quantile;
use eliminant_tests::{Case, cases};

/// Measures the time of `solve`.
#[derive(Parser)]
struct Arguments {
    /// Only these problems.
    problems: Vec<String>,
    /// Instances of each problem and family, the same in every round.
    #[arg(long, default_value_t = 1_000)]
    instances: u64,
    /// Rounds.
    #[arg(long, default_value_t = 21, value_parser = clap::value_parser!(u64).range(1..))]
    rounds: u64,
    /// Seed of the first instance.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Set by `cargo bench`.
    #[arg(long, hide = true)]
    bench: bool,
}

/// The instances of a family take at most this long in one round; fewer of them are solved where
/// they would take longer, but at least 8.
const LONGEST_ROUND: Duration = Duration::from_millis(50);

const FAMILIES: [Family; 2] = [Family::Random, Family::Scene];

/// One solver on one family.
struct Subject {
    case: Case,
    data: Vec<Vec<f64>>,
    /// For each round, nanoseconds per solve.
    nanoseconds: Vec<f64>,
    /// Real solutions per solve.
    solutions: f64,
}

impl Subject {
    fn new(case: &Case, family: Family, arguments: &Arguments) -> Self {
        let source = DataSource::new(case);
        let draw = |k| source.draw(family, arguments.seed + k);
        // One instance may need a second attempt; of eight the time is hardly ever too short.
        let first: Vec<_> = (0..8).map(draw).collect();
        let (time, _) = (case.time)(&first);
        let affordable = (8.0 * LONGEST_ROUND.as_secs_f64() / time.as_secs_f64()) as u64;
        let data = (0..arguments.instances.min(affordable).max(8)).map(draw).collect();
        Self { case: *case, data, nanoseconds: Vec::new(), solutions: 0.0 }
    }

    fn run(&mut self) {
        let (time, found) = (self.case.time)(&self.data);
        let count = self.data.len() as f64;
        self.nanoseconds.push(time.as_secs_f64() * 1e9 / count);
        self.solutions = found as f64 / count;
    }

    /// Instances, microseconds per solve, real solutions per solve.
    fn cells(&self) -> [String; 3] {
        let microseconds = quantile(&mut self.nanoseconds.clone(), 0.5) / 1e3;
        [self.data.len().to_string(), format!("{microseconds:.2}"), format!("{:.1}", self.solutions)]
    }
}

fn main() {
    let arguments = Arguments::parse();
    let is_wanted =
        |case: &Case| arguments.problems.is_empty() || arguments.problems.iter().any(|name| name == case.name);
    let cases: Vec<Case> = cases().into_iter().filter(is_wanted).collect();
    let mut subjects: Vec<[Subject; 2]> =
        cases.iter().map(|case| FAMILIES.map(|family| Subject::new(case, family, &arguments))).collect();
    for _ in 0..arguments.rounds {
        subjects.iter_mut().flatten().for_each(Subject::run);
    }
    let mut table = Table::new();
    table.load_preset(presets::ASCII_MARKDOWN).set_header([
        "problem",
        "template",
        "basis",
        "roots",
        "random n",
        "random us",
        "random solutions",
        "scene n",
        "scene us",
        "scene solutions",
    ]);
    for (case, [random, scene]) in cases.iter().zip(&subjects) {
        let file = case.template();
        let (template, basis) = (&file.template, file.template.basis.len());
        let size = format!("{}x{}", template.rows(), template.columns());
        let words = [case.name.to_owned(), size, basis.to_string(), file.roots.name().to_owned()];
        table.add_row(words.into_iter().chain(random.cells()).chain(scene.cells()));
    }
    table.column_iter_mut().skip(4).for_each(|column| column.set_cell_alignment(CellAlignment::Right));
    println!("{table}");
}
