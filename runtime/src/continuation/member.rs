//! The equations of a problem for complex data.

extern crate alloc;

use alloc::vec;
use alloc::vec::Vec;
use num_complex::Complex;

use crate::continuation::family::Family;
use crate::dynamic_size::Dynamic;
use crate::number::Scalar;
use crate::size::Matrix;
use crate::solution::system::{System, Values};

/// The equations for complex data.
pub(crate) struct Member<'a> {
    family: &'a Family<'a>,
    coefficients: Vec<Complex<f64>>,
}

impl<'a> Family<'a> {
    /// The equations for these data.
    pub(crate) fn at(&'a self, data: &[Complex<f64>]) -> Member<'a> {
        let (values, coefficients) = self.counts;
        let (mut values, mut coefficients) = (vec![Complex::ZERO; values], vec![Complex::ZERO; coefficients]);
        let mut inputs = data.to_vec();
        inputs.resize(self.inputs, Complex::ZERO);
        self.program.run_on(&inputs, &mut values, &mut coefficients);
        Member { family: self, coefficients }
    }
}

impl Member<'_> {
    /// The numbers of unknowns and equations.
    pub(crate) fn sizes(&self) -> (Dynamic, Dynamic) {
        (Dynamic(self.family.unknowns), Dynamic(self.family.ends.len()))
    }

    /// Calls `each` with each term: its equation, its coefficient, and its monomial.
    fn for_each_term(&self, mut each: impl FnMut(usize, Complex<f64>, usize)) {
        let mut start = 0;
        for (equation, &end) in self.family.ends.iter().enumerate() {
            for term in self.family.terms.get(start..end as usize).unwrap_or(&[]) {
                let coefficient = self.coefficients.get(usize::from(term.coefficient));
                each(equation, coefficient.copied().unwrap_or(Complex::ZERO), usize::from(term.monomial));
            }
            start = end as usize;
        }
    }
}

impl System<Complex<f64>, Dynamic, Dynamic> for Member<'_> {
    type Monomials = Vec<Complex<f64>>;

    fn monomials(&self, x: &Vec<Complex<f64>>) -> Vec<Complex<f64>> {
        let mut values = vec![Complex::ONE; self.family.chain.len()];
        for (k, product) in self.family.chain.iter().enumerate().skip(1) {
            values[k] = values[usize::from(product.parent)] * x[usize::from(product.unknown)];
        }
        values
    }

    fn residual(&self, monomials: &Vec<Complex<f64>>, at: &mut Values<Complex<f64>, Dynamic>) {
        at.residual.fill(Complex::ZERO);
        at.scale.fill(0.0);
        self.for_each_term(|equation, coefficient, monomial| {
            let product = coefficient * monomials[monomial];
            at.residual[equation] += product;
            at.scale[equation] += product.magnitude();
        });
    }

    fn values(&self, monomials: &Vec<Complex<f64>>, residual: &mut Vec<Complex<f64>>) {
        residual.fill(Complex::ZERO);
        self.for_each_term(|equation, coefficient, monomial| residual[equation] += coefficient * monomials[monomial]);
    }

    fn derivatives(
        &self,
        x: &Vec<Complex<f64>>,
        monomials: &Vec<Complex<f64>>,
        columns: &mut Matrix<Dynamic, Dynamic, Complex<f64>>,
    ) {
        let (unknowns, chain) = (self.family.unknowns, self.family.chain);
        // One row for each monomial, in one list: there are many steps.
        let mut gradients = vec![Complex::ZERO; chain.len() * unknowns];
        for (k, product) in chain.iter().enumerate().skip(1) {
            let (parent, unknown) = (usize::from(product.parent), usize::from(product.unknown));
            for j in 0..unknowns {
                gradients[k * unknowns + j] = gradients[parent * unknowns + j] * x[unknown];
            }
            gradients[k * unknowns + unknown] += monomials[parent];
        }
        columns.iter_mut().for_each(|column| column.fill(Complex::ZERO));
        self.for_each_term(|equation, coefficient, monomial| {
            for (column, &derivative) in columns.iter_mut().zip(&gradients[monomial * unknowns..]) {
                column[equation] += coefficient * derivative;
            }
        });
    }
}
