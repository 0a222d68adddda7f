//! A build script without the feature `search`: `cargo test -p eliminant-generator
//! --no-default-features --test without_search`.
#![cfg(not(feature = "search"))]

use std::fs;
use std::path::{Path, PathBuf};

use eliminant_generator::Generator;

const TEMPLATES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../templates");

/// A folder with one problem, and one for the solver.
fn project(name: &str, files: &[&str]) -> (PathBuf, PathBuf) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let (problems, out) = (folder.join("problems"), folder.join("out"));
    // Left by an earlier run.
    let _ = fs::remove_dir_all(&folder);
    [&problems, &out].into_iter().for_each(|folder| fs::create_dir_all(folder).expect("a folder"));
    for file in files {
        fs::copy(Path::new(TEMPLATES).join(file), problems.join(file)).expect("a committed file");
    }
    (problems, out)
}

#[test]
fn a_missing_template_stops_the_build_and_names_the_command() {
    let (problems, out) = project("missing", &["two_conics.rs"]);
    let error = Generator::new().problems(&problems).out_dir(&out).run().expect_err("there is no template");
    let message = error.to_string();
    for word in ["two_conics.rs", "eliminant search ", "feature `search`"] {
        assert!(message.contains(word), "`{word}` is missing in\n{message}");
    }
    assert!(!out.join("two_conics.rs").exists());
}

#[test]
fn a_template_is_verified_and_emitted() {
    let (problems, out) = project("present", &["two_conics.rs", "two_conics.template.toml"]);
    Generator::new().problems(&problems).out_dir(&out).run().expect("a good project");
    assert!(fs::read_to_string(out.join("two_conics.rs")).expect("emitted").contains("pub mod two_conics"));
}

#[test]
fn a_wrong_number_of_solutions_stops_the_build() {
    let (problems, out) = project("miscounted", &["two_conics.rs", "two_conics.template.toml"]);
    let path = problems.join("two_conics.template.toml");
    let text = fs::read_to_string(&path).expect("a committed file");
    fs::write(&path, text.replace("solutions = 4\n", "solutions = 3\n")).expect("a file to write");
    let error = Generator::new().problems(&problems).out_dir(&out).run().expect_err("there are 4 solutions");
    let message = error.to_string();
    for words in ["the template file says 3 solutions, the template gives 4", "eliminant search "] {
        assert!(message.contains(words), "`{words}` is missing in\n{message}");
    }
    assert!(!out.join("two_conics.rs").exists());
}
