//! A number for each of several instances, in one register of the processor.

use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use fearless_simd::prelude::*;

use crate::number::{Arithmetic, Over};

/// The largest number of instances side by side.
pub(super) const MOST: usize = 8;

/// A number for each instance: 8 with AVX-512, 4 with AVX2, 2 with NEON. `S` stands for the
/// instruction set, which is known when the program runs.
///
/// All arithmetic on lanes is `inline(always)`: it must become part of a function that is compiled
/// for the instruction set.
pub(super) struct Lanes<S: Simd>(pub(super) S::f64s);

impl<S: Simd> Clone for Lanes<S> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: Simd> Copy for Lanes<S> {}

/// A truth for each instance.
pub(super) struct Mask<S: Simd>(<S::f64s as SimdBase<S>>::Mask);

impl<S: Simd> Clone for Mask<S> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: Simd> Copy for Mask<S> {}

impl<S: Simd> Lanes<S> {
    /// The number of instances.
    pub(super) const COUNT: usize = <S::f64s as SimdBase<S>>::LEN;

    /// The number of instances of an instruction set.
    #[cfg(test)]
    pub(super) const fn count_of(_: S) -> usize {
        Self::COUNT
    }

    /// x for each instance.
    #[inline(always)]
    pub(super) fn splat(simd: S, x: f64) -> Self {
        Self(S::f64s::simd_from(simd, x))
    }

    /// The instruction set.
    #[inline(always)]
    pub(super) fn token(&self) -> S {
        self.0.token()
    }

    /// The number of an instance.
    #[inline(always)]
    pub(super) fn get(&self, lane: usize) -> f64 {
        self.0.as_slice()[lane]
    }

    #[inline(always)]
    pub(super) fn set(&mut self, lane: usize, x: f64) {
        self.0.as_mut_slice()[lane] = x;
    }

    /// self + a b, rounded once where the processor can.
    #[inline(always)]
    pub(super) fn plus(self, a: Self, b: Self) -> Self {
        Self(a.0.mul_add(b.0, self.0))
    }

    /// self - a b, rounded once where the processor can.
    #[inline(always)]
    pub(super) fn minus(self, a: Self, b: Self) -> Self {
        Self((-a.0).mul_add(b.0, self.0))
    }

    #[inline(always)]
    pub(super) fn abs(self) -> Self {
        Self(self.0.abs())
    }

    #[inline(always)]
    pub(super) fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    /// The larger number of each lane; the second one if the first one is NaN.
    #[inline(always)]
    pub(super) fn max(self, other: Self) -> Self {
        self.above(other).select(self, other)
    }

    /// self > other; false for NaN.
    #[inline(always)]
    pub(super) fn above(self, other: Self) -> Mask<S> {
        Mask(self.0.simd_gt(other.0))
    }

    /// self <= other; false for NaN.
    #[inline(always)]
    pub(super) fn at_most(self, other: Self) -> Mask<S> {
        Mask(other.0.simd_ge(self.0))
    }

    /// The least number of all instances; NaN counts as less.
    #[inline(always)]
    pub(super) fn least(self) -> f64 {
        let mut least = f64::INFINITY;
        for &x in self.0.as_slice() {
            least = if x >= least { least } else { x };
        }
        least
    }
}

impl<S: Simd> Mask<S> {
    /// `yes` where this is true, `no` elsewhere.
    #[inline(always)]
    pub(super) fn select(self, yes: Lanes<S>, no: Lanes<S>) -> Lanes<S> {
        Lanes(self.0.select(yes.0, no.0))
    }

    /// From a bit for each instance.
    #[inline(always)]
    pub(super) fn from_bits(simd: S, bits: u64) -> Self {
        Self(SimdMask::from_bitmask(simd, bits))
    }

    /// A bit for each instance.
    #[inline(always)]
    pub(super) fn bits(self) -> u64 {
        self.0.to_bitmask()
    }
}

impl<S: Simd> Add for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl<S: Simd> Sub for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl<S: Simd> Mul for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl<S: Simd> Div for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Self(self.0 / other.0)
    }
}

impl<S: Simd> Neg for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<S: Simd> AddAssign for Lanes<S> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<S: Simd> SubAssign for Lanes<S> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl<S: Simd> Arithmetic for Lanes<S> {
    #[inline(always)]
    fn constant(self, x: f64) -> Self {
        Self::splat(self.token(), x)
    }

    #[inline(always)]
    fn apart(self, compute: impl FnOnce()) {
        self.token().vectorize(compute);
    }

    #[inline(always)]
    fn add_product<const A: usize, const B: usize, const N: usize>(sum: &mut [Self; N], a: &[Self; A], b: &[Self; B]) {
        for i in 0..A {
            for j in 0..B {
                sum[i + j] = sum[i + j].plus(a[i], b[j]);
            }
        }
    }

    #[inline(always)]
    fn subtract_product<const A: usize, const B: usize, const N: usize>(
        sum: &mut [Self; N],
        a: &[Self; A],
        b: &[Self; B],
    ) {
        for i in 0..A {
            for j in 0..B {
                sum[i + j] = sum[i + j].minus(a[i], b[j]);
            }
        }
    }
}

impl<S: Simd> Over<Self> for Lanes<S> {
    #[inline(always)]
    fn from_real(x: Self) -> Self {
        x
    }

    #[inline(always)]
    fn times(self, factor: Self) -> Self {
        self * factor
    }
}

/// A bit for each instance.
#[inline(always)]
pub(super) fn lanes_in_use<S: Simd>() -> u64 {
    (1 << Lanes::<S>::COUNT) - 1
}
