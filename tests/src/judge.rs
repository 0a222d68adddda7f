//! The points that a solver returns, judged by the equations of the problem at twice the precision.

use crate::equations::{Equations, Point};
use crate::statistics::distance;

/// A returned point approximates a solution if Newton's method leads from it to one at most this
/// far, relative to its norm. A point further away is spurious: the solver found it near no
/// solution.
const NEAR: f64 = 1e-2;
/// Exact solutions that are closer than this, relative to their norms, are one. They are known to
/// about 1e-16, and two of them are this close on no data that are drawn.
const SAME: f64 = 1e-11;

/// The judgement of the points returned by one solve.
#[derive(Clone, Debug, Default)]
pub struct Judgement {
    /// The number of different solutions that the points approximate.
    pub found: usize,
    /// The number of points that approximate a solution that another point approximates, too.
    pub duplicates: usize,
    /// The number of points near which there is no solution.
    pub spurious: usize,
    /// The relative residual of each point.
    pub residuals: Vec<f64>,
    /// The distance of each point that is not spurious from its solution, relative to its norm.
    pub errors: Vec<f64>,
}

/// Judges the points by the equations, and by all elements of the same solutions.
pub fn judge(equations: &Equations, points: &[Point], elements: &[Point]) -> Judgement {
    let residuals = elements.iter().map(|x| equations.residual_of_elements(x)).collect();
    let mut judgement = Judgement { residuals, ..Judgement::default() };
    let mut exact: Vec<Point> = Vec::new();
    for point in points {
        let refined = equations.refined(point);
        if !(refined.is_solution() && refined.moved <= NEAR) {
            judgement.spurious += 1;
            continue;
        }
        judgement.errors.push(refined.moved);
        match exact.iter().any(|known| distance(known, &refined.point) <= SAME) {
            true => judgement.duplicates += 1,
            false => exact.push(refined.point),
        }
    }
    judgement.found = exact.len();
    judgement
}

impl Judgement {
    /// The judgement of the points of both.
    pub fn plus(mut self, other: Self) -> Self {
        self.found += other.found;
        self.duplicates += other.duplicates;
        self.spurious += other.spurious;
        self.residuals.extend(other.residuals);
        self.errors.extend(other.errors);
        self
    }
}

#[cfg(test)]
mod tests {
    use eliminant::Complex;
    use eliminant_generator::problem::Problem;

    use super::*;

    /// x^2 = 2 and x y = 1 have two solutions.
    #[test]
    fn duplicates_and_spurious_points_are_counted() {
        let text = "fn squares(a: f64) -> (x, y) {\n    x * x == a;\n    x * y == 1;\n}\n";
        let problem = Problem::parse("squares.rs", text).unwrap_or_else(|messages| panic!("{}", messages.render()));
        let equations = Equations::new(&problem, &[2.0]).expect("no divisor");
        let root = 2f64.sqrt();
        let point = |x: f64, y: f64| vec![Complex::from(x), Complex::from(y)];
        let near = point(-root * (1.0 + 1e-7), -1.0 / root);
        let points = [point(root, 1.0 / root), near.clone(), point(-root, -1.0 / root), point(0.3, 3.0)];
        let judgement = judge(&equations, &points, &points);
        assert_eq!((judgement.found, judgement.duplicates, judgement.spurious), (2, 1, 1), "{judgement:?}");
        assert!(judgement.residuals[0] < 1e-15 && judgement.residuals[3] > 1e-2, "{judgement:?}");
        assert!((1e-8..1e-6).contains(&judgement.errors[1]), "{judgement:?}");
        let sum = judgement.clone().plus(judge(&equations, std::slice::from_ref(&near), std::slice::from_ref(&near)));
        assert_eq!((sum.found, sum.residuals.len(), sum.errors.len()), (3, 5, 4));
    }
}
