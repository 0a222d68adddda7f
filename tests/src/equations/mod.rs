//! The equations of a problem as stated, evaluated at twice the precision of `f64`: what the
//! emitted solvers are judged by. Neither the plan nor emitted code nor the runtime has a part in
//! it.

mod least_squares;
mod twice;

use std::collections::BTreeMap;

use eliminant::Complex;
use eliminant_generator::expression::arithmetic::Float64;
use eliminant_generator::problem::chart::entry;
use eliminant_generator::problem::{Problem, SolutionField};
use least_squares::least_squares;
use nalgebra::DMatrix;
use qd::Quad;
use twice::{Twice, Wide, exact};

/// A point with a complex value for each unknown.
pub type Point = Vec<Complex<f64>>;

/// The polynomials of a problem with its coefficients for given data.
pub struct Equations {
    unknowns: usize,
    /// What the unknowns stand for.
    fields: Vec<SolutionField>,
    /// All monomials. The first is the constant one, and each other one stands behind its parent.
    monomials: Vec<Product>,
    /// For each equation its coefficients and the positions of their monomials.
    equations: Vec<Vec<(Quad, usize)>>,
}

/// A monomial as its parent times an unknown; the constant monomial is its own parent.
struct Product {
    parent: usize,
    unknown: usize,
}

/// A point after Newton's method at twice the precision.
#[derive(Clone, Debug)]
pub struct Refined {
    /// The point, rounded.
    pub point: Point,
    /// How far it is from where it started, relative to its norm.
    pub moved: f64,
    /// The length of the last step, relative to its norm.
    pub last_step: f64,
    /// The relative residual.
    pub residual: f64,
}

/// An unknown this small, relative to the largest one, is the noise of 0: no term of an equation is
/// known to less, and the relative residual of an equation without larger terms means nothing.
const NOISE: f64 = 1e-25;
/// Steps of Newton's method at most. Two reach 31 digits from a point with 16 correct ones.
const STEPS: usize = 12;
/// A step this short, relative to the point, is the last one.
const SHORTEST_STEP: f64 = 1e-24;
/// A step this short, relative to the point, shows that the method converges.
const CONVERGED: f64 = 1e-12;
/// The relative residual of a solution. It is not 0 if there are more equations than unknowns and
/// the data satisfy a condition up to their rounding only, such as that of a rotation.
const EXACT: f64 = 1e-13;

impl Refined {
    /// Whether the method converges to a solution.
    pub fn is_solution(&self) -> bool {
        self.last_step <= CONVERGED && self.residual <= EXACT
    }
}

impl Equations {
    /// The equations for these data; `None` if a divisor vanishes.
    pub fn new(problem: &Problem, data: &[f64]) -> Option<Self> {
        // Derived data are as a solver has them, rounded.
        let data = problem.graph.all_inputs(Float64, data)?;
        let inputs: Vec<Quad> = data.iter().map(|&x| Quad(x, 0.0)).collect();
        let values = problem.graph.evaluate(Twice, &inputs)?;
        let unknowns = problem.unknowns.len();
        let mut monomials = Monomials::new(unknowns);
        let equations = problem.polynomials().map(|polynomial| {
            let terms = polynomial.terms().iter();
            terms.map(|(m, c)| (values[c.index()], monomials.position(&m.exponents()[..unknowns]))).collect()
        });
        let fields = problem.fields.clone();
        Some(Self { unknowns, fields, equations: equations.collect(), monomials: monomials.products })
    }

    /// The number of equations.
    pub fn len(&self) -> usize {
        self.equations.len()
    }

    /// Whether there are no equations.
    pub fn is_empty(&self) -> bool {
        self.equations.is_empty()
    }

    /// max over the equations of |f| / sum of the moduli of its terms. An equation whose terms all
    /// vanish counts as 0.
    pub fn residual(&self, x: &[Complex<f64>]) -> f64 {
        let x: Vec<Wide> = x.iter().map(|&x| x.into()).collect();
        relative_residual(&self.values(&x))
    }

    /// As [`Equations::residual`], from a solution as it is returned: vectors that are given up to
    /// scale by all elements. Their coordinates in a chart, in `f64`, would not keep the digits of
    /// elements that are small.
    pub fn residual_of_elements(&self, elements: &[Complex<f64>]) -> f64 {
        let (mut x, mut rest) = (Vec::with_capacity(self.unknowns), elements);
        for field in &self.fields {
            let (of_field, others) = rest.split_at(field.scalars());
            let of_field: Vec<Wide> = of_field.iter().map(|&x| x.into()).collect();
            match field.is_projective {
                true => x.extend(coordinates(&of_field)),
                false => x.extend(of_field),
            }
            rest = others;
        }
        relative_residual(&self.values(&x))
    }

    /// Newton's method from a point, by least squares where there are more equations than unknowns.
    /// The values of the equations are computed at twice the precision, so that the point it
    /// converges to is the solution with all its digits.
    pub fn refined(&self, x: &[Complex<f64>]) -> Refined {
        let mut point: Vec<Wide> = x.iter().map(|&x| x.into()).collect();
        let mut last_step = f64::INFINITY;
        for _ in 0..STEPS {
            let values = self.values(&point);
            let rounded: Point = point.iter().map(|x| x.rounded()).collect();
            let (matrix, right) = self.linearised(&rounded, &values);
            let Some(step) = least_squares(matrix, right) else {
                last_step = f64::INFINITY;
                break;
            };
            for (x, &step) in point.iter_mut().zip(&step) {
                *x = *x - step.into();
            }
            without_noise(&mut point);
            last_step = relative(norm(&step), &rounded);
            if last_step <= SHORTEST_STEP {
                break;
            }
        }
        let residual = relative_residual(&self.values(&point));
        let rounded: Point = point.iter().map(|x| x.rounded()).collect();
        let change: Point = point.iter().zip(x).map(|(&x, &start)| (x - start.into()).rounded()).collect();
        Refined { moved: relative(norm(&change), &rounded), last_step, residual, point: rounded }
    }

    /// The smallest singular value of the Jacobian, its rows divided by the sums of the moduli of
    /// the equations' terms, its columns multiplied by `scale`: a relative error e of each equation
    /// moves the solution by about e over this value, in units of `scale`.
    pub fn smallest_singular_value(&self, x: &[Complex<f64>], scale: &[f64]) -> f64 {
        let wide: Vec<Wide> = x.iter().map(|&x| x.into()).collect();
        let (rows, _) = self.linearised(x, &self.values(&wide));
        let matrix = DMatrix::from_fn(rows.len(), self.unknowns, |i, j| rows[i][j] * scale[j]);
        matrix.singular_values().iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// The value of each equation and the sum of the moduli of its terms.
    fn values(&self, x: &[Wide]) -> Vec<(Wide, f64)> {
        let mut monomials = vec![Wide::ONE; self.monomials.len()];
        for (at, &Product { parent, unknown }) in self.monomials.iter().enumerate().skip(1) {
            monomials[at] = monomials[parent] * x[unknown];
        }
        let sum = |terms: &Vec<(Quad, usize)>| {
            terms.iter().fold((Wide::ZERO, 0.0), |(sum, size), &(coefficient, at)| {
                let term = monomials[at].times(coefficient);
                (sum + term, size + term.rounded().norm())
            })
        };
        self.equations.iter().map(sum).collect()
    }

    /// The rows of the Jacobian and the values of the equations, divided by the sums of the moduli
    /// of their terms; where all terms of an equation vanish, by the largest entry of its gradient.
    fn linearised(&self, x: &[Complex<f64>], values: &[(Wide, f64)]) -> (Vec<Point>, Point) {
        let mut monomials = vec![Complex::ONE; self.monomials.len()];
        let mut gradients = vec![vec![Complex::ZERO; self.unknowns]; self.monomials.len()];
        for (at, &Product { parent, unknown }) in self.monomials.iter().enumerate().skip(1) {
            monomials[at] = monomials[parent] * x[unknown];
            gradients[at] = gradients[parent].iter().map(|derivative| derivative * x[unknown]).collect();
            gradients[at][unknown] += monomials[parent];
        }
        let row = |(terms, &(_, size)): (&Vec<(Quad, usize)>, &(Wide, f64))| {
            let mut row = vec![Complex::ZERO; self.unknowns];
            for &(coefficient, at) in terms {
                row.iter_mut().zip(&gradients[at]).for_each(|(entry, derivative)| *entry += derivative * coefficient.0);
            }
            let scale = if size > 0.0 { size } else { row.iter().map(|entry| entry.norm()).fold(0.0, f64::max) };
            if scale > 0.0 {
                row.iter_mut().for_each(|entry| *entry /= scale);
            }
            (row, scale)
        };
        let rows: Vec<(Point, f64)> = self.equations.iter().zip(values).map(row).collect();
        let divided = |(&(value, _), (_, scale)): (&(Wide, f64), &(Point, f64))| {
            if *scale > 0.0 { value.rounded() / *scale } else { value.rounded() }
        };
        let right = values.iter().zip(&rows).map(divided).collect();
        (rows.into_iter().map(|(row, _)| row).collect(), right)
    }
}

/// Monomials in the order in which they can be multiplied up.
struct Monomials {
    products: Vec<Product>,
    known: BTreeMap<Vec<i8>, usize>,
}

impl Monomials {
    fn new(unknowns: usize) -> Self {
        let constant = Product { parent: 0, unknown: 0 };
        Self { products: vec![constant], known: BTreeMap::from([(vec![0; unknowns], 0)]) }
    }

    /// Where a monomial stands. It is added with its parents if it is new.
    fn position(&mut self, exponents: &[i8]) -> usize {
        if let Some(&at) = self.known.get(exponents) {
            return at;
        }
        let unknown = exponents.iter().position(|&e| e > 0).expect("the constant monomial is known");
        let mut parent = exponents.to_vec();
        parent[unknown] -= 1;
        let product = Product { parent: self.position(&parent), unknown };
        self.products.push(product);
        self.known.insert(exponents.to_vec(), self.products.len() - 1);
        self.products.len() - 1
    }
}

/// The coordinates of a vector in the chart in which it is solved for: Q e, divided by its last
/// entry.
fn coordinates(vector: &[Wide]) -> Vec<Wide> {
    let size = vector.len();
    let product = |row: usize| {
        let term = |column: usize| {
            let (numerator, denominator) = entry(size, row, column);
            vector[column].times(exact(numerator) / exact(denominator))
        };
        (0..size).map(term).fold(Wide::ZERO, |sum, term| sum + term)
    };
    let scale = product(size - 1).reciprocal();
    (0..size - 1).map(|row| product(row) * scale).collect()
}

fn relative_residual(values: &[(Wide, f64)]) -> f64 {
    let relative = |&(value, size): &(Wide, f64)| if size == 0.0 { 0.0 } else { value.rounded().norm() / size };
    crate::statistics::worst(values.iter().map(relative))
}

/// Sets unknowns at the level of noise to 0.
fn without_noise(x: &mut [Wide]) {
    let largest = x.iter().map(|x| x.rounded().norm()).fold(0.0, f64::max);
    x.iter_mut().filter(|x| x.rounded().norm() <= NOISE * largest).for_each(|x| *x = Wide::ZERO);
}

/// A length relative to that of a point; as it is at the origin.
fn relative(length: f64, point: &[Complex<f64>]) -> f64 {
    let size = norm(point);
    if size > 0.0 { length / size } else { length }
}

fn norm(x: &[Complex<f64>]) -> f64 {
    x.iter().map(|x| x.norm_sqr()).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn problem(text: &str) -> Problem {
        Problem::parse("test.rs", text).unwrap_or_else(|messages| panic!("{}", messages.render()))
    }

    /// The root of x^2 = 2 to 31 digits: the value at the rounded root shows the digits that it
    /// lacks.
    #[test]
    fn residuals_below_the_precision_of_f64_are_seen() {
        let squares = problem("fn squares(a: f64, b: f64) -> (x, y) {\n    x * x == a;\n    x * y == b;\n}\n");
        let equations = Equations::new(&squares, &[2.0, 3.0]).expect("no divisor");
        let root = 2f64.sqrt();
        let start = [root, 3.0 / root].map(Complex::from);
        let residual = equations.residual(&start);
        assert!((1e-17..2e-16).contains(&residual), "{residual}");
        let refined = equations.refined(&[Complex::new(1.4, 0.0), Complex::new(2.1, 0.0)]);
        assert!(refined.is_solution() && refined.residual < 1e-30, "{refined:?}");
        assert!((refined.point[0] - start[0]).norm() < 1e-15 && refined.moved > 1e-3, "{refined:?}");
    }

    #[test]
    fn a_point_without_a_solution_near_by_is_told() {
        let parallel = problem("fn parallel(a: f64) -> (x, y) {\n    x * y == 1;\n    x * x * y == a;\n}\n");
        // The only solution is (a, 1/a). Far out with small residual: x y is nearly 0, and so is
        // the first equation's part.
        let equations = Equations::new(&parallel, &[0.5]).expect("no divisor");
        assert!(equations.refined(&[0.6, 1.8].map(Complex::from)).is_solution());
        let none = problem("fn none(a: f64) -> (x) {\n    x * x == a;\n    x * x == a + 1;\n}\n");
        let equations = Equations::new(&none, &[0.5]).expect("no divisor");
        assert!(!equations.refined(&[Complex::from(1.0)]).is_solution());
    }

    /// (x - 1)^2 + d (x - 1) has the roots 1 and 1 - d, with derivative d and terms of size 4.
    #[test]
    fn singular_values_measure_the_distance_from_a_double_solution() {
        let text = "fn close(d: f64) -> x {\n    x * x + (d - 2) * x + 1 - d == 0;\n}\n";
        for d in [1e-2, 1e-6] {
            let equations = Equations::new(&problem(text), &[d]).expect("no divisor");
            let value = equations.smallest_singular_value(&[Complex::ONE], &[1.0]);
            assert!((4.0 * value / d - 1.0).abs() < 1e-2, "{value}");
        }
    }

    #[test]
    fn complex_solutions_converge_quadratically() {
        let text = "fn both(a: f64) -> (x, y) {\n    x * x + y * y + x * y + a == 0;\n    x - 2 * y == 3;\n    x * x - 4 * y * y == 3 * x + 6 * y;\n}\n";
        let equations = Equations::new(&problem(text), &[5.0]).expect("no divisor");
        assert_eq!((equations.len(), equations.is_empty()), (3, false));
        // y = (-15 +- sqrt(225 - 4 * 7 * 14)) / 14, x = 3 + 2 y.
        let y = Complex::new(-15.0 / 14.0, 167f64.sqrt() / 14.0);
        let refined = equations.refined(&[Complex::new(0.9, 1.8), Complex::new(-1.1, 0.9)]);
        assert!(refined.is_solution() && refined.residual < 1e-30, "{refined:?}");
        assert!((refined.point[1] - y).norm() < 1e-15, "{refined:?}");
        assert!((refined.point[0] - (y * 2.0 + 3.0)).norm() < 1e-15, "{refined:?}");
    }
}
