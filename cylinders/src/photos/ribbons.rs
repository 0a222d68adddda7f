//! Ribbons: pairs of lines of one image between which the image is the same all along, as the two
//! silhouettes of a cylinder are that is lit and painted evenly, and is not that of a flat face.
//!
//! ```text
//!       first    second
//!         |  . . .  |       each point of a walk from line to line has about the same grey value
//!         |  . . .  |       at all places along the ribbon: these values are its profile
//!          | . . . |
//! ```

use nalgebra::{Point2, Vector2};

use crate::detection::GreyImage;
use crate::observations::view::View;

/// Least length of both lines, as a part of the diagonal of the image.
const LEAST_LENGTH: f64 = 0.08;
/// Largest angle between the lines, radians.
const LARGEST_ANGLE: f64 = 0.1;
/// The lines are side by side on at least this part of the shorter one.
const LEAST_OVERLAP: f64 = 0.5;
/// Least width, pixels, and largest, as a part of the length.
const LEAST_WIDTH: f64 = 8.0;
const LARGEST_WIDTH: f64 = 0.4;
/// Values of a profile, at this part of the width from both lines, and places along the ribbon.
const VALUES: usize = 16;
const MARGIN: f64 = 0.12;
const PLACES: usize = 48;
/// Largest median deviation of the values along the ribbon from the profile, of 255.
const LARGEST_SPREAD: f32 = 8.0;
/// Least root mean square distance of a profile from its mean, of 255; or from a straight line, of
/// 255 and in errors of its values: a flat face is equally bright all across it, or nearly, a
/// cylinder is not.
const LEAST_DEVIATION: f32 = 5.0;
const LEAST_BEND: f32 = 1.0;
const BEND: f32 = 2.0;
/// Largest difference of neighbouring values, of 255 and as a part of the range of the profile: the
/// light on a cylinder changes little by little.
const LARGEST_STEP: f32 = 16.0;
const STEP: f32 = 0.5;
/// So many ribbons of an image at most: the longest.
const MOST: usize = 40;

/// Grey values on a walk across a ribbon.
pub(super) type Profile = [f32; VALUES];

/// A pair of lines with an even part of the image between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Ribbon {
    /// Indices of the lines in their view.
    pub lines: [usize; 2],
    /// Of each line the two points between which the other one is beside it, pixels; first points
    /// are at the same end.
    pub ends: [[Point2<f64>; 2]; 2],
    /// Median grey values on a walk from the first line to the second.
    pub profile: Profile,
}

impl Ribbon {
    /// Distance between the lines in the middle, pixels.
    pub(super) fn width(&self) -> f64 {
        let [first, second] = self.ends.map(|ends| nalgebra::center(&ends[0], &ends[1]));
        (second - first).norm()
    }

    /// Pixels.
    pub(super) fn length(&self) -> f64 {
        self.ends.map(|ends| (ends[1] - ends[0]).norm()).iter().sum::<f64>() / 2.0
    }

    /// Whether the middle of another one of the same image lies between the lines, or the other way
    /// round.
    pub(super) fn overlaps(&self, other: &Self) -> bool {
        self.holds(&other.middle()) || other.holds(&self.middle())
    }

    /// Whether both lines of another one of the same image lie between the lines of this one, or on
    /// them.
    pub(super) fn encloses(&self, other: &Self) -> bool {
        let is_inside = |line: usize| {
            self.lines.contains(&other.lines[line])
                || self.holds(&nalgebra::center(&other.ends[line][0], &other.ends[line][1]))
        };
        is_inside(0) && is_inside(1)
    }

    pub(super) fn middle(&self) -> Point2<f64> {
        let [first, second] = self.ends.map(|ends| nalgebra::center(&ends[0], &ends[1]));
        nalgebra::center(&first, &second)
    }

    /// Whether a point lies between the lines, as far as they are side by side.
    fn holds(&self, point: &Point2<f64>) -> bool {
        let [[a, b], [c, d]] = self.ends;
        let side = |from: Point2<f64>, to: Point2<f64>| (to - from).perp(&(point - from)).is_sign_positive();
        // Around the quadrangle a, b, d, c.
        let sides = [side(a, b), side(b, d), side(d, c), side(c, a)];
        sides.iter().all(|&side| side == sides[0])
    }
}

/// The ribbons of an image without distortion among the lines of its view, the longest first.
pub(super) fn ribbons(view: &View, image: &GreyImage) -> Vec<Ribbon> {
    let Some(calibration) = view.camera().calibration() else { return Vec::new() };
    let least = LEAST_LENGTH * (image.width() as f64).hypot(image.height() as f64);
    let in_pixels = |ends: &[Point2<f64>; 2]| ends.map(|end| calibration.point_to_pixels(&end));
    let lines: Vec<(usize, [Point2<f64>; 2])> = view
        .ends()
        .iter()
        .enumerate()
        .filter_map(|(line, ends)| Some((line, in_pixels(ends.as_ref()?))))
        .filter(|(_, ends)| (ends[1] - ends[0]).norm() >= least)
        .collect();
    let mut found: Vec<Ribbon> = Vec::new();
    for (index, first) in lines.iter().enumerate() {
        found.extend(lines[index + 1..].iter().filter_map(|second| ribbon(first, second, image)));
    }
    found.sort_by(|a, b| b.length().total_cmp(&a.length()));
    found.truncate(MOST);
    found
}

/// The ribbon between two lines, if there is one.
fn ribbon(first: &(usize, [Point2<f64>; 2]), second: &(usize, [Point2<f64>; 2]), image: &GreyImage) -> Option<Ribbon> {
    let [(first, a), (second, mut b)] = [*first, *second];
    let along = (a[1] - a[0]).normalize();
    if (b[1] - b[0]).dot(&along) < 0.0 {
        b.reverse();
    }
    let other = (b[1] - b[0]).normalize();
    if along.perp(&other).abs() > LARGEST_ANGLE {
        return None;
    }
    let axis: Vector2<f64> = (along + other).normalize();
    let height = |point: &Point2<f64>| axis.dot(&(point - a[0]));
    let span = |ends: &[Point2<f64>; 2]| [height(&ends[0]), height(&ends[1])];
    let [of_a, of_b] = [span(&a), span(&b)];
    let both = [of_a[0].max(of_b[0]), of_a[1].min(of_b[1])];
    if both[1] - both[0] < LEAST_OVERLAP * (of_a[1] - of_a[0]).min(of_b[1] - of_b[0]) {
        return None;
    }
    let at = |ends: &[Point2<f64>; 2], span: [f64; 2], height: f64| {
        ends[0] + (ends[1] - ends[0]) * ((height - span[0]) / (span[1] - span[0]))
    };
    let ends = [both.map(|height| at(&a, of_a, height)), both.map(|height| at(&b, of_b, height))];
    let ribbon = Ribbon { lines: [first, second], ends, profile: [0.0; VALUES] };
    let width = ribbon.width();
    if !(LEAST_WIDTH..LARGEST_WIDTH * ribbon.length()).contains(&width) {
        return None;
    }
    Some(Ribbon { profile: profile(&ends, image)?, ..ribbon })
}

/// The median values on walks from line to line, if those of the walks agree, and are not those of
/// a flat face.
fn profile(ends: &[[Point2<f64>; 2]; 2], image: &GreyImage) -> Option<Profile> {
    let mut walks: Vec<Profile> = (0..PLACES).map(|place| walk(ends, place, image)).collect();
    // Outside of the photograph nothing is known.
    walks.retain(|walk| walk.iter().all(|value| value.is_finite()));
    if 2 * walks.len() < PLACES {
        return None;
    }
    let (profile, spread) = medians(&walks);
    // The light may change along the ribbon.
    for walk in &mut walks {
        let mean = walk.iter().sum::<f32>() / VALUES as f32;
        walk.iter_mut().for_each(|value| *value -= mean);
    }
    let (across, noise) = medians(&walks);
    // The error of the median of so many values, if they are normal.
    let error = noise * 1.48 * 1.25 / (walks.len() as f32).sqrt();
    let is_curved = deviation(&across) >= LEAST_DEVIATION || bend(&across) >= LEAST_BEND.max(BEND * error);
    (spread <= LARGEST_SPREAD && is_curved && !has_step(&profile)).then_some(profile)
}

/// The values at one place along a ribbon, from its first line to the second.
fn walk([first, second]: &[[Point2<f64>; 2]; 2], place: usize, image: &GreyImage) -> Profile {
    let along = (place as f64 + 0.5) / PLACES as f64;
    let [from, to] = [first, second].map(|ends| ends[0] + (ends[1] - ends[0]) * along);
    std::array::from_fn(|value| {
        let across = MARGIN + (1.0 - 2.0 * MARGIN) * value as f64 / (VALUES - 1) as f64;
        image.at(&(from + (to - from) * across))
    })
}

/// The median of each value over all walks, and the mean of their median deviations from it.
fn medians(walks: &[Profile]) -> (Profile, f32) {
    let (mut profile, mut spread) = ([0.0; VALUES], 0.0);
    for (at, median) in profile.iter_mut().enumerate() {
        let mut values: Vec<f32> = walks.iter().map(|walk| walk[at]).collect();
        *median = middle(&mut values);
        values.iter_mut().for_each(|value| *value = (*value - *median).abs());
        spread += middle(&mut values) / VALUES as f32;
    }
    (profile, spread)
}

/// Whether a profile is that of two faces, or of two things before a background.
fn has_step(profile: &Profile) -> bool {
    let (least, most) = profile.iter().fold((f32::INFINITY, 0.0_f32), |(least, most), &v| (least.min(v), most.max(v)));
    let largest = LARGEST_STEP.max(STEP * (most - least));
    profile.windows(2).any(|pair| (pair[1] - pair[0]).abs() > largest)
}

/// Root mean square distance of a profile from its mean.
fn deviation(profile: &Profile) -> f32 {
    let mean = profile.iter().sum::<f32>() / VALUES as f32;
    (profile.iter().map(|value| (value - mean).powi(2)).sum::<f32>() / VALUES as f32).sqrt()
}

/// Root mean square distance of a profile from the straight line that fits it best.
fn bend(profile: &Profile) -> f32 {
    let centre = (VALUES - 1) as f32 / 2.0;
    let mean = profile.iter().sum::<f32>() / VALUES as f32;
    let places = || (0..VALUES).map(|place| place as f32 - centre);
    let slope = places().zip(profile).map(|(x, value)| x * value).sum::<f32>() / places().map(|x| x * x).sum::<f32>();
    let squares = places().zip(profile).map(|(x, value)| (value - mean - slope * x).powi(2));
    (squares.sum::<f32>() / VALUES as f32).sqrt()
}

/// The median of some values.
fn middle(values: &mut [f32]) -> f32 {
    values.sort_by(f32::total_cmp);
    values[values.len() / 2]
}
