//! Monomials with integer exponents.

use std::collections::{HashMap, HashSet};
use std::fmt;
use std::hash::{BuildHasherDefault, Hash, Hasher};

/// The largest number of unknowns of a problem.
pub const MAX_UNKNOWNS: usize = 16;

/// x_0^e_0 ... x_15^e_15. Exponents may be negative (Laurent monomials); the algebra of ideals uses
/// non-negative ones.
///
/// `Ord` is the graded reverse lexicographic order with x_0 > x_1 > ...: it is the canonical order
/// of terms everywhere.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Monomial {
    exponents: [i8; MAX_UNKNOWNS],
}

/// The sign bit of each byte.
const SIGNS: u128 = 0x8080_8080_8080_8080_8080_8080_8080_8080;

/// A set of monomials that is looked up often.
pub type MonomialSet = HashSet<Monomial, BuildHasherDefault<MonomialHasher>>;
/// Values of monomials that are looked up often.
pub type MonomialMap<V> = HashMap<Monomial, V, BuildHasherDefault<MonomialHasher>>;

impl Hash for Monomial {
    #[inline]
    fn hash<H: Hasher>(&self, state: &mut H) {
        state.write_u128(self.packed());
    }
}

/// Mixes all exponents by one multiplication: sets of shifts grow mostly by looking up monomials.
#[derive(Clone, Copy, Debug, Default)]
pub struct MonomialHasher(u64);

impl Hasher for MonomialHasher {
    #[inline]
    fn write_u128(&mut self, exponents: u128) {
        // Odd numbers from the digits of pi. Exponents are small and half of them may be 0: without
        // the constants the product would be 0.
        const MIX: [u64; 2] = [0x243f_6a88_85a3_08d3, 0x1319_8a2e_0370_7345];
        let (low, high) = (exponents as u64 ^ self.0 ^ MIX[0], (exponents >> 64) as u64 ^ MIX[1]);
        let product = u128::from(low) * u128::from(high);
        self.0 = product as u64 ^ (product >> 64) as u64;
    }

    #[inline]
    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|&byte| self.write_u128(u128::from(byte)));
    }

    #[inline]
    fn finish(&self) -> u64 {
        self.0
    }
}

impl Monomial {
    /// The monomial 1.
    pub const ONE: Self = Self { exponents: [0; MAX_UNKNOWNS] };

    /// The unknown with index `unknown`.
    pub fn unknown(unknown: usize) -> Self {
        let mut exponents = [0; MAX_UNKNOWNS];
        exponents[unknown] = 1;
        Self { exponents }
    }

    /// The monomial with the given exponents, the rest zero.
    pub fn from_exponents(exponents: &[i8]) -> Self {
        let mut all = [0; MAX_UNKNOWNS];
        all[..exponents.len()].copy_from_slice(exponents);
        Self { exponents: all }
    }

    /// All exponents, [`MAX_UNKNOWNS`] of them.
    #[inline]
    pub fn exponents(&self) -> &[i8; MAX_UNKNOWNS] {
        &self.exponents
    }

    /// The exponent of one unknown.
    #[inline]
    pub fn exponent(&self, unknown: usize) -> i8 {
        self.exponents[unknown]
    }

    /// Sum of the exponents.
    #[inline]
    pub fn degree(&self) -> i32 {
        // Here and below: an unoptimised build script calls this more often than anything else, and
        // calls a function for each step of an iterator.
        let (mut degree, mut i) = (0, 0);
        while i < MAX_UNKNOWNS {
            degree += self.exponents[i] as i32;
            i += 1;
        }
        degree
    }

    /// Sum of weight times exponent.
    pub fn weighted_degree(&self, weights: &[i32]) -> i32 {
        self.exponents.iter().zip(weights).map(|(&e, &w)| i32::from(e) * w).sum()
    }

    /// The product, or `None` if an exponent leaves the range of `i8`.
    pub fn checked_mul(&self, other: &Self) -> Option<Self> {
        let (mut exponents, mut i) = ([0; MAX_UNKNOWNS], 0);
        while i < MAX_UNKNOWNS {
            exponents[i] = self.exponents[i].checked_add(other.exponents[i])?;
            i += 1;
        }
        Some(Self { exponents })
    }

    /// The product. Exponents wrap outside the range of `i8`: callers bound the degrees.
    #[inline]
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let (a, b) = (self.packed(), other.packed());
        // All bytes at once: without their signs they cannot overflow into the next one.
        Self::unpacked(((a & !SIGNS) + (b & !SIGNS)) ^ ((a ^ b) & SIGNS))
    }

    /// The quotient as a Laurent monomial. Exponents wrap as in [`Monomial::times`].
    #[inline]
    #[must_use]
    pub fn over(&self, other: &Self) -> Self {
        let (a, b) = (self.packed(), other.packed());
        Self::unpacked(((a | SIGNS) - (b & !SIGNS)) ^ ((a ^ !b) & SIGNS))
    }

    /// A key that sorts as [`Ord`] does, for sorting many monomials.
    pub fn rank(&self) -> (i32, u128) {
        (self.degree(), !(self.packed() ^ SIGNS))
    }

    /// All exponents as the bytes of one number, the last one the highest.
    #[inline]
    fn packed(&self) -> u128 {
        let (mut bytes, mut i) = ([0; MAX_UNKNOWNS], 0);
        while i < MAX_UNKNOWNS {
            bytes[i] = self.exponents[i] as u8;
            i += 1;
        }
        u128::from_le_bytes(bytes)
    }

    #[inline]
    fn unpacked(packed: u128) -> Self {
        let (mut exponents, mut i, bytes) = ([0; MAX_UNKNOWNS], 0, packed.to_le_bytes());
        while i < MAX_UNKNOWNS {
            exponents[i] = bytes[i] as i8;
            i += 1;
        }
        Self { exponents }
    }

    /// Whether every exponent of `self` is at most that of `other`.
    #[inline]
    pub fn divides(&self, other: &Self) -> bool {
        // Without early exit: one vector comparison.
        (0..MAX_UNKNOWNS).fold(true, |all, i| all & (self.exponents[i] <= other.exponents[i]))
    }

    /// The least common multiple.
    #[inline]
    #[must_use]
    pub fn lcm(&self, other: &Self) -> Self {
        let mut exponents = [0; MAX_UNKNOWNS];
        for i in 0..MAX_UNKNOWNS {
            exponents[i] = self.exponents[i].max(other.exponents[i]);
        }
        Self { exponents }
    }

    /// The greatest common divisor.
    #[inline]
    #[must_use]
    pub fn gcd(&self, other: &Self) -> Self {
        let mut exponents = [0; MAX_UNKNOWNS];
        for i in 0..MAX_UNKNOWNS {
            exponents[i] = self.exponents[i].min(other.exponents[i]);
        }
        Self { exponents }
    }

    /// Whether no exponent is negative.
    pub fn is_polynomial(&self) -> bool {
        self.exponents.iter().fold(true, |all, &e| all & (e >= 0))
    }

    /// The monomial in the problem's own names, such as `x^2*y` or `x/y`; `1` for the unit.
    pub fn display<'a>(&'a self, names: &'a [String]) -> impl fmt::Display + 'a {
        DisplayMonomial { monomial: self, names }
    }
}

impl Ord for Monomial {
    #[inline]
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        let backwards = || (other.packed() ^ SIGNS).cmp(&(self.packed() ^ SIGNS));
        self.degree().cmp(&other.degree()).then_with(backwards)
    }
}

impl PartialOrd for Monomial {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl fmt::Debug for Monomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let last = self.exponents.iter().rposition(|&e| e != 0).map_or(0, |i| i + 1);
        write!(f, "x^{:?}", &self.exponents[..last])
    }
}

struct DisplayMonomial<'a> {
    monomial: &'a Monomial,
    names: &'a [String],
}

impl fmt::Display for DisplayMonomial<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let factor = |f: &mut fmt::Formatter<'_>, name: &str, e: i8| match e {
            1 => write!(f, "{name}"),
            _ => write!(f, "{name}^{e}"),
        };
        let exponents = || self.names.iter().zip(self.monomial.exponents);
        let mut first = true;
        for (name, e) in exponents().filter(|&(_, e)| e > 0) {
            if !first {
                write!(f, "*")?;
            }
            factor(f, name, e)?;
            first = false;
        }
        if first {
            write!(f, "1")?;
        }
        for (name, e) in exponents().filter(|&(_, e)| e < 0) {
            write!(f, "/")?;
            factor(f, name, -e)?;
        }
        Ok(())
    }
}
