//! Mistakes in problem files: `problem_errors/NAME.rs` holds one mistake (or a few), `NAME.txt`
//! what the user sees.

#![cfg(feature = "search")]

use std::fmt::Write as _;
use std::path::Path;
use std::{env, fs};

use eliminant_generator::check;
use eliminant_generator::problem::Problem;
use eliminant_generator::problem::diagnostic::Diagnostics;

const UPDATE: &str = "UPDATE_GOLDEN=1 cargo test -p eliminant-generator --test problem_errors";

/// What a user of the file gets from `eliminant check`.
fn check(path: &str, text: &str) -> Result<(), Diagnostics> {
    let problem = Problem::parse(path, text)?;
    check::check(&problem).map(|_| ())
}

#[test]
fn every_mistake_has_its_message() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/problem_errors");
    let mut names: Vec<String> = fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| name.ends_with(".rs"))
        .collect();
    names.sort();
    assert!(names.len() >= 20, "{} files in {}", names.len(), folder.display());

    let mut failures = String::new();
    for name in names {
        let text = fs::read_to_string(folder.join(&name)).unwrap();
        let message = match check(&name, &text) {
            Ok(_) => {
                writeln!(failures, "{name}: no mistake was found").unwrap();
                continue;
            }
            Err(diagnostics) => diagnostics.render() + "\n",
        };
        assert_eq!(check(&name, &text).unwrap_err().render() + "\n", message, "{name}: two runs differ");
        let golden = folder.join(&name).with_extension("txt");
        if env::var_os("UPDATE_GOLDEN").is_some() {
            fs::write(golden, message).unwrap();
        } else if fs::read_to_string(golden).ok().as_ref() != Some(&message) {
            writeln!(failures, "{name}: the message is now\n{message}").unwrap();
        }
    }
    assert!(failures.is_empty(), "{failures}\nIf these are better, accept them with\n    {UPDATE}");
}
