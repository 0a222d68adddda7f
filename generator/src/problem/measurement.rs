//! Data that are means over measurements: what one of them gives.
//!
//! ```text
//!   fn pose(#[mean(of_point)] means: [[f64; 10]; 6]) -> (..)
//!   fn of_point(ray: [f64; 3], point: [f64; 3]) -> [[f64; 10]; 6]
//!
//!   means = (of_point(ray 1, point 1) + .. + of_point(ray n, point n)) / n
//! ```
//!
//! A solver has data of one size, n is up to each call. To the search the means are data like any
//! others; the emitted module has a function that computes them.

use syn::{Ident, ItemFn, Meta, PatType, ReturnType};

use super::MeanOf;
use super::interpret::Interpreter;
use super::names::closest;
use super::scope::Outcome;
use super::syntax::place;
use super::value::{Value, describe};
use crate::expression::{ExpressionGraph, ExpressionId, SymbolicPolynomial};
use crate::problem::diagnostic::Diagnostic;

impl Interpreter<'_> {
    /// The function that `#[mean(..)]` names, if the parameter has the attribute.
    pub(super) fn read_mean(&mut self, parameter: &PatType, is_complex: bool) -> Outcome<Option<MeanOf>> {
        let mut attributes = parameter.attrs.iter().filter(|attribute| attribute.path().is_ident("mean"));
        let Some(attribute) = attributes.next() else { return Ok(None) };
        let span = place(&attribute.meta);
        if let Some(again) = attributes.next() {
            let diagnostic = Diagnostic::new("a parameter is one mean", place(&again.meta)).label("the second");
            return Err(self.report(diagnostic.context(span, "the first")));
        }
        let function = match &attribute.meta {
            Meta::List(list) => list.parse_args::<Ident>().ok(),
            _ => None,
        };
        let Some(function) = function else {
            let hint =
                "the function says what one measurement gives: `fn of_point(point: [f64; 3]) -> [f64; 3] { .. }`";
            let diagnostic = Diagnostic::new("`mean` needs the name of a function", span);
            return Err(self.report(diagnostic.label("expected such as `mean(of_point)`").hint(hint)));
        };
        let name = function.to_string();
        if !self.helpers.contains_key(&name) {
            let diagnostic = Diagnostic::new(format!("unknown function `{name}`"), place(&function)).label("not found");
            return Err(self.report(match closest(&name, self.helpers.keys().map(String::as_str)) {
                Some(meant) => diagnostic.hint(format!("did you mean `{meant}`?")),
                None => diagnostic.hint(format!("add `fn {name}(..) -> .. {{ .. }}`: what one measurement gives")),
            }));
        }
        if is_complex {
            let diagnostic = Diagnostic::new("only real data are means", span);
            let diagnostic = diagnostic.context(place(&*parameter.ty), "this is complex");
            return Err(self.report(diagnostic.hint("write real and imaginary parts as data of their own")));
        }
        Ok(Some(MeanOf { function: name, span }))
    }

    /// What a function gives for a measurement, or what is wrong with it.
    pub(super) fn measured(&mut self, function: &ItemFn, shape: &[usize]) -> Outcome<Vec<ExpressionId>> {
        let value = self.block_value(&function.block)?;
        let ReturnType::Type(_, ty) = &function.sig.output else {
            let diagnostic = Diagnostic::new("what a measurement gives has no type", place(&function.sig.ident));
            let ty = if shape.is_empty() { "`f64`".to_owned() } else { describe(shape) };
            return Err(self.report(diagnostic.label(format!("expected {ty}")).hint("write the type behind `->`")));
        };
        let expected = self.shape_of_type(ty)?;
        let fits = expected.check(&value, self.algebra.is_complex_value(&value));
        self.check(fits, &**ty)?;
        if value.shape() != shape {
            let found = format!("this is {}", describe(value.shape()));
            let mean = if shape.is_empty() { "a number".to_owned() } else { describe(shape) };
            return Err(self.report(Diagnostic::new(format!("the mean is {mean}"), place(&**ty)).label(found)));
        }
        self.elements_of_measurement(function, &value)
    }

    fn elements_of_measurement(&mut self, function: &ItemFn, value: &Value) -> Outcome<Vec<ExpressionId>> {
        if !self.algebra.graph.derivations().is_empty() {
            let diagnostic = Diagnostic::new(
                "what a measurement gives has sums, products and quotients only",
                place(&function.sig.ident),
            )
            .label("square roots, linear systems or null spaces occur in it")
            .hint("a projection across `v` needs no unit vector: divide products of its elements by `dot(v, v)`");
            return Err(self.report(diagnostic));
        }
        Ok(value.elements().iter().map(constant).collect())
    }
}

/// The one coefficient of a polynomial without unknowns.
pub(super) fn constant(polynomial: &SymbolicPolynomial) -> ExpressionId {
    polynomial.terms().first().map_or(ExpressionGraph::ZERO, |&(_, value)| value)
}
