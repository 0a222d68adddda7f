//! Evaluation of the original equations from static tables, so that emitted code is data, not arithmetic.

use crate::scalar::{Scalar, mapped};

/// E equations in N unknowns, with their derivatives.
pub trait System<S: Scalar, const N: usize, const E: usize> {
    /// At the point x: each equation's value, the sum of the moduli of its terms, and its gradient.
    fn evaluate(&self, x: &[S; N], residual: &mut [S; E], scale: &mut [f64; E], jacobian: &mut [[S; N]; E]);

    /// Like [`System::evaluate`], without gradients.
    #[inline]
    fn residual(&self, x: &[S; N], residual: &mut [S; E], scale: &mut [f64; E]) {
        self.evaluate(x, residual, scale, &mut [[S::ZERO; N]; E]);
    }
}

/// One monomial of the product chain: an earlier monomial times an unknown.
#[derive(Clone, Copy, Debug)]
pub struct Product {
    /// The position of the earlier monomial in the chain.
    pub parent: u16,
    /// The unknown it is multiplied by.
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
///   chain     monomial 0 is 1 (chain[0] is not read); monomial k is monomial chain[k].parent * x[chain[k].unknown]
///   terms     [ equation 0 .. | equation 1 .. |   ..   | equation E-1 .. ]
///   ends                      ^ ends[0]       ^ ends[1]                  ^ ends[E-1]
/// ```
///
/// Every monomial value costs one multiplication, and its N derivatives one multiplication each, by the product rule
/// along the chain; the chain must therefore hold the parents of every monomial that the equations use.
#[derive(Clone, Copy, Debug)]
pub struct Tables<const N: usize, const E: usize, const K: usize, const C: usize> {
    chain: &'static [Product; K],
    ends: &'static [u32; E],
    terms: &'static [Term],
}

impl<const N: usize, const E: usize, const K: usize, const C: usize> Tables<N, E, K, C> {
    /// Checks the tables: parents come before their products, unknowns, monomials and slots exist, ends ascend to the
    /// number of terms. Written for constants, where a failed check is a compile error.
    ///
    /// # Panics
    /// When a check fails: call it in a `const`.
    #[must_use]
    pub const fn new(chain: &'static [Product; K], ends: &'static [u32; E], terms: &'static [Term]) -> Self {
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
        Tables { chain, ends, terms }
    }

    /// The system with these coefficients.
    #[inline]
    #[must_use]
    pub const fn bind<'a>(&self, coefficients: &'a [f64; C]) -> PolynomialSystem<'a, N, E, K, C> {
        PolynomialSystem { tables: *self, coefficients }
    }
}

/// [`Tables`] with coefficients: a system that can be evaluated.
#[derive(Clone, Copy, Debug)]
pub struct PolynomialSystem<'a, const N: usize, const E: usize, const K: usize, const C: usize> {
    tables: Tables<N, E, K, C>,
    coefficients: &'a [f64; C],
}

impl<const N: usize, const E: usize, const K: usize, const C: usize> PolynomialSystem<'_, N, E, K, C> {
    /// Calls `visit(equation, coefficient, monomial)` for every term, equation by equation.
    #[inline]
    fn for_each_term(&self, mut visit: impl FnMut(usize, f64, usize)) {
        let mut start = 0;
        for (equation, &end) in self.tables.ends.iter().enumerate() {
            for term in &self.tables.terms[start..end as usize] {
                visit(equation, self.coefficients[usize::from(term.coefficient)], usize::from(term.monomial));
            }
            start = end as usize;
        }
    }

    /// The values of the chain.
    #[inline]
    fn monomials<S: Scalar>(&self, x: &[S; N]) -> [S; K] {
        let mut values = [S::ONE; K];
        for k in 1..K {
            let Product { parent, unknown } = self.tables.chain[k];
            values[k] = values[usize::from(parent)] * x[usize::from(unknown)];
        }
        values
    }
}

impl<S: Scalar, const N: usize, const E: usize, const K: usize, const C: usize> System<S, N, E>
    for PolynomialSystem<'_, N, E, K, C>
{
    #[inline]
    fn evaluate(&self, x: &[S; N], residual: &mut [S; E], scale: &mut [f64; E], jacobian: &mut [[S; N]; E]) {
        let values = self.monomials(x);
        let mut gradients = [[S::ZERO; N]; K];
        for k in 1..K {
            let Product { parent, unknown } = self.tables.chain[k];
            let (parent, unknown) = (usize::from(parent), usize::from(unknown));
            gradients[k] = mapped(&gradients[parent], |derivative| derivative * x[unknown]);
            gradients[k][unknown] += values[parent];
        }
        *residual = [S::ZERO; E];
        *scale = [0.0; E];
        *jacobian = [[S::ZERO; N]; E];
        self.for_each_term(|equation, coefficient, monomial| {
            let term = values[monomial].scale(coefficient);
            residual[equation] += term;
            scale[equation] += term.modulus();
            for j in 0..N {
                jacobian[equation][j] += gradients[monomial][j].scale(coefficient);
            }
        });
    }

    #[inline]
    fn residual(&self, x: &[S; N], residual: &mut [S; E], scale: &mut [f64; E]) {
        let values = self.monomials(x);
        *residual = [S::ZERO; E];
        *scale = [0.0; E];
        self.for_each_term(|equation, coefficient, monomial| {
            let term = values[monomial].scale(coefficient);
            residual[equation] += term;
            scale[equation] += term.modulus();
        });
    }
}
