//! The coefficient matrix of a set of shifts over Z_p.

use super::Shift;
use crate::algebra::{Echelon, Monomial, MonomialMap, Polynomial, PrimeField};
use crate::presolve::symmetry::Reading;

/// The sparse rows of a set of shifts `m * f`, and their monomials as columns.
///
/// ```text
///              monomials[0]  monomials[1]  ...      (decreasing)
/// shifts[0]         .             c
/// shifts[1]         c             .
/// ```
#[derive(Clone, Debug)]
pub struct ShiftMatrix {
    /// The field of the entries.
    pub field: PrimeField,
    /// The shift of each row.
    pub shifts: Vec<Shift>,
    /// The columns, decreasing.
    pub monomials: Vec<Monomial>,
    /// Position of each monomial among the columns.
    pub column_of: MonomialMap<usize>,
    /// Nonzero entries (column, value) of each row.
    pub rows: Vec<Vec<(usize, u32)>>,
}

impl ShiftMatrix {
    /// The matrix of the given shifts of `equations`.
    pub fn new(field: PrimeField, equations: &[Polynomial<u32>], shifts: &[Shift]) -> Self {
        let mut monomials: Vec<Monomial> =
            shifts.iter().flat_map(|s| equations[s.equation].monomials().map(|m| m.times(&s.multiplier))).collect();
        monomials.sort_unstable_by(|a, b| b.cmp(a));
        monomials.dedup();
        let column_of: MonomialMap<usize> = monomials.iter().enumerate().map(|(i, &m)| (m, i)).collect();
        let row = |s: &Shift| {
            let terms = equations[s.equation].terms().iter();
            terms.map(|&(m, c)| (column_of[&m.times(&s.multiplier)], c)).collect()
        };
        let rows = shifts.iter().map(row).collect();
        Self { field, shifts: shifts.to_vec(), monomials, column_of, rows }
    }

    /// The pivots of the echelon form with columns in the order: others, `reducible`, `basis`.
    /// Returned are those among the others.
    pub fn pivots_before(&self, reducible: &[Monomial], basis: &[Monomial]) -> Vec<Monomial> {
        let mut part = vec![0; self.monomials.len()];
        let mut mark = |monomials: &[Monomial], number| {
            monomials.iter().filter_map(|m| self.column_of.get(m)).for_each(|&column| part[column] = number);
        };
        mark(reducible, 1);
        mark(basis, 2);
        let mut order: Vec<usize> = (0..part.len()).collect();
        order.sort_by_key(|&column| part[column]);
        let mut position = vec![0; order.len()];
        order.iter().enumerate().for_each(|(at, &column)| position[column] = at as u32);
        let mut echelon = Echelon::new(self.field, order.len());
        for row in &self.rows {
            let entries: Vec<(u32, u32)> = row.iter().map(|&(column, value)| (position[column], value)).collect();
            echelon.insert_sparse(&entries);
        }
        let pivots = echelon.pivot_columns().into_iter().map(|at| order[at]);
        pivots.filter(|&column| part[column] == 0).map(|column| self.monomials[column]).collect()
    }

    /// The columns whose monomial is that of `column` times a step of the reading.
    pub fn steps_from<'a>(&'a self, column: usize, reading: &'a Reading) -> impl Iterator<Item = usize> + 'a {
        reading.steps.iter().filter_map(move |step| self.column_of.get(&self.monomials[column].times(step)).copied())
    }

    /// The matrix of the rows that are kept. Columns that become empty are dropped, except those of
    /// `basis`: b of B may be in no row when a b is in B.
    #[must_use]
    pub fn retain_rows(&self, basis: &[usize], keep: impl Fn(usize) -> bool) -> Self {
        let kept: Vec<usize> = (0..self.rows.len()).filter(|&row| keep(row)).collect();
        let mut used = vec![false; self.monomials.len()];
        basis.iter().for_each(|&column| used[column] = true);
        for &row in &kept {
            for &(column, _) in &self.rows[row] {
                used[column] = true;
            }
        }
        let mut renumbered = vec![usize::MAX; used.len()];
        let mut monomials = Vec::new();
        for (column, _) in used.iter().enumerate().filter(|(_, used)| **used) {
            renumbered[column] = monomials.len();
            monomials.push(self.monomials[column]);
        }
        let row = |&row: &usize| self.rows[row].iter().map(|&(c, v)| (renumbered[c], v)).collect();
        Self {
            field: self.field,
            shifts: kept.iter().map(|&row| self.shifts[row]).collect(),
            column_of: monomials.iter().enumerate().map(|(i, &m)| (m, i)).collect(),
            monomials,
            rows: kept.iter().map(row).collect(),
        }
    }
}
