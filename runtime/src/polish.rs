//! Gauss-Newton steps on the original equations.

use crate::float;
use crate::scalar::{Scalar, mapped};
use crate::system::System;

/// Steps at most; nearly always one or two lower the residual and the next one stops.
pub const POLISH_STEPS: usize = 24;

/// A step that does not lower a high residual is shortened by this factor so many times at most.
const SHORTER: f64 = 0.35;
const SHORTER_STEPS: usize = 6;

/// A relative residual at most this is rounding: no step could lower it by much.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// A relative residual above this after the last step has a cause other than rounding.
const STALLED: f64 = 1e-12;

/// An unknown this small relative to the largest one may be the rounding noise of zero.
const NOISE: f64 = 1e-12;
/// No unknown is known to less than this times the relative residual, relative to the largest one, where the polish converges slowly: towards solutions that
/// are not isolated, such as those at which an unknown vanishes that should not.
const UNCERTAIN: f64 = 1e3;

/// A step that changes an unknown by more than this part of it shows that x is near no solution, if the residual has a cause other than rounding
/// or stays below [`FLAT`].
const FAR: f64 = 0.1;

/// A relative residual below this after a long step away from a solution: there is no solution but a direction in which the equations are
/// nearly constant. Away from a double solution the residual grows with the square of the distance.
const FLAT: f64 = 1e-6;

/// Unknowns at least this large may be on the way to infinity: they are if half of them gives a residual that is rounding, too. (There
/// steps are rounding errors and show nothing.)
const LARGE: f64 = 1e6;

/// Improves x by at most `steps` Gauss-Newton steps and returns its relative residual,
///
/// max over equations e of |f_e(x)| / (sum of the moduli of the terms of f_e at x), 0/0 counting as 0.
///
/// Equations are weighted by one over that sum, which makes the result independent of their scaling; scaling an unknown
/// does not matter to Householder QR. A step is kept only if it lowers the residual, if need be a fraction of it; where no fraction does, that ends
/// the iteration, as does a residual at rounding level or a rank-deficient Jacobian. Infinity, with x unchanged, when x
/// or a value at x is not finite.
///
/// Infinity also where the last step, taken or not, changes an unknown by a tenth and the residual is no rounding error, or stays small however
/// long the step is: so far out, where the terms of highest degree alone are nearly zero, the residual is small without a solution near by.
///
/// Where every term of an equation holds an unknown that is zero at the solution, noise in that unknown keeps the relative residual high
/// however small it is. A step that does not lower a high residual is therefore tried again with unknowns at the level of noise set to zero.
#[inline]
pub fn polish<S: Scalar, const N: usize, const E: usize>(
    x: &mut [S; N],
    system: &dyn System<S, N, E>,
    steps: usize,
) -> f64 {
    let mut values = [S::ZERO; E];
    let mut scale = [0.0; E];
    if steps == 0 {
        system.residual(x, &mut values, &mut scale);
        return relative_residual(&values, &scale);
    }
    let mut jacobian = [[S::ZERO; N]; E];
    let mut best = f64::INFINITY;
    let mut correction = [S::ZERO; N];
    // Whether the last step leads from a residual that is rounding to one that is small, too.
    let mut flat = false;
    for step in 0..steps {
        system.evaluate(x, &mut values, &mut scale, &mut jacobian);
        if step == 0 {
            best = relative_residual(&values, &scale);
        }
        if (step == 0 && best <= ROUNDING) || best == f64::INFINITY {
            break;
        }
        weigh(&mut values, &scale, &mut jacobian);
        let Some(step) = least_squares(&mut jacobian, &mut values) else { break };
        correction = step;
        let mut moved = *x;
        for j in 0..N {
            moved[j] -= correction[j];
        }
        system.residual(&moved, &mut values, &mut scale);
        let mut residual = relative_residual(&values, &scale);
        if !(residual < best) && best > STALLED {
            moved = without_small(&moved, NOISE);
            system.residual(&moved, &mut values, &mut scale);
            residual = relative_residual(&values, &scale);
        }
        let mut fraction = 1.0;
        for _ in 0..SHORTER_STEPS {
            if residual < best || best <= STALLED {
                break;
            }
            fraction *= SHORTER;
            for j in 0..N {
                moved[j] = x[j] - correction[j].scale(fraction);
            }
            system.residual(&moved, &mut values, &mut scale);
            residual = relative_residual(&values, &scale);
        }
        flat = best <= STALLED && residual <= FLAT;
        if !(residual < best) {
            break;
        }
        best = residual;
        *x = moved;
        // After a long step the next one tells a badly determined solution, which it leaves in place, from none.
        if best <= ROUNDING && !far(x, &correction).contains(&true) {
            break;
        }
    }
    let mut residual_of = |x: &[S; N]| {
        system.residual(x, &mut values, &mut scale);
        relative_residual(&values, &scale)
    };
    let is_large = |value: &S| value.magnitude() >= LARGE;
    if x.iter().any(is_large)
        && residual_of(&mapped(x, |value| if is_large(&value) { value.scale(0.5) } else { value })) <= STALLED.max(best)
    {
        return f64::INFINITY;
    }
    let far = far(x, &correction);
    if !far.contains(&true) {
        return best;
    }
    // An unknown that is zero up to noise is free to change by as much.
    let mut without = *x;
    without.iter_mut().zip(far).filter(|(_, far)| *far).for_each(|(value, _)| *value = S::ZERO);
    if best > STALLED || (flat && residual_of(&without) > STALLED) { f64::INFINITY } else { best }
}

/// Which unknowns a step changes by more than the part [`FAR`], other than rounding noise of zero.
#[inline]
fn far<S: Scalar, const N: usize>(x: &[S; N], step: &[S; N]) -> [bool; N] {
    let noise = NOISE * largest(x);
    core::array::from_fn(|j| step[j].magnitude() > FAR * x[j].magnitude() + noise)
}

/// A polished x of this relative residual, with the unknowns that cannot be told from zero set to zero.
#[inline]
pub(crate) fn without_uncertain<S: Scalar, const N: usize>(x: &[S; N], residual: f64) -> [S; N] {
    without_small(x, NOISE.max(UNCERTAIN * residual))
}

/// x with the unknowns that are at most this small relative to the largest one set to zero.
#[inline]
fn without_small<S: Scalar, const N: usize>(x: &[S; N], level: f64) -> [S; N] {
    let smallest = level * largest(x);
    mapped(x, |value| if value.magnitude() <= smallest { S::ZERO } else { value })
}

/// The magnitude of the largest unknown.
#[inline]
pub(crate) fn largest<S: Scalar, const N: usize>(x: &[S; N]) -> f64 {
    x.iter().map(|value| value.magnitude()).fold(0.0, f64::max)
}

/// max |f_e| / scale_e; infinity when something is not finite.
#[inline]
fn relative_residual<S: Scalar, const E: usize>(values: &[S; E], scale: &[f64; E]) -> f64 {
    let mut worst = 0.0;
    for e in 0..E {
        if !(values[e].is_finite() && scale[e].is_finite()) {
            return f64::INFINITY;
        }
        if scale[e] > 0.0 {
            let relative = values[e].modulus() / scale[e];
            worst = if relative > worst { relative } else { worst };
        }
    }
    worst
}

/// Divides each equation by its scale; where all terms vanish, by the size of its gradient.
#[inline]
fn weigh<S: Scalar, const N: usize, const E: usize>(values: &mut [S; E], scale: &[f64; E], jacobian: &mut [[S; N]; E]) {
    for e in 0..E {
        let size = if scale[e] > 0.0 {
            scale[e]
        } else {
            jacobian[e].iter().map(|entry| entry.magnitude()).fold(0.0, f64::max)
        };
        let weight = if size > 0.0 { 1.0 / size } else { 0.0 };
        values[e] = values[e].scale(weight);
        jacobian[e] = mapped(&jacobian[e], |entry| entry.scale(weight));
    }
}

/// The least-squares solution of `matrix * y = right`, E equations in N <= E unknowns, by Householder QR; both
/// arguments are overwritten. None when the matrix has lost rank (a diagonal entry of R below N epsilon times its
/// column) or something is not finite.
#[inline]
fn least_squares<S: Scalar, const N: usize, const E: usize>(
    matrix: &mut [[S; N]; E],
    right: &mut [S; E],
) -> Option<[S; N]> {
    if E < N {
        return None;
    }
    let mut column_size = [0.0_f64; N];
    for row in matrix.iter() {
        for j in 0..N {
            column_size[j] += row[j].modulus_squared();
        }
    }
    let rounding = N as f64 * f64::EPSILON;
    let mut inverse_diagonal = [S::ZERO; N];
    for k in 0..N {
        let square: f64 = (k..E).map(|i| matrix[i][k].modulus_squared()).sum();
        if !(square > rounding * rounding * column_size[k] && square < f64::INFINITY) {
            return None;
        }
        let length = float::sqrt(square);
        let head = matrix[k][k];
        let size = head.modulus();
        // R[k][k] has the direction opposite to the head, so that head - diagonal does not cancel.
        let diagonal = if size > 0.0 { -head.scale(length / size) } else { S::from_f64(-length) };
        inverse_diagonal[k] = diagonal.reciprocal();
        matrix[k][k] = head - diagonal;
        // The reflection I - v v^H / factor, v the column k.. as it is now.
        let inverse_factor = 1.0 / (square + length * size);
        let mut product = [S::ZERO; N];
        let mut product_right = S::ZERO;
        for i in k..E {
            let v = matrix[i][k].conj();
            for j in k + 1..N {
                product[j] += v * matrix[i][j];
            }
            product_right += v * right[i];
        }
        for i in k..E {
            let v = matrix[i][k].scale(inverse_factor);
            for j in k + 1..N {
                matrix[i][j] -= v * product[j];
            }
            right[i] -= v * product_right;
        }
    }
    let mut solution = [S::ZERO; N];
    for k in (0..N).rev() {
        let mut sum = right[k];
        for j in k + 1..N {
            sum -= matrix[k][j] * solution[j];
        }
        solution[k] = sum * inverse_diagonal[k];
    }
    solution.iter().all(|entry| entry.is_finite()).then_some(solution)
}
