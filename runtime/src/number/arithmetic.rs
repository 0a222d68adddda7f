//! What emitted code asks of its numbers: one function serves a single instance and several side by
//! side.

use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use crate::elimination::lu::{BlockError, solve_block_trailing};
use crate::number::{Real, Scalar};
use crate::size::Vector;

/// Numbers with the four operations: a [`Scalar`], or a number for each of several instances.
pub trait Arithmetic:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
{
    /// The number x of the same kind as this one. (How many instances there are side by side is
    /// known at run time, so no function makes a number from nothing.)
    #[must_use]
    fn constant(self, x: f64) -> Self;

    /// Adds the product of two polynomials, lowest coefficient first. N is A + B - 1.
    fn add_product<const A: usize, const B: usize, const N: usize>(sum: &mut [Self; N], a: &[Self; A], b: &[Self; B]);

    /// Like [`Arithmetic::add_product`], with the other sign.
    fn subtract_product<const A: usize, const B: usize, const N: usize>(
        sum: &mut [Self; N],
        a: &[Self; A],
        b: &[Self; B],
    );
}

impl<S: Scalar> Arithmetic for S {
    #[inline(always)]
    fn constant(self, x: f64) -> Self {
        S::from_f64(x)
    }

    /// It is a call, because a determinant has many products, and few lengths.
    #[inline(never)]
    fn add_product<const A: usize, const B: usize, const N: usize>(sum: &mut [S; N], a: &[S; A], b: &[S; B]) {
        for (shift, &factor) in a.iter().enumerate() {
            for (sum, &value) in sum[shift..].iter_mut().zip(b) {
                *sum += factor * value;
            }
        }
    }

    #[inline(never)]
    fn subtract_product<const A: usize, const B: usize, const N: usize>(sum: &mut [S; N], a: &[S; A], b: &[S; B]) {
        for (shift, &factor) in a.iter().enumerate() {
            for (sum, &value) in sum[shift..].iter_mut().zip(b) {
                *sum -= factor * value;
            }
        }
    }
}

/// Numbers with which a block of a template is eliminated.
pub trait Eliminated: Arithmetic {
    /// Solves a diagonal block: see [`solve_block_trailing`].
    ///
    /// # Errors
    /// As [`solve_block_trailing`].
    fn solve_block<V: Vector<Self>, const N: usize>(
        matrix: &mut [[Self; N]; N],
        right: &mut [V],
        needed: usize,
    ) -> Result<(), BlockError>;
}

impl<R: Real> Eliminated for R {
    #[inline(always)]
    fn solve_block<V: Vector<Self>, const N: usize>(
        matrix: &mut [[R; N]; N],
        right: &mut [V],
        needed: usize,
    ) -> Result<(), BlockError> {
        solve_block_trailing(matrix, right, needed)
    }
}
