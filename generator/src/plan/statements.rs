//! Which values of a straight-line program are statements of the emitted code, and which are parts
//! of others.

use std::collections::BTreeMap;

use super::program::{Operation, Program, ValueId};

/// Operations that a statement holds at most.
const MOST_OPERATIONS: usize = 64;

/// A program of more operations falls into functions of about so many, and is not copied to those
/// that call it: compilers take more than twice as long for twice as long a function, and a call is
/// nothing beside it. The 3,948 operations of five-point on registers of 4 and 8 numbers, whole,
/// took half of the time in which its solver was compiled.
pub const MOST_TOGETHER: usize = 256;

/// Where a value of the program is in the emitted program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Nowhere: nothing reads it. Such are the coefficients of sums that no equation has.
    Unread,
    /// It is part of each expression that reads it.
    Inline,
    /// It is computed by a statement of its own and kept at this position of one array.
    Slot(usize),
    /// It is computed by a statement of its own and kept in a variable with this position among the
    /// program's names.
    Variable(usize),
}

/// The statements that a program is emitted as.
///
/// A value that is read once is part of the expression that reads it: the order of operations is
/// the same. A value that is read more often is kept in one array. Each type that the compiler must
/// find costs time, and thousands of variables, each with its debug information, overflow its
/// stack. So only values that the problem names are variables, and in short programs only:
/// functions share the array. Constants and data need no place.
///
/// ```text
///   program    v0 = a;  v1 = b;  v2 = v0 v1;  v3 = v2 + v0;  v4 = v2 v2;  v5 = v3 - v4
///   places     inline   inline   slot 0       inline         inline       inline
///   emitted    v[0] = a * b;  [v[0] + a - v[0] * v[0]]       for the coefficients [v5]
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Statements {
    /// One for each value of the program.
    pub places: Vec<Place>,
    /// How many values have a slot.
    pub slots: usize,
    /// Whether all are one function.
    pub is_short: bool,
}

impl Statements {
    /// The statements of a program that ends in these coefficients.
    pub fn of(program: &Program, coefficients: &[ValueId]) -> Self {
        let reads = reads(program, coefficients);
        let is_short = program.steps() <= MOST_TOGETHER;
        let mut statements = Self { places: Vec::with_capacity(reads.len()), slots: 0, is_short };
        // Operations of the expression of each value: its own and those of its inline operands.
        let mut operations: Vec<usize> = Vec::with_capacity(reads.len());
        let names = program.names.iter().enumerate().filter(|_| is_short);
        let names: BTreeMap<ValueId, usize> = names.map(|(at, (id, _))| (*id, at)).collect();
        for ((id, &operation), &reads) in (0..).map(ValueId).zip(&program.operations).zip(&reads) {
            let of_operands: usize = program.read_by(operation).iter().map(|id| operations[id.0 as usize]).sum();
            let of_expression = own_operations(program, operation) + of_operands;
            let is_inline = match reads {
                1 => of_expression < MOST_OPERATIONS,
                _ => !operation.is_step(),
            };
            let place = match (reads, names.get(&id)) {
                (0, _) => Place::Unread,
                (_, Some(&name)) => Place::Variable(name),
                (_, None) if is_inline => Place::Inline,
                (_, None) => Place::Slot(statements.slots),
            };
            statements.slots += usize::from(matches!(place, Place::Slot(_)));
            statements.places.push(place);
            operations.push(if place == Place::Inline { of_expression } else { 0 });
        }
        statements
    }

    /// Whether a scalar of the data is read.
    pub fn reads_input(&self, program: &Program, input: usize) -> bool {
        let is_input = |operation: &Operation| matches!(operation, Operation::Input(at) if *at as usize == input);
        program.operations.iter().zip(&self.places).any(|(operation, &at)| at != Place::Unread && is_input(operation))
    }
}

/// How often each value of the program is read by what is emitted.
fn reads(program: &Program, coefficients: &[ValueId]) -> Vec<usize> {
    let mut reads = vec![0; program.operations.len()];
    coefficients.iter().for_each(|id| reads[id.0 as usize] += 1);
    // Operands come before their users: from the back each number is complete when it is looked at.
    for position in (0..reads.len()).rev() {
        if reads[position] > 0 {
            program.read_by(program.operations[position]).iter().for_each(|id| reads[id.0 as usize] += 1);
        }
    }
    reads
}

/// The operations that the expression of a value has besides those of its operands.
fn own_operations(program: &Program, operation: Operation) -> usize {
    match operation {
        Operation::Constant(_) | Operation::Input(_) => 0,
        Operation::Coefficient { sum, at } => {
            let mut terms = program.product_sums[sum as usize].terms(at as usize).peekable();
            // A sum that begins with a subtraction negates its first product.
            let negation = usize::from(terms.peek().is_some_and(|(negative, ..)| *negative));
            (2 * terms.count()).saturating_sub(1) + negation
        }
        _ => 1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::product_sum::{Product, ProductSum};
    use crate::expression::rational::Rational;
    use crate::plan::program::ProgramForm;

    fn program(operations: Vec<Operation>, product_sums: Vec<ProductSum<ValueId>>) -> Program {
        Program { operations, product_sums, form: ProgramForm::Statements, names: Vec::new() }
    }

    #[test]
    fn what_is_read_once_is_part_of_its_reader() {
        let [a, b, product, sum, square, last] = [0, 1, 2, 3, 4, 5].map(ValueId);
        let operations = vec![
            Operation::Input(0),
            Operation::Input(1),
            Operation::Multiply(a, b),
            Operation::Add(product, a),
            Operation::Multiply(product, product),
            Operation::Subtract(sum, square),
            Operation::Input(2),
            Operation::Negate(ValueId(6)),
        ];
        let program = program(operations, Vec::new());
        let statements = Statements::of(&program, &[last]);
        let places = [Place::Inline, Place::Inline, Place::Slot(0), Place::Inline, Place::Inline, Place::Inline];
        assert_eq!((&statements.places[..6], statements.slots), (places.as_slice(), 1));
        assert_eq!(statements.places[6..], [Place::Unread, Place::Unread]);
        assert_eq!([0, 1, 2].map(|input| statements.reads_input(&program, input)), [true, true, false]);
    }

    #[test]
    fn named_values_of_short_programs_are_variables() {
        for (count, expected) in [(MOST_TOGETHER, MOST_TOGETHER - 1), (MOST_TOGETHER + 1, 0)] {
            let mut operations = vec![Operation::Input(0)];
            operations.extend((0..count as u32).map(|at| Operation::Add(ValueId(at), ValueId(0))));
            let mut program = program(operations, Vec::new());
            // The last value is read by nothing, the others once.
            program.names = (1..=count as u32).rev().map(|at| (ValueId(at), format!("v{at}"))).collect();
            let statements = Statements::of(&program, &[ValueId(count as u32 - 1)]);
            assert_eq!(statements.is_short, count <= MOST_TOGETHER);
            assert_eq!(statements.places[count], Place::Unread);
            assert_eq!(statements.places[count - 1] == Place::Variable(1), statements.is_short);
            let variables = statements.places.iter().filter(|place| matches!(place, Place::Variable(_)));
            assert_eq!(variables.count(), expected);
        }
    }

    #[test]
    fn long_expressions_are_split() {
        let mut operations = vec![Operation::Input(0), Operation::Constant(Rational::integer(2))];
        let steps = 3 * MOST_OPERATIONS;
        operations.extend((1..=steps as u32).map(|at| Operation::Add(ValueId(at), ValueId(0))));
        let last = ValueId(operations.len() as u32 - 1);
        let statements = Statements::of(&program(operations, Vec::new()), &[last]);
        assert_eq!(statements.slots, 3);
        assert_eq!(statements.places[1 + MOST_OPERATIONS], Place::Slot(0));
    }

    #[test]
    fn coefficients_of_a_sum_read_their_own_terms_only() {
        // (a + b t) (a + b t): the coefficients a a, a b + b a, b b; the middle one is used.
        let [a, b] = [0, 1].map(ValueId);
        let product = Product { negative: true, left: vec![a, b], right: vec![a, b], places: vec![0, 1, 1, 2] };
        let sum = ProductSum { products: vec![product], length: 3 };
        let mut operations = vec![Operation::Input(0), Operation::Input(1)];
        operations.extend((0..3).map(|at| Operation::Coefficient { sum: 0, at }));
        let program = program(operations, vec![sum]);
        let statements = Statements::of(&program, &[ValueId(3)]);
        assert_eq!(statements.places, [Place::Inline, Place::Inline, Place::Unread, Place::Inline, Place::Unread]);
        // - a b - b a: two products, a negation and a subtraction.
        assert_eq!(own_operations(&program, program.operations[3]), 4);
    }

    #[test]
    fn a_sum_has_one_operation_less_than_twice_its_products() {
        let [a, b] = [0, 1].map(ValueId);
        for (negative, operations) in [(false, 7), (true, 8)] {
            // Four products and three additions; or a negation, and subtractions.
            let product = Product { negative, left: vec![a, b], right: vec![a, b], places: vec![0; 4] };
            let sums = vec![ProductSum { products: vec![product], length: 1 }];
            let coefficient = Operation::Coefficient { sum: 0, at: 0 };
            let program = program(vec![Operation::Input(0), Operation::Input(1), coefficient], sums);
            assert_eq!(own_operations(&program, coefficient), operations);
        }
    }
}
