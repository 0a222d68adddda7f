//! All real roots of a polynomial, with their number certain.
//!
//! The positive and the negative real axis are cut at the modulus 1 of a scaled variable, and what
//! lies beyond is turned inside out by x = 1/t. On each of the four unit intervals the polynomial
//! is written in the Bernstein basis,
//!
//! q(t) = sum over j of b_j C(n, j) t^j (1 - t)^(n-j),
//!
//! whose coefficients change their sign as often as q has roots in (0, 1), or an even number of
//! times more often (Descartes' rule). Intervals with two and more changes are halved by de
//! Casteljau's algorithm until each has one change, which is one root, or none (Lane and Riesenfeld
//! 1981). An interval that still has two changes when it is short holds two roots that are close to
//! each other, or a pair close to the real axis: nobody can tell from rounded coefficients, and the
//! result says so. Degrees 2 to 4 have closed forms, which are tried first.

use crate::number::float;
use crate::size::{List, Size};
use crate::spectrum::closed_form::few_roots;

/// An interval is halved at most this often. Roots of one interval are then at most 2^-12 = 2e-4
/// apart, relative to the scaled variable, and coefficients that are wrong by 2e-4 squared may make
/// them a complex pair.
pub(crate) const HALVINGS: u32 = 12;

/// A factor of the scaled variable: the square root of 3/4. Without it, numbers such as 1 and 3/8
/// would lie where intervals meet, and they are the roots of many polynomials that people write.
pub(crate) const UNIT: f64 = 0.866_025_403_784_438_6;

/// The value where an interval is halved must exceed this, relative to the largest Bernstein
/// coefficient: it is about the square of the distance 2^-12.
pub(crate) const CLEAR_MIDDLE: f64 = 1e-7;

/// The largest number of steps to a root. They are Newton's, or halve the bracket.
pub(crate) const MOST_STEPS: usize = 100;

/// A Newton step of this size, relative to the root, is the last one: the next one would be its
/// square.
pub(crate) const LAST_STEP: f64 = 1e-9;

/// Pieces of the axis, and roots, that are computed side by side.
pub(crate) const LANES: usize = 4;

/// A number for each piece or root.
pub(crate) type Lanes = [f64; LANES];

/// The real roots of a polynomial.
pub struct RealRoots<Z: Size> {
    /// The roots, in no order. A root at infinity is left out.
    pub roots: Z::List<f64>,
    /// Whether these are all of them and all are simple. Otherwise roots may be missing: some are
    /// close to each other or to their conjugates, or a number is not finite.
    pub is_certain: bool,
    /// The least |b_j| of the intervals without a root, relative to the largest coefficient of the
    /// unit interval: relative errors below this make none.
    pub clearance: f64,
}

/// The real roots of c\[0\] + c\[1\] x + .. + c\[n\] x^n. The vector has n + 1 entries; the degree
/// is lowered if the last ones are zero.
#[must_use]
pub fn real_roots<Z: Size>(size: Z, coefficients: &Z::Vector<f64>) -> RealRoots<Z> {
    let mut result = RealRoots { roots: size.list(), is_certain: false, clearance: f64::INFINITY };
    let c = coefficients.as_ref();
    let Some(degree) = c.iter().rposition(|&c| c != 0.0) else { return result };
    if !c.iter().all(|c| c.is_finite()) {
        return result;
    }
    let lowest = c.iter().position(|&c| c != 0.0).unwrap_or(0);
    result.is_certain = lowest <= 1;
    if lowest > 0 {
        result.roots.push(0.0);
    }
    let degree = degree - lowest;
    match degree + 1 == size.get() {
        true => Isolation::<Z, true> { size, degree, result }.run(c),
        false => Isolation::<Z, false> { size, degree, result }.run(&c[lowest..]),
    }
}

/// The roots found so far. `FULL`: the degree is one less than the size, which the compiler knows.
pub(crate) struct Isolation<Z: Size, const FULL: bool> {
    size: Z,
    degree: usize,
    result: RealRoots<Z>,
}

/// The polynomial on the four unit intervals, lowest coefficient first: x = t, 1/t, -t, -1/t.
pub(crate) type Pieces<Z> = <Z as Size>::Vector<Lanes>;

/// An interval with one root.
#[derive(Clone, Copy)]
pub(crate) struct Bracket {
    /// The piece of the axis.
    pub(crate) piece: usize,
    pub(crate) low: f64,
    pub(crate) high: f64,
    /// The zero of the control polygon.
    pub(crate) start: f64,
    /// Whether q is negative at the lower end.
    pub(crate) rises: bool,
}

impl<Z: Size, const FULL: bool> Isolation<Z, FULL> {
    /// A polynomial of the largest degree, no root found.
    pub(crate) fn new(size: Z) -> Self {
        let result = RealRoots { roots: size.list(), is_certain: false, clearance: f64::INFINITY };
        Self { size, degree: size.get() - 1, result }
    }

    #[inline(always)]
    fn degree(&self) -> usize {
        if FULL { self.size.get() - 1 } else { self.degree }
    }

    /// All roots but 0 of the polynomial with these coefficients; the first one is not zero.
    #[inline]
    fn run(mut self, coefficients: &[f64]) -> RealRoots<Z> {
        let (power, shift) = self.scaled(coefficients);
        match self.degree() {
            0 => {}
            1 => {
                self.result.roots.push(-power[0] / power[1]);
            }
            2..=4 => match few_roots(&power.as_ref()[..self.degree() + 1]) {
                Some(mut found) => {
                    self.result.clearance = if found.count == 0 { found.clearance } else { f64::INFINITY };
                    for &root in found.in_order() {
                        self.result.is_certain &= self.result.roots.push(root);
                    }
                }
                None => self.isolate(&self.pieces(&power)),
            },
            _ => self.isolate(&self.pieces(&power)),
        }
        let mut result = self.result;
        for root in result.roots.iter_mut() {
            *root = times_power_of_two(*root * UNIT, shift);
            result.is_certain &= root.is_finite();
        }
        result
    }

    /// The coefficients with x = 2^shift UNIT y, which brings the geometric mean of the moduli of
    /// the roots to about 1, and the shift.
    #[inline]
    pub(crate) fn scaled(&self, coefficients: &[f64]) -> (Z::Vector<f64>, i32) {
        let n = self.degree();
        let mut power = self.size.filled(0.0);
        let exponent = |k: usize| float::exponent(coefficients[k]);
        let shift = (exponent(0) - exponent(n)).div_euclid(n.max(1) as i32);
        // 2^(k shift - first) UNIT^k, unless it is out of range.
        let (first, step) = (exponent(0), UNIT * float::power_of_two(shift));
        let mut unit = float::power_of_two(-first);
        let mut largest = 0.0;
        for (scaled, &c) in power.as_mut()[..n + 1].iter_mut().zip(coefficients) {
            *scaled = c * unit;
            unit *= step;
            largest = if scaled.abs() > largest { scaled.abs() } else { largest };
        }
        let is_in_range = first.abs() < 900 && (n as i32 * shift - first).abs() < 900 && largest < 1e100;
        if !is_in_range {
            self.scale_any(coefficients, shift, &mut power);
        }
        (power, shift)
    }

    /// As [`Self::scaled`], for coefficients of any size.
    #[cold]
    #[inline(never)]
    fn scale_any(&self, coefficients: &[f64], shift: i32, power: &mut Z::Vector<f64>) {
        let n = self.degree();
        let exponent = |k: usize| float::exponent(coefficients[k]) + k as i32 * shift;
        let largest = (0..=n).filter(|&k| coefficients[k] != 0.0).map(exponent).max().unwrap_or(0);
        let mut unit = 1.0;
        for k in 0..=n {
            power[k] = unit * times_power_of_two(coefficients[k], k as i32 * shift - largest);
            unit *= UNIT;
        }
    }

    #[inline(always)]
    pub(crate) fn pieces(&self, power: &Z::Vector<f64>) -> Pieces<Z> {
        let n = self.degree();
        let mut pieces = self.size.filled([0.0; LANES]);
        for k in 0..n + 1 {
            let (inner, outer) = (power[k], power[n - k]);
            let is_odd = |power: usize| !power.is_multiple_of(2);
            pieces[k] =
                [inner, outer, if is_odd(k) { -inner } else { inner }, if is_odd(n - k) { -outer } else { outer }];
        }
        pieces
    }

    /// Finds the intervals with one root, and then the roots.
    #[inline(always)]
    fn isolate(&mut self, pieces: &Pieces<Z>) {
        let n = self.degree();
        let mut brackets = self.size.list();
        let bernstein = self.bernstein(pieces);
        let (mut largest, mut least) = ([0.0; LANES], [f64::INFINITY; LANES]);
        for k in 0..n + 1 {
            for lane in 0..LANES {
                let size = bernstein[k][lane].abs();
                largest[lane] = if size > largest[lane] { size } else { largest[lane] };
                least[lane] = if size < least[lane] { size } else { least[lane] };
            }
        }
        for lane in 0..LANES {
            // Pieces that meet at t = 1 must be sure of the sign there.
            self.result.is_certain &= bernstein[n][lane].abs() > CLEAR_MIDDLE * largest[lane];
            let mut of_lane = self.size.filled(0.0);
            for k in 0..n + 1 {
                of_lane[k] = bernstein[k][lane];
            }
            match sign_changes(&of_lane.as_ref()[..n + 1]) {
                0 => self.result.clearance = self.result.clearance.min(least[lane] / largest[lane]),
                1 => self.add_bracket(&mut brackets, lane, &of_lane, (0.0, 1.0)),
                _ => self.halve(&mut brackets, (lane, largest[lane]), &mut of_lane, (0.0, 1.0), HALVINGS),
            }
        }
        for group in brackets.chunks(LANES) {
            self.refine(pieces, group);
        }
    }

    /// b_j = sum over i <= j of C(j, i) q_i / C(n, i), by Pascal's rule.
    #[inline(always)]
    pub(crate) fn bernstein(&self, pieces: &Pieces<Z>) -> Pieces<Z> {
        let n = self.degree();
        let mut bernstein = pieces.clone();
        let mut at_one = [0.0; LANES];
        let mut binomial = 1.0;
        for k in 0..n + 1 {
            for lane in 0..LANES {
                at_one[lane] += bernstein[k][lane];
                bernstein[k][lane] /= binomial;
            }
            binomial = binomial * (n - k) as f64 / (k + 1) as f64;
        }
        for first in 0..n {
            let mut below = bernstein[first];
            for entry in &mut bernstein.as_mut()[first + 1..n + 1] {
                let own = *entry;
                for lane in 0..LANES {
                    entry[lane] += below[lane];
                }
                below = own;
            }
        }
        // Both sides of t = 1 have the same value there, and must agree about its sign.
        bernstein[n] = [at_one[0], at_one[0], at_one[2], at_one[2]];
        bernstein
    }

    /// Halves an interval with these Bernstein coefficients, and its halves, until each has one
    /// root or none. The largest Bernstein coefficient of a piece comes with it.
    #[inline(never)]
    fn halve(
        &mut self,
        brackets: &mut Z::List<Bracket>,
        piece: (usize, f64),
        right: &mut Z::Vector<f64>,
        ends: (f64, f64),
        halvings: u32,
    ) {
        let n = self.degree();
        if halvings == 0 {
            self.result.is_certain = false;
            return;
        }
        let mut left = left_half::<Z>(n, right);
        // Two close roots in the middle, or a pair, show in neither half.
        let size = largest(&left.as_ref()[..n + 1]).max(largest(&right.as_ref()[..n + 1]));
        self.result.is_certain &= right[0].abs() > CLEAR_MIDDLE * size;
        let middle = 0.5 * (ends.0 + ends.1);
        for (half, ends) in [(&mut left, (ends.0, middle)), (right, (middle, ends.1))] {
            match sign_changes(&half.as_ref()[..n + 1]) {
                0 => {
                    let clearance = least(&half.as_ref()[..n + 1]) / piece.1;
                    self.result.clearance = self.result.clearance.min(clearance);
                }
                1 => self.add_bracket(brackets, piece.0, half, ends),
                _ => self.halve(brackets, piece, half, ends, halvings - 1),
            }
        }
    }

    /// Adds an interval whose Bernstein coefficients change their sign once.
    #[inline]
    fn add_bracket(
        &mut self,
        brackets: &mut Z::List<Bracket>,
        piece: usize,
        bernstein: &Z::Vector<f64>,
        (low, high): (f64, f64),
    ) {
        let n = self.degree();
        let rises = bernstein[0] < 0.0;
        let crossing = (0..n).find(|&j| (bernstein[j + 1] < 0.0) != rises).unwrap_or(0);
        let (before, after) = (bernstein[crossing], bernstein[crossing + 1]);
        let part = (crossing as f64 + before / (before - after)) / n as f64;
        let bracket = Bracket { piece, low, high, start: low + (high - low) * part, rises };
        self.result.is_certain &= brackets.push(bracket);
    }

    /// The one root of each of up to four intervals: Newton's method from the zero of the control
    /// polygon, with bisection where a step leaves the bracket.
    #[inline(always)]
    fn refine(&mut self, pieces: &Pieces<Z>, group: &[Bracket]) {
        let n = self.degree();
        let bracket = |lane: usize| group[lane.min(group.len() - 1)];
        let mut power = self.size.filled([0.0; LANES]);
        for lane in 0..LANES {
            let piece = bracket(lane).piece;
            for k in 0..n + 1 {
                power[k][lane] = pieces[k][piece % LANES];
            }
        }
        let mut t = core::array::from_fn(|lane| bracket(lane).start);
        let mut low: Lanes = core::array::from_fn(|lane| bracket(lane).low);
        let mut high: Lanes = core::array::from_fn(|lane| bracket(lane).high);
        let mut is_done = [false; LANES];
        for _ in 0..MOST_STEPS {
            let (value, slope) = self.value_and_slope(&power, &t);
            for lane in 0..LANES {
                if is_done[lane] || value[lane] == 0.0 {
                    is_done[lane] = true;
                    continue;
                }
                let end = if (value[lane] < 0.0) == bracket(lane).rises { &mut low } else { &mut high };
                end[lane] = t[lane];
                let newton = t[lane] - value[lane] / slope[lane];
                // A NaN from a slope of zero leads to bisection.
                let is_newton = newton >= low[lane] && newton <= high[lane];
                let next = if is_newton { newton } else { 0.5 * (low[lane] + high[lane]) };
                let step = (next - t[lane]).abs();
                t[lane] = next;
                is_done[lane] = step <= if is_newton { LAST_STEP * next } else { 0.0 };
            }
            if is_done == [true; LANES] {
                break;
            }
        }
        for (bracket, t) in group.iter().zip(t) {
            let modulus = if bracket.piece % 2 == 0 { t } else { 1.0 / t };
            let root = if bracket.piece < 2 { modulus } else { -modulus };
            self.result.is_certain &= self.result.roots.push(root);
        }
    }

    /// q and its derivative, by Horner's rule.
    #[inline(always)]
    pub(crate) fn value_and_slope(&self, power: &Pieces<Z>, t: &Lanes) -> (Lanes, Lanes) {
        let n = self.degree();
        let (mut value, mut slope) = (power[n], [0.0; LANES]);
        for k in (0..n).rev() {
            for lane in 0..LANES {
                slope[lane] = slope[lane] * t[lane] + value[lane];
                value[lane] = value[lane] * t[lane] + power[k][lane];
            }
        }
        (value, slope)
    }
}

/// Bernstein coefficients of the left half of an interval; those of the interval become those of
/// the right half. De Casteljau: after pass k, the first entry is the k-th coefficient of the left
/// half, and the last one that changed is final in the right half.
#[inline(always)]
pub(crate) fn left_half<Z: Size>(degree: usize, right: &mut Z::Vector<f64>) -> Z::Vector<f64> {
    let mut left = right.clone();
    for pass in 1..degree + 1 {
        let open = &mut right.as_mut()[..degree + 2 - pass];
        for j in 0..open.len() - 1 {
            open[j] = 0.5 * (open[j] + open[j + 1]);
        }
        left[pass] = open[0];
    }
    left
}

/// How often the sign changes along a list. A zero has a sign, too: one between numbers of the
/// other sign makes two changes, and the interval is halved.
#[inline]
fn sign_changes(values: &[f64]) -> u64 {
    values.windows(2).map(|pair| (pair[0].to_bits() ^ pair[1].to_bits()) >> 63).sum()
}

/// min |b_j|
#[inline]
fn least(values: &[f64]) -> f64 {
    values.iter().fold(f64::INFINITY, |least, b| least.min(b.abs()))
}

/// max |b_j|
#[inline]
fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest, b| largest.max(b.abs()))
}

/// x * 2^exponent, even if 2^exponent itself is out of range.
#[inline]
pub(crate) fn times_power_of_two(x: f64, exponent: i32) -> f64 {
    let half = exponent / 2;
    x * float::power_of_two(half) * float::power_of_two(exponent - half)
}
