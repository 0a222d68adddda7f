//! From a set of shifts that solves to a template none of whose rows can be deleted.
//!
//! Rows are offered for deletion one after another. A trial asks whether the rows that are left
//! still express all reducible monomials R = aB \ B of some B in terms of B. Let r be the number of
//! rows, n that of columns. A new elimination for each trial would cost r^2 n, and r trials r^3 n.
//! The [`Dependencies`] keep the reduced echelon form instead, where a deletion costs one row
//! operation for each row that is kept, about |R| n.
//!
//! Deleting rows shrinks the row space, so that what is not expressible stays so. If all closed
//! sets of monomials were looked at, a row that cannot be deleted now could never be deleted later.
//! But only the closures of single columns and rows are looked at, and these change with the rows.
//! Passes are therefore repeated until one deletes nothing.
//!
//! The number of rows of a template is |E| + |R|, where E are the excess columns: a row can be
//! deleted together with a column of E that nothing else needs, or with a column of R if B changes.
//! Which rows go first decides which columns can go later. Multipliers of the highest degree bring
//! monomials that no other row has, so they are offered first.

use std::rc::Rc;
use std::sync::atomic::AtomicBool;

use super::monitor::{Monitor, Stage, is_set};
use super::solving_set::{Dependencies, Requirements, SolvingSet};
use crate::algebra::{Echelon, Monomial, Random};
use crate::template::shift_matrix::ShiftMatrix;
use crate::template::{EliminationTemplate, Shift};

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

/// Deletes rows one by one, and chooses a new solving set after each, as long as |B| stays within
/// `requirements.max_basis`.
///
/// Ends after a full pass over the rows without a deletion: no single row of the template can then
/// be deleted, unless the monitor ended the search. Returns `None` if the shifts do not solve, or
/// the search is interrupted.
pub fn reduce(
    matrix: &ShiftMatrix,
    action: &Monomial,
    requirements: &Requirements<'_>,
    order: DeletionOrder,
    monitor: &dyn Monitor,
) -> Option<EliminationTemplate> {
    let interruption = monitor.interruption();
    let mut current = Reduction::start(matrix.clone(), action, requirements, order, interruption)?;
    let mut queue = deletion_queue(&current.matrix, order);
    // Blocks of rows first, halved after each pass: a large set loses most rows in a few trials.
    let mut block = (queue.len() / 8).max(1);
    loop {
        let mut deleted = false;
        let mut at = 0;
        while at < queue.len() {
            if monitor.is_over(Stage::Searching) {
                return current.template(action);
            }
            let end = (at + block).min(queue.len());
            match current.without(&queue[at..end], requirements) {
                Some(smaller) => {
                    current = smaller;
                    queue.retain(|&row| current.alive[row]);
                    deleted = true;
                    // Deleted rows and empty columns still take space in the tableau. A new
                    // elimination costs r^2 n; after a quarter of the rows it pays, and happens a
                    // logarithmic number of times.
                    if queue.len() * 4 < current.alive.len() * 3 {
                        let shifts: Vec<Shift> = queue.iter().map(|&row| current.matrix.shifts[row]).collect();
                        current = current.compacted(action, requirements, order)?;
                        let row_of = |shift: &Shift| current.matrix.shifts.iter().position(|other| other == shift);
                        queue = shifts.iter().filter_map(row_of).collect();
                    }
                }
                None => at = end,
            }
        }
        if block == 1 && !deleted {
            return current.template(action);
        }
        block = (block / 2).max(1);
    }
}

/// A matrix that loses rows, and a solving set of the rows that are left.
///
/// ```text
///            E        R      B
/// alive    [ * * .    * .    * * ]
/// alive    [ . * *    . *    . * ]
/// deleted  [ - - -    - -    - - ]
/// alive    [ * . *    . .    * . ]
/// ```
///
/// Invariant: the alive rows are independent, the solving set (B, R) meets the requirements, and
/// every alive row has a part in expressing R in B.
#[derive(Clone)]
struct Reduction<'a> {
    matrix: Rc<ShiftMatrix>,
    /// Whether each row of the matrix is left.
    alive: Vec<bool>,
    dependencies: Dependencies<'a>,
    set: SolvingSet,
    interruption: Option<&'a AtomicBool>,
}

impl<'a> Reduction<'a> {
    /// Starts with the rows that the best solving set needs. Of dependent rows, those are left out
    /// that would be offered for deletion first.
    fn start(
        mut matrix: ShiftMatrix,
        action: &Monomial,
        requirements: &Requirements<'_>,
        order: DeletionOrder,
        interruption: Option<&'a AtomicBool>,
    ) -> Option<Self> {
        loop {
            let rows = independent_rows(&matrix, order, interruption);
            let dependencies = Dependencies::new(&matrix, action, &rows, requirements.readings, interruption)?;
            let set = dependencies.best(&matrix, requirements)?;
            let needed = dependencies.rows_of(&set);
            // On fewer rows another set may be best, which needs fewer rows still.
            if needed.len() == matrix.rows.len() {
                let alive = vec![true; needed.len()];
                return Some(Self { matrix: Rc::new(matrix), alive, dependencies, set, interruption });
            }
            matrix = matrix.retain_rows(&set.basis, |row| needed.binary_search(&row).is_ok());
        }
    }

    /// The reduction without some rows, and without the rows that are then of no use. `None` if the
    /// rest does not solve.
    fn without(&self, rows: &[usize], requirements: &Requirements<'_>) -> Option<Self> {
        // Most trials fail, and end here. This test updates only the columns and the part of the
        // combinations that belongs to these rows; all combinations are needed only to choose the
        // rows of the next set.
        if !self.dependencies.solves_without(rows, &self.matrix, requirements) {
            return None;
        }
        let mut rest = self.clone();
        rows.iter().for_each(|&row| rest.delete(row));
        // The test above says that enough permissible columns are left.
        rest.dependencies.settle(requirements.solutions);
        rest.set = rest.dependencies.best(&rest.matrix, requirements)?;
        let needed = rest.dependencies.rows_of(&rest.set);
        for row in 0..rest.alive.len() {
            if rest.alive[row] && needed.binary_search(&row).is_err() {
                rest.delete(row);
            }
        }
        Some(rest)
    }

    /// The same reduction on a matrix of the rows that are left.
    fn compacted(&self, action: &Monomial, requirements: &Requirements<'_>, order: DeletionOrder) -> Option<Self> {
        let matrix = self.matrix.retain_rows(&self.set.basis, |row| self.alive[row]);
        Self::start(matrix, action, requirements, order, self.interruption)
    }

    fn delete(&mut self, row: usize) {
        self.alive[row] = false;
        self.dependencies.delete_row(row);
    }

    /// The template of the solving set. Its matrix (E R) must be square: excess columns without a
    /// pivot cancel in the rows that express R, so that only those with a pivot are columns of the
    /// template.
    fn template(&self, action: &Monomial) -> Option<EliminationTemplate> {
        if is_set(self.interruption) {
            return None;
        }
        let matrix = self.matrix.retain_rows(&self.set.basis, |row| self.alive[row]);
        let monomials = |columns: &[usize]| -> Vec<Monomial> {
            columns.iter().map(|&column| self.matrix.monomials[column]).collect()
        };
        let (reducible, basis) = (monomials(&self.set.reducible), monomials(&self.set.basis));
        let mut shifts = matrix.shifts.clone();
        shifts.sort_unstable();
        let excess = matrix.pivots_before(&reducible, &basis);
        (shifts.len() == excess.len() + reducible.len()).then_some(EliminationTemplate {
            shifts,
            action: *action,
            excess,
            reducible,
            basis,
        })
    }
}

/// A largest set of independent rows. Rows that are offered for deletion late are preferred.
///
/// The row space is all that decides what solves, so the other rows are of no use. Greedy choice
/// gives a largest set because independent rows form a matroid. No further row is taken where the
/// flag is set.
pub fn independent_rows(matrix: &ShiftMatrix, order: DeletionOrder, interruption: Option<&AtomicBool>) -> Vec<usize> {
    let mut echelon = Echelon::new(matrix.field, matrix.monomials.len());
    let mut rows: Vec<usize> = deletion_queue(matrix, order)
        .into_iter()
        .rev()
        .take_while(|_| !is_set(interruption))
        .filter(|&row| {
            let entries: Vec<(u32, u32)> =
                matrix.rows[row].iter().map(|&(column, value)| (column as u32, value)).collect();
            echelon.insert_sparse(&entries).is_some()
        })
        .collect();
    rows.sort_unstable();
    rows
}

/// The rows in the order in which they are offered for deletion.
fn deletion_queue(matrix: &ShiftMatrix, order: DeletionOrder) -> Vec<usize> {
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
    rows
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{PRIMES, Polynomial, PrimeField};
    use crate::presolve::symmetry::Symmetry;
    use crate::problem::draw::Draw;
    use crate::search::grow::{Growth, Shifts, monomials_up_to};
    use crate::search::monitor::Unmonitored;
    use crate::template::verify::verify;

    #[test]
    fn two_conics_give_a_small_template() {
        let field = PrimeField::new(PRIMES[0]);
        let mut random = Random::new(1);
        let mut conic = || {
            let monomials = monomials_up_to(&[0, 1], &[1, 1], 2);
            Polynomial::from_terms(monomials.into_iter().map(|m| (m, field.draw(&mut random))).collect())
        };
        let equations = [conic(), conic()];
        let requirements =
            Requirements { readings: &Symmetry::NONE.readings(&[0, 1]), solutions: 4, max_basis: 4, zero_sets: &[] };
        let action = Monomial::unknown(0);
        let template = Shifts::new(&equations, &[0, 1], Growth::Degree(vec![1, 1]), 100)
            .find_map(|shifts| {
                let matrix = ShiftMatrix::new(field, &equations, &shifts);
                reduce(&matrix, &action, &requirements, DeletionOrder::HighestFirst, &Unmonitored)
            })
            .unwrap();
        assert_eq!(template.basis.len(), 4);
        assert_eq!(template.rows() + 4, template.columns());
        assert!(template.rows() <= 6, "{template:?}");
    }

    #[test]
    fn an_unknown_outside_of_basis_and_image_is_read_from_the_excess() {
        // x^3 + a x^2 + b x + c = 0 and y + d x^2 + e x + f = 0: no row but the second knows y.
        let field = PrimeField::new(PRIMES[0]);
        let mut random = Random::new(3);
        let mut with = |leading: [i8; 2], rest: &[[i8; 2]]| {
            let terms = rest.iter().map(|exponents| (Monomial::from_exponents(exponents), field.draw(&mut random)));
            Polynomial::from_terms(terms.chain([(Monomial::from_exponents(&leading), 1)]).collect())
        };
        let low = [[2, 0], [1, 0], [0, 0]];
        let equations = [with([3, 0], &low), with([0, 1], &low)];
        let shifts = [0, 1].map(|equation| Shift { equation, multiplier: Monomial::ONE });
        let matrix = ShiftMatrix::new(field, &equations, &shifts);
        let requirements =
            Requirements { readings: &Symmetry::NONE.readings(&[0, 1]), solutions: 3, max_basis: 3, zero_sets: &[] };
        let template =
            reduce(&matrix, &Monomial::unknown(0), &requirements, DeletionOrder::HighestFirst, &Unmonitored).unwrap();
        assert_eq!((template.rows(), template.columns()), (2, 5));
        assert!(template.reducible.contains(&Monomial::unknown(1)) && template.excess.is_empty(), "{template:?}");
        assert!(verify(&template, field, &equations).is_ok());
    }

    #[test]
    fn unknowns_that_only_occur_together_cannot_be_read() {
        // x^3 + a x^2 + b x + c = 0 and y + d z + e x^2 + f x + g = 0.
        let field = PrimeField::new(PRIMES[0]);
        let mut random = Random::new(4);
        let mut of = |exponents: &[[i8; 3]]| {
            let terms =
                exponents.iter().map(|exponents| (Monomial::from_exponents(exponents), field.draw(&mut random)));
            Polynomial::from_terms(terms.collect())
        };
        let cubic = of(&[[3, 0, 0], [2, 0, 0], [1, 0, 0], [0, 0, 0]]);
        let equations = [cubic, of(&[[0, 1, 0], [0, 0, 1], [2, 0, 0], [1, 0, 0], [0, 0, 0]])];
        let shifts = [0, 1].map(|equation| Shift { equation, multiplier: Monomial::ONE });
        let matrix = ShiftMatrix::new(field, &equations, &shifts);
        let reduced = |unknowns: &[usize]| {
            let requirements = Requirements {
                readings: &Symmetry::NONE.readings(unknowns),
                solutions: 3,
                max_basis: 3,
                zero_sets: &[],
            };
            reduce(&matrix, &Monomial::unknown(0), &requirements, DeletionOrder::HighestFirst, &Unmonitored)
        };
        assert!(reduced(&[0]).is_some());
        assert_eq!(reduced(&[0, 1, 2]), None);
    }
}
