//! Constant and run-time sizes give the same bits: elimination, polish, and whole solves with
//! second attempts. (The spectrum is compared in unit tests, where the kernels can be called with
//! every kind of size.)
#![cfg(feature = "alloc")]
mod support;

use eliminant::emitted::{
    AtMost, BlockError, BlockMemory, DenseSystem, Dynamic, Fixed, List, Point, Product, Size, SolverInstance, Tables,
    Term, complex_solutions, polish, real_solutions, real_solutions_by_determinant, solve_block_trailing,
    solve_large_block,
};
use eliminant::{Complex, Scalar, SolveError};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use support::rows::rows_of;
use support::two_conics::{Constant, Family, RunTime, TwoConics};

fn bits<S: Scalar>(x: &[S]) -> Vec<[u64; 2]> {
    x.iter().map(|x| x.to_complex()).map(|x| [x.re.to_bits(), x.im.to_bits()]).collect()
}

/// Numbers that are often 0 or 1, and of very different sizes.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => Just(0.0),
        1 => Just(1.0),
        4 => -1.0..1.0_f64,
        2 => (-1.0..1.0_f64, -60..60_i32).prop_map(|(x, exponent)| x * 2.0_f64.powi(exponent)),
    ]
}

/// Solves an N x N block with constant sizes and with run-time sizes: X or the error, and the
/// factors.
type Solved = (Result<Vec<Vec<u64>>, BlockError>, Vec<u64>);

fn solve_both<const N: usize, const M: usize>(numbers: &[f64], needed: usize) -> [Solved; 2] {
    let at = |k: usize| numbers[k % numbers.len()];
    let mut matrix: [[f64; N]; N] = std::array::from_fn(|i| std::array::from_fn(|j| at(i * N + j)));
    let mut right: [[f64; M]; N] = std::array::from_fn(|i| std::array::from_fn(|j| at(N * N + i * M + j)));
    let (mut of_large, mut right_of_large) = (matrix.as_flattened().to_vec(), right.map(|row| row.to_vec()).to_vec());
    let bits = |row: &[f64]| row.iter().map(|x| x.to_bits()).collect::<Vec<_>>();

    let solved = solve_block_trailing(&mut matrix, &mut right, needed);
    let rows = right[N - needed.min(N)..].iter().map(|row| bits(row)).collect();
    let (row_scale, smallest) = (&mut vec![0.0; N], &mut vec![0.0; N]);
    let memory = BlockMemory { matrix: &mut of_large, row_scale, smallest };
    let solved_large = solve_large_block(memory, &mut right_of_large, needed);
    let rows_of_large = right_of_large[N - needed.min(N)..].iter().map(|row| bits(row)).collect();
    [(solved.map(|()| rows), bits(matrix.as_flattened())), (solved_large.map(|()| rows_of_large), bits(&of_large))]
}

/// The same cases every time.
fn config(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..Default::default() }
}

proptest! {
    #![proptest_config(config(500))]
    #[test]
    fn blocks(numbers in prop::collection::vec(number(), 150), needed in 0..12_usize) {
        let [constant, run_time] = solve_both::<1, 2>(&numbers, needed);
        prop_assert_eq!(constant, run_time);
        let [constant, run_time] = solve_both::<4, 3>(&numbers, needed);
        prop_assert_eq!(constant, run_time);
        let [constant, run_time] = solve_both::<10, 5>(&numbers, needed);
        prop_assert_eq!(constant, run_time);
    }
}

/// E equations in N unknowns over K monomials, and a point.
#[derive(Debug)]
struct Polynomials<const N: usize, const E: usize, const K: usize> {
    chain: [Product; K],
    ends: [u32; E],
    terms: Vec<Term>,
    coefficients: Vec<f64>,
    point: [Complex<f64>; N],
}

impl<const N: usize, const E: usize, const K: usize> Polynomials<N, E, K> {
    /// From random numbers: parents, unknowns, the monomials and coefficients of the terms, the
    /// point.
    fn new(choices: &[usize], numbers: &[f64]) -> Self {
        let choose = |at: usize, below: usize| (choices[at] % below) as u16;
        let chain = std::array::from_fn(|k| Product { parent: choose(k, k.max(1)), unknown: choose(K + k, N) });
        let count = choices.len() - 2 * K;
        let terms = (0..count).map(|t| Term { coefficient: t as u16, monomial: choose(2 * K + t, K) }).collect();
        let ends = std::array::from_fn(|e| ((e + 1) * count / E) as u32);
        let point = std::array::from_fn(|j| Complex { re: numbers[2 * j], im: numbers[2 * j + 1] });
        Polynomials { chain, ends, terms, coefficients: numbers[2 * N..].to_vec(), point }
    }

    /// The polished point and its residual by a table and by a matrix, with sizes of two kinds.
    fn polish_both<S: Scalar>(&self, point: [S; N], steps: usize) -> [[Polished; 2]; 2] {
        let tables = Tables {
            sizes: (Fixed::<N>, Fixed::<E>, Fixed::<K>),
            chain: &self.chain,
            ends: &self.ends,
            terms: &self.terms,
        };
        let (chain, ends) = (self.chain.to_vec(), self.ends.to_vec());
        let sizes = (Dynamic(N), Dynamic(E), Dynamic(K));
        let of_run_time = Tables { sizes, chain: &chain, ends: &ends, terms: &self.terms };
        [
            polished::<S, _, _, _>(&tables, &self.coefficients, point, steps),
            polished::<S, _, _, _>(&of_run_time, &self.coefficients, point.to_vec(), steps),
        ]
    }
}

/// A point and its residual.
type Polished = (Vec<[u64; 2]>, u64);

fn polished<S: Scalar, N: Size, E: Size, K: Size>(
    tables: &Tables<'_, N, E, K>,
    coefficients: &[f64],
    start: N::Vector<S>,
    steps: usize,
) -> [Polished; 2] {
    let (system, rows) = (tables.bind(coefficients), rows_of(tables, coefficients));
    let matrix = DenseSystem { sizes: tables.sizes, monomials: *tables, rows: &rows };
    let mut x = start.clone();
    let residual = polish(&mut x, tables.polynomials(), &system, steps);
    assert_eq!(
        system.exceeds::<S>(&x, -1.0),
        system.exceeds::<S>(&x, -0.5),
        "both are below any modulus, or not finite"
    );
    let mut of_matrix = start;
    let residual_of_matrix = polish(&mut of_matrix, tables.polynomials(), &matrix, steps);
    [(bits(x.as_ref()), residual.to_bits()), (bits(of_matrix.as_ref()), residual_of_matrix.to_bits())]
}

proptest! {
    #![proptest_config(config(2_000))]
    #[test]
    fn polished_points(
        choices in prop::collection::vec(0..1_000_usize, 40),
        numbers in prop::collection::vec(number(), 50),
        steps in 0..24_usize,
    ) {
        let square = Polynomials::<2, 2, 7>::new(&choices, &numbers);
        let [constant, run_time] = square.polish_both(square.point, steps);
        prop_assert_eq!(constant, run_time);
        let [constant, run_time] = square.polish_both(square.point.map(|x| x.re), steps);
        prop_assert_eq!(constant, run_time);
        let overdetermined = Polynomials::<3, 5, 9>::new(&choices, &numbers);
        let [constant, run_time] = overdetermined.polish_both(overdetermined.point, steps);
        prop_assert_eq!(constant, run_time);
        let [constant, run_time] = overdetermined.polish_both(overdetermined.point.map(|x| x.re), steps);
        prop_assert_eq!(constant, run_time);
    }
}

/// Solutions as bits, or the error; and how many attempts there were.
type Outcome = (Result<Vec<Vec<[u64; 2]>>, SolveError>, usize);

fn listed<S: Scalar, N: Size>(solutions: &impl List<N::Vector<S>>) -> Vec<Vec<[u64; 2]>> {
    solutions.iter().map(|x| bits(x.as_ref())).collect()
}

/// What is called to solve.
type Solve<F> = fn(&mut TwoConics<F>) -> Result<Vec<Vec<[u64; 2]>>, SolveError>;

/// Real solutions, those by a determinant, and complex solutions.
fn outcomes<F: Family>(coefficients: [f64; 12], reads_all: bool) -> [Outcome; 3] {
    let solvers: [Solve<F>; 3] = [
        |conics| real_solutions(conics).map(|found| listed::<f64, F::Of<2>>(&found)),
        |conics| real_solutions_by_determinant(conics).map(|found| listed::<f64, F::Of<2>>(&found)),
        |conics| complex_solutions(conics).map(|found| listed::<Complex<f64>, F::Of<2>>(&found)),
    ];
    solvers.map(|solve| {
        let mut conics = TwoConics::<F>::new(coefficients);
        conics.reads_all = reads_all;
        let found = solve(&mut conics);
        (found, conics.calls)
    })
}

/// What constant sizes give, after a comparison with run-time sizes.
fn agreed(coefficients: [f64; 12], reads_all: bool) -> [Outcome; 3] {
    let constant = outcomes::<Constant>(coefficients, reads_all);
    assert_eq!(constant, outcomes::<RunTime>(coefficients, reads_all));
    constant
}

proptest! {
    #![proptest_config(config(1_000))]
    #[test]
    fn solutions_of_any_conics(numbers in prop::array::uniform12(number())) {
        let _ = agreed(numbers, true);
    }

    /// General conics have four common points, which are found, and those that are real are the
    /// real solutions.
    #[test]
    fn all_solutions_of_general_conics(coefficients in prop::array::uniform12(-1.0..1.0_f64)) {
        let [real, by_determinant, complex] = agreed(coefficients, true);
        let all = complex_solutions(&mut TwoConics::<Constant>::new(coefficients)).unwrap();
        for point in &all {
            let residual = TwoConics::<Constant>::new(coefficients).polish(&mut point.clone(), 0);
            prop_assert!(residual < 1e-12, "{residual:e} at {point:?}");
        }
        prop_assert_eq!(all.len(), 4);
        let count = all.iter().filter(|point| point.iter().all(|x| x.im == 0.0)).count();
        prop_assert_eq!([real.0.unwrap().len(), by_determinant.0.unwrap().len()], [count; 2]);
        prop_assert_eq!(complex.1, 1);
    }

    /// Conics that are symmetric in y: pairs of solutions share a value of the action monomial.
    #[test]
    fn solutions_with_a_shared_value(c in prop::array::uniform8(-1.0..1.0_f64)) {
        let coefficients = [c[0], c[1], 0.0, c[2], 0.0, c[3], c[4], c[5], 0.0, c[6], 0.0, c[7]];
        let [_, _, complex] = agreed(coefficients, true);
        prop_assert_eq!(complex.0.map(|all| all.len()), Ok(4));
        let _ = agreed(coefficients, false);
    }

    /// The quadratic parts differ by a rounding error: the template is singular to `f64`, and a
    /// second attempt solves it.
    #[test]
    fn solutions_of_a_second_attempt(c in prop::array::uniform12(-1.0..1.0_f64), bit in 0..2_u64) {
        let next = |x: f64| f64::from_bits(x.to_bits() + bit);
        let coefficients = [c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8], c[3], c[4], next(c[5])];
        let [real, _, complex] = agreed(coefficients, true);
        prop_assert_eq!((real.1, complex.1), (2, 2));
        let degenerate = Err(SolveError::Degenerate { block: 0 });
        match bit {
            0 => prop_assert_eq!((real.0, complex.0), (degenerate.clone(), degenerate)),
            _ => prop_assert!(complex.0.is_ok()),
        }
    }
}

/// What a full list takes, and what it holds.
fn fill_up<Z: Size>(size: Z) -> (Vec<bool>, Vec<usize>) {
    let mut list = size.list();
    let taken = (0..4).map(|entry| list.push(entry)).collect();
    list[0] += 10;
    (taken, list.to_vec())
}

#[test]
fn a_full_list_takes_nothing() {
    let expected = (vec![true, true, false, false], vec![10, 1]);
    assert_eq!(fill_up(Fixed::<2>), expected);
    assert_eq!(fill_up(AtMost::<2>(1)), expected);
    assert_eq!(fill_up(Dynamic(2)), expected);
}

#[test]
fn sizes_say_how_many_entries_are_in_use() {
    assert_eq!([Fixed::<3>.get(), AtMost::<3>(2).get(), AtMost::<3>(5).get(), Dynamic(2).get()], [3, 2, 3, 2]);
    assert_eq!(Fixed::<3>.filled(7), [7; 3]);
    assert_eq!(AtMost::<3>(2).filled(7), [7; 3]);
    assert_eq!(Dynamic(2).filled(7), vec![7; 2]);
    let point: Point<TwoConics<RunTime>, f64> = Dynamic(2).filled(0.5);
    assert_eq!(point.len(), 2);
}
