//! Straight-line code as a table of instructions.

use std::collections::BTreeMap;

use super::Plan;
use super::program::{Operation, Program, ValueId};
use crate::expression::rational::Rational;

/// The operation of all steps of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StepKind {
    /// a + b
    Add,
    /// a - b
    Subtract,
    /// a b
    Multiply,
    /// a / b
    Divide,
    /// -a
    Negate,
    /// All coefficients of a sum of products of polynomials.
    ProductSum,
}

/// A product of two polynomials that is added to a sum, or subtracted from it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ProductEntry {
    /// Whether it is subtracted.
    pub negative: bool,
    /// The number of the left factor.
    pub left: u32,
    /// The number of the right factor.
    pub right: u32,
    /// The number of its list of places.
    pub places: u32,
}

/// Straight-line code from the data to the coefficients, as the runtime's `Program` executes it.
///
/// ```text
///   values     [ constants | data, one parameter after another | result of step 0, of step 1, .. ]
///   operands   the positions in values of the operands of each step, all before its own run
///   results    the positions in values of the coefficients
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProgramTable {
    /// Numbers that do not depend on the data.
    pub constants: Vec<Rational>,
    /// Consecutive steps of one kind that do not read each other's results, and their number.
    pub runs: Vec<(StepKind, u32)>,
    /// (a, b) of each step with scalar operands; a twice for a negation.
    pub operands: Vec<(u32, u32)>,
    /// (number of products, number of coefficients) of each sum of products.
    pub sums: Vec<(u32, u32)>,
    /// The products of all sums, one sum after another.
    pub products: Vec<ProductEntry>,
    /// Polynomials: the positions in values of their coefficients. Equal ones are listed once.
    pub factors: Vec<Vec<u32>>,
    /// For each product of two factors' coefficients, the coefficient of the sum that it is added
    /// to. Equal lists are kept once.
    pub places: Vec<Vec<u32>>,
    /// The positions in values of the coefficients.
    pub results: Vec<u32>,
    /// The number of values.
    pub values: usize,
}

impl ProgramTable {
    /// The table of a plan's program.
    pub fn of(plan: &Plan) -> Self {
        Self::of_program(&plan.program, plan.inputs(), &plan.coefficients)
    }

    /// The number of values of a table.
    pub fn values_of(program: &Program, inputs: usize) -> usize {
        let is_value = |operation: &&Operation| !matches!(operation, Operation::Input(_));
        inputs + program.operations.iter().filter(is_value).count()
    }

    /// The table of a program from so many data to these values. All data have a position, also
    /// those that no step reads.
    pub fn of_program(program: &Program, inputs: usize, values: &[ValueId]) -> Self {
        let as_constant = |operation: &Operation| match operation {
            Operation::Constant(value) => Some(*value),
            _ => None,
        };
        let constants: Vec<Rational> = program.operations.iter().filter_map(as_constant).collect();
        let positions = positions(program, constants.len(), inputs);
        let position = |id: ValueId| positions[id.0 as usize];
        let scalar = |operation: &&Operation| !matches!(operation, Operation::Coefficient { .. });
        let operands = program.operations.iter().filter(scalar).filter_map(|&operation| {
            let mut operands = program.operands(operation);
            let a = operands.next()?;
            Some((position(a), position(operands.next().unwrap_or(a))))
        });
        let mut table = Self {
            values: Self::values_of(program, inputs),
            constants,
            runs: runs(program),
            operands: operands.collect(),
            sums: Vec::new(),
            products: Vec::new(),
            factors: Vec::new(),
            places: Vec::new(),
            results: values.iter().map(|&id| position(id)).collect(),
        };
        table.add_product_sums(program, &positions);
        table
    }

    fn add_product_sums(&mut self, program: &Program, positions: &[u32]) {
        let (mut factors, mut places) = (Lists::default(), Lists::default());
        for operation in &program.operations {
            let Operation::Coefficient { sum, at: 0 } = *operation else { continue };
            let of_sum = &program.product_sums[sum as usize];
            for product in &of_sum.products {
                let mut factor =
                    |ids: &[ValueId]| factors.number(ids.iter().map(|id| positions[id.0 as usize]).collect());
                let (left, right) = (factor(&product.left), factor(&product.right));
                let places = places.number(product.places.clone());
                self.products.push(ProductEntry { negative: product.negative, left, right, places });
            }
            self.sums.push((of_sum.products.len() as u32, of_sum.length as u32));
        }
        (self.factors, self.places) = (factors.lists, places.lists);
    }
}

/// Lists of numbers, each kept once and numbered.
#[derive(Default)]
struct Lists {
    numbers: BTreeMap<Vec<u32>, u32>,
    lists: Vec<Vec<u32>>,
}

impl Lists {
    fn number(&mut self, list: Vec<u32>) -> u32 {
        if let Some(&number) = self.numbers.get(&list) {
            return number;
        }
        let number = self.lists.len() as u32;
        self.lists.push(list.clone());
        self.numbers.insert(list, number);
        number
    }
}

/// The position in the table's values of each value of the program.
fn positions(program: &Program, constants: usize, inputs: usize) -> Vec<u32> {
    let (mut next_constant, mut next_step) = (0, (constants + inputs) as u32);
    let take = |next: &mut u32| {
        *next += 1;
        *next - 1
    };
    let position = |operation: &Operation| match operation {
        Operation::Constant(_) => take(&mut next_constant),
        Operation::Input(input) => constants as u32 + *input,
        _ => take(&mut next_step),
    };
    program.operations.iter().map(position).collect()
}

/// The runs of steps; a sum of products is one step.
///
/// A run ends where the kind changes, or where a step reads a result of its own run: a run is
/// executed as a loop.
fn runs(program: &Program) -> Vec<(StepKind, u32)> {
    let mut runs: Vec<(StepKind, u32)> = Vec::new();
    let mut start = 0;
    for (at, &operation) in program.operations.iter().enumerate() {
        let Some(kind) = kind(operation) else { continue };
        let independent = program.operands(operation).all(|id| (id.0 as usize) < start || !is_step(program, id));
        match runs.last_mut() {
            Some((last, steps)) if *last == kind && independent => *steps += 1,
            _ => {
                runs.push((kind, 1));
                start = at;
            }
        }
    }
    runs
}

fn is_step(program: &Program, id: ValueId) -> bool {
    program.operations.get(id.0 as usize).is_some_and(|operation| operation.is_step())
}

/// The kind of a step. `None` for constants and data, and for all coefficients of a sum of products
/// but the first, which are computed with it. Only results hold roots, and those of a solution are
/// statements.
fn kind(operation: Operation) -> Option<StepKind> {
    Some(match operation {
        Operation::Constant(_) | Operation::Input(_) | Operation::Coefficient { at: 1.., .. } => return None,
        Operation::Root(_) => return None,
        Operation::Add(..) => StepKind::Add,
        Operation::Subtract(..) => StepKind::Subtract,
        Operation::Multiply(..) => StepKind::Multiply,
        Operation::Divide(..) => StepKind::Divide,
        Operation::Negate(_) => StepKind::Negate,
        Operation::Coefficient { at: 0, .. } => StepKind::ProductSum,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::Random;
    use crate::plan::program::ProgramForm;

    /// Data, constants, additions and products in any order, few of them far from what they read.
    fn random_program(random: &mut Random) -> Program {
        let mut operations = vec![Operation::Input(0), Operation::Constant(Rational::integer(3))];
        while operations.len() < 60 {
            let count = operations.len() as u64;
            let mut id = || ValueId((count - 1 - random.below(count.min(6))) as u32);
            let (a, b) = (id(), id());
            operations.push(match random.below(8) {
                0 => Operation::Input(1),
                1 => Operation::Negate(a),
                2 | 3 => Operation::Multiply(a, b),
                _ => Operation::Add(a, b),
            });
        }
        Program { operations, product_sums: Vec::new(), form: ProgramForm::Table, names: Vec::new() }
    }

    /// A run is executed as one loop that reads only what was known before it. Where a run ends,
    /// the next step has another kind or reads a result of the run.
    #[test]
    fn runs_are_as_long_as_no_step_reads_its_own_run() {
        let mut random = Random::new(11);
        let (mut longer, mut ended_by_a_reader) = (0, 0);
        for _ in 0..100 {
            let program = random_program(&mut random);
            let mut steps = (0..program.operations.len()).filter(|&at| program.operations[at].is_step()).peekable();
            let reads = |step: usize, run: &[usize]| {
                program.operands(program.operations[step]).any(|id| run.contains(&(id.0 as usize)))
            };
            for (run_kind, length) in runs(&program) {
                let run: Vec<usize> = steps.by_ref().take(length as usize).collect();
                assert_eq!(run.len(), length as usize);
                for &step in &run {
                    assert_eq!(kind(program.operations[step]), Some(run_kind));
                    assert!(!reads(step, &run), "{:?}", program.operations);
                }
                longer += usize::from(run.len() > 2);
                if let Some(&next) = steps.peek().filter(|&&next| kind(program.operations[next]) == Some(run_kind)) {
                    assert!(reads(next, &run), "{:?}", program.operations);
                    ended_by_a_reader += 1;
                }
            }
            assert_eq!(steps.next(), None);
        }
        assert!(longer > 50 && ended_by_a_reader > 50, "{longer} longer runs, {ended_by_a_reader} ended by a reader");
    }
}
