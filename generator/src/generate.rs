//! From a problem and its template to the source of a solver. Files and environment are not
//! touched.

use crate::algebra::{Monomial, PRIMES, PrimeField};
use crate::emit::{EmitError, Provenance, emit};
#[cfg(feature = "search")]
use crate::plan::Chains;
use crate::plan::Plan;
use crate::plan::interpret::{self, Eliminated};
use crate::plan::schedule::{ScheduleError, schedule};
use crate::plan::solution_count::{SolutionBounds, count_solutions};
use crate::presolve::{ReducedProblem, presolve};
use crate::problem::Problem;
use crate::problem::diagnostic::Diagnostics;
use crate::problem::instance::Instance;
use crate::template::RootMethod;
use crate::template::file::{TemplateFile, TemplateFileError};
use crate::template::verify::{VerifyError, verify};

/// Why no solver can be generated from a template.
#[derive(Debug, thiserror::Error)]
pub enum GenerateError {
    /// The problem file is at fault.
    #[error(transparent)]
    Problem(#[from] Diagnostics),
    /// The template file cannot be read.
    #[error("the template file cannot be read: {0}")]
    File(#[from] TemplateFileError),
    /// The template was found for another problem, or for an earlier version of this one.
    #[error("the template belongs to {found}, not to the problem `{problem}` as it is now")]
    Stale {
        /// The problem.
        problem: String,
        /// The problem that the template file names.
        found: String,
    },
    /// The template does not hold on a random instance.
    #[error("the template does not hold for the problem: {0}")]
    Verify(#[from] VerifyError),
    /// The template gives another number of solutions than its file says.
    #[error("the template file says {file} solutions, the template gives {found}")]
    Solutions {
        /// The number in the file.
        file: usize,
        /// The number that the template gives.
        found: SolutionBounds,
    },
    /// The template does not fit the problem.
    #[error(transparent)]
    Schedule(#[from] ScheduleError),
    /// A random instance could not be drawn.
    #[error("no random instance has the support of the problem")]
    NoInstance,
    /// The basis is not one for a determinant.
    #[error(
        "the template file says `roots = \"determinant\"`, but its basis has too many chains, or more monomials than \
         there are solutions: expected `roots = \"eigenvalues\"`"
    )]
    Chains,
    /// The plan gives another action matrix than the template: a fault of this crate.
    #[error("the plan gives another action matrix than the template")]
    PlanDiffers,
    /// The printed code does not parse: a fault of this crate.
    #[error(transparent)]
    Emit(#[from] EmitError),
}

impl GenerateError {
    /// Whether a new search for a template would mend the error.
    pub fn is_stale_template(&self) -> bool {
        use GenerateError::{Chains, File, Schedule, Solutions, Stale, Verify};
        matches!(self, File(_) | Stale { .. } | Verify(_) | Solutions { .. } | Schedule(_) | Chains)
    }
}

/// The prime at which templates are verified; the search uses another one.
const VERIFY_FIELD: PrimeField = PrimeField::new(PRIMES[2]);
/// The seeds of the instances, which the search does not use either. The template must hold on the
/// first. The others are drawn only if the first gives another number of solutions than the file
/// says: data from few values (`#[integer]`) may be special in one draw.
const VERIFY_SEEDS: [u64; 3] = [0x5eed, 0x5eee, 0x5eef];

/// A problem with the plan of its solver.
#[derive(Clone, Debug)]
pub struct Planned {
    /// The form that the template is for.
    pub reduced: ReducedProblem,
    /// The plan.
    pub plan: Plan,
}

/// Verifies a template over Z_p and plans its solver.
///
/// The interpreted plan then gives the verified action matrix exactly, and this has as many
/// solutions as the file says.
///
/// # Errors
/// See [`GenerateError`].
pub fn plan(problem: &Problem, file: &TemplateFile) -> Result<Planned, GenerateError> {
    if file.problem != problem.name || file.fingerprint != problem.fingerprint() {
        let found = match file.problem == problem.name {
            true => format!("an earlier version of `{}`", file.problem),
            false => format!("`{}`", file.problem),
        };
        return Err(GenerateError::Stale { problem: problem.name.clone(), found });
    }
    let reduced = presolve(problem, file.presolve);
    let draw = |seed: u64| Instance::draw(&reduced.problem, VERIFY_FIELD, seed);
    let instance = draw(VERIFY_SEEDS[0]).ok_or(GenerateError::NoInstance)?;
    let action = verify(&file.template, VERIFY_FIELD, &instance.equations)?;
    let mut plan = schedule(problem, &reduced, &file.template, (file.solutions, &file.zero_sets))?;
    let (coefficients, eliminated) = interpreted(&plan, &instance).ok_or(GenerateError::PlanDiffers)?;
    if !eliminated.action.iter().enumerate().all(|(row, values)| values.as_slice() == action.row(row)) {
        return Err(GenerateError::PlanDiffers);
    }
    let found = count_solutions(&plan, &file.template.action, VERIFY_FIELD, &coefficients, &eliminated);
    let allows = |count: SolutionBounds| count.allows(file.solutions);
    if !allows(found) && !counts(&plan, &file.template.action, &reduced, &VERIFY_SEEDS[1..]).any(allows) {
        return Err(GenerateError::Solutions { file: file.solutions, found });
    }
    if file.roots == RootMethod::Determinant {
        let chains = plan.determinant_chains(VERIFY_FIELD, &eliminated.action);
        plan.chains = Some(chains.ok_or(GenerateError::Chains)?);
        plan.check().map_err(ScheduleError::from)?;
    }
    Ok(Planned { reduced, plan })
}

/// Whether a template gives as many solutions as its plan is for; a build refuses it otherwise. A
/// template loses a solution at which all basis monomials vanish.
#[cfg(feature = "search")]
pub(crate) fn gives_its_solutions(plan: &Plan, action: &Monomial, reduced: &ReducedProblem) -> bool {
    counts(plan, action, reduced, &VERIFY_SEEDS).any(|count| count.allows(plan.solutions))
}

/// The chains over which a determinant gives the real solutions, as a build will find them.
#[cfg(feature = "search")]
pub(crate) fn determinant_chains(plan: &Plan, reduced: &ReducedProblem) -> Option<Chains> {
    let instance = Instance::draw(&reduced.problem, VERIFY_FIELD, VERIFY_SEEDS[0])?;
    let (_, eliminated) = interpreted(plan, &instance)?;
    plan.determinant_chains(VERIFY_FIELD, &eliminated.action)
}

/// The number of solutions on each of some instances.
fn counts(
    plan: &Plan,
    action: &Monomial,
    reduced: &ReducedProblem,
    seeds: &[u64],
) -> impl Iterator<Item = SolutionBounds> {
    seeds.iter().filter_map(move |&seed| {
        let instance = Instance::draw(&reduced.problem, VERIFY_FIELD, seed)?;
        let (coefficients, eliminated) = interpreted(plan, &instance)?;
        Some(count_solutions(plan, action, VERIFY_FIELD, &coefficients, &eliminated))
    })
}

/// The coefficients of an instance, and what the elimination leaves; `None` where a divisor or a
/// block is singular.
fn interpreted(plan: &Plan, instance: &Instance) -> Option<(Vec<u32>, Eliminated<u32>)> {
    let coefficients = interpret::coefficients(plan, instance.field, &instance.inputs)?;
    let eliminated = interpret::eliminate(plan, instance.field, &coefficients)?;
    Some((coefficients, eliminated))
}

/// The source of the solver of `problem` by the template in `file`.
pub fn generate(problem: &Problem, file: &TemplateFile) -> Result<String, GenerateError> {
    let planned = plan(problem, file)?;
    Ok(emit(&planned.plan, &Provenance::of(problem, file, &planned.reduced, &planned.plan))?)
}
