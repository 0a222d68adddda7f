//! Seed sets: the first sets of shifts of a strategy from which an action monomial solves.
//!
//! A set that solves is a template already, but mostly a large one. [`super::reduce`] deletes its
//! rows.

use super::failed_strategy::MOST_TRACED_ROWS;
use super::formulation::Formulation;
use super::grow::{Growth, Shifts};
use super::monitor::{Monitor, Stage, is_set};
use super::options::SearchOptions;
use super::reduce::{DeletionOrder, independent_rows};
use super::solving_set::{Dependencies, Obstacle};
use super::strategy::Strategy;
use super::traced_shifts::traced_shifts;
use crate::algebra::Monomial;
use crate::template::shift_matrix::ShiftMatrix;

/// Shifts from which an action monomial solves, to be reduced.
pub(crate) struct SolvingShifts {
    pub(crate) action: Monomial,
    pub(crate) matrix: ShiftMatrix,
    /// The bound on |B| for which they were found.
    pub(crate) max_basis: usize,
}

/// What growing by one strategy gave.
#[derive(Default)]
pub(crate) struct SeedSets {
    /// For each level that solves, each action monomial and each bound on |B|.
    pub(crate) solving: Vec<SolvingShifts>,
    /// Number of sets of shifts that were looked at.
    pub(crate) tried: usize,
    /// (columns, rows) of the largest.
    pub(crate) largest: (usize, usize),
    /// The largest set if none solves.
    pub(crate) unsolved: Option<ShiftMatrix>,
    /// Whether a set by the trace of a Gröbner basis was left out for its size.
    pub(crate) is_too_large: bool,
}

/// Levels to go on growing after the first that solves for the tightest bound on |B|: larger sets
/// sometimes reduce to smaller templates.
const LEVELS_BEYOND_FIRST: usize = 1;
/// Where the tightest bound is not met, growing ends at this many times the rows of the first set
/// that solves for any bound.
const ROWS_BEYOND_FIRST: usize = 3;
/// If shifts are added one by one, a set is looked at after it has grown by one row in this many.
const ROWS_BETWEEN_LOOKS: usize = 20;

/// Grows the shifts of a strategy until an action monomial solves, and a little further.
pub(crate) fn seed_sets(strategy: &Strategy<'_>, options: &SearchOptions, monitor: &dyn Monitor) -> SeedSets {
    let Strategy { formulation, growth } = strategy;
    if *growth == Growth::Trace {
        return traced_seed_sets(formulation, monitor);
    }
    let equations = &formulation.instance.equations;
    let mut sets = SeedSets::default();
    let mut levels_left = LEVELS_BEYOND_FIRST;
    let mut rows_of_first = None;
    let tightest = formulation.basis_limits().first().copied();
    let mut last_look: usize = 0;
    let grown = Shifts::new(equations, &formulation.reduced.kept, growth.clone(), options.max_columns);
    for shifts in grown.until(monitor.interruption()) {
        // To look at a set is an elimination, to add a shift is not.
        if matches!(growth, Growth::BestShift(_) | Growth::Laurent(_))
            && shifts.len() < last_look + last_look.div_ceil(ROWS_BETWEEN_LOOKS)
        {
            continue;
        }
        last_look = shifts.len();
        if monitor.is_over(Stage::Searching) {
            break;
        }
        let matrix = ShiftMatrix::new(formulation.instance.field, equations, &shifts);
        sets.tried += 1;
        sets.largest = sets.largest.max((matrix.monomials.len(), matrix.rows.len()));
        sets.solving.extend(solving_shifts(formulation, &formulation.actions, &matrix, monitor));
        if !sets.solving.is_empty() {
            sets.unsolved = None;
            // A large basis may need few rows, and one as small as the number of solutions more.
            let most = *rows_of_first.get_or_insert(matrix.rows.len()) * ROWS_BEYOND_FIRST;
            let meets_tightest = sets.solving.iter().any(|shifts| Some(shifts.max_basis) == tightest);
            if levels_left == 0 || matrix.rows.len() > most {
                break;
            }
            levels_left -= usize::from(meets_tightest);
        } else {
            sets.unsolved = Some(matrix);
        }
    }
    sets
}

/// Number of traced sets from which templates are made, the smallest that solve.
const TRACED_SETS: usize = 2;

/// The seed sets by the trace of a Gröbner basis, the smallest ones, each for its action monomial.
/// There are none if the basis is too large.
fn traced_seed_sets(formulation: &Formulation, monitor: &dyn Monitor) -> SeedSets {
    let mut sets = SeedSets::default();
    let mut found = 0;
    let of_trace = traced_shifts(formulation, monitor.interruption());
    sets.is_too_large = of_trace.is_err();
    for traced in of_trace.unwrap_or_default() {
        // The first set is looked at in any case.
        if found == TRACED_SETS || (sets.tried > 0 && monitor.is_over(Stage::Searching)) {
            break;
        }
        if traced.shifts.len() > MOST_TRACED_ROWS {
            sets.is_too_large = true;
            break;
        }
        let matrix = ShiftMatrix::new(formulation.instance.field, &formulation.instance.equations, &traced.shifts);
        let (rows, columns) = (matrix.rows.len(), matrix.monomials.len());
        monitor.say(&format!("{rows} x {columns} by the trace of a Gröbner basis"));
        sets.tried += 1;
        sets.largest = sets.largest.max((columns, rows));
        let solving = solving_shifts(formulation, &[traced.action], &matrix, monitor);
        found += usize::from(!solving.is_empty());
        sets.solving.extend(solving);
        sets.unsolved = sets.solving.is_empty().then_some(matrix);
    }
    sets
}

/// For each action monomial and each bound on |B| the rows that the best solving set needs.
fn solving_shifts(
    formulation: &Formulation,
    actions: &[Monomial],
    matrix: &ShiftMatrix,
    monitor: &dyn Monitor,
) -> Vec<SolvingShifts> {
    let mut solving = Vec::new();
    let limits = formulation.basis_limits();
    // Which rows are independent depends on no action monomial.
    let interruption = monitor.interruption();
    let independent = independent_rows(matrix, DeletionOrder::HighestFirst, interruption);
    for &action in actions {
        let dependencies = Dependencies::new(matrix, &action, &independent, &formulation.readings, interruption);
        let Some(dependencies) = dependencies else { continue };
        for &max_basis in &limits {
            let requirements = formulation.requirements(max_basis);
            let Some(set) = dependencies.best(matrix, &requirements) else { continue };
            let needed = dependencies.rows_of(&set);
            let matrix = matrix.retain_rows(&set.basis, |row| needed.binary_search(&row).is_ok());
            solving.push(SolvingShifts { action, matrix, max_basis });
        }
    }
    solving
}

/// What keeps the rows from solving, for the action monomial that comes closest; `None` if the
/// search is interrupted.
pub(crate) fn obstacle(formulation: &Formulation, matrix: &ShiftMatrix, monitor: &dyn Monitor) -> Option<Obstacle> {
    let max_basis = formulation.basis_limits().last().copied().unwrap_or(formulation.solutions);
    let requirements = formulation.requirements(max_basis);
    let interruption = monitor.interruption();
    let rows = independent_rows(matrix, DeletionOrder::HighestFirst, interruption);
    let of = |action: &Monomial| Dependencies::new(matrix, action, &rows, &formulation.readings, interruption);
    let dependencies = formulation.actions.iter().filter_map(of);
    let obstacles = dependencies.map(|dependencies| dependencies.obstacle(matrix, &requirements));
    let closest = obstacles.min_by_key(Obstacle::distance).unwrap_or(Obstacle::NoClosedSet);
    (!is_set(interruption)).then_some(closest)
}
