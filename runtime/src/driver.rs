//! From the action matrix to polished solutions: the steps that all solvers share.
//!
//! On a few of a thousand instances, a template is so close to singular, or a solution so close to
//! infinity, that rounding errors of the elimination or of the eigenvalues lose the solution or
//! lead to another one. If solutions are missing, both steps are therefore repeated with twice the
//! digits. An elimination that fails is repeated only if the coefficients can be computed with
//! twice the digits, too. If it fails again, the template stands for nothing at these data, and
//! solutions are followed from data nearby.

use num_complex::Complex;

#[cfg(feature = "alloc")]
use crate::continuation::{
    family::Family,
    path::DataPath,
    track::{Tracker, is_affordable},
};
use crate::error::SolveError;
use crate::number::Scalar;
use crate::number::double_double::DoubleDouble;
use crate::number::scalar::mapped;
use crate::size::{List, Size, Square, filled_matrix};
use crate::solution::candidates::{AllSolutions, Collection, images};
use crate::solution::extract::unknowns;
use crate::solution::real_solutions::RealSolutions;
use crate::solution::shared_value::SharedValue;
use crate::solver_instance::{BasisVector, EigenpairSource, Points, SolverInstance};
use crate::spectrum::hessenberg::Hessenberg;
use crate::spectrum::inverse_iteration::ShiftedLu;
use crate::spectrum::precise_spectrum::{PreciseSpectrum, Row, with_precise_spectrum};

/// If |B| exceeds the number of solutions and all solutions are found, an eigenpair with a larger
/// relative residual than this before the polish counts as spurious. Residuals of solutions are
/// near rounding, and the polish of a spurious eigenpair would take long.
const NO_SOLUTION: f64 = 1e-6;

/// A factor that must not vanish counts as zero if its modulus is at most this, relative to the sum
/// of the moduli of its terms.
pub const VANISHING: f64 = 1e-8;

/// Returns all complex solutions. If fewer are found than general data have, a second attempt
/// computes at twice the precision.
///
/// # Errors
/// Errors of the action matrix, [`SolveError::Overflow`] if it is not finite,
/// [`SolveError::NoConvergence`] if the QR iteration reaches its limit. With
/// [`SolverInstance::has_precise_coefficients`] an error is returned only if the second attempt
/// fails, too.
#[inline]
pub fn complex_solutions<I: SolverInstance>(solver: &mut I) -> Result<Points<I, Complex<f64>>, SolveError> {
    let mut found = AllSolutions::new(solver);
    solve(solver, &mut found, None)?;
    Ok(found.admissible(solver))
}

/// Returns all real solutions, by the QR iteration. If solutions are missing, a second attempt
/// computes at twice the precision. If |B| exceeds the number of solutions, or if the polish moves
/// a solution far, complex solutions are counted, too, which shows whether some are missing.
/// Otherwise the number of real eigenvalues and eigenvalues without a solution show it: solutions
/// that are not real come in pairs.
///
/// # Errors
/// As [`complex_solutions`].
#[inline]
pub fn real_solutions<I: SolverInstance>(solver: &mut I) -> Result<Points<I, f64>, SolveError> {
    let mut found = RealSolutions::new(solver, has_spurious_values(solver));
    solve(solver, &mut found, None)?;
    Ok(found.admissible(solver))
}

/// Whether some eigenvalues belong to no solution, or to a solution that is known beforehand.
#[inline]
fn has_spurious_values<I: SolverInstance>(solver: &I) -> bool {
    let sizes = solver.sizes();
    sizes.basis.get() * (1 + images(solver).len()) + usize::from(solver.has_origin()) > sizes.solutions.get()
}

/// Collects the solutions, in one attempt or two, from the action matrix if it is known.
#[inline]
pub(crate) fn solve<I: SolverInstance>(
    solver: &mut I,
    found: &mut dyn Collection<I>,
    action: Option<&Square<I::Basis, f64>>,
) -> Result<(), SolveError> {
    let may_repeat = solver.allows_second_attempt();
    let mut known = solver.sizes().basis.list();
    let first = match action {
        Some(action) => from_action(solver, action, found, (&mut known, may_repeat)),
        None => first_attempt(solver, found, (&mut known, may_repeat)),
    };
    if may_repeat {
        found.forget_stalled();
    }
    if !(may_repeat && (first.is_err() || found.lacks_some())) {
        return first.map(|_| ());
    }
    if first.is_err() {
        found.starts_to_count(solver, solver.has_large_quotients());
    }
    let can_repeat = first.is_ok() || solver.has_precise_coefficients();
    let is_repeated = can_repeat && second_attempt(solver, found, &known).is_ok();
    match first {
        _ if is_repeated && !found.lacks_some() => Ok(()),
        Ok(may_lose_some) => {
            // It may have stopped early.
            first_attempt(solver, found, (&mut known, false))?;
            if may_lose_some && found.lacks_some() {
                continued(solver, found);
            }
            Ok(())
        }
        Err(_) if continued(solver, found) || is_repeated => Ok(()),
        Err(error) => Err(error),
    }
}

/// General data nearby differ from given ones by so much, relative to them. If a template is close
/// to singular there, too, it is not further away.
#[cfg(feature = "alloc")]
const DISTANCES: [f64; 2] = [0.125, 0.5];

/// Data above this are no measurements in any unit, and nothing near them is general.
#[cfg(feature = "alloc")]
const LARGEST_DATUM: f64 = 1e8;

/// If so many paths are lost before one gives a solution, the data are degenerate for the problem,
/// too: solutions fill curves. Samples of RANSAC often are, and should not take long.
#[cfg(feature = "alloc")]
const LOST_AT_FIRST: u32 = 3;

/// Adds the solutions at the ends of paths that begin at general data nearby. Returns false if
/// there are none. There may be none that is real: this is known only if all paths have isolated
/// ends.
#[cfg(feature = "alloc")]
#[cold]
#[inline(never)]
fn continued<I: SolverInstance>(solver: &mut I, found: &mut dyn Collection<I>) -> bool {
    let paths = solver.sizes().solutions.get();
    let is_ordinary = |family: &Family<'_>| family.data.iter().all(|x| x.abs() <= LARGEST_DATUM);
    if !solver.family().is_some_and(|family| is_ordinary(&family) && is_affordable(&family, paths)) {
        return false;
    }
    for (&distance, seed) in DISTANCES.iter().zip(1..) {
        let Some(path) = solver.family().map(|family| DataPath::new(&family, distance, seed)) else { return false };
        solver.move_to(&path.start());
        let start = general_solutions(solver);
        solver.move_to(path.target());
        let (Some(start), Some(family)) = (start, solver.family()) else { continue };
        let (mut tracker, mut has_some, mut lost) = (Tracker::new(&family, &path), false, 0);
        for start in start.iter() {
            let Some(end) = tracker.end_of_path(start.as_ref()) else {
                lost += 1;
                if lost == LOST_AT_FIRST && !has_some {
                    return false;
                }
                continue;
            };
            let mut point = solver.sizes().unknowns.filled(Complex::ZERO);
            point.as_mut().iter_mut().zip(end).for_each(|(x, end)| *x = end);
            has_some |= found.add_point(solver, point);
        }
        return has_some || lost == 0;
    }
    false
}

/// Without a heap there is no continuation.
#[cfg(not(feature = "alloc"))]
fn continued<I: SolverInstance>(_: &mut I, _: &mut dyn Collection<I>) -> bool {
    false
}

/// All solutions of general data by one attempt, or `None` if some are missing.
#[cfg(feature = "alloc")]
fn general_solutions<I: SolverInstance>(solver: &mut I) -> Option<Points<I, Complex<f64>>> {
    let mut found = AllSolutions::new(solver);
    let outcome = first_attempt(solver, &mut found, (&mut solver.sizes().basis.list(), false));
    (outcome.is_ok() && !found.lacks_some()).then(|| found.admissible(solver))
}

/// Eigenvalues that led to solutions.
type Known<I> = <<I as SolverInstance>::Basis as Size>::List<Complex<f64>>;

/// Entries of an action matrix above this belong to a template that is close to singular: an
/// eigenvalue is far out, and may stand for an infinite one.
const FAR_OUT: f64 = 1e8;

/// Whether a template with this action matrix is close to singular.
fn is_far_out<B: Size, S: Scalar>(action: &Square<B, S>) -> bool {
    action.as_ref().iter().any(|row| row.as_ref().iter().any(|entry| entry.modulus() > FAR_OUT))
}

/// Collects what the usual precision finds. It is a function of its own, so that its memory is free
/// for the second attempt. See [`from_action`].
#[inline(never)]
fn first_attempt<I: SolverInstance>(
    solver: &mut I,
    found: &mut dyn Collection<I>,
    known: (&mut Known<I>, bool),
) -> Result<bool, SolveError> {
    let action = solver.action_matrix::<f64>()?;
    from_action(solver, &action, found, known)
}

/// Collects the solutions of an action matrix, and the eigenvalues that led to them. With
/// `may_stop` it ends as soon as it is known that solutions will be missing: polishes that fail
/// take long, and so do solutions that share an eigenvalue. Returns whether solutions may have no
/// eigenpair, or one without digits.
#[inline(never)]
fn from_action<I: SolverInstance>(
    solver: &I,
    action: &Square<I::Basis, f64>,
    found: &mut dyn Collection<I>,
    (known, may_stop): (&mut Known<I>, bool),
) -> Result<bool, SolveError> {
    let mut spectrum = Hessenberg::zero(solver.sizes().basis);
    spectrum.matrix = action.clone();
    spectrum.reduce_in_place()?;
    let values = spectrum.eigenvalues()?;
    if found.note(solver, values.as_ref()) {
        return Ok(false);
    }
    let in_order: &[Part] = if found.tries_real_first() { &[REAL, COMPLEX] } else { &[ALL] };
    let mut is_complete = add_separate(solver, (&spectrum, &values), found, (known, may_stop), in_order);
    let may_lose_some = solver.has_large_quotients()
        || solver.loses_zeros() && is_far_out::<I::Basis, _>(action)
        || solver.misreads_zeros() && !is_complete;
    if found.starts_to_count(solver, may_lose_some) {
        // Where signs can be changed, a real eigenvalue may belong to solutions that are not real.
        let again = if images(solver).is_empty() { COMPLEX } else { ALL };
        if images(solver).is_empty() {
            found.count_real(solver);
        }
        known.keep(|value| !again(value));
        is_complete &= add_separate(solver, (&spectrum, &values), found, (known, may_stop), &[again]);
        is_complete |= found.has_all();
    }
    if !(is_complete || may_stop && found.lacks_some()) {
        add_shared(solver, action, (&spectrum, &values), found);
    }
    Ok(may_lose_some)
}

/// Eigenvalues with im >= 0 that are tried together.
type Part = fn(&Complex<f64>) -> bool;

const ALL: Part = |value| value.im >= 0.0;
const REAL: Part = |value| value.im == 0.0;
const COMPLEX: Part = |value| value.im > 0.0;

/// Adds the solutions of separate eigenpairs, part by part, and their eigenvalues to those known.
/// What real solutions show decides which others are wanted. Returns false if two eigenpairs gave
/// the same solution, or if it stopped early because the eigenpairs that are left are too few. It
/// is a function of its own, so that its memory is free afterwards.
#[inline(never)]
fn add_separate<I: SolverInstance>(
    solver: &I,
    (spectrum, values): (&Hessenberg<I::Basis>, &BasisVector<I, Complex<f64>>),
    found: &mut dyn Collection<I>,
    (known, may_stop): (&mut Known<I>, bool),
    parts: &[Part],
) -> bool {
    let size = solver.sizes().basis;
    let mut pairs = size.list();
    let each = 1 + images(solver).len();
    let solutions_of = |pair: &EigenpairOf<I::Basis>| if pair.value.im == 0.0 { each } else { 2 * each };
    let mut complete = true;
    for (at, part) in parts.iter().enumerate() {
        let first = pairs.len();
        push_eigenpairs(&mut pairs, spectrum, values.as_ref(), &|value| part(value) && found.wants(value));
        if at + 1 == parts.len() && pairs.is_empty() {
            push_witness(&mut pairs, spectrum, values.as_ref());
        }
        let mut left = pairs[first..].iter().map(solutions_of).sum::<usize>();
        for &(residual, at) in in_order(solver, &pairs[first..]).iter() {
            if found.has_all() && residual > NO_SOLUTION {
                return true;
            }
            if may_stop && found.will_lack_some(left) {
                return false;
            }
            let (pair, count) = (&pairs[first + at], found.count());
            left -= solutions_of(pair);
            complete &= found.add(solver, &Listed { size, pair }, pair.value);
            if found.count() > count {
                known.push(pair.value);
            }
        }
    }
    complete
}

/// An eigenvalue and its eigenvector, from which a solution may be read.
struct Eigenpair<V> {
    value: Complex<f64>,
    /// The vector is real for a real eigenvalue.
    vector: V,
}

/// The eigenpair of a basis of this size.
type EigenpairOf<B> = Eigenpair<<B as Size>::Vector<Complex<f64>>>;

/// An eigenpair of a list, as a source.
struct Listed<'a, B: Size> {
    size: B,
    pair: &'a EigenpairOf<B>,
}

/// Adds the eigenpairs of the eigenvalues that are wanted, which have im >= 0. One vector of a
/// conjugate pair is computed, and the other follows from it.
#[inline(never)]
fn push_eigenpairs<B: Size>(
    pairs: &mut B::List<EigenpairOf<B>>,
    spectrum: &Hessenberg<B>,
    values: &[Complex<f64>],
    is_wanted: &dyn Fn(&Complex<f64>) -> bool,
) {
    let (size, mut real, mut complex) = (spectrum.size, None, None);
    for &value in values.iter().filter(|value| is_wanted(value)) {
        let vector = match value.im == 0.0 {
            true => {
                let memory = real.get_or_insert_with(|| ShiftedLu::new(size));
                let vector = spectrum.eigenvector_in(memory, value.re);
                mapped(size, &vector, |entry: f64| Complex::from(entry))
            }
            false => spectrum.eigenvector_in(complex.get_or_insert_with(|| ShiftedLu::new(size)), value),
        };
        pairs.push(Eigenpair { value, vector });
    }
}

/// Adds the eigenpair of the eigenvalue closest to a real one, a witness of whether eigenvalues are
/// precise where none is wanted.
#[cold]
#[inline(never)]
fn push_witness<B: Size>(pairs: &mut B::List<EigenpairOf<B>>, spectrum: &Hessenberg<B>, values: &[Complex<f64>]) {
    let angle = |value: &&Complex<f64>| value.im / value.re.abs();
    let upper = values.iter().filter(|value| value.im > 0.0);
    if let Some(&value) = upper.min_by(|a, b| angle(a).total_cmp(&angle(b))) {
        pairs.push(Eigenpair { value, vector: spectrum.eigenvector(value) });
    }
}

impl<B: Size> Listed<'_, B> {
    /// The relative residual before the polish.
    #[inline]
    fn residual<I: SolverInstance<Basis = B>>(&self, solver: &I) -> f64 {
        let Eigenpair { value, vector } = self.pair;
        match value.im == 0.0 {
            true => {
                let (value, vector) = self.real(value.re);
                residual_of(solver, value, &vector)
            }
            false => residual_of(solver, *value, vector),
        }
    }
}

#[inline]
fn residual_of<S: Scalar, I: SolverInstance>(solver: &I, value: S, vector: &BasisVector<I, S>) -> f64 {
    unknowns(solver, value, vector).map_or(f64::INFINITY, |mut unknowns| solver.polish(&mut unknowns, 0))
}

impl<B: Size> EigenpairSource<B> for Listed<'_, B> {
    fn real(&self, value: f64) -> (f64, B::Vector<f64>) {
        (value, mapped(self.size, &self.pair.vector, |entry: Complex<f64>| entry.re))
    }

    fn complex(&self, value: Complex<f64>) -> (Complex<f64>, B::Vector<Complex<f64>>) {
        (value, self.pair.vector.clone())
    }
}

/// The residuals of eigenpairs and their positions, in the order in which they are tried. If some
/// eigenpairs belong to no solution, the order is that of increasing residuals. Otherwise residuals
/// are not needed and zero.
#[inline]
fn in_order<I: SolverInstance>(solver: &I, pairs: &[EigenpairOf<I::Basis>]) -> <I::Basis as Size>::List<(f64, usize)> {
    let has_spurious_values = has_spurious_values(solver);
    let size = solver.sizes().basis;
    let mut order = size.list();
    for (at, pair) in pairs.iter().enumerate() {
        order.push((if has_spurious_values { Listed { size, pair }.residual(solver) } else { 0.0 }, at));
    }
    if has_spurious_values {
        sort(&mut order);
    }
    order
}

/// A function of its own is compiled once for all solvers.
#[inline(never)]
fn sort(order: &mut [(f64, usize)]) {
    order.sort_unstable_by(|(a, _), (b, _)| a.total_cmp(b));
}

/// Adds the solutions of eigenvalues that several solutions may share.
#[cold]
#[inline(never)]
fn add_shared<I: SolverInstance>(
    solver: &I,
    action: &Square<I::Basis, f64>,
    (spectrum, values): (&Hessenberg<I::Basis>, &BasisVector<I, Complex<f64>>),
    found: &mut dyn Collection<I>,
) {
    let size = solver.sizes().basis;
    let mut basis = filled_matrix(size, size, 0.0);
    let mut combination = Hessenberg::zero(size);
    let mut shared = SharedValue::new(size, action, &mut basis, &mut combination);
    for cluster in spectrum.clusters(values).iter() {
        if shared.find(solver, spectrum, cluster).is_ok() {
            shared.for_each(&mut |source, value| {
                if value.im >= 0.0 && found.wants(&value) {
                    found.add(solver, source, value);
                }
            });
        }
    }
}

/// Repeats the elimination and the eigenvalue iteration at twice the precision and adds the
/// solutions. Eigenvectors and polishes take most of the time, so eigenvalues that are closest to
/// known ones, whose solutions are found, come last, and are left out once all are counted.
///
/// # Errors
/// As the first attempt.
#[cold]
#[inline(never)]
fn second_attempt<I: SolverInstance>(
    solver: &mut I,
    found: &mut dyn Collection<I>,
    known: &[Complex<f64>],
) -> Result<(), SolveError> {
    // The matrix stays in its result: a move would take its size from the stack twice.
    let action = solver.action_matrix::<DoubleDouble>();
    let action = action.as_ref().map_err(|&error| error)?;
    let solver = &*solver;
    // Parity does not tell that a pair of solutions is lost.
    if is_far_out::<I::Basis, _>(action) {
        found.starts_to_count(solver, true);
    }
    let size = solver.sizes().basis;
    let add_all = &mut |spectrum: &PreciseSpectrum<'_>| {
        found.note(solver, spectrum.eigenvalues);
        let source = PreciseEigenpairs { size, spectrum };
        let mut order = size.list();
        for (at, value) in spectrum.eigenvalues.iter().enumerate().filter(|(_, value)| value.im >= 0.0) {
            order.push((-distance_to_one(value, known), at));
        }
        sort(&mut order);
        for &(_, at) in order.iter() {
            let value = spectrum.eigenvalues[at];
            if found.has_all() {
                break;
            }
            if found.wants(&value) {
                found.add(solver, &source, value);
            }
        }
    };
    let (order, row): (_, Row<'_>) = (size.get(), &|at| action[at].as_ref());
    with_precise_spectrum(order, row, solver.memory(), add_all)
}

/// The distance to the nearest of the known eigenvalues, relative to the eigenvalue.
#[inline(never)]
fn distance_to_one(value: &Complex<f64>, known: &[Complex<f64>]) -> f64 {
    let nearest = known.iter().map(|other| (value - other).l1_norm()).fold(f64::INFINITY, f64::min);
    nearest / value.l1_norm()
}

/// The eigenpairs of the second attempt, listed under the eigenvalues.
struct PreciseEigenpairs<'a, B> {
    size: B,
    spectrum: &'a PreciseSpectrum<'a>,
}

impl<B: Size> EigenpairSource<B> for PreciseEigenpairs<'_, B> {
    fn real(&self, value: f64) -> (f64, B::Vector<f64>) {
        let (_, vector) = self.complex(value.into());
        (value, mapped(self.size, &vector, |entry: Complex<f64>| entry.re))
    }

    fn complex(&self, value: Complex<f64>) -> (Complex<f64>, B::Vector<Complex<f64>>) {
        let mut vector = self.size.filled(Complex::ZERO);
        self.spectrum.eigenvector(value, vector.as_mut());
        (value, vector)
    }
}
