//! Block-triangular form of a sparse square matrix: maximum matching, then strongly connected
//! components (Duff and Reid, "An implementation of Tarjan's algorithm for the block
//! triangularization of a matrix", 1978).

/// Rows and columns of one diagonal block.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct DiagonalBlock {
    /// Row indices.
    pub(crate) rows: Vec<usize>,
    /// Column indices, as many.
    pub(crate) columns: Vec<usize>,
}

/// The diagonal blocks in an order of solution: block k has entries only in columns of blocks
/// 0..=k. `None` where the pattern is structurally singular.
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

/// Row matched to each column, by augmenting paths (depth-first, iterative).
fn perfect_matching(pattern: &[Vec<usize>]) -> Option<Vec<usize>> {
    let n = pattern.len();
    let mut row_of_column = vec![UNMATCHED; n];
    let mut seen = vec![UNMATCHED; n];
    for start in 0..n {
        // Path of (row, next entry to try).
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
            if column >= n || seen[column] == start {
                continue;
            }
            seen[column] = start;
            chosen.push(column);
            if row_of_column[column] == UNMATCHED {
                break;
            }
            path.push((row_of_column[column], 0));
        }
        for (&(row, _), &column) in path.iter().zip(&chosen) {
            row_of_column[column] = row;
        }
    }
    Some(row_of_column)
}

/// Components of the graph row -> row matched to a column of the row; a component comes after all
/// that it points to (Tarjan, iterative).
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
}
