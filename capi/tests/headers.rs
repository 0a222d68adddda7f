//! The committed headers are those of all problems, and agree with the codes of the library.

use std::path::{Path, PathBuf};
use std::{env, fs};

use eliminant_capi_generator::{cpp_header, header, interfaces};
use eliminant_capi_runtime::Code;
use eliminant_templates::FOLDER;

const UPDATE: &str = "UPDATE_GOLDEN=1 cargo test --manifest-path capi/Cargo.toml --test headers";

fn committed(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("include").join(name)
}

/// Compares with the committed file, or writes it on request.
fn compare(name: &str, text: &str) {
    let path = committed(name);
    let old = fs::read_to_string(&path).unwrap_or_default();
    if old == text {
        return;
    }
    match env::var_os("UPDATE_GOLDEN") {
        Some(_) => fs::write(&path, text).expect("written"),
        None => panic!("include/{name} is not that of the problems as they are: {UPDATE}"),
    }
}

#[test]
fn committed_headers_are_those_of_all_problems() {
    let interfaces = interfaces(Path::new(FOLDER), |_| true).expect("problems and templates are committed");
    assert!(interfaces.len() > 40, "{} problems", interfaces.len());
    compare("eliminant.h", &header("eliminant", &interfaces));
    compare("eliminant.hpp", &cpp_header("eliminant", &interfaces));
}

#[test]
fn headers_of_the_library_declare_a_part_of_the_committed_ones() {
    for (name, text) in eliminant_c::HEADERS {
        let all = fs::read_to_string(committed(name)).expect("committed");
        let missing: Vec<&str> = text.lines().filter(|line| !all.contains(line)).collect();
        assert!(missing.is_empty(), "{name}: {missing:#?}");
    }
}

/// `NonFiniteInput` as a macro.
fn macro_name(code: Code) -> String {
    let camel = format!("{code:?}");
    let words = camel.chars().enumerate().map(|(at, c)| match c.is_uppercase() && at > 0 {
        true => format!("_{c}"),
        false => c.to_ascii_uppercase().to_string(),
    });
    format!("ELIMINANT_{}", words.collect::<String>())
}

#[test]
fn codes_of_the_header_are_those_of_the_library() {
    let text = fs::read_to_string(committed("eliminant.h")).expect("committed");
    for code in Code::ALL {
        let line = format!("#define {} {}\n", macro_name(code), code.number());
        assert!(text.contains(&line), "{line}");
    }
    let version = format!("#define ELIMINANT_VERSION \"{}\"", env!("CARGO_PKG_VERSION"));
    assert!(text.contains(&version), "{version}");
}
