//! Histograms of log10 of residuals and errors, in `templates/histograms.csv`.
//!
//! ```text
//!   problem, figure, -17, -16.5, .., -0.5, 0     the lower edges of the bins
//!   a,       residual, 0, 512,   .., 0,    0     how many values lie in each
//! ```
//!
//! The first bin holds what is smaller, too, the last one what is larger, or missing.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::templates_folder;

/// The lower edge of the first bin.
const FIRST: f64 = -17.0;
/// The width of a bin.
const WIDTH: f64 = 0.5;
/// The number of bins: the last one begins at 0, a value of 1.
pub const BINS: usize = 35;

/// How many values lie in each bin.
pub type Counts = [u64; BINS];

/// The counts of these values of log10; infinity stands for one that is missing.
#[must_use]
pub fn counts(values: &[f64]) -> Counts {
    let mut counts = [0; BINS];
    for value in values {
        // A negative number becomes 0.
        counts[(((value - FIRST) / WIDTH).floor() as usize).min(BINS - 1)] += 1;
    }
    counts
}

/// The histograms of all problems, by problem and figure.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Histograms {
    /// The counts.
    pub counts: BTreeMap<(String, String), Counts>,
}

/// Where they lie.
#[must_use]
pub fn path() -> PathBuf {
    templates_folder().join("histograms.csv")
}

impl Histograms {
    /// Adds, or replaces, those of a problem.
    pub fn insert(&mut self, problem: &str, figures: impl IntoIterator<Item = (&'static str, Counts)>) {
        self.counts.extend(figures.into_iter().map(|(name, counts)| ((problem.to_owned(), name.to_owned()), counts)));
    }

    /// Those of a problem.
    pub fn of(&self, problem: &str) -> impl Iterator<Item = ((String, String), Counts)> {
        self.counts.iter().filter(move |((of, _), _)| of == problem).map(|(key, counts)| (key.clone(), *counts))
    }

    /// Of a file.
    ///
    /// # Errors
    /// If it cannot be read, or a row has another number of cells.
    pub fn read(path: &Path) -> Result<Self, csv::Error> {
        let mut histograms = Self::default();
        for row in csv::Reader::from_path(path)?.deserialize() {
            let (problem, figure, counts): (String, String, Vec<u64>) = row?;
            let counts = counts.try_into().map_err(|_| std::io::Error::other(format!("{problem}: not {BINS} bins")))?;
            histograms.counts.insert((problem, figure), counts);
        }
        Ok(histograms)
    }

    /// The text of the file.
    ///
    /// # Errors
    /// None that can occur: it is written to memory.
    pub fn text(&self) -> Result<String, Box<dyn std::error::Error>> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        let edges = (0..BINS).map(|bin| (FIRST + WIDTH * bin as f64).to_string());
        writer.write_record(["problem", "figure"].map(str::to_owned).into_iter().chain(edges))?;
        for ((problem, figure), counts) in &self.counts {
            let cells = [problem.clone(), figure.clone()].into_iter().chain(counts.iter().map(u64::to_string));
            writer.write_record(cells)?;
        }
        Ok(String::from_utf8(writer.into_inner()?)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases;

    #[test]
    fn values_lie_in_the_bins_of_their_lower_edges() {
        let found = counts(&[f64::NEG_INFINITY, -17.0, -16.5, -0.4, 0.0, 3.0, f64::INFINITY]);
        let mut wanted = [0; BINS];
        (wanted[0], wanted[1], wanted[33], wanted[34]) = (2, 1, 1, 3);
        assert_eq!(found, wanted);
    }

    #[test]
    fn the_file_has_two_histograms_of_every_problem_and_no_others() {
        let histograms = Histograms::read(&path()).unwrap();
        assert_eq!(histograms.text().unwrap(), std::fs::read_to_string(path()).unwrap());
        let problems: Vec<(&str, &str)> =
            cases().iter().flat_map(|case| [(case.name, "error"), (case.name, "residual")]).collect();
        let listed: Vec<(&str, &str)> = histograms.counts.keys().map(|(a, b)| (a.as_str(), b.as_str())).collect();
        assert_eq!(listed, problems);
    }
}
