//! Coefficients of large problems: arithmetic on the data as a table instead of statements.

use crate::scalar::Real;

/// What every step of a [`Run`] does with its operands a and b.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operation {
    /// a + b
    Add,
    /// a - b
    Subtract,
    /// a * b
    Multiply,
    /// a / b
    Divide,
    /// -a
    Negate,
}

/// Consecutive steps that do the same and do not read each other's results: one decision for all of them.
#[derive(Clone, Copy, Debug)]
pub struct Run {
    /// What they do.
    pub operation: Operation,
    /// How many they are.
    pub steps: u32,
}

/// Straight-line arithmetic from the data to the coefficients.
///
/// ```text
///   values   [ constants | data, one parameter after another | result of step 0, of step 1, .. ]
///   operands   the positions in values of the operands of each step, all before its own run's results
///   results    the positions in values of the coefficients
/// ```
///
/// Statements run in half the time, but the time to compile them grows faster than their number.
#[derive(Clone, Copy, Debug)]
pub struct Program {
    /// Numbers that do not depend on the data.
    pub constants: &'static [f64],
    /// The steps, grouped.
    pub runs: &'static [Run],
    /// (a, b) of each step; a twice for [`Operation::Negate`].
    pub operands: &'static [(u32, u32)],
    /// Where the coefficients are.
    pub results: &'static [u32],
}

impl Program {
    /// The coefficients, C of them, in the precision of `R`. V counts all constants, data and steps; so many numbers are on the stack meanwhile.
    #[inline(never)]
    #[must_use]
    pub fn evaluate<R: Real, const V: usize, const C: usize>(&self, data: &[&[f64]]) -> [R; C] {
        let (mut values, mut coefficients) = ([R::ZERO; V], [R::ZERO; C]);
        self.run(data, &mut values, &mut coefficients);
        coefficients
    }

    /// What would be out of range is left out or NaN; the generator's tables fit.
    #[inline(never)]
    fn run<R: Real>(&self, data: &[&[f64]], values: &mut [R], coefficients: &mut [R]) {
        let nan = R::from_f64(f64::NAN);
        let mut written = 0;
        for given in core::iter::once(&self.constants).chain(data) {
            values[written..].iter_mut().zip(*given).for_each(|(place, &value)| *place = R::from_f64(value));
            written = (written + given.len()).min(values.len());
        }
        let mut operands = self.operands;
        for run in self.runs {
            let (of_run, rest) = operands.split_at((run.steps as usize).min(operands.len()));
            operands = rest;
            let (known, open) = values.split_at_mut(written);
            let steps = open.iter_mut().zip(of_run);
            let at = |position: u32| known.get(position as usize).copied().unwrap_or(nan);
            match run.operation {
                Operation::Add => steps.for_each(|(result, &(a, b))| *result = at(a) + at(b)),
                Operation::Subtract => steps.for_each(|(result, &(a, b))| *result = at(a) - at(b)),
                Operation::Multiply => steps.for_each(|(result, &(a, b))| *result = at(a) * at(b)),
                Operation::Divide => steps.for_each(|(result, &(a, b))| *result = at(a) / at(b)),
                Operation::Negate => steps.for_each(|(result, &(a, _))| *result = -at(a)),
            }
            written = (written + of_run.len()).min(values.len());
        }
        for (coefficient, &position) in coefficients.iter_mut().zip(self.results) {
            *coefficient = values.get(position as usize).copied().unwrap_or(nan);
        }
    }
}

/// All data in one array, one parameter after another; what would be too much is left out.
#[inline]
#[must_use]
pub fn joined<const I: usize>(data: &[&[f64]]) -> [f64; I] {
    let mut joined = [0.0; I];
    joined.iter_mut().zip(data.iter().copied().flatten()).for_each(|(place, &value)| *place = value);
    joined
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::double_double::DoubleDouble;
    use crate::scalar::Scalar;

    const PROGRAM: Program = Program {
        constants: &[3.0],
        runs: &[
            Run { operation: Operation::Multiply, steps: 2 },
            Run { operation: Operation::Subtract, steps: 1 },
            Run { operation: Operation::Divide, steps: 1 },
            Run { operation: Operation::Add, steps: 1 },
            Run { operation: Operation::Negate, steps: 1 },
        ],
        operands: &[(0, 1), (1, 2), (4, 5), (6, 3), (7, 0), (8, 8)],
        results: &[9, 5, 0],
    };

    #[test]
    fn steps_are_executed_in_order() {
        for [a, b, c] in [[1.0, 2.0, 3.0], [-0.5, 1e200, 7.0], [0.1, 0.2, 0.0]] {
            let [first, second, third] = PROGRAM.evaluate::<f64, 10, 3>(&[&[a, b], &[c]]);
            assert_eq!(first.to_bits(), (-((3.0 * a - a * b) / c + 3.0)).to_bits());
            assert_eq!((second, third), (a * b, 3.0));
        }
    }

    #[test]
    fn twice_the_precision_holds_what_cancels() {
        // 3 a - a b = 1 - 2^-60, which is 1 where the products are rounded.
        let (a, b, c) = (1.0 + 2f64.powi(-30), 2.0 + 2f64.powi(-30), 1.0);
        let [precise, ..] = PROGRAM.evaluate::<DoubleDouble, 10, 3>(&[&[a, b], &[c]]);
        let [rounded, ..] = PROGRAM.evaluate::<f64, 10, 3>(&[&[a, b], &[c]]);
        assert_eq!((precise + DoubleDouble::from_f64(4.0)).real(), 2f64.powi(-60));
        assert_eq!(rounded + 4.0, 0.0);
    }

    #[test]
    fn what_is_out_of_range_is_not_a_number() {
        assert!(PROGRAM.evaluate::<f64, 5, 3>(&[&[1.0, 2.0], &[3.0]])[0].is_nan());
        assert!(Program { results: &[99], ..PROGRAM }.evaluate::<f64, 10, 1>(&[&[1.0, 2.0], &[3.0]])[0].is_nan());
    }
}
