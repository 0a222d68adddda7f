//! The `eliminant` command, as people call it.
#![cfg(feature = "command")]

#[path = "support/shares.rs"]
mod shares;
mod support;

use std::fs;
use std::path::PathBuf;

use eliminant_generator::command::{Colour, run_in};
use eliminant_generator::search::choose::EQUAL_COST;
use serde_json::Value;
use shares::SHARES;
use support::{TWO_CONICS, eliminant, folder, json, names, status, stderr, stdout, two_conics};

/// A folder with `two_conics.rs` and its template.
fn searched(test: &str) -> PathBuf {
    let folder = two_conics(test);
    assert_eq!(status(&eliminant(&folder, &["search", "two_conics.rs", "--trials", "20"])), 0);
    folder
}

/// What every report on a template of two general conics holds.
fn check_summary(report: &Value) {
    assert_eq!(report["problem"], "two_conics");
    assert_eq!((&report["unknowns"], &report["equations"], &report["solutions"]), (&2.into(), &2.into(), &4.into()));
    let count = |key: &str| report[key].as_u64().unwrap_or_else(|| panic!("{key}: {report}"));
    assert!(count("basis") >= 4);
    assert_eq!(count("columns"), count("rows") + count("basis"));
    assert!(count("columns") <= 10);
    assert!(count("operations") > 0);
    assert_eq!(report["basis_monomials"].as_array().map(Vec::len), Some(count("basis") as usize));
    assert!(report["action"].as_str().is_some_and(|action| action.contains(['x', 'y'])));
    assert!(report["seconds"].as_f64().is_some_and(|seconds| seconds >= 0.0));
}

#[test]
fn from_a_new_problem_to_a_solver() {
    let folder = folder("from_a_new_problem_to_a_solver");
    assert_eq!(status(&eliminant(&folder, &["new", "my_conics"])), 0);
    let checked = eliminant(&folder, &["check", "my_conics.rs"]);
    assert_eq!(status(&checked), 0, "{}", stderr(&checked));
    assert!(stdout(&checked).contains("solutions  4"), "{}", stdout(&checked));
    assert_eq!(status(&eliminant(&folder, &["search", "my_conics.rs", "--trials", "20"])), 0);
    let emitted = eliminant(&folder, &["emit", "my_conics.rs", "--out", "solver.rs"]);
    assert_eq!(status(&emitted), 0, "{}", stderr(&emitted));
    let source = fs::read_to_string(folder.join("solver.rs")).unwrap();
    assert!(source.contains("pub mod my_conics") && syn::parse_file(&source).is_ok());
    assert_eq!(names(&folder), ["my_conics.rs", "my_conics.template.toml", "solver.rs"]);
}

#[test]
fn the_origin_takes_no_eigenvalue() {
    let folder = searched("the_origin_takes_no_eigenvalue");
    let text = "/// Conics through the origin.\nfn through_origin(p: [f64; 5], q: [f64; 5]) -> (x, y) {\n    \
                dot(p, [x * x, x * y, y * y, x, y]) == 0;\n    dot(q, [x * x, x * y, y * y, x, y]) == 0;\n}\n";
    fs::write(folder.join("through_origin.rs"), text).unwrap();
    let searched = eliminant(&folder, &["search", "through_origin.rs", "--trials", "20"]);
    assert!(stdout(&searched).contains("all unknowns 0 is one of the solutions"), "{}", stdout(&searched));
    let emitted = |problem: &str| stdout(&eliminant(&folder, &["emit", problem]));
    let said = ["- all unknowns 0 is a solution", "fn has_origin(&self) -> bool {"];
    let source = emitted("through_origin.rs");
    assert!(
        said.iter().all(|text| source.contains(text)) && source.contains("const MAX_SOLUTIONS: usize = 4;"),
        "{source}"
    );
    let source = emitted("two_conics.rs");
    assert!(!said.iter().any(|text| source.contains(text)), "{source}");
}

#[test]
fn solutions_that_share_all_values_are_told_apart() {
    let folder = folder("solutions_that_share_all_values_are_told_apart");
    fs::write(folder.join("shares.rs"), SHARES).unwrap();
    let checked = stdout(&eliminant(&folder, &["check", "shares.rs"]));
    let said = [
        "zeros      unknowns that are 0 together at a solution: x; x, y; x, z; y; y, z; z\n",
        "values     solutions share",
    ];
    assert!(said.iter().all(|text| checked.contains(text)), "{checked}");
    let searched = eliminant(&folder, &["search", "shares.rs", "--trials", "20"]);
    assert!(stdout(&searched).contains("form        a linear form stands in the place of"), "{}", stdout(&searched));
    let emitted = stdout(&eliminant(&folder, &["emit", "shares.rs"]));
    assert!(emitted.contains("stands for t in all monomials, where"), "{emitted}");
    let inspected = stdout(&eliminant(&folder, &["inspect", "shares.rs"]));
    assert!(inspected.contains("presolve    eliminates x\n"), "{inspected}");
}

#[test]
fn multiple_solutions_count_once() {
    let folder = folder("multiple_solutions_count_once");
    // A triple solution (2, -1) for all data, and a simple one.
    let text = "/// A conic that osculates another.\nfn osculating(a: f64) -> (x, y) {\n    x * x + y - 3 == 0;\n    a * (8 * x + y * y - 12) == 0;\n}\n";
    fs::write(folder.join("osculating.rs"), text).unwrap();
    let checked = eliminant(&folder, &["check", "osculating.rs"]);
    let expected = "solutions  2 different ones, 4 with multiplicity";
    assert!(stdout(&checked).contains(expected), "{}{}", stdout(&checked), stderr(&checked));
    // A template needs a basis for all four, and its solver looks for two.
    assert_eq!(status(&eliminant(&folder, &["search", "osculating.rs", "--trials", "20"])), 0);
    let file = fs::read_to_string(folder.join("osculating.template.toml")).unwrap();
    assert!(file.contains("\nsolutions = 2\n"), "{file}");
}

#[test]
fn new_overwrites_nothing_and_takes_good_names_only() {
    let folder = two_conics("new_overwrites_nothing_and_takes_good_names_only");
    let again = eliminant(&folder, &["new", "two_conics"]);
    assert_eq!(status(&again), 1);
    assert!(stderr(&again).contains("`./two_conics.rs` exists already"), "{}", stderr(&again));
    assert_eq!(fs::read_to_string(folder.join("two_conics.rs")).unwrap(), TWO_CONICS);
    for name in ["two conics", "3points", "fn", "Upper", "a/b", "../up", "", "gen"] {
        let output = eliminant(&folder, &["new", name]);
        assert_eq!(status(&output), 2, "{name}: {}", stderr(&output));
        assert!(stderr(&output).contains("NAME"), "{name}: {}", stderr(&output));
    }
    assert_eq!(status(&eliminant(&folder, &["new", "other", "--dir", "two_conics.rs"])), 1, "a file");
    assert_eq!(names(&folder), ["two_conics.rs"]);
    assert_eq!(status(&eliminant(&folder, &["new", "other", "--dir", "new/folder"])), 0);
    assert_eq!(names(&folder.join("new/folder")), ["other.rs"]);
    let report = json(&folder, &["new", "other"]);
    assert_eq!((&report["problem"], &report["file"]), (&"other".into(), &"./other.rs".into()));
}

#[test]
fn check_reports_what_can_be_eliminated() {
    let folder = folder("check_reports_what_can_be_eliminated");
    let text = "fn line_and_conic(p: [f64; 6], a: f64) -> (x, y, z) {
        dot(p, [x * x, x * z, z * z, x, z, 1]) == 0;
        y == x * x + 1;
        a * z == y + 2;
    }";
    fs::write(folder.join("line_and_conic.rs"), text).unwrap();
    let report = json(&folder, &["check", "line_and_conic.rs"]);
    assert_eq!(report["problem"], "line_and_conic");
    assert_eq!((&report["unknowns"], &report["equations"], &report["data"]), (&3.into(), &3.into(), &7.into()));
    // z = (x^2 + 3) / a in a conic: degree 4 in x.
    assert_eq!(report["solutions"], 4);
    assert_eq!(report["degrees"], serde_json::json!([2, 2, 1]));
    let forms = report["presolve"].as_array().unwrap();
    assert_eq!(forms.len(), 2, "{report}");
    assert_eq!((&forms[0]["kind"], forms[0]["kept"].as_array().unwrap().len()), (&"constant".into(), 2));
    assert_eq!((&forms[1]["kind"], &forms[1]["kept"]), (&"linear".into(), &serde_json::json!(["x"])));
    assert!(report["seconds"].is_f64());
}

#[test]
fn check_says_whether_a_scene_is_right() {
    let folder = folder("check_says_whether_a_scene_is_right");
    let scene_line = |name: &str, scene: &str| {
        let problem = "fn on_a_line(a: [f64; 2]) -> (#[projective] v: [f64; 2], s) {
            dot(a, v) == 0;
            s * s == dot(a, a);
            s > 0;
            Square { square: s * s }
        }";
        fs::write(folder.join(name), format!("{problem}\n{scene}")).unwrap();
        let output = eliminant(&folder, &["check", name]);
        assert_eq!(status(&output), 0, "{}", stderr(&output));
        let text = stdout(&output);
        text.lines().find_map(|line| line.strip_prefix("scene      ")).map(str::to_owned)
    };
    let of = |result: &str| {
        let returned = result.split([' ', '{']).next().unwrap();
        format!("#[scene]\nfn scene(a: [f64; 2]) -> (Data, {returned}) {{ (Data {{ a }}, {result}) }}")
    };
    assert_eq!(scene_line("without.rs", ""), None);
    let right = scene_line("right.rs", &of("Solution { v: [-3 * a[1], 3 * a[0]], s: norm(a) }")).unwrap();
    assert_eq!(right, "the solution of 200 drawn ones solves the equations");
    for (name, wrong) in [("first.rs", "v: [a[1], a[0]], s: norm(a)"), ("second.rs", "v: [-a[1], a[0]], s: -norm(a)")] {
        let wrong = scene_line(name, &of(&format!("Solution {{ {wrong} }}"))).unwrap();
        assert_eq!(wrong, "wrong: the solution of only 0 of 200 solves the equations");
    }
    let results = scene_line("results.rs", &of("Square { square: dot(a, a) }")).unwrap();
    assert!(results.starts_with("states results"), "{results}");
    let data = "#[scene]\nfn scene(a: [f64; 2]) -> Data { Data { a } }";
    assert!(scene_line("data.rs", data).unwrap().starts_with("states data alone"));
    let never = "#[scene]\nfn scene(a: [f64; 2]) -> Data { a[0] > 3; Data { a } }";
    assert!(scene_line("never.rs", never).unwrap().starts_with("only 0 of 200 could be drawn"));
}

#[test]
fn search_reports_and_writes_the_same_bytes_again() {
    let folder = two_conics("search_reports_and_writes_the_same_bytes_again");
    let report = json(&folder, &["search", "two_conics.rs", "--trials", "50"]);
    check_summary(&report);
    let candidates = report["candidates"].as_array().unwrap();
    let chosen = &candidates[report["chosen"].as_u64().unwrap() as usize];
    for key in ["rows", "columns", "basis", "action", "operations"] {
        assert_eq!(chosen[key], report[key], "{key}");
    }
    assert!(chosen["p99"].as_f64().is_some_and(|p99| p99 < -10.0));
    let path = folder.join("two_conics.template.toml");
    let first = fs::read_to_string(&path).unwrap();
    fs::remove_file(&path).unwrap();
    let output = eliminant(&folder, &["search", "two_conics.rs", "--trials", "50"]);
    assert_eq!(status(&output), 0, "{}", stderr(&output));
    assert_eq!(fs::read_to_string(&path).unwrap(), first);
    assert!(stdout(&output).contains("* chosen"), "{}", stdout(&output));
    assert!(stderr(&output).is_empty(), "progress is for terminals: {}", stderr(&output));
    // Elsewhere on request; the file beside the problem stays.
    assert_eq!(status(&eliminant(&folder, &["search", "two_conics.rs", "--trials", "50", "--out", "other.toml"])), 0);
    assert_eq!(fs::read_to_string(folder.join("other.toml")).unwrap(), first);
    assert_eq!(names(&folder), ["other.toml", "two_conics.rs", "two_conics.template.toml"]);
}

#[test]
fn search_prefers_what_it_is_told() {
    let folder = two_conics("search_prefers_what_it_is_told");
    let search = |prefer| json(&folder, &["search", "two_conics.rs", "--trials", "50", "--prefer", prefer]);
    let figure = |report: &Value, key: &str| report[key].as_u64().unwrap_or_else(|| panic!("{key}: {report}"));
    let (size, speed, stability) = (search("size"), search("speed"), search("stability"));
    assert!(figure(&size, "rows") < figure(&speed, "rows"), "{size} {speed}");
    assert!(figure(&speed, "operations") < figure(&size, "operations"), "{speed} {size}");
    let time = |report: &Value| report["nanoseconds"].as_f64().unwrap();
    let times = speed["candidates"].as_array().unwrap().iter().map(time);
    assert!(time(&speed) <= EQUAL_COST * times.fold(f64::INFINITY, f64::min) && time(&speed) > 0.0, "{speed}");
    assert!(figure(&stability, "operations") <= 2 * figure(&speed, "operations"), "{stability} {speed}");
    for prefer in ["size", "speed", "stability"] {
        let output = eliminant(&folder, &["search", "two_conics.rs", "--trials", "50", "--prefer", prefer]);
        let text = stdout(&output);
        let (first, _) = text.split_once("(* chosen").expect("the first table ends so");
        assert_eq!(first.lines().filter(|line| line.trim_start().starts_with('*')).count(), 1, "{prefer}: {text}");
    }
    for report in [size, speed, stability] {
        check_summary(&report);
        let candidates = report["candidates"].as_array().unwrap();
        let chosen = &candidates[figure(&report, "chosen") as usize];
        assert_eq!((&chosen["verdict"], &chosen["trials"]), (&"accepted".into(), &10_000.into()), "{report}");
        assert_eq!(report["warnings"], serde_json::json!([]), "{report}");
        // Nothing on the front is beaten in all that counts by anything measured on as many
        // instances.
        let front: Vec<&Value> = candidates.iter().filter(|candidate| candidate["pareto"] == true).collect();
        assert!(!front.is_empty());
        for (a, b) in front.iter().flat_map(|a| candidates.iter().map(move |b| (a, b))) {
            let less = |key: &str| figure(b, key) < figure(a, key);
            let p99 = |c: &Value| (10.0 * c["p99"].as_f64().unwrap()).round();
            assert!(!(less("rows") && time(b) < time(a) && p99(b) < p99(a)), "{a} {b}");
        }
    }
}

#[test]
fn a_problem_without_data_is_measured_on_its_one_instance() {
    let folder = folder("a_problem_without_data_is_measured_on_its_one_instance");
    fs::write(folder.join("plain.rs"), "fn plain() -> (x, y) { x * x + 2 * y == 7; y * y - x * y == 3; }").unwrap();
    let report = json(&folder, &["search", "plain.rs"]);
    let candidates = report["candidates"].as_array().unwrap();
    let chosen = &candidates[report["chosen"].as_u64().unwrap() as usize];
    assert_eq!((&chosen["verdict"], &chosen["trials"]), (&"accepted".into(), &1.into()), "{report}");
    assert!(candidates.iter().all(|candidate| candidate["trials"] == 1), "{report}");
}

#[test]
fn a_template_that_is_not_confirmed_comes_with_a_warning() {
    let folder = folder("a_template_that_is_not_confirmed_comes_with_a_warning");
    // Data are drawn from (-1, 1): where the leading coefficient is tiny a solution runs away.
    let problem = "fn steep(a: f64, b: f64) -> (x, y) { a.pow(12) * x * x + b * y + x == 1; x + y * y == b; }";
    fs::write(folder.join("steep.rs"), problem).unwrap();
    let report = json(&folder, &["search", "steep.rs", "--trials", "100", "--confirm", "1000"]);
    let candidates = report["candidates"].as_array().unwrap();
    let chosen = &candidates[report["chosen"].as_u64().unwrap() as usize];
    let warnings = report["warnings"].as_array().unwrap();
    assert_eq!(chosen["verdict"], "rejected", "{report}");
    assert!(warnings[0].as_str().is_some_and(|warning| warning.contains("lacks a solution on")), "{report}");
    assert!(folder.join("steep.template.toml").exists());
}

/// A scene that states something else than a solution costs every template all instances.
#[test]
fn a_scene_that_is_not_solved_is_told() {
    let folder = folder("a_scene_that_is_not_solved_is_told");
    let warnings = |root: &str| {
        let scene = format!(
            "#[scene]\nfn scene(root: f64) -> (Data, Solution) {{\n    \
             (Data {{ square: root * root }}, Solution {{ x: {root} }})\n}}"
        );
        let text = format!("fn root(square: f64) -> x {{ x * x == square; }}\n{scene}");
        fs::write(folder.join("root.rs"), text).unwrap();
        json(&folder, &["search", "root.rs", "--trials", "50"])["warnings"].to_string()
    };
    assert_eq!(warnings("-root"), "[]");
    let told = warnings("2 * root");
    assert!(told.contains("what the scene says is not found on 50 of 50 scenes"), "{told}");
}

#[test]
fn the_basis_can_be_bounded() {
    let folder = two_conics("the_basis_can_be_bounded");
    let basis = |options: &[&str]| {
        let report = json(&folder, &[&["search", "two_conics.rs", "--prefer", "size"][..], options].concat());
        let file = fs::read_to_string(folder.join("two_conics.template.toml")).unwrap();
        (report["basis"].as_u64().unwrap(), file.contains("max_basis = "))
    };
    assert_eq!(basis(&[]), (5, false));
    assert_eq!(basis(&["--max-basis", "4"]), (4, true));
    // There are four solutions.
    assert_eq!(basis(&["--max-basis", "3"]), (4, true));
}

#[test]
fn a_failing_search_leaves_the_old_template() {
    let folder = two_conics("a_failing_search_leaves_the_old_template");
    let template = folder.join("two_conics.template.toml");
    fs::write(&template, "old").unwrap();
    let limited = eliminant(&folder, &["search", "two_conics.rs", "--max-columns", "5"]);
    assert_eq!(status(&limited), 1);
    assert!(stderr(&limited).contains("within 5 columns"), "{}", stderr(&limited));
    let without_solution = "fn two_conics(a: f64) -> (x, y) { x + y == a; x + y == a + 1; }";
    fs::write(folder.join("two_conics.rs"), without_solution).unwrap();
    let failed = eliminant(&folder, &["search", "two_conics.rs"]);
    assert_eq!(status(&failed), 1);
    assert!(stderr(&failed).contains("two_conics.rs:1:"), "{}", stderr(&failed));
    assert_eq!(fs::read_to_string(&template).unwrap(), "old");
    assert_eq!(names(&folder), ["two_conics.rs", "two_conics.template.toml"]);
}

/// A folder with a template that a quick search found, and its text.
fn quickly_searched(test: &str, options: &[&str]) -> (PathBuf, String) {
    let folder = two_conics(test);
    let quick = ["search", "two_conics.rs", "--trials", "20", "--confirm", "1000"];
    assert_eq!(status(&eliminant(&folder, &[&quick[..], options].concat())), 0);
    let text = fs::read_to_string(folder.join("two_conics.template.toml")).unwrap();
    (folder, text)
}

const CHECK: [&str; 3] = ["search", "--check", "two_conics.rs"];

#[test]
fn a_search_that_is_repeated_by_its_record_writes_the_same() {
    let all = ["--prefer", "size", "--seed", "3", "--max-columns", "60", "--max-basis", "4", "--shuffles", "2"];
    for options in [&[][..], &["--prefer", "stability"], &all] {
        let (folder, text) = quickly_searched("a_search_that_is_repeated_by_its_record_writes_the_same", options);
        let checked = eliminant(&folder, &CHECK);
        assert_eq!(status(&checked), 0, "{options:?}: {}", stdout(&checked));
        assert!(stdout(&checked).starts_with("two_conics.rs: same\n1 template checked in "), "{}", stdout(&checked));
        assert_eq!(fs::read_to_string(folder.join("two_conics.template.toml")).unwrap(), text);
        // The version is recorded, and no reason to search anew.
        let version = concat!("generator = \"", env!("CARGO_PKG_VERSION"), "\"");
        assert!(text.contains(version), "{text}");
        fs::write(folder.join("two_conics.template.toml"), text.replace(version, "generator = \"0.0.0\"")).unwrap();
        let report = json(&folder, &CHECK);
        assert_eq!((&report["same"], &report["different"]), (&1.into(), &0.into()), "{report}");
        assert_eq!(report["files"][0]["found"], report["files"][0]["committed"], "{report}");
    }
}

/// What is done to a template file or its problem, and what `--check` must say.
#[test]
fn a_template_that_the_search_would_no_longer_write_is_told() {
    let (folder, text) = quickly_searched("a_template_that_the_search_would_no_longer_write_is_told", &[]);
    let template = folder.join("two_conics.template.toml");
    let said = |content: &str| {
        fs::write(&template, content).unwrap();
        let checked = eliminant(&folder, &CHECK);
        assert_eq!(status(&checked), 1, "{}", stdout(&checked));
        assert!(!stdout(&checked).contains(": same"), "{}", stdout(&checked));
        assert_eq!(fs::read_to_string(&template).unwrap(), content, "a check writes nothing");
        stdout(&checked)
    };
    let without = |key: &str| {
        text.lines().filter(|line| !line.starts_with(key)).fold(String::new(), |all, line| all + line + "\n")
    };
    for (content, expected) in [
        (without("trials ="), "lacks key trials"),
        (without("growth ="), "lacks key growth"),
        (format!("{text}deletion = \"HighestFirst\"\n"), "holds a key that nothing writes: deletion"),
        (format!("{text}nothing_within = \"9\"\n"), "holds a key that this search does not write: nothing_within"),
        (text.replace("seed = \"1\"", "seed = \"x\""), "records no search that can be repeated: invalid value 'x'"),
        (text.replace("operations = \"", "operations = \"1"), "differs: operations is committed as `1"),
        (text.replace("# Found by", "# Made by"), "differs: the same template and keys, written in another layout"),
        (text.replace("fingerprint = \"", "fingerprint = \"1\" # "), "differs: found for another version"),
        (format!("{text}ended_early = \"budget\"\n"), "ended early (budget)"),
        ("nothing".to_owned(), "two_conics.template.toml"),
    ] {
        assert_ne!(content, text, "{expected}");
        let report = said(&content);
        assert!(report.contains(expected), "{expected}: {report}");
    }
    // Fewer rows were preferred when this was found.
    let (_, small) =
        quickly_searched("a_template_that_the_search_would_no_longer_write_is_told", &["--prefer", "size"]);
    let size = |text: &str| {
        let value = |key: &str| text.lines().find_map(|line| line.strip_prefix(key).map(str::to_owned)).unwrap();
        format!("{}x{}", value("rows = "), value("columns = "))
    };
    let report = said(&small.replace("prefer = \"size\"", "prefer = \"speed\""));
    let expected = format!("two_conics.rs: differs: committed {}, found {}\n", size(&small), size(&text));
    assert!(size(&small) != size(&text) && report.contains(&expected), "{report}");
}

#[test]
fn every_file_is_checked_whatever_the_others_say() {
    let (folder, text) = quickly_searched("every_file_is_checked_whatever_the_others_say", &[]);
    fs::write(folder.join("lonely.rs"), "fn lonely(a: f64) -> x { x * x == a; }").unwrap();
    fs::write(folder.join("wrong.rs"), "fn wrong(a: f64) -> x { x * x = a; }").unwrap();
    let arguments = ["search", "--check", "missing.rs", "wrong.rs", "two_conics.rs", "lonely.rs"];
    let checked = eliminant(&folder, &[&arguments[..], &["--json"]].concat());
    assert_eq!(status(&checked), 1);
    let report: Value = serde_json::from_str(&stdout(&checked)).unwrap();
    let same: Vec<bool> = report["files"].as_array().unwrap().iter().map(|file| file["same"] == true).collect();
    assert_eq!(same, [false, false, true, false], "{report}");
    assert_eq!((&report["same"], &report["different"]), (&1.into(), &3.into()));
    for (at, part) in [(0, "no such file"), (1, "wrong.rs:1:"), (3, "no template file `lonely.template.toml`")] {
        let difference = report["files"][at]["differences"][0].as_str().unwrap();
        assert!(difference.contains(part), "{difference}");
    }
    assert_eq!(fs::read_to_string(folder.join("two_conics.template.toml")).unwrap(), text);
    assert_eq!(names(&folder), ["lonely.rs", "two_conics.rs", "two_conics.template.toml", "wrong.rs"]);
}

#[test]
fn emit_gives_the_same_bytes_again() {
    let folder = searched("emit_gives_the_same_bytes_again");
    let source = stdout(&eliminant(&folder, &["emit", "two_conics.rs"]));
    assert!(source.contains("pub mod two_conics") && source.contains("pub fn solve_complex"));
    assert_eq!(stdout(&eliminant(&folder, &["emit", "two_conics.rs"])), source);
    let report = json(&folder, &["emit", "two_conics.rs"]);
    check_summary(&report);
    assert_eq!(report["source"].as_str(), Some(source.as_str()));
    let report = json(&folder, &["emit", "two_conics.rs", "--out", "solver.rs"]);
    assert_eq!((&report["file"], report.get("source")), (&"solver.rs".into(), None));
    assert_eq!(fs::read_to_string(folder.join("solver.rs")).unwrap(), source);
    // A template from elsewhere.
    fs::rename(folder.join("two_conics.template.toml"), folder.join("kept.toml")).unwrap();
    assert_eq!(stdout(&eliminant(&folder, &["emit", "two_conics.rs", "--template", "kept.toml"])), source);
}

#[test]
fn inspect_draws_every_row_with_its_shift() {
    let folder = searched("inspect_draws_every_row_with_its_shift");
    let report = json(&folder, &["inspect", "two_conics.rs", "--svg", "plot.svg"]);
    check_summary(&report);
    let shifts: Vec<&str> = report["shifts"].as_array().unwrap().iter().map(|s| s.as_str().unwrap()).collect();
    let rows = report["rows"].as_u64().unwrap();
    assert_eq!(shifts.len() as u64, rows);
    let blocks: u64 = report["blocks"].as_array().unwrap().iter().map(|size| size.as_u64().unwrap()).sum();
    assert_eq!(blocks, rows);

    let text = stdout(&eliminant(&folder, &["inspect", "two_conics.rs"]));
    let plot: Vec<&str> = text.lines().filter(|line| line.contains(" | ")).collect();
    assert_eq!(plot[0].split('|').skip(1).map(str::trim).collect::<Vec<_>>(), ["excess", "reducible", "basis", ""]);
    assert_eq!(plot.iter().skip(1).map(|line| line.split(" | ").next().unwrap().trim()).collect::<Vec<_>>(), shifts);
    // Each equation has the six monomials of a conic; the template has no other column.
    let entries = plot.iter().skip(1).map(|line| line.split_once(" | ").unwrap().1).collect::<String>();
    let drawn = entries.chars().filter(|c| "#+o".contains(*c)).count() as u64;
    assert_eq!((drawn, report["entries"].as_u64()), (6 * rows, Some(6 * rows)));

    let svg = fs::read_to_string(folder.join("plot.svg")).unwrap();
    assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"));
    for shift in shifts {
        assert!(svg.contains(&format!("<title>{shift}</title>")), "{shift}");
    }
    for part in ["excess", "reducible", "basis"] {
        assert!(svg.contains(&format!(">{part}</text>")), "{part}");
    }
    json(&folder, &["inspect", "two_conics.rs", "--svg", "again.svg"]);
    assert_eq!(fs::read_to_string(folder.join("again.svg")).unwrap(), svg);
}

/// The same solver twice: both are compiled and solve the same instances.
#[test]
fn bench_times_the_stages_of_solvers() {
    let folder = searched("bench_times_the_stages_of_solvers");
    let runtime = concat!(env!("CARGO_MANIFEST_DIR"), "/../runtime");
    let size = ["--instances", "50", "--rounds", "3", "--fit"];
    let report =
        json(&folder, &[&["bench", "two_conics.rs", "two_conics.rs", "--runtime", runtime], &size[..]].concat());
    let solvers = report["solvers"].as_array().unwrap();
    assert_eq!(solvers.len(), 2);
    let positive =
        ["coefficients", "solutions", "total", "p99", "source_bytes", "program_bytes", "compile_seconds", "predicted"];
    for solver in solvers {
        let figure = |key: &str| solver[key].as_f64().unwrap();
        assert!(positive.iter().all(|key| figure(key) > 0.0), "{report}");
        assert!((1.0..=2.5).contains(&figure("found")), "{report}");
        assert_eq!((&solver["found"], &solver["roots"]), (&solvers[0]["found"], &"determinant".into()));
        assert_eq!(figure("eigenvalues"), 0.0, "none is computed: {report}");
    }
    // Both have the same counts: the fit is between their times.
    // Both solvers have one plan, for which each model predicts one time.
    for model in ["shipped", "fitted"] {
        let times = report["fit"][model]["predicted"].as_array().unwrap();
        assert!(times.len() == 2 && times[0] == times[1] && times[0].as_f64() > Some(0.0), "{report}");
    }
    assert_eq!(report["fit"]["shipped"]["predicted"][0], solvers[0]["predicted"], "no second attempts: {report}");
    let output = eliminant(&folder, &["bench", "two_conics.rs", "--scenes"]);
    assert_eq!(status(&output), 1);
    assert!(stderr(&output).contains("`two_conics.rs` states no scene"), "{}", stderr(&output));
    let output = eliminant(&folder, &["bench", "two_conics.rs", "--runtime", "nowhere"]);
    assert_eq!(status(&output), 1);
    assert!(stderr(&output).contains("`nowhere`"), "{}", stderr(&output));
    let broken = folder.join("broken");
    fs::create_dir_all(&broken).unwrap();
    fs::write(broken.join("Cargo.toml"), "[package]\nname = \"other\"\n").unwrap();
    let output = eliminant(&folder, &["bench", "two_conics.rs", "--runtime", "broken"]);
    assert_eq!(status(&output), 1);
    assert!(stderr(&output).contains("cannot compile the solvers") && stderr(&output).contains("help:"));
}

/// Problem and template, the arguments, and what the message must name.
#[test]
fn bad_input_is_named_and_nothing_is_written() {
    let folder = searched("bad_input_is_named_and_nothing_is_written");
    let template = fs::read_to_string(folder.join("two_conics.template.toml")).unwrap();
    let write = |name: &str, content: &[u8]| fs::write(folder.join(name), content).unwrap();
    fs::create_dir(folder.join("folder.rs")).unwrap();
    write("bytes.rs", b"fn bytes(a: f64) -> (x) {\n    x == \xff;\n}");
    write("empty.rs", b"");
    write("syntax.rs", b"fn syntax(a: f64) -> (x) {\n    x = = a;\n}");
    write("unknown.rs", b"fn unknown(a: f64) -> (x) {\n    x * x == b;\n}");
    write("renamed.rs", TWO_CONICS.as_bytes());
    write("curve.rs", b"fn curve(a: f64) -> (x, y) {\n    x * (x + y) == 0;\n    x * (y + a) == 0;\n}");
    let edits: [(&str, &str, &str); 13] = [
        ("solutions", "solutions = 4", "solutions = 40"),
        ("rows", "\nrows = ", "\nrows = 1"),
        ("columns", "\ncolumns = ", "\ncolumns = 1"),
        ("no_toml", "problem = ", "problem "),
        ("no_key", "solutions = 4\n", ""),
        ("other_problem", "problem = \"two_conics\"", "problem = \"three_conics\""),
        ("fingerprint", "fingerprint = \"", "fingerprint = \"1\" # "),
        ("digits", "fingerprint = \"", "fingerprint = \"x"),
        ("presolve", "presolve = \"none\"", "presolve = \"some\""),
        ("action", "action = \"", "action = \"q*"),
        ("equation", "equation = 2", "equation = 3"),
        ("zero", "equation = 2", "equation = 0"),
        ("shift", "multipliers = [\"1\"", "multipliers = [\"x^3\""),
    ];
    for (name, from, to) in edits {
        let edited = template.replace(from, to);
        assert_ne!(edited, template, "{name}");
        write(&format!("{name}.toml"), edited.as_bytes());
    }
    write("empty.toml", b"");
    write("bytes.toml", b"problem = \"\xff\"");

    let mut cases: Vec<(Vec<&str>, Vec<&str>)> = vec![
        (vec!["check", "missing.rs"], vec!["`missing.rs`", "no such file"]),
        (vec!["check", "folder.rs"], vec!["`folder.rs`", "folder"]),
        (vec!["check", "bytes.rs"], vec!["`bytes.rs`", "not UTF-8", "line 2"]),
        (vec!["check", "empty.rs"], vec!["empty.rs"]),
        (vec!["check", "syntax.rs"], vec!["syntax.rs:2:"]),
        (vec!["check", "unknown.rs"], vec!["unknown.rs:2:14", "`b`"]),
        (vec!["check", "curve.rs"], vec!["curve.rs:1:", "dimension 1"]),
        (vec!["search", "renamed.rs"], vec!["`renamed.rs`", "`two_conics.rs`"]),
        (vec!["search", "curve.rs"], vec!["curve.rs:1:", "dimension 1"]),
        (vec!["search", "two_conics.rs", "--out", "nowhere/out.toml"], vec!["`nowhere/out.toml`"]),
        (vec!["search", "two_conics.rs", "--out", "folder.rs"], vec!["`folder.rs`", "not a regular file"]),
        (vec!["emit", "unknown.rs"], vec!["unknown.rs:2:14"]),
        (vec!["emit", "curve.rs"], vec!["`curve.template.toml`", "`eliminant search curve.rs`"]),
        (vec!["emit", "two_conics.rs", "--out", "nowhere/out.rs"], vec!["`nowhere/out.rs`"]),
        (vec!["emit", "two_conics.rs", "--template", "folder.rs"], vec!["`folder.rs`", "folder"]),
        (vec!["inspect", "two_conics.rs", "--svg", "nowhere/out.svg"], vec!["`nowhere/out.svg`"]),
        (vec!["inspect", "two_conics.rs", "--template", "missing.toml"], vec!["missing.toml", "`eliminant search"]),
        (vec!["stability", "two_conics.rs", "--template", "bytes.toml"], vec!["`bytes.toml`", "not UTF-8"]),
        (vec!["stability", "two_conics.rs", "--template", "empty.toml"], vec!["empty.toml", "`eliminant search"]),
    ];
    let files: Vec<String> = edits.iter().map(|(name, ..)| format!("{name}.toml")).collect();
    for file in &files {
        cases.push((
            vec!["emit", "two_conics.rs", "--out", "solver.rs", "--template", file],
            vec![file, "`eliminant search two_conics.rs`"],
        ));
    }
    let before = names(&folder);
    for (arguments, expected) in cases {
        let output = eliminant(&folder, &[&arguments[..], &["--json"]].concat());
        let message = stderr(&output);
        assert_eq!(status(&output), 1, "{arguments:?}: {message}");
        for part in expected {
            assert!(message.contains(part), "{arguments:?} does not say {part}: {message}");
        }
        assert!(!message.contains("panicked"), "{arguments:?}: {message}");
        let report: Value = serde_json::from_str(&stdout(&output)).unwrap();
        assert_eq!(report["error"].as_str().map(str::trim), Some(message.trim()), "{arguments:?}");
    }
    assert_eq!(names(&folder), before);
    assert_eq!(fs::read_to_string(folder.join("two_conics.template.toml")).unwrap(), template);
}

/// A template found for an earlier text of the problem is refused, whatever changed in what the
/// problem states.
#[test]
fn an_edited_problem_needs_a_new_search() {
    let folder = searched("an_edited_problem_needs_a_new_search");
    let edits = [("dot(q, monomials) == 0", "dot(q, monomials) == 1"), ("q: [f64; 6]", "#[unit] q: [f64; 6]")];
    for (from, to) in edits {
        let edited = TWO_CONICS.replace(from, to);
        assert_ne!(edited, TWO_CONICS);
        fs::write(folder.join("two_conics.rs"), edited).unwrap();
        let output = eliminant(&folder, &["emit", "two_conics.rs"]);
        assert_eq!(status(&output), 1);
        assert!(stderr(&output).contains("earlier version of `two_conics`"), "{}", stderr(&output));
        assert!(stderr(&output).contains("`eliminant search two_conics.rs`"), "{}", stderr(&output));
    }
    // Another comment states the same problem.
    fs::write(folder.join("two_conics.rs"), format!("{TWO_CONICS}// The end.\n")).unwrap();
    assert_eq!(status(&eliminant(&folder, &["emit", "two_conics.rs"])), 0);
}

#[test]
fn wrong_usage_is_told_apart() {
    let folder = two_conics("wrong_usage_is_told_apart");
    for arguments in [
        &[][..],
        &["solve", "two_conics.rs"],
        &["check"],
        &["check", "two_conics.rs", "--fast"],
        &["check", "two_conics.rs", "other.rs"],
        &["search", "two_conics.rs", "--seed", "x"],
        &["search", "two_conics.rs", "--max-columns", "0"],
        &["search", "two_conics.rs", "--prefer", "beauty"],
        &["search", "two_conics.rs", "--confirm", "0"],
        &["search", "two_conics.rs", "--shuffles", "-1"],
        &["search"],
        &["search", "--check"],
        &["search", "--check", "two_conics.rs", "--seed", "2"],
        &["search", "two_conics.rs", "--check", "two_conics.rs"],
        &["stability", "two_conics.rs", "--trials", "0"],
        &["stability", "two_conics.rs", "--trials", "1e3"],
        &["stability", "two_conics.rs", "--trials"],
        &["stability", "two_conics.rs", "--families", "usual"],
        &["stability", "two_conics.rs", "--check", "--update-baseline"],
        &["stability"],
        &["inspect", "two_conics.rs", "--svg"],
        &["bench"],
        &["bench", "two_conics.rs", "--rounds", "0"],
    ] {
        let output = eliminant(&folder, arguments);
        assert_eq!(status(&output), 2, "{arguments:?}");
        assert!(stderr(&output).contains("Usage") || stderr(&output).contains("error:"), "{arguments:?}");
        assert!(stdout(&output).is_empty(), "{arguments:?}");
    }
}

#[test]
fn every_subcommand_helps_with_an_example() {
    let folder = folder("every_subcommand_helps_with_an_example");
    for subcommand in ["new", "check", "search", "emit", "inspect", "stability", "bench", "completions"] {
        let output = eliminant(&folder, &[subcommand, "--help"]);
        let text = stdout(&output);
        assert_eq!(status(&output), 0);
        for part in ["--json", "Example", &format!("eliminant {subcommand} ")] {
            assert!(text.contains(part), "{subcommand} --help lacks {part}:\n{text}");
        }
    }
}

#[test]
fn shells_complete_the_command() {
    let folder = folder("shells_complete_the_command");
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = eliminant(&folder, &["completions", shell]);
        assert_eq!(status(&script), 0);
        for part in ["search", "stability", "budget"] {
            assert!(stdout(&script).contains(part), "{shell}: {part}");
        }
    }
}

/// Messages have colours where they are asked for, and the same text.
#[test]
fn messages_may_have_colours() {
    let folder = folder("messages_may_have_colours");
    fs::write(folder.join("wrong.rs"), "fn wrong(a: f64) -> (x, y) { x == a; y == b; }").unwrap();
    for arguments in [["check", "wrong.rs"], ["check", "missing.rs"], ["check", "--wrong"]] {
        let file = folder.join(arguments[1]).display().to_string();
        let arguments = ["eliminant", arguments[0], if arguments[1] == "--wrong" { "--wrong" } else { &file }];
        let [plain, coloured] = [Colour::Never, Colour::Always].map(|colour| {
            let mut err = Vec::new();
            assert_ne!(run_in(arguments, &mut Vec::new(), &mut err, colour), 0);
            String::from_utf8(err).unwrap()
        });
        assert!(coloured.contains("\x1b[") && !plain.contains('\x1b'), "{coloured:?}");
        let stripped: String = coloured.split("\x1b[").enumerate().fold(String::new(), |text, (at, part)| {
            text + if at == 0 { part } else { part.split_once('m').map_or("", |(_, rest)| rest) }
        });
        let lines = |text: &str| text.lines().map(|line| line.trim_end().to_owned()).collect::<Vec<_>>();
        assert_eq!(lines(&stripped), lines(&plain));
    }
}

/// The library function behind the binary writes where it is told to.
#[test]
fn the_command_runs_without_a_process() {
    let folder = two_conics("the_command_runs_without_a_process");
    let file = folder.join("two_conics.rs").display().to_string();
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let status = eliminant_generator::command::run(["eliminant", "check", "--json", &file], &mut out, &mut err);
    assert_eq!((status, err.len()), (0, 0));
    let report: Value = serde_json::from_slice(&out).unwrap();
    assert_eq!(report["solutions"], 4);
}
