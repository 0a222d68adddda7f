//! The shape of the source: files without circles of imports, and functions and files of a size
//! that can be read. There is no list of exceptions.

use std::fs;
use std::path::PathBuf;

use eliminant_tests::source::{CrateSource, Imports, SourceFile, functions};

/// Lines of a file, comments and tests included.
const LINES_OF_A_FILE: usize = 520;
/// Lines of a function, from its signature to its closing brace.
const LINES_OF_A_FUNCTION: usize = 70;
/// Parameters of a function, besides `self`.
const PARAMETERS: usize = 5;

/// The crates of the workspace by the names of their folders.
fn crates() -> Vec<(String, CrateSource)> {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut folders: Vec<PathBuf> =
        fs::read_dir(&root).expect("the workspace").map(|e| e.expect("an entry").path()).collect();
    folders.retain(|folder| folder.join("Cargo.toml").exists() && folder.join("src").exists());
    folders.sort();
    let name = |folder: &PathBuf| folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
    folders.iter().map(|folder| (name(folder), CrateSource::read(&folder.join("src")))).collect()
}

/// What `check` finds in the files of all crates, with the path of each file before it.
fn offenders(check: impl Fn(&SourceFile) -> Vec<String>) -> Vec<String> {
    let crates = crates();
    let files: usize = crates.iter().map(|(_, source)| source.files.len()).sum();
    assert!(crates.len() >= 4 && files > 150, "{files} files of {} crates are all that was found", crates.len());
    let in_file = |name: &str, file: &SourceFile| -> Vec<String> {
        let path = format!("{name}/src/{}", file.path.display());
        check(file).into_iter().map(|found| format!("{path}{found}")).collect()
    };
    crates.iter().flat_map(|(name, source)| source.files.iter().flat_map(move |file| in_file(name, file))).collect()
}

/// Within each crate the files can be put in an order in which each imports only files before it.
#[test]
fn no_files_import_each_other_in_a_circle() {
    let mut circles = Vec::new();
    for (name, source) in crates() {
        let imports = Imports::of(&source);
        println!("{name}: {} files, {} imports", source.files.len(), imports.count());
        assert!(imports.count() + 2 > source.files.len() / 2, "{name}: imports are not found");
        circles.extend(imports.circles().into_iter().map(|circle| format!("{name}: {circle}")));
    }
    assert!(circles.is_empty(), "\n{}", circles.join("\n"));
}

#[test]
fn functions_are_short() {
    let long = offenders(|file| {
        let long = functions(&file.items).into_iter().filter(|function| function.lines > LINES_OF_A_FUNCTION);
        long.map(|f| format!(":{}: `{}` has {} lines", f.line, f.name, f.lines)).collect()
    });
    assert!(long.is_empty(), "functions of more than {LINES_OF_A_FUNCTION} lines:\n{}", long.join("\n"));
}

#[test]
fn functions_have_few_parameters() {
    let wide = offenders(|file| {
        let wide = functions(&file.items).into_iter().filter(|function| function.parameters > PARAMETERS);
        wide.map(|f| format!(":{}: `{}` has {} parameters", f.line, f.name, f.parameters)).collect()
    });
    assert!(wide.is_empty(), "functions of more than {PARAMETERS} parameters:\n{}", wide.join("\n"));
}

#[test]
fn files_are_short() {
    let long = offenders(|file| match file.lines {
        ..=LINES_OF_A_FILE => Vec::new(),
        lines => vec![format!(": {lines} lines")],
    });
    assert!(long.is_empty(), "files of more than {LINES_OF_A_FILE} lines:\n{}", long.join("\n"));
}
