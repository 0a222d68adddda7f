//! A crate in a temporary folder that times solvers.

use std::env::consts::EXE_SUFFIX;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::Instant;

use serde::Serialize;

use crate::command::error::CommandError;

/// The program: a function for each solver that reads its instances, and the loop over rounds.
const MAIN: &str = include_str!("timing_main.rs.txt");

/// A solver with its instances.
pub(super) struct Subject {
    /// The module of the solver.
    pub(super) name: String,
    /// Its source.
    pub(super) source: String,
    /// The shapes of the parameters.
    pub(super) parameters: Vec<Vec<usize>>,
    pub(super) unknowns: usize,
    /// The data of all instances, one after another.
    pub(super) instances: Vec<f64>,
}

/// Nanoseconds of one solve, and what was found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub(super) struct Times {
    /// Coefficients from the data, and one residual.
    pub(super) coefficients: f64,
    /// Fill and elimination of the template.
    pub(super) elimination: f64,
    /// Roots, vectors, polish, and second attempts.
    pub(super) solutions: f64,
    /// The whole of `solve`.
    pub(super) total: f64,
    /// The 99th percentile of single solves.
    pub(super) p99: f64,
    /// Real solutions per instance.
    pub(super) found: f64,
}

impl Times {
    /// From the measured times: the residual of a point, which begins with the coefficients; the
    /// action matrix, which begins with them, too; all of `solve`; its percentile; the solutions.
    fn of([residual, matrix, total, p99, found]: [f64; 5]) -> Self {
        let elimination = (matrix - residual).max(0.0);
        Self { coefficients: residual, elimination, solutions: (total - matrix).max(0.0), total, p99, found }
    }
}

/// The crate. Its folder is removed when this is dropped.
pub(super) struct TimingCrate {
    folder: PathBuf,
}

impl Drop for TimingCrate {
    fn drop(&mut self) {
        // What cannot be removed is left to the system, which empties its temporary folder.
        let _ = fs::remove_dir_all(&self.folder);
    }
}

impl TimingCrate {
    /// Writes the crate. Without a `runtime` folder, that of the checkout around `problem` is used,
    /// or else the published crate.
    pub(super) fn new(subjects: &[Subject], runtime: Option<&Path>, problem: &Path) -> Result<Self, CommandError> {
        let folder = std::env::temp_dir().join(format!("eliminant-bench-{}", std::process::id()));
        let this = Self { folder };
        let source = this.folder.join("src");
        fs::create_dir_all(&source).map_err(|source| CommandError::Write { path: this.folder.clone(), source })?;
        let runtime = runtime.map(Path::to_owned).or_else(|| runtime_around(problem));
        this.write("Cargo.toml", &manifest(runtime.as_deref())?)?;
        // The versions of the checkout, whose crates are on this machine already.
        if let Some(lock) = runtime.as_deref().and_then(Path::parent).map(|root| root.join("Cargo.lock"))
            && let Ok(text) = fs::read_to_string(lock)
        {
            this.write("Cargo.lock", &text)?;
        }
        let mut main = MAIN.to_owned();
        let mut calls = String::new();
        for (number, subject) in subjects.iter().enumerate() {
            this.write(&format!("src/solver_{number}.rs"), &subject.source)?;
            let bytes: Vec<u8> = subject.instances.iter().flat_map(|value| value.to_le_bytes()).collect();
            let path = this.folder.join(format!("instances_{number}"));
            fs::write(&path, bytes).map_err(|source| CommandError::Write { path, source })?;
            main += &loader(number, subject);
            let _ = write!(calls, "Box::new(subject_{number}()), ");
        }
        let _ = write!(main, "\nfn main() {{\n    run(vec![{calls}]);\n}}\n");
        this.write("src/main.rs", &main)?;
        Ok(this)
    }

    fn write(&self, name: &str, text: &str) -> Result<(), CommandError> {
        let path = self.folder.join(name);
        fs::write(&path, text).map_err(|source| CommandError::Write { path, source })
    }

    /// Compiles the crate. Returns the seconds that it took, without its dependencies.
    pub(super) fn compile(&self) -> Result<f64, CommandError> {
        // What is on this machine suffices as a rule; otherwise crates are fetched.
        if self.build(&["--offline", "--package", "eliminant"]).is_err() {
            self.build(&["--package", "eliminant"])?;
        }
        let start = Instant::now();
        self.build(&["--offline"])?;
        Ok(start.elapsed().as_secs_f64())
    }

    fn build(&self, arguments: &[&str]) -> Result<(), CommandError> {
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let mut command = Command::new(cargo);
        command.args(["build", "--release", "--quiet"]).args(arguments).current_dir(&self.folder);
        // Settings of the folder that the user is in are not settings of this crate.
        command.env("CARGO_TARGET_DIR", self.folder.join("target"));
        run(command, "compile the solvers").map(|_| ())
    }

    /// Runs the program: the times of each solver.
    pub(super) fn run(&self, count: usize, rounds: u64) -> Result<Vec<Times>, CommandError> {
        let mut command = Command::new(self.folder.join(format!("target/release/eliminant-bench{EXE_SUFFIX}")));
        command.arg(rounds.to_string()).current_dir(&self.folder);
        let output = run(command, "run the solvers")?;
        let text = String::from_utf8_lossy(&output.stdout);
        let times: Vec<Times> = text.lines().filter_map(times).collect();
        match times.len() == count {
            true => Ok(times),
            false => {
                Err(CommandError::Bench { action: "run the solvers", reason: format!("unexpected output:\n{text}") })
            }
        }
    }
}

/// Five numbers of a line.
fn times(line: &str) -> Option<Times> {
    let numbers: Vec<f64> = line.split_whitespace().map(str::parse).collect::<Result<_, _>>().ok()?;
    Some(Times::of(numbers.try_into().ok()?))
}

fn run(mut command: Command, action: &'static str) -> Result<Output, CommandError> {
    let fail = |reason: String| CommandError::Bench { action, reason };
    let output = command.output().map_err(|error| fail(error.to_string()))?;
    match output.status.success() {
        true => Ok(output),
        false => Err(fail(format!("{}\n{}", output.status, String::from_utf8_lossy(&output.stderr)))),
    }
}

/// The folder `runtime` beside which the problem stands, or above, if it holds the runtime crate.
fn runtime_around(problem: &Path) -> Option<PathBuf> {
    let problem = fs::canonicalize(problem).ok()?;
    let is_runtime = |folder: &PathBuf| {
        let manifest = fs::read_to_string(folder.join("Cargo.toml"));
        manifest.is_ok_and(|text| text.lines().any(|line| line == "name = \"eliminant\""))
    };
    problem.ancestors().map(|folder| folder.join("runtime")).find(is_runtime)
}

fn manifest(runtime: Option<&Path>) -> Result<String, CommandError> {
    let dependency = match runtime {
        Some(folder) => {
            let folder = fs::canonicalize(folder)
                .map_err(|error| CommandError::Read { path: folder.to_owned(), reason: error.to_string() })?;
            format!("{{ path = {:?} }}", folder.display().to_string())
        }
        None => format!("\"={}\"", env!("CARGO_PKG_VERSION")),
    };
    Ok(format!(
        "[package]\nname = \"eliminant-bench\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[workspace]\n\n\
         [dependencies]\neliminant = {dependency}\n"
    ))
}

/// The module of a solver, and a function that reads its instances.
fn loader(number: usize, subject: &Subject) -> String {
    let Subject { name, parameters, unknowns, .. } = subject;
    let types: Vec<String> = parameters.iter().map(|shape| array_type(shape)).collect();
    let values: Vec<String> = parameters.iter().map(|shape| array_value(shape)).collect();
    let arguments: Vec<String> = (0..parameters.len())
        .map(|at| if parameters[at].is_empty() { format!("data.{at}") } else { format!("&data.{at}") })
        .collect();
    let (types, values, arguments) = (types.join(", "), values.join(", "), arguments.join(", "));
    format!(
        "
mod solver_{number};

fn subject_{number}() -> impl Subject {{
    use solver_{number}::{name} as solver;
    type Data = ({types},);
    fn read(next: &mut dyn FnMut() -> f64) -> Data {{
        ({values},)
    }}
    Timed {{
        instances: read_all(\"instances_{number}\", read),
        residual: |data: &Data| {{
            let point = solver::Solution::from([0.5; {unknowns}]);
            solver::relative_residual({arguments}, &point).is_ok()
        }},
        matrix: |data: &Data| solver::action_matrix({arguments}).is_ok(),
        solve: |data: &Data| solver::solve({arguments}).map_or(0, |found| found.len()),
    }}
}}
"
    )
}

fn array_type(shape: &[usize]) -> String {
    shape.iter().rev().fold("f64".to_owned(), |inner, length| format!("[{inner}; {length}]"))
}

fn array_value(shape: &[usize]) -> String {
    shape.iter().fold("next()".to_owned(), |inner, _| format!("std::array::from_fn(|_| {inner})"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stages_are_differences_and_never_negative() {
        let times = Times::of([100.0, 250.0, 900.0, 1500.0, 4.2]);
        assert_eq!((times.coefficients, times.elimination, times.solutions), (100.0, 150.0, 650.0));
        assert_eq!((times.total, times.p99, times.found), (900.0, 1500.0, 4.2));
        assert_eq!(Times::of([100.0, 90.0, 80.0, 80.0, 0.0]).elimination, 0.0);
    }

    #[test]
    fn parameters_are_read_by_their_shapes() {
        assert_eq!((array_type(&[]), array_value(&[])), ("f64".into(), "next()".into()));
        assert_eq!(array_type(&[4, 3]), "[[f64; 3]; 4]");
        assert_eq!(array_value(&[4, 3]), "std::array::from_fn(|_| std::array::from_fn(|_| next()))");
    }

    #[test]
    fn lines_of_five_numbers_are_times() {
        assert_eq!(times("1 2.5 4 5 0"), Some(Times::of([1.0, 2.5, 4.0, 5.0, 0.0])));
        assert_eq!((times("1 2 3 4"), times("1 2 3 4 x")), (None, None));
    }
}
