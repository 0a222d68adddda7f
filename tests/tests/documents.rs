//! Prose rots where it names paths: every path that a document names exists. And prose is read: its
//! lines are short.

use std::fs;
use std::path::{Path, PathBuf};

const EXTENSIONS: [&str; 8] = [".rs", ".toml", ".md", ".json", ".svg", ".png", ".csv", ".lock"];
/// Folders that are not part of the project.
const SKIPPED: [&str; 3] = ["target", ".git", "node_modules"];
/// Words that stand for a name of the reader's own, as in `templates/NAME.rs`, and folders that
/// cargo makes.
const PLACEHOLDERS: [&str; 6] = ["NAME", "FILE", "FOLDER", "OUT_DIR", "target", "problems"];

fn root() -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    root.canonicalize().expect("the workspace")
}

/// All files of the project.
fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    let mut entries: Vec<PathBuf> =
        fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()).collect();
    entries.sort();
    for path in entries {
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        if path.is_dir() && !SKIPPED.contains(&name) {
            files(&path, found);
        } else if path.is_file() {
            found.push(path);
        }
    }
}

/// The spans in backticks outside of fenced blocks, and the targets of links and pictures.
fn references(text: &str) -> Vec<String> {
    let mut references = Vec::new();
    let mut fenced = false;
    for line in text.lines() {
        if line.trim_start().starts_with("```") {
            fenced = !fenced;
            continue;
        }
        if fenced {
            continue;
        }
        references.extend(line.split('`').skip(1).step_by(2).map(str::to_owned));
        for link in line.split("](").skip(1) {
            let target = link.split([')', '#', ' ']).next().unwrap_or_default();
            references.push(target.to_owned());
        }
    }
    references
}

/// Whether it reads as a path of the project: no command, address, formula or placeholder.
fn is_path(text: &str) -> bool {
    let plain = |c: char| c.is_ascii_alphanumeric() || "_-./".contains(c);
    if text.is_empty() || !text.chars().all(plain) || text.starts_with(['-', '/']) {
        return false;
    }
    let components: Vec<&str> = text.trim_end_matches('/').split('/').collect();
    let placeholder = |component: &&str| PLACEHOLDERS.contains(&component.split('.').next().unwrap_or_default());
    // `1/x` and `a/b` are formulas.
    let formula = components.iter().all(|component| component.len() < 2);
    let named_file = EXTENSIONS.iter().any(|extension| text.ends_with(extension) && text.len() > extension.len());
    (named_file || text.contains('/') && !formula) && !components.iter().any(placeholder)
}

/// Beside the document, or in any folder above it up to the root of the project; a bare name, whose
/// folder the sentence around it tells, anywhere.
fn exists(path: &str, document: &Path, root: &Path, files: &[PathBuf]) -> bool {
    if !path.contains('/') && files.iter().any(|file| file.file_name().is_some_and(|name| name == path)) {
        return true;
    }
    document.ancestors().skip(1).take_while(|folder| folder.starts_with(root)).any(|folder| folder.join(path).exists())
}

#[test]
fn paths_in_documents_exist() {
    let root = root();
    let mut all = Vec::new();
    files(&root, &mut all);
    let documents: Vec<&PathBuf> = all.iter().filter(|path| path.extension().is_some_and(|end| end == "md")).collect();
    let (mut checked, mut missing) = (0, Vec::new());
    for file in &documents {
        let text = fs::read_to_string(file).expect("UTF-8");
        for path in references(&text).iter().filter(|reference| is_path(reference)) {
            checked += 1;
            if !exists(path, file, &root, &all) {
                missing.push(format!("{}: {path}", file.strip_prefix(&root).expect("inside").display()));
            }
        }
    }
    println!("{checked} paths in {} documents", documents.len());
    assert!(missing.is_empty(), "{missing:#?}");
    assert!(checked > 0, "no document names a path");
}

/// The most characters of a line of prose.
const COLUMNS: usize = 100;

/// What begins a line of prose in a file: a comment, and anything in a document. Templates are
/// data.
fn start_of_prose(file: &Path) -> Option<&'static str> {
    let name = file.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    match file.extension().and_then(|end| end.to_str()) {
        Some("md") => Some(""),
        Some("rs") => Some("//"),
        Some("toml") if !name.ends_with(".template.toml") => Some("#"),
        None if file.parent().and_then(Path::file_name).is_some_and(|folder| folder == ".ci") => Some("#"),
        _ => None,
    }
}

/// The numbers of the lines of prose that are too long. Tables, code and markers of documents are
/// no prose. A line with an address cannot be broken.
fn long_lines(text: &str, start_of_prose: &str) -> Vec<usize> {
    let mut fenced = false;
    let mut is_prose = |line: &str| {
        let start = line.trim_start();
        fenced ^= start.starts_with("```");
        let is_other = start_of_prose.is_empty() && (fenced || start.starts_with(['|', '<']));
        start.starts_with(start_of_prose) && !is_other
    };
    let lines = text.lines().map(|line| is_prose(line) && line.chars().count() > COLUMNS && !line.contains("://"));
    lines.enumerate().filter(|(_, is_long)| *is_long).map(|(at, _)| at + 1).collect()
}

#[test]
fn lines_of_prose_are_short() {
    let root = root();
    let mut all = Vec::new();
    files(&root, &mut all);
    let (mut checked, mut long) = (0, Vec::new());
    for file in &all {
        let Some(start) = start_of_prose(file) else { continue };
        let text = fs::read_to_string(file).expect("UTF-8");
        let name = file.strip_prefix(&root).expect("inside").display();
        long.extend(long_lines(&text, start).iter().map(|line| format!("{name}:{line}")));
        checked += 1;
    }
    assert!(checked > 0, "no file was read");
    assert!(long.is_empty(), "over {COLUMNS} columns: {long:#?}");
}

#[test]
fn long_lines_are_found() {
    let (short, long) = ("x".repeat(COLUMNS - 3), "x".repeat(COLUMNS - 2));
    let rust = format!("// {short}\n    // {short}\nlet s = \"{long}{long}\";\n// {long}\n// https://{long}\n");
    assert_eq!(long_lines(&rust, "//"), [2, 4]);
    let text = format!("{short}\n\n{long} xxx\n| {long} xxx |\n```\n{long} xxx\n```\n{long} xxx\n");
    assert_eq!(long_lines(&text, ""), [3, 8]);
}

#[test]
fn paths_are_told_from_other_code() {
    for path in ["templates/two_conics.rs", "README.md", "generator/src", "solvers/", ".ci/run", "a/b.toml"] {
        assert!(is_path(path), "{path}");
    }
    for other in
        ["1/x", "cargo test", "x^2*y/z", "https://doc.rs/a", "--json", "f64", "templates/NAME.rs", ".rs", "/a/b"]
    {
        assert!(!is_path(other), "{other}");
    }
    assert_eq!(references("see `a/b` and [c](d/e#f)\n```\n`g/h`\n```\n"), ["a/b", "d/e"]);
}
