//! Where a search starts: presolved forms, ways to grow shifts, and the sets of shifts from which an action monomial solves.

use super::error::SearchError;
use super::grow::{Growth, Shifts, linear_groups};
use super::monitor::{Monitor, Stage};
use super::options::SearchOptions;
use super::reduce::{DeletionOrder, independent_rows};
use super::solving_set::{Dependencies, Obstacle, Requirements};
use crate::algebra::{Monomial, PRIMES, PrimeField};
use crate::presolve::symmetry::{Reading, Symmetry};
use crate::presolve::{Presolve, ReducedProblem, presolve};
use crate::problem::Problem;
use crate::problem::instance::Instance;
use crate::template::shift_matrix::ShiftMatrix;

/// The field in which templates are searched.
pub(crate) const SEARCH_FIELD: PrimeField = PrimeField::new(PRIMES[0]);
/// Candidates must hold at a prime that was not used to find them.
pub(crate) const CHECK_FIELD: PrimeField = PrimeField::new(PRIMES[1]);

/// Rows that solve, to be reduced.
pub(crate) struct Start {
    pub(crate) action: Monomial,
    pub(crate) matrix: ShiftMatrix,
    /// Largest size of B.
    pub(crate) max_basis: usize,
}

/// A presolved form with an instance to search on and one to check on.
pub(crate) struct Form {
    pub(crate) presolve: Presolve,
    /// The sign changes that templates make use of.
    pub(crate) symmetry: Symmetry,
    /// The ways to read the unknowns then.
    pub(crate) readings: Vec<Vec<Reading>>,
    /// The action monomials to try.
    pub(crate) actions: Vec<Monomial>,
    pub(crate) reduced: ReducedProblem,
    pub(crate) instance: Instance,
    pub(crate) check: Instance,
    /// No larger basis is wanted, unless the solutions need it.
    max_basis: Option<usize>,
}

impl Form {
    /// What templates must satisfy. `solutions` is the number of solutions of the problem that are to be computed.
    pub(crate) fn requirements(&self, solutions: usize, max_basis: usize) -> Requirements<'_> {
        Requirements { readings: &self.readings, solutions: solutions.div_ceil(self.symmetry.order()), max_basis }
    }

    /// The different [`BASIS_PERCENT`] of the number of solutions up to sign, increasing, up to the largest that is wanted.
    pub(crate) fn basis_limits(&self, solutions: usize) -> Vec<usize> {
        let orbits = solutions.div_ceil(self.symmetry.order());
        let mut limits: Vec<usize> = BASIS_PERCENT.iter().map(|percent| (orbits * percent).div_ceil(100)).collect();
        if let Some(most) = self.max_basis {
            limits.retain(|&limit| limit < most);
            limits.push(most.max(orbits));
        }
        limits.dedup();
        limits
    }
}

/// The different presolved forms of a problem. Where signs can be changed there are two of each, since solutions that no sign change moves are
/// lost to a template that makes use of it.
pub(crate) fn forms(problem: &Problem, options: &SearchOptions) -> Result<Vec<Form>, SearchError> {
    let mut forms: Vec<Form> = Vec::new();
    let of_problem = Symmetry::of_problem(problem);
    for (_, kind) in Presolve::ALL {
        let reduced = presolve(problem, kind);
        if forms.iter().any(|form| is_same(&form.reduced, &reduced)) {
            continue;
        }
        let draw = |field, seed| Instance::draw(&reduced.problem, field, seed).ok_or(SearchError::NoInstance);
        let (instance, check) = (draw(SEARCH_FIELD, options.seed)?, draw(CHECK_FIELD, options.seed.wrapping_add(1))?);
        let symmetry = of_problem.on(&reduced.kept);
        let symmetries = [Some(symmetry.clone()).filter(|symmetry| !symmetry.is_none()), Some(Symmetry::NONE)];
        for symmetry in symmetries.into_iter().flatten() {
            let (readings, actions) = (symmetry.readings(&reduced.kept), actions(&symmetry, &reduced.kept));
            let (reduced, instance, check) = (reduced.clone(), instance.clone(), check.clone());
            let max_basis = options.max_basis;
            forms.push(Form { presolve: kind, symmetry, readings, actions, reduced, instance, check, max_basis });
        }
    }
    Ok(forms)
}

/// Whether two forms have the same unknowns and the same monomials in the same equations.
fn is_same(a: &ReducedProblem, b: &ReducedProblem) -> bool {
    let monomials = |form: &ReducedProblem| -> Vec<Vec<Monomial>> {
        form.problem.polynomials().map(|polynomial| polynomial.monomials().collect()).collect()
    };
    a.kept == b.kept && monomials(a) == monomials(b)
}

/// Weights 1 and 2 in all ways for few unknowns, one unknown at a time for more; two degrees where equations are linear in some unknowns; neighbours;
/// best shift, of polynomials and of Laurent polynomials.
pub(crate) fn growths(form: &Form) -> Vec<Growth> {
    let (kept, all) = (&form.reduced.kept, form.reduced.problem.unknowns.len());
    let mut growths = vec![Growth::Degree(vec![1; all])];
    let n = kept.len();
    let heavy_sets: Vec<usize> = match n {
        1 => vec![],
        2..=4 => (1..(1 << n) - 1).collect(),
        _ => (0..n).map(|at| 1 << at).collect(),
    };
    for heavy in heavy_sets {
        let mut weights = vec![1; all];
        kept.iter().enumerate().filter(|(at, _)| heavy >> at & 1 == 1).for_each(|(_, &unknown)| weights[unknown] = 2);
        growths.push(Growth::Degree(weights));
    }
    for apart in linear_groups(&form.instance.equations, kept) {
        growths.extend([0, 1].map(|beyond| Growth::Graded { apart: apart.clone(), beyond }));
    }
    growths.push(Growth::Neighbours);
    growths.push(Growth::BestShift(0));
    growths.push(Growth::BestShift(1));
    growths.extend([0, 1].map(Growth::Laurent));
    growths
}

/// The action monomials to try: each unknown and its reciprocal; products and ratios of two unknowns that change their signs together.
fn actions(symmetry: &Symmetry, unknowns: &[usize]) -> Vec<Monomial> {
    let unknowns: Vec<Monomial> = unknowns.iter().map(|&unknown| Monomial::unknown(unknown)).collect();
    let (keep, change): (Vec<Monomial>, Vec<Monomial>) = unknowns.into_iter().partition(|x| symmetry.keeps(x));
    let pairs = (0..change.len()).flat_map(|i| (i..change.len()).map(move |j| (i, j)));
    let of_pairs = pairs.flat_map(|(i, j)| [change[i].times(&change[j]), change[i].over(&change[j])]);
    let all = keep.iter().copied().chain(of_pairs.filter(|m| *m != Monomial::ONE && symmetry.keeps(m)));
    all.flat_map(|m| [m, Monomial::ONE.over(&m)]).collect()
}

/// Largest sizes of B to try, in percent of the number of solutions. A larger B takes fewer rows and a larger eigenvalue problem.
const BASIS_PERCENT: [usize; 6] = [100, 115, 130, 150, 175, 200];

/// What growing in one way gave.
pub(crate) struct Grown {
    pub(crate) starts: Vec<Start>,
    pub(crate) tried: usize,
    /// (columns, rows).
    pub(crate) largest: (usize, usize),
    /// The largest where there is no start.
    pub(crate) unsolved: Option<ShiftMatrix>,
}

/// Levels to go on growing after the first that solves: larger sets sometimes reduce to smaller templates.
const LEVELS_BEYOND_FIRST: usize = 1;
/// Where single shifts are added a set is looked at only when it has grown by one row in so many.
const ROWS_BETWEEN_LOOKS: usize = 20;

/// Grows one form in one way until an action monomial solves, and a little further.
pub(crate) fn grow(
    form: &Form,
    growth: &Growth,
    solutions: usize,
    options: &SearchOptions,
    monitor: &dyn Monitor,
) -> Grown {
    let equations = &form.instance.equations;
    let kept = &form.reduced.kept;
    let limits = form.basis_limits(solutions);
    let mut grown = Grown { starts: Vec::new(), tried: 0, largest: (0, 0), unsolved: None };
    let mut levels_left = LEVELS_BEYOND_FIRST;
    let mut last_look: usize = 0;
    for shifts in Shifts::new(equations, kept, growth.clone(), options.max_columns) {
        if matches!(growth, Growth::BestShift(_) | Growth::Laurent(_))
            && shifts.len() < last_look + last_look.div_ceil(ROWS_BETWEEN_LOOKS)
        {
            continue;
        }
        last_look = shifts.len();
        if monitor.is_over(Stage::Searching) {
            break;
        }
        let matrix = ShiftMatrix::new(form.instance.field, equations, &shifts);
        grown.tried += 1;
        grown.largest = grown.largest.max((matrix.monomials.len(), matrix.rows.len()));
        let independent = independent_rows(&matrix, DeletionOrder::HighestFirst);
        for &action in &form.actions {
            let Some(dependencies) = Dependencies::new(&matrix, &action, &independent, &form.readings) else {
                continue;
            };
            for &max_basis in &limits {
                let requirements = form.requirements(solutions, max_basis);
                let Some(set) = dependencies.best(&matrix, &requirements) else { continue };
                let needed = dependencies.rows_of(&set);
                let matrix = matrix.retain_rows(&set.basis, |row| needed.binary_search(&row).is_ok());
                grown.starts.push(Start { action, matrix, max_basis });
            }
        }
        if !grown.starts.is_empty() {
            grown.unsolved = None;
            if levels_left == 0 {
                break;
            }
            levels_left -= 1;
        } else {
            grown.unsolved = Some(matrix);
        }
    }
    grown
}

/// What keeps the rows from solving for any action monomial.
pub(crate) fn obstacle(form: &Form, matrix: &ShiftMatrix, solutions: usize) -> Obstacle {
    let max_basis = form.basis_limits(solutions).last().copied().unwrap_or(solutions);
    let requirements = form.requirements(solutions, max_basis);
    let rows = independent_rows(matrix, DeletionOrder::HighestFirst);
    let of = |action: &Monomial| Dependencies::new(matrix, action, &rows, &form.readings);
    let dependencies = form.actions.iter().filter_map(of);
    let obstacles = dependencies.map(|dependencies| dependencies.obstacle(matrix, &requirements));
    obstacles.min_by_key(Obstacle::distance).unwrap_or(Obstacle::NothingExpressed)
}
