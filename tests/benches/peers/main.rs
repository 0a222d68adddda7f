//! Our solvers beside hand-written and generated C++: time, and how often the truth is found.
//!
//! `cargo bench -p eliminant-tests --bench peers -- [WORD...]` measures the rows whose title or
//! name contains one of the words, or all. Ours always runs, peers where the environment names them
//! (`peer.rs` says how). Both sides read the same instances. They take turns on one core, chunk by
//! chunk of about a millisecond; the ratio is the median over the chunks of the ratio on the same
//! chunk. Of several builds of a peer the fastest counts.

mod cases;
mod ours;
mod peer;
mod scenes;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{fs, io};

use cases::{Case, Side, cases};
use clap::Parser;
use comfy_table::{CellAlignment, Table, presets};
use eliminant_generator::algebra::Random;
use eliminant_tests::ground_truth::FOUND;
use eliminant_tests::statistics::quantile;
use peer::{Driver, Peer, drivers};
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
    /// Set by `cargo bench`.
    #[arg(long, hide = true)]
    bench: bool,
}

/// How long the slowest side takes for a chunk, nanoseconds.
const CHUNK: f64 = 1e6;

/// What was measured of one side.
struct Measured {
    /// Nanoseconds per solve, for each chunk.
    times: Vec<f64>,
    /// The share of instances of which the truth was found.
    found: f64,
}

impl Measured {
    fn nanoseconds(&self) -> f64 {
        quantile(&mut self.times.clone(), 0.5)
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments = Arguments::parse();
    match pin(arguments.core) {
        Ok(core) => println!("pinned to core {core}"),
        Err(reason) => println!("not pinned to a core: {reason}"),
    }
    let (drivers, missing) = drivers();
    missing.iter().for_each(|reason| println!("skipped: {reason}"));
    println!("skipped: the Python wheel of PoseLib, whose calls convert lists and cannot be timed alone");
    let mut table = Table::new();
    table.load_preset(presets::ASCII_MARKDOWN).set_header([
        "case",
        "peer",
        "ours ns",
        "peer ns",
        "ratio",
        "ours found",
        "peer found",
        "build",
        "note",
    ]);
    table.column_iter_mut().skip(2).take(5).for_each(|column| column.set_cell_alignment(CellAlignment::Right));
    let is_wanted = |case: &Case| {
        let matches = |word: &String| case.title.contains(word.as_str()) || case.name.contains(word.as_str());
        arguments.words.is_empty() || arguments.words.iter().any(matches)
    };
    for case in cases().iter().filter(|case| is_wanted(case)) {
        let cells = row(case, &drivers, &arguments)?;
        println!("{}", cells.join(" | "));
        table.add_row(cells);
    }
    println!("\n{table}");
    Ok(())
}

/// Measures one row of the table.
fn row(case: &Case, drivers: &[Driver], arguments: &Arguments) -> Result<Vec<String>, Box<dyn std::error::Error>> {
    let mut random = Random::new(arguments.seed);
    let scenes: Vec<Scene> = (0..arguments.instances).map(|_| (case.draw)(&mut random)).collect();
    let file = write(case, &scenes)?;
    let mut peers = Vec::new();
    for driver in drivers.iter().filter(|driver| driver.name == case.driver) {
        peers.push(driver.start(case.name, &file)?);
    }
    let mut ours = (case.ours)(&scenes);
    let measured = measure(case, &scenes, ours.as_mut(), &mut peers, arguments.rounds as usize);
    let (first, others) = measured.split_first().ok_or("nothing was measured")?;
    let mut cells = vec![case.title.to_owned(), case.driver.to_owned(), format!("{:.0}", first.nanoseconds())];
    let fastest = others.iter().zip(&peers).min_by(|a, b| a.0.nanoseconds().total_cmp(&b.0.nanoseconds()));
    let share = |measured: &Measured| format!("{:.2} %", 100.0 * measured.found);
    if let Some((theirs, peer)) = fastest {
        let mut ratios: Vec<f64> = theirs.times.iter().zip(&first.times).map(|(peer, ours)| peer / ours).collect();
        let (time, ratio) = (theirs.nanoseconds(), quantile(&mut ratios, 0.5));
        cells.extend([format!("{time:.0}"), format!("{ratio:.2}"), share(first), share(theirs), peer.build.to_owned()]);
    } else {
        cells.extend([String::new(), String::new(), share(first), String::new(), String::new()]);
    }
    cells.push(case.note.to_owned());
    Ok(cells)
}

/// Ours, then the peers: all solve the same chunks, one side after the other.
fn measure(case: &Case, scenes: &[Scene], ours: &mut dyn Side, peers: &mut [Peer], rounds: usize) -> Vec<Measured> {
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
    times.into_iter().zip(shares).map(|(times, found)| Measured { times, found }).collect()
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
