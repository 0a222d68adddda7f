//! Statements about results: the struct that a problem returns, and inequalities that its solutions
//! satisfy.

use syn::{Attribute, BinOp, Expr, ExprBinary, ExprStruct, FieldValue, Member, Meta};

use super::Statement;
use super::functions::BUILT_IN;
use super::interpret::Interpreter;
use super::names::{refuse, snake_case};
use super::output::{Output, OutputElement, OutputField};
use super::scope::Outcome;
use super::syntax::place;
use super::value::{Algebra, IMAGINARY_UNIT, Value, describe};
use crate::algebra::{MAX_UNKNOWNS, Monomial, Polynomial};
use crate::expression::rational::Rational;
use crate::expression::{ExpressionGraph, SymbolicPolynomial};
use crate::problem::diagnostic::Diagnostic;

/// Types, traits and parameters that the emitted module has or names: a struct would hide them.
const TAKEN: [&str; 18] = [
    "Solution",
    "Data",
    "Instance",
    "Chains",
    "Monomials",
    "Result",
    "Option",
    "Some",
    "None",
    "Ok",
    "Err",
    "Copy",
    "Clone",
    "From",
    "C",
    "R",
    "S",
    "T",
];

impl Interpreter<'_> {
    /// The last line of a problem: a struct of what it returns.
    pub(super) fn state_output(&mut self, stated: &ExprStruct) {
        let span = place(stated);
        if let Some((name, _)) = self.calls.last().cloned() {
            let diagnostic = Diagnostic::new("a helper function returns a value, not a struct", span);
            self.report(diagnostic.label(format!("`{name}` is a helper: it does not return unknowns")));
            return;
        }
        if let Some(first) = self.output.as_ref().map(|first| first.span.clone()) {
            let diagnostic = Diagnostic::new("a problem returns one struct", span).label("a second one");
            self.report(diagnostic.context(first, "the first"));
            return;
        }
        let Ok(name) = self.name_of_output(stated) else { return };
        self.parts = Some(Vec::new());
        let mut fields: Vec<OutputField> = Vec::new();
        for field in &stated.fields {
            let Member::Named(ident) = &field.member else {
                self.report(Diagnostic::new("fields have names", place(&field.member)));
                continue;
            };
            if let Some(diagnostic) = refuse(ident, "a field") {
                self.report(diagnostic);
            }
            if fields.iter().any(|known| *ident == known.name) {
                self.report(Diagnostic::new(format!("the field `{ident}` is listed twice"), place(ident)));
                continue;
            }
            let Ok(is_projective) = self.is_up_to_scale(field) else { continue };
            if let Ok(OutputValue { shape, is_complex, elements }) = self.output_elements(&field.expr) {
                if is_projective && (is_complex || shape.is_empty()) {
                    let diagnostic = Diagnostic::new("this field cannot be given up to scale", place(&field.expr));
                    self.report(diagnostic.label("expected an array of real numbers"));
                }
                fields.push(OutputField { name: ident.to_string(), shape, is_complex, is_projective, elements });
            }
        }
        let (function, parts) = (snake_case(&name), self.parts.take().unwrap_or_default());
        self.output = Some(Output { name, function, parts, fields, span });
    }

    /// Whether a field is marked as one of which any multiple says the same.
    fn is_up_to_scale(&mut self, field: &FieldValue) -> Outcome<bool> {
        let is_known =
            |attribute: &&Attribute| matches!(&attribute.meta, Meta::Path(path) if path.is_ident("projective"));
        match field.attrs.iter().find(|attribute| !is_known(attribute)) {
            None => Ok(!field.attrs.is_empty()),
            Some(attribute) => {
                let diagnostic = Diagnostic::new("this attribute has no meaning here", place(attribute));
                Err(self.report(diagnostic.label("expected `#[projective]`, for a field that is given up to scale")))
            }
        }
    }

    fn name_of_output(&mut self, stated: &ExprStruct) -> Outcome<String> {
        let name = stated.path.get_ident().map(ToString::to_string).unwrap_or_default();
        let is_type = name.starts_with(|c: char| c.is_ascii_uppercase())
            && name.chars().all(|c| c.is_ascii_alphanumeric())
            && refuse(&quote::format_ident!("{}", snake_case(&name)), "").is_none();
        if !is_type || TAKEN.contains(&name.as_str()) {
            let diagnostic = Diagnostic::new("this cannot be the name of what is returned", place(&stated.path));
            let diagnostic = diagnostic.label("expected a name in CamelCase, such as `Pose`");
            return Err(self.report(match TAKEN.contains(&name.as_str()) {
                true => diagnostic.hint(format!("the code of every solver has the name `{name}`")),
                false => diagnostic,
            }));
        }
        if let Some(rest) = &stated.rest {
            return Err(self.report(Diagnostic::new("all fields are listed", place(&**rest))));
        }
        if stated.fields.is_empty() {
            let diagnostic = Diagnostic::new("the struct has no fields", place(stated));
            return Err(self.report(diagnostic.label("expected such as `Pose { rotation: r }`")));
        }
        Ok(name)
    }

    /// The shape and the scalars of a field. Quotients and square roots that hold unknowns are
    /// parts, but for the outermost operation.
    fn output_elements(&mut self, expression: &Expr) -> Outcome<OutputValue> {
        match expression {
            Expr::Paren(inner) => self.output_elements(&inner.expr),
            Expr::Binary(binary) if matches!(binary.op, BinOp::Div(_)) => self.quotient(binary),
            Expr::Call(call) if is_root(&call.func) && call.args.len() == 1 => {
                let mut value = self.output_elements(&call.args[0])?;
                let OutputValue { shape, elements, .. } = &mut value;
                if !shape.is_empty() || elements.iter().any(|element| element.is_root) {
                    let diagnostic = Diagnostic::new("`sqrt` needs a polynomial or a quotient", place(&call.args[0]));
                    return Err(self.report(diagnostic));
                }
                if elements.iter().all(|e| e.denominator.is_none() && e.numerator.degree() == 0) {
                    return self.call(call).map(|value| self.as_elements(&value));
                }
                elements.iter_mut().for_each(|element| element.is_root = true);
                Ok(value)
            }
            _ => self.evaluate(expression).map(|value| self.as_elements(&value)),
        }
    }

    fn quotient(&mut self, binary: &ExprBinary) -> Outcome<OutputValue> {
        let (left, right) = (self.evaluate(&binary.left), self.evaluate(&binary.right));
        let (left, right) = self.with_real_divisor(left?, right?, &binary.right)?;
        let divisor = right.as_scalar().filter(|divisor| divisor.degree() > 0).cloned();
        if divisor.is_none() {
            return self.combine(binary, &left, &right).map(|value| self.as_elements(&value));
        }
        let mut quotient = self.as_elements(&left);
        quotient.elements.iter_mut().for_each(|element| element.denominator.clone_from(&divisor));
        Ok(quotient)
    }

    /// The square root of what depends on unknowns, inside of a field.
    pub(super) fn root_in_field(&mut self, root: &Expr) -> Outcome<Value> {
        let value = self.output_elements(root)?;
        match <[OutputElement; 1]>::try_from(value.elements) {
            Ok([element]) if element.is_root => self.part(element, root),
            Ok([element]) => Ok(Value::scalar(element.numerator)),
            Err(_) => Err(self.report(Diagnostic::new("`sqrt` needs a scalar", place(root)))),
        }
    }

    /// The reciprocal of what depends on unknowns, inside of a field.
    pub(super) fn reciprocal_in_field(&mut self, divisor: &SymbolicPolynomial, at: &Expr) -> Outcome<Value> {
        let numerator = self.algebra.constant(Rational::ONE);
        self.part(OutputElement { numerator, denominator: Some(divisor.clone()), is_root: false }, at)
    }

    /// Inside of a field a sum that is passed to a helper is a part: whatever the helper does with
    /// it, it is computed once.
    pub(super) fn passed_in_field(&mut self, value: Value, at: &Expr) -> Outcome<Value> {
        match value.as_scalar() {
            Some(sum) if self.parts.is_some() && self.algebra.is_complex(sum) => {
                let parts = self.algebra.parts(sum).map(|part| self.passed_in_field(Value::scalar(part), at));
                let [re, im] = parts;
                let (re, im) = (re?, im?);
                let joined = Algebra::join([&re.elements()[0], &im.elements()[0]]);
                Ok(Value::scalar(joined))
            }
            Some(sum) if self.parts.is_some() && sum.degree() > 0 && sum.terms().len() > 1 => {
                let element = plain(sum);
                self.part(element, at)
            }
            _ => Ok(value),
        }
    }

    /// A value that stands for a part of the output.
    fn part(&mut self, element: OutputElement, at: &Expr) -> Outcome<Value> {
        let (first, parts) = (self.unknowns.len(), self.parts.get_or_insert_default());
        let number = parts.iter().position(|known| *known == element).unwrap_or(parts.len());
        let end = if self.algebra.has_imaginary_unit { IMAGINARY_UNIT } else { MAX_UNKNOWNS };
        if first + number >= end {
            let diagnostic = Diagnostic::new(
                "the results hold too many quotients, roots and sums that are passed to helpers",
                place(at),
            );
            let most = end - first;
            return Err(self.report(diagnostic.label(format!("at most {most} are allowed beside the unknowns"))));
        }
        if number == parts.len() {
            parts.push(element);
        }
        let monomial = Monomial::unknown(first + number);
        Ok(Value::scalar(Polynomial::from_terms(vec![(monomial, ExpressionGraph::ONE)])))
    }

    /// `left > right` or `left < right`: `solve` returns no other solutions.
    pub(super) fn state_inequality(&mut self, expression: &Expr, binary: &ExprBinary) {
        if self.outside_helpers(expression).is_err() {
            return;
        }
        let (left, right) = (self.evaluate(&binary.left), self.evaluate(&binary.right));
        let (Ok(left), Ok(right)) = (left, right) else { return };
        let (larger, smaller) = if matches!(binary.op, BinOp::Gt(_)) { (left, right) } else { (right, left) };
        let Ok(difference) = self.difference(binary, &larger, &smaller) else { return };
        if self.real(expression, &difference).is_err() {
            return;
        }
        let span = place(expression);
        match difference.as_scalar() {
            Some(polynomial) if polynomial.degree() > 0 || self.is_scene => {
                let statement = Statement { polynomial: polynomial.clone(), span, element: String::new() };
                self.positive.push(statement);
            }
            Some(_) => {
                let diagnostic = Diagnostic::new("the inequality does not depend on the unknowns", span);
                self.report(diagnostic.hint("it holds for some data and fails for others: test the data beforehand"));
            }
            None => {
                let diagnostic = Diagnostic::new("an inequality needs scalars", span);
                let diagnostic = diagnostic.label(format!("this is {}", describe(difference.shape())));
                self.report(diagnostic.hint("state it for each element in a loop"));
            }
        }
    }

    /// Refuses statements about solutions inside helpers.
    pub(super) fn outside_helpers(&mut self, expression: &Expr) -> Outcome<()> {
        let Some((name, _)) = self.calls.last().cloned() else { return Ok(()) };
        Err(self.report(
            Diagnostic::new("a helper function cannot state equations", place(expression))
                .label(format!("`{name}` is a helper: it does not return unknowns"))
                .hint("return the value and state the equation in the problem function"),
        ))
    }

    fn as_elements(&self, value: &Value) -> OutputValue {
        let (shape, elements, is_complex) = self.real_elements(value);
        OutputValue { shape, is_complex, elements: elements.iter().map(plain).collect() }
    }

    fn difference(&mut self, binary: &ExprBinary, larger: &Value, smaller: &Value) -> Outcome<Value> {
        if smaller.is_scalar_zero() {
            return Ok(larger.clone());
        }
        let difference = self.algebra.subtract(larger, smaller);
        self.check(difference, binary)
    }
}

fn plain(numerator: &SymbolicPolynomial) -> OutputElement {
    OutputElement { numerator: numerator.clone(), denominator: None, is_root: false }
}

/// The value of a field.
struct OutputValue {
    shape: Vec<usize>,
    is_complex: bool,
    elements: Vec<OutputElement>,
}

/// Whether a call is one of the function `sqrt` of the language.
pub(super) fn is_root(function: &Expr) -> bool {
    let is_built_in = |name: &syn::Ident| name == "sqrt" && BUILT_IN.iter().any(|known| known.name == "sqrt");
    matches!(function, Expr::Path(path) if path.path.get_ident().is_some_and(is_built_in))
}

/// Checks that an inequality means the same for both signs of a vector that is given up to scale.
pub(super) fn check_even(statement: &Statement, unknowns: &[usize], field: &str) -> Result<(), Diagnostic> {
    let first = statement.polynomial.monomials().next();
    let degree = first.map_or(0, |m| unknowns.iter().map(|&at| i32::from(m.exponent(at))).sum::<i32>());
    match degree % 2 {
        0 => Ok(()),
        _ => Err(Diagnostic::new("the inequality depends on a sign that nothing determines", statement.span.clone())
            .label(format!("of degree {degree} in `{field}`"))
            .hint(format!("`{field}` is given up to scale: state it for products of two of its elements"))),
    }
}
