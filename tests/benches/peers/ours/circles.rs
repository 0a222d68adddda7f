//! Circles that touch lines. A line is a x + b y + c = 0.

use eliminant_cylinders::rectify::TangentLine;
use eliminant_cylinders::{ClosedForm, SectionLine, SectionShape, SectionSolver};
use eliminant_solvers::{circle_least_squares, circle_minimal};

use super::linear::{Vector, null_space};
use super::{Instance, vectors};

/// Twenty lines to the circles at which the least-squares cost is stationary.
pub(crate) struct LeastSquares([Vector; 20]);

impl Instance for LeastSquares {
    fn load(data: &[f64]) -> Self {
        Self(vectors(data))
    }

    /// The origin is moved to the point that is nearest to all lines.
    fn solve(&self, found: &mut Vec<f64>) {
        let (mut aa, mut ab, mut bb, mut ac, mut bc) = (0.0, 0.0, 0.0, 0.0, 0.0);
        let lines = self.0.map(|[a, b, c]| {
            let scale = (a * a + b * b).sqrt().recip();
            let [a, b, c] = [scale * a, scale * b, scale * c];
            aa += a * a;
            ab += a * b;
            bb += b * b;
            ac += a * c;
            bc += b * c;
            [a, b, c]
        });
        let inverse = (aa * bb - ab * ab).recip();
        let (x, y) = (inverse * (ab * bc - bb * ac), inverse * (ab * ac - aa * bc));
        let mut gram = [[0.0; 6]; 6];
        for [a, b, c] in lines {
            let c = c + a * x + b * y;
            let row = [a * a, a * b, a * c, b * b, b * c, c * c];
            for i in 0..6 {
                for j in i..6 {
                    gram[i][j] += row[i] * row[j];
                }
            }
        }
        for i in 0..6 {
            for j in 0..i {
                gram[i][j] = gram[j][i];
            }
        }
        let Ok(solutions) = circle_least_squares::solve(&gram) else { return };
        for s in solutions.iter() {
            let square = s.d1 + s.d3 * s.d3;
            if square > 0.0 {
                found.extend([x - s.d3, y - s.d5, square.sqrt()]);
            }
        }
    }
}

/// Three lines to the circles that touch them.
pub(crate) struct Minimal([Vector; 3]);

impl Instance for Minimal {
    fn load(data: &[f64]) -> Self {
        Self(vectors(data))
    }

    fn solve(&self, found: &mut Vec<f64>) {
        let rows = self.0.map(|[a, b, c]| [a * a, 2.0 * a * b, 2.0 * a * c, b * b, 2.0 * b * c, c * c]);
        let basis: [[f64; 6]; 3] = null_space(rows);
        let Ok(solutions) = circle_minimal::solve(&basis[0], &basis[1], &basis[2]) else { return };
        for s in solutions.iter() {
            let d: [f64; 6] = std::array::from_fn(|i| s.a * basis[0][i] + s.b * basis[1][i] + basis[2][i]);
            let scale = -d[5].recip();
            let (x, y) = (-scale * d[2], -scale * d[4]);
            let square = scale * d[0] + x * x;
            if square > 0.0 {
                found.extend([x, y, square.sqrt()]);
            }
        }
    }
}

/// Three lines to the circles that touch them, by the closed form behind the trait of all
/// cross-section solvers.
pub(crate) struct ClosedFormTrait([SectionLine; 3]);

impl Instance for ClosedFormTrait {
    fn load(data: &[f64]) -> Self {
        let lines: [Vector; 3] = vectors(data);
        Self(std::array::from_fn(|view| {
            let [a, b, c] = lines[view];
            SectionLine { line: TangentLine { normal: [a, b].into(), offset: c }, weight: 1.0, view }
        }))
    }

    fn solve(&self, found: &mut Vec<f64>) {
        let solver: &dyn SectionSolver = &ClosedForm;
        for section in solver.solve(&self.0).into_iter().flatten() {
            if let SectionShape::Circle(circle) = section.shape {
                found.extend([circle.centre.x, circle.centre.y, circle.radius]);
            }
        }
    }
}
