//! Table-driven systems and their polish.
mod support;

use eliminant::emitted::{DenseSystem, Fixed, FixedTables, System, Term, Values};
use eliminant::{Complex, Scalar};
use support::Random;
use support::conics::{MONOMIALS, THREE, TWO, polish, product, term, terms, through, through_complex};
use support::rows::rows_of;

/// Values, scales and Jacobian at a point.
fn evaluate<S: Scalar>(
    system: &impl System<S, Fixed<2>, Fixed<2>>,
    x: &[S; 2],
    at: &mut Values<S, Fixed<2>>,
    jacobian: &mut [[S; 2]; 2],
) {
    let monomials = system.monomials(x);
    system.residual(&monomials, at);
    system.derivatives(x, &monomials, jacobian);
}

#[test]
fn evaluation_is_that_of_the_written_out_polynomial() {
    let mut random = Random::new(1);
    let c: [f64; 12] = std::array::from_fn(|_| random.symmetric());
    let system = TWO.bind(&c);
    let [x, y] = [0.75, -1.5];
    let (mut at, mut jacobian) = (Values::zero(Fixed::<2>), [[0.0; 2]; 2]);
    evaluate(&system, &[x, y], &mut at, &mut jacobian);
    let Values { residual, scale } = at;
    for e in 0..2 {
        let k = &c[6 * e..];
        let terms = [k[0], k[1] * x, k[2] * y, k[3] * x * x, k[4] * x * y, k[5] * y * y];
        assert!((residual[e] - terms.iter().sum::<f64>()).abs() < 1e-15);
        assert!((scale[e] - terms.iter().map(|t| t.abs()).sum::<f64>()).abs() < 1e-15);
        assert!((jacobian[0][e] - (k[1] + 2.0 * k[3] * x + k[4] * y)).abs() < 1e-15);
        assert!((jacobian[1][e] - (k[2] + k[4] * x + 2.0 * k[5] * y)).abs() < 1e-15);
    }
    let mut again = [0.0; 2];
    system.values(&system.monomials(&[x, y]), &mut again);
    assert_eq!(residual, again);

    // A complex gradient agrees with a finite difference along the imaginary axis.
    let z = [Complex::new(0.75, 0.25), Complex::new(-1.5, 2.0)];
    let step = Complex::new(0.0, 1e-6);
    let (mut f, mut moved) = (Values::zero(Fixed::<2>), Values::zero(Fixed::<2>));
    let mut j = [[Complex::ZERO; 2]; 2];
    evaluate(&system, &z, &mut f, &mut j);
    system.residual(&system.monomials(&[z[0] + step, z[1]]), &mut moved);
    for e in 0..2 {
        assert!(((moved.residual[e] - f.residual[e]) / step - j[0][e]).modulus() < 1e-5);
    }
}

/// Two conics, the second without x y and with its x^2 in two terms: the matrix has the values and
/// derivatives of the table.
#[test]
fn a_matrix_of_coefficients_evaluates_as_the_table_does() {
    const TERMS: [Term; 12] = {
        let mut terms = terms::<12>();
        terms[10] = term(10, 3);
        terms
    };
    const SYSTEM: FixedTables<2, 2, 6> = FixedTables::new::<12>(&MONOMIALS, &[6, 12], &TERMS);
    fn compare<S: Scalar>(c: &[f64; 12], x: [S; 2]) {
        let rows = rows_of(&SYSTEM, c);
        assert_eq!((rows[4][1], rows[3][1]), (0.0, c[9] + c[10]));
        let table = SYSTEM.bind(c);
        let matrix = DenseSystem { sizes: SYSTEM.sizes, monomials: SYSTEM, rows: &rows };
        let mut at = [(); 2].map(|()| Values::zero(Fixed::<2>));
        let (mut jacobians, mut again) = ([[[S::ZERO; 2]; 2]; 2], [S::ZERO; 2]);
        evaluate(&table, &x, &mut at[0], &mut jacobians[0]);
        evaluate(&matrix, &x, &mut at[1], &mut jacobians[1]);
        matrix.values(&matrix.monomials(&x), &mut again);
        let near = |a: S, b: S| (a - b).modulus() < 1e-15;
        for e in 0..2 {
            assert!(near(at[0].residual[e], at[1].residual[e]));
            assert!((0..2).all(|j| near(jacobians[0][j][e], jacobians[1][j][e])));
        }
        // The two terms in x^2 are one in the matrix.
        assert!((at[0].scale[0] - at[1].scale[0]).abs() < 1e-15 && at[1].scale[1] <= at[0].scale[1] + 1e-15);
        assert_eq!(at[1].residual, again);
    }
    let mut random = Random::new(11);
    for _ in 0..100 {
        let c: [f64; 12] = std::array::from_fn(|_| random.symmetric());
        compare(&c, [random.symmetric(), random.symmetric()]);
        compare(&c, [0, 1].map(|_| Complex::new(random.symmetric(), random.symmetric())));
        compare(&c, [0.0, random.symmetric()]);
    }
}

/// A polynomial exceeds a level if its modulus is larger than that part of the sum of the moduli of
/// its terms.
#[test]
fn levels_are_relative_to_the_terms() {
    const LINE: FixedTables<1, 1, 2> =
        FixedTables::new::<2>(&[product(0, 0), product(0, 0)], &[2], &[term(0, 0), term(1, 1)]);
    // 4 x - 1: half of the terms cancel at 3/4; all at 1/4.
    let system = LINE.bind(&[-1.0, 4.0]);
    assert!(system.exceeds(&[0.75], 0.49) && !system.exceeds(&[0.75], 0.5) && !system.exceeds(&[0.75], 0.51));
    assert!(!system.exceeds(&[0.25], 1e-15) && system.exceeds(&[0.26], 1e-3));
    assert!(system.exceeds(&[Complex::new(0.25, 1.0)], 0.7), "4 i of 1 and 1 + 4 i");
    // All of several must.
    let circles = [-1.0, 0.0, 0.0, 1.0, 0.0, 1.0, -4.0, 0.0, 0.0, 1.0, 0.0, 1.0];
    assert!(TWO.bind(&circles).exceeds(&[3.0, 0.0], 0.3) && !TWO.bind(&circles).exceeds(&[2.0, 0.0], 1e-8));
    assert!(!TWO.bind(&circles).exceeds(&[0.0, 1.0], 1e-8) && !TWO.bind(&circles).exceeds(&[f64::NAN, 1.0], 1e-8));
}

#[test]
fn polish_converges_quadratically_to_the_true_solution() {
    let mut random = Random::new(2);
    let mut far = 0;
    for _ in 0..2_000 {
        let exact = [random.symmetric(), random.symmetric()];
        let c: [f64; 12] = through(&mut random, exact);
        let system = TWO.bind(&c);
        let mut x = exact.map(|v| v * (1.0 + 1e-5 * random.symmetric()));
        let residual = polish(&mut x, &system, 6);
        far += usize::from(residual > 4e-16 || (0..2).any(|k| (x[k] - exact[k]).abs() > 1e-11));

        let mut z = exact.map(|v| Complex::new(v + 1e-6 * random.symmetric(), 1e-6 * random.symmetric()));
        let residual = polish(&mut z, &system, 6);
        far += usize::from(residual > 4e-16 || (0..2).any(|k| (z[k] - exact[k]).modulus() > 1e-11));
    }
    // Conics that touch in the point have a singular Jacobian there: rare.
    assert!(far <= 20, "{far} of 4000 stay away");
}

/// The Jacobian at a complex point is complex. One step squares the distance of 1e-4, also from
/// more equations than unknowns: the reflections of the least-squares solution must be unitary,
/// with conjugates.
#[test]
fn one_step_squares_the_distance_to_a_complex_solution() {
    let mut random = Random::new(21);
    let mut far = [0; 2];
    for _ in 0..1_000 {
        let exact = [0, 1].map(|_| Complex::new(random.symmetric(), 1.0 + 0.5 * random.symmetric()));
        let start = exact.map(|z| z + Complex::new(1e-4 * random.symmetric(), 1e-4 * random.symmetric()));
        let distance = |z: [Complex<f64>; 2]| (0..2).map(|k| (z[k] - exact[k]).norm()).fold(0.0, f64::max);
        let two = through_complex::<12>(&mut random, exact);
        let three = through_complex::<18>(&mut random, exact);
        let mut z = [start; 2];
        polish(&mut z[0], &TWO.bind(&two), 1);
        polish(&mut z[1], &THREE.bind(&three), 1);
        (0..2).for_each(|k| far[k] += usize::from(distance(z[k]) > 3e-7));
    }
    // Conics that nearly touch in the point have a nearly singular Jacobian there.
    assert!(far[0] <= 60 && far[1] <= 20, "{far:?} of 1000 stay away");
}

#[test]
fn overdetermined_systems_reach_the_common_solution() {
    let mut random = Random::new(3);
    let mut far = 0;
    for _ in 0..1_000 {
        let exact = [random.symmetric(), random.symmetric()];
        let mut c: [f64; 18] = through(&mut random, exact);
        // Equations in very different units.
        c[6..12].iter_mut().for_each(|v| *v *= 1e20);
        c[12..].iter_mut().for_each(|v| *v *= 1e-20);
        let mut x = exact.map(|v| v + 1e-4 * random.symmetric());
        let residual = polish(&mut x, &THREE.bind(&c), 6);
        far += usize::from(residual > 1e-15 || (0..2).any(|k| (x[k] - exact[k]).abs() > 1e-11));
    }
    assert!(far <= 5, "{far} of 1000 stay away");
}

#[test]
fn polish_never_raises_the_residual_and_survives_bad_values() {
    let mut random = Random::new(4);
    for _ in 0..2_000 {
        let c: [f64; 12] = std::array::from_fn(|_| random.symmetric());
        let system = TWO.bind(&c);
        let start = [10.0 * random.symmetric(), 10.0 * random.symmetric()];
        let before = polish(&mut start.clone(), &system, 0);
        let mut x = start;
        let after = polish(&mut x, &system, 3);
        let residual = polish(&mut x.clone(), &system, 0);
        assert!(residual <= before);
        // After a short step the scales are those of the point before it, at most 1e-3 away. The
        // degree is 2.
        let is_same = (after - residual).abs() <= 2.1e-3 * residual;
        assert!(is_same || (after == f64::INFINITY && residual > 1e-12), "{after} {residual}");
    }
    let c = [1.0; 12];
    for bad in [f64::NAN, f64::INFINITY, 1e300] {
        let mut x = [bad, 1.0];
        assert_eq!(polish(&mut x, &TWO.bind(&c), 3), f64::INFINITY);
        assert_eq!(x[1], 1.0);
        let mut z = [Complex::new(1.0, bad), Complex::ONE];
        assert_eq!(polish(&mut z, &TWO.bind(&c), 3), f64::INFINITY);
    }
    assert_eq!(polish(&mut [1.0, 1.0], &TWO.bind(&[f64::NAN; 12]), 3), f64::INFINITY);
    // All terms vanish: 0/0 counts as 0. Two equal conics: the Jacobian has rank one, and x stays.
    let origin = [0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0];
    assert_eq!(polish(&mut [0.0, 0.0], &TWO.bind(&origin), 3), 0.0);
    let mut x = [0.3, 0.4];
    let equal = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
    assert!(polish(&mut x, &TWO.bind(&equal), 3) > 0.1);
    assert_eq!(x, [0.3, 0.4]);
}

#[test]
fn double_solutions_are_approached() {
    // x^2 + y^2 = 2 and x + y = 2 touch in (1, 1).
    let c = [-2.0, 0.0, 0.0, 1.0, 0.0, 1.0, -2.0, 1.0, 1.0, 0.0, 0.0, 0.0];
    let mut x = [1.01, 0.98];
    let residual = polish(&mut x, &TWO.bind(&c), 30);
    assert!(residual < 1e-12 && (x[0] - 1.0).abs() < 1e-5, "{residual:e} {x:?}");
}

/// Parabolas (x - y)^2 = x + y and (x - y)^2 = 2 x + 2 y + 1 with the same axis: far out on it the
/// residual is small, but they do not meet there.
#[test]
fn far_points_with_a_small_residual_are_no_solutions() {
    let coefficients = [0.0, -1.0, -1.0, 1.0, -2.0, 1.0, -1.0, -2.0, -2.0, 1.0, -2.0, 1.0];
    let system = TWO.bind(&coefficients);
    for far in [1e9, -1e10, 1e11] {
        for apart in [1e-3, 1.0, -30.0] {
            let mut x = [far + apart, far];
            assert!(polish(&mut x, &system, 0) < 1e-8);
            let residual = polish(&mut x, &system, 8);
            let solves = residual <= 1e-15 && x[0].abs() < 1e3;
            assert!(solves || residual == f64::INFINITY, "{residual:e} at {x:?}");
        }
    }
}

/// x^2 - y^2 + x + 1 = 0 and x^2 - y^2 + 2 y + 3 = 0 in multiples of a unit have a solution at
/// infinity, along x = y. Far out the residual is rounding.
#[test]
fn points_at_infinity_are_no_solutions() {
    for (unit, distance) in [(1.0, 1e13), (1.0, 1e16), (1e-10, 1e3), (1e10, 1e26)] {
        let square = unit * unit;
        let c = [square, unit, 0.0, 1.0, 0.0, -1.0, 3.0 * square, 0.0, 2.0 * unit, 1.0, 0.0, -1.0];
        assert!(polish(&mut [distance; 2], &TWO.bind(&c), 0) < 1e-12, "it looks like a solution");
        assert_eq!(polish(&mut [distance; 2], &TWO.bind(&c), 8), f64::INFINITY, "unit {unit}");
        let mut complex = [Complex::new(distance, 0.0); 2];
        assert_eq!(polish(&mut complex, &TWO.bind(&c), 8), f64::INFINITY, "unit {unit}");
    }
}

#[test]
fn large_solutions_are_solutions() {
    let mut random = Random::new(6);
    for size in [1e6, 1e9, 1e14] {
        for _ in 0..100 {
            let truth = [size * random.symmetric(), -2.0 * size];
            let c: [f64; 12] = through(&mut random, truth);
            let mut x = truth.map(|x| x * (1.0 + 1e-9 * random.symmetric()));
            assert!(polish(&mut x, &TWO.bind(&c), 8) < 1e-12, "{truth:?}");
            assert!(x.iter().zip(&truth).all(|(x, truth)| (x - truth).abs() < 1e-6 * size), "{x:?} {truth:?}");
        }
    }
}

/// x y - 2 x = 0 and x + y - 1 = 0: every term of the first equation vanishes at (0, 1), and no
/// term at (-1, 2).
#[test]
fn an_unknown_that_is_zero_at_the_solution_does_not_hide_it() {
    let coefficients = [0.0, -2.0, 0.0, 0.0, 1.0, 0.0, -1.0, 1.0, 1.0, 0.0, 0.0, 0.0];
    for noise in [0.0, 1e-17, -3e-16, 1e-9] {
        let mut x = [noise, 1.0 + 1e-9];
        assert!(polish(&mut x, &TWO.bind(&coefficients), 8) <= 1e-15, "{noise}: {x:?}");
        assert_eq!(x[0], 0.0);
        let mut x = [-1.0 + noise, 2.0];
        assert!(polish(&mut x, &TWO.bind(&coefficients), 8) <= 1e-15);
        assert!((x[0] + 1.0).abs() < 1e-15);
    }
}

/// Two conics that are nearly the same meet where y = 0: errors of the equations are enlarged, and
/// y is known to 1e-11 or so only. From one step to the next all its digits change.
#[test]
fn a_zero_that_rounding_moves_is_a_solution() {
    let mut random = Random::new(12);
    for apart in [1e-3, 1e-4, 1e-5] {
        for _ in 0..300 {
            let truth = [random.symmetric(), 0.0];
            let [mut c, other]: [[f64; 12]; 2] = std::array::from_fn(|_| through(&mut random, truth));
            for k in 0..6 {
                c[6 + k] = c[k] + apart * other[k];
            }
            let mut x = [truth[0] + 1e-9, 1e-9];
            let residual = polish(&mut x, &TWO.bind(&c), 24);
            assert!(residual <= 1e-14 && x[1].abs() < 1e-7, "{apart:e} apart: {residual:e} at {x:?}");
        }
    }
}

/// x^4 = 10 from where Newton's step is forty times too long.
#[test]
fn a_step_that_is_too_long_is_shortened() {
    const POWER: FixedTables<1, 1, 5> = FixedTables::new::<2>(
        &[product(0, 0), product(0, 0), product(1, 0), product(2, 0), product(3, 0)],
        &[2],
        &[term(0, 0), term(1, 4)],
    );
    let system = POWER.bind(&[-10.0, 1.0]);
    let mut x = [0.5];
    let residual = polish(&mut x, &system, 24);
    assert!(residual <= 1e-15 && (x[0] - 10.0_f64.powf(0.25)).abs() <= 1e-15 * x[0].abs(), "{x:?} {residual:e}");
}

/// A step of less than a thousandth takes the scales of the equations from the point before. The
/// residual that is returned must not: it decides whether the point is a solution.
#[test]
fn the_residual_is_that_of_the_point_that_is_returned() {
    let mut random = Random::new(8);
    for _ in 0..200 {
        let c: [f64; 12] = std::array::from_fn(|_| random.symmetric());
        let system = TWO.bind(&c);
        let mut x = [random.symmetric(), random.symmetric()];
        for _ in 0..8 {
            let residual = polish(&mut x, &system, 1);
            if residual > 1e-12 && residual < f64::INFINITY {
                assert_eq!(residual, polish(&mut x.clone(), &system, 0));
            }
        }
    }
}
