//! The command `eliminant` as a function.

use eliminant_generator::command;
use pyo3::prelude::*;

/// Runs the command with these arguments, the name of the program first. Returns the exit status,
/// and what it writes to standard output and to standard error.
#[pyfunction]
pub(crate) fn run_command(py: Python<'_>, arguments: Vec<String>) -> (u8, String, String) {
    let (mut stdout, mut stderr) = (Vec::new(), Vec::new());
    let status = py.detach(|| command::run(arguments, &mut stdout, &mut stderr));
    let text = |bytes: Vec<u8>| String::from_utf8_lossy(&bytes).into_owned();
    (status, text(stdout), text(stderr))
}
