//! Circles and their tangents.

use eliminant_generator::algebra::Random;
use nalgebra::{SMatrix, Vector2};

use super::{KnownInstance, Make, Maker, null_space, relative_error, uniform};

pub(super) fn makers() -> Vec<Maker> {
    vec![
        Maker {
            name: "circle_least_squares",
            // The multipliers vanish with the cost.
            make: Make::Scene(|random| known_circle(random, |d| [&d[..], &[0.0; 2]].concat())),
            error: |_, solution, truth| relative_error(&solution[..5], &truth[..5]),
        },
        Maker {
            name: "circle_least_squares_dual",
            make: Make::Scene(|random| known_circle(random, |d| d[2..].to_vec())),
            error: |_, solution, truth| relative_error(solution, truth),
        },
        Maker {
            name: "circle_minimal",
            make: Make::Scene(|random| {
                let circle = Circle::draw(random);
                let lines = circle.tangents(random, 3);
                let (data, [d1, d2, d3, d4, d5]) = (minimal_data(&lines), circle.dual_conic());
                // The null vectors are orthonormal.
                let along = |k: usize| {
                    let pairs = data[6 * k..6 * k + 6].iter().zip([d1, d2, d3, d4, d5, -1.0]);
                    pairs.map(|(x, d)| x * d).sum::<f64>()
                };
                let truth = vec![along(0) / along(2), along(1) / along(2)];
                KnownInstance { data, truths: vec![truth] }
            }),
            error: |data, s, truth| relative_error(&minimal_conic(data, s), &minimal_conic(data, truth)),
        },
    ]
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

/// The null space of the tangency equations (a^2, 2ab, 2ac, b^2, 2bc, c^2) d = 0 of three lines:
/// d_alpha, d_beta, d_gamma.
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

/// Lines moved to the point nearest to all of them and scaled to a root mean square distance of 1
/// from it, and the circle with them.
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

/// The least-squares problem of 5 to 20 exact tangents, normalised: the circle is a stationary
/// point of cost 0.
fn known_circle(random: &mut Random, unknowns: impl Fn(&[f64; 5]) -> Vec<f64>) -> KnownInstance {
    let circle = Circle::draw(random);
    let count = 5 + random.below(16) as usize;
    let (lines, circle) = normalised(&circle.tangents(random, count), &circle);
    KnownInstance { data: gram(&lines), truths: vec![unknowns(&circle.dual_conic())] }
}

#[cfg(test)]
mod tests {
    use super::*;

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
}
