//! Copies of a line are one line.
//!
//! Edge detectors break a silhouette into pieces, and find it twice, a fraction of a pixel apart;
//! a photograph may be given twice. Such lines say the same: two copies of three lines are three
//! lines, which four cylinders touch. Estimators therefore count independent lines only.
//!
//! ```text
//!     ======---------- ======     copies: all end points are near their joint line (least
//!        ==========               squares), and no gap is longer than all pieces together
//! ```
//!
//! A line without end points is represented by two points beside the principal point.

use nalgebra::{Point2, Point3, Vector2, Vector3};

use super::scene::LineId;
use super::view::{LineWithEnds, View};

/// Largest distance of an end point from the joint line of copies, pixels.
const TOLERANCE_PIXELS: f64 = 1.0;

/// The same tolerance without calibration, normalised image coordinates: a pixel at a focal length
/// of 3000.
const TOLERANCE: f64 = 1.0 / 3000.0;

/// Pieces of a line are longer than their scatter across it by this factor or more, as for the
/// segments of one line in a CSV file.
const ELONGATION: f64 = 10.0;

/// Half of the distance between the points that represent a line without end points, normalised
/// image coordinates.
const HALF_LENGTH: f64 = 0.1;

/// Two cameras stand at one place if their distance, relative to their distance from the world's
/// origin, is at most this.
const SAME_PLACE: f64 = 1e-9;

/// Lines of which none is a copy of another.
#[derive(Clone, Debug, PartialEq)]
pub struct IndependentLines {
    /// The views with one line for each group of copies: the line of least squares through the end
    /// points of the group, from the first to the last of them. It is in the view of the first
    /// copy.
    pub views: Vec<View>,
    /// The given lines that each line of `views` stands for, in their order.
    pub copies: Vec<Vec<LineId>>,
}

impl IndependentLines {
    /// Joins copies: lines of one image, or of images from one place, whose end points all lie
    /// within a pixel of their joint line (without calibration within 1/3000 of the focal length).
    /// Gaps between pieces are at most as long as the pieces.
    pub fn of(views: &[View]) -> Self {
        Self::within(views, 1.0)
    }

    /// Joins lines that are nearly copies: all within a multiple of the tolerance.
    pub(crate) fn within(views: &[View], multiple: f64) -> Self {
        let centres: Vec<_> = views.iter().map(|view| view.camera().centre()).collect();
        let reaches: Vec<_> = centres.iter().map(|centre| SAME_PLACE * centre.coords.norm()).collect();
        // The groups of each view. Each starts with a line of that view.
        let mut groups: Vec<Vec<Group>> = Vec::with_capacity(views.len());
        for (index, view) in views.iter().enumerate() {
            groups.push(Vec::new());
            // Lines of other images can only be copies if they were seen from the same place.
            let homes: Vec<_> =
                (0..=index).filter(|&home| same_place(&centres[home], &centres[index], reaches[home])).collect();
            for line in 0..view.lines().len() {
                let id = LineId { view: index, line };
                let is_joined = homes.iter().any(|&home| {
                    let Some(seen) = Seen::of(view, line, &views[home]) else { return false };
                    let tolerance = multiple * tolerance(&views[home]);
                    groups[home].iter_mut().any(|group| group.join(&seen, id, tolerance))
                });
                if !is_joined {
                    groups[index].push(Group::new(Seen::of(view, line, view), id));
                }
            }
        }
        let joint = |(view, groups): (&View, &Vec<Group>)| {
            let chosen: Vec<_> = groups.iter().map(|group| (group.copies[0].line, group.joint())).collect();
            view.with_joint_lines(&chosen)
        };
        let views = views.iter().zip(&groups).map(joint).collect();
        Self { views, copies: groups.into_iter().flatten().map(|group| group.copies).collect() }
    }

    /// Number of independent lines.
    pub fn count(&self) -> usize {
        self.copies.len()
    }

    /// Number of given lines.
    pub fn given(&self) -> usize {
        self.copies.iter().map(Vec::len).sum()
    }
}

/// Whether two points are within a distance. Most cameras are further apart along the first axis
/// already.
fn same_place(one: &Point3<f64>, other: &Point3<f64>, reach: f64) -> bool {
    one == other || ((one.x - other.x).abs() <= reach && (one - other).norm() <= reach)
}

/// The tolerance in normalised image coordinates.
fn tolerance(view: &View) -> f64 {
    view.camera().calibration().map_or(TOLERANCE, |calibration| {
        let k = calibration.matrix();
        TOLERANCE_PIXELS / (k[(0, 0)] * k[(1, 1)]).abs().sqrt()
    })
}

/// A line of an image, in normalised coordinates.
#[derive(Clone, Copy, Debug)]
struct Seen {
    /// Unit normal and offset.
    line: Vector3<f64>,
    /// End points, or two points that stand for a line without them.
    points: [Point2<f64>; 2],
    has_ends: bool,
}

impl Seen {
    /// A line in the image of a camera at the same place; `None` if it is not seen there.
    fn of(view: &View, index: usize, home: &View) -> Option<Self> {
        let (mut line, mut ends) = (view.lines()[index], view.ends()[index]);
        if view.camera() != home.camera() {
            let turn = home.camera().rotation() * view.camera().rotation().transpose();
            line = turn * line;
            if let Some(ends) = &mut ends {
                let rays = ends.map(|end| turn * end.to_homogeneous());
                if rays.iter().any(|ray| ray.z <= 0.0) {
                    return None;
                }
                *ends = rays.map(|ray| Point2::from(ray.xy() / ray.z));
            }
        }
        let line = line / line.xy().norm();
        let (foot, along) = (line.xy() * -line.z, Vector2::new(-line.y, line.x) * HALF_LENGTH);
        let points = ends.unwrap_or([foot - along, foot + along].map(Point2::from));
        let finite = points.iter().all(|point| point.iter().all(|entry| entry.is_finite()));
        finite.then_some(Self { line, points, has_ends: ends.is_some() })
    }

    fn length(&self) -> f64 {
        (self.points[1] - self.points[0]).norm()
    }

    /// The line at the places of other points: their projections.
    fn beside(&self, points: &[Point2<f64>; 2]) -> [Point2<f64>; 2] {
        points.map(|point| point - self.line.xy() * self.line.dot(&point.to_homogeneous()))
    }
}

/// A line and its copies.
struct Group {
    /// The lines that were joined, none if the only line is out of range. Lines without end points
    /// are dropped when a line with end points joins them.
    seen: Vec<Seen>,
    copies: Vec<LineId>,
}

impl Group {
    fn new(seen: Option<Seen>, id: LineId) -> Self {
        Self { seen: seen.into_iter().collect(), copies: vec![id] }
    }

    /// Takes the line into the group if it is a copy, and says whether it is.
    fn join(&mut self, other: &Seen, id: LineId, tolerance: f64) -> bool {
        // Lines at a larger angle have no joint line within the tolerance.
        let Some(first) = self.seen.first() else { return false };
        let angle = first.line.xy().perp(&other.line.xy()).abs();
        if angle > 2.0 * tolerance * (1.0 / first.length() + 1.0 / other.length()) {
            return false;
        }
        let is_copy = match (first.has_ends, other.has_ends) {
            (true, false) => self.seen.iter().all(|seen| is_near(&other.beside(&seen.points), &seen.line, tolerance)),
            (false, true) => self.seen.iter().all(|seen| is_near(&seen.beside(&other.points), &other.line, tolerance)),
            _ => {
                let seen: Vec<_> = self.seen.iter().chain([other]).copied().collect();
                JointLine::of(&seen).is_some_and(|joint| joint.explains(&seen, tolerance))
            }
        };
        if is_copy {
            match (first.has_ends, other.has_ends) {
                (true, false) => {}
                (false, true) => self.seen = vec![*other],
                _ => self.seen.push(*other),
            }
            self.copies.push(id);
        }
        is_copy
    }

    /// The joint line and its end points; `None` if the group is a single line.
    fn joint(&self) -> Option<LineWithEnds> {
        if self.copies.len() == 1 {
            return None;
        }
        let first = self.seen.first()?;
        let joint = JointLine::of(&self.seen)?;
        let ends = first.has_ends.then(|| joint.outermost(&self.seen));
        Some(if self.seen.len() == 1 {
            (first.line.normalize(), first.has_ends.then_some(first.points))
        } else {
            (joint.line(), ends)
        })
    }
}

/// Whether points are within twice the tolerance of a line, so that a line between both is within
/// the tolerance.
fn is_near(points: &[Point2<f64>; 2], line: &Vector3<f64>, tolerance: f64) -> bool {
    points.iter().all(|point| line.dot(&point.to_homogeneous()).abs() <= 2.0 * tolerance)
}

/// The line of least squares through end points: their centroid and the main axis of their scatter.
struct JointLine {
    centroid: Point2<f64>,
    along: Vector2<f64>,
}

impl JointLine {
    fn of(seen: &[Seen]) -> Option<Self> {
        let points = || seen.iter().flat_map(|seen| seen.points);
        let count = points().count() as f64;
        let centroid = Point2::from(points().map(|point| point.coords / count).sum::<Vector2<f64>>());
        let (mut difference, mut product) = (0.0, 0.0);
        for point in points() {
            let offset = point - centroid;
            difference += (offset.x - offset.y) * (offset.x + offset.y);
            product += 2.0 * offset.x * offset.y;
        }
        let (sine, cosine) = (0.5 * product.atan2(difference)).sin_cos();
        let along = Vector2::new(cosine, sine);
        (along.x.is_finite() && along.y.is_finite()).then_some(Self { centroid, along })
    }

    /// Whether all points are within the tolerance, the pieces are elongated, and no gap is longer
    /// than the pieces.
    fn explains(&self, seen: &[Seen], tolerance: f64) -> bool {
        let (mut largest, mut across, mut along) = (0.0_f64, 0.0, 0.0);
        let mut spans = Vec::with_capacity(seen.len());
        for line in seen {
            let offsets = line.points.map(|point| point - self.centroid);
            for offset in offsets {
                let distance = self.along.perp(&offset);
                largest = largest.max(distance.abs());
                across += distance * distance;
                along += self.along.dot(&offset).powi(2);
            }
            let [start, end] = offsets.map(|offset| self.along.dot(&offset));
            spans.push([start.min(end), start.max(end)]);
        }
        if largest > tolerance || across * ELONGATION * ELONGATION > along {
            return false;
        }
        let total: f64 = spans.iter().map(|[start, end]| end - start).sum();
        spans.sort_by(|one, other| one[0].total_cmp(&other[0]));
        let mut reached = spans[0][1];
        spans.iter().all(|[start, end]| {
            let gap = start - reached;
            reached = reached.max(*end);
            gap <= total
        })
    }

    fn line(&self) -> Vector3<f64> {
        let normal = Vector2::new(-self.along.y, self.along.x);
        normal.push(-normal.dot(&self.centroid.coords)).normalize()
    }

    /// The first and the last point, projected to the line.
    fn outermost(&self, seen: &[Seen]) -> [Point2<f64>; 2] {
        let places = seen.iter().flat_map(|seen| seen.points).map(|point| self.along.dot(&(point - self.centroid)));
        let [first, last] =
            places.fold([f64::INFINITY, f64::NEG_INFINITY], |[first, last], place| [first.min(place), last.max(place)]);
        [first, last].map(|place| self.centroid + self.along * place)
    }
}
