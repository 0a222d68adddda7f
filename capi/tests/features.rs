//! The features are those of `eliminant-solvers`: the problems, and families of them.

use std::path::{Path, PathBuf};
use std::{env, fs};

const UPDATE: &str = "UPDATE_GOLDEN=1 cargo test --manifest-path capi/Cargo.toml --test features";

fn manifest(of: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(of).join("Cargo.toml")
}

/// What stands between two pieces of a text, which are part of the first and the last piece.
fn parts<'a>(text: &'a str, from: &str, to: &str) -> [&'a str; 3] {
    let start = text.find(from).unwrap_or_else(|| panic!("no `{from}`"));
    let end = start + text[start..].find(to).unwrap_or_else(|| panic!("no `{to}`"));
    [&text[..start], &text[start..end], &text[end..]]
}

#[test]
fn features_are_those_of_the_solvers() {
    let solvers = fs::read_to_string(manifest("../solvers")).expect("a manifest");
    let [_, families, _] = parts(&solvers, "# Pose of a camera", "\n# What follows is written by");
    let [_, problems, _] = parts(&solvers, "# problems:begin", "# problems:end");
    let own = fs::read_to_string(manifest(".")).expect("a manifest");
    let [before, listed, after] = parts(&own, "# families:begin\n", "# problems:end");
    let wanted = format!("# families:begin\n{families}# families:end\n{problems}");
    if listed == wanted {
        return;
    }
    match env::var_os("UPDATE_GOLDEN") {
        Some(_) => fs::write(manifest("."), [before, &wanted, after].concat()).expect("written"),
        None => panic!("capi/Cargo.toml has other features than solvers/Cargo.toml: {UPDATE}"),
    }
}
