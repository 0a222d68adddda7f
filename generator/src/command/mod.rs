//! The `eliminant` command: argument types and dispatch. Only here and in [`crate::build`] are
//! files read and written.
//!
//! Exit status: 0 good; 1 the problem, its template or a file is at fault; 2 usage.

mod bench;
mod check;
mod compiled;
mod emit;
mod error;
mod files;
mod folded;
mod inspect;
mod interrupt;
mod new;
mod progress;
mod report;
mod search;
mod spy;
mod stability;
mod svg;
mod watch;

use std::ffi::OsString;
use std::fmt;
use std::io::{self, Write};

use clap::{CommandFactory, Parser, Subcommand};
use clap_complete::Shell;
use serde::Serialize;

use error::CommandError;
use report::Output;

/// Turns polynomial problems, written as short Rust-syntax functions, into fast Rust solvers.
#[derive(Debug, Parser)]
#[command(
    name = "eliminant",
    max_term_width = 100,
    version,
    after_help = "From a new problem to a solver:
  eliminant new my_problem
  eliminant check my_problem.rs
  eliminant search my_problem.rs
  eliminant emit my_problem.rs --out solver.rs

Exit status: 0 good; 1 the problem, its template or a file is at fault; 2 usage."
)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
    /// Print one JSON object instead of text; an error as `{"error": ".."}`
    #[arg(long, global = true)]
    json: bool,
}

#[derive(Debug, Subcommand)]
enum Command {
    New(new::Arguments),
    Check(check::Arguments),
    Search(search::Arguments),
    Emit(emit::Arguments),
    Inspect(inspect::Arguments),
    Stability(stability::Arguments),
    Bench(bench::Arguments),
    /// Print a script that completes the command in a shell
    #[command(after_help = "Example:
  eliminant completions bash > ~/.local/share/bash-completion/completions/eliminant")]
    Completions {
        /// The shell
        shell: Shell,
    },
}

impl Command {
    fn run(&self) -> Result<Output, CommandError> {
        match self {
            Self::New(arguments) => new::run(arguments),
            Self::Check(arguments) => check::run(arguments),
            Self::Search(arguments) => search::run(arguments),
            Self::Emit(arguments) => emit::run(arguments),
            Self::Inspect(arguments) => inspect::run(arguments),
            Self::Stability(arguments) => stability::run(arguments),
            Self::Bench(arguments) => bench::run(arguments),
            Self::Completions { shell } => Ok(completions(*shell)),
        }
    }
}

#[derive(Serialize)]
struct Completions {
    script: String,
}

impl fmt::Display for Completions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.script)
    }
}

fn completions(shell: Shell) -> Output {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "eliminant", &mut script);
    Output::verbatim(&Completions { script: String::from_utf8_lossy(&script).into_owned() })
}

/// The exit status if the problem, its template or a file is at fault.
pub const AT_FAULT: u8 = 1;
/// The exit status of a wrong command line.
pub const USAGE: u8 = 2;

/// Runs the command with these arguments, the name of the program first. Returns the exit status.
///
/// Errors go to `stderr`; with `--json` also to `stdout`, as an object.
pub fn run(
    arguments: impl IntoIterator<Item = impl Into<OsString> + Clone>,
    stdout: &mut dyn Write,
    stderr: &mut dyn Write,
) -> u8 {
    run_in(arguments, stdout, stderr, Colour::Never)
}

/// Whether messages on standard error have colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colour {
    /// As escape sequences of a terminal.
    Always,
    /// Plain text.
    Never,
}

/// As [`run`], with messages in colours.
pub fn run_in(
    arguments: impl IntoIterator<Item = impl Into<OsString> + Clone>,
    stdout: &mut dyn Write,
    stderr: &mut dyn Write,
    colour: Colour,
) -> u8 {
    let arguments = match Arguments::try_parse_from(arguments) {
        Ok(arguments) => arguments,
        Err(error) => {
            // `--help` and `--version` are errors of clap, too.
            let text = error.render();
            let is_coloured = error.use_stderr() && colour == Colour::Always;
            let text = if is_coloured { text.ansi().to_string() } else { text.to_string() };
            return match error.use_stderr() {
                true => {
                    // If even this cannot be written, there is nobody to tell.
                    let _ = stderr.write_all(text.as_bytes());
                    USAGE
                }
                false => status_of(stdout.write_all(text.as_bytes())),
            };
        }
    };
    match arguments.command.run() {
        Ok(output) => {
            let text = if arguments.json { &output.json } else { &output.text };
            let written = status_of(stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()));
            written.max(if output.is_at_fault { AT_FAULT } else { 0 })
        }
        Err(error) => {
            let _ = match colour {
                Colour::Always => writeln!(stderr, "{}", error.render_in_colour()),
                Colour::Never => writeln!(stderr, "{error}"),
            };
            if arguments.json {
                let _ = stdout.write_all(report::error_json(&error).as_bytes());
            }
            AT_FAULT
        }
    }
}

/// A reader that stops reading, such as `head`, is no fault.
fn status_of(written: io::Result<()>) -> u8 {
    match written {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => AT_FAULT,
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_arguments_are_consistent() {
        Arguments::command().debug_assert();
    }
}
