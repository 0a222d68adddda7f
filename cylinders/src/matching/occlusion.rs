//! Which silhouettes of a circle others hide.
//!
//! ```text
//!        C -------- o ----- T      hidden: the line of sight to the point of contact T,
//!           \     (   )  ( p )     at alpha = -+beta and at the distance sqrt(rho^2 - r^2),
//!                                  passes through another circle
//! ```
//!
//! The cross-section is seen against the direction, as in `plan`: the left silhouette is on the
//! right of the centre in the sense of its coordinates.

use nalgebra::{Point2, Vector2};

use crate::cross_section::circle::Circle;

/// A line of sight, from a camera to the point at which it touches a circle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sight {
    camera: Point2<f64>,
    to_contact: Vector2<f64>,
}

impl Sight {
    /// The lines of sight to the left and the right silhouette of a circle; `None` if the camera is
    /// inside.
    pub(super) fn of_silhouettes(camera: &Point2<f64>, circle: &Circle) -> Option<[Self; 2]> {
        let to_centre = circle.centre - camera;
        let square = to_centre.norm_squared();
        let tangent_square = square - circle.radius * circle.radius;
        let outside = tangent_square > 0.0;
        if !outside {
            return None;
        }
        let across = Vector2::new(-to_centre.y, to_centre.x) * circle.radius / tangent_square.sqrt();
        let to_contacts = [to_centre - across, to_centre + across].map(|ray| ray * (tangent_square / square));
        Some(to_contacts.map(|to_contact| Self { camera: *camera, to_contact }))
    }

    /// Whether it passes through a circle.
    pub(super) fn passes_through(&self, circle: &Circle) -> bool {
        let to_centre = circle.centre - self.camera;
        let along = (to_centre.dot(&self.to_contact) / self.to_contact.norm_squared()).clamp(0.0, 1.0);
        (to_centre - self.to_contact * along).norm_squared() < circle.radius * circle.radius
    }
}

/// Whether the left and the right silhouette of a circle are hidden from a camera; `None` if the
/// camera is inside.
pub(super) fn hidden(camera: &Point2<f64>, circle: &Circle, others: &[Circle]) -> Option<[bool; 2]> {
    let sights = Sight::of_silhouettes(camera, circle)?;
    Some(sights.map(|sight| others.iter().any(|other| sight.passes_through(other))))
}

#[cfg(all(test, feature = "command"))]
mod tests {
    use super::*;
    use crate::matching::MatchOptions;
    use crate::matching::plan::Plan;
    use crate::simulation::ParallelSetup;
    use crate::space::cylinder::Side;

    fn circle(x: f64, y: f64, radius: f64) -> Circle {
        Circle { centre: Point2::new(x, y), radius }
    }

    #[test]
    fn what_stands_between_hides_what_stands_behind_does_not() {
        let camera = Point2::new(1.0, 2.0);
        // The camera looks along the first axis, so left is down.
        let seen = circle(11.0, 2.0, 1.0);
        let hidden = |others: &[Circle]| hidden(&camera, &seen, others).expect("a camera outside");
        assert_eq!(hidden(&[]), [false, false]);
        assert_eq!(hidden(&[circle(6.0, 2.6, 0.3)]), [false, true]);
        assert_eq!(hidden(&[circle(6.0, 1.4, 0.3)]), [true, false]);
        assert_eq!(hidden(&[circle(6.0, 2.0, 1.0)]), [true, true]);
        assert_eq!(hidden(&[circle(6.0, 2.0, 0.3)]), [false, false]);
        assert_eq!(hidden(&[circle(15.0, 2.0, 2.0)]), [false, false]);
        assert_eq!(hidden(&[circle(6.0, 2.6, 0.3), circle(6.0, 1.4, 0.3)]), [true, true]);
        assert_eq!(super::hidden(&Point2::new(11.0, 2.5), &seen, &[]), None);
    }

    #[test]
    fn a_circle_at_the_point_of_contact_hides_it_however_small() {
        let (camera, seen) = (Point2::new(-3.0, 0.5), circle(1.0, 2.0, 1.2));
        let to_centre = seen.centre - camera;
        let tangent = (to_centre.norm_squared() - 1.44).sqrt();
        for (side, sign) in [-1.0, 1.0].into_iter().enumerate() {
            let angle = to_centre.y.atan2(to_centre.x) + sign * 1.2_f64.atan2(tangent);
            let contact = camera + Vector2::new(angle.cos(), angle.sin()) * tangent;
            let hides = hidden(&camera, &seen, &[Circle { centre: contact, radius: 1e-9 }]).expect("a camera outside");
            assert!(hides[side] && !hides[1 - side]);
        }
    }

    /// In a scene whose truth is known, no silhouette that was seen is hidden, and left is left.
    #[test]
    fn what_is_seen_is_not_hidden() {
        let setup = ParallelSetup { detection: 1.0, ..ParallelSetup::seven_in_twelve() };
        let (mut seen, mut visible) = (0, 0);
        for seed in 0..5 {
            let scene = setup.scene(seed).expect("a scene");
            let plan = Plan::new(&scene.views, &scene.direction, &MatchOptions::of(&scene.views)).expect("a plan");
            let circle = |index: usize| {
                let cylinder = &scene.cylinders[index];
                Circle { centre: plan.rectification().point(&cylinder.axis_point), radius: cylinder.radius }
            };
            for (view, truth) in plan.views().iter().zip(&scene.truth) {
                for index in 0..7 {
                    let others: Vec<_> = (0..7).filter(|&other| other != index).map(circle).collect();
                    let hidden = hidden(&view.centre, &circle(index), &others).expect("a camera outside");
                    for (side, hidden) in [Side::Left, Side::Right].into_iter().zip(hidden) {
                        let is_seen = truth.contains(&Some((index, side)));
                        assert_eq!(is_seen, !hidden, "seed {seed}, cylinder {index}, {side:?}");
                        seen += usize::from(is_seen);
                        visible += usize::from(!hidden);
                    }
                }
            }
        }
        assert!(seen == visible && (400..840).contains(&seen), "{seen}");
    }
}
