//! What the polish does with a step, on functions whose values are chosen: where it stops, what it
//! keeps, and which limits count.

use std::cell::Cell;

use eliminant::emitted::{Fixed, Matrix, System, Values, polish};
use eliminant::{Complex, Scalar};

/// Relative residuals at most this are rounding, as in the polish.
const ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Residuals at most this may have no other cause than rounding.
const STALLED: f64 = 1e-12;
/// Unknowns this small relative to the largest one may be noise.
const NOISE: f64 = 1e-12;

/// Values, scales and Jacobian of E equations in N unknowns are given as functions. It counts the
/// evaluations.
struct Chosen<const N: usize, const E: usize, F, J> {
    values: F,
    scale: [f64; E],
    jacobian: J,
    jacobians: Cell<usize>,
    residuals: Cell<usize>,
}

impl<const N: usize, const E: usize, F: Fn([f64; N]) -> [f64; E], J: Fn([f64; N]) -> [[f64; N]; E]> Chosen<N, E, F, J> {
    fn new(values: F, jacobian: J) -> Self {
        Self { values, scale: [1.0; E], jacobian, jacobians: Cell::new(0), residuals: Cell::new(0) }
    }

    /// The polished point, its residual, and the numbers of Jacobians and of residuals computed.
    fn polish(&self, mut x: [f64; N], steps: usize) -> ([f64; N], f64, [usize; 2]) {
        self.jacobians.set(0);
        self.residuals.set(0);
        let residual = polish(&mut x, (Fixed::<N>, Fixed::<E>), self, steps);
        (x, residual, [self.jacobians.get(), self.residuals.get()])
    }
}

impl<const N: usize, const E: usize, F: Fn([f64; N]) -> [f64; E], J: Fn([f64; N]) -> [[f64; N]; E]>
    System<f64, Fixed<N>, Fixed<E>> for Chosen<N, E, F, J>
{
    type Monomials = [f64; N];

    fn monomials(&self, x: &[f64; N]) -> [f64; N] {
        *x
    }

    fn residual(&self, x: &[f64; N], at: &mut Values<f64, Fixed<E>>) {
        self.values(x, &mut at.residual);
        at.scale = self.scale;
    }

    fn values(&self, x: &[f64; N], residual: &mut [f64; E]) {
        self.residuals.update(|count| count + 1);
        *residual = (self.values)(*x);
    }

    fn derivatives(&self, x: &[f64; N], _: &[f64; N], columns: &mut Matrix<Fixed<N>, Fixed<E>, f64>) {
        self.jacobians.update(|count| count + 1);
        let jacobian = (self.jacobian)(*x);
        *columns = std::array::from_fn(|j| jacobian.map(|row| row[j]));
    }
}

/// One equation whose slope at x = 1 makes the first step lead to `next`.
fn towards(next: f64, value: impl Fn(f64) -> f64) -> impl Fn([f64; 1], usize) -> ([f64; 1], f64, [usize; 2]) {
    let slope = value(1.0) / (1.0 - next);
    let chosen = Chosen::new(move |[x]: [f64; 1]| [value(x)], move |_| [[slope]]);
    move |x, steps| chosen.polish(x, steps)
}

#[test]
fn a_point_at_rounding_level_stays() {
    let at = |level: f64| towards(1.25, move |x| if x == 1.0 { level } else { 0.0 })([1.0], 8);
    // The Jacobian is asked for the condition only.
    assert_eq!(at(ROUNDING), ([1.0], ROUNDING, [1, 1]));
    assert_eq!(at(1.25 * ROUNDING).0, [1.25]);
    assert_eq!(at(f64::INFINITY).0, [1.0]);
}

/// After a step the polish ends at rounding level, except after a long step: one more then shows
/// whether it stays.
#[test]
fn a_step_to_rounding_level_is_the_last_one_unless_it_is_long() {
    let value = |x: f64| if x == 1.0 { 1.0 } else { ROUNDING };
    assert_eq!(towards(1.0625, value)([1.0], 8), ([1.0625], ROUNDING, [1, 2]));
    // The second step is so short that its residual is known.
    let long = towards(1.25, value)([1.0], 8);
    assert!((long.0[0] - 1.25).abs() < 1e-15 && long.1 <= ROUNDING && long.2 == [2, 2], "{long:?}");
    let still_above = |x: f64| if x == 1.0 { 1.0 } else { 1.5 * ROUNDING };
    assert_eq!(towards(1.0625, still_above)([1.0], 8).2, [2, 2]);
}

/// After a step whose square is rounding the residual is not evaluated, unless the linear equations
/// leave something over or enlarge errors.
#[test]
fn the_residual_after_a_short_step_is_known() {
    let short = 2.0_f64.powi(-30);
    let line = |step: f64, factor: f64| {
        let value = move |[x]: [f64; 1]| [factor * (x - 1.0 - step)];
        Chosen::new(value, move |_| [[factor]]).polish([1.0], 8)
    };
    let (x, residual, counts) = line(short, 1.0);
    assert_eq!((x, counts), ([1.0 + short], [1, 1]));
    assert!(residual <= ROUNDING && residual >= 50.0 * short * short, "{residual}");
    assert_eq!(line(16.0 * short, 1.0).2, [1, 2]);
    assert_eq!(line(short, 2.0_f64.powi(-8)).2, [1, 2]);
    let two = |other: f64| {
        let value = move |[x]: [f64; 1]| [x - 1.0 - short, other];
        Chosen::new(value, |_| [[1.0], [0.0]]).polish([1.0], 1)
    };
    assert_eq!((two(0.5 * ROUNDING).2, two(2.0 * ROUNDING).2), ([1, 1], [1, 2]));
}

/// A step that leaves a high residual as it is is tried with noise set to zero, then shortened six
/// times, by 0.35 each.
#[test]
fn a_step_that_does_not_lower_the_residual_is_shortened() {
    let constant = towards(1.5, |_| 1.0)([1.0], 8);
    assert_eq!((constant.0, constant.2), ([1.0], [1, 9]));
    let first = towards(1.5, |x| if x == 1.0 || x == 1.5 { 1.0 } else { 0.5 })([1.0], 1);
    assert_eq!((first.0, first.2), ([1.0 + 0.5 * 0.35], [1, 4]));
    let last = towards(1.5, |x| if x > 1.0 && x < 1.001 { 0.5 } else { 1.0 })([1.0], 1);
    assert_eq!(last.2, [1, 9]);
    assert!((last.0[0] - (1.0 + 0.5 * 0.35_f64.powi(6))).abs() < 1e-15, "{last:?}");
    // A step that lowers it is taken at once.
    assert_eq!(towards(1.0625, |x| if x == 1.0 { 1.0 } else { 0.5 })([1.0], 1).2, [1, 2]);
}

#[test]
fn a_residual_that_may_be_rounding_is_worth_one_attempt_only() {
    let at = |level: f64| towards(1.0625, move |x| if x == 1.0 { level } else { 1.0 })([1.0], 8);
    assert_eq!(at(STALLED), ([1.0], STALLED, [1, 2]));
    assert_eq!(at(1.25 * STALLED), ([1.0], 1.25 * STALLED, [1, 9]));
}

/// A long last step shows that no solution is near if the residual is above rounding level, or
/// stays below 1e-6.
#[test]
fn a_long_step_tells_a_flat_direction_from_a_badly_determined_solution() {
    let at = |here: f64, there: f64, without: f64| {
        let value = move |x: f64| match x {
            1.0 => here,
            1.5 => there,
            0.0 => without,
            _ => 1.0,
        };
        let (x, residual, _) = towards(1.5, value)([1.0], 1);
        assert_eq!(x, [1.0]);
        residual
    };
    assert_eq!(at(1.25 * STALLED, 1.0, 1.0), f64::INFINITY);
    assert_eq!(at(STALLED, 1e-6, 1.0), f64::INFINITY, "the direction is flat");
    assert_eq!(at(STALLED, 1.25e-6, 1.0), STALLED, "the direction is not");
    assert_eq!(at(STALLED, 1e-6, STALLED), STALLED, "the unknown is free");
    assert_eq!(at(STALLED, 1e-6, 1.25 * STALLED), f64::INFINITY);
}

/// A step of this size from this point, which lowers nothing, shows that there is no solution. The
/// other unknown is 1024.
fn shows_none(start: f64, step: f64) -> bool {
    let chosen = Chosen::new(move |_: [f64; 2]| [step, 0.0], |_| [[1.0, 0.0], [0.0, 1.0]]);
    let (x, residual, _) = chosen.polish([start, 1024.0], 1);
    assert_eq!(x, [start, 1024.0]);
    residual == f64::INFINITY
}

/// A long step is one by more than a tenth of the unknown, up to noise.
#[test]
fn how_long_a_step_is_depends_on_the_unknown() {
    for start in [0.1, 1.0, 10.0, -10.0] {
        let longest = 0.1 * f64::abs(start) + NOISE * 1024.0;
        assert!(shows_none(start, longest.next_up()) && !shows_none(start, longest), "{start}");
        assert!(shows_none(start, -longest.next_up()) && !shows_none(start, -longest), "{start}");
    }
}

#[test]
fn a_step_within_the_noise_of_zero_is_not_long() {
    let noise = NOISE * 1024.0;
    assert!(shows_none(0.0, noise.next_up()) && !shows_none(0.0, noise));
}

/// Noise in an unknown beside one of 1024 is set to zero if a step does not lower the residual.
#[test]
fn unknowns_at_the_level_of_noise_are_set_to_zero() {
    let reached = |noise: f64| {
        let values = move |[x, _]: [f64; 2]| [if x == 0.0 { 0.0 } else { noise }, 0.0];
        // The step halves the first unknown, to `noise`.
        let chosen = Chosen::new(values, |_| [[1.0, 0.0], [0.0, 1.0]]);
        chosen.polish([2.0 * noise, 1024.0], 1).0[0]
    };
    let noise = NOISE * 1024.0;
    assert_eq!([noise, 0.5 * noise, 0.01 * noise].map(reached), [0.0; 3]);
    assert_eq!(reached(noise.next_up()), 2.0 * noise.next_up());
}

/// Points of a million and above are none if half of them solves the equations as well.
#[test]
fn large_points_are_compared_with_half_of_them() {
    let at = |x: f64, half: f64| {
        let chosen = Chosen::new(move |[at]: [f64; 1]| [if at == x { 0.0 } else { half }], |_| [[1.0]]);
        chosen.polish([x], 4).1
    };
    assert_eq!(at(1e6, STALLED), f64::INFINITY);
    assert_eq!(at(-3e6, 0.0), f64::INFINITY);
    assert_eq!(at(1e6, 1.25 * STALLED), 0.0);
    assert_eq!(at(0.99e6, 0.0), 0.0);
    // Only large unknowns are halved.
    let chosen = Chosen::new(
        |[x, y]: [f64; 2]| [if x == 1e7 { 0.0 } else { 1.0 }, if y == 1.0 { 0.0 } else { 1.0 }],
        |_| [[1.0, 0.0], [0.0, 1.0]],
    );
    assert_eq!(chosen.polish([1e7, 1.0], 4).1, 0.0);
    let chosen = Chosen::new(|[_, y]: [f64; 2]| [0.0, if y == 1.0 { 0.0 } else { 1.0 }], |_| [[1.0, 0.0], [0.0, 1.0]]);
    assert_eq!(chosen.polish([1e7, 1.0], 4).1, f64::INFINITY);
}

#[test]
fn values_that_are_not_finite_are_no_residual() {
    for (value, scale) in [(1.0, f64::INFINITY), (f64::NAN, 1.0), (f64::INFINITY, 1.0), (1.0, f64::NAN)] {
        let mut chosen = Chosen::new(move |_: [f64; 1]| [value], |_| [[1.0]]);
        chosen.scale = [scale];
        assert_eq!(chosen.polish([1.0], 0).1, f64::INFINITY, "{value} of {scale}");
        assert_eq!(chosen.polish([1.0], 3), ([1.0], f64::INFINITY, [0, 1]), "{value} of {scale}");
    }
    // The largest counts, wherever it is.
    let mut chosen = Chosen::new(|_: [f64; 1]| [3.0, -8.0, 1.0], |_| [[1.0]; 3]);
    chosen.scale = [2.0, 4.0, 1.0];
    assert_eq!(chosen.polish([1.0], 0).1, 2.0);
}

/// Equations count with one over their scale: residuals 1 and 3 of scales 1 and 10, both of slope
/// 1.
#[test]
fn equations_are_weighted_by_their_scale() {
    let mut chosen = Chosen::new(|[x]: [f64; 1]| if x == 1.0 { [1.0, 3.0] } else { [0.0; 2] }, |_| [[1.0], [1.0]]);
    chosen.scale = [1.0, 10.0];
    let expected = 1.0 - (1.0 + 0.03) / (1.0 + 0.01);
    assert!((chosen.polish([1.0], 1).0[0] - expected).abs() < 1e-15);
}

#[test]
fn an_equation_that_vanishes_with_its_gradient_does_not_count() {
    let mut chosen = Chosen::new(|[x]: [f64; 1]| [x - 2.0, 0.0], |_| [[1.0], [0.0]]);
    chosen.scale = [1.0, 0.0];
    assert_eq!(chosen.polish([1.9], 4), ([2.0], 0.0, [1, 2]));
    // If only the terms vanish, the gradient gives the weight.
    let mut chosen = Chosen::new(|[x, y]: [f64; 2]| [x - 2.0, 0.0 * y], |_| [[1.0, 0.0], [1e200, 1e200]]);
    chosen.scale = [1.0, 0.0];
    let ([x, y], ..) = chosen.polish([1.9, 1.0], 1);
    assert!((x - 2.0).abs() < 1e-15 && (y - 0.9).abs() < 1e-15, "{x} {y}");
}

/// A linear system is solved by one step, whatever its matrix: A x = b with a consistent b.
struct Linear<S, const N: usize, const E: usize> {
    matrix: [[S; N]; E],
    right: [S; E],
}

impl<S: Scalar, const N: usize, const E: usize> System<S, Fixed<N>, Fixed<E>> for Linear<S, N, E> {
    type Monomials = [S; N];

    fn monomials(&self, x: &[S; N]) -> [S; N] {
        *x
    }

    fn values(&self, x: &[S; N], residual: &mut [S; E]) {
        let mut at = Values::zero(Fixed);
        self.residual(x, &mut at);
        *residual = at.residual;
    }

    fn derivatives(&self, _: &[S; N], _: &[S; N], columns: &mut [[S; E]; N]) {
        *columns = std::array::from_fn(|j| self.matrix.map(|row| row[j]));
    }

    fn residual(&self, x: &[S; N], at: &mut Values<S, Fixed<E>>) {
        for e in 0..E {
            (at.residual[e], at.scale[e]) = (-self.right[e], self.right[e].modulus());
            for j in 0..N {
                let term = self.matrix[e][j] * x[j];
                at.residual[e] += term;
                at.scale[e] += term.modulus();
            }
        }
    }
}

/// How far one step from zeros leads from the solution.
fn distance_after_one_step<S: Scalar, const N: usize, const E: usize>(matrix: [[S; N]; E], solution: [S; N]) -> f64 {
    let right = matrix.map(|row| (0..N).fold(S::ZERO, |sum, j| sum + row[j] * solution[j]));
    let mut x = [S::ONE; N];
    polish(&mut x, (Fixed::<N>, Fixed::<E>), &Linear { matrix, right }, 1);
    (0..N).map(|j| (x[j] - solution[j]).modulus()).fold(0.0, f64::max)
}

#[test]
fn linear_systems_are_solved_in_one_step() {
    // Zeros at the head of columns leave the sign of the reflection open.
    assert!(distance_after_one_step([[0.0, 2.0], [3.0, 0.0]], [5.0, -7.0]) < 1e-14);
    assert!(distance_after_one_step([[0.0, 2.0, 1.0], [0.0, 0.0, 4.0], [3.0, 1.0, 0.0]], [5.0, -7.0, 0.5]) < 1e-13);
    let i = Complex::<f64>::I;
    let [zero, one] = [Complex::ZERO, Complex::ONE];
    assert!(distance_after_one_step([[zero, i], [one * 3.0, zero]], [one * 5.0, i * 2.0 - 7.0]) < 1e-14);
    let matrix = [[one, i, one - i], [i * 2.0, one, zero], [one + i, zero, i], [i, i, one], [one - i * 3.0, one, i]];
    assert!(distance_after_one_step(matrix, [one * 5.0, i * 2.0 - 7.0, i + 0.5]) < 1e-13);
}

#[test]
fn too_few_equations_and_lost_rank_change_nothing() {
    let few = Chosen::new(|_: [f64; 2]| [1.0], |_| [[1.0, 1.0]]);
    let (x, residual, _) = few.polish([1.0, 2.0], 4);
    assert_eq!((x, residual), ([1.0, 2.0], 1.0));
    let values = |_: [f64; 2]| [1.0, 0.5];
    let lost = Chosen::new(values, |_| [[1.0, 1.0], [1.0, 1.0 + f64::EPSILON]]);
    assert_eq!(lost.polish([1.0, 2.0], 4).0, [1.0, 2.0]);
    let kept =
        Chosen::new(|[_, y]: [f64; 2]| [if y > 2.0 { 0.0 } else { 1.0 }, 0.0], |_| [[1.0, 1.0], [1.0, 1.0 + 1e-14]]);
    assert_ne!(kept.polish([1.0, 2.0], 4).0, [1.0, 2.0]);
}
