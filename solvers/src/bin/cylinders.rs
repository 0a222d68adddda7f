//! The `cylinders` command, see [`eliminant_solvers::cylinder::command`].

use std::io;
use std::process::ExitCode;

use eliminant_solvers::cylinder::command;

fn main() -> ExitCode {
    ExitCode::from(command::run(std::env::args_os(), &mut io::stdout(), &mut io::stderr()))
}
