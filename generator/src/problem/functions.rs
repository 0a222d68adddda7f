//! Calls: the built-in functions and the helpers of the file.

use syn::{Expr, ExprCall, FnArg, ItemFn, Pat, ReturnType};

use super::interpret::{Interpreter, WORK_OF_A_SCOPE};
use super::names::closest;
use super::scope::{Binding, Kind, Outcome, Reported};
use super::syntax::place;
use super::value::{Value, describe};
use crate::algebra::{Monomial, Polynomial};
use crate::expression::ExpressionId;
use crate::expression::rational::Rational;
use crate::problem::diagnostic::Diagnostic;

/// A function of the language.
pub(super) struct BuiltIn {
    /// Its name.
    pub(super) name: &'static str,
    /// How it is called.
    pub(super) usage: &'static str,
    /// Fewest and most arguments.
    arguments: (usize, usize),
}

/// The functions of the language.
pub(super) const BUILT_IN: [BuiltIn; 18] = [
    BuiltIn { name: "det", usage: "det(matrix)", arguments: (1, 1) },
    BuiltIn { name: "trace", usage: "trace(matrix)", arguments: (1, 1) },
    BuiltIn { name: "dot", usage: "dot(a, b)", arguments: (2, 2) },
    BuiltIn { name: "cross", usage: "cross(a, b)", arguments: (2, 2) },
    BuiltIn { name: "skew", usage: "skew(v)", arguments: (1, 1) },
    BuiltIn { name: "identity", usage: "identity(n)", arguments: (1, 1) },
    BuiltIn { name: "gradient", usage: "gradient(e)` or `gradient(e, [x, y])", arguments: (1, 2) },
    BuiltIn { name: "concat", usage: "concat(a, b)", arguments: (2, 2) },
    BuiltIn { name: "reshape", usage: "reshape(array, [rows, columns])", arguments: (2, 2) },
    BuiltIn { name: "solve", usage: "solve(a, b)", arguments: (2, 2) },
    BuiltIn { name: "inverse", usage: "inverse(matrix)", arguments: (1, 1) },
    BuiltIn { name: "null_space", usage: "null_space(matrix)", arguments: (1, 1) },
    BuiltIn { name: "least", usage: "least(keys, values)", arguments: (2, 2) },
    BuiltIn { name: "sqrt", usage: "sqrt(x)", arguments: (1, 1) },
    BuiltIn { name: "norm", usage: "norm(v)", arguments: (1, 1) },
    BuiltIn { name: "normalise", usage: "normalise(v)", arguments: (1, 1) },
    BuiltIn { name: "complex", usage: "complex(re, im)", arguments: (2, 2) },
    BuiltIn { name: "conj", usage: "conj(z)", arguments: (1, 1) },
];

/// Largest matrix whose determinant is expanded.
const MAX_DETERMINANT: usize = 10;

/// Deepest chain of helpers that call helpers.
const MAX_CALLS: usize = 32;

/// For the name of a well-known function that is not a polynomial: what to do instead.
pub(super) fn non_polynomial(name: &str) -> Option<&'static str> {
    Some(match name {
        "normalize" => "write `normalise(v)`: the vector holds data only",
        "cbrt" | "hypot" | "magnitude" | "abs" => {
            "introduce an unknown for it: `root.pow(2) == ..`; if it depends on data only, pass it as data"
        }
        "sin" | "cos" | "tan" | "asin" | "acos" | "atan" | "atan2" | "sin_cos" => {
            "introduce unknowns for sine and cosine with `s.pow(2) + c.pow(2) == 1;`; of data, pass them as data"
        }
        "powi" | "powf" => "a power with a constant integer exponent is written `.pow(2)`",
        "recip" => "write `1 / d` for data; for unknowns multiply the equation by it, and state `it != 0;`",
        "inv" | "try_inverse" => "write `inverse(matrix)`: the matrix holds data only",
        "min" | "argmin" | "min_by" => "of data, `least(keys, values)` is the value whose key is least",
        "exp" | "ln" | "log" | "log2" | "log10" | "max" | "signum" | "floor" | "ceil" | "round" => {
            "if it depends on data only, pass it as data"
        }
        _ => return None,
    })
}

impl Interpreter<'_> {
    /// The value of a call.
    pub(super) fn call(&mut self, call: &ExprCall) -> Outcome<Value> {
        let name = match &*call.func {
            Expr::Path(path) => path.path.get_ident().map(ToString::to_string),
            _ => None,
        };
        let Some(name) = name else {
            let diagnostic = Diagnostic::new("only functions can be called", place(&call.func));
            let is_complex = matches!(&*call.func, Expr::Path(path) if path.path.segments[0].ident == "Complex");
            return Err(self.report(diagnostic.label("not the name of a function").hint(match is_complex {
                true => "a complex number is written `complex(re, im)`",
                false => "a product needs `*`: `2 * (x + y)`",
            })));
        };
        let helper = self.helpers.get(&name).copied();
        let built_in = BUILT_IN.iter().find(|function| function.name == name);
        if helper.is_none() && built_in.is_none() {
            return Err(self.unknown_function(call, &name));
        }
        let arguments: Vec<&Expr> = call.args.iter().collect();
        let values: Vec<Outcome<Value>> = arguments.iter().map(|argument| self.evaluate(argument)).collect();
        let mut values: Vec<Value> = values.into_iter().collect::<Outcome<_>>()?;
        if self.is_in_field && built_in.is_none_or(|function| function.name != "gradient") {
            let operands = values.iter().zip(&arguments).map(|(value, at)| self.operand_in_field(value, at));
            values = operands.collect::<Outcome<_>>()?;
        }
        match (helper, built_in) {
            (Some(helper), _) => self.call_helper(call, helper, &arguments, values),
            (None, Some(function)) => self.call_built_in(call, function, &arguments, &values),
            (None, None) => Err(Reported),
        }
    }

    fn unknown_function(&mut self, call: &ExprCall, name: &str) -> Reported {
        let span = place(&call.func);
        if let Some(binding) = self.scopes.get(name) {
            let is_array = binding.value.as_ref().is_ok_and(|value| !value.shape().is_empty());
            let hint = match is_array {
                true => format!("a product needs `*`: `{name} * (..)`; an element is written `{name}[0]`"),
                false => format!("a product needs `*`: `{name} * (..)`"),
            };
            let diagnostic = Diagnostic::new(format!("`{name}` is not a function"), span);
            return self.report(diagnostic.label("this is a value").hint(hint));
        }
        if let Some(hint) = non_polynomial(name) {
            return self.report(Diagnostic::new(format!("`{name}` is not a polynomial"), span).hint(hint));
        }
        let names: Vec<&str> = BUILT_IN.iter().map(|function| function.name).collect();
        let helpers = self.helpers.keys().map(String::as_str);
        let mut diagnostic = Diagnostic::new(format!("unknown function `{name}`"), span);
        diagnostic = match closest(name, names.iter().copied().chain(helpers)) {
            Some(meant) => diagnostic.label("not found").hint(format!("did you mean `{meant}`?")),
            None => diagnostic
                .label("neither built in nor a helper in this file")
                .hint(format!("built in are `{}`", names.join("`, `"))),
        };
        self.report(diagnostic)
    }

    fn call_built_in(
        &mut self,
        call: &ExprCall,
        function: &BuiltIn,
        arguments: &[&Expr],
        values: &[Value],
    ) -> Outcome<Value> {
        let (fewest, most) = function.arguments;
        if !(fewest..=most).contains(&values.len()) {
            let counts = if fewest == most { format!("{fewest}") } else { format!("{fewest} or {most}") };
            let plural = if most == 1 { "" } else { "s" };
            let message = format!("`{}` takes {counts} argument{plural}, found {}", function.name, values.len());
            return Err(self.report(Diagnostic::new(message, place(call)).hint(format!("write `{}`", function.usage))));
        }
        match (function.name, values) {
            ("det", [matrix]) => {
                let n = self.square(function, arguments[0], matrix)?;
                if n > MAX_DETERMINANT {
                    let message = format!("the determinant of a {n}x{n} matrix is too large to be expanded");
                    let diagnostic = Diagnostic::new(message, place(arguments[0]));
                    let hint = "state instead that the matrix has a null vector: `m * v == 0;`";
                    return Err(self
                        .report(diagnostic.label(format!("at most {MAX_DETERMINANT}x{MAX_DETERMINANT}")).hint(hint)));
                }
                let result = self.algebra.determinant(matrix.elements(), n);
                self.check(result.map(Value::scalar), call)
            }
            ("trace", [matrix]) => self.trace(call, function, arguments[0], matrix),
            ("dot", [a, b]) => {
                let length = self.vector(function, arguments[0], a, None)?;
                self.vector(function, arguments[1], b, Some(length))?;
                let result = self.algebra.dot(a, b);
                self.check(result.map(Value::scalar), call)
            }
            ("cross", [a, b]) => {
                self.vector(function, arguments[0], a, Some(3))?;
                self.vector(function, arguments[1], b, Some(3))?;
                let matrix = self.skew(a);
                let result = self.algebra.multiply(&matrix, b);
                self.check(result, call)
            }
            ("skew", [v]) => {
                self.vector(function, arguments[0], v, Some(3))?;
                Ok(self.skew(v))
            }
            ("identity", [_]) => {
                let n = self.length(arguments[0])?;
                self.limit_elements(n * n, 2 * n * n, call)?;
                let one = self.algebra.constant(Rational::ONE);
                let entry = |at: usize| if at.is_multiple_of(n + 1) { one.clone() } else { Polynomial::ZERO };
                Ok(Value::array(vec![n, n], (0..n * n).map(entry).collect()))
            }
            ("concat", [a, b]) => self.concat(call, a, b),
            ("reshape", [array, _]) => self.reshape(call, arguments[1], array),
            ("solve", [a, b]) => self.solve(call, function, arguments, [a, b]),
            ("inverse", [matrix]) => self.inverse(call, function, arguments[0], matrix),
            ("null_space", [matrix]) => self.null_space(call, function, arguments[0], matrix),
            ("least", [keys, values]) => self.least(call, function, arguments, [keys, values]),
            ("sqrt", [x]) => self.square_root(call, function, arguments[0], x),
            ("norm", [v]) => self.norm(call, function, arguments[0], v),
            ("normalise", [v]) => self.normalise(call, function, arguments[0], v),
            ("complex", [re, im]) => self.complex(call, arguments, [re, im]),
            ("conj", [z]) => self.conjugate(call, z),
            ("gradient", [scalar, by @ ..]) => self.gradient(call, arguments, scalar, by.first()),
            _ => Err(Reported),
        }
    }

    /// The sum of the diagonal.
    fn trace(&mut self, call: &ExprCall, function: &BuiltIn, argument: &Expr, matrix: &Value) -> Outcome<Value> {
        let n = self.square(function, argument, matrix)?;
        let diagonal = matrix.elements().iter().step_by(n + 1).cloned().map(Value::scalar);
        let zero = Value::scalar(Polynomial::ZERO);
        let sum = diagonal.into_iter().try_fold(zero, |sum, entry| self.algebra.add(&sum, &entry));
        self.check(sum, call)
    }

    /// The same elements, row by row, in an array of another shape.
    fn reshape(&mut self, call: &ExprCall, shape: &Expr, array: &Value) -> Outcome<Value> {
        let Expr::Array(dimensions) = shape else {
            let diagnostic = Diagnostic::new("the new shape is a list of constant integers", place(shape));
            return Err(self.report(diagnostic.label("expected such as `[3, 3]`")));
        };
        let dimensions: Vec<usize> = dimensions.elems.iter().map(|n| self.length(n)).collect::<Outcome<_>>()?;
        let (elements, count) = (array.elements().len(), dimensions.iter().product::<usize>());
        if dimensions.is_empty() || count != elements {
            let message = format!("an array of {elements} elements cannot have this shape");
            let diagnostic = Diagnostic::new(message, place(shape)).label(format!("{count} elements"));
            return Err(self.report(diagnostic.context(place(&call.args[0]), describe(array.shape()))));
        }
        self.charge(array.weight(), call)?;
        Ok(Value::array(dimensions, array.elements().to_vec()))
    }

    /// The size of a square matrix.
    pub(super) fn square(&mut self, function: &BuiltIn, argument: &Expr, value: &Value) -> Outcome<usize> {
        match *value.shape() {
            [n, m] if n == m => Ok(n),
            _ => {
                let diagnostic = Diagnostic::new(format!("`{}` needs a square matrix", function.name), place(argument));
                Err(self.report(diagnostic.label(format!("this is {}", describe(value.shape())))))
            }
        }
    }

    /// The length of a vector, checked where one is expected.
    pub(super) fn vector(
        &mut self,
        function: &BuiltIn,
        argument: &Expr,
        value: &Value,
        want: Option<usize>,
    ) -> Outcome<usize> {
        match *value.shape() {
            [n] if want.is_none_or(|want| want == n) => Ok(n),
            _ => {
                let what = want.map_or("a vector".to_owned(), |n| format!("a vector of length {n}"));
                let diagnostic = Diagnostic::new(format!("`{}` needs {what} here", function.name), place(argument));
                Err(self.report(diagnostic.label(format!("this is {}", describe(value.shape())))))
            }
        }
    }

    /// The matrix S with S w = v x w, for a vector of length 3.
    fn skew(&mut self, v: &Value) -> Value {
        let negative = self.algebra.negate(v);
        let plus = |i: usize| v.elements()[i].clone();
        let minus = |i: usize| negative.elements()[i].clone();
        let zero = || Polynomial::ZERO;
        let rows = vec![zero(), minus(2), plus(1), plus(2), zero(), minus(0), minus(1), plus(0), zero()];
        Value::array(vec![3, 3], rows)
    }

    fn gradient(&mut self, call: &ExprCall, arguments: &[&Expr], value: &Value, by: Option<&Value>) -> Outcome<Value> {
        let Some(polynomial) = value.as_scalar() else {
            let diagnostic = Diagnostic::new("`gradient` needs a scalar", place(arguments[0]));
            return Err(self.report(diagnostic.label(format!("this is {}", describe(value.shape())))));
        };
        let (shape, unknowns) = match by {
            None => (vec![self.unknowns.len()], (0..self.unknowns.len()).collect()),
            Some(by) => {
                let unknowns = by.elements().iter().map(|element| self.algebra.as_unknown(element));
                let Some(unknowns) = unknowns.collect::<Option<Vec<_>>>() else {
                    let diagnostic = Diagnostic::new("derivatives are taken by unknowns only", place(arguments[1]));
                    return Err(self.report(
                        diagnostic
                            .label("not just unknowns")
                            .hint(format!("write `gradient(e, [{}])`", self.unknowns.join(", "))),
                    ));
                };
                (by.shape().to_vec(), unknowns)
            }
        };
        let graph = &self.algebra.graph;
        let is_of_solution = |&(_, coefficient): &(Monomial, ExpressionId)| graph.is_of_solution(coefficient);
        if polynomial.terms().iter().any(is_of_solution) {
            let diagnostic =
                Diagnostic::new("the derivative of what is computed from unknowns is not known", place(call));
            return Err(
                self.report(diagnostic.label("a quotient, a square root, or a sum that was passed to a helper"))
            );
        }
        let derivatives: Result<_, _> =
            unknowns.iter().map(|&unknown| self.algebra.derivative(polynomial, unknown)).collect();
        self.check(derivatives.map(|elements| Value::array(shape, elements)), call)
    }

    fn call_helper(
        &mut self,
        call: &ExprCall,
        helper: &ItemFn,
        arguments: &[&Expr],
        values: Vec<Value>,
    ) -> Outcome<Value> {
        let name = helper.sig.ident.to_string();
        if self.calls.iter().any(|(caller, _)| *caller == name) || self.calls.len() == MAX_CALLS {
            let message = match self.calls.len() {
                MAX_CALLS => format!("more than {MAX_CALLS} helpers call each other"),
                _ => format!("`{name}` calls itself"),
            };
            let diagnostic = Diagnostic::new(message, place(call)).label("this call would never end");
            return Err(self.report(diagnostic.hint("repeat with a `for` loop")));
        }
        if values.len() != helper.sig.inputs.len() {
            let (expected, found) = (helper.sig.inputs.len(), values.len());
            let plural = if expected == 1 { "" } else { "s" };
            let message = format!("`{name}` takes {expected} argument{plural}, found {found}");
            let declared = place(&helper.sig.ident);
            return Err(self.report(Diagnostic::new(message, place(call)).context(declared, "declared here")));
        }
        self.charge(WORK_OF_A_SCOPE * (1 + values.len()), call)?;
        self.calls.push((name, place(&call.func)));
        let caller = self.scopes.enter_function();
        let mut bound = Ok(());
        for ((parameter, value), argument) in helper.sig.inputs.iter().zip(values).zip(arguments) {
            bound = bound.and(self.bind_parameter(parameter, value, argument));
        }
        let value = bound.and_then(|()| self.block_value(&helper.block));
        let value = match (&helper.sig.output, value) {
            (ReturnType::Type(_, ty), Ok(value)) => self.shape_of_type(ty).and_then(|shape| {
                let result = shape.check(&value, self.algebra.is_complex_value(&value));
                self.check(result, ty).map(|()| value)
            }),
            (_, value) => value,
        };
        self.scopes.leave_function(caller);
        self.calls.pop();
        value
    }

    fn bind_parameter(&mut self, parameter: &FnArg, value: Value, argument: &Expr) -> Outcome<()> {
        let FnArg::Typed(parameter) = parameter else { return Err(Reported) };
        let Pat::Ident(name) = &*parameter.pat else { return Err(Reported) };
        let shape = self.shape_of_type(&parameter.ty)?;
        if let Err(diagnostic) = shape.check(&value, self.algebra.is_complex_value(&value)) {
            let declared = place(&*parameter.ty);
            // The caller is at fault: the message belongs to the argument.
            return Err(self.report(diagnostic.at(place(argument)).context(declared, "declared here")));
        }
        let binding =
            Binding { value: Ok(value), kind: Kind::Local(name.mutability.is_some()), span: place(&name.ident) };
        self.scopes.declare(name.ident.to_string(), binding);
        Ok(())
    }
}
