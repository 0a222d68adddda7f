//! What a solver returns on instances: emitted code, compiled and run, or the interpreted plan.

use std::path::Path;

use eliminant::{Complex, SolveError};

use crate::command::compiled::parameters::ParameterText;
use crate::command::compiled::workspace::{Workspace, manifest, unexpected};
use crate::command::error::CommandError;
use crate::plan::Plan;
use crate::search::measuring::interpreted::InterpretedSolver;

/// The library that emitted solvers are run by.
const SOLVING: &str = include_str!("solving.rs.txt");

/// Points, or the message of an error.
pub(super) type Found = Result<Vec<Vec<Complex<f64>>>, String>;

/// What a solver returned on one instance.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Returned {
    /// The time of `solve`, the fastest of three; only of emitted code.
    pub(super) nanoseconds: Option<f64>,
    /// The solutions of `solve`.
    pub(super) real: Found,
    /// The solutions of `solve_complex`.
    pub(super) complex: Found,
}

/// A solver, and the data of all of its instances.
pub(super) struct Subject<'a> {
    /// The plan of the solver.
    pub(super) plan: &'a Plan,
    /// Its source.
    pub(super) source: &'a str,
    /// The data of each instance.
    pub(super) data: Vec<&'a [f64]>,
}

/// What the interpreted plan returns: the bits of the emitted solver.
pub(super) fn interpreted(solver: &InterpretedSolver, data: &[f64]) -> Returned {
    let message = |error: SolveError| error.to_string();
    let complex = |points: Vec<Vec<f64>>| {
        points.into_iter().map(|point| point.into_iter().map(Complex::from).collect()).collect()
    };
    Returned {
        nanoseconds: None,
        real: solver.solve(data).map(complex).map_err(message),
        complex: solver.solve_complex(data).map_err(message),
    }
}

/// The workspace in which emitted solvers are compiled and run.
pub(super) struct SolvingCrate(Workspace);

impl SolvingCrate {
    /// Writes a program for each solver, see [`Workspace::new`], and compiles what they share.
    pub(super) fn new(subjects: &[Subject<'_>], runtime: Option<&Path>, problem: &Path) -> Result<Self, CommandError> {
        let workspace = Workspace::new(&["solving", "solver_*"], runtime, problem)?;
        workspace.write("solving/Cargo.toml", &manifest("solving", ""))?;
        workspace.write("solving/src/lib.rs", SOLVING)?;
        let dependencies = "solving = { path = \"../solving\" }\n".to_owned() + &workspace.runtime();
        for (number, subject) in subjects.iter().enumerate() {
            let (name, instances) = (format!("solver_{number}"), format!("instances_{number}"));
            workspace.write(&format!("{name}/Cargo.toml"), &manifest(&name, &dependencies))?;
            workspace.write(&format!("{name}/src/main.rs"), &subject.program(&instances))?;
            workspace.write_numbers(&instances, &subject.data.concat())?;
        }
        workspace.build_runtime()?;
        Ok(Self(workspace))
    }

    /// Compiles a solver and runs it.
    pub(super) fn run(&self, number: usize, subject: &Subject<'_>) -> Result<Vec<Returned>, CommandError> {
        let name = format!("solver_{number}");
        self.0.build(&name)?;
        let text = self.0.run(&name, "")?;
        let lines: Vec<&str> = text.lines().collect();
        let unknowns = subject.plan.unknowns.len();
        let returned: Option<Vec<Returned>> = lines.chunks(3).map(|lines| parse(lines, unknowns)).collect();
        returned.filter(|returned| returned.len() == subject.data.len()).ok_or_else(|| unexpected(&text))
    }
}

impl Subject<'_> {
    fn program(&self, instances: &str) -> String {
        let Self { plan, source, data } = self;
        let ParameterText { types, values, arguments } = ParameterText::of(&plan.data);
        let (name, count) = (&plan.name, data.len());
        format!(
            "#![allow(unused)]
{source}

use {name} as solver;

type Data = {types};

fn read(next: &mut dyn FnMut() -> f64) -> Data {{
    {values}
}}

fn main() {{
    let real = |data: &Data| match solver::solve({arguments}) {{
        Ok(found) => Ok(found.iter().flat_map(|s| s.to_unknowns()).collect()),
        Err(error) => Err(error.to_string()),
    }};
    let complex = |data: &Data| match solver::solve_complex({arguments}) {{
        Ok(found) => Ok(found.iter().flat_map(|s| s.to_unknowns()).flat_map(|x| [x.re, x.im]).collect()),
        Err(error) => Err(error.to_string()),
    }};
    let time = |data: &Data| solver::solve({arguments}).map_or(0, |found| found.len());
    ::solving::run({instances:?}, {count}, read, ::solving::Solver {{ time, real, complex }});
}}
"
        )
    }
}

/// Three lines of an instance.
fn parse(lines: &[&str], unknowns: usize) -> Option<Returned> {
    let [time, real, complex] = lines else { return None };
    let pairs = |pair: &[f64]| Complex::new(pair[0], pair.get(1).copied().unwrap_or(0.0));
    Some(Returned {
        nanoseconds: Some(time.parse().ok()?),
        real: points(real, unknowns, |numbers| numbers.chunks(1).map(pairs).collect())?,
        complex: points(complex, unknowns, |numbers| numbers.chunks(2).map(pairs).collect())?,
    })
}

fn points(line: &str, unknowns: usize, complex: impl Fn(&[f64]) -> Vec<Complex<f64>>) -> Option<Found> {
    if let Some(message) = line.strip_prefix("- ") {
        return Some(Err(message.to_owned()));
    }
    let words = line.strip_prefix('+')?.split_whitespace();
    let numbers: Vec<f64> =
        words.map(|bits| u64::from_str_radix(bits, 16).map(f64::from_bits)).collect::<Result<_, _>>().ok()?;
    Some(Ok(complex(&numbers).chunks(unknowns.max(1)).map(<[_]>::to_vec).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_give_the_bits_back() {
        let bits = |x: f64| format!("{:x}", x.to_bits());
        let real = format!("+ {} {}", bits(0.1), bits(-2.5));
        let complex = format!("+ {} {} {} {}", bits(0.1), bits(0.0), bits(-2.5), bits(1e-300));
        let returned = parse(&["12.5", &real, &complex], 2).unwrap();
        assert_eq!((returned.nanoseconds, returned.real), (Some(12.5), Ok(vec![vec![0.1.into(), (-2.5).into()]])));
        assert_eq!(returned.complex, Ok(vec![vec![Complex::new(0.1, 0.0), Complex::new(-2.5, 1e-300)]]));
        let failed = parse(&["1", "- degenerate data", "+"], 2).unwrap();
        assert_eq!((failed.real, failed.complex), (Err("degenerate data".to_owned()), Ok(Vec::new())));
        assert_eq!(parse(&["1", "+ x", "+"], 2), None);
        assert_eq!(parse(&["1", "+"], 2), None);
    }
}
