//! Executes a [`crate::plan::Plan`] in any field, step by step as the emitted code does: exactly
//! over Z_p, or in `f64`.

use super::output::PlannedOutput;
use super::{
    ActionRow, Block, CoefficientId, Elimination, LEAST_PIVOT_OF_PRESOLVE, PivotId, Plan, PlannedDerivation, Term,
};
use crate::expression::arithmetic::{Arithmetic, Float64};

/// The values of all coefficients; `None` if a divisor is zero, or an input or a coefficient is not
/// finite.
pub fn coefficients<A: Arithmetic>(plan: &Plan, f: A, inputs: &[A::Value]) -> Option<Vec<A::Value>> {
    if !all_finite(f, inputs) {
        return None;
    }
    let values = plan.program.evaluate(f, &all_inputs(plan, f, inputs)?)?;
    let coefficients: Vec<A::Value> = plan.coefficients.iter().map(|id| values[id.0 as usize]).collect();
    all_finite(f, &coefficients).then_some(coefficients)
}

/// The values of the coefficients of what is returned beside the unknowns, from the data that are
/// given; `None` as for [`coefficients`].
pub fn coefficients_of_results<A: Arithmetic>(
    plan: &Plan,
    output: &PlannedOutput,
    f: A,
    given: &[A::Value],
) -> Option<Vec<A::Value>> {
    let values = output.program.evaluate(f, &derived_inputs(plan, f, given, &|_| true)?)?;
    Some(output.coefficients.iter().map(|id| values[id.0 as usize]).collect())
}

/// The values of all data, from those that are given: the others are derived, or 0 where a solve
/// does not depend on them. Derived data that are there already stay as they are. `None` if a
/// matrix has lost rank.
pub fn all_inputs<A: Arithmetic>(plan: &Plan, f: A, given: &[A::Value]) -> Option<Vec<A::Value>> {
    derived_inputs(plan, f, given, &|planned| !planned.is_for_results)
}

fn derived_inputs<A: Arithmetic>(
    plan: &Plan,
    f: A,
    given: &[A::Value],
    is_wanted: &dyn Fn(&PlannedDerivation) -> bool,
) -> Option<Vec<A::Value>> {
    let mut inputs = given.to_vec();
    for planned in &plan.derived {
        let PlannedDerivation { derivation, program, is_tentative, .. } = planned;
        if !is_wanted(planned) {
            inputs.resize(derivation.inputs().end.max(inputs.len()), f.zero());
        } else if inputs.len() == derivation.first_input {
            let of_presolve = derivation.first_input >= plan.stated;
            let least = if of_presolve { LEAST_PIVOT_OF_PRESOLVE } else { 0.0 };
            let results = program.evaluate(f, &inputs).and_then(|values| {
                let operands: Vec<A::Value> = derivation.operands.iter().map(|id| values[id.0 as usize]).collect();
                f.derive(derivation.kind, &operands, least)
            });
            let nothing = || Some(vec![f.no_number()?; derivation.kind.results()]);
            inputs.extend(results.or_else(|| if *is_tentative { nothing() } else { None })?);
        }
    }
    for planned in plan.derived.iter().filter(|planned| planned.is_tentative) {
        inputs[planned.derivation.inputs()].fill(f.zero());
    }
    Some(inputs)
}

/// Whether all values are finite; over Z_p they are.
fn all_finite<A: Arithmetic>(f: A, values: &[A::Value]) -> bool {
    values.iter().all(|&value| f.pivot_size(value).is_finite())
}

/// The result of the elimination, as rows of |B| values.
#[derive(Clone, Debug, PartialEq)]
pub struct Eliminated<V> {
    /// The action matrix T, |B| rows: a B = T B at every solution.
    pub action: Vec<Vec<V>>,
    /// The monomials of [`Plan::read`] as combinations of B.
    pub read: Vec<Vec<V>>,
}

/// Fills and eliminates the template. `None` if a block is singular or a value overflows.
pub fn eliminate<A: Arithmetic>(plan: &Plan, f: A, coefficients: &[A::Value]) -> Option<Eliminated<A::Value>> {
    let solved = solve_blocks(&plan.elimination, f, coefficients)?;
    let expressed = |pivot: &PivotId| solved[usize::from(pivot.0)].iter().map(|&value| f.neg(value)).collect();
    let row = |row: &ActionRow| match row {
        ActionRow::Unit(b) => {
            let mut unit = vec![f.zero(); plan.elimination.basis];
            unit[usize::from(b.0)] = f.one();
            unit
        }
        ActionRow::Solved(pivot) => expressed(pivot),
    };
    Some(Eliminated { action: plan.action.iter().map(row).collect(), read: plan.read.iter().map(expressed).collect() })
}

/// Computes M_ER^-1 M_B, block by block. Rows of pivots that are not needed are left unfinished.
fn solve_blocks<A: Arithmetic>(plan: &Elimination, f: A, coefficients: &[A::Value]) -> Option<Vec<Vec<A::Value>>> {
    let coefficient = |id: CoefficientId| coefficients[usize::from(id.0)];
    let mut right = vec![vec![f.zero(); plan.basis]; plan.rows];
    for entry in &plan.right {
        right[usize::from(entry.row)][usize::from(entry.column)] = coefficient(entry.coefficient);
    }
    for block in &plan.blocks {
        for entry in &block.coupling {
            let factor = coefficient(entry.coefficient);
            let (solved, open) = right.split_at_mut(block.first);
            subtract_multiple(f, &mut open[usize::from(entry.row)], factor, &solved[usize::from(entry.column)]);
        }
        let mut matrix = vec![vec![f.zero(); block.size]; block.size];
        for entry in &block.diagonal {
            matrix[usize::from(entry.row)][usize::from(entry.column)] = coefficient(entry.coefficient);
        }
        solve_block(f, block, matrix, &mut right[block.first..block.first + block.size])?;
    }
    Some(right)
}

fn subtract_multiple<A: Arithmetic>(f: A, row: &mut [A::Value], factor: A::Value, other: &[A::Value]) {
    for (entry, &value) in row.iter_mut().zip(other) {
        *entry = f.sub(*entry, f.mul(factor, value));
    }
}

/// Gaussian elimination with partial pivoting, in rows that are scaled by their 1-norm. The
/// run-time kernel does the same operations in the same order.
fn solve_block<A: Arithmetic>(
    f: A,
    block: &Block,
    mut matrix: Vec<Vec<A::Value>>,
    right: &mut [Vec<A::Value>],
) -> Option<()> {
    let n = block.size;
    let norms: Vec<f64> = matrix.iter().map(|row| one_norm(f, row)).collect();
    if !(right.iter().all(|row| all_finite(f, row)) && norms.iter().all(|norm| norm.is_finite())) {
        return None;
    }
    let mut row_scale: Vec<f64> = norms.iter().map(|norm| 1.0 / norm).collect();
    let scaled = |matrix: &[Vec<A::Value>], scale: &[f64], i: usize, k: usize| f.pivot_size(matrix[i][k]) * scale[i];
    let largest = |k: usize| (0..n).map(|i| scaled(&matrix, &row_scale, i, k)).fold(0.0, f64::max);
    let threshold = n as f64 * f.rounding();
    let smallest: Vec<f64> = (0..n).map(|k| largest(k) * threshold).collect();
    for k in 0..n {
        let mut pivot = k;
        for i in k + 1..n {
            if scaled(&matrix, &row_scale, i, k) > scaled(&matrix, &row_scale, pivot, k) {
                pivot = i;
            }
        }
        let enough = scaled(&matrix, &row_scale, pivot, k) > smallest[k];
        if !enough {
            return None;
        }
        matrix.swap(k, pivot);
        right.swap(k, pivot);
        row_scale.swap(k, pivot);
        let inverse = f.div(f.one(), matrix[k][k])?;
        let (above, below) = matrix.split_at_mut(k + 1);
        let (right_above, right_below) = right.split_at_mut(k + 1);
        for (row, right_row) in below.iter_mut().zip(right_below) {
            if row[k] != f.zero() {
                let multiplier = f.mul(row[k], inverse);
                subtract_multiple(f, &mut row[k + 1..], multiplier, &above[k][k + 1..]);
                subtract_multiple(f, right_row, multiplier, &right_above[k]);
            }
        }
    }
    for k in (n - block.needed..n).rev() {
        let (above, below) = right.split_at_mut(k + 1);
        for (&factor, solved) in matrix[k][k + 1..].iter().zip(below.iter()) {
            if factor != f.zero() {
                subtract_multiple(f, &mut above[k], factor, solved);
            }
        }
        let inverse = f.div(f.one(), matrix[k][k])?;
        above[k].iter_mut().for_each(|value| *value = f.mul(*value, inverse));
    }
    right[n - block.needed..].iter().all(|row| all_finite(f, row)).then_some(())
}

/// The sum of the sizes, in four interleaved partial sums, as the run-time kernel adds them.
fn one_norm<A: Arithmetic>(f: A, row: &[A::Value]) -> f64 {
    let mut partial = [0.0; 4];
    let (quads, rest) = row.as_chunks::<4>();
    for quad in quads {
        for lane in 0..4 {
            partial[lane] += f.pivot_size(quad[lane]);
        }
    }
    (partial[0] + partial[1]) + (partial[2] + partial[3]) + rest.iter().map(|&x| f.pivot_size(x)).sum::<f64>()
}

/// Whether the unknowns satisfy the inequalities of the problem.
pub fn is_wanted(plan: &Plan, coefficients: &[f64], x: &[f64]) -> bool {
    plan.positive.iter().all(|terms| evaluate(terms, Float64, coefficients, x) > 0.0)
}

/// The value of a polynomial in the unknowns `x`.
pub fn evaluate<A: Arithmetic>(terms: &[Term], f: A, coefficients: &[A::Value], x: &[A::Value]) -> A::Value {
    terms.iter().fold(f.zero(), |sum, term| {
        let coefficient = coefficients[usize::from(term.coefficient.0)];
        let product =
            term.exponents.iter().zip(x).fold(coefficient, |product, (&exponent, &x)| {
                (0..exponent).fold(product, |product, _| f.mul(product, x))
            });
        f.add(sum, product)
    })
}
