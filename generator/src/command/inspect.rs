//! `eliminant inspect`: draws a template.

use std::fmt;
use std::path::PathBuf;
use std::time::Instant;

use serde::Serialize;

use super::error::CommandError;
use super::files::{Loaded, write};
use super::report::{Output, Summary, counted};
use super::spy::spy;
use super::svg::svg;
use crate::plan::picture::Picture;

/// Draw a template: which rows and columns it has and where its entries stand
#[derive(clap::Args, Debug)]
#[command(after_help = "Rows are labelled with their shift: f2 * x*y is equation 2, as presolve leaves it, times x*y.

Example:
  eliminant inspect problems/two_circles.rs --svg two_circles.svg")]
pub(super) struct Arguments {
    /// The problem file, NAME.rs
    file: PathBuf,
    /// The template file, if it is not NAME.template.toml beside the problem
    #[arg(long, value_name = "FILE")]
    template: Option<PathBuf>,
    /// Write a picture to this file
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
}

#[derive(Serialize)]
struct TemplateReport {
    #[serde(flatten)]
    summary: Summary,
    /// Entries that are not zero for general data.
    entries: usize,
    /// Number of rows of each diagonal block, in order of solution.
    blocks: Vec<usize>,
    /// Unknowns that presolve eliminated.
    eliminated: Vec<String>,
    /// The rows in the order of solution.
    shifts: Vec<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    svg: Option<String>,
    seconds: f64,
    #[serde(skip)]
    drawing: String,
}

pub(super) fn run(arguments: &Arguments) -> Result<Output, CommandError> {
    let start = Instant::now();
    let Loaded { problem, file, planned } = Loaded::read(&arguments.file, arguments.template.as_deref())?;
    let template = &file.template;
    let picture = Picture::new(template, &planned.plan);
    if let Some(path) = &arguments.svg {
        let subtitle = format!(
            "{} × {} template · {} · action {} · {}",
            template.rows(),
            template.columns(),
            counted(planned.plan.solutions, "solution"),
            template.action.display(&problem.unknowns),
            counted(picture.blocks.len(), "diagonal block"),
        );
        write(path, &svg(&picture, &problem.name, &subtitle))?;
    }
    Ok(Output::of(&TemplateReport {
        summary: Summary::new(&problem, template, &planned.plan),
        entries: picture.entries(),
        blocks: picture.blocks.clone(),
        eliminated: planned.plan.eliminated().iter().map(|&unknown| problem.unknowns[unknown].clone()).collect(),
        drawing: spy(&picture),
        shifts: picture.rows,
        svg: arguments.svg.as_ref().map(|path| path.display().to_string()),
        seconds: start.elapsed().as_secs_f64(),
    }))
}

impl fmt::Display for TemplateReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.summary)?;
        if !self.eliminated.is_empty() {
            writeln!(f, "presolve    eliminates {}", self.eliminated.join(", "))?;
        }
        let sizes: Vec<String> = self.blocks.iter().map(usize::to_string).collect();
        writeln!(f, "blocks      {}", sizes.join(" "))?;
        writeln!(f, "entries     {}\n\n{}", self.entries, self.drawing)?;
        match &self.svg {
            Some(path) => writeln!(f, "wrote {path}"),
            None => Ok(()),
        }
    }
}
