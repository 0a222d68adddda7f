//! How a solver comes to its solutions on one instance: growth of pivots, separation of
//! eigenvalues, second attempts. Emitted code shows none of this; the interpreted plan does, whose
//! numbers are the same.

use std::cell::Cell;

use eliminant::{Complex, emitted};

use crate::expression::arithmetic::{Arithmetic, Float64};
use crate::expression::rational::Rational;
use crate::plan::{Entry, Plan, interpret};
use crate::search::measuring::interpreted::InterpretedSolver;

/// What is seen of one instance.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Condition {
    /// The largest modulus that a difference of the elimination takes, back-substitution included,
    /// over the largest entry of the template; `None` if the template is singular.
    pub(super) growth: Option<f64>,
    /// The smallest distance of two eigenvalues of the action matrix over the largest modulus of
    /// one; `None` if there are no two.
    pub(super) separation: Option<f64>,
    /// Whether `solve` made a second attempt.
    pub(super) is_repeated: bool,
    /// Whether `solve_complex` did.
    pub(super) is_repeated_complex: bool,
}

impl Condition {
    /// Of an instance.
    pub(super) fn of(plan: &Plan, solver: &InterpretedSolver, data: &[f64]) -> Self {
        let Ok(mut instance) = solver.instance(data) else { return Self::default() };
        let eliminated = growth_and_action(plan, instance.coefficients());
        // An error of the solver is counted where its solutions are.
        let _ = instance.solve();
        let is_repeated = instance.attempts() > 1;
        let is_repeated_complex = solver.instance(data).is_ok_and(|mut instance| {
            let _ = instance.solve_complex();
            instance.attempts() > 1
        });
        Self {
            growth: eliminated.as_ref().map(|(growth, _)| *growth),
            separation: eliminated.and_then(|(_, action)| separation(&action)),
            is_repeated,
            is_repeated_complex,
        }
    }
}

fn growth_and_action(plan: &Plan, coefficients: &[f64]) -> Option<(f64, Vec<Vec<f64>>)> {
    let size = |entry: &Entry| coefficients[usize::from(entry.coefficient.0)].abs();
    let blocks = plan.elimination.blocks.iter().flat_map(|block| block.diagonal.iter().chain(&block.coupling));
    let start = blocks.chain(&plan.elimination.right).map(size).fold(0.0, f64::max);
    let largest = Cell::new(start);
    let eliminated = interpret::eliminate(plan, Watched(&largest), coefficients)?;
    Some((if start > 0.0 { largest.get() / start } else { 1.0 }, eliminated.action))
}

fn separation(action: &Vec<Vec<f64>>) -> Option<f64> {
    let values: Vec<Complex<f64>> = emitted::eigenvalues(emitted::Dynamic(action.len()), action).ok()?;
    let largest = values.iter().map(|value| value.norm()).fold(0.0, f64::max);
    let distances =
        (0..values.len()).flat_map(|i| (0..i).map(move |j| (i, j))).map(|(i, j)| (values[i] - values[j]).norm());
    distances.reduce(f64::min).map(|distance| if largest > 0.0 { distance / largest } else { 0.0 })
}

/// `f64` with the largest modulus of a difference.
#[derive(Clone, Copy)]
struct Watched<'a>(&'a Cell<f64>);

impl Arithmetic for Watched<'_> {
    type Value = f64;

    fn constant(self, value: Rational) -> Option<f64> {
        Float64.constant(value)
    }
    fn add(self, a: f64, b: f64) -> f64 {
        a + b
    }
    fn sub(self, a: f64, b: f64) -> f64 {
        let difference = a - b;
        self.0.set(self.0.get().max(difference.abs()));
        difference
    }
    fn mul(self, a: f64, b: f64) -> f64 {
        a * b
    }
    fn div(self, a: f64, b: f64) -> Option<f64> {
        Float64.div(a, b)
    }
    fn pivot_size(self, a: f64) -> f64 {
        a.abs()
    }
    fn rounding(self) -> f64 {
        f64::EPSILON
    }
    fn zero(self) -> f64 {
        0.0
    }
    fn one(self) -> f64 {
        1.0
    }
    // Not a difference of the elimination.
    fn neg(self, a: f64) -> f64 {
        -a
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn separation_is_relative_to_the_largest() {
        // The eigenvalues are 4, 3 and 1.
        let action = vec![vec![4.0, 1.0, 0.0], vec![0.0, 3.0, 0.0], vec![0.0, 0.0, 1.0]];
        let found = separation(&action).unwrap();
        assert!((found - 0.25).abs() < 1e-12, "{found}");
        assert_eq!(separation(&vec![vec![4.0]]), None);
    }
}
