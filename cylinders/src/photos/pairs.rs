//! Cylinders from few photographs: ribbons of two images that are the silhouettes of one cylinder.
//!
//! Two images of a cylinder have four lines, which no direction needs to confirm: they have eight
//! degrees of freedom, a cylinder has five. The three that are left say by chance, for lines with
//! distances `e` from the silhouettes, width `w` and length `l`, pixels,
//!
//! ```text
//!   p = (e / w) (e / w) (e / (t l)),    t = 0.1: the largest tilt of a ribbon against another
//! ```
//!
//! that they agree: about the width, its change along the ribbon, and the direction. What is found
//! must be no chance among all pairs of ribbons, look alike in both images, and be seen there in
//! the same part.
//!
//! Of pairs that contradict each other, those stay that explain more. A pair around two others is
//! the two, as the outer lines of two parallel cylinders are; a pair between two others is the gap
//! between them; a pair inside of another is an edge of its paint or light.

use nalgebra::{Point2, Point3};

use super::lines::Seen;
use super::ribbons::{Profile, Ribbon};
use crate::estimation::estimate::{Estimate, Method, estimate, estimate_from};
use crate::estimation::warnings::Warning;
use crate::matching::{MatchOptions, MatchedCylinder};
use crate::observations::view::View;
use crate::space::cylinder::{Cylinder, LineResidual};
use crate::space::extent::end_contacts;

/// Distances of lines from silhouettes are not taken as smaller, pixels.
const LEAST_DISTANCE: f64 = 0.3;
/// See the top of the file.
const TILT: f64 = 0.1;
/// Largest expected number of pairs that agree by chance.
const FALSE_ALARMS: f64 = 0.01;
/// Largest difference of the mean of two profiles, of 255, and of their values beside that.
const EXPOSURE: f32 = 30.0;
const DIFFERENCE: f32 = 12.0;
/// The parts of the axis that two images show have at least this part of the smaller in common.
const COMMON: f64 = 0.3;
/// Largest standard deviation of the radius, relative.
const UNCERTAINTY: f64 = 0.1;
/// A line of another image may be so many thresholds away from the silhouette before it is known.
const NEAR: f64 = 10.0;
/// Of more photographs directions tell more, and pairs are not tried: chequered floors have edges
/// that agree by chance in three of twelve photographs.
const FEW: usize = 5;
/// Least number of images with both silhouettes of a cylinder, unless no more show it.
const LEAST_IMAGES: usize = 3;
/// An image shows a cylinder if it has at least this part of its silhouettes.
const SHOWN: f64 = 0.5;
/// Points of the axis at which that is tested.
const POINTS: usize = 16;

/// A cylinder and its ribbons.
struct Candidate<'a> {
    cylinder: Cylinder,
    /// For each of some views its ribbon.
    ribbons: Vec<(usize, &'a Ribbon)>,
    false_alarms: f64,
}

/// Of few photographs, the cylinders whose two silhouettes are seen as ribbons in all images that
/// show them, two at least, or in three or more, beside those that are known; each has its own
/// direction. The least likely by chance come first. There are none after an interruption.
pub(super) fn cylinders_of_ribbons(
    seen: &[Seen],
    known: &[MatchedCylinder],
    &MatchOptions { threshold, interrupt, .. }: &MatchOptions<'_>,
) -> Vec<MatchedCylinder> {
    if seen.len() > FEW {
        return Vec::new();
    }
    let free: Vec<Vec<&Ribbon>> = (0..seen.len()).map(|view| free(seen, view, known)).collect();
    let pairs = (0..seen.len()).flat_map(|first| (first + 1..seen.len()).map(move |second| [first, second]));
    let pairs: Vec<_> = pairs.collect();
    let tests: usize = pairs.iter().map(|pair| free[pair[0]].len() * free[pair[1]].len()).sum();
    let mut candidates = Vec::new();
    for views in pairs {
        for first in &free[views[0]] {
            if interrupt.is_set() {
                return Vec::new();
            }
            let of_pair = |&second| candidate(seen, (views, [*first, second]), tests, threshold);
            candidates.extend(free[views[1]].iter().filter_map(of_pair));
        }
    }
    let mut chosen = chosen(candidates);
    for (view, ribbons) in free.iter().enumerate() {
        extend(&mut chosen, seen, (view, ribbons), threshold);
    }
    chosen.retain(|candidate| candidate.ribbons.len() >= LEAST_IMAGES || candidate.is_missed_by_none(seen));
    chosen.iter().filter_map(|candidate| matched(seen, candidate, threshold)).collect()
}

/// The ribbons of an image that are not those of a known cylinder, nor lie on it.
fn free<'a>(seen: &'a [Seen], view: usize, known: &[MatchedCylinder]) -> Vec<&'a Ribbon> {
    let Seen { view: content, ribbons, .. } = &seen[view];
    let (camera, centre) = (content.camera(), content.camera().centre());
    let is_free = |ribbon: &&Ribbon| {
        let Some(calibration) = camera.calibration() else { return false };
        let ray = calibration.point_to_normalised(&ribbon.middle()).to_homogeneous();
        let ray = camera.rotation().tr_mul(&ray);
        known.iter().all(|MatchedCylinder { cylinder, matches, .. }| {
            let has_line = matches.iter().any(|line| line.view == view && ribbon.lines.contains(&line.line));
            let across = ray.cross(&cylinder.direction);
            let distance = across.dot(&cylinder.vector_to_axis(&centre)).abs() / across.norm();
            !has_line && distance > cylinder.radius
        })
    };
    ribbons.iter().filter(is_free).collect()
}

/// The cylinder of two ribbons, if they are those of one.
fn candidate<'a>(
    seen: &[Seen],
    (views, ribbons): ([usize; 2], [&'a Ribbon; 2]),
    tests: usize,
    threshold: f64,
) -> Option<Candidate<'a>> {
    let reversed = reversed(ribbons[1]);
    if !(look_alike(&ribbons[0].profile, &ribbons[1].profile) || look_alike(&ribbons[0].profile, &reversed)) {
        return None;
    }
    let lines: Vec<View> = (0..2).map(|k| seen[views[k]].view.selected(&ribbons[k].lines)).collect();
    let estimate = estimate(&lines, &Method::Refined).ok()?;
    let (refinement, _) = estimate.refinement.as_ref()?;
    let least = |value: fn(&Ribbon) -> f64| value(ribbons[0]).min(value(ribbons[1]));
    let (width, length) = (least(Ribbon::width), least(Ribbon::length));
    let distance = refinement.rms.max(LEAST_DISTANCE);
    let false_alarms = tests as f64 * (distance / width).powi(2) * distance / (TILT * length);
    let is_doubtful = |warning: &Warning| {
        matches!(
            warning,
            Warning::Ambiguous { .. } | Warning::NotTheBest | Warning::ThreeLines | Warning::Behind { .. }
        )
    };
    let is_good = refinement.rms <= threshold
        && false_alarms <= FALSE_ALARMS
        && refinement.deviation.radius <= UNCERTAINTY * estimate.cylinder.radius
        && !estimate.warnings.iter().any(is_doubtful);
    let same_order = order(&estimate)?;
    let second = if same_order { ribbons[1].profile } else { reversed };
    let is_same = is_good && look_alike(&ribbons[0].profile, &second) && show_the_same_part(&estimate.cylinder, &lines);
    let ribbons = views.into_iter().zip(ribbons).collect();
    is_same.then_some(Candidate { cylinder: estimate.cylinder, ribbons, false_alarms })
}

/// The profile from the second line to the first.
fn reversed(ribbon: &Ribbon) -> Profile {
    let mut profile = ribbon.profile;
    profile.reverse();
    profile
}

/// Whether the first lines of both ribbons are on the same side of the cylinder; `None` if a ribbon
/// has both lines on one side.
fn order(estimate: &Estimate) -> Option<bool> {
    let [a, b, c, d] = estimate.residuals[..] else { return None };
    (a.side != b.side && c.side != d.side).then_some(a.side == c.side)
}

/// Whether two profiles are those of one surface, up to the exposure.
fn look_alike(first: &[f32], second: &[f32]) -> bool {
    let count = first.len() as f32;
    let exposure = first.iter().zip(second).map(|(a, b)| b - a).sum::<f32>() / count;
    let square = first.iter().zip(second).map(|(a, b)| (b - a - exposure).powi(2)).sum::<f32>() / count;
    exposure.abs() <= EXPOSURE && square.sqrt() <= DIFFERENCE
}

/// Whether the images show parts of the axis that have much in common.
fn show_the_same_part(cylinder: &Cylinder, views: &[View]) -> bool {
    let part = |view: &View| -> Option<[f64; 2]> {
        let contacts: Vec<[Point3<f64>; 2]> = end_contacts(cylinder, view).into_iter().flatten().collect();
        let heights = contacts.iter().flatten().map(|point| cylinder.height(point));
        heights.fold(None, |range: Option<[f64; 2]>, height| {
            let [low, high] = range.unwrap_or([height; 2]);
            Some([low.min(height), high.max(height)])
        })
    };
    let parts: Option<Vec<_>> = views.iter().map(part).collect();
    let Some(&[first, second]) = parts.as_deref() else { return false };
    let common = first[1].min(second[1]) - first[0].max(second[0]);
    common >= COMMON * (first[1] - first[0]).min(second[1] - second[0])
}

/// The candidates that do not contradict each other.
fn chosen(mut candidates: Vec<Candidate<'_>>) -> Vec<Candidate<'_>> {
    let apart = |others: &[&Candidate<'_>]| {
        others.iter().enumerate().any(|(at, one)| others[at + 1..].iter().any(|other| !one.contradicts(other)))
    };
    keep(&mut candidates, |of, all| {
        let inside: Vec<_> = all.iter().filter(|other| of.is_around(other)).collect();
        let beside: Vec<_> = all.iter().filter(|other| of.is_beside(other)).collect();
        !apart(&inside) && !apart(&beside)
    });
    keep(&mut candidates, |of, all| !all.iter().any(|other| other.is_around(of)));
    candidates.sort_by(|a, b| a.false_alarms.total_cmp(&b.false_alarms));
    let mut chosen: Vec<Candidate<'_>> = Vec::new();
    for candidate in candidates {
        if !chosen.iter().any(|other| other.contradicts(&candidate)) {
            chosen.push(candidate);
        }
    }
    chosen
}

/// Keeps those candidates that stand among all.
fn keep<'a>(candidates: &mut Vec<Candidate<'a>>, stands: impl Fn(&Candidate<'a>, &[Candidate<'a>]) -> bool) {
    let stand: Vec<bool> = candidates.iter().map(|candidate| stands(candidate, candidates)).collect();
    let mut stand = stand.into_iter();
    candidates.retain(|_| stand.next() == Some(true));
}

impl<'a> Candidate<'a> {
    fn ribbon(&self, view: usize) -> Option<&'a Ribbon> {
        self.ribbons.iter().find(|(of, _)| *of == view).map(|(_, ribbon)| *ribbon)
    }

    /// The ribbons of both in the views that they have in common.
    fn common(&self, other: &Self) -> Vec<[&'a Ribbon; 2]> {
        self.ribbons.iter().filter_map(|(view, own)| Some([*own, other.ribbon(*view)?])).collect()
    }

    /// Whether both cannot be cylinders: they have a line in common, or lie above each other.
    fn contradicts(&self, other: &Self) -> bool {
        self.common(other)
            .iter()
            .any(|[own, other]| own.lines.iter().any(|line| other.lines.contains(line)) || own.overlaps(other))
    }

    /// Whether another one lies inside in all views that both have, two at least.
    fn is_around(&self, other: &Self) -> bool {
        let common = self.common(other);
        let is_inside = |[own, other]: &[&Ribbon; 2]| own.lines != other.lines && own.encloses(other);
        common.len() > 1 && common.iter().all(is_inside)
    }

    /// Whether another one has a line of this one, and lies beside it, in all views that both have,
    /// two at least.
    fn is_beside(&self, other: &Self) -> bool {
        let common = self.common(other);
        let is_there = |[own, other]: &[&Ribbon; 2]| {
            own.lines.iter().filter(|line| other.lines.contains(line)).count() == 1 && !own.overlaps(other)
        };
        common.len() > 1 && common.iter().all(is_there)
    }

    /// Whether a line of a ribbon is one of this cylinder.
    fn uses(&self, view: usize, ribbon: &Ribbon) -> bool {
        self.ribbon(view).is_some_and(|own| own.lines.iter().any(|line| ribbon.lines.contains(line)))
    }

    /// The cylinder with the ribbon of one more image, and the distance of its lines; `None` if the
    /// ribbon does not fit.
    fn with(&self, seen: &[Seen], (view, ribbon): (usize, &'a Ribbon), threshold: f64) -> Option<(f64, Self)> {
        if !self.is_near(view, &seen[view].view.selected(&ribbon.lines), threshold) {
            return None;
        }
        let ribbons = [&self.ribbons[..], &[(view, ribbon)]].concat();
        let Estimate { cylinder, refinement, .. } = estimate_from(&lines(seen, &ribbons), &self.cylinder).ok()?;
        let rms = refinement?.0.rms;
        (rms <= threshold).then_some((rms, Self { cylinder, ribbons, ..*self }))
    }

    /// Whether no image that shows the part that ribbons show is without a ribbon.
    fn is_missed_by_none(&self, seen: &[Seen]) -> bool {
        let contacts = lines(seen, &self.ribbons);
        let contacts = contacts.iter().flat_map(|view| end_contacts(&self.cylinder, view)).flatten().flatten();
        let heights: Vec<f64> = contacts.map(|point| self.cylinder.height(&point)).collect();
        let [low, high] = [
            heights.iter().copied().fold(f64::INFINITY, f64::min),
            heights.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        ];
        let is_shown = |seen: &Seen| {
            let heights = (0..POINTS).map(|place| low + (high - low) * (place as f64 + 0.5) / POINTS as f64);
            heights.filter(|height| self.is_inside(*height, seen)).count() as f64 >= SHOWN * POINTS as f64
        };
        seen.iter().enumerate().all(|(view, seen)| self.ribbon(view).is_some() || !is_shown(seen))
    }

    /// Whether an image has both silhouettes at this height.
    fn is_inside(&self, height: f64, seen: &Seen) -> bool {
        let camera = seen.view.camera();
        let Some(calibration) = camera.calibration() else { return false };
        let on_axis = self.cylinder.axis_at(height);
        let across = self.cylinder.direction.cross(&(on_axis - camera.centre())).normalize() * self.cylinder.radius;
        [on_axis + across, on_axis - across].iter().all(|point| {
            let point = camera.rotation() * point.coords + camera.translation();
            let pixel = calibration.point_to_pixels(&Point2::new(point.x / point.z, point.y / point.z));
            let [width, height] = seen.size.map(|size| size as f64);
            point.z > 0.0 && (0.0..width).contains(&pixel.x) && (0.0..height).contains(&pixel.y)
        })
    }

    /// Whether the lines of a view lie near both silhouettes. Two images determine a direction
    /// badly, and others show it.
    fn is_near(&self, view: usize, lines: &View, threshold: f64) -> bool {
        let Some(residuals) = self.cylinder.residuals(view, lines) else { return false };
        let is_near = |line: &LineResidual| line.pixels.is_some_and(|pixels| pixels.abs() <= NEAR * threshold);
        residuals.iter().all(is_near) && residuals.windows(2).all(|pair| pair[0].side != pair[1].side)
    }
}

/// Gives the ribbons of an image to the cylinders that have none there, the best fits first. A line
/// is used once.
fn extend<'a>(chosen: &mut [Candidate<'a>], seen: &[Seen], (view, ribbons): (usize, &[&'a Ribbon]), threshold: f64) {
    let mut fits = Vec::new();
    for (at, candidate) in chosen.iter().enumerate().filter(|(_, candidate)| candidate.ribbon(view).is_none()) {
        let with = |ribbon: &&'a Ribbon| Some((at, candidate.with(seen, (view, ribbon), threshold)?));
        fits.extend(ribbons.iter().filter_map(with));
    }
    fits.sort_by(|(_, (a, _)), (_, (b, _))| a.total_cmp(b));
    for (at, (_, extended)) in fits {
        let is_free = |ribbon: &Ribbon| !chosen.iter().any(|other| other.uses(view, ribbon));
        if chosen[at].ribbon(view).is_none() && extended.ribbon(view).is_some_and(is_free) {
            chosen[at] = extended;
        }
    }
}

/// The views with the lines of some ribbons only.
fn lines(seen: &[Seen], ribbons: &[(usize, &Ribbon)]) -> Vec<View> {
    let of_view = |(index, seen): (usize, &Seen)| {
        let ribbon = ribbons.iter().find(|(view, _)| *view == index);
        seen.view.selected(ribbon.map_or(&[][..], |(_, ribbon)| &ribbon.lines[..]))
    };
    seen.iter().enumerate().map(of_view).collect()
}

/// The cylinder of a candidate with its lines; `None` if these do not fit.
fn matched(seen: &[Seen], candidate: &Candidate<'_>, threshold: f64) -> Option<MatchedCylinder> {
    let views = lines(seen, &candidate.ribbons);
    let estimate = estimate_from(&views, &candidate.cylinder).ok()?;
    let (refinement, _) = estimate.refinement.as_ref()?;
    if refinement.rms > threshold {
        return None;
    }
    let mut matches = estimate.residuals.clone();
    for line in &mut matches {
        line.line = candidate.ribbon(line.view)?.lines[line.line];
    }
    let square: f64 = matches.iter().map(|line| line.distance * line.distance).sum();
    Some(MatchedCylinder {
        cylinder: estimate.cylinder,
        rms: (square / matches.len() as f64).sqrt(),
        matches,
        outlier_rate: 0.0,
        false_alarms: candidate.false_alarms,
    })
}
