//! Gauss-Newton steps on the original equations.

use crate::number::scalar::mapped;
use crate::number::sums::{folded, sum_of};
use crate::number::{Scalar, float};
use crate::size::{Matrix, Size, filled_matrix};
use crate::solution::system::{System, Values};

/// The largest number of steps. One or two steps usually lower the residual, and the next one
/// stops.
pub const POLISH_STEPS: usize = 24;

/// A step that does not lower a high residual is shortened by this factor.
const SHORTER: f64 = 0.35;
/// A step is shortened at most this many times.
const SHORTER_STEPS: usize = 6;

/// A relative residual at most this is rounding: a step could hardly lower it.
pub(crate) const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// A relative residual above this after the last step has a cause other than rounding.
pub(crate) const STALLED: f64 = 1e-12;

/// A step that changes each unknown by at most this part of it leaves the scale of an equation as
/// it is, but for this part times the degree.
const NEAR: f64 = 1e-3;

/// A step that changes each unknown by at most a part s of it changes a term of degree d by its
/// linear part and by at most about d (d - 1) / 2 s^2 of the term: this is more, up to degree 14.
pub(crate) const CURVATURE: f64 = 100.0;

/// An unknown this small relative to the largest one may be the rounding noise of zero.
pub(crate) const NOISE: f64 = 1e-12;
/// An unknown below this times the relative residual, relative to the largest unknown, cannot be
/// told from zero. The polish converges slowly towards solutions that are not isolated, such as
/// solutions at which an excluded factor vanishes.
const UNCERTAIN: f64 = 1e3;

/// A step that changes an unknown by more than this part of it shows that no solution is near, if
/// the residual has a cause other than rounding or stays below [`FLAT`].
pub(crate) const FAR: f64 = 0.1;

/// If the relative residual is below this after a long step away from x, the equations are nearly
/// constant in that direction, and no solution is near. Away from a double solution the residual
/// grows with the square of the distance.
const FLAT: f64 = 1e-6;

/// Unknowns at least this large may be on the way to infinity. They are if the residual of half of
/// them is rounding, too. (At such points steps are rounding errors and show nothing.)
pub(crate) const LARGE: f64 = 1e6;

/// A point is ill-conditioned if a relative error of the equations may move it by more than so many
/// times this error, relative to its largest unknown: rounding then costs it more than 9 of its 16
/// digits.
pub(crate) const ILL_CONDITIONED: f64 = 1e6;

/// Improves x by at most `steps` Gauss-Newton steps and returns its relative residual,
///
/// max over equations e of |f_e(x)| / (sum of the moduli of the terms of f_e at x), where 0/0 = 0.
///
/// After a step of less than a thousandth of each unknown the sums are those of the point before,
/// but the result, where it has a cause other than rounding, is that of the point itself. After a
/// step so short that the residual is certain to be rounding it is not evaluated: the result is
/// what the linear equations of the step leave over, and what higher terms may add.
///
/// Equations are weighted by one over that sum, so their scaling does not matter; the scaling of
/// unknowns does not matter to Householder QR. A step is kept only if it lowers the residual, or is
/// as short as that; if it does not, a fraction of it is tried. The iteration ends if no fraction
/// lowers the residual, at a residual at rounding level, and at a rank-deficient Jacobian. If x or
/// a value at x is not finite, x stays and the result is infinity.
///
/// The result is also infinity if the last step, taken or not, changes an unknown by more than a
/// tenth, and the residual is above rounding or stays small along the whole step: no solution is
/// near. Far out, where the terms of highest degree alone nearly vanish, the residual is small
/// although no solution is near.
///
/// If every term of an equation holds an unknown that is zero at the solution, noise in that
/// unknown keeps the relative residual high, however small the noise is. A step that does not lower
/// a high residual is therefore tried again with unknowns at noise level set to zero.
#[inline]
pub fn polish<S: Scalar, N: Size, E: Size>(
    x: &mut N::Vector<S>,
    (unknowns, equations): (N, E),
    system: &impl System<S, N, E>,
    steps: usize,
) -> f64 {
    polish_and_judge(x, (unknowns, equations), system, steps).residual
}

/// A polished point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Polished {
    /// The relative residual.
    pub(crate) residual: f64,
    /// Whether errors of the equations are enlarged by more than [`ILL_CONDITIONED`].
    pub(crate) is_ill_conditioned: bool,
}

/// As [`polish`]; says in addition whether the point is ill-conditioned, which only steps show.
#[inline]
pub(crate) fn polish_and_judge<S: Scalar, N: Size, E: Size>(
    x: &mut N::Vector<S>,
    (unknowns, equations): (N, E),
    system: &impl System<S, N, E>,
    steps: usize,
) -> Polished {
    let mut polish = Polish::new(x, (unknowns, equations), system);
    let residual = polish.residual();
    match steps {
        0 => Polished { residual, is_ill_conditioned: false },
        _ => polish.run(x, residual, steps),
    }
}

/// One polish: the system, and what it is at the point where it was evaluated last.
pub(crate) struct Polish<'a, S: Scalar, N: Size, E: Size, Y: System<S, N, E>> {
    unknowns: N,
    equations: E,
    system: &'a Y,
    monomials: Y::Monomials,
    at: Values<S, E>,
    /// One over the scale of each equation; 0 for an equation whose terms all vanish.
    weight: E::Vector<f64>,
    /// Whether the weights are those of a point close to the one that was evaluated last.
    has_old_scales: bool,
}

/// The end of an iteration.
struct Ended<S: Scalar, N: Size> {
    /// The residual of the point.
    best: f64,
    /// The last step, taken or not.
    step: Step<S, N>,
    /// Whether the residual is by the scales of another point.
    has_old_scales: bool,
    /// Whether the last step leads from a residual that is rounding to one that is small, too.
    flat: bool,
}

/// A Gauss-Newton step, which is subtracted from a point.
pub(crate) struct Step<S: Scalar, N: Size> {
    pub(crate) correction: N::Vector<S>,
    /// The largest 1 / |R\[k\]\[k\]| of the QR decomposition of the weighted Jacobian: a relative
    /// error of the equations may move the point by so much, and by several times that where
    /// columns of R are long beside their diagonal entry.
    pub(crate) enlargement: f64,
    /// The length of what the step leaves of the weighted equations, as far as they are linear.
    left: f64,
}

impl<'a, S: Scalar, N: Size, E: Size, Y: System<S, N, E>> Polish<'a, S, N, E, Y> {
    /// At this point, nothing evaluated but the monomials.
    #[inline]
    pub(crate) fn new(x: &N::Vector<S>, (unknowns, equations): (N, E), system: &'a Y) -> Self {
        let (at, weight) = (Values::zero(equations), equations.filled(0.0));
        Self { unknowns, equations, system, monomials: system.monomials(x), at, weight, has_old_scales: false }
    }

    /// The relative residual at the point of the monomials.
    #[inline]
    pub(crate) fn residual(&mut self) -> f64 {
        self.has_old_scales = false;
        self.system.residual(&self.monomials, &mut self.at);
        for e in 0..self.equations.get() {
            let scale = self.at.scale[e];
            // A scale that is not finite gives NaN.
            self.weight[e] = if scale > 0.0 { 1.0 / scale } else { 0.0 } + scale * 0.0;
        }
        largest_weighted(self.equations, &self.at.residual, &self.weight)
    }

    /// The relative residual at x.
    #[inline]
    pub(crate) fn residual_at(&mut self, x: &N::Vector<S>) -> f64 {
        self.monomials = self.system.monomials(x);
        self.residual()
    }

    /// The relative residual at a point close to the one before, by the scales there.
    #[inline]
    fn residual_near(&mut self, x: &N::Vector<S>) -> f64 {
        self.has_old_scales = true;
        self.monomials = self.system.monomials(x);
        self.system.values(&self.monomials, &mut self.at.residual);
        largest_weighted(self.equations, &self.at.residual, &self.weight)
    }

    #[inline]
    fn run(&mut self, x: &mut N::Vector<S>, residual: f64, steps: usize) -> Polished {
        let mut ended = self.iterate(x, residual, steps);
        // By the scales of the point before it may be wrong by a small part, and pass a bound that
        // it exceeds.
        if ended.has_old_scales && ended.best > STALLED {
            ended.best = self.residual_at(x);
        }
        let is_ill_conditioned = ended.step.enlargement > ILL_CONDITIONED * largest(x.as_ref());
        Polished { residual: self.verdict(x, &ended), is_ill_conditioned }
    }

    #[inline]
    fn iterate(&mut self, x: &mut N::Vector<S>, residual: f64, steps: usize) -> Ended<S, N> {
        let mut derivatives = filled_matrix(self.unknowns, self.equations, S::ZERO);
        let (mut best, mut flat, mut has_old_scales) = (residual, false, false);
        let mut last = Step { correction: self.unknowns.filled(S::ZERO), enlargement: 0.0, left: 0.0 };
        for step in 0..steps {
            if best == f64::INFINITY {
                break;
            }
            let Some(next) = self.newton_step(x, &mut derivatives) else {
                // An equation all of whose terms are noise outweighs the others.
                match self.without_noise(x, best) {
                    Some(lower) => (best, has_old_scales) = (lower, false),
                    None => break,
                }
                continue;
            };
            // At a residual that is rounding the step is only asked for the condition.
            if step == 0 && best <= ROUNDING {
                last.enlargement = next.enlargement;
                break;
            }
            last = next;
            if let Some(residual) = self.residual_after(x, &last) {
                (best, flat, has_old_scales) = (residual, false, false);
                for j in 0..self.unknowns.get() {
                    x[j] -= last.correction[j];
                }
                break;
            }
            let (moved, residual) = self.step(x, &last.correction, best);
            flat = best <= STALLED && residual <= FLAT;
            if !(residual < best) {
                break;
            }
            (best, has_old_scales) = (residual, self.has_old_scales);
            *x = moved;
            // After a long step one more is taken: it stays near x if the solution is badly
            // determined, and leads away if there is no solution.
            if best <= ROUNDING && !self.is_far(x, &last).as_ref().contains(&true) {
                break;
            }
        }
        Ended { best, step: last, has_old_scales, flat }
    }

    /// A bound on the relative residual after a step that is so short that it is rounding, and that
    /// a further step would change nothing, though errors of the equations are enlarged.
    #[inline]
    fn residual_after(&self, x: &N::Vector<S>, step: &Step<S, N>) -> Option<f64> {
        let (mut change, mut largest) = (0.0, 0.0);
        for j in 0..self.unknowns.get() {
            let (part, size) = (step.correction[j].magnitude(), x[j].magnitude());
            // The comparison is false for 0/0, which is no change.
            change = if part / size > change { part / size } else { change };
            largest = if size > largest { size } else { largest };
        }
        let higher = CURVATURE * change * change;
        let is_certain = higher * f64::max(step.enlargement, largest) <= ROUNDING * largest && step.left <= ROUNDING;
        is_certain.then_some(step.left + higher)
    }

    /// The step at x, where the equations were evaluated, for other values of theirs.
    pub(crate) fn step_for(
        &mut self,
        x: &N::Vector<S>,
        values: E::Vector<S>,
        derivatives: &mut Matrix<N, E, S>,
    ) -> Option<Step<S, N>> {
        self.at.residual = values;
        self.newton_step(x, derivatives)
    }

    /// The Gauss-Newton step at x for the residuals at hand, which are overwritten, as are the
    /// derivatives. `None` if the Jacobian has lost rank.
    #[inline]
    pub(crate) fn newton_step(&mut self, x: &N::Vector<S>, derivatives: &mut Matrix<N, E, S>) -> Option<Step<S, N>> {
        self.system.derivatives(x, &self.monomials, derivatives);
        self.weigh(derivatives);
        least_squares((self.unknowns, self.equations), derivatives, &mut self.at.residual)
    }

    /// Multiplies each equation by its weight, or divides it by the size of its gradient if all its
    /// terms vanish.
    #[inline]
    fn weigh(&mut self, derivatives: &mut Matrix<N, E, S>) {
        let (unknowns, equations) = (self.unknowns.get(), self.equations.get());
        let mut weight = self.weight.clone();
        if weight.as_ref().contains(&0.0) {
            for e in 0..equations {
                let size = (0..unknowns).map(|j| derivatives[j][e].magnitude()).fold(0.0, f64::max);
                if weight[e] == 0.0 && size > 0.0 {
                    weight[e] = 1.0 / size;
                }
            }
        }
        for e in 0..equations {
            self.at.residual[e] = self.at.residual[e].scale(weight[e]);
        }
        for j in 0..unknowns {
            for e in 0..equations {
                derivatives[j][e] = derivatives[j][e].scale(weight[e]);
            }
        }
    }

    /// Sets noise to zero if that lowers a high residual, which is returned then.
    #[inline(never)]
    fn without_noise(&mut self, x: &mut N::Vector<S>, best: f64) -> Option<f64> {
        let zeroed = zero_below(self.unknowns, x, NOISE);
        let residual = if best > STALLED { self.residual_at(&zeroed) } else { best };
        (residual < best).then(|| {
            *x = zeroed;
            residual
        })
    }

    /// The point that a step from x leads to, and its residual. A step that does not lower a high
    /// residual is tried again with noise set to zero, and then shortened.
    #[inline]
    fn step(&mut self, x: &N::Vector<S>, correction: &N::Vector<S>, best: f64) -> (N::Vector<S>, f64) {
        let (mut moved, mut is_near) = (x.clone(), true);
        for j in 0..self.unknowns.get() {
            moved[j] -= correction[j];
            is_near &= correction[j].magnitude() <= NEAR * x[j].magnitude();
        }
        let mut residual = if is_near { self.residual_near(&moved) } else { self.residual_at(&moved) };
        if !(residual < best) && best > STALLED {
            moved = zero_below(self.unknowns, &moved, NOISE);
            residual = self.residual_at(&moved);
        }
        let mut fraction = 1.0;
        for _ in 0..SHORTER_STEPS {
            if residual < best || best <= STALLED {
                break;
            }
            fraction *= SHORTER;
            for j in 0..self.unknowns.get() {
                moved[j] = x[j] - correction[j].scale(fraction);
            }
            residual = self.residual_at(&moved);
        }
        (moved, residual)
    }

    /// Returns the residual, or infinity if no solution is near.
    #[inline]
    fn verdict(&mut self, x: &N::Vector<S>, ended: &Ended<S, N>) -> f64 {
        let best = ended.best;
        let is_large = |value: &S| value.magnitude() >= LARGE;
        if x.as_ref().iter().any(is_large) {
            let halved = mapped(self.unknowns, x, |value: S| if is_large(&value) { value.scale(0.5) } else { value });
            if self.residual_at(&halved) <= STALLED.max(best) {
                return f64::INFINITY;
            }
        }
        let far = self.is_far(x, &ended.step);
        if !far.as_ref().contains(&true) {
            return best;
        }
        // An unknown that is zero up to noise may change by as much as it likes: the residual
        // without it decides.
        let mut without = x.clone();
        let unknowns = without.as_mut().iter_mut().zip(far.as_ref());
        unknowns.filter(|(_, far)| **far).for_each(|(value, _)| *value = S::ZERO);
        if best > STALLED || (ended.flat && self.residual_at(&without) > STALLED) { f64::INFINITY } else { best }
    }

    /// The unknowns that a step changes by more than the part [`FAR`], apart from rounding noise of
    /// zero. Where errors of the equations are enlarged, so is that noise: a distortion of 0, of
    /// which points tell little, may be 1e-11 in one step and -1e-11 in the next.
    #[inline]
    fn is_far(&self, x: &N::Vector<S>, step: &Step<S, N>) -> N::Vector<bool> {
        let size = largest(x.as_ref());
        let noise = f64::max(NOISE * size, ROUNDING * step.enlargement.min(ILL_CONDITIONED * size));
        let mut far = self.unknowns.filled(false);
        for j in 0..self.unknowns.get() {
            far[j] = step.correction[j].magnitude() > FAR * x[j].magnitude() + noise;
        }
        far
    }
}

/// A polished x of this relative residual, with unknowns that cannot be told from zero set to zero.
#[inline]
pub(crate) fn zero_below_accuracy<S: Scalar, N: Size>(unknowns: N, x: &N::Vector<S>, residual: f64) -> N::Vector<S> {
    zero_below(unknowns, x, NOISE.max(UNCERTAIN * residual))
}

/// x, with unknowns of at most this magnitude, relative to the largest unknown, set to zero.
#[inline]
fn zero_below<S: Scalar, N: Size>(unknowns: N, x: &N::Vector<S>, level: f64) -> N::Vector<S> {
    let smallest = level * largest(x.as_ref());
    mapped(unknowns, x, |value: S| if value.magnitude() <= smallest { S::ZERO } else { value })
}

/// The magnitude of the largest unknown.
#[inline]
pub(crate) fn largest<S: Scalar>(x: &[S]) -> f64 {
    x.iter().map(|value| value.magnitude()).fold(0.0, f64::max)
}

/// max |f_e| weight_e; infinity if a number is not finite.
#[inline]
fn largest_weighted<S: Scalar, E: Size>(equations: E, values: &E::Vector<S>, weight: &E::Vector<f64>) -> f64 {
    let size = |e: usize| values[e].modulus() * weight[e];
    let worst = folded(equations.get(), 0.0, size, |a, b| if b > a { b } else { a });
    if sum_of(equations.get(), 0.0, size).is_finite() { worst } else { f64::INFINITY }
}

/// The least-squares solution y of E equations in N <= E unknowns, sum over j of columns[j] y[j] =
/// right, by Householder QR. Both arguments are overwritten. `None` if the matrix has lost rank (a
/// diagonal entry of R is below N epsilon times its column) or a number is not finite.
#[inline]
fn least_squares<S: Scalar, N: Size, E: Size>(
    (unknowns, equations): (N, E),
    columns: &mut Matrix<N, E, S>,
    right: &mut E::Vector<S>,
) -> Option<Step<S, N>> {
    let n = unknowns.get();
    if equations.get() < n {
        return None;
    }
    let rounding = n as f64 * f64::EPSILON;
    let mut smallest = unknowns.filled(0.0);
    for k in 0..n {
        smallest[k] = rounding * rounding * squared_length(columns[k].as_ref());
    }
    let mut inverse_diagonal = unknowns.filled(S::ZERO);
    let mut triangle = filled_matrix(unknowns, unknowns, S::ZERO);
    for k in 0..n {
        let (done, rest) = columns.as_mut().split_at_mut(k + 1);
        let column = &mut done[k];
        // What is above the diagonal belongs to R. Zeros in its place leave those rows alone, and
        // all loops have the length of a column, which the compiler knows.
        for i in 0..k {
            triangle[i][k] = column[i];
            column[i] = S::ZERO;
        }
        let square = squared_length(column.as_ref());
        if !(square > smallest[k]) {
            return None;
        }
        let length = float::sqrt(square);
        let head = column[k];
        let size = head.modulus();
        // R[k][k] points opposite to the head, so that head - diagonal does not cancel.
        let diagonal = if size > 0.0 { -head.scale(length / size) } else { S::from_f64(-length) };
        inverse_diagonal[k] = diagonal.reciprocal();
        column[k] = head - diagonal;
        // The reflection is I - v v^H / factor, where v is the column as it is now.
        let inverse_factor = 1.0 / (square + length * size);
        for other in rest {
            reflect(equations, column, inverse_factor, other);
        }
        reflect(equations, column, inverse_factor, right);
    }
    let mut solution = unknowns.filled(S::ZERO);
    for k in (0..n).rev() {
        let mut sum = right[k];
        for j in k + 1..n {
            sum -= triangle[k][j] * solution[j];
        }
        solution[k] = sum * inverse_diagonal[k];
    }
    let is_finite = solution.as_ref().iter().all(|entry| entry.is_finite());
    let enlargement = largest(inverse_diagonal.as_ref());
    let left = float::sqrt(squared_length(&right.as_ref()[n..]));
    is_finite.then_some(Step { correction: solution, enlargement, left })
}

/// Subtracts v v^H `other` times the factor.
#[inline(always)]
fn reflect<S: Scalar, E: Size>(equations: E, v: &E::Vector<S>, inverse_factor: f64, other: &mut E::Vector<S>) {
    let product = sum_of(equations.get(), S::ZERO, |e| v[e].conj() * other[e]).scale(inverse_factor);
    for e in 0..equations.get() {
        other[e] -= v[e] * product;
    }
}

#[inline]
fn squared_length<S: Scalar>(column: &[S]) -> f64 {
    sum_of(column.len(), 0.0, |e| column[e].modulus_squared())
}
