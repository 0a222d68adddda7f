//! From the graph of coefficient expressions to straight-line code.

use crate::expression::{Expression, ExpressionGraph, ExpressionId};
use crate::plan::{CodeForm, Operation, ValueId};

/// Code of more steps than this becomes a table. A step takes 0.7 ns in a table and 0.3 ns as a statement, but the time to compile statements grows
/// faster than their number: solvers of 3,700, 13,400 and 17,100 steps take 3.4 s, 11 s and 47 s, and 4 s with a table.
const MOST_STATEMENTS: usize = 4096;
/// The code for a template of more rows than this becomes a table, too: beside its elimination the time does not matter, and a table can be executed
/// at twice the precision. That is what finds the solutions of instances close to degenerate ones.
const MOST_ROWS: usize = 40;

/// The code that computes `used`, the value of each, and the form to emit it in. `rows` are those of the template.
pub(crate) fn straight_line_code(
    graph: &ExpressionGraph,
    used: &[ExpressionId],
    rows: usize,
) -> (Vec<Operation>, Vec<ValueId>, CodeForm) {
    let (code, values) = in_order_of_the_graph(graph, used);
    let steps = code.iter().filter(|operation| operation.is_step()).count();
    if steps <= MOST_STATEMENTS && rows <= MOST_ROWS {
        return (code, values, CodeForm::Statements);
    }
    let (code, values) = in_runs(&code, &values);
    (code, values, CodeForm::Table)
}

/// The nodes that `used` depends on, in order, and the position of each used one.
fn in_order_of_the_graph(graph: &ExpressionGraph, used: &[ExpressionId]) -> (Vec<Operation>, Vec<ValueId>) {
    let mut needed = vec![false; graph.nodes().len()];
    used.iter().for_each(|id| needed[id.index()] = true);
    for at in (0..needed.len()).rev() {
        if needed[at] {
            operands(graph.nodes()[at]).into_iter().flatten().for_each(|id| needed[id.index()] = true);
        }
    }
    let mut position = vec![ValueId(0); needed.len()];
    let mut code = Vec::new();
    for (at, node) in graph.nodes().iter().enumerate().filter(|&(at, _)| needed[at]) {
        position[at] = ValueId(code.len() as u32);
        let to = |id: ExpressionId| position[id.index()];
        code.push(match *node {
            Expression::Constant(value) => Operation::Constant(value),
            Expression::Input(input) => Operation::Input(input),
            Expression::Add(a, b) => Operation::Add(to(a), to(b)),
            Expression::Subtract(a, b) => Operation::Subtract(to(a), to(b)),
            Expression::Multiply(a, b) => Operation::Multiply(to(a), to(b)),
            Expression::Divide(a, b) => Operation::Divide(to(a), to(b)),
            Expression::Negate(a) => Operation::Negate(to(a)),
        });
    }
    (code, used.iter().map(|id| position[id.index()]).collect())
}

fn operands(node: Expression) -> [Option<ExpressionId>; 2] {
    match node {
        Expression::Constant(_) | Expression::Input(_) => [None, None],
        Expression::Negate(a) => [Some(a), None],
        Expression::Add(a, b) | Expression::Subtract(a, b) | Expression::Multiply(a, b) | Expression::Divide(a, b) => {
            [Some(a), Some(b)]
        }
    }
}

/// The same code in another order: constants, inputs, then steps by the longest chain of steps that leads to them, those of the same
/// operation together. So the steps of a run do not depend on each other.
fn in_runs(code: &[Operation], values: &[ValueId]) -> (Vec<Operation>, Vec<ValueId>) {
    let mut chain = vec![0_u32; code.len()];
    for (at, operation) in code.iter().enumerate() {
        let longest = operation.operands().into_iter().flatten().map(|id| chain[id.0 as usize]).max();
        chain[at] = longest.map_or(0, |longest| longest + 1);
    }
    let mut order: Vec<usize> = (0..code.len()).collect();
    order.sort_by_key(|&at| (chain[at], kind(code[at])));
    let mut position = vec![ValueId(0); code.len()];
    for (new, &old) in (0..).zip(&order) {
        position[old] = ValueId(new);
    }
    let to = |id: ValueId| position[id.0 as usize];
    (order.iter().map(|&old| code[old].with_operands(to)).collect(), values.iter().map(|&id| to(id)).collect())
}

/// The order of operations within a level.
fn kind(operation: Operation) -> u8 {
    match operation {
        Operation::Constant(_) => 0,
        Operation::Input(_) => 1,
        Operation::Add(..) => 2,
        Operation::Subtract(..) => 3,
        Operation::Multiply(..) => 4,
        Operation::Divide(..) => 5,
        Operation::Negate(_) => 6,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{PRIMES, PrimeField};
    use crate::arithmetic::Arithmetic;
    use crate::instance::Random;
    use crate::rational::Rational;

    fn random_code(random: &mut Random) -> Vec<Operation> {
        let mut code = vec![Operation::Input(1), Operation::Constant(Rational::integer(3)), Operation::Input(0)];
        while code.len() < 200 {
            let mut id = || ValueId(random.below(code.len() as u64) as u32);
            let (a, b) = (id(), id());
            code.push(match random.below(5) {
                0 => Operation::Add(a, b),
                1 => Operation::Subtract(a, b),
                2 => Operation::Negate(a),
                _ => Operation::Multiply(a, b),
            });
        }
        code
    }

    fn values(code: &[Operation], inputs: [u32; 2]) -> Vec<u32> {
        let f = PrimeField::new(PRIMES[0]);
        let mut values: Vec<u32> = Vec::new();
        for operation in code {
            let at = |id: ValueId| values[id.0 as usize];
            let value = match *operation {
                Operation::Constant(value) => f.constant(value).unwrap(),
                Operation::Input(input) => inputs[input as usize],
                Operation::Add(a, b) => f.add(at(a), at(b)),
                Operation::Subtract(a, b) => f.sub(at(a), at(b)),
                Operation::Multiply(a, b) => f.mul(at(a), at(b)),
                Operation::Divide(..) => unreachable!("no divisions are drawn"),
                Operation::Negate(a) => f.neg(at(a)),
            };
            values.push(value);
        }
        values
    }

    #[test]
    fn the_order_of_runs_changes_no_value() {
        for seed in 0..50 {
            let mut random = Random::new(seed);
            let code = random_code(&mut random);
            let inputs = [random.below(1 << 30) as u32, random.below(1 << 30) as u32];
            let all: Vec<ValueId> = (0..code.len() as u32).map(ValueId).collect();
            let (ordered, moved) = in_runs(&code, &all);
            let (before, after) = (values(&code, inputs), values(&ordered, inputs));
            let found: Vec<u32> = moved.iter().map(|id| after[id.0 as usize]).collect();
            assert_eq!(found, before, "seed {seed}");
            assert!(ordered[0] == code[1] && ordered[1..3].iter().all(|op| matches!(op, Operation::Input(_))));
        }
    }
}
