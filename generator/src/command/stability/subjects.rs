//! The problems that are measured: files, and folders of them.

use std::fs;
use std::path::{Path, PathBuf};

use crate::command::error::CommandError;
use crate::command::files::{Loaded, template_path};
use crate::generate::generate;

/// A problem with its template, and the source of its solver.
pub(super) struct Subject {
    pub(super) file: PathBuf,
    pub(super) loaded: Loaded,
    /// Empty where the plan is interpreted.
    pub(super) source: String,
}

/// Reads problems, each with its template. All files at fault are named.
pub(super) fn read_subjects(
    paths: &[PathBuf],
    template: Option<&Path>,
    is_emitted: bool,
) -> Result<Vec<Subject>, CommandError> {
    let (mut subjects, mut errors) = (Vec::new(), Vec::new());
    for path in paths {
        match files_of(path) {
            Ok(files) => files.into_iter().for_each(|file| match read_subject(file, template, is_emitted) {
                Ok(subject) => subjects.push(subject),
                Err(error) => errors.push(error),
            }),
            Err(error) => errors.push(error),
        }
    }
    let mut names: Vec<&str> = subjects.iter().map(|subject| subject.loaded.problem.name.as_str()).collect();
    names.sort_unstable();
    if let Some(twice) = names.windows(2).find(|pair| pair[0] == pair[1]) {
        errors.push(CommandError::Twice { problem: twice[0].to_owned() });
    }
    match errors.len() {
        0 => Ok(subjects),
        1 => Err(errors.remove(0)),
        _ => Err(CommandError::Several(errors)),
    }
}

fn read_subject(file: PathBuf, template: Option<&Path>, is_emitted: bool) -> Result<Subject, CommandError> {
    let loaded = Loaded::read(&file, template)?;
    let emitted = || {
        generate(&loaded.problem, &loaded.file)
            .map_err(|error| CommandError::Generate { problem: file.clone(), error: error.into() })
    };
    let source = if is_emitted { emitted()? } else { String::new() };
    Ok(Subject { file, loaded, source })
}

/// The file itself, or the problems of a folder that have a template, by name.
fn files_of(path: &Path) -> Result<Vec<PathBuf>, CommandError> {
    if !path.is_dir() {
        return Ok(vec![path.to_owned()]);
    }
    let fail = |error: std::io::Error| CommandError::Read { path: path.to_owned(), reason: error.to_string() };
    let mut files = Vec::new();
    for entry in fs::read_dir(path).map_err(fail)? {
        let file = entry.map_err(fail)?.path();
        if file.extension().is_some_and(|end| end == "rs") && template_path(&file).exists() {
            files.push(file);
        }
    }
    files.sort();
    if files.is_empty() { Err(CommandError::NoProblem { folder: path.to_owned() }) } else { Ok(files) }
}
