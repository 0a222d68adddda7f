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

    /// The product of an element with its conjugates, which has no roots, and the product of these
    /// conjugates: the element with other signs of its roots.
    pub(super) fn norm(&self, element: &Element) -> (Univariate, Element) {
        let (mut norm, mut conjugates) = (element.clone(), self.element(&Univariate::constant(1)));
        for (root, _) in &self.squares {
            let mut conjugate = norm.clone();
            for (_, residue) in conjugate.parts.iter_mut().filter(|(roots, _)| roots >> root & 1 == 1) {
                *residue = residue.scaled(self.field, self.field.neg(1));
            }
            (norm, conjugates) = (self.product(&norm, &conjugate), self.product(&conjugates, &conjugate));
        }
        (norm.residues().next().cloned().unwrap_or(Univariate::ZERO), conjugates)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{PRIMES, Random};

    const F: PrimeField = PrimeField::new(PRIMES[0]);
    /// Unknowns that are square roots, of t and of t + 1; no root of the modulus is 0 or -1.
    const ROOTS: [usize; 2] = [2, 5];

    /// The product of t - z for these z.
    fn with_zeros(zeros: &[u32]) -> Univariate {
        let factor = |z: &u32| Univariate::new(vec![F.neg(*z), 1]);
        zeros.iter().fold(Univariate::constant(1), |product, z| product.times(F, &factor(z)))
    }

    fn residues() -> Residues {
        let squares = vec![(ROOTS[0], Univariate::t()), (ROOTS[1], Univariate::new(vec![1, 1]))];
        Residues { field: F, modulus: with_zeros(&[1, 2, 3, 7]), squares }
    }

    fn sum(r: &Residues, a: &Element, b: &Element) -> Element {
        let mut sum = a.clone();
        r.add_multiple(&mut sum, 1, b);
        sum
    }

    /// A combination of 1, both roots and their product.
    fn random_element(r: &Residues, random: &mut Random) -> Element {
        let [x, y] = ROOTS.map(|root| r.root(root));
        let parts = [r.element(&Univariate::constant(1)), x.clone(), y.clone(), r.product(&x, &y)];
        parts.iter().fold(Element::default(), |total, part| {
            let residue = Univariate::new((0..6).map(|_| random.below(1 << 30) as u32).collect());
            sum(r, &total, &r.product(part, &r.element(&residue)))
        })
    }

    #[test]
    fn the_norm_is_the_product_with_the_conjugates() {
        let r = residues();
        let random = &mut Random::new(3);
        let constants = [0; 3].map(|_| r.element(&Univariate::constant(random.below(1_000) as u32 + 1)));
        let [x, y] = ROOTS.map(|unknown| r.root(unknown));
        let a = sum(&r, &constants[0], &sum(&r, &r.product(&constants[1], &x), &r.product(&constants[2], &y)));
        let (norm, conjugates) = r.norm(&a);
        assert_eq!(r.product(&a, &conjugates), r.element(&norm));
        assert!(norm.inverse_modulo(F, &r.modulus).is_some());
        assert!(r.norm(&Element::default()).0.is_zero());
    }

    #[test]
    fn the_square_of_a_root_is_its_residue() {
        let r = residues();
        for (root, square) in &r.squares {
            let x = r.root(*root);
            assert_eq!(r.product(&x, &x), r.element(square));
            assert_eq!(r.product(&x, &r.inverse_root(*root).unwrap()), r.element(&Univariate::constant(1)));
        }
        assert_eq!(r.inverse_root(0), None);
        let [x, y] = ROOTS.map(|root| r.root(root));
        let product = r.product(&x, &y);
        assert_eq!(r.product(&product, &y), r.product(&x, &r.element(&r.squares[1].1)));
        assert!(x != y && product != x && product != y);
    }

    #[test]
    fn elements_are_a_commutative_ring() {
        let r = residues();
        let mut random = Random::new(3);
        for _ in 0..50 {
            let [a, b, c] = [(); 3].map(|_| random_element(&r, &mut random));
            assert_eq!(r.product(&a, &b), r.product(&b, &a));
            assert_eq!(r.product(&r.product(&a, &b), &c), r.product(&a, &r.product(&b, &c)));
            assert_eq!(r.product(&a, &sum(&r, &b, &c)), sum(&r, &r.product(&a, &b), &r.product(&a, &c)));
            let mut difference = a.clone();
            r.add_multiple(&mut difference, F.neg(1), &a);
            assert_eq!(difference, Element::default());
        }
    }

    /// x (t - 1) (t - 2) + (t - 2) (t - 7) vanishes for both signs of x where t = 2 only.
    #[test]
    fn an_element_vanishes_where_all_its_residues_do() {
        let r = residues();
        let [left, right] = [[1, 2], [2, 7]].map(|zeros| r.element(&with_zeros(&zeros)));
        let element = sum(&r, &r.product(&r.root(2), &left), &right);
        assert_eq!(r.zeros(&element).monic(F), with_zeros(&[2]));
        assert_eq!(r.zeros(&Element::default()), r.modulus);
        // Modulo t - 2 it is 0, and modulo t - 1 it has no root any more.
        let restricted = |zeros: &[u32]| Residues { modulus: with_zeros(zeros), ..r.clone() };
        assert_eq!(restricted(&[2]).reduced(&element), Element::default());
        let at_one = restricted(&[1]);
        assert_eq!(at_one.reduced(&element), at_one.element(&with_zeros(&[2, 7])));
        assert_eq!(at_one.reduced(&element).residues().count(), 1);
    }
}
