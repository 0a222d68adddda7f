//! Instances whose solutions are known beforehand: geometry first, data from it.

use eliminant_generator::instance::Random;
use nalgebra::{DMatrix, Matrix3, Rotation3, SMatrix, Vector2, Vector3};

/// Data of a problem with solutions known from the way they were made.
pub struct KnownInstance {
    /// Flat data, as a [`crate::Case`] takes them.
    pub data: Vec<f64>,
    /// What the solver must find, in the terms of [`Maker::error`]; not always all solutions.
    pub truths: Vec<Vec<f64>>,
}

/// Makes instances of one problem.
pub struct Maker {
    /// Name of the problem.
    pub name: &'static str,
    /// Draws an instance.
    pub make: fn(&mut Random) -> KnownInstance,
    /// The relative error of a solution against a truth: `error(data, solution, truth)`.
    pub error: fn(&[f64], &[f64], &[f64]) -> f64,
}

/// One maker for every problem.
pub fn makers() -> Vec<Maker> {
    vec![
        Maker {
            name: "circle_least_squares",
            make: |random| known_circle(random, |d| d.to_vec()),
            error: |_, solution, truth| relative_error(&solution[..5], truth),
        },
        Maker {
            name: "circle_least_squares_dual",
            make: |random| known_circle(random, |d| d[2..].to_vec()),
            error: |_, solution, truth| relative_error(solution, truth),
        },
        Maker {
            name: "circle_minimal",
            make: |random| {
                let circle = Circle::draw(random);
                let lines = circle.tangents(random, 3);
                KnownInstance { data: minimal_data(&lines), truths: vec![circle.dual_conic().to_vec()] }
            },
            error: |data, solution, truth| relative_error(&minimal_conic(data, solution), truth),
        },
        Maker {
            name: "relpose_5pt",
            make: five_points,
            error: |data, s, truth| projective_error(&combination(data, &[s[0], s[1], s[2], 1.0]), truth),
        },
        Maker {
            name: "relpose_6pt_focal",
            make: six_points,
            error: |data, s, truth| {
                let fundamental = projective_error(&combination(data, &[1.0, s[0], s[1]]), &truth[..9]);
                fundamental.max(relative_error(&s[2..], &truth[9..]))
            },
        },
        Maker {
            name: "trilateration",
            make: distances_to_points,
            error: |_, solution, truth| relative_error(solution, truth),
        },
        Maker {
            name: "two_conics",
            make: conics_through_points,
            error: |_, solution, truth| relative_error(solution, truth),
        },
    ]
}

/// |x - truth| / |truth|.
pub fn relative_error(x: &[f64], truth: &[f64]) -> f64 {
    let square = |v: &mut dyn Iterator<Item = f64>| v.map(|x| x * x).sum::<f64>().sqrt();
    square(&mut x.iter().zip(truth).map(|(x, t)| x - t)) / square(&mut truth.iter().copied())
}

/// Distance of the unit vectors along x and truth, up to sign.
pub fn projective_error(x: &[f64], truth: &[f64]) -> f64 {
    let norm = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let (x_norm, truth_norm) = (norm(x), norm(truth));
    let unit: Vec<f64> = x.iter().map(|x| x / x_norm).collect();
    let [plus, minus] = [1.0, -1.0].map(|sign| {
        let truth: Vec<f64> = truth.iter().map(|t| sign * t / truth_norm).collect();
        relative_error(&unit, &truth)
    });
    plus.min(minus)
}

/// Sum of weight times matrix, the matrices 3x3 and stored one after another.
pub fn combination(matrices: &[f64], weights: &[f64]) -> Vec<f64> {
    (0..9).map(|i| weights.iter().zip(matrices.chunks(9)).map(|(w, m)| w * m[i]).sum()).collect()
}

/// A uniform number in [low, high).
pub fn uniform(random: &mut Random, low: f64, high: f64) -> f64 {
    low + (high - low) * 0.5 * (random.symmetric_unit() + 1.0)
}

/// Two conics of the pencil through four points in [-1, 1)^2: they meet in these points and nowhere else.
fn conics_through_points(random: &mut Random) -> KnownInstance {
    let points: Vec<Vec<f64>> = (0..4).map(|_| (0..2).map(|_| random.symmetric_unit()).collect()).collect();
    let rows: Vec<Vec<f64>> =
        points.iter().map(|p| vec![p[0] * p[0], p[0] * p[1], p[1] * p[1], p[0], p[1], 1.0]).collect();
    KnownInstance { data: null_space(&rows).concat(), truths: points }
}

/// Distances of a point of the unit ball from three others of it: the point and its mirror image.
fn distances_to_points(random: &mut Random) -> KnownInstance {
    let centres: Vec<Vector3<f64>> = (0..3).map(|_| in_ball(random)).collect();
    let point = in_ball(random);
    let normal = (centres[1] - centres[0]).cross(&(centres[2] - centres[0])).normalize();
    let image = point - normal * (2.0 * normal.dot(&(point - centres[0])));
    let distances = centres.iter().map(|centre| (centre - point).norm());
    let data = centres.iter().flat_map(|centre| centre.iter().copied()).chain(distances).collect();
    KnownInstance { data, truths: [point, image].map(|x| x.as_slice().to_vec()).to_vec() }
}

/// A circle in the plane.
#[derive(Clone, Copy, Debug)]
pub struct Circle {
    /// Centre.
    pub centre: Vector2<f64>,
    /// Radius.
    pub radius: f64,
}

/// The line normal . x + offset = 0, |normal| = 1.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    /// Unit normal.
    pub normal: Vector2<f64>,
    /// Minus the signed distance of the line from the origin.
    pub offset: f64,
}

impl Circle {
    /// Centre in [0, 10)^2, radius in [1, 2).
    pub fn draw(random: &mut Random) -> Self {
        let centre = Vector2::from_fn(|_, _| uniform(random, 0.0, 10.0));
        Self { centre, radius: uniform(random, 1.0, 2.0) }
    }

    /// (d1, .., d5) of the dual conic [d1 d2 d3; d2 d4 d5; d3 d5 -1].
    pub fn dual_conic(&self) -> [f64; 5] {
        let (x, y, square) = (self.centre.x, self.centre.y, self.radius * self.radius);
        [square - x * x, -x * y, -x, square - y * y, -y]
    }

    /// Tangents at uniformly drawn angles.
    pub fn tangents(&self, random: &mut Random, count: usize) -> Vec<Line> {
        let tangent = |_| {
            let angle = uniform(random, 0.0, std::f64::consts::TAU);
            let normal = Vector2::new(angle.cos(), angle.sin());
            Line { normal, offset: self.radius - normal.dot(&self.centre) }
        };
        (0..count).map(tangent).collect()
    }
}

/// The null space of the tangency equations (a^2, 2ab, 2ac, b^2, 2bc, c^2) d = 0 of three lines: d_alpha, d_beta, d_gamma.
pub fn minimal_data(lines: &[Line]) -> Vec<f64> {
    let row = |line: &Line| {
        let (a, b, c) = (line.normal.x, line.normal.y, line.offset);
        vec![a * a, 2.0 * a * b, 2.0 * a * c, b * b, 2.0 * b * c, c * c]
    };
    null_space(&lines.iter().map(row).collect::<Vec<_>>()).concat()
}

/// The dual conic (d1, .., d5), d6 = -1, of the solution (a, b) for these null vectors.
pub fn minimal_conic(data: &[f64], solution: &[f64]) -> Vec<f64> {
    let d: Vec<f64> = (0..6).map(|i| solution[0] * data[i] + solution[1] * data[6 + i] + data[12 + i]).collect();
    d[..5].iter().map(|x| x / -d[5]).collect()
}

/// Lines moved to the point nearest to all of them and scaled to a root mean square distance of 1 from it, and the circle with them.
pub fn normalised(lines: &[Line], circle: &Circle) -> (Vec<Line>, Circle) {
    let matrix: SMatrix<f64, 2, 2> = lines.iter().map(|line| line.normal * line.normal.transpose()).sum();
    let right: Vector2<f64> = lines.iter().map(|line| -line.normal * line.offset).sum();
    let nearest = matrix.lu().solve(&right).expect("random lines are not parallel");
    let moved: Vec<f64> = lines.iter().map(|line| line.offset + line.normal.dot(&nearest)).collect();
    let scale = (moved.iter().map(|offset| offset * offset).sum::<f64>() / lines.len() as f64).sqrt();
    let lines = lines.iter().zip(&moved).map(|(line, &offset)| Line { offset: offset / scale, ..*line }).collect();
    (lines, Circle { centre: (circle.centre - nearest) / scale, radius: circle.radius / scale })
}

/// The 6x6 Gram matrix of the rows (a^2, ab, ac, b^2, bc, c^2).
pub fn gram(lines: &[Line]) -> Vec<f64> {
    let mut gram = vec![0.0; 36];
    for line in lines {
        let (a, b, c) = (line.normal.x, line.normal.y, line.offset);
        let row = [a * a, a * b, a * c, b * b, b * c, c * c];
        for (at, entry) in gram.iter_mut().enumerate() {
            *entry += row[at / 6] * row[at % 6];
        }
    }
    gram
}

/// The least-squares problem of 5 to 20 exact tangents, normalised: the circle is a stationary point of cost 0.
fn known_circle(random: &mut Random, unknowns: impl Fn(&[f64; 5]) -> Vec<f64>) -> KnownInstance {
    let circle = Circle::draw(random);
    let count = 5 + random.below(16) as usize;
    let (lines, circle) = normalised(&circle.tangents(random, count), &circle);
    KnownInstance { data: gram(&lines), truths: vec![unknowns(&circle.dual_conic())] }
}

/// Two cameras 2 to 6 units from a ball of radius 1, looking at points inside the ball of half its radius, so that their
/// optical axes do not meet: rotation and translation from the first camera's coordinates to the second's, and points in
/// the first's.
fn two_cameras(random: &mut Random, points: usize) -> (Matrix3<f64>, Vector3<f64>, Vec<Vector3<f64>>) {
    let mut camera = || {
        let direction = in_ball(random).normalize();
        let centre = direction * uniform(random, 2.0, 6.0);
        let up = in_ball(random);
        let rotation = Rotation3::look_at_lh(&(0.5 * in_ball(random) - centre), &up).into_inner();
        (rotation, -rotation * centre)
    };
    let ((r1, t1), (r2, t2)) = (camera(), camera());
    let rotation = r2 * r1.transpose();
    let points = (0..points).map(|_| r1 * in_ball(random) + t1).collect();
    (rotation, t2 - rotation * t1, points)
}

/// A uniform point of the unit ball, not at its very centre.
fn in_ball(random: &mut Random) -> Vector3<f64> {
    loop {
        let point = Vector3::from_fn(|_, _| random.symmetric_unit());
        if (0.01..1.0).contains(&point.norm()) {
            return point;
        }
    }
}

/// x2^T M x1 = 0 as a row in the nine entries of M, row by row.
fn epipolar_row(x1: &Vector3<f64>, x2: &Vector3<f64>) -> Vec<f64> {
    (0..9).map(|at| x2[at / 3] * x1[at % 3]).collect()
}

/// `count` points seen by two cameras with focal length `focal`: the null space of the epipolar equations, and the
/// fundamental matrix.
fn epipolar(random: &mut Random, count: usize, focal: f64) -> (Vec<f64>, Vec<f64>) {
    let (rotation, translation, points) = two_cameras(random, count);
    let image = |point: &Vector3<f64>| Vector3::new(focal * point.x / point.z, focal * point.y / point.z, 1.0);
    let rows: Vec<Vec<f64>> =
        points.iter().map(|x| epipolar_row(&image(x), &image(&(rotation * x + translation)))).collect();
    let inverse = Matrix3::from_diagonal(&Vector3::new(1.0 / focal, 1.0 / focal, 1.0));
    let fundamental = inverse * translation.cross_matrix() * rotation * inverse;
    (null_space(&rows).concat(), fundamental.transpose().as_slice().to_vec())
}

fn five_points(random: &mut Random) -> KnownInstance {
    let (data, essential) = epipolar(random, 5, 1.0);
    KnownInstance { data, truths: vec![essential] }
}

/// Focal lengths of 0.5 to 3 times the unit of the image coordinates, which reach up to about one focal length.
fn six_points(random: &mut Random) -> KnownInstance {
    let focal = uniform(random, 0.5, 3.0);
    let (data, mut truth) = epipolar(random, 6, focal);
    truth.push(1.0 / (focal * focal));
    KnownInstance { data, truths: vec![truth] }
}

/// An orthonormal basis of the null space of independent rows.
pub fn null_space(rows: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let columns = rows.first().map_or(0, Vec::len);
    // Square: the thin decomposition has no null vectors.
    let matrix = DMatrix::from_fn(columns, columns, |i, j| rows.get(i).map_or(0.0, |row| row[j]));
    let right = matrix.svd(false, true).v_t.expect("asked for");
    (rows.len()..columns).map(|i| right.row(i).iter().copied().collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_in_front_of_both_cameras() {
        let mut random = Random::new(1);
        for _ in 0..1000 {
            let (rotation, translation, points) = two_cameras(&mut random, 6);
            assert!((rotation.determinant() - 1.0).abs() < 1e-12);
            assert!((rotation * rotation.transpose() - Matrix3::identity()).norm() < 1e-12);
            for point in points {
                assert!(point.z > 0.0 && (rotation * point + translation).z > 0.0);
            }
        }
    }

    #[test]
    fn tangents_touch_their_circle_also_when_normalised() {
        let mut random = Random::new(2);
        for _ in 0..1000 {
            let circle = Circle::draw(&mut random);
            let lines = circle.tangents(&mut random, 5);
            let (moved, scaled) = normalised(&lines, &circle);
            for (lines, circle) in [(lines, circle), (moved, scaled)] {
                for line in lines {
                    let distance = (line.normal.dot(&circle.centre) + line.offset).abs();
                    assert!((distance - circle.radius).abs() < 1e-10 * circle.radius.max(circle.centre.norm()));
                }
            }
        }
    }

    #[test]
    fn null_spaces_are_orthonormal_and_null() {
        let mut random = Random::new(3);
        let rows: Vec<Vec<f64>> = (0..5).map(|_| (0..9).map(|_| random.symmetric_unit()).collect()).collect();
        let basis = null_space(&rows);
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        assert_eq!(basis.len(), 4);
        for (i, vector) in basis.iter().enumerate() {
            assert!(rows.iter().all(|row| dot(row, vector).abs() < 1e-14));
            assert!((0..4).all(|j| (dot(vector, &basis[j]) - f64::from(u8::from(i == j))).abs() < 1e-14));
        }
    }
}
