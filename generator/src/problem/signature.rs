//! Signatures: the data with their shapes and attributes, the unknowns, and the shapes that types
//! stand for.

use proc_macro2::Ident;
use syn::{Attribute, Expr, ExprLit, FnArg, GenericArgument, ItemFn, Lit, LitInt, Meta, Pat, PatType, PathArguments};
use syn::{ReturnType, Type, TypePath};

use super::functions::BUILT_IN;
use super::interpret::Interpreter;
use super::names::{closest, refuse};
use super::scope::{Outcome, Reported};
use super::syntax::place;
use super::unknown_shapes::{Shapes, UnknownShape};
use super::value::{Checked, MAX_ELEMENTS, Value, describe, fault};
use super::{DataAttribute, DataParameter, SolutionField, Span};
use crate::algebra::MAX_UNKNOWNS;
use crate::problem::diagnostic::Diagnostic;

/// Types of Rust that somebody may write by habit; none of them is the name of an unknown.
const PRIMITIVES: [&str; 17] = [
    "f64", "f32", "i8", "i16", "i32", "i64", "i128", "isize", "u8", "u16", "u32", "u64", "u128", "usize", "bool",
    "char", "str",
];

/// The attributes without an argument; `rank` has one.
const ATTRIBUTES: [(&str, DataAttribute); 5] = [
    ("symmetric", DataAttribute::Symmetric),
    ("rotation", DataAttribute::Rotation),
    ("unit", DataAttribute::Unit),
    ("plucker", DataAttribute::Plucker),
    ("integer", DataAttribute::Integer),
];

/// What a type says about the shape of a value.
pub(super) struct ShapePattern {
    /// Outermost dimension first.
    dimensions: Vec<usize>,
    /// Whether `_` stands in place of `f64`: any further dimensions.
    open: bool,
    /// Whether `Complex<f64>` does.
    complex: bool,
}

impl ShapePattern {
    /// Whether a value is one of those described.
    pub(super) fn check(&self, value: &Value, is_complex: bool) -> Checked<()> {
        let shape = value.shape();
        if is_complex && !self.complex && !self.open {
            let hint = "write `Complex<f64>` in place of `f64`, or take its part `.re` or `.im`";
            return Err(fault("the type says real").label("the value is complex").hint(hint));
        }
        let fits = if self.open { shape.starts_with(&self.dimensions) } else { shape == self.dimensions };
        if fits {
            return Ok(());
        }
        let mut expected = describe(&self.dimensions);
        if self.open {
            expected = expected.replace("f64", "_");
        }
        Err(fault(format!("the type says {expected}")).label(format!("the value is {}", describe(shape))))
    }
}

/// The names in a return type that lists unknowns, `(x, y)` or `x`; `None` for any other return
/// type.
pub(super) fn unknown_list(output: &ReturnType) -> Option<Vec<&Type>> {
    let ReturnType::Type(_, ty) = output else { return None };
    let mut ty = &**ty;
    while let Type::Paren(inner) = ty {
        ty = &inner.elem;
    }
    match ty {
        Type::Tuple(tuple) if tuple.elems.iter().any(|element| unknown_name(element).is_some()) => {
            Some(tuple.elems.iter().collect())
        }
        _ => unknown_name(ty).map(|_| vec![ty]),
    }
}

/// A type that is a plain name in lower case and no primitive type: an unknown.
fn unknown_name(ty: &Type) -> Option<&Ident> {
    plain_name(ty).filter(|ident| ident.to_string().starts_with(|c: char| c.is_lowercase() || c == '_'))
}

/// A type that is a plain name, in whatever case, and no primitive type.
fn plain_name(ty: &Type) -> Option<&Ident> {
    let Type::Path(path) = ty else { return None };
    let ident = path.path.get_ident().filter(|_| path.qself.is_none())?;
    (!PRIMITIVES.contains(&ident.to_string().as_str())).then_some(ident)
}

/// The message for what stands in place of the name of an unknown.
fn no_name(ty: &Type) -> Diagnostic {
    let span = place(ty);
    let primitive = match ty {
        Type::Path(path) => path.path.get_ident(),
        _ => None,
    };
    if let Some(primitive) = primitive {
        return Diagnostic::new(format!("`{primitive}` is a type, not the name of an unknown"), span)
            .label("choose another name")
            .hint("the return type lists unknowns by name: `-> (x, y)`, or `v: [f64; 3]` for an array of them");
    }
    if let Type::Infer(_) = ty {
        return Diagnostic::new("an unknown without a name", span)
            .label("choose a name")
            .hint("every unknown is a field of the solution");
    }
    Diagnostic::new("the return type lists unknowns by name", span)
        .label("expected a name")
        .hint("an array of unknowns has a name and a shape: `v: [f64; 3]`")
}

/// The lines of the doc comments, without the blank after `///`.
pub(super) fn doc_lines(attributes: &[Attribute]) -> Vec<String> {
    let mut lines = Vec::new();
    for attribute in attributes.iter().filter(|attribute| attribute.path().is_ident("doc")) {
        if let Meta::NameValue(pair) = &attribute.meta
            && let Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) = &pair.value
        {
            lines.extend(
                text.value().split('\n').map(|line| line.strip_prefix(' ').unwrap_or(line).trim_end().to_owned()),
            );
        }
    }
    lines
}

/// `Complex<f64>`, with any path before it.
fn is_complex(path: &TypePath) -> bool {
    let Some(last) = path.path.segments.last().filter(|last| last.ident == "Complex") else { return false };
    let PathArguments::AngleBracketed(arguments) = &last.arguments else { return false };
    let is_real = |argument: &GenericArgument| matches!(argument, GenericArgument::Type(Type::Path(real)) if real.path.is_ident("f64"));
    arguments.args.len() == 1 && arguments.args.iter().all(is_real)
}

/// Types of integers, which a count may be thought to need.
const INTEGERS: [&str; 6] = ["usize", "isize", "u32", "i32", "u64", "i64"];

impl Interpreter<'_> {
    /// The shape of a parameter or of unknowns: `Complex<f64>` is an array of two.
    fn scalars(pattern: &ShapePattern) -> Vec<usize> {
        let mut shape = pattern.dimensions.clone();
        shape.extend(pattern.complex.then_some(2));
        shape
    }

    /// The shape that a type stands for; `_` for any.
    pub(super) fn shape_of_type(&mut self, ty: &Type) -> Outcome<ShapePattern> {
        match ty {
            Type::Paren(inner) => self.shape_of_type(&inner.elem),
            Type::Infer(_) => Ok(ShapePattern { dimensions: Vec::new(), open: true, complex: false }),
            Type::Array(array) => {
                let length = self.length(&array.len);
                let mut pattern = self.shape_of_type(&array.elem)?;
                pattern.dimensions.insert(0, length?);
                let count = pattern.dimensions.iter().fold(1usize, |product, &n| product.saturating_mul(n));
                self.limit_elements(count, count, ty)?;
                Ok(pattern)
            }
            Type::Path(path) if path.path.is_ident("f64") => {
                Ok(ShapePattern { dimensions: Vec::new(), open: false, complex: false })
            }
            Type::Path(path) if is_complex(path) => {
                Ok(ShapePattern { dimensions: Vec::new(), open: false, complex: true })
            }
            _ => {
                let diagnostic = Diagnostic::new("this type is not part of the problem language", place(ty))
                    .label("expected `f64`, `[f64; n]`, `[[f64; n]; m]`, ..");
                Err(self.report(match ty {
                    Type::Reference(_) => diagnostic.hint("remove the `&`: data are passed by value"),
                    Type::Slice(_) => diagnostic.hint("give the number of elements: `[f64; 3]`"),
                    Type::Path(path) if INTEGERS.iter().any(|name| path.path.is_ident(name)) => diagnostic
                        .hint("data are `f64`, and marked if they are integers: `#[integer] n: f64`")
                        .hint("what counts loops or elements is a constant above the function: `const N: f64 = 3;`"),
                    Type::Path(path) if path.path.segments.iter().any(|s| s.ident.to_string().contains("omplex")) => {
                        diagnostic.hint("complex numbers are `Complex<f64>`")
                    }
                    Type::Path(_) => diagnostic.hint("numbers are `f64`; integers are marked `#[integer]`"),
                    _ => diagnostic,
                }))
            }
        }
    }

    /// The unknowns of a return type that lists them, with the shapes of those that have one.
    pub(super) fn read_unknowns(&mut self, types: &[&Type], shapes: &Shapes) -> Vec<SolutionField> {
        let mut unknowns: Vec<SolutionField> = Vec::new();
        for ty in types {
            let span = place(ty);
            let Some(ident) = plain_name(ty) else {
                self.report(no_name(ty));
                continue;
            };
            let name = ident.to_string();
            if let Some(first) = unknowns.iter().find(|unknown| unknown.name == name) {
                let diagnostic = Diagnostic::new(format!("the unknown `{name}` is listed twice"), span);
                self.report(diagnostic.label("again here").context(first.span.clone(), "first here"));
                continue;
            }
            if let Some(diagnostic) = refuse(ident, "an unknown").or_else(|| self.function_named(ident)) {
                self.report(diagnostic);
            }
            let Ok((pattern, is_projective)) = self.shape_beside(shapes.get(&span.start)) else { continue };
            let first_unknown = unknowns.last().map_or(0, |last| last.unknowns().end);
            let (shape, is_complex) = (Self::scalars(&pattern), pattern.complex);
            unknowns.push(SolutionField { name, shape, is_complex, is_projective, first_unknown, span });
        }
        // The equations of a vector that is given up to scale are read with all its coordinates.
        let count = unknowns.iter().map(SolutionField::scalars).sum::<usize>();
        let mut sum = 0;
        let is_too_much = |field: &SolutionField| {
            sum += field.scalars();
            sum > MAX_UNKNOWNS
        };
        if let Some(first) = unknowns.iter().position(is_too_much) {
            let message = format!("the problem has {count} unknowns, at most {MAX_UNKNOWNS} are allowed");
            let diagnostic = Diagnostic::new(message, unknowns[first].span.clone());
            let diagnostic = match unknowns[first].scalars() {
                1 => diagnostic.label("one too many"),
                elements => diagnostic.label(format!("{elements} of them")),
            };
            self.report(diagnostic.hint("eliminate unknowns by hand, or pass known quantities as parameters"));
            unknowns.truncate(first);
        }
        unknowns
    }

    /// The shape of an unknown, and whether it is given up to scale.
    fn shape_beside(&mut self, beside: Option<&UnknownShape>) -> Outcome<(ShapePattern, bool)> {
        let scalar = ShapePattern { dimensions: Vec::new(), open: false, complex: false };
        let Some(UnknownShape { ty, projective }) = beside else { return Ok((scalar, false)) };
        let pattern = ty.as_ref().map_or(Ok(scalar), |ty| self.shape_of_unknown(ty))?;
        let shape = &pattern.dimensions;
        match projective {
            Some(span) if pattern.complex => {
                let diagnostic = Diagnostic::new("only a real vector is given up to scale", span.clone());
                Err(self.report(diagnostic.label("this is complex").hint("state which of its elements is 1")))
            }
            Some(span) if shape.len() != 1 || shape[0] < 2 => {
                let diagnostic = Diagnostic::new("only a vector of two or more is given up to scale", span.clone());
                let found = if shape.is_empty() { "a scalar".to_owned() } else { describe(shape) };
                let diagnostic = diagnostic.label(format!("this is {found}"));
                Err(self.report(diagnostic.hint("write `#[projective] v: [f64; 3]`")))
            }
            _ => Ok((pattern, projective.is_some())),
        }
    }

    fn shape_of_unknown(&mut self, ty: &Type) -> Outcome<ShapePattern> {
        let pattern = self.shape_of_type(ty)?;
        if pattern.open {
            let diagnostic = Diagnostic::new("the shape of the unknowns must be given", place(ty));
            return Err(self.report(diagnostic.label("expected `[f64; n]`, `[[f64; n]; m]`, ..")));
        }
        Ok(pattern)
    }

    fn function_named(&self, ident: &Ident) -> Option<Diagnostic> {
        let name = ident.to_string();
        let what = if self.helpers.contains_key(&name) {
            "a helper in this file"
        } else if BUILT_IN.iter().any(|function| function.name == name) {
            "a function of the language"
        } else {
            return None;
        };
        let diagnostic = Diagnostic::new(format!("`{name}` is the name of a function"), place(ident));
        Some(diagnostic.label(format!("there is {what} of that name")).hint("choose another name"))
    }

    /// The data: the parameters of the problem function.
    pub(super) fn read_parameters(&mut self, function: &ItemFn, unknowns: &[SolutionField]) -> Vec<DataParameter> {
        let mut data: Vec<DataParameter> = Vec::new();
        for parameter in &function.sig.inputs {
            let Ok(mut parameter) = self.read_parameter(parameter) else { continue };
            let twice = data.iter().find(|other| other.name == parameter.name).map(|other| (&other.span, "first here"));
            let unknown = unknowns.iter().find(|unknown| unknown.name == parameter.name);
            if let Some((span, label)) = twice.or(unknown.map(|unknown| (&unknown.span, "the unknown"))) {
                let message = format!("`{}` is declared twice", parameter.name);
                let diagnostic = Diagnostic::new(message, parameter.span).label("a parameter");
                let diagnostic = diagnostic.context(span.clone(), label);
                self.report(diagnostic.hint("parameters are known, the names in the return type unknown"));
                continue;
            }
            parameter.first_input = data.last().map_or(0, |last| last.first_input + last.len());
            if parameter.first_input + parameter.len() > MAX_ELEMENTS {
                let diagnostic = Diagnostic::new("the problem has too many data", parameter.span);
                self.report(diagnostic.label(format!("at most {MAX_ELEMENTS} numbers are allowed")));
                continue;
            }
            data.push(parameter);
        }
        data
    }

    fn read_parameter(&mut self, parameter: &FnArg) -> Outcome<DataParameter> {
        let (typed, ident) = self.parameter_name(parameter)?;
        let pattern = self.shape_of_type(&typed.ty);
        let attribute = self.read_attribute(typed);
        let mean = self.read_mean(typed, pattern.as_ref().is_ok_and(|pattern| pattern.complex));
        if let Some(diagnostic) = refuse(ident, "a parameter") {
            return Err(self.report(diagnostic));
        }
        let pattern = pattern?;
        if pattern.open {
            let diagnostic = Diagnostic::new("the shape of the data must be given", place(&*typed.ty));
            return Err(self.report(diagnostic.label("expected `f64`, `[f64; n]`, `[[f64; n]; m]`, ..")));
        }
        let ((attribute, at), mean) = (attribute?, mean?);
        let (shape, is_complex) = (Self::scalars(&pattern), pattern.complex);
        let of_matrices = !matches!(attribute, DataAttribute::Generic | DataAttribute::Integer | DataAttribute::Unit);
        let expected = match (attribute, &shape[..]) {
            _ if is_complex && of_matrices => Some("real data"),
            (DataAttribute::Symmetric, [.., n, m]) if n == m => None,
            (DataAttribute::Symmetric, _) => Some("a square matrix, or an array of them"),
            (DataAttribute::Rotation, [.., 3, 3]) => None,
            (DataAttribute::Rotation, _) => Some("a 3x3 matrix, or an array of them"),
            (DataAttribute::Unit, [.., n]) if *n > 1 => None,
            (DataAttribute::Unit, _) => Some("a vector of two or more, or an array of them"),
            (DataAttribute::Plucker, [.., 2, 3]) => None,
            (DataAttribute::Plucker, _) => Some("two vectors of length 3, or an array of such pairs"),
            (DataAttribute::Rank(rank), [.., n, m]) if rank < *n.min(m) => None,
            (DataAttribute::Rank(_), _) => Some("a matrix of more rows and columns than its rank, or an array of them"),
            (DataAttribute::Integer | DataAttribute::Generic, _) => None,
        };
        if let Some(expected) = expected {
            let message = format!("the attribute needs {expected}");
            let found = if is_complex { "this is complex".to_owned() } else { format!("this is {}", describe(&shape)) };
            return Err(self.report(Diagnostic::new(message, at).context(place(&*typed.ty), found)));
        }
        let (name, span) = (ident.to_string(), place(ident));
        Ok(DataParameter { name, shape, is_complex, attribute, mean, first_input: 0, span })
    }

    /// A parameter of the form `name: type`.
    fn parameter_name<'p>(&mut self, parameter: &'p FnArg) -> Outcome<(&'p PatType, &'p Ident)> {
        if let FnArg::Typed(typed) = parameter
            && let Pat::Ident(name) = &*typed.pat
            && name.by_ref.is_none()
            && name.subpat.is_none()
        {
            return Ok((typed, &name.ident));
        }
        let diagnostic = Diagnostic::new("parameters are written `name: type`", place(parameter));
        Err(self.report(diagnostic.label("expected such as `points: [[f64; 2]; 5]`")))
    }

    /// Checks the form of the parameters of a helper, whose shapes are known only when it is
    /// called.
    pub(super) fn check_helper_parameters(&mut self, function: &ItemFn) -> Outcome<()> {
        let mut outcome = Ok(());
        for parameter in &function.sig.inputs {
            let Ok((typed, _)) = self.parameter_name(parameter) else {
                outcome = Err(Reported);
                continue;
            };
            if let Some(attribute) = typed.attrs.iter().find(|attribute| !attribute.path().is_ident("doc")) {
                let diagnostic = Diagnostic::new("a helper's parameters have no attributes", place(attribute));
                outcome = Err(self.report(diagnostic.hint("attributes describe the data of the problem function")));
            }
        }
        outcome
    }

    /// What the data of a parameter satisfy, and where it says so.
    fn read_attribute(&mut self, parameter: &PatType) -> Outcome<(DataAttribute, Span)> {
        let mut found: Option<(DataAttribute, Span)> = None;
        let is_other = |attribute: &&Attribute| ["doc", "mean"].iter().any(|name| attribute.path().is_ident(name));
        for attribute in parameter.attrs.iter().filter(|attribute| !is_other(attribute)) {
            let span = place(attribute);
            let kind = self.attribute_kind(attribute)?;
            if let Some((_, first)) = found {
                let diagnostic = Diagnostic::new("a parameter can have one attribute", span);
                return Err(self.report(diagnostic.label("the second").context(first, "the first")));
            }
            found = Some((kind, span));
        }
        Ok(found.unwrap_or((DataAttribute::Generic, 0..0)))
    }

    fn attribute_kind(&mut self, attribute: &Attribute) -> Outcome<DataAttribute> {
        let name = attribute.path().get_ident().map(ToString::to_string).unwrap_or_default();
        if name == "rank" {
            let argument = match &attribute.meta {
                Meta::List(list) => list.parse_args::<LitInt>().and_then(|integer| integer.base10_parse()).ok(),
                _ => None,
            };
            return match argument {
                Some(rank) if rank > 0 => Ok(DataAttribute::Rank(rank)),
                _ => {
                    let diagnostic = Diagnostic::new("`rank` needs a positive integer", place(&attribute.meta));
                    Err(self.report(diagnostic.label("expected such as `rank(2)`")))
                }
            };
        }
        let known = ATTRIBUTES.iter().find(|(known, _)| *known == name);
        if let Some(&(_, kind)) = known.filter(|_| matches!(attribute.meta, Meta::Path(_))) {
            return Ok(kind);
        }
        let diagnostic = Diagnostic::new("unknown attribute", place(&attribute.meta))
            .label("expected `symmetric`, `rotation`, `unit`, `plucker`, `integer`, `rank(..)` or `mean(..)`");
        let meant = closest(&name, ATTRIBUTES.map(|(known, _)| known));
        Err(self.report(match meant {
            Some(meant) => diagnostic.hint(format!("did you mean `#[{meant}]`?")),
            None => diagnostic,
        }))
    }
}
