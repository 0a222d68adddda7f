//! What a build script can ask for beside a folder: some problems only, templates of its own, an
//! index of the solvers.

use std::fs;
use std::path::Path;

use eliminant_generator::{BuildError, Generator};
use eliminant_tests::templates_folder;
use tempfile::TempDir;

fn out() -> TempDir {
    tempfile::tempdir().expect("a folder")
}

/// Runs a build script over the committed problems; the error as cargo shows it.
fn run(generator: Generator, out: &Path) -> Result<(), String> {
    generator.problems(templates_folder()).out_dir(out).run().map_err(|error: BuildError| format!("{error:?}"))
}

fn written(out: &Path) -> Vec<String> {
    let entries = fs::read_dir(out).expect("the folder");
    let mut names: Vec<String> =
        entries.map(|entry| entry.expect("an entry").file_name().into_string().expect("UTF-8")).collect();
    names.sort();
    names
}

fn read(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).expect("a file")
}

#[test]
fn only_the_named_problems_are_emitted() {
    let out = out();
    run(Generator::new().only(["two_conics", "circle_minimal"]), out.path()).expect("good problems");
    assert_eq!(written(out.path()), ["circle_minimal.rs", "two_conics.rs"]);
}

#[test]
fn no_problem_may_be_asked_for() {
    let out = out();
    run(Generator::new().only([""; 0]).index("solvers"), out.path()).expect("nothing to do");
    assert_eq!(written(out.path()), ["solvers.rs"]);
    assert!(read(out.path(), "solvers.rs").lines().all(|line| line.starts_with("//")));
}

#[test]
fn a_name_that_is_none_is_refused() {
    for name in ["two_circles", "", "two_conics.rs", "../templates/two_conics"] {
        let out = out();
        let message = run(Generator::new().only(["two_conics", name]), out.path()).expect_err("no such problem");
        assert!(message.contains(&format!("`{name}.rs`")), "{message}");
        assert_eq!(written(out.path()), [""; 0]);
    }
}

#[test]
fn the_index_includes_what_was_emitted() {
    let out = out();
    run(Generator::new().only(["two_conics", "circle_minimal"]).index("solvers"), out.path()).expect("good problems");
    let index = read(out.path(), "solvers.rs");
    let lines: Vec<&str> = index.lines().filter(|line| !line.starts_with("//")).collect();
    assert_eq!(lines, ["include!(\"circle_minimal.rs\");", "include!(\"two_conics.rs\");"]);
}

#[test]
fn the_index_cannot_have_the_name_of_a_problem() {
    let out = out();
    let message =
        run(Generator::new().only(["two_conics"]).index("two_conics"), out.path()).expect_err("two files of one name");
    assert!(message.contains("`two_conics`") && message.contains("index"), "{message}");
    assert!(read(out.path(), "two_conics.rs").contains("pub mod two_conics"));
}

/// The same template with other notes makes the same solver; one that does not hold stops the
/// build; others are not read.
#[test]
fn templates_of_another_folder_go_first() {
    let (out, own) = (out(), tempfile::tempdir().expect("a folder"));
    let generator = || Generator::new().only(["two_conics", "circle_minimal"]).templates(own.path());
    run(generator(), out.path()).expect("no template of its own");
    let committed = read(out.path(), "two_conics.rs");
    let text = read(&templates_folder(), "two_conics.template.toml");
    let swapped = text.replacen("action = \"", "action = \"y*", 1);
    assert_ne!(swapped, text);
    fs::write(own.path().join("two_conics.template.toml"), swapped).expect("written");
    let message = run(generator(), out.path()).expect_err("the basis is not the one of another action");
    assert!(message.contains("does not hold") && message.contains("two_conics"), "{message}");
    fs::write(own.path().join("two_conics.template.toml"), text).expect("written");
    run(generator(), out.path()).expect("a good template");
    assert_eq!(read(out.path(), "two_conics.rs"), committed);
}

#[test]
fn a_folder_of_templates_that_is_missing_is_an_error() {
    let out = out();
    let missing = out.path().join("missing");
    let message =
        run(Generator::new().only(["two_conics"]).templates(&missing), out.path()).expect_err("no such folder");
    assert!(message.contains("missing"), "{message}");
}
