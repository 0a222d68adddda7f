//! Residues of polynomials modulo a polynomial, times square roots of residues.

use crate::algebra::{PrimeField, Univariate};

/// A set of unknowns that are square roots, by bits.
type Roots = u16;

/// A sum of residues c(t) modulo a polynomial, each times some square roots:
///
/// ```text
///   sum over sets R of roots of  c_R(t) * product over x in R of x          with x^2 = X(t)
/// ```
///
/// It vanishes for both signs of each root if and only if all c_R do, where no X is 0.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Element {
    /// Increasing sets of roots with what they are multiplied by, which is not 0.
    parts: Vec<(Roots, Univariate)>,
}

impl Element {
    /// The residues c_R, none of them 0.
    pub(super) fn residues(&self) -> impl Iterator<Item = &Univariate> {
        self.parts.iter().map(|(_, residue)| residue)
    }
}

/// Where elements are computed: residues of polynomials in t, and square roots of some of them.
#[derive(Clone, Debug)]
pub(super) struct Residues {
    /// The coefficients of residues.
    pub(super) field: PrimeField,
    /// The polynomial that residues are taken modulo; it has no repeated factor.
    pub(super) modulus: Univariate,
    /// The unknowns that are square roots, with their squares, which have inverses.
    pub(super) squares: Vec<(usize, Univariate)>,
}

impl Residues {
    /// A residue as an element without roots.
    pub(super) fn element(&self, residue: &Univariate) -> Element {
        self.with_roots(0, residue)
    }

    /// An unknown that is a square root.
    pub(super) fn root(&self, unknown: usize) -> Element {
        self.with_roots(1 << unknown, &Univariate::constant(1))
    }

    fn with_roots(&self, roots: Roots, residue: &Univariate) -> Element {
        let residue = residue.modulo(self.field, &self.modulus);
        Element { parts: if residue.is_zero() { Vec::new() } else { vec![(roots, residue)] } }
    }

    /// The same element modulo a divisor of the modulus it was computed with.
    pub(super) fn reduced(&self, element: &Element) -> Element {
        let reduced = |(roots, residue): &(Roots, Univariate)| (*roots, residue.modulo(self.field, &self.modulus));
        Element { parts: element.parts.iter().map(reduced).filter(|(_, residue)| !residue.is_zero()).collect() }
    }

    /// sum += c element, for c in Z_p.
    pub(super) fn add_multiple(&self, sum: &mut Element, c: u32, element: &Element) {
        for (roots, residue) in &element.parts {
            match sum.parts.binary_search_by_key(roots, |(roots, _)| *roots) {
                Ok(at) => sum.parts[at].1.add_multiple(self.field, (c, 0), residue),
                Err(at) => sum.parts.insert(at, (*roots, residue.scaled(self.field, c))),
            }
        }
        sum.parts.retain(|(_, residue)| !residue.is_zero());
    }

    /// The product.
    pub(super) fn product(&self, a: &Element, b: &Element) -> Element {
        let mut sum = Element::default();
        for (of_a, left) in &a.parts {
            for (of_b, right) in &b.parts {
                let twice = of_a & of_b;
                let squares = self.squares.iter().filter(|(unknown, _)| twice >> unknown & 1 == 1);
                let product = squares.fold(self.residue_product(left, right), |product, (_, square)| {
                    self.residue_product(&product, square)
                });
                self.add_multiple(&mut sum, 1, &self.with_roots(of_a ^ of_b, &product));
            }
        }
        sum
    }

    /// 1 / x for a square root x: x / X.
    pub(super) fn inverse_root(&self, unknown: usize) -> Option<Element> {
        let (_, square) = self.squares.iter().find(|(root, _)| *root == unknown)?;
        let inverse = square.inverse_modulo(self.field, &self.modulus)?;
        Some(self.with_roots(1 << unknown, &inverse))
    }

    fn residue_product(&self, a: &Univariate, b: &Univariate) -> Univariate {
        a.times(self.field, b).modulo(self.field, &self.modulus)
    }

    /// The part of the modulus at whose roots an element vanishes, for all signs of the square
    /// roots.
    pub(super) fn zeros(&self, element: &Element) -> Univariate {
        element.residues().fold(self.modulus.clone(), |zeros, residue| zeros.gcd(self.field, residue))
    }
}
