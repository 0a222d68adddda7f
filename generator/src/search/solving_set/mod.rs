//! Sets of monomials on which multiplication by the action monomial is known (redundant solving
//! sets).
//!
//! Given the rows of a [`ShiftMatrix`] and an action monomial a, find B such that every a b is in B
//! or is expressed by the row space in terms of B. At every solution of the equations T B = a B
//! then holds for a matrix T, so that the values of a at the solutions are eigenvalues of T. B need
//! not be a basis of the quotient ring: if |B| exceeds the number of solutions, some eigenvalues
//! are spurious. (Martyushev, Bhayani, Pajdla, arXiv 2307.00320.)
//!
//! # The method
//! 1. P starts as all columns whose image under a is a column, and R = aP \ P. Each monomial of R
//!    that the rows do not express in P becomes excess, which takes its preimages out of P, until
//!    nothing changes ([`Dependencies::settle`]). The result is the largest P: the conditions on
//!    two sets hold on their union.
//! 2. P is mostly much larger than needed. The columns of P that are no pivots are *free*. The
//!    closure of a free column m is the least set of free columns that holds m and, for each of its
//!    members t, either a t or what the row of a t depends on. Closures of single columns and of
//!    single rows are the candidates for B ([`Dependencies::best`]). All closed sets are unions of
//!    closures of single columns, too many to look at.

mod obstacle;
mod vanishing;

use std::collections::BTreeSet;
use std::sync::atomic::AtomicBool;

use crate::algebra::Monomial;
use crate::presolve::symmetry::Reading;
use crate::search::index_set::IndexSet;
use crate::search::monitor::is_set;
use crate::search::tableau::Tableau;
use crate::template::shift_matrix::ShiftMatrix;

pub use obstacle::Obstacle;
use vanishing::Vanishing;

/// Columns of a [`ShiftMatrix`], increasing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SolvingSet {
    /// B.
    pub basis: Vec<usize>,
    /// R = aB \ B, and the columns that are only there for an unknown to be read from.
    pub reducible: Vec<usize>,
    /// How many rows of the matrix express R in B.
    pub rows: usize,
}

/// What a solving set must satisfy to be of use.
#[derive(Clone, Debug)]
pub struct Requirements<'a> {
    /// Ways to read the unknowns, as ratios of monomials that are in B or expressed in B. One of
    /// them must be possible.
    pub readings: &'a [Vec<Reading>],
    /// Least size of B: the number of solutions, up to the signs that no monomial of B tells. A
    /// smaller T has too few eigenvalues.
    pub solutions: usize,
    /// Largest size of B.
    pub max_basis: usize,
    /// The sets of unknowns that are 0 together at a solution. If all monomials of B hold one of
    /// such a set, or an unknown is a ratio of such monomials only, the solution is lost.
    pub zero_sets: &'a [Vec<usize>],
}

/// Number of columns that are kept for each unknown that may need one, the lowest ones. Each kept
/// column keeps a row in the tableau.
const COLUMNS_TO_READ: usize = 3;

/// The part of the columns that a column belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    Excess,
    /// Not in P or aP, but an unknown may be read from it.
    Reading,
    Reducible,
    Permissible,
}

/// How each reducible monomial depends on the permissible ones, for an action monomial a.
///
/// ```text
///   | excess | reading | reducible R = aP \ P | permissible P |
///   |   *    |    *    |          *          |       *       |   for the excess only, not kept
///   |   0    |    1    |          *          |       *       |   for unknowns not read from P, aP
///   |   0    |    0    |          1          |       *       |   one for each reducible column
///   |   0    |    0    |          0          |       *       |   relations within P
/// ```
///
/// Invariant after [`Dependencies::settle`]: the image of every permissible column is permissible
/// or reducible, and the row of every reducible column has other entries in P only.
///
/// Deleting rows shrinks the row space, so less is expressible: what is excess stays excess. A
/// column only ever moves from P to R and from either to the excess. This is what allows one
/// tableau to be updated through a whole reduction.
#[derive(Clone, Debug)]
pub struct Dependencies<'a> {
    tableau: Tableau,
    /// The column of a m for the monomial m of each column.
    image: Vec<Option<usize>>,
    part: Vec<Part>,
    /// Once this flag is set nothing solves any more.
    interruption: Option<&'a AtomicBool>,
}

impl<'a> Dependencies<'a> {
    /// The dependencies by some rows of `matrix`, which must be independent. `readings` are the
    /// ways in which unknowns will be read. Returns `None` if no column is permissible, or where
    /// the flag is set.
    pub fn new(
        matrix: &ShiftMatrix,
        action: &Monomial,
        rows: &[usize],
        readings: &[Vec<Reading>],
        interruption: Option<&'a AtomicBool>,
    ) -> Option<Self> {
        let dependencies = Self::with_reading(matrix, action, rows, &[], interruption)?;
        match dependencies.columns_to_read(matrix, readings) {
            none if none.is_empty() => Some(dependencies),
            reading => Self::with_reading(matrix, action, rows, &reading, interruption),
        }
    }

    /// The dependencies with these columns kept outside of the excess.
    fn with_reading(
        matrix: &ShiftMatrix,
        action: &Monomial,
        rows: &[usize],
        reading: &[usize],
        interruption: Option<&'a AtomicBool>,
    ) -> Option<Self> {
        let columns = matrix.monomials.len();
        let image: Vec<Option<usize>> =
            matrix.monomials.iter().map(|m| matrix.column_of.get(&m.times(action)).copied()).collect();
        let mut part = vec![Part::Permissible; columns];
        reading.iter().for_each(|&column| part[column] = Part::Reading);
        stabilise(&mut part, &image);
        if !part.contains(&Part::Permissible) {
            return None;
        }
        let ranks = (0..columns).map(|column| rank(part[column], column, columns)).collect();
        let tableau = Tableau::new(matrix, rows, ranks, columns, interruption)?;
        let mut dependencies = Self { tableau, image, part, interruption };
        dependencies.settle(1).then_some(dependencies)
    }

    /// Columns of the excess to keep, so that unknowns can be read. An unknown x is read as the
    /// ratio of two monomials m and x m. If it has no such pair outside of the excess, these are
    /// columns with their partner outside of it.
    fn columns_to_read(&self, matrix: &ShiftMatrix, readings: &[Vec<Reading>]) -> Vec<usize> {
        let is_outside = |column: usize| self.part[column] != Part::Excess;
        let mut columns = Vec::new();
        for reading in readings.iter().flatten() {
            let pairs: Vec<(usize, usize)> = (0..matrix.monomials.len())
                .rev()
                .flat_map(|m| matrix.steps_from(m, reading).map(move |sm| (m, sm)))
                .filter(|&(m, sm)| is_outside(m) || is_outside(sm))
                .collect();
            if !pairs.iter().any(|&(m, sm)| is_outside(m) && is_outside(sm)) {
                let lowest = pairs.iter().take(COLUMNS_TO_READ);
                columns.extend(lowest.map(|&(m, sm)| if is_outside(m) { sm } else { m }));
            }
        }
        columns
    }

    /// Deletes a row of the matrix. The caller must call [`Dependencies::settle`] before anything
    /// else.
    pub fn delete_row(&mut self, row: usize) {
        self.tableau.delete_shift(row);
    }

    /// Whether there is a solving set without some rows. The row operations carry along only what
    /// belongs to these rows.
    pub fn solves_without(&self, rows: &[usize], matrix: &ShiftMatrix, requirements: &Requirements<'_>) -> bool {
        let (image, part) = (self.image.clone(), self.part.clone());
        let mut rest = Self { tableau: self.tableau.narrowed(rows), image, part, interruption: self.interruption };
        rows.iter().for_each(|&row| rest.delete_row(row));
        if !rest.settle(requirements.solutions) {
            return false;
        }
        let vanishing = Vanishing::new(matrix, requirements.zero_sets);
        let is_readable = |basis: Vec<usize>| {
            requirements.readings.iter().any(|readings| rest.readable(matrix, &basis, readings, &vanishing).is_some())
        };
        rest.closed_sets(requirements, &vanishing).into_iter().any(is_readable)
    }

    /// Moves columns that are no longer expressible to the excess, and their preimages with them,
    /// until nothing changes. Returns false if fewer than `least` permissible columns are left, or
    /// where the flag is set; the dependencies are then of no further use.
    ///
    /// Each round moves at least one column, and a column moves at most twice, so there are at most
    /// twice as many rounds as columns. In practice there are two or three.
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
                if part[column] == self.part[column] {
                    continue;
                }
                if is_set(self.interruption) {
                    return false;
                }
                self.part[column] = part[column];
                match part[column] {
                    Part::Excess => self.tableau.give_up(column),
                    part @ (Part::Reading | Part::Reducible | Part::Permissible) => {
                        self.tableau.move_forward(column, rank(part, column, self.part.len()))
                    }
                }
            }
        }
    }

    /// Whether a row expresses the column by permissible columns.
    fn is_clean(&self, column: usize) -> bool {
        let mut others = self.tableau.dependence(column);
        others.as_mut().is_some_and(|others| others.all(|other| self.part[other] == Part::Permissible))
    }

    /// The rows of the matrix that express the reducible columns of a solving set, increasing.
    pub fn rows_of(&self, set: &SolvingSet) -> Vec<usize> {
        self.shifts_of(&set.reducible).iter().collect()
    }

    fn shifts_of(&self, columns: &[usize]) -> IndexSet {
        let mut shifts = self.tableau.no_shifts();
        columns.iter().for_each(|&column| shifts.extend(&self.tableau.shifts_of(column)));
        shifts
    }

    /// The solving set with the fewest rows among those that meet the requirements, and among these
    /// the smallest one.
    ///
    /// The number of rows is that of the shifts in the combinations that express R: this many rows
    /// of the matrix are needed and no other.
    pub fn best(&self, matrix: &ShiftMatrix, requirements: &Requirements<'_>) -> Option<SolvingSet> {
        let vanishing = Vanishing::new(matrix, requirements.zero_sets);
        let mut closed: Vec<(usize, usize, Vec<usize>)> = self
            .closed_sets(requirements, &vanishing)
            .into_iter()
            .take_while(|_| !is_set(self.interruption))
            .map(|basis| (self.shifts_of(&self.image_outside(&basis)).len(), basis.len(), basis))
            .collect();
        closed.sort_unstable();
        let mut best: Option<SolvingSet> = None;
        for (rows, size, basis) in closed {
            // Sets are sorted by the rows that aB \ B takes. Reading the unknowns may take more
            // rows, never fewer, so no later set can be better.
            if best.as_ref().is_some_and(|best| (best.rows, best.basis.len()) <= (rows, size)) {
                break;
            }
            if is_set(self.interruption) {
                return None;
            }
            let ways =
                requirements.readings.iter().filter_map(|readings| self.readable(matrix, &basis, readings, &vanishing));
            let with_rows = ways.map(|reducible| (self.shifts_of(&reducible).len(), reducible));
            let Some((rows, reducible)) = with_rows.min_by_key(|(rows, _)| *rows) else { continue };
            if best.as_ref().is_none_or(|best| (rows, size) < (best.rows, best.basis.len())) {
                best = Some(SolvingSet { basis, reducible, rows });
            }
        }
        best
    }

    /// Sets of free columns that are closed under the action and have a size in the required range:
    /// the closure of each free column, and of the columns that each single row depends on.
    ///
    /// The free columns are the vertices of a graph:
    ///
    /// ```text
    /// m -> a m                     if a m is free
    /// m -> t for all t in the row  if a m is a pivot, whose row is  a m + sum of c_t t = 0
    /// ```
    ///
    /// A closed set is a set of vertices that no edge leaves. With k free columns the transitive
    /// closure costs k^3 / 64 word operations. There is none where the flag is set.
    fn closed_sets(&self, requirements: &Requirements<'_>, vanishing: &Vanishing<'_>) -> BTreeSet<Vec<usize>> {
        let free: Vec<usize> = (0..self.part.len()).filter(|&column| self.is_free(column)).collect();
        let mut index_of = vec![usize::MAX; self.part.len()];
        free.iter().enumerate().for_each(|(at, &column)| index_of[column] = at);
        let dependence = |column: usize| {
            let mut set = IndexSet::new(free.len());
            for other in self.tableau.dependence(column).into_iter().flatten() {
                set.insert(index_of[other]);
            }
            set
        };
        let next: Vec<IndexSet> = free
            .iter()
            .map(|&column| match self.image[column] {
                Some(target) if self.is_free(target) => {
                    let mut set = IndexSet::new(free.len());
                    set.insert(index_of[target]);
                    set
                }
                Some(target) => dependence(target),
                // The image of a permissible column is a column, so this does not happen.
                None => IndexSet::new(free.len()),
            })
            .collect();
        let goes_on = || !is_set(self.interruption);
        let closures = closures(next, &goes_on);
        let is_expressed = |column: &&usize| matches!(self.part[**column], Part::Reducible | Part::Permissible);
        let of_rows = self.tableau.pivots().iter().filter(is_expressed).take_while(|_| goes_on()).map(|&column| {
            let mut union = IndexSet::new(free.len());
            dependence(column).iter().for_each(|at| union.extend(&closures[at]));
            union
        });
        let sets: BTreeSet<IndexSet> = closures.iter().cloned().chain(of_rows).collect();
        if !goes_on() {
            return BTreeSet::new();
        }
        let sizes = requirements.solutions..=requirements.max_basis;
        let columns = |set: IndexSet| set.iter().map(|at| free[at]).collect();
        let sets = sets.into_iter().filter(|set| sizes.contains(&set.len())).map(columns);
        sets.filter(|basis: &Vec<usize>| !vanishing.somewhere(basis)).collect()
    }

    fn is_free(&self, column: usize) -> bool {
        self.part[column] == Part::Permissible && !self.tableau.is_pivot(column)
    }

    /// aB \ B, increasing.
    fn image_outside(&self, basis: &[usize]) -> Vec<usize> {
        let mut image: Vec<usize> =
            basis.iter().filter_map(|&b| self.image[b]).filter(|t| basis.binary_search(t).is_err()).collect();
        image.sort_unstable();
        image
    }

    /// Whether the column is in B, or a row expresses it in B.
    fn is_expressed(&self, column: usize, basis: &[usize]) -> bool {
        let is_basis = |other: &usize| basis.binary_search(other).is_ok();
        is_basis(&column)
            || self.tableau.dependence(column).is_some_and(|mut others| others.all(|other| is_basis(&other)))
    }

    /// The columns to express in a closed B so that every unknown can be read, increasing: aB \ B,
    /// and further columns for unknowns that B and aB do not give. `None` if an unknown cannot be
    /// read.
    fn readable(
        &self,
        matrix: &ShiftMatrix,
        basis: &[usize],
        readings: &[Reading],
        vanishing: &Vanishing<'_>,
    ) -> Option<Vec<usize>> {
        let mut reducible = self.image_outside(basis);
        for (reading, zeros) in readings.iter().flat_map(|reading| vanishing.sets().map(move |zeros| (reading, zeros)))
        {
            let known =
                |column: usize| basis.binary_search(&column).is_ok() || reducible.binary_search(&column).is_ok();
            let divides = |m: usize| !vanishing.vanishes(m, zeros);
            let mut from = basis.iter().chain(&reducible).copied().filter(|&m| divides(m));
            if from.any(|m| matrix.steps_from(m, reading).any(known)) {
                continue;
            }
            // A ratio with one known monomial takes one column more. Columns decrease, so the last
            // pair is the lowest.
            let expressed = |column: usize| self.is_expressed(column, basis);
            let one_of = |m: usize, sm: usize| match (known(m), known(sm)) {
                (true, false) => expressed(sm).then_some(sm),
                (false, true) => expressed(m).then_some(m),
                _ => None,
            };
            let lowest = (0..matrix.monomials.len())
                .rev()
                .filter(|&m| divides(m))
                .find_map(|m| matrix.steps_from(m, reading).find_map(|sm| one_of(m, sm)))?;
            if let Err(at) = reducible.binary_search(&lowest) {
                reducible.insert(at, lowest);
            }
        }
        Some(reducible)
    }
}

/// The transitive and reflexive closure of `next`, the indices that are reached in one step
/// (Warshall's algorithm).
///
/// After step k the set of each index holds all indices that are reached over intermediate indices
/// up to k. No step is taken any more where `goes_on` is false; the sets are then of no use.
fn closures(mut next: Vec<IndexSet>, goes_on: &dyn Fn() -> bool) -> Vec<IndexSet> {
    (0..next.len()).for_each(|at| {
        next[at].insert(at);
    });
    for over in (0..next.len()).take_while(|_| goes_on()) {
        let reached = next[over].clone();
        next.iter_mut().filter(|set| set.contains(over)).for_each(|set| set.extend(&reached));
    }
    next
}

/// Shrinks P and R until the image of every column of P is in P or R, and R holds only images of P.
///
/// A column of P whose image is excess leaves P. It stays as a column of R if it is itself an
/// image. A column of R that is no image any more is excess.
fn stabilise(part: &mut [Part], image: &[Option<usize>]) {
    let is_expressible = |part: Part| matches!(part, Part::Reducible | Part::Permissible);
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
                Part::Reading => continue,
                Part::Permissible if image[column].is_some_and(|target| is_expressible(part[target])) => continue,
                Part::Permissible | Part::Reducible if is_image[column] => Part::Reducible,
                _ => Part::Excess,
            };
            is_stable &= next == part[column];
            part[column] = next;
        }
    }
}

/// The order of the columns: excess, reading, reducible, permissible, each from high to low
/// monomials.
fn rank(part: Part, column: usize, columns: usize) -> usize {
    column
        + columns
            * match part {
                Part::Excess => 0,
                Part::Reading => 1,
                Part::Reducible => 2,
                Part::Permissible => 3,
            }
}
