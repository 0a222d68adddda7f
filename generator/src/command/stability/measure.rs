//! Solves and judges instances of all subjects.

use std::path::Path;

use indicatif::ProgressBar;
use rayon::prelude::*;

use super::condition::Condition;
use super::instance::Instance;
use super::outcome::Outcome;
use super::solve::{self, Returned, SolvingCrate, interpreted};
use super::subjects::Subject;
use crate::command::error::CommandError;
use crate::command::interrupt::is_interrupted;
use crate::plan::Plan;
use crate::search::measuring::in_pool;
use crate::search::measuring::interpreted::InterpretedSolver;

/// An instance and what came of it.
pub(super) struct Measured {
    pub(super) instance: Instance,
    pub(super) outcome: Outcome,
}

/// Microseconds of one core that an instance takes, by a rough count: Newton's method at 237 bits
/// evaluates each term some ten times for each solution, and solving takes some operations, several
/// times over.
pub(super) fn microseconds(plan: &Plan) -> f64 {
    let terms: usize = plan.equations.iter().map(Vec::len).sum();
    15.0 * (plan.solutions * terms) as f64 + plan.operations().total() as f64 / 100.0
}

/// Solves the instances of each subject by emitted code and judges what is returned.
pub(super) fn measure_emitted(
    subjects: &[Subject],
    instances: Vec<Vec<Instance>>,
    runtime: Option<&Path>,
    progress: &ProgressBar,
) -> Result<Vec<Vec<Measured>>, CommandError> {
    let all: Vec<solve::Subject<'_>> = subjects
        .iter()
        .zip(&instances)
        .map(|(subject, instances)| solve::Subject {
            plan: &subject.loaded.planned.plan,
            source: &subject.source,
            data: instances.iter().map(|instance| instance.data.as_slice()).collect(),
        })
        .collect();
    let Some(first) = subjects.first() else { return Ok(Vec::new()) };
    let solving = SolvingCrate::new(&all, runtime, &first.file)?;
    let mut returned = Vec::new();
    for (number, subject) in all.iter().enumerate() {
        returned.push(solving.run(number, subject)?);
        progress.inc(1);
    }
    drop(all);
    let judge = |((subject, instances), returned): ((&Subject, Vec<Instance>), Vec<Returned>)| {
        judged(&subject.loaded.planned.plan, instances, Some(returned), progress)
    };
    subjects.iter().zip(instances).zip(returned).map(judge).collect()
}

/// The same by interpreted plans, which return the same bits, and no times.
pub(super) fn measure_interpreted(
    subjects: &[Subject],
    instances: Vec<Vec<Instance>>,
    progress: &ProgressBar,
) -> Result<Vec<Vec<Measured>>, CommandError> {
    let of_subject = |(subject, instances): (&Subject, Vec<Instance>)| {
        judged(&subject.loaded.planned.plan, instances, None, progress)
    };
    subjects.iter().zip(instances).map(of_subject).collect()
}

fn judged(
    plan: &Plan,
    instances: Vec<Instance>,
    returned: Option<Vec<Returned>>,
    progress: &ProgressBar,
) -> Result<Vec<Measured>, CommandError> {
    let solver = InterpretedSolver::of(plan);
    let judge = |(at, instance): (usize, Instance)| {
        if is_interrupted() {
            return Err(CommandError::Ended);
        }
        let known = returned.as_ref().and_then(|returned| returned.get(at));
        let returned = known.cloned().unwrap_or_else(|| interpreted(&solver, &instance.data));
        let condition = Condition::of(plan, &solver, &instance.data);
        let outcome = Outcome::of(plan, &instance, &returned, condition);
        progress.inc(1);
        Ok(Measured { instance, outcome })
    };
    in_pool(|| instances.into_par_iter().enumerate().map(judge).collect())
}
