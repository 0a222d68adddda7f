//! Elimination against exact answers, backward errors and nalgebra.
mod support;

use eliminant::emitted::{BlockError, BlockMemory, solve_block, solve_block_trailing, solve_large_block};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use support::Random;

/// max over columns of |A x - b| / (|A| |x| + |b|), row by row: the componentwise backward error.
fn backward_error<const N: usize, const M: usize>(a: &[[f64; N]; N], x: &[[f64; M]], b: &[[f64; M]; N]) -> f64 {
    let mut worst = 0.0_f64;
    for i in 0..N {
        for m in 0..M {
            let (mut sum, mut size) = (-b[i][m], b[i][m].abs());
            // The bound of partial pivoting is normwise in the row: |a_i| |x| with norms.
            let row = a[i].iter().map(|v| v.abs()).fold(0.0, f64::max);
            let column = (0..N).map(|j| x[j][m].abs()).fold(0.0, f64::max);
            for j in 0..N {
                sum += a[i][j] * x[j][m];
            }
            size += row * column * N as f64;
            if size > 0.0 {
                worst = worst.max(sum.abs() / size);
            }
        }
    }
    worst
}

fn random_matrices_have_small_backward_error<const N: usize, const M: usize>(seed: u64) {
    let mut random = Random::new(seed);
    for _ in 0..200 {
        let (a, b): ([[f64; N]; N], [[f64; M]; N]) = (random.matrix(), random.matrix());
        let (mut lu, mut x) = (a, b);
        solve_block(&mut lu, &mut x).unwrap();
        let error = backward_error(&a, &x, &b);
        assert!(error < 10.0 * f64::EPSILON, "{N} x {N}: backward error {error:e}");
    }
}

#[test]
fn random_matrices_of_all_shapes() {
    random_matrices_have_small_backward_error::<1, 1>(1);
    random_matrices_have_small_backward_error::<2, 3>(2);
    random_matrices_have_small_backward_error::<3, 2>(3);
    random_matrices_have_small_backward_error::<4, 4>(4);
    random_matrices_have_small_backward_error::<7, 10>(5);
    random_matrices_have_small_backward_error::<10, 10>(6);
    random_matrices_have_small_backward_error::<25, 9>(7);
    random_matrices_have_small_backward_error::<40, 40>(8);
}

#[test]
fn integer_matrices_with_integer_solutions_agree_with_nalgebra() {
    let mut random = Random::new(9);
    for _ in 0..500 {
        let a: [[f64; 6]; 6] = random.matrix::<6, 6>().map(|row| row.map(|v| (v * 9.0).round()));
        let x: [[f64; 2]; 6] = random.matrix::<6, 2>().map(|row| row.map(|v| (v * 9.0).round()));
        let mut b = [[0.0; 2]; 6];
        for i in 0..6 {
            for m in 0..2 {
                b[i][m] = (0..6).map(|j| a[i][j] * x[j][m]).sum();
            }
        }
        let oracle = nalgebra::SMatrix::<f64, 6, 6>::from_fn(|i, j| a[i][j]);
        let (mut lu, mut solution) = (a, b);
        match solve_block(&mut lu, &mut solution) {
            Ok(()) => {
                let inverse = oracle.try_inverse().unwrap();
                let condition = oracle.norm() * inverse.norm();
                for i in 0..6 {
                    for m in 0..2 {
                        assert!((solution[i][m] - x[i][m]).abs() <= 1e-14 * condition * 9.0);
                    }
                }
            }
            // The determinant of an integer matrix is an integer: singular means zero.
            Err(error) => {
                assert!(matches!(error, BlockError::Singular { .. }));
                assert!(oracle.determinant().abs() < 0.5, "{oracle}");
            }
        }
    }
}

#[test]
fn scaling_rows_by_powers_of_two_changes_nothing() {
    let mut random = Random::new(10);
    for _ in 0..200 {
        let (a, b): ([[f64; 8]; 8], [[f64; 3]; 8]) = (random.matrix(), random.matrix());
        let (mut lu, mut x) = (a, b);
        solve_block(&mut lu, &mut x).unwrap();
        let (mut scaled, mut y) = (a, b);
        for i in 0..8 {
            let factor = 2.0_f64.powi(random.below(600) as i32 - 300);
            scaled[i] = scaled[i].map(|v| v * factor);
            y[i] = y[i].map(|v| v * factor);
        }
        solve_block(&mut scaled, &mut y).unwrap();
        assert_eq!(x, y);
    }
}

#[test]
fn badly_scaled_columns_are_no_rank_loss() {
    let mut random = Random::new(13);
    for _ in 0..200 {
        let (mut a, b): ([[f64; 8]; 8], [[f64; 3]; 8]) = (random.matrix(), random.matrix());
        for j in 0..8 {
            let factor = 2.0_f64.powi(random.below(200) as i32 - 100);
            a.iter_mut().for_each(|row| row[j] *= factor);
        }
        let (mut lu, mut x) = (a, b);
        solve_block(&mut lu, &mut x).unwrap();
        let error = backward_error(&a, &x, &b);
        assert!(error < 10.0 * f64::EPSILON, "backward error {error:e}");
    }
}

#[test]
fn only_the_needed_rows_are_solved_and_they_are_the_same() {
    let mut random = Random::new(11);
    let (a, b): ([[f64; 12]; 12], [[f64; 5]; 15]) = (random.matrix(), random.matrix());
    let (mut lu, mut all) = (a, b);
    solve_block(&mut lu, &mut all).unwrap();
    assert_eq!(all[12..], b[12..], "rows beyond the block are untouched");
    for needed in 0..=12 {
        let (mut lu, mut some) = (a, b);
        solve_block_trailing(&mut lu, &mut some, needed).unwrap();
        assert_eq!(some[12 - needed..12], all[12 - needed..12]);
    }
    let (mut lu, mut more) = (a, b);
    solve_block_trailing(&mut lu, &mut more, 100).unwrap();
    assert_eq!(more, all);
}

/// Rank N - lost, exactly: small integers. Returns how often the loss was reported.
fn reported_rank_losses<const N: usize>(lost: usize, trials: usize) -> usize {
    let mut random = Random::new(12);
    let mut integers = || random.matrix::<N, N>().map(|row| row.map(|v| (v * 9.0).round()));
    let mut reported = 0;
    for _ in 0..trials {
        let (left, right) = (integers(), integers());
        let mut a: [[f64; N]; N] =
            std::array::from_fn(|i| std::array::from_fn(|j| (0..N - lost).map(|k| left[i][k] * right[k][j]).sum()));
        let mut x = [[0.0; 1]; N];
        x[0] = [1.0];
        match solve_block(&mut a, &mut x) {
            Err(error) => {
                assert!(matches!(error, BlockError::Singular { .. }));
                reported += 1;
            }
            // What slips through is rounding noise above the threshold: it shows in the size of X.
            Ok(()) => assert!(x.iter().any(|row| row[0].abs() > 1e8), "{x:?}"),
        }
    }
    reported
}

#[test]
fn rank_loss_is_reported() {
    assert_eq!(reported_rank_losses::<4>(3, 500), 500);
    assert_eq!(reported_rank_losses::<25>(4, 500), 500);
    // One lost dimension leaves a single pivot of noise, now and then a large one.
    assert!(reported_rank_losses::<4>(1, 500) > 450);
    assert!(reported_rank_losses::<10>(1, 500) > 450);
    assert!(reported_rank_losses::<25>(1, 500) > 400);
    assert_eq!(solve_block(&mut [[0.0]], &mut [[1.0]]), Err(BlockError::Singular { column: 0 }));
}

#[test]
fn a_column_of_zeros_is_a_rank_loss_of_its_own() {
    assert_eq!(
        solve_block(&mut [[1.0, 0.0], [2.0, 0.0]], &mut [[1.0], [1.0]]),
        Err(BlockError::Singular { column: 1 })
    );
    assert_eq!(
        solve_block(&mut [[0.0, 1.0], [0.0, 2.0]], &mut [[1.0], [1.0]]),
        Err(BlockError::Singular { column: 0 })
    );
    assert_eq!(
        solve_block(&mut [[1.0, 2.0], [0.0, 0.0]], &mut [[1.0], [1.0]]),
        Err(BlockError::Singular { column: 1 })
    );
}

#[test]
fn of_equally_good_pivots_the_first_stays() {
    let mut matrix = [[1.0, 1.0], [1.0, -1.0]];
    let mut right = [[3.0], [5.0]];
    solve_block(&mut matrix, &mut right).unwrap();
    assert_eq!((matrix, right), ([[1.0, 1.0], [0.0, -2.0]], [[4.0], [-1.0]]));
}

#[test]
fn slices_whose_lengths_do_not_belong_together_are_refused() {
    assert_eq!(solve_block(&mut [[1.0, 2.0], [3.0, 4.0]], &mut [[1.0]]), Err(BlockError::Shape));
    for (entries, rows, columns) in [(4, 2, 2), (3, 2, 2), (5, 2, 2), (4, 1, 2), (4, 2, 1), (4, 3, 2), (4, 2, 3)] {
        let (matrix, row_scale, smallest) = (&mut vec![1.0; entries], &mut vec![0.0; rows], &mut vec![0.0; columns]);
        matrix[0] = 2.0;
        let right: &mut [[f64; 1]] = &mut [[1.0], [1.0]];
        let memory = BlockMemory { matrix, row_scale, smallest };
        let expected = if (entries, rows, columns) == (4, 2, 2) { Ok(()) } else { Err(BlockError::Shape) };
        assert_eq!(solve_large_block(memory, right, 2), expected, "{entries} entries, {rows} rows, {columns} columns");
    }
}

#[test]
fn nearly_singular_but_regular_is_solved() {
    // Pivots of 1e-12 are far above rounding.
    let mut a = [[1.0, 1.0], [1.0, 1.0 + 1e-12]];
    let mut b = [[2.0], [2.0 + 1e-12]];
    solve_block(&mut a, &mut b).unwrap();
    assert!((b[0][0] - 1.0).abs() < 1e-3 && (b[1][0] - 1.0).abs() < 1e-3);
}

#[test]
fn empty_blocks() {
    solve_block::<f64, [f64; 3], 0>(&mut [], &mut []).unwrap();
    solve_block::<f64, [f64; 0], 2>(&mut [[0.0, 1.0], [1.0, 0.0]], &mut [[], []]).unwrap();
}

/// The same cases every time.
fn config() -> ProptestConfig {
    ProptestConfig { cases: 1_000, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..Default::default() }
}

proptest! {
    #![proptest_config(config())]
    #[test]
    fn one_bad_entry_anywhere_is_an_error(
        entry in 0..60_usize,
        bad in prop::sample::select(vec![f64::NAN, f64::INFINITY, f64::NEG_INFINITY]),
        seed: u64,
    ) {
        let mut random = Random::new(seed);
        let (mut a, mut b): ([[f64; 6]; 6], [[f64; 4]; 6]) = (random.matrix(), random.matrix());
        if entry < 36 { a[entry / 6][entry % 6] = bad } else { b[(entry - 36) / 4][entry % 4] = bad }
        prop_assert_eq!(solve_block(&mut a, &mut b), Err(BlockError::NonFinite));
    }

    #[test]
    fn success_means_finite(a: [[f64; 3]; 3], b: [[f64; 2]; 3]) {
        let (mut lu, mut x) = (a, b);
        if solve_block(&mut lu, &mut x).is_ok() {
            prop_assert!(x.as_flattened().iter().all(|v| v.is_finite()));
        }
    }
}
