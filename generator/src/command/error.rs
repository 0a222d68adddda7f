//! Why the command stops. Each message names the file at fault and a way out.

use std::io;
use std::path::{Path, PathBuf};

use crate::generate::GenerateError;
use crate::problem::diagnostic::Diagnostics;
use crate::problem::{Problem, Statement};
use crate::search::{MOST_COLUMNS, SearchError};

/// Why the command failed. In all cases the problem, the template or a file is at fault.
#[derive(Debug, thiserror::Error)]
pub(super) enum CommandError {
    /// A file is missing, a folder, or not readable.
    #[error("error: cannot read `{}`: {reason}", path.display())]
    Read { path: PathBuf, reason: String },
    /// A file cannot be written: no folder, no permission or no space.
    #[error("error: cannot write `{}`: {source}", path.display())]
    Write { path: PathBuf, source: io::Error },
    /// `eliminant new` overwrites no file.
    #[error("error: `{}` exists already and is left unchanged", path.display())]
    Exists { path: PathBuf },
    /// A problem file must be named after its problem, so that a template finds its problem.
    #[error("error: `{}` states the problem `{name}`: name the file `{name}.rs`", path.display())]
    FileName { path: PathBuf, name: String },
    /// The problem file is at fault. Its message says where.
    #[error("{0}")]
    Problem(#[from] Diagnostics),
    /// No template was found.
    #[error("error: {}: {error}{hint}", path.display())]
    Search { path: PathBuf, error: SearchError, hint: String },
    /// A file given to `search --merge` is not a file of a shard, or does not belong to the others.
    #[error("error: `{}`: {reason}", path.display())]
    Shard { path: PathBuf, reason: String },
    /// `search --check` was ended by Ctrl-C.
    #[error("error: not compared, because Ctrl-C ended the check")]
    Interrupted,
    /// `stability` was ended by Ctrl-C.
    #[error("error: not measured, because Ctrl-C ended it")]
    Ended,
    /// A folder holds no problem.
    #[error("error: there is no problem with a template in `{}`\nhelp: a folder is searched for files NAME.rs with NAME.template.toml beside them", folder.display())]
    NoProblem { folder: PathBuf },
    /// Figures go by the name of the problem.
    #[error("error: two files state the problem `{problem}`\nhelp: measure them one at a time")]
    Twice { problem: String },
    /// A file of instances is at fault.
    #[error("error: `{}`:{line}: {reason}", path.display())]
    Instance { path: PathBuf, line: usize, reason: String },
    /// A baseline is at fault.
    #[error("error: `{}`: {reason}\nhelp: `eliminant stability --update-baseline` writes the figures of the problems that it is given", path.display())]
    Baseline { path: PathBuf, reason: String },
    /// Several files are at fault.
    #[error("{}", .0.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))]
    Several(Vec<CommandError>),
    /// Some shards are missing.
    #[error("error: {reason}\nhelp: run `eliminant search {} --shard i/n` for each i, and merge all their files", problem.display())]
    Shards { problem: PathBuf, reason: String },
    /// There is no template file yet.
    #[error("error: there is no template file `{}`\nhelp: search one: `eliminant search {}`", template.display(), problem.display())]
    NoTemplate { template: PathBuf, problem: PathBuf },
    /// The template does not hold, or does not belong to the problem.
    #[error("error: {}: {error}\nhelp: search a template for the problem as it is now: `eliminant search {}`", template.display(), problem.display())]
    Template { template: PathBuf, problem: PathBuf, error: Box<GenerateError> },
    /// Solvers cannot be compiled or run.
    #[error(
        "error: cannot {action}: {reason}\nhelp: emitted solvers need cargo and the runtime crate `eliminant`; --runtime FOLDER names a checkout of it"
    )]
    Compiled { action: &'static str, reason: String },
    /// `bench --scenes` needs scenes.
    #[error("error: `{}` states no scene\nhelp: state a function with `#[scene]`, or leave out --scenes", problem.display())]
    NoScene { problem: PathBuf },
    /// No solver can be made although the template holds.
    #[error("error: {}: {error}", problem.display())]
    Generate { problem: PathBuf, error: Box<GenerateError> },
}

impl CommandError {
    /// The message in colours, for a terminal.
    pub(super) fn render_in_colour(&self) -> String {
        match self {
            Self::Problem(diagnostics) => diagnostics.render_in_colour(),
            Self::Several(errors) => errors.iter().map(Self::render_in_colour).collect::<Vec<_>>().join("\n"),
            other => {
                let message = other.to_string();
                let rest = message.strip_prefix("error");
                rest.map_or(message.clone(), |rest| format!("\x1b[1m\x1b[91merror\x1b[0m{rest}"))
            }
        }
    }

    /// Why the search for a template of `problem` failed.
    pub(super) fn of_search(path: &Path, problem: &Problem, error: SearchError) -> Self {
        let mut hint = String::new();
        if let SearchError::NotFound { max_columns: limit @ ..MOST_COLUMNS, is_over: false, .. } = error {
            let more = (3 * limit).min(MOST_COLUMNS);
            hint += &format!("\nhelp: `--max-columns {more}` looks further, and takes longer");
        }
        if let SearchError::NotFound { failed, .. } = &error
            && failed.iter().all(|strategy| strategy.sets == 0)
        {
            hint += "\nhelp: eliminate unknowns by hand, or state combinations of the equations of lower degree";
        }
        if let SearchError::TooFewColumns { least, .. } = error {
            hint += &format!("\nhelp: `--max-columns` must be more than {least}, or left out");
        }
        let is_sum = |factor: &Statement| factor.polynomial.terms().len() > 1;
        // An unknown of its own has no scale, and vectors that are given up to scale have any.
        let has_scales = problem.fields.iter().any(|field| field.is_projective);
        if !has_scales && problem.nonzero.iter().any(is_sum) {
            hint += "\nhelp: rows can be divided by a factor that must not vanish if it is an unknown of its own: `w == FACTOR; w != 0;`";
        }
        Self::Search { path: path.to_owned(), error, hint }
    }
}
