//! Unknowns that are given up to scale: statements that are homogeneous in them, read in a chart.

use super::chart::entry;
use super::value::Algebra;
use super::{SolutionField, Statement};
use crate::algebra::{Monomial, Polynomial};
use crate::expression::rational::Rational;
use crate::expression::{ExpressionGraph, SymbolicPolynomial};
use crate::problem::diagnostic::Diagnostic;

/// How the elements of vectors that are given up to scale are read.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Elements {
    /// As combinations of the coordinates in the chart, which are solved for.
    InChart,
    /// As unknowns themselves.
    Themselves,
}

/// The elements of a field as polynomials in its unknowns, and in one more in place of 1, so that
/// what is homogeneous stays so.
pub(super) fn homogeneous(
    (algebra, elements): (&mut Algebra, Elements),
    field: &SolutionField,
    scale: usize,
) -> Vec<SymbolicPolynomial> {
    let size = field.unknowns().len() + 1;
    let coordinates: Vec<usize> = field.unknowns().chain([scale]).collect();
    if elements == Elements::Themselves {
        let unknown = |&at| Polynomial::from_terms(vec![(Monomial::unknown(at), ExpressionGraph::ONE)]);
        return coordinates.iter().map(unknown).collect();
    }
    let unknown = |algebra: &mut Algebra, row: usize| {
        let mut terms = Vec::with_capacity(size);
        for (column, &coordinate) in coordinates.iter().enumerate() {
            // A power of two in place of the denominator changes the scale alone: coefficients keep
            // their size, and are exact in `f64`.
            let (numerator, denominator) = entry(size, row, column);
            let power = denominator.cast_unsigned().next_power_of_two().cast_signed();
            let Some(value) = Rational::new(numerator, power) else { continue };
            if let [(_, coefficient)] = algebra.constant(value).terms() {
                terms.push((Monomial::unknown(coordinate), *coefficient));
            }
        }
        Polynomial::from_terms(terms)
    };
    (0..size).map(|row| unknown(algebra, row)).collect()
}

/// Checks that a statement is homogeneous in the unknowns of a field.
pub(super) fn check_homogeneous(statement: &Statement, field: &SolutionField, scale: usize) -> Result<(), Diagnostic> {
    let degree = |monomial: Monomial| -> i32 {
        field.unknowns().chain([scale]).map(|unknown| i32::from(monomial.exponent(unknown))).sum()
    };
    let (mut least, mut largest) = (i32::MAX, 0);
    for monomial in statement.polynomial.monomials() {
        (least, largest) = (least.min(degree(monomial)), largest.max(degree(monomial)));
    }
    if least >= largest {
        return Ok(());
    }
    let name = &field.name;
    let diagnostic = Diagnostic::new(format!("the terms have different degrees in `{name}`"), statement.span.clone());
    Err(diagnostic
        .label(format!("degrees {least} to {largest}"))
        .context(field.span.clone(), "given up to scale")
        .hint(format!("with `{name}` any multiple of it is a solution only if all terms have one degree in it")))
}

/// A homogeneous polynomial where the unknowns from `first` on are 1.
pub(super) fn dehomogenised(polynomial: &SymbolicPolynomial, first: usize) -> SymbolicPolynomial {
    let terms = polynomial
        .terms()
        .iter()
        .map(|&(monomial, coefficient)| (Monomial::from_exponents(&monomial.exponents()[..first]), coefficient));
    Polynomial::from_terms(terms.collect())
}
