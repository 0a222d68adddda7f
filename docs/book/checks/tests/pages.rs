//! Pages that code can check without the command: gallery, examples of the language, links.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use eliminant_book_checks::{Mark, accuracy, blocks, comparison, file, gallery, page, page_path, reach, root};
use eliminant_generator::problem::Problem;

#[test]
fn the_gallery_is_fresh() {
    let fresh = gallery(&root()).expect("problems, templates, features and figures are committed");
    let write = "cargo run --manifest-path docs/book/checks/Cargo.toml --bin gallery";
    assert!(page("gallery.md") == fresh.page, "gallery.md is not that of the problems as they are: {write}");
    let files = fs::read_dir(page_path("gallery")).expect("pictures are committed");
    let pictures: BTreeMap<String, String> = files
        .map(|file| {
            let path = file.expect("a file").path();
            let name = path.file_name().expect("a name").to_string_lossy().into_owned();
            (name, fs::read_to_string(path).expect("a picture"))
        })
        .collect();
    assert!(pictures.keys().eq(fresh.pictures.keys()), "pictures of other problems: {write}");
    let stale: Vec<&String> = pictures.keys().filter(|name| pictures[*name] != fresh.pictures[*name]).collect();
    assert!(stale.is_empty(), "{stale:?} are not those of the problems as they are: {write}");
}

#[test]
fn the_comparison_is_fresh() {
    let fresh = comparison(&root()).expect("the page and templates/README.md are committed");
    let write = "cargo run --manifest-path docs/book/checks/Cargo.toml --bin gallery";
    assert!(page("comparison.md") == fresh, "comparison.md is not that of templates/README.md: {write}");
}

#[test]
fn tables_that_follow_from_others_are_fresh() {
    let write = "cargo run --manifest-path docs/book/checks/Cargo.toml --bin gallery";
    let pages = [
        ("accuracy.md", accuracy(&file("templates/README.md"), &page("accuracy.md"))),
        ("speed.md", reach(&file("README.md"), &page("speed.md"))),
    ];
    for (name, fresh) in pages {
        assert!(page(name) == fresh.expect("all tables are there"), "{name} is stale: {write}");
    }
}

/// The blocks of the language page that are problems.
fn problems() -> Vec<String> {
    let all = blocks(&page("language.md")).into_iter();
    all.filter(|block| block.language == "rust").map(|block| block.text).collect()
}

#[test]
fn examples_of_the_language_are_problems() {
    let problems = problems();
    assert!(problems.len() >= 10, "{} examples", problems.len());
    for text in problems {
        let parsed = Problem::parse("language.md", &text);
        assert!(parsed.is_ok(), "{}", parsed.err().map(|found| found.render()).unwrap_or_default());
    }
}

/// The names of the functions and of the attributes, as the generator's source lists them.
fn words_of_the_language() -> BTreeSet<String> {
    let source =
        |file: &str| fs::read_to_string(root().join("generator/src/problem").join(file)).expect("the source is there");
    let functions = source("functions.rs");
    let names = functions.split("BuiltIn { name: \"").skip(1).filter_map(|rest| rest.split('"').next());
    let mut words: BTreeSet<String> = names.map(|name| format!("{name}(")).collect();
    let signature = source("signature.rs");
    let (_, list) = signature.split_once("const ATTRIBUTES").expect("the list of attributes");
    let (list, _) = list.split_once("];").expect("its end");
    let attributes = list.split("(\"").skip(1).filter_map(|rest| rest.split('"').next());
    words.extend(attributes.map(|name| format!("#[{name}]")));
    words.extend(
        ["#[rank(", "#[projective]", "!= 0", "> 0", ".pow(", ".t()", "for ", "let mut", "const "].map(Into::into),
    );
    words
}

#[test]
fn examples_have_all_words_of_the_language() {
    let words = words_of_the_language();
    assert!(words.len() > 25, "{words:?}");
    let text = problems().concat();
    let missing: Vec<&String> = words.iter().filter(|word| !text.contains(word.as_str())).collect();
    assert!(missing.is_empty(), "no example of {missing:?}");
}

#[test]
fn the_summary_lists_all_pages() {
    let summary = page("SUMMARY.md");
    let files = fs::read_dir(page_path("")).expect("a folder").map(|file| file.expect("a file").file_name());
    let pages = files.filter_map(|name| name.to_str().filter(|name| name.ends_with(".md")).map(str::to_owned));
    for name in pages.filter(|name| name != "SUMMARY.md") {
        assert!(summary.contains(&format!("({name})")), "SUMMARY.md does not list {name}");
    }
}

/// How many draws RANSAC needs, to be 99 % certain that one has good data only.
#[test]
fn the_table_of_draws_is_right() {
    let page = page("minimal-problems.md");
    for good in [0.7f64, 0.5, 0.3] {
        let draws = |n| (0.01f64.ln() / (1.0 - good.powi(n)).ln()).ceil();
        let cells: Vec<String> = [2, 3, 5, 8].map(|n| draws(n).to_string()).into();
        let line = format!("| {:.0} % | {} |", 100.0 * good, cells.join(" | "));
        assert!(page.contains(&line), "{line}");
    }
}

#[test]
fn the_tutorial_has_files_and_commands() {
    let blocks = blocks(&page("tutorial.md"));
    let count = |is: fn(&Mark) -> bool| blocks.iter().filter(|block| is(&block.mark)).count();
    assert!(count(|mark| matches!(mark, Mark::File(_))) >= 4);
    assert!(count(|mark| *mark == Mark::Run) >= 4);
    assert!(count(|mark| *mark == Mark::Output) >= 2);
}
