//! Instances, and the files that hold them: one JSON object in each line.
//!
//! ```text
//! {"problem": "trilateration", "family": "scene", "data": [0.1, ..], "solutions": [[1.5, 2, 0.5]]}
//! ```
//!
//! `data` are flat, one parameter after another, arrays row by row. `level`, a number that orders
//! the instances of a family, and `solutions`, known values of all unknowns, may be absent; vectors
//! that are given up to scale have any length. So may `results`, which are known values of what the
//! problem returns, null for what is not known. `note` is for the reader.

use std::fmt::Write as _;
use std::path::Path;

use eliminant::Complex;
use serde::{Deserialize, Serialize};

use crate::command::error::CommandError;
use crate::command::files::{read_text, write};
use crate::plan::Plan;
use crate::search::measuring::results::{all, in_charts, is_among, is_among_results, results_of};

/// Data of a problem, with what is known of them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Instance {
    /// The problem.
    pub(super) problem: String,
    /// What makes the instance: a name.
    pub(super) family: String,
    /// How far it goes, such as a power of ten.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) level: Option<f64>,
    /// One parameter after another, arrays row by row.
    pub(super) data: Vec<f64>,
    /// Real solutions that are known from the way in which the instance was made.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) solutions: Vec<Vec<f64>>,
    /// What the problem returns for solutions that are known so; null where it is not known.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) results: Vec<Vec<Option<f64>>>,
    /// What was seen of it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) note: Option<String>,
}

impl Instance {
    /// How many of the known solutions and results the returned real solutions lack.
    pub(super) fn missed(&self, plan: &Plan, real: &[Vec<Complex<f64>>]) -> usize {
        if self.solutions.is_empty() && self.results.is_empty() {
            return 0;
        }
        let points: Vec<Vec<f64>> = real.iter().map(|point| point.iter().map(|x| x.re).collect()).collect();
        let results = if self.results.is_empty() { Vec::new() } else { results_of(plan, &self.data, &points) };
        let of_solutions = self.solutions.iter().filter(|known| !is_among(&points, &all(known)));
        let of_results = self.results.iter().filter(|known| !is_among_results(plan, results.clone(), known));
        of_solutions.count() + of_results.count()
    }
}

/// So many wrong lines are shown.
const MOST_ERRORS: usize = 5;

/// Reads a file of instances of these problems.
pub(super) fn read_instances(path: &Path, plans: &[&Plan]) -> Result<Vec<Instance>, CommandError> {
    let text = read_text(path)?;
    let (mut instances, mut errors) = (Vec::new(), Vec::new());
    for (at, line) in text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty()) {
        match parse(line, plans) {
            Ok(instance) => instances.push(instance),
            Err(reason) => errors.push(CommandError::Instance { path: path.to_owned(), line: at + 1, reason }),
        }
    }
    match errors.len() {
        0 if instances.is_empty() => {
            Err(CommandError::Instance { path: path.to_owned(), line: 1, reason: "there is no instance".into() })
        }
        0 => Ok(instances),
        1 => Err(errors.remove(0)),
        count => {
            errors.truncate(MOST_ERRORS);
            if let Some(CommandError::Instance { reason, .. }) = errors.last_mut()
                && count > MOST_ERRORS
            {
                let _ = write!(reason, "; {} more lines are wrong", count - MOST_ERRORS);
            }
            Err(CommandError::Several(errors))
        }
    }
}

fn parse(line: &str, plans: &[&Plan]) -> Result<Instance, String> {
    let mut instance: Instance = serde_json::from_str(line).map_err(|error| error.to_string())?;
    let name = &instance.problem;
    let Some(plan) = plans.iter().find(|plan| plan.name == *name) else {
        return Err(format!("it is of the problem `{name}`, which is not among those that are measured"));
    };
    if instance.data.len() != plan.given() {
        return Err(format!("`{name}` takes {} numbers as data, not {}", plan.given(), instance.data.len()));
    }
    for solution in &mut instance.solutions {
        *solution = in_charts(plan, solution)?;
    }
    let returned: usize = plan.output.iter().map(|output| output.scalars.len()).sum();
    if let Some(results) = instance.results.iter().find(|results| results.len() != returned) {
        return Err(format!("`{name}` returns {returned} numbers, not {}", results.len()));
    }
    Ok(instance)
}

/// Writes a file of instances.
pub(super) fn write_instances(path: &Path, instances: &[Instance]) -> Result<(), CommandError> {
    let mut text = String::new();
    for instance in instances {
        // Only maps with keys other than strings cannot be written, and a string takes all.
        let _ = writeln!(text, "{}", serde_json::to_string(instance).unwrap_or_default());
    }
    write(path, &text)
}
