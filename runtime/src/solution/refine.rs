//! Newton's method with the values of the equations at twice the precision.
//!
//! A solution x of f(x) = 0 whose weighted Jacobian W J has a small singular value s is known to
//! about u / s only, relative to its largest unknown, if coefficients and values have relative
//! errors u = 1e-16:
//!
//! ```text
//!   J (x' - x) = -f(x)      x' - x is wrong by the error of f(x), divided by s
//! ```
//!
//! The error of the Jacobian matters little: it changes x' - x by a part of it. With f(x) at twice
//! the precision, the steps lead to the solution of the given data with all its digits, if s is
//! well above u (iterative refinement; Higham, "Accuracy and Stability of Numerical Algorithms",
//! 2002, theorem 25.1, for nonlinear systems).

use crate::number::Scalar;
use crate::number::double_double::{DoubleComplex, DoubleDouble};
use crate::number::scalar::mapped;
use crate::size::{Matrix, Size, filled_matrix};
use crate::solution::candidates::MAX_RESIDUAL;
use crate::solution::polish::{Polish, largest, polish_and_judge};
use crate::solution::system::{PreciseSystem, System};

/// Steps at most. Each multiplies the error by about u / s.
const MOST_STEPS: usize = 8;
/// A step is taken only if it is shorter by this factor than the one before.
const SHORTER: f64 = 0.5;
/// The first step may change the largest unknown by this part of it. A longer one leads away.
const FIRST: f64 = 1e-2;
/// The method has converged with a step of this size, relative to the largest unknown.
const CONVERGED: f64 = 0.5 * f64::EPSILON;
/// It ends near a solution if the last step is at most this, relative to the largest unknown.
const NEAR: f64 = 1e-9;

/// As [`polish`](super::polish::polish). A point that is ill-conditioned is then refined, with
/// `coefficients` at twice the precision, in the order of the system's tables.
#[inline]
pub fn polish_precisely<S: Scalar, N: Size, E: Size, C: AsRef<[DoubleDouble]>>(
    x: &mut N::Vector<S>,
    sizes: (N, E),
    system: &(impl System<S, N, E> + PreciseSystem<N, E>),
    steps: usize,
    coefficients: impl Fn() -> C,
) -> f64 {
    let polished = polish_and_judge(x, sizes, system, steps);
    match polished.is_ill_conditioned && polished.residual <= MAX_RESIDUAL {
        true => refined(x, sizes, system, polished.residual, coefficients),
        false => polished.residual,
    }
}

/// Refines x and returns its relative residual. If the steps do not converge to a solution near x,
/// x stays.
#[cold]
#[inline(never)]
fn refined<S: Scalar, N: Size, E: Size, C: AsRef<[DoubleDouble]>>(
    x: &mut N::Vector<S>,
    sizes: (N, E),
    system: &(impl System<S, N, E> + PreciseSystem<N, E>),
    residual: f64,
    coefficients: impl Fn() -> C,
) -> f64 {
    let coefficients = coefficients();
    let mut newton = PreciseNewton::new(x, sizes, system, coefficients.as_ref());
    let mut last = FIRST / SHORTER;
    for _ in 0..MOST_STEPS {
        let Some(size) = newton.step(SHORTER * last) else { break };
        last = size;
        if size <= CONVERGED {
            break;
        }
    }
    let moved = newton.point();
    let of_moved = Polish::new(&moved, sizes, system).residual();
    if last <= NEAR && of_moved <= MAX_RESIDUAL {
        *x = moved;
        return of_moved;
    }
    residual
}

/// A bound on the error of x, the largest error of an unknown relative to the largest unknown:
///
/// ```text
///   steps d_1, d_2 of Newton's method with |d_2| <= |d_1| / 4:
///   error <= |d_1| + |d_2| + .. <= |d_1| / (1 - 1/4)
/// ```
///
/// if the steps go on to shorten at this rate; near a solution they shorten much faster. Infinity
/// if they do not shorten, or the Jacobian has lost rank: then no solution near x is known. The
/// values of the equations are computed at twice the precision, from `coefficients` of this
/// precision, so that the bound is about the solution of the data as they are given.
#[cold]
#[inline(never)]
pub fn error_bound<S: Scalar, N: Size, E: Size>(
    x: &N::Vector<S>,
    sizes: (N, E),
    system: &(impl System<S, N, E> + PreciseSystem<N, E>),
    coefficients: &[DoubleDouble],
) -> f64 {
    const RATE: f64 = 0.25;
    let mut newton = PreciseNewton::new(x, sizes, system, coefficients);
    let Some(first) = newton.step(f64::INFINITY) else { return f64::INFINITY };
    // Steps below the last digit are rounding errors of the point.
    match newton.step((RATE * first).max(f64::EPSILON)) {
        Some(_) => first / (1.0 - RATE),
        None => f64::INFINITY,
    }
}

/// A point with twice the digits, and the equations there.
struct PreciseNewton<'a, S: Scalar, N: Size, E: Size, Y> {
    sizes: (N, E),
    system: &'a Y,
    coefficients: &'a [DoubleDouble],
    x: N::Vector<DoubleComplex>,
    derivatives: Matrix<N, E, S>,
}

impl<'a, S: Scalar, N: Size, E: Size, Y: System<S, N, E> + PreciseSystem<N, E>> PreciseNewton<'a, S, N, E, Y> {
    fn new(x: &N::Vector<S>, sizes: (N, E), system: &'a Y, coefficients: &'a [DoubleDouble]) -> Self {
        let x = mapped(sizes.0, x, |x: S| DoubleComplex::from_complex(x.to_complex()));
        Self { sizes, system, coefficients, x, derivatives: filled_matrix(sizes.0, sizes.1, S::ZERO) }
    }

    /// The point, rounded.
    fn point(&self) -> N::Vector<S> {
        mapped(self.sizes.0, &self.x, |x: DoubleComplex| S::from_complex(x.to_complex()))
    }

    /// Takes a step if it is at most so long, relative to the largest unknown, and returns its
    /// length. `None` if it is longer, or the Jacobian has lost rank.
    fn step(&mut self, longest: f64) -> Option<f64> {
        let rounded = self.point();
        let mut at = Polish::new(&rounded, self.sizes, self.system);
        at.residual();
        let values = self.system.precise_values(&self.x, self.coefficients);
        let values = mapped(self.sizes.1, &values, |value: DoubleComplex| S::from_complex(value.to_complex()));
        let step = at.step_for(&rounded, values, &mut self.derivatives)?.correction;
        let length = largest(step.as_ref()) / largest(rounded.as_ref());
        if !(length <= longest) {
            return None;
        }
        for j in 0..self.sizes.0.get() {
            self.x[j] -= DoubleComplex::from_complex(step[j].to_complex());
        }
        Some(length)
    }
}
