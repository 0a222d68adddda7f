//! Block-triangular form of a sparse square matrix (Duff and Reid, "An implementation of Tarjan's
//! algorithm for the block triangularization of a matrix", 1978).
//!
//! 1. A perfect matching gives each row a column of its own, in which it has an entry: a
//!    permutation to a matrix without zeros on the diagonal.
//! 2. Row i needs row j solved before if it has an entry in the column of row j. Rows that need
//!    each other in a circle, the strongly connected components of this graph, form a diagonal
//!    block.
//! 3. A component comes after those that it needs, so the blocks can be solved in order.
//!
//! ```text
//!   rows in any order         blocks in order of solution
//!   [ x . x . ]                 [ x x | . . ]
//!   [ . x . x ]      -->        [ x x | . . ]
//!   [ x . x . ]                 [ . . | x x ]
//!   [ x x . x ]                 [ x . | x x ]
//! ```
//!
//! The blocks do not depend on the matching (Dulmage and Mendelsohn, "Coverings of bipartite
//! graphs", 1958).

/// The rows and columns of one diagonal block.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct DiagonalBlock {
    /// Row indices.
    pub(crate) rows: Vec<usize>,
    /// Column indices, as many as rows.
    pub(crate) columns: Vec<usize>,
}

/// The diagonal blocks in an order of solution: block k has entries only in columns of blocks 0 to
/// k. `None` if the pattern is structurally singular.
///
/// `pattern[row]` lists the columns of the nonzero entries of a square matrix.
pub(crate) fn block_triangular_form(pattern: &[Vec<usize>]) -> Option<Vec<DiagonalBlock>> {
    let row_of_column = perfect_matching(pattern)?;
    let mut column_of_row = vec![0; pattern.len()];
    for (column, &row) in row_of_column.iter().enumerate() {
        column_of_row[row] = column;
    }
    let components = strongly_connected_components(pattern, &row_of_column);
    Some(
        components
            .into_iter()
            .map(|mut rows| {
                rows.sort_unstable();
                let columns = rows.iter().map(|&row| column_of_row[row]).collect();
                DiagonalBlock { rows, columns }
            })
            .collect(),
    )
}

const UNMATCHED: usize = usize::MAX;

/// The row matched to each column; `None` if there is no perfect matching.
///
/// A new row takes a free column, or one whose row can move to another: an augmenting path. Paths
/// are searched depth-first with a stack of their own, because they can be as long as the matrix.
fn perfect_matching(pattern: &[Vec<usize>]) -> Option<Vec<usize>> {
    let n = pattern.len();
    let mut row_of_column = vec![UNMATCHED; n];
    let mut seen = vec![UNMATCHED; n];
    for start in 0..n {
        // The path: rows, each with the next of its entries to try. An empty path has tried all.
        let mut path = vec![(start, 0)];
        let mut chosen = Vec::new();
        loop {
            let (row, next) = path.last_mut()?;
            let Some(&column) = pattern[*row].get(*next) else {
                path.pop();
                chosen.pop();
                continue;
            };
            *next += 1;
            // A column that this path tried before leads nowhere again.
            if seen[column] == start {
                continue;
            }
            seen[column] = start;
            chosen.push(column);
            if row_of_column[column] == UNMATCHED {
                break;
            }
            path.push((row_of_column[column], 0));
        }
        // Every row of the path moves to the column that was chosen for it.
        for (&(row, _), &column) in path.iter().zip(&chosen) {
            row_of_column[column] = row;
        }
    }
    Some(row_of_column)
}

/// The strongly connected components of the graph of rows, each after those that it needs (Tarjan's
/// algorithm, with a stack of its own).
///
/// `index` numbers the rows in the order in which they are met, and `low` is the least index that a
/// row reaches by rows which are still on the stack. A row with `low` = `index` is the first of its
/// component, which is then the top of the stack.
fn strongly_connected_components(pattern: &[Vec<usize>], row_of_column: &[usize]) -> Vec<Vec<usize>> {
    let n = pattern.len();
    let mut index = vec![UNMATCHED; n];
    let mut low = vec![0; n];
    let mut on_stack = vec![false; n];
    let mut stack = Vec::new();
    let mut components = Vec::new();
    let mut counter = 0;
    for root in 0..n {
        if index[root] != UNMATCHED {
            continue;
        }
        let mut calls = vec![(root, 0)];
        while let Some(&mut (row, ref mut next)) = calls.last_mut() {
            if *next == 0 {
                index[row] = counter;
                low[row] = counter;
                counter += 1;
                stack.push(row);
                on_stack[row] = true;
            }
            if let Some(&column) = pattern[row].get(*next) {
                *next += 1;
                let target = row_of_column[column];
                if index[target] == UNMATCHED {
                    calls.push((target, 0));
                } else if on_stack[target] {
                    low[row] = low[row].min(index[target]);
                }
                continue;
            }
            calls.pop();
            if let Some(&(parent, _)) = calls.last() {
                low[parent] = low[parent].min(low[row]);
            }
            if low[row] == index[row] {
                let at = stack.iter().rposition(|&r| r == row).unwrap_or(0);
                let component = stack.split_off(at);
                component.iter().for_each(|&r| on_stack[r] = false);
                components.push(component);
            }
        }
    }
    components
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{DenseMatrix, PRIMES, PrimeField, Random};

    fn check(pattern: &[Vec<usize>], sizes: &[usize]) {
        let blocks = block_triangular_form(pattern).unwrap();
        assert_eq!(blocks.iter().map(|b| b.rows.len()).collect::<Vec<_>>(), sizes);
        let mut solved = vec![false; pattern.len()];
        for block in &blocks {
            block.columns.iter().for_each(|&column| solved[column] = true);
            for &row in &block.rows {
                assert!(pattern[row].iter().all(|&column| solved[column]), "{blocks:?}");
            }
        }
        assert!(solved.iter().all(|&s| s));
    }

    #[test]
    fn finds_the_blocks() {
        check(&[vec![0]], &[1]);
        check(&[vec![0, 1], vec![1]], &[1, 1]);
        check(&[vec![0, 1], vec![0, 1], vec![0, 1, 2]], &[2, 1]);
        check(&[vec![0, 1, 2, 3], vec![1, 2], vec![1, 2], vec![0, 3]], &[2, 2]);
        // A cycle is one block.
        check(&[vec![0, 1], vec![1, 2], vec![2, 0]], &[3]);
    }

    #[test]
    fn refuses_structural_singularity() {
        assert_eq!(block_triangular_form(&[vec![0], vec![0]]), None);
        assert_eq!(block_triangular_form(&[vec![], vec![0, 1]]), None);
    }

    /// Row i needs row j if it has an entry in the column matched to j. Rows that need each other,
    /// directly or by others, are one block.
    fn groups_of_rows(pattern: &[Vec<usize>], row_of_column: &[usize]) -> Vec<Vec<usize>> {
        let n = pattern.len();
        let mut needs = vec![vec![false; n]; n];
        for (row, columns) in pattern.iter().enumerate() {
            needs[row][row] = true;
            columns.iter().for_each(|&column| needs[row][row_of_column[column]] = true);
        }
        for (through, from, to) in (0..n * n * n).map(|k| (k / (n * n), k / n % n, k % n)) {
            needs[from][to] |= needs[from][through] && needs[through][to];
        }
        let group = |row: usize| (0..n).filter(|&other| needs[row][other] && needs[other][row]).collect::<Vec<_>>();
        let mut groups: Vec<Vec<usize>> = (0..n).map(group).collect();
        groups.sort();
        groups.dedup();
        groups
    }

    /// A pattern is structurally singular exactly where a matrix of random numbers is singular, and
    /// no block can be split further, by a search that tries all rows.
    #[test]
    fn blocks_of_random_patterns_are_as_small_as_possible() {
        let field = PrimeField::new(PRIMES[0]);
        let mut random = Random::new(1);
        let (mut regular, mut split) = (0, 0);
        for _ in 0..2_000 {
            let n = 1 + random.below(9) as usize;
            let share = 1 + random.below(3);
            let mut matrix = DenseMatrix::zeros(field, n, n);
            for at in (0..n * n).filter(|_| random.below(6) < share).collect::<Vec<_>>() {
                matrix.row_mut(at / n)[at % n] = 1 + random.below(1 << 30) as u32;
            }
            let columns = |row: usize| (0..n).filter(|&column| matrix.get(row, column) != 0).collect::<Vec<_>>();
            let pattern: Vec<Vec<usize>> = (0..n).map(columns).collect();
            let Some(blocks) = block_triangular_form(&pattern) else {
                assert!(matrix.reduce_to_echelon().len() < n, "{pattern:?}");
                continue;
            };
            let sizes: Vec<usize> = blocks.iter().map(|block| block.rows.len()).collect();
            check(&pattern, &sizes);
            let mut row_of_column = vec![0; n];
            for block in &blocks {
                assert!(block.rows.is_sorted(), "{blocks:?}");
                block.rows.iter().zip(&block.columns).for_each(|(&row, &column)| {
                    assert_ne!(matrix.get(row, column), 0, "{blocks:?}");
                    row_of_column[column] = row;
                });
            }
            let mut rows: Vec<Vec<usize>> = blocks.iter().map(|block| block.rows.clone()).collect();
            rows.sort();
            assert_eq!(rows, groups_of_rows(&pattern, &row_of_column), "{pattern:?}");
            (regular, split) = (regular + 1, split + usize::from(blocks.len() > 1 && blocks.len() < n));
            assert_eq!(matrix.reduce_to_echelon().len(), n, "{pattern:?}");
        }
        assert!(regular > 200 && split > 100, "{regular} regular, {split} of them split into blocks of several rows");
    }
}
