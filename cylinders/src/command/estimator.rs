//! The arguments for the estimation of cylinders, shared by the subcommands that find cylinders by
//! label.

use super::error::CommandError;
use super::scene::SceneArguments;
use crate::{
    CylinderLines, Estimate, EstimateError, Method, ParallelError, RansacOptions, RobustOptions, View, estimate,
    parallel_estimates, triangulate_parallel,
};

/// How to estimate.
#[derive(clap::Args, Debug)]
pub(super) struct EstimatorArguments {
    /// Find the cylinder by RANSAC if many lines are wrong, and refine it
    #[arg(long)]
    robust: bool,
    /// Upper bound of the distance of a line from its silhouette: pixels (default 48), or radians
    /// without calibration (default 0.016). Less is allowed where the lines show less noise: three
    /// times their estimated deviation
    #[arg(long, value_name = "PIXELS", requires = "robust", value_parser = positive)]
    threshold: Option<f64>,
    /// Seed of the random numbers
    #[arg(long, default_value_t = 0, requires = "robust")]
    seed: u64,
    /// Probability that at least one sample of three correct lines is drawn
    #[arg(long, default_value_t = 0.999, requires = "robust", value_parser = probability)]
    confidence: f64,
    /// Refine on the distances of the lines from their silhouettes; the output then has standard
    /// deviations
    #[arg(long)]
    refine: bool,
    /// Estimate one direction for the cylinders of all labels
    #[arg(long, conflicts_with_all = ["robust", "refine"])]
    parallel: bool,
}

fn number(text: &str, is_valid: impl Fn(f64) -> bool, range: &str) -> Result<f64, String> {
    text.parse().ok().filter(|&number| is_valid(number)).ok_or_else(|| format!("not a number {range}"))
}

fn positive(text: &str) -> Result<f64, String> {
    number(text, |number| number > 0.0 && number.is_finite(), "greater than 0")
}

fn probability(text: &str) -> Result<f64, String> {
    number(text, |number| number > 0.0 && number < 1.0, "between 0 and 1")
}

impl EstimatorArguments {
    /// The cylinders of a scene, in the order of their lines.
    pub(super) fn estimate(
        &self,
        scene: &SceneArguments,
        cylinders: &[CylinderLines],
    ) -> Result<Vec<Estimate>, CommandError> {
        let failure = |index: usize, error: EstimateError| CommandError::Estimate {
            scene: scene.path().to_owned(),
            label: cylinders.get(index).and_then(|lines| lines.label.clone()),
            error,
        };
        if self.parallel {
            let views: Vec<_> = cylinders.iter().map(|lines| lines.views.clone()).collect();
            let result = triangulate_parallel(&views).map_err(|error| match error {
                ParallelError::Cylinder { cylinder, error } => failure(cylinder, error.into()),
                // The error has no label, because it concerns the lines of all cylinders.
                error @ ParallelError::Direction(_) => failure(usize::MAX, error.into()),
            })?;
            return Ok(parallel_estimates(result, &views));
        }
        let estimate = |(index, lines)| self.single(lines).map_err(|error| failure(index, error));
        cylinders.iter().enumerate().map(estimate).collect()
    }

    fn single(&self, CylinderLines { views, .. }: &CylinderLines) -> Result<Estimate, EstimateError> {
        let method = match (self.robust, self.refine) {
            (true, _) => Method::Robust(self.robust_options(views)),
            (false, true) => Method::Refined,
            (false, false) => Method::LeastSquares,
        };
        estimate(views, &method)
    }

    fn robust_options(&self, views: &[View]) -> RobustOptions {
        let default = RobustOptions::of(views);
        let threshold = self.threshold.unwrap_or(default.ransac.threshold);
        let ransac = RansacOptions { threshold, seed: self.seed, confidence: self.confidence, ..default.ransac };
        RobustOptions { ransac, ..default }
    }
}
