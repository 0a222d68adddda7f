//! Solutions that differ by signs only, on an action matrix made from solutions up to sign.
mod support;

use eliminant::emitted::{Fixed, Real, Sizes, SizesOf, SolverInstance, Symmetries, complex_solutions, real_solutions};
use eliminant::{Complex, Scalar, SolveError};
use nalgebra::SMatrix;
use support::distance_to_next;

/// Monomials 1, x^2, x y, y^2.
const B: usize = 4;
/// Four times two signs.
const MAX: usize = 8;
type Point = [Complex<f64>; 2];

/// Points of the plane up to the sign of both coordinates; action x^2. The polish improves nothing:
/// it returns the distance to the nearest point.
struct UpToSign([Point; B]);

impl UpToSign {
    fn all(&self) -> Vec<Point> {
        self.0.iter().flat_map(|point| [*point, point.map(|x| -x)]).collect()
    }

    fn matrix(&self) -> [[f64; B]; B] {
        let v = SMatrix::<Complex<f64>, B, B>::from_fn(|i, k| {
            let [x, y] = self.0[k];
            [Complex::ONE, x * x, x * y, y * y][i]
        });
        let scaled = SMatrix::<Complex<f64>, B, B>::from_fn(|i, k| v[(i, k)] * self.0[k][0] * self.0[k][0]);
        let matrix = v.transpose().lu().solve(&scaled.transpose()).unwrap().transpose();
        std::array::from_fn(|i| std::array::from_fn(|j| matrix[(i, j)].re))
    }
}

impl SolverInstance for UpToSign {
    type Basis = Fixed<B>;
    type Unknowns = Fixed<2>;
    type Values = Fixed<B>;
    type Solutions = Fixed<MAX>;

    fn sizes(&self) -> SizesOf<Self> {
        Sizes::FIXED
    }

    fn ratios(&self, unknown: usize) -> &[(u16, u16)] {
        [&[(0, 1)], &[(0, 2)]][unknown]
    }

    fn symmetries(&self) -> Option<Symmetries<'_>> {
        Some(Symmetries { steps: &[&[2, 0], &[1, 1]], images: &[&[(0, true), (1, true)]] })
    }

    fn action_matrix<R: Real>(&mut self) -> Result<[[R; B]; B], SolveError> {
        Ok(self.matrix().map(|row| row.map(R::from_f64)))
    }

    fn monomial_values<S: Scalar>(&self, _value: S, vector: &[S; B]) -> [S; B] {
        *vector
    }

    fn recover<S: Scalar>(&self, _unknowns: &mut [S; 2]) {}

    fn polish<S: Scalar>(&self, unknowns: &mut [S; 2], _steps: usize) -> f64 {
        distance_to_next(&self.all(), unknowns)
    }

    fn is_admissible<S: Scalar>(&self, _unknowns: &[S; 2]) -> bool {
        true
    }
}

fn c(re: f64, im: f64) -> Complex<f64> {
    Complex { re, im }
}

#[test]
fn every_sign_of_every_solution_is_found() {
    // Real; imaginary, so that all that the eigenvector holds is real; and conjugates.
    let real = [c(2.0, 0.0), c(3.0, 0.0)];
    let imaginary = [c(0.0, 1.0), c(0.0, -2.0)];
    let complex = [c(1.0, 0.5), c(0.3, 2.0)];
    let mut points = UpToSign([real, imaginary, complex, complex.map(|x| x.conj())]);
    let is = |p: &Point, x: &Point| (0..2).all(|j| (p[j] - x[j]).norm() < 1e-9);

    let found = complex_solutions(&mut points).unwrap();
    assert_eq!(found.len(), MAX);
    assert!(points.all().iter().all(|p| found.iter().any(|x| is(p, x))), "{found:?}");

    let found = real_solutions(&mut points).unwrap();
    let found: Vec<Point> = found.iter().map(|x| x.map(Complex::from)).collect();
    assert_eq!(found.len(), 2);
    assert!([real, real.map(|x| -x)].iter().all(|p| found.iter().any(|x| is(p, x))), "{found:?}");
}
