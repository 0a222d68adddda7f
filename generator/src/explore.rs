//! All templates that one way to grow leads to.

use crate::search::SearchOptions;
use crate::starts::{Form, Start, actions, basis_limits, grow};
use crate::template::EliminationTemplate;
use crate::template::grow::Growth;
use crate::template::improve::Improvement;
use crate::template::reduce::{DeletionOrder, reduce};
use crate::template::solving_set::Requirements;

/// What one way to grow led to.
pub(crate) struct Explored {
    /// Different templates, for one bound on |B| after another, with fewer rows first.
    pub(crate) templates: Vec<EliminationTemplate>,
    /// Number of sets of shifts.
    pub(crate) tried: usize,
    /// (columns, rows) of the largest.
    pub(crate) largest: (usize, usize),
}

/// Starts with more rows than so many percent of those of the smallest with the same bound on |B| are left out.
const ROWS_PERCENT: usize = 150;
/// For each bound on |B| so many of the smallest templates are improved.
const IMPROVED: usize = 2;

/// Grows the shifts of a form in one way, and reduces what solves to small templates for a number of bounds on |B|.
///
/// The result depends on the arguments alone, so that ways to grow can be explored anywhere and put together.
pub(crate) fn explore(form: &Form, growth: &Growth, solutions: usize, options: &SearchOptions) -> Explored {
    let grown = grow(form, growth, solutions, options);
    let mut explored = Explored { templates: Vec::new(), tried: grown.tried, largest: grown.largest };
    for max_basis in basis_limits(solutions) {
        let requirements = Requirements { unknowns: &form.reduced.kept, solutions, max_basis };
        let starts = promising(grown.starts.iter().filter(|start| start.max_basis == max_basis).collect());
        let mut templates: Vec<EliminationTemplate> = starts
            .into_iter()
            .filter_map(|start| reduce(&start.matrix, &start.action, &requirements, DeletionOrder::HighestFirst))
            .collect();
        templates.sort_by_key(|template| (template.rows(), template.basis.len()));
        let improved: Vec<EliminationTemplate> =
            templates.iter().take(IMPROVED).map(|template| improve(form, template, &requirements, options)).collect();
        for template in improved.into_iter().chain(templates) {
            if !explored.templates.contains(&template) {
                explored.templates.push(template);
            }
        }
    }
    explored
}

/// Without those that have many more rows than the smallest.
fn promising(starts: Vec<&Start>) -> Vec<&Start> {
    let least = starts.iter().map(|start| start.matrix.rows.len()).min().unwrap_or(0);
    starts.into_iter().filter(|start| start.matrix.rows.len() * 100 <= least * ROWS_PERCENT).collect()
}

fn improve(
    form: &Form,
    template: &EliminationTemplate,
    requirements: &Requirements<'_>,
    options: &SearchOptions,
) -> EliminationTemplate {
    let improvement = Improvement {
        field: form.instance.field,
        equations: &form.instance.equations,
        actions: &actions(form),
        rounds: options.shuffles,
        seed: options.seed,
    };
    improvement.of(template.clone(), requirements)
}
