//! What makes instances with known solutions, and how far a solution is from a known one.

use eliminant_generator::algebra::Random;

use super::cameras::Motion;
use super::views::View;
use crate::Case;
use crate::statistics::worst;

/// A truth counts as found if some real solution is this close.
pub const FOUND: f64 = 1e-6;

/// Data of a problem with solutions known from the way they were made.
pub struct KnownInstance {
    /// Flat data, as a [`crate::Case`] takes them.
    pub data: Vec<f64>,
    /// Values of all unknowns for solutions that are known; not always all solutions.
    pub truths: Vec<Vec<f64>>,
}

/// Draws instances.
#[derive(Clone, Copy)]
pub enum Make {
    /// Of any scene.
    Scene(fn(&mut Random) -> KnownInstance),
    /// Of two cameras, between which there is a motion of any kind.
    TwoCameras(fn(&mut Random, Motion) -> KnownInstance),
    /// Of a camera that sees points of known position, in any way.
    KnownPoints(fn(&mut Random, View) -> KnownInstance),
}

impl Make {
    /// Draws an instance; of cameras that are placed independently of each other and the points.
    pub fn draw(self, random: &mut Random) -> KnownInstance {
        match self {
            Self::Scene(make) => make(random),
            Self::TwoCameras(make) => make(random, Motion::General),
            Self::KnownPoints(make) => make(random, View::General),
        }
    }
}

/// Makes instances of one problem.
pub struct Maker {
    /// Name of the problem.
    pub name: &'static str,
    /// How an instance is drawn.
    pub make: Make,
    /// The relative error of a solution against a truth: `error(data, solution, truth)`.
    pub error: fn(&[f64], &[f64], &[f64]) -> f64,
}

impl Maker {
    /// Draws an instance and solves it: the error of the truth that is found worst, infinite where
    /// a solution is missing altogether.
    pub fn worst_error(&self, case: &Case, random: &mut Random) -> f64 {
        let instance = self.make.draw(random);
        let Ok(found) = (case.solve)(&instance.data) else { return f64::INFINITY };
        let error_of = |truth: &Vec<f64>| {
            found.iter().map(|solution| (self.error)(&instance.data, solution, truth)).fold(f64::INFINITY, f64::min)
        };
        worst(instance.truths.iter().map(error_of))
    }
}

/// |x - truth| / |truth|; |x - truth| where the truth is 0.
pub fn relative_error(x: &[f64], truth: &[f64]) -> f64 {
    let square = |v: &mut dyn Iterator<Item = f64>| v.map(|x| x * x).sum::<f64>().sqrt();
    let size = square(&mut truth.iter().copied());
    square(&mut x.iter().zip(truth).map(|(x, t)| x - t)) / if size == 0.0 { 1.0 } else { size }
}

/// Distance of the unit vectors along x and truth, up to sign.
pub fn projective_error(x: &[f64], truth: &[f64]) -> f64 {
    let norm = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let (x_norm, truth_norm) = (norm(x), norm(truth));
    let unit: Vec<f64> = x.iter().map(|x| x / x_norm).collect();
    let [plus, minus] = [1.0, -1.0].map(|sign| {
        let truth: Vec<f64> = truth.iter().map(|t| sign * t / truth_norm).collect();
        relative_error(&unit, &truth)
    });
    plus.min(minus)
}

/// The largest relative error of the unknowns, each for itself; that of an unknown that is 0 is
/// absolute.
pub fn largest_relative_error(x: &[f64], truth: &[f64]) -> f64 {
    worst(x.iter().zip(truth).map(|(&x, &truth)| relative_error(&[x], &[truth])))
}
