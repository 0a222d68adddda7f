//! Elimination of constant rows before run time.
//!
//! A row with constant entries, a multiple of an equation without data, expresses an excess
//! monomial in its other monomials, whatever the data are:
//!
//! ```text
//!                 pivot  others                          others
//!   constant row [  c      r   ]
//!   other rows   [  a      s   ]   -->   other rows [ s - (a / c) r ]     (Schur complement)
//! ```
//!
//! The row and the column of the pivot are then gone. At run time only the coefficients s - (a / c)
//! r are left to compute.

use std::collections::BTreeMap;

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

/// Eliminates constant rows as long as one has an entry in the first `excess` columns. Returns the
/// pivot columns; no row has an entry there any more.
///
/// With r entries in its row and c in its column a pivot changes at most (r - 1)(c - 1) entries.
/// The pivot is always one for which this is least (Markowitz, "The elimination form of the inverse
/// and its application to linear programming", 1957).
pub(crate) fn eliminate_constant_rows(rows: &mut Vec<Row>, excess: usize, graph: &mut ExpressionGraph) -> Vec<usize> {
    let mut pivots = Vec::new();
    while let Some((at, column)) = cheapest_pivot(rows, excess, graph) {
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

/// The cheapest pivot: the position of a constant row and one of its excess columns.
fn cheapest_pivot(rows: &[Row], excess: usize, graph: &ExpressionGraph) -> Option<(usize, usize)> {
    let mut count = vec![0usize; excess];
    for &column in rows.iter().flat_map(|row| row.entries.keys()).filter(|&&column| column < excess) {
        count[column] += 1;
    }
    let candidates = rows.iter().enumerate().filter(|(_, row)| row.is_constant(graph)).flat_map(|(at, row)| {
        let cost = |&column: &usize| ((row.entries.len() - 1) * (count[column] - 1), at, column);
        row.entries.keys().filter(|&&column| column < excess).map(cost).collect::<Vec<_>>()
    });
    candidates.min().map(|(_, at, column)| (at, column))
}

/// The other entries of a constant row divided by that in `column`; `None` if one has more than 64
/// bits.
fn ratios_to_pivot(row: &mut Row, column: usize, graph: &mut ExpressionGraph) -> Option<Vec<(usize, ExpressionId)>> {
    let pivot = graph.as_constant(*row.entries.get(&column)?)?;
    let ratio =
        |(&other, &entry): (&usize, &ExpressionId)| Some((other, graph.as_constant(entry)?.checked_div(pivot)?));
    let others = row.entries.iter().filter(|&(&other, _)| other != column);
    let ratios: Vec<_> = others.map(ratio).collect::<Option<_>>()?;
    Some(ratios.into_iter().map(|(other, ratio)| (other, graph.constant(ratio))).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{PRIMES, PrimeField};
    use crate::expression::rational::Rational;

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
        let pivots = eliminate_constant_rows(&mut rows, 3, &mut graph);
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
        assert_eq!(eliminate_constant_rows(&mut rows, 2, &mut graph).len(), 1);
        assert_eq!(rows.iter().find(|row| row.shift == 1).unwrap().entries.keys().collect::<Vec<_>>(), [&2]);
    }

    #[test]
    fn rows_that_become_constant_are_eliminated_too() {
        let (mut graph, mut rows) = setting(&[&[1, 1, 0, 0], &[100, 100, 1, 0], &[0, 3, 101, 1]]);
        // After row 0 is subtracted row 1 is 1 in column 2; after that is subtracted row 2 is
        // constant.
        let pivots = eliminate_constant_rows(&mut rows, 3, &mut graph);
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
        assert_eq!((eliminate_constant_rows(&mut rows, 2, &mut graph), rows), (vec![], before));
    }
}
