//! Text to [`Problem`]: the functions of a file, and the checks on the problem as a whole.

use std::collections::BTreeMap;

use syn::{Attribute, Ident, Item, ItemConst, ItemFn, Meta, ReturnType, Safety, Visibility};

use super::complex::joined;
use super::functions::BUILT_IN;
use super::interpret::Interpreter;
use super::names::{refuse, refuse_module};
use super::output::Output;
use super::projective::{Elements, check_homogeneous, dehomogenised, homogeneous};
use super::results::check_even;
use super::scaling::{Stated, scalings};
use super::scene::Scene;
use super::scene_function::{ATTRIBUTE, is_scene};
use super::scope::{Binding, Kind, Outcome, Reported};
use super::signature::{doc_lines, unknown_list};
use super::syntax::{parse_file, place};
use super::value::Value;
use super::{DataParameter, MeanOf, Measurement, Problem, Scaling, SolutionField, SourceFile, Span};
use crate::algebra::{Monomial, Polynomial};
use crate::expression::{ExpressionGraph, ExpressionId, SymbolicPolynomial};
use crate::problem::diagnostic::{Diagnostic, Diagnostics};
use crate::problem::instance::fingerprint_points;

/// Stack of the thread that parses, so that the longest expression allowed fits whatever the
/// caller's stack is.
const STACK: usize = 256 << 20;

impl Problem {
    /// Reads a problem from the text of its file. `path` is shown in messages.
    ///
    /// # Errors
    /// All mistakes in the file, in order of place; of more than a hundred the first. A text that
    /// takes more than two million steps to read is refused.
    pub fn parse(path: &str, text: &str) -> Result<Self, Diagnostics> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let source = SourceFile { path: path.to_owned(), text: text.to_owned() };
        let parsed = std::thread::scope(|scope| {
            let thread = std::thread::Builder::new().stack_size(STACK).spawn_scoped(scope, || parse_source(&source));
            match thread.map(std::thread::ScopedJoinHandle::join) {
                Ok(Ok(parsed)) => parsed,
                Ok(Err(panic)) => std::panic::resume_unwind(panic),
                Err(error) => Err(vec![Diagnostic::new(format!("cannot start a thread to parse in: {error}"), 0..0)]),
            }
        });
        parsed.map_err(|messages| Diagnostics::new(source, messages))
    }
}

/// The items of a file.
#[derive(Default)]
struct Items<'a> {
    constants: Vec<&'a ItemConst>,
    helpers: BTreeMap<String, &'a ItemFn>,
    problem: Option<&'a ItemFn>,
    scene: Option<&'a ItemFn>,
}

fn parse_source(source: &SourceFile) -> Result<Problem, Vec<Diagnostic>> {
    let (file, shapes) = parse_file(&source.text).map_err(|diagnostic| vec![diagnostic])?;
    let (items, messages) = sort_items(&file.items);
    let Some(function) = items.problem.filter(|_| messages.is_empty()) else { return Err(messages) };

    // Shapes may use constants, and coefficients need the data: constants are evaluated once for
    // each.
    let mut signature = Interpreter::new(ExpressionGraph::new(&[vec![], vec![]]), &items.helpers);
    declare_constants(&mut signature, &items.constants);
    let types = unknown_list(&function.sig.output).unwrap_or_default();
    let unknowns = signature.read_unknowns(&types, &shapes);
    let data = signature.read_parameters(function, &unknowns);
    for helper in items.helpers.values().filter(|helper| !is_scene(helper)) {
        // Its own failure is among the messages.
        let _ = signature.check_helper_parameters(helper);
    }
    let messages = signature.into_messages();
    if !messages.is_empty() {
        return Err(messages);
    }
    let measurements = read_measurements(&items, &data)?;

    let mut body = run(&items, function, (&data, &unknowns), Elements::InChart);
    compute_results(&mut body, |graph| {
        let mut results = Interpreter::new(graph, &items.helpers);
        declare_constants(&mut results, &items.constants);
        results.is_in_field = true;
        run_body(&mut results, function, (&data, &unknowns), Elements::InChart);
        results
    });
    enter_charts(&mut body, &unknowns);
    check_counts(&mut body, function, &unknowns);
    check_data(&mut body, &data);
    if body.has_messages() {
        return Err(body.into_messages());
    }
    let scalings = scalings_of(&body, &unknowns, || run(&items, function, (&data, &unknowns), Elements::Themselves));
    let mut problem = Problem {
        name: function.sig.ident.to_string(),
        docs: doc_lines(&function.attrs),
        data,
        measurements,
        unknowns: body.unknowns,
        fields: unknowns,
        equations: body.equations,
        nonzero: body.nonzero,
        positive: body.positive,
        output: body.output,
        scene: None,
        scalings,
        graph: body.algebra.graph,
        source: source.clone(),
        span: place_of_output(&function.sig.output),
    };
    problem.scene = items.scene.map(|scene| read_scene(&items, scene, &problem)).transpose()?;
    Ok(problem)
}

fn read_scene(items: &Items<'_>, function: &ItemFn, problem: &Problem) -> Result<Scene, Vec<Diagnostic>> {
    let mut signature = Interpreter::new(ExpressionGraph::new(&[vec![], vec![]]), &items.helpers);
    declare_constants(&mut signature, &items.constants);
    let drawn = signature.read_parameters(function, &[]);
    for parameter in drawn.iter().filter(|parameter| parameter.mean.is_some()) {
        let diagnostic = Diagnostic::new("what a scene draws is no mean", parameter.span.clone());
        signature.report(diagnostic.hint("draw the measurements, and add what they give"));
    }
    if signature.has_messages() {
        return Err(signature.into_messages());
    }
    let mut body = Interpreter::new(ExpressionGraph::new(&fingerprint_points(&drawn)), &items.helpers);
    body.data.clone_from(&drawn);
    body.is_scene = true;
    declare_constants(&mut body, &items.constants);
    body.scopes.enter();
    declare_signature((&mut body, Elements::InChart), &drawn, &[]);
    let scene = body.run_scene(function, &drawn, problem);
    let scene = if body.has_messages() { Err(Reported) } else { scene };
    scene.map_err(|Reported| body.into_messages())
}

/// Runs the statements of a problem.
fn run<'a>(
    items: &'a Items<'_>,
    function: &ItemFn,
    (data, unknowns): (&[DataParameter], &[SolutionField]),
    elements: Elements,
) -> Interpreter<'a> {
    let mut body = Interpreter::new(ExpressionGraph::new(&fingerprint_points(data)), &items.helpers);
    declare_constants(&mut body, &items.constants);
    run_body(&mut body, function, (data, unknowns), elements);
    body
}

fn run_body(
    body: &mut Interpreter<'_>,
    function: &ItemFn,
    (data, unknowns): (&[DataParameter], &[SolutionField]),
    elements: Elements,
) {
    body.data = data.to_vec();
    body.scopes.enter();
    declare_signature((body, elements), data, unknowns);
    body.run_block(&function.block);
}

/// Runs the body once more for results alone, with all that is multiplied on the way to them as a
/// value: what stands before the struct was expanded for the equations. Where that fails, as for
/// the derivative of a product, results stay polynomials of what stands before.
fn compute_results<'a>(body: &mut Interpreter<'a>, again: impl FnOnce(ExpressionGraph) -> Interpreter<'a>) {
    if body.output.is_none() || body.has_messages() {
        return;
    }
    let results = again(body.algebra.graph.without_solution());
    if !results.has_messages() {
        body.output = results.output;
        body.algebra.graph = results.algebra.graph;
    }
}

/// The measurements that the data name, each once.
fn read_measurements(items: &Items<'_>, data: &[DataParameter]) -> Result<Vec<Measurement>, Vec<Diagnostic>> {
    let mut read: Vec<Measurement> = Vec::new();
    let mut messages = Vec::new();
    for parameter in data {
        let Some(of) = &parameter.mean else { continue };
        if read.iter().any(|known| known.name == of.function && known.shape == parameter.shape) {
            continue;
        }
        match read_measurement(items, of, &parameter.shape) {
            Ok(measurement) => read.extend(measurement),
            Err(own) => messages.extend(own),
        }
    }
    if messages.is_empty() { Ok(read) } else { Err(messages) }
}

fn read_measurement(items: &Items<'_>, of: &MeanOf, shape: &[usize]) -> Result<Option<Measurement>, Vec<Diagnostic>> {
    let Some(&function) = items.helpers.get(&of.function) else { return Ok(None) };
    let mut signature = Interpreter::new(ExpressionGraph::new(&[vec![], vec![]]), &items.helpers);
    declare_constants(&mut signature, &items.constants);
    let data = signature.read_parameters(function, &[]);
    if let Some(complex) = data.iter().find(|parameter| parameter.is_complex) {
        let diagnostic = Diagnostic::new("a measurement is real", complex.span.clone());
        signature.report(diagnostic.label("this is complex").hint("pass real and imaginary parts by themselves"));
    }
    if function.sig.inputs.is_empty() {
        let diagnostic = Diagnostic::new("a measurement has parameters", place(&function.sig.ident));
        signature.report(diagnostic.label("this has none"));
    }
    if signature.has_messages() {
        return Err(signature.into_messages());
    }
    let mut body = Interpreter::new(ExpressionGraph::new(&fingerprint_points(&data)), &items.helpers);
    body.data.clone_from(&data);
    declare_constants(&mut body, &items.constants);
    body.scopes.enter();
    declare_signature((&mut body, Elements::InChart), &data, &[]);
    // As a helper it states nothing, and does not call itself.
    body.calls.push((of.function.clone(), of.span.clone()));
    let elements = body.measured(function, shape);
    body.calls.pop();
    let elements: Outcome<_> = if body.has_messages() { Err(Reported) } else { elements };
    let Ok(elements) = elements else { return Err(body.into_messages()) };
    Ok(Some(Measurement {
        name: of.function.clone(),
        docs: doc_lines(&function.attrs),
        data,
        shape: shape.to_vec(),
        graph: body.algebra.graph,
        elements,
    }))
}

/// The scalings of a problem: by its statements in the unknowns, or, where vectors are given up to
/// scale, by those in the `elements` of these.
fn scalings_of<'a>(
    body: &Interpreter<'a>,
    unknowns: &[SolutionField],
    elements: impl FnOnce() -> Interpreter<'a>,
) -> Vec<Scaling> {
    let vectors = unknowns.iter().filter(|field| field.is_projective).count();
    let homogeneous = (vectors > 0).then(elements);
    let stating = homogeneous.as_ref().unwrap_or(body);
    if stating.has_messages() {
        return Vec::new();
    }
    let statements = stating.equations.iter().chain(&stating.nonzero).chain(&stating.positive);
    scalings(&Stated {
        data: &stating.data,
        graph: &stating.algebra.graph,
        polynomials: statements.map(|statement| &statement.polynomial).collect(),
        unknowns: body.unknowns.len(),
        vectors,
    })
}

/// Tells the problem function, the one whose return type lists unknowns, from the helpers.
fn sort_items(items: &[Item]) -> (Items<'_>, Vec<Diagnostic>) {
    let mut sorted = Items::default();
    let mut messages = Vec::new();
    for item in items {
        match item {
            Item::Const(constant) => sorted.constants.push(constant),
            Item::Fn(function) => {
                messages.extend(check_function(function));
                let name = function.sig.ident.to_string();
                if unknown_list(&function.sig.output).is_none() {
                    messages.extend(refuse_built_in(&function.sig.ident));
                    if is_scene(function)
                        && let Some(first) = sorted.scene.replace(function)
                    {
                        let diagnostic = Diagnostic::new("a file has one scene", place(&function.sig.ident));
                        messages.push(diagnostic.label("the second").context(place(&first.sig.ident), "the first"));
                    }
                    if let Some(first) = sorted.helpers.insert(name.clone(), function) {
                        let diagnostic =
                            Diagnostic::new(format!("there are two helpers `{name}`"), place(&function.sig.ident));
                        messages.push(diagnostic.label("again here").context(place(&first.sig.ident), "first here"));
                    }
                } else if let Some(first) = sorted.problem {
                    messages.push(
                        Diagnostic::new("a file states one problem", place_of_output(&function.sig.output))
                            .label("a second return type that lists unknowns")
                            .context(place_of_output(&first.sig.output), "the first")
                            .hint("move it to a file of its own"),
                    );
                } else {
                    messages.extend(refuse_module(&function.sig.ident));
                    sorted.problem = Some(function);
                }
            }
            _ => messages.push(
                Diagnostic::new("a problem file has functions and constants only", place(item))
                    .label("expected `fn` or `const`"),
            ),
        }
    }
    if sorted.problem.is_none() && messages.is_empty() {
        messages.push(missing_problem(sorted.helpers.values().next().copied()));
    }
    (sorted, messages)
}

fn missing_problem(helper: Option<&ItemFn>) -> Diagnostic {
    let hint = "list the unknowns as return type: `fn two_circles(a: f64) -> (x, y) { x * x + y * y == a; .. }`";
    let Some(helper) = helper else {
        return Diagnostic::new("the file states no problem", 0..0).label("expected a function").hint(hint);
    };
    let span = match &helper.sig.output {
        ReturnType::Default => place(&helper.sig.ident),
        output => place_of_output(output),
    };
    Diagnostic::new("no function of the file has unknowns", span)
        .label("expected a list of lower-case names such as `-> (x, y)`")
        .hint(hint)
}

/// The place of a return type, without the arrow.
fn place_of_output(output: &ReturnType) -> Span {
    match output {
        ReturnType::Default => place(output),
        ReturnType::Type(_, ty) => place(&**ty),
    }
}

/// A helper may not hide a function of the language. Nobody calls a problem.
fn refuse_built_in(name: &Ident) -> Option<Diagnostic> {
    BUILT_IN.iter().find(|built_in| name == built_in.name).map(|built_in| {
        let message = format!("`{}` is a function of the language", built_in.name);
        Diagnostic::new(message, place(name)).label("choose another name")
    })
}

/// The form of a function: a plain `fn name(parameters) -> result`.
fn check_function(function: &ItemFn) -> Vec<Diagnostic> {
    let signature = &function.sig;
    let mut messages = Vec::new();
    messages.extend(refuse(&signature.ident, "a function"));
    let plain = signature.constness.is_none()
        && signature.asyncness.is_none()
        && matches!(signature.safety, Safety::Default)
        && signature.abi.is_none()
        && signature.variadic.is_none()
        && signature.generics.params.is_empty()
        && signature.generics.where_clause.is_none()
        && !matches!(function.vis, Visibility::Restricted(_));
    if !plain {
        let diagnostic = Diagnostic::new("this kind of function is not supported", place(signature));
        messages.push(diagnostic.label("expected a plain `fn name(parameters) -> result`"));
    }
    let known = |attribute: &&Attribute| {
        let may_be_scene = unknown_list(&signature.output).is_none() && matches!(attribute.meta, Meta::Path(_));
        let is_named = |name: &str| attribute.path().segments.first().is_some_and(|segment| segment.ident == name);
        let is_of_rust = ["doc", "allow", "expect", "rustfmt"].iter().any(|&name| is_named(name));
        !(is_of_rust || may_be_scene && attribute.path().is_ident(ATTRIBUTE))
    };
    for attribute in function.attrs.iter().filter(known) {
        let diagnostic = Diagnostic::new("unknown attribute of a function", place(attribute));
        messages.push(
            diagnostic
                .hint("`#[symmetric]`, `#[rotation]`, `#[unit]`, `#[plucker]`, `#[integer]`, `#[rank(2)]`, `#[mean(f)]` stand before a parameter; `#[scene]` before a function that returns `Data`"),
        );
    }
    messages
}

/// Evaluates the constants of the file in order.
fn declare_constants(interpreter: &mut Interpreter<'_>, constants: &[&ItemConst]) {
    for constant in constants {
        let value = interpreter.evaluate(&constant.expr);
        let span = place(&constant.ident);
        interpreter.scopes.declare(constant.ident.to_string(), Binding { value, kind: Kind::Constant, span });
    }
}

/// Declares the data and the unknowns in the scope of the body.
fn declare_signature(
    (interpreter, elements): (&mut Interpreter<'_>, Elements),
    data: &[DataParameter],
    unknowns: &[SolutionField],
) {
    for parameter in data {
        let inputs = parameter.first_input..parameter.first_input + parameter.len();
        let algebra = &interpreter.algebra;
        let elements = inputs.map(|input| algebra.data(algebra.graph.input(input))).collect();
        let value = Ok(value_of((&parameter.shape, parameter.is_complex), elements));
        let binding = Binding { value, kind: Kind::Data, span: parameter.span.clone() };
        interpreter.scopes.declare(parameter.name.clone(), binding);
    }
    interpreter.unknowns = unknowns.iter().flat_map(|field| field.names()[..field.unknowns().len()].to_vec()).collect();
    let complex = data.iter().filter(|parameter| parameter.is_complex).map(|parameter| &parameter.span);
    let mut complex = complex.chain(unknowns.iter().filter(|field| field.is_complex).map(|field| &field.span));
    // Constants may be complex, too.
    let of_constants = || unknowns.last().filter(|_| interpreter.algebra.has_imaginary_unit).map(|last| &last.span);
    if let Some(first) = complex.next().or_else(of_constants) {
        // Its own failure is among the messages.
        let _ = interpreter.enter_complex_numbers(first.clone());
    }
    for field in unknowns {
        let polynomial = |unknown| -> Polynomial<ExpressionId> {
            Polynomial::from_terms(vec![(Monomial::unknown(unknown), ExpressionGraph::ONE)])
        };
        let values = if field.is_projective {
            let scale = interpreter.unknowns.len();
            interpreter.unknowns.extend(field.names().pop());
            homogeneous((&mut interpreter.algebra, elements), field, scale)
        } else {
            field.unknowns().map(polynomial).collect()
        };
        let value = Ok(value_of((&field.shape, field.is_complex), values));
        let binding = Binding { value, kind: Kind::Unknown, span: field.span.clone() };
        interpreter.scopes.declare(field.name.clone(), binding);
    }
}

/// The value of data or unknowns, from its scalars.
fn value_of((shape, is_complex): (&[usize], bool), scalars: Vec<SymbolicPolynomial>) -> Value {
    match shape {
        [dimensions @ .., _] if is_complex => Value::array(dimensions.to_vec(), joined(&scalars)),
        _ => Value::array(shape.to_vec(), scalars),
    }
}

/// Sets the last coordinate of each vector that is given up to scale to 1. All statements must be
/// homogeneous in the vector.
fn enter_charts(body: &mut Interpreter<'_>, unknowns: &[SolutionField]) {
    let first = unknowns.last().map_or(0, |last| last.unknowns().end);
    let mut messages = Vec::new();
    for (at, field) in unknowns.iter().filter(|field| field.is_projective).enumerate() {
        let statements = body.equations.iter().chain(&body.nonzero).chain(&body.positive);
        messages.extend(statements.filter_map(|statement| check_homogeneous(statement, field, first + at).err()));
    }
    for (at, field) in unknowns.iter().filter(|field| field.is_projective).enumerate() {
        let own: Vec<usize> = field.unknowns().chain([first + at]).collect();
        messages.extend(body.positive.iter().filter_map(|statement| check_even(statement, &own, &field.name).err()));
    }
    body.unknowns.truncate(first);
    if messages.is_empty() {
        for statement in body.equations.iter_mut().chain(&mut body.nonzero).chain(&mut body.positive) {
            statement.polynomial = dehomogenised(&statement.polynomial, first);
        }
    }
    for message in messages {
        body.report(message);
    }
}

/// Every parameter must be read: by a coefficient of some equation or exclusion, at least one of
/// its elements.
fn check_data(body: &mut Interpreter<'_>, data: &[DataParameter]) {
    if body.has_messages() {
        // The statements that read it may have failed.
        return;
    }
    let statements = body.equations.iter().chain(&body.nonzero).chain(&body.positive);
    let coefficients = statements.flat_map(|s| s.polynomial.terms()).map(|&(_, coefficient)| coefficient);
    let of_output = body.output.iter().flat_map(Output::elements);
    let coefficients: Vec<ExpressionId> = coefficients.chain(of_output).collect();
    let needed = body.algebra.graph.needed_by_way_of_derivations(&coefficients, |_| true);
    let is_read = |input: usize| needed[body.algebra.graph.input(input).index()];
    let is_unused =
        |parameter: &&DataParameter| !(parameter.first_input..parameter.first_input + parameter.len()).any(is_read);
    let unused: Vec<&DataParameter> = data.iter().filter(is_unused).collect();
    for parameter in unused {
        let message = format!("no equation depends on the parameter `{}`", parameter.name);
        let diagnostic = Diagnostic::new(message, parameter.span.clone()).label("its values make no difference");
        body.report(diagnostic.hint("remove it, or state the equation that it is for"));
    }
}

/// Every unknown must occur, and there must be as many equations as unknowns.
fn check_counts(body: &mut Interpreter<'_>, function: &ItemFn, unknowns: &[SolutionField]) {
    if body.has_messages() {
        // Statements that failed may be the ones that are missing.
        return;
    }
    let occurs = |index: usize| {
        let mut monomials = body.equations.iter().flat_map(|equation| equation.polynomial.monomials());
        monomials.any(|monomial| monomial.exponent(index) > 0)
    };
    let missing = |field: &SolutionField| -> Vec<String> {
        field.unknowns().zip(field.names()).filter(|&(index, _)| !occurs(index)).map(|(_, name)| name).collect()
    };
    let missing: Vec<(&SolutionField, Vec<String>)> = unknowns.iter().map(|field| (field, missing(field))).collect();
    for (field, names) in missing.iter().filter(|(_, names)| !names.is_empty()) {
        let message = match &names[..] {
            [name] => format!("the unknown `{name}` occurs in no equation"),
            names => format!("the unknowns `{}` occur in no equation", names.join("`, `")),
        };
        body.report(
            Diagnostic::new(message, field.span.clone())
                .label("any value would solve the problem")
                .hint("remove it, or state what determines it"),
        );
    }
    let (equations, count) = (body.equations.len(), body.unknowns.len());
    if missing.iter().all(|(_, names)| names.is_empty()) && equations < count {
        let plural = if equations == 1 { "" } else { "s" };
        let message = format!("{equations} equation{plural} cannot determine {count} unknowns");
        let mut diagnostic = Diagnostic::new(message, place_of_output(&function.sig.output))
            .label(format!("{count} unknowns"))
            .hint("state what else must hold, or pass known quantities as parameters");
        if body.repeated > 0 {
            let repeated = body.repeated;
            diagnostic = diagnostic.hint(format!("{repeated} more are stated, equal to others up to their sign"));
        }
        body.report(diagnostic);
    }
}
