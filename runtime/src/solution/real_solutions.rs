//! Collects the real solutions.

use num_complex::Complex;

use crate::number::{Scalar, float};
use crate::size::{List, Size};
use crate::solution::candidates::{
    AllSolutions, Collection, admissible, as_complex, images, is_close_to_one, known_beforehand, nearly_real,
    polish_from, polished, push_both, push_orbit,
};
use crate::solution::distinct::Candidate;
use crate::solution::extract::unknowns;
use crate::solution::polish::STALLED;
#[cfg(feature = "alloc")]
use crate::solver_instance::Point;
use crate::solver_instance::{BasisVector, EigenpairSource, Found, Points, SolverInstance};

/// An eigenvalue whose imaginary part is at most this, relative to its modulus, may belong to a
/// real solution, because rounding splits a pair of close real eigenvalues into a complex one, far
/// apart if the template is close to singular. If |B| exceeds the number of solutions, any
/// eigenvalue may belong to a real solution: spurious eigenvalues are often close together and far
/// less precise, and perturb others.
const NEARLY_REAL: f64 = 0.1;

/// An error e of eigenvalues, seen in the polish, splits a pair of real ones by about the square
/// root of e, relative to their modulus. An eigenvalue further from the real axis than this times
/// the root is no such one. The factor is large, because the error of close eigenvalues may be
/// larger than that of others.
const SPLIT: f64 = 100.0;

/// Rounding splits a real eigenvalue that four solutions share into complex ones this close to the
/// real axis, relative to their modulus, or closer: the fourth root of the last digit, times ten.
const SHARED: f64 = 1e-3;

/// If the polish moves a real solution by more than this part of an unknown, the eigenvalues are
/// imprecise, and those of a pair of real solutions may be complex, far from the real axis. So is a
/// root of a determinant that it moves by more than this part of itself.
pub(crate) const IMPRECISE: f64 = 1e-4;
/// If it moves no root of a determinant by more than this part of itself, the coefficients are
/// precise: an error of this size in them moves two roots by about 3e-4 if they are close to each
/// other, and closer ones are not certain.
pub(crate) const IMPRECISE_ROOT: f64 = 1e-7;
/// An unknown may be moved by this part of the largest unknown, relative to the bound.
pub(crate) const IMPRECISE_FLOOR: f64 = 1e-2;

/// The largest errors of the eigenvalues that led to solutions: how far the polish moves the action
/// monomial.
#[derive(Clone, Copy, Default)]
struct EigenvalueError {
    absolute: f64,
    /// Relative to the eigenvalue.
    relative: f64,
}

/// The real solutions.
pub(crate) struct RealSolutions<I: SolverInstance> {
    real: Found<I, f64>,
    /// All complex solutions, if they are counted. If |B| exceeds the number of solutions, only the
    /// count tells whether a spurious eigenpair replaces a missing solution. If eigenvalues are
    /// imprecise, only the count tells whether a pair of real solutions became complex.
    all: Option<AllSolutions<I>>,
    most: usize,
    /// The number of real solutions, if each eigenvalue belongs to one: those known beforehand and
    /// those of real eigenvalues.
    expected: Option<usize>,
    /// Whether an eigenvalue that is nearly real led to no solution.
    has_failed: bool,
    /// The part of itself by which the polish moved the action monomial of the last solution, 0 if
    /// it found none.
    moved: f64,
    /// Whether it moved one by more than [`IMPRECISE`].
    is_imprecise: bool,
    /// How far it moved the action monomials of all solutions of the attempt so far; `None` before
    /// the first.
    error: Option<EigenvalueError>,
    /// Whether an eigenvalue gave nothing new, or may be real up to rounding, where signs can be
    /// changed and the number of real eigenvalues says nothing of that of real solutions.
    may_share: bool,
    /// Whether the solutions come from the roots of a determinant, of which it is in doubt whether
    /// they are all.
    has_doubtful_number: bool,
}

impl<I: SolverInstance> RealSolutions<I> {
    /// The solutions that are known beforehand.
    #[inline]
    pub(crate) fn new(solver: &I, counts_complex: bool) -> Self {
        Self {
            real: known_beforehand(solver),
            all: counts_complex.then(|| AllSolutions::new(solver)),
            most: solver.sizes().solutions.get(),
            expected: None,
            has_failed: false,
            moved: 0.0,
            is_imprecise: false,
            error: None,
            may_share: false,
            has_doubtful_number: false,
        }
    }

    /// Says that only the number of solutions is in doubt: eigenvalues may confirm it.
    #[inline]
    pub(crate) fn doubt_number(&mut self) {
        self.has_doubtful_number = true;
        self.error = None;
    }

    /// How far from the real axis, relative to its modulus, an eigenvalue may be that belongs to a
    /// real solution.
    #[inline]
    fn reach(&self, value: &Complex<f64>) -> f64 {
        let Some(EigenvalueError { absolute, relative }) = self.error else { return NEARLY_REAL };
        (SPLIT * float::sqrt(f64::max(absolute / value.re.abs(), relative))).clamp(SHARED, NEARLY_REAL)
    }

    /// Whether there is a solution for each real eigenvalue, and none of the others is nearly real.
    #[inline]
    fn are_all(&self, values: &[Complex<f64>]) -> bool {
        let are_clear = values.iter().all(|value| value.im <= 0.0 || !Collection::<I>::wants(self, value));
        are_clear && self.expected == Some(self.real.len()) && !self.lacks_some()
    }

    /// Whether a real eigenvalue belongs to solutions that are not real, because the square of an
    /// unknown is negative.
    #[inline]
    fn is_imaginary(&self, solver: &I, source: &dyn EigenpairSource<I::Basis>, value: Complex<f64>) -> bool {
        !images(solver).is_empty() && polished(solver, source.complex(value)).is_some()
    }

    /// Whether the polish moved an unknown of a solution so far that others may be missing.
    #[inline]
    pub(crate) fn is_imprecise(&self) -> bool {
        self.is_imprecise
    }

    /// The part of itself by which the polish moved the action monomial of the last solution, 0 if
    /// it found none. Where the action monomial is not one of unknowns, that of an unknown.
    #[inline]
    pub(crate) fn moved(&self) -> f64 {
        self.moved
    }

    /// The solutions at which no excluded factor vanishes. If all complex solutions are known, a
    /// real solution that is not among them is spurious.
    #[inline]
    pub(crate) fn admissible(mut self, solver: &I) -> Points<I, f64> {
        if let Some(all) = self.all.as_ref().filter(|all| all.found.len() == self.most) {
            let mut known = solver.sizes().solutions.list();
            for real in self.real.iter() {
                if is_close_to_one(&as_complex(solver, real), &all.found) {
                    known.push(real.clone());
                }
            }
            self.real = known;
        }
        admissible(solver, &self.real)
    }

    /// As the function of this name. It notes whether the polish moves the solution far.
    #[inline]
    fn polished<S: Scalar>(
        &mut self,
        solver: &I,
        (value, vector): (S, BasisVector<I, S>),
    ) -> Option<Candidate<S, I::Unknowns>> {
        self.moved = 0.0;
        let start = unknowns(solver, value, &vector)?;
        let end = polish_from(solver, start.clone())?;
        let start = Candidate { unknowns: start, residual: f64::INFINITY };
        let moved = end.distance(&start, IMPRECISE_FLOOR);
        self.is_imprecise |= !(moved <= IMPRECISE && end.residual <= STALLED);
        let off = |action: S| (action - value).modulus() / action.modulus();
        self.moved = solver.action_value(&end.unknowns).map_or(moved, off);
        let (size, error) = (value.modulus(), self.error.unwrap_or_default());
        self.error = Some(EigenvalueError {
            absolute: error.absolute.max(self.moved * size),
            relative: error.relative.max(self.moved),
        });
        Some(end)
    }
}

impl<I: SolverInstance> Collection<I> for RealSolutions<I> {
    #[inline]
    fn wants(&self, value: &Complex<f64>) -> bool {
        self.all.is_some() || value.im <= self.reach(value) * value.re.abs()
    }

    #[inline]
    fn note(&mut self, solver: &I, values: &[Complex<f64>]) -> bool {
        (self.has_failed, self.error) = (false, None);
        if self.all.is_none() && images(solver).is_empty() {
            let real = values.iter().filter(|value| value.im == 0.0);
            self.expected = Some(usize::from(solver.has_origin()) + real.count());
        }
        if self.has_doubtful_number && !self.are_all(values) {
            *self = Self { expected: self.expected, ..Self::new(solver, false) };
        }
        core::mem::take(&mut self.has_doubtful_number)
    }

    /// The result is also false for a complex eigenvalue, because its conjugate may stand for one
    /// more solution.
    #[inline(never)]
    fn add(&mut self, solver: &I, source: &dyn EigenpairSource<I::Basis>, value: Complex<f64>) -> bool {
        if value.im == 0.0 {
            let candidate = self.polished(solver, source.real(value.re));
            match (&mut self.all, &candidate) {
                (Some(all), Some(candidate)) => {
                    push_orbit(solver, &as_complex(solver, candidate), &mut all.found);
                }
                (Some(all), None) if !images(solver).is_empty() => {
                    all.add(solver, source, value);
                }
                _ => {}
            }
            let is_new = match &candidate {
                Some(candidate) => push_orbit(solver, candidate, &mut self.real),
                None => self.all.is_none() && self.is_imaginary(solver, source, value),
            };
            self.may_share |= !is_new && !images(solver).is_empty();
            return is_new;
        }
        self.may_share |= value.im <= SHARED * value.re.abs() && !images(solver).is_empty();
        let Some(candidate) = self.polished(solver, source.complex(value)) else {
            self.has_failed = true;
            return false;
        };
        let real = nearly_real(solver, &candidate);
        if let Some(all) = &mut self.all {
            push_both(solver, candidate, &mut all.found);
        }
        if let Some(real) = real {
            push_orbit(solver, &real, &mut self.real);
        }
        false
    }

    #[cfg(feature = "alloc")]
    fn add_point(&mut self, solver: &I, point: Point<I, Complex<f64>>) -> bool {
        let Some(candidate) = polish_from(solver, point) else { return false };
        let real = nearly_real(solver, &candidate);
        if let Some(real) = &real {
            push_orbit(solver, real, &mut self.real);
        }
        if let Some(all) = &mut self.all {
            let complex = real.as_ref().map(|real| as_complex(solver, real));
            push_orbit(solver, &complex.unwrap_or(candidate), &mut all.found);
        }
        real.is_some()
    }

    #[inline]
    fn tries_real_first(&self) -> bool {
        self.all.is_none()
    }

    #[inline]
    fn starts_to_count(&mut self, solver: &I, may_lose_pairs: bool) -> bool {
        let starts = (self.is_imprecise || self.may_share || may_lose_pairs) && self.all.is_none();
        if starts {
            self.all = Some(AllSolutions::new(solver));
        }
        starts
    }

    #[inline]
    fn count_real(&mut self, solver: &I) {
        if let Some(all) = &mut self.all {
            for real in self.real.iter() {
                push_orbit(solver, &as_complex(solver, real), &mut all.found);
            }
        }
    }

    #[inline]
    fn count(&self) -> usize {
        self.all.as_ref().map_or(self.real.len(), |all| all.found.len())
    }

    #[inline]
    fn has_all(&self) -> bool {
        self.all.as_ref().is_some_and(|all| all.has_all())
    }

    #[inline]
    fn will_lack_some(&self, left: usize) -> bool {
        self.all.as_ref().map_or(self.has_failed, |all| all.will_lack_some(left))
    }

    /// Solutions that are not real come in pairs. If they are not counted, some are lost if the
    /// number of missing real solutions is odd, if there are not as many as expected, or if an
    /// eigenvalue led to no solution.
    #[inline]
    fn lacks_some(&self) -> bool {
        match &self.all {
            Some(all) => all.lacks_some(),
            None => {
                let is_odd = !(self.most - self.real.len()).is_multiple_of(2);
                is_odd || self.has_failed || self.expected.is_some_and(|count| count != self.real.len())
            }
        }
    }

    #[inline]
    fn forget_stalled(&mut self) {
        let count = self.real.len();
        self.real.keep(|candidate| candidate.residual <= STALLED);
        self.has_failed |= self.real.len() < count;
        if let Some(all) = &mut self.all {
            all.forget_stalled();
        }
    }
}
