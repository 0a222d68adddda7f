//! The `eliminant` command, see [`eliminant_generator::command`].

use std::io;
use std::process::ExitCode;

fn main() -> ExitCode {
    let status = eliminant_generator::command::run(std::env::args_os(), &mut io::stdout(), &mut io::stderr());
    ExitCode::from(status)
}
