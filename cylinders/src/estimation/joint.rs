//! Refinement of several cylinders at once that have a direction or a radius in common, or whose
//! direction or radius is known.
//!
//! ```text
//!   minimise  sum_k sum_i rho(|e_ki|^2 / 2)   over the parameters of all cylinders k
//! ```
//!
//! Each cylinder has the five local parameters of the single refinement (`silhouette_cost`). A
//! parameter that cylinders share is one unknown, to which the lines of all of them contribute; a
//! known one is none. All cylinders have the same unit of length, and each has its own origin.
//! Points near a surface add their squared distances from it.

use nalgebra::{DMatrix, DVector, Dyn, Point3, SVector, Unit, Vector3};

use super::loss::Loss;
use super::refine::{Measure, NO_RADIUS, RefineError, Refinement, STEPS, check};
use super::silhouette_cost::{Frame, Observed, PARAMETERS, SilhouetteCost, moved};
use super::uncertainty::{Block, Uncertainty};
use crate::numerics::interrupt::Interrupt;
use crate::numerics::levenberg_marquardt::{LeastSquares, Linearised, minimise};
use crate::space::cylinder::{Cylinder, Side};
use crate::space::silhouette_distance::MeasuredLine;

/// The radii of several cylinders.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Radii {
    /// Each has its own.
    #[default]
    Own,
    /// All have the same.
    Shared,
    /// All have this one, world units.
    Known(f64),
}

/// The directions of several cylinders.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub enum Directions {
    /// Each has its own.
    #[default]
    Own,
    /// All have the same.
    Shared,
    /// All have that of the first, which is known.
    Known,
}

/// How several cylinders are refined.
#[derive(Clone, Copy)]
pub(super) struct Model<'a> {
    pub(super) directions: Directions,
    pub(super) radii: Radii,
    pub(super) loss: Loss,
    /// Ends the refinement between steps.
    pub(super) interrupt: Interrupt<'a>,
}

/// Cylinders that were refined together.
#[derive(Clone, Debug, PartialEq)]
pub struct JointRefinement {
    /// The cylinders, in the order of the input. Noise and degrees of freedom are those of all
    /// lines.
    pub cylinders: Vec<Refinement>,
    /// The radius that they share, and its standard deviation.
    pub radius: Option<Measure>,
}

/// Refines cylinders together, each on what was observed of it. Copies of lines must have been
/// joined.
pub(super) fn refine_together(
    observed: &[Observed<'_>],
    initial: &[Cylinder],
    model: &Model<'_>,
) -> Result<JointRefinement, RefineError> {
    let Optimised { cylinders, iterations, converged } = optimise_together(observed, initial, model, STEPS)?;
    if !converged {
        return Err(RefineError::NotConverged { iterations });
    }
    // The directions are equal where they are shared, and so are their signs.
    let cylinders: Vec<_> = cylinders.into_iter().map(Cylinder::with_canonical_sign).collect();
    let frames = frames(observed, &cylinders)?;
    let problem = Problem::new(observed, &frames, model);
    let local: Vec<_> = frames.iter().zip(&cylinders).map(|(frame, cylinder)| frame.local(cylinder)).collect();
    let blocks: Vec<_> = (0..observed.len())
        .map(|index| Block { cost: &problem.costs[index], cylinder: &local[index], places: problem.places[index] })
        .collect();
    let uncertainty = Uncertainty::of(&blocks, problem.parameters)?;
    let refinement = |index: usize| {
        let lines = observed[index].lines;
        Refinement::new((&cylinders[index], &frames[index]), lines, &blocks[index], &uncertainty, iterations)
    };
    let cylinders: Vec<_> = (0..observed.len()).map(refinement).collect();
    let radius = cylinders.first().filter(|_| model.radii == Radii::Shared);
    let radius = radius.map(|first| Measure { value: first.cylinder.radius, deviation: first.deviation.radius });
    Ok(JointRefinement { cylinders, radius })
}

/// The state in which Levenberg-Marquardt ended.
pub(super) struct Optimised {
    pub(super) cylinders: Vec<Cylinder>,
    iterations: usize,
    converged: bool,
}

/// The optimum, or the cylinders that are reached after `limit` steps. Directions and radii that
/// are shared start from the first direction and the median radius.
pub(super) fn optimise_together(
    observed: &[Observed<'_>],
    initial: &[Cylinder],
    model: &Model<'_>,
    limit: usize,
) -> Result<Optimised, RefineError> {
    let start = start(initial, model)?;
    observed.iter().zip(&start).try_for_each(|(observed, cylinder)| check(observed.lines, cylinder, model.loss))?;
    let frames = frames(observed, &start)?;
    let problem = Problem::new(observed, &frames, model);
    let local = frames.iter().zip(&start).map(|(frame, cylinder)| frame.local(cylinder)).collect();
    let optimum = minimise(&problem, local, limit)?;
    if optimum.state.iter().any(|cylinder| cylinder.radius <= NO_RADIUS) {
        return Err(RefineError::NoRadius);
    }
    let cylinders = frames.iter().zip(&optimum.state).map(|(frame, local)| frame.world(local)).collect();
    Ok(Optimised { cylinders, iterations: optimum.iterations, converged: optimum.converged })
}

/// The cylinders with what they share.
fn start(initial: &[Cylinder], &Model { directions, radii, .. }: &Model<'_>) -> Result<Vec<Cylinder>, RefineError> {
    let Some(first) = initial.first() else { return Err(RefineError::TooFewLines { lines: 0 }) };
    let mut sorted: Vec<_> = initial.iter().map(|cylinder| cylinder.radius).collect();
    sorted.sort_by(f64::total_cmp);
    let with_shared = |cylinder: &Cylinder| Cylinder {
        direction: if directions == Directions::Own { cylinder.direction } else { first.direction },
        radius: match radii {
            Radii::Own => cylinder.radius,
            Radii::Shared => sorted[sorted.len() / 2],
            Radii::Known(radius) => radius,
        },
        ..*cylinder
    };
    Ok(initial.iter().map(with_shared).collect())
}

/// A frame for each cylinder, all with the same unit.
fn frames(observed: &[Observed<'_>], cylinders: &[Cylinder]) -> Result<Vec<Frame>, RefineError> {
    let frames = observed.iter().zip(cylinders).map(|(observed, cylinder)| Frame::of(cylinder, observed.lines));
    let frames: Vec<_> = frames.collect::<Result<_, _>>()?;
    let unit = frames.iter().map(|frame| frame.unit).sum::<f64>() / frames.len() as f64;
    Ok(frames.into_iter().map(|frame| Frame { unit, ..frame }).collect())
}

/// The cost of all cylinders together.
struct Problem<'a> {
    costs: Vec<SilhouetteCost>,
    /// The place of each local parameter of each cylinder; `None` for a known one.
    places: Vec<[Option<usize>; PARAMETERS]>,
    /// Number of parameters of all cylinders.
    parameters: usize,
    interrupt: Interrupt<'a>,
}

impl<'a> Problem<'a> {
    fn new(observed: &[Observed<'_>], frames: &[Frame], model: &Model<'a>) -> Self {
        let cost = |(observed, frame): (&Observed<'_>, &Frame)| SilhouetteCost::new(*observed, frame, model.loss);
        let (places, parameters) = places(observed.len(), model);
        let costs = observed.iter().zip(frames).map(cost).collect();
        Self { costs, places, parameters, interrupt: model.interrupt }
    }
}

/// The places of all local parameters of so many cylinders, and the number of places.
fn places(count: usize, &Model { directions, radii, .. }: &Model<'_>) -> (Vec<[Option<usize>; PARAMETERS]>, usize) {
    let mut next = 0;
    let mut new = || {
        next += 1;
        Some(next - 1)
    };
    let shared_direction = if directions == Directions::Shared { [new(), new()] } else { [None; 2] };
    let shared_radius = if radii == Radii::Shared { new() } else { None };
    let of_cylinder = |_| {
        let [first, second] = if directions == Directions::Own { [new(), new()] } else { shared_direction };
        let position = [new(), new()];
        let radius = if radii == Radii::Own { new() } else { shared_radius };
        [first, second, position[0], position[1], radius]
    };
    let places = (0..count).map(of_cylinder).collect();
    (places, next)
}

impl LeastSquares<Dyn> for Problem<'_> {
    type State = Vec<Cylinder>;
    type Error = RefineError;

    fn check(&self) -> Result<(), RefineError> {
        Ok(self.interrupt.check()?)
    }

    fn linearise(&self, cylinders: &Vec<Cylinder>) -> Result<Linearised<Dyn>, RefineError> {
        let mut sum: Linearised<Dyn> = Linearised {
            cost: 0.0,
            gradient: DVector::zeros(self.parameters),
            normal_matrix: DMatrix::zeros(self.parameters, self.parameters),
        };
        for ((cost, cylinder), places) in self.costs.iter().zip(cylinders).zip(&self.places) {
            let local = cost.linearise(cylinder)?;
            sum.cost += local.cost;
            for (row, place) in places.iter().enumerate() {
                let Some(place) = *place else { continue };
                sum.gradient[place] += local.gradient[row];
                for (column, other) in places.iter().enumerate() {
                    if let Some(other) = *other {
                        sum.normal_matrix[(place, other)] += local.normal_matrix[(row, column)];
                    }
                }
            }
        }
        Ok(sum)
    }

    fn moved(&self, cylinders: &Vec<Cylinder>, step: &DVector<f64>) -> Vec<Cylinder> {
        let of_cylinder = |(cylinder, places): (&Cylinder, &[Option<usize>; PARAMETERS])| {
            let local = SVector::from_fn(|row, _| places[row].map_or(0.0, |place| step[place]));
            moved(cylinder, &local)
        };
        cylinders.iter().zip(&self.places).map(of_cylinder).collect()
    }
}

/// What is known of a cylinder beside its lines.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Known {
    pub(crate) direction: Option<Unit<Vector3<f64>>>,
    pub(crate) radius: Option<f64>,
    /// The side of all lines, if the axis, with its largest entry positive, points up.
    pub(crate) side: Option<Side>,
}

impl Known {
    /// Number of parameters that are not known.
    pub(crate) fn parameters(&self) -> f64 {
        let known = 2 * usize::from(self.direction.is_some()) + usize::from(self.radius.is_some());
        (PARAMETERS - known) as f64
    }

    /// The refinement of one cylinder.
    fn model(&self) -> Model<'static> {
        let directions = if self.direction.is_some() { Directions::Known } else { Directions::Own };
        let radii = self.radius.map_or(Radii::Own, Radii::Known);
        Model { directions, radii, loss: Loss::Quadratic, interrupt: Interrupt::never() }
    }

    /// Whether all lines are on the known side of a cylinder.
    pub(crate) fn has_side(&self, lines: &[MeasuredLine], cylinder: &Cylinder) -> bool {
        let cylinder = cylinder.with_canonical_sign();
        let is_there = |line: &MeasuredLine, side| line.distance(&cylinder).is_some_and(|found| found.side() == side);
        self.side.is_none_or(|side| lines.iter().all(|line| is_there(line, side)))
    }

    /// A cylinder with the known radius: with its axis where it is, and so far away from the
    /// cameras that it looks as large as before. Otherwise the cylinder itself.
    pub(crate) fn sized(&self, cylinder: &Cylinder, cameras: &Point3<f64>) -> Vec<Cylinder> {
        let Some(radius) = self.radius else { return vec![*cylinder] };
        let moved = cameras + cylinder.vector_to_axis(cameras) * (radius / cylinder.radius);
        let here = Cylinder { radius, ..*cylinder };
        vec![here, Cylinder::new(&moved, cylinder.direction, radius)]
    }

    /// The cylinder of least squared distances near another one, after at most `limit` steps.
    pub(crate) fn nearest(&self, lines: &[MeasuredLine], start: &Cylinder, limit: usize) -> Option<Cylinder> {
        if self.direction.is_none() && self.radius.is_none() {
            return Some(super::refine::optimise(lines, start, Loss::Quadratic, limit).ok()?.cylinder);
        }
        let start = Cylinder { direction: self.direction.unwrap_or(start.direction), ..*start };
        let observed = [Observed::lines(lines)];
        let optimised = optimise_together(&observed, &[start], &self.model(), limit).ok()?;
        optimised.cylinders.first().copied()
    }
}
