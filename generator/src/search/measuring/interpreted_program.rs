//! Coefficients of an interpreted solver: the runtime's `Program`, owned.

use eliminant::Scalar;
use eliminant::emitted::{self, Condition};

use crate::plan::Plan;
use crate::plan::program::{self, ValueId};
use crate::plan::program_table::{ProgramTable, StepKind};
use crate::problem::{DataAttribute, DataParameter};

/// The runtime's `Program`, owned.
#[derive(Clone, Debug)]
pub(super) struct Program {
    constants: Vec<f64>,
    runs: Vec<emitted::Run>,
    operands: Vec<(u32, u32)>,
    sums: Vec<emitted::ProductSum>,
    products: Vec<emitted::PolynomialProduct>,
    factors: Vec<Vec<u32>>,
    places: Vec<Vec<u32>>,
    pub(super) results: Vec<u32>,
    pub(super) values: usize,
}

impl Program {
    pub(super) fn of(plan: &Plan) -> Self {
        let table = ProgramTable::of(plan);
        let operation = |kind: StepKind| match kind {
            StepKind::Add => emitted::Operation::Add,
            StepKind::Subtract => emitted::Operation::Subtract,
            StepKind::Multiply => emitted::Operation::Multiply,
            StepKind::Divide => emitted::Operation::Divide,
            StepKind::Negate => emitted::Operation::Negate,
            StepKind::ProductSum => emitted::Operation::ProductSum,
        };
        let runs = table.runs.iter().map(|&(kind, steps)| emitted::Run { operation: operation(kind), steps });
        let sums = table.sums.iter().map(|&(products, length)| emitted::ProductSum { products, length });
        let products = table.products.iter().map(|product| emitted::PolynomialProduct {
            negative: product.negative,
            left: product.left,
            right: product.right,
            places: product.places,
        });
        Self {
            constants: table.constants.iter().map(|c| c.numerator() as f64 / c.denominator() as f64).collect(),
            runs: runs.collect(),
            operands: table.operands,
            sums: sums.collect(),
            products: products.collect(),
            factors: table.factors,
            places: table.places,
            results: table.results,
            values: table.values,
        }
    }

    /// Factors and places, as [`Program::view`] takes them.
    pub(super) fn lists(&self) -> [Vec<&[u32]>; 2] {
        [&self.factors, &self.places].map(|lists| lists.iter().map(Vec::as_slice).collect())
    }

    /// The runtime's program.
    pub(super) fn view<'a>(&'a self, [factors, places]: &'a [Vec<&'a [u32]>; 2]) -> emitted::Program<'a> {
        emitted::Program {
            constants: &self.constants,
            runs: &self.runs,
            operands: &self.operands,
            product_sums: emitted::ProductSums { sums: &self.sums, products: &self.products, factors, places },
            results: &self.results,
        }
    }

    /// The coefficients for these data, in their precision.
    pub(super) fn evaluate_on<R: Scalar>(&self, data: &[R]) -> Vec<R> {
        let (mut values, mut coefficients) = (vec![R::ZERO; self.values], vec![R::ZERO; self.results.len()]);
        self.view(&self.lists()).run_on(data, &mut values, &mut coefficients);
        coefficients
    }

    /// The coefficients for these data.
    pub(super) fn evaluate<R: Scalar>(&self, data: &[f64]) -> Vec<R> {
        let (mut values, mut coefficients) = (vec![R::ZERO; self.values], vec![R::ZERO; self.results.len()]);
        self.view(&self.lists()).run(&[data], &mut values, &mut coefficients);
        coefficients
    }
}

/// The values of all operations of a program in statements, in the precision of the inputs.
pub(super) fn values<R: Scalar>(program: &program::Program, inputs: &[R]) -> Vec<R> {
    let mut values: Vec<R> = Vec::with_capacity(program.operations.len());
    for &operation in &program.operations {
        let at = |id: ValueId| values[id.0 as usize];
        let value = match operation {
            program::Operation::Constant(c) => R::from_f64(c.to_f64()),
            program::Operation::Input(input) => inputs[input as usize],
            program::Operation::Add(a, b) => at(a) + at(b),
            program::Operation::Subtract(a, b) => at(a) - at(b),
            program::Operation::Multiply(a, b) => at(a) * at(b),
            program::Operation::Divide(a, b) => at(a) / at(b),
            program::Operation::Negate(a) => -at(a),
            program::Operation::Root(a) => at(a).sqrt(),
            program::Operation::Coefficient { sum, at: own } => {
                let terms = program.product_sums[sum as usize].terms(own as usize);
                let signed = terms.map(|(negative, a, b)| if negative { -(at(a) * at(b)) } else { at(a) * at(b) });
                signed.reduce(|sum, term| sum + term).unwrap_or(R::ZERO)
            }
        };
        values.push(value);
    }
    values
}

/// What the data of a parameter satisfy.
pub(super) fn condition(parameter: &DataParameter) -> Condition {
    let [rows, columns] = parameter.last_dimensions().map(|dimension| dimension as u32);
    match parameter.attribute {
        DataAttribute::Generic | DataAttribute::Integer => Condition::Free,
        DataAttribute::Symmetric => Condition::Symmetric(columns),
        DataAttribute::Unit => Condition::Unit(columns),
        DataAttribute::Rotation => Condition::Rotation,
        DataAttribute::Plucker => Condition::Plucker,
        DataAttribute::Rank(_) => Condition::Rank(rows, columns),
    }
}
