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

/// Logarithm of the factor by which a match is the less likely that is seen through a circle: the
/// match may be wrong, and a cylinder of finite length does not hide everything behind it. It never
/// makes a circle stand out more, so that chance is not underestimated.
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
