//! Instances whose solutions are known beforehand: geometry first, data from it.

mod absolute_pose;
mod benchmarks;
mod cameras;
mod circles;
mod linear;
mod lines;
mod maker;
mod measurements;
mod optimal_pose;
mod orbits;
mod platforms;
mod points;
mod pose;
mod radial_distortion;
mod ranging;
mod relative_pose;
mod triangulation;
mod underwater;
mod views;

pub use cameras::{Motion, camera, distorted, image, in_ball, two_cameras, upright, upright_cameras};
pub use circles::{Circle, Line, gram, minimal_conic, minimal_data, normalised};
pub use linear::{combination, coordinates, null_space, uniform, vector};
use linear::{derived_null_space, solved, weights};
pub use maker::{FOUND, KnownInstance, Make, Maker, largest_relative_error, projective_error, relative_error};
pub use pose::{is_pose, is_rotation};
pub use underwater::{Underwater, WATER};
pub use views::View;

/// One maker for every problem, by name.
pub fn makers() -> Vec<Maker> {
    let families = [
        absolute_pose::makers(),
        benchmarks::makers(),
        circles::makers(),
        lines::makers(),
        measurements::makers(),
        optimal_pose::makers(),
        orbits::makers(),
        platforms::makers(),
        points::makers(),
        radial_distortion::makers(),
        ranging::makers(),
        relative_pose::makers(),
        triangulation::makers(),
    ];
    let mut makers: Vec<Maker> = families.into_iter().flatten().collect();
    makers.sort_by_key(|maker| maker.name);
    makers
}
