//! From the graph of coefficient expressions to a straight-line program.

use std::collections::BTreeSet;

use super::program::{Operation, Program, ProgramForm, ValueId};
use super::{PlannedDerivation, PlannedMeasurement};
use crate::expression::derivation::{Derivation, DerivationKind};
use crate::expression::{Expression, ExpressionGraph, ExpressionId};
use crate::problem::Measurement;

/// A program of more steps than this becomes a table. A step takes 0.7 ns in a table and 0.3 ns as
/// a statement. But the time to compile statements grows faster than their number: solvers of
/// 3,700, 13,400 and 17,100 steps take 3.4 s, 11 s and 47 s as statements, and 4 s as tables.
const MOST_STATEMENTS: usize = 4096;
/// The program for a template of more rows than this becomes a table, too. Beside the elimination
/// its time does not matter, and a table can be executed at twice the precision, which finds
/// solutions close to a degenerate instance.
const MOST_ROWS: usize = 40;

/// The program that computes `used`, and the value of each. `rows` is the number of rows of the
/// template that reads them, 0 for results.
pub(crate) fn straight_line_program(
    graph: &ExpressionGraph,
    used: &[ExpressionId],
    rows: usize,
) -> (Program, Vec<ValueId>) {
    let (mut program, values) = in_order_of_the_graph(graph, used);
    if program.steps() <= MOST_STATEMENTS && rows <= MOST_ROWS {
        program.form = ProgramForm::Statements;
        return (program, values);
    }
    in_runs(&program, &values)
}

/// The data that are derived from data, in order. A solve computes what `used` depends on, results
/// what `by_results` depends on.
pub(crate) fn planned_derivations(
    graph: &ExpressionGraph,
    used: &[ExpressionId],
    by_results: &[ExpressionId],
) -> Vec<PlannedDerivation> {
    let needed = graph.needed_by_way_of_derivations(used, |_| true);
    let is_no_choice = |kind: DerivationKind| !matches!(kind, DerivationKind::Least { .. });
    let without_choices = graph.needed_by_way_of_derivations(&[used, by_results].concat(), is_no_choice);
    let planned = |derivation: &Derivation<ExpressionId>| {
        let (program, operands) = statements_in_order(graph, &derivation.operands);
        let Derivation { kind, first_input, .. } = *derivation;
        let derivation = Derivation { kind, operands, first_input };
        let is_among = |needed: &[bool]| derivation.inputs().any(|input| graph.is_input_among(needed, input));
        let (is_for_results, is_tentative) = (!is_among(&needed), !is_among(&without_choices));
        PlannedDerivation { derivation, program, is_for_results, is_tentative }
    };
    graph.derivations().iter().map(planned).collect()
}

/// What is computed from a solution, in two steps: coefficients from the data, once for all
/// solutions, and the results from these and the coordinates of a solution.
///
/// ```text
///   data --[ first ]--> coefficients --+--[ second ]--> results
///                                      |
///   coordinates of a solution ---------+
/// ```
///
/// The inputs of the second program are the coefficients, then the coordinates.
pub(crate) fn programs_of_results(graph: &ExpressionGraph, used: &[ExpressionId]) -> [(Program, Vec<ValueId>); 2] {
    let needed = graph.needed(used);
    let of_solution = |at: usize| needed[at] && graph.is_of_solution(graph.id(at));
    let all = || (0..needed.len()).filter(|&at| of_solution(at));
    let operands = all().flat_map(|at| graph.operands(graph.nodes()[at])).chain(used.iter().copied());
    let of_data: BTreeSet<ExpressionId> = operands.filter(|&id| !graph.is_of_solution(id)).collect();
    let (constants, coefficients): (Vec<_>, Vec<_>) =
        of_data.into_iter().partition(|&id| graph.as_constant(id).is_some());
    let mut inputs = vec![None; needed.len()];
    (0..).zip(&coefficients).for_each(|(number, id)| inputs[id.index()] = Some(number));
    let mut in_second = vec![false; needed.len()];
    all().for_each(|at| in_second[at] = true);
    coefficients.iter().chain(&constants).for_each(|id| in_second[id.index()] = true);
    let input = |at: usize| match graph.nodes()[at] {
        Expression::Unknown(number) => Some(coefficients.len() as u32 + number),
        _ => inputs[at],
    };
    let (mut second, results) = in_order_of_the_graph_from(graph, used, &in_second, input);
    second.form = ProgramForm::Statements;
    [straight_line_program(graph, &coefficients, 0), (second, results)]
}

/// What one measurement gives.
pub(crate) fn planned_measurement(measurement: &Measurement) -> PlannedMeasurement {
    let (program, elements) = statements_in_order(&measurement.graph, &measurement.elements);
    let Measurement { name, docs, data, shape, .. } = measurement.clone();
    PlannedMeasurement { name, docs, data, shape, program, elements }
}

/// The statements that compute `used`, and the value of each.
fn statements_in_order(graph: &ExpressionGraph, used: &[ExpressionId]) -> (Program, Vec<ValueId>) {
    let (mut program, values) = in_order_of_the_graph(graph, used);
    program.form = ProgramForm::Statements;
    (program, values)
}

/// The nodes that `used` depends on, in the order of the graph, and the position of each used one.
///
/// A sum of products is taken whole, even if only some of its coefficients are used: it is computed
/// in one loop.
fn in_order_of_the_graph(graph: &ExpressionGraph, used: &[ExpressionId]) -> (Program, Vec<ValueId>) {
    in_order_of_the_graph_from(graph, used, &graph.needed(used), |_| None)
}

/// Like [`in_order_of_the_graph`], for the nodes that are `needed`. Some of them may be inputs of
/// the program: `input` has their numbers.
fn in_order_of_the_graph_from(
    graph: &ExpressionGraph,
    used: &[ExpressionId],
    needed: &[bool],
    input: impl Fn(usize) -> Option<u32>,
) -> (Program, Vec<ValueId>) {
    let mut position = vec![ValueId(0); needed.len()];
    let mut first_of_sum: Vec<Option<u32>> = vec![None; graph.product_sums().len()];
    let mut program =
        Program { operations: Vec::new(), product_sums: Vec::new(), form: ProgramForm::Table, names: Vec::new() };
    for (at, node) in graph.nodes().iter().enumerate().filter(|&(at, _)| needed[at]) {
        let next = program.operations.len() as u32;
        let to = |id: ExpressionId| position[id.index()];
        let operation = match *node {
            _ if let Some(input) = input(at) => Operation::Input(input),
            Expression::Constant(value) => Operation::Constant(value),
            Expression::Input(input) => Operation::Input(input),
            Expression::Add(a, b) => Operation::Add(to(a), to(b)),
            Expression::Subtract(a, b) => Operation::Subtract(to(a), to(b)),
            Expression::Multiply(a, b) => Operation::Multiply(to(a), to(b)),
            Expression::Divide(a, b) => Operation::Divide(to(a), to(b)),
            Expression::Negate(a) => Operation::Negate(to(a)),
            Expression::Root(a) => Operation::Root(to(a)),
            Expression::Unknown(number) => Operation::Input(number),
            Expression::Coefficient { sum, at: coefficient } => {
                // The first coefficient that is met brings all others of its sum behind it.
                let first = *first_of_sum[sum as usize].get_or_insert_with(|| {
                    let (own, of_sum) = (program.product_sums.len() as u32, graph.product_sums()[sum as usize].map(to));
                    let coefficients = 0..of_sum.length as u32;
                    program.operations.extend(coefficients.map(|at| Operation::Coefficient { sum: own, at }));
                    program.product_sums.push(of_sum);
                    next
                });
                position[at] = ValueId(first + coefficient);
                continue;
            }
        };
        position[at] = ValueId(next);
        program.operations.push(operation);
    }
    let names = graph.names().filter(|(id, _)| needed[id.index()] && input(id.index()).is_none());
    program.names = names.map(|(id, name)| (position[id.index()], name.to_owned())).collect();
    (program, used.iter().map(|id| position[id.index()]).collect())
}

/// The same program in an order of long runs of equal operations, which a table executes as loops.
///
/// The level of a value is the length of the longest chain of steps that leads to it. Values of one
/// level do not depend on each other, so they may be sorted by operation:
///
/// ```text
///   level    0                    1                      2
///          [ constants | inputs | + + + | - - | * * * * | + + | * * | .. ]
/// ```
///
/// The coefficients of a sum of products stay together: all have the level of the first.
fn in_runs(program: &Program, values: &[ValueId]) -> (Program, Vec<ValueId>) {
    let operations = &program.operations;
    let mut chain = vec![0_u32; operations.len()];
    for (at, &operation) in operations.iter().enumerate() {
        chain[at] = match operation {
            Operation::Coefficient { at: 1.., .. } => chain[at - 1],
            _ => program.operands(operation).map(|id| chain[id.0 as usize] + 1).max().unwrap_or(0),
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
        Operation::Root(a) => Operation::Root(to(a)),
        other => other,
    };
    let ordered = Program {
        operations: order.iter().map(moved).collect(),
        product_sums: program.product_sums.iter().map(|sum| sum.map(to)).collect(),
        form: program.form,
        names: program.names.iter().map(|(id, name)| (to(*id), name.clone())).collect(),
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
        Operation::Root(_) => 8,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::Random;
    use crate::algebra::{PRIMES, PrimeField};
    use crate::expression::product_sum::{Product, ProductSum};
    use crate::expression::rational::Rational;

    fn random_program(random: &mut Random) -> Program {
        let operations = vec![Operation::Input(1), Operation::Constant(Rational::integer(3)), Operation::Input(0)];
        let (product_sums, names) = (Vec::new(), vec![(ValueId(1), "three".to_owned())]);
        let mut program = Program { operations, product_sums, form: ProgramForm::Table, names };
        while program.operations.len() < 200 {
            let count = program.operations.len() as u64;
            let mut id = || ValueId(random.below(count) as u32);
            let (a, b, c) = (id(), id(), id());
            let operation = match random.below(6) {
                0 => Operation::Add(a, b),
                1 => Operation::Subtract(a, b),
                2 => Operation::Negate(a),
                3 => {
                    let product = |negative, places| Product { negative, left: vec![a, b], right: vec![b, c], places };
                    let products = vec![product(false, vec![0, 2, 2, 1]), product(true, vec![1, 0, 2, 1])];
                    program.product_sums.push(ProductSum { products, length: 3 });
                    let sum = program.product_sums.len() as u32 - 1;
                    program.operations.extend((0..2).map(|at| Operation::Coefficient { sum, at }));
                    Operation::Coefficient { sum, at: 2 }
                }
                _ => Operation::Multiply(a, b),
            };
            program.operations.push(operation);
        }
        program
    }

    #[test]
    fn the_order_of_runs_changes_no_value() {
        let f = PrimeField::new(PRIMES[0]);
        for seed in 0..50 {
            let mut random = Random::new(seed);
            let program = random_program(&mut random);
            let inputs = [random.below(1 << 30) as u32, random.below(1 << 30) as u32];
            let all: Vec<ValueId> = (0..program.operations.len() as u32).map(ValueId).collect();
            let (ordered, moved) = in_runs(&program, &all);
            assert!(program.is_ordered(2) && ordered.is_ordered(2), "seed {seed}");
            let [before, after] = [&program, &ordered].map(|program| program.evaluate(f, &inputs).unwrap());
            let found: Vec<u32> = moved.iter().map(|id| after[id.0 as usize]).collect();
            assert_eq!(found, before, "seed {seed}");
            assert_eq!(ordered.names, [(moved[1], "three".to_owned())], "seed {seed}");
            let [constant, inputs @ ..] = &ordered.operations[..3] else { unreachable!() };
            assert_eq!(*constant, program.operations[1]);
            assert!(inputs.iter().all(|operation| matches!(operation, Operation::Input(_))));
        }
    }

    /// What depends on data only is computed once: the product of both inputs and a quotient are
    /// the coefficients, constants are not, and nothing that depends on the solution is.
    #[test]
    fn results_are_computed_in_two_steps() {
        let mut graph = ExpressionGraph::new(&[vec![12_345, 67_890], vec![54_321, 9_876]]);
        let (a, b) = (graph.input(0), graph.input(1));
        let [x, y] = [0, 1].map(|number| graph.unknown(number));
        let (product, three) = (graph.mul(a, b), graph.constant(Rational::integer(3)));
        let (scaled, sum) = (graph.mul(product, x), graph.add(x, y));
        let of_unknowns = graph.mul(sum, three);
        let square = graph.mul(scaled, scaled);
        let root = graph.root(square);
        let quotient = graph.div(a, b).unwrap();
        let last = graph.div(root, of_unknowns).unwrap();
        let [(first, coefficients), (second, results)] =
            programs_of_results(&graph, &[scaled, quotient, last, ExpressionGraph::ONE]);
        assert_eq!((coefficients.len(), results.len()), (2, 4));
        assert!(first.is_ordered(2) && second.is_ordered(4));
        let constants = second.operations.iter().filter(|operation| matches!(operation, Operation::Constant(_)));
        assert_eq!(constants.count(), 2);
        let f = PrimeField::new(PRIMES[0]);
        let (a, b, x, y) = (91, 92, 93, 94);
        let values = first.evaluate(f, &[a, b]).unwrap();
        let coefficients: Vec<u32> = coefficients.iter().map(|id| values[id.0 as usize]).collect();
        let values = second.evaluate(f, &[&coefficients[..], &[x, y]].concat()).unwrap();
        let [scaled, quotient, last, one] = [0, 1, 2, 3].map(|at: usize| values[results[at].0 as usize]);
        assert_eq!((scaled, f.mul(quotient, b), one), (f.mul(f.mul(a, b), x), a, 1));
        // Of the square one of both roots.
        let root = f.mul(last, 3 * (x + y));
        assert!([scaled, f.sub(0, scaled)].contains(&root));
    }

    /// A long program and one of a large template are tables; up to the limits they are statements.
    #[test]
    fn the_form_follows_from_the_sizes() {
        let form = |steps: usize, rows: usize| {
            let mut graph = ExpressionGraph::new(&[vec![12_345, 67_890], vec![54_321, 9_876]]);
            let (mut value, factor) = (graph.input(0), graph.input(1));
            (0..steps).for_each(|_| value = graph.mul(value, factor));
            let (program, values) = straight_line_program(&graph, &[value], rows);
            assert_eq!((program.steps(), values.len()), (steps, 1));
            program.form
        };
        for (steps, rows, expected) in [
            (1, 1, ProgramForm::Statements),
            (MOST_STATEMENTS, MOST_ROWS, ProgramForm::Statements),
            (MOST_STATEMENTS + 1, 1, ProgramForm::Table),
            (1, MOST_ROWS + 1, ProgramForm::Table),
        ] {
            assert_eq!(form(steps, rows), expected, "{steps} steps, {rows} rows");
        }
    }
}
