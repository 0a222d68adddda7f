//! The arguments for the estimation of cylinders, shared by the subcommands that find cylinders by
//! label.

use nalgebra::Point3;

use super::error::CommandError;
use super::scene::SceneArguments;
use crate::{
    CylinderLines, Estimate, EstimateError, JointError, JointEstimate, JointMethod, Loss, Method, Radii, RansacOptions,
    RefineError, RobustOptions, Side, TriangulateError, View, estimate, estimate_on_side, estimate_together,
    with_points,
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
    #[arg(long, conflicts_with = "robust")]
    parallel: bool,
    /// Estimate one radius for the cylinders of all labels; refines
    #[arg(long, conflicts_with_all = ["robust", "radius"])]
    shared_radius: bool,
    /// The radius of all cylinders, if it is known, world units; refines
    #[arg(long, value_name = "R", conflicts_with = "robust", value_parser = positive)]
    radius: Option<f64>,
    /// Points of the scene near the surface are evidence, too, as far as they gather there; refines
    #[arg(long)]
    points: bool,
    /// The side of all lines, for one line in each image: left or right of the axis if its
    /// direction, with the largest entry positive, points up; refines
    #[arg(long, value_enum, conflicts_with_all = ["robust", "parallel", "shared_radius", "radius"])]
    side: Option<SideArgument>,
}

/// [`Side`] on the command line.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum SideArgument {
    Left,
    Right,
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
    /// The cylinders of a scene, in the order of their lines, and the radius that they share.
    pub(super) fn estimate(
        &self,
        scene: &SceneArguments,
        cylinders: &[CylinderLines],
        points: &[Point3<f64>],
    ) -> Result<JointEstimate, CommandError> {
        if self.points && points.is_empty() {
            return Err(CommandError::NoPoints { scene: scene.path().to_owned() });
        }
        let estimate = self.of_lines(scene, cylinders)?;
        if !self.points {
            return Ok(estimate);
        }
        let views: Vec<_> = cylinders.iter().map(|lines| lines.views.clone()).collect();
        let method = self.joint_method().unwrap_or_default();
        with_points(estimate, &views, points, &method).map_err(|error| self.failure(scene, cylinders, error))
    }

    /// The message of an error of one cylinder, or of all together.
    fn failure(&self, scene: &SceneArguments, cylinders: &[CylinderLines], error: JointError) -> CommandError {
        let (index, error) = match error {
            JointError::Cylinder { cylinder, error } => (Some(cylinder), error),
            // An error of all cylinders together has no label.
            JointError::Direction(error) => (None, TriangulateError::Direction(error).into()),
            JointError::Refine(error) => (None, error.into()),
            JointError::Interrupted(error) => (None, RefineError::Interrupted(error).into()),
        };
        let label = index.and_then(|index| cylinders.get(index)?.label.clone());
        CommandError::Estimate { scene: scene.path().to_owned(), label, error }
    }

    fn of_lines(&self, scene: &SceneArguments, cylinders: &[CylinderLines]) -> Result<JointEstimate, CommandError> {
        let failure = |error| self.failure(scene, cylinders, error);
        if let Some(method) = self.joint_method() {
            let views: Vec<_> = cylinders.iter().map(|lines| lines.views.clone()).collect();
            return estimate_together(&views, &method).map_err(failure);
        }
        let estimate =
            |(cylinder, lines)| self.single(lines).map_err(|error| failure(JointError::Cylinder { cylinder, error }));
        let cylinders = cylinders.iter().enumerate().map(estimate).collect::<Result<_, _>>()?;
        Ok(JointEstimate { cylinders, radius: None })
    }

    /// How cylinders are estimated together; `None` if they share nothing.
    fn joint_method(&self) -> Option<JointMethod<'static>> {
        let radii = match self.radius {
            Some(radius) => Radii::Known(radius),
            None if self.shared_radius => Radii::Shared,
            None => Radii::Own,
        };
        let refines = self.refine || radii != Radii::Own;
        let refinement = refines.then_some((radii, Loss::Quadratic));
        let method = JointMethod { parallel: self.parallel, refinement, ..JointMethod::default() };
        (self.parallel || radii != Radii::Own).then_some(method)
    }

    fn single(&self, CylinderLines { views, .. }: &CylinderLines) -> Result<Estimate, EstimateError> {
        match self.side {
            Some(SideArgument::Left) => return estimate_on_side(views, Side::Left),
            Some(SideArgument::Right) => return estimate_on_side(views, Side::Right),
            None => {}
        }
        let method = match (self.robust, self.refine) {
            (true, _) => Method::Robust(self.robust_options(views)),
            (false, true) => Method::Refined,
            (false, false) => Method::LeastSquares,
        };
        estimate(views, &method)
    }

    fn robust_options(&self, views: &[View]) -> RobustOptions<'static> {
        let default = RobustOptions::of(views);
        let threshold = self.threshold.unwrap_or(default.ransac.threshold);
        let ransac = RansacOptions { threshold, seed: self.seed, confidence: self.confidence, ..default.ransac };
        RobustOptions { ransac, ..default }
    }
}
