//! All templates that one way to grow leads to.

use std::collections::HashMap;
use std::hash::Hash;
use std::sync::{Mutex, PoisonError};

use super::grow::Growth;
use super::improve::Improvement;
use super::monitor::Monitor;
use super::options::SearchOptions;
use super::reduce::{DeletionOrder, reduce};
use super::solving_set::Requirements;
use super::starts::{Form, Start, grow};
use crate::algebra::Monomial;
use crate::presolve::Presolve;
use crate::template::shift_matrix::ShiftMatrix;
use crate::template::{EliminationTemplate, Shift};

/// What one way to grow led to.
pub(crate) struct Explored {
    /// Different templates, for one bound on |B| after another, with fewer rows first.
    pub(crate) templates: Vec<EliminationTemplate>,
    /// Number of sets of shifts.
    pub(crate) tried: usize,
    /// (columns, rows) of the largest.
    pub(crate) largest: (usize, usize),
    /// The largest where none solves.
    pub(crate) unsolved: Option<ShiftMatrix>,
}

/// Starts with more rows than so many percent of those of the smallest with the same bound on |B| are left out.
const ROWS_PERCENT: usize = 150;
/// For each bound on |B| starts are reduced, the smallest first, until the next would exceed this estimate of multiplications; at least [`LEAST_REDUCED`] are.
const WORK: usize = 100_000_000;
/// See [`WORK`].
const LEAST_REDUCED: usize = 4;
/// For each bound on |B| so many of the smallest templates are returned, and so many of them are improved first.
const RETURNED: usize = 8;
const IMPROVED: usize = 2;
/// A template with more rows than this is improved less often, in proportion.
const ROWS_OF_FULL_IMPROVEMENT: u64 = 50;

/// What was computed before: different ways to grow often come to the same rows. It saves work and changes no result.
#[derive(Default)]
pub(crate) struct Memory {
    reduced: Remembered<(FormKey, Vec<Shift>, Monomial, usize), Option<EliminationTemplate>>,
    improved: Remembered<(FormKey, EliminationTemplate, usize), EliminationTemplate>,
}

/// What tells forms apart.
type FormKey = (Presolve, bool);

fn key(form: &Form) -> FormKey {
    (form.presolve, form.symmetry.is_none())
}

/// Values of a function by its arguments.
struct Remembered<K, V>(Mutex<HashMap<K, V>>);

impl<K, V> Default for Remembered<K, V> {
    fn default() -> Self {
        Self(Mutex::new(HashMap::new()))
    }
}

impl<K: Eq + Hash, V: Clone> Remembered<K, V> {
    /// The value remembered for `key`, or else what `compute` returns, which may be computed twice by two threads.
    fn get(&self, key: K, compute: impl FnOnce() -> V) -> V {
        let known = || self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let value = known().get(&key).cloned();
        value.unwrap_or_else(|| {
            let value = compute();
            known().insert(key, value.clone());
            value
        })
    }
}

/// Grows the shifts of a form in one way, and reduces what solves to small templates for a number of bounds on |B|.
///
/// Unless the monitor ends it the result depends on the arguments other than `memory` alone, so that ways to grow can be explored anywhere and put together.
pub(crate) fn explore(
    form: &Form,
    growth: &Growth,
    solutions: usize,
    options: &SearchOptions,
    memory: &Memory,
    monitor: &dyn Monitor,
) -> Explored {
    let grown = grow(form, growth, solutions, options, monitor);
    let mut explored =
        Explored { templates: Vec::new(), tried: grown.tried, largest: grown.largest, unsolved: grown.unsolved };
    for max_basis in form.basis_limits(solutions) {
        let requirements = form.requirements(solutions, max_basis);
        let starts = promising(grown.starts.iter().filter(|start| start.max_basis == max_basis).collect());
        let reduced = |start: &Start| {
            let key = (key(form), start.matrix.shifts.clone(), start.action, max_basis);
            let compute = || reduce(&start.matrix, &start.action, &requirements, DeletionOrder::HighestFirst, monitor);
            memory.reduced.get(key, compute)
        };
        let mut templates: Vec<EliminationTemplate> = starts.into_iter().filter_map(reduced).collect();
        templates.sort_by_key(|template| (template.rows(), template.basis.len()));
        templates.dedup();
        templates.truncate(RETURNED);
        let improved = |template: &EliminationTemplate| {
            let compute = || improve(form, template, &requirements, options, monitor);
            memory.improved.get((key(form), template.clone(), max_basis), compute)
        };
        let improved: Vec<EliminationTemplate> = templates.iter().take(IMPROVED).map(improved).collect();
        for template in improved.into_iter().chain(templates) {
            let template = template.in_lowest_terms(&form.instance.equations);
            if !explored.templates.contains(&template) {
                explored.templates.push(template);
            }
        }
    }
    explored
}

/// Those to reduce, smallest first.
fn promising(mut starts: Vec<&Start>) -> Vec<&Start> {
    starts.sort_by_key(|start| (start.matrix.rows.len(), start.matrix.monomials.len()));
    let least = starts.first().map_or(0, |start| start.matrix.rows.len());
    let mut work = 0;
    let mut count = 0;
    starts
        .into_iter()
        .take_while(|start| {
            let (rows, columns) = (start.matrix.rows.len(), start.matrix.monomials.len());
            // As many trials as rows; each updates a row for each of about |B| reducible columns.
            work += rows * start.max_basis * (rows + columns);
            count += 1;
            rows * 100 <= least * ROWS_PERCENT && (work <= WORK || count <= LEAST_REDUCED)
        })
        .collect()
}

fn improve(
    form: &Form,
    template: &EliminationTemplate,
    requirements: &Requirements<'_>,
    options: &SearchOptions,
    monitor: &dyn Monitor,
) -> EliminationTemplate {
    // Between shifts of one class of monomials.
    let unknowns = form.reduced.kept.iter().map(|&unknown| Monomial::unknown(unknown));
    let steps: Vec<Monomial> = if form.symmetry.is_none() { unknowns.collect() } else { form.actions.clone() };
    let improvement = Improvement {
        field: form.instance.field,
        equations: &form.instance.equations,
        actions: &form.actions,
        steps: &steps,
        rounds: options.shuffles * ROWS_OF_FULL_IMPROVEMENT / ROWS_OF_FULL_IMPROVEMENT.max(template.rows() as u64),
        seed: options.seed,
    };
    improvement.of(template.clone(), requirements, monitor)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::Problem;
    use crate::search::monitor::Unmonitored;
    use crate::search::starts::forms;

    #[test]
    fn what_is_remembered_changes_no_result() {
        let text = "/// Two conics.\nfn conics(a: [f64; 6], b: [f64; 6]) -> (x, y) {\n    dot(a, [x * x, x * y, y * y, x, y, 1]) == 0;\n    \
                    dot(b, [x * x, x * y, y * y, x, y, 1]) == 0;\n}\n";
        let problem = Problem::parse("conics.rs", text).unwrap();
        let options = SearchOptions::default();
        let forms = forms(&problem, &options).unwrap();
        let shared = Memory::default();
        for growth in [Growth::Degree(vec![1, 1]), Growth::Neighbours, Growth::BestShift(0), Growth::Degree(vec![1, 1])]
        {
            let [alone, together] = [&Memory::default(), &shared]
                .map(|memory| explore(&forms[0], &growth, 4, &options, memory, &Unmonitored).templates);
            assert_eq!(alone, together);
            let sizes: Vec<_> = alone.iter().map(|t| (t.rows(), t.basis.len())).collect();
            assert!(sizes.contains(&(6, 4)) && sizes.contains(&(4, 5)), "{growth}: {sizes:?}");
        }
    }
}
