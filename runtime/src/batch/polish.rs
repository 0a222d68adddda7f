//! Gauss-Newton steps on the equations of several instances.

use fearless_simd::prelude::*;

use crate::batch::lanes::{Lanes, Mask, lanes_in_use};
use crate::number::Arithmetic;
use crate::size::{Matrix, Size, filled_matrix};
use crate::solution::polish::{CURVATURE, FAR, ILL_CONDITIONED, LARGE, NOISE, ROUNDING, STALLED};
use crate::solution::system::Monomials;

/// Instances that need more steps are rare. They are solved by themselves.
const MOST_STEPS: usize = 4;

/// The equations of several instances, as in [`DenseSystem`](crate::emitted::DenseSystem).
pub(super) struct Equations<'a, S: Simd, N: Size, E: Size, K: Size, Q> {
    pub(super) sizes: (N, E, K),
    pub(super) monomials: Q,
    pub(super) rows: &'a Matrix<K, E, Lanes<S>>,
}

impl<S: Simd, N: Size, E: Size, K: Size, Q: Monomials<N, K>> Equations<'_, S, N, E, K, Q> {
    /// Polishes x. Returns a bit for each instance for which the polish gives what that of one
    /// instance would give: few short steps lower the residual to rounding.
    #[inline(always)]
    pub(super) fn polish(&self, x: &mut N::Vector<Lanes<S>>) -> u64 {
        let (unknowns, equations, _) = self.sizes;
        let (zero, one) = (x[0].constant(0.0), x[0].constant(1.0));
        let (mut values, scales) = self.values_and_scales(&self.monomials.products(x));
        let mut weight = equations.filled(zero);
        let mut has_scales = u64::MAX;
        for e in 0..equations.get() {
            has_scales &= scales[e].above(zero).bits();
            weight[e] = one / scales[e];
        }
        let rounding = zero.constant(ROUNDING);
        let mut residual = largest_weighted::<S, E>(equations, &values, &weight);
        let mut open = !residual.at_most(rounding).bits();
        let mut is_near = u64::MAX;
        // Solutions are polished in steps so short that one Jacobian serves all.
        let jacobian = LeastSquares::factored((unknowns, equations), self.weighted_derivatives(x, &weight));
        for number in 0..MOST_STEPS {
            if open & lanes_in_use::<S>() == 0 {
                break;
            }
            for e in 0..equations.get() {
                values[e] = values[e] * weight[e];
            }
            let step = jacobian.solution(&mut values);
            let mut moved = x.clone();
            let mut size = zero;
            for j in 0..unknowns.get() {
                moved[j] -= step[j];
                size = moved[j].abs().max(size);
            }
            if number == 0 {
                let known = jacobian.residual_after(x, &step, &values);
                if open & lanes_in_use::<S>() & !known.at_most(rounding).bits() == 0 {
                    let is_open = Mask::from_bits(zero.token(), open);
                    for j in 0..unknowns.get() {
                        x[j] = is_open.select(moved[j], x[j]);
                    }
                    residual = is_open.select(known, residual);
                    break;
                }
            }
            let noise = size * zero.constant(NOISE);
            let mut is_short = u64::MAX;
            for j in 0..unknowns.get() {
                is_short &= step[j].abs().at_most(moved[j].abs() * zero.constant(FAR) + noise).bits();
            }
            // The last step of each instance counts, taken or not.
            is_near = (is_near & !open) | (is_short & open);
            values = self.values(&self.monomials.products(&moved));
            let moved_residual = largest_weighted::<S, E>(equations, &values, &weight);
            let lowers = residual.above(moved_residual);
            for j in 0..unknowns.get() {
                x[j] = lowers.select(moved[j], x[j]);
            }
            residual = lowers.select(moved_residual, residual);
            // After a long step one more is taken.
            open &= lowers.bits() & !(residual.at_most(rounding).bits() & is_short);
        }
        let is_solved = has_scales & is_near & residual.at_most(zero.constant(STALLED)).bits();
        is_solved & jacobian.is_well_conditioned(x) & self.is_bounded(x)
    }

    /// A bit for each instance whose point is not on the way to infinity, where halves of large
    /// unknowns would be a solution, too.
    #[inline(always)]
    fn is_bounded(&self, x: &N::Vector<Lanes<S>>) -> u64 {
        let (unknowns, equations, _) = self.sizes;
        let large = x[0].constant(LARGE);
        let mut halved = x.clone();
        let mut is_large = 0;
        for j in 0..unknowns.get() {
            let of_unknown = large.at_most(x[j].abs());
            is_large |= of_unknown.bits();
            halved[j] = of_unknown.select(x[j] * large.constant(0.5), x[j]);
        }
        if is_large == 0 {
            return u64::MAX;
        }
        let (values, mut scales) = self.values_and_scales(&self.monomials.products(&halved));
        for e in 0..equations.get() {
            scales[e] = large.constant(1.0) / scales[e];
        }
        let residual = largest_weighted::<S, E>(equations, &values, &scales);
        residual.above(large.constant(STALLED)).bits() | !is_large
    }

    #[inline(always)]
    fn values_and_scales(&self, monomials: &K::Vector<Lanes<S>>) -> (E::Vector<Lanes<S>>, E::Vector<Lanes<S>>) {
        let (_, equations, count) = self.sizes;
        let zero = monomials[0].constant(0.0);
        let (mut values, mut scales) = (equations.filled(zero), equations.filled(zero));
        for k in (0..count.get()).rev() {
            let (row, factor) = (&self.rows[k], monomials[k]);
            for e in 0..equations.get() {
                let term = factor * row[e];
                values[e] += term;
                scales[e] += term.abs();
            }
        }
        (values, scales)
    }

    #[inline(always)]
    fn values(&self, monomials: &K::Vector<Lanes<S>>) -> E::Vector<Lanes<S>> {
        let (_, equations, count) = self.sizes;
        let mut values = equations.filled(monomials[0].constant(0.0));
        for k in (0..count.get()).rev() {
            let (row, factor) = (&self.rows[k], monomials[k]);
            for e in 0..equations.get() {
                values[e] = values[e].plus(factor, row[e]);
            }
        }
        values
    }

    #[inline(always)]
    fn weighted_derivatives(&self, x: &N::Vector<Lanes<S>>, weight: &E::Vector<Lanes<S>>) -> Matrix<N, E, Lanes<S>> {
        let (unknowns, equations, _) = self.sizes;
        let zero = x[0].constant(0.0);
        let mut columns = filled_matrix(unknowns, equations, zero);
        self.monomials.for_each_gradient(
            x,
            &self.monomials.products(x),
            #[inline(always)]
            |j, terms| {
                let mut column = columns[j].clone();
                for &(k, factor) in terms {
                    let row = &self.rows[usize::from(k)];
                    for e in 0..equations.get() {
                        column[e] = column[e].plus(factor, row[e]);
                    }
                }
                columns[j] = column;
            },
        );
        for j in 0..unknowns.get() {
            for e in 0..equations.get() {
                columns[j][e] = columns[j][e] * weight[e];
            }
        }
        columns
    }
}

/// max |f_e| weight_e; NaN if a number is not finite.
#[inline(always)]
fn largest_weighted<S: Simd, E: Size>(
    equations: E,
    values: &E::Vector<Lanes<S>>,
    weight: &E::Vector<Lanes<S>>,
) -> Lanes<S> {
    let zero = values[0].constant(0.0);
    let (mut worst, mut finite) = (zero, zero);
    for e in 0..equations.get() {
        let size = values[e].abs() * weight[e];
        worst = size.max(worst);
        finite += size * zero;
    }
    worst + finite
}

/// The Householder QR decomposition of the weighted Jacobian, as that of one instance.
struct LeastSquares<S: Simd, N: Size, E: Size> {
    sizes: (N, E),
    /// Column k holds the vector of reflection k from row k on, and R above.
    columns: Matrix<N, E, Lanes<S>>,
    /// 2 / (squared length) of the vectors of the reflections.
    inverse_factors: N::Vector<Lanes<S>>,
    /// One over the diagonal of R.
    inverse_diagonal: N::Vector<Lanes<S>>,
}

impl<S: Simd, N: Size, E: Size> LeastSquares<S, N, E> {
    /// Numbers of an instance that has lost rank are not finite, or so large that no step is short.
    #[inline(always)]
    fn factored((unknowns, equations): (N, E), mut columns: Matrix<N, E, Lanes<S>>) -> Self {
        let (n, count) = (unknowns.get(), equations.get());
        let zero = columns[0][0].constant(0.0);
        let one = zero.constant(1.0);
        let mut inverse_diagonal = unknowns.filled(zero);
        let mut inverse_factors = unknowns.filled(zero);
        for k in 0..n {
            let square = product::<S, E>((k, count), &columns[k], &columns[k]);
            let length = square.sqrt();
            let head = columns[k][k];
            // R[k][k] points opposite to the head, so that head - diagonal does not cancel.
            let diagonal = head.above(zero).select(-length, length);
            inverse_diagonal[k] = one / diagonal;
            columns[k][k] = head - diagonal;
            inverse_factors[k] = one / (square + length * head.abs());
            let (done, rest) = columns.as_mut().split_at_mut(k + 1);
            for other in rest {
                reflect::<S, E>((k, count), &done[k], inverse_factors[k], other);
            }
        }
        Self { sizes: (unknowns, equations), columns, inverse_factors, inverse_diagonal }
    }

    /// A bit for each instance whose solution x needs no refinement at twice the precision.
    #[inline(always)]
    fn is_well_conditioned(&self, x: &N::Vector<Lanes<S>>) -> u64 {
        let (enlargement, size) = self.enlargement_and_size(x);
        enlargement.at_most(size * size.constant(ILL_CONDITIONED)).bits()
    }

    /// The largest entry of one over the diagonal of R, and of x.
    #[inline(always)]
    fn enlargement_and_size(&self, x: &N::Vector<Lanes<S>>) -> (Lanes<S>, Lanes<S>) {
        let (mut enlargement, mut size) = (self.inverse_diagonal[0].abs(), x[0].abs());
        for k in 1..self.sizes.0.get() {
            enlargement = self.inverse_diagonal[k].abs().max(enlargement);
            size = x[k].abs().max(size);
        }
        (enlargement, size)
    }

    /// A bound on the relative residual after a step from the point x of the Jacobian, enlarged if
    /// errors are: if it is rounding, a further step would change nothing. `right` is what
    /// [`LeastSquares::solution`] leaves.
    #[inline(always)]
    fn residual_after(
        &self,
        x: &N::Vector<Lanes<S>>,
        step: &N::Vector<Lanes<S>>,
        right: &E::Vector<Lanes<S>>,
    ) -> Lanes<S> {
        let (unknowns, equations) = self.sizes;
        let (enlargement, size) = self.enlargement_and_size(x);
        let mut change = size.constant(0.0);
        for j in 0..unknowns.get() {
            // An unknown that is zero makes it infinite or NaN.
            change = (step[j] / x[j]).abs().max(change);
        }
        let mut square = size.constant(0.0);
        for e in unknowns.get()..equations.get() {
            square = square.plus(right[e], right[e]);
        }
        let higher = change * change * size.constant(CURVATURE);
        square.sqrt() + higher * enlargement.max(size) / size
    }

    /// The least-squares solution for this right side, which is overwritten.
    #[inline(always)]
    fn solution(&self, right: &mut E::Vector<Lanes<S>>) -> N::Vector<Lanes<S>> {
        let (unknowns, equations) = self.sizes;
        let n = unknowns.get();
        let mut solution = unknowns.filled(right[0].constant(0.0));
        for k in 0..n {
            reflect::<S, E>((k, equations.get()), &self.columns[k], self.inverse_factors[k], right);
        }
        for k in (0..n).rev() {
            let mut sum = right[k];
            for j in k + 1..n {
                sum = sum.minus(self.columns[j][k], solution[j]);
            }
            solution[k] = sum * self.inverse_diagonal[k];
        }
        solution
    }
}

/// The scalar product of two columns from row k on.
#[inline(always)]
fn product<S: Simd, E: Size>((k, count): (usize, usize), a: &E::Vector<Lanes<S>>, b: &E::Vector<Lanes<S>>) -> Lanes<S> {
    // Two sums, so that none waits for the one before it.
    let mut sums = [a[0].constant(0.0); 2];
    for e in k..count {
        sums[e % 2] = sums[e % 2].plus(a[e], b[e]);
    }
    sums[0] + sums[1]
}

/// Subtracts v v^T `other` times the factor, from row k on.
#[inline(always)]
fn reflect<S: Simd, E: Size>(
    (k, count): (usize, usize),
    v: &E::Vector<Lanes<S>>,
    inverse_factor: Lanes<S>,
    other: &mut E::Vector<Lanes<S>>,
) {
    let factor = product::<S, E>((k, count), v, other) * inverse_factor;
    for e in k..count {
        other[e] = other[e].minus(v[e], factor);
    }
}
