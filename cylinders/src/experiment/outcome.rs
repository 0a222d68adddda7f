//! What an experiment found: tables and pictures, for files and as a summary.

use std::fmt;

use serde::Serialize;

use super::error::ExperimentError;
use super::options::Options;
use super::table::Table;
use crate::picture::{Format, Picture};

/// What an experiment found.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Description of the experiment, in a few lines of text.
    pub setup: String,
    /// Number of instances.
    pub runs: usize,
    /// The results.
    pub tables: Vec<Table>,
    /// Names and contents of picture files.
    pub pictures: Vec<(String, Vec<u8>)>,
}

impl Outcome {
    /// Without tables and pictures.
    pub(super) fn new(setup: impl Into<String>, runs: usize) -> Self {
        Self { setup: setup.into(), runs, tables: Vec::new(), pictures: Vec::new() }
    }

    /// Adds a picture, as SVG and as PNG.
    pub(super) fn draw(&mut self, name: &str, picture: &impl Picture) -> Result<(), ExperimentError> {
        for (format, extension) in [(Format::Svg, "svg"), (Format::Png, "png")] {
            let name = format!("{name}.{extension}");
            match format.render(picture) {
                Ok(content) => self.pictures.push((name, content)),
                Err(source) => return Err(ExperimentError::Picture { name, source }),
            }
        }
        Ok(())
    }

    /// Names and contents of all files but the summary: a CSV file for each table, and the
    /// pictures.
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

    /// The results for people and as JSON.
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
