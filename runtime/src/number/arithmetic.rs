//! What emitted code asks of its numbers: one function serves a single instance and several side by
//! side.

use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// Numbers with the four operations: a [`Scalar`](crate::Scalar), or a number for each of several
/// instances.
pub trait Arithmetic:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + Send
    + 'static
{
    /// The number x of the same kind as this one. (How many instances there are side by side is
    /// known at run time, so no function makes a number from nothing.)
    #[must_use]
    fn constant(self, x: f64) -> Self;

    /// Computes in a function of its own, for the same instruction set: compilers take more than
    /// twice as long for twice as long a function.
    fn apart(self, compute: impl FnOnce());

    /// Adds the product of two polynomials, lowest coefficient first. N is A + B - 1.
    fn add_product<const A: usize, const B: usize, const N: usize>(sum: &mut [Self; N], a: &[Self; A], b: &[Self; B]);

    /// Like [`Arithmetic::add_product`], with the other sign.
    fn subtract_product<const A: usize, const B: usize, const N: usize>(
        sum: &mut [Self; N],
        a: &[Self; A],
        b: &[Self; B],
    );
}
