//! Quotients and remainders.

use syn::ExprBinary;

use super::interpret::Interpreter;
use super::scope::Outcome;
use super::syntax::place;
use super::value::{Value, describe};
use crate::expression::ExpressionGraph;
use crate::expression::rational::Rational;
use crate::problem::diagnostic::Diagnostic;

impl Interpreter<'_> {
    /// left / right, by a scalar: constants and data divide; inside of a field whatever depends on
    /// the solution, too.
    pub(super) fn divide(&mut self, binary: &ExprBinary, left: &Value, right: &Value) -> Outcome<Value> {
        let at = place(&binary.right);
        let Some(divisor) = right.as_scalar() else {
            let diagnostic = Diagnostic::new("only scalars can divide", at);
            let hint = match *right.shape() {
                [n, m] if n == m => "write `inverse(a) * b`, or `solve(a, b)`, for data a",
                _ => "divide by an element, or by `norm(v)` of data v",
            };
            return Err(self.report(diagnostic.label(format!("this is {}", describe(right.shape()))).hint(hint)));
        };
        let diagnostic = match self.algebra.as_constant(divisor) {
            Some(value) => match Rational::ONE.checked_div(value) {
                Some(reciprocal) => {
                    let factor = Value::scalar(self.algebra.constant(reciprocal));
                    let result = self.algebra.multiply(left, &factor);
                    return self.check(result, binary);
                }
                None => Diagnostic::new("division by zero", at).label("this is 0"),
            },
            None if divisor.degree() > 0 && !self.is_in_field => {
                Diagnostic::new("division by an unknown is not polynomial", at)
                    .label("this depends on unknowns")
                    .hint("multiply the equation by it, and state `divisor != 0;`")
            }
            None => {
                // A value of the data; inside of a field one that may depend on the solution, too.
                let divisor = self.algebra.graph.value_of(divisor);
                if let Some(dividend) = left.as_scalar().filter(|p| self.is_in_field && !self.algebra.is_complex(p)) {
                    let dividend = self.algebra.graph.value_of(dividend);
                    if let Some(quotient) = self.algebra.graph.div(dividend, divisor) {
                        return Ok(Value::scalar(self.algebra.data(quotient)));
                    }
                }
                let Some(reciprocal) = self.algebra.graph.div(ExpressionGraph::ONE, divisor) else {
                    let diagnostic = Diagnostic::new("division by zero", at);
                    return Err(self.report(diagnostic.label("this is 0 for all data")));
                };
                let result = self.algebra.multiply(left, &Value::scalar(self.algebra.data(reciprocal)));
                return self.check(result, binary);
            }
        };
        Err(self.report(diagnostic))
    }

    /// Remainder of constant integers, non-negative: `(i + 1) % 3` is the next of three.
    pub(super) fn remainder(&mut self, binary: &ExprBinary) -> Outcome<Value> {
        let (left, right) = (self.index_value(&binary.left)?, self.index_value(&binary.right)?);
        match left.checked_rem_euclid(right) {
            Some(remainder) => Ok(self.integer(remainder)),
            None => Err(self.report(Diagnostic::new("division by zero", place(&binary.right)).label("this is 0"))),
        }
    }
}
