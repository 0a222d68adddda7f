//! What the driver does with solutions that a problem excludes.

use eliminant::{ActionMethod, Complex, Scalar, Solutions, complex_solutions, real_solutions};

/// Solutions (x, y) with y = 1, 2; basis 1, y, x; action y. Excluded where x = 0.
struct TwoPoints {
    x: [f64; 2],
}

const B: usize = 2;

impl ActionMethod<B, 2, 3> for TwoPoints {
    const PAIRS: [&'static [(u16, u16)]; 2] = [&[(0, 2)], &[(0, 1)]];

    fn known<S: Scalar>(&self, _value: S, vector: &[S; B]) -> [S; 3] {
        // x is linear in 1 and y.
        let [first, second] = self.x;
        let x = vector[0].scale(2.0 * first - second) + vector[1].scale(second - first);
        [vector[0], vector[1], x]
    }

    fn recover<S: Scalar>(&self, _unknowns: &mut [S; 2]) {}

    fn polish<S: Scalar>(&self, unknowns: &mut [S; 2], _steps: usize) -> f64 {
        // The polish of a point gives it the x that it should have.
        let second = (unknowns[1].real() - 2.0).abs() < 0.5;
        unknowns[0] = S::from_f64(self.x[usize::from(second)]);
        0.0
    }

    fn is_admissible<S: Scalar>(&self, unknowns: &[S; 2]) -> bool {
        // As emitted: the factor x relative to its only term.
        unknowns[0].modulus() > 1e-8 * unknowns[0].modulus()
    }
}

#[test]
fn noise_of_zero_is_excluded_where_zero_is() {
    // 1, y -> y, 3 y - 2.
    let action = [[0.0, 1.0], [-2.0, 3.0]];
    for (x, count) in [([1.0, 3.0], 2), ([1.0, 0.0], 1), ([1.0, 1e-20], 1), ([-1e-17, 1e-20], 0), ([1.0, 1e-6], 2)] {
        let points = TwoPoints { x };
        let real: Solutions<[f64; 2], B> = real_solutions(&points, &action).unwrap();
        let all: Solutions<[Complex<f64>; 2], B> = complex_solutions(&points, &action).unwrap();
        assert_eq!((real.len(), all.len()), (count, count), "{x:?}: {real:?}");
    }
}
