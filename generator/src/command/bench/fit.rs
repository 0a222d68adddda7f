//! Fits the model of the time of a solve to measured times: `--fit`.

use std::fmt;

use serde::Serialize;

use super::timing_crate::Times;
use crate::plan::time::{MODEL, STAGES, WEIGHTS, Weight, predicted};

/// A solver: what is counted in its plan, and what it took.
pub(super) struct Sample {
    pub(super) counts: [f64; WEIGHTS],
    pub(super) times: Times,
}

impl Sample {
    /// The measured times of the stages.
    fn stages(&self) -> [f64; STAGES.len()] {
        [self.times.coefficients, self.times.elimination, self.times.after_elimination()]
    }
}

/// The model that ships beside the one that fits the measured times best.
#[derive(Serialize)]
pub(super) struct Fit {
    shipped: Judged,
    fitted: Judged,
}

/// A model, and by which factor its predictions are off, up or down.
#[derive(Serialize)]
struct Judged {
    /// Nanoseconds of one of what is counted.
    model: Vec<Line>,
    /// The predicted time of each solver, in the order of the files.
    predicted: Vec<f64>,
    median_factor: f64,
    p90_factor: f64,
    largest_factor: f64,
}

/// A weight of a model.
#[derive(Serialize)]
struct Line {
    stage: String,
    what: &'static str,
    nanoseconds: f64,
}

impl Fit {
    /// Fits each stage by itself.
    pub(super) fn of(samples: &[Sample]) -> Self {
        Self { shipped: Judged::of(&MODEL, samples), fitted: Judged::of(&fitted(samples), samples) }
    }
}

impl Judged {
    fn of(model: &[Weight; WEIGHTS], samples: &[Sample]) -> Self {
        let predicted: Vec<f64> =
            samples.iter().map(|sample| predicted(model, &sample.counts).iter().sum::<f64>()).collect();
        let factor = |(sample, predicted): (&Sample, &f64)| (predicted / sample.times.total).ln().abs().exp();
        let mut factors: Vec<f64> = samples.iter().zip(&predicted).map(factor).collect();
        factors.sort_by(f64::total_cmp);
        let quantile = |q: f64| factors.get(((factors.len() - 1) as f64 * q).round() as usize).copied().unwrap_or(1.0);
        let line =
            |&Weight { stage, what, nanoseconds }: &Weight| Line { stage: format!("{stage:?}"), what, nanoseconds };
        Self {
            model: model.iter().map(line).collect(),
            predicted,
            median_factor: quantile(0.5),
            p90_factor: quantile(0.9),
            largest_factor: quantile(1.0),
        }
    }
}

/// The model that minimises the squares of the relative errors of each stage, no weight negative.
fn fitted(samples: &[Sample]) -> [Weight; WEIGHTS] {
    let mut model = MODEL;
    for (at, &stage) in STAGES.iter().enumerate() {
        let columns: Vec<usize> = (0..WEIGHTS).filter(|&at| MODEL[at].stage == stage).collect();
        // A stage counts by its part of the whole: what takes little matters little.
        let importance = |sample: &Sample| 1.0 / sample.stages()[at].max(0.02 * sample.times.total);
        let rows: Vec<Vec<f64>> = samples
            .iter()
            .map(|sample| columns.iter().map(|&column| sample.counts[column] * importance(sample)).collect())
            .collect();
        let right: Vec<f64> = samples.iter().map(|sample| sample.stages()[at] * importance(sample)).collect();
        for (&column, value) in columns.iter().zip(nonnegative_least_squares(&rows, &right)) {
            model[column].nanoseconds = value;
        }
    }
    model
}

/// The x >= 0 with the least |A x - b|, by coordinate descent: the minimum along a coordinate is
/// known, and the problem is convex.
fn nonnegative_least_squares(rows: &[Vec<f64>], right: &[f64]) -> Vec<f64> {
    const ROUNDS: usize = 100_000;
    let width = rows.first().map_or(0, Vec::len);
    let mut x = vec![0.0; width];
    let mut residual = right.to_vec();
    let squares: Vec<f64> = (0..width).map(|j| rows.iter().map(|row| row[j] * row[j]).sum()).collect();
    for _ in 0..ROUNDS {
        let mut largest = 0.0_f64;
        for j in 0..width {
            let slope: f64 = rows.iter().zip(&residual).map(|(row, r)| row[j] * r).sum();
            // A column of zeros has nothing to fit.
            let step = if squares[j] > 0.0 { (slope / squares[j]).max(-x[j]) } else { 0.0 };
            x[j] += step;
            rows.iter().zip(&mut residual).for_each(|(row, r)| *r -= step * row[j]);
            largest = largest.max(step.abs() * squares[j].sqrt());
        }
        if largest < 1e-12 {
            break;
        }
    }
    x
}

impl fmt::Display for Fit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "\nThe model of the time of a solve (`generator/src/plan/time.rs`), fitted to these times:\n")?;
        for Line { stage, what, nanoseconds } in &self.fitted.model {
            writeln!(f, "    weight({stage}, {what:?}, {nanoseconds:.3}),")?;
        }
        writeln!(f)?;
        for (name, judged) in [("shipped", &self.shipped), ("fitted", &self.fitted)] {
            let Judged { median_factor, p90_factor, largest_factor, .. } = judged;
            writeln!(
                f,
                "the {name} model is wrong by a factor of {median_factor:.2} in the median, {p90_factor:.2} at 90 %, \
                 {largest_factor:.2} at most"
            )?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn least_squares_without_negative_numbers() {
        // Without the bound the solution is (3, -1).
        let rows = [vec![1.0, 0.0], vec![1.0, 1.0], vec![0.0, 1.0]];
        let x = nonnegative_least_squares(&rows, &[3.0, 2.0, -1.0]);
        assert!((x[0] - 2.5).abs() < 1e-9 && x[1] == 0.0, "{x:?}");
        let x = nonnegative_least_squares(&rows, &[3.0, 5.0, 2.0]);
        assert!((x[0] - 3.0).abs() < 1e-9 && (x[1] - 2.0).abs() < 1e-9, "{x:?}");
    }

    #[test]
    fn a_model_that_made_the_times_is_found() {
        let model: [Weight; WEIGHTS] = std::array::from_fn(|at| Weight { nanoseconds: 1.0 + at as f64, ..MODEL[at] });
        let mut random = crate::algebra::Random::new(1);
        let samples: Vec<Sample> = (0..60)
            .map(|_| {
                let counts = std::array::from_fn(|_| 1.0 + 9.0 * random.symmetric_unit().abs());
                let [coefficients, elimination, solutions] = predicted(&model, &counts);
                let total = coefficients + elimination + solutions;
                Sample { counts, times: Times { coefficients, elimination, solutions, total, ..Times::default() } }
            })
            .collect();
        let fit = Fit::of(&samples);
        assert!(fit.fitted.largest_factor < 1.0001, "{}", fit.fitted.largest_factor);
        assert!(fit.fitted.model.iter().zip(&model).all(|(a, b)| (a.nanoseconds / b.nanoseconds - 1.0).abs() < 1e-3));
    }
}
