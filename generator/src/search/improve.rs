//! Makes a template smaller by going back and forth: add some rows, then delete as many as possible
//! in another order.
//!
//! A template of which no row can be deleted is a local minimum only: whether a row can go depends
//! on which rows are there. The rows that are added need not bring new columns, so a template with
//! exchanged rows is often found for the same columns. A round costs one reduction of a set of rows
//! that is a little larger than the template, which is far less than the reduction of a seed set.

use super::grow::shifts_within;
use super::monitor::{Monitor, Stage};
use super::reduce::{DeletionOrder, reduce};
use super::solving_set::Requirements;
use crate::algebra::Random;
use crate::algebra::{Monomial, MonomialSet, Polynomial, PrimeField};
use crate::template::shift_matrix::ShiftMatrix;
use crate::template::{EliminationTemplate, Shift};

/// Exponents of the monomials that are added: far from the bounds of `i8`.
const EXPONENTS: std::ops::Range<i8> = -60..60;

/// The choices by which a template is improved.
#[derive(Clone, Debug)]
pub struct Improvement<'a> {
    /// The field of the coefficients.
    pub field: PrimeField,
    /// The equations that the template is for.
    pub equations: &'a [Polynomial<u32>],
    /// Action monomials to try besides that of the template.
    pub actions: &'a [Monomial],
    /// The multipliers of neighbouring shifts differ by one of these, or by its reciprocal.
    pub steps: Vec<Monomial>,
    /// Number of rounds.
    pub rounds: u64,
    /// Seed of the choices.
    pub seed: u64,
}

impl Improvement<'_> {
    /// A template with at most as many rows, and with the smallest basis that was found for that
    /// number of rows.
    ///
    /// Each round takes all shifts that fit into the monomials of the template and, in three rounds
    /// of four, of some neighbours of its shifts, and reduces them in another order.
    pub fn of(
        &self,
        template: EliminationTemplate,
        requirements: &Requirements<'_>,
        monitor: &dyn Monitor,
    ) -> EliminationTemplate {
        let mut random = Random::new(self.seed);
        let mut current = template;
        for round in 0..self.rounds {
            if monitor.is_over(Stage::Searching) {
                break;
            }
            // Another action monomial has another image aB, and so needs other rows.
            let action = match random.below(3) {
                0 => self.actions[random.below(self.actions.len() as u64) as usize],
                _ => current.action,
            };
            let shifts = self.surroundings(&current, round % 4, &mut random);
            let matrix = ShiftMatrix::new(self.field, self.equations, &shifts);
            let order = match random.below(4) {
                0 => DeletionOrder::HighestFirst,
                1 => DeletionOrder::RarestFirst,
                _ => DeletionOrder::Shuffled(random.bits()),
            };
            // A template of the same size is taken too: the next round then starts from other rows.
            let size = |t: &EliminationTemplate| (t.rows(), t.basis.len());
            current = reduce(&matrix, &action, requirements, order, monitor)
                .filter(|next| size(next) <= size(&current))
                .unwrap_or(current);
        }
        current
    }

    /// All shifts within the monomials of the template and of some neighbours of its shifts.
    fn surroundings(&self, template: &EliminationTemplate, neighbours: u64, random: &mut Random) -> Vec<Shift> {
        let mut support: MonomialSet =
            template.shifts.iter().flat_map(|shift| shift.monomials(self.equations)).collect();
        for _ in 0..neighbours {
            let shift = template.shifts[random.below(template.shifts.len() as u64) as usize];
            let step = self.steps[random.below(self.steps.len() as u64) as usize];
            let multiplier = match random.below(2) {
                0 => shift.multiplier.times(&step),
                _ => shift.multiplier.over(&step),
            };
            // A template is determined up to a common monomial, and may drift by it from round to
            // round.
            let in_range = |m: &Monomial| m.exponents().iter().all(|e| EXPONENTS.contains(e));
            let monomials: Vec<Monomial> = (Shift { multiplier, ..shift }).monomials(self.equations).collect();
            if in_range(&multiplier) && monomials.iter().all(in_range) {
                support.extend(monomials);
            }
        }
        shifts_within(self.equations, &support).into_iter().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::PRIMES;
    use crate::presolve::symmetry::Symmetry;
    use crate::problem::draw::Draw;
    use crate::search::grow::{Growth, Shifts, monomials_up_to};
    use crate::search::monitor::Unmonitored;
    use crate::template::verify::verify;

    #[test]
    fn two_conics_lose_rows_where_the_basis_may_be_larger() {
        let field = PrimeField::new(PRIMES[0]);
        let mut random = Random::new(1);
        let mut conic = || {
            let monomials = monomials_up_to(&[0, 1], &[1, 1], 2);
            Polynomial::from_terms(monomials.into_iter().map(|m| (m, field.draw(&mut random))).collect())
        };
        let equations = [conic(), conic()];
        let actions = [Monomial::unknown(0), Monomial::ONE.over(&Monomial::unknown(0))];
        let shifts = Shifts::new(&equations, &[0, 1], Growth::Degree(vec![1, 1]), 100).nth(1).unwrap();
        let matrix = ShiftMatrix::new(field, &equations, &shifts);
        let readings = Symmetry::NONE.readings(&[0, 1]);
        let requirements = |max_basis| Requirements { readings: &readings, solutions: 4, max_basis, zero_sets: &[] };
        let template =
            reduce(&matrix, &actions[0], &requirements(4), DeletionOrder::HighestFirst, &Unmonitored).unwrap();
        assert_eq!((template.rows(), template.basis.len()), (6, 4));
        let steps = [0, 1].map(Monomial::unknown).to_vec();
        let improvement = Improvement { field, equations: &equations, actions: &actions, steps, rounds: 8, seed: 1 };
        let improved = improvement.of(template, &requirements(5), &Unmonitored);
        assert_eq!((improved.rows(), improved.basis.len()), (4, 5));
        assert!(verify(&improved, field, &equations).is_ok());
    }
}
