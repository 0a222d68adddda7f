//! The stages of a group of instances that fills the lanes.

use fearless_simd::{Level, Simd};

use crate::batch::hidden_pairs::HiddenPairs;
use crate::batch::lanes::{Lanes, MOST, lanes_in_use};
use crate::batch::polish::Equations;
use crate::batch::roots::real_roots;
use crate::batch::solver::{BatchData, BatchSolver};
use crate::determinant::CLEARANCE;
use crate::elimination::template::{action_matrix_from, solved_rows_from};
use crate::number::Arithmetic;
use crate::size::{List, Matrix, Size};
use crate::solution::distinct::{CLOSE, CLOSE_FLOOR};
use crate::solution::extract::monomial_value;
use crate::solution::inequality::is_wanted;
use crate::solution::real_solutions::{IMPRECISE_FLOOR, IMPRECISE_ROOT};
use crate::solution::symmetries::mapped_by;
use crate::solver_instance::{Point, Points, SolverInstance};
use crate::spectrum::hidden_variable::ChainedBasis;
use crate::spectrum::root_count::{LEAST_ERROR, SAFETY};

/// A square is negative beyond doubt if its ratio is, and if its monomial exceeds this part of the
/// largest entry of the eigenvector.
const CLEARLY_NEGATIVE: f64 = 1e-6;

/// The monomials that are read besides, as combinations of the basis.
type ReadRows<I, S> = Matrix<<I as BatchSolver>::Read, <I as SolverInstance>::Basis, Lanes<S>>;

/// A lane for each basis monomial.
type BasisLanes<I, S> = <<I as SolverInstance>::Basis as Size>::Vector<Lanes<S>>;

/// Solves all instances in groups. Returns false if the processor has no wide registers.
#[inline]
pub(super) fn solve_all<I: BatchSolver, D: BatchData<I>>(data: &[D], results: &mut [D::Result]) -> bool {
    let Some(level) = Level::try_detect() else { return false };
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    {
        if let Some(avx512) = level.as_avx512() {
            solve_groups::<_, I, D>(avx512, data, results);
            return true;
        }
        if let Some(avx2) = level.as_avx2() {
            solve_groups::<_, I, D>(avx2, data, results);
            return true;
        }
    }
    #[cfg(target_arch = "aarch64")]
    if let Some(neon) = level.as_neon() {
        solve_groups::<_, I, D>(neon, data, results);
        return true;
    }
    let _ = level;
    false
}

#[inline(never)]
fn solve_groups<S: Simd, I: BatchSolver, D: BatchData<I>>(simd: S, data: &[D], results: &mut [D::Result]) {
    const { assert!(Lanes::<S>::COUNT <= MOST, "there is a place for each instance") };
    let (sizes, batch) = I::all_sizes();
    let count = Lanes::<S>::COUNT;
    let zero = Lanes::splat(simd, 0.0);
    for (data, results) in data.chunks(count).zip(results.chunks_mut(count)) {
        let mut inputs = batch.inputs.filled(zero);
        let mut exponents: [Point<I, i16>; MOST] = core::array::from_fn(|_| sizes.unknowns.filled(0));
        let mut is_finite = 0;
        for lane in 0..count {
            // The last instance fills lanes that are left over.
            let Some(instance) = data.get(lane).or(data.last()) else { break };
            let mut of_lane = batch.inputs.filled(0.0);
            instance.inputs(of_lane.as_mut(), exponents[lane].as_mut());
            // Data that no equation reads must be finite, too.
            is_finite |= u64::from(of_lane.as_ref().iter().all(|x| x.is_finite())) << lane;
            for at in 0..batch.inputs.get() {
                inputs[at].set(lane, of_lane[at]);
            }
        }
        let mut points: [Points<I, f64>; MOST] = core::array::from_fn(|_| sizes.solutions.list());
        let is_certain = is_finite & solve_group::<S, I>(simd, &inputs, &mut points);
        for (lane, (data, result)) in data.iter().zip(results).enumerate() {
            *result =
                if is_certain >> lane & 1 == 1 { D::result(&points[lane], &exponents[lane]) } else { data.solve() };
        }
    }
}

/// Adds the real solutions of each instance. Returns a bit for each instance for which these are
/// certain to be all.
#[inline(always)]
fn solve_group<S: Simd, I: BatchSolver>(
    simd: S,
    inputs: &<I::Inputs as Size>::Vector<Lanes<S>>,
    points: &mut [Points<I, f64>; MOST],
) -> u64 {
    let (sizes, batch) = I::all_sizes();
    let (zero, one) = (Lanes::splat(simd, 0.0), Lanes::splat(simd, 1.0));
    let mut coefficients = batch.coefficients.filled(zero);
    simd.vectorize(
        #[inline(always)]
        || coefficients = I::coefficients(one, inputs),
    );
    let pairs = simd.vectorize(
        #[inline(always)]
        || {
            // The template stays in its result: a move would copy it.
            let right = I::eliminated(zero, &coefficients);
            let Ok(right) = &right else { return None };
            let action = action_matrix_from(sizes.basis, I::ACTION, right.as_ref(), zero);
            let read = solved_rows_from((batch.read, sizes.basis), I::READ, right.as_ref(), (zero, |x| x));
            let pairs = HiddenPairs::new(I::all_chains(), &action);
            let determinant = pairs.determinant();
            Some((pairs, read, determinant))
        },
    );
    let Some((pairs, read, determinant)) = &pairs else { return 0 };
    let (_, _, _, degree) = I::all_chains().sizes();
    let roots = real_roots(simd, degree, determinant);
    if I::HAS_ORIGIN {
        push_origin::<S, I>(simd, &coefficients, points);
    }
    let (mut is_certain, mut furthest) = (0, zero);
    for (lane, roots) in roots.iter().enumerate().take(Lanes::<S>::COUNT) {
        furthest.set(lane, IMPRECISE_ROOT.min(roots.clearance / SAFETY));
        // Without a root, no polish shows whether the polynomial is precise.
        let is_sure = match roots.roots.is_empty() {
            true => roots.clearance > CLEARANCE && !I::QUOTIENTS.are_large(|slot| coefficients[slot].get(lane)),
            false => roots.clearance > LEAST_ERROR,
        };
        let is_sure = is_sure && roots.is_certain;
        is_certain |= u64::from(is_sure) << lane;
    }
    let most = roots.iter().map(|roots| roots.roots.len()).max().unwrap_or(0);
    for number in 0..most {
        let mut x = zero;
        let mut in_use = 0;
        for (lane, roots) in roots.iter().enumerate().take(Lanes::<S>::COUNT) {
            if let Some(&root) = roots.roots.get(number) {
                x.set(lane, root);
                in_use |= 1 << lane;
            }
        }
        let found = simd.vectorize(
            #[inline(always)]
            || Solved::<S, I>::at(&coefficients, (pairs, read), (x, furthest)),
        );
        is_certain &= found.is_certain | found.is_imaginary | !in_use;
        let new = in_use & is_certain & !found.is_imaginary;
        for (lane, points) in points.iter_mut().enumerate().take(Lanes::<S>::COUNT) {
            if new >> lane & 1 == 1 && !push::<S, I>(points, &found.unknowns, lane) {
                is_certain &= !(1 << lane);
            }
        }
    }
    keep_wanted::<S, I>(&coefficients, points);
    is_certain & lanes_in_use::<S>()
}

/// Removes the points that do not satisfy the inequalities of the problem.
#[inline]
fn keep_wanted<S: Simd, I: BatchSolver>(
    coefficients: &<I::Coefficients as Size>::Vector<Lanes<S>>,
    points: &mut [Points<I, f64>; MOST],
) {
    if I::POSITIVE.is_empty() {
        return;
    }
    for (lane, points) in points.iter_mut().enumerate().take(Lanes::<S>::COUNT) {
        points.keep(|point| is_wanted(I::POSITIVE, |slot| coefficients[slot].get(lane), point.as_ref()));
    }
}

/// The solutions of a root of each instance.
struct Solved<S: Simd, I: BatchSolver> {
    unknowns: Point<I, Lanes<S>>,
    /// A bit for each instance whose solution is precise.
    is_certain: u64,
    /// A bit for each instance for which the square of an unknown is negative.
    is_imaginary: u64,
}

impl<S: Simd, I: BatchSolver> Solved<S, I> {
    /// At the root x of each instance. The polish may move the action monomial by this part of
    /// itself, or an unknown if the action monomial is not one of the unknowns.
    #[inline(always)]
    fn at(
        coefficients: &<I::Coefficients as Size>::Vector<Lanes<S>>,
        (pairs, read): (&HiddenPairs<S, I::Chains>, &ReadRows<I, S>),
        (x, furthest): (Lanes<S>, Lanes<S>),
    ) -> Self {
        let (sizes, batch) = I::all_sizes();
        let vector = pairs.vector(x);
        let mut largest = x.constant(0.0);
        for b in 0..sizes.basis.get() {
            largest = vector[b].abs().max(largest);
        }
        let values = monomial_values::<S, I>(&vector, read);
        let mut unknowns = sizes.unknowns.filled(x.constant(0.0));
        let mut is_imaginary = 0;
        for (at, pairs) in I::RATIOS.iter().enumerate() {
            if !pairs.is_empty() {
                let (ratio, monomial) = ratio::<S, I>(&values, pairs);
                unknowns[at] = ratio;
                if I::SYMMETRIES.is_some_and(|changes| changes.steps[at][at] == 2) {
                    let is_clear = monomial.above(largest * x.constant(CLEARLY_NEGATIVE)).bits();
                    is_imaginary |= x.constant(0.0).above(ratio).bits() & is_clear;
                }
            }
        }
        resolve::<S, I>(&mut unknowns);
        I::recovered(coefficients, &mut unknowns);
        let start = unknowns.clone();
        let equations = Equations {
            sizes: (sizes.unknowns, batch.equations, batch.products),
            monomials: I::monomials(),
            rows: I::equations(coefficients),
        };
        let mut is_certain = equations.polish(&mut unknowns);
        // One instance by itself is told more of its roots: see `count_is_certain`.
        let mut size = x.constant(0.0);
        for j in 0..sizes.unknowns.get() {
            size = unknowns[j].abs().max(size);
        }
        if I::ACTION_MONOMIAL.is_empty() {
            let floor = size * x.constant(IMPRECISE_FLOOR) * furthest;
            for j in 0..sizes.unknowns.get() {
                let bound = floor + unknowns[j].abs() * furthest;
                is_certain &= (unknowns[j] - start[j]).abs().at_most(bound).bits();
            }
        } else {
            let action = monomial_value(unknowns.as_ref(), I::ACTION_MONOMIAL);
            is_certain &= (action - x).abs().at_most(action.abs() * furthest).bits();
        }
        Self { unknowns, is_certain, is_imaginary }
    }
}

/// The values of basis monomials, and of those that are read besides.
#[inline(always)]
fn monomial_values<S: Simd, I: BatchSolver>(
    vector: &BasisLanes<I, S>,
    read: &ReadRows<I, S>,
) -> <I::Values as Size>::Vector<Lanes<S>> {
    let (sizes, batch) = I::all_sizes();
    let zero = vector[0].constant(0.0);
    let mut values = sizes.values.filled(zero);
    let basis = sizes.basis.get();
    for b in 0..basis {
        values[b] = vector[b];
    }
    for (at, row) in (0..batch.read.get()).map(|k| (basis + k, &read[k])) {
        for b in 0..basis {
            values[at] = values[at].plus(vector[b], row[b]);
        }
    }
    values
}

/// The least-squares ratio of monomial values: see [`ratio`](crate::emitted::ratio). The modulus of
/// the largest numerator comes with it.
#[inline(always)]
fn ratio<S: Simd, I: BatchSolver>(
    values: &<I::Values as Size>::Vector<Lanes<S>>,
    pairs: &[(u16, u16)],
) -> (Lanes<S>, Lanes<S>) {
    let zero = values[0].constant(0.0);
    let (mut numerator, mut denominator, mut largest) = (zero, zero, zero);
    for &(from, to) in pairs {
        let (from, to) = (values[usize::from(from)], values[usize::from(to)]);
        numerator = numerator.plus(from, to);
        denominator = denominator.plus(from, from);
        largest = to.abs().max(largest);
    }
    (numerator / denominator, largest)
}

/// Computes the unknowns from the ratios of their pairs: see
/// [`Symmetries`](crate::emitted::Symmetries).
#[inline(always)]
fn resolve<S: Simd, I: BatchSolver>(ratios: &mut Point<I, Lanes<S>>) {
    let Some(changes) = I::SYMMETRIES else { return };
    for (at, steps) in changes.steps.iter().enumerate() {
        if steps[at] == 2 {
            ratios[at] = ratios[at].sqrt();
        }
    }
    for (at, steps) in changes.steps.iter().enumerate().filter(|(at, steps)| steps[*at] == 1) {
        for (other, &step) in steps.iter().enumerate().filter(|(other, _)| *other != at) {
            match step {
                0 => {}
                1 => ratios[at] = ratios[at] / ratios[other],
                _ => ratios[at] = ratios[at] * ratios[other],
            }
        }
    }
}

/// Adds the solution of each instance at which all unknowns that were not eliminated are 0.
#[inline(always)]
fn push_origin<S: Simd, I: BatchSolver>(
    simd: S,
    coefficients: &<I::Coefficients as Size>::Vector<Lanes<S>>,
    points: &mut [Points<I, f64>; MOST],
) {
    let mut origin = I::all_sizes().0.unknowns.filled(Lanes::splat(simd, 0.0));
    simd.vectorize(
        #[inline(always)]
        || I::recovered(coefficients, &mut origin),
    );
    for (lane, points) in points.iter_mut().enumerate().take(Lanes::<S>::COUNT) {
        push::<S, I>(points, &origin, lane);
    }
}

/// Adds the point of a lane and its images under the symmetries. Returns false if one of them may
/// be the same as a point before, or if there is no room.
#[inline]
fn push<S: Simd, I: BatchSolver>(points: &mut Points<I, f64>, unknowns: &Point<I, Lanes<S>>, lane: usize) -> bool {
    let (sizes, _) = I::all_sizes();
    let mut point = sizes.unknowns.filled(0.0);
    let mut largest = 0.0;
    for j in 0..sizes.unknowns.get() {
        point[j] = unknowns[j].get(lane);
        largest = if point[j].abs() > largest { point[j].abs() } else { largest };
    }
    let mut is_new = push_one::<I>(points, &point, largest);
    for images in I::SYMMETRIES.map_or(&[][..], |symmetries| symmetries.images) {
        is_new &= push_one::<I>(points, &mapped_by(images, &point), largest);
    }
    is_new
}

#[inline]
fn push_one<I: BatchSolver>(points: &mut Points<I, f64>, point: &Point<I, f64>, largest: f64) -> bool {
    let agrees = |x: f64, y: f64| {
        // A point that is close has a largest unknown of about the same size.
        (x - y).abs() <= 1.01 * CLOSE_FLOOR * largest + CLOSE * if x.abs() > y.abs() { x.abs() } else { y.abs() }
    };
    let is_close = |known: &Point<I, f64>| known.as_ref().iter().zip(point.as_ref()).all(|(&x, &y)| agrees(x, y));
    !points.iter().any(is_close) && points.push(point.clone())
}
