//! From the action matrix to polished solutions: what all emitted solvers do alike.

use num_complex::Complex;

use crate::distinct::{Candidate, push_distinct};
use crate::error::SolveError;
use crate::hessenberg::Hessenberg;
use crate::polynomial_roots::real_roots_monic;
use crate::scalar::Scalar;
use crate::solutions::Solutions;

/// A solution is kept only if its relative residual is at most this after the polish.
pub const MAX_RESIDUAL: f64 = 1e-10;

/// A complex solution counts as real where every unknown's imaginary part is at most this, relative to its modulus.
pub const REAL_TOLERANCE: f64 = 1e-9;

/// An eigenvalue whose imaginary part is at most this, relative to its modulus, may belong to a real solution:
/// rounding splits a pair of close real eigenvalues into a complex one.
const NEARLY_REAL: f64 = 1e-3;

/// A factor that must not vanish does if its value is at most this, relative to the sum of the moduli of its terms.
pub const VANISHING: f64 = 1e-8;

/// Newton steps at most; nearly always one or two lower the residual and the next one stops.
pub const POLISH_STEPS: usize = 8;

/// What differs between solvers once the action matrix is known: |B| = B basis monomials, N unknowns.
pub trait ActionMethod<const B: usize, const N: usize> {
    /// The unknowns from an eigenpair; `None` where they cannot be read.
    fn unknowns<S: Scalar>(&self, value: S, vector: &[S; B]) -> Option<[S; N]>;

    /// Polishes on the original equations and returns the relative residual.
    fn polish<S: Scalar>(&self, unknowns: &mut [S; N], steps: usize) -> f64;

    /// Whether no factor that was stated to be nonzero vanishes.
    fn is_admissible<S: Scalar>(&self, unknowns: &[S; N]) -> bool;
}

/// How real roots are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RootMethod {
    /// QR iteration on the Hessenberg form.
    Eigenvalues,
    /// Real roots of the characteristic polynomial.
    CharacteristicPolynomial,
}

/// All complex solutions, at most MAX.
///
/// # Errors
/// [`SolveError::NonFiniteInput`] for a matrix that is not finite, [`SolveError::NoConvergence`] where the QR iteration reaches its limit.
#[inline]
pub fn complex_solutions<const B: usize, const N: usize, const MAX: usize>(
    method: &impl ActionMethod<B, N>,
    action: &[[f64; B]; B],
) -> Result<Solutions<[Complex<f64>; N], MAX>, SolveError> {
    let spectrum = Hessenberg::reduce(action)?;
    let mut found = Solutions::<Candidate<Complex<f64>, N>, MAX>::new();
    // Of a conjugate pair one is solved for and the other follows.
    for value in spectrum.eigenvalues()?.into_iter().filter(|value| value.im >= 0.0) {
        if value.im == 0.0 {
            if let Some(real) = polished(method, value.re, &spectrum.eigenvector(value.re)) {
                let unknowns = real.unknowns.map(Complex::from);
                push_distinct(&mut found, Candidate { unknowns, residual: real.residual });
            }
        } else if let Some(candidate) = polished(method, value, &spectrum.eigenvector(value)) {
            push_distinct(&mut found, candidate);
            push_distinct(&mut found, Candidate { unknowns: candidate.unknowns.map(|x| x.conj()), ..candidate });
        }
    }
    Ok(found.iter().map(|candidate| candidate.unknowns).collect())
}

/// All real solutions, at most MAX.
///
/// # Errors
/// As [`complex_solutions`].
#[inline]
pub fn real_solutions<const B: usize, const N: usize, const MAX: usize>(
    method: &impl ActionMethod<B, N>,
    action: &[[f64; B]; B],
    roots: RootMethod,
) -> Result<Solutions<[f64; N], MAX>, SolveError> {
    let spectrum = Hessenberg::reduce(action)?;
    let mut found = Solutions::<Candidate<f64, N>, MAX>::new();
    let mut try_real = |value: f64| {
        if let Some(candidate) = polished(method, value, &spectrum.eigenvector(value)) {
            push_distinct(&mut found, candidate);
        }
    };
    match roots {
        RootMethod::CharacteristicPolynomial => {
            real_roots_monic(&spectrum.characteristic_polynomial()).into_iter().for_each(try_real);
        }
        RootMethod::Eigenvalues => {
            let values = spectrum.eigenvalues()?;
            values.iter().filter(|value| value.im == 0.0).for_each(|value| try_real(value.re));
            for value in values.iter().filter(|value| value.im != 0.0) {
                if value.im.abs() <= NEARLY_REAL * value.re.abs()
                    && let Some(candidate) = nearly_real(method, &spectrum, *value)
                {
                    push_distinct(&mut found, candidate);
                }
            }
        }
    }
    Ok(found.iter().map(|candidate| candidate.unknowns).collect())
}

/// The real solution that belongs to a complex eigenvalue close to the real axis, if there is one.
#[inline]
fn nearly_real<const B: usize, const N: usize>(
    method: &impl ActionMethod<B, N>,
    spectrum: &Hessenberg<B>,
    value: Complex<f64>,
) -> Option<Candidate<f64, N>> {
    let complex = polished(method, value, &spectrum.eigenvector(value))?;
    let is_real = |x: &Complex<f64>| x.im.abs() <= REAL_TOLERANCE * x.modulus();
    if !complex.unknowns.iter().all(is_real) {
        return None;
    }
    let mut unknowns = complex.unknowns.map(|x| x.re);
    let residual = method.polish(&mut unknowns, POLISH_STEPS);
    (residual <= MAX_RESIDUAL).then_some(Candidate { unknowns, residual })
}

#[inline]
fn polished<S: Scalar, const B: usize, const N: usize>(
    method: &impl ActionMethod<B, N>,
    value: S,
    vector: &[S; B],
) -> Option<Candidate<S, N>> {
    let mut unknowns = method.unknowns(value, vector)?;
    let residual = method.polish(&mut unknowns, POLISH_STEPS);
    let good = residual <= MAX_RESIDUAL && unknowns.iter().all(|x| x.is_finite()) && method.is_admissible(&unknowns);
    good.then_some(Candidate { unknowns, residual })
}
