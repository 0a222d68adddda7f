//! From a set of shifts that solves to a template with as few rows as possible.

use super::shift_matrix::ShiftMatrix;
use super::solving_set::{Requirements, SolvingSet, solving_set};
use super::{EliminationTemplate, Shift};
use crate::algebra::{DenseMatrix, Monomial};
use crate::instance::Random;

/// The order in which rows are offered for deletion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DeletionOrder {
    /// Multipliers of the highest degree first.
    HighestFirst,
    /// Rows with the rarest monomials first.
    RarestFirst,
    /// Shuffled with this seed.
    Shuffled(u64),
}

/// Deletes rows one by one, searching the solving set anew each time, as long as |B| does not grow beyond `requirements.max_basis`.
///
/// After a full pass over the rows without a deletion the template cannot lose a row. `None` if the shifts do not solve.
pub fn reduce(
    matrix: &ShiftMatrix,
    action: &Monomial,
    requirements: &Requirements<'_>,
    order: DeletionOrder,
) -> Option<EliminationTemplate> {
    let (mut current, mut set) = settle(matrix.clone(), action, requirements)?;
    let mut queue = deletion_queue(&current, order);
    // Blocks of rows first, halved on failure: a large template loses most rows in a few trials.
    let mut block = (current.rows.len() / 8).max(1);
    loop {
        let mut deleted = false;
        let mut at = 0;
        while at < queue.len() {
            let end = (at + block).min(queue.len());
            let doomed = &queue[at..end];
            let trial = current.retain_rows(|row| !doomed.contains(&current.shifts[row]));
            match settle(trial, action, requirements) {
                Some(smaller) => {
                    (current, set) = smaller;
                    queue.retain(|shift| current.shifts.contains(shift));
                    deleted = true;
                }
                None => at = end,
            }
        }
        if block == 1 && !deleted {
            return finish(&current, action, &set);
        }
        block = (block / 2).max(1);
    }
}

/// The matrix without the rows that its solving set does not need, and the solving set of what is left.
fn settle(
    mut matrix: ShiftMatrix,
    action: &Monomial,
    requirements: &Requirements<'_>,
) -> Option<(ShiftMatrix, SolvingSet)> {
    loop {
        let set = solving_set(&matrix, action, requirements)?;
        let rows = support(&matrix, &set)?.rows;
        if rows.len() == matrix.rows.len() {
            return Some((matrix, set));
        }
        let mut needed = vec![false; matrix.rows.len()];
        rows.iter().for_each(|&row| needed[row] = true);
        matrix = matrix.retain_rows(|row| needed[row]);
    }
}

fn deletion_queue(matrix: &ShiftMatrix, order: DeletionOrder) -> Vec<Shift> {
    let mut rows: Vec<usize> = (0..matrix.rows.len()).collect();
    let shift = |row: usize| (matrix.shifts[row].multiplier, matrix.shifts[row].equation);
    rows.sort_unstable_by_key(|&row| std::cmp::Reverse(shift(row)));
    match order {
        DeletionOrder::HighestFirst => {}
        DeletionOrder::RarestFirst => {
            let mut uses = vec![0usize; matrix.monomials.len()];
            for &(column, _) in matrix.rows.iter().flatten() {
                uses[column] += 1;
            }
            rows.sort_by_key(|&row| matrix.rows[row].iter().map(|&(column, _)| uses[column]).min());
        }
        DeletionOrder::Shuffled(seed) => Random::new(seed).shuffle(&mut rows),
    }
    rows.into_iter().map(|row| matrix.shifts[row]).collect()
}

/// Positions of the pivot columns among excess and reducible ones, and which independent rows the reducible rows are made of.
struct Support {
    /// Rows of the matrix that express the reducible monomials.
    rows: Vec<usize>,
    /// Columns, excess then reducible, that form an invertible square with `rows`.
    pivots: Vec<usize>,
}

/// ```text
///   | excess (decreasing) | reducible |   identity   |
///   |          U          |     *     |      *       |
///   |          0          |     I     | combinations |    nonzero columns: the rows that are needed
/// ```
fn support(matrix: &ShiftMatrix, set: &SolvingSet) -> Option<Support> {
    let mut is_reducible = vec![false; matrix.monomials.len()];
    set.reducible.iter().for_each(|&column| is_reducible[column] = true);
    let mut eliminated: Vec<usize> = (0..matrix.monomials.len())
        .filter(|&column| !is_reducible[column] && set.basis.binary_search(&column).is_err())
        .collect();
    let excess = eliminated.len();
    eliminated.extend(&set.reducible);
    let mut position = vec![usize::MAX; matrix.monomials.len()];
    for (at, &column) in eliminated.iter().enumerate() {
        position[column] = at;
    }
    // Low rows are preferred where rows depend on each other.
    let mut order: Vec<usize> = (0..matrix.rows.len()).collect();
    order.sort_unstable_by_key(|&row| (matrix.shifts[row].multiplier, matrix.shifts[row].equation));
    let mut dense = DenseMatrix::zeros(matrix.field, order.len(), eliminated.len());
    for (at, &row) in order.iter().enumerate() {
        for &(column, value) in &matrix.rows[row] {
            if position[column] != usize::MAX {
                dense.row_mut(at)[position[column]] = value;
            }
        }
    }
    let independent = dense.independent_rows();
    let mut augmented = DenseMatrix::zeros(matrix.field, independent.len(), eliminated.len() + independent.len());
    for (at, &row) in independent.iter().enumerate() {
        let target = augmented.row_mut(at);
        target[..eliminated.len()].copy_from_slice(dense.row(row));
        target[eliminated.len() + at] = 1;
    }
    let pivots = augmented.reduce_to_echelon();
    if pivots.len() != independent.len() || pivots.last().is_some_and(|&last| last >= eliminated.len()) {
        return None;
    }
    let mut used = vec![false; independent.len()];
    let mut reducible_pivots = 0;
    for (row, _) in pivots.iter().enumerate().filter(|&(_, &pivot)| pivot >= excess) {
        reducible_pivots += 1;
        for (at, used) in used.iter_mut().enumerate() {
            *used |= augmented.row(row)[eliminated.len() + at] != 0;
        }
    }
    if reducible_pivots != set.reducible.len() {
        return None;
    }
    let rows = (0..used.len()).filter(|&at| used[at]).map(|at| order[independent[at]]).collect();
    Some(Support { rows, pivots: pivots.iter().map(|&pivot| eliminated[pivot]).collect() })
}

/// The template of a solving set: needed rows only, excess columns that carry a pivot only.
fn finish(matrix: &ShiftMatrix, action: &Monomial, set: &SolvingSet) -> Option<EliminationTemplate> {
    let support = support(matrix, set)?;
    if support.rows.len() != support.pivots.len() {
        return None;
    }
    let monomials = |columns: &[usize]| columns.iter().map(|&column| matrix.monomials[column]).collect();
    let is_excess = |column: &&usize| set.reducible.binary_search(column).is_err();
    let excess: Vec<usize> = support.pivots.iter().filter(is_excess).copied().collect();
    let mut shifts: Vec<Shift> = support.rows.iter().map(|&row| matrix.shifts[row]).collect();
    shifts.sort_unstable();
    Some(EliminationTemplate {
        shifts,
        action: *action,
        excess: monomials(&excess),
        reducible: monomials(&set.reducible),
        basis: monomials(&set.basis),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{PRIMES, Polynomial, PrimeField};
    use crate::instance::Draw;
    use crate::template::grow::{Growth, Shifts, monomials_up_to};

    #[test]
    fn two_conics_give_a_small_template() {
        let field = PrimeField::new(PRIMES[0]);
        let mut random = Random::new(1);
        let mut conic = || {
            let monomials = monomials_up_to(&[0, 1], &[1, 1], 2);
            Polynomial::from_terms(monomials.into_iter().map(|m| (m, field.draw(&mut random))).collect())
        };
        let equations = [conic(), conic()];
        let requirements = Requirements { unknowns: &[0, 1], solutions: 4, max_basis: 4 };
        let action = Monomial::unknown(0);
        let template = Shifts::new(&equations, &[0, 1], Growth::Degree(vec![1, 1]), 100)
            .find_map(|shifts| {
                let matrix = ShiftMatrix::new(field, &equations, &shifts);
                reduce(&matrix, &action, &requirements, DeletionOrder::HighestFirst)
            })
            .unwrap();
        assert_eq!(template.basis.len(), 4);
        assert_eq!(template.rows() + 4, template.columns());
        assert!(template.rows() <= 6, "{template:?}");
    }
}
