//! The method `least-squares`: all stationary circles of the cost in the module `circle`, the
//! global minimum first.

use super::circle::{Circle, CircleError};
use super::normalise::Normalisation;
use super::section::{Section, SectionError, SectionLine, SectionSolver, check_lines, weighted_mean_square};
use super::stationary::{Kind, StationaryPoint, stationary_points};

/// A circle fits exactly if the root mean square of `r^2 - h^2` is at most this, in units of the
/// normalised lines or of `r^2`, whichever is larger.
const EXACT_FIT: f64 = 1e-9;

/// Constrained least squares with a weight for each line. Circles that touch all lines exactly come
/// first, by radius (three lines have up to four such circles). The other stationary points follow,
/// by cost.
#[derive(Clone, Copy, Debug, Default)]
pub struct LeastSquares;

impl SectionSolver for LeastSquares {
    fn name(&self) -> &'static str {
        "least-squares"
    }

    fn least_lines(&self) -> usize {
        3
    }

    fn solve(&self, lines: &[SectionLine]) -> Result<Vec<Section>, SectionError> {
        check_lines(lines, self.least_lines())?;
        let stationary = StationaryCircles::of(lines)?;
        if stationary.len() == 0 {
            return Err(CircleError::NoCircle.into());
        }
        let section = |(circle, cost)| Section { cost, ..Section::from_circle(circle, lines) };
        Ok(stationary.iter().map(section).collect())
    }
}

/// The stationary circles in normalised coordinates, each with its cost, the best first.
pub(crate) struct StationaryCircles {
    normalisation: Normalisation,
    candidates: Vec<Candidate>,
}

struct Candidate {
    circle: Circle,
    /// Weighted mean square of `r^2 - h^2`, evaluated on the lines: `d^T G d` loses all digits by
    /// cancellation if the fit is good.
    mean_square: f64,
    exact: bool,
    is_minimum: bool,
}

impl StationaryCircles {
    pub(crate) fn of(lines: &[SectionLine]) -> Result<Self, CircleError> {
        let normalisation = Normalisation::of(lines)?;
        let normalised = normalisation.lines(lines);
        let candidate = |StationaryPoint { circle, kind }| {
            let mean_square = weighted_mean_square(&normalised, |line| {
                let distance = line.distance(&circle.centre).abs();
                (circle.radius - distance) * (circle.radius + distance)
            });
            let exact = mean_square.sqrt() <= EXACT_FIT * circle.radius.max(1.0).powi(2);
            Candidate { circle, mean_square, exact, is_minimum: kind == Kind::Minimum }
        };
        let mut candidates: Vec<_> = stationary_points(&normalised)?.into_iter().map(candidate).collect();
        let key = |candidate: &Candidate| if candidate.exact { candidate.circle.radius } else { candidate.mean_square };
        candidates.sort_by(|left, right| right.exact.cmp(&left.exact).then(key(left).total_cmp(&key(right))));
        Ok(Self { normalisation, candidates })
    }

    /// The circles and their costs, in the coordinates of the lines.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (Circle, f64)> {
        self.candidates.iter().map(|candidate| self.in_world(candidate))
    }

    fn in_world(&self, candidate: &Candidate) -> (Circle, f64) {
        (self.normalisation.circle(&candidate.circle), candidate.mean_square * self.normalisation.scale.powi(4))
    }

    /// The circle that touches all lines; otherwise the best admitted minimum; otherwise the best
    /// circle.
    pub(crate) fn best(&self, is_admitted: impl Fn(&Circle) -> bool) -> Option<(Circle, f64)> {
        let first = self.candidates.first()?;
        let is_admitted = |&candidate: &&Candidate| candidate.is_minimum && is_admitted(&self.in_world(candidate).0);
        let best = if first.exact { first } else { self.candidates.iter().find(is_admitted).unwrap_or(first) };
        Some(self.in_world(best))
    }

    pub(crate) fn len(&self) -> usize {
        self.candidates.len()
    }

    /// Number of circles that touch all lines.
    pub(crate) fn exact(&self) -> usize {
        self.candidates.iter().filter(|candidate| candidate.exact).count()
    }

    /// Root mean square distance of the lines from the point that is nearest to all of them, world
    /// units.
    pub(crate) fn scale(&self) -> f64 {
        self.normalisation.scale
    }
}
