//! Coefficients of large problems: arithmetic on the data from a table instead of statements.

#[cfg(feature = "alloc")]
use crate::memory::{HeapRows, Memory};
use crate::number::{Real, Scalar};

/// The operation of every step of a [`Run`] on its operands a and b.
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
    /// The coefficients of a [`ProductSum`], which is one step with several results.
    ProductSum,
}

/// Consecutive steps with the same operation that do not read each other's results. The operation
/// is decoded once for all of them.
#[derive(Clone, Copy, Debug)]
pub struct Run {
    /// The operation of the steps.
    pub operation: Operation,
    /// The number of steps.
    pub steps: u32,
}

/// Sums of products of polynomials, in the order of execution.
#[derive(Clone, Copy, Debug)]
pub struct ProductSums<'a> {
    /// The sums.
    pub sums: &'a [ProductSum],
    /// The products of all sums, one sum after another.
    pub products: &'a [PolynomialProduct],
    /// Polynomials: the positions of their coefficients in `values`.
    pub factors: &'a [&'a [u32]],
    /// For each coefficient of a left factor: the coefficients of the sum to which its products
    /// with the coefficients of the right factor are added.
    pub places: &'a [&'a [u32]],
}

/// One sum of [`ProductSums`].
#[derive(Clone, Copy, Debug)]
pub struct ProductSum {
    /// The number of products.
    pub products: u32,
    /// The number of coefficients.
    pub length: u32,
}

/// A product of two polynomials, `coefficient[places[i |right| + j]] += left[i] right[j]` for all i
/// and j.
#[derive(Clone, Copy, Debug)]
pub struct PolynomialProduct {
    /// Whether the product is subtracted.
    pub negative: bool,
    /// The position of the left factor in the list of factors.
    pub left: u32,
    /// The position of the right factor.
    pub right: u32,
    /// The position of its list of places.
    pub places: u32,
}

impl<'a> ProductSums<'a> {
    /// Computes the next sums and removes them from the lists. `known` are the values before this
    /// run, `open` receives the results. Returns the number of results.
    fn run<R: Scalar>(&mut self, steps: u32, known: &[R], open: &mut [R]) -> usize {
        let mut written = 0;
        for _ in 0..steps {
            let Some((of_sum, sums)) = self.sums.split_first() else { break };
            let (products, rest) = self.products.split_at((of_sum.products as usize).min(self.products.len()));
            (self.sums, self.products) = (sums, rest);
            let open = &mut open[written..];
            let length = (of_sum.length as usize).min(open.len());
            let sum = &mut open[..length];
            // -0 + x is x for every x.
            sum.fill(R::from_f64(-0.0));
            products.iter().for_each(|product| self.add(product, known, sum));
            written += length;
        }
        written
    }

    /// Adds a product to `sum`; `known` are the values before this run.
    fn add<R: Scalar>(&self, product: &PolynomialProduct, known: &[R], sum: &mut [R]) {
        let list = |lists: &'a [&'a [u32]], at: u32| lists.get(at as usize).copied().unwrap_or(&[]);
        let (left, right) = (list(self.factors, product.left), list(self.factors, product.right));
        let at = |position: u32| known.get(position as usize).copied().unwrap_or(R::from_f64(f64::NAN));
        let places = list(self.places, product.places).chunks_exact(right.len().max(1));
        for (&left, places) in left.iter().zip(places) {
            let factor = if product.negative { -at(left) } else { at(left) };
            for (&right, &place) in right.iter().zip(places) {
                if let Some(sum) = sum.get_mut(place as usize) {
                    *sum += factor * at(right);
                }
            }
        }
    }
}

/// Straight-line arithmetic from the data to the coefficients.
///
/// ```text
///   values     [ constants | data, one parameter after another | results of step 0, step 1, .. ]
///   operands   positions in values of the operands of each step, before the results of its run
///   results    positions in values of the coefficients
/// ```
///
/// Statements run twice as fast, but the time to compile them grows faster than their number.
#[derive(Clone, Copy, Debug)]
pub struct Program<'a> {
    /// Numbers that do not depend on the data.
    pub constants: &'a [f64],
    /// The steps, grouped into runs.
    pub runs: &'a [Run],
    /// The operands (a, b) of each step; (a, a) for [`Operation::Negate`].
    pub operands: &'a [(u32, u32)],
    /// The sums that the runs of [`Operation::ProductSum`] execute, one after another.
    pub product_sums: ProductSums<'a>,
    /// The positions of the coefficients in `values`.
    pub results: &'a [u32],
}

impl Program<'_> {
    /// Computes the C coefficients in the precision of `R`. V is the number of constants, data and
    /// results; that many numbers are on the stack meanwhile.
    #[inline(never)]
    #[must_use]
    pub fn evaluate<R: Real, const V: usize, const C: usize>(&self, data: &[&[f64]]) -> [R; C] {
        let (mut values, mut coefficients) = ([R::ZERO; V], [R::ZERO; C]);
        self.run(data, &mut values, &mut coefficients);
        coefficients
    }

    /// Like [`Program::evaluate`], from data in that precision.
    #[inline(never)]
    #[must_use]
    pub fn evaluate_on<R: Real, const V: usize, const C: usize>(&self, data: &[R]) -> [R; C] {
        let (mut values, mut coefficients) = ([R::ZERO; V], [R::ZERO; C]);
        self.run_on(data, &mut values, &mut coefficients);
        coefficients
    }

    /// Like [`Program::evaluate_on`], with so many `values` and `coefficients` on the heap.
    #[cfg(feature = "alloc")]
    #[inline(never)]
    #[must_use]
    pub fn evaluate_on_heap_on<'w, R: Real>(
        &self,
        (values, coefficients): (usize, usize),
        data: &[R],
        memory: &'w Memory,
    ) -> HeapRows<'w, R> {
        let mut coefficients = memory.filled(coefficients, R::ZERO);
        self.run_on(data, memory.filled(values, R::ZERO).as_mut(), coefficients.as_mut());
        coefficients
    }

    /// Like [`Program::evaluate`], with so many `values` and `coefficients` on the heap.
    #[cfg(feature = "alloc")]
    #[inline(never)]
    #[must_use]
    pub fn evaluate_on_heap<'w, R: Real>(
        &self,
        (values, coefficients): (usize, usize),
        data: &[&[f64]],
        memory: &'w Memory,
    ) -> HeapRows<'w, R> {
        let mut coefficients = memory.filled(coefficients, R::ZERO);
        self.run(data, memory.filled(values, R::ZERO).as_mut(), coefficients.as_mut());
        coefficients
    }

    /// Computes the coefficients on slices. `values` has an entry for each constant, datum and
    /// result, and is overwritten. A position out of range reads as NaN, and a result out of range
    /// is dropped; the generator's tables stay in range.
    #[inline(never)]
    pub fn run<R: Scalar>(&self, data: &[&[f64]], values: &mut [R], coefficients: &mut [R]) {
        let given = core::iter::once(&self.constants).chain(data).copied().flatten();
        let known = values.iter_mut().zip(given).map(|(place, &value)| *place = R::from_f64(value)).count();
        self.execute(known, values, coefficients);
    }

    /// As [`Program::run`], on data of the same kind as the results.
    pub fn run_on<S: Scalar>(&self, data: &[S], values: &mut [S], coefficients: &mut [S]) {
        let given = self.constants.iter().map(|&value| S::from_f64(value)).chain(data.iter().copied());
        let known = values.iter_mut().zip(given).map(|(place, value)| *place = value).count();
        self.execute(known, values, coefficients);
    }

    /// Executes all steps after so many known values.
    fn execute<R: Scalar>(&self, mut written: usize, values: &mut [R], coefficients: &mut [R]) {
        let nan = R::from_f64(f64::NAN);
        let (mut operands, mut sums) = (self.operands, self.product_sums);
        for run in self.runs {
            let (known, open) = values.split_at_mut(written);
            let at = |position: u32| known.get(position as usize).copied().unwrap_or(nan);
            let scalar_steps = if run.operation == Operation::ProductSum { 0 } else { run.steps as usize };
            let (of_run, rest) = operands.split_at(scalar_steps.min(operands.len()));
            operands = rest;
            written += of_run.len().min(open.len());
            let steps = open.iter_mut().zip(of_run);
            match run.operation {
                Operation::Add => steps.for_each(|(result, &(a, b))| *result = at(a) + at(b)),
                Operation::Subtract => steps.for_each(|(result, &(a, b))| *result = at(a) - at(b)),
                Operation::Multiply => steps.for_each(|(result, &(a, b))| *result = at(a) * at(b)),
                Operation::Divide => steps.for_each(|(result, &(a, b))| *result = at(a) / at(b)),
                Operation::Negate => steps.for_each(|(result, &(a, _))| *result = -at(a)),
                Operation::ProductSum => written += sums.run(run.steps, known, open),
            }
        }
        for (coefficient, &position) in coefficients.iter_mut().zip(self.results) {
            *coefficient = values.get(position as usize).copied().unwrap_or(nan);
        }
    }
}

/// All data in one array, one parameter after another; data beyond I entries are dropped.
#[inline]
#[must_use]
pub fn joined<const I: usize>(data: &[&[f64]]) -> [f64; I] {
    let mut joined = [0.0; I];
    join_into(data, &mut joined);
    joined
}

/// Writes all data, one parameter after another; data for which there is no place are dropped.
#[inline]
pub fn join_into(data: &[&[f64]], joined: &mut [f64]) {
    joined.iter_mut().zip(data.iter().copied().flatten()).for_each(|(place, &value)| *place = value);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Scalar;
    use crate::number::double_double::DoubleDouble;

    const PROGRAM: Program<'static> = Program {
        constants: &[3.0],
        runs: &[
            Run { operation: Operation::Multiply, steps: 2 },
            Run { operation: Operation::Subtract, steps: 1 },
            Run { operation: Operation::Divide, steps: 1 },
            Run { operation: Operation::Add, steps: 1 },
            Run { operation: Operation::Negate, steps: 1 },
        ],
        operands: &[(0, 1), (1, 2), (4, 5), (6, 3), (7, 0), (8, 8)],
        product_sums: ProductSums { sums: &[], products: &[], factors: &[], places: &[] },
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
    // (3 + a x) (b + c x) - (a + b x) (a + b x), and a square after it
    const WITH_SUMS: Program<'static> = Program {
        constants: &[3.0],
        runs: &[
            Run { operation: Operation::ProductSum, steps: 2 },
            Run { operation: Operation::Negate, steps: 1 },
            Run { operation: Operation::ProductSum, steps: 1 },
        ],
        operands: &[(4, 4)],
        product_sums: ProductSums {
            sums: &[
                ProductSum { products: 2, length: 3 },
                ProductSum { products: 1, length: 1 },
                ProductSum { products: 1, length: 1 },
            ],
            products: &[
                PolynomialProduct { negative: false, left: 0, right: 1, places: 0 },
                PolynomialProduct { negative: true, left: 2, right: 2, places: 0 },
                PolynomialProduct { negative: false, left: 3, right: 3, places: 1 },
                PolynomialProduct { negative: true, left: 4, right: 4, places: 1 },
            ],
            factors: &[&[0, 1], &[2, 3], &[1, 2], &[2], &[8]],
            places: &[&[0, 1, 1, 2], &[0]],
        },
        results: &[4, 5, 6, 7, 8, 9],
    };

    #[test]
    fn products_are_added_in_order() {
        for [a, b, c] in [[1.0, 2.0, 3.0], [-0.5, 1e100, 7.0], [0.1, 0.2, 0.0]] {
            let found = WITH_SUMS.evaluate::<f64, 10, 6>(&[&[a, b], &[c]]);
            let first = 3.0 * b - a * a;
            let expected = [first, 3.0 * c + a * b - a * b - b * a, a * c - b * b, b * b, -first, -(first * first)];
            assert_eq!(found.map(f64::to_bits), expected.map(f64::to_bits), "{a} {b} {c}");
        }
    }

    #[test]
    fn sums_that_do_not_fit_are_cut_off() {
        let short: [f64; 6] = WITH_SUMS.evaluate::<f64, 6, 6>(&[&[1.0, 2.0], &[3.0]]);
        assert!(short[2..].iter().all(|value| value.is_nan()));
        let lists = ProductSums { factors: &[], ..WITH_SUMS.product_sums };
        let empty = Program { product_sums: lists, ..WITH_SUMS }.evaluate::<f64, 10, 6>(&[&[1.0, 2.0], &[3.0]]);
        assert_eq!(empty[..3], [0.0; 3]);
    }
}
