//! Poses of the example's own scenes, or of the pairs of a file.

use std::error::Error;
use std::process::ExitCode;
use std::time::Instant;

use two_view::input::{join, pose_to_array};
use two_view::scene::{SceneOptions, scene};
use two_view::{Options, Pair, estimate};

const HELP: &str = "\
two-view [--scenes N] [--seed S] [--outliers SHARE] [--threshold PIXELS] [--write FILE | --file FILE]

Without a file: estimates the poses of N scenes (50) for each share of outliers (0.3 and 0.6), and
prints the errors. With --write these scenes are written to a file. With --file the pairs of a file
are estimated, and a line is printed for each: its name, nanoseconds, samples, inliers, the rotation
row by row, the translation.";

struct Arguments {
    scenes: u64,
    seed: u64,
    outliers: Vec<f64>,
    write: Option<String>,
    file: Option<String>,
    options: Options,
}

fn main() -> ExitCode {
    if std::env::args().any(|argument| argument == "--help") {
        println!("{HELP}");
        return ExitCode::SUCCESS;
    }
    match arguments(std::env::args().skip(1)).and_then(|arguments| run(&arguments)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn arguments(mut given: impl Iterator<Item = String>) -> Result<Arguments, Box<dyn Error>> {
    let options = Options::default();
    let mut arguments = Arguments { scenes: 50, seed: 1, outliers: vec![0.3, 0.6], write: None, file: None, options };
    while let Some(name) = given.next() {
        let value = given.next().ok_or_else(|| format!("{name} takes a value; --help says which"))?;
        match name.as_str() {
            "--scenes" => arguments.scenes = value.parse()?,
            "--seed" => arguments.seed = value.parse()?,
            "--outliers" => arguments.outliers = vec![value.parse()?],
            "--threshold" => arguments.options.threshold = value.parse()?,
            "--write" => arguments.write = Some(value),
            "--file" => arguments.file = Some(value),
            _ => return Err(format!("unknown option {name}; --help lists all").into()),
        }
    }
    Ok(arguments)
}

fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    match (&arguments.file, &arguments.write) {
        (Some(file), _) => estimate_file(file, &arguments.options),
        (None, Some(file)) => {
            let pairs = arguments.outliers.iter().flat_map(|&outliers| scenes(arguments, outliers));
            Ok(std::fs::write(file, pairs.map(|pair| pair.to_text()).collect::<String>())?)
        }
        (None, None) => estimate_scenes(arguments),
    }
}

fn scenes(arguments: &Arguments, outliers: f64) -> impl Iterator<Item = Pair> {
    let options = SceneOptions { outliers, seed: arguments.seed, ..SceneOptions::default() };
    (0..arguments.scenes).map(move |number| scene(&options, number).pair)
}

fn estimate_file(file: &str, options: &Options) -> Result<(), Box<dyn Error>> {
    for pair in Pair::read_all(&std::fs::read_to_string(file)?)? {
        let start = Instant::now();
        let found = estimate(&pair, options);
        let nanoseconds = start.elapsed().as_nanos();
        let found = found.map_err(|error| format!("pair {}: {error}", pair.name))?;
        let pose = join(&pose_to_array(&found.pose));
        println!("{},{nanoseconds},{},{},{pose}", pair.name, found.samples, found.inliers.len());
    }
    Ok(())
}

fn estimate_scenes(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    println!("{} scenes each, seed {}; degrees and milliseconds, median and mean", arguments.scenes, arguments.seed);
    println!("{:>8}  {:^17}  {:^17}  {:^17}  {:>7}", "outliers", "rotation", "translation", "time", "samples");
    for &outliers in &arguments.outliers {
        let mut columns: [Vec<f64>; 4] = Default::default();
        for pair in scenes(arguments, outliers) {
            let start = Instant::now();
            let found = estimate(&pair, &arguments.options)?;
            let milliseconds = start.elapsed().as_secs_f64() * 1e3;
            let [rotation, translation] = pair.truth.map_or([f64::NAN; 2], |truth| truth.degrees_to(&found.pose));
            let row = [rotation, translation, milliseconds, found.samples as f64];
            columns.iter_mut().zip(row).for_each(|(column, value)| column.push(value));
        }
        let [rotation, translation, time, (_, samples)] = columns.map(median_and_mean);
        print!("{:>6.0} %", 100.0 * outliers);
        for (median, mean) in [rotation, translation, time] {
            print!("  {median:>8.4} {mean:>8.4}");
        }
        println!("  {samples:>7.0}");
    }
    Ok(())
}

fn median_and_mean(mut values: Vec<f64>) -> (f64, f64) {
    values.sort_by(f64::total_cmp);
    let (low, high) = (values.get((values.len().max(1) - 1) / 2), values.get(values.len() / 2));
    let median = low.zip(high).map_or(f64::NAN, |(low, high)| 0.5 * (low + high));
    (median, values.iter().sum::<f64>() / values.len() as f64)
}
