//! How much a circle stands out from chance, and the noise of its matches.

use std::f64::consts::LN_2;

use super::band::is_band;
use super::chance::{Chance, FalseAlarms};
use super::model::{Model, fitted};
use super::occlusion::{Sight, hidden};
use super::pair::{Pair, is_near};
use super::plan::{Plan, PlanMatch};
use super::ratio::Nearest;
use crate::cross_section::circle::{Circle, CircleFit};
use crate::space::cylinder::Side;

/// Matches are within so many standard deviations of the silhouettes.
const DEVIATIONS: f64 = 3.0;

/// Logarithm of the factor by which a circle is less likely for each match of another that would
/// be seen through it: the match may be wrong, and a cylinder of finite length does not hide
/// everything behind it. It never makes a circle stand out more, so that chance is not
/// underestimated.
const SEEN_THROUGH: f64 = LN_2;

/// The lines that are free and the circles that were found.
pub(super) struct Judge {
    chance: Chance,
    circles: Vec<Circle>,
    /// The lines of sight of the matches of those circles.
    sights: Vec<Sight>,
    /// Whether pairs of lines of different views are tried.
    crosses: bool,
}

impl Judge {
    pub(super) fn new(plan: &Plan, pairs: &[Pair], found: &[Model], chance: &Chance) -> Self {
        Self {
            chance: chance.updated(plan, pairs),
            circles: found.iter().map(|model| model.fit.circle).collect(),
            sights: found.iter().flat_map(|model| sights(plan, model)).collect(),
            crosses: pairs.last().is_some_and(|pair| !pair.is_of_one_view()),
        }
    }

    /// After more circles were found.
    pub(super) fn updated(&self, plan: &Plan, pairs: &[Pair], found: &[Model]) -> Self {
        Self::new(plan, pairs, found, &self.chance)
    }

    /// The model of a hypothesis: fitted to its matches at its level, and then at each wider one.
    /// The fit that is the least likely by chance counts. `plans` are those of all levels, the
    /// widest first.
    pub(super) fn fitted(&self, plans: &[Plan], level: usize, circle: &Circle) -> Option<Model> {
        let mut best: Option<Model> = None;
        let mut circle = *circle;
        for plan in plans[..=level].iter().rev() {
            let Some(fit) = fitted(plan, circle) else { break };
            circle = fit.circle;
            let Some(model) = self.judged(&plans[0], &fit) else { continue };
            if best.as_ref().is_none_or(|best| model.false_alarms < best.false_alarms) {
                best = Some(model);
            }
        }
        best
    }

    /// The model of a circle, with the matches within three standard deviations of the noise;
    /// `None` if they are those of a band.
    pub(super) fn judged(&self, plan: &Plan, fit: &CircleFit) -> Option<Model> {
        let FalseAlarms { logarithm, scale } = self.false_alarms(plan, &fit.circle);
        let matches = plan.matches(&fit.circle, (DEVIATIONS * scale).min(1.0));
        let repeated = (self.repeated(plan, &matches) as f64).ln();
        let is_round = !is_band(plan, &fit.circle, &matches);
        is_round.then_some(Model { fit: *fit, matches, false_alarms: logarithm - repeated })
    }

    /// Number of hypotheses that make a circle with these matches.
    fn repeated(&self, plan: &Plan, matches: &[PlanMatch]) -> usize {
        let views: Vec<_> = matches.iter().map(|line| plan.id(line.line).view).collect();
        let is_tried = |one: usize, other: usize| one == other || (self.crosses && is_near([one, other]));
        let pairs: usize = (0..views.len())
            .map(|first| views[first + 1..].iter().filter(|&&second| is_tried(views[first], second)).count())
            .sum();
        (pairs * matches.len().saturating_sub(2)).max(1)
    }

    /// Natural logarithm of the expected number of hypotheses as good as this circle by chance. It
    /// is counted on all silhouettes and on those that the circles found do not hide, because
    /// cylinders of finite length do not hide everything behind them. The smaller number counts,
    /// doubled for the choice between the two. It grows with each match of the circles found that
    /// this one would hide.
    fn false_alarms(&self, plan: &Plan, circle: &Circle) -> FalseAlarms {
        let (mut all, mut visible) = ((Vec::new(), 0), (Vec::new(), 0));
        for view in plan.views().iter().filter(|view| !view.lines.is_empty()) {
            let Some((silhouettes, hidden)) =
                plan.matched_silhouettes(view, circle).zip(hidden(&view.centre, circle, &self.circles))
            else {
                continue;
            };
            let densities = plan.densities(view, circle);
            for ((silhouette, hidden), density) in silhouettes.into_iter().zip(hidden).zip(densities) {
                let nearest = silhouette.map(|(_, cost)| Nearest { distance: cost.sqrt(), density });
                for (lines, count) in [Some(&mut all), Some(&mut visible).filter(|_| !hidden)].into_iter().flatten() {
                    lines.extend(nearest);
                    *count += 1;
                }
            }
        }
        let [all, visible] = [all, visible].map(|(lines, count)| self.chance.false_alarms(lines, count));
        let least = if visible.logarithm < all.logarithm { visible } else { all };
        let seen_through = self.sights.iter().filter(|sight| sight.passes_through(circle)).count() as f64;
        FalseAlarms { logarithm: least.logarithm + LN_2 + seen_through * SEEN_THROUGH, ..least }
    }
}

/// The lines of sight of the matches of a model.
fn sights(plan: &Plan, model: &Model) -> Vec<Sight> {
    let sight = |found: &PlanMatch| {
        let camera = &plan.views()[plan.id(found.line).view].centre;
        let [left, right] = Sight::of_silhouettes(camera, &model.fit.circle)?;
        Some(if found.side == Side::Left { left } else { right })
    };
    model.matches.iter().filter_map(sight).collect()
}

#[cfg(all(test, feature = "command"))]
mod tests {
    use nalgebra::Point2;

    use super::*;
    use crate::matching::pair::pairs;
    use crate::matching::{MatchOptions, References};
    use crate::simulation::ParallelSetup;

    /// Of two circles that match the same lines, the one that would hide lines of a circle found
    /// stands out less, by a factor for each of those lines.
    #[test]
    fn a_circle_that_would_hide_matches_of_others_stands_out_less() {
        let scene = ParallelSetup::seven_in_twelve().scene(1).expect("a scene");
        let plan = Plan::new(&scene.views, &scene.direction, &MatchOptions::of(&scene.views)).expect("a plan");
        let pairs = pairs(&plan, References::Every);
        let chance = Chance::of(&plan, &pairs);
        let alone = Judge::new(&plan, &pairs, &[], &chance);
        let model = |index: usize| {
            let (point, radius) = (scene.cylinders[index].axis_point, scene.cylinders[index].radius);
            let circle = Circle { centre: plan.rectification().point(&point), radius };
            alone.judged(&plan, &fitted(&plan, circle).expect("a fit")).expect("a model")
        };
        let behind = model(0);
        let after = Judge::new(&plan, &pairs, std::slice::from_ref(&behind), &chance);
        let change = |circle: &Circle| {
            let [before, after] = [&alone, &after].map(|judge| judge.false_alarms(&plan, circle).logarithm);
            after - before
        };
        // No true circle is in front of what is seen of another.
        for index in 1..7 {
            assert!(change(&model(index).fit.circle) <= 1e-12, "{index}");
        }
        // Half-way to the circle from a camera that sees it.
        let camera = plan.views()[plan.id(behind.matches[0].line).view].centre;
        let centre = Point2::from((camera.coords + behind.fit.circle.centre.coords) / 2.0);
        let hides = Circle { centre, radius: behind.fit.circle.radius };
        let hidden = after.sights.iter().filter(|sight| sight.passes_through(&hides)).count();
        assert!(hidden >= 1 && (change(&hides) - hidden as f64 * SEEN_THROUGH).abs() < 1e-9, "{hidden}");
    }

    /// Lines beside a silhouette, counted by their angles.
    #[test]
    fn the_density_of_lines_is_that_beside_the_silhouette() {
        let scene = ParallelSetup::seven_in_twelve().scene(2).expect("a scene");
        let plan = Plan::new(&scene.views, &scene.direction, &MatchOptions::of(&scene.views)).expect("a plan");
        let mut counted = 0;
        for cylinder in &scene.cylinders {
            let circle = Circle { centre: plan.rectification().point(&cylinder.axis_point), radius: cylinder.radius };
            for view in plan.views() {
                let to_centre = circle.centre - view.centre;
                let half = (circle.radius / to_centre.norm()).asin();
                let angles = view.lines.clone().map(|line| {
                    let normal = plan.normal(line);
                    let along = normal.x * to_centre.y - normal.y * to_centre.x;
                    normal.dot(&to_centre).atan2(along)
                });
                let angles: Vec<f64> = angles.collect();
                for (silhouette, density) in [-half, half].into_iter().zip(plan.densities(view, &circle)) {
                    let is_beside = |angle: &&f64| (**angle - silhouette).abs() <= 30.0 * view.threshold;
                    let others = angles.iter().filter(is_beside).count().saturating_sub(1);
                    // The sine and the angle differ by less than a line in a thousand.
                    assert!((density * 60.0 - others as f64).abs() <= 1.0, "{density} {others}");
                    counted += others;
                }
            }
        }
        assert!(counted > 200, "{counted}");
    }
}
