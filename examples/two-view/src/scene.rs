//! Synthetic scenes, whose truth is known.

use std::f64::consts::TAU;

use nalgebra::{Rotation3, Unit, Vector3};
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{RngCore, SeedableRng};

use crate::input::{Camera, Pair};
use crate::pose::Pose;

/// Width and height of the images, in pixels.
const SIZE: [f64; 2] = [1200.0, 900.0];
/// Depths of points, where the distance of the cameras is one.
const DEPTHS: [f64; 2] = [2.0, 10.0];
/// The largest angle between the cameras, in radians.
const TURN: f64 = 0.4;
/// Focal lengths, in pixels.
const FOCAL: [f64; 2] = [800.0, 1000.0];

/// How scenes are made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SceneOptions {
    /// At least, and at most, so many correspondences.
    pub correspondences: [usize; 2],
    /// The standard deviation of coordinates, in pixels.
    pub noise: f64,
    /// The share of outliers, whose points in the second image are anywhere.
    pub outliers: f64,
    /// Of the random numbers.
    pub seed: u64,
}

impl Default for SceneOptions {
    fn default() -> Self {
        Self { correspondences: [500, 2000], noise: 1.0, outliers: 0.3, seed: 1 }
    }
}

/// A pair of images with what is known of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The pair, with its truth.
    pub pair: Pair,
    /// For each correspondence whether it is an inlier.
    pub is_inlier: Vec<bool>,
}

/// The scene of a number: the same options and number give the same scene.
pub fn scene(options: &SceneOptions, number: u64) -> Scene {
    let mut random = Random(Xoshiro256PlusPlus::seed_from_u64(options.seed.wrapping_mul(1 << 20).wrapping_add(number)));
    let camera = |focal: f64| Camera { focal: [focal; 2], centre: SIZE.map(|size| 0.5 * size) };
    let cameras = [camera(random.between(FOCAL)), camera(random.between(FOCAL))];
    let turn = random.direction().scale(random.between([0.0, TURN]));
    let truth = Pose { rotation: Rotation3::new(turn), translation: Unit::new_unchecked(random.direction()) };
    let [least, most] = options.correspondences.map(|count| count as f64);
    let count = random.between([least, most + 1.0]) as usize;
    let (mut points, mut is_inlier) = (Vec::with_capacity(count), Vec::with_capacity(count));
    while points.len() < count {
        let Some([first, mut second]) = images(&mut random, &cameras, &truth) else { continue };
        let noise = [(); 4].map(|()| options.noise * random.normal());
        let inlier = random.between([0.0, 1.0]) >= options.outliers;
        if !inlier {
            second = SIZE.map(|size| random.between([0.0, size]));
        }
        points.push([first[0] + noise[0], first[1] + noise[1], second[0] + noise[2], second[1] + noise[3]]);
        is_inlier.push(inlier);
    }
    Scene { pair: Pair { name: number.to_string(), cameras, points, truth: Some(truth) }, is_inlier }
}

/// The images of a random point, if the second camera sees it.
fn images(random: &mut Random, cameras: &[Camera; 2], pose: &Pose) -> Option<[[f64; 2]; 2]> {
    let first = SIZE.map(|size| random.between([0.0, size]));
    let [focal, centre] = [cameras[0].focal, cameras[0].centre];
    let ray = Vector3::new((first[0] - centre[0]) / focal[0], (first[1] - centre[1]) / focal[1], 1.0);
    let point = pose.rotation * (ray * random.between(DEPTHS)) + *pose.translation;
    let [focal, centre] = [cameras[1].focal, cameras[1].centre];
    let second = [0, 1].map(|k| focal[k] * point[k] / point.z + centre[k]);
    let is_seen = point.z > 0.0 && (0..2).all(|k| second[k] >= 0.0 && second[k] < SIZE[k]);
    is_seen.then_some([first, second])
}

struct Random(Xoshiro256PlusPlus);

impl Random {
    fn between(&mut self, [from, to]: [f64; 2]) -> f64 {
        from + (to - from) * (self.0.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// By Box and Muller.
    fn normal(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.between([0.0, 1.0])).ln()).sqrt();
        radius * self.between([0.0, TAU]).cos()
    }

    fn direction(&mut self) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.normal()).normalize()
    }
}
