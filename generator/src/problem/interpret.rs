//! Statements: what they bind and which equations they state.
//!
//! A statement that fails is reported once, the names it would have bound are marked, and
//! interpretation goes on, so that one run shows all mistakes and no mistake twice.

use std::collections::{BTreeMap, BTreeSet, HashSet};

use syn::{BinOp, Block, Expr, ExprBinary, ExprForLoop, ItemFn, Local, Pat, RangeLimits, Stmt};

use super::data::PARTS;
use super::names::emitted_name;
use super::output::Output;
use super::scope::{Binding, Kind, Outcome, Reported, Scopes};
use super::syntax::place;
use super::value::{Algebra, Checked, MAX_ELEMENTS, Value, describe, fault};
use super::{DataParameter, Span, Statement, element_name};
use crate::algebra::Monomial;
use crate::expression::{ExpressionGraph, SymbolicPolynomial};
use crate::problem::diagnostic::{Diagnostic, MAX_MESSAGES};

/// Largest number of scalar equations.
const MAX_EQUATIONS: usize = 1000;

/// What it takes to enter a scope and to leave it, in units of work.
pub(super) const WORK_OF_A_SCOPE: usize = 8;

/// What it takes to find a mistake, in units of work.
const WORK_OF_A_MESSAGE: usize = 40;

/// Most calls of helpers shown with a message.
const MAX_CALLS_SHOWN: usize = 3;

/// The state of the symbolic evaluation of one file.
pub(super) struct Interpreter<'a> {
    pub(super) algebra: Algebra,
    pub(super) scopes: Scopes,
    pub(super) helpers: &'a BTreeMap<String, &'a ItemFn>,
    pub(super) unknowns: Vec<String>,
    /// The data that are given.
    pub(super) data: Vec<DataParameter>,
    /// The helpers being evaluated, each with the place of its call.
    pub(super) calls: Vec<(String, Span)>,
    /// Expressions being evaluated, one inside the other.
    pub(super) depth: usize,
    pub(super) equations: Vec<Statement>,
    pub(super) nonzero: Vec<Statement>,
    pub(super) positive: Vec<Statement>,
    pub(super) output: Option<Output>,
    /// Whether a scene is evaluated, which has no unknowns.
    pub(super) is_scene: bool,
    /// Whether a field of the output is evaluated, or what stands before it for the sake of the
    /// output alone.
    pub(super) is_in_field: bool,
    /// The polynomials of the equations.
    stated: HashSet<SymbolicPolynomial>,
    /// Place of each equation statement: whether some element of it was not 0 = 0.
    says_something: BTreeMap<(usize, usize), bool>,
    /// Number of equations left out because an earlier one says the same.
    pub(super) repeated: usize,
    messages: Vec<Diagnostic>,
    reported: BTreeSet<(usize, usize)>,
}

impl<'a> Interpreter<'a> {
    pub(super) fn new(graph: ExpressionGraph, helpers: &'a BTreeMap<String, &'a ItemFn>) -> Self {
        Self {
            algebra: Algebra::new(graph),
            scopes: Scopes::default(),
            helpers,
            unknowns: Vec::new(),
            data: Vec::new(),
            calls: Vec::new(),
            depth: 0,
            equations: Vec::new(),
            nonzero: Vec::new(),
            positive: Vec::new(),
            output: None,
            is_scene: false,
            is_in_field: false,
            stated: HashSet::new(),
            says_something: BTreeMap::new(),
            repeated: 0,
            messages: Vec::new(),
            reported: BTreeSet::new(),
        }
    }

    /// Records a message: one for each place, the first, so that loops do not repeat it.
    pub(super) fn report(&mut self, mut diagnostic: Diagnostic) -> Reported {
        // A mistake in a loop is found again and again. A message about the work would add nothing.
        let _ = self.algebra.charge(WORK_OF_A_MESSAGE);
        if self.messages.len() > MAX_MESSAGES {
            // One more than are shown: nobody reads them, and they take time.
            self.algebra.exhaust();
        } else if self.reported.insert((diagnostic.span.start, diagnostic.span.end)) {
            for (name, span) in self.calls.iter().rev().take(MAX_CALLS_SHOWN) {
                diagnostic = diagnostic.context(span.clone(), format!("in this call of `{name}`"));
            }
            self.messages.push(diagnostic);
        }
        Reported
    }

    /// Records the message of a failed operation at its place.
    pub(super) fn check<T>(&mut self, result: Checked<T>, at: &impl syn::spanned::Spanned) -> Outcome<T> {
        result.map_err(|diagnostic| self.report(diagnostic.at(place(at))))
    }

    /// Takes note of work about to be done; fails silently once the limit has been reported.
    pub(super) fn charge(&mut self, work: usize, at: &impl syn::spanned::Spanned) -> Outcome<()> {
        if self.algebra.is_exhausted() {
            return Err(Reported);
        }
        let result = self.algebra.charge(work);
        self.check(result, at)
    }

    /// Everything reported so far, at the end also the statements that say nothing.
    pub(super) fn into_messages(mut self) -> Vec<Diagnostic> {
        for ((start, end), says_something) in std::mem::take(&mut self.says_something) {
            if !says_something {
                self.report(
                    Diagnostic::new("the equation is always true", start..end)
                        .label("both sides are equal whatever the unknowns are")
                        .hint("remove it, or mend a mistake in it"),
                );
            }
        }
        self.messages
    }

    /// Whether anything was reported.
    pub(super) fn has_messages(&self) -> bool {
        !self.messages.is_empty() || self.says_something.values().any(|says| !says)
    }

    /// Runs the statements of a block in a scope of their own.
    pub(super) fn run_block(&mut self, block: &Block) {
        self.scopes.enter();
        for statement in &block.stmts {
            self.run_statement(statement);
        }
        self.scopes.leave();
    }

    /// The value of a block: that of its last expression.
    pub(super) fn block_value(&mut self, block: &Block) -> Outcome<Value> {
        let Some((Stmt::Expr(value, None), statements)) = block.stmts.split_last() else {
            let span = block.brace_token.span.close().byte_range();
            return Err(self.report(
                Diagnostic::new("the block has no value", span)
                    .label("expected an expression without `;` before this")
                    .hint("the value of a block is its last line, written without `;`"),
            ));
        };
        self.scopes.enter();
        for statement in statements {
            self.run_statement(statement);
        }
        let value = self.evaluate(value);
        self.scopes.leave();
        value
    }

    pub(super) fn run_statement(&mut self, statement: &Stmt) {
        match statement {
            Stmt::Local(local) => self.run_let(local),
            Stmt::Expr(expression, _) => self.run_expression(expression),
            Stmt::Macro(statement) => {
                self.report(
                    Diagnostic::new("macros are not part of the problem language", place(&statement.mac))
                        .hint("state an equation as `left == right;`"),
                );
            }
            Stmt::Item(item) => {
                self.report(
                    Diagnostic::new("items cannot stand inside a function", place(item))
                        .hint("move it to the top of the file"),
                );
            }
        }
    }

    fn run_let(&mut self, local: &Local) {
        let value = match &local.init {
            Some(init) if init.diverge.is_none() => self.evaluate(&init.expr),
            Some(_) => Err(self.report(Diagnostic::new("`let` with `else` is not supported", place(local)))),
            None => Err(self.report(
                Diagnostic::new("`let` needs a value", place(local))
                    .hint("write `let name = value;`; unknowns stand in the return type of the function"),
            )),
        };
        self.bind(&local.pat, value);
    }

    /// Binds the names of a pattern; where the value is missing or does not fit, marks them.
    pub(super) fn bind(&mut self, pattern: &Pat, value: Outcome<Value>) {
        match pattern {
            Pat::Wild(_) => {}
            Pat::Paren(inner) => self.bind(&inner.pat, value),
            Pat::Ident(name) if name.by_ref.is_none() && name.subpat.is_none() => {
                let (text, span) = (name.ident.to_string(), place(&name.ident));
                let hidden = self.scopes.get(&text).filter(|binding| binding.kind == Kind::Unknown);
                if let Some(unknown) = hidden.map(|binding| binding.span.clone()) {
                    self.report(
                        Diagnostic::new(format!("`{text}` is an unknown"), span)
                            .label("this would hide it")
                            .context(unknown, "declared here")
                            .hint("choose another name; to state an equation write `==`"),
                    );
                    return;
                }
                // What changes is not what the name says in the end; names of helpers say nothing
                // to a reader.
                if name.mutability.is_none() && self.calls.is_empty() {
                    self.name_values(&text, &value);
                }
                self.scopes.declare(text, Binding { value, kind: Kind::Local(name.mutability.is_some()), span });
            }
            Pat::Type(typed) => {
                let value = value.and_then(|value| {
                    let expected = self.shape_of_type(&typed.ty)?;
                    let result = expected.check(&value, self.algebra.is_complex_value(&value));
                    self.check(result, &typed.ty).map(|()| value)
                });
                self.bind(&typed.pat, value);
            }
            Pat::Slice(slice) => {
                let rows = value.and_then(|value| {
                    let rows: Vec<_> = value.rows().collect();
                    if rows.len() == slice.elems.len() {
                        return Ok(rows);
                    }
                    let expected = describe(value.shape());
                    let message = format!("a pattern of {} names for {expected}", slice.elems.len());
                    Err(self.report(Diagnostic::new(message, place(slice)).label("the numbers differ")))
                });
                for (position, inner) in slice.elems.iter().enumerate() {
                    let row = rows.as_ref().map_err(|&reported| reported).map(|rows| rows[position].clone());
                    self.bind(inner, row);
                }
            }
            _ => {
                self.report(
                    Diagnostic::new("this pattern is not supported", place(pattern))
                        .label("expected a name or an array of names")
                        .hint("write `let name = ..;` or `let [first, second] = ..;`"),
                );
            }
        }
    }

    /// Remembers the names of values that depend on data only, so that they appear in the emitted
    /// code.
    fn name_values(&mut self, name: &str, value: &Outcome<Value>) {
        let (Some(name), Ok(value)) = (emitted_name(name), value) else { return };
        for (index, polynomial) in value.elements().iter().enumerate() {
            if let &[(Monomial::ONE, coefficient)] = polynomial.terms() {
                let element = element_name(value.shape(), index);
                self.algebra.graph.name(coefficient, &format!("{name}{element}"));
            }
        }
    }

    fn run_expression(&mut self, expression: &Expr) {
        match expression {
            Expr::Struct(_) if self.is_scene => self.refuse_in_scene(expression),
            Expr::Binary(binary) => self.run_binary(expression, binary),
            Expr::Assign(assign) => {
                let value = self.evaluate(&assign.right);
                self.assign(&assign.left, value);
            }
            Expr::ForLoop(each) => self.run_for(each),
            Expr::If(stated) => self.run_if(stated),
            Expr::Block(block) => self.run_block(&block.block),
            Expr::Struct(stated) => self.state_output(stated),
            Expr::Paren(inner) => self.run_expression(&inner.expr),
            Expr::Verbatim(tokens) if tokens.is_empty() => {}
            _ => {
                if self.evaluate(expression).is_ok() {
                    self.without_effect(expression);
                }
            }
        }
    }

    fn without_effect(&mut self, expression: &Expr) {
        self.report(
            Diagnostic::new("the expression has no effect", place(expression))
                .label("expected a statement")
                .hint("state an equation as `left == right;`, name a value with `let name = value;`"),
        );
    }

    fn run_binary(&mut self, expression: &Expr, binary: &ExprBinary) {
        match binary.op {
            BinOp::Eq(_) | BinOp::Ne(_) if self.is_scene => self.refuse_in_scene(expression),
            BinOp::Eq(_) | BinOp::Ne(_) | BinOp::Gt(_) | BinOp::Lt(_) if self.is_in_field => {}
            BinOp::Eq(_) => self.state_equation(expression, binary),
            BinOp::Ne(_) => self.state_nonzero(expression, binary),
            BinOp::Gt(_) | BinOp::Lt(_) => self.state_inequality(expression, binary),
            BinOp::AddAssign(_) | BinOp::SubAssign(_) | BinOp::MulAssign(_) | BinOp::DivAssign(_) => {
                let left = self.evaluate(&binary.left);
                let right = self.evaluate(&binary.right);
                let value = left.and_then(|left| right.and_then(|right| self.combine(binary, &left, &right)));
                self.assign(&binary.left, value);
            }
            _ => {
                if self.evaluate(expression).is_ok() {
                    self.without_effect(expression);
                }
            }
        }
    }

    fn assign(&mut self, target: &Expr, value: Outcome<Value>) {
        let mut indices = Vec::new();
        let mut base = target;
        while let Expr::Index(index) = base {
            indices.push(&*index.index);
            base = &index.expr;
        }
        indices.reverse();
        let name = match base {
            Expr::Path(path) => path.path.get_ident().map(ToString::to_string),
            _ => None,
        };
        let Some(name) = name else {
            self.report(
                Diagnostic::new("only names and their elements can be assigned to", place(target))
                    .label("expected `name` or `name[i]`")
                    .hint("an equation is stated as `left == right;`"),
            );
            return;
        };
        let at: Outcome<Vec<i64>> = indices.iter().map(|index| self.index_value(index)).collect();
        let Some(kind) = self.scopes.get(&name).map(|binding| binding.kind) else {
            self.report_unknown_name(&name, place(base));
            return;
        };
        if kind != Kind::Local(true) {
            self.report_immutable(&name, kind, place(base));
            return;
        }
        let result = value.and_then(|value| self.store(target, &indices, &name, &at?, value));
        if let (Err(reported), Some(binding)) = (result, self.scopes.get_mut(&name)) {
            binding.value = Err(reported);
        }
    }

    fn store(&mut self, target: &Expr, indices: &[&Expr], name: &str, at: &[i64], value: Value) -> Outcome<()> {
        let Some(binding) = self.scopes.get_mut(name) else { return Err(Reported) };
        let current = binding.value.as_mut().map_err(|reported| *reported)?;
        let located = current.locate(at).map(|(first, shape)| (first, shape.to_vec()));
        match located {
            Ok((first, shape)) if shape == value.shape() => current.replace(first, &value),
            Ok((_, shape)) => {
                let message = format!("{} is assigned to {}", describe(value.shape()), describe(&shape));
                return Err(self.report(Diagnostic::new(message, place(target)).label("the shapes differ")));
            }
            Err((position, diagnostic)) => return self.check(Err(diagnostic), indices[position]),
        }
        Ok(())
    }

    fn report_immutable(&mut self, name: &str, kind: Kind, span: Span) {
        let (what, hint) = match kind {
            Kind::Unknown => ("an unknown", format!("to state an equation write `{name} == ..;`")),
            Kind::Data => ("a parameter", format!("copy it first: `let mut copy = {name};`")),
            Kind::Constant => ("a constant", format!("copy it first: `let mut copy = {name};`")),
            Kind::Local(_) => ("not mutable", format!("declare it with `let mut {name} = ..;`")),
        };
        let message = format!("`{name}` cannot be assigned to");
        self.report(Diagnostic::new(message, span).label(format!("it is {what}")).hint(hint));
    }

    fn run_for(&mut self, each: &ExprForLoop) {
        let Ok(items) = self.loop_items(&each.expr) else { return };
        for item in items {
            if self.charge(WORK_OF_A_SCOPE, &each.expr).is_err() {
                return;
            }
            self.scopes.enter();
            self.bind(&each.pat, Ok(item));
            self.run_block(&each.body);
            self.scopes.leave();
        }
    }

    /// The values a loop runs over: integers of a range, or elements or rows of an array.
    fn loop_items(&mut self, over: &Expr) -> Outcome<Vec<Value>> {
        let Expr::Range(range) = over else {
            let value = self.evaluate(over)?;
            if value.shape().is_empty() {
                let diagnostic = Diagnostic::new("a scalar cannot be iterated over", place(over));
                return Err(self.report(diagnostic.label("expected a range such as `0..3`, or an array")));
            }
            self.charge(value.weight(), over)?;
            return Ok(value.rows().collect());
        };
        let (Some(start), Some(end)) = (&range.start, &range.end) else {
            let diagnostic = Diagnostic::new("the range of a loop needs both ends", place(over));
            return Err(self.report(diagnostic.label("expected `first..end` or `first..=last`")));
        };
        let (start, end) = (self.index_value(start), self.index_value(end));
        let (start, end) = (start?, end?);
        let end = match range.limits {
            RangeLimits::HalfOpen(_) => end,
            RangeLimits::Closed(_) => end.saturating_add(1),
        };
        if end.saturating_sub(start) > MAX_ELEMENTS as i64 {
            let diagnostic = Diagnostic::new("the loop is too long", place(over));
            return Err(self.report(diagnostic.label(format!("at most {MAX_ELEMENTS} iterations are allowed"))));
        }
        self.charge(usize::try_from(end.saturating_sub(start)).unwrap_or(0), over)?;
        Ok((start..end).map(|i| self.integer(i)).collect())
    }

    fn state_equation(&mut self, expression: &Expr, binary: &ExprBinary) {
        if self.outside_helpers(expression).is_err() {
            return;
        }
        let (left, right) = (self.evaluate(&binary.left), self.evaluate(&binary.right));
        let (Ok(left), Ok(right)) = (left, right) else { return };
        let difference = if right.is_scalar_zero() {
            left
        } else if left.is_scalar_zero() {
            right
        } else {
            match self.combine(binary, &left, &right) {
                Ok(difference) => difference,
                Err(Reported) => return,
            }
        };
        let span = place(expression);
        let mut says_something = false;
        for (index, polynomial) in difference.elements().iter().enumerate() {
            let is_complex = self.algebra.is_complex(polynomial);
            for (part, name) in self.algebra.parts(polynomial).iter().zip(PARTS).filter(|(part, _)| !part.is_zero()) {
                says_something = true;
                let name = if is_complex { name } else { "" };
                self.add_equation(part, element_name(difference.shape(), index) + name, &span);
            }
        }
        *self.says_something.entry((span.start, span.end)).or_default() |= says_something;
    }

    fn add_equation(&mut self, polynomial: &SymbolicPolynomial, element: String, span: &Span) {
        if polynomial.degree() == 0 {
            let diagnostic = match self.algebra.as_constant(polynomial) {
                Some(value) => Diagnostic::new(format!("the equation can never hold: {value} is not 0"), span.clone())
                    .label(format!("the difference of the two sides{} is {value}", element_suffix(&element))),
                None => Diagnostic::new("the equation is a condition on the data alone", span.clone())
                    .label(format!("no unknown is left{}", element_suffix(&element)))
                    .hint("it holds for some data and fails for others: remove it, or make one of the data an unknown"),
            };
            self.report(diagnostic);
            return;
        }
        let negative = self.algebra.graph.polynomial_neg(polynomial);
        // The mirrored entries of symmetric and skew matrices add nothing.
        if self.stated.contains(polynomial) || self.stated.contains(&negative) {
            self.repeated += 1;
            return;
        }
        if self.equations.len() == MAX_EQUATIONS {
            let diagnostic = Diagnostic::new("the problem has too many equations", span.clone());
            self.report(diagnostic.label(format!("at most {MAX_EQUATIONS} scalar equations are allowed")));
            return;
        }
        self.stated.insert(polynomial.clone());
        self.equations.push(Statement { polynomial: polynomial.clone(), span: span.clone(), element });
    }

    fn state_nonzero(&mut self, expression: &Expr, binary: &ExprBinary) {
        if self.outside_helpers(expression).is_err() {
            return;
        }
        let (left, right) = (self.evaluate(&binary.left), self.evaluate(&binary.right));
        let (Ok(left), Ok(right)) = (left, right) else { return };
        let span = place(expression);
        let diagnostic = if !right.is_scalar_zero() {
            fault("the right side of `!=` must be 0")
                .at(place(&binary.right))
                .label("expected `0`")
                .hint("write `left - right != 0;`")
        } else if let Some(polynomial) = left.as_scalar() {
            let is_complex = self.algebra.is_complex(polynomial);
            let square = is_complex.then(|| self.algebra.square_of_modulus(polynomial)).transpose();
            let Ok(square) = self.check(square, expression) else { return };
            let polynomial = square.as_ref().unwrap_or(polynomial);
            if polynomial.degree() > 0 {
                self.nonzero.push(Statement { polynomial: polynomial.clone(), span, element: String::new() });
                return;
            }
            fault("the factor does not depend on the unknowns")
                .at(place(&binary.left))
                .label("no unknown is left in it")
                .hint("`!= 0` drops the solutions at which an expression in the unknowns vanishes")
        } else {
            fault("`!= 0` needs a scalar")
                .at(place(&binary.left))
                .label(format!("this is {}", describe(left.shape())))
                .hint("state it for one element: `v[0] != 0;`, or for each in a loop")
        };
        self.report(diagnostic);
    }
}

fn element_suffix(element: &str) -> String {
    match element {
        "" => String::new(),
        _ => format!(" in element {element}"),
    }
}
