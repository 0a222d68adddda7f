//! What the driver does with solutions that a problem excludes, and where rounding errors lose
//! some.

use std::cell::Cell;

use eliminant::emitted::{Fixed, Hessenberg, Real, Sizes, SizesOf, SolverInstance, complex_solutions, real_solutions};
use eliminant::{Scalar, SolveError};

/// Solutions (x, y) with y = 1, 2; basis 1, y; action y. Solutions with x = 0 are excluded. MAX
/// solutions are known.
struct TwoPoints<const MAX: usize = B> {
    x: [f64; 2],
    /// How often the action matrix was computed.
    calls: usize,
}

const B: usize = 2;

impl<const MAX: usize> SolverInstance for TwoPoints<MAX> {
    type Basis = Fixed<B>;
    type Unknowns = Fixed<2>;
    type Values = Fixed<3>;
    type Solutions = Fixed<MAX>;

    fn sizes(&self) -> SizesOf<Self> {
        Sizes::FIXED
    }

    fn ratios(&self, unknown: usize) -> &[(u16, u16)] {
        [&[(0, 2)], &[(0, 1)]][unknown]
    }

    fn action_matrix<R: Real>(&mut self) -> Result<[[R; B]; B], SolveError> {
        self.calls += 1;
        // 1, y -> y, 3 y - 2.
        Ok([[0.0, 1.0], [-2.0, 3.0]].map(|row| row.map(R::from_f64)))
    }

    fn monomial_values<S: Scalar>(&self, _value: S, vector: &[S; B]) -> [S; 3] {
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
    for (x, count) in [([1.0, 3.0], 2), ([1.0, 0.0], 1), ([1.0, 1e-20], 1), ([-1e-17, 1e-20], 0), ([1.0, 1e-6], 2)] {
        let mut points = TwoPoints::<B> { x, calls: 0 };
        let real = real_solutions(&mut points).unwrap();
        let all = complex_solutions(&mut points).unwrap();
        assert_eq!((real.len(), all.len()), (count, count), "{x:?}: {real:?}");
    }
}

/// x = 1, .., 16, by the companion matrix of their polynomial: rounding errors leave ten digits of
/// few of its eigenvalues (Wilkinson 1963). Action x; basis 1, x, .., x^15. The polish improves
/// nothing.
struct Wilkinson<const MAX: usize = ROOTS> {
    /// Whether the elimination can be repeated with precise coefficients.
    is_precise: bool,
    /// Whether `f64` does not suffice for the action matrix.
    is_singular: bool,
    /// How often the action matrix was computed.
    calls: usize,
    /// Smaller solutions are excluded.
    above: f64,
}

const ROOTS: usize = 16;

impl<const MAX: usize> Wilkinson<MAX> {
    /// Regular, with the solutions above that number.
    fn above(above: f64) -> Self {
        Self { is_precise: false, is_singular: false, calls: 0, above }
    }
}

impl<const MAX: usize> SolverInstance for Wilkinson<MAX> {
    type Basis = Fixed<ROOTS>;
    type Unknowns = Fixed<1>;
    type Values = Fixed<ROOTS>;
    type Solutions = Fixed<MAX>;

    fn sizes(&self) -> SizesOf<Self> {
        Sizes::FIXED
    }

    fn ratios(&self, _unknown: usize) -> &[(u16, u16)] {
        &[(0, 1)]
    }

    fn has_precise_coefficients(&self) -> bool {
        self.is_precise
    }

    fn action_matrix<R: Real>(&mut self) -> Result<[[R; ROOTS]; ROOTS], SolveError> {
        self.calls += 1;
        if self.is_singular && R::EPSILON == f64::EPSILON {
            return Err(DEGENERATE);
        }
        // (x - 1) .. (x - 16) has integer coefficients below 2^53.
        let mut lower = [0.0; ROOTS];
        lower[0] = 1.0;
        for root in 1..=ROOTS {
            let before = lower;
            for k in 0..ROOTS {
                let shifted = if k > 0 { before[k - 1] } else { 0.0 };
                lower[k] = shifted - root as f64 * before[k];
            }
        }
        let mut action = [[R::ZERO; ROOTS]; ROOTS];
        for k in 0..ROOTS - 1 {
            action[k][k + 1] = R::ONE;
        }
        action[ROOTS - 1] = lower.map(|c| R::from_f64(-c));
        Ok(action)
    }

    fn monomial_values<S: Scalar>(&self, _value: S, vector: &[S; ROOTS]) -> [S; ROOTS] {
        *vector
    }

    fn recover<S: Scalar>(&self, _unknowns: &mut [S; 1]) {}

    fn polish<S: Scalar>(&self, [x]: &mut [S; 1], _steps: usize) -> f64 {
        let nearest = (1..=ROOTS).map(|root| (*x - S::from_f64(root as f64)).modulus()).fold(f64::INFINITY, f64::min);
        nearest / x.modulus()
    }

    fn is_admissible<S: Scalar>(&self, [x]: &[S; 1]) -> bool {
        x.real() > self.above
    }
}

/// What the singular examples report.
const DEGENERATE: SolveError = SolveError::Degenerate { block: 3 };

#[test]
fn what_rounding_errors_lose_is_found_at_twice_the_precision() {
    let action = Wilkinson::<ROOTS>::above(0.0).action_matrix::<f64>().unwrap();
    let once = Hessenberg::reduce(&action).unwrap();
    let lost = once.eigenvalues().unwrap().iter().filter(|x| (x.re - x.re.round()).abs() > 1e-6).count();
    assert!(lost > 4, "the example is too easy: {lost}");

    let mut problem = Wilkinson::<ROOTS>::above(0.0);
    let all = complex_solutions(&mut problem).unwrap();
    assert_eq!((all.len(), problem.calls), (ROOTS, 2), "{all:?}");

    // Of real ones 2 is found at first, and an odd number of others cannot all be complex. As 1 is
    // excluded, one is missing at twice the precision, too, and the first attempt is completed.
    let mut problem = Wilkinson::<ROOTS>::above(1.5);
    let real = real_solutions(&mut problem).unwrap();
    assert_eq!((real.len(), problem.calls), (ROOTS - 1, 3), "{real:?}");
}

#[test]
fn what_is_singular_to_rounding_is_solved_with_precise_coefficients_only() {
    let mut rounded = Wilkinson::<ROOTS> { is_singular: true, ..Wilkinson::above(0.0) };
    assert_eq!(complex_solutions(&mut rounded), Err(DEGENERATE));
    assert_eq!(real_solutions(&mut rounded), Err(DEGENERATE));
    assert_eq!(rounded.calls, 2);

    let mut precise = Wilkinson::<ROOTS> { is_precise: true, ..rounded };
    precise.calls = 0;
    let all = complex_solutions(&mut precise).unwrap();
    let real = real_solutions(&mut precise).unwrap();
    assert_eq!((all.len(), real.len(), precise.calls), (ROOTS, ROOTS, 4));
}

/// Where |B| exceeds the number of solutions all eigenvalues are tried, and the number of missing
/// solutions need not be odd: x = 1 is excluded, and of the other fifteen fourteen are lost at
/// first.
#[test]
fn solutions_are_counted_where_some_eigenvalues_belong_to_none() {
    let mut problem = Wilkinson::<{ ROOTS - 1 }>::above(1.5);
    let real = real_solutions(&mut problem).unwrap();
    assert_eq!((real.len(), problem.calls), (ROOTS - 1, 2), "{real:?}");
}

#[test]
fn what_is_complete_is_not_done_twice() {
    let mut points = TwoPoints::<B> { x: [1.0, 3.0], calls: 0 };
    let real = real_solutions(&mut points).unwrap();
    assert_eq!((real.len(), points.calls), (B, 1));
    let all = complex_solutions(&mut points).unwrap();
    assert_eq!((all.len(), points.calls), (B, 2));
    // There are fewer solutions than eigenvalues.
    let mut points = TwoPoints::<1> { x: [1.0, 0.0], calls: 0 };
    let real = real_solutions(&mut points).unwrap();
    assert_eq!((real.len(), points.calls), (1, 1));
}

/// Solutions x = 2 + i, 2 - i; action x; basis 1, x, x^2, with 1 as a third eigenvalue. MAX
/// solutions are known.
struct Spurious<const MAX: usize> {
    /// At 1, before the polish and after it.
    residual: f64,
    /// How often 1 was polished.
    polished: Cell<usize>,
}

impl<const MAX: usize> Spurious<MAX> {
    fn new(residual: f64) -> Self {
        Self { residual, polished: Cell::new(0) }
    }
}

impl<const MAX: usize> SolverInstance for Spurious<MAX> {
    type Basis = Fixed<3>;
    type Unknowns = Fixed<1>;
    type Values = Fixed<3>;
    type Solutions = Fixed<MAX>;

    fn sizes(&self) -> SizesOf<Self> {
        Sizes::FIXED
    }

    fn ratios(&self, _unknown: usize) -> &[(u16, u16)] {
        &[(0, 1)]
    }

    fn action_matrix<R: Real>(&mut self) -> Result<[[R; 3]; 3], SolveError> {
        // x^3 = 5 x^2 - 9 x + 5.
        Ok([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [5.0, -9.0, 5.0]].map(|row| row.map(R::from_f64)))
    }

    fn monomial_values<S: Scalar>(&self, _value: S, vector: &[S; 3]) -> [S; 3] {
        *vector
    }

    fn recover<S: Scalar>(&self, _unknowns: &mut [S; 1]) {}

    fn polish<S: Scalar>(&self, [x]: &mut [S; 1], steps: usize) -> f64 {
        let x = x.to_complex();
        match (x.re - 1.0).hypot(x.im) < 1e-8 {
            true => {
                self.polished.update(|count| count + usize::from(steps > 0));
                self.residual
            }
            false => (x.re - 2.0).hypot(x.im.abs() - 1.0),
        }
    }

    fn is_admissible<S: Scalar>(&self, _unknowns: &[S; 1]) -> bool {
        true
    }
}

#[test]
fn of_too_many_solutions_that_with_the_largest_residual_is_none() {
    let spurious = &mut Spurious::<2>::new(1e-11);
    let all = complex_solutions(spurious).unwrap();
    assert!(all.len() == 2 && all.iter().all(|[x]| x.im != 0.0), "{all:?}");
    let real = real_solutions(spurious).unwrap();
    assert!(real.is_empty(), "{real:?}");
    let real = real_solutions(&mut Spurious::<3>::new(1e-11)).unwrap();
    assert_eq!(real.len(), 1, "{real:?}");
}

#[test]
fn what_belongs_to_no_solution_is_not_polished_once_all_are_found() {
    let polished = |residual, solve: fn(&mut Spurious<2>) -> usize| {
        let mut spurious = Spurious::new(residual);
        let found = solve(&mut spurious);
        (found, spurious.polished.get() > 0)
    };
    let complex = |spurious: &mut Spurious<2>| complex_solutions(spurious).unwrap().len();
    let real = |spurious: &mut Spurious<2>| real_solutions(spurious).unwrap().len();
    assert_eq!([polished(1e-2, complex), polished(1e-2, real)], [(2, false), (0, false)]);
    assert_eq!([polished(1e-8, complex), polished(1e-8, real)], [(2, true), (0, true)]);
}

/// Solutions x = 0, 1 and 2; action x; basis x, x^2. The origin is known to be one.
#[derive(Default)]
struct ThroughOrigin {
    attempts: usize,
}

impl SolverInstance for ThroughOrigin {
    type Basis = Fixed<B>;
    type Unknowns = Fixed<1>;
    type Values = Fixed<B>;
    type Solutions = Fixed<3>;

    fn sizes(&self) -> SizesOf<Self> {
        Sizes::FIXED
    }

    fn ratios(&self, _unknown: usize) -> &[(u16, u16)] {
        &[(0, 1)]
    }

    fn has_origin(&self) -> bool {
        true
    }

    fn action_matrix<R: Real>(&mut self) -> Result<[[R; B]; B], SolveError> {
        self.attempts += 1;
        // x^3 = 3 x^2 - 2 x.
        Ok([[0.0, 1.0], [-2.0, 3.0]].map(|row| row.map(R::from_f64)))
    }

    fn monomial_values<S: Scalar>(&self, _value: S, vector: &[S; B]) -> [S; B] {
        *vector
    }

    fn recover<S: Scalar>(&self, _unknowns: &mut [S; 1]) {}

    fn polish<S: Scalar>(&self, [x]: &mut [S; 1], _steps: usize) -> f64 {
        [0.0, 1.0, 2.0].map(|root| (*x - S::from_f64(root)).modulus()).into_iter().fold(f64::INFINITY, f64::min)
    }

    fn is_admissible<S: Scalar>(&self, _unknowns: &[S; 1]) -> bool {
        true
    }
}

#[test]
fn the_origin_is_returned_without_an_eigenpair() {
    let is_all = |found: &mut dyn Iterator<Item = f64>| {
        let mut found: Vec<f64> = found.collect();
        found.sort_by(f64::total_cmp);
        found.len() == 3 && found.iter().zip([0.0, 1.0, 2.0]).all(|(x, root)| (x - root).abs() < 1e-14)
    };
    let mut solver = ThroughOrigin::default();
    let all = complex_solutions(&mut solver).unwrap();
    assert!(is_all(&mut all.iter().map(|[x]| x.re)), "{all:?}");
    let real = real_solutions(&mut solver).unwrap();
    assert!(is_all(&mut real.iter().map(|[x]| *x)), "{real:?}");
    assert_eq!(solver.attempts, 2, "one for the complex and one for the real solutions");
}
