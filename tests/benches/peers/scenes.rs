//! Instances with a known solution, in the data that the functions of the peers take: no noise, and
//! cameras, points and lines as in the scenes of the catalogue.

use eliminant_generator::algebra::Random;
use eliminant_tests::ground_truth::{
    Circle, Line, Motion, camera, distorted, image, in_ball, normalised, two_cameras, uniform,
};
use nalgebra::{Matrix3, Vector3};

/// Flat data and one solution that is known, as [`crate::cases::Case::parts`] describes it.
pub(crate) struct Scene {
    pub(crate) data: Vec<f64>,
    pub(crate) truth: Vec<f64>,
}

fn flat<'a>(vectors: impl IntoIterator<Item = &'a Vector3<f64>>) -> Vec<f64> {
    vectors.into_iter().flat_map(|v| v.data.0[0]).collect()
}

fn rows(matrix: &Matrix3<f64>) -> Vec<f64> {
    matrix.transpose().as_slice().to_vec()
}

fn pose(rotation: &Matrix3<f64>, translation: &Vector3<f64>) -> Vec<f64> {
    [rows(rotation), flat([translation])].concat()
}

/// Rays of length 1 in the first camera, then in the second; the essential matrix.
pub(crate) fn five_points(random: &mut Random) -> Scene {
    five_points_of(random, Motion::General)
}

/// As [`five_points`], of any motion.
pub(crate) fn five_points_of(random: &mut Random, motion: Motion) -> Scene {
    let (rotation, translation, points) = two_cameras((random, motion), 5);
    let seen = points.iter().copied().chain(points.iter().map(|x| rotation * x + translation));
    let rays: Vec<Vector3<f64>> = seen.map(|x| x.normalize()).collect();
    Scene { data: flat(&rays), truth: rows(&(translation.cross_matrix() * rotation)) }
}

/// Image points (x, y, 1), a focal length of 0.5 to 3; pose with a translation of length 1, focal
/// length.
pub(crate) fn six_points_focal(random: &mut Random) -> Scene {
    six_points_focal_of(random, Motion::General)
}

/// As [`six_points_focal`], of any motion.
pub(crate) fn six_points_focal_of(random: &mut Random, motion: Motion) -> Scene {
    let focal = uniform(random, 0.5, 3.0);
    let (rotation, translation, points) = two_cameras((random, motion), 6);
    let seen = points.iter().copied().chain(points.iter().map(|x| rotation * x + translation));
    let images: Vec<Vector3<f64>> = seen.map(|x| image(&x, focal).push(1.0)).collect();
    Scene { data: flat(&images), truth: [pose(&rotation, &translation.normalize()), vec![focal]].concat() }
}

/// Image points, a focal length of 0.5 to 3, points; pose and focal length.
pub(crate) fn four_points_focal(random: &mut Random) -> Scene {
    let (rotation, translation) = camera(random);
    let focal = uniform(random, 0.5, 3.0);
    let points: Vec<Vector3<f64>> = (0..4).map(|_| in_ball(random)).collect();
    let images = points.iter().flat_map(|x| image(&(rotation * x + translation), focal).data.0[0]);
    let data = images.chain(flat(&points)).collect();
    Scene { data, truth: [pose(&rotation, &translation), vec![focal]].concat() }
}

/// Distorted image points (x, y, 1) of nine points; fundamental matrix and distortion.
pub(crate) fn nine_points_radial(random: &mut Random) -> Scene {
    let focal = [0; 2].map(|_| uniform(random, 2.0, 4.0));
    let radial = -uniform(random, 0.05, 0.5);
    let (rotation, translation, points) = two_cameras((random, Motion::General), 9);
    let see = |x: Vector3<f64>, focal: f64| distorted(image(&x, focal), radial).push(1.0);
    let first = points.iter().map(|&x| see(x, focal[0]));
    let images: Vec<Vector3<f64>> =
        first.chain(points.iter().map(|x| see(rotation * x + translation, focal[1]))).collect();
    let inverse = focal.map(|focal| Matrix3::from_diagonal(&Vector3::new(1.0 / focal, 1.0 / focal, 1.0)));
    let fundamental = inverse[1] * translation.cross_matrix() * rotation * inverse[0];
    Scene { data: flat(&images), truth: [rows(&fundamental), vec![radial]].concat() }
}

/// Centres up to half a unit from the origin and rays of length 1, in the first system and in the
/// second; pose.
pub(crate) fn six_points_generalized(random: &mut Random) -> Scene {
    let (rotation, translation, points) = two_cameras((random, Motion::General), 6);
    let mut data = Vec::new();
    let second: Vec<Vector3<f64>> = points.iter().map(|x| rotation * x + translation).collect();
    for seen in [&points, &second] {
        let centres: Vec<Vector3<f64>> = seen.iter().map(|_| 0.5 * in_ball(random)).collect();
        let rays: Vec<Vector3<f64>> = seen.iter().zip(&centres).map(|(x, centre)| (x - centre).normalize()).collect();
        data.extend(flat(&centres));
        data.extend(flat(&rays));
    }
    Scene { data, truth: pose(&rotation, &translation) }
}

/// Centres in the unit ball, rays of length 1, points; pose and a scale of 0.5 to 2.
pub(crate) fn four_points_scale(random: &mut Random) -> Scene {
    let (rotation, translation) = camera(random);
    let scale = uniform(random, 0.5, 2.0);
    let (centres, points): (Vec<_>, Vec<_>) = (0..4).map(|_| (in_ball(random), in_ball(random))).unzip();
    let ray = |(x, centre): (&Vector3<f64>, &Vector3<f64>)| (rotation * x + translation - scale * centre).normalize();
    let rays: Vec<Vector3<f64>> = points.iter().zip(&centres).map(ray).collect();
    let data = [flat(&centres), flat(&rays), flat(&points)].concat();
    Scene { data, truth: [pose(&rotation, &translation), vec![scale]].concat() }
}

/// Three quadrics with random coefficients through a point of \[-1, 1)^3, which is the solution.
pub(crate) fn quadrics(random: &mut Random) -> Scene {
    let [x, y, z] = [0; 3].map(|_| random.symmetric_unit());
    let monomials = [x * x, x * y, x * z, y * y, y * z, z * z, x, y, z];
    let mut data = Vec::new();
    for _ in 0..3 {
        let coefficients = monomials.map(|_| random.symmetric_unit());
        data.extend(coefficients);
        data.push(-coefficients.iter().zip(&monomials).map(|(c, m)| c * m).sum::<f64>());
    }
    Scene { data, truth: vec![x, y, z] }
}

/// Rays of length 1 and points; pose.
pub(crate) fn three_points(random: &mut Random) -> Scene {
    let (rotation, translation) = camera(random);
    let points: Vec<Vector3<f64>> = (0..3).map(|_| in_ball(random)).collect();
    let rays: Vec<Vector3<f64>> = points.iter().map(|x| (rotation * x + translation).normalize()).collect();
    Scene { data: [flat(&rays), flat(&points)].concat(), truth: pose(&rotation, &translation) }
}

/// Lines (a, b, c) with a normal (a, b) of length 1 that touch a circle; its centre and radius.
fn tangents(lines: &[Line], circle: &Circle) -> Scene {
    let data = lines.iter().flat_map(|line| [line.normal.x, line.normal.y, line.offset]).collect();
    Scene { data, truth: vec![circle.centre.x, circle.centre.y, circle.radius] }
}

/// Three tangents.
pub(crate) fn three_tangents(random: &mut Random) -> Scene {
    let circle = Circle::draw(random);
    tangents(&circle.tangents(random, 3), &circle)
}

/// Twenty tangents.
pub(crate) fn twenty_tangents(random: &mut Random) -> Scene {
    let circle = Circle::draw(random);
    tangents(&circle.tangents(random, 20), &circle)
}

/// Twenty tangents in coordinates in which their nearest point is the origin, at a root mean square
/// distance of 1.
pub(crate) fn twenty_normalised_tangents(random: &mut Random) -> Scene {
    let circle = Circle::draw(random);
    let (lines, circle) = normalised(&circle.tangents(random, 20), &circle);
    tangents(&lines, &circle)
}
