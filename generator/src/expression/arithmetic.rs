//! The arithmetic that straight-line code and plans are interpreted in: Z_p exactly, or `f64`.

use super::derivation::DerivationKind;
use super::rational::Rational;
use crate::algebra::PrimeField;

/// A field to compute in. Values are passed beside the arithmetic, which knows the modulus.
pub trait Arithmetic: Copy {
    /// An element.
    type Value: Copy + PartialEq + std::fmt::Debug;

    /// The image of a constant; `None` if its denominator is 0 in this field.
    fn constant(self, value: Rational) -> Option<Self::Value>;
    /// a + b.
    fn add(self, a: Self::Value, b: Self::Value) -> Self::Value;
    /// a - b.
    fn sub(self, a: Self::Value, b: Self::Value) -> Self::Value;
    /// a b.
    fn mul(self, a: Self::Value, b: Self::Value) -> Self::Value;
    /// a / b; `None` for b = 0.
    fn div(self, a: Self::Value, b: Self::Value) -> Option<Self::Value>;
    /// A square root; `None` where there is none.
    fn root(self, a: Self::Value) -> Option<Self::Value> {
        self.derive(DerivationKind::SquareRoot, &[a], 0.0)?.pop()
    }
    /// The size of a value as a pivot, larger being better: |a| over the reals, 0 or 1 over Z_p.
    fn pivot_size(self, a: Self::Value) -> f64;
    /// The relative rounding error of one operation; 0 for exact arithmetic.
    fn rounding(self) -> f64;

    /// The results of a derivation; `None` where a matrix has lost rank, and in arithmetics that do
    /// not derive data: they take them among the inputs. In arithmetics that round, a matrix of a
    /// linear system has lost rank if an equilibrated pivot is not more than `least`.
    fn derive(self, kind: DerivationKind, operands: &[Self::Value], least: f64) -> Option<Vec<Self::Value>> {
        let _ = (kind, operands, least);
        None
    }

    /// What stands for a result that does not exist; `None` where it is drawn anew instead.
    fn no_number(self) -> Option<Self::Value> {
        None
    }

    /// 0.
    fn zero(self) -> Self::Value;
    /// 1.
    fn one(self) -> Self::Value;
    /// -a.
    fn neg(self, a: Self::Value) -> Self::Value {
        self.sub(self.zero(), a)
    }
}

impl Arithmetic for PrimeField {
    type Value = u32;

    fn constant(self, value: Rational) -> Option<u32> {
        let denominator = self.inverse(self.from_integer(value.denominator()))?;
        Some(PrimeField::mul(self, self.from_integer(value.numerator()), denominator))
    }
    fn add(self, a: u32, b: u32) -> u32 {
        PrimeField::add(self, a, b)
    }
    fn sub(self, a: u32, b: u32) -> u32 {
        PrimeField::sub(self, a, b)
    }
    fn mul(self, a: u32, b: u32) -> u32 {
        PrimeField::mul(self, a, b)
    }
    fn div(self, a: u32, b: u32) -> Option<u32> {
        Some(PrimeField::mul(self, a, self.inverse(b)?))
    }
    fn pivot_size(self, a: u32) -> f64 {
        f64::from(u8::from(a != 0))
    }
    fn rounding(self) -> f64 {
        0.0
    }
    fn derive(self, kind: DerivationKind, operands: &[u32], _: f64) -> Option<Vec<u32>> {
        kind.over_prime_field(self, operands)
    }
    fn zero(self) -> u32 {
        0
    }
    fn one(self) -> u32 {
        1
    }
}

/// IEEE double precision, the arithmetic of the emitted code.
#[derive(Clone, Copy, Debug)]
pub struct Float64;

impl Arithmetic for Float64 {
    type Value = f64;

    fn constant(self, value: Rational) -> Option<f64> {
        Some(value.to_f64())
    }
    fn add(self, a: f64, b: f64) -> f64 {
        a + b
    }
    fn sub(self, a: f64, b: f64) -> f64 {
        a - b
    }
    fn mul(self, a: f64, b: f64) -> f64 {
        a * b
    }
    fn div(self, a: f64, b: f64) -> Option<f64> {
        (b != 0.0).then(|| a / b)
    }
    fn pivot_size(self, a: f64) -> f64 {
        a.abs()
    }
    fn rounding(self) -> f64 {
        f64::EPSILON
    }
    /// The results of the kernels that ship, bit by bit.
    #[cfg(feature = "search")]
    fn derive(self, kind: DerivationKind, operands: &[f64], least: f64) -> Option<Vec<f64>> {
        kind.over_reals(operands.to_vec(), least).ok()
    }
    fn no_number(self) -> Option<f64> {
        Some(f64::NAN)
    }
    fn zero(self) -> f64 {
        0.0
    }
    fn one(self) -> f64 {
        1.0
    }
    fn neg(self, a: f64) -> f64 {
        -a
    }
}
