//! What the command prints for people fits a terminal of 100 columns.
#![cfg(feature = "command")]

use std::process::Command;

const COLUMNS: usize = 100;
const TEMPLATES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../templates");

/// Lines that are too long in what a command prints.
fn long_lines(arguments: &[&str]) -> Vec<String> {
    let output = Command::new(env!("CARGO_BIN_EXE_eliminant")).args(arguments).output().expect("it runs");
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    assert!(text.lines().count() > 5, "{arguments:?}: {text}");
    text.lines().filter(|line| line.chars().count() > COLUMNS).map(str::to_owned).collect()
}

#[test]
fn help_and_reports_fit() {
    let found = concat!(env!("CARGO_TARGET_TMPDIR"), "/report_width.template.toml");
    let conics = format!("{TEMPLATES}/two_conics.rs");
    // Many unknowns with long names, and long lists of monomials.
    let (long, other) = (format!("{TEMPLATES}/relpose_7pt_focal_radial.rs"), format!("{TEMPLATES}/relpose_5pt.rs"));
    let interpreted = ["--interpreted", "--trials", "8"];
    let mut calls: Vec<Vec<&str>> = vec![vec!["--help"], vec!["check", &long], vec!["inspect", &other]];
    calls.extend(["new", "check", "search", "emit", "inspect", "stability", "bench"].map(|name| vec![name, "--help"]));
    calls.push([&["stability", &other][..], &interpreted].concat());
    calls.push([&["stability", &other, &conics][..], &interpreted].concat());
    calls.push(vec!["search", &other, "--trials", "50", "--confirm", "100", "--out", found]);
    for call in calls {
        assert_eq!(long_lines(&call), Vec::<String>::new(), "{call:?}");
    }
}
