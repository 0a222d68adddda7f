//! `eliminant emit`: the source of a solver.

use std::fmt;
use std::path::PathBuf;
use std::time::Instant;

use serde::Serialize;

use super::error::CommandError;
use super::files::{Loaded, write};
use super::report::{Output, Summary, seconds};
use crate::generate::generate;

/// Print the source of the solver of a problem
#[derive(clap::Args, Debug)]
#[command(after_help = "Build scripts do the same with `eliminant_generator::Generator`.

Example:
  eliminant emit problems/two_circles.rs --out src/two_circles.rs")]
pub(super) struct Arguments {
    /// The problem file, NAME.rs
    file: PathBuf,
    /// The template file, if it is not NAME.template.toml beside the problem
    #[arg(long, value_name = "FILE")]
    template: Option<PathBuf>,
    /// Write to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

#[derive(Serialize)]
struct EmitReport {
    #[serde(flatten)]
    summary: Summary,
    /// The source, if it is not written to a file.
    #[serde(skip_serializing_if = "Option::is_none")]
    source: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    file: Option<String>,
    seconds: f64,
}

pub(super) fn run(arguments: &Arguments) -> Result<Output, CommandError> {
    let start = Instant::now();
    let loaded = Loaded::read(&arguments.file, arguments.template.as_deref())?;
    let source = generate(&loaded.problem, &loaded.file)
        .map_err(|error| CommandError::Generate { problem: arguments.file.clone(), error: error.into() })?;
    if let Some(out) = &arguments.out {
        write(out, &source)?;
    }
    Ok(Output::verbatim(&EmitReport {
        summary: Summary::new(&loaded.problem, &loaded.file.template, &loaded.planned.plan),
        source: arguments.out.is_none().then_some(source),
        file: arguments.out.as_ref().map(|out| out.display().to_string()),
        seconds: start.elapsed().as_secs_f64(),
    }))
}

impl fmt::Display for EmitReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (&self.source, &self.file) {
            (Some(source), _) => write!(f, "{source}"),
            (None, Some(file)) => writeln!(f, "wrote {file} in {}", seconds(self.seconds)),
            (None, None) => Ok(()),
        }
    }
}
