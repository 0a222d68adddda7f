//! A template with its plan, as a search finds it.

use super::formulation::SEARCH_FIELD;
use super::options::SearchOptions;
use super::preference::{BURDEN_OF_PRESOLVE, Cost};

use crate::plan::Plan;
use crate::presolve::Presolve;
use crate::problem::Problem;
use crate::template::EliminationTemplate;
use crate::template::file::TemplateFile;

/// A template with how it was found and what it costs.
#[derive(Clone, Debug)]
pub struct TemplateCandidate {
    /// How the problem was presolved.
    pub presolve: Presolve,
    /// Position of the strategy that found it among all strategies.
    pub strategy: usize,
    /// How that strategy grew the set of shifts, in words.
    pub growth: String,
    /// The template.
    pub template: EliminationTemplate,
    /// The plan of its solver.
    pub plan: Plan,
    /// Sets of unknowns that are 0 together at a solution.
    pub zero_sets: Vec<Vec<usize>>,
}

impl TemplateCandidate {
    /// The template file of the candidate. Its provenance holds the options of the search.
    pub fn to_file(&self, problem: &Problem, options: &SearchOptions) -> TemplateFile {
        let mut provenance = vec![
            ("generator".to_owned(), env!("CARGO_PKG_VERSION").to_owned()),
            ("prefer".to_owned(), options.prefer.to_string()),
            ("growth".to_owned(), self.growth.clone()),
            ("max_columns".to_owned(), options.max_columns.to_string()),
            ("shuffles".to_owned(), options.shuffles.to_string()),
            ("seed".to_owned(), options.seed.to_string()),
            ("prime".to_owned(), SEARCH_FIELD.modulus().to_string()),
        ];
        provenance.extend(options.max_basis.map(|most| ("max_basis".to_owned(), most.to_string())));
        provenance.push(("operations".to_owned(), self.plan.operations().total().to_string()));
        TemplateFile {
            problem: problem.name.clone(),
            fingerprint: problem.fingerprint(),
            solutions: self.plan.solutions,
            presolve: self.presolve,
            roots: self.plan.roots(),
            template: self.template.clone(),
            zero_sets: self.zero_sets.clone(),
            provenance,
        }
    }

    /// The cost of the solver. Where equations are solved at run time its time counts 1.25 times.
    pub fn cost(&self) -> Cost {
        let nanoseconds = self.plan.predicted_nanoseconds(0.0);
        let burden = if self.plan.is_presolved_at_run_time() { BURDEN_OF_PRESOLVE } else { 1.0 };
        Cost {
            nanoseconds: (burden * nanoseconds).round() as usize,
            second_attempt: (self.plan.predicted_nanoseconds(1.0) - nanoseconds).round() as usize,
            operations: self.plan.operations().total(),
            rows: self.template.rows(),
            basis: self.template.basis.len(),
        }
    }
}
