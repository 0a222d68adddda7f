//! Sets of monomials on which multiplication by the action monomial is known (redundant solving sets).
//!
//! Given the rows of a [`ShiftMatrix`] and an action monomial a, find B such that every a b is in B or is expressed by the
//! row space in terms of B. B need not be a basis of the quotient ring: with |B| above the number of solutions some
//! eigenvalues are spurious. (Martyushev, Bhayani, Pajdla, arXiv 2307.00320.)

use super::shift_matrix::ShiftMatrix;
use super::tableau::Tableau;
use crate::algebra::Monomial;

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

/// Where a column stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    Excess,
    Reducible,
    Permissible,
}

/// For an action monomial a, how each reducible monomial depends on the permissible ones.
///
/// ```text
///   | excess | reducible = aP \ P | permissible P |
///   |   *    |         *          |       *       |   rows that only serve to eliminate the excess
///   |   0    |         1          |       *       |   a row for each reducible column, all of which depend on P only
///   |   0    |         0          |       *       |   relations within P
/// ```
///
/// Columns that turn out not to be expressible become excess, which shrinks P, until nothing changes. With fewer rows less is expressible,
/// so that what is excess stays excess when rows are deleted.
#[derive(Clone, Debug)]
pub struct Dependencies {
    tableau: Tableau,
    /// The column of a m for the monomial m of each column.
    image: Vec<Option<usize>>,
    part: Vec<Part>,
    /// The rank that the next column gets which becomes excess.
    next_excess: usize,
}

impl Dependencies {
    /// For the rows of `matrix`; `tracked` if rows are to be deleted. `None` if no column is permissible.
    pub fn new(matrix: &ShiftMatrix, action: &Monomial, tracked: bool) -> Option<Self> {
        let columns = matrix.monomials.len();
        let image: Vec<Option<usize>> =
            matrix.monomials.iter().map(|m| matrix.column_of.get(&m.times(action)).copied()).collect();
        let mut part = vec![Part::Permissible; columns];
        stabilise(&mut part, &image);
        let ranks = (0..columns).map(|column| rank(part[column], column, columns)).collect();
        let next_excess = columns;
        let mut dependencies = Self { tableau: Tableau::new(matrix, ranks, tracked), image, part, next_excess };
        (dependencies.settle(1) && dependencies.part.contains(&Part::Permissible)).then_some(dependencies)
    }

    /// Takes a row out of the matrix; call [`Dependencies::settle`] afterwards.
    pub fn delete_row(&mut self, row: usize) {
        self.tableau.delete_shift(row);
    }

    /// Moves columns that have become inexpressible to the excess. False, and of no further use, if fewer than `least` permissible columns are left.
    pub fn settle(&mut self, least: usize) -> bool {
        loop {
            let mut part = self.part.clone();
            let mut is_settled = true;
            for column in 0..part.len() {
                if part[column] == Part::Reducible && !self.is_clean(column) {
                    part[column] = Part::Excess;
                    is_settled = false;
                }
            }
            if is_settled {
                return true;
            }
            stabilise(&mut part, &self.image);
            if part.iter().filter(|&&part| part == Part::Permissible).count() < least {
                return false;
            }
            for column in 0..part.len() {
                if part[column] != self.part[column] {
                    self.move_to(column, part[column]);
                }
            }
        }
    }

    fn move_to(&mut self, column: usize, part: Part) {
        let rank = match part {
            Part::Excess => {
                self.next_excess += 1;
                self.next_excess - 1
            }
            part => rank(part, column, self.part.len()),
        };
        self.part[column] = part;
        self.tableau.move_forward(column, rank);
    }

    /// Whether the column is expressed by permissible ones.
    fn is_clean(&self, column: usize) -> bool {
        let mut others = self.tableau.dependence(column);
        others.as_mut().is_some_and(|others| others.all(|other| self.part[other] == Part::Permissible))
    }

    /// Whether a solving set that held before rows were deleted still does.
    pub fn still_solves(&self, set: &SolvingSet) -> bool {
        set.basis.iter().all(|&b| !self.tableau.is_pivot(b))
            && set.reducible.iter().all(|&column| self.is_expressed(column, &set.basis))
    }

    /// Whether the column is in B or a row expresses it in B.
    fn is_expressed(&self, column: usize, basis: &[usize]) -> bool {
        let is_basis = |other: &usize| basis.binary_search(other).is_ok();
        is_basis(&column)
            || self.tableau.dependence(column).is_some_and(|mut others| others.all(|other| is_basis(&other)))
    }

    /// The rows of the matrix that express the reducible columns of a solving set, increasing.
    pub fn rows_of(&self, set: &SolvingSet) -> Vec<usize> {
        let mut rows: Vec<usize> = set.reducible.iter().flat_map(|&column| self.tableau.shifts_of(column)).collect();
        rows.sort_unstable();
        rows.dedup();
        rows
    }

    /// The pivot columns, increasing.
    pub fn pivots(&self) -> Vec<usize> {
        let mut pivots = self.tableau.pivots().to_vec();
        pivots.sort_unstable();
        pivots
    }

    /// The smallest solving set that meets the requirements, or `None`. Among sets of one size one from which all unknowns can be read
    /// without further rows is preferred.
    pub fn smallest(&self, matrix: &ShiftMatrix, requirements: &Requirements<'_>) -> Option<SolvingSet> {
        let support: Vec<Option<Vec<usize>>> = (0..self.part.len())
            .map(|column| match self.part[column] {
                Part::Excess => None,
                _ => self.tableau.dependence(column).map(Iterator::collect),
            })
            .collect();
        let mut best: Option<(SolvingSet, bool)> = None;
        let mut tried: Vec<Vec<usize>> = Vec::new();
        for seed in self.seeds(&support) {
            let limit = match &best {
                Some((set, needs_more)) => set.basis.len() - usize::from(!needs_more),
                None => requirements.max_basis,
            };
            let Some(basis) = self.closure(&seed, &support, limit) else { continue };
            if basis.len() < requirements.solutions || tried.contains(&basis) {
                continue;
            }
            if let Some(found) = self.readable(matrix, &basis, requirements.unknowns) {
                let is_better =
                    |(old, old_more): &(SolvingSet, bool)| (basis.len(), found.1) < (old.basis.len(), *old_more);
                if best.as_ref().is_none_or(is_better) {
                    best = Some(found);
                }
            }
            tried.push(basis);
        }
        best.map(|(set, _)| set)
    }

    /// Starting points for closures: the supports of single rows, and single free columns, small first.
    fn seeds(&self, support: &[Option<Vec<usize>>]) -> Vec<Vec<usize>> {
        let mut seeds: Vec<Vec<usize>> = support.iter().flatten().filter(|s| !s.is_empty()).cloned().collect();
        seeds.extend((0..self.part.len()).filter(|&c| self.is_free(c)).map(|c| vec![c]));
        seeds.sort_unstable_by(|a, b| (a.len(), a).cmp(&(b.len(), b)));
        seeds.dedup();
        seeds
    }

    fn is_free(&self, column: usize) -> bool {
        self.part[column] == Part::Permissible && !self.tableau.is_pivot(column)
    }

    /// The smallest set of free columns that holds `seed` and is closed under the action; `None` if larger than `limit`.
    fn closure(&self, seed: &[usize], support: &[Option<Vec<usize>>], limit: usize) -> Option<Vec<usize>> {
        let mut member = vec![false; self.part.len()];
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
            let target = self.image[members[next]]?;
            match &support[target] {
                _ if self.is_free(target) => enter(target, &mut members),
                Some(support) => support.iter().for_each(|&column| enter(column, &mut members)),
                None => return None,
            }
            next += 1;
        }
        members.sort_unstable();
        (members.len() <= limit).then_some(members)
    }

    /// The solving set of a closed B if every unknown can be read from it, and whether that needs columns besides B and its image.
    fn readable(&self, matrix: &ShiftMatrix, basis: &[usize], unknowns: &[usize]) -> Option<(SolvingSet, bool)> {
        let mut reducible: Vec<usize> =
            basis.iter().filter_map(|&b| self.image[b]).filter(|t| basis.binary_search(t).is_err()).collect();
        reducible.sort_unstable();
        let image = reducible.len();
        for &unknown in unknowns {
            let x = Monomial::unknown(unknown);
            let times_x = |column: usize| matrix.column_of.get(&matrix.monomials[column].times(&x)).copied();
            let known =
                |column: usize| basis.binary_search(&column).is_ok() || reducible.binary_search(&column).is_ok();
            let ready = basis.iter().chain(&reducible).any(|&m| times_x(m).is_some_and(known));
            if ready {
                continue;
            }
            // Columns decrease: the last pair is the lowest. One of the two is known.
            let expressed = |column: usize| self.is_expressed(column, basis);
            let lowest = (0..matrix.monomials.len()).rev().find_map(|m| {
                let xm = times_x(m)?;
                match (known(m), known(xm)) {
                    (true, false) => expressed(xm).then_some(xm),
                    (false, true) => expressed(m).then_some(m),
                    _ => None,
                }
            })?;
            if let Err(at) = reducible.binary_search(&lowest) {
                reducible.insert(at, lowest);
            }
        }
        let needs_more = reducible.len() > image;
        Some((SolvingSet { basis: basis.to_vec(), reducible }, needs_more))
    }
}

/// Shrinks P and R until P = columns that are not excess and whose image is not, R = images of P outside P.
fn stabilise(part: &mut [Part], image: &[Option<usize>]) {
    let mut is_stable = false;
    while !is_stable {
        is_stable = true;
        let mut is_image = vec![false; part.len()];
        for column in 0..part.len() {
            if let (Part::Permissible, Some(target)) = (part[column], image[column]) {
                is_image[target] = true;
            }
        }
        for column in 0..part.len() {
            let next = match part[column] {
                Part::Permissible if image[column].is_some_and(|target| part[target] != Part::Excess) => continue,
                Part::Permissible | Part::Reducible if is_image[column] => Part::Reducible,
                _ => Part::Excess,
            };
            is_stable &= next == part[column];
            part[column] = next;
        }
    }
}

/// Excess columns first, then reducible, then permissible ones; room for `columns` that become excess later.
fn rank(part: Part, column: usize, columns: usize) -> usize {
    column
        + columns
            * match part {
                Part::Excess => 0,
                Part::Reducible => 2,
                Part::Permissible => 3,
            }
}
