//! Reads the function of a scene: the last line is the data and, if it is known, what solves them.

use syn::{Expr, ExprStruct, ExprTuple, ItemFn, Member, ReturnType, Stmt};

use super::interpret::Interpreter;
use super::measurement::constant;
use super::names::closest;
use super::scene::{Scene, Truth};
use super::scope::Outcome;
use super::syntax::place;
use super::value::describe;
use super::{DataParameter, Problem, Span};
use crate::expression::{ExpressionGraph, ExpressionId};
use crate::problem::diagnostic::Diagnostic;

/// The attribute of its function.
pub(super) const ATTRIBUTE: &str = "scene";

/// Whether a function of the file is a scene.
pub(super) fn is_scene(function: &ItemFn) -> bool {
    function.attrs.iter().any(|attribute| attribute.path().is_ident(ATTRIBUTE))
}

/// A struct that a scene may return.
struct Expected<'a> {
    name: &'a str,
    fields: Vec<Field<'a>>,
}

/// A field of a struct: name, shape, and whether it is complex.
type Field<'a> = (&'a str, &'a [usize], bool);

impl Interpreter<'_> {
    /// Runs the function of a scene, whose parameters have been declared.
    pub(super) fn run_scene(
        &mut self,
        function: &ItemFn,
        drawn: &[DataParameter],
        problem: &Problem,
    ) -> Outcome<Scene> {
        let data = problem.data.iter().map(|data| (&*data.name, &*data.shape, data.is_complex)).collect();
        let of_unknowns = problem.fields.iter().map(|field| (&*field.name, &*field.shape, field.is_complex));
        let mut expected =
            vec![Expected { name: "Data", fields: data }, Expected { name: "Solution", fields: of_unknowns.collect() }];
        expected.extend(problem.output.as_ref().map(|output| Expected {
            name: &output.name,
            fields: output.fields.iter().map(|field| (&*field.name, &*field.shape, field.is_complex)).collect(),
        }));
        let (statements, value) = match function.block.stmts.split_last() {
            Some((Stmt::Expr(value, None), statements)) => (statements, Some(value)),
            _ => (&function.block.stmts[..], None),
        };
        statements.iter().for_each(|statement| self.run_statement(statement));
        let Some(value) = value else {
            return Err(self.no_scene(function.block.brace_token.span.close().byte_range(), &expected));
        };
        let (data, truth) = self.returned(value, &expected)?;
        self.check_return_type(function, &truth)?;
        let data = self.all_fields(data, &expected[0]);
        let truth = match truth {
            None => Ok(Truth::Nothing),
            Some((stated, 1)) => self.all_fields(stated, &expected[1]).map(Truth::Solution),
            Some((stated, at)) => self.fields(stated, &expected[at]).map(Truth::Results),
        };
        let (data, truth) = (data?, truth?);
        let positive = self.positive.iter().map(|statement| constant(&statement.polynomial)).collect();
        let graph = self.algebra.graph.clone();
        Ok(Scene { name: function.sig.ident.to_string(), drawn: drawn.to_vec(), graph, data, truth, positive })
    }

    /// Refuses equations and results, which are of unknowns.
    pub(super) fn refuse_in_scene(&mut self, expression: &Expr) {
        let diagnostic = Diagnostic::new("a scene states nothing of unknowns", place(expression));
        self.report(diagnostic.hint("it computes data; where `depth > 0;` fails another scene is drawn"));
    }

    /// The struct of the data and, if there is one, that of the truth and its place among those
    /// that are expected.
    fn returned<'e>(
        &mut self,
        value: &'e Expr,
        expected: &[Expected<'_>],
    ) -> Outcome<(&'e ExprStruct, Option<(&'e ExprStruct, usize)>)> {
        let named = |value: &'e Expr, wanted: std::ops::Range<usize>| match value {
            Expr::Struct(stated) => {
                let at = wanted.into_iter().find(|&at| stated.path.is_ident(expected[at].name))?;
                Some((stated, at))
            }
            _ => None,
        };
        let found = match value {
            Expr::Tuple(ExprTuple { elems, .. }) if elems.len() == 2 => {
                named(&elems[0], 0..1).and_then(|(data, _)| Some((data, Some(named(&elems[1], 1..expected.len())?))))
            }
            _ => named(value, 0..1).map(|(data, _)| (data, None)),
        };
        found.ok_or_else(|| self.no_scene(place(value), expected))
    }

    fn no_scene(&mut self, span: Span, expected: &[Expected<'_>]) -> super::scope::Reported {
        let text = |expected: &Expected<'_>| {
            let fields: Vec<&str> = expected.fields.iter().map(|&(name, ..)| name).collect();
            format!("{} {{ {} }}", expected.name, fields.join(", "))
        };
        let (data, truth) = (text(&expected[0]), text(&expected[expected.len() - 1]));
        self.report(
            Diagnostic::new("the last line of a scene is the data of the problem", span)
                .label(format!("expected `{data}`, without `;`"))
                .hint(format!("to state what solves them, return two: `({data}, {truth})`")),
        )
    }

    fn check_return_type(&mut self, function: &ItemFn, truth: &Option<(&ExprStruct, usize)>) -> Outcome<()> {
        let expected = match truth {
            None => "Data".to_owned(),
            Some((stated, _)) => {
                format!("(Data, {})", stated.path.get_ident().map(ToString::to_string).unwrap_or_default())
            }
        };
        let ReturnType::Type(_, ty) = &function.sig.output else {
            let diagnostic = Diagnostic::new("the return type of the scene is missing", place(&function.sig.ident));
            return Err(self.report(diagnostic.hint(format!("write `-> {expected}` behind the parameters"))));
        };
        let without_spaces = |text: &str| text.chars().filter(|c| !c.is_whitespace()).collect::<String>();
        if without_spaces(&quote::quote!(#ty).to_string()) != without_spaces(&expected) {
            let diagnostic = Diagnostic::new("the scene returns something else than its type says", place(&**ty));
            return Err(self.report(diagnostic.label(format!("expected `{expected}`"))));
        }
        Ok(())
    }

    /// The fields of a struct that lacks none.
    fn all_fields(&mut self, stated: &ExprStruct, expected: &Expected<'_>) -> Outcome<Vec<ExpressionId>> {
        let fields = self.fields(stated, expected)?;
        let is_listed = |name: &str| stated.fields.iter().any(|field| is_named(&field.member, name));
        let names = expected.fields.iter().map(|&(name, ..)| name);
        let missing: Vec<&str> = names.filter(|name| !is_listed(name)).collect();
        if !missing.is_empty() {
            let message = format!("`{}` lacks the fields `{}`", expected.name, missing.join("`, `"));
            return Err(self.report(Diagnostic::new(message, place(&stated.path))));
        }
        Ok(fields.into_iter().flatten().collect())
    }

    /// The scalars of all fields of a struct in the order that is expected, `None` for those that
    /// are missing.
    fn fields(&mut self, stated: &ExprStruct, expected: &Expected<'_>) -> Outcome<Vec<Option<ExpressionId>>> {
        if let Some(rest) = &stated.rest {
            return Err(self.report(Diagnostic::new("all fields are listed", place(&**rest))));
        }
        let names = expected.fields.iter().map(|&(name, ..)| name);
        let mut found: Vec<Option<Outcome<Vec<ExpressionId>>>> = vec![None; expected.fields.len()];
        let mut outcome = Ok(());
        for field in &stated.fields {
            let Member::Named(ident) = &field.member else {
                outcome = Err(self.report(Diagnostic::new("fields have names", place(&field.member))));
                continue;
            };
            if let Some(attribute) = field.attrs.first() {
                let diagnostic = Diagnostic::new("this attribute has no meaning in a scene", place(attribute));
                outcome = Err(self.report(diagnostic.hint("that a field is given up to scale is said by the problem")));
                continue;
            }
            let name = ident.to_string();
            let Some(at) = names.clone().position(|known| known == name) else {
                let message = format!("`{}` has no field `{name}`", expected.name);
                let diagnostic = Diagnostic::new(message, place(&field.member));
                outcome = Err(self.report(match closest(&name, names.clone()) {
                    Some(meant) => diagnostic.hint(format!("did you mean `{meant}`?")),
                    None => {
                        diagnostic.hint(format!("its fields are `{}`", names.clone().collect::<Vec<_>>().join("`, `")))
                    }
                }));
                continue;
            };
            if found[at].is_some() {
                let diagnostic = Diagnostic::new(format!("the field `{name}` is listed twice"), place(&field.member));
                outcome = Err(self.report(diagnostic));
                continue;
            }
            found[at] = Some(self.field(&field.expr, expected.fields[at]));
        }
        outcome?;
        let mut fields = Vec::new();
        for ((_, shape, _), found) in expected.fields.iter().zip(found) {
            match found {
                Some(elements) => fields.extend(elements?.into_iter().map(Some)),
                None => fields.resize(fields.len() + shape.iter().product::<usize>(), None),
            }
        }
        Ok(fields)
    }

    fn field(&mut self, expression: &Expr, (name, shape, is_complex): Field<'_>) -> Outcome<Vec<ExpressionId>> {
        let value = self.evaluate(expression)?;
        let (found, elements, found_complex) = self.real_elements(&value);
        // A real number is a complex one whose imaginary part is 0.
        let is_widened = is_complex && !found_complex && [&found[..], &[2]].concat() == shape;
        if is_widened {
            return Ok(elements.iter().flat_map(|re| [constant(re), ExpressionGraph::ZERO]).collect());
        }
        if found != shape || found_complex != is_complex {
            let words = |shape: &[usize], is_complex: bool| {
                let dimensions = &shape[..shape.len() - usize::from(is_complex)];
                let number = if is_complex { "a complex number" } else { "a number" };
                match dimensions.is_empty() {
                    true => number.to_owned(),
                    false if is_complex => format!("{} of complex numbers", describe(dimensions)),
                    false => describe(dimensions),
                }
            };
            let message = format!("`{name}` is {}", words(shape, is_complex));
            let diagnostic = Diagnostic::new(message, place(expression));
            return Err(self.report(diagnostic.label(format!("this is {}", words(&found, found_complex)))));
        }
        Ok(elements.iter().map(constant).collect())
    }
}

fn is_named(member: &Member, name: &str) -> bool {
    matches!(member, Member::Named(ident) if ident == name)
}
