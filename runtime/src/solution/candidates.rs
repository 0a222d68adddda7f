//! From an eigenpair to the list of solutions: unknowns are read off, polished, and kept if the
//! solution is new.

use num_complex::Complex;

use crate::number::Scalar;
use crate::number::scalar::mapped;
use crate::size::{List, Size};
use crate::solution::distinct::{Candidate, DOUBLE, push_distinct};
use crate::solution::extract::unknowns;
use crate::solution::polish::{POLISH_STEPS, STALLED, zero_below_accuracy};
use crate::solution::symmetries::{Image, mapped_by};
use crate::solver_instance::{BasisVector, EigenpairSource, Found, Point, Points, SolverInstance};

/// A solution is kept only if its relative residual is at most this after the polish.
pub const MAX_RESIDUAL: f64 = 1e-10;

/// The collected solutions of a solve: [`AllSolutions`] or [`RealSolutions`].
pub(crate) trait Collection<I: SolverInstance> {
    /// Whether an eigenvalue with im >= 0 may belong to a collected solution.
    fn wants(&self, value: &Complex<f64>) -> bool;

    /// Takes note of the eigenvalues of an attempt, and forgets what those of another one said.
    /// Returns true if they say that all solutions are there already; solutions whose number was in
    /// doubt are forgotten otherwise.
    fn note(&mut self, solver: &I, values: &[Complex<f64>]) -> bool;

    /// Adds the solutions of an eigenvalue with im >= 0; its conjugate stands for the conjugate
    /// solutions. Returns false if an eigenpair gave nothing new, and belongs to no solution that
    /// is left out: it may share its eigenvalue with another one.
    fn add(&mut self, solver: &I, source: &dyn EigenpairSource<I::Basis>, value: Complex<f64>) -> bool;

    /// Adds the solution at a point. Returns false if there is none that is collected.
    #[cfg(feature = "alloc")]
    fn add_point(&mut self, solver: &I, point: Point<I, Complex<f64>>) -> bool;

    /// Whether the solutions of real eigenvalues decide which other eigenvalues are wanted.
    fn tries_real_first(&self) -> bool;

    /// Starts to count complex solutions, too, if eigenvalues turned out to be imprecise, or may be
    /// shared or lost as pairs. Returns true if it does so from now on: every eigenpair must then
    /// be added, known ones again, but for real ones if [`Collection::count_real`] is called.
    fn starts_to_count(&mut self, solver: &I, may_lose_pairs: bool) -> bool;

    /// Counts the real solutions that are known.
    fn count_real(&mut self, solver: &I);

    /// The number of solutions so far: complex ones if they are counted.
    fn count(&self) -> usize;

    /// Whether as many complex solutions were counted as general data have.
    fn has_all(&self) -> bool;

    /// Whether some will be missing if eigenpairs for at most so many complex solutions follow.
    fn will_lack_some(&self, left: usize) -> bool;

    /// Whether the number of solutions shows that some are missing.
    fn lacks_some(&self) -> bool;

    /// Forgets the solutions whose residual is [`STALLED`]: such a point may be none, and stand for
    /// one that is missing.
    fn forget_stalled(&mut self);
}

/// All complex solutions.
pub(crate) struct AllSolutions<I: SolverInstance> {
    pub(super) found: Found<I, Complex<f64>>,
    most: usize,
}

impl<I: SolverInstance> AllSolutions<I> {
    /// The solutions that are known beforehand.
    #[inline]
    pub(crate) fn new(solver: &I) -> Self {
        Self { found: known_beforehand(solver), most: solver.sizes().solutions.get() }
    }

    /// The solutions at which no excluded factor vanishes.
    #[inline]
    pub(crate) fn admissible(self, solver: &I) -> Points<I, Complex<f64>> {
        admissible(solver, &self.found)
    }
}

impl<I: SolverInstance> Collection<I> for AllSolutions<I> {
    #[inline]
    fn wants(&self, _: &Complex<f64>) -> bool {
        true
    }

    #[inline]
    fn note(&mut self, _: &I, _: &[Complex<f64>]) -> bool {
        false
    }

    #[inline(never)]
    fn add(&mut self, solver: &I, source: &dyn EigenpairSource<I::Basis>, value: Complex<f64>) -> bool {
        if value.im != 0.0 {
            let Some(candidate) = polished(solver, source.complex(value)) else { return false };
            return push_both(solver, candidate, &mut self.found);
        }
        let mut candidate = polished(solver, source.real(value.re)).map(|real| as_complex(solver, &real));
        if candidate.is_none() && !images(solver).is_empty() {
            // The square of an unknown may be real and negative. A symmetry then maps the solution
            // to its conjugate.
            candidate = polished(solver, source.complex(value));
        }
        let Some(candidate) = candidate else { return false };
        push_orbit(solver, &candidate, &mut self.found)
    }

    #[cfg(feature = "alloc")]
    fn add_point(&mut self, solver: &I, point: Point<I, Complex<f64>>) -> bool {
        let Some(candidate) = polish_from(solver, point) else { return false };
        // The polish of a real point stays real.
        let real = nearly_real(solver, &candidate).map(|real| as_complex(solver, &real));
        push_orbit(solver, &real.unwrap_or(candidate), &mut self.found);
        true
    }

    #[inline]
    fn tries_real_first(&self) -> bool {
        false
    }

    #[inline]
    fn starts_to_count(&mut self, _: &I, _: bool) -> bool {
        false
    }

    #[inline]
    fn count_real(&mut self, _: &I) {}

    #[inline]
    fn count(&self) -> usize {
        self.found.len()
    }

    #[inline]
    fn has_all(&self) -> bool {
        self.found.len() == self.most
    }

    #[inline]
    fn will_lack_some(&self, left: usize) -> bool {
        self.found.len() + left < self.most
    }

    #[inline]
    fn lacks_some(&self) -> bool {
        self.found.len() < self.most
    }

    #[inline]
    fn forget_stalled(&mut self) {
        self.found.keep(|candidate| candidate.residual <= STALLED);
    }
}

#[inline(never)]
pub(super) fn is_close_to_one<S: Scalar, N: Size>(candidate: &Candidate<S, N>, known: &[Candidate<S, N>]) -> bool {
    known.iter().any(|known| known.close(candidate))
}

/// The solution at which all unknowns that were not eliminated beforehand are 0, if it is one.
#[inline]
pub(super) fn known_beforehand<S: Scalar, I: SolverInstance>(solver: &I) -> Found<I, S> {
    let sizes = solver.sizes();
    let mut known = sizes.solutions.list();
    if solver.has_origin() {
        let mut unknowns = sizes.unknowns.filled(S::ZERO);
        solver.recover(&mut unknowns);
        known.push(Candidate { unknowns, residual: 0.0 });
    }
    known
}

/// Final filter: merging two solutions can produce an excluded solution.
#[inline]
pub(super) fn admissible<S: Scalar, I: SolverInstance>(solver: &I, found: &Found<I, S>) -> Points<I, S> {
    let mut solutions = solver.sizes().solutions.list();
    for candidate in found.iter() {
        if is_admissible(solver, candidate) {
            solutions.push(candidate.unknowns.clone());
        }
    }
    solutions
}

#[inline]
pub(super) fn as_complex<I: SolverInstance>(
    solver: &I,
    real: &Candidate<f64, I::Unknowns>,
) -> Candidate<Complex<f64>, I::Unknowns> {
    let unknowns = mapped(solver.sizes().unknowns, &real.unknowns, |x: f64| Complex::from(x));
    Candidate { unknowns, residual: real.residual }
}

/// Adds a solution and its conjugate. Returns false if one of them is not new.
#[inline]
pub(super) fn push_both<I: SolverInstance>(
    solver: &I,
    candidate: Candidate<Complex<f64>, I::Unknowns>,
    found: &mut Found<I, Complex<f64>>,
) -> bool {
    let other = conjugate(solver, &candidate);
    push_orbit(solver, &candidate, found) & push_orbit(solver, &other, found)
}

#[inline]
fn conjugate<I: SolverInstance>(
    solver: &I,
    candidate: &Candidate<Complex<f64>, I::Unknowns>,
) -> Candidate<Complex<f64>, I::Unknowns> {
    let unknowns = mapped(solver.sizes().unknowns, &candidate.unknowns, |x: Complex<f64>| Scalar::conj(x));
    Candidate { unknowns, residual: candidate.residual }
}

/// The maps that connect the solutions of one eigenpair.
#[inline]
pub(crate) fn images<I: SolverInstance>(solver: &I) -> &[&[Image]] {
    solver.symmetries().map_or(&[], |symmetries| symmetries.images)
}

/// Adds a solution and its images under the symmetries. Returns false if all of them are known.
#[inline]
pub(super) fn push_orbit<S: Scalar, I: SolverInstance>(
    solver: &I,
    candidate: &Candidate<S, I::Unknowns>,
    found: &mut Found<I, S>,
) -> bool {
    let polish = |x: &mut Point<I, S>, steps: usize| solver.polish(x, steps);
    let mut is_new = push_distinct(found, candidate.clone(), polish);
    for images in images(solver) {
        let unknowns = mapped_by(images, &candidate.unknowns);
        is_new |= push_distinct(found, Candidate { unknowns, residual: candidate.residual }, polish);
    }
    is_new
}

/// The real solution that belongs to a complex solution close to its conjugate, if there is one.
/// Their midpoint is their real part, and the same test as in [`push_distinct`] shows a double
/// solution.
#[inline]
pub(super) fn nearly_real<I: SolverInstance>(
    solver: &I,
    complex: &Candidate<Complex<f64>, I::Unknowns>,
) -> Option<Candidate<f64, I::Unknowns>> {
    if !complex.close(&conjugate(solver, complex)) {
        return None;
    }
    let unknowns = mapped(solver.sizes().unknowns, &complex.unknowns, |x: Complex<f64>| x.re);
    polish_from(solver, unknowns).filter(|real| real.residual <= complex.residual.max(DOUBLE))
}

#[inline]
pub(super) fn polished<S: Scalar, I: SolverInstance>(
    solver: &I,
    (value, vector): (S, BasisVector<I, S>),
) -> Option<Candidate<S, I::Unknowns>> {
    polish_from(solver, unknowns(solver, value, &vector)?)
}

/// Whether no excluded factor vanishes. A factor that is an unknown or a product of unknowns is
/// never small relative to its terms. It vanishes if an unknown cannot be told from zero.
#[inline]
fn is_admissible<S: Scalar, I: SolverInstance>(solver: &I, candidate: &Candidate<S, I::Unknowns>) -> bool {
    let unknowns = solver.sizes().unknowns;
    solver.is_admissible(&zero_below_accuracy(unknowns, &candidate.unknowns, candidate.residual))
}

/// The solution that the polish of a point converges to, if there is one.
#[inline]
pub(super) fn polish_from<S: Scalar, I: SolverInstance>(
    solver: &I,
    mut unknowns: Point<I, S>,
) -> Option<Candidate<S, I::Unknowns>> {
    let residual = solver.polish(&mut unknowns, POLISH_STEPS);
    let candidate: Candidate<S, I::Unknowns> = Candidate { unknowns, residual };
    let is_finite = candidate.unknowns.as_ref().iter().all(|x: &S| x.is_finite());
    let good = residual <= MAX_RESIDUAL && is_finite && is_admissible(solver, &candidate);
    good.then_some(candidate)
}
