//! Elimination with constant pivots before run time.
//!
//! A row with constant entries, a multiple of an equation without data, expresses an excess
//! monomial in its other monomials, whatever the data are. So does a multiple of an equation that
//! presolve has solved for a monomial, with expressions of the data:
//!
//! ```text
//!                 pivot  others                          others
//!   row           [  c      r   ]
//!   other rows    [  a      s   ]   -->   other rows [ s - (a / c) r ]     (Schur complement)
//! ```
//!
//! The row and the column of the pivot are then gone. At run time only the coefficients s - (a / c)
//! r are left to compute, those that are not zero for all data: the equations of three quadrics,
//! solved for x^2, x y and y^2, leave 5 of 21 rows, and a tenth of the operations.

use std::collections::BTreeMap;

use crate::expression::rational::Rational;
use crate::expression::{ExpressionGraph, ExpressionId};

/// A row of the template.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Row {
    /// The number of its shift in the template.
    pub(crate) shift: usize,
    /// The entries that are not zero for all data, by column. Columns are numbered: excess,
    /// reducible, basis.
    pub(crate) entries: BTreeMap<usize, ExpressionId>,
}

impl Row {
    fn is_constant(&self, graph: &ExpressionGraph) -> bool {
        self.entries.values().all(|&entry| graph.as_constant(entry).is_some())
    }
}

/// The constant entries that may be pivots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ConstantPivots {
    /// Those of rows that are constant as a whole: they lose no digits.
    OfConstantRows,
    /// All. No pivots are chosen at run time, so a row should have no larger entries than its
    /// constant one for most data. A system that was solved for its highest monomials, with
    /// pivots, has such rows.
    OfAllRows,
}

/// Eliminates as long as there is a pivot in the first `excess` columns. Returns the pivot columns;
/// no row has an entry there any more.
///
/// With r entries in its row and c in its column a pivot changes at most (r - 1)(c - 1) entries.
/// The pivot is always one for which this is least (Markowitz, "The elimination form of the inverse
/// and its application to linear programming", 1957).
pub(crate) fn eliminate_constant_pivots(
    rows: &mut Vec<Row>,
    excess: usize,
    graph: &mut ExpressionGraph,
    which: ConstantPivots,
) -> Vec<usize> {
    let mut pivots = Vec::new();
    while let Some((at, column)) = cheapest_pivot(rows, excess, graph, which) {
        let mut pivot_row = rows.remove(at);
        let Some(ratios) = ratios_to_pivot(&mut pivot_row, column, graph) else {
            // A ratio has more than 64 bits: the row is eliminated at run time.
            rows.insert(at, pivot_row);
            break;
        };
        for row in rows.iter_mut() {
            let Some(factor) = row.entries.remove(&column) else { continue };
            for &(other, ratio) in &ratios {
                let change = graph.mul(factor, ratio);
                let entry = match row.entries.get(&other) {
                    Some(&entry) => graph.sub(entry, change),
                    None => graph.neg(change),
                };
                match graph.is_zero(entry) {
                    true => row.entries.remove(&other),
                    false => row.entries.insert(other, entry),
                };
            }
        }
        pivots.push(column);
    }
    pivots
}

/// The cheapest pivot: the position of a row and one of its excess columns.
fn cheapest_pivot(
    rows: &[Row],
    excess: usize,
    graph: &ExpressionGraph,
    which: ConstantPivots,
) -> Option<(usize, usize)> {
    let mut count = vec![0usize; excess];
    for &column in rows.iter().flat_map(|row| row.entries.keys()).filter(|&&column| column < excess) {
        count[column] += 1;
    }
    let may_have = |row: &Row| which == ConstantPivots::OfAllRows || row.is_constant(graph);
    let candidates = rows.iter().enumerate().filter(|(_, row)| may_have(row)).flat_map(|(at, row)| {
        let constant = row.entries.iter().filter(|&(_, &entry)| graph.as_constant(entry).is_some());
        let columns: Vec<usize> = constant.map(|(&column, _)| column).filter(|&column| column < excess).collect();
        let count = &count;
        columns.into_iter().map(move |column| ((row.entries.len() - 1) * (count[column] - 1), at, column))
    });
    candidates.min().map(|(_, at, column)| (at, column))
}

/// The other entries of a row divided by the constant in `column`; `None` if one has more than 64
/// bits.
fn ratios_to_pivot(row: &mut Row, column: usize, graph: &mut ExpressionGraph) -> Option<Vec<(usize, ExpressionId)>> {
    let pivot = graph.as_constant(*row.entries.get(&column)?)?;
    let inverse = graph.constant(Rational::integer(1).checked_div(pivot)?);
    let others = row.entries.iter().filter(|&(&other, _)| other != column);
    others
        .map(|(&other, &entry)| {
            let ratio = match graph.as_constant(entry) {
                Some(constant) => graph.constant(constant.checked_div(pivot)?),
                None => graph.mul(entry, inverse),
            };
            Some((other, ratio))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{PRIMES, PrimeField};

    const F: PrimeField = PrimeField::new(PRIMES[0]);

    /// Two inputs, and rows given by small integers or, from 100 on, inputs.
    fn setting(rows: &[&[i64]]) -> (ExpressionGraph, Vec<Row>) {
        let mut graph = ExpressionGraph::new(&[vec![12_345, 67_890], vec![54_321, 9_876]]);
        let rows = rows.iter().enumerate().map(|(shift, row)| {
            let entry = |(column, &value): (usize, &i64)| match value {
                0 => None,
                100.. => Some((column, graph.input(value as usize - 100))),
                _ => Some((column, graph.constant(Rational::integer(value)))),
            };
            Row { shift, entries: row.iter().enumerate().filter_map(entry).collect() }
        });
        let rows = rows.collect();
        (graph, rows)
    }

    /// The rows as they are for two values of the inputs.
    fn values(graph: &ExpressionGraph, rows: &[Row], columns: usize) -> Vec<Vec<u32>> {
        let values = graph.evaluate(F, &[777, 888]).unwrap();
        let value = |row: &Row, column| row.entries.get(&column).map_or(0, |entry| values[entry.index()]);
        rows.iter().map(|row| (0..columns).map(|column| value(row, column)).collect()).collect()
    }

    #[test]
    fn pivots_are_excess_columns_of_constant_rows() {
        let (mut graph, mut rows) =
            setting(&[&[1, 2, 0, 3, 1], &[100, 0, 5, 101, 0], &[0, 0, 0, 2, 2], &[4, 1, 1, 0, 101]]);
        let before = values(&graph, &rows, 5);
        let pivots = eliminate_constant_pivots(&mut rows, 3, &mut graph, ConstantPivots::OfConstantRows);
        // Row 2 has no entry in columns 0 to 2, and rows 1 and 3 are not constant. Column 1 changes
        // one row only.
        assert_eq!((pivots, rows.iter().map(|row| row.shift).collect::<Vec<_>>()), (vec![1], vec![1, 2, 3]));
        let after = values(&graph, &rows, 5);
        assert_eq!((&after[0], &after[1]), (&before[1], &before[2]));
        let half = F.inverse(2).unwrap();
        let expected = |column: usize| F.sub(before[3][column], F.mul(half, before[0][column]));
        assert_eq!(after[2], (0..5).map(expected).collect::<Vec<_>>());
    }

    #[test]
    fn what_cancels_is_no_entry() {
        let (mut graph, mut rows) = setting(&[&[1, 2, 1], &[2, 4, 100], &[-3, 100, 101]]);
        assert_eq!(eliminate_constant_pivots(&mut rows, 2, &mut graph, ConstantPivots::OfConstantRows).len(), 1);
        assert_eq!(rows.iter().find(|row| row.shift == 1).unwrap().entries.keys().collect::<Vec<_>>(), [&2]);
    }

    #[test]
    fn rows_that_become_constant_are_eliminated_too() {
        let (mut graph, mut rows) = setting(&[&[1, 1, 0, 0], &[100, 100, 1, 0], &[0, 3, 101, 1]]);
        // After row 0 is subtracted row 1 is 1 in column 2; after that is subtracted row 2 is
        // constant.
        let pivots = eliminate_constant_pivots(&mut rows, 3, &mut graph, ConstantPivots::OfConstantRows);
        assert_eq!((pivots, rows), (vec![0, 2, 1], vec![]));
    }

    /// 2^61 divided by 1 / 16 has 66 bits: the row is left for run time, in its place.
    #[test]
    fn a_ratio_of_too_many_bits_leaves_the_rows_as_they_are() {
        let (mut graph, mut rows) = setting(&[&[100, 1, 1], &[1, 100, 1], &[0, 101, 1]]);
        let small = graph.constant(Rational::new(1, 16).unwrap());
        let large = graph.constant(Rational::integer(1 << 61));
        rows[1].entries = BTreeMap::from([(0, small), (2, large)]);
        let before = rows.clone();
        assert_eq!(
            (eliminate_constant_pivots(&mut rows, 2, &mut graph, ConstantPivots::OfConstantRows), rows),
            (vec![], before)
        );
    }

    /// Row 0 is solved for column 0: with x and y for the inputs, row 1 minus x times row 0 is x in
    /// column 1 less x y, and 1 in column 2.
    #[test]
    fn constant_entries_of_other_rows_are_pivots_if_asked_for() {
        let rows = [[1, 101, 0].as_slice(), &[100, 100, 1]];
        let (mut graph, mut kept) = setting(&rows);
        assert!(eliminate_constant_pivots(&mut kept, 1, &mut graph, ConstantPivots::OfConstantRows).is_empty());
        let (mut graph, mut rows) = setting(&rows);
        assert_eq!(eliminate_constant_pivots(&mut rows, 1, &mut graph, ConstantPivots::OfAllRows), [0]);
        let expected = F.sub(777, F.mul(777, 888));
        assert_eq!(values(&graph, &rows, 3), [[0, expected, 1]]);
    }
}
