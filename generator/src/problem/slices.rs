//! Parts of arrays, and arrays joined.

use syn::{ExprCall, ExprIndex, ExprRange, RangeLimits};

use super::interpret::Interpreter;
use super::scope::Outcome;
use super::syntax::place;
use super::value::{Value, describe};
use crate::problem::diagnostic::Diagnostic;

impl Interpreter<'_> {
    /// `array[first..end]`: elements of a vector, or rows of a matrix.
    pub(super) fn slice(&mut self, expression: &ExprIndex, range: &ExprRange) -> Outcome<Value> {
        let array = self.evaluate(&expression.expr)?;
        let Some((&length, inner)) = array.shape().split_first() else {
            let diagnostic = Diagnostic::new("a scalar has no elements", place(&expression.expr));
            return Err(self.report(diagnostic.label("expected an array")));
        };
        let first = range.start.as_ref().map_or(Ok(0), |first| self.index_value(first));
        let end = range.end.as_ref().map_or(Ok(length as i64), |end| self.index_value(end));
        let is_closed = range.end.is_some() && matches!(range.limits, RangeLimits::Closed(_));
        let (first, end) = (first?, end?.saturating_add(i64::from(is_closed)));
        if !(0 <= first && first < end && end <= length as i64) {
            let diagnostic = Diagnostic::new(format!("the range {first}..{end} has no elements here"), place(range))
                .label(format!("expected a part of 0..{length}"));
            return Err(self.report(diagnostic.context(place(&expression.expr), describe(array.shape()))));
        }
        self.charge(array.weight(), expression)?;
        let (first, end, width) = (first as usize, end as usize, inner.iter().product::<usize>());
        let shape = [&[end - first], inner].concat();
        Ok(Value::array(shape, array.elements()[first * width..end * width].to_vec()))
    }

    /// The elements, or rows, of two arrays one after another. What has the shape of an element,
    /// such as a scalar beside a vector, is one element.
    pub(super) fn concat(&mut self, call: &ExprCall, a: &Value, b: &Value) -> Outcome<Value> {
        let larger = if a.shape().len() >= b.shape().len() { a } else { b };
        let element = larger.shape().get(1..).unwrap_or_default();
        let count = |value: &Value| match value.shape() {
            shape if shape == element => Some(1),
            [length, inner @ ..] if inner == element => Some(*length),
            _ => None,
        };
        let (Some(first), Some(second)) = (count(a), count(b)) else {
            let diagnostic = Diagnostic::new("`concat` needs elements of one shape", place(call));
            let label = format!("{} and {}", describe(a.shape()), describe(b.shape()));
            return Err(self.report(diagnostic.label(label)));
        };
        self.limit_elements(a.elements().len() + b.elements().len(), a.weight() + b.weight(), call)?;
        let shape = [&[first + second], element].concat();
        Ok(Value::array(shape, [a.elements(), b.elements()].concat()))
    }
}
