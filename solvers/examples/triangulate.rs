//! Silhouette lines and cameras in, cylinder out: `triangulate [--json] FILE`.

use std::io::Write;
use std::process::ExitCode;

use eliminant_solvers::cylinder::command;

fn main() -> ExitCode {
    let outcome = command::run(std::env::args_os().skip(1));
    // A reader that closes the pipe early is no fault of the scene.
    let _ = std::io::stdout().write_all(outcome.output.as_bytes());
    let _ = std::io::stderr().write_all(outcome.error.as_bytes());
    ExitCode::from(outcome.code)
}
