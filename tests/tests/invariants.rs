//! What must not be there: dependencies between the wrong crates, input and output in the middle of the pipeline, words in
//! code that must neither allocate nor panic.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use eliminant_generator::generate::generate;
use eliminant_tests::cases;

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The names of all crates that a crate depends on, however indirectly, by cargo's own account.
fn dependencies(manifest: &str, edges: &str, features: &[&str]) -> Vec<String> {
    let output = Command::new(env!("CARGO"))
        .args(["tree", "--locked", "--prefix", "none", "--format", "{p}", "--edges", edges])
        .args(features)
        .arg("--manifest-path")
        .arg(root().join(manifest))
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    let mut names: Vec<String> =
        text.lines().skip(1).filter_map(|line| line.split(' ').next()).map(str::to_owned).collect();
    names.sort();
    names.dedup();
    names
}

/// Asserts that none of the dependencies is forbidden.
fn assert_none(names: &[String], forbidden: &[&str], of: &str) {
    let found: Vec<&String> = names.iter().filter(|name| forbidden.contains(&name.as_str())).collect();
    assert!(found.is_empty(), "{of} depends on {found:?}");
}

#[test]
fn crates_depend_in_one_direction() {
    let all = "normal,build,dev";
    let generator = dependencies("generator/Cargo.toml", all, &["--all-features"]);
    assert!(generator.iter().any(|name| name == "syn"), "{generator:?}");
    assert_none(&generator, &["eliminant", "eliminant-solvers", "eliminant-tests"], "the generator");

    let runtime = dependencies("runtime/Cargo.toml", all, &["--all-features"]);
    assert!(runtime.iter().any(|name| name == "arrayvec"), "{runtime:?}");
    assert_none(&runtime, &["eliminant-generator", "eliminant-solvers", "eliminant-tests"], "the runtime");

    let solvers = dependencies("solvers/Cargo.toml", "normal", &["--all-features"]);
    assert!(solvers.iter().any(|name| name == "eliminant"), "{solvers:?}");
    assert_none(&solvers, &["eliminant-generator", "groebner", "eliminant-tests"], "the solvers' code");
}

/// What only the search and the command need.
const SEARCH_ONLY: [&str; 7] = ["rayon", "nalgebra", "qd", "clap", "ctrlc", "indicatif", "serde_json"];

#[test]
fn a_build_script_does_not_pay_for_the_search() {
    let command = dependencies("generator/Cargo.toml", "normal", &[]);
    for name in SEARCH_ONLY {
        assert!(command.iter().any(|found| found == name), "the command does not depend on {name}");
    }
    let user = dependencies("examples/own-problem/Cargo.toml", "normal,build", &[]);
    assert!(user.iter().any(|name| name == "eliminant-generator"), "{user:?}");
    assert_none(&user, &SEARCH_ONLY, "a user's build");
}

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files.sort();
    files
}

/// The identifiers of code: comments are skipped, and everything from a line `#[cfg(test)]` on.
fn identifiers(code: &str) -> Vec<(usize, String)> {
    let lines = code.lines().enumerate().take_while(|(_, line)| line.trim() != "#[cfg(test)]");
    lines
        .flat_map(|(number, line)| {
            let code = line.split("//").next().unwrap_or_default();
            let words = code.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty());
            words.map(move |word| (number + 1, word.to_owned())).collect::<Vec<_>>()
        })
        .collect()
}

/// The places where one of the words stands in the code.
fn places(name: &str, code: &str, words: &[&str]) -> Vec<String> {
    let found = identifiers(code).into_iter().filter(|(_, word)| words.contains(&word.as_str()));
    found.map(|(line, word)| format!("{name}:{line}: {word}")).collect()
}

/// Words of allocation, panic and undefined behaviour.
const HEAVY: [&str; 17] = [
    "unwrap",
    "expect",
    "panic",
    "todo",
    "unimplemented",
    "unreachable",
    "unwrap_unchecked",
    "Vec",
    "vec",
    "Box",
    "String",
    "format",
    "to_vec",
    "to_owned",
    "alloc",
    "Rc",
    "unsafe",
];

#[test]
fn the_runtime_neither_allocates_nor_panics() {
    let files = rust_files(&root().join("runtime/src"));
    assert!(files.len() > 10, "{files:?}");
    let read = |path: &PathBuf| fs::read_to_string(path).expect("UTF-8");
    let found: Vec<String> =
        files.iter().flat_map(|path| places(&path.display().to_string(), &read(path), &HEAVY)).collect();
    assert!(found.is_empty(), "{found:#?}");
    assert!(read(&root().join("runtime/src/lib.rs")).contains("#![no_std]"));
}

#[test]
fn emitted_solvers_neither_allocate_nor_panic() {
    for case in cases() {
        let source = generate(&case.problem(), &case.template()).expect("a solver");
        assert!(identifiers(&source).iter().any(|(_, word)| word == "solve_complex"), "{source}");
        let found = places(case.name, &source, &[&HEAVY[..], &["assert", "std"]].concat());
        assert!(found.is_empty(), "{found:#?}");
    }
}

/// Where the generator may touch files, the environment and the clock.
const RIM: [&str; 3] = ["build.rs", "main.rs", "command"];

#[test]
fn only_the_rim_of_the_generator_does_input_and_output() {
    let source = root().join("generator/src");
    let mut inner = 0;
    for path in rust_files(&source) {
        let relative = path.strip_prefix(&source).expect("inside");
        if RIM.iter().any(|rim| relative.starts_with(rim)) {
            continue;
        }
        inner += 1;
        let code = fs::read_to_string(&path).expect("UTF-8");
        let words =
            ["fs", "Instant", "SystemTime", "var_os", "args_os", "println", "eprintln", "stdout", "stderr", "stdin"];
        let found = places(&relative.display().to_string(), &code, &words);
        assert!(found.is_empty(), "{found:#?}");
    }
    assert!(inner > 30, "{inner} files");
}

#[test]
fn code_is_told_from_comments_and_tests() {
    let code = "let a = b; // Vec\n/// Box\nArrayVec::x(vec![1]);\n#[cfg(test)]\nfn f() { g().unwrap() }\n";
    assert_eq!(places("x", code, &HEAVY), ["x:3: vec"]);
}
