//! From the graph of coefficient expressions to straight-line code.

use crate::code::{Code, CodeForm, Operation, ValueId};
use crate::expression::{Expression, ExpressionGraph, ExpressionId};

/// Code of more steps than this becomes a table. A step takes 0.7 ns in a table and 0.3 ns as a statement, but the time to compile statements grows
/// faster than their number: solvers of 3,700, 13,400 and 17,100 steps take 3.4 s, 11 s and 47 s, and 4 s with a table.
const MOST_STATEMENTS: usize = 4096;
/// The code for a template of more rows than this becomes a table, too: beside its elimination the time does not matter, and a table can be executed
/// at twice the precision. That is what finds the solutions of instances close to degenerate ones.
const MOST_ROWS: usize = 40;

/// The code that computes `used`, and the value of each. `rows` are those of the template.
pub(crate) fn straight_line_code(graph: &ExpressionGraph, used: &[ExpressionId], rows: usize) -> (Code, Vec<ValueId>) {
    let (mut code, values) = in_order_of_the_graph(graph, used);
    if code.steps() <= MOST_STATEMENTS && rows <= MOST_ROWS {
        code.form = CodeForm::Statements;
        return (code, values);
    }
    in_runs(&code, &values)
}

/// The nodes that `used` depends on, in order, and the position of each used one. A sum of products is there as a whole.
fn in_order_of_the_graph(graph: &ExpressionGraph, used: &[ExpressionId]) -> (Code, Vec<ValueId>) {
    let needed = graph.needed(used);
    let mut position = vec![ValueId(0); needed.len()];
    let mut first_of_sum: Vec<Option<u32>> = vec![None; graph.product_sums().len()];
    let mut code = Code { operations: Vec::new(), product_sums: Vec::new(), form: CodeForm::Table };
    for (at, node) in graph.nodes().iter().enumerate().filter(|&(at, _)| needed[at]) {
        let next = code.operations.len() as u32;
        let to = |id: ExpressionId| position[id.index()];
        let operation = match *node {
            Expression::Constant(value) => Operation::Constant(value),
            Expression::Input(input) => Operation::Input(input),
            Expression::Add(a, b) => Operation::Add(to(a), to(b)),
            Expression::Subtract(a, b) => Operation::Subtract(to(a), to(b)),
            Expression::Multiply(a, b) => Operation::Multiply(to(a), to(b)),
            Expression::Divide(a, b) => Operation::Divide(to(a), to(b)),
            Expression::Negate(a) => Operation::Negate(to(a)),
            Expression::Coefficient { sum, at: coefficient } => {
                let first = *first_of_sum[sum as usize].get_or_insert_with(|| {
                    let (own, of_sum) = (code.product_sums.len() as u32, graph.product_sums()[sum as usize].map(to));
                    let coefficients = 0..of_sum.length as u32;
                    code.operations.extend(coefficients.map(|at| Operation::Coefficient { sum: own, at }));
                    code.product_sums.push(of_sum);
                    next
                });
                position[at] = ValueId(first + coefficient);
                continue;
            }
        };
        position[at] = ValueId(next);
        code.operations.push(operation);
    }
    (code, used.iter().map(|id| position[id.index()]).collect())
}

/// The same code in another order: constants, inputs, then steps by the longest chain of steps that leads to them, those of the same
/// operation together. So the steps of a run do not depend on each other.
fn in_runs(code: &Code, values: &[ValueId]) -> (Code, Vec<ValueId>) {
    let operations = &code.operations;
    let mut chain = vec![0_u32; operations.len()];
    for (at, &operation) in operations.iter().enumerate() {
        chain[at] = match operation {
            Operation::Coefficient { at: 1.., .. } => chain[at - 1],
            _ => code.operands(operation).map(|id| chain[id.0 as usize] + 1).max().unwrap_or(0),
        };
    }
    let mut order: Vec<usize> = (0..operations.len()).collect();
    order.sort_by_key(|&at| (chain[at], kind(operations[at])));
    let mut position = vec![ValueId(0); operations.len()];
    for (new, &old) in (0..).zip(&order) {
        position[old] = ValueId(new);
    }
    let to = |id: ValueId| position[id.0 as usize];
    let moved = |&old: &usize| match operations[old] {
        Operation::Add(a, b) => Operation::Add(to(a), to(b)),
        Operation::Subtract(a, b) => Operation::Subtract(to(a), to(b)),
        Operation::Multiply(a, b) => Operation::Multiply(to(a), to(b)),
        Operation::Divide(a, b) => Operation::Divide(to(a), to(b)),
        Operation::Negate(a) => Operation::Negate(to(a)),
        other => other,
    };
    let ordered = Code {
        operations: order.iter().map(moved).collect(),
        product_sums: code.product_sums.iter().map(|sum| sum.map(to)).collect(),
        form: code.form,
    };
    (ordered, values.iter().map(|&id| to(id)).collect())
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
        Operation::Coefficient { .. } => 7,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{PRIMES, PrimeField};
    use crate::instance::Random;
    use crate::product_sum::{Product, ProductSum};
    use crate::rational::Rational;

    fn random_code(random: &mut Random) -> Code {
        let operations = vec![Operation::Input(1), Operation::Constant(Rational::integer(3)), Operation::Input(0)];
        let mut code = Code { operations, product_sums: Vec::new(), form: CodeForm::Table };
        while code.operations.len() < 200 {
            let count = code.operations.len() as u64;
            let mut id = || ValueId(random.below(count) as u32);
            let (a, b, c) = (id(), id(), id());
            let operation = match random.below(6) {
                0 => Operation::Add(a, b),
                1 => Operation::Subtract(a, b),
                2 => Operation::Negate(a),
                3 => {
                    let product = |negative, to| Product { negative, left: vec![a, b], right: vec![b, c], to };
                    let products = vec![product(false, vec![0, 2, 2, 1]), product(true, vec![1, 0, 2, 1])];
                    code.product_sums.push(ProductSum { products, length: 3 });
                    let sum = code.product_sums.len() as u32 - 1;
                    code.operations.extend((0..2).map(|at| Operation::Coefficient { sum, at }));
                    Operation::Coefficient { sum, at: 2 }
                }
                _ => Operation::Multiply(a, b),
            };
            code.operations.push(operation);
        }
        code
    }

    #[test]
    fn the_order_of_runs_changes_no_value() {
        let f = PrimeField::new(PRIMES[0]);
        for seed in 0..50 {
            let mut random = Random::new(seed);
            let code = random_code(&mut random);
            let inputs = [random.below(1 << 30) as u32, random.below(1 << 30) as u32];
            let all: Vec<ValueId> = (0..code.operations.len() as u32).map(ValueId).collect();
            let (ordered, moved) = in_runs(&code, &all);
            assert!(code.is_ordered(2) && ordered.is_ordered(2), "seed {seed}");
            let [before, after] = [&code, &ordered].map(|code| code.evaluate(f, &inputs).unwrap());
            let found: Vec<u32> = moved.iter().map(|id| after[id.0 as usize]).collect();
            assert_eq!(found, before, "seed {seed}");
            let [constant, inputs @ ..] = &ordered.operations[..3] else { unreachable!() };
            assert_eq!(*constant, code.operations[1]);
            assert!(inputs.iter().all(|operation| matches!(operation, Operation::Input(_))));
        }
    }
}
