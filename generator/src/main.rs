//! The `eliminant` command, see [`eliminant_generator::command`].

use std::env;
use std::io::{self, IsTerminal};
use std::process::ExitCode;

use eliminant_generator::command::{Colour, run_in};

fn main() -> ExitCode {
    // https://no-color.org
    let is_coloured = io::stderr().is_terminal() && env::var_os("NO_COLOR").is_none_or(|value| value.is_empty());
    let colour = if is_coloured { Colour::Always } else { Colour::Never };
    ExitCode::from(run_in(env::args_os(), &mut io::stdout(), &mut io::stderr(), colour))
}
