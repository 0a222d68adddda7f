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
use crate::number::Scalar;
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
    /// Whether they may be larger, as the polish of its roots shows.
    may_err_more: bool,
}

/// Errors of the elimination are in the coefficients.
const OF_USUAL: Trust = Trust { limits: USUAL, least_error: LEAST_ERROR, may_err_more: true };

/// Relative errors of coefficients that are rounded to `f64`, and then written in the Bernstein
/// basis.
const ROUNDED: f64 = 1e-13;

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
    let action = action.as_ref().ok();
    let mut found = RealSolutions::new(solver, false);
    match action.map_or(Verdict::Useless, |action| add_roots(solver, action, &mut found, &OF_USUAL)) {
        Verdict::Complete => return Ok(found.admissible(solver)),
        Verdict::NumberInDoubt => found.doubt_number(),
        Verdict::Useless => found = RealSolutions::new(solver, false),
    }
    let mut precise = None;
    solve(solver, &mut found, action, &mut |solver| {
        precise = action.and_then(|action| precise_solutions(solver, action));
        precise.is_some()
    })?;
    Ok(precise.unwrap_or(found).admissible(solver))
}

/// The solutions by the determinant at twice the precision; `None` if it cannot be told whether
/// they are all real solutions.
///
/// A coefficient is a sum of products that may be much larger than the sum. The relative error of
/// the usual precision is its difference from the precise one, and may be above 1. As products of
/// both precisions are the same, that at twice the precision is smaller by as many digits as an
/// `f64` has. The polish does not show it, but errors of the equations: their coefficients have the
/// usual precision.
#[cold]
#[inline(never)]
fn precise_solutions<I: HiddenVariableSolver>(
    solver: &mut I,
    usual: &Square<I::Basis, f64>,
) -> Option<RealSolutions<I>> {
    let action = solver.action_matrix::<DoubleDouble>().ok()?;
    let chains = solver.chains();
    let usual = HiddenVariable::new(&chains, usual)?.determinant();
    let precise = HiddenVariable::new(&chains, &action)?.determinant();
    let relative = |(&usual, precise): (&f64, &DoubleDouble)| (usual - precise.real()).abs() / precise.modulus();
    let error = usual.as_ref().iter().zip(precise.as_ref()).map(relative).fold(0.0, f64::max);
    let least_error = ROUNDED.max(SAFETY * f64::EPSILON * error);
    let mut found = RealSolutions::new(solver, false);
    let trust = Trust { limits: CLOSEST, least_error, may_err_more: false };
    matches!(add_roots(solver, &action, &mut found, &trust), Verdict::Complete).then_some(found)
}

/// What the solutions of the roots are worth.
enum Verdict {
    /// They are all real solutions.
    Complete,
    /// Each root has a solution of its own, but errors of the determinant may hide others.
    NumberInDoubt,
    /// Some roots have none, or are too close to be told apart, or the polish moves one far.
    Useless,
}

/// Adds the solutions of all real roots of the determinant.
#[inline(never)]
fn add_roots<I: HiddenVariableSolver, R: Real>(
    solver: &I,
    action: &Square<I::Basis, R>,
    found: &mut RealSolutions<I>,
    trust: &Trust,
) -> Verdict {
    let chains = solver.chains();
    let (basis, _, _, size) = chains.sizes();
    let Some(variable) = HiddenVariable::new(&chains, action) else { return Verdict::Useless };
    let precise = variable.determinant();
    let determinant = mapped(size, &precise, R::real);
    let roots = real_roots_within(size, &determinant, trust.limits);
    let is_sure = !roots.roots.is_empty() || has_no_root(solver, action, roots.clearance);
    let mut are_solutions = roots.is_certain && is_sure;
    let (mut moved, mut is_precise, mut error) = (size.list(), true, trust.least_error);
    for &root in roots.roots.iter() {
        let source = HiddenPair { basis, variable: &variable, root: precise_root(size, &precise, root) };
        are_solutions = are_solutions && found.add(solver, &source, root.into()) && found.moved() <= IMPRECISE;
        if trust.may_err_more {
            is_precise &= found.moved() <= IMPRECISE_ROOT;
            error = error.max(SAFETY * found.moved());
            moved.push((root, found.moved()));
        }
    }
    is_precise &= roots.clearance > error;
    let count = || is_precise || count_is_certain(size, &determinant, &moved, trust.least_error);
    match are_solutions && !found.is_imprecise() {
        true if count() => Verdict::Complete,
        true => Verdict::NumberInDoubt,
        false => Verdict::Useless,
    }
}

/// Whether a determinant without a root is certain to have none: no polish shows whether it is
/// precise. It is a sum of products of an entry of each chain's row, which may be much larger than
/// the sum.
fn has_no_root<I: HiddenVariableSolver, R: Real>(solver: &I, action: &Square<I::Basis, R>, clearance: f64) -> bool {
    let (_, count, ..) = solver.chains().sizes();
    let entries = action.as_ref().iter().flat_map(|row| row.as_ref());
    let largest = entries.fold(1.0, |largest: f64, x| largest.max(x.modulus()));
    let error = (0..count.get()).fold(R::EPSILON, |error, _| error * largest);
    clearance > CLEARANCE.max(error) && !solver.has_large_quotients()
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
