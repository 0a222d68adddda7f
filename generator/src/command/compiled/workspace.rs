//! A cargo workspace in a temporary folder, in which programs are compiled and run.

use std::env::consts::EXE_SUFFIX;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use crate::command::error::CommandError;
use crate::command::interrupt::{is_interrupted, listen};

/// The workspace. Its folder is removed when this is dropped.
pub(in crate::command) struct Workspace {
    folder: PathBuf,
    /// What a manifest says of the runtime crate.
    runtime: String,
}

impl Drop for Workspace {
    fn drop(&mut self) {
        // What cannot be removed is left to the system, which empties its temporary folder.
        let _ = fs::remove_dir_all(&self.folder);
    }
}

impl Workspace {
    /// An empty workspace of these members. Without a `runtime` folder, that of the checkout around
    /// `problem` is used, or else the published crate. From now on Ctrl-C ends the steps below with
    /// an error, and the folder is removed.
    pub(in crate::command) fn new(
        members: &[&str],
        runtime: Option<&Path>,
        problem: &Path,
    ) -> Result<Self, CommandError> {
        listen();
        let runtime = runtime.map(Path::to_owned).or_else(|| runtime_around(problem));
        let this = Self { folder: new_folder()?, runtime: runtime_dependency(runtime.as_deref())? };
        let manifest =
            format!("[workspace]\nmembers = {members:?}\nresolver = \"3\"\n\n[profile.release]\nstrip = true\n");
        this.write("Cargo.toml", &manifest)?;
        // The versions of the checkout, whose crates are on this machine already.
        if let Some(lock) = runtime.as_deref().and_then(Path::parent).map(|root| root.join("Cargo.lock"))
            && let Ok(text) = fs::read_to_string(lock)
        {
            this.write("Cargo.lock", &text)?;
        }
        Ok(this)
    }

    /// The line of a manifest that depends on the runtime crate.
    pub(in crate::command) fn runtime(&self) -> String {
        format!("eliminant = {}\n", self.runtime)
    }

    /// Writes a file of the workspace.
    pub(in crate::command) fn write(
        &self,
        name: &str,
        content: &(impl AsRef<[u8]> + ?Sized),
    ) -> Result<(), CommandError> {
        let path = self.folder.join(name);
        let folder = path.parent().unwrap_or(&self.folder);
        let written = fs::create_dir_all(folder).and_then(|()| fs::write(&path, content));
        written.map_err(|source| CommandError::Write { path, source })
    }

    /// Writes numbers as bytes, the lowest first.
    pub(in crate::command) fn write_numbers(&self, name: &str, numbers: &[f64]) -> Result<(), CommandError> {
        let bytes: Vec<u8> = numbers.iter().flat_map(|value| value.to_le_bytes()).collect();
        self.write(name, &bytes)
    }

    /// Compiles the runtime crate, by what is on this machine if that suffices; otherwise crates
    /// are fetched.
    pub(in crate::command) fn build_runtime(&self) -> Result<(), CommandError> {
        self.cargo_build(&["--offline", "--package", "eliminant"])
            .or_else(|_| self.cargo_build(&["--package", "eliminant"]))
    }

    /// Compiles a package, once the runtime crate is compiled.
    pub(in crate::command) fn build(&self, package: &str) -> Result<(), CommandError> {
        self.cargo_build(&["--offline", "--package", package])
    }

    fn cargo_build(&self, arguments: &[&str]) -> Result<(), CommandError> {
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

    /// The size of a compiled program.
    pub(in crate::command) fn program_bytes(&self, name: &str) -> Result<u64, CommandError> {
        let path = self.program(name);
        let length = fs::metadata(&path).map(|metadata| metadata.len());
        length.map_err(|error| CommandError::Read { path, reason: error.to_string() })
    }

    /// Runs a compiled program: what it prints.
    pub(in crate::command) fn run(&self, name: &str, argument: &str) -> Result<String, CommandError> {
        let mut command = Command::new(self.program(name));
        command.arg(argument).current_dir(&self.folder);
        let output = run(command, RUN)?;
        Ok(String::from_utf8_lossy(&output.stdout).into_owned())
    }
}

const RUN: &str = "run the solvers";

/// The error of a program whose output is not what it should print.
pub(in crate::command) fn unexpected(output: &str) -> CommandError {
    CommandError::Compiled { action: RUN, reason: format!("unexpected output:\n{output}") }
}

/// A folder that was not there before: its name can be guessed, and what others put there must not
/// be compiled.
fn new_folder() -> Result<PathBuf, CommandError> {
    let mut number = 0;
    loop {
        let path = std::env::temp_dir().join(format!("eliminant-{}-{number}", std::process::id()));
        match fs::create_dir(&path) {
            Ok(()) => return Ok(path),
            Err(error) if error.kind() == std::io::ErrorKind::AlreadyExists && number < 1000 => number += 1,
            Err(source) => return Err(CommandError::Write { path, source }),
        }
    }
}

fn run(mut command: Command, action: &'static str) -> Result<Output, CommandError> {
    let fail = |reason: String| CommandError::Compiled { action, reason };
    let output = command.output().map_err(|error| fail(error.to_string()))?;
    if is_interrupted() {
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

/// The manifest of a package with these lines of dependencies.
pub(in crate::command) fn manifest(name: &str, dependencies: &str) -> String {
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
    fn folders_are_new() {
        let (a, b) = (new_folder().ok().unwrap(), new_folder().ok().unwrap());
        assert!(a != b && a.is_dir() && b.is_dir());
        [a, b].iter().for_each(|folder| fs::remove_dir(folder).unwrap());
    }
}
