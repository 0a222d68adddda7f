//! The time of `solve_batch` on one core and on all, beside that of `solve`.
//!
//! `cargo bench -p eliminant-tests --bench batch -- [PROBLEM...]`, on scenes. Solvers and ways take
//! turns, so that a drifting clock hits all alike. A time is the median over rounds of the mean
//! over the instances of a round.

use clap::Parser;
use comfy_table::{CellAlignment, Table, presets};
use eliminant_tests::case::Cores;
use eliminant_tests::families::{DataSource, Family};
use eliminant_tests::statistics::quantile;
use eliminant_tests::{Case, cases};

/// Measures the time of `solve_batch`.
#[derive(Parser)]
struct Arguments {
    /// These problems; otherwise those of the table in README.md.
    problems: Vec<String>,
    /// Instances of each problem, the same in every round.
    #[arg(long, default_value_t = 4_096)]
    instances: u64,
    /// Rounds.
    #[arg(long, default_value_t = 21, value_parser = clap::value_parser!(u64).range(1..))]
    rounds: u64,
    /// Seed of the first instance.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Random data in place of scenes.
    #[arg(long)]
    random: bool,
    /// Set by `cargo bench`.
    #[arg(long, hide = true)]
    bench: bool,
}

/// The solvers of the table in README.md: some of those that compute instances side by side.
const LISTED: [&str; 10] = [
    "circle_least_squares",
    "circle_minimal",
    "pose_35pt_focal",
    "pose_3pt",
    "pose_3pt_depths",
    "pose_4pt_focal",
    "relpose_5pt",
    "relpose_6pt_focal_one_side",
    "three_quadrics",
    "two_conics",
];

/// One solver: for each round, nanoseconds per instance one by one, in a batch, and on all cores.
struct Subject {
    case: Case,
    data: Vec<Vec<f64>>,
    nanoseconds: [Vec<f64>; 3],
    ratios: Vec<f64>,
}

impl Subject {
    fn new(case: Case, arguments: &Arguments) -> Self {
        let source = DataSource::new(&case);
        let family = if arguments.random { Family::Random } else { Family::Scene };
        let data = (0..arguments.instances).map(|k| source.draw(family, arguments.seed + k)).collect();
        Self { case, data, nanoseconds: Default::default(), ratios: Vec::new() }
    }

    fn run(&mut self) {
        let (alone, _) = (self.case.time)(&self.data);
        let [one, all] = [Cores::One, Cores::All].map(|cores| (self.case.time_batch)(&self.data, cores));
        for (list, time) in self.nanoseconds.iter_mut().zip([alone, one, all]) {
            list.push(time.as_secs_f64() * 1e9 / self.data.len() as f64);
        }
        self.ratios.push(alone.as_secs_f64() / one.as_secs_f64());
    }

    fn row(&self) -> Vec<String> {
        let [alone, one, all] = [0, 1, 2].map(|at: usize| quantile(&mut self.nanoseconds[at].clone(), 0.5));
        let ratio = quantile(&mut self.ratios.clone(), 0.5);
        vec![
            self.case.name.to_owned(),
            format!("{alone:.0}"),
            format!("{one:.0}"),
            format!("{ratio:.2}"),
            format!("{:.2}", 1e3 / all),
        ]
    }
}

fn main() {
    let arguments = Arguments::parse();
    let is_wanted = |case: &Case| match arguments.problems.is_empty() {
        true => LISTED.contains(&case.name),
        false => arguments.problems.iter().any(|name| name == case.name),
    };
    let wanted = cases().into_iter().filter(is_wanted);
    let mut subjects: Vec<Subject> = wanted.map(|case| Subject::new(case, &arguments)).collect();
    for _ in 0..arguments.rounds {
        subjects.iter_mut().for_each(Subject::run);
    }
    let mut table = Table::new();
    table.load_preset(presets::ASCII_MARKDOWN).set_header([
        "problem",
        "solve ns",
        "solve_batch ns",
        "ratio",
        "all cores, million/s",
    ]);
    table.add_rows(subjects.iter().map(Subject::row));
    table.column_iter_mut().skip(1).for_each(|column| column.set_cell_alignment(CellAlignment::Right));
    println!("{table}");
    println!("{} instances each, {} cores", arguments.instances, rayon::current_num_threads());
}
