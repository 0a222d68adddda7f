//! Solutions that share a value of the action monomial, on action matrices made from solutions.
mod support;

use eliminant::emitted::{
    Fixed, Real, Sizes, SizesOf, SolverInstance, complex_solutions, monomial_values, real_solutions,
};
use eliminant::{Complex, Scalar, SolveError};
use nalgebra::SMatrix;
use support::{Random, distance_to_next};

const B: usize = 10;
type Point = [Complex<f64>; 2];

/// x^i y^j for the basis 1, x, y, x^2, x y, y^2, x^3, x^2 y, x y^2, y^3.
const BASIS: [(i32, i32); B] = [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2), (3, 0), (2, 1), (1, 2), (0, 3)];

/// Ten points of the plane.
struct Points([Point; B]);

/// Points with the values that the action has there. The polish improves nothing: it returns the
/// distance to the nearest point. So solutions are as accurate as the eigenvectors, and are found
/// where those have 10 digits.
struct Given<'a> {
    points: &'a Points,
    values: &'a [Complex<f64>; B],
}

/// The positions of (m, x m) and of (m, y m) in the basis.
const RATIOS: [&[(u16, u16)]; 2] =
    [&[(0, 1), (1, 3), (2, 4), (3, 6), (4, 7), (5, 8)], &[(0, 2), (1, 4), (2, 5), (3, 7), (4, 8), (5, 9)]];

impl SolverInstance for Given<'_> {
    type Basis = Fixed<B>;
    type Unknowns = Fixed<2>;
    type Values = Fixed<B>;
    type Solutions = Fixed<B>;

    fn sizes(&self) -> SizesOf<Self> {
        Sizes::FIXED
    }

    fn ratios(&self, unknown: usize) -> &[(u16, u16)] {
        RATIOS[unknown]
    }

    fn action_matrix<R: Real>(&mut self) -> Result<[[R; B]; B], SolveError> {
        Ok(action_matrix(&self.points.0, self.values).map(|row| row.map(R::from_f64)))
    }

    fn monomial_values<S: Scalar>(&self, _value: S, vector: &[S; B]) -> [S; B] {
        *vector
    }

    fn recover<S: Scalar>(&self, _unknowns: &mut [S; 2]) {}

    fn polish<S: Scalar>(&self, unknowns: &mut [S; 2], _steps: usize) -> f64 {
        distance_to_next(&self.points.0, unknowns)
    }

    fn is_admissible<S: Scalar>(&self, _unknowns: &[S; 2]) -> bool {
        true
    }
}

/// T = V diag(values) V^-1, V the basis at the points: real where both are closed under
/// conjugation.
fn action_matrix(points: &[Point; B], values: &[Complex<f64>; B]) -> [[f64; B]; B] {
    let v = SMatrix::<Complex<f64>, B, B>::from_fn(|i, k| {
        let [x, y] = points[k];
        x.powi(BASIS[i].0) * y.powi(BASIS[i].1)
    });
    let scaled = SMatrix::<Complex<f64>, B, B>::from_fn(|i, k| v[(i, k)] * values[k]);
    let matrix = v.transpose().lu().solve(&scaled.transpose()).unwrap().transpose();
    std::array::from_fn(|i| std::array::from_fn(|j| matrix[(i, j)].re))
}

/// `pairs` conjugate pairs of points in front, real points behind; a regular grid made irregular,
/// so that the points keep apart.
fn draw(random: &mut Random, pairs: usize) -> Points {
    let mut points = [[Complex::ZERO; 2]; B];
    for k in 0..B {
        let angle = k as f64 * std::f64::consts::TAU / 5.0;
        let radius = if k < 5 { 0.5 } else { 1.0 };
        let centre = [radius * angle.cos(), radius * angle.sin()];
        points[k] = centre.map(|c| Complex::from(c + 0.2 * random.symmetric()));
        if k < 2 * pairs {
            points[k] = match k % 2 {
                0 => points[k].map(|c| c + Complex::new(0.0, random.symmetric())),
                _ => points[k - 1].map(|c| c.conj()),
            };
        }
    }
    Points(points)
}

/// How many points with real coordinates `real_solutions` finds, and how many points
/// `complex_solutions` finds. Both must find nothing else.
fn found(points: &Points, values: &[Complex<f64>; B]) -> [usize; 2] {
    let mut given = Given { points, values };
    let real = real_solutions(&mut given).unwrap();
    let all = complex_solutions(&mut given).unwrap();
    let is = |p: &Point, x: &Point| (0..2).all(|j| (p[j] - x[j]).modulus() < 1e-9);
    [real.iter().map(|x| x.map(Complex::from)).collect::<Vec<_>>(), all.to_vec()].map(|list| {
        let known: Vec<&Point> = points.0.iter().filter(|p| list.iter().any(|x| is(p, x))).collect();
        assert_eq!(known.len(), list.len(), "{list:?}");
        known.len()
    })
}

/// On 200 systems: the values of the groups spread by `delta` each, conjugates accordingly, the
/// others apart. Returns how often a real solution was missing, and how often any.
fn missing(pairs: usize, groups: &[usize], delta: f64) -> [usize; 2] {
    let mut random = Random::new(1);
    let mut missing = [0; 2];
    for _ in 0..200 {
        let points = draw(&mut random, pairs);
        // With pairs, a group counts pairs.
        let step = if pairs > 0 { 2 } else { 1 };
        let height = if pairs > 0 { 0.5 } else { 0.0 };
        let mut values: [Complex<f64>; B] = std::array::from_fn(|k| {
            Complex::new(0.35 * (k - k % step) as f64 - 1.3, if k % step == 0 { height } else { -height })
        });
        let mut start = 0;
        for size in groups {
            for k in start..start + size * step {
                values[k].re = values[start].re + delta * ((k - start) / step) as f64;
            }
            start += size * step;
        }
        let [real, all] = found(&points, &values);
        missing[0] += usize::from(real < B - 2 * pairs);
        missing[1] += usize::from(all < B);
    }
    missing
}

/// Whether values are equal or only close: all solutions are found to 10 digits, up to a few
/// systems that are too ill conditioned.
#[test]
fn solutions_with_one_value_are_told_apart() {
    let cases: [(usize, &[usize]); 8] =
        [(0, &[2]), (0, &[2, 2]), (0, &[3]), (0, &[4, 3]), (0, &[6]), (5, &[2]), (5, &[2, 2]), (5, &[3])];
    for (pairs, groups) in cases {
        for delta in [0.0, 1e-15, 1e-13, 1e-11, 1e-9, 1e-7, 1e-5, 1e-4] {
            let [real, all] = missing(pairs, groups, delta);
            println!("{pairs} conjugate pairs, groups {groups:?}, {delta:e} apart: missing {real}, {all} of 200");
            assert!(real <= 10 && all <= 10, "{pairs} pairs, {groups:?}, {delta:e}: {real}, {all}");
        }
    }
}

/// A pair of conjugate solutions with a real value: a double real eigenvalue without a real
/// solution.
#[test]
fn conjugate_solutions_with_a_real_value() {
    let mut random = Random::new(2);
    let mut missing = 0;
    for _ in 0..200 {
        let points = draw(&mut random, 3);
        let values = std::array::from_fn(|k| {
            let own = if k < 6 { 0.7 * (k / 2) as f64 } else { 0.5 * k as f64 };
            Complex::from(own - 2.0)
        });
        let [real, all] = found(&points, &values);
        missing += usize::from(real < 4 || all < B);
    }
    assert!(missing <= 10, "{missing} of 200");
}

/// Two values of x with two points each, (1, 2), (1, -1/2) and (1/2, 1 + i), (1/2, 1 - i); basis 1,
/// x, y, x y; action x. The values of monomials are those of the basis, their images x m by the
/// action's value, and y^2, x y^2. The polish improves nothing.
struct ByImage {
    points: [Point; 4],
    action: [[f64; 4]; 4],
    read: [[f64; 4]; 2],
}

impl ByImage {
    fn new() -> Self {
        let point = |x: f64, re: f64, im: f64| [Complex::from(x), Complex::new(re, im)];
        let points = [point(1.0, 2.0, 0.0), point(1.0, -0.5, 0.0), point(0.5, 1.0, 1.0), point(0.5, 1.0, -1.0)];
        let basis = |[x, y]: Point| [Complex::ONE, x, y, x * y];
        let lu = SMatrix::<Complex<f64>, 4, 4>::from_fn(|k, i| basis(points[k])[i]).lu();
        // The monomial as a combination of the basis: real, because the points are closed under
        // conjugation.
        let combination = |monomial: fn(Point) -> Complex<f64>| -> [f64; 4] {
            let values = SMatrix::<Complex<f64>, 4, 1>::from_fn(|k, _| monomial(points[k]));
            let solution = lu.solve(&values).unwrap();
            std::array::from_fn(|i| solution[i].re)
        };
        let images: [fn(Point) -> Complex<f64>; 4] = [|[x, _]| x, |[x, _]| x * x, |[x, y]| x * y, |[x, y]| x * x * y];
        let read: [fn(Point) -> Complex<f64>; 2] = [|[_, y]| y * y, |[x, y]| x * y * y];
        ByImage { points, action: images.map(combination), read: read.map(combination) }
    }
}

impl SolverInstance for ByImage {
    type Basis = Fixed<4>;
    type Unknowns = Fixed<2>;
    type Values = Fixed<10>;
    type Solutions = Fixed<4>;

    fn sizes(&self) -> SizesOf<Self> {
        Sizes::FIXED
    }

    fn ratios(&self, unknown: usize) -> &[(u16, u16)] {
        [&[(0, 4), (1, 5), (2, 6), (3, 7)], &[(0, 2), (1, 3), (2, 8), (3, 9)]][unknown]
    }

    fn action_matrix<R: Real>(&mut self) -> Result<[[R; 4]; 4], SolveError> {
        Ok(self.action.map(|row| row.map(R::from_f64)))
    }

    fn monomial_values<S: Scalar>(&self, value: S, vector: &[S; 4]) -> [S; 10] {
        monomial_values(Fixed, (value, vector), true, &self.read)
    }

    fn recover<S: Scalar>(&self, _unknowns: &mut [S; 2]) {}

    fn polish<S: Scalar>(&self, unknowns: &mut [S; 2], _steps: usize) -> f64 {
        distance_to_next(&self.points, unknowns)
    }

    fn is_admissible<S: Scalar>(&self, _unknowns: &[S; 2]) -> bool {
        true
    }
}

/// A combination of eigenvectors has the action's value, too, which gives x.
#[test]
fn an_unknown_is_read_off_a_shared_value() {
    let mut instance = ByImage::new();
    let is = |p: &Point, x: &Point| (0..2).all(|j| (p[j] - x[j]).norm() < 1e-9);
    let all = complex_solutions(&mut instance).unwrap();
    assert_eq!(all.len(), 4, "{all:?}");
    assert!(instance.points.iter().all(|p| all.iter().any(|x| is(p, x))), "{all:?}");
    let real: Vec<Point> = real_solutions(&mut instance).unwrap().iter().map(|x| x.map(Complex::from)).collect();
    assert_eq!(real.len(), 2, "{real:?}");
    assert!(instance.points[..2].iter().all(|p| real.iter().any(|x| is(p, x))), "{real:?}");
}
