//! Solutions at which the Jacobian is close to singular, with all their digits.
mod support;

use eliminant::emitted::{DoubleDouble, Fixed, error_bound, polish_precisely};
use eliminant::{Complex, Scalar};
use support::Random;
use support::conics::{TWO, polish};

/// Two conics through a point, the second of which differs from the first by a conic times `angle`,
/// with coefficients at twice the precision.
struct NearlyTangent {
    point: [f64; 2],
    precise: [DoubleDouble; 12],
    rounded: [f64; 12],
}

impl NearlyTangent {
    fn new(angle: f64, random: &mut Random) -> Self {
        let [x, y] = [0, 1].map(|_| 0.5 + random.symmetric().abs());
        let number = DoubleDouble::from_f64;
        let monomials =
            [number(1.0), number(x), number(y), number(x) * number(x), number(x) * number(y), number(y) * number(y)];
        let mut through = || {
            let mut conic: [DoubleDouble; 6] = std::array::from_fn(|_| number(random.symmetric()));
            conic[0] = (1..6).fold(DoubleDouble::ZERO, |sum, k| sum - conic[k] * monomials[k]);
            conic
        };
        let (first, other) = (through(), through());
        let precise =
            std::array::from_fn(|k| if k < 6 { first[k] } else { first[k - 6] + other[k - 6] * number(angle) });
        Self { point: [x, y], precise, rounded: precise.map(|c| c.to_complex().re) }
    }

    /// The largest error of an unknown, relative to the largest unknown.
    fn error<S: Scalar>(&self, x: &[S; 2]) -> f64 {
        let largest = self.point[0].max(self.point[1]);
        (0..2).map(|j| (x[j] - S::from_f64(self.point[j])).modulus() / largest).fold(0.0, f64::max)
    }

    fn bound(&self, x: &[f64; 2]) -> f64 {
        error_bound::<f64, Fixed<2>, Fixed<2>>(x, (Fixed, Fixed), &TWO.bind(&self.rounded), &self.precise)
    }

    fn refined<S: Scalar>(&self, mut x: [S; 2]) -> ([S; 2], f64) {
        let system = TWO.bind(&self.rounded);
        let residual =
            polish_precisely::<S, Fixed<2>, Fixed<2>, _>(&mut x, (Fixed, Fixed), &system, 24, || self.precise);
        (x, residual)
    }
}

/// A point so far from the solution, relative to its size.
fn beside(point: [f64; 2], distance: f64, random: &mut Random) -> [f64; 2] {
    point.map(|x| x * (1.0 + distance * random.symmetric()))
}

#[test]
fn ill_conditioned_solutions_have_all_digits() {
    let mut random = Random::new(3);
    for angle in [1e-8, 1e-9, 1e-10] {
        let mut plain = Vec::new();
        for _ in 0..100 {
            let conics = NearlyTangent::new(angle, &mut random);
            let start = beside(conics.point, 1e-6, &mut random);
            let mut polished = start;
            polish(&mut polished, &TWO.bind(&conics.rounded), 24);
            plain.push(conics.error(&polished));
            let (x, residual) = conics.refined(start);
            assert!(conics.error(&x) < 1e-14 && residual < 1e-14, "{angle}: {x:?} {residual}");
            let (z, of_z) = conics.refined(start.map(|x| Complex::new(x, 1e-6 * x)));
            assert!(conics.error(&z) < 1e-14, "{angle}: {z:?} {of_z}");
        }
        plain.sort_by(f64::total_cmp);
        assert!(plain[50] > 1e-18 / angle, "without refinement {}", plain[50]);
    }
}

#[test]
fn well_conditioned_solutions_are_not_refined() {
    let mut random = Random::new(4);
    for _ in 0..100 {
        let conics = NearlyTangent::new(1.0, &mut random);
        let mut plain = beside(conics.point, 1e-6, &mut random);
        let (mut refined, system) = (plain, TWO.bind(&conics.rounded));
        polish(&mut plain, &system, 24);
        let unread: fn() -> [DoubleDouble; 12] = || panic!("the coefficients are not asked for");
        polish_precisely::<f64, Fixed<2>, Fixed<2>, _>(&mut refined, (Fixed, Fixed), &system, 24, unread);
        assert_eq!(plain, refined);
    }
}

#[test]
fn the_bound_is_above_the_error_and_close_to_it() {
    let mut random = Random::new(5);
    for angle in [1.0, 1e-3, 1e-6, 1e-9] {
        for distance in [1e-3, 1e-6, 1e-9, 1e-12] {
            for _ in 0..50 {
                let conics = NearlyTangent::new(angle, &mut random);
                let x = beside(conics.point, distance * angle, &mut random);
                let (error, bound) = (conics.error(&x), conics.bound(&x));
                assert!(bound >= error, "{angle} {distance}: {error} and {bound}");
                let is_known = bound < 2.0 * error + 1e-15;
                assert!(is_known || bound == f64::INFINITY, "{angle} {distance}: {error} and {bound}");
            }
        }
    }
}

#[test]
fn without_a_solution_near_by_there_is_no_bound() {
    let mut random = Random::new(6);
    let mut conics = NearlyTangent::new(0.0, &mut random);
    assert_eq!(conics.bound(&conics.point), f64::INFINITY, "both conics are the same");
    conics = NearlyTangent::new(1.0, &mut random);
    assert_eq!(conics.bound(&[f64::NAN, 1.0]), f64::INFINITY);
    // x^2 + y^2 + 1 = 0 and x = y have no real solution.
    let rounded = [1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0];
    let none = NearlyTangent { point: [0.0; 2], rounded, precise: rounded.map(DoubleDouble::from_f64) };
    assert_eq!(none.bound(&[0.3, 0.3]), f64::INFINITY);
}
