//! Sets of monomials on which multiplication by the action monomial is known (redundant solving sets).
//!
//! Given the rows of a [`ShiftMatrix`] and an action monomial a, find B such that every a b is in B or is expressed by the
//! row space in terms of B. B need not be a basis of the quotient ring: with |B| above the number of solutions some
//! eigenvalues are spurious. (Martyushev, Bhayani, Pajdla, arXiv 2307.00320.)

use super::shift_matrix::ShiftMatrix;
use crate::algebra::{DenseMatrix, Monomial};

/// Columns of a [`ShiftMatrix`], increasing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SolvingSet {
    /// B.
    pub basis: Vec<usize>,
    /// R = aB \ B, and the columns that are only there for an unknown to be read from.
    pub reducible: Vec<usize>,
}

/// What a solving set must satisfy to be of use.
#[derive(Clone, Debug)]
pub struct Requirements<'a> {
    /// Indices of the unknowns that must be readable as ratios of monomials that are in B or expressed in B.
    pub unknowns: &'a [usize],
    /// Least size of B: the number of solutions.
    pub solutions: usize,
    /// Largest size of B.
    pub max_basis: usize,
}

/// The smallest solving set that meets the requirements, or `None`.
pub fn solving_set(matrix: &ShiftMatrix, action: &Monomial, requirements: &Requirements<'_>) -> Option<SolvingSet> {
    let image: Vec<Option<usize>> =
        matrix.monomials.iter().map(|m| matrix.column_of.get(&m.times(action)).copied()).collect();
    let dependencies = Dependencies::find(matrix, &image)?;
    let mut best: Option<SolvingSet> = None;
    let mut unreadable: Vec<SolvingSet> = Vec::new();
    for seed in dependencies.seeds() {
        let limit = best.as_ref().map_or(requirements.max_basis, |set| set.basis.len() - 1);
        let Some(basis) = dependencies.closure(&seed, &image, limit) else { continue };
        if basis.len() < requirements.solutions {
            continue;
        }
        let mut reducible: Vec<usize> =
            basis.iter().filter_map(|&b| image[b]).filter(|t| basis.binary_search(t).is_err()).collect();
        reducible.sort_unstable();
        let set = SolvingSet { basis, reducible };
        if requirements.unknowns.iter().all(|&x| is_readable(matrix, &set, x)) {
            best = Some(set);
        } else if !unreadable.contains(&set) {
            unreadable.push(set);
        }
    }
    unreadable.retain(|set| best.as_ref().is_none_or(|best| set.basis.len() < best.basis.len()));
    unreadable.sort_by_key(|set| set.basis.len());
    let extended = |set: &SolvingSet| with_readable_unknowns(matrix, set, requirements.unknowns);
    unreadable.iter().take(EXTENDED).find_map(extended).or(best)
}

/// Solving sets that are tried with more columns where an unknown cannot be read from their own: each takes an elimination.
const EXTENDED: usize = 2;

/// The set with columns t = x m or t = m / x, m in B or R, added to R, so that every unknown x can be read. The rows must express t in B:
///
/// ```text
///   | excess | candidates t | R  | B |
///   |   *    |      *       | *  | * |
///   |   0    |      1       | 0  | * |   t can be read
/// ```
fn with_readable_unknowns(matrix: &ShiftMatrix, set: &SolvingSet, unknowns: &[usize]) -> Option<SolvingSet> {
    let open: Vec<Monomial> =
        unknowns.iter().filter(|&&x| !is_readable(matrix, set, x)).map(|&x| Monomial::unknown(x)).collect();
    let is_known =
        |column: &usize| set.basis.binary_search(column).is_ok() || set.reducible.binary_search(column).is_ok();
    let reads = |column: usize, x: &Monomial| {
        let t = &matrix.monomials[column];
        let near = [t.times(x), t.over(x)];
        near.iter().any(|m| matrix.column_of.get(m).is_some_and(is_known))
    };
    let candidates: Vec<usize> = (0..matrix.monomials.len())
        .filter(|column| !is_known(column) && open.iter().any(|x| reads(*column, x)))
        .collect();
    let reducible = candidates.iter().chain(&set.reducible).copied().collect();
    let blocks = Blocks { reducible, permissible: set.basis.clone() };
    let rest = Remaining::eliminate(matrix, &blocks);
    let expressed: Vec<usize> = rest.clean_rows(blocks.reducible.len()).map(|(column, _)| column).collect();
    let mut extended = set.clone();
    for x in &open {
        // Columns decrease: the last is the lowest.
        let lowest = candidates.iter().rev().find(|&&column| expressed.contains(&column) && reads(column, x))?;
        if let Err(at) = extended.reducible.binary_search(lowest) {
            extended.reducible.insert(at, *lowest);
        }
    }
    Some(extended)
}

/// Whether both m and x m are in B or R for some m.
fn is_readable(matrix: &ShiftMatrix, set: &SolvingSet, unknown: usize) -> bool {
    let x = Monomial::unknown(unknown);
    let known = |column: &usize| set.basis.binary_search(column).is_ok() || set.reducible.binary_search(column).is_ok();
    set.basis
        .iter()
        .chain(&set.reducible)
        .any(|&column| matrix.column_of.get(&matrix.monomials[column].times(&x)).is_some_and(known))
}

/// How each reducible monomial depends on the permissible ones.
struct Dependencies {
    /// Permissible columns that the rows leave free: any solving set is a subset.
    free: Vec<bool>,
    /// For each dependent column the free columns in its row.
    support: Vec<Option<Vec<usize>>>,
}

impl Dependencies {
    /// ```text
    ///   | excess | reducible | permissible |
    ///   |   *    |     *     |      *      |   rows dropped once they have served to eliminate the excess
    ///   |   0    |     1     |      *      |   a row for each reducible column that depends on permissible columns only
    ///   |   0    |     0     |      *      |   relations among the permissible columns
    /// ```
    /// Columns that turn out not to be expressible become excess, which shrinks the permissible set, until nothing changes.
    fn find(matrix: &ShiftMatrix, image: &[Option<usize>]) -> Option<Self> {
        let columns = matrix.monomials.len();
        let mut alive = vec![true; columns];
        let mut remaining: Option<Remaining> = None;
        loop {
            let blocks = Blocks::split(&mut alive, image);
            if blocks.permissible.is_empty() {
                return None;
            }
            let rest = match &remaining {
                None => Remaining::eliminate(matrix, &blocks),
                Some(previous) => previous.eliminate_further(&blocks, columns),
            };
            let mut support = vec![None; columns];
            let mut free = vec![false; columns];
            for &column in &blocks.permissible {
                free[column] = true;
            }
            for &pivot in &rest.pivots {
                free[rest.columns[pivot]] = false;
            }
            for (column, used) in rest.clean_rows(blocks.reducible.len()) {
                support[column] = Some(used);
            }
            let mut changed = false;
            for &column in &blocks.reducible {
                if support[column].is_none() {
                    alive[column] = false;
                    changed = true;
                }
            }
            if !changed {
                return Some(Self { free, support });
            }
            remaining = Some(rest);
        }
    }

    /// Starting points for closures: the supports of single rows, and single free columns, small first.
    fn seeds(&self) -> Vec<Vec<usize>> {
        let mut seeds: Vec<Vec<usize>> = self.support.iter().flatten().filter(|s| !s.is_empty()).cloned().collect();
        seeds.extend((0..self.free.len()).filter(|&c| self.free[c]).map(|c| vec![c]));
        seeds.sort_unstable_by(|a, b| (a.len(), a).cmp(&(b.len(), b)));
        seeds.dedup();
        seeds
    }

    /// The smallest set of free columns that holds `seed` and is closed under the action; `None` if larger than `limit`.
    fn closure(&self, seed: &[usize], image: &[Option<usize>], limit: usize) -> Option<Vec<usize>> {
        let mut member = vec![false; self.free.len()];
        let mut members = Vec::new();
        let mut enter = |column: usize, members: &mut Vec<usize>| {
            if !member[column] {
                member[column] = true;
                members.push(column);
            }
        };
        for &column in seed {
            enter(column, &mut members);
        }
        let mut next = 0;
        while next < members.len() {
            if members.len() > limit {
                return None;
            }
            let target = image[members[next]]?;
            match &self.support[target] {
                _ if self.free[target] => enter(target, &mut members),
                Some(support) => support.iter().for_each(|&column| enter(column, &mut members)),
                None => return None,
            }
            next += 1;
        }
        members.sort_unstable();
        (members.len() <= limit).then_some(members)
    }
}

/// The split of the columns for the current set of living ones.
struct Blocks {
    reducible: Vec<usize>,
    permissible: Vec<usize>,
}

impl Blocks {
    /// P = living columns whose image lives, R = images outside P; whatever is neither dies.
    fn split(alive: &mut [bool], image: &[Option<usize>]) -> Self {
        loop {
            let permissible: Vec<bool> =
                (0..alive.len()).map(|c| alive[c] && image[c].is_some_and(|target| alive[target])).collect();
            let mut is_image = vec![false; alive.len()];
            for c in 0..alive.len() {
                if let (true, Some(target)) = (permissible[c], image[c]) {
                    is_image[target] = true;
                }
            }
            let mut changed = false;
            for c in 0..alive.len() {
                if alive[c] && !permissible[c] && !is_image[c] {
                    alive[c] = false;
                    changed = true;
                }
            }
            if !changed {
                return Self {
                    reducible: (0..alive.len()).filter(|&c| alive[c] && !permissible[c]).collect(),
                    permissible: (0..alive.len()).filter(|&c| permissible[c]).collect(),
                };
            }
        }
    }

    fn columns(&self) -> Vec<usize> {
        self.reducible.iter().chain(&self.permissible).copied().collect()
    }
}

/// Reduced echelon form of the part of the row space that vanishes on the excess columns.
struct Remaining {
    /// Column of the [`ShiftMatrix`] at each position.
    columns: Vec<usize>,
    matrix: DenseMatrix,
    /// Pivot position of each row, increasing.
    pivots: Vec<usize>,
}

impl Remaining {
    fn eliminate(matrix: &ShiftMatrix, blocks: &Blocks) -> Self {
        let columns = blocks.columns();
        let mut position = vec![usize::MAX; matrix.monomials.len()];
        for (at, &column) in columns.iter().enumerate() {
            position[column] = at;
        }
        let mut excess = 0;
        let mut excess_position = vec![0; matrix.monomials.len()];
        for column in 0..matrix.monomials.len() {
            if position[column] == usize::MAX {
                excess_position[column] = excess;
                excess += 1;
            }
        }
        let mut dense = DenseMatrix::zeros(matrix.field, matrix.rows.len(), excess + columns.len());
        for (row, entries) in matrix.rows.iter().enumerate() {
            let target = dense.row_mut(row);
            for &(column, value) in entries {
                let at =
                    if position[column] == usize::MAX { excess_position[column] } else { excess + position[column] };
                target[at] = value;
            }
        }
        Self::after_echelon(dense, excess, columns)
    }

    /// More columns have become excess: eliminate those from the rows that are left.
    fn eliminate_further(&self, blocks: &Blocks, total: usize) -> Self {
        let columns = blocks.columns();
        let mut stays = vec![false; total];
        for &column in &columns {
            stays[column] = true;
        }
        let mut position = vec![usize::MAX; total];
        for (at, &column) in self.columns.iter().enumerate() {
            position[column] = at;
        }
        let order: Vec<usize> = (0..self.columns.len())
            .filter(|&at| !stays[self.columns[at]])
            .chain(columns.iter().map(|&column| position[column]))
            .collect();
        let excess = order.len() - columns.len();
        let mut dense = DenseMatrix::zeros(self.matrix.field(), self.pivots.len(), order.len());
        for row in 0..self.pivots.len() {
            let from = self.entries(row);
            for (target, &at) in dense.row_mut(row).iter_mut().zip(&order) {
                *target = from[at];
            }
        }
        Self::after_echelon(dense, excess, columns)
    }

    fn after_echelon(mut dense: DenseMatrix, excess: usize, columns: Vec<usize>) -> Self {
        let pivots = dense.reduce_to_echelon();
        let first = pivots.partition_point(|&pivot| pivot < excess);
        let mut matrix = DenseMatrix::zeros(dense.field(), pivots.len() - first, columns.len());
        for row in first..pivots.len() {
            matrix.row_mut(row - first).copy_from_slice(&dense.row(row)[excess..]);
        }
        Self { columns, matrix, pivots: pivots[first..].iter().map(|&pivot| pivot - excess).collect() }
    }

    fn entries(&self, row: usize) -> &[u32] {
        self.matrix.row(row)
    }

    /// The pivot column and the other nonzero columns of each row whose others are all behind the first `reducible` positions.
    fn clean_rows(&self, reducible: usize) -> impl Iterator<Item = (usize, Vec<usize>)> {
        self.pivots.iter().enumerate().filter_map(move |(row, &pivot)| {
            let entries = self.entries(row);
            let clean = entries[pivot + 1..].iter().take(reducible.saturating_sub(pivot + 1)).all(|&v| v == 0);
            let used = (pivot + 1..entries.len()).filter(|&c| entries[c] != 0).map(|c| self.columns[c]);
            clean.then(|| (self.columns[pivot], used.collect()))
        })
    }
}
