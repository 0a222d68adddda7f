//! All templates that one strategy leads to: its seed sets, reduced and improved.

use super::cache::Cache;
use super::formulation::Formulation;
use super::improve::Improvement;
use super::monitor::Monitor;
use super::options::SearchOptions;
use super::reduce::{DeletionOrder, reduce};
use super::seed_sets::{SeedSets, SolvingShifts, seed_sets};
use super::strategy::Strategy;
use crate::algebra::Monomial;
use crate::template::EliminationTemplate;
use crate::template::shift_matrix::ShiftMatrix;

/// What all strategies of a search have in common.
pub(crate) struct StrategyContext<'a> {
    pub(crate) options: &'a SearchOptions,
    pub(crate) cache: &'a Cache,
    pub(crate) monitor: &'a dyn Monitor,
}

/// What one strategy led to.
pub(crate) struct StrategyTemplates {
    /// Different templates, for one bound on |B| after another, those with fewer rows first.
    pub(crate) templates: Vec<EliminationTemplate>,
    /// Number of sets of shifts that were looked at.
    pub(crate) tried: usize,
    /// (columns, rows) of the largest.
    pub(crate) largest: (usize, usize),
    /// The largest set if none solves.
    pub(crate) unsolved: Option<ShiftMatrix>,
    /// Whether a set by the trace of a Gröbner basis was left out for its size.
    pub(crate) is_too_large: bool,
}

/// Seed sets with more rows than this percentage of the smallest one for the same bound on |B| are
/// left out.
const ROWS_PERCENT: usize = 150;
/// For each bound on |B| seed sets are reduced, the smallest first, until the next one would exceed
/// this estimate of multiplications. At least [`LEAST_REDUCED`] are.
const WORK: usize = 100_000_000;
/// See [`WORK`].
const LEAST_REDUCED: usize = 4;
/// Number of templates that are returned for each bound on |B|, the smallest.
const RETURNED: usize = 8;
/// Number of these that are improved first.
const IMPROVED: usize = 2;
/// A template with more rows than this is improved in fewer rounds, in proportion.
const ROWS_OF_FULL_IMPROVEMENT: u64 = 50;

/// Grows the shifts of a strategy, and reduces what solves to small templates for each bound on
/// |B|.
///
/// Unless the monitor ends it, the result depends on the strategy, the number of solutions and the
/// options alone. Strategies can therefore be reduced anywhere, and their templates put together.
pub(crate) fn reduce_strategy(strategy: &Strategy<'_>, context: &StrategyContext<'_>) -> StrategyTemplates {
    let StrategyContext { options, cache, monitor } = *context;
    let formulation = strategy.formulation;
    let seeds = seed_sets(strategy, options, monitor);
    let mut templates: Vec<EliminationTemplate> = Vec::new();
    for max_basis in formulation.basis_limits() {
        let requirements = formulation.requirements(max_basis);
        let reduced = |shifts: &SolvingShifts| {
            let key = (formulation.key(), shifts.matrix.shifts.clone(), shifts.action, max_basis);
            let order = DeletionOrder::HighestFirst;
            cache.reduced.get(key, || reduce(&shifts.matrix, &shifts.action, &requirements, order, monitor))
        };
        let seeds = promising(seeds.solving.iter().filter(|shifts| shifts.max_basis == max_basis).collect());
        let mut smallest: Vec<EliminationTemplate> = seeds.into_iter().filter_map(reduced).collect();
        smallest.sort_by_key(|template| (template.rows(), template.basis.len()));
        smallest.dedup();
        smallest.truncate(RETURNED);
        let improved = |template: &EliminationTemplate| {
            let key = (formulation.key(), template.clone(), max_basis);
            let improvement = improvement(formulation, template, options);
            cache.improved.get(key, || improvement.of(template.clone(), &requirements, monitor))
        };
        let improved: Vec<EliminationTemplate> = smallest.iter().take(IMPROVED).map(improved).collect();
        for template in improved.into_iter().chain(smallest) {
            let template = template.in_lowest_terms(&formulation.instance.equations);
            if !templates.contains(&template) {
                templates.push(template);
            }
        }
    }
    let SeedSets { tried, largest, unsolved, is_too_large, .. } = seeds;
    StrategyTemplates { templates, tried, largest, unsolved, is_too_large }
}

/// The seed sets to reduce, smallest first.
fn promising(mut seeds: Vec<&SolvingShifts>) -> Vec<&SolvingShifts> {
    seeds.sort_by_key(|seed| (seed.matrix.rows.len(), seed.matrix.monomials.len()));
    let least = seeds.first().map_or(0, |seed| seed.matrix.rows.len());
    let mut work = 0;
    let mut count = 0;
    seeds
        .into_iter()
        .take_while(|seed| {
            let (rows, columns) = (seed.matrix.rows.len(), seed.matrix.monomials.len());
            // There are as many trials as rows. Each updates a row of the tableau for each of about
            // |B| reducible columns.
            work += rows * seed.max_basis * (rows + columns);
            count += 1;
            rows * 100 <= least * ROWS_PERCENT && (work <= WORK || count <= LEAST_REDUCED)
        })
        .collect()
}

/// How a template of a formulation is improved.
fn improvement<'a>(
    formulation: &'a Formulation,
    template: &EliminationTemplate,
    options: &SearchOptions,
) -> Improvement<'a> {
    // If sign changes are used, all rows are of one parity in the unknowns that change. A step
    // between two of them must keep that parity, as action monomials do.
    let steps: Vec<Monomial> = match formulation.symmetry.is_none() {
        true => formulation.reduced.kept.iter().map(|&unknown| Monomial::unknown(unknown)).collect(),
        false => formulation.actions.clone(),
    };
    Improvement {
        field: formulation.instance.field,
        equations: &formulation.instance.equations,
        actions: &formulation.actions,
        steps,
        rounds: options.shuffles * ROWS_OF_FULL_IMPROVEMENT / ROWS_OF_FULL_IMPROVEMENT.max(template.rows() as u64),
        seed: options.seed,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::check;
    use crate::problem::Problem;
    use crate::search::formulation::formulations;
    use crate::search::grow::Growth;
    use crate::search::monitor::Unmonitored;

    #[test]
    fn a_cache_changes_no_result() {
        let text = "/// Two conics.\nfn conics(a: [f64; 6], b: [f64; 6]) -> (x, y) {\n    dot(a, [x * x, x * y, y * y, x, y, 1]) == 0;\n    \
                    dot(b, [x * x, x * y, y * y, x, y, 1]) == 0;\n}\n";
        let problem = Problem::parse("conics.rs", text).unwrap();
        let options = SearchOptions::default();
        let count = check(&problem).unwrap();
        let formulations = formulations(&problem, &count, &options, &Unmonitored).unwrap();
        let shared = Cache::default();
        for growth in [Growth::Degree(vec![1, 1]), Growth::Neighbours, Growth::BestShift(0), Growth::Degree(vec![1, 1])]
        {
            let strategy = Strategy { formulation: &formulations[0], growth: growth.clone() };
            let [alone, together] = [&Cache::default(), &shared].map(|cache| {
                let context = StrategyContext { options: &options, cache, monitor: &Unmonitored };
                reduce_strategy(&strategy, &context).templates
            });
            assert_eq!(alone, together);
            let sizes: Vec<_> = alone.iter().map(|t| (t.rows(), t.basis.len())).collect();
            assert!(sizes.contains(&(6, 4)) && sizes.contains(&(4, 5)), "{growth}: {sizes:?}");
        }
    }
}
