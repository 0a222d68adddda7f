//! Conditions on constants, such as the variables of loops: they choose what is stated.

use syn::{BinOp, Block, Expr, ExprBinary, ExprIf, Lit, UnOp};

use super::interpret::Interpreter;
use super::scope::Outcome;
use super::syntax::place;
use super::value::{Value, describe};
use crate::expression::rational::Rational;
use crate::problem::diagnostic::Diagnostic;

impl Interpreter<'_> {
    /// Runs the statements that an `if` chooses.
    pub(super) fn run_if(&mut self, stated: &ExprIf) {
        if let Ok(Some(block)) = self.choose(stated) {
            self.run_block(block);
        }
    }

    /// The value of the block that an `if` chooses.
    pub(super) fn if_value(&mut self, stated: &ExprIf) -> Outcome<Value> {
        match self.choose(stated)? {
            Some(block) => self.block_value(block),
            None => Err(self.report(
                Diagnostic::new("the `if` has no value", place(stated))
                    .label("the condition is false, and there is no `else`")
                    .hint("write `if condition { value } else { other }`"),
            )),
        }
    }

    /// The block of the first condition that is true; `None` if none is, and there is no `else`.
    fn choose<'e>(&mut self, mut stated: &'e ExprIf) -> Outcome<Option<&'e Block>> {
        loop {
            if self.condition(&stated.cond)? {
                return Ok(Some(&stated.then_branch));
            }
            match stated.else_branch.as_ref().map(|(_, other)| &**other) {
                Some(Expr::If(next)) => stated = next,
                Some(Expr::Block(block)) => return Ok(Some(&block.block)),
                _ => return Ok(None),
            }
        }
    }

    /// Whether a condition on constants is true.
    fn condition(&mut self, expression: &Expr) -> Outcome<bool> {
        self.charge(1, expression)?;
        match expression {
            Expr::Paren(inner) => self.condition(&inner.expr),
            Expr::Group(inner) => self.condition(&inner.expr),
            Expr::Lit(literal) if let Lit::Bool(known) = &literal.lit => Ok(known.value),
            Expr::Unary(not) if matches!(not.op, UnOp::Not(_)) => Ok(!self.condition(&not.expr)?),
            Expr::Binary(binary) => self.comparison(expression, binary),
            _ => Err(self.report(
                Diagnostic::new("expected a condition", place(expression))
                    .label("expected a comparison")
                    .hint("compare constants, such as the variables of loops: `if k < 3 { .. }`"),
            )),
        }
    }

    fn comparison(&mut self, expression: &Expr, binary: &ExprBinary) -> Outcome<bool> {
        if let BinOp::And(_) = binary.op {
            return Ok(self.condition(&binary.left)? && self.condition(&binary.right)?);
        }
        if let BinOp::Or(_) = binary.op {
            return Ok(self.condition(&binary.left)? || self.condition(&binary.right)?);
        }
        let is_true = match binary.op {
            BinOp::Eq(_) => |a, b| a == b,
            BinOp::Ne(_) => |a, b| a != b,
            BinOp::Lt(_) => |a, b| a < b,
            BinOp::Le(_) => |a, b| a <= b,
            BinOp::Gt(_) => |a, b| a > b,
            BinOp::Ge(_) => |a, b| a >= b,
            _ => {
                let diagnostic = Diagnostic::new("expected a condition", place(expression));
                return Err(self.report(diagnostic.label("expected `==`, `!=`, `<`, `<=`, `>` or `>=`")));
            }
        };
        // Both sides are evaluated, so that every mistake in them is seen.
        let (left, right) = (self.constant(&binary.left), self.constant(&binary.right));
        Ok(is_true(left?, right?))
    }

    /// The value of a side of a comparison, which must be a constant.
    fn constant(&mut self, expression: &Expr) -> Outcome<Rational> {
        let value = self.evaluate(expression)?;
        if let Some(constant) = value.as_scalar().and_then(|polynomial| self.algebra.as_constant(polynomial)) {
            return Ok(constant);
        }
        let diagnostic = Diagnostic::new("conditions compare constants", place(expression));
        Err(self.report(match value.shape().is_empty() {
            true => diagnostic.label("this depends on unknowns or data").hint("write two problems, one for each case"),
            false => diagnostic.label(format!("this is {}", describe(value.shape()))),
        }))
    }
}
