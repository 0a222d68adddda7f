//! Experiments of Gummeson & Oskarsson, "Robust and Accurate Cylinder Triangulation", on simulated scenes.
//!
//! An experiment is a function from options to tables and pictures; who calls it writes the files. Instance `k` of a run is
//! drawn from a generator that depends on the seed and `k` only, so the result depends neither on the number of threads nor, for
//! the first instances, on how many follow.

/// A simulated soda can in photographs from all sides.
mod can;
/// `conditioning`: a limited viewing range.
mod conditioning;
/// Seeded instances, on all processors.
mod instances;
/// `matching`: parallel cylinders without correspondences.
mod matching;
/// `noise`: the response of the solvers to noise.
mod noise;
/// `one_sided`: only the left silhouettes.
mod one_sided;
/// Quantiles of samples.
mod quantile;
/// Seeds of instances, and random choices.
mod random;
/// `real`: a scene file by all methods.
mod real;
/// `residuals`: what the solvers leave on noise-free data.
mod residuals;
/// Circles and their tangents from cameras in the plane.
mod section_scene;
/// Tables as text, CSV and JSON.
mod table;
/// `table1`: distance to the true conic.
mod table1;

use std::fmt;
use std::path::PathBuf;

use serde::Serialize;
use thiserror::Error;

use super::input::InputError;
use super::picture::{Format, Picture, PictureError};
use super::view::ViewError;

pub use table::Table;

/// The experiments.
#[derive(clap::ValueEnum, Clone, Copy, Debug, Eq, PartialEq)]
pub enum Experiment {
    /// What all solvers leave on noise-free data
    Residuals,
    /// Response of the minimal solver and of least squares to noise
    Noise,
    /// Distance to the true conic of proposed, linear and Navab's method for a soda can in 2 to 15 photographs
    Table1,
    /// Linear and constrained estimate for a limited viewing range
    Conditioning,
    /// Proposed and linear method for fifteen left silhouettes
    #[value(name = "one_sided")]
    OneSided,
    /// Seven cylinders in twelve images without correspondences; success against outlier rate and noise
    Matching,
    /// All methods and refinement on a scene file, by default of a round tower, beside its sparse points
    Real,
}

/// What an experiment is run with.
#[derive(Clone, Debug)]
pub struct Options {
    /// Number of instances; of the experiment itself where it is not given.
    pub runs: Option<usize>,
    /// Seed of all instances.
    pub seed: u64,
    /// Scene file of the experiment `real`.
    pub scene: Option<PathBuf>,
}

/// What an experiment found.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// What was done, in a few lines of text.
    pub setup: String,
    /// Number of instances.
    pub runs: usize,
    /// The results.
    pub tables: Vec<Table>,
    /// Names and contents of picture files.
    pub pictures: Vec<(String, Vec<u8>)>,
}

/// Why an experiment was not finished.
#[derive(Debug, Error)]
pub enum ExperimentError {
    /// A picture cannot be drawn.
    #[error("{name}: {source}")]
    Picture {
        /// Name of its file.
        name: String,
        /// Reason.
        source: PictureError,
    },
    /// The simulated cameras are out of range.
    #[error(transparent)]
    View(#[from] ViewError),
    /// The scene cannot be read.
    #[error(transparent)]
    Input(#[from] InputError),
    /// The lines of the scene determine no cylinder.
    #[error("{}: {reason}", path.display())]
    Scene {
        /// The file.
        path: PathBuf,
        /// Why.
        reason: String,
    },
    /// A scene is given to an experiment that simulates its own.
    #[error("only the experiment `real` takes a scene file")]
    NoScene,
    /// A table cannot be written as CSV.
    #[error("{table}: {source}")]
    Csv {
        /// Name of the table.
        table: String,
        /// Reason.
        source: csv::Error,
    },
}

impl Experiment {
    /// Runs it, with a progress bar on standard error where that is a terminal.
    ///
    /// # Errors
    /// [`ExperimentError`].
    pub fn run(self, options: &Options) -> Result<Outcome, ExperimentError> {
        if options.scene.is_some() && self != Self::Real {
            return Err(ExperimentError::NoScene);
        }
        match self {
            Self::Residuals => residuals::run(options),
            Self::Noise => noise::run(options),
            Self::Table1 => table1::run(options),
            Self::Conditioning => conditioning::run(options),
            Self::OneSided => one_sided::run(options),
            Self::Matching => matching::run(options),
            Self::Real => real::run(options),
        }
    }
}

impl Options {
    fn runs_or(&self, default: usize) -> usize {
        self.runs.unwrap_or(default)
    }
}

impl Outcome {
    fn new(setup: impl Into<String>, runs: usize) -> Self {
        Self { setup: setup.into(), runs, tables: Vec::new(), pictures: Vec::new() }
    }

    /// Adds a picture, as SVG and as PNG.
    fn draw(&mut self, name: &str, picture: &impl Picture) -> Result<(), ExperimentError> {
        for (format, extension) in [(Format::Svg, "svg"), (Format::Png, "png")] {
            let name = format!("{name}.{extension}");
            match format.render(picture) {
                Ok(content) => self.pictures.push((name, content)),
                Err(source) => return Err(ExperimentError::Picture { name, source }),
            }
        }
        Ok(())
    }

    /// Names and contents of all files but the summary: a CSV file for each table, and the pictures.
    ///
    /// # Errors
    /// [`ExperimentError::Csv`].
    pub fn files(&self) -> Result<Vec<(String, Vec<u8>)>, ExperimentError> {
        let csv = |table: &Table| match table.to_csv() {
            Ok(content) => Ok((format!("{}.csv", table.name), content)),
            Err(source) => Err(ExperimentError::Csv { table: table.name.clone(), source }),
        };
        let mut files = self.tables.iter().map(csv).collect::<Result<Vec<_>, _>>()?;
        files.extend(self.pictures.iter().cloned());
        Ok(files)
    }

    /// What the experiment found, for people and as JSON.
    pub fn summary(&self, experiment: &str, options: &Options) -> Summary<'_> {
        Summary {
            experiment: experiment.to_owned(),
            runs: self.runs,
            seed: options.seed,
            setup: &self.setup,
            tables: &self.tables,
        }
    }
}

/// What an experiment found.
#[derive(Debug, Serialize)]
pub struct Summary<'a> {
    experiment: String,
    runs: usize,
    seed: u64,
    setup: &'a str,
    tables: &'a [Table],
}

impl fmt::Display for Summary<'_> {
    fn fmt(&self, text: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(text, "{}: {} runs, seed {}\n{}", self.experiment, self.runs, self.seed, self.setup)?;
        self.tables.iter().try_for_each(|table| write!(text, "\n{table}"))
    }
}
