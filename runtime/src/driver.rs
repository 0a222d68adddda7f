//! From the action matrix to polished solutions: what all emitted solvers do alike.
//!
//! On a few instances of a thousand a template is so close to singular, or a solution so close to infinity, that rounding errors of the
//! elimination or of the eigenvalues lead to no solution, or to another one. Where solutions are missing, both are therefore repeated with
//! twice the digits; where the elimination itself fails, by solvers whose coefficients can have as many.

use arrayvec::ArrayVec;
use num_complex::Complex;

use crate::distinct::{Candidate, DOUBLE, push_distinct};
use crate::double_double::DoubleDouble;
use crate::error::SolveError;
use crate::extract::{Eigenpairs, unknowns};
use crate::hessenberg::{Full, Hessenberg};
use crate::polish::{POLISH_STEPS, without_uncertain};
use crate::polynomial_roots::real_roots_monic;
use crate::precise_spectrum::{PreciseSpectrum, with_precise_spectrum};
use crate::scalar::{Real, Scalar, mapped};
use crate::shared_value::{Combinations, SharedValue};
use crate::solutions::Solutions;
use crate::symmetry::{Symmetry, flipped};

/// A solution is kept only if its relative residual is at most this after the polish.
pub const MAX_RESIDUAL: f64 = 1e-10;

/// An eigenvalue whose imaginary part is at most this, relative to its modulus, may belong to a real solution:
/// rounding splits a pair of close real eigenvalues into a complex one. Where |B| exceeds the number of solutions any
/// eigenvalue may: those that belong to no solution are often close together, far less precise, and take others along.
const NEARLY_REAL: f64 = 1e-3;

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
        for_each_precise_value(method, first, |method, source, value| {
            add_complex(method, source, value, &mut found);
        })?;
    }
    Ok(admissible(method, &found))
}

/// What of [`complex_solutions`] the usual precision finds. A function of its own, so that its memory is free for the second attempt.
#[inline(never)]
fn add_all_complex<const B: usize, const N: usize, const K: usize, const MAX: usize>(
    method: &mut impl ActionMethod<B, N, K>,
    found: &mut Solutions<Candidate<Complex<f64>, N>, MAX>,
) -> Result<(), SolveError> {
    let action = method.action_matrix::<f64>()?;
    let mut spectrum = Hessenberg::zero(Full);
    spectrum.matrix = action;
    spectrum.reduce_in_place()?;
    let values = spectrum.eigenvalues()?;
    if !add_separate_complex(method, &spectrum, &values, found) {
        for_each_shared_value(method, &action, &spectrum, &values, |source, value| {
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
    found: &mut Solutions<Candidate<Complex<f64>, N>, MAX>,
) -> bool {
    let mut complete = true;
    let guesses: ArrayVec<_, B> = upper_half(*values).map(|value| Guess::new(spectrum, value)).collect();
    for (residual, guess) in in_order(method, &guesses, has_spurious_values(method, MAX)) {
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
        for_each_precise_value(method, first, |method, source, value| {
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
        for_each_shared_value(method, &action, &spectrum, &values, |source, value| {
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
    let may_be_real = upper_half(*values).filter(|value| found.may_be_real(value));
    let guesses: ArrayVec<_, B> = may_be_real.map(|value| Guess::new(spectrum, value)).collect();
    for (residual, guess) in in_order(method, &guesses, found.all.is_some()) {
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

/// The origin, where it is a solution.
#[inline]
fn known_beforehand<
    S: Scalar,
    const B: usize,
    const N: usize,
    const K: usize,
    const MAX: usize,
    M: ActionMethod<B, N, K>,
>(
    _: &M,
) -> Solutions<Candidate<S, N>, MAX> {
    M::HAS_ORIGIN.then_some(Candidate { unknowns: [S::ZERO; N], residual: 0.0 }).into_iter().collect()
}

/// An eigenvalue and its eigenvector, from which a solution may be read.
struct Guess<const B: usize> {
    value: Complex<f64>,
    /// Real for a real eigenvalue.
    vector: [Complex<f64>; B],
}

impl<const B: usize> Guess<B> {
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
    fn residual<S: Scalar, const N: usize, const K: usize>(&self, method: &impl ActionMethod<B, N, K>) -> f64 {
        let (value, vector) = self.eigenpair(S::from_complex(self.value));
        unknowns(method, value, &vector).map_or(f64::INFINITY, |mut unknowns| method.polish(&mut unknowns, 0))
    }
}

impl<const B: usize> Eigenpairs<B> for Guess<B> {
    #[inline]
    fn eigenpair<S: Scalar>(&self, value: S) -> (S, [S; B]) {
        (value, mapped(&self.vector, S::from_complex))
    }
}

/// The guesses with their residuals, in the order in which they are tried: where some belong to no solution, those that do come first. Elsewhere residuals
/// are not needed, and zero.
#[inline]
fn in_order<'a, const B: usize, const N: usize, const K: usize>(
    method: &impl ActionMethod<B, N, K>,
    guesses: &'a [Guess<B>],
    has_spurious_values: bool,
) -> impl Iterator<Item = (f64, &'a Guess<B>)> {
    let mut order: ArrayVec<(f64, usize), B> = (0..guesses.len()).map(|at| (0.0, at)).collect();
    if has_spurious_values {
        for ((residual, _), guess) in order.iter_mut().zip(guesses) {
            *residual = match guess.value.im == 0.0 {
                true => guess.residual::<f64, N, K>(method),
                false => guess.residual::<Complex<f64>, N, K>(method),
            };
        }
        sort(&mut order);
    }
    order.into_iter().map(|(residual, at)| (residual, &guesses[at]))
}

/// A function of its own: compiled once for all solvers.
#[inline(never)]
fn sort(order: &mut [(f64, usize)]) {
    order.sort_unstable_by(|(a, _), (b, _)| a.total_cmp(b));
}

/// What [`real_solutions`] finds.
struct RealAndAll<const N: usize, const MAX: usize> {
    real: Solutions<Candidate<f64, N>, MAX>,
    /// With the complex ones, where they are counted.
    all: Option<Solutions<Candidate<Complex<f64>, N>, MAX>>,
}

impl<const N: usize, const MAX: usize> RealAndAll<N, MAX> {
    /// Whether an eigenvalue may belong to a real solution.
    #[inline]
    fn may_be_real(&self, value: &Complex<f64>) -> bool {
        self.all.is_some() || is_nearly_real(value)
    }

    /// Whether the number of solutions shows that some are missing.
    #[inline]
    fn lacks_some(&self) -> bool {
        match &self.all {
            Some(all) => all.len() < MAX,
            None => !(MAX - self.real.len()).is_multiple_of(2),
        }
    }

    /// Where all solutions are known, drops what is none of them.
    #[inline]
    fn drop_spurious(&mut self) {
        if let Some(all) = self.all.as_ref().filter(|all| all.len() == MAX) {
            let is_known = |real: &&Candidate<f64, N>| all.iter().any(|known| known.close(&as_complex(**real)));
            self.real = self.real.iter().filter(is_known).copied().collect();
        }
    }
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

/// What is found at last. Two solutions that were made one may have become one that is excluded.
#[inline]
fn admissible<S: Scalar, const B: usize, const N: usize, const K: usize, const MAX: usize>(
    method: &impl ActionMethod<B, N, K>,
    found: &Solutions<Candidate<S, N>, MAX>,
) -> Solutions<[S; N], MAX> {
    found.iter().filter(|candidate| is_admissible(method, candidate)).map(|candidate| candidate.unknowns).collect()
}

/// Of a conjugate pair one is solved for and the other follows.
#[inline]
fn upper_half(values: impl IntoIterator<Item = Complex<f64>>) -> impl Iterator<Item = Complex<f64>> {
    values.into_iter().filter(|value| value.im >= 0.0)
}

#[inline]
fn is_nearly_real(value: &Complex<f64>) -> bool {
    value.im.abs() <= NEARLY_REAL * value.re.abs()
}

/// Calls `solve` for the eigenpairs of all eigenvalues that several solutions may share.
#[cold]
#[inline(never)]
fn for_each_shared_value<const B: usize, const N: usize, const K: usize>(
    method: &impl ActionMethod<B, N, K>,
    action: &[[f64; B]; B],
    spectrum: &Hessenberg<B>,
    values: &[Complex<f64>; B],
    mut solve: impl FnMut(&Combinations<'_, B>, Complex<f64>),
) {
    let mut basis = [[0.0; B]; B];
    let mut combination = Hessenberg::zero(Full);
    let mut shared = SharedValue::new(action, &mut basis, &mut combination);
    for cluster in spectrum.clusters(values) {
        if shared.find(method, spectrum, &cluster).is_ok() {
            shared.for_each(|source, value| {
                if value.im >= 0.0 {
                    solve(source, value);
                }
            });
        }
    }
}

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
    mut solve: impl FnMut(&M, &PreciseSpectrum<'_>, Complex<f64>),
) -> Result<(), SolveError> {
    if first.is_err() && !M::HAS_PRECISE_COEFFICIENTS {
        return first;
    }
    // Not moved out of its result, which would take its size from the stack twice.
    let action = method.action_matrix::<DoubleDouble>();
    let Ok(action) = &action else { return first };
    let solve_all = &mut |spectrum: &PreciseSpectrum<'_>| {
        for value in upper_half(spectrum.eigenvalues.iter().copied()) {
            solve(method, spectrum, value);
        }
    };
    with_precise_spectrum(action.as_flattened(), B, solve_all).or(first)
}

/// Adds the solution of a real eigenvalue, or that of a complex one and its conjugate; false where none of them is new.
#[inline]
fn add_complex<const B: usize, const N: usize, const K: usize, const MAX: usize>(
    method: &impl ActionMethod<B, N, K>,
    source: &impl Eigenpairs<B>,
    value: Complex<f64>,
    found: &mut Solutions<Candidate<Complex<f64>, N>, MAX>,
) -> bool {
    if value.im == 0.0 {
        let real = polished(method, source, value.re).map(as_complex);
        // The square of an unknown may be real and negative. A conjugate then differs by signs only.
        let candidate = real.or_else(|| (!flips(method).is_empty()).then(|| polished(method, source, value)).flatten());
        candidate.is_some_and(|candidate| push_all_signs(method, candidate, found))
    } else {
        polished(method, source, value).is_some_and(|candidate| push_both(method, candidate, found))
    }
}

#[inline]
fn as_complex<const N: usize>(real: Candidate<f64, N>) -> Candidate<Complex<f64>, N> {
    Candidate { unknowns: mapped(&real.unknowns, Complex::from), residual: real.residual }
}

/// Adds a solution and its conjugate; false where one of them is not new.
#[inline]
fn push_both<const B: usize, const N: usize, const K: usize, const MAX: usize>(
    method: &impl ActionMethod<B, N, K>,
    candidate: Candidate<Complex<f64>, N>,
    found: &mut Solutions<Candidate<Complex<f64>, N>, MAX>,
) -> bool {
    push_all_signs(method, candidate, found) & push_all_signs(method, conjugate(&candidate), found)
}

#[inline]
fn conjugate<const N: usize>(candidate: &Candidate<Complex<f64>, N>) -> Candidate<Complex<f64>, N> {
    Candidate { unknowns: mapped(&candidate.unknowns, Scalar::conj), ..*candidate }
}

/// The sign changes that connect solutions of one eigenpair.
#[inline]
fn flips<const B: usize, const N: usize, const K: usize, M: ActionMethod<B, N, K>>(_: &M) -> &'static [[bool; N]] {
    M::SYMMETRY.map_or(&[], |symmetry| symmetry.flips)
}

/// Adds a solution with those that differ by signs only; false where none of them is new.
#[inline]
fn push_all_signs<S: Scalar, const B: usize, const N: usize, const K: usize, const MAX: usize>(
    method: &impl ActionMethod<B, N, K>,
    candidate: Candidate<S, N>,
    found: &mut Solutions<Candidate<S, N>, MAX>,
) -> bool {
    let polish = |x: &mut _, steps| method.polish(x, steps);
    let mut is_new = push_distinct(found, candidate, polish);
    for flip in flips(method) {
        let unknowns = flipped(&candidate.unknowns, flip);
        is_new |= push_distinct(found, Candidate { unknowns, ..candidate }, polish);
    }
    is_new
}

/// Adds the real solution of a real or nearly real eigenvalue. False where there is none or none that is new, and for a
/// complex eigenvalue, because its conjugate may stand for one more.
#[inline]
fn add_real<const B: usize, const N: usize, const K: usize, const MAX: usize>(
    method: &impl ActionMethod<B, N, K>,
    source: &impl Eigenpairs<B>,
    value: Complex<f64>,
    found: &mut RealAndAll<N, MAX>,
) -> bool {
    if value.im == 0.0 {
        let candidate = polished(method, source, value.re);
        match (&mut found.all, candidate) {
            (Some(all), Some(candidate)) => {
                push_all_signs(method, as_complex(candidate), all);
            }
            (Some(all), None) if !flips(method).is_empty() => {
                add_complex(method, source, value, all);
            }
            _ => {}
        }
        return candidate.is_some_and(|candidate| push_all_signs(method, candidate, &mut found.real));
    }
    if let Some(candidate) = polished(method, source, value) {
        if let Some(all) = &mut found.all {
            push_both(method, candidate, all);
        }
        if let Some(real) = nearly_real(method, &candidate) {
            push_all_signs(method, real, &mut found.real);
        }
    }
    false
}

/// The real solution that belongs to a complex one close to its conjugate, if there is one. Halfway between the two is their real part: what shows a
/// double solution in [`push_distinct`] does so here.
#[inline]
fn nearly_real<const B: usize, const N: usize, const K: usize>(
    method: &impl ActionMethod<B, N, K>,
    complex: &Candidate<Complex<f64>, N>,
) -> Option<Candidate<f64, N>> {
    if !complex.close(&conjugate(complex)) {
        return None;
    }
    let unknowns = mapped(&complex.unknowns, Scalar::real);
    polish_from(method, unknowns).filter(|real| real.residual <= complex.residual.max(DOUBLE))
}

#[inline]
fn polished<S: Scalar, const B: usize, const N: usize, const K: usize>(
    method: &impl ActionMethod<B, N, K>,
    source: &impl Eigenpairs<B>,
    value: S,
) -> Option<Candidate<S, N>> {
    let (value, vector) = source.eigenpair(value);
    polish_from(method, unknowns(method, value, &vector)?)
}

/// Whether no factor vanishes. A factor that is an unknown, or a product of some, is never small relative to its terms: it vanishes where the unknown
/// cannot be told from zero.
#[inline]
fn is_admissible<S: Scalar, const B: usize, const N: usize, const K: usize>(
    method: &impl ActionMethod<B, N, K>,
    candidate: &Candidate<S, N>,
) -> bool {
    method.is_admissible(&without_uncertain(&candidate.unknowns, candidate.residual))
}

/// The solution that the polish of a point leads to.
#[inline]
fn polish_from<S: Scalar, const B: usize, const N: usize, const K: usize>(
    method: &impl ActionMethod<B, N, K>,
    mut unknowns: [S; N],
) -> Option<Candidate<S, N>> {
    let residual = method.polish(&mut unknowns, POLISH_STEPS);
    let candidate = Candidate { unknowns, residual };
    let good = residual <= MAX_RESIDUAL && unknowns.iter().all(|x| x.is_finite()) && is_admissible(method, &candidate);
    good.then_some(candidate)
}
