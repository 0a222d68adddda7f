//! Straight-line programs: arithmetic from the data to the coefficients, without branches or loops.

use crate::expression::arithmetic::Arithmetic;
use crate::expression::product_sum::ProductSum;
use crate::expression::rational::Rational;

/// Position of a value in [`Program::operations`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ValueId(pub u32);

/// One operation of a program. Its result is the value with the operation's own position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operation {
    /// A constant.
    Constant(Rational),
    /// A scalar of the flattened data.
    Input(u32),
    /// a + b
    Add(ValueId, ValueId),
    /// a - b
    Subtract(ValueId, ValueId),
    /// a * b
    Multiply(ValueId, ValueId),
    /// a / b
    Divide(ValueId, ValueId),
    /// -a
    Negate(ValueId),
    /// A coefficient of one of [`Program::product_sums`]. All coefficients of a sum follow one
    /// another, in order.
    Coefficient {
        /// The number of the sum.
        sum: u32,
        /// The number of the coefficient in the sum.
        at: u32,
    },
    /// The square root of a value that depends on the solution.
    Root(ValueId),
}

impl Operation {
    /// Whether something is computed: neither a constant nor a scalar of the data.
    pub fn is_step(self) -> bool {
        !matches!(self, Self::Constant(_) | Self::Input(_))
    }
}

/// How straight-line code is emitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProgramForm {
    /// A statement for each step.
    Statements,
    /// A table that the run-time library executes. The constants come first, then the inputs. The
    /// results of a run of equal operations are read by later runs only.
    Table,
}

/// Operations from the data to the coefficients, each after those whose values it reads.
///
/// ```text
///   position      0      1      2          3          4                    5
///   operation     3      a      b          0 * 1      (sum 0, at 0)        (sum 0, at 1)
///   value         3      a      b          3 a        the coefficients of a product of polynomials
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Program {
    /// The steps, operands before their users.
    pub operations: Vec<Operation>,
    /// Sums of products of polynomials, by their coefficients.
    pub product_sums: Vec<ProductSum<ValueId>>,
    /// How the program is emitted.
    pub form: ProgramForm,
    /// What the problem calls values, `scale` or `m[0][1]`. Only for people: no step reads it.
    pub names: Vec<(ValueId, String)>,
}

impl Program {
    /// A value that is zero.
    pub fn zero(&mut self) -> ValueId {
        let is_zero = |operation: &Operation| matches!(operation, Operation::Constant(value) if value.numerator() == 0);
        let at = self.operations.iter().position(is_zero).unwrap_or(self.operations.len());
        if at == self.operations.len() {
            self.operations.push(Operation::Constant(Rational::integer(0)));
        }
        ValueId(at as u32)
    }

    /// The values that an operation reads; a coefficient reads all operands of its sum.
    pub fn operands(&self, operation: Operation) -> impl Iterator<Item = ValueId> + '_ {
        let (scalars, sum) = match operation {
            Operation::Constant(_) | Operation::Input(_) => ([None, None], None),
            Operation::Negate(a) | Operation::Root(a) => ([Some(a), None], None),
            Operation::Add(a, b) | Operation::Subtract(a, b) | Operation::Multiply(a, b) | Operation::Divide(a, b) => {
                ([Some(a), Some(b)], None)
            }
            Operation::Coefficient { sum, .. } => ([None, None], self.product_sums.get(sum as usize)),
        };
        scalars.into_iter().flatten().chain(sum.into_iter().flat_map(ProductSum::operands))
    }

    /// The values that one operation needs. A coefficient needs the factors of its own products
    /// only, unlike in [`Program::operands`].
    pub fn read_by(&self, operation: Operation) -> Vec<ValueId> {
        match operation {
            Operation::Coefficient { sum, at } => {
                let terms = self.product_sums[sum as usize].terms(at as usize);
                terms.flat_map(|(_, a, b)| [a, b]).collect()
            }
            _ => self.operands(operation).collect(),
        }
    }

    /// The values of all operations; `None` where an input is missing or a divisor is zero.
    pub fn evaluate<A: Arithmetic>(&self, f: A, inputs: &[A::Value]) -> Option<Vec<A::Value>> {
        let mut values: Vec<A::Value> = Vec::with_capacity(self.operations.len());
        for operation in &self.operations {
            let at = |id: &ValueId| values[id.0 as usize];
            let value = match operation {
                Operation::Constant(value) => f.constant(*value)?,
                Operation::Input(input) => *inputs.get(*input as usize)?,
                Operation::Add(a, b) => f.add(at(a), at(b)),
                Operation::Subtract(a, b) => f.sub(at(a), at(b)),
                Operation::Multiply(a, b) => f.mul(at(a), at(b)),
                Operation::Divide(a, b) => f.div(at(a), at(b))?,
                Operation::Negate(a) => f.neg(at(a)),
                Operation::Root(a) => f.root(at(a))?,
                Operation::Coefficient { sum, at: 0 } => {
                    let sums = self.product_sums.get(*sum as usize)?.evaluate(f, |id| at(&id));
                    values.extend(sums);
                    continue;
                }
                // The first coefficient of the sum has brought all others.
                Operation::Coefficient { .. } => continue,
            };
            values.push(value);
        }
        Some(values)
    }

    /// The number of arithmetic operations.
    pub fn steps(&self) -> usize {
        let scalar =
            |operation: &&Operation| operation.is_step() && !matches!(operation, Operation::Coefficient { .. });
        let sums: usize = self.product_sums.iter().map(ProductSum::operations).sum();
        self.operations.iter().filter(scalar).count() + sums
    }

    /// Whether every value is written before it is read, the coefficients of every sum follow one
    /// another in order, and no input lies beyond `inputs`.
    pub(crate) fn is_ordered(&self, inputs: usize) -> bool {
        self.operations.iter().enumerate().all(|(position, &operation)| match operation {
            Operation::Input(input) => (input as usize) < inputs,
            Operation::Coefficient { sum, at: 0 } => self.product_sums.get(sum as usize).is_some_and(|of_sum| {
                let own = (0..of_sum.length as u32).map(|at| Operation::Coefficient { sum, at });
                let inside = |place: &u32| (*place as usize) < of_sum.length;
                self.operations[position..].iter().copied().take(of_sum.length).eq(own)
                    && of_sum
                        .products
                        .iter()
                        .all(|p| p.places.len() == p.left.len() * p.right.len() && p.places.iter().all(inside))
                    && of_sum.operands().all(|id| (id.0 as usize) < position)
            }),
            Operation::Coefficient { sum, at } => {
                position > 0 && self.operations[position - 1] == Operation::Coefficient { sum, at: at - 1 }
            }
            _ => self.operands(operation).all(|id| (id.0 as usize) < position),
        })
    }
}
