//! Real solutions by the real roots of a determinant: no eigenvalue is computed, unless it cannot
//! be told whether the roots are all there.
//!
//! ```text
//!   action matrix ──► det M(x) ──► real roots ──► null vectors ──► polish ──► certain? ──► solutions
//!        ▲                                                                       │ no
//!        └──── the same, at twice the precision ◄── lacks some? ◄── eigenvalues ◄┘
//! ```
//!
//! In the usual precision, eigenvalues show at less expense than the determinant at twice the
//! precision what is missing. At twice the precision, the determinant takes a tenth of the time of
//! the eigenvalue iteration, which comes last.

use num_complex::Complex;

use crate::driver::solve;
use crate::error::SolveError;
use crate::number::double_double::DoubleDouble;
use crate::number::scalar::{Real, mapped};
use crate::size::{List, Size, Square};
use crate::solution::candidates::{Collection, IMPRECISE, IMPRECISE_ROOT, RealSolutions};
use crate::solver_instance::{EigenpairSource, HiddenVariableSolver, Points};
use crate::spectrum::hidden_variable::{ChainedBasis, HiddenVariable};
use crate::spectrum::real_roots::{CLOSEST, Limits, USUAL, real_roots_within};
use crate::spectrum::root_count::{LEAST_ERROR, SAFETY, count_is_certain};

/// A determinant without real roots is certain to have none if errors of its coefficients that
/// could give it one are larger than this, relative to them.
pub(crate) const CLEARANCE: f64 = 1e-6;

/// What is believed of a determinant that was computed with numbers of this precision.
struct Trust {
    /// Which of its roots are told apart.
    limits: Limits,
    /// Relative errors of its coefficients that are never excluded.
    least_error: f64,
    /// The same if it has no root that shows its errors.
    least_clearance: f64,
}

/// The errors of the elimination are in the coefficients.
const OF_USUAL: Trust = Trust { limits: USUAL, least_error: LEAST_ERROR, least_clearance: CLEARANCE };

/// They are far below rounding, and rounding to `f64` is left, with that of the Bernstein basis.
const OF_TWICE: Trust = Trust { limits: CLOSEST, least_error: 1e-13, least_clearance: 1e-13 };

/// Steps of Newton's method from a root of the rounded determinant to one at twice the precision.
const NEWTON_STEPS: usize = 2;

/// Returns all real solutions, by the real roots of a determinant. If a root is not certain, or
/// leads to no solution of its own, or the polish moves one so far that errors of the determinant
/// could hide others, or there is no root and presolve divided by a number close to zero, all is
/// done as by [`real_solutions`](crate::driver::real_solutions). If that lacks solutions, the
/// determinant is computed at twice the precision, before eigenvalues are.
///
/// # Errors
/// As [`real_solutions`](crate::driver::real_solutions).
#[inline]
pub fn real_solutions_by_determinant<I: HiddenVariableSolver>(solver: &mut I) -> Result<Points<I, f64>, SolveError> {
    let action = solver.action_matrix::<f64>();
    if let Ok(action) = &action {
        let mut found = RealSolutions::new(solver, false);
        if add_roots(solver, action, &mut found, &OF_USUAL) {
            return Ok(found.admissible(solver));
        }
    }
    let (mut found, mut by_roots) = (RealSolutions::new(solver, false), None);
    solve(solver, &mut found, action.as_ref().ok(), &mut |solver| {
        let mut found = RealSolutions::new(solver, false);
        let action = solver.action_matrix::<DoubleDouble>();
        let is_certain = action.is_ok_and(|action| add_roots(solver, &action, &mut found, &OF_TWICE));
        by_roots = is_certain.then_some(found);
        is_certain
    })?;
    Ok(by_roots.unwrap_or(found).admissible(solver))
}

/// Adds the solutions of all real roots of the determinant. Returns false if it cannot be told
/// whether these are all real solutions.
#[inline(never)]
fn add_roots<I: HiddenVariableSolver, R: Real>(
    solver: &I,
    action: &Square<I::Basis, R>,
    found: &mut RealSolutions<I>,
    trust: &Trust,
) -> bool {
    let chains = solver.chains();
    let (basis, _, _, size) = chains.sizes();
    let Some(variable) = HiddenVariable::new(&chains, action) else { return false };
    let precise = variable.determinant();
    let determinant = mapped(size, &precise, R::real);
    let roots = real_roots_within(size, &determinant, trust.limits);
    let is_sure = !roots.roots.is_empty() || has_no_root(solver, action, roots.clearance, trust);
    let mut is_certain = roots.is_certain && is_sure;
    let mut moved = size.list();
    let (mut is_precise, mut error) = (true, trust.least_error);
    for &root in roots.roots.iter() {
        let source = HiddenPair { basis, variable: &variable, root: precise_root(size, &precise, root) };
        is_certain = is_certain && found.add(solver, &source, root.into()) && found.moved() <= IMPRECISE;
        is_precise &= found.moved() <= IMPRECISE_ROOT;
        error = error.max(SAFETY * found.moved());
        moved.push((root, found.moved()));
    }
    is_precise &= roots.clearance > error;
    let count = || is_precise || count_is_certain(size, &determinant, &moved, trust.least_error);
    is_certain && !found.is_imprecise() && count()
}

/// Whether a determinant without a root is certain to have none: no polish shows whether it is
/// precise. It is a sum of products of an entry of each chain's row, which may be much larger than
/// the sum.
fn has_no_root<I: HiddenVariableSolver, R: Real>(
    solver: &I,
    action: &Square<I::Basis, R>,
    clearance: f64,
    trust: &Trust,
) -> bool {
    let (_, count, ..) = solver.chains().sizes();
    let entries = action.as_ref().iter().flat_map(|row| row.as_ref());
    let largest = entries.fold(1.0, |largest: f64, x| largest.max(x.modulus()));
    let error = (0..count.get()).fold(R::EPSILON, |error, _| error * largest);
    clearance > trust.least_clearance.max(error) && !solver.has_large_quotients()
}

/// The root of the determinant near one of the rounded determinant. In the usual precision it is
/// that root.
#[inline]
fn precise_root<Z: Size, R: Real>(size: Z, determinant: &Z::Vector<R>, root: f64) -> R {
    let mut x = R::from_f64(root);
    for _ in 0..if R::EPSILON < f64::EPSILON { NEWTON_STEPS } else { 0 } {
        let (mut value, mut slope) = (R::ZERO, R::ZERO);
        for k in (0..size.get()).rev() {
            slope = slope * x + value;
            value = value * x + determinant[k];
        }
        x = x - value / slope;
    }
    x
}

/// The eigenpair of a root.
struct HiddenPair<'a, 'c, H: ChainedBasis, R: Real> {
    basis: H::Basis,
    variable: &'a HiddenVariable<'c, H, R>,
    root: R,
}

impl<H: ChainedBasis, R: Real> EigenpairSource<H::Basis> for HiddenPair<'_, '_, H, R> {
    fn real(&self, _: f64) -> (f64, <H::Basis as Size>::Vector<f64>) {
        (self.root.real(), mapped(self.basis, &self.variable.vector(self.root), R::real))
    }

    fn complex(&self, _: Complex<f64>) -> (Complex<f64>, <H::Basis as Size>::Vector<Complex<f64>>) {
        let vector = self.variable.vector(self.root);
        (self.root.to_complex(), mapped(self.basis, &vector, |entry: R| entry.to_complex()))
    }
}
