//! The histograms of `templates/histograms.csv`.

use std::collections::BTreeMap;

/// What is drawn of one figure of a problem.
pub(crate) struct Histogram {
    /// The lower edges of the bins, log10.
    pub(crate) edges: Vec<f64>,
    /// The part of all values that lies in each bin.
    pub(crate) shares: Vec<f64>,
}

/// All histograms, by problem and figure.
pub(crate) struct Histograms {
    edges: Vec<f64>,
    counts: BTreeMap<(String, String), Vec<f64>>,
}

impl Histograms {
    /// Of a text: the lower edges of the bins, and then a row for each figure of each problem.
    pub(crate) fn of(text: &str) -> Result<Self, csv::Error> {
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let edges: (String, String, Vec<f64>) = reader.headers()?.deserialize(None)?;
        let rows = reader.deserialize().map(|row| {
            let (problem, figure, counts): (String, String, Vec<f64>) = row?;
            Ok(((problem, figure), counts))
        });
        Ok(Self { edges: edges.2, counts: rows.collect::<Result<_, csv::Error>>()? })
    }

    /// A figure of a problem.
    pub(crate) fn get(&self, problem: &str, figure: &str) -> Result<Histogram, String> {
        let counts = self.counts.get(&(problem.to_owned(), figure.to_owned()));
        let counts = counts.ok_or_else(|| format!("there is no histogram `{figure}` of `{problem}`"))?;
        let all: f64 = counts.iter().sum();
        Ok(Histogram { edges: self.edges.clone(), shares: counts.iter().map(|count| count / all.max(1.0)).collect() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_stand_above_the_edges_of_the_head() {
        let histograms = Histograms::of("problem,figure,-1,-0.5\na,error,1,3\n").unwrap();
        let found = histograms.get("a", "error").unwrap();
        assert_eq!((found.edges, found.shares), (vec![-1.0, -0.5], vec![0.25, 0.75]));
        assert!(histograms.get("a", "residual").is_err());
    }
}
