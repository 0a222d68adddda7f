//! The API of build scripts: all problems of a folder become solvers in `OUT_DIR`.

use std::env;
use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::generate::{GenerateError, generate};
use crate::problem::Problem;
use crate::problem::diagnostic::Diagnostics;
use crate::template::file::TemplateFile;

/// Emits a solver for every problem of a folder.
///
/// ```no_run
/// // build.rs
/// fn main() -> Result<(), eliminant_generator::BuildError> {
///     eliminant_generator::Generator::new().problems("problems").run()
/// }
/// ```
///
/// `problems/NAME.rs` and its template `problems/NAME.template.toml` become `OUT_DIR/NAME.rs`,
/// which `eliminant::include_solver!("NAME")` includes. A file whose content would not change is
/// not written.
///
/// A problem without a template stops the build with a message that names the command which finds
/// one. With the feature `search` a bounded search is done instead, and a warning says how to keep
/// its result.
#[derive(Clone, Debug, Default)]
pub struct Generator {
    problems: Option<PathBuf>,
    templates: Option<PathBuf>,
    only: Option<Vec<String>>,
    index: Option<String>,
    out_dir: Option<PathBuf>,
}

impl Generator {
    /// A generator that reads the folder `problems` and writes to `OUT_DIR`.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the folder with the problems, relative to the crate's manifest.
    #[must_use]
    pub fn problems(mut self, folder: impl Into<PathBuf>) -> Self {
        self.problems = Some(folder.into());
        self
    }

    /// Only the problems of these names, not all of the folder.
    ///
    /// ```no_run
    /// # fn main() -> Result<(), eliminant_generator::BuildError> {
    /// # let folder = "problems";
    /// let generator = eliminant_generator::Generator::new().problems(folder);
    /// generator.only(["relpose_5pt", "two_conics"]).run()
    /// # }
    /// ```
    #[must_use]
    pub fn only(mut self, names: impl IntoIterator<Item = impl Into<String>>) -> Self {
        self.only = Some(names.into_iter().map(Into::into).collect());
        self
    }

    /// A folder with other templates, relative to the crate's manifest: a file `NAME.template.toml`
    /// there is taken instead of the one beside the problem.
    #[must_use]
    pub fn templates(mut self, folder: impl Into<PathBuf>) -> Self {
        self.templates = Some(folder.into());
        self
    }

    /// Also writes `NAME.rs`, which includes all solvers: `eliminant::include_solver!("NAME")`
    /// takes them at once.
    #[must_use]
    pub fn index(mut self, name: impl Into<String>) -> Self {
        self.index = Some(name.into());
        self
    }

    /// Sets the folder for the solvers, instead of `OUT_DIR`.
    #[must_use]
    pub fn out_dir(mut self, folder: impl Into<PathBuf>) -> Self {
        self.out_dir = Some(folder.into());
        self
    }

    /// Emits all solvers and tells cargo when to do so again.
    ///
    /// # Errors
    /// The errors of all problems together. The solvers of the other problems are written.
    pub fn run(self) -> Result<(), BuildError> {
        let manifest = env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from).unwrap_or_default();
        let folder = self.problems.clone().unwrap_or_else(|| "problems".into());
        let out_dir = self.out_dir.clone().or_else(|| env::var_os("OUT_DIR").map(PathBuf::from));
        let out_dir =
            out_dir.ok_or_else(|| BuildError::one(&folder, "OUT_DIR is not set: this is for build scripts"))?;
        let templates = self.templates.as_ref().map(|folder| manifest.join(folder));
        if let Some(folder) = &templates {
            println!("cargo:rerun-if-changed={}", folder.display());
            fs::read_dir(folder).map_err(|error| BuildError::one(folder, error.to_string()))?;
        }
        let (mut names, mut errors) = (Vec::new(), Vec::new());
        for file in self.problem_files(&manifest.join(&folder))? {
            println!("cargo:rerun-if-changed={}", file.display());
            let shown = folder.join(file.file_name().unwrap_or_default());
            match emit_file(&file, templates.as_deref(), &shown) {
                Ok((name, source)) => {
                    write_into(&out_dir, &name, &source, &mut errors);
                    names.push(name);
                }
                Err(message) => errors.push((shown, message)),
            }
        }
        if let Some(index) = &self.index {
            match names.contains(index) {
                true => errors.push((folder, format!("`{index}` is the name of a problem, and of the index"))),
                false => write_into(&out_dir, index, &index_of(&names), &mut errors),
            }
        }
        if errors.is_empty() { Ok(()) } else { Err(BuildError { errors }) }
    }

    /// The problem files that are wanted, sorted.
    fn problem_files(&self, root: &Path) -> Result<Vec<PathBuf>, BuildError> {
        let mut files = problem_files(root).map_err(|error| BuildError::one(root, error.to_string()))?;
        let Some(only) = &self.only else {
            println!("cargo:rerun-if-changed={}", root.display());
            if files.is_empty() {
                return Err(BuildError::one(root, "there is no problem file (`NAME.rs`) in this folder"));
            }
            return Ok(files);
        };
        let missing = |name: &&String| !files.contains(&root.join(format!("{name}.rs")));
        if let Some(name) = only.iter().find(missing) {
            return Err(BuildError::one(root, format!("there is no problem file `{name}.rs` in this folder")));
        }
        files.retain(|file| file.file_stem().is_some_and(|stem| only.iter().any(|name| stem == name.as_str())));
        Ok(files)
    }
}

/// The file that includes the solvers of these names, which lie beside it.
fn index_of(names: &[String]) -> String {
    let includes: String = names.iter().map(|name| format!("include!(\"{name}.rs\");\n")).collect();
    format!("// @generated by eliminant-generator. Do not edit.\n{includes}")
}

/// Writes the file of that name and notes what went wrong.
fn write_into(out_dir: &Path, name: &str, source: &str, errors: &mut Vec<(PathBuf, String)>) {
    let path = out_dir.join(format!("{name}.rs"));
    if let Err(error) = write_if_changed(&path, source) {
        errors.push((path, error.to_string()));
    }
}

/// All errors that stopped a build, each with its file. A build script whose `main` returns it
/// prints it as it is.
pub struct BuildError {
    errors: Vec<(PathBuf, String)>,
}

impl BuildError {
    fn one(path: &Path, message: impl Into<String>) -> Self {
        Self { errors: vec![(path.to_owned(), message.into())] }
    }
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (path, message) in &self.errors {
            writeln!(f, "\n{}:\n{message}", path.display())?;
        }
        Ok(())
    }
}

impl fmt::Debug for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl std::error::Error for BuildError {}

/// The `*.rs` files of a folder, sorted.
fn problem_files(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

/// The problem's name and its solver, or the message to show. A template in the folder `templates`
/// goes first.
fn emit_file(path: &Path, templates: Option<&Path>, shown: &Path) -> Result<(String, String), String> {
    let shown = shown.display().to_string();
    let text = fs::read_to_string(path).map_err(|error| error.to_string())?;
    let problem = Problem::parse(&shown, &text).map_err(|messages: Diagnostics| messages.render())?;
    if path.file_stem().is_none_or(|stem| stem != problem.name.as_str()) {
        return Err(format!("the file states the problem `{0}`: name it `{0}.rs`", problem.name));
    }
    let name = format!("{}.template.toml", problem.name);
    let own = templates.map(|folder| folder.join(name)).filter(|own| own.exists());
    let template_path = own.unwrap_or_else(|| path.with_extension("template.toml"));
    println!("cargo:rerun-if-changed={}", template_path.display());
    let file = match fs::read_to_string(&template_path) {
        Ok(text) => TemplateFile::parse(&text, &problem.unknowns).map_err(|error| stale(&error.into(), &shown))?,
        Err(error) if error.kind() == io::ErrorKind::NotFound => without_template(&problem, &shown)?,
        Err(error) => return Err(format!("{}: {error}", template_path.display())),
    };
    let source = generate(&problem, &file).map_err(|error| stale(&error, &shown))?;
    Ok((problem.name, source))
}

/// The message of an error; if the template is at fault, with the command that finds another.
fn stale(error: &GenerateError, shown: &str) -> String {
    match error.is_stale_template() {
        true => format!("{error}\nhelp: search a template for the problem as it is now: `eliminant search {shown}`"),
        false => error.to_string(),
    }
}

/// A missing template is an error: a build script without the search cannot find one.
#[cfg(not(feature = "search"))]
fn without_template(_: &Problem, shown: &str) -> Result<TemplateFile, String> {
    Err(format!(
        "there is no template file beside the problem\n\
         help: search one and keep it: `eliminant search {shown}`\n\
         help: a build script searches itself with the feature `search` of eliminant-generator"
    ))
}

/// A missing template is found by a bounded search, with a warning that says how to keep the
/// result.
#[cfg(feature = "search")]
fn without_template(problem: &Problem, shown: &str) -> Result<TemplateFile, String> {
    use crate::search::{SearchError, SearchOptions, candidates};
    println!(
        "cargo:warning={shown} has no template file: searching at every change. Keep one: `eliminant search {shown}`"
    );
    let algebra = crate::check::check(problem).map_err(|messages| messages.render())?;
    let options = SearchOptions::for_a_build();
    let monitor = crate::search::monitor::Unmonitored;
    let found = candidates(problem, &algebra, &options, &monitor).map_err(|error: SearchError| {
        format!("{error}\nhelp: search longer than a build should: `eliminant search {shown}`")
    })?;
    let best = found.candidates.first().ok_or_else(|| "the search found no template".to_owned())?;
    Ok(best.to_file(problem, &options))
}

/// Writes a file through a temporary one, and only if the content differs: an unchanged file keeps
/// its time.
///
/// # Errors
/// Errors of the file system; the old file is then untouched.
pub fn write_if_changed(path: &Path, content: &str) -> io::Result<()> {
    if fs::read_to_string(path).is_ok_and(|old| old == content) {
        return Ok(());
    }
    let mut temporary = path.as_os_str().to_owned();
    temporary.push(".tmp");
    fs::write(&temporary, content).and_then(|()| fs::rename(&temporary, path)).inspect_err(|_| {
        // The temporary file is of no use any more; the error to report is the first one.
        let _ = fs::remove_file(&temporary);
    })
}
