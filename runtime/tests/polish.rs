//! Table-driven systems, polish, extraction, and the lists of solutions.
mod support;

use eliminant::{Candidate, Complex, Product, Scalar, Solutions, System, Tables, Term, polish, push_distinct, ratio};
use support::Random;

const fn product(parent: u16, unknown: u16) -> Product {
    Product { parent, unknown }
}

const fn term(coefficient: u16, monomial: u16) -> Term {
    Term { coefficient, monomial }
}

/// Monomials 1, x, y, x^2, x y, y^2 and two conics with a coefficient slot for each of their terms.
const CONICS: Tables<2, 2, 6, 12> = Tables::new(
    &[product(0, 0), product(0, 0), product(0, 1), product(1, 0), product(1, 1), product(2, 1)],
    &[6, 12],
    &[
        term(0, 0),
        term(1, 1),
        term(2, 2),
        term(3, 3),
        term(4, 4),
        term(5, 5),
        term(6, 0),
        term(7, 1),
        term(8, 2),
        term(9, 3),
        term(10, 4),
        term(11, 5),
    ],
);

/// Three conics: one more equation than unknowns need.
const THREE: Tables<2, 3, 6, 18> = Tables::new(
    &[product(0, 0), product(0, 0), product(0, 1), product(1, 0), product(1, 1), product(2, 1)],
    &[6, 12, 18],
    &[
        term(0, 0),
        term(1, 1),
        term(2, 2),
        term(3, 3),
        term(4, 4),
        term(5, 5),
        term(6, 0),
        term(7, 1),
        term(8, 2),
        term(9, 3),
        term(10, 4),
        term(11, 5),
        term(12, 0),
        term(13, 1),
        term(14, 2),
        term(15, 3),
        term(16, 4),
        term(17, 5),
    ],
);

/// Conics through the point: random coefficients, the constant chosen.
fn through<const C: usize>(random: &mut Random, [x, y]: [f64; 2]) -> [f64; C] {
    let mut c: [f64; C] = std::array::from_fn(|_| random.symmetric());
    for conic in c.chunks_mut(6) {
        conic[0] = -(conic[1] * x + conic[2] * y + conic[3] * x * x + conic[4] * x * y + conic[5] * y * y);
    }
    c
}

#[test]
fn evaluation_is_that_of_the_written_out_polynomial() {
    let mut random = Random::new(1);
    let c: [f64; 12] = std::array::from_fn(|_| random.symmetric());
    let system = CONICS.bind(&c);
    let [x, y] = [0.75, -1.5];
    let (mut residual, mut scale, mut jacobian) = ([0.0; 2], [0.0; 2], [[0.0; 2]; 2]);
    system.evaluate(&[x, y], &mut residual, &mut scale, &mut jacobian);
    for e in 0..2 {
        let k = &c[6 * e..];
        let terms = [k[0], k[1] * x, k[2] * y, k[3] * x * x, k[4] * x * y, k[5] * y * y];
        assert!((residual[e] - terms.iter().sum::<f64>()).abs() < 1e-15);
        assert!((scale[e] - terms.iter().map(|t| t.abs()).sum::<f64>()).abs() < 1e-15);
        assert!((jacobian[e][0] - (k[1] + 2.0 * k[3] * x + k[4] * y)).abs() < 1e-15);
        assert!((jacobian[e][1] - (k[2] + k[4] * x + 2.0 * k[5] * y)).abs() < 1e-15);
    }
    let (mut again, mut scale_again) = ([0.0; 2], [0.0; 2]);
    system.residual(&[x, y], &mut again, &mut scale_again);
    assert_eq!((residual, scale), (again, scale_again));

    // A complex gradient agrees with a finite difference along the imaginary axis.
    let z = [Complex::new(0.75, 0.25), Complex::new(-1.5, 2.0)];
    let step = Complex::new(0.0, 1e-6);
    let (mut f, mut s, mut j) = ([Complex::ZERO; 2], [0.0; 2], [[Complex::ZERO; 2]; 2]);
    system.evaluate(&z, &mut f, &mut s, &mut j);
    let (mut f1, mut s1) = (f, s);
    system.residual(&[z[0] + step, z[1]], &mut f1, &mut s1);
    for e in 0..2 {
        assert!(((f1[e] - f[e]) / step - j[e][0]).modulus() < 1e-5);
    }
}

#[test]
fn polish_converges_quadratically_to_the_true_solution() {
    let mut random = Random::new(2);
    let mut far = 0;
    for _ in 0..2_000 {
        let exact = [random.symmetric(), random.symmetric()];
        let c: [f64; 12] = through(&mut random, exact);
        let system = CONICS.bind(&c);
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

/// Conics with real coefficients through a complex point: the constant and the coefficient of x are chosen.
fn through_complex<const C: usize>(random: &mut Random, [x, y]: [Complex<f64>; 2]) -> [f64; C] {
    let mut c: [f64; C] = std::array::from_fn(|_| random.symmetric());
    for conic in c.chunks_mut(6) {
        let rest = y * conic[2] + x * x * conic[3] + x * y * conic[4] + y * y * conic[5];
        conic[1] = -rest.im / x.im;
        conic[0] = -(rest.re + conic[1] * x.re);
    }
    c
}

/// How often the distance from a solution that is not real is not squared by each of two steps, of 1000 starts.
/// The Jacobian is complex, so that a reflection of the QR decomposition without conjugation does not annihilate.
fn not_squared<const E: usize, const C: usize>(tables: &Tables<2, E, 6, C>, seed: u64) -> usize {
    let mut random = Random::new(seed);
    let mut slow = 0;
    for _ in 0..1_000 {
        let exact = [0; 2].map(|_| Complex::new(random.symmetric(), 0.5 + 0.5 * random.unit()));
        let c: [f64; C] = through_complex(&mut random, exact);
        let start = exact.map(|z| z + Complex::new(random.symmetric(), random.symmetric()) * 1e-5);
        let distance_after = |steps: usize| {
            let mut z = start;
            polish(&mut z, &tables.bind(&c), steps);
            (0..2).map(|k| (z[k] - exact[k]).modulus()).fold(0.0, f64::max)
        };
        slow += usize::from(distance_after(1) > 1e-8 || distance_after(2) > 1e-13);
    }
    slow
}

#[test]
fn complex_solutions_are_approached_quadratically() {
    let slow = [not_squared(&CONICS, 7), not_squared(&THREE, 8)];
    println!("not squared on {slow:?} of 1000 each");
    // Conics that nearly touch in the point have a nearly singular Jacobian there: rare.
    assert!(slow.iter().all(|&slow| slow <= 5), "{slow:?} of 1000 each are slow");
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
        let system = CONICS.bind(&c);
        let start = [10.0 * random.symmetric(), 10.0 * random.symmetric()];
        let before = polish(&mut start.clone(), &system, 0);
        let mut x = start;
        let after = polish(&mut x, &system, 3);
        let residual = polish(&mut x.clone(), &system, 0);
        assert!(residual <= before);
        assert!(after == residual || (after == f64::INFINITY && residual > 1e-12));
    }
    let c = [1.0; 12];
    for bad in [f64::NAN, f64::INFINITY, 1e300] {
        let mut x = [bad, 1.0];
        assert_eq!(polish(&mut x, &CONICS.bind(&c), 3), f64::INFINITY);
        assert_eq!(x[1], 1.0);
        let mut z = [Complex::new(1.0, bad), Complex::ONE];
        assert_eq!(polish(&mut z, &CONICS.bind(&c), 3), f64::INFINITY);
    }
    assert_eq!(polish(&mut [1.0, 1.0], &CONICS.bind(&[f64::NAN; 12]), 3), f64::INFINITY);
    // All terms vanish: 0/0 counts as 0. Two equal conics: the Jacobian has rank one, and x stays.
    let origin = [0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0];
    assert_eq!(polish(&mut [0.0, 0.0], &CONICS.bind(&origin), 3), 0.0);
    let mut x = [0.3, 0.4];
    let equal = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
    assert!(polish(&mut x, &CONICS.bind(&equal), 3) > 0.1);
    assert_eq!(x, [0.3, 0.4]);
}

#[test]
fn double_solutions_are_approached() {
    // x^2 + y^2 = 2 and x + y = 2 touch in (1, 1).
    let c = [-2.0, 0.0, 0.0, 1.0, 0.0, 1.0, -2.0, 1.0, 1.0, 0.0, 0.0, 0.0];
    let mut x = [1.01, 0.98];
    let residual = polish(&mut x, &CONICS.bind(&c), 30);
    assert!(residual < 1e-12 && (x[0] - 1.0).abs() < 1e-5, "{residual:e} {x:?}");
}

/// Parabolas (x - y)^2 = x + y and (x - y)^2 = 2 x + 2 y + 1 with the same axis: far out on it the residual is small, but they meet
/// nowhere near.
#[test]
fn far_points_with_a_small_residual_are_no_solutions() {
    let coefficients = [0.0, -1.0, -1.0, 1.0, -2.0, 1.0, -1.0, -2.0, -2.0, 1.0, -2.0, 1.0];
    let system = CONICS.bind(&coefficients);
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

/// x y - 2 x = 0 and x + y - 1 = 0: at (0, 1) every term of the first equation vanishes, at (-1, 2) none does.
/// x^2 - y^2 + x + 1 = 0 and x^2 - y^2 + 2 y + 3 = 0 in multiples of a unit: a solution at infinity, along x = y. Far out the residual is rounding.
#[test]
fn points_at_infinity_are_no_solutions() {
    for (unit, distance) in [(1.0, 1e13), (1.0, 1e16), (1e-10, 1e3), (1e10, 1e26)] {
        let square = unit * unit;
        let c = [square, unit, 0.0, 1.0, 0.0, -1.0, 3.0 * square, 0.0, 2.0 * unit, 1.0, 0.0, -1.0];
        let (mut values, mut scale) = ([0.0; 2], [0.0; 2]);
        CONICS.bind(&c).residual(&[distance; 2], &mut values, &mut scale);
        assert!(
            values.iter().zip(&scale).all(|(value, scale)| value.abs() < 1e-12 * scale),
            "it looks like a solution"
        );
        assert_eq!(polish(&mut [distance; 2], &CONICS.bind(&c), 8), f64::INFINITY, "unit {unit}");
        let mut complex = [Complex::new(distance, 0.0); 2];
        assert_eq!(polish(&mut complex, &CONICS.bind(&c), 8), f64::INFINITY, "unit {unit}");
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
            assert!(polish(&mut x, &CONICS.bind(&c), 8) < 1e-12, "{truth:?}");
            assert!(x.iter().zip(&truth).all(|(x, truth)| (x - truth).abs() < 1e-6 * size), "{x:?} {truth:?}");
        }
    }
}

#[test]
fn an_unknown_that_is_zero_at_the_solution_does_not_hide_it() {
    let coefficients = [0.0, -2.0, 0.0, 0.0, 1.0, 0.0, -1.0, 1.0, 1.0, 0.0, 0.0, 0.0];
    for noise in [0.0, 1e-17, -3e-16, 1e-9] {
        let mut x = [noise, 1.0 + 1e-9];
        assert!(polish(&mut x, &CONICS.bind(&coefficients), 8) <= 1e-15, "{noise}: {x:?}");
        assert_eq!(x[0], 0.0);
        let mut x = [-1.0 + noise, 2.0];
        assert!(polish(&mut x, &CONICS.bind(&coefficients), 8) <= 1e-15);
        assert!((x[0] + 1.0).abs() < 1e-15);
    }
}

#[test]
fn ratios_of_monomial_values() {
    // v = (1, x, y, x y, x^2) times a common factor.
    let (x, y) = (Complex::new(2.0, -1.0), Complex::new(0.5, 3.0));
    let common = Complex::new(-0.3, 0.1);
    let v = [Complex::ONE, x, y, x * y, x * x].map(|value| value * common);
    let found = ratio(&v, &[(0, 1), (2, 3), (1, 4)]).unwrap();
    assert!((found - x).modulus() < 1e-15);
    assert_eq!(ratio(&[1.0, 3.0, 2.0, 6.0], &[(0, 1), (2, 3)]), Some(3.0));
    assert!((ratio(&[1e-60, 1.0], &[(0, 1)]).unwrap() - 1e60).abs() < 1e46, "whatever the units");
    assert_eq!(ratio(&[0.0, 0.0], &[(0, 1)]), None);
    assert_eq!(ratio(&[f64::NAN, 1.0], &[(0, 1)]), None);
    assert_eq!(ratio(&[1.0, f64::INFINITY], &[(0, 1)]), None);
    assert_eq!(ratio::<f64>(&[], &[]), None);
    assert_eq!(ratio(&[1.0], &[(0, 7)]), None);
}

#[test]
fn solutions_behave_like_a_slice_and_never_overflow() {
    let mut solutions = Solutions::<u32, 2>::new();
    assert!(solutions.is_empty());
    assert!(solutions.push(7) && solutions.push(8) && !solutions.push(9));
    assert_eq!(solutions.len(), 2);
    assert_eq!(solutions[1], 8);
    assert_eq!((&solutions).into_iter().sum::<u32>(), 15);
    assert_eq!(solutions.clone().into_iter().collect::<Vec<_>>(), [7, 8]);
    assert_eq!((0..10).collect::<Solutions<u32, 3>>().to_vec(), [0, 1, 2]);
    assert_eq!(solutions.map(|solution| solution > 7).to_vec(), [false, true]);
    assert_eq!(format!("{solutions:?}"), "Solutions([7, 8])");
}

#[test]
fn duplicates_keep_the_better_one() {
    let mut found = Solutions::<Candidate<f64, 2>, 3>::new();
    let candidate = |x: f64, y: f64, residual: f64| Candidate { unknowns: [x, y], residual };
    let mut push = |x: f64, y: f64, residual: f64| {
        let new = push_distinct(&mut found, candidate(x, y, residual), |_, _| 1.0);
        (new, found.to_vec())
    };
    assert!(push(1.0, 1e6, 1e-12).0);
    assert!(!push(1.0 + 1e-12, 1e6, 1e-15).0);
    assert_eq!(push(1.0 - 1e-12, 1e6, 1e-13), (false, vec![candidate(1.0 + 1e-12, 1e6, 1e-15)]));
    // They differ in the small unknown only, and are different all the same.
    assert!(push(-1.0, 1e6, 1e-15).0);
    // Noise instead of zero.
    assert!(push(1e-17, 1.0, 1e-15).0);
    assert!(!push(-3e-16, 1.0, 1e-16).0);
    // There is no room: one of the worst goes.
    let (new, all) = push(5.0, 5.0, 1e-15);
    assert!(!new && all.len() == 3, "not better");
    let (new, all) = push(5.0, 5.0, 0.0);
    assert!(new && all.len() == 3 && all.contains(&candidate(5.0, 5.0, 0.0)), "{all:?}");
    assert!(all.contains(&candidate(-3e-16, 1.0, 1e-16)), "{all:?}");
}

/// x^2 = e and y = 1: two solutions, or one for e = 0.
#[test]
fn close_solutions_are_one_where_the_equations_cannot_tell() {
    let distance = 1e-5;
    for (e, count) in [(0.0, 1), (distance * distance, 2)] {
        // x^2 + y - 1 - e = 0 and y - 1 = 0.
        let coefficients = [-1.0 - e, 0.0, 1.0, 1.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0];
        let system = CONICS.bind(&coefficients);
        let mut found = Solutions::<Candidate<f64, 2>, 4>::new();
        for x in [distance, -0.7 * distance, -distance] {
            let mut unknowns = [x, 1.0];
            let residual = polish(&mut unknowns, &system, 8);
            push_distinct(&mut found, Candidate { unknowns, residual }, |x, steps| polish(x, &system, steps));
        }
        assert_eq!(found.len(), count, "{found:?}");
        let truth = e.sqrt();
        assert!(found.iter().all(|candidate| (candidate.unknowns[0].abs() - truth).abs() < 1e-7), "{found:?}");
    }
}

/// x^4 = 10 from where Newton's step is forty times too long.
#[test]
fn a_step_that_is_too_long_is_shortened() {
    const POWER: Tables<1, 1, 5, 2> = Tables::new(
        &[product(0, 0), product(0, 0), product(1, 0), product(2, 0), product(3, 0)],
        &[2],
        &[term(0, 0), term(1, 4)],
    );
    let system = POWER.bind(&[-10.0, 1.0]);
    let mut x = [0.5];
    let residual = polish(&mut x, &system, 24);
    assert!(residual <= 1e-15 && (x[0] - 10.0_f64.powf(0.25)).abs() <= 1e-15 * x[0].abs(), "{x:?} {residual:e}");
}
