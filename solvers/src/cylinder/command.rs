//! The command line of the example `triangulate`, as a function: arguments in, exit code and text out.

use std::ffi::OsString;
use std::path::Path;

use super::input::read_scene;
use super::report::Report;
use super::triangulate::triangulate;

const USAGE: &str = "\
Triangulates a cylinder from its silhouette lines in several views.

usage: triangulate [--json] FILE

  FILE     scene: cameras and lines, JSON (see the module `cylinder::input`)
  --json   write the result as JSON
  --help   write this text

exit code: 0 done, 1 the scene is at fault, 2 wrong usage
";

/// What a run wants written, and its exit code.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct Outcome {
    /// 0 done, 1 the scene is at fault, 2 wrong usage.
    pub code: u8,
    /// For standard output.
    pub output: String,
    /// For standard error.
    pub error: String,
}

impl Outcome {
    fn done(output: String) -> Self {
        Self { code: 0, output, error: String::new() }
    }

    fn failed(code: u8, error: String) -> Self {
        Self { code, output: String::new(), error }
    }
}

/// Runs the command with its arguments, the program's name not among them. Reads the file and writes nothing.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> Outcome {
    let usage = |problem: String| Outcome::failed(2, format!("error: {problem}\n\n{USAGE}"));
    let mut json = false;
    let mut files = Vec::new();
    for argument in arguments {
        match argument.to_str() {
            Some("--json") => json = true,
            Some("--help" | "-h") => return Outcome::done(USAGE.to_owned()),
            Some(option) if option.starts_with('-') => return usage(format!("unknown option `{option}`")),
            _ => files.push(argument),
        }
    }
    match files.as_slice() {
        [file] => run_file(Path::new(file), json),
        [] => usage("no FILE given".to_owned()),
        files => usage(format!("{} files given, one expected", files.len())),
    }
}

fn run_file(path: &Path, json: bool) -> Outcome {
    let scene = match read_scene(path) {
        Ok(scene) => scene,
        Err(error) => return Outcome::failed(1, format!("error: {error}\n")),
    };
    match triangulate(&scene.views) {
        Ok(result) => {
            let report = Report::new(&result, &scene.points);
            Outcome::done(if json { report.json() } else { report.text() })
        }
        Err(error) => Outcome::failed(1, format!("error: {}: {error}\n", path.display())),
    }
}
