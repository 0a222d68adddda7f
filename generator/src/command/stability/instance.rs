//! Instances, and the files that hold them: one JSON object in each line.
//!
//! ```text
//! {"problem": "trilateration", "family": "scene", "data": [0.1, ..], "solutions": [[1.5, 2, 0.5]]}
//! ```
//!
//! `data` are flat, one parameter after another, arrays row by row. `level`, a number that orders
//! the instances of a family, and `solutions`, known values of all unknowns, may be absent; vectors
//! that are given up to scale have any length. `note` is for the reader.

use std::fmt::Write as _;
use std::path::Path;

use eliminant::emitted;
use serde::{Deserialize, Serialize};

use crate::command::error::CommandError;
use crate::command::files::{read_text, write};
use crate::plan::Plan;
use crate::problem::SolutionField;

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
    /// What was seen of it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) note: Option<String>,
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
    Ok(instance)
}

/// A solution as a solver returns it, with vectors that are given up to scale in coordinates of
/// their charts. One that is in coordinates already stays as it is.
fn in_charts(plan: &Plan, solution: &[f64]) -> Result<Vec<f64>, String> {
    if solution.len() == plan.unknowns.len() {
        return Ok(solution.to_vec());
    }
    let scalars: usize = plan.fields.iter().map(SolutionField::scalars).sum();
    if solution.len() != scalars {
        return Err(format!("a solution of `{}` has {scalars} numbers, not {}", plan.name, solution.len()));
    }
    let (mut unknowns, mut rest) = (vec![0.0; plan.unknowns.len()], solution);
    for field in &plan.fields {
        let (values, others) = rest.split_at(field.scalars());
        rest = others;
        match field.chart() {
            Some(chart) => emitted::to_chart(&chart, values, &mut unknowns[field.unknowns()]),
            None => unknowns[field.unknowns()].copy_from_slice(values),
        }
    }
    Ok(unknowns)
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
