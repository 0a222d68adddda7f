//! Statements about results: the struct that a problem returns, and inequalities that its solutions
//! satisfy.

use syn::{Attribute, BinOp, Expr, ExprBinary, ExprStruct, FieldValue, Member, Meta};

use super::Statement;
use super::interpret::Interpreter;
use super::names::{refuse, snake_case};
use super::output::{Output, OutputField};
use super::scope::{Outcome, Reported};
use super::syntax::place;
use super::value::{Algebra, Value, describe};
use crate::expression::{ExpressionId, SymbolicPolynomial};
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
        let is_inside = std::mem::replace(&mut self.is_in_field, true);
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
            if let Ok((shape, elements, is_complex)) = self.output_elements(&field.expr) {
                if is_projective && (is_complex || shape.is_empty()) {
                    let diagnostic = Diagnostic::new("this field cannot be given up to scale", place(&field.expr));
                    self.report(diagnostic.label("expected an array of real numbers"));
                }
                fields.push(OutputField { name: ident.to_string(), shape, is_complex, is_projective, elements });
            }
        }
        self.is_in_field = is_inside;
        let function = snake_case(&name);
        self.output = Some(Output { name, function, fields, span });
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

    /// The shape and the scalars of a field, and whether it is complex.
    fn output_elements(&mut self, expression: &Expr) -> Outcome<(Vec<usize>, Vec<ExpressionId>, bool)> {
        let value = self.evaluate(expression)?;
        self.charge(value.weight(), expression)?;
        let (shape, elements, is_complex) = self.real_elements(&value);
        let elements = elements.iter().map(|element| self.algebra.graph.value_of(element)).collect();
        Ok((shape, elements, is_complex))
    }

    /// Inside of a field what is multiplied, or passed to a function, is a value: it is computed
    /// once, whatever is made of it. Sums of products would be expanded otherwise. Powers of single
    /// unknowns stay as they are, so that there are derivatives by them.
    pub(super) fn operand_in_field(&mut self, operand: &Value, at: &Expr) -> Outcome<Value> {
        self.charge(operand.weight(), at)?;
        let elements = operand.elements().iter().map(|element| {
            let [re, im] = self.algebra.parts(element).map(|part| match part.terms().len() {
                0 | 1 => part,
                _ => self.value_in_field(&part),
            });
            Algebra::join([&re, &im])
        });
        let elements = elements.collect();
        Ok(Value::array(operand.shape().to_vec(), elements))
    }

    /// The value of a real polynomial at the solution.
    fn value_in_field(&mut self, polynomial: &SymbolicPolynomial) -> SymbolicPolynomial {
        let value = self.algebra.graph.value_of(polynomial);
        self.algebra.data(value)
    }

    /// The square root of a real scalar that depends on unknowns, inside of a field.
    pub(super) fn root_in_field(&mut self, square: &Value) -> Outcome<Value> {
        let Some(polynomial) = square.as_scalar() else { return Err(Reported) };
        let square = self.algebra.graph.value_of(polynomial);
        let root = self.algebra.graph.root(square);
        Ok(Value::scalar(self.algebra.data(root)))
    }

    /// Whether a value depends on unknowns.
    pub(super) fn is_of_solution(&self, value: &Value) -> bool {
        let graph = &self.algebra.graph;
        let depends = |p: &SymbolicPolynomial| {
            p.degree() > 0 || p.terms().iter().any(|&(_, coefficient)| graph.is_of_solution(coefficient))
        };
        value.elements().iter().flat_map(|element| self.algebra.parts(element)).any(|part| depends(&part))
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

    fn difference(&mut self, binary: &ExprBinary, larger: &Value, smaller: &Value) -> Outcome<Value> {
        if smaller.is_scalar_zero() {
            return Ok(larger.clone());
        }
        let difference = self.algebra.subtract(larger, smaller);
        self.check(difference, binary)
    }
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
