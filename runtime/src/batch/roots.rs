//! The real roots of a polynomial of each instance, by the method of
//! [`real_roots`](crate::emitted::real_roots): isolation in the Bernstein basis, then Newton steps
//! in brackets.
//!
//! The pieces of the axis are converted for all instances at once. Intervals that must be halved,
//! and roots, are few and differ from instance to instance: those of all instances share the lanes.

use fearless_simd::Simd;

use crate::batch::lanes::{Lanes, MOST, Mask, lanes_in_use};
use crate::number::{Arithmetic, float};
use crate::size::{List, Size};
use crate::spectrum::real_roots::{Bracket, CLEAR_MIDDLE, HALVINGS, LAST_STEP, MOST_STEPS, RealRoots, UNIT};

/// The pieces of the axis: x = t, 1/t, -t, -1/t for t in the unit interval.
const PIECES: usize = 4;

/// Polynomials of all instances, lowest coefficient first.
type Polynomials<S, Z> = <Z as Size>::Vector<Lanes<S>>;

/// An interval of a piece of the axis.
#[derive(Clone, Copy, Default)]
struct Interval {
    instance: usize,
    piece: usize,
    low: f64,
    high: f64,
    /// How often it may still be halved.
    halvings: u32,
    /// The largest Bernstein coefficient of the piece.
    largest: f64,
}

/// An interval that must be halved, with its Bernstein coefficients.
type Open<Z> = (Interval, <Z as Size>::Vector<f64>);

/// What the Bernstein coefficients of an interval of each instance say.
struct Control<S: Simd> {
    /// The largest and the least modulus.
    largest: Lanes<S>,
    least: Lanes<S>,
    /// Bits: the sign changes at all; more than once; the first coefficient is negative.
    some: u64,
    many: u64,
    rises: u64,
    /// The zero of the control polygon, if the sign changes once.
    crossing: Lanes<S>,
}

impl<S: Simd> Control<S> {
    #[inline(always)]
    fn of<Z: Size>(size: Z, bernstein: &Polynomials<S, Z>) -> Self {
        let n = size.get() - 1;
        let zero = bernstein[0].constant(0.0);
        let (mut largest, mut least) = (bernstein[0].abs(), bernstein[0].abs());
        let rises = zero.above(bernstein[0]).bits();
        let (mut some, mut many, mut negative) = (0, 0, rises);
        let (mut before, mut after, mut position) = (zero, zero, zero);
        for k in 1..n + 1 {
            let size = bernstein[k].abs();
            largest = size.max(largest);
            least = size.above(least).select(least, size);
            let is_negative = zero.above(bernstein[k]).bits();
            let changes = negative ^ is_negative;
            many |= some & changes;
            some |= changes;
            negative = is_negative;
            let changes = Mask::from_bits(zero.token(), changes);
            before = changes.select(bernstein[k - 1], before);
            after = changes.select(bernstein[k], after);
            position = changes.select(zero.constant((k - 1) as f64), position);
        }
        let crossing = (position + before / (before - after)) * zero.constant(1.0 / n as f64);
        Self { largest, least, some, many, rises, crossing }
    }

    /// A bit for each instance whose value exceeds rounding, relative to the largest one.
    #[inline(always)]
    fn is_clear(&self, value: Lanes<S>, largest: Lanes<S>) -> u64 {
        value.abs().above(largest * largest.constant(CLEAR_MIDDLE)).bits()
    }
}

/// The roots found so far.
struct Isolation<S: Simd, Z: Size> {
    simd: S,
    size: Z,
    pieces: [Polynomials<S, Z>; PIECES],
    /// Intervals that must be halved, with their Bernstein coefficients.
    open: [Z::List<Open<Z>>; MOST],
    brackets: [Z::List<Bracket>; MOST],
    result: [RealRoots<Z>; MOST],
}

/// The real roots of a polynomial of each instance: see [`Isolation::run`]. Nothing in its type
/// belongs to one solver, so that it is compiled once for all whose polynomials have this degree.
#[inline(never)]
pub(super) fn real_roots<S: Simd, Z: Size>(simd: S, size: Z, coefficients: &Polynomials<S, Z>) -> [RealRoots<Z>; MOST] {
    simd.vectorize(
        #[inline(always)]
        || Isolation::run(simd, size, coefficients),
    )
}

/// A function of its own is compiled once for all solvers.
#[inline(never)]
fn sort(brackets: &mut [Bracket]) {
    brackets.sort_unstable_by(|a, b| a.piece.cmp(&b.piece).then(a.low.total_cmp(&b.low)));
}

impl<S: Simd, Z: Size> Isolation<S, Z> {
    /// The roots of c\[0\] + c\[1\] x + .. + c\[n\] x^n of each instance, in the order in which
    /// [`real_roots`](crate::emitted::real_roots) returns them. Those of an instance without a
    /// first or a last coefficient, or with one far out of range, are not certain.
    #[inline(always)]
    fn run(simd: S, size: Z, coefficients: &Polynomials<S, Z>) -> [RealRoots<Z>; MOST] {
        let (power, shifts, is_in_range) = scaled(simd, size, coefficients);
        let certain = |at: usize| at < Lanes::<S>::COUNT && is_in_range >> at & 1 == 1;
        let mut this = Self {
            simd,
            size,
            pieces: core::array::from_fn(|piece| piece_of(size, piece, &power)),
            open: core::array::from_fn(|_| size.list()),
            brackets: core::array::from_fn(|_| size.list()),
            result: core::array::from_fn(|at| RealRoots {
                roots: size.list(),
                is_certain: certain(at),
                clearance: f64::INFINITY,
            }),
        };
        for piece in 0..PIECES {
            this.look_at_piece(piece);
        }
        this.halve_all();
        this.refine_all();
        for (result, shift) in this.result.iter_mut().zip(shifts) {
            for root in result.roots.iter_mut() {
                *root *= UNIT * float::power_of_two(shift);
                result.is_certain &= root.is_finite();
            }
        }
        this.result
    }

    /// Counts the changes of sign of a piece of each instance.
    #[inline(always)]
    fn look_at_piece(&mut self, piece: usize) {
        let n = self.size.get() - 1;
        let bernstein = bernstein(self.size, &self.pieces[piece]);
        let found = Control::of(self.size, &bernstein);
        // Pieces that meet at t = 1 must be sure of the sign there.
        let is_clear = found.is_clear(bernstein[n], found.largest);
        for instance in 0..Lanes::<S>::COUNT {
            self.result[instance].is_certain &= is_clear >> instance & 1 == 1;
            let largest = found.largest.get(instance);
            let interval = Interval { instance, piece, low: 0.0, high: 1.0, halvings: HALVINGS, largest };
            self.sort_in(interval, &found, &bernstein, instance);
        }
    }

    /// An interval without a change of sign has no root, one with one change has one root, others
    /// are halved.
    #[inline(always)]
    fn sort_in(&mut self, interval: Interval, found: &Control<S>, bernstein: &Polynomials<S, Z>, lane: usize) {
        let result = &mut self.result[interval.instance];
        if !result.is_certain {
            return;
        }
        if found.many >> lane & 1 == 1 {
            let mut of_lane = self.size.filled(0.0);
            for k in 0..self.size.get() {
                of_lane[k] = bernstein[k].get(lane);
            }
            let has_room = interval.halvings > 0 && self.open[interval.instance].push((interval, of_lane));
            result.is_certain &= has_room;
        } else if found.some >> lane & 1 == 1 {
            let Interval { piece, low, high, .. } = interval;
            let start = low + (high - low) * found.crossing.get(lane);
            let rises = found.rises >> lane & 1 == 1;
            let bracket = Bracket { piece, low, high, start, rises };
            result.is_certain &= self.brackets[interval.instance].push(bracket);
        } else {
            let clearance = found.least.get(lane) / interval.largest;
            result.clearance = if clearance < result.clearance { clearance } else { result.clearance };
        }
    }

    /// Halves intervals, and their halves, until each has one root or none.
    #[inline(always)]
    fn halve_all(&mut self) {
        let n = self.size.get() - 1;
        let zero = Lanes::splat(self.simd, 0.0);
        loop {
            let mut group = [Interval::default(); MOST];
            let mut right = self.size.filled(zero);
            let mut count = 0;
            for open in &mut self.open {
                while let Some((interval, of_lane)) = if count < Lanes::<S>::COUNT { open.pop() } else { None } {
                    for k in 0..n + 1 {
                        right[k].set(count, of_lane[k]);
                    }
                    group[count] = interval;
                    count += 1;
                }
            }
            if count == 0 {
                break;
            }
            // De Casteljau: see `real_roots`.
            let (mut left, half) = (right.clone(), zero.constant(0.5));
            for pass in 1..n + 1 {
                for j in 0..n + 1 - pass {
                    right[j] = half * (right[j] + right[j + 1]);
                }
                left[pass] = right[0];
            }
            let of_halves = [Control::of(self.size, &left), Control::of(self.size, &right)];
            // Two close roots in the middle, or a pair, show in neither half.
            let largest = of_halves[0].largest.max(of_halves[1].largest);
            let is_clear = of_halves[0].is_clear(right[0], largest);
            for (lane, &interval) in group[..count].iter().enumerate() {
                self.result[interval.instance].is_certain &= is_clear >> lane & 1 == 1;
                let halvings = interval.halvings - 1;
                let middle = 0.5 * (interval.low + interval.high);
                let lower = Interval { high: middle, halvings, ..interval };
                self.sort_in(lower, &of_halves[0], &left, lane);
                let upper = Interval { low: middle, halvings, ..interval };
                self.sort_in(upper, &of_halves[1], &right, lane);
            }
        }
    }

    /// Finds the root of each bracket, those of all instances side by side.
    #[inline(always)]
    fn refine_all(&mut self) {
        for brackets in &mut self.brackets {
            sort(brackets);
        }
        let (mut instance, mut at) = (0, 0);
        loop {
            let mut group = [(0, 0); MOST];
            let mut count = 0;
            while count < Lanes::<S>::COUNT && instance < MOST {
                if at < self.brackets[instance].len() {
                    group[count] = (instance, at);
                    (count, at) = (count + 1, at + 1);
                } else {
                    (instance, at) = (instance + 1, 0);
                }
            }
            if count == 0 {
                break;
            }
            let t = self.refine(&group, count);
            for (lane, &(instance, at)) in group[..count].iter().enumerate() {
                let (t, piece) = (t.get(lane), self.brackets[instance][at].piece);
                let modulus = if piece.is_multiple_of(2) { t } else { 1.0 / t };
                let root = if piece < 2 { modulus } else { -modulus };
                self.result[instance].is_certain &= self.result[instance].roots.push(root);
            }
        }
    }

    /// The roots of a group of brackets: Newton's method from the zero of the control polygon, with
    /// bisection where a step leaves the bracket.
    #[inline(always)]
    fn refine(&self, group: &[(usize, usize); MOST], count: usize) -> Lanes<S> {
        let n = self.size.get() - 1;
        let zero = Lanes::splat(self.simd, 0.0);
        let mut power = self.size.filled(zero);
        let (mut t, mut low, mut high, mut rise) = (zero, zero, zero, zero);
        for lane in 0..Lanes::<S>::COUNT {
            let (instance, at) = group[if lane < count { lane } else { 0 }];
            let bracket = self.brackets[instance][at];
            t.set(lane, bracket.start);
            low.set(lane, bracket.low);
            high.set(lane, bracket.high);
            rise.set(lane, if bracket.rises { 1.0 } else { -1.0 });
            for k in 0..n + 1 {
                power[k].set(lane, self.pieces[bracket.piece % PIECES][k].get(instance));
            }
        }
        let half = zero.constant(0.5);
        let mut done = 0;
        for _ in 0..MOST_STEPS {
            let (mut value, mut slope) = (power[n], zero);
            for k in (0..n).rev() {
                slope = value.plus(slope, t);
                value = power[k].plus(value, t);
            }
            let is_below = zero.above(value * rise);
            low = is_below.select(t, low);
            high = is_below.select(high, t);
            let newton = t - value / slope;
            // A NaN from a slope of zero leads to bisection.
            let is_newton = Mask::from_bits(self.simd, low.at_most(newton).bits() & newton.at_most(high).bits());
            let next = is_newton.select(newton, half * (low + high));
            let last = is_newton.select(next * zero.constant(LAST_STEP), zero);
            let is_root = value.abs().at_most(zero).bits();
            let is_last = (next - t).abs().at_most(last).bits();
            t = Mask::from_bits(self.simd, done | is_root).select(t, next);
            done |= is_root | is_last;
            if done == lanes_in_use::<S>() {
                break;
            }
        }
        t
    }
}

/// The coefficients with x = 2^shift UNIT y, which brings the geometric mean of the moduli of the
/// roots to about 1, and the shift; a bit for each instance whose numbers stay in range.
#[inline(always)]
fn scaled<S: Simd, Z: Size>(
    simd: S,
    size: Z,
    coefficients: &Polynomials<S, Z>,
) -> (Polynomials<S, Z>, [i32; MOST], u64) {
    let n = size.get() - 1;
    let (mut shifts, mut is_in_range) = ([0; MOST], 0);
    let (mut unit, mut step) = (Lanes::splat(simd, 0.0), Lanes::splat(simd, 0.0));
    for lane in 0..Lanes::<S>::COUNT {
        let (first, last) = (coefficients[0].get(lane), coefficients[n].get(lane));
        let exponent = float::exponent(first);
        let shift = (exponent - float::exponent(last)).div_euclid(n.max(1) as i32);
        let is_good = exponent.abs() < 900 && (n as i32 * shift - exponent).abs() < 900 && first != 0.0 && last != 0.0;
        is_in_range |= u64::from(is_good) << lane;
        shifts[lane] = shift;
        unit.set(lane, float::power_of_two(-exponent));
        step.set(lane, UNIT * float::power_of_two(shift));
    }
    let mut power = size.filled(unit);
    let mut largest = unit.constant(0.0);
    for k in 0..n + 1 {
        power[k] = coefficients[k] * unit;
        unit = unit * step;
        // A NaN stays.
        largest = largest.above(power[k].abs()).select(largest, power[k].abs() + largest.constant(0.0) * largest);
    }
    (power, shifts, is_in_range & unit.constant(1e100).above(largest).bits())
}

/// The polynomial on a piece of the axis.
#[inline(always)]
fn piece_of<S: Simd, Z: Size>(size: Z, piece: usize, power: &Polynomials<S, Z>) -> Polynomials<S, Z> {
    let n = size.get() - 1;
    let mut polynomial = power.clone();
    for k in 0..n + 1 {
        let of_x = if piece.is_multiple_of(2) { k } else { n - k };
        polynomial[k] = if piece >= 2 && of_x % 2 == 1 { -power[of_x] } else { power[of_x] };
    }
    polynomial
}

/// b_j = sum over i <= j of C(j, i) q_i / C(n, i), by Pascal's rule.
#[inline(always)]
fn bernstein<S: Simd, Z: Size>(size: Z, polynomial: &Polynomials<S, Z>) -> Polynomials<S, Z> {
    let n = size.get() - 1;
    let mut bernstein = polynomial.clone();
    let mut at_one = polynomial[0].constant(0.0);
    let mut binomial = 1.0;
    for k in 0..n + 1 {
        at_one += polynomial[k];
        bernstein[k] = polynomial[k] * at_one.constant(1.0 / binomial);
        binomial = binomial * (n - k) as f64 / (k + 1) as f64;
    }
    for first in 0..n {
        let mut below = bernstein[first];
        for k in first + 1..n + 1 {
            let own = bernstein[k];
            bernstein[k] += below;
            below = own;
        }
    }
    // Both sides of t = 1 have about the same value there, and nearly the same rounding errors.
    bernstein[n] = at_one;
    bernstein
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::batch::levels::on_all_levels;
    use crate::size::Fixed;
    use crate::spectrum::real_roots::real_roots;
    use rand_xoshiro::Xoshiro256PlusPlus;
    use rand_xoshiro::rand_core::{Rng, SeedableRng};

    type Polynomial = [f64; 11];

    /// The roots of polynomials side by side; the first one fills lanes that are left over.
    fn side_by_side<S: Simd>(simd: S, polynomials: &[Polynomial]) -> [RealRoots<Fixed<11>>; MOST] {
        let mut coefficients = [Lanes::splat(simd, 0.0); 11];
        for lane in 0..Lanes::<S>::COUNT {
            let polynomial = polynomials.get(lane).unwrap_or(&polynomials[0]);
            (0..11).for_each(|k| coefficients[k].set(lane, polynomial[k]));
        }
        Isolation::run(simd, Fixed::<11>, &coefficients)
    }

    /// The product of ten factors x - r with real roots, or of x^2 - 2 r x + r^2 + s^2.
    fn with_roots(random: &mut Xoshiro256PlusPlus, pairs: usize) -> Polynomial {
        let mut number = || ((random.next_u64() >> 11) as f64 * 2.0_f64.powi(-52) - 1.0) * 3.0;
        let mut product = [0.0; 11];
        product[0] = 1.0;
        for k in 0..10 - pairs {
            let (r, s) = (number(), number());
            let factor = if k < pairs { [r * r + s * s, -2.0 * r, 1.0] } else { [-r, 1.0, 0.0] };
            let known = product;
            for at in 0..11 {
                let before = |by: usize| if at >= by { known[at - by] } else { 0.0 };
                product[at] = factor[0] * known[at] + factor[1] * before(1) + factor[2] * before(2);
            }
        }
        product
    }

    #[test]
    fn roots_are_those_of_each_polynomial_alone() {
        on_all_levels!(|simd| {
            let mut random = Xoshiro256PlusPlus::seed_from_u64(1);
            let (mut compared, mut roots) = (0, 0);
            for round in 0..300 {
                let polynomials: [Polynomial; 8] = core::array::from_fn(|_| with_roots(&mut random, round % 6));
                let found = side_by_side(simd, &polynomials);
                for (polynomial, found) in polynomials.iter().zip(&found).take(Lanes::<_>::count_of(simd)) {
                    let alone = real_roots(Fixed::<11>, polynomial);
                    if !(alone.is_certain && found.is_certain) {
                        continue;
                    }
                    assert_eq!(found.roots.len(), alone.roots.len(), "{polynomial:?}");
                    for (x, y) in found.roots.iter().zip(&alone.roots) {
                        assert!((x - y).abs() <= 1e-6 * y.abs(), "{x} {y} of {polynomial:?}");
                    }
                    compared += 1;
                    roots += alone.roots.len();
                }
            }
            assert!(compared > 400 && roots > 1_000, "{compared} polynomials with {roots} roots");
        });
    }

    #[test]
    fn what_needs_care_is_not_certain() {
        on_all_levels!(|simd| {
            let good = with_roots(&mut Xoshiro256PlusPlus::seed_from_u64(2), 3);
            let with = |at: usize, value: f64| {
                let mut bad = good;
                bad[at] = value;
                bad
            };
            let cases =
                [(0, 0.0), (10, 0.0), (5, f64::NAN), (0, f64::INFINITY), (10, f64::NAN), (3, 1e300), (0, 1e300)];
            for (at, value) in cases {
                let found = side_by_side(simd, &[good, with(at, value)]);
                assert!(found[0].is_certain && !found[1].is_certain, "{value} at {at}");
            }
            // (x - 1)^2 (x^8 + 1)
            let double = [1.0, -2.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, -2.0, 1.0];
            assert!(!side_by_side(simd, &[double])[0].is_certain, "a double root");
        });
    }
}
