//! `eliminant check`: reads a problem and counts its solutions.

use std::fmt;
use std::path::PathBuf;
use std::time::Instant;

use serde::Serialize;

use super::error::CommandError;
use super::files::read_problem;
use super::progress::spinner;
use super::report::{Output, counted, seconds};
use crate::check::check;
use crate::presolve::symmetry::Symmetry;
use crate::presolve::{Presolve, presolve};
use crate::problem::Problem;

/// Read a problem and count its solutions for general data
#[derive(clap::Args, Debug)]
#[command(after_help = "Example:
  eliminant check problems/two_circles.rs")]
pub(super) struct Arguments {
    /// The problem file
    file: PathBuf,
}

#[derive(Serialize)]
struct ProblemReport {
    problem: String,
    unknowns: usize,
    unknown_names: Vec<String>,
    equations: usize,
    /// The total degree of each equation.
    degrees: Vec<i32>,
    /// Number of `!= 0` statements.
    nonzero: usize,
    /// Number of scalars in all data.
    data: usize,
    solutions: usize,
    /// Number of different solutions.
    different: usize,
    /// Groups of unknowns: changing the signs of a group turns a solution into another.
    sign_changes: Vec<Vec<String>>,
    /// Whether all unknowns 0 is a solution that no factor excludes.
    origin: bool,
    presolve: Vec<PresolvedForm>,
    seconds: f64,
}

/// What one way to presolve leaves.
#[derive(Serialize)]
struct PresolvedForm {
    kind: String,
    eliminated: Vec<String>,
    kept: Vec<String>,
    degrees: Vec<i32>,
}

pub(super) fn run(arguments: &Arguments) -> Result<Output, CommandError> {
    let start = Instant::now();
    let problem = read_problem(&arguments.file)?;
    let progress = spinner();
    progress.set_message("counting solutions");
    let count = check(&problem)?;
    progress.finish_and_clear();
    Ok(Output::of(&ProblemReport {
        problem: problem.name.clone(),
        unknowns: problem.unknowns.len(),
        unknown_names: problem.unknowns.clone(),
        equations: problem.equations.len(),
        degrees: degrees(&problem),
        nonzero: problem.nonzero.len(),
        data: problem.input_count(),
        solutions: count.solutions,
        different: count.different,
        sign_changes: sign_changes(&problem),
        origin: problem.has_origin(),
        presolve: forms(&problem),
        seconds: start.elapsed().as_secs_f64(),
    }))
}

fn degrees(problem: &Problem) -> Vec<i32> {
    problem.polynomials().map(|p| p.monomials().map(|m| m.degree()).max().unwrap_or(0)).collect()
}

fn sign_changes(problem: &Problem) -> Vec<Vec<String>> {
    let names = |flip: Vec<usize>| flip.into_iter().map(|unknown| problem.unknowns[unknown].clone()).collect();
    Symmetry::of_problem(problem).generators().into_iter().map(names).collect()
}

/// The ways to presolve that eliminate an unknown or lower a degree.
fn forms(problem: &Problem) -> Vec<PresolvedForm> {
    let mut forms: Vec<PresolvedForm> = Vec::new();
    for how in [Presolve::Constant, Presolve::Linear, Presolve::Combined, Presolve::CombinedLinear] {
        let reduced = presolve(problem, how);
        let names = |indices: &[usize]| indices.iter().map(|&at| problem.unknowns[at].clone()).collect::<Vec<_>>();
        let form = PresolvedForm {
            kind: how.name(),
            eliminated: names(&reduced.recoveries.iter().map(|recovery| recovery.unknown).collect::<Vec<_>>()),
            kept: names(&reduced.kept),
            degrees: degrees(&reduced.problem),
        };
        let is_known = |known: &PresolvedForm| known.kept == form.kept && known.degrees == form.degrees;
        let changes = !form.eliminated.is_empty() || form.degrees != degrees(problem);
        if changes && !forms.iter().any(is_known) {
            forms.push(form);
        }
    }
    forms
}

impl fmt::Display for ProblemReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let list = |degrees: &[i32]| degrees.iter().map(i32::to_string).collect::<Vec<_>>().join(", ");
        writeln!(f, "problem    {}", self.problem)?;
        writeln!(f, "unknowns   {} ({})", self.unknowns, self.unknown_names.join(", "))?;
        writeln!(f, "equations  {} of degree {}", self.equations, list(&self.degrees))?;
        if self.nonzero > 0 {
            writeln!(f, "nonzero    {}", counted(self.nonzero, "factor"))?;
        }
        writeln!(f, "data       {}", counted(self.data, "scalar"))?;
        if self.presolve.is_empty() {
            writeln!(f, "presolve   no unknown can be eliminated beforehand")?;
        }
        for PresolvedForm { kind, eliminated, kept, degrees } in &self.presolve {
            write!(f, "presolve   {kind}: ")?;
            if !eliminated.is_empty() {
                write!(f, "eliminates {}; ", eliminated.join(", "))?;
            }
            writeln!(f, "leaves {} in equations of degree {}", kept.join(", "), list(degrees))?;
        }
        match self.different {
            different if different == self.solutions => writeln!(f, "solutions  {different}")?,
            different => writeln!(f, "solutions  {different} different ones, {} with multiplicity", self.solutions)?,
        }
        if self.origin {
            let name = self.unknown_names.first().map_or("x", String::as_str);
            writeln!(f, "origin     all unknowns 0 is a solution, and is counted. Exclude it with `{name} != 0;`")?;
        }
        for unknowns in &self.sign_changes {
            writeln!(f, "symmetry   changing the sign of {} gives another solution", unknowns.join(", "))?;
        }
        writeln!(f, "time       {}", seconds(self.seconds))
    }
}
