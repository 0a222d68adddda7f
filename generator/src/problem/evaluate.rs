//! Expressions: polynomials and arrays of them.

use syn::{BinOp, Expr, ExprBinary, ExprField, ExprIndex, ExprMethodCall, ExprUnary, Lit, Member, UnOp};

use super::Span;
use super::functions::{BUILT_IN, non_polynomial};
use super::interpret::Interpreter;
use super::names::closest;
use super::scope::{Outcome, Reported};
use super::syntax::place;
use super::value::{MAX_DEGREE, MAX_ELEMENTS, Value, describe, fault};
use crate::expression::rational::Rational;
use crate::problem::diagnostic::Diagnostic;

/// Deepest nesting of expressions, calls of helpers included.
const MAX_DEPTH: usize = 2000;

impl Interpreter<'_> {
    /// The value of an expression.
    pub(super) fn evaluate(&mut self, expression: &Expr) -> Outcome<Value> {
        self.charge(1, expression)?;
        if self.depth == MAX_DEPTH {
            self.algebra.exhaust();
            return Err(self.report(Diagnostic::new("the expression is nested too deeply", place(expression))));
        }
        self.depth += 1;
        let value = match expression {
            Expr::Paren(inner) => self.evaluate(&inner.expr),
            Expr::Group(inner) => self.evaluate(&inner.expr),
            Expr::Lit(literal) => self.literal(&literal.lit),
            Expr::Path(path) => self.name(path),
            Expr::Array(array) => self.array(expression, array.elems.iter()),
            Expr::Repeat(repeat) => self.repeat(expression, &repeat.expr, &repeat.len),
            Expr::Index(index) => self.index(index),
            Expr::Unary(unary) => self.unary(unary),
            Expr::Binary(binary) => self.binary(binary),
            Expr::Call(call) => self.call(call),
            Expr::MethodCall(call) => self.method(call),
            Expr::Field(field) if is_part(field) => self.part_of(field),
            Expr::Block(block) if block.label.is_none() => self.block_value(&block.block),
            Expr::If(stated) => self.if_value(stated),
            _ => Err(self.unsupported(expression)),
        };
        self.depth -= 1;
        value
    }

    /// An integer as a value.
    pub(super) fn integer(&mut self, value: i64) -> Value {
        Value::scalar(self.algebra.constant(Rational::integer(value)))
    }

    /// The value of an expression that must be a constant integer.
    pub(super) fn index_value(&mut self, expression: &Expr) -> Outcome<i64> {
        let value = self.evaluate(expression)?;
        let constant = value.as_scalar().and_then(|polynomial| self.algebra.as_constant(polynomial));
        let label = match constant {
            Some(constant) if constant.denominator() == 1 => return Ok(constant.numerator()),
            Some(constant) => format!("this is {constant}"),
            None if value.shape().is_empty() => "this depends on unknowns or data".to_owned(),
            None => format!("this is {}", describe(value.shape())),
        };
        Err(self.report(Diagnostic::new("expected a constant integer", place(expression)).label(label)))
    }

    fn literal(&mut self, literal: &Lit) -> Outcome<Value> {
        let (digits, suffix) = match literal {
            Lit::Int(integer) => (integer.base10_digits().to_owned(), integer.suffix()),
            Lit::Float(float) => (float.base10_digits().to_owned(), float.suffix()),
            _ => return Err(self.report(Diagnostic::new("only numbers are constants here", place(literal)))),
        };
        if !matches!(suffix, "" | "f64") {
            let diagnostic = Diagnostic::new("a product needs `*`", place(literal));
            return Err(self.report(
                diagnostic
                    .label("a number with a suffix")
                    .hint(format!("write `{digits} * {}`", suffix.trim_matches('_'))),
            ));
        }
        // `2e1` is twenty, unless somebody has an unknown `e1` in mind.
        if let Some(at) = digits.find(['e', 'E'])
            && self.scopes.get(&digits[at..]).is_some()
        {
            let (factor, name) = digits.split_at(at);
            let diagnostic = Diagnostic::new(format!("`{digits}` is a number, not a product"), place(literal));
            return Err(self.report(diagnostic.label(format!("{factor} times ten to the {}", &name[1..])).hint(
                format!("for the product with `{name}` write `{factor} * {name}`; for the number, all digits"),
            )));
        }
        let Some(value) = parse_decimal(&digits) else {
            let diagnostic = Diagnostic::new("the number is out of range", place(literal));
            return Err(self.report(diagnostic.label("it is no fraction of two 64-bit integers")));
        };
        Ok(Value::scalar(self.algebra.constant(value)))
    }

    fn name(&mut self, path: &syn::ExprPath) -> Outcome<Value> {
        let Some(name) = path.path.get_ident().map(ToString::to_string) else {
            let diagnostic = Diagnostic::new("paths are not part of the problem language", place(path));
            return Err(self.report(
                diagnostic.label("expected a plain name").hint("constants must be rational; pass others as data"),
            ));
        };
        match self.scopes.get(&name) {
            Some(binding) => {
                let value = binding.value.as_ref().map_err(|&reported| reported)?;
                let weight = value.weight();
                let value = value.clone();
                self.charge(weight, path)?;
                Ok(value)
            }
            None => Err(self.report_unknown_name(&name, place(path))),
        }
    }

    /// Says that a name is not known, and which one may have been meant.
    pub(super) fn report_unknown_name(&mut self, name: &str, span: Span) -> Reported {
        let mut diagnostic = Diagnostic::new(format!("unknown name `{name}`"), span);
        if BUILT_IN.iter().any(|function| function.name == name) || self.helpers.contains_key(name) {
            diagnostic = diagnostic.label("this is a function").hint(format!("call it: `{name}(..)`"));
            return self.report(diagnostic);
        }
        diagnostic = diagnostic.label("not found in this scope");
        if let Some(meant) = closest(name, self.scopes.names()) {
            diagnostic = diagnostic.hint(format!("did you mean `{meant}`?"));
        } else if self.calls.is_empty() {
            diagnostic =
                diagnostic.hint("unknowns stand in the return type, data among the parameters, others after `let`");
        } else {
            diagnostic = diagnostic.hint("a helper sees its own parameters only: pass the value to it");
        }
        self.report(diagnostic)
    }

    fn array<'e>(&mut self, whole: &Expr, items: impl Iterator<Item = &'e Expr>) -> Outcome<Value> {
        // All elements are evaluated, so that every mistake in them is seen.
        let values: Vec<(&Expr, Outcome<Value>)> = items.map(|item| (item, self.evaluate(item))).collect();
        let mut rows: Vec<Value> = Vec::with_capacity(values.len());
        for (item, value) in values {
            let value = value?;
            if let Some(first) = rows.first()
                && first.shape() != value.shape()
            {
                let diagnostic = Diagnostic::new("the elements of an array must have one shape", place(item));
                let (this, first) = (describe(value.shape()), describe(first.shape()));
                let diagnostic = diagnostic.label(format!("this is {this}, the first element is {first}"));
                return Err(self.report(diagnostic.hint("all rows of an array have one length: `[[a, b], [c, d]]`")));
            }
            rows.push(value);
        }
        let count = rows.iter().map(|row| row.elements().len()).sum();
        self.limit_elements(count, rows.iter().map(Value::weight).sum(), whole)?;
        match Value::stack(rows) {
            Some(value) => Ok(value),
            None => Err(self.report(Diagnostic::new("an array needs at least one element", place(whole)))),
        }
    }

    fn repeat(&mut self, whole: &Expr, item: &Expr, length: &Expr) -> Outcome<Value> {
        let item = self.evaluate(item);
        let length = self.length(length)?;
        let item = item?;
        let [count, weight] = [item.elements().len(), item.weight()].map(|each| length.saturating_mul(each));
        self.limit_elements(count, weight, whole)?;
        Value::stack(vec![item; length]).ok_or(Reported)
    }

    /// A constant positive integer that counts elements.
    pub(super) fn length(&mut self, expression: &Expr) -> Outcome<usize> {
        let value = self.index_value(expression)?;
        match usize::try_from(value) {
            Ok(length) if (1..=MAX_ELEMENTS).contains(&length) => Ok(length),
            _ => {
                let diagnostic = Diagnostic::new(format!("an array cannot have {value} elements"), place(expression));
                Err(self.report(diagnostic.label(format!("expected 1 to {MAX_ELEMENTS}"))))
            }
        }
    }

    /// Refuses arrays that are too large, before they are made; `weight` is what it takes to make
    /// them.
    pub(super) fn limit_elements(
        &mut self,
        count: usize,
        weight: usize,
        at: &impl syn::spanned::Spanned,
    ) -> Outcome<()> {
        if count > MAX_ELEMENTS {
            let diagnostic = Diagnostic::new(format!("the array has {count} elements"), place(at));
            return Err(self.report(diagnostic.label(format!("at most {MAX_ELEMENTS} are allowed"))));
        }
        self.charge(weight, at)
    }

    fn index(&mut self, expression: &ExprIndex) -> Outcome<Value> {
        if let Expr::Range(range) = &*expression.index {
            return self.slice(expression, range);
        }
        let mut indices = vec![&*expression.index];
        let mut base = &*expression.expr;
        while let Expr::Index(inner) = base
            && !matches!(&*inner.index, Expr::Range(_))
        {
            indices.push(&*inner.index);
            base = &inner.expr;
        }
        indices.reverse();
        let at: Vec<Outcome<i64>> = indices.iter().map(|index| self.index_value(index)).collect();
        // A name is indexed in place: copying a large array for each of its elements would be slow.
        let name = match base {
            Expr::Path(path) => path.path.get_ident().and_then(|name| self.scopes.get(&name.to_string())),
            _ => None,
        };
        let selected = match name {
            Some(binding) => {
                let at: Vec<i64> = at.into_iter().collect::<Outcome<_>>()?;
                binding.value.as_ref().map_err(|&reported| reported)?.select(&at)
            }
            None => {
                let base = self.evaluate(base)?;
                base.select(&at.into_iter().collect::<Outcome<Vec<_>>>()?)
            }
        };
        let selected = selected.map_err(|(position, fault)| self.report(fault.at(place(indices[position]))))?;
        self.charge(selected.weight(), expression)?;
        Ok(selected)
    }

    fn unary(&mut self, unary: &ExprUnary) -> Outcome<Value> {
        let diagnostic = match unary.op {
            UnOp::Neg(_) => {
                let value = self.evaluate(&unary.expr)?;
                self.charge(value.weight(), unary)?;
                return Ok(self.algebra.negate(&value));
            }
            UnOp::Deref(_) => Diagnostic::new("there are no references to follow with `*`", place(&unary.op))
                .hint("a product needs two factors: `a * b`; a power is written `a.pow(2)`"),
            _ => Diagnostic::new("there are no logical values to negate with `!`", place(&unary.op))
                .hint("write `expression != 0;` to drop solutions at which it vanishes"),
        };
        Err(self.report(diagnostic))
    }

    fn binary(&mut self, binary: &ExprBinary) -> Outcome<Value> {
        if let Some(diagnostic) = mistaken_power(binary) {
            return Err(self.report(diagnostic));
        }
        match binary.op {
            BinOp::Add(_) | BinOp::Sub(_) | BinOp::Mul(_) | BinOp::Div(_) | BinOp::Rem(_) => {
                let (left, right) = (self.evaluate(&binary.left), self.evaluate(&binary.right));
                self.combine(binary, &left?, &right?)
            }
            BinOp::Eq(_) | BinOp::Ne(_) => Err(self.report(
                Diagnostic::new("an equation is not a value", place(&binary.op))
                    .label("an equation must be a statement of its own")
                    .hint("end the statement before it with `;`"),
            )),
            BinOp::Lt(_) | BinOp::Le(_) | BinOp::Gt(_) | BinOp::Ge(_) => Err(self.report(
                Diagnostic::new("this inequality cannot be stated", place(&binary.op))
                    .label("expected `<` or `>` in a statement of its own")
                    .hint("`focal > 0;` drops the other solutions"),
            )),
            _ => Err(self.report(
                Diagnostic::new("the operator is not part of the problem language", place(&binary.op))
                    .label("expected `+`, `-`, `*`, `/`, `==` or `!=`"),
            )),
        }
    }

    /// left op right; the difference for `==`.
    pub(super) fn combine(&mut self, binary: &ExprBinary, left: &Value, right: &Value) -> Outcome<Value> {
        use BinOp::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Rem};
        let operands;
        let [left, right] = match binary.op {
            Mul(_) | MulAssign(_) | Div(_) | DivAssign(_) if self.is_in_field => {
                operands = [self.operand_in_field(left, &binary.left)?, self.operand_in_field(right, &binary.right)?];
                operands.each_ref()
            }
            _ => [left, right],
        };
        let result = match binary.op {
            Add(_) | AddAssign(_) => self.algebra.add(left, right),
            Mul(_) | MulAssign(_) => self.algebra.multiply(left, right),
            Div(_) | DivAssign(_) => {
                let (left, right) = self.with_real_divisor(left.clone(), right.clone(), &binary.right)?;
                return self.divide(binary, &left, &right);
            }
            Rem(_) => return self.remainder(binary),
            _ => self.algebra.subtract(left, right),
        };
        result.map_err(|diagnostic| {
            let both_scalar = left.shape().is_empty() && right.shape().is_empty();
            let mut diagnostic = diagnostic.at(place(&binary.op));
            if !both_scalar {
                diagnostic = diagnostic
                    .context(place(&binary.left), format!("this is {}", describe(left.shape())))
                    .context(place(&binary.right), format!("this is {}", describe(right.shape())));
            }
            self.report(diagnostic)
        })
    }

    fn method(&mut self, call: &ExprMethodCall) -> Outcome<Value> {
        let name = call.method.to_string();
        let arguments: Vec<&Expr> = call.args.iter().collect();
        match (name.as_str(), &arguments[..]) {
            ("t", []) => {
                let value = self.evaluate(&call.receiver)?;
                self.charge(value.weight(), call)?;
                let result = value.transpose();
                self.check(result, &call.receiver)
            }
            ("pow", [exponent]) => self.power(&call.receiver, exponent),
            ("t", _) => Err(self.report(
                Diagnostic::new("`.t()` takes no arguments", place(&call.args)).label("expected `matrix.t()`"),
            )),
            ("pow", _) => {
                let diagnostic = Diagnostic::new("`.pow(n)` takes one argument", place(&call.method));
                Err(self.report(diagnostic.label("expected the exponent, such as `.pow(2)`")))
            }
            _ => Err(self.unknown_method(call, &name)),
        }
    }

    fn power(&mut self, base: &Expr, exponent: &Expr) -> Outcome<Value> {
        let (value, n) = (self.evaluate(base), self.index_value(exponent));
        let (mut value, n) = (value?, n?);
        if self.is_in_field {
            value = self.operand_in_field(&value, base)?;
        }
        let Some(polynomial) = value.as_scalar() else {
            let diagnostic = Diagnostic::new("only scalars have powers", place(base));
            return Err(self.report(
                diagnostic.label(format!("this is {}", describe(value.shape()))).hint("write the product: `m * m`"),
            ));
        };
        let Some(n) = u32::try_from(n).ok().filter(|&n| n <= MAX_DEGREE as u32) else {
            let diagnostic = Diagnostic::new(format!("the exponent {n} is out of range"), place(exponent))
                .label(format!("expected 0 to {MAX_DEGREE}"));
            return Err(self.report(match n < 0 {
                true => diagnostic.hint("a negative power is no polynomial: multiply the equation by the base"),
                false => diagnostic,
            }));
        };
        let result = self.algebra.power(polynomial, n);
        self.check(result.map(Value::scalar), base)
    }

    fn unknown_method(&mut self, call: &ExprMethodCall, name: &str) -> Reported {
        let mut diagnostic = Diagnostic::new(format!("unknown method `.{name}()`"), place(&call.method));
        if let Some(hint) = non_polynomial(name) {
            diagnostic = fault(format!("`.{name}()` is not a polynomial")).at(place(&call.method)).hint(hint);
        } else if let Some(function) = BUILT_IN.iter().find(|function| function.name == name) {
            diagnostic = diagnostic.label("this is a function").hint(format!("write `{}`", function.usage));
        } else if matches!(name, "transpose" | "T") {
            diagnostic = diagnostic.hint("the transpose is written `.t()`");
        } else if matches!(name, "iter" | "into_iter" | "len" | "clone") {
            diagnostic = diagnostic.hint("loops run over arrays and ranges: `for row in matrix`, `for i in 0..3`");
        } else {
            diagnostic = diagnostic.label("the methods are `.pow(n)` and `.t()`");
        }
        self.report(diagnostic)
    }

    fn unsupported(&mut self, expression: &Expr) -> Reported {
        let (what, hint) = match expression {
            Expr::Tuple(_) => {
                ("tuples are not values", "write a `let` for each value, or an array of values of one shape: `[a, b]`")
            }
            Expr::Match(_) => ("there is no `match`", "write `if k == 0 { .. } else { .. }`"),
            Expr::While(_) | Expr::Loop(_) => ("only `for` loops are supported", "write `for i in 0..3 { .. }`"),
            Expr::Reference(_) => ("references are not needed", "remove the `&`: values are copied"),
            Expr::Cast(_) => ("there is nothing to cast", "remove the `as`: an integer is a value like any other"),
            Expr::Return(_) => ("`return` is not supported", "write the value as last line, without `;`"),
            Expr::Closure(_) => ("closures are not supported", "write a helper function beside the problem"),
            Expr::Range(_) => ("a range is not a value", "ranges stand in loops: `for i in 0..3 { .. }`"),
            Expr::Field(field) if matches!(&field.member, Member::Named(name) if name == "t") => {
                ("values have no fields", "the transpose is written `.t()`")
            }
            Expr::Field(_) => {
                ("values have no such fields", "index arrays with `v[0]`; complex values have `.re` and `.im`")
            }
            Expr::Macro(_) => ("macros are not part of the problem language", "state an equation as `left == right;`"),
            Expr::Assign(_) => ("an assignment is not a value", "state an equation as `left == right;`"),
            _ => (
                "this is not part of the problem language",
                "expressions are made of `+ - * /`, calls, arrays, indices",
            ),
        };
        self.report(Diagnostic::new(what, place(expression)).hint(hint))
    }
}

/// Whether a field is the real or the imaginary part.
fn is_part(field: &ExprField) -> bool {
    matches!(&field.member, Member::Named(name) if name == "re" || name == "im")
}

/// `x^2` and `x**2`, which Rust reads as `x ^ (2 + ..)` and `x * (*2)`.
fn mistaken_power(binary: &ExprBinary) -> Option<Diagnostic> {
    let (span, operator, exponent) = match (&binary.op, &*binary.right) {
        (BinOp::BitXor(_), right) => (place(&binary.op), "^", right),
        (BinOp::Mul(_), Expr::Unary(unary)) if matches!(unary.op, UnOp::Deref(_)) => {
            (place(&binary.op).start..place(&unary.op).end, "**", &*unary.expr)
        }
        _ => return None,
    };
    let base = outer_operand(&binary.left, |inner| &inner.right);
    let exponent = outer_operand(exponent, |inner| &inner.left);
    let text = |operand: &Expr| operand.span_text().filter(|text| text.len() <= 20);
    let hint = match (text(base), text(exponent)) {
        (Some(base), Some(exponent)) => format!("write `{base}.pow({exponent})`"),
        _ => "write `x.pow(2)`".to_owned(),
    };
    let diagnostic = Diagnostic::new(format!("`{operator}` is not a power"), span);
    Some(diagnostic.label("powers are written `.pow(n)`").hint(hint))
}

/// The operand next to an operator, whatever the precedence: the last of `a * x`, or the first
/// of `2 + y`.
fn outer_operand(mut expression: &Expr, side: impl Fn(&ExprBinary) -> &Expr) -> &Expr {
    while let Expr::Binary(binary) = expression {
        expression = side(binary);
    }
    expression
}

trait SpanText {
    fn span_text(&self) -> Option<String>;
}

impl SpanText for Expr {
    /// The text it was parsed from.
    fn span_text(&self) -> Option<String> {
        use syn::spanned::Spanned;
        self.span().source_text()
    }
}

/// A decimal number, as digits with optional point and exponent, as an exact fraction.
fn parse_decimal(digits: &str) -> Option<Rational> {
    let (mantissa, exponent) = match digits.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (digits, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    // Trailing zeros of the fraction would only shorten the range.
    let fraction = fraction.trim_end_matches('0');
    let numerator: i64 = format!("{whole}{fraction}").parse().ok()?;
    let exponent = exponent.checked_sub(i32::try_from(fraction.len()).ok()?)?;
    if numerator == 0 {
        return Some(Rational::ZERO);
    }
    let power = 10i64.checked_pow(exponent.unsigned_abs())?;
    let (numerator, power) = (Rational::integer(numerator), Rational::integer(power));
    if exponent < 0 { numerator.checked_div(power) } else { numerator.checked_mul(power) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_exact_fractions() {
        let cases = [("0.5", 1, 2), ("2", 2, 1), ("1.250", 5, 4), ("1e3", 1000, 1), ("2.5e-1", 1, 4), ("0.000", 0, 1)];
        for (text, numerator, denominator) in cases {
            assert_eq!(parse_decimal(text), Rational::new(numerator, denominator), "{text}");
        }
        for text in ["1e40", "99999999999999999999", "1e-40", "1e99999999999"] {
            assert_eq!(parse_decimal(text), None, "{text}");
        }
    }
}
