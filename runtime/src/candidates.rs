//! From an eigenpair to the list of solutions: read off, polished, kept if it is one and new.

use num_complex::Complex;

use crate::distinct::{Candidate, DOUBLE, push_distinct};
use crate::driver::{ActionMethod, MAX_RESIDUAL};
use crate::extract::{Eigenpairs, unknowns};
use crate::polish::{POLISH_STEPS, without_uncertain};
use crate::scalar::{Scalar, mapped};
use crate::solutions::Solutions;
use crate::symmetry::flipped;

/// An eigenvalue whose imaginary part is at most this, relative to its modulus, may belong to a real solution:
/// rounding splits a pair of close real eigenvalues into a complex one. Where |B| exceeds the number of solutions any
/// eigenvalue may: those that belong to no solution are often close together, far less precise, and take others along.
const NEARLY_REAL: f64 = 1e-3;

/// What [`crate::driver::complex_solutions`] finds.
pub(crate) type All<const N: usize, const MAX: usize> = Solutions<Candidate<Complex<f64>, N>, MAX>;

/// What [`crate::driver::real_solutions`] finds.
pub(crate) struct RealAndAll<const N: usize, const MAX: usize> {
    pub(crate) real: Solutions<Candidate<f64, N>, MAX>,
    /// With the complex ones, where they are counted.
    pub(crate) all: Option<All<N, MAX>>,
}

impl<const N: usize, const MAX: usize> RealAndAll<N, MAX> {
    /// Whether an eigenvalue may belong to a real solution.
    #[inline]
    pub(crate) fn may_be_real(&self, value: &Complex<f64>) -> bool {
        self.all.is_some() || value.im.abs() <= NEARLY_REAL * value.re.abs()
    }

    /// Whether the number of solutions shows that some are missing.
    #[inline]
    pub(crate) fn lacks_some(&self) -> bool {
        match &self.all {
            Some(all) => all.len() < MAX,
            None => !(MAX - self.real.len()).is_multiple_of(2),
        }
    }

    /// Where all solutions are known, drops what is none of them.
    #[inline]
    pub(crate) fn drop_spurious(&mut self) {
        let Some(all) = self.all.as_ref().filter(|all| all.len() == MAX) else { return };
        let mut known = Solutions::new();
        for &real in &self.real {
            if is_close_to_one(&as_complex(real), all) {
                known.push(real);
            }
        }
        self.real = known;
    }
}

#[inline(never)]
fn is_close_to_one<S: Scalar, const N: usize>(candidate: &Candidate<S, N>, known: &[Candidate<S, N>]) -> bool {
    known.iter().any(|known| known.close(candidate))
}

/// The origin, where it is a solution.
#[inline]
pub(crate) fn known_beforehand<
    S: Scalar,
    const B: usize,
    const N: usize,
    const K: usize,
    const MAX: usize,
    M: ActionMethod<B, N, K>,
>(
    _: &M,
) -> Solutions<Candidate<S, N>, MAX> {
    let mut known = Solutions::new();
    if M::HAS_ORIGIN {
        known.push(Candidate { unknowns: [S::ZERO; N], residual: 0.0 });
    }
    known
}

/// What is found at last. Two solutions that were made one may have become one that is excluded.
#[inline]
pub(crate) fn admissible<S: Scalar, const B: usize, const N: usize, const K: usize, const MAX: usize>(
    method: &impl ActionMethod<B, N, K>,
    found: &Solutions<Candidate<S, N>, MAX>,
) -> Solutions<[S; N], MAX> {
    let mut solutions = Solutions::new();
    for candidate in found {
        if is_admissible(method, candidate) {
            solutions.push(candidate.unknowns);
        }
    }
    solutions
}

/// Adds the solution of a real eigenvalue, or that of a complex one and its conjugate; false where none of them is new.
#[inline(never)]
pub(crate) fn add_complex<const B: usize, const N: usize, const K: usize, const MAX: usize>(
    method: &impl ActionMethod<B, N, K>,
    source: &dyn Eigenpairs<B>,
    value: Complex<f64>,
    found: &mut All<N, MAX>,
) -> bool {
    if value.im != 0.0 {
        let Some(candidate) = polished(method, source.complex(value)) else { return false };
        return push_both(method, candidate, found);
    }
    let mut candidate = polished(method, source.real(value.re)).map(as_complex);
    if candidate.is_none() && !flips(method).is_empty() {
        // The square of an unknown may be real and negative. A conjugate then differs by signs only.
        candidate = polished(method, source.complex(value));
    }
    let Some(candidate) = candidate else { return false };
    push_all_signs(method, candidate, found)
}

/// Adds the real solution of a real or nearly real eigenvalue. False where there is none or none that is new, and for a
/// complex eigenvalue, because its conjugate may stand for one more.
#[inline(never)]
pub(crate) fn add_real<const B: usize, const N: usize, const K: usize, const MAX: usize>(
    method: &impl ActionMethod<B, N, K>,
    source: &dyn Eigenpairs<B>,
    value: Complex<f64>,
    found: &mut RealAndAll<N, MAX>,
) -> bool {
    if value.im == 0.0 {
        let candidate = polished(method, source.real(value.re));
        match (&mut found.all, candidate) {
            (Some(all), Some(candidate)) => {
                push_all_signs(method, as_complex(candidate), all);
            }
            (Some(all), None) if !flips(method).is_empty() => {
                add_complex(method, source, value, all);
            }
            _ => {}
        }
        let Some(candidate) = candidate else { return false };
        return push_all_signs(method, candidate, &mut found.real);
    }
    if let Some(candidate) = polished(method, source.complex(value)) {
        if let Some(all) = &mut found.all {
            push_both(method, candidate, all);
        }
        if let Some(real) = nearly_real(method, &candidate) {
            push_all_signs(method, real, &mut found.real);
        }
    }
    false
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
    found: &mut All<N, MAX>,
) -> bool {
    push_all_signs(method, candidate, found) & push_all_signs(method, conjugate(&candidate), found)
}

#[inline]
fn conjugate<const N: usize>(candidate: &Candidate<Complex<f64>, N>) -> Candidate<Complex<f64>, N> {
    Candidate { unknowns: mapped(&candidate.unknowns, Scalar::conj), ..*candidate }
}

/// The sign changes that connect solutions of one eigenpair.
#[inline]
pub(crate) fn flips<const B: usize, const N: usize, const K: usize, M: ActionMethod<B, N, K>>(
    _: &M,
) -> &'static [[bool; N]] {
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
    (value, vector): (S, [S; B]),
) -> Option<Candidate<S, N>> {
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
    let good = residual <= MAX_RESIDUAL && (0..N).all(|j| unknowns[j].is_finite()) && is_admissible(method, &candidate);
    good.then_some(candidate)
}
