//! Reading problems and templates, with errors that name the file.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use super::error::CommandError;
use crate::build::write_if_changed;
use crate::generate::{GenerateError, Planned, plan};
use crate::problem::Problem;
use crate::template::file::TemplateFile;

/// Most bytes of a problem or a template. A device may have no end.
const MAX_BYTES: u64 = 16 << 20;

pub(super) fn read_text(path: &Path) -> Result<String, CommandError> {
    let fail = |reason: String| CommandError::Read { path: path.to_owned(), reason };
    if fs::metadata(path).is_ok_and(|metadata| metadata.is_dir()) {
        return Err(fail("it is a folder, not a file".into()));
    }
    let mut bytes = Vec::new();
    let read = File::open(path).and_then(|file| file.take(MAX_BYTES + 1).read_to_end(&mut bytes));
    read.map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => fail("there is no such file".into()),
        _ => fail(error.to_string()),
    })?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(fail(format!("it is longer than {MAX_BYTES} bytes")));
    }
    String::from_utf8(bytes).map_err(|error| {
        let valid = error.utf8_error().valid_up_to();
        let line = 1 + error.as_bytes()[..valid].iter().filter(|&&byte| byte == b'\n').count();
        fail(format!("it is not UTF-8 text (byte {valid}, in line {line})"))
    })
}

/// Reads a problem.
pub(super) fn read_problem(path: &Path) -> Result<Problem, CommandError> {
    Ok(Problem::parse(&path.display().to_string(), &read_text(path)?)?)
}

/// Reads a problem from a file that must be named after it.
pub(super) fn read_named_problem(path: &Path) -> Result<Problem, CommandError> {
    let problem = read_problem(path)?;
    match path.file_stem().is_some_and(|stem| stem == problem.name.as_str()) {
        true => Ok(problem),
        false => Err(CommandError::FileName { path: path.to_owned(), name: problem.name }),
    }
}

/// `NAME.template.toml` beside `NAME.rs`.
pub(super) fn template_path(problem: &Path) -> PathBuf {
    problem.with_extension("template.toml")
}

/// A problem with its template, verified and planned.
pub(super) struct Loaded {
    pub(super) problem: Problem,
    pub(super) file: TemplateFile,
    pub(super) planned: Planned,
}

impl Loaded {
    /// Reads a problem and its template, which stands beside it unless `template` is given.
    pub(super) fn read(path: &Path, template: Option<&Path>) -> Result<Self, CommandError> {
        let problem = read_named_problem(path)?;
        let template = template.map_or_else(|| template_path(path), Path::to_owned);
        if !template.exists() {
            return Err(CommandError::NoTemplate { template, problem: path.to_owned() });
        }
        let at_fault = |error: GenerateError| {
            let (is_stale, problem, error) = (error.is_stale_template(), path.to_owned(), Box::new(error));
            match is_stale {
                true => CommandError::Template { template: template.clone(), problem, error },
                false => CommandError::Generate { problem, error },
            }
        };
        let text = read_text(&template)?;
        let file = TemplateFile::parse(&text, &problem.unknowns).map_err(|error| at_fault(error.into()))?;
        let planned = plan(&problem, &file).map_err(at_fault)?;
        Ok(Self { problem, file, planned })
    }
}

/// Writes all of a file or nothing: if it fails, an old file is untouched. Folders and devices are
/// not replaced.
pub(super) fn write(path: &Path, content: &str) -> Result<(), CommandError> {
    let fail = |source: io::Error| CommandError::Write { path: path.to_owned(), source };
    if fs::metadata(path).is_ok_and(|metadata| !metadata.is_file()) {
        return Err(fail(io::Error::other("it is not a regular file")));
    }
    write_if_changed(path, content).map_err(fail)
}
