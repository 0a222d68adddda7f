//! Data that are derived from data: square roots, linear systems, null spaces, choices.

use syn::{Expr, ExprCall};

use super::draw::redraw;
use super::functions::BuiltIn;
use super::instance::redrawn;
use super::interpret::Interpreter;
use super::scope::Outcome;
use super::syntax::place;
use super::value::{Algebra, Value, describe};
use crate::algebra::{Monomial, Polynomial, Random};
use crate::expression::derivation::DerivationKind;
use crate::expression::{ExpressionGraph, ExpressionId, FINGERPRINT_FIELDS, SymbolicPolynomial};
use crate::problem::diagnostic::Diagnostic;

/// The seed of points that are moved; any constant does.
const ROOT_SEED: u64 = 0x726f_6f74;
/// Half of all points have a root, and roots that depend on the same data must exist together.
const MAX_MOVES: usize = 512;
/// What it takes to compute all values anew, in units of work.
const WORK_OF_A_MOVE: usize = 1000;

/// Most entries that are derived from: a matrix of 64 x 64.
const MAX_OPERANDS: usize = 4096;

impl Interpreter<'_> {
    /// `solve(a, b)`: the x with a x = b, for a vector or the columns of a matrix.
    pub(super) fn solve(
        &mut self,
        call: &ExprCall,
        function: &BuiltIn,
        arguments: &[&Expr],
        [a, b]: [&Value; 2],
    ) -> Outcome<Value> {
        let size = self.square(function, arguments[0], a)?;
        let right = match *b.shape() {
            [n] if n == size => 1,
            [n, columns] if n == size => columns,
            _ => {
                let message = format!("`solve` needs a vector of length {size} or a matrix of {size} rows here");
                let diagnostic = Diagnostic::new(message, place(arguments[1]));
                return Err(self.report(diagnostic.label(format!("this is {}", describe(b.shape())))));
            }
        };
        match self.algebra.is_complex_value(a) || self.algebra.is_complex_value(b) {
            true => self.solve_complex(call, (function, arguments), [a, b], right),
            false => self.solve_real(call, (function, arguments), [a, b]),
        }
    }

    /// `solve(a, b)` with real data, of shapes that fit.
    fn solve_real(
        &mut self,
        call: &ExprCall,
        (function, arguments): (&BuiltIn, &[&Expr]),
        [a, b]: [&Value; 2],
    ) -> Outcome<Value> {
        let [size, right] = [a, b].map(|value| value.shape().get(1).copied().unwrap_or(1));
        let mut operands = self.data_of(function, arguments[0], a)?;
        let last = arguments.last().copied().unwrap_or(arguments[0]);
        operands.extend(self.data_of(function, last, b)?);
        self.derive(call, DerivationKind::Solve { size, right }, &operands, b.shape().to_vec())
    }

    /// The real system for `solve(a, b)` with complex data: [A -B; B A] [x; y] = [c; d] for
    /// a = A + B i, b = c + d i and the solution x + y i. The values are the matrix, n x n, and the
    /// right sides, of so many columns.
    fn solve_complex(
        &mut self,
        call: &ExprCall,
        (function, arguments): (&BuiltIn, &[&Expr]),
        [a, b]: [&Value; 2],
        columns: usize,
    ) -> Outcome<Value> {
        let n = a.shape().first().copied().unwrap_or(0);
        let parts = |algebra: &Algebra, value: &Value| -> Vec<[SymbolicPolynomial; 2]> {
            value.elements().iter().map(|element| algebra.parts(element)).collect()
        };
        let (of_a, of_b) = (parts(&self.algebra, a), parts(&self.algebra, b));
        let entry = |algebra: &mut Algebra, row: usize, column: usize| {
            let [re, im] = &of_a[row % n * n + column % n];
            match (row < n, column < n) {
                (true, true) | (false, false) => re.clone(),
                (true, false) => algebra.graph.polynomial_neg(im),
                (false, true) => im.clone(),
            }
        };
        let all = (0..2 * n).flat_map(|row| (0..2 * n).map(move |column| (row, column)));
        let matrix: Vec<_> = all.map(|(row, column)| entry(&mut self.algebra, row, column)).collect();
        let right = (0..2).flat_map(|part| of_b.iter().map(move |parts| parts[part].clone())).collect();
        let matrix = Value::array(vec![2 * n, 2 * n], matrix);
        let solution =
            self.solve_real(call, (function, arguments), [&matrix, &Value::array(vec![2 * n, columns], right)])?;
        let (re, im) = solution.elements().split_at(n * columns);
        let elements = re.iter().zip(im).map(|(re, im)| Algebra::join([re, im])).collect();
        Ok(Value::array(b.shape().to_vec(), elements))
    }

    /// `inverse(a)`.
    pub(super) fn inverse(
        &mut self,
        call: &ExprCall,
        function: &BuiltIn,
        argument: &Expr,
        a: &Value,
    ) -> Outcome<Value> {
        let size = self.square(function, argument, a)?;
        let (one, zero) = (self.algebra.data(ExpressionGraph::ONE), Polynomial::ZERO);
        let entry = |at: usize| if at.is_multiple_of(size + 1) { one.clone() } else { zero.clone() };
        let identity = Value::array(vec![size, size], (0..size * size).map(entry).collect());
        self.solve(call, function, &[argument, argument], [a, &identity])
    }

    /// `null_space(a)`: orthonormal vectors v with a v = 0, one in each row.
    pub(super) fn null_space(
        &mut self,
        call: &ExprCall,
        function: &BuiltIn,
        argument: &Expr,
        a: &Value,
    ) -> Outcome<Value> {
        let [rows, columns] = *a.shape() else {
            let diagnostic = Diagnostic::new("`null_space` needs a matrix", place(argument));
            return Err(self.report(diagnostic.label(format!("this is {}", describe(a.shape())))));
        };
        if rows >= columns {
            let diagnostic = Diagnostic::new("the null space of general data is 0", place(argument));
            let diagnostic = diagnostic.label(format!("this is {}", describe(a.shape())));
            return Err(self.report(diagnostic.hint("a null space needs fewer rows than columns")));
        }
        let operands = self.data_of(function, argument, a)?;
        self.derive(call, DerivationKind::NullSpace { rows, columns }, &operands, vec![columns - rows, columns])
    }

    /// `least(keys, values)`: the value whose key is least.
    pub(super) fn least(
        &mut self,
        call: &ExprCall,
        function: &BuiltIn,
        arguments: &[&Expr],
        [keys, values]: [&Value; 2],
    ) -> Outcome<Value> {
        let count = self.vector(function, arguments[0], keys, None)?;
        let shape = match values.shape() {
            [n, shape @ ..] if *n == count => shape.to_vec(),
            _ => {
                let diagnostic = Diagnostic::new(format!("`least` needs {count} values here"), place(arguments[1]));
                let diagnostic = diagnostic.label(format!("this is {}", describe(values.shape())));
                return Err(self.report(diagnostic.context(place(arguments[0]), "one for each key")));
            }
        };
        let mut operands = self.data_of(function, arguments[0], keys)?;
        operands.extend(self.data_of(function, arguments[1], values)?);
        let kind = DerivationKind::Least { keys: count, size: shape.iter().product() };
        self.derive(call, kind, &operands, shape)
    }

    /// `sqrt(x)`.
    pub(super) fn square_root(
        &mut self,
        call: &ExprCall,
        function: &BuiltIn,
        argument: &Expr,
        x: &Value,
    ) -> Outcome<Value> {
        if !x.shape().is_empty() {
            let diagnostic = Diagnostic::new(format!("`{}` needs a scalar", function.name), place(argument));
            let diagnostic = diagnostic.label(format!("this is {}", describe(x.shape())));
            return Err(self.report(diagnostic.hint("the length of a vector is `norm(v)`")));
        }
        if self.is_in_field && self.is_of_solution(x) {
            self.real(argument, x)?;
            return self.root_in_field(x);
        }
        let operands = self.data_of(function, argument, x)?;
        self.root(call, operands[0])
    }

    /// `norm(v)`: the square root of the sum of the squares of all elements.
    pub(super) fn norm(&mut self, call: &ExprCall, function: &BuiltIn, argument: &Expr, v: &Value) -> Outcome<Value> {
        let (_, elements, _) = self.real_elements(v);
        let mut all = Value::array(vec![elements.len()], elements);
        let is_result = self.is_in_field && self.is_of_solution(&all);
        match is_result {
            true => all = self.operand_in_field(&all, argument)?,
            false => drop(self.data_of(function, argument, &all)?),
        }
        let square = self.algebra.dot(&all, &all);
        let square = Value::scalar(self.check(square, call)?);
        if is_result {
            return self.root_in_field(&square);
        }
        let operands = self.data_of(function, argument, &square)?;
        self.root(call, operands[0])
    }

    /// `normalise(v)`: v / norm(v).
    pub(super) fn normalise(
        &mut self,
        call: &ExprCall,
        function: &BuiltIn,
        argument: &Expr,
        v: &Value,
    ) -> Outcome<Value> {
        let norm = self.norm(call, function, argument, v)?;
        let norm = self.algebra.graph.value_of(&norm.elements()[0]);
        let Some(reciprocal) = self.algebra.graph.div(ExpressionGraph::ONE, norm) else {
            let diagnostic = Diagnostic::new("the vector is 0 for all data", place(argument));
            return Err(self.report(diagnostic));
        };
        let result = self.algebra.multiply(v, &Value::scalar(self.algebra.data(reciprocal)));
        self.check(result, call)
    }

    /// The square root of a value of the data. Values are told apart at points over Z_p; where this
    /// one has no root there, the point is moved.
    fn root(&mut self, call: &ExprCall, square: ExpressionId) -> Outcome<Value> {
        let mut random = Random::new(ROOT_SEED);
        for _ in 0..MAX_MOVES {
            let graph = &mut self.algebra.graph;
            if let Some(roots) = graph.derive(DerivationKind::SquareRoot, &[square]) {
                return Ok(Value::scalar(self.algebra.data(roots[0])));
            }
            for (k, field) in FINGERPRINT_FIELDS.into_iter().enumerate() {
                if field.square_root(graph.fingerprint(square)[k]).is_none() {
                    let which = redrawn(graph, graph.derivations().len(), &[square], &mut random);
                    let mut given: Vec<u32> = graph.given_fingerprints(k, which.len());
                    redraw(&self.data, (field, &mut random), &mut given, &which);
                    graph.move_fingerprints(k, &given);
                }
            }
            self.charge(WORK_OF_A_MOVE, call)?;
        }
        let diagnostic = Diagnostic::new("the square root cannot be taken", place(call));
        Err(self
            .report(diagnostic.hint("the root of a constant, or one that depends on many others, is passed as data")))
    }

    /// The values of an array that depends on data only.
    fn data_of(&mut self, function: &BuiltIn, argument: &Expr, value: &Value) -> Outcome<Vec<ExpressionId>> {
        let graph = &self.algebra.graph;
        let of_data = value.elements().iter().map(|element| match *element.terms() {
            [] => Some(ExpressionGraph::ZERO),
            [(Monomial::ONE, coefficient)] if !graph.is_of_solution(coefficient) => Some(coefficient),
            _ => None,
        });
        of_data.collect::<Option<_>>().ok_or_else(|| {
            if let Err(reported) = self.real(argument, value) {
                return reported;
            }
            let message = format!("`{}` is computed from data only", function.name);
            let diagnostic = Diagnostic::new(message, place(argument)).label("this depends on unknowns");
            self.report(diagnostic.hint("state the equations that the result satisfies instead"))
        })
    }

    fn derive(
        &mut self,
        call: &ExprCall,
        kind: DerivationKind,
        operands: &[ExpressionId],
        shape: Vec<usize>,
    ) -> Outcome<Value> {
        if operands.len() > MAX_OPERANDS {
            let diagnostic = Diagnostic::new("there are too many entries", place(call));
            return Err(self.report(diagnostic.label(format!("at most {MAX_OPERANDS} are allowed"))));
        }
        self.charge(kind.operations(), call)?;
        self.limit_elements(kind.results(), kind.results(), call)?;
        match self.algebra.graph.derive(kind, operands) {
            Some(results) => {
                let elements = results.into_iter().map(|result| self.algebra.data(result)).collect();
                Ok(Value::array(shape, elements))
            }
            None => {
                let diagnostic = Diagnostic::new("the matrix is singular for all data", place(call));
                Err(self.report(diagnostic.label("its rows are linearly dependent")))
            }
        }
    }
}
