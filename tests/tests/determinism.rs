//! The same problem, template and options give the same bytes, however often and on however many
//! threads.

use std::fs;

use eliminant_generator::Generator;
use eliminant_generator::check::check;
use eliminant_generator::generate::generate;
use eliminant_generator::search::monitor::Unmonitored;
use eliminant_generator::search::{SearchError, SearchOptions, candidates};
use eliminant_tests::{cases, templates_folder};
use rayon::ThreadPoolBuilder;

/// Problems with more solutions are not searched: that would take minutes.
const MOST_SOLUTIONS: usize = 12;

/// The stems of the files in `templates/` that end so.
fn stems(suffix: &str) -> Vec<String> {
    let entries = fs::read_dir(templates_folder()).expect("the folder with problems");
    let names = entries.map(|entry| entry.expect("an entry").file_name().into_string().expect("UTF-8"));
    let mut stems: Vec<String> = names.filter_map(|name| name.strip_suffix(suffix).map(str::to_owned)).collect();
    stems.sort();
    stems
}

#[test]
fn every_problem_has_a_template_and_a_case() {
    let solved: Vec<&str> = cases().iter().map(|case| case.name).collect();
    assert_eq!(stems(".rs"), solved);
    assert_eq!(stems(".template.toml"), solved);
}

/// A build script writes what `generate` returns, for every problem of the folder. Each solver is
/// emitted twice for it.
#[test]
fn the_build_script_writes_the_same_bytes() {
    let out = tempfile::tempdir().expect("a folder");
    Generator::new().problems(templates_folder()).out_dir(out.path()).run().expect("all templates hold");
    for case in cases() {
        let written = fs::read_to_string(out.path().join(format!("{}.rs", case.name))).expect("written");
        assert_eq!(written, generate(&case.problem(), &case.template()).expect("a solver"), "{}", case.name);
    }
    assert_eq!(fs::read_dir(out.path()).expect("the folder").count(), cases().len());
}

#[test]
fn template_files_survive_a_round_trip() {
    for case in cases() {
        let path = templates_folder().join(format!("{}.template.toml", case.name));
        let committed = fs::read_to_string(path).expect("a template file");
        let again = case.template().to_text(&case.problem().unknowns);
        // The notes at the end come in any order.
        let notes_sorted = |text: &str| {
            let (template, notes) = text.split_once("[provenance]").expect("notes");
            let mut notes: Vec<String> = notes.lines().map(str::to_owned).collect();
            notes.sort();
            (template.to_owned(), notes)
        };
        assert_eq!(notes_sorted(&again), notes_sorted(&committed), "{}", case.name);
    }
}

/// All templates that a search finds, in order, or why it finds none, with one thread and with
/// several.
#[test]
fn searches_repeat_themselves_on_any_number_of_threads() {
    let options = SearchOptions { max_columns: 100, shuffles: 1, ..SearchOptions::default() };
    let quick = cases().into_iter().filter(|case| case.template().solutions <= MOST_SOLUTIONS);
    for (case, threads) in quick.zip([2, 3].into_iter().cycle()) {
        let problem = case.problem();
        let algebra = check(&problem).expect("finitely many solutions");
        let search = |threads: usize| -> Result<Vec<String>, SearchError> {
            let pool = ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            let found = pool.install(|| candidates(&problem, &algebra, &options, &Unmonitored))?.candidates;
            Ok(found.iter().map(|c| c.to_file(&problem, &options).to_text(&problem.unknowns)).collect())
        };
        let one = search(1);
        println!("{}: {:?} templates", case.name, one.as_ref().map(Vec::len));
        assert_eq!(one, search(threads), "{}", case.name);
    }
}
