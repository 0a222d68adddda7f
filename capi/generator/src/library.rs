//! The API of build scripts: all problems of a folder become a C library in `OUT_DIR`.

use std::path::{Path, PathBuf};
use std::{env, error, fmt, fs, io};

use eliminant_generator::build::write_if_changed;
use eliminant_generator::problem::Problem;
use eliminant_generator::template::file::TemplateFile;
use eliminant_generator::{BuildError, Generator};

use crate::header::constants;
use crate::interface::{Interface, Row};
use crate::names::is_prefix;
use crate::{cpp_header, functions, header};

/// Classes of the C++ header, which a result of the same name would hide.
const CLASSES: [&str; 8] = ["Error", "Span", "Many", "Values", "Solutions", "Result", "Batch", "SecondAttempts"];

/// Emits solvers and C functions for every problem of a folder.
///
/// `problems/NAME.rs` and its template `problems/NAME.template.toml` become the functions
/// `PREFIX_NAME_solve`, `PREFIX_NAME_solve_with`, `PREFIX_NAME_solve_batch`, for a problem that
/// returns a struct `Pose` the same with `_for_pose` behind, and functions that measure solutions
/// and compute means. In the library,
/// `eliminant::include_solver!("PREFIX")` includes them with the solvers, and `HEADERS`, the texts
/// of `PREFIX.h` and `PREFIX.hpp`.
#[derive(Clone, Debug)]
pub struct Library {
    prefix: String,
    problems: PathBuf,
    only: Option<Vec<String>>,
}

impl Library {
    /// A library whose functions have this prefix, and its problems in the folder `problems`.
    pub fn new(prefix: impl Into<String>) -> Self {
        Self { prefix: prefix.into(), problems: "problems".into(), only: None }
    }

    /// Sets the folder with problems and templates, relative to the crate's manifest.
    #[must_use]
    pub fn problems(mut self, folder: impl Into<PathBuf>) -> Self {
        self.problems = folder.into();
        self
    }

    /// Only the problems of these names, not all of the folder.
    #[must_use]
    pub fn only(mut self, names: impl IntoIterator<Item = impl Into<String>>) -> Self {
        self.only = Some(names.into_iter().map(Into::into).collect());
        self
    }

    /// Emits all files and tells cargo when to do so again.
    ///
    /// # Errors
    /// Those of the problems, of their templates and of files, and names that collide.
    pub fn run(self) -> Result<(), LibraryError> {
        let prefix = &self.prefix;
        if !is_prefix(prefix) {
            return Err(LibraryError::Names(format!("`{prefix}` cannot begin the names of C functions")));
        }
        let out_dir = env::var_os("OUT_DIR").map(PathBuf::from);
        let out_dir =
            out_dir.ok_or_else(|| LibraryError::Names("OUT_DIR is not set: this is for build scripts".into()))?;
        let solvers = format!("{prefix}_solvers");
        let generator = Generator::new().problems(&self.problems).index(&solvers);
        match &self.only {
            Some(only) => generator.only(only).run()?,
            None => generator.run()?,
        }
        let manifest = env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from).unwrap_or_default();
        let is_wanted = |name: &str| self.only.as_ref().is_none_or(|only| only.iter().any(|wanted| wanted == name));
        let interfaces = interfaces(&manifest.join(&self.problems), is_wanted)?;
        check_names(prefix, &interfaces)?;
        let solvers = fs::read_to_string(out_dir.join(format!("{solvers}.rs"))).map_err(LibraryError::File)?;
        let files = [
            ("rs", solvers + &functions::functions(prefix, &interfaces)),
            ("h", header(prefix, &interfaces)),
            ("hpp", cpp_header(prefix, &interfaces)),
        ];
        for (extension, text) in files {
            write_if_changed(&out_dir.join(format!("{prefix}.{extension}")), &text).map_err(LibraryError::File)?;
        }
        Ok(())
    }
}

/// The interfaces of the problems of a folder whose names are wanted, sorted by name. Each has its
/// template beside it.
///
/// # Errors
/// Those of the problems, of their templates and of files.
pub fn interfaces(folder: &Path, is_wanted: impl Fn(&str) -> bool) -> Result<Vec<Interface>, LibraryError> {
    let entries = fs::read_dir(folder).map_err(LibraryError::File)?;
    let mut files: Vec<PathBuf> =
        entries.map(|entry| entry.map(|entry| entry.path())).collect::<Result<_, _>>().map_err(LibraryError::File)?;
    files.retain(|file| {
        let name = file.file_name().and_then(|name| name.to_str()).and_then(|name| name.strip_suffix(".rs"));
        name.is_some_and(&is_wanted)
    });
    files.sort();
    files.iter().map(|file| interface(file)).collect()
}

fn interface(file: &Path) -> Result<Interface, LibraryError> {
    let text = fs::read_to_string(file).map_err(LibraryError::File)?;
    let problem = Problem::parse(&file.display().to_string(), &text)
        .map_err(|messages| LibraryError::Problem(messages.render()))?;
    let template = file.with_extension("template.toml");
    let of_template = |message: String| LibraryError::Problem(format!("{}: {message}", template.display()));
    let text = fs::read_to_string(&template).map_err(|error| of_template(error.to_string()))?;
    let template = TemplateFile::parse(&text, &problem.unknowns).map_err(|error| of_template(error.to_string()))?;
    Ok(Interface::new(&problem, template.solutions))
}

/// Whether all functions and macros have names of their own.
fn check_names(prefix: &str, interfaces: &[Interface]) -> Result<(), LibraryError> {
    let of_interface = |interface: &Interface| {
        let constants = constants(prefix, interface).into_iter().map(|(name, _)| name);
        interface.functions().into_iter().chain(constants).collect::<Vec<_>>()
    };
    let mut names: Vec<String> = interfaces.iter().flat_map(of_interface).collect();
    names.sort();
    if interfaces.iter().any(|interface| interface.name == prefix) {
        return Err(LibraryError::Names(format!("`{prefix}` is the name of a problem, and of the library")));
    }
    let hidden = |row: &&Row| CLASSES.contains(&row.name.as_str());
    if let Some(row) = interfaces.iter().flat_map(|interface| &interface.rows).find(hidden) {
        return Err(LibraryError::Names(format!(
            "`{}` is a class of the C++ header: name the result otherwise",
            row.name
        )));
    }
    match names.windows(2).find(|pair| pair[0] == pair[1]) {
        Some(pair) => Err(LibraryError::Names(format!("two problems give the name `{}`: rename one", pair[0]))),
        None => Ok(()),
    }
}

/// What stopped a build. A build script whose `main` returns it prints it as it is.
pub enum LibraryError {
    /// Solvers could not be emitted.
    Solvers(BuildError),
    /// A problem or a template could not be read.
    Problem(String),
    /// Names that C cannot tell apart, or has no place for.
    Names(String),
    /// An error of the file system.
    File(io::Error),
}

impl From<BuildError> for LibraryError {
    fn from(error: BuildError) -> Self {
        Self::Solvers(error)
    }
}

impl fmt::Display for LibraryError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Solvers(error) => write!(formatter, "{error}"),
            Self::Problem(message) | Self::Names(message) => write!(formatter, "{message}"),
            Self::File(error) => write!(formatter, "{error}"),
        }
    }
}

impl fmt::Debug for LibraryError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, formatter)
    }
}

impl error::Error for LibraryError {}

#[cfg(test)]
mod tests {
    use super::*;

    fn interface(name: &str, output: &str) -> Interface {
        let text = format!("fn {name}(a: f64) -> x {{ x * x == a; {output} {{ y: x }} }}");
        let problem = Problem::parse("test.rs", &text).unwrap_or_else(|messages| panic!("{}", messages.render()));
        Interface::new(&problem, 2)
    }

    #[test]
    fn names_that_collide_are_refused() {
        let message = |prefix, interfaces: &[Interface]| check_names(prefix, interfaces).err().map(|e| e.to_string());
        assert_eq!(message("own", &[interface("roots", "Pose"), interface("others", "Pose")]), None);
        let of_functions = message("own", &[interface("roots", "Pose"), interface("roots", "Pose")]);
        assert!(of_functions.is_some_and(|text| text.contains("two problems give the name")));
        let of_library = message("roots", &[interface("roots", "Pose")]);
        assert!(of_library.is_some_and(|text| text.contains("and of the library")));
        let of_class = message("own", &[interface("roots", "Batch")]);
        assert!(of_class.is_some_and(|text| text.contains("class of the C++ header")));
    }
}
