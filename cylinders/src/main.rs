//! The `cylinders` command, see [`eliminant_cylinders::command`].

use std::io;
use std::process::ExitCode;

use eliminant_cylinders::command;

fn main() -> ExitCode {
    ExitCode::from(command::run(std::env::args_os(), &mut io::stdout(), &mut io::stderr()))
}
