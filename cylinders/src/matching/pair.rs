//! Pairs of silhouettes of one image, and the circles that they and one more line determine.
//!
//! Two rays from the camera centre `C`, the left and the right silhouette of a circle, determine a
//! family of circles with one parameter, the circles in the wedge between them:
//!
//! ```text
//!     \   ( p )   /        p = C + s b,   r = s sin(beta),   s > 0
//!      \   |   /          b: unit bisector,  beta: half of the angle between the rays
//!       \  | b /           n_right^T b = sin(beta),   n_left^T b = -sin(beta)
//!        \ | /
//!          C
//! ```
//!
//! Another line, with the normal `n` and through the camera centre `C'`, is the right (+) or left
//! (-) silhouette of one of them:
//!
//! ```text
//!   n^T (p - C') = +-r      s = -n^T (C - C') / (n^T b -+ sin(beta))
//! ```
//!
//! These are two of the four circles that touch the three lines (`closed_form`). The other two lie
//! in the wedges where one line of the pair points backwards. As a ray turns, its circle moves
//! through the family in one direction. The circles that have a line within the threshold therefore
//! form an interval, whose ends are the circles of the rays turned by `+-t`. One sweep over the
//! ends of all intervals bounds the support of every hypothesis of the pair, in `O(N log N)`. The
//! bound exceeds the support only for lines that are near both silhouettes.

use nalgebra::Vector2;

use super::options::References;
use super::plan::{Plan, Support, ray};
use crate::cross_section::circle::Circle;

/// A pair of rays of one view that may be the two silhouettes of a cylinder.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair {
    /// Index of the view.
    view: usize,
    /// Indices of the two lines.
    lines: [usize; 2],
    bisector: Vector2<f64>,
    /// `sin(beta)`.
    sine: f64,
}

/// A circle with its support.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hypothesis {
    pub(super) circle: Circle,
    pub(super) support: Support,
}

/// All pairs of the reference views, in the order of views and lines. Two rays within the threshold
/// of their bisector do not form a pair: each of them could be either silhouette.
pub(super) fn pairs(plan: &Plan, references: References) -> Vec<Pair> {
    let mut pairs = Vec::new();
    for (index, view) in plan.views().iter().enumerate() {
        if references == References::First && !pairs.is_empty() {
            break;
        }
        for first in view.lines.clone() {
            for second in first + 1..view.lines.end {
                let normals = [first, second].map(|line| plan.normal(line));
                let bisector = ray(&(normals[0] + normals[1])).normalize();
                let sine = normals[0].dot(&bisector).abs();
                // False for opposite rays, which have no bisector.
                if sine > view.sine {
                    pairs.push(Pair { view: index, lines: [first, second], bisector, sine });
                }
            }
        }
    }
    pairs
}

/// An event at a circle of the family, in the order in which events at the same circle count.
#[derive(Clone, Copy, Debug, Eq, Ord, PartialEq, PartialOrd)]
enum Event {
    /// From this circle on, a line is within the threshold.
    Start,
    /// A circle that a line touches.
    Touch,
    /// From this circle on, a line is no longer within the threshold.
    End,
}

impl Pair {
    /// Index of the view.
    pub(super) fn view(&self) -> usize {
        self.view
    }

    /// Whether both lines are free: no cylinder found has taken them.
    pub(super) fn is_free(&self, plan: &Plan) -> bool {
        self.lines.iter().all(|&line| plan.is_free(line))
    }

    /// The best supported circle of the pair and one more line, the nearest one among equals.
    /// `None` if no circle has the least support.
    pub(super) fn best(&self, plan: &Plan, least_support: usize) -> Option<Hypothesis> {
        if !self.is_free(plan) {
            return None;
        }
        let mut hypotheses = self.bounded(plan, least_support);
        hypotheses.sort_unstable_by(|(bound, place), (other, other_place)| {
            other.cmp(bound).then(place.total_cmp(other_place))
        });
        let mut best: Option<Hypothesis> = None;
        for (bound, place) in hypotheses {
            let least = best.map_or(least_support, |best| best.support.matches);
            if bound < least {
                break;
            }
            let circle = self.circle(plan, place);
            let Some(support) = plan.support(&circle, least) else { continue };
            let better = best.is_none_or(|best| support.cmp(&best.support).is_gt());
            if support.matches >= least_support && better {
                best = Some(Hypothesis { circle, support });
            }
        }
        best
    }

    fn circle(&self, plan: &Plan, place: f64) -> Circle {
        Circle { centre: plan.views()[self.view].centre + self.bisector * place, radius: place * self.sine }
    }

    /// Every hypothesis `s` with a bound on its number of matches, if the bound is at least the
    /// least support.
    fn bounded(&self, plan: &Plan, least_support: usize) -> Vec<(usize, f64)> {
        let mut events = self.events(plan);
        events.sort_unstable_by(|(place, event, silhouette), (other, other_event, other_silhouette)| {
            place.total_cmp(other).then(event.cmp(other_event)).then(silhouette.cmp(other_silhouette))
        });
        // Number of lines within the threshold of each silhouette, two silhouettes for each view.
        // The lines of the pair touch every circle of the family.
        let mut lines = vec![0_u32; 2 * plan.views().len()];
        let mut matches = 2;
        let mut hypotheses = Vec::new();
        for (place, event, silhouette) in events {
            let lines = &mut lines[silhouette];
            match event {
                Event::Start => {
                    *lines += 1;
                    matches += usize::from(*lines == 1);
                }
                Event::End => {
                    *lines -= 1;
                    matches -= usize::from(*lines == 0);
                }
                Event::Touch if matches >= least_support => hypotheses.push((matches, place)),
                Event::Touch => {}
            }
        }
        hypotheses
    }

    /// Interval and circle of every line of the other views, as left and as right silhouette,
    /// numbered `2 view + side`.
    fn events(&self, plan: &Plan) -> Vec<(f64, Event, usize)> {
        let centre = plan.views()[self.view].centre;
        let mut events = Vec::new();
        for (index, view) in plan.views().iter().enumerate() {
            if index == self.view {
                continue;
            }
            let start = centre - view.centre;
            for line in view.lines.clone() {
                let normal = plan.normal(line);
                for (side, sine) in [self.sine, -self.sine].into_iter().enumerate() {
                    let family = Family { start, bisector: self.bisector, sine };
                    let Some(place) = family.place(&normal) else { continue };
                    let ends = family.ends(&normal, place, [view.cosine, view.sine]);
                    let silhouette = 2 * index + side;
                    events.extend(
                        [(ends[0], Event::Start), (place, Event::Touch), (ends[1], Event::End)]
                            .map(|(place, event)| (place, event, silhouette)),
                    );
                }
            }
        }
        events
    }
}

/// The circles of a pair, seen from another camera, and one of their silhouettes.
struct Family {
    /// `C - C'`
    start: Vector2<f64>,
    bisector: Vector2<f64>,
    /// `sin(beta)` for the right, `-sin(beta)` for the left silhouette.
    sine: f64,
}

impl Family {
    /// The circle that the ray with this normal touches; `None` if it is not in front of both
    /// cameras.
    fn place(&self, normal: &Vector2<f64>) -> Option<f64> {
        let place = -normal.dot(&self.start) / (normal.dot(&self.bisector) - self.sine);
        let ahead = ray(normal).dot(&(self.start + self.bisector * place)) > 0.0;
        (place > 0.0 && place.is_finite() && ahead).then_some(place)
    }

    /// An interval that contains all circles that have the ray within the threshold, whose cosine
    /// and sine are given.
    fn ends(&self, normal: &Vector2<f64>, place: f64, [cosine, sine]: [f64; 2]) -> [f64; 2] {
        let mut ends = [place; 2];
        for sine in [sine, -sine] {
            let turned = normal * cosine + ray(normal) * sine;
            let changes = |value: &dyn Fn(&Vector2<f64>) -> f64| value(normal) * value(&turned) <= 0.0;
            let through_zero = changes(&|normal| normal.dot(&self.start));
            let through_infinity = changes(&|normal| normal.dot(&self.bisector) - self.sine);
            match self.place(&turned).filter(|_| !through_zero && !through_infinity) {
                Some(end) => ends = [ends[0].min(end), ends[1].max(end)],
                None if through_zero && !through_infinity => ends[0] = 0.0,
                None if through_infinity && !through_zero => ends[1] = f64::INFINITY,
                // The other camera is near the surface of some of the circles.
                None => ends = [0.0, f64::INFINITY],
            }
        }
        ends
    }
}

#[cfg(all(test, feature = "command"))]
mod tests {
    use super::*;
    use crate::cross_section::closed_form::tangent_circles;
    use crate::matching::MatchOptions;
    use crate::simulation::ParallelSetup;

    /// Every circle that touches the lines of the pair and a line of another view, scored one by
    /// one.
    fn best_of_all(plan: &Plan, pair: &Pair) -> Option<Support> {
        let own = &plan.views()[pair.view];
        let mut best: Option<Support> = None;
        for view in plan.views().iter().filter(|view| view.lines != own.lines) {
            for line in view.lines.clone() {
                let sample = [pair.lines[0], pair.lines[1], line];
                for circle in tangent_circles(&sample.map(|line| plan.tangent_line(line))).into_iter().flatten() {
                    let from = [own, own, view].map(|view| circle.centre - view.centre);
                    let ahead = (0..3).all(|index| ray(&plan.normal(sample[index])).dot(&from[index]) > 0.0);
                    let [first, second] = [0, 1].map(|index| plan.normal(sample[index]).dot(&from[index]));
                    let Some(support) = plan.support(&circle, 0).filter(|_| ahead && first * second < 0.0) else {
                        continue;
                    };
                    best = best.filter(|best| best.cmp(&support).is_ge()).or(Some(support));
                }
            }
        }
        best
    }

    #[test]
    fn a_pair_finds_the_best_of_all_circles_that_touch_three_lines() {
        let setup = ParallelSetup { cylinders: 3, images: 5, noise: 2.0, detection: 0.8, outlier_rate: 0.9 };
        let (mut compared, mut largest) = (0, 0);
        for seed in 0..3 {
            let scene = setup.scene(seed).expect("a scene");
            let options = MatchOptions::of(&scene.views);
            let plan = Plan::new(&scene.views, &scene.direction, &options).expect("a plan");
            for pair in pairs(&plan, References::Every) {
                let expected = best_of_all(&plan, &pair).filter(|support| support.matches >= 4);
                let found = pair.best(&plan, 4).map(|best| best.support);
                assert_eq!(found.map(|best| best.matches), expected.map(|best| best.matches), "seed {seed}, {pair:?}");
                if let (Some(found), Some(expected)) = (found, expected) {
                    assert!((found.cost - expected.cost).abs() < 1e-6, "{found:?} {expected:?}");
                    compared += 1;
                    largest = largest.max(found.matches);
                }
            }
        }
        // The hypotheses compared include those of true cylinders.
        assert!(compared > 100 && largest >= 7, "{compared} {largest}");
    }
}
