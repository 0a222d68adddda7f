//! Evaluates the original equations from tables, so that emitted code is data, not arithmetic.

use crate::number::double_double::{DoubleComplex, DoubleDouble};
use crate::number::{Arithmetic, Over, Scalar};
use crate::size::{Fixed, Matrix, Size, filled_matrix};

/// E equations in N unknowns, with their derivatives.
pub trait System<S: Scalar, N: Size, E: Size> {
    /// What all evaluations at one point share: the values of monomials.
    type Monomials;

    /// The monomials at the point x.
    fn monomials(&self, x: &N::Vector<S>) -> Self::Monomials;

    /// The equations with their scales at the point of these monomials.
    fn residual(&self, monomials: &Self::Monomials, at: &mut Values<S, E>);

    /// Like [`System::residual`], without the scales.
    fn values(&self, monomials: &Self::Monomials, residual: &mut E::Vector<S>);

    /// The columns of the Jacobian, one for each unknown, at the point x of these monomials.
    fn derivatives(&self, x: &N::Vector<S>, monomials: &Self::Monomials, columns: &mut Matrix<N, E, S>);
}

/// E equations in N unknowns, evaluated at twice the precision.
pub trait PreciseSystem<N: Size, E: Size> {
    /// The equations at a point of twice the precision, with these coefficients in place of the
    /// rounded ones. A coefficient that is not in the list counts as zero.
    fn precise_values(&self, x: &N::Vector<DoubleComplex>, coefficients: &[DoubleDouble]) -> E::Vector<DoubleComplex>;
}

/// The coefficient in a slot; zero if there is no such slot.
#[inline]
pub(crate) fn precise_coefficient(coefficients: &[DoubleDouble], slot: usize) -> DoubleDouble {
    coefficients.get(slot).copied().unwrap_or(DoubleDouble::ZERO)
}

/// K monomials in N unknowns.
pub trait Monomials<N: Size, K: Size> {
    /// Their values at the point x.
    fn products<T: Arithmetic>(&self, x: &N::Vector<T>) -> K::Vector<T>;

    /// Hands over the derivatives by each unknown in turn, from the values at x: the positions of
    /// the monomials with the unknown, highest first, with their derivatives, in one piece or
    /// several.
    fn for_each_gradient<T: Arithmetic>(
        &self,
        x: &N::Vector<T>,
        values: &K::Vector<T>,
        visit: impl FnMut(usize, &[(u16, T)]),
    );
}

/// The equations at a point.
pub struct Values<S: Scalar, E: Size> {
    /// The value of each equation.
    pub residual: E::Vector<S>,
    /// The sum of the moduli of the terms of each equation.
    pub scale: E::Vector<f64>,
}

impl<S: Scalar, E: Size> Values<S, E> {
    /// All values are zero.
    #[inline]
    pub fn zero(equations: E) -> Self {
        Values { residual: equations.filled(S::ZERO), scale: equations.filled(0.0) }
    }
}

/// One monomial of the product chain: an earlier monomial times an unknown.
#[derive(Clone, Copy, Debug)]
pub struct Product {
    /// The position of the earlier monomial in the chain.
    pub parent: u16,
    /// The unknown by which it is multiplied.
    pub unknown: u16,
}

/// One term of an equation: a coefficient, which depends on the data, times a monomial.
#[derive(Clone, Copy, Debug)]
pub struct Term {
    /// The slot of the coefficient.
    pub coefficient: u16,
    /// The position of the monomial in the chain.
    pub monomial: u16,
}

/// The support of E polynomial equations in N unknowns over K monomials and C coefficient slots.
///
/// ```text
///   chain     monomial 0 is 1 (chain[0] is not read);
///             monomial k is monomial chain[k].parent * x[chain[k].unknown]
///   terms     [ equation 0 .. | equation 1 .. |   ..   | equation E-1 .. ]
///   ends                      ^ ends[0]       ^ ends[1]                  ^ ends[E-1]
/// ```
///
/// Every monomial value costs one multiplication, and its N derivatives one multiplication each, by
/// the product rule along the chain. The chain must therefore hold the parents of every monomial
/// that the equations use.
pub struct Tables<'a, N: Size, E: Size, K: Size> {
    /// N, E and K.
    pub sizes: (N, E, K),
    /// The monomials.
    pub chain: &'a K::Vector<Product>,
    /// The end of each equation's terms.
    pub ends: &'a E::Vector<u32>,
    /// The terms of all equations.
    pub terms: &'a [Term],
}

/// Tables of sizes that the compiler knows.
pub type FixedTables<const N: usize, const E: usize, const K: usize> = Tables<'static, Fixed<N>, Fixed<E>, Fixed<K>>;

impl<const N: usize, const E: usize, const K: usize> FixedTables<N, E, K> {
    /// Checks the tables: parents come before their products, unknowns and monomials exist,
    /// coefficients are among the first C, ends ascend to the number of terms. In a constant, a
    /// failed check is a compile error.
    ///
    /// # Panics
    /// If a check fails.
    #[must_use]
    pub const fn new<const C: usize>(
        chain: &'static [Product; K],
        ends: &'static [u32; E],
        terms: &'static [Term],
    ) -> Self {
        assert!(K >= 1, "the chain starts with the monomial 1");
        let mut k = 1;
        while k < K {
            assert!((chain[k].parent as usize) < k, "a parent must come before its product");
            assert!((chain[k].unknown as usize) < N, "there is no such unknown");
            k += 1;
        }
        let mut e = 0;
        let mut start = 0;
        while e < E {
            assert!(ends[e] >= start, "ends must ascend");
            start = ends[e];
            e += 1;
        }
        assert!(start as usize == terms.len(), "the last equation ends with the terms");
        let mut t = 0;
        while t < terms.len() {
            assert!((terms[t].monomial as usize) < K, "there is no such monomial");
            assert!((terms[t].coefficient as usize) < C, "there is no such coefficient slot");
            t += 1;
        }
        Tables { sizes: (Fixed, Fixed, Fixed), chain, ends, terms }
    }
}

impl<N: Size, E: Size, K: Size> Clone for Tables<'_, N, E, K> {
    #[inline]
    fn clone(&self) -> Self {
        *self
    }
}

// A derived `Copy` would require that arrays of all types are `Copy`.
impl<N: Size, E: Size, K: Size> Copy for Tables<'_, N, E, K> {}

impl<'a, N: Size, E: Size, K: Size> Tables<'a, N, E, K> {
    /// N and E.
    #[inline]
    #[must_use]
    pub const fn polynomials(&self) -> (N, E) {
        let (unknowns, equations, _) = self.sizes;
        (unknowns, equations)
    }

    /// The system with these coefficients.
    #[inline]
    #[must_use]
    pub const fn bind(&self, coefficients: &'a [f64]) -> PolynomialSystem<'a, N, E, K> {
        PolynomialSystem { tables: *self, coefficients }
    }

    /// The terms of each equation.
    #[inline]
    pub(crate) fn equations(&self) -> impl Iterator<Item = &'a [Term]> {
        let terms = self.terms;
        self.ends.as_ref().iter().scan(0, move |start, &end| {
            let of_equation = &terms[*start..end as usize];
            *start = end as usize;
            Some(of_equation)
        })
    }
}

impl<N: Size, E: Size, K: Size> Monomials<N, K> for Tables<'_, N, E, K> {
    #[inline]
    fn products<T: Arithmetic>(&self, x: &N::Vector<T>) -> K::Vector<T> {
        let (_, _, count) = self.sizes;
        let mut values = count.filled(x[0].constant(1.0));
        for k in 1..count.get() {
            let Product { parent, unknown } = self.chain[k];
            values[k] = values[usize::from(parent)] * x[usize::from(unknown)];
        }
        values
    }

    #[inline]
    fn for_each_gradient<T: Arithmetic>(
        &self,
        x: &N::Vector<T>,
        values: &K::Vector<T>,
        mut visit: impl FnMut(usize, &[(u16, T)]),
    ) {
        let (unknowns, _, count) = self.sizes;
        let gradients = self.gradients(x, values);
        // A list of all would take stack where nothing is optimised.
        let mut piece = [(0, values[0]); PIECE];
        for j in 0..unknowns.get() {
            let mut has_unknown = count.filled(false);
            for k in 1..count.get() {
                let Product { parent, unknown } = self.chain[k];
                has_unknown[k] = has_unknown[usize::from(parent)] || usize::from(unknown) == j;
            }
            let mut length = 0;
            for k in (1..count.get()).rev().filter(|&k| has_unknown[k]) {
                piece[length] = (k as u16, gradients[k][j]);
                length += 1;
                if length == PIECE {
                    visit(j, &piece);
                    length = 0;
                }
            }
            visit(j, &piece[..length]);
        }
    }
}

/// Monomials of one unknown that tables hand over at once.
const PIECE: usize = 32;

impl<N: Size, E: Size, K: Size> Tables<'_, N, E, K> {
    /// The derivatives of each monomial by all unknowns.
    #[inline]
    fn gradients<T: Arithmetic>(&self, x: &N::Vector<T>, values: &K::Vector<T>) -> Matrix<K, N, T> {
        let (unknowns, _, count) = self.sizes;
        let mut gradients = filled_matrix(count, unknowns, x[0].constant(0.0));
        for k in 1..count.get() {
            let Product { parent, unknown } = self.chain[k];
            let (parent, unknown) = (usize::from(parent), usize::from(unknown));
            let factor = x[unknown];
            let mut gradient = gradients[parent].clone();
            gradient.as_mut().iter_mut().for_each(|derivative| *derivative = *derivative * factor);
            gradient[unknown] += values[parent];
            gradients[k] = gradient;
        }
        gradients
    }
}

/// A system that can be evaluated: [`Tables`] with coefficients.
pub struct PolynomialSystem<'a, N: Size, E: Size, K: Size> {
    tables: Tables<'a, N, E, K>,
    coefficients: &'a [f64],
}

impl<N: Size, E: Size, K: Size> PolynomialSystem<'_, N, E, K> {
    #[inline]
    fn term<S: Scalar>(&self, term: &Term, monomials: &K::Vector<S>) -> S {
        monomials[usize::from(term.monomial)].scale(self.coefficients[usize::from(term.coefficient)])
    }

    /// Whether the modulus of every polynomial exceeds `level`, relative to the sum of the moduli
    /// of its terms.
    #[inline]
    pub fn exceeds<S: Scalar>(&self, x: &N::Vector<S>, level: f64) -> bool {
        let (_, count, _) = self.tables.sizes;
        let mut values = Values::zero(count);
        self.residual(&self.monomials(x), &mut values);
        let sizes = values.residual.as_ref().iter().map(|value: &S| value.modulus());
        sizes.zip(values.scale.as_ref()).all(|(size, scale)| size > level * scale)
    }
}

impl<S: Scalar, N: Size, E: Size, K: Size> System<S, N, E> for PolynomialSystem<'_, N, E, K> {
    type Monomials = K::Vector<S>;

    #[inline]
    fn monomials(&self, x: &N::Vector<S>) -> K::Vector<S> {
        self.tables.products(x)
    }

    #[inline]
    fn residual(&self, monomials: &K::Vector<S>, at: &mut Values<S, E>) {
        for (equation, terms) in self.tables.equations().enumerate() {
            // Sums in locals, which stay in registers.
            let (mut value, mut size) = (S::ZERO, 0.0);
            for term in terms {
                let product = self.term(term, monomials);
                value += product;
                size += product.modulus();
            }
            (at.residual[equation], at.scale[equation]) = (value, size);
        }
    }

    #[inline]
    fn values(&self, monomials: &K::Vector<S>, residual: &mut E::Vector<S>) {
        for (equation, terms) in self.tables.equations().enumerate() {
            let mut value = S::ZERO;
            for term in terms {
                value += self.term(term, monomials);
            }
            residual[equation] = value;
        }
    }

    #[inline]
    fn derivatives(&self, x: &N::Vector<S>, monomials: &K::Vector<S>, columns: &mut Matrix<N, E, S>) {
        let (unknowns, _, _) = self.tables.sizes;
        let gradients = self.tables.gradients(x, monomials);
        for (equation, terms) in self.tables.equations().enumerate() {
            let mut gradient = unknowns.filled(S::ZERO);
            for term in terms {
                let coefficient = self.coefficients[usize::from(term.coefficient)];
                let of_monomial = &gradients[usize::from(term.monomial)];
                for j in 0..unknowns.get() {
                    gradient[j] += of_monomial[j].scale(coefficient);
                }
            }
            for j in 0..unknowns.get() {
                columns[j][equation] = gradient[j];
            }
        }
    }
}

impl<N: Size, E: Size, K: Size> PreciseSystem<N, E> for PolynomialSystem<'_, N, E, K> {
    fn precise_values(&self, x: &N::Vector<DoubleComplex>, coefficients: &[DoubleDouble]) -> E::Vector<DoubleComplex> {
        let (_, equations, _) = self.tables.sizes;
        let monomials = self.tables.products(x);
        let mut values = equations.filled(DoubleComplex::ZERO);
        for (equation, terms) in self.tables.equations().enumerate() {
            for term in terms {
                let coefficient = precise_coefficient(coefficients, usize::from(term.coefficient));
                values[equation] += monomials[usize::from(term.monomial)].times(coefficient);
            }
        }
        values
    }
}
