//! Data that are derived from data: quotients, linear systems, null spaces.

use syn::{Expr, ExprCall};

use super::functions::BuiltIn;
use super::interpret::Interpreter;
use super::scope::Outcome;
use super::syntax::place;
use super::value::{Value, describe};
use crate::algebra::Monomial;
use crate::expression::derivation::DerivationKind;
use crate::expression::{ExpressionGraph, ExpressionId};
use crate::problem::diagnostic::Diagnostic;

/// Largest matrix that is derived from: 64 x 64.
const MAX_OPERANDS: usize = 4096;

impl Interpreter<'_> {
    /// `solve(a, b)`: the x with a x = b, for a vector or the columns of a matrix.
    pub(super) fn solve(
        &mut self,
        call: &ExprCall,
        function: &BuiltIn,
        arguments: &[&Expr],
        [a, b]: [&Value; 2],
    ) -> Outcome<Value> {
        let size = self.square(function, arguments[0], a)?;
        let right = match *b.shape() {
            [n] if n == size => 1,
            [n, columns] if n == size => columns,
            _ => {
                let message = format!("`solve` needs a vector of length {size} or a matrix of {size} rows here");
                let diagnostic = Diagnostic::new(message, place(arguments[1]));
                return Err(self.report(diagnostic.label(format!("this is {}", describe(b.shape())))));
            }
        };
        let mut operands = self.data_of(function, arguments[0], a)?;
        operands.extend(self.data_of(function, arguments[1], b)?);
        self.derive(call, DerivationKind::Solve { size, right }, &operands, b.shape().to_vec())
    }

    /// `inverse(a)`.
    pub(super) fn inverse(
        &mut self,
        call: &ExprCall,
        function: &BuiltIn,
        argument: &Expr,
        a: &Value,
    ) -> Outcome<Value> {
        let size = self.square(function, argument, a)?;
        let mut operands = self.data_of(function, argument, a)?;
        operands.extend((0..size * size).map(|at| match at.is_multiple_of(size + 1) {
            true => ExpressionGraph::ONE,
            false => ExpressionGraph::ZERO,
        }));
        self.derive(call, DerivationKind::Solve { size, right: size }, &operands, vec![size, size])
    }

    /// `null_space(a)`: orthonormal vectors v with a v = 0, one in each row.
    pub(super) fn null_space(
        &mut self,
        call: &ExprCall,
        function: &BuiltIn,
        argument: &Expr,
        a: &Value,
    ) -> Outcome<Value> {
        let [rows, columns] = *a.shape() else {
            let diagnostic = Diagnostic::new("`null_space` needs a matrix", place(argument));
            return Err(self.report(diagnostic.label(format!("this is {}", describe(a.shape())))));
        };
        if rows >= columns {
            let diagnostic = Diagnostic::new("the null space of general data is 0", place(argument));
            let diagnostic = diagnostic.label(format!("this is {}", describe(a.shape())));
            return Err(self.report(diagnostic.hint("a null space needs fewer rows than columns")));
        }
        let operands = self.data_of(function, argument, a)?;
        self.derive(call, DerivationKind::NullSpace { rows, columns }, &operands, vec![columns - rows, columns])
    }

    /// The values of an array that depends on data only.
    fn data_of(&mut self, function: &BuiltIn, argument: &Expr, value: &Value) -> Outcome<Vec<ExpressionId>> {
        let of_data = value.elements().iter().map(|element| match *element.terms() {
            [] => Some(ExpressionGraph::ZERO),
            [(Monomial::ONE, coefficient)] => Some(coefficient),
            _ => None,
        });
        of_data.collect::<Option<_>>().ok_or_else(|| {
            let message = format!("`{}` is computed from data only", function.name);
            let diagnostic = Diagnostic::new(message, place(argument)).label("this depends on unknowns");
            self.report(diagnostic.hint("state the equations that the result satisfies instead"))
        })
    }

    fn derive(
        &mut self,
        call: &ExprCall,
        kind: DerivationKind,
        operands: &[ExpressionId],
        shape: Vec<usize>,
    ) -> Outcome<Value> {
        if operands.len() > MAX_OPERANDS {
            let diagnostic = Diagnostic::new("the matrix is too large", place(call));
            return Err(self.report(diagnostic.label(format!("at most {MAX_OPERANDS} entries are allowed"))));
        }
        self.charge(kind.operations(), call)?;
        self.limit_elements(kind.results(), kind.results(), call)?;
        match self.algebra.graph.derive(kind, operands) {
            Some(results) => {
                let elements = results.into_iter().map(|result| self.algebra.data(result)).collect();
                Ok(Value::array(shape, elements))
            }
            None => {
                let diagnostic = Diagnostic::new("the matrix is singular for all data", place(call));
                Err(self.report(diagnostic.label("its rows are linearly dependent")))
            }
        }
    }
}
