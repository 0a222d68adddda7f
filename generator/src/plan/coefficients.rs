//! The list of coefficients that the tables of a plan refer to.

use std::collections::HashMap;

use super::output::{PlannedField, PlannedOutput};
use super::straight_line::programs_of_results;
use super::system_table::SystemTable;
use super::{CoefficientId, Term};
use crate::algebra::Monomial;
use crate::expression::{ExpressionId, SymbolicPolynomial};
use crate::problem::Problem;
use crate::problem::output::Output;

/// The coefficients that the tables refer to. If the equations are stored as a matrix, it comes
/// first, row by row. The others follow in order of first use.
#[derive(Default)]
pub(super) struct Coefficients {
    ids: HashMap<ExpressionId, u32>,
    /// `None` for a zero.
    pub(super) used: Vec<Option<ExpressionId>>,
}

impl Coefficients {
    pub(super) fn of_equations(problem: &Problem) -> Self {
        let (mut listed, width) = (Self::default(), problem.unknowns.len());
        let equations: Vec<Vec<Term>> = problem.polynomials().map(|p| listed.terms(p, width)).collect();
        let table = SystemTable::of(&equations, width);
        let mut coefficients = Self::default();
        if table.is_dense() {
            let entry = |entry: Option<u16>| entry.and_then(|id| listed.used[usize::from(id)]);
            coefficients.used = table.matrix().into_iter().map(entry).collect();
            for (&expression, at) in coefficients.used.iter().zip(0..) {
                expression.map(|expression| *coefficients.ids.entry(expression).or_insert(at));
            }
        }
        coefficients
    }

    pub(super) fn id(&mut self, expression: ExpressionId) -> CoefficientId {
        let next = self.used.len() as u32;
        let id = *self.ids.entry(expression).or_insert(next);
        if id == next {
            self.used.push(Some(expression));
        }
        // A number that does not fit is refused at the end, before anything reads the plan.
        CoefficientId(id as u16)
    }

    pub(super) fn terms(&mut self, polynomial: &SymbolicPolynomial, width: usize) -> Vec<Term> {
        let term = |&(m, c): &(Monomial, ExpressionId)| Term {
            coefficient: self.id(c),
            exponents: m.exponents()[..width].iter().map(|&e| e.max(0) as u8).collect(),
        };
        polynomial.terms().iter().map(term).collect()
    }
}

/// What a solver returns beside the unknowns.
pub(super) fn planned_output(problem: &Problem, output: &Output) -> PlannedOutput {
    let fields = output.fields.iter().map(|field| PlannedField {
        name: field.name.clone(),
        shape: field.shape.clone(),
        is_complex: field.is_complex,
        is_projective: field.is_projective,
    });
    let elements: Vec<ExpressionId> = output.elements().collect();
    let [(program, coefficients), (of_solution, scalars)] = programs_of_results(&problem.graph, &elements);
    let (name, function) = (output.name.clone(), output.function.clone());
    PlannedOutput { name, function, fields: fields.collect(), program, coefficients, of_solution, scalars }
}
