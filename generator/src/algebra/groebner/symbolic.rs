//! Symbolic preprocessing: the multiples of basis elements that make up an F4 matrix.

use super::monomial_table::{MonomialId, MonomialTable};
use super::pairs::{Lead, Pair};
use super::{GroebnerError, Limits};
use crate::algebra::Monomial;

/// A monomial multiple of a basis element, as a matrix row; its values are those of the element.
#[derive(Clone, Debug)]
pub(super) struct Multiple {
    /// The basis element.
    pub(super) element: usize,
    /// Its monomials times the multiplier, largest first.
    pub(super) monomials: Vec<MonomialId>,
}

/// The rows and columns of an F4 matrix before elimination.
///
/// ```text
///               columns, largest monomial first
///  pivots      [ 1 * . * . * * ]   no two lead in the same column
///              [   1 * . . * . ]
///              [         1 . * ]
///  to reduce   [   1 . * . * * ]   leading columns that pivots share
/// ```
///
/// Every monomial of the matrix that a leading monomial of the basis divides leads one pivot row.
pub(super) struct Symbolic<'a> {
    table: &'a mut MonomialTable,
    /// The monomials of each basis element, largest first.
    supports: &'a [Vec<MonomialId>],
    leads: &'a [Lead],
    /// The basis elements that are not redundant.
    active: Vec<usize>,
    /// Per interned monomial: whether it is a column of the matrix, and leads a pivot row.
    states: Vec<State>,
    entries: usize,
    limits: &'a Limits<'a>,
    /// Rows that lead in a column of their own.
    pub(super) pivots: Vec<Multiple>,
    /// The remaining rows.
    pub(super) to_reduce: Vec<Multiple>,
    /// The monomials of all rows, unsorted.
    pub(super) columns: Vec<MonomialId>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    Absent,
    Column,
    PivotColumn,
}

impl<'a> Symbolic<'a> {
    /// An empty matrix.
    pub(super) fn new(
        table: &'a mut MonomialTable,
        supports: &'a [Vec<MonomialId>],
        leads: &'a [Lead],
        limits: &'a Limits<'a>,
    ) -> Self {
        let active = (0..leads.len()).filter(|&i| !leads[i].redundant).collect();
        let states = vec![State::Absent; table.len()];
        let (pivots, to_reduce, columns) = (Vec::new(), Vec::new(), Vec::new());
        Self { table, supports, leads, active, states, entries: 0, limits, pivots, to_reduce, columns }
    }

    /// Adds both halves of the S-polynomials of pairs: of all multiples with the same leading
    /// monomial one becomes a pivot row.
    pub(super) fn add_pairs(&mut self, pairs: &[Pair]) -> Result<(), GroebnerError> {
        let mut halves: Vec<(Monomial, usize)> =
            pairs.iter().flat_map(|pair| pair.elements.map(|element| (pair.lcm, element))).collect();
        // The sparsest multiple of each leading monomial comes first.
        halves.sort_unstable_by_key(|&(lcm, element)| (lcm, self.supports[element].len(), element));
        halves.dedup();
        let mut previous = None;
        for (lcm, element) in halves {
            let row = self.multiple(element, &lcm.over(&self.leads[element].monomial))?;
            if previous == Some(lcm) {
                self.to_reduce.push(row);
            } else {
                self.add_pivot(row);
            }
            previous = Some(lcm);
        }
        Ok(())
    }

    /// Adds the basis elements that are not redundant as pivot rows.
    pub(super) fn add_active_elements(&mut self) -> Result<(), GroebnerError> {
        for i in 0..self.active.len() {
            let row = self.multiple(self.active[i], &Monomial::ONE)?;
            self.add_pivot(row);
        }
        Ok(())
    }

    /// Adds a pivot row for every column without one that a leading monomial divides. Its monomials
    /// are new columns, which are treated in turn.
    pub(super) fn close(&mut self) -> Result<(), GroebnerError> {
        let mut next = 0;
        while let Some(&id) = self.columns.get(next) {
            self.limits.go_on()?;
            next += 1;
            if self.states[id.index()] == State::PivotColumn {
                continue;
            }
            let monomial = *self.table.monomial(id);
            if let Some(&element) = self.active.iter().find(|&&i| self.leads[i].monomial.divides(&monomial)) {
                let row = self.multiple(element, &monomial.over(&self.leads[element].monomial))?;
                self.add_pivot(row);
            }
        }
        Ok(())
    }

    fn add_pivot(&mut self, row: Multiple) {
        if let Some(leading) = row.monomials.first() {
            self.states[leading.index()] = State::PivotColumn;
        }
        self.pivots.push(row);
    }

    /// The multiple of an element, its monomials entered as columns.
    fn multiple(&mut self, element: usize, multiplier: &Monomial) -> Result<Multiple, GroebnerError> {
        let support = &self.supports[element];
        self.entries += support.len();
        let limit = self.limits.max_matrix_entries;
        if self.entries > limit {
            return Err(GroebnerError::LimitReached { what: "matrix entries", limit });
        }
        let hash = MonomialTable::hash(multiplier);
        let mut monomials = Vec::with_capacity(support.len());
        for &id in support {
            let id = self.table.intern_product(multiplier, hash, id)?;
            if id.index() >= self.states.len() {
                self.states.resize(id.index() + 1, State::Absent);
            }
            if self.states[id.index()] == State::Absent {
                self.states[id.index()] = State::Column;
                self.columns.push(id);
            }
            monomials.push(id);
        }
        Ok(Multiple { element, monomials })
    }
}
