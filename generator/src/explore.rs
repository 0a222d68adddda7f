//! All templates that one way to grow leads to.

use crate::monitor::Monitor;
use crate::search::SearchOptions;
use crate::starts::{Form, Start, actions, basis_limits, grow};
use crate::template::EliminationTemplate;
use crate::template::grow::Growth;
use crate::template::improve::Improvement;
use crate::template::reduce::{DeletionOrder, reduce};
use crate::template::shift_matrix::ShiftMatrix;
use crate::template::solving_set::Requirements;

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

/// Grows the shifts of a form in one way, and reduces what solves to small templates for a number of bounds on |B|.
///
/// Unless the monitor ends it the result depends on the arguments alone, so that ways to grow can be explored anywhere and put together.
pub(crate) fn explore(
    form: &Form,
    growth: &Growth,
    solutions: usize,
    options: &SearchOptions,
    monitor: &dyn Monitor,
) -> Explored {
    let grown = grow(form, growth, solutions, options, monitor);
    let mut explored =
        Explored { templates: Vec::new(), tried: grown.tried, largest: grown.largest, unsolved: grown.unsolved };
    for max_basis in basis_limits(solutions) {
        let requirements = Requirements { unknowns: &form.reduced.kept, solutions, max_basis };
        let starts = promising(grown.starts.iter().filter(|start| start.max_basis == max_basis).collect());
        let mut templates: Vec<EliminationTemplate> = starts
            .into_iter()
            .filter_map(|start| {
                reduce(&start.matrix, &start.action, &requirements, DeletionOrder::HighestFirst, monitor)
            })
            .collect();
        templates.sort_by_key(|template| (template.rows(), template.basis.len()));
        templates.dedup();
        templates.truncate(RETURNED);
        let improved: Vec<EliminationTemplate> = templates
            .iter()
            .take(IMPROVED)
            .map(|template| improve(form, template, &requirements, options, monitor))
            .collect();
        for template in improved.into_iter().chain(templates) {
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
    let improvement = Improvement {
        field: form.instance.field,
        equations: &form.instance.equations,
        actions: &actions(form),
        rounds: options.shuffles * ROWS_OF_FULL_IMPROVEMENT / ROWS_OF_FULL_IMPROVEMENT.max(template.rows() as u64),
        seed: options.seed,
    };
    improvement.of(template.clone(), requirements, monitor)
}
