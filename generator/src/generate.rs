//! From a problem and its template to the source of a solver. Files and environment are not
//! touched.

use crate::algebra::{Monomial, PRIMES, PrimeField};
use crate::emit::{EmitError, Provenance, emit};
use crate::plan::Plan;
use crate::plan::interpret::{self, Eliminated};
use crate::plan::schedule::{ScheduleError, schedule};
use crate::plan::solution_count::{SolutionBounds, count_solutions};
use crate::presolve::{ReducedProblem, presolve};
use crate::problem::Problem;
use crate::problem::diagnostic::Diagnostics;
use crate::problem::instance::Instance;
use crate::template::EliminationTemplate;
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
        use GenerateError::{File, Schedule, Solutions, Stale, Verify};
        matches!(self, File(_) | Stale { .. } | Verify(_) | Solutions { .. } | Schedule(_))
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
    let plan = schedule(problem, &reduced, &file.template, file.solutions, file.roots)?;
    let (coefficients, eliminated) = interpreted(&plan, &instance).ok_or(GenerateError::PlanDiffers)?;
    if !eliminated.action.iter().enumerate().all(|(row, values)| values.as_slice() == action.row(row)) {
        return Err(GenerateError::PlanDiffers);
    }
    let count = |(coefficients, eliminated): (Vec<u32>, Eliminated<u32>)| {
        count_solutions(&plan, &file.template.action, VERIFY_FIELD, &coefficients, &eliminated)
    };
    let found = count((coefficients, eliminated));
    let mut others = VERIFY_SEEDS[1..].iter().filter_map(|&seed| interpreted(&plan, &draw(seed)?).map(count));
    if !found.allows(file.solutions) && !others.any(|other| other.allows(file.solutions)) {
        return Err(GenerateError::Solutions { file: file.solutions, found });
    }
    Ok(Planned { reduced, plan })
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
    Ok(emit(&planned.plan, &provenance(problem, file, &planned.plan))?)
}

/// The header of the emitted module: sizes, counts, and where every row comes from.
fn provenance(problem: &Problem, file: &TemplateFile, plan: &Plan) -> Provenance {
    let mut lines = vec![
        format!("Solver of the problem `{}`: {} complex solutions.", problem.name, plan.solutions),
        String::new(),
        format!("- generator: eliminant-generator {}", env!("CARGO_PKG_VERSION")),
        format!("- problem: fingerprint {:016x}", file.fingerprint),
    ];
    lines.extend(sizes(&file.template, plan));
    lines.push(format!("- action monomial: {}", listed(&[file.template.action], &problem.unknowns)));
    lines.push(format!("- basis: {}", listed(&file.template.basis, &problem.unknowns)));
    if plan.has_origin {
        lines.push("- all unknowns 0 is a solution, whatever the data, and is returned without an eigenvalue".into());
    }
    if !plan.recoveries.is_empty() {
        let names: Vec<_> = plan.recoveries.iter().map(|r| format!("`{}`", problem.unknowns[r.unknown])).collect();
        lines.push(format!("- eliminated beforehand and recovered afterwards: {}", names.join(", ")));
    }
    lines.extend(["", "Rows: multiples of the equations, numbered after that elimination.", ""].map(String::from));
    for group in file.template.shifts.chunk_by(|a, b| a.equation == b.equation) {
        let multipliers: Vec<_> = group.iter().map(|shift| shift.multiplier).collect();
        lines.push(format!("- equation {}: {}", group[0].equation + 1, listed(&multipliers, &problem.unknowns)));
    }
    Provenance { lines }
}

/// Sizes of the template as it is written and as it is eliminated, and operations of one solve.
fn sizes(template: &EliminationTemplate, plan: &Plan) -> [String; 3] {
    let (e, operations) = (&plan.elimination, plan.operations());
    let largest = e.blocks.iter().map(|block| block.size).max().unwrap_or(0);
    [
        format!(
            "- template: {} x {} ({} excess, {} reducible, {} basis columns)",
            template.rows(),
            template.columns(),
            template.excess.len(),
            template.reducible.len(),
            template.basis.len(),
        ),
        format!(
            "- at run time: {} x {} ({} constant rows are eliminated beforehand), {} diagonal blocks, the largest of size {largest}",
            e.rows,
            e.columns(),
            template.rows() - e.rows,
            e.blocks.len()
        ),
        format!(
            "- operations: {} for coefficients, {} for the elimination, about {} for the roots",
            operations.coefficients, operations.elimination, operations.roots
        ),
    ]
}

/// Monomials as code, separated by commas.
fn listed(monomials: &[Monomial], unknowns: &[String]) -> String {
    monomials.iter().map(|m| format!("`{}`", m.display(unknowns))).collect::<Vec<_>>().join(", ")
}
