//! Emits the solvers of the problems that features enable.

use std::path::Path;
use std::{env, error, fs};

use eliminant_generator::Generator;
use eliminant_templates::FOLDER;

fn main() -> Result<(), Box<dyn error::Error>> {
    println!("cargo:rerun-if-changed=build.rs");
    let mut enabled = Vec::new();
    for entry in fs::read_dir(FOLDER)? {
        let path = entry?.path();
        enabled.extend(problem(&path).filter(|name| is_enabled(name)).map(str::to_owned));
    }
    Ok(Generator::new().problems(FOLDER).only(enabled).index("solvers").run()?)
}

/// The problem that a file states, where it is a problem file.
fn problem(path: &Path) -> Option<&str> {
    path.file_name()?.to_str()?.strip_suffix(".rs")
}

fn is_enabled(problem: &str) -> bool {
    env::var_os(format!("CARGO_FEATURE_{}", problem.to_uppercase())).is_some()
}
