//! Which eigenpairs the driver polishes, in which form, and what it counts as missing.

use std::any::TypeId;
use std::cell::{Cell, RefCell};

use eliminant::emitted::{
    Arithmetic, ChainTable, ChainedBasis, Fixed, HiddenVariableSolver, MAX_RESIDUAL, Real, Sizes, SizesOf,
    SolverInstance, Symmetries, complex_solutions, real_solutions, real_solutions_by_determinant, unpolished_points,
    value_at,
};
use eliminant::{Complex, Scalar, SecondAttempts, SolveError};

/// What a second attempt counts as.
const OPERATIONS: u64 = 1_000;

/// A call of the polish: the value of the unknown, and whether the unknown was complex.
type Call = (Complex<f64>, bool);

/// One unknown x with B eigenvalues t, by the companion matrix; basis 1, t, .., t^(B-1). The
/// unknown is t, or a root of t. MAX solutions are known.
struct Listed<const B: usize, const MAX: usize> {
    /// All t. Those that are not real come with their conjugates.
    eigenvalues: [Complex<f64>; B],
    /// The residual of x, whether complex, after at most so many steps.
    residual: Box<dyn Fn(Complex<f64>, bool, usize) -> f64>,
    /// The part of x by which the polish moves it.
    moves: f64,
    /// Whether x^2 = t.
    is_square: bool,
    has_origin: bool,
    /// Whether `f64` does not suffice for the action matrix.
    is_singular: bool,
    /// How often the action matrix was computed.
    attempts: usize,
    second_attempts: SecondAttempts,
    polished: RefCell<Vec<Call>>,
    evaluated: RefCell<Vec<Call>>,
}

impl<const B: usize, const MAX: usize> Listed<B, MAX> {
    fn new(eigenvalues: [Complex<f64>; B], residual: impl Fn(Complex<f64>, bool, usize) -> f64 + 'static) -> Self {
        Self {
            eigenvalues,
            residual: Box::new(residual),
            moves: 0.0,
            is_square: false,
            has_origin: false,
            is_singular: false,
            attempts: 0,
            second_attempts: SecondAttempts::Always,
            polished: RefCell::default(),
            evaluated: RefCell::default(),
        }
    }

    /// The real solutions, and what was polished.
    fn real(&mut self) -> (Vec<f64>, Vec<Call>) {
        let found = real_solutions(self).unwrap().iter().map(|[x]| *x).collect();
        (found, self.polished.take())
    }

    /// All solutions, and what was polished.
    fn complex(&mut self) -> (Vec<Complex<f64>>, Vec<Call>) {
        let found = complex_solutions(self).unwrap().iter().map(|[x]| *x).collect();
        (found, self.polished.take())
    }
}

impl<const B: usize, const MAX: usize> SolverInstance for Listed<B, MAX> {
    type Basis = Fixed<B>;
    type Unknowns = Fixed<1>;
    type Values = Fixed<B>;
    type Solutions = Fixed<MAX>;

    fn sizes(&self) -> SizesOf<Self> {
        Sizes::FIXED
    }

    fn ratios(&self, _unknown: usize) -> &[(u16, u16)] {
        &[(0, 1)]
    }

    fn has_origin(&self) -> bool {
        self.has_origin
    }

    fn symmetries(&self) -> Option<Symmetries<'_>> {
        self.is_square.then_some(Symmetries { steps: &[&[2]], images: &[&[(0, true)]] })
    }

    fn has_precise_coefficients(&self) -> bool {
        self.is_singular
    }

    fn allows_second_attempt(&self) -> bool {
        self.second_attempts.allows(OPERATIONS)
    }

    fn action_matrix<R: Real>(&mut self) -> Result<[[R; B]; B], SolveError> {
        self.attempts += 1;
        if self.is_singular && R::EPSILON == f64::EPSILON {
            return Err(SolveError::Degenerate { block: 0 });
        }
        // The product of all x - t, lowest coefficient first, without the leading 1.
        let mut lower = [Complex::ZERO; B];
        for (degree, t) in self.eigenvalues.iter().enumerate() {
            let before = lower;
            for k in 0..=degree {
                let shifted = if k > 0 { before[k - 1] } else { Complex::ZERO };
                let leading = if k == degree { Complex::ONE } else { before[k] };
                lower[k] = shifted - t * leading;
            }
        }
        let mut action = [[R::ZERO; B]; B];
        (0..B - 1).for_each(|k| action[k][k + 1] = R::ONE);
        action[B - 1] = lower.map(|c| R::from_f64(-c.re));
        Ok(action)
    }

    fn monomial_values<S: Scalar>(&self, _value: S, vector: &[S; B]) -> [S; B] {
        *vector
    }

    fn recover<S: Scalar>(&self, _unknowns: &mut [S; 1]) {}

    fn polish<S: Scalar>(&self, [x]: &mut [S; 1], steps: usize) -> f64 {
        let call = (x.to_complex(), TypeId::of::<S>() != TypeId::of::<f64>());
        if steps > 0 {
            self.polished.borrow_mut().push(call);
            *x = x.scale(1.0 + self.moves);
        } else {
            self.evaluated.borrow_mut().push(call);
        }
        (self.residual)(call.0, call.1, steps)
    }

    fn is_admissible<S: Scalar>(&self, _unknowns: &[S; 1]) -> bool {
        true
    }
}

impl<const MAX: usize> HiddenVariableSolver for Listed<4, MAX> {
    type Chains = OneChain;

    fn chains(&self) -> OneChain {
        OneChain
    }
}

/// One chain of four monomials: the determinant is the characteristic polynomial.
struct OneChain;

impl ChainedBasis for OneChain {
    type Basis = Fixed<4>;
    type Count = Fixed<1>;
    type Width = Fixed<5>;
    type Coefficients = Fixed<5>;

    fn sizes(&self) -> (Fixed<4>, Fixed<1>, Fixed<5>, Fixed<5>) {
        (Fixed, Fixed, Fixed, Fixed)
    }

    fn table(&self) -> ChainTable<'_> {
        ChainTable { ends: &[3], leading: &[4], degrees: &[4], heads: &[] }
    }

    fn polynomials<T: Arithmetic>(&self, row: &[T; 4]) -> [T; 5] {
        [-row[0], -row[1], -row[2], -row[3], row[0].constant(0.0)]
    }

    fn determinant<T: Arithmetic>(&self, rows: &[[T; 5]; 1]) -> [T; 5] {
        rows[0]
    }

    fn row_at<T: Arithmetic>(&self, row: &[T; 5], x: T) -> [T; 1] {
        [value_at(row, x)]
    }

    fn vector<T: Arithmetic>(&self, x: T, heads: &[T; 1], _eliminated: &[T; 1]) -> [T; 4] {
        [heads[0], heads[0] * x, heads[0] * x * x, heads[0] * x * x * x]
    }
}

fn c(re: f64, im: f64) -> Complex<f64> {
    Complex { re, im }
}

/// Whether lists agree up to their order and rounding.
fn agree<T: Copy>(found: &[T], expected: &[T], distance: impl Fn(T, T) -> f64) -> bool {
    let close = |x: T, list: &[T]| list.iter().filter(|y| distance(x, **y) < 1e-9).count() == 1;
    found.len() == expected.len() && expected.iter().all(|&x| close(x, found))
}

fn are_calls(found: &[Call], expected: &[Call]) -> bool {
    agree(found, expected, |x, y| if x.1 == y.1 { (x.0 - y.0).norm() } else { f64::INFINITY })
}

fn are_points(found: &[Complex<f64>], expected: &[Complex<f64>]) -> bool {
    agree(found, expected, |x, y| (x - y).norm())
}

fn are_numbers(found: &[f64], expected: &[f64]) -> bool {
    agree(found, expected, |x, y| (x - y).abs())
}

/// A point whose residual stays above rounding may stand for a solution that is missing. With no
/// other there, it is taken after all.
#[test]
fn stalled_points_take_a_second_attempt() {
    for (residual, attempts) in [(1e-13, 1), (1e-11, 2)] {
        let at_two = move |x: Complex<f64>| if (x.re - 2.0).abs() < 0.5 { residual } else { 0.0 };
        let made = || Listed::<3, 3>::new([1.0, 2.0, 3.0].map(Complex::from), move |x, _, _| at_two(x));
        let mut problem = made();
        assert_eq!((problem.complex().0.len(), problem.attempts), (3, attempts), "{residual:e}");
        let mut problem = made();
        assert_eq!((problem.real().0.len(), problem.attempts), (3, attempts), "{residual:e}");
        let four = [c(0.7, 0.0), c(2.0, 0.0), c(3.0, 2.0), c(3.0, -2.0)];
        let mut problem = Listed::<4, 4>::new(four, move |x, _, _| at_two(x));
        assert_eq!((real_solutions_by_determinant(&mut problem).unwrap().len(), problem.attempts), (2, attempts));
        let mut once = made();
        once.second_attempts = SecondAttempts::Never;
        assert_eq!((once.complex().0.len(), once.attempts), (3, 1), "{residual:e}");
    }
}

/// One polish per real eigenvalue and per conjugate pair; real solves leave the pairs alone.
#[test]
fn each_eigenpair_is_polished_once() {
    for is_singular in [false, true] {
        let mut three = Listed::<3, 3>::new([c(1.0, 0.0), c(2.0, 1.0), c(2.0, -1.0)], |_, _, _| 0.0);
        three.is_singular = is_singular;
        let (found, polished) = three.complex();
        assert!(are_points(&found, &three.eigenvalues), "{found:?}");
        assert!(are_calls(&polished, &[(c(1.0, 0.0), false), (c(2.0, 1.0), true)]), "{polished:?}");
        let (found, polished) = three.real();
        assert!(are_numbers(&found, &[1.0]), "{found:?}");
        assert!(are_calls(&polished, &[(c(1.0, 0.0), false)]), "{polished:?}");
        assert_eq!(three.attempts, if is_singular { 4 } else { 2 });
        assert!(three.evaluated.borrow().is_empty(), "no order is needed");
    }
}

/// A real eigenvalue that belongs to no solution is polished as a real one only.
#[test]
fn an_eigenpair_without_solution_is_polished_once() {
    let spurious = |x: Complex<f64>, _: bool, steps: usize| match x.re < 3.0 {
        true => 0.0,
        false if steps > 0 => 1.0,
        false => 1e-7,
    };
    let mut three = Listed::<3, 2>::new([c(1.0, 0.0), c(2.0, 0.0), c(4.0, 0.0)], spurious);
    let expected = [(c(1.0, 0.0), false), (c(2.0, 0.0), false), (c(4.0, 0.0), false)];
    let (found, polished) = three.complex();
    assert!(found.len() == 2 && are_calls(&polished, &expected), "{polished:?}");
    let (found, polished) = three.real();
    assert!(found.len() == 2 && are_calls(&polished, &expected), "{polished:?}");
}

/// The origin is known, so one of two eigenvalues is spurious. Its residual before the polish shows
/// it.
#[test]
fn the_origin_makes_an_eigenvalue_spurious() {
    let mut two = Listed::<2, 2>::new([c(1.0, 0.0), c(5.0, 0.0)], |x, _, _| if x.re < 3.0 { 0.0 } else { 1.0 });
    two.has_origin = true;
    let (found, polished) = two.complex();
    assert!(are_points(&found, &[c(0.0, 0.0), c(1.0, 0.0)]), "{found:?}");
    assert!(are_calls(&polished, &[(c(1.0, 0.0), false)]), "{polished:?}");
    let (found, polished) = two.real();
    assert!(are_numbers(&found, &[0.0, 1.0]), "{found:?}");
    assert!(are_calls(&polished, &[(c(1.0, 0.0), false)]), "{polished:?}");
}

/// x^2 = 4, 9 and -1 have six solutions, of which two are imaginary. A fourth eigenvalue is
/// spurious, although the four eigenpairs are fewer than the solutions.
#[test]
fn solutions_that_differ_by_signs_are_counted() {
    let residual = |x: Complex<f64>, _: bool, _: usize| if x.re.abs() < 9.0 { 0.0 } else { 1.0 };
    let mut squares = Listed::<4, 6>::new([c(4.0, 0.0), c(9.0, 0.0), c(-1.0, 0.0), c(100.0, 0.0)], residual);
    squares.is_square = true;
    let (found, polished) = squares.complex();
    let expected = [c(2.0, 0.0), c(-2.0, 0.0), c(3.0, 0.0), c(-3.0, 0.0), c(0.0, 1.0), c(0.0, -1.0)];
    assert!(are_points(&found, &expected), "{found:?}");
    let expected = [2.0, 3.0, 10.0].map(|x| (c(x, 0.0), false));
    let expected = [&expected[..], &[(c(10.0, 0.0), true), (c(0.0, 1.0), true)]].concat();
    assert!(are_calls(&polished, &expected), "{polished:?}");
    let (found, _) = squares.real();
    assert!(are_numbers(&found, &[2.0, -2.0, 3.0, -3.0]), "{found:?}");
    assert_eq!(squares.attempts, 2, "nothing is missing");
    assert!(!squares.evaluated.borrow().is_empty(), "the order matters");
}

/// While solutions are missing, an eigenpair is polished whatever its residual before.
#[test]
fn a_solution_is_found_from_a_large_residual() {
    let far = |x: Complex<f64>, _: bool, steps: usize| match (x.re < 3.0, steps) {
        (false, _) => 1.0,
        (true, 0) => 1e-3 * x.re,
        (true, _) => 0.0,
    };
    let mut three = Listed::<3, 2>::new([c(1.0, 0.0), c(2.0, 0.0), c(4.0, 0.0)], far);
    let (found, polished) = three.complex();
    assert!(are_points(&found, &[c(1.0, 0.0), c(2.0, 0.0)]), "{found:?}");
    assert!(are_calls(&polished, &[(c(1.0, 0.0), false), (c(2.0, 0.0), false)]), "{polished:?}");
    let (found, polished) = three.real();
    assert!(are_numbers(&found, &[1.0, 2.0]), "{found:?}");
    assert!(are_calls(&polished, &[(c(1.0, 0.0), false), (c(2.0, 0.0), false)]), "{polished:?}");
    assert_eq!(three.attempts, 2);
}

/// Once all solutions are found, an eigenpair is polished if its residual before is at most 1e-6.
#[test]
fn a_residual_of_a_millionth_may_belong_to_a_solution() {
    fn polished(residual: impl Fn(Complex<f64>, bool, usize) -> f64 + 'static) -> usize {
        Listed::<2, 1>::new([c(1.0, 0.0), c(5.0, 0.0)], residual).complex().1.len()
    }
    assert_eq!(
        polished(|x, _, steps| if x.re < 3.0 {
            0.0
        } else if steps == 0 {
            1e-6
        } else {
            1.0
        }),
        2
    );
    assert_eq!(
        polished(|x, _, steps| if x.re < 3.0 {
            0.0
        } else if steps == 0 {
            1e-6_f64.next_up()
        } else {
            1.0
        }),
        1
    );
}

#[test]
fn a_residual_up_to_the_limit_is_a_solution() {
    let count = |residual| Listed::<2, 2>::new([c(2.0, 0.0), c(3.0, 0.0)], move |_, _, _| residual).complex().0.len();
    assert_eq!([MAX_RESIDUAL, MAX_RESIDUAL.next_up(), f64::NAN].map(count), [2, 0, 0]);
}

/// The eigenvalue re + im i, its conjugate, and 20, which is a solution that the polish moves by
/// that part: which real solutions the pair gives.
fn of_pair(re: f64, im: f64, moves: f64, residual: fn(bool) -> f64) -> (Vec<f64>, Vec<Call>) {
    let near = move |x: Complex<f64>, is_complex: bool, _| match () {
        () if (x.re - re).abs() < 1e-3 => residual(is_complex),
        () if x.re > 15.0 => 0.0,
        () => 1.0,
    };
    let mut three = Listed::<3, 3>::new([c(re, im), c(re, -im), c(20.0, 0.0)], near);
    three.moves = moves;
    let (mut found, mut polished) = three.real();
    found.retain(|&x| x < 15.0);
    polished.retain(|(x, _)| x.re < 15.0);
    (found, polished)
}

/// An eigenvalue is tried for a real solution if its imaginary part is at most 1e-3 to 0.1 of the
/// real one: a hundred times the square root of the error of real eigenvalues, the larger one of
/// the absolute and the relative error.
#[test]
fn nearly_real_eigenvalues_are_tried_for_real_solutions() {
    for re in [0.1, 1.0, 10.0, -0.1, -1.0, -10.0] {
        for moves in [0.0, 1e-12, 3e-9, 1e-8, 0.9e-4] {
            let error = f64::max(moves, 20.0 * moves / f64::abs(re));
            let reach = (100.0 * error.sqrt()).clamp(1e-3, 0.1);
            let is_tried = |part: f64| !of_pair(re, part * reach * f64::abs(re), moves, |_| 1.0).1.is_empty();
            assert!(is_tried(0.99) && !is_tried(1.01) && !is_tried(5.0), "{re} {moves}");
        }
    }
}

/// The real part of a complex solution close to its conjugate is a solution if its residual is at
/// most 1e-12, or not larger than that of the complex one.
#[test]
fn a_complex_solution_close_to_its_conjugate_may_be_a_real_one() {
    let found = |im: f64, residual| of_pair(2.0, im, 0.0, residual).0;
    let close = 0.8e-3;
    assert!(are_numbers(&found(close, |_| 1e-15), &[2.0]));
    assert!(found(1.2e-3, |_| 1e-15).is_empty(), "not close");
    assert_eq!(found(close, |is_complex| if is_complex { 1e-15 } else { 1e-12 }).len(), 1);
    assert_eq!(found(close, |is_complex| if is_complex { 1e-15 } else { 1.25e-12 }).len(), 0);
    assert_eq!(found(close, |_| 2e-11).len(), 1);
    assert_eq!(found(close, |is_complex| if is_complex { 2e-11 } else { 2.5e-11 }).len(), 0);
}

/// An eigenvalue of zero is a real one.
#[test]
fn zero_is_a_real_solution() {
    let mut two = Listed::<2, 2>::new([c(0.0, 0.0), c(3.0, 0.0)], |_, _, _| 0.0);
    let (found, _) = two.real();
    assert!(are_numbers(&found, &[0.0, 3.0]), "{found:?}");
}

/// Of four eigenvalues, 1 and 2 give solutions. The other two are taken for lost if they are real,
/// or as close to real as the error of real ones allows. The second attempt does not find them, and
/// then the first one, which stopped when one was lost, is completed.
#[test]
fn real_eigenvalues_without_real_solutions_cause_a_second_attempt() {
    let attempts = |[third, fourth]: [Complex<f64>; 2], moves: f64| {
        let residual = |x: Complex<f64>, _: bool, _: usize| if x.re < 2.5 { 0.0 } else { 1.0 };
        let mut four = Listed::<4, 4>::new([c(1.0, 0.0), c(2.0, 0.0), third, fourth], residual);
        four.moves = moves;
        let (mut found, _) = four.real();
        found.sort_by(f64::total_cmp);
        let is_near = |(x, y): (&f64, f64)| (x / y - 1.0).abs() <= 4.0 * moves + 1e-12;
        assert!(found.len() == 2 && found.iter().zip([1.0, 2.0]).all(is_near), "{found:?}");
        four.attempts
    };
    assert_eq!(attempts([c(3.0, 0.0), c(4.0, 0.0)], 0.0), 3);
    assert_eq!(attempts([c(3.0, 0.1), c(3.0, -0.1)], 1e-6), 3);
    assert_eq!(attempts([c(3.0, 0.1), c(3.0, -0.1)], 1e-9), 1);
    assert_eq!(attempts([c(3.0, 2.0), c(3.0, -2.0)], 1e-6), 1);
}

/// If the polish moves a real solution by more than 1e-4 of it, complex solutions are counted: a
/// pair of them may be two real solutions.
#[test]
fn imprecise_eigenvalues_are_all_tried() {
    let real = |moves: f64, is_pair_lost: bool| {
        let residual =
            move |_: Complex<f64>, is_complex: bool, _: usize| if is_complex && is_pair_lost { 1.0 } else { 0.0 };
        let mut four = Listed::<4, 4>::new([c(1.0, 0.0), c(2.0, 0.0), c(3.0, 2.0), c(3.0, -2.0)], residual);
        four.moves = moves;
        let (_, polished) = four.real();
        (polished.iter().any(|call| call.1), four.attempts)
    };
    assert_eq!(real(0.9e-4, false), (false, 1));
    assert_eq!(real(1.1e-4, false), (true, 1), "four solutions are counted");
    assert_eq!(real(1.1e-4, true), (true, 3), "two are counted, in both attempts and when the first is completed");
}

/// If no eigenvalue is nearly real, the one with the least |im / re| shows whether they are
/// precise.
#[test]
fn a_complex_eigenvalue_shows_that_all_are_imprecise() {
    let polished = |moves: f64| {
        let pairs = [c(1.0, 2.0), c(1.0, -2.0), c(3.0, 1.0), c(3.0, -1.0)];
        let mut four = Listed::<4, 4>::new(pairs, |_, _, _| 0.0);
        four.moves = moves;
        let (found, polished) = four.real();
        assert!(found.is_empty() && four.attempts == 1, "{found:?}");
        polished
    };
    assert!(are_calls(&polished(0.9e-4), &[(c(3.0, 1.0), true)]));
    assert_eq!(polished(1.1e-4).len(), 3, "the witness, then both pairs");
}

/// With sign changes a real eigenvalue has two real solutions, or two imaginary ones: their number
/// shows nothing.
#[test]
fn with_sign_changes_real_eigenvalues_are_not_counted() {
    for (eigenvalues, expected) in [([4.0, 9.0], &[2.0, -2.0, 3.0, -3.0][..]), ([4.0, -9.0], &[2.0, -2.0])] {
        let mut squares = Listed::<2, 4>::new(eigenvalues.map(Complex::from), |_, _, _| 0.0);
        squares.is_square = true;
        let (found, _) = squares.real();
        assert!(are_numbers(&found, expected), "{eigenvalues:?}: {found:?}");
        assert_eq!(squares.attempts, 1, "{eigenvalues:?}");
    }
}

/// A determinant is taken at its word if its roots are certain, each leads to a solution of its
/// own, and the polish moves none of them by more than 1e-7, or by more than 1e-4 where others may
/// be close. Otherwise eigenvalues decide.
#[test]
fn determinants_are_taken_at_their_word_if_they_are_certain() {
    /// The solutions, how often the action matrix was computed, and how many points were polished.
    fn solved(eigenvalues: [Complex<f64>; 4], moves: f64, lost: f64) -> (Vec<f64>, usize, usize) {
        let residual = move |x: Complex<f64>, _: bool, _: usize| if x.re > lost { 1.0 } else { 0.0 };
        let mut four = Listed::<4, 4>::new(eigenvalues, residual);
        four.moves = moves;
        let found = real_solutions_by_determinant(&mut four).unwrap().iter().map(|[x]| *x).collect();
        (found, four.attempts, four.polished.take().len())
    }
    let none = f64::INFINITY;
    let two = [c(0.7, 0.0), c(2.0, 0.0), c(3.0, 2.0), c(3.0, -2.0)];
    let (found, attempts, polished) = solved(two, 0.0, none);
    assert!(are_numbers(&found, &[0.7, 2.0]), "{found:?}");
    assert_eq!((attempts, polished), (1, 2));
    assert_eq!(solved(two, 0.9e-7, none).2, 2);
    assert_eq!(solved(two, 0.9e-6, none).2, 2, "far from other roots");
    let near = [c(0.7, 0.0), c(2.0, 0.0), c(1.0, 0.01), c(1.0, -0.01)];
    assert_eq!(solved(near, 0.9e-7, none).2, 2);
    assert_eq!(solved(near, 0.9e-5, none).2, 5, "a pair may be two real roots: the roots, then all eigenvalues");
    let far = [c(0.7, 0.0), c(2.0, 0.0), c(1.0, 0.2), c(1.0, -0.2)];
    let (found, attempts, polished) = solved(far, 0.9e-4, none);
    assert_eq!((found.len(), attempts, polished), (2, 1, 2), "eigenvalues say that there are two real roots");
    assert_eq!(solved(two, 1.1e-4, none).2, 4, "imprecise: a root, two real eigenvalues, then the pair");
    assert_eq!(solved(two, 0.0, 1.0).1, 3, "a root without a solution: eigenvalues in both precisions, and to the end");
    let pairs = [c(1.0, 2.0), c(1.0, -2.0), c(3.0, 1.0), c(3.0, -1.0)];
    assert_eq!(solved(pairs, 0.0, none), (vec![], 1, 0), "certain to have no root");
    let close = [c(1.0, 1e-4), c(1.0, -1e-4), c(3.0, 1.0), c(3.0, -1.0)];
    assert_ne!(solved(close, 0.0, none).1, 1, "close to the real axis");
}

/// The square of a real unknown is positive: an eigenvalue of the other sign has imaginary
/// solutions.
#[test]
fn determinants_with_sign_changes() {
    let eigenvalues = [4.0, 9.0, -16.0, -30.0].map(Complex::from);
    let mut squares = Listed::<4, 8>::new(eigenvalues, |_, _, _| 0.0);
    squares.is_square = true;
    let found: Vec<f64> = real_solutions_by_determinant(&mut squares).unwrap().iter().map(|[x]| *x).collect();
    assert!(are_numbers(&found, &[2.0, -2.0, 3.0, -3.0]), "{found:?}");
    assert_eq!(squares.attempts, 1);
}

/// Conjugate eigenvectors that give one real solution may be combinations of two: others are tried,
/// too.
#[test]
fn a_pair_with_one_solution_may_hide_another() {
    let residual = |x: Complex<f64>, _: bool, _: usize| 1e-10 * x.im.abs();
    let mut pair = Listed::<2, 1>::new([c(2.0, 1e-4), c(2.0, -1e-4)], residual);
    let (found, polished) = pair.complex();
    assert!(are_points(&found, &[c(2.0, 0.0)]), "{found:?}");
    assert!(polished.iter().any(|(x, _)| (x - c(2.0, 0.0)).norm() > 1e-3), "{polished:?}");
    assert_eq!(pair.attempts, 1);
}

/// A pair that is nearly real makes a real solve search the subspaces of all clusters, for real
/// combinations of their vectors. Complex ones are tried only of the pair itself.
#[test]
fn real_solves_try_real_combinations() {
    let close = [c(2.0, 1.0), c(2.0, -1.0), c(2.0, 1.0005), c(2.0, -1.0005), c(5.0, 1e-3), c(5.0, -1e-3)];
    let (found, polished) = Listed::<6, 6>::new(close, |_, _, _| 1.0).real();
    let (complex, real): (Vec<Call>, Vec<Call>) = polished.iter().partition(|(_, is_complex)| *is_complex);
    assert!(found.is_empty() && !real.is_empty(), "{real:?}");
    assert!(complex.iter().all(|(x, _)| (x - c(5.0, 1e-3)).norm() < 1e-4), "{complex:?}");
}

/// Measurements see what every eigenpair gives, whether it belongs to a solution or not, with both
/// signs.
#[test]
fn points_before_the_polish_are_those_of_all_eigenpairs() {
    let mut three = Listed::<3, 2>::new([c(4.0, 0.0), c(-1.0, 0.0), c(9.0, 0.0)], |_, _, _| 1.0);
    for (is_square, expected) in [
        (false, &[c(4.0, 0.0), c(-1.0, 0.0), c(9.0, 0.0)][..]),
        (true, &[c(2.0, 0.0), c(-2.0, 0.0), c(0.0, 1.0), c(0.0, -1.0), c(3.0, 0.0), c(-3.0, 0.0)]),
    ] {
        three.is_square = is_square;
        let mut points = Vec::new();
        unpolished_points(&mut three, |[x]| points.push(*x)).unwrap();
        assert!(are_points(&points, expected), "{points:?}");
    }
    assert!(three.polished.borrow().is_empty() && three.evaluated.borrow().is_empty());
    three.is_singular = true;
    assert_eq!(unpolished_points(&mut three, |_| ()), Err(SolveError::Degenerate { block: 0 }));
}

/// Where the first attempt fails or misses a solution, a second one is made only if it is allowed.
/// Where that misses one, too, the first is made to the end.
#[test]
fn second_attempts_are_bounded() {
    let allowed = [SecondAttempts::Always, SecondAttempts::AtMost(OPERATIONS)];
    for second_attempts in [allowed[0], allowed[1], SecondAttempts::Never, SecondAttempts::AtMost(OPERATIONS - 1)] {
        let is_allowed = allowed.contains(&second_attempts);
        // Three are known, and there are two.
        let mut missing = Listed::<2, 3>::new([c(1.0, 0.0), c(2.0, 0.0)], |_, _, _| 0.0);
        missing.second_attempts = second_attempts;
        assert!(are_points(&missing.complex().0, &[c(1.0, 0.0), c(2.0, 0.0)]));
        assert_eq!(missing.attempts, if is_allowed { 3 } else { 1 }, "{second_attempts:?}");
        let mut singular = Listed::<2, 2>::new([c(1.0, 0.0), c(2.0, 0.0)], |_, _, _| 0.0);
        (singular.is_singular, singular.second_attempts) = (true, second_attempts);
        let found = complex_solutions(&mut singular).map(|found| found.len());
        assert_eq!(found, if is_allowed { Ok(2) } else { Err(SolveError::Degenerate { block: 0 }) });
    }
}

/// Where an eigenpair gives nothing, and the others are too few, the second attempt begins at once.
/// It tries what is missing, and ends when all solutions are counted.
#[test]
fn second_attempts_try_what_is_missing() {
    let failures = Cell::new(0);
    let residual = move |x: Complex<f64>, _: bool, _: usize| {
        let fails = (x.re - 2.0).abs() < 1e-6 && failures.replace(1) == 0;
        if fails { 1.0 } else { 0.0 }
    };
    let mut four = Listed::<4, 4>::new([1.0, 2.0, 3.0, 4.0].map(Complex::from), residual);
    let (found, polished) = four.complex();
    assert_eq!((found.len(), four.attempts), (4, 2));
    assert_eq!(polished.len(), 5, "2 twice, all others once: {polished:?}");
}
