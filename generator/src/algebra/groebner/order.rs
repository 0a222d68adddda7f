//! Monomial orders.

use std::cmp::Ordering;

use crate::algebra::{MAX_UNKNOWNS, Monomial};

/// A monomial order, with x_0 > x_1 > ...
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MonomialOrder {
    /// Total degree, ties by reverse lexicographic order.
    GrevLex,
    /// Weighted degree, ties as [`MonomialOrder::GrevLex`]. Unknowns may have weight 0; those of
    /// positive weight are then eliminated: a polynomial whose leading monomial is free of them is
    /// free of them altogether (Bayer & Stillman, "A theorem on refining division orders by the
    /// reverse lexicographic order", 1987).
    Weighted([u16; MAX_UNKNOWNS]),
    /// Lexicographic.
    Lex,
}

impl MonomialOrder {
    /// The order by weighted degree. Unknowns beyond `weights` get weight 1.
    pub fn weighted(weights: &[u16]) -> Self {
        let mut all = [1; MAX_UNKNOWNS];
        all.iter_mut().zip(weights).for_each(|(target, &weight)| *target = weight);
        Self::Weighted(all)
    }

    /// The order that eliminates the given unknowns: their joint degree, ties as
    /// [`MonomialOrder::GrevLex`].
    pub fn eliminating(unknowns: impl IntoIterator<Item = usize>) -> Self {
        let mut weights = [0; MAX_UNKNOWNS];
        for unknown in unknowns {
            weights.get_mut(unknown).into_iter().for_each(|weight| *weight = 1);
        }
        Self::Weighted(weights)
    }

    /// Compares two monomials.
    pub fn compare(&self, a: &Monomial, b: &Monomial) -> Ordering {
        self.key(a).cmp(&self.key(b))
    }

    /// A key that sorts as the monomials do.
    #[inline]
    pub fn key(&self, monomial: &Monomial) -> OrderKey {
        // |total degree| < 2^11: it does not reach the bits of the weighted degree.
        let degree = || i64::from(monomial.degree());
        match self {
            Self::GrevLex => OrderKey { degrees: degree(), exponents: reverse_key(monomial) },
            Self::Weighted(weights) => {
                let weighted: i64 =
                    monomial.exponents().iter().zip(weights).map(|(&e, &w)| i64::from(e) * i64::from(w)).sum();
                OrderKey { degrees: (weighted << 16) + degree(), exponents: reverse_key(monomial) }
            }
            Self::Lex => OrderKey { degrees: 0, exponents: lexicographic_key(monomial) },
        }
    }

    /// The degree that the order compares first, by which S-pairs are selected; `None` for orders
    /// that are not graded by positive weights.
    pub(super) fn grade(&self, monomial: &Monomial) -> Option<i32> {
        match self {
            Self::GrevLex => Some(monomial.degree()),
            Self::Weighted(weights) if weights.iter().all(|&weight| weight > 0) => {
                Some(monomial.exponents().iter().zip(weights).map(|(&e, &w)| i32::from(e) * i32::from(w)).sum())
            }
            Self::Weighted(_) | Self::Lex => None,
        }
    }
}

/// A monomial's place in a [`MonomialOrder`]; only keys of the same order compare meaningfully.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct OrderKey {
    degrees: i64,
    exponents: u128,
}

/// The last exponent in the most significant byte, smaller exponents ranking higher.
#[inline]
fn reverse_key(monomial: &Monomial) -> u128 {
    u128::from_le_bytes(monomial.exponents().map(|e| 127i8.wrapping_sub(e) as u8))
}

/// The first exponent in the most significant byte.
#[inline]
fn lexicographic_key(monomial: &Monomial) -> u128 {
    u128::from_be_bytes(monomial.exponents().map(|e| e.wrapping_sub(-128) as u8))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn m(exponents: &[i8]) -> Monomial {
        Monomial::from_exponents(exponents)
    }

    #[test]
    fn textbook_comparisons() {
        // Cox, Little & O'Shea, "Ideals, Varieties, and Algorithms", section 2.2.
        assert_eq!(MonomialOrder::Lex.compare(&m(&[1, 2, 0]), &m(&[0, 3, 4])), Ordering::Greater);
        assert_eq!(MonomialOrder::Lex.compare(&m(&[3, 2, 4]), &m(&[3, 2, 1])), Ordering::Greater);
        assert_eq!(MonomialOrder::GrevLex.compare(&m(&[4, 7, 1]), &m(&[4, 2, 3])), Ordering::Greater);
        assert_eq!(MonomialOrder::GrevLex.compare(&m(&[1, 5, 2]), &m(&[4, 1, 3])), Ordering::Greater);
        let weighted = MonomialOrder::weighted(&[1, 3]);
        assert_eq!(weighted.compare(&m(&[2, 0]), &m(&[0, 1])), Ordering::Less);
        assert_eq!(weighted.compare(&m(&[3, 0]), &m(&[0, 1])), Ordering::Greater);
        let eliminating = MonomialOrder::eliminating([2]);
        assert_eq!(eliminating.compare(&m(&[0, 0, 1]), &m(&[9, 9, 0])), Ordering::Greater);
        assert_eq!(eliminating.compare(&m(&[2, 0, 1]), &m(&[1, 1, 1])), Ordering::Greater);
    }

    #[test]
    fn grevlex_is_the_canonical_order_also_of_laurent_monomials() {
        let samples =
            [m(&[0, 0]), m(&[-1, 1]), m(&[1, -1]), m(&[2, -3, 1]), m(&[127, 0, -128]), m(&[0, 1, 1]), m(&[1, 0, 1])];
        for a in &samples {
            for b in &samples {
                assert_eq!(MonomialOrder::GrevLex.compare(a, b), a.cmp(b));
            }
        }
    }
}
