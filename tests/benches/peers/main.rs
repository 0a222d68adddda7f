//! Our solvers beside hand-written and generated C++: time, and how often the truth is found.
//!
//! `cargo bench -p eliminant-tests --bench peers -- [WORD...]` measures the rows whose title or
//! name contains one of the words, or all. Ours always runs, peers where the environment names them
//! (`peer.rs` says how). Both sides read the same instances. They take turns on one core, chunk by
//! chunk of about a millisecond; the ratio is the median over the chunks of the ratio on the same
//! chunk. Of several builds of a peer the fastest counts.

mod cases;
mod instructions;
mod ours;
mod peer;
mod report;
mod scenes;
mod stages;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{fs, io};

use cases::{Case, Side, cases};
use clap::Parser;
use eliminant_generator::algebra::Random;
use eliminant_tests::ground_truth::FOUND;
use eliminant_tests::statistics::quantile;
use instructions::Executed;
use peer::{Driver, Peer, drivers};
use report::{Measured, Row, Theirs};
use scenes::Scene;

/// Measures our solvers beside peers.
#[derive(Parser)]
struct Arguments {
    /// Only rows whose title or name contains one of these words.
    words: Vec<String>,
    /// Instances of each row.
    #[arg(long, default_value_t = 10_000, value_parser = clap::value_parser!(u64).range(8..))]
    instances: u64,
    /// Chunks of each row, in which all sides take turns.
    #[arg(long, default_value_t = 301, value_parser = clap::value_parser!(u64).range(1..))]
    rounds: u64,
    /// Seed of the instances.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// The core on which all runs; the last that is allowed if not given.
    #[arg(long)]
    core: Option<u32>,
    /// Counts instructions, too, with Valgrind.
    #[arg(long)]
    instructions: bool,
    /// Writes the tables into README.md and, with instructions, docs/book/src/speed.md.
    #[arg(long)]
    update: bool,
    /// Solves the first instances of the row with this title, and nothing else: what Valgrind runs.
    #[arg(long, hide = true)]
    solve_row: Option<String>,
    /// How many of them.
    #[arg(long, hide = true, default_value_t = 0)]
    solves: usize,
    /// Set by `cargo bench`.
    #[arg(long, hide = true)]
    bench: bool,
}

/// How long the slowest side takes for a chunk, nanoseconds.
const CHUNK: f64 = 1e6;

/// What is measured of one side: nanoseconds per solve, for each chunk, and the share of instances
/// of which the truth was found.
struct Measurement {
    times: Vec<f64>,
    found: f64,
}

impl Measurement {
    fn nanoseconds(&self) -> f64 {
        quantile(&mut self.times.clone(), 0.5)
    }

    fn with(&self, executed: Option<Executed>) -> Measured {
        Measured { nanoseconds: self.nanoseconds(), found: self.found, executed }
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments = Arguments::parse();
    if let Some(title) = &arguments.solve_row {
        solve_row(title, &arguments);
        return Ok(());
    }
    match pin(arguments.core) {
        Ok(core) => println!("pinned to core {core}"),
        Err(reason) => println!("not pinned to a core: {reason}"),
    }
    let (drivers, missing) = drivers();
    missing.iter().for_each(|reason| println!("skipped: {reason}"));
    println!("skipped: the Python wheel of PoseLib, whose calls convert lists and cannot be timed alone");
    let is_wanted = |case: &Case| {
        let matches = |word: &String| case.title.contains(word.as_str()) || case.name.contains(word.as_str());
        arguments.words.is_empty() || arguments.words.iter().any(matches)
    };
    let mut rows = Vec::new();
    for case in cases().iter().filter(|case| is_wanted(case)) {
        let row = row(case, &drivers, &arguments)?;
        let build = row.theirs.as_ref().map_or("", |theirs| theirs.build);
        println!("{}: {:.0} ns; fastest build of the peer: {build}", row.title, row.ours.nanoseconds);
        rows.push(row);
    }
    let table = report::markdown(&rows, arguments.instructions);
    println!("\n{table}");
    let stages = arguments.instructions.then(|| report::stages(&rows));
    stages.iter().for_each(|table| println!("{table}"));
    if arguments.update {
        report::update_readme(&table, arguments.instances, arguments.rounds)?;
        stages.map_or(Ok(()), |table| report::update_book(&table))?;
    }
    Ok(())
}

fn draw(case: &Case, count: u64, seed: u64) -> Vec<Scene> {
    let mut random = Random::new(seed);
    (0..count).map(|_| (case.draw)(&mut random)).collect()
}

fn solve_row(title: &str, arguments: &Arguments) {
    for case in cases().iter().filter(|case| case.title == title) {
        let scenes = draw(case, 2 * instructions::INSTANCES as u64, arguments.seed);
        (case.ours)(&scenes).time(0, arguments.solves.min(scenes.len()));
    }
}

/// Measures one row of the table.
fn row(case: &Case, drivers: &[Driver], arguments: &Arguments) -> Result<Row, Box<dyn std::error::Error>> {
    let scenes = draw(case, arguments.instances, arguments.seed);
    let file = write(case, &scenes)?;
    let drivers: Vec<&Driver> = drivers.iter().filter(|driver| driver.name == case.driver).collect();
    let mut peers = Vec::new();
    for driver in &drivers {
        peers.push(driver.start(case.name, &file)?);
    }
    let mut ours = (case.ours)(&scenes);
    let measured = measure(case, &scenes, ours.as_mut(), &mut peers, arguments.rounds as usize);
    let (first, others) = measured.split_first().ok_or("nothing was measured")?;
    let fastest = others.iter().zip(&drivers).min_by(|a, b| a.0.nanoseconds().total_cmp(&b.0.nanoseconds()));
    let theirs = fastest.map(|(theirs, driver)| {
        let mut ratios: Vec<f64> = theirs.times.iter().zip(&first.times).map(|(peer, ours)| peer / ours).collect();
        // The fastest build, or else another one.
        let count = || {
            let mut builds = [driver].into_iter().chain(&drivers);
            builds.find_map(|driver| instructions::of_driver(driver, case, &file))
        };
        let counted = arguments.instructions.then(count).flatten();
        Theirs { measured: theirs.with(counted), ratio: quantile(&mut ratios, 0.5), build: driver.build }
    });
    let counted = arguments.instructions.then(|| instructions::of_ours(case, arguments.seed)).flatten();
    Ok(Row { title: case.title, peer: case.driver, ours: first.with(counted), theirs, note: case.note })
}

/// Ours, then the peers: all solve the same chunks, one side after the other.
fn measure(case: &Case, scenes: &[Scene], ours: &mut dyn Side, peers: &mut [Peer], rounds: usize) -> Vec<Measurement> {
    let mut sides: Vec<&mut dyn Side> = vec![ours];
    sides.extend(peers.iter_mut().map(|peer| peer as &mut dyn Side));
    let slowest = sides.iter_mut().map(|side| side.time(0, 8) / 8.0).fold(1.0, f64::max);
    let chunk = ((CHUNK / slowest) as usize).clamp(4, scenes.len());
    let mut times = vec![Vec::new(); sides.len()];
    let last = sides.len();
    for round in 0..rounds {
        let first = round * chunk % (scenes.len() - chunk + 1);
        // Another side begins in each round.
        for at in (0..last).map(|k| (k + round) % last) {
            times[at].push(sides[at].time(first, chunk) / chunk as f64);
        }
    }
    let share = |side: &mut &mut dyn Side| {
        let is_found = |(k, scene): (usize, &Scene)| case.error(&side.solutions(k), &scene.truth) <= FOUND;
        scenes.iter().enumerate().map(is_found).filter(|&found| found).count() as f64 / scenes.len() as f64
    };
    let shares: Vec<f64> = sides.iter_mut().map(share).collect();
    times.into_iter().zip(shares).map(|(times, found)| Measurement { times, found }).collect()
}

/// The file of instances that drivers read: `drivers/harness.hpp` describes it.
fn write(case: &Case, scenes: &[Scene]) -> io::Result<PathBuf> {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{}.instances", case.name));
    let width = scenes.first().map_or(0, |scene| scene.data.len());
    let head = [scenes.len() as f64, width as f64];
    let values = head.iter().chain(scenes.iter().flat_map(|scene| &scene.data));
    fs::write(&path, values.flat_map(|value| value.to_ne_bytes()).collect::<Vec<u8>>())?;
    Ok(path)
}

/// Keeps this process, and those that it starts, on one core.
fn pin(core: Option<u32>) -> Result<String, String> {
    let status = fs::read_to_string("/proc/self/status").map_err(|error| error.to_string())?;
    let allowed = status.lines().find_map(|line| line.strip_prefix("Cpus_allowed_list:")).unwrap_or_default();
    let last = || allowed.trim().rsplit(['-', ',']).next().unwrap_or("0").to_owned();
    let core = core.map_or_else(last, |core| core.to_string());
    let pinned = Command::new("taskset").args(["-cp", &core, &std::process::id().to_string()]).output();
    match pinned {
        Ok(output) if output.status.success() => Ok(core),
        Ok(output) => Err(String::from_utf8_lossy(&output.stderr).trim().to_owned()),
        Err(error) => Err(format!("taskset: {error}")),
    }
}
