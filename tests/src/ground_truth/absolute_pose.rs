//! Pose of a camera from points of known position.

use std::array::from_fn;
use std::f64::consts::TAU;

use eliminant_generator::algebra::Random;
use nalgebra::{Matrix3, Vector2, Vector3};

use super::cameras::{distorted, frame, image, in_ball, quaternion};
use super::underwater::{Underwater, WATER};
use super::{
    KnownInstance, Make, Maker, View, combination, coordinates, derived_null_space, projective_error, relative_error,
    uniform, vector, weights,
};

pub(super) fn makers() -> Vec<Maker> {
    vec![
        Maker {
            name: "pose_35pt_focal",
            make: Make::KnownPoints(three_and_a_half_points),
            error: |_, solution, truth| relative_error(solution, truth),
        },
        Maker {
            name: "pose_3pt_depths",
            make: Make::KnownPoints(three_depths),
            error: |_, solution, truth| relative_error(solution, truth),
        },
        Maker {
            name: "pose_3pt_upright_error_bound",
            make: Make::KnownPoints(three_stationary_errors),
            error: |_, solution, truth| relative_error(solution, truth),
        },
        Maker {
            name: "pose_4pt_focal_radial",
            make: Make::KnownPoints(|random, view| {
                let (data, weights, radial) = distorted_points(random, view);
                KnownInstance { data, truths: vec![[weights, vec![radial]].concat()] }
            }),
            error: |_, s, truth| {
                let matrix = projective_error(&vector(&s[..3]), &vector(&truth[..3]));
                matrix.max(relative_error(&s[3..], &truth[3..]))
            },
        },
        Maker {
            name: "pose_4pt_focal_radial_cut",
            make: Make::KnownPoints(|random, view| {
                let (data, weights, radial) = distorted_points(random, view);
                KnownInstance { data, truths: vec![[vec![radial], weights].concat()] }
            }),
            error: |_, s, truth| {
                let matrix = projective_error(&vector(&s[1..]), &vector(&truth[1..]));
                matrix.max(relative_error(&s[..1], &truth[..1]))
            },
        },
        Maker {
            name: "pose_4pt_generalized_scale",
            make: Make::KnownPoints(generalized_camera),
            error: |_, solution, truth| projective_error(&vector(solution), &vector(truth)),
        },
        Maker {
            name: "pose_4pt_upright_error_bound",
            make: Make::KnownPoints(four_errors_at_bounds),
            error: |_, solution, truth| relative_error(solution, truth),
        },
        Maker {
            name: "pose_5pt_refraction",
            make: Make::KnownPoints(through_water),
            error: |data, solution, truth| {
                let basis = derived_null_space(&refracted_rows(data));
                let [solved, known] = [solution, truth].map(|x| combination(&basis, &vector(x)));
                projective_error(&solved, &known)
            },
        },
        Maker {
            name: "pose_6pt_rolling_shutter",
            make: Make::KnownPoints(rolling_shutter),
            error: |_, solution, truth| relative_error(solution, truth),
        },
    ]
}

/// Points in the unit ball. The depths, and their negatives: points behind the camera.
fn three_depths(random: &mut Random, view: View) -> KnownInstance {
    let pose = view.camera(random);
    let points: [Vector3<f64>; 3] = from_fn(|k| pose.0 * view.point(random, &pose, k) + pose.1);
    let pairs = [(1, 2), (0, 2), (0, 1)].map(|(i, j)| (points[i], points[j]));
    let cosines = pairs.map(|(x, y)| x.dot(&y) / (x.norm() * y.norm()));
    let squares = pairs.map(|(x, y)| (x - y).norm_squared());
    let depths = points.map(|x| x.norm());
    KnownInstance { data: [cosines, squares].concat(), truths: vec![depths.to_vec(), depths.map(|d| -d).to_vec()] }
}

/// Points in the unit ball, their image coordinates for a focal length of 0.5 to 3; the rotation
/// without its turn about the optical axis.
fn three_and_a_half_points(random: &mut Random, view: View) -> KnownInstance {
    let pose = view.camera(random);
    let focal = uniform(random, 0.5, 3.0);
    let points = view.points(random, &pose, 4);
    let (rotation, translation) = pose;
    let images: Vec<Vector2<f64>> = points.iter().map(|x| image(&(rotation * x + translation), focal)).collect();
    // The points are turned before.
    let [w, x, y, z] = quaternion(&(rotation * frame().transpose()));
    // (w, x, y, z) = (w, 0, 0, z) (1, truth, 0).
    let truth = vec![(w * x + z * y) / (w * w + z * z), (w * y - z * x) / (w * w + z * z)];
    let horizontal = images.iter().map(|x| x[0]);
    let vertical = images[..3].iter().map(|x| x[1]);
    let data = points.iter().flat_map(|x| x.data.0[0]).chain(horizontal).chain(vertical).collect();
    KnownInstance { data, truths: vec![truth] }
}

/// Positions and distorted images of four points; the weights of the null vectors in the first two
/// rows of the camera diag(1, 1, 1/f) [R t], and the distortion.
fn distorted_points(random: &mut Random, view: View) -> (Vec<f64>, Vec<f64>, f64) {
    // An image at the centre has no direction: it is no measurement for this problem.
    let view = if view == View::Centred { View::General } else { view };
    let pose = view.camera(random);
    let (focal, radial) = (uniform(random, 0.5, 3.0), -uniform(random, 0.05, 0.5) / 9.0);
    let radial = if view == View::Ideal { 0.0 } else { radial };
    let points: [Vector3<f64>; 4] = from_fn(|k| view.point(random, &pose, k));
    let (rotation, translation) = pose;
    let images = points.map(|x| distorted(image(&(rotation * x + translation), focal), radial));
    // Positions relative to the first, in units of their length.
    let offsets = points.map(|x| x - points[0]);
    let unit = offsets.iter().map(Vector3::norm_squared).sum::<f64>().sqrt();
    let row = |(x, q): (&Vector3<f64>, &Vector2<f64>)| {
        let x = (x / unit).push(1.0).data.0[0];
        // Zeros are without a sign, as the solver has them: the first null vector depends on it.
        [x.map(|x| q[1] * x + 0.0), x.map(|x| -q[0] * x + 0.0)].concat()
    };
    let rows: Vec<Vec<f64>> = offsets.iter().zip(&images).map(row).collect();
    let first = (rotation * points[0] + translation) / unit;
    let upper: Vec<f64> =
        (0..2).flat_map(|i| [rotation[(i, 0)], rotation[(i, 1)], rotation[(i, 2)], first[i]]).collect();
    let weights = coordinates(&weights(&derived_null_space(&rows), &upper));
    let data = points.iter().flat_map(|x| x.data.0[0]).chain(images.iter().flat_map(|q| q.data.0[0])).collect();
    (data, weights, radial)
}

/// Rays of any length from different centres in the unit ball, whose unit is 0.5 to 2 times that of
/// the points; in some views those of a stereo rig, from either of which two points are seen.
fn generalized_camera(random: &mut Random, view: View) -> KnownInstance {
    let pose = view.camera(random);
    let scale = uniform(random, 0.5, 2.0);
    let points: [Vector3<f64>; 4] = from_fn(|k| view.point(random, &pose, k));
    let (rotation, translation) = pose;
    let mut centres: [Vector3<f64>; 4] = from_fn(|_| in_ball(random));
    if matches!(view, View::Aligned | View::Plane | View::Frontal | View::Square | View::SquareHeadOn) {
        let half: Vector3<f64> = 0.5 * Vector3::x();
        centres = [-half, -half, half, half];
    }
    let ray = |k: usize| rotation * points[k] + translation - scale * centres[k];
    let rays: [Vector3<f64>; 4] = from_fn(|k| ray(k) * uniform(random, 0.5, 2.0));
    let data = centres.iter().chain(&rays).chain(&points).flat_map(|x| x.data.0[0]).collect();
    KnownInstance { data, truths: vec![coordinates(&quaternion(&rotation))] }
}

/// A camera 2 to 6 units from the centre of the unit ball, turned about its first axis, and points
/// of the ball, each seen with an error of the length of the bound.
struct ErrorsAtBounds {
    view: View,
    cosine: f64,
    sine: f64,
    position: Vector3<f64>,
    bound: f64,
    points: Vec<Vector3<f64>>,
    images: Vec<Vector2<f64>>,
}

impl ErrorsAtBounds {
    fn draw(random: &mut Random, view: View) -> Self {
        let (sine, cosine) = view.turn(random);
        let position =
            Vector3::new(0.5 * random.symmetric_unit(), 0.5 * random.symmetric_unit(), uniform(random, 2.0, 6.0));
        let position = if view == View::AtOrigin { Vector3::zeros() } else { position };
        let bound = uniform(random, 0.005, 0.02);
        Self { view, cosine, sine, position, bound, points: Vec::new(), images: Vec::new() }
    }

    /// Adds a point. `towards` gives the direction of its error from the point and its image.
    fn see(&mut self, random: &mut Random, towards: impl Fn(&Vector3<f64>, &Vector2<f64>) -> Vector2<f64>) {
        let (s, c) = (self.sine, self.cosine);
        let pose = (Matrix3::new(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c), self.position);
        let point = self.view.point(random, &pose, self.points.len());
        let image = image(&(self.turned(&point) + self.position), 1.0);
        self.images.push(image + self.bound * towards(&point, &image));
        self.points.push(point);
    }

    fn see_anywhere(&mut self, random: &mut Random) {
        let (s, c) = uniform(random, 0.0, TAU).sin_cos();
        self.see(random, |_, _| Vector2::new(c, s));
    }

    fn turned(&self, p: &Vector3<f64>) -> Vector3<f64> {
        Vector3::new(p.x, self.cosine * p.y - self.sine * p.z, self.sine * p.y + self.cosine * p.z)
    }

    fn known(self) -> KnownInstance {
        let truth = self.position.iter().copied().chain([self.cosine, self.sine]).collect();
        let points = self.points.iter().flat_map(|x| x.data.0[0]);
        let data = points.chain(self.images.iter().flat_map(|q| q.data.0[0])).chain([self.bound]).collect();
        KnownInstance { data, truths: vec![truth] }
    }
}

fn four_errors_at_bounds(random: &mut Random, view: View) -> KnownInstance {
    let mut seen = ErrorsAtBounds::draw(random, view);
    (0..4).for_each(|_| seen.see_anywhere(random));
    seen.known()
}

/// The third error has the direction in which the derivatives are dependent. With X and Y the
/// point's image and (c, s) the direction from there to what is seen, the gradient of the point's
/// cone by Y and Z is in proportion to (-s, c X + s Y).
fn three_stationary_errors(random: &mut Random, view: View) -> KnownInstance {
    let mut seen = ErrorsAtBounds::draw(random, view);
    (0..2).for_each(|_| seen.see_anywhere(random));
    let rows: Vec<Vector3<f64>> = (0..2)
        .map(|k| {
            let (point, q) = (seen.points[k], seen.images[k]);
            let x = seen.turned(&point) + seen.position;
            let along = q.norm_squared() - seen.bound * seen.bound;
            let (to_y, to_z) = (x.y - q.y * x.z, along * x.z - q.x * x.x - q.y * x.y);
            to_y * by_y(&point) + to_z * by_z(&point)
        })
        .collect();
    let normal = rows[0].cross(&rows[1]);
    seen.see(random, |point, image| {
        let (of_y, of_z) = (normal.dot(&by_y(point)), normal.dot(&by_z(point)));
        Vector2::new(of_y - image.y * of_z, image.x * of_z).normalize()
    });
    seen.known()
}

/// The derivatives of a point's Y and Z in the camera by the shift along Z, the cosine and the
/// sine.
fn by_y(point: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(0.0, point.y, -point.z)
}

fn by_z(point: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(1.0, point.z, point.y)
}

/// A camera turned in any way looks into water.
fn through_water(random: &mut Random, view: View) -> KnownInstance {
    let Underwater { rotation, centre, rays, points } = Underwater::draw(random, view);
    let data: Vec<f64> = rays.iter().chain(&points).flat_map(|x| x.data.0[0]).chain([WATER]).collect();
    let foot = (centre.xy() - points[0].xy()) / unit_in_plane(&points);
    let [first, second] = [0, 1].map(|row| rotation.row(row).transpose());
    let moment = foot[0] * second - foot[1] * first;
    let known: Vec<f64> = [first, second, moment].iter().flat_map(|x| x.data.0[0]).collect();
    KnownInstance { truths: vec![coordinates(&weights(&derived_null_space(&refracted_rows(&data)), &known))], data }
}

/// The unit in which points seen through a plane are about 1 from the first, along the plane.
fn unit_in_plane(points: &[Vector3<f64>]) -> f64 {
    points.iter().map(|x| (x - points[0]).xy().norm_squared()).sum::<f64>().sqrt()
}

/// The equations of five rays and points for two rows of a rotation and their moment.
fn refracted_rows(data: &[f64]) -> Vec<Vec<f64>> {
    let vectors: Vec<Vector3<f64>> = data[..30].chunks(3).map(Vector3::from_column_slice).collect();
    let (rays, points) = vectors.split_at(5);
    let unit = unit_in_plane(points);
    let row = |(ray, point): (&Vector3<f64>, &Vector3<f64>)| {
        let (direction, offset) = (ray.normalize(), (point - points[0]) / unit);
        [offset[1], -offset[0], 1.0].iter().flat_map(|factor| (*factor * direction).data.0[0]).collect()
    };
    rays.iter().zip(points).map(row).collect()
}

/// The image of a point in the row in which it is exposed, by the linearised model: q[0] (A + q[0]
/// B)[2] = (A + q[0] B)[0] has the root that goes to A[0] / A[2] where B goes to 0.
fn exposed(a: &Vector3<f64>, b: &Vector3<f64>) -> Vector2<f64> {
    let half = 0.5 * (a.z - b.x);
    let row = a.x / (half + (half * half + b.z * a.x).sqrt());
    Vector2::new(row, (a.y + row * b.y) / (a.z + row * b.z))
}

/// Rotations of up to 0.3 from a frame in which the points are 3 to 5 units ahead, angular velocity
/// and velocity of up to 0.3.
fn rolling_shutter(random: &mut Random, view: View) -> KnownInstance {
    let [mut turn, mut spin, mut velocity] = [(); 3].map(|()| 0.3 * in_ball(random));
    let position = Vector3::new(random.symmetric_unit(), random.symmetric_unit(), uniform(random, 3.0, 5.0));
    if matches!(view, View::Aligned | View::Frontal | View::SquareHeadOn) {
        turn = Vector3::zeros();
    }
    if view == View::Ideal {
        (spin, velocity) = (Vector3::zeros(), Vector3::zeros());
    }
    let draw = |k: usize| {
        let point = view.point(random, &(Matrix3::identity(), position), k);
        let rotated = point + turn.cross(&point);
        (point, exposed(&(rotated + position), &(spin.cross(&rotated) + velocity)))
    };
    let seen: [(Vector3<f64>, Vector2<f64>); 6] = from_fn(draw);
    let points = seen.iter().flat_map(|(x, _)| x.data.0[0]);
    let data = points.chain(seen.iter().flat_map(|(_, q)| q.data.0[0])).collect();
    KnownInstance { data, truths: vec![turn.iter().chain(&spin).copied().collect()] }
}
