//! Eigenvalues and eigenvectors against nalgebra and known spectra.
mod support;

use eliminant::emitted::Hessenberg;
use eliminant::{Complex, Scalar, SolveError};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use support::Random;

fn norm<const N: usize>(a: &[[f64; N]; N]) -> f64 {
    a.as_flattened().iter().map(|v| v * v).sum::<f64>().sqrt()
}

/// |A v - value v| / |A|, v of length 1.
fn residual<S: Scalar, const N: usize>(a: &[[f64; N]; N], value: S, v: &[S; N]) -> f64 {
    let mut sum = 0.0;
    for i in 0..N {
        let mut entry = -value * v[i];
        for j in 0..N {
            entry += v[j].scale(a[i][j]);
        }
        sum += entry.modulus_squared();
    }
    sum.sqrt() / norm(a).max(f64::MIN_POSITIVE)
}

/// Worst residual over all eigenpairs, complex and, for real eigenvalues, real.
fn worst_residual<const N: usize>(a: &[[f64; N]; N]) -> f64 {
    let h = Hessenberg::reduce(a).unwrap();
    let values = h.eigenvalues().unwrap();
    let mut worst = 0.0_f64;
    for value in values {
        let v = h.eigenvector(value);
        let length: f64 = v.iter().map(|x| x.modulus_squared()).sum();
        assert!((length - 1.0).abs() < 1e-12, "length {length} for {value}");
        worst = worst.max(residual(a, value, &v));
        if value.im == 0.0 {
            worst = worst.max(residual(a, value.re, &h.eigenvector(value.re)));
        }
    }
    worst
}

/// Largest distance after matching each expected value with the nearest unused computed one.
fn distance(mut computed: Vec<Complex<f64>>, expected: &[Complex<f64>]) -> f64 {
    assert_eq!(computed.len(), expected.len());
    let mut worst = 0.0_f64;
    for value in expected {
        let gap = |z: &Complex<f64>| (z - value).modulus();
        let best = (0..computed.len()).min_by(|&i, &j| gap(&computed[i]).total_cmp(&gap(&computed[j]))).unwrap();
        worst = worst.max(gap(&computed.swap_remove(best)));
    }
    worst
}

fn agrees_with_nalgebra<const N: usize>(seed: u64, trials: usize) -> f64 {
    let mut random = Random::new(seed);
    let mut worst = 0.0_f64;
    let mut distances = Vec::new();
    for _ in 0..trials {
        let a: [[f64; N]; N] = random.matrix();
        let dynamic = nalgebra::DMatrix::from_fn(N, N, |i, j| a[i][j]);
        let oracle = nalgebra::Schur::try_new(dynamic, f64::EPSILON, 10_000).unwrap().complex_eigenvalues();
        let computed = Hessenberg::reduce(&a).unwrap().eigenvalues().unwrap();
        distances.push(distance(computed.to_vec(), oracle.as_slice()));
        worst = worst.max(worst_residual(&a));
    }
    distances.sort_by(f64::total_cmp);
    // Eigenvalues may be ill-conditioned, the residuals of eigenpairs may not be large.
    let rounding = N as f64 * f64::EPSILON * (N as f64 / 3.0_f64.sqrt());
    assert!(distances[trials / 2] < 10.0 * rounding, "{N}: median distance {:e}", distances[trials / 2]);
    assert!(distances[trials - 1] < 1e-6, "{N}: largest distance {:e}", distances[trials - 1]);
    assert!(worst < 20.0 * N as f64 * f64::EPSILON, "{N}: residual {worst:e}");
    worst
}

#[test]
fn random_matrices_agree_with_nalgebra() {
    agrees_with_nalgebra::<1>(1, 500);
    agrees_with_nalgebra::<2>(2, 500);
    agrees_with_nalgebra::<3>(3, 500);
    agrees_with_nalgebra::<4>(4, 500);
    agrees_with_nalgebra::<5>(5, 500);
    agrees_with_nalgebra::<6>(6, 500);
    agrees_with_nalgebra::<8>(8, 500);
    agrees_with_nalgebra::<9>(9, 500);
    agrees_with_nalgebra::<10>(10, 500);
    agrees_with_nalgebra::<13>(13, 300);
    agrees_with_nalgebra::<15>(15, 300);
    agrees_with_nalgebra::<20>(20, 300);
    agrees_with_nalgebra::<40>(40, 30);
}

/// The companion matrix of the monic polynomial with these lower coefficients.
fn companion<const N: usize>(lower: &[f64; N]) -> [[f64; N]; N] {
    let mut a = [[0.0; N]; N];
    for i in 0..N {
        a[i][N - 1] = -lower[i];
        if i > 0 {
            a[i][i - 1] = 1.0;
        }
    }
    a
}

#[test]
fn companion_matrices() {
    // (x - 1)(x - 2)..(x - 6)
    let lower = [720.0, -1764.0, 1624.0, -735.0, 175.0, -21.0];
    let h = Hessenberg::reduce(&companion(&lower)).unwrap();
    let expected: Vec<_> = (1..=6).map(|k| Complex::from_f64(f64::from(k))).collect();
    assert!(distance(h.eigenvalues().unwrap().to_vec(), &expected) < 1e-10);
    // Its norm is 50 times that of the balanced matrix, too little to balance it.
    assert!(worst_residual(&companion(&lower)) < 1e-14);

    // x^8 - 1: the cyclic permutation, orthogonal; without exceptional shifts the iteration stalls.
    let lower = [-1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let h = Hessenberg::reduce(&companion(&lower)).unwrap();
    let eighth = |k: u32| Complex::new(0.0, f64::from(k) * std::f64::consts::FRAC_PI_4);
    let expected: Vec<_> = (0..8).map(|k| Complex::new(eighth(k).im.cos(), eighth(k).im.sin())).collect();
    assert!(distance(h.eigenvalues().unwrap().to_vec(), &expected) < 1e-14);
    assert!(worst_residual(&companion(&lower)) < 1e-14);
}

#[test]
fn the_matrices_on_which_plain_shifts_stall() {
    let cyclic3 = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let cyclic4 = [[0.0, 0.0, 0.0, 1.0], [1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
    // Batterson and Day 1992: a fixed point of the Francis iteration with standard shifts.
    let batterson = [[0.0, 1.0, 0.0, 0.0], [1.0, 0.0, 1e-20, 0.0], [0.0, -1e-20, 0.0, 1.0], [0.0, 0.0, 1.0, 0.0]];
    assert!(worst_residual(&cyclic3) < 1e-15);
    assert!(worst_residual(&cyclic4) < 1e-15);
    assert!(worst_residual(&batterson) < 1e-15);
    let values = Hessenberg::reduce(&cyclic4).unwrap().eigenvalues().unwrap();
    assert!(values.iter().all(|value| (value.modulus() - 1.0).abs() < 1e-15));
}

#[test]
fn defective_zero_identity_and_triangular() {
    let mut jordan = [[0.0; 24]; 24];
    for i in 0..23 {
        jordan[i][i + 1] = 1.0;
    }
    assert!(worst_residual(&jordan) < 1e-14);
    assert!(Hessenberg::reduce(&jordan).unwrap().eigenvalues().unwrap().iter().all(|value| value.modulus() == 0.0));

    let zero = [[0.0; 5]; 5];
    assert_eq!(worst_residual(&zero), 0.0);
    let identity: [[f64; 5]; 5] = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))));
    assert!(worst_residual(&identity) < 1e-15);
    assert_eq!(worst_residual::<0>(&[]), 0.0);
    assert_eq!(Hessenberg::reduce(&[[3.5]]).unwrap().eigenvalues().unwrap(), [Complex::new(3.5, 0.0)]);

    // Diagonal 1..7, dense above: the eigenvalues are the diagonal, exactly.
    let mut random = Random::new(77);
    let mut triangular = random.matrix::<7, 7>();
    for i in 0..7 {
        triangular[i][i] = i as f64 + 1.0;
        for j in 0..i {
            triangular[i][j] = 0.0;
        }
    }
    let mut values = Hessenberg::reduce(&triangular).unwrap().eigenvalues().unwrap().map(|value| value.re);
    values.sort_by(f64::total_cmp);
    assert_eq!(values, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]);
    assert!(worst_residual(&triangular) < 1e-15);
}

#[test]
fn balancing_saves_the_small_eigenvalues_of_badly_scaled_matrices() {
    let mut random = Random::new(5);
    let mut worst = 0.0_f64;
    for _ in 0..200 {
        let a: [[f64; 8]; 8] = random.matrix();
        let scale: [f64; 8] = std::array::from_fn(|_| 10.0_f64.powf(8.0 * random.symmetric()));
        let scaled: [[f64; 8]; 8] = std::array::from_fn(|i| std::array::from_fn(|j| a[i][j] * scale[i] / scale[j]));
        let expected = Hessenberg::reduce(&a).unwrap().eigenvalues().unwrap();
        let computed = Hessenberg::reduce(&scaled).unwrap().eigenvalues().unwrap();
        worst = worst.max(distance(computed.to_vec(), &expected));
    }
    assert!(worst < 1e-9, "{worst:e}");
}

#[test]
fn extreme_units() {
    let mut random = Random::new(6);
    let a: [[f64; 6]; 6] = random.matrix();
    let expected = Hessenberg::reduce(&a).unwrap().eigenvalues().unwrap();
    for exponent in [-1000, -400, 400, 1000] {
        let unit = 2.0_f64.powi(exponent);
        let scaled = a.map(|row| row.map(|v| v * unit));
        let h = Hessenberg::reduce(&scaled).unwrap();
        let computed = h.eigenvalues().unwrap();
        let back: Vec<_> = computed.iter().map(|value| value / unit).collect();
        assert!(distance(back, &expected) < 1e-12);
        for value in computed {
            let v = h.eigenvector(value);
            assert!(residual(&a, value / unit, &v) < 1e-14);
        }
    }
    let subnormal = [[1e-310, 2e-310], [3e-310, 4e-310]];
    assert!(Hessenberg::reduce(&subnormal).unwrap().eigenvalues().is_ok());
    let huge = [[1e308, -1e308], [1e308, 1e308]];
    assert!(Hessenberg::reduce(&huge).unwrap().eigenvalues().is_ok());
}

#[test]
fn bad_input_is_refused() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for entry in 0..16 {
            let mut a = [[0.5; 4]; 4];
            a[entry / 4][entry % 4] = bad;
            assert_eq!(Hessenberg::reduce(&a).err(), Some(SolveError::Overflow));
        }
    }
}

/// The same cases every time.
fn config() -> ProptestConfig {
    ProptestConfig { cases: 10_000, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..Default::default() }
}

proptest! {
    #![proptest_config(config())]
    /// Whatever the finite entries, it ends; integer entries make clusters and defects likely.
    #[test]
    fn small_integer_matrices_have_small_residuals(entries in prop::array::uniform(prop::array::uniform(-2..3_i32))) {
        let a: [[f64; 6]; 6] = entries.map(|row: [i32; 6]| row.map(f64::from));
        let worst = worst_residual(&a);
        prop_assert!(worst < 5e-14, "{worst:e}");
    }

    #[test]
    fn any_finite_matrix_ends(a: [[f64; 5]; 5]) {
        if let Ok(h) = Hessenberg::reduce(&a) {
            let _ = h.eigenvalues();
        }
    }
}
