//! `eliminant check`: reads a problem and counts its solutions.

use std::fmt;
use std::path::PathBuf;
use std::time::Instant;

use serde::Serialize;

use super::error::CommandError;
use super::files::read_problem;
use super::progress::spinner;
use super::report::{Output, counted, seconds};
use crate::algebra::MAX_UNKNOWNS;
use crate::check::check;
use crate::expression::Expression;
use crate::expression::rational::Rational;
use crate::presolve::exchange::exchanged;
use crate::presolve::symmetry::Symmetry;
use crate::presolve::{Presolve, presolve};
use crate::problem::Problem;
use crate::problem::scene::Scene;
use crate::search::measuring::scene_check::SceneCheck;

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
    /// Every elimination template has at least this many columns.
    least_columns: usize,
    /// Groups of unknowns: changing the signs of a group turns a solution into another.
    sign_changes: Vec<Vec<String>>,
    /// Pairs of unknowns: exchanging them, all or some together, turns a solution into another.
    exchanged: Vec<Vec<String>>,
    /// Whether all unknowns 0 is a solution that no factor excludes.
    origin: bool,
    /// Groups of unknowns that are 0 together at some solution.
    zero_sets: Vec<Vec<String>>,
    /// Whether solutions share values of every unknown.
    shares_values: bool,
    presolve: Vec<PresolvedForm>,
    scene: Option<SceneReport>,
    seconds: f64,
}

/// What the scene says, and whether it is right.
#[derive(Serialize)]
struct SceneReport {
    /// Number of scenes that were tried.
    tried: usize,
    /// Those that could be drawn.
    drawn: usize,
    /// What it says beside the data: `nothing`, `solution` or `results`.
    states: &'static str,
    /// Those whose solution solves the equations; `None` if it states no solution.
    solved: Option<usize>,
}

/// Number and seed of the scenes that are tried.
const SCENES: usize = 200;
const SEED_OF_SCENES: u64 = 1;

/// What one way to presolve leaves.
#[derive(Serialize)]
struct PresolvedForm {
    kind: String,
    eliminated: Vec<String>,
    kept: Vec<String>,
    degrees: Vec<i32>,
    /// The monomials for which equations are solved at run time, each with the number of terms of
    /// its equation then.
    solved_for: Vec<(String, usize)>,
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
        least_columns: count.least_columns(&problem),
        sign_changes: names(&problem, &Symmetry::of_problem(&problem).generators()),
        exchanged: names(&problem, &exchanged(&problem).into_iter().map(Vec::from).collect::<Vec<_>>()),
        origin: problem.has_origin(),
        zero_sets: names(&problem, &count.zero_sets),
        shares_values: count.shares_values,
        presolve: forms(&problem),
        scene: problem.scene.as_ref().map(|scene| SceneReport::of(&problem, scene)),
        seconds: start.elapsed().as_secs_f64(),
    }))
}

impl SceneReport {
    fn of(problem: &Problem, scene: &Scene) -> Self {
        let SceneCheck { drawn, solved } = SceneCheck::of(problem, scene, SCENES, SEED_OF_SCENES);
        let states = match (scene.states_solution(), scene.has_truth()) {
            (true, _) => "solution",
            (_, true) => "results",
            _ => "nothing",
        };
        Self { tried: SCENES, drawn, states, solved }
    }
}

impl fmt::Display for SceneReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { tried, drawn, states, solved } = self;
        match (drawn < tried, states, solved) {
            (true, ..) => {
                write!(f, "only {drawn} of {tried} could be drawn: inequalities fail, or a value does not exist")
            }
            (_, _, Some(solved)) if solved == drawn => {
                write!(f, "the solution of {drawn} drawn ones solves the equations")
            }
            (_, _, Some(solved)) => write!(f, "wrong: the solution of only {solved} of {drawn} solves the equations"),
            (_, &"results", _) => write!(f, "states results, which a search compares with those of solutions"),
            _ => write!(f, "states data alone, and nothing of what solves them"),
        }
    }
}

fn degrees(problem: &Problem) -> Vec<i32> {
    problem.polynomials().map(|p| p.monomials().map(|m| m.degree()).max().unwrap_or(0)).collect()
}

/// The names of the unknowns of each group.
fn names(problem: &Problem, groups: &[Vec<usize>]) -> Vec<Vec<String>> {
    let names = |group: &Vec<usize>| group.iter().map(|&unknown| problem.unknowns[unknown].clone()).collect();
    groups.iter().map(names).collect()
}

/// The ways to presolve that eliminate an unknown or lower a degree.
fn forms(problem: &Problem) -> Vec<PresolvedForm> {
    let mut forms: Vec<PresolvedForm> = Vec::new();
    let symbolic = [Presolve::Constant, Presolve::Linear, Presolve::Combined, Presolve::CombinedLinear];
    let each = || 0..problem.unknowns.len().min(MAX_UNKNOWNS) as u8;
    let at_run_time = [Presolve::Eliminated, Presolve::Solved].into_iter().chain(each().map(Presolve::Hiding));
    for how in symbolic.into_iter().chain(at_run_time).chain(each().map(Presolve::Determinants)) {
        let reduced = presolve(problem, how);
        let names = |indices: &[usize]| indices.iter().map(|&at| problem.unknowns[at].clone()).collect::<Vec<_>>();
        let form = PresolvedForm {
            kind: how.name(),
            eliminated: names(&reduced.eliminated().collect::<Vec<_>>()),
            kept: names(&reduced.kept),
            degrees: degrees(&reduced.problem),
            solved_for: solved_for(problem, &reduced.problem),
        };
        let is_known = |known: &PresolvedForm| {
            (&known.kept, &known.degrees, &known.solved_for) == (&form.kept, &form.degrees, &form.solved_for)
        };
        let changes = !form.eliminated.is_empty() || form.degrees != degrees(problem) || !form.solved_for.is_empty();
        if changes && !forms.iter().any(is_known) {
            forms.push(form);
        }
    }
    forms
}

/// The monomials for which equations are solved: those with the coefficient 1 beside others that
/// presolve derives.
fn solved_for(problem: &Problem, reduced: &Problem) -> Vec<(String, usize)> {
    let first = reduced.graph.derivations().iter().find(|d| d.first_input >= problem.graph.input_count());
    let Some(first) = first.map(|derivation| derivation.first_input) else { return Vec::new() };
    let is_derived = |node: Expression| matches!(node, Expression::Input(input) if input as usize >= first);
    let solved = reduced.polynomials().filter_map(|p| {
        let (ones, others): (Vec<_>, Vec<_>) =
            p.terms().iter().partition(|(_, c)| reduced.graph.as_constant(*c) == Some(Rational::ONE));
        let is_solved = others.iter().any(|&&(_, c)| is_derived(reduced.graph.node(c)));
        let lead = ones.iter().max_by_key(|(m, _)| (m.degree(), *m)).filter(|_| is_solved)?;
        Some((lead.0.display(&reduced.unknowns).to_string(), p.terms().len()))
    });
    solved.collect()
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
        for PresolvedForm { kind, eliminated, kept, degrees, solved_for } in &self.presolve {
            write!(f, "presolve   {kind}: ")?;
            if !eliminated.is_empty() {
                write!(f, "eliminates {}; ", eliminated.join(", "))?;
            }
            if !solved_for.is_empty() {
                let leads: Vec<String> =
                    solved_for.iter().map(|(lead, terms)| format!("{lead} ({})", counted(terms - 1, "term"))).collect();
                write!(f, "solves at run time for {}; ", leads.join(", "))?;
            }
            writeln!(f, "leaves {} in equations of degree {}", kept.join(", "), list(degrees))?;
        }
        match self.different {
            different if different == self.solutions => writeln!(f, "solutions  {different}")?,
            different => writeln!(f, "solutions  {different} different ones, {} with multiplicity", self.solutions)?,
        }
        writeln!(f, "columns    at least {} in every elimination template", self.least_columns)?;
        if self.origin {
            let name = self.unknown_names.first().map_or("x", String::as_str);
            writeln!(f, "origin     all unknowns 0 is a solution, and is counted. Exclude it with `{name} != 0;`")?;
        }
        // The origin is told of above.
        let zeros = self.zero_sets.iter().filter(|set| !self.origin || set.len() < self.unknowns);
        let zeros: Vec<String> = zeros.map(|set| set.join(", ")).collect();
        if !zeros.is_empty() {
            writeln!(f, "zeros      unknowns that are 0 together at a solution: {}", zeros.join("; "))?;
        }
        if self.shares_values {
            writeln!(f, "values     solutions share those of every unknown: a linear form can tell them apart")?;
        }
        for unknowns in &self.sign_changes {
            writeln!(f, "symmetry   changing the sign of {} gives another solution", unknowns.join(", "))?;
        }
        if !self.exchanged.is_empty() {
            let pairs: Vec<String> = self.exchanged.iter().map(|pair| pair.join(" and ")).collect();
            writeln!(f, "symmetry   exchanging {} gives another solution", pairs.join(", "))?;
        }
        if let Some(scene) = &self.scene {
            writeln!(f, "scene      {scene}")?;
        }
        writeln!(f, "time       {}", seconds(self.seconds))
    }
}
