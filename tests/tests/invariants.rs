//! What must not be there: dependencies between the wrong crates, input and output in the middle of
//! the pipeline, words in code that must neither allocate nor panic.

use std::path::PathBuf;
use std::process::Command;
use std::{env, fs};

use eliminant_generator::generate::generate;
use eliminant_tests::cases;
use eliminant_tests::source::{CrateSource, SourceFile, identifiers, rust_files, without_tests};
use syn::Item;

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
    assert_none(&generator, &["eliminant-solvers", "eliminant-tests"], "the generator");
    let of_build_scripts = dependencies("generator/Cargo.toml", "normal,build", &["--no-default-features"]);
    assert!(of_build_scripts.iter().any(|name| name == "syn"), "{of_build_scripts:?}");
    assert_none(&of_build_scripts, &["eliminant"], "the generator without the search");

    let runtime = dependencies("runtime/Cargo.toml", all, &["--all-features"]);
    assert!(runtime.iter().any(|name| name == "arrayvec"), "{runtime:?}");
    assert_none(&runtime, &["eliminant-generator", "eliminant-solvers", "eliminant-tests"], "the runtime");

    let solvers = dependencies("solvers/Cargo.toml", "normal", &["--all-features"]);
    assert!(solvers.iter().any(|name| name == "eliminant"), "{solvers:?}");
    assert_none(&solvers, &["eliminant-generator", "groebner", "eliminant-tests"], "the solvers' code");
}

/// What only the search and the command need.
const SEARCH_ONLY: [&str; 6] = ["rayon", "f256", "clap", "ctrlc", "indicatif", "serde_json"];

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

/// The places where one of the words stands in the code.
fn places(name: &str, items: &[Item], words: &[&str]) -> Vec<String> {
    let found = identifiers(items).into_iter().filter(|(_, word)| words.contains(&word.as_str()));
    found.map(|(line, word)| format!("{name}:{line}: {word}")).collect()
}

/// The code of a crate, without its tests.
fn code_of(krate: &str) -> Vec<SourceFile> {
    CrateSource::read(&root().join(krate).join("src")).files
}

/// Words of panic and undefined behaviour.
const PANIC: [&str; 8] =
    ["unwrap", "expect", "panic", "todo", "unimplemented", "unreachable", "unwrap_unchecked", "unsafe"];

/// Words of allocation.
const ALLOCATION: [&str; 9] = ["Vec", "vec", "Box", "String", "format", "to_vec", "to_owned", "alloc", "Rc"];

/// Words of matrices on the heap, in emitted solvers.
const ON_HEAP: [&str; 4] = ["OnHeap", "HeapRows", "memory", "eliminate_on_heap"];

/// The files of the runtime that allocate, all with the feature `alloc` only: sizes known at run
/// time, for interpreted plans; the memory of large solvers; and what follows solutions from other
/// data, where the template stands for nothing.
const ALLOCATING: [&str; 5] =
    ["dynamic_size.rs", "memory.rs", "continuation/member.rs", "continuation/path.rs", "continuation/track.rs"];

#[test]
fn the_runtime_does_not_panic_and_allocates_in_few_files() {
    let files = code_of("runtime");
    assert!(files.len() > 10, "{} files", files.len());
    let text = |name: &str| fs::read_to_string(root().join("runtime/src").join(name)).expect("UTF-8");
    assert!(text("lib.rs").contains("#[cfg(feature = \"alloc\")]\nmod dynamic_size;"));
    assert!(text("memory.rs").contains("#[cfg(feature = \"alloc\")]\nmod on_heap {"));
    for module in ["mod member;", "pub(crate) mod path;", "pub(crate) mod track;"] {
        assert!(text("continuation/mod.rs").contains(&format!("#[cfg(feature = \"alloc\")]\n{module}")), "{module}");
    }
    let allocates = |file: &SourceFile| ALLOCATING.iter().any(|name| file.path.ends_with(name));
    let words = |file: &SourceFile| if allocates(file) { PANIC.to_vec() } else { [&PANIC[..], &ALLOCATION].concat() };
    let found: Vec<String> =
        files.iter().flat_map(|file| places(&file.path.display().to_string(), &file.items, &words(file))).collect();
    assert!(found.is_empty(), "{found:#?}");
    assert_eq!(files.iter().filter(|file| allocates(file)).count(), ALLOCATING.len());
    assert!(text("lib.rs").contains("#![no_std]"));
}

/// No emitted solver panics. Only large ones have memory on the heap, and they take it from their
/// workspace.
#[test]
fn emitted_solvers_do_not_panic_and_small_ones_do_not_allocate() {
    let mut small = 0;
    for case in cases() {
        let source = generate(&case.problem(), &case.template()).expect("a solver");
        let items = syn::parse_file(&source).expect("emitted code is Rust").items;
        assert!(identifiers(&items).iter().any(|(_, word)| word == "solve_complex"), "{source}");
        let found = places(case.name, &items, &[&PANIC[..], &ALLOCATION, &["assert", "std"]].concat());
        assert!(found.is_empty(), "{found:#?}");
        let is_on_heap = case.planned().plan.is_on_heap();
        let on_heap = places(case.name, &items, &ON_HEAP);
        assert_eq!(on_heap.is_empty(), !is_on_heap, "{}: {on_heap:#?}", case.name);
        small += usize::from(!is_on_heap);
    }
    assert!(small > 20, "{small} solvers are small");
}

/// Where the generator may touch files, the environment and the clock.
const RIM: [&str; 3] = ["build.rs", "main.rs", "command"];

#[test]
fn only_the_rim_of_the_generator_does_input_and_output() {
    let mut inner = 0;
    for file in code_of("generator") {
        if RIM.iter().any(|rim| file.path.starts_with(rim)) {
            continue;
        }
        inner += 1;
        let words =
            ["fs", "Instant", "SystemTime", "var_os", "args_os", "println", "eprintln", "stdout", "stderr", "stdin"];
        let found = places(&file.path.display().to_string(), &file.items, &words);
        assert!(found.is_empty(), "{found:#?}");
    }
    assert!(inner > 30, "{inner} files");
}

/// A word behind the last line of any file is found: test modules end nothing.
#[test]
fn no_file_hides_code_from_these_tests() {
    for krate in ["runtime", "generator"] {
        for path in rust_files(&root().join(krate).join("src")) {
            let text = fs::read_to_string(&path).expect("UTF-8")
                + "
fn planted() {
    hidden().unwrap();
}
";
            let items = without_tests(syn::parse_file(&text).expect("Rust").items);
            let line = text.lines().count() - 1;
            assert!(places("x", &items, &["unwrap"]).contains(&format!("x:{line}: unwrap")), "{}", path.display());
        }
    }
}

#[test]
fn code_is_told_from_comments_and_tests() {
    let code = "use a::b; // Vec
/// Box
fn f() { ArrayVec::x(vec![1]); }
#[cfg(test)]
fn g() { h().unwrap() }
fn last() { Box }
";
    let items = without_tests(syn::parse_file(code).expect("Rust").items);
    assert_eq!(places("x", &items, &ALLOCATION), ["x:3: vec", "x:6: Box"]);
}
