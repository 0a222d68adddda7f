//! Real solutions by the real roots of a determinant: no eigenvalue is computed, unless it cannot
//! be told whether the roots are all there.
//!
//! ```text
//!   action matrix ──► det M(x) ──► real roots ──► null vectors ──► polish ──► certain? ──► done
//!        │                                                                       │ no
//!        └────────────────────────────► eigenvalues: as many real ones? ◄────────┘
//!                                            │ no
//!                                            └──► their vectors, polish, second attempts
//! ```

use num_complex::Complex;

use crate::driver::solve;
use crate::error::SolveError;
use crate::number::scalar::mapped;
use crate::size::{List, Size, Square};
use crate::solution::candidates::Collection;
use crate::solution::real_solutions::{IMPRECISE, IMPRECISE_ROOT, RealSolutions};
use crate::solver_instance::{EigenpairSource, HiddenVariableSolver, Points};
use crate::spectrum::hidden_variable::{ChainedBasis, HiddenVariable};
use crate::spectrum::real_roots::real_roots;
use crate::spectrum::root_count::{LEAST_ERROR, SAFETY, count_is_certain};

/// A determinant without real roots is certain to have none if errors of its coefficients that
/// could give it one are larger than this, relative to them.
pub(crate) const CLEARANCE: f64 = 1e-6;

/// What the solutions of the roots are worth.
enum Verdict {
    /// They are all real solutions.
    Complete,
    /// Each root has a solution of its own, but errors of the determinant may hide others.
    NumberInDoubt,
    /// Some roots have none, or are too close to be told apart, or the polish moves one far.
    Useless,
}

/// Returns all real solutions, by the real roots of a determinant. If each root leads to a solution
/// of its own, but the polish moves one so far that errors of the determinant could hide others,
/// eigenvalues may confirm their number. If they do not, or a root is not certain or has no such
/// solution, or there is no root and presolve divided by a number close to zero, all is done as by
/// [`real_solutions`](crate::driver::real_solutions).
///
/// # Errors
/// As [`real_solutions`](crate::driver::real_solutions).
#[inline]
pub fn real_solutions_by_determinant<I: HiddenVariableSolver>(solver: &mut I) -> Result<Points<I, f64>, SolveError> {
    let action = solver.action_matrix::<f64>();
    let action = action.as_ref().ok();
    let mut found = RealSolutions::new(solver, false);
    match action.map_or(Verdict::Useless, |action| add_roots(solver, action, &mut found)) {
        Verdict::Complete => return Ok(found.admissible(solver)),
        Verdict::NumberInDoubt => found.doubt_number(),
        Verdict::Useless => found = RealSolutions::new(solver, false),
    }
    solve(solver, &mut found, action)?;
    Ok(found.admissible(solver))
}

/// Adds the solutions of all real roots of the determinant.
#[inline(never)]
fn add_roots<I: HiddenVariableSolver>(
    solver: &I,
    action: &Square<I::Basis, f64>,
    found: &mut RealSolutions<I>,
) -> Verdict {
    let chains = solver.chains();
    let (basis, _, _, size) = chains.sizes();
    let Some(variable) = HiddenVariable::new(&chains, action) else { return Verdict::Useless };
    let determinant = variable.determinant();
    let roots = real_roots(size, &determinant);
    let source = HiddenPairs { basis, variable: &variable };
    let has_roots = !roots.roots.is_empty();
    let mut are_solutions = roots.is_certain && (has_roots || has_no_root(solver, action, roots.clearance));
    let (mut moved, mut is_precise, mut error) = (size.list(), true, LEAST_ERROR);
    for &root in roots.roots.iter() {
        are_solutions = are_solutions && found.add(solver, &source, root.into()) && found.moved() <= IMPRECISE;
        is_precise &= found.moved() <= IMPRECISE_ROOT;
        error = error.max(SAFETY * found.moved());
        moved.push((root, found.moved()));
    }
    is_precise &= roots.clearance > error;
    match are_solutions && !found.is_imprecise() {
        true if is_precise || count_is_certain(size, &determinant, &moved) => Verdict::Complete,
        true => Verdict::NumberInDoubt,
        false => Verdict::Useless,
    }
}

/// Whether a determinant without a root is certain to have none: no polish shows whether it is
/// precise. It is a sum of products of an entry of each chain's row, which may be much larger than
/// the sum.
fn has_no_root<I: HiddenVariableSolver>(solver: &I, action: &Square<I::Basis, f64>, clearance: f64) -> bool {
    let (_, count, ..) = solver.chains().sizes();
    let entries = action.as_ref().iter().flat_map(|row| row.as_ref());
    let largest = entries.fold(1.0, |largest: f64, x| largest.max(x.abs()));
    let error = (0..count.get()).fold(f64::EPSILON, |error, _| error * largest);
    clearance > CLEARANCE.max(error) && !solver.has_large_quotients()
}

/// The eigenpairs of the real roots.
struct HiddenPairs<'a, 'c, H: ChainedBasis> {
    basis: H::Basis,
    variable: &'a HiddenVariable<'c, H>,
}

impl<H: ChainedBasis> EigenpairSource<H::Basis> for HiddenPairs<'_, '_, H> {
    fn real(&self, value: f64) -> (f64, <H::Basis as Size>::Vector<f64>) {
        (value, self.variable.vector(value))
    }

    fn complex(&self, value: Complex<f64>) -> (Complex<f64>, <H::Basis as Size>::Vector<Complex<f64>>) {
        let (_, vector) = self.real(value.re);
        (value, mapped(self.basis, &vector, |entry: f64| Complex::from(entry)))
    }
}
