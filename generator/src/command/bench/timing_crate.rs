//! A workspace in a temporary folder that times solvers.
//!
//! ```text
//! timing       the loop over rounds, and `base`, a program with nothing to solve
//! solver_0     a solver: a library, and a program of its own, whose size is compared with `base`
//! solver_1     ..
//! all          the program in which all solvers take turns
//! ```

use std::path::Path;
use std::time::Instant;

use serde::Serialize;

use super::subject::Subject;
use crate::command::compiled::workspace::{Workspace, manifest, unexpected};
use crate::command::error::CommandError;

/// The library `timing`.
const TIMING: &str = include_str!("timing.rs.txt");

/// The program `base`.
const BASE: &str = "use timing::{Timed, read_all, run};

const POSITIVE: fn(&f64) -> bool = |x| *x > 0.0;

fn main() {
    run(vec![Box::new(Timed {
        instances: read_all(\"instances_0\", 1, |next| next()),
        residual: POSITIVE,
        matrix: POSITIVE,
        eigenvalues: POSITIVE,
        attempt: POSITIVE,
        solve: |x| *x as usize,
    })]);
}
";

/// Nanoseconds of one solve, and what was found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub(super) struct Times {
    /// Coefficients from the data, and one residual.
    pub(super) coefficients: f64,
    /// Fill and elimination of the template.
    pub(super) elimination: f64,
    /// All eigenvalues of the action matrix; 0 where roots are those of a determinant.
    pub(super) eigenvalues: f64,
    /// Roots of a determinant, vectors, polish.
    pub(super) solutions: f64,
    /// Second attempts.
    pub(super) second_attempts: f64,
    /// The whole of `solve`.
    pub(super) total: f64,
    /// The 99th percentile of single solves.
    pub(super) p99: f64,
    /// Real solutions per instance.
    pub(super) found: f64,
}

impl Times {
    /// From the measured times: the residual of a point, which begins with the coefficients; the
    /// action matrix, which begins with them, too; the same with its eigenvalues, or nothing;
    /// `solve` without second attempts; all of it; its percentile; the solutions.
    fn of([residual, matrix, spectrum, attempt, total, p99, found]: [f64; 7]) -> Self {
        let after = |end: f64, start: f64| (end - start).max(0.0);
        Self {
            coefficients: residual,
            elimination: after(matrix, residual),
            eigenvalues: after(spectrum, matrix),
            solutions: after(attempt, spectrum.max(matrix)),
            second_attempts: after(total, attempt),
            total,
            p99,
            found,
        }
    }

    /// What follows the elimination.
    pub(super) fn after_elimination(&self) -> f64 {
        self.eigenvalues + self.solutions + self.second_attempts
    }
}

/// What a solver costs those who compile it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub(super) struct BuildCost {
    /// Bytes that the solver adds to a program: machine code and tables, without symbols.
    pub(super) program_bytes: u64,
    /// Seconds to compile and link it alone, with all its dependencies there.
    pub(super) compile_seconds: f64,
}

/// The workspace.
pub(super) struct TimingCrate {
    workspace: Workspace,
    solvers: usize,
}

impl TimingCrate {
    /// Writes the crates, see [`Workspace::new`].
    pub(super) fn new(subjects: &[Subject], runtime: Option<&Path>, problem: &Path) -> Result<Self, CommandError> {
        let workspace = Workspace::new(&["timing", "solver_*", "all"], runtime, problem)?;
        workspace.write("timing/Cargo.toml", &manifest("timing", ""))?;
        workspace.write("timing/src/lib.rs", TIMING)?;
        workspace.write("timing/src/bin/base.rs", BASE)?;
        let timing = "timing = { path = \"../timing\" }\n";
        let dependencies = timing.to_owned() + &workspace.runtime();
        for (number, subject) in subjects.iter().enumerate() {
            let name = format!("solver_{number}");
            workspace.write(&format!("{name}/Cargo.toml"), &manifest(&name, &dependencies))?;
            workspace.write(&format!("{name}/src/lib.rs"), &subject.library(&format!("instances_{number}")))?;
            let main = format!("fn main() {{\n    timing::run(vec![{name}::subject()]);\n}}\n");
            workspace.write(&format!("{name}/src/main.rs"), &main)?;
            workspace.write_numbers(&format!("instances_{number}"), &subject.instances)?;
        }
        let all = 0..subjects.len();
        let solvers: String = all.clone().map(|k| format!("solver_{k} = {{ path = \"../solver_{k}\" }}\n")).collect();
        workspace.write("all/Cargo.toml", &manifest("all", &(timing.to_owned() + &solvers)))?;
        let calls: String = all.map(|k| format!("solver_{k}::subject(), ")).collect();
        workspace.write("all/src/main.rs", &format!("fn main() {{\n    timing::run(vec![{calls}]);\n}}\n"))?;
        Ok(Self { workspace, solvers: subjects.len() })
    }

    /// Compiles the crates. Returns what each solver costs; `each` is called after each.
    pub(super) fn compile(&self, each: &dyn Fn()) -> Result<Vec<BuildCost>, CommandError> {
        self.workspace.build_runtime()?;
        self.workspace.build("timing")?;
        let base = self.workspace.program_bytes("base")?;
        let mut costs = Vec::new();
        for number in 0..self.solvers {
            let (start, name) = (Instant::now(), format!("solver_{number}"));
            self.workspace.build(&name)?;
            let compile_seconds = start.elapsed().as_secs_f64();
            let program_bytes = self.workspace.program_bytes(&name)?.saturating_sub(base);
            costs.push(BuildCost { program_bytes, compile_seconds });
            each();
        }
        self.workspace.build("all")?;
        Ok(costs)
    }

    /// Runs the program: the times of each solver.
    pub(super) fn run(&self, rounds: u64) -> Result<Vec<Times>, CommandError> {
        let text = self.workspace.run("all", &rounds.to_string())?;
        let times: Vec<Times> = text.lines().filter_map(times).collect();
        if times.len() == self.solvers { Ok(times) } else { Err(unexpected(&text)) }
    }
}

/// Seven numbers of a line.
fn times(line: &str) -> Option<Times> {
    let numbers: Vec<f64> = line.split_whitespace().map(str::parse).collect::<Result<_, _>>().ok()?;
    Some(Times::of(numbers.try_into().ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stages_are_differences_and_never_negative() {
        let times = Times::of([100.0, 250.0, 550.0, 900.0, 1000.0, 1500.0, 4.2]);
        assert_eq!((times.coefficients, times.elimination, times.eigenvalues), (100.0, 150.0, 300.0));
        assert_eq!((times.solutions, times.second_attempts, times.after_elimination()), (350.0, 100.0, 750.0));
        assert_eq!((times.total, times.p99, times.found), (1000.0, 1500.0, 4.2));
        let times = Times::of([100.0, 90.0, 80.0, 85.0, 80.0, 80.0, 0.0]);
        assert_eq!((times.elimination, times.after_elimination()), (0.0, 0.0));
    }

    #[test]
    fn lines_of_seven_numbers_are_times() {
        assert_eq!(times("1 2.5 3 4 5 6 0"), Some(Times::of([1.0, 2.5, 3.0, 4.0, 5.0, 6.0, 0.0])));
        assert_eq!((times("1 2 3 4 5 6"), times("1 2 3 4 5 6 x")), (None, None));
    }
}
