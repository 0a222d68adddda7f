//! From the action matrix to polished solutions: what all emitted solvers do alike.
//!
//! On a few instances of a thousand a template is so close to singular, or a solution so close to infinity, that rounding errors of the
//! elimination or of the eigenvalues lead to no solution, or to another one. Where solutions are missing, both are therefore repeated with
//! twice the digits; where the elimination itself fails, by solvers whose coefficients can have as many.

use arrayvec::ArrayVec;
use num_complex::Complex;

use crate::candidates::{All, RealAndAll, add_complex, add_real, admissible, flips, known_beforehand};
use crate::double_double::DoubleDouble;
use crate::error::SolveError;
use crate::extract::{Eigenpairs, unknowns};
use crate::hessenberg::{Full, Hessenberg};
use crate::polynomial_roots::real_roots_monic;
use crate::precise_spectrum::{PreciseSpectrum, with_precise_spectrum};
use crate::scalar::{Real, Scalar, mapped};
use crate::shared_value::SharedValue;
use crate::solutions::Solutions;
use crate::symmetry::Symmetry;

/// A solution is kept only if its relative residual is at most this after the polish.
pub const MAX_RESIDUAL: f64 = 1e-10;

/// Where |B| exceeds the number of solutions and all are found, an eigenpair whose unknowns have a larger relative residual before the polish is taken
/// for one that belongs to none. Those of solutions are near rounding, and the polish would take long to show that there is none.
const NO_SOLUTION: f64 = 1e-6;

/// A factor that must not vanish does if its value is at most this, relative to the sum of the moduli of its terms.
pub const VANISHING: f64 = 1e-8;

/// What differs between solvers: |B| = B basis monomials, N unknowns, K monomials whose
/// values follow from an eigenpair.
pub trait ActionMethod<const B: usize, const N: usize, const K: usize> {
    /// For each unknown x the positions of (m, x m) among the known monomials; none where [`ActionMethod::recover`]
    /// gives it.
    const PAIRS: [&'static [(u16, u16)]; N];

    /// Whether all unknowns 0 is a solution, whatever the data. It is known, and the eigenpairs need not give it.
    const HAS_ORIGIN: bool = false;

    /// How unknowns follow from their pairs where the template tells them up to sign.
    const SYMMETRY: Option<Symmetry<N>> = None;

    /// Whether [`ActionMethod::action_matrix`] computes the coefficients in its own precision, too. A template that is singular to `f64` is then eliminated
    /// at twice the precision: exactly degenerate data are singular to both, and of data that are so up to rounding the solutions as they are result.
    const HAS_PRECISE_COEFFICIENTS: bool = false;

    /// The action matrix, |B| rows: T with a b = T b at every solution, b being the values of the basis and a that of the action monomial.
    /// What [`ActionMethod::known`] reads besides is kept.
    ///
    /// # Errors
    /// [`SolveError::Degenerate`] where the template is singular up to rounding.
    fn action_matrix<R: Real>(&mut self) -> Result<[[R; B]; B], SolveError>;

    /// The values of the known monomials from an eigenpair: linear in the vector; those of the image, value times
    /// vector, and only those depend on the value.
    fn known<S: Scalar>(&self, value: S, vector: &[S; B]) -> [S; K];

    /// Fills in the unknowns that follow from those that were read.
    fn recover<S: Scalar>(&self, unknowns: &mut [S; N]);

    /// Polishes on the original equations and returns the relative residual.
    fn polish<S: Scalar>(&self, unknowns: &mut [S; N], steps: usize) -> f64;

    /// Whether no factor that was stated to be nonzero vanishes.
    fn is_admissible<S: Scalar>(&self, unknowns: &[S; N]) -> bool;
}

/// All complex solutions. MAX is how many there are for general data: where some are missing, all is done once more at twice the precision.
///
/// # Errors
/// Those of the action matrix, [`SolveError::NonFiniteInput`] where it is not finite, [`SolveError::NoConvergence`] where the QR iteration
/// reaches its limit; with [`ActionMethod::HAS_PRECISE_COEFFICIENTS`] only where it is so at twice the precision, too.
#[inline]
pub fn complex_solutions<const B: usize, const N: usize, const K: usize, const MAX: usize>(
    method: &mut impl ActionMethod<B, N, K>,
) -> Result<Solutions<[Complex<f64>; N], MAX>, SolveError> {
    let mut found = known_beforehand(method);
    let first = add_all_complex(method, &mut found);
    if found.len() < MAX {
        for_each_precise_value(method, first, &mut |method, source, value| {
            add_complex(method, source, value, &mut found);
        })?;
    }
    Ok(admissible(method, &found))
}

/// What of [`complex_solutions`] the usual precision finds. A function of its own, so that its memory is free for the second attempt.
#[inline(never)]
fn add_all_complex<const B: usize, const N: usize, const K: usize, const MAX: usize>(
    method: &mut impl ActionMethod<B, N, K>,
    found: &mut All<N, MAX>,
) -> Result<(), SolveError> {
    let action = method.action_matrix::<f64>()?;
    let mut spectrum = Hessenberg::zero(Full);
    spectrum.matrix = action;
    spectrum.reduce_in_place()?;
    let values = spectrum.eigenvalues()?;
    if !add_separate_complex(method, &spectrum, &values, found) {
        for_each_shared_value(method, &action, &spectrum, &values, &mut |source, value| {
            add_complex(method, source, value, found);
        });
    }
    Ok(())
}

/// The solutions of separate eigenpairs; false where two of them gave one. A function of its own, so that its memory is free afterwards.
#[inline(never)]
fn add_separate_complex<const B: usize, const N: usize, const K: usize, const MAX: usize>(
    method: &impl ActionMethod<B, N, K>,
    spectrum: &Hessenberg<B>,
    values: &[Complex<f64>; B],
    found: &mut All<N, MAX>,
) -> bool {
    let mut complete = true;
    let mut guesses = ArrayVec::new();
    Guess::push_all(&mut guesses, spectrum, values, &|_| true);
    for (residual, at) in in_order(method, &guesses, has_spurious_values(method, MAX)) {
        let guess = &guesses[at];
        if found.len() == MAX && residual > NO_SOLUTION {
            return true;
        }
        complete &= add_complex(method, guess, guess.value, found);
    }
    complete
}

/// All real solutions, by the QR iteration. MAX is how many complex ones there are for general data: where it shows that some are missing, all
/// is done once more at twice the precision. Where B exceeds MAX complex eigenvalues are tried, too, until all solutions are counted; else
/// solutions that are not real come in pairs, and an odd number is missing.
///
/// # Errors
/// As [`complex_solutions`].
#[inline]
pub fn real_solutions<const B: usize, const N: usize, const K: usize, const MAX: usize>(
    method: &mut impl ActionMethod<B, N, K>,
) -> Result<Solutions<[f64; N], MAX>, SolveError> {
    let has_spurious_values = has_spurious_values(method, MAX);
    let mut found =
        RealAndAll { real: known_beforehand(method), all: has_spurious_values.then(|| known_beforehand(method)) };
    let first = add_all_real(method, &mut found);
    if found.lacks_some() || first.is_err() {
        for_each_precise_value(method, first, &mut |method, source, value| {
            if found.may_be_real(&value) {
                add_real(method, source, value, &mut found);
            }
        })?;
    }
    found.drop_spurious();
    Ok(admissible(method, &found.real))
}

/// What of [`real_solutions`] the usual precision finds. A function of its own, so that its memory is free for the second attempt.
#[inline(never)]
fn add_all_real<const B: usize, const N: usize, const K: usize, const MAX: usize>(
    method: &mut impl ActionMethod<B, N, K>,
    found: &mut RealAndAll<N, MAX>,
) -> Result<(), SolveError> {
    let action = method.action_matrix::<f64>()?;
    let mut spectrum = Hessenberg::zero(Full);
    spectrum.matrix = action;
    spectrum.reduce_in_place()?;
    let values = spectrum.eigenvalues()?;
    if !add_separate_real(method, &spectrum, &values, found) {
        for_each_shared_value(method, &action, &spectrum, &values, &mut |source, value| {
            if found.may_be_real(&value) {
                add_real(method, source, value, found);
            }
        });
    }
    Ok(())
}

/// As [`add_separate_complex`].
#[inline(never)]
fn add_separate_real<const B: usize, const N: usize, const K: usize, const MAX: usize>(
    method: &impl ActionMethod<B, N, K>,
    spectrum: &Hessenberg<B>,
    values: &[Complex<f64>; B],
    found: &mut RealAndAll<N, MAX>,
) -> bool {
    let mut complete = true;
    let mut guesses = ArrayVec::new();
    Guess::push_all(&mut guesses, spectrum, values, &|value| found.may_be_real(value));
    for (residual, at) in in_order(method, &guesses, found.all.is_some()) {
        let guess = &guesses[at];
        if found.all.as_ref().is_some_and(|all| all.len() == MAX) && residual > NO_SOLUTION {
            return true;
        }
        complete &= add_real(method, guess, guess.value, found);
    }
    complete
}

/// Whether some eigenvalues belong to no solution, or to one that is known beforehand.
#[inline]
fn has_spurious_values<const B: usize, const N: usize, const K: usize, M: ActionMethod<B, N, K>>(
    method: &M,
    solutions: usize,
) -> bool {
    B * (1 + flips(method).len()) + usize::from(M::HAS_ORIGIN) > solutions
}

/// An eigenvalue and its eigenvector, from which a solution may be read.
struct Guess<const B: usize> {
    value: Complex<f64>,
    /// Real for a real eigenvalue.
    vector: [Complex<f64>; B],
}

impl<const B: usize> Guess<B> {
    /// Adds those of the eigenvalues that are wanted. Of a conjugate pair one is solved for and the other follows.
    #[inline(never)]
    fn push_all(
        guesses: &mut ArrayVec<Self, B>,
        spectrum: &Hessenberg<B>,
        values: &[Complex<f64>; B],
        is_wanted: &dyn Fn(&Complex<f64>) -> bool,
    ) {
        for &value in values {
            if value.im >= 0.0 && is_wanted(&value) {
                guesses.push(Self::new(spectrum, value));
            }
        }
    }

    #[inline]
    fn new(spectrum: &Hessenberg<B>, value: Complex<f64>) -> Self {
        let vector = match value.im == 0.0 {
            true => mapped(&spectrum.eigenvector(value.re), Complex::from),
            false => spectrum.eigenvector(value),
        };
        Self { value, vector }
    }

    /// The relative residual before the polish.
    #[inline]
    fn residual<const N: usize, const K: usize>(&self, method: &impl ActionMethod<B, N, K>) -> f64 {
        match self.value.im == 0.0 {
            true => residual_of(method, self.real(self.value.re)),
            false => residual_of(method, self.complex(self.value)),
        }
    }
}

#[inline]
fn residual_of<S: Scalar, const B: usize, const N: usize, const K: usize>(
    method: &impl ActionMethod<B, N, K>,
    (value, vector): (S, [S; B]),
) -> f64 {
    unknowns(method, value, &vector).map_or(f64::INFINITY, |mut unknowns| method.polish(&mut unknowns, 0))
}

impl<const B: usize> Eigenpairs<B> for Guess<B> {
    fn real(&self, value: f64) -> (f64, [f64; B]) {
        (value, mapped(&self.vector, |entry| entry.re))
    }

    fn complex(&self, value: Complex<f64>) -> (Complex<f64>, [Complex<f64>; B]) {
        (value, self.vector)
    }
}

/// The residuals of guesses and which they are, in the order in which they are tried: where some belong to no solution, those that do come first. Elsewhere
/// residuals are not needed, and zero.
#[inline]
fn in_order<const B: usize, const N: usize, const K: usize>(
    method: &impl ActionMethod<B, N, K>,
    guesses: &[Guess<B>],
    has_spurious_values: bool,
) -> ArrayVec<(f64, usize), B> {
    let mut order = ArrayVec::new();
    for (at, guess) in guesses.iter().enumerate() {
        order.push((if has_spurious_values { guess.residual(method) } else { 0.0 }, at));
    }
    if has_spurious_values {
        sort(&mut order);
    }
    order
}

/// A function of its own: compiled once for all solvers.
#[inline(never)]
fn sort(order: &mut [(f64, usize)]) {
    order.sort_unstable_by(|(a, _), (b, _)| a.total_cmp(b));
}

/// All real solutions, at most MAX, by the real roots of the characteristic polynomial.
///
/// # Errors
/// Those of the action matrix, [`SolveError::NonFiniteInput`] where it is not finite.
#[inline]
pub fn real_solutions_by_polynomial<const B: usize, const N: usize, const K: usize, const MAX: usize>(
    method: &mut impl ActionMethod<B, N, K>,
) -> Result<Solutions<[f64; N], MAX>, SolveError> {
    let action = method.action_matrix::<f64>()?;
    let spectrum = Hessenberg::reduce(&action)?;
    let mut found = RealAndAll::<N, MAX> { real: known_beforehand(method), all: None };
    for value in real_roots_monic(&spectrum.characteristic_polynomial()) {
        let guess = Guess::new(&spectrum, value.into());
        add_real(method, &guess, guess.value, &mut found);
    }
    Ok(admissible(method, &found.real))
}

/// Calls `solve` for the eigenpairs of all eigenvalues that several solutions may share.
#[cold]
#[inline(never)]
fn for_each_shared_value<const B: usize, const N: usize, const K: usize>(
    method: &impl ActionMethod<B, N, K>,
    action: &[[f64; B]; B],
    spectrum: &Hessenberg<B>,
    values: &[Complex<f64>; B],
    solve: &mut dyn FnMut(&dyn Eigenpairs<B>, Complex<f64>),
) {
    let mut basis = [[0.0; B]; B];
    let mut combination = Hessenberg::zero(Full);
    let mut shared = SharedValue::new(action, &mut basis, &mut combination);
    for cluster in spectrum.clusters(values) {
        if shared.find(method, spectrum, &cluster).is_ok() {
            shared.for_each(&mut |source, value| {
                if value.im >= 0.0 {
                    solve(source, value);
                }
            });
        }
    }
}

/// What is done with the eigenvalues of the second attempt.
type SolvePrecise<'a, const B: usize, M> = &'a mut dyn FnMut(&M, &dyn Eigenpairs<B>, Complex<f64>);

/// Repeats the elimination and the eigenvalue iteration at twice the precision and calls `solve` for each eigenvalue with im >= 0; for none where
/// one of the two fails.
///
/// # Errors
/// That of the `first` attempt, where this one fails, too, or the coefficients are no more precise.
#[cold]
#[inline(never)]
fn for_each_precise_value<const B: usize, const N: usize, const K: usize, M: ActionMethod<B, N, K>>(
    method: &mut M,
    first: Result<(), SolveError>,
    solve: SolvePrecise<'_, B, M>,
) -> Result<(), SolveError> {
    if first.is_err() && !M::HAS_PRECISE_COEFFICIENTS {
        return first;
    }
    // Not moved out of its result, which would take its size from the stack twice.
    let action = method.action_matrix::<DoubleDouble>();
    let Ok(action) = &action else { return first };
    let solve_all = &mut |spectrum: &PreciseSpectrum<'_>| {
        for &value in spectrum.eigenvalues {
            if value.im >= 0.0 {
                solve(method, spectrum, value);
            }
        }
    };
    with_precise_spectrum(action.as_flattened(), B, solve_all).or(first)
}
