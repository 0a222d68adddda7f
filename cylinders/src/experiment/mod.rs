//! Experiments of Gummeson & Oskarsson, "Robust and Accurate Cylinder Triangulation", on simulated
//! scenes.
//!
//! An experiment is a function from options to tables and pictures; the caller writes the files.
//! Instance `k` of a run is drawn from a generator that depends only on the seed and `k`, so the
//! result does not depend on the number of threads, and more runs do not change the first ones.

/// A simulated soda can in photographs from all sides.
mod can;
/// `conditioning`: a limited viewing range.
mod conditioning;
/// Why an experiment was not finished.
mod error;
/// Seeded instances, on all processors.
mod instances;
/// `matching`: parallel cylinders without correspondences.
mod matching;
/// `noise`: the response of the solvers to noise.
mod noise;
/// `one_sided`: only the left silhouettes.
mod one_sided;
/// `one_sided` with cameras on one side.
mod one_sided_range;
/// What an experiment is run with.
mod options;
/// What an experiment found.
mod outcome;
/// Least squares with the choice of the circle in front of the cameras.
mod proposed;
/// Quantiles of samples.
mod quantile;
/// Seeds of instances, and random choices.
mod random;
/// `real`: a scene file by all methods.
mod real;
/// `residuals`: the residuals of the solvers on noise-free data.
mod residuals;
/// Circles and their tangents from cameras in the plane.
mod section_scene;
/// Tables as text, CSV and JSON.
mod table;
/// `table1`: distance to the true conic.
mod table1;
/// `table1` with views among fixed photographs, as in the paper.
mod table1_fixed;

pub use error::ExperimentError;
pub use options::Options;
pub use outcome::{Outcome, Summary};
pub use table::Table;

/// The experiments.
#[derive(clap::ValueEnum, Clone, Copy, Debug, Eq, PartialEq)]
pub enum Experiment {
    /// Residuals of all solvers on noise-free data
    Residuals,
    /// Response of the minimal solver and of least squares to noise
    Noise,
    /// Distance to the true conic of the proposed, the linear and Navab's method for a soda can in
    /// 2 to 15 photographs, with new noise for each draw and, as in the paper, with fixed noise
    Table1,
    /// Linear and constrained estimate for a limited viewing range
    Conditioning,
    /// Proposed and linear method for fifteen left silhouettes, from all sides and from one side
    #[value(name = "one_sided")]
    OneSided,
    /// Seven cylinders in twelve images without correspondences: success against outlier rate and
    /// noise
    Matching,
    /// All methods and refinement on a scene file, by default a round tower, compared with its
    /// sparse points, and silhouettes over its photographs
    Real,
}

impl Experiment {
    /// Runs the experiment, with a progress bar if standard error is a terminal.
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
