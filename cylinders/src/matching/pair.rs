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
//! form an interval, whose ends are the circles of the rays turned by `+-t`.
//!
//! The family is divided into equal parts of `u = s / (s + E)`, from 0 at the camera to 1 at
//! infinity, with the extent `E` of the cameras. With `s = a / d`, `u = a / (a + E d)` needs no
//! case for circles at infinity. Each part has a set of silhouettes, one bit for each: those with a
//! line whose interval meets the part. The size of the set bounds the support of every hypothesis
//! in the part, in time linear in the number of lines `N`. Only hypotheses whose bound is large are
//! scored.

use nalgebra::{Point2, Vector2};

use super::options::References;
use super::plan::{Plan, PlanView, Support, ray};
use crate::cross_section::circle::Circle;

/// Number of parts of the family of a pair, if there are few and if there are many lines. Where the
/// circles are as far away as the cameras from each other, the width of a part is a few thousandths
/// of the distance or less: about that of an interval.
const PARTS: [usize; 2] = [1024, 4096];

/// Number of lines from which on there are many.
const MANY_LINES: usize = 600;

/// Lines of a view are paired with those of so many views after it.
const NEXT_VIEWS: usize = 2;

/// Limit on the number of pairs of lines of different views. If there were more, there are so many
/// lines that a cylinder without both silhouettes in any view would not stand out from chance.
const CROSS_PAIRS: usize = 20_000;

/// Limit on the number of pairs of lines of one view each. If there were more, only those of some
/// views are taken, which are spread evenly over all: a sample of the hypotheses. A cylinder that
/// stands out from so many lines shows both silhouettes in many views.
const PAIRS: usize = 60_000;

/// Two lines of different views that are as parallel as this sine have no apex.
const PARALLEL: f64 = 0.01;

/// Number of silhouettes in one word of a set.
const WORD: usize = u64::BITS as usize;

/// A pair of rays that may be two silhouettes of a cylinder, in one view or in two.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair {
    /// The views of the two lines.
    views: [usize; 2],
    /// Their sides: whether each is the right silhouette.
    rights: [bool; 2],
    /// Indices of the two lines.
    lines: [usize; 2],
    /// Where the rays meet: the camera centre, if they are those of one view.
    apex: Point2<f64>,
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

/// All pairs of the reference views, in the order of views and lines, and then pairs of lines of
/// near views if there are few. Two rays within the threshold of their bisector do not form a pair:
/// each of them could be either silhouette.
pub(super) fn pairs(plan: &Plan, references: References) -> Vec<Pair> {
    let mut pairs = Vec::new();
    let count = plan.views().len();
    let of_one_view = |view: &PlanView| view.lines.len() * view.lines.len().saturating_sub(1) / 2;
    let step = match references {
        References::First => 1,
        References::Every => plan.views().iter().map(of_one_view).sum::<usize>().div_ceil(PAIRS).clamp(1, count.max(1)),
    };
    for index in (0..count).step_by(step) {
        if references == References::First && !pairs.is_empty() {
            return pairs;
        }
        push_pairs_of_view(plan, index, &mut pairs);
    }
    let next = |index: usize| (1..=NEXT_VIEWS).map(move |step| (index, index + step)).filter(|pair| pair.1 < count);
    let lines = |index: usize| plan.views()[index].lines.len();
    let view_pairs: Vec<_> = (0..count).flat_map(next).collect();
    let cross: usize = view_pairs.iter().map(|&(first, second)| 4 * lines(first) * lines(second)).sum();
    if references == References::Every && cross <= CROSS_PAIRS {
        for (first, second) in view_pairs {
            push_cross_pairs(plan, [first, second], &mut pairs);
        }
    }
    pairs
}

/// The pairs of lines of a view, as its left and its right silhouette.
fn push_pairs_of_view(plan: &Plan, index: usize, pairs: &mut Vec<Pair>) {
    let view = &plan.views()[index];
    for first in view.lines.clone() {
        for second in first + 1..view.lines.end {
            let normals = [first, second].map(|line| plan.normal(line));
            let bisector = ray(&(normals[0] + normals[1])).normalize();
            let across = normals[0].dot(&bisector);
            // False for opposite rays, which have no bisector.
            if across.abs() > view.sine {
                let rights = [across > 0.0, across < 0.0];
                let lines = [first, second];
                pairs.push(Pair { views: [index; 2], rights, lines, apex: view.centre, bisector, sine: across.abs() });
            }
        }
    }
}

/// The pairs of a line of one view and a line of another, each as either silhouette.
fn push_cross_pairs(plan: &Plan, views: [usize; 2], pairs: &mut Vec<Pair>) {
    let [own, other] = views.map(|view| &plan.views()[view]);
    let start = other.centre - own.centre;
    for first in own.lines.clone() {
        for second in other.lines.clone() {
            let normals = [first, second].map(|line| plan.normal(line));
            let sine = normals[0].perp(&normals[1]);
            if sine.abs() < PARALLEL {
                continue;
            }
            // The point of the first ray that is on the second.
            let apex = own.centre + ray(&normals[0]) * (normals[1].dot(&start) / normals[1].dot(&ray(&normals[0])));
            for rights in [[false, false], [false, true], [true, false], [true, true]] {
                // Both distances, positive towards the circle, are equal.
                let toward = [0, 1].map(|line| if rights[line] { normals[line] } else { -normals[line] });
                let bisector = ray(&(toward[0] - toward[1])).normalize();
                let sine = toward[0].dot(&bisector);
                if sine.abs() < PARALLEL {
                    continue;
                }
                let bisector = bisector * sine.signum();
                pairs.push(Pair { views, rights, lines: [first, second], apex, bisector, sine: sine.abs() });
            }
        }
    }
}

/// Whether pairs of lines of these two views are tried.
pub(super) fn is_near(views: [usize; 2]) -> bool {
    views[0].abs_diff(views[1]) <= NEXT_VIEWS
}

/// Memory of the search in a family, kept from pair to pair.
#[derive(Default)]
pub(super) struct Workspace {
    /// The set of silhouettes of each part, one array for each word.
    sets: Vec<Vec<u64>>,
    /// Bound on the number of matches of each part.
    bounds: Vec<usize>,
    marks: Marks,
    /// Bound and place of every hypothesis.
    hypotheses: Vec<(usize, f64)>,
}

/// Two numbers of every line of a view.
type Places = Vec<[f64; 2]>;

/// What the lines touch.
#[derive(Default)]
struct Marks {
    /// Part and place of every line as a silhouette.
    touches: Vec<Touch>,
    /// Of the lines of one view: see [`Pair::sweep`].
    places: Places,
    intervals: Places,
}

/// The circle of the family that a line touches.
#[derive(Clone, Copy, Debug)]
struct Touch {
    part: usize,
    place: f64,
}

impl Pair {
    /// Whether both lines are of one view.
    pub(super) fn is_of_one_view(&self) -> bool {
        self.views[0] == self.views[1]
    }

    /// Index of the view of the first line.
    pub(super) fn view(&self) -> usize {
        self.views[0]
    }

    /// Whether both lines are free: no cylinder found has taken them.
    pub(super) fn is_free(&self, plan: &Plan) -> bool {
        self.lines.iter().all(|&line| plan.is_free(line))
    }

    /// The best supported circle of the pair and one more line, the nearest one among equals.
    /// `None` if no circle has the least support.
    pub(super) fn best(&self, plan: &Plan, least_support: usize, workspace: &mut Workspace) -> Option<Hypothesis> {
        if !self.is_free(plan) || !self.bound(plan, least_support, workspace) {
            return None;
        }
        let hypotheses = &mut workspace.hypotheses;
        hypotheses.sort_unstable_by(|(bound, place), (other, other_place)| {
            other.cmp(bound).then(place.total_cmp(other_place))
        });
        let mut best: Option<Hypothesis> = None;
        for &(bound, place) in hypotheses.iter() {
            let least = best.map_or(least_support, |best| best.support.matches);
            if bound < least {
                break;
            }
            let circle = self.circle(place);
            let Some(support) = plan.support(&circle, least) else { continue };
            let better = best.is_none_or(|best| support.cmp(&best.support).is_gt());
            if support.matches >= least_support && better {
                best = Some(Hypothesis { circle, support });
            }
        }
        best
    }

    fn circle(&self, place: f64) -> Circle {
        Circle { centre: self.apex + self.bisector * place, radius: place * self.sine }
    }

    /// Writes every hypothesis whose bound on the number of matches is at least the least support.
    /// Whether there are any.
    fn bound(&self, plan: &Plan, least_support: usize, workspace: &mut Workspace) -> bool {
        let Workspace { sets, bounds, marks, hypotheses } = workspace;
        let parts = PARTS[usize::from(plan.line_count() >= MANY_LINES)];
        sets.resize((2 * plan.views().len()).div_ceil(WORD), Vec::new());
        for set in sets.iter_mut() {
            set.clear();
            set.resize(parts, 0);
        }
        marks.touches.clear();
        hypotheses.clear();
        // Silhouettes are numbered `2 view + side`. The lines of the pair touch every circle.
        for index in 0..plan.views().len() {
            for (side, sine) in [-self.sine, self.sine].into_iter().enumerate() {
                let is_own = |line: usize| self.views[line] == index && usize::from(self.rights[line]) == side;
                if !is_own(0) && !is_own(1) {
                    let silhouette = 2 * index + side;
                    let bit = 1 << (silhouette % WORD);
                    self.mark(plan, index, sine, (&mut sets[silhouette / WORD], bit), marks);
                }
            }
        }
        bounds.clear();
        bounds.resize(parts, 2);
        for set in sets.iter() {
            bounds.iter_mut().zip(set).for_each(|(bound, set)| *bound += set.count_ones() as usize);
        }
        if bounds.iter().all(|&bound| bound < least_support) {
            return false;
        }
        let bounded = marks.touches.iter().map(|touch| (bounds[touch.part], touch.place));
        hypotheses.extend(bounded.filter(|(bound, place)| *bound >= least_support && self.is_ahead(plan, *place)));
        !hypotheses.is_empty()
    }

    /// Whether a circle of the family is in front of the cameras of the pair.
    fn is_ahead(&self, plan: &Plan, place: f64) -> bool {
        let centre = self.apex + self.bisector * place;
        let is_ahead = |line: usize| {
            ray(&plan.normal(self.lines[line])).dot(&(centre - plan.views()[self.views[line]].centre)) > 0.0
        };
        is_ahead(0) && is_ahead(1)
    }

    /// Marks the parts of every line of another view as one of its silhouettes, with the sine
    /// `sin(beta)` for the right and `-sin(beta)` for the left one.
    fn mark(&self, plan: &Plan, view: usize, sine: f64, (set, bit): (&mut [u64], u64), marks: &mut Marks) {
        let Marks { touches, places, intervals } = marks;
        self.sweep(plan, view, sine, set.len() as f64, (places, intervals));
        for (&[place, middle], &[low, high]) in places.iter().zip(&*intervals) {
            if place.is_nan() {
                continue;
            }
            // Conversion of numbers saturates.
            let [part, low, high] = [middle, low, high].map(|part| (part as u32 as usize).min(set.len() - 1));
            set[low.min(part)..=high.max(part)].iter_mut().for_each(|set| *set |= bit);
            touches.push(Touch { part, place });
        }
    }

    /// For every line of another view the place of the circle that it touches and its part, and
    /// the first and the last part of its interval, all not yet whole; NaN for lines that touch
    /// none. It has no branches, so that several lines are computed at a time.
    fn sweep(&self, plan: &Plan, view: usize, sine: f64, parts: f64, (places, intervals): (&mut Places, &mut Places)) {
        let (extent, bisector) = (plan.extent(), self.bisector);
        let PlanView { centre: other, cosine: cos_t, sine: sin_t, ref lines, .. } = plan.views()[view];
        let start = self.apex - other;
        let [x, y] = plan.normals(lines);
        places.clear();
        intervals.clear();
        places.resize(x.len(), [0.0; 2]);
        intervals.resize(x.len(), [0.0; 2]);
        for ((&x, &y), (of_place, interval)) in x.iter().zip(y).zip(places.iter_mut().zip(intervals)) {
            // Of the ray: s = a / d. A turned normal is n cos(t) +- ray(n) sin(t), so that its a
            // and d follow from those of the ray and from its products with `start` and `bisector`.
            let (a, along) = (-(x * start.x + y * start.y), x * start.y - y * start.x);
            let (across, forward) = (x * bisector.x + y * bisector.y, x * bisector.y - y * bisector.x);
            let d = across - sine;
            let place = a / d;
            // In front of both cameras. It is false for a line that was taken.
            let touches = (a * d > 0.0) & (along + forward * place > 0.0) & (place < f64::INFINITY);
            let turned = |sin_t: f64| {
                let a = a * cos_t - along * sin_t;
                (a, a + extent * (across * cos_t + forward * sin_t - sine))
            };
            let [(first, below_first), (second, below_second)] = [turned(-sin_t), turned(sin_t)];
            let [first, second] = [first / below_first, second / below_second];
            let (least, most) = if first < second { (first, second) } else { (second, first) };
            // Otherwise the other camera is near the surface of some of the circles.
            let is_interval = below_first * below_second > 0.0;
            *interval = [if is_interval { least } else { 0.0 } * parts, if is_interval { most } else { 1.0 } * parts];
            *of_place = [if touches { place } else { f64::NAN }, place / (place + extent) * parts];
        }
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
        let own = &plan.views()[pair.view()];
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
            for pair in pairs(&plan, References::Every).into_iter().filter(Pair::is_of_one_view) {
                let expected = best_of_all(&plan, &pair).filter(|support| support.matches >= 4);
                let found = pair.best(&plan, 4, &mut Workspace::default()).map(|best| best.support);
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
