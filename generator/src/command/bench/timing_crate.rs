//! A workspace in a temporary folder that times solvers.
//!
//! ```text
//! timing       the loop over rounds, and `base`, a program with nothing to solve
//! solver_0     a solver: a library, and a program of its own, whose size is compared with `base`
//! solver_1     ..
//! all          the program in which all solvers take turns
//! ```

use std::env::consts::EXE_SUFFIX;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use serde::Serialize;

use super::subject::Subject;
use crate::command::error::CommandError;

/// The library `timing`.
const TIMING: &str = include_str!("timing.rs.txt");

/// The program `base`.
const BASE: &str = "use timing::{Timed, read_all, run};

const POSITIVE: fn(&f64) -> bool = |x| *x > 0.0;
const WHOLE: fn(&f64) -> usize = |x| *x as usize;

fn main() {
    let instances = read_all(\"instances_0\", 1, |next| next());
    run(vec![Box::new(Timed { instances, residual: POSITIVE, matrix: POSITIVE, solve: WHOLE })]);
}
";

/// Whether Ctrl-C was pressed.
static IS_INTERRUPTED: AtomicBool = AtomicBool::new(false);

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

/// What a solver costs those who compile it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub(super) struct BuildCost {
    /// Bytes that the solver adds to a program: machine code and tables, without symbols.
    pub(super) program_bytes: u64,
    /// Seconds to compile and link it alone, with all its dependencies there.
    pub(super) compile_seconds: f64,
}

/// The workspace. Its folder is removed when this is dropped.
pub(super) struct TimingCrate {
    folder: PathBuf,
    solvers: usize,
}

impl Drop for TimingCrate {
    fn drop(&mut self) {
        // What cannot be removed is left to the system, which empties its temporary folder.
        let _ = fs::remove_dir_all(&self.folder);
    }
}

impl TimingCrate {
    /// Writes the crates. Without a `runtime` folder, that of the checkout around `problem` is
    /// used, or else the published crate. From now on Ctrl-C ends the steps below with an error,
    /// and the folder is removed.
    pub(super) fn new(subjects: &[Subject], runtime: Option<&Path>, problem: &Path) -> Result<Self, CommandError> {
        listen();
        let this = Self { folder: new_folder()?, solvers: subjects.len() };
        let runtime = runtime.map(Path::to_owned).or_else(|| runtime_around(problem));
        this.write(
            "Cargo.toml",
            "[workspace]\nmembers = [\"timing\", \"solver_*\", \"all\"]\nresolver = \"3\"\n\n\
             [profile.release]\nstrip = true\n",
        )?;
        // The versions of the checkout, whose crates are on this machine already.
        if let Some(lock) = runtime.as_deref().and_then(Path::parent).map(|root| root.join("Cargo.lock"))
            && let Ok(text) = fs::read_to_string(lock)
        {
            this.write("Cargo.lock", &text)?;
        }
        this.write("timing/Cargo.toml", &manifest("timing", ""))?;
        this.write("timing/src/lib.rs", TIMING)?;
        this.write("timing/src/bin/base.rs", BASE)?;
        let timing = "timing = { path = \"../timing\" }\n";
        let dependencies = format!("{timing}eliminant = {}\n", runtime_dependency(runtime.as_deref())?);
        for (number, subject) in subjects.iter().enumerate() {
            let name = format!("solver_{number}");
            this.write(&format!("{name}/Cargo.toml"), &manifest(&name, &dependencies))?;
            this.write(&format!("{name}/src/lib.rs"), &subject.library(&format!("instances_{number}")))?;
            let main = format!("fn main() {{\n    timing::run(vec![{name}::subject()]);\n}}\n");
            this.write(&format!("{name}/src/main.rs"), &main)?;
            let bytes: Vec<u8> = subject.instances.iter().flat_map(|value| value.to_le_bytes()).collect();
            this.write(&format!("instances_{number}"), &bytes)?;
        }
        let all = 0..subjects.len();
        let solvers: String = all.clone().map(|k| format!("solver_{k} = {{ path = \"../solver_{k}\" }}\n")).collect();
        this.write("all/Cargo.toml", &manifest("all", &(timing.to_owned() + &solvers)))?;
        let calls: String = all.map(|k| format!("solver_{k}::subject(), ")).collect();
        this.write("all/src/main.rs", &format!("fn main() {{\n    timing::run(vec![{calls}]);\n}}\n"))?;
        Ok(this)
    }

    fn write(&self, name: &str, content: &(impl AsRef<[u8]> + ?Sized)) -> Result<(), CommandError> {
        let path = self.folder.join(name);
        let folder = path.parent().unwrap_or(&self.folder);
        let written = fs::create_dir_all(folder).and_then(|()| fs::write(&path, content));
        written.map_err(|source| CommandError::Write { path, source })
    }

    /// Compiles the crates. Returns what each solver costs; `each` is called after each.
    pub(super) fn compile(&self, each: &dyn Fn()) -> Result<Vec<BuildCost>, CommandError> {
        // What is on this machine suffices as a rule; otherwise crates are fetched.
        if self.build(&["--offline", "--package", "eliminant"]).is_err() {
            self.build(&["--package", "eliminant"])?;
        }
        self.build(&["--offline", "--package", "timing"])?;
        let base = self.program_bytes("base")?;
        let mut costs = Vec::new();
        for number in 0..self.solvers {
            let (start, name) = (Instant::now(), format!("solver_{number}"));
            self.build(&["--offline", "--package", &name])?;
            let compile_seconds = start.elapsed().as_secs_f64();
            costs.push(BuildCost { program_bytes: self.program_bytes(&name)?.saturating_sub(base), compile_seconds });
            each();
        }
        self.build(&["--offline", "--package", "all"])?;
        Ok(costs)
    }

    fn build(&self, arguments: &[&str]) -> Result<(), CommandError> {
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let mut command = Command::new(cargo);
        command.args(["build", "--release", "--quiet"]).args(arguments).current_dir(&self.folder);
        // Settings of the folder that the user is in are not settings of these crates.
        command.env("CARGO_TARGET_DIR", self.folder.join("target"));
        run(command, "compile the solvers").map(|_| ())
    }

    fn program(&self, name: &str) -> PathBuf {
        self.folder.join(format!("target/release/{name}{EXE_SUFFIX}"))
    }

    fn program_bytes(&self, name: &str) -> Result<u64, CommandError> {
        let path = self.program(name);
        let length = fs::metadata(&path).map(|metadata| metadata.len());
        length.map_err(|error| CommandError::Read { path, reason: error.to_string() })
    }

    /// Runs the program: the times of each solver.
    pub(super) fn run(&self, rounds: u64) -> Result<Vec<Times>, CommandError> {
        let mut command = Command::new(self.program("all"));
        command.arg(rounds.to_string()).current_dir(&self.folder);
        let output = run(command, "run the solvers")?;
        let text = String::from_utf8_lossy(&output.stdout);
        let times: Vec<Times> = text.lines().filter_map(times).collect();
        match times.len() == self.solvers {
            true => Ok(times),
            false => {
                Err(CommandError::Bench { action: "run the solvers", reason: format!("unexpected output:\n{text}") })
            }
        }
    }
}

/// Begins to listen to Ctrl-C. The programs that run get it, too, and end.
fn listen() {
    static LISTENS: OnceLock<bool> = OnceLock::new();
    // If no handler can be set, Ctrl-C ends the process as usual, and leaves the folder.
    LISTENS.get_or_init(|| ctrlc::set_handler(|| IS_INTERRUPTED.store(true, Ordering::Relaxed)).is_ok());
}

/// A folder that was not there before: its name can be guessed, and what others put there must not
/// be compiled.
fn new_folder() -> Result<PathBuf, CommandError> {
    let mut number = 0;
    loop {
        let path = std::env::temp_dir().join(format!("eliminant-bench-{}-{number}", std::process::id()));
        match fs::create_dir(&path) {
            Ok(()) => return Ok(path),
            Err(error) if error.kind() == std::io::ErrorKind::AlreadyExists && number < 1000 => number += 1,
            Err(source) => return Err(CommandError::Write { path, source }),
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
    if IS_INTERRUPTED.load(Ordering::Relaxed) {
        return Err(fail("interrupted".to_owned()));
    }
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

fn manifest(name: &str, dependencies: &str) -> String {
    format!(
        "[package]\nname = \"{name}\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n\
         [dependencies]\n{dependencies}"
    )
}

fn runtime_dependency(runtime: Option<&Path>) -> Result<String, CommandError> {
    match runtime {
        Some(folder) => {
            let folder = fs::canonicalize(folder)
                .map_err(|error| CommandError::Read { path: folder.to_owned(), reason: error.to_string() })?;
            Ok(format!("{{ path = {:?} }}", folder.display().to_string()))
        }
        None => Ok(format!("\"={}\"", env!("CARGO_PKG_VERSION"))),
    }
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
    fn lines_of_five_numbers_are_times() {
        assert_eq!(times("1 2.5 4 5 0"), Some(Times::of([1.0, 2.5, 4.0, 5.0, 0.0])));
        assert_eq!((times("1 2 3 4"), times("1 2 3 4 x")), (None, None));
    }

    #[test]
    fn folders_are_new() {
        let (a, b) = (new_folder().ok().unwrap(), new_folder().ok().unwrap());
        assert!(a != b && a.is_dir() && b.is_dir());
        [a, b].iter().for_each(|folder| fs::remove_dir(folder).unwrap());
    }
}
