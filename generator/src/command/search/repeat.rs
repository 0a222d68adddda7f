//! `eliminant search --check`: repeats the searches of committed templates and tells what differs.

use std::fmt;
use std::path::{Path, PathBuf};

use serde::Serialize;

use super::outcome::{Task, search};
use super::provenance::{ENDED_EARLY, GENERATOR, position, recorded_settings, value_of};
use crate::command::error::CommandError;
use crate::command::files::{read_named_problem, read_text, template_path};
use crate::command::report::{Output, counted, seconds};
use crate::command::watch::Watch;
use crate::generate::GenerateError;
use crate::problem::Problem;
use crate::search::monitor::Monitor;
use crate::template::file::TemplateFile;

/// The object of `--json`.
#[derive(Serialize)]
struct CheckReport {
    files: Vec<CheckedFile>,
    /// Number of files whose search writes the same again.
    same: usize,
    /// Number of the others.
    different: usize,
    seconds: f64,
}

/// A problem whose template was compared with what the search writes now.
#[derive(Serialize)]
struct CheckedFile {
    file: String,
    same: bool,
    /// What differs, each in a sentence.
    differences: Vec<String>,
    /// Size of the committed template, such as `11x13`; `null` if there is none that can be read.
    committed: Option<String>,
    /// Size of the template that the search writes now; `null` if it was not repeated to its end.
    found: Option<String>,
    /// Keys of the provenance that the file lacks.
    lacks: Vec<String>,
    /// Keys of the provenance that no search writes.
    unwritten: Vec<String>,
}

/// Repeats the search of each problem.
pub(super) fn run(problems: &[PathBuf]) -> Output {
    let watch = Watch::new(None);
    let files: Vec<CheckedFile> = problems.iter().map(|path| check(path, &watch)).collect();
    watch.finish();
    let same = files.iter().filter(|file| file.same).count();
    let different = files.len() - same;
    Output::of(&CheckReport { files, same, different, seconds: watch.seconds() }).at_fault_if(different > 0)
}

fn check(path: &Path, watch: &Watch) -> CheckedFile {
    let mut checked = CheckedFile {
        file: path.display().to_string(),
        same: false,
        differences: Vec::new(),
        committed: None,
        found: None,
        lacks: Vec::new(),
        unwritten: Vec::new(),
    };
    if let Err(error) = checked.compare(path, watch) {
        checked.differences.push(error.to_string());
    }
    checked.same = checked.differences.is_empty();
    checked
}

impl CheckedFile {
    fn compare(&mut self, path: &Path, watch: &Watch) -> Result<(), CommandError> {
        let problem = read_named_problem(path)?;
        let (text, committed) = read_committed(path, &problem)?;
        self.committed = Some(size(&committed));
        for (key, _) in &committed.provenance {
            if position(key).is_none() {
                self.differences.push(format!("holds a key that nothing writes: {key}"));
                self.unwritten.push(key.clone());
            }
        }
        if let Some(end) = value_of(&committed.provenance, ENDED_EARLY) {
            self.differences.push(format!("comes of a search that was ended early ({end}), which cannot be repeated"));
        }
        let settings = match recorded_settings(&committed.provenance) {
            Ok(settings) => settings,
            Err(reason) => {
                self.differences.push(format!("records no search that can be repeated: {reason}"));
                return Ok(());
            }
        };
        watch.say(&format!("repeating the search of {}", problem.name));
        let found = match watch.end() {
            None => search(Task { path, problem: &problem, watch }, settings),
            Some(_) => Err(CommandError::Interrupted),
        };
        // A search that Ctrl-C cut short says nothing about the one that was recorded.
        let found = if watch.end().is_some() { Err(CommandError::Interrupted) } else { found }?.file;
        self.found = Some(size(&found));
        self.compare_templates(&committed, &found, &problem);
        self.compare_keys(&committed, &found);
        if self.differences.is_empty() && !is_same_text(&text, &committed, &found, &problem) {
            self.differences.push("differs: the same template and keys, written in another layout".to_owned());
        }
        Ok(())
    }

    fn compare_templates(&mut self, committed: &TemplateFile, found: &TemplateFile, problem: &Problem) {
        if committed.problem != found.problem || committed.fingerprint != found.fingerprint {
            self.differences.push(format!("differs: found for another version of `{}`", problem.name));
        }
        let action = |file: &TemplateFile| file.template.action.display(&problem.unknowns).to_string();
        let [old, new] = [committed, found].map(size);
        let difference = if old != new {
            format!("committed {old}, found {new}")
        } else if committed.template.action != found.template.action {
            format!("committed {old} with action {}, found {new} with action {}", action(committed), action(found))
        } else if committed.presolve != found.presolve {
            format!(
                "committed {old} with presolve {}, found {new} with {}",
                committed.presolve.name(),
                found.presolve.name()
            )
        } else if committed.template != found.template {
            format!("committed {old}, found {new} with other rows or columns")
        } else if committed.solutions != found.solutions || committed.roots != found.roots {
            format!("committed {old}, found the same with other `solutions` or `roots`")
        } else {
            return;
        };
        self.differences.push(format!("differs: {difference}"));
    }

    /// Compares the provenance. Values are compared only if the templates are the same, because
    /// they follow from the template.
    fn compare_keys(&mut self, committed: &TemplateFile, found: &TemplateFile) {
        for (key, value) in &found.provenance {
            match value_of(&committed.provenance, key) {
                None => self.lacks.push(key.clone()),
                Some(old) if old != value && key != GENERATOR && committed.template == found.template => {
                    self.differences.push(format!("differs: {key} is committed as `{old}`, found as `{value}`"));
                }
                Some(_) => {}
            }
        }
        match self.lacks.as_slice() {
            [] => {}
            [key] => self.differences.push(format!("lacks key {key}")),
            keys => self.differences.push(format!("lacks keys {}", keys.join(", "))),
        }
        for (key, _) in &committed.provenance {
            let is_written = value_of(&found.provenance, key).is_some();
            if position(key).is_some() && key != ENDED_EARLY && !is_written {
                self.differences.push(format!("holds a key that this search does not write: {key}"));
            }
        }
    }
}

/// The text and the content of the template file of a problem.
fn read_committed(path: &Path, problem: &Problem) -> Result<(String, TemplateFile), CommandError> {
    let template = template_path(path);
    if !template.exists() {
        return Err(CommandError::NoTemplate { template, problem: path.to_owned() });
    }
    let text = read_text(&template)?;
    let file = TemplateFile::parse(&text, &problem.unknowns).map_err(|error| CommandError::Template {
        template,
        problem: path.to_owned(),
        error: Box::new(GenerateError::from(error)),
    })?;
    Ok((text, file))
}

fn size(file: &TemplateFile) -> String {
    format!("{}x{}", file.template.rows(), file.template.columns())
}

/// Whether a search writes these bytes again, the version of the generator aside.
fn is_same_text(text: &str, committed: &TemplateFile, found: &TemplateFile, problem: &Problem) -> bool {
    let mut found = found.clone();
    for (key, value) in &mut found.provenance {
        if key == GENERATOR
            && let Some(version) = value_of(&committed.provenance, GENERATOR)
        {
            version.clone_into(value);
        }
    }
    found.to_text(&problem.unknowns) == text
}

impl fmt::Display for CheckReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for CheckedFile { file, same, differences, .. } in &self.files {
            if *same {
                writeln!(f, "{file}: same")?;
            }
            for difference in differences {
                writeln!(f, "{file}: {}", difference.trim_end())?;
            }
        }
        let Self { files, same, different, seconds: time } = self;
        let checked = counted(files.len(), "template");
        writeln!(f, "{checked} checked in {}: {same} the same, {different} not", seconds(*time))
    }
}
