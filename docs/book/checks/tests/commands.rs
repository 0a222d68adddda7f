//! What needs the command `eliminant`: the tutorial, and the pictures. `docs/book/check` builds it,
//! and then runs these tests.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use eliminant_book_checks::{Mark, blocks, command, page, page_path, root};

/// An empty folder for a test, outside of all workspaces, as that of a reader.
fn fresh_folder(name: &str) -> PathBuf {
    let folder = env::temp_dir().join(format!("eliminant-book-{name}-{}", std::process::id()));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// Runs commands in a folder, where `eliminant` is the command; what they print.
fn run(commands: &str, folder: &Path) -> String {
    let bin = fs::canonicalize(command()).expect("the command is built: docs/book/check does it");
    let path = env::var("PATH").unwrap_or_default();
    let path = format!("{}:{path}", bin.parent().expect("a folder").display());
    let output = Command::new("bash")
        .args(["-euc", commands])
        .current_dir(folder)
        .env("PATH", path)
        .env_remove("CARGO_TARGET_DIR")
        .output()
        .expect("bash runs");
    let text = [&output.stdout[..], &output.stderr[..]].map(String::from_utf8_lossy).concat();
    assert!(output.status.success(), "{commands}\n{text}");
    text
}

#[test]
fn the_tutorial_does_what_it_says() {
    let folder = fresh_folder("tutorial");
    std::os::unix::fs::symlink(root().canonicalize().expect("the root"), folder.join("eliminant")).expect("a link");
    let own = folder.join("pose");
    fs::create_dir(&own).expect("a folder");
    // The versions that a crate with the same dependencies has committed.
    let lock = fs::read_to_string(root().join("examples/own-problem/Cargo.lock")).expect("committed");
    fs::write(own.join("Cargo.lock"), lock.replace("own-problem", "pose")).expect("written");
    let mut printed = String::new();
    for block in blocks(&page("tutorial.md")) {
        match block.mark {
            Mark::File(path) => {
                let path = own.join(path);
                fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
                fs::write(path, block.text).expect("written");
            }
            Mark::Run => {
                printed = run(&block.text, &own);
                println!("{}{printed}", block.text);
            }
            Mark::Output => {
                let mut lines = printed.lines();
                for line in block.text.lines() {
                    // A time differs from run to run.
                    assert!(
                        lines.any(|found| found == line),
                        "`{line}` is not printed, or not in this order:\n{printed}"
                    );
                }
            }
            Mark::None => {}
        }
    }
    fs::remove_dir_all(folder).expect("removed");
}

#[test]
fn pictures_are_those_of_the_templates() {
    let folder = fresh_folder("pictures");
    let committed = page_path("pictures");
    let mut count = 0;
    for entry in fs::read_dir(&committed).expect("pictures are committed") {
        let path = entry.expect("a file").path();
        let name = path.file_stem().and_then(|name| name.to_str()).expect("the name of a problem");
        run(&format!("eliminant inspect templates/{name}.rs --svg {}/{name}.svg", folder.display()), &root());
        let [old, new] = [&path, &folder.join(format!("{name}.svg"))].map(|file| fs::read(file).expect("readable"));
        let write = format!("eliminant inspect templates/{name}.rs --svg docs/book/src/pictures/{name}.svg");
        assert!(old == new, "the picture of {name} is not that of its template: {write}");
        count += 1;
    }
    assert!(count >= 3, "{count} pictures");
    fs::remove_dir_all(folder).expect("removed");
}

#[test]
fn commands_of_pages_run() {
    for name in ["choosing.md", "templates.md", "cylinders.md", "hidden-variables.md"] {
        let mut printed = String::new();
        for block in blocks(&page(name)) {
            match block.mark {
                Mark::Run => printed = run(&block.text, &root()),
                Mark::Output => {
                    let missing: Vec<&str> =
                        block.text.lines().filter(|line| !printed.lines().any(|found| found == *line)).collect();
                    assert!(missing.is_empty(), "{name}: not printed: {missing:#?}\n{printed}");
                }
                _ => {}
            }
        }
    }
}
