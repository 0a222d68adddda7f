//! The `cylinders` command: argument types and dispatch. Each subcommand is a file with its
//! arguments and its `run`.
//!
//! Exit status: 0 success; 1 the data or a file is at fault; 2 wrong usage.

/// Models, pictures and the page of a result.
mod drawings;
/// Why a subcommand failed.
mod error;
/// How cylinders are estimated.
mod estimator;
/// `cylinders experiment`.
mod experiment;
/// Output files, written whole or not at all.
mod files;
/// Cylinders that were found among lines without labels.
mod found;
/// Where photographs are.
mod images;
/// `cylinders match`.
mod matching;
/// Text for people, or one JSON object.
mod output;
/// `cylinders photos`.
mod photos;
/// Where cameras and lines come from.
mod scene;
/// `cylinders triangulate`.
mod triangulate;

use std::ffi::OsString;
use std::io::{self, Write};

use clap::{Parser, Subcommand};

use error::CommandError;
use output::{Output, error_json};

/// Triangulates cylinders from their silhouette lines in several images.
#[derive(Debug, Parser)]
#[command(
    name = "cylinders",
    version,
    max_term_width = 100,
    after_help = "Exit status: 0 good; 1 the data or a file is at fault; 2 usage."
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
    Experiment(experiment::Arguments),
    Match(matching::Arguments),
    Photos(photos::Arguments),
    Triangulate(triangulate::Arguments),
}

impl Command {
    fn run(&self, line: &str) -> Result<Output, CommandError> {
        match self {
            Self::Experiment(arguments) => experiment::run(arguments),
            Self::Match(arguments) => matching::run(arguments, line),
            Self::Photos(arguments) => photos::run(arguments, line),
            Self::Triangulate(arguments) => triangulate::run(arguments, line),
        }
    }
}

/// The exit status if the data or a file is at fault.
pub const AT_FAULT: u8 = 1;
/// The exit status of a wrong command line.
pub const USAGE: u8 = 2;

/// Runs the command with these arguments, of which the first is the name of the program. Returns
/// the exit status.
///
/// Errors go to `stderr`; with `--json` also to `stdout`, as an object. Warnings are part of the
/// text; with `--json` they are part of the object and also go to `stderr`.
pub fn run(
    arguments: impl IntoIterator<Item = impl Into<OsString> + Clone>,
    stdout: &mut dyn Write,
    stderr: &mut dyn Write,
) -> u8 {
    let arguments: Vec<OsString> = arguments.into_iter().map(Into::into).collect();
    let line = arguments.iter().map(|argument| argument.to_string_lossy()).collect::<Vec<_>>().join(" ");
    let arguments = match Arguments::try_parse_from(arguments) {
        Ok(arguments) => arguments,
        Err(error) => {
            // The parser reports `--help` and `--version` as errors, too.
            let text = error.render().to_string();
            return match error.use_stderr() {
                true => {
                    // If standard error cannot be written either, the failure cannot be reported.
                    let _ = stderr.write_all(text.as_bytes());
                    USAGE
                }
                false => status_of(stdout.write_all(text.as_bytes())),
            };
        }
    };
    match arguments.command.run(&line) {
        Ok(output) => {
            if arguments.json {
                for warning in &output.warnings {
                    let _ = writeln!(stderr, "warning: {warning}");
                }
            }
            let text = if arguments.json { &output.json } else { &output.text };
            status_of(stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()))
        }
        Err(error) => {
            let _ = writeln!(stderr, "error: {error}");
            if arguments.json {
                let _ = stdout.write_all(error_json(&error).as_bytes());
            }
            AT_FAULT
        }
    }
}

/// A closed pipe is not an error: a reader such as `head` may stop early.
fn status_of(written: io::Result<()>) -> u8 {
    match written {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => AT_FAULT,
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    #[test]
    fn the_arguments_are_consistent() {
        super::Arguments::command().debug_assert();
    }
}
