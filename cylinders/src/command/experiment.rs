//! `cylinders experiment`: runs an experiment and writes its files.

use std::path::PathBuf;

use clap::ValueEnum;

use super::error::CommandError;
use super::files::write_all;
use super::output::Output;
use crate::experiment::{Experiment, Options};

/// Repeat an experiment of the paper
#[derive(clap::Args, Debug)]
#[command(after_help = "Writes a CSV file for each table, the pictures as SVG and PNG, summary.txt and summary.json.
The same seed gives the same files, on any number of threads (RAYON_NUM_THREADS).

Example:
  cylinders experiment noise --runs 1000 --out noise")]
pub(super) struct Arguments {
    /// The experiment
    name: Experiment,
    /// Scene file, for the experiment `real` only
    scene: Option<PathBuf>,
    /// Number of instances, by default as in the paper
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..))]
    runs: Option<u32>,
    /// Seed of all instances
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Folder of the files; it is created if it does not exist
    #[arg(long, value_name = "FOLDER")]
    out: PathBuf,
}

/// Computes all files, then writes them.
pub(super) fn run(arguments: &Arguments) -> Result<Output, CommandError> {
    let runs = arguments.runs.map(|runs| runs as usize);
    let options = Options { runs, seed: arguments.seed, scene: arguments.scene.clone() };
    let outcome = arguments.name.run(&options)?;
    let name = arguments.name.to_possible_value().map_or(String::new(), |value| value.get_name().to_owned());
    let output = Output::of(&outcome.summary(&name, &options));
    let mut files = outcome.files()?;
    files.push(("summary.txt".to_owned(), output.text.clone().into_bytes()));
    files.push(("summary.json".to_owned(), output.json.clone().into_bytes()));
    let folder = &arguments.out;
    let files: Vec<_> = files.into_iter().map(|(name, content)| (folder.join(name), content)).collect();
    write_all(&[folder.as_path()], &files)?;
    Ok(output)
}
