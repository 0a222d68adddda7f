//! What a build script meets: good problems, stale and broken templates, files that are none. No
//! partial output, no panic.

use std::fs;
use std::path::PathBuf;
use std::time::SystemTime;

use eliminant_generator::Generator;
use eliminant_generator::check::check;
use eliminant_generator::generate::generate;
use eliminant_generator::problem::Problem;
use eliminant_generator::search::measuring::stability;
use eliminant_generator::search::monitor::Unmonitored;
use eliminant_generator::search::{SearchOptions, candidates};
use eliminant_tests::templates_folder;
use tempfile::TempDir;

/// A folder of problems and one for the solvers.
struct Project {
    folder: TempDir,
}

impl Project {
    fn new() -> Self {
        let project = Self { folder: tempfile::tempdir().expect("a folder") };
        fs::create_dir(project.problems()).expect("a folder");
        fs::create_dir(project.out()).expect("a folder");
        project
    }

    /// With files of `templates/`.
    fn with(files: &[&str]) -> Self {
        let project = Self::new();
        files.iter().for_each(|file| project.write(file, committed(file)));
        project
    }

    fn problems(&self) -> PathBuf {
        self.folder.path().join("problems")
    }

    fn out(&self) -> PathBuf {
        self.folder.path().join("out")
    }

    fn write(&self, file: &str, content: impl AsRef<[u8]>) {
        fs::write(self.problems().join(file), content).expect("written");
    }

    /// Runs the build script; the error as cargo shows it.
    fn run(&self) -> Result<(), String> {
        Generator::new().problems(self.problems()).out_dir(self.out()).run().map_err(|error| format!("{error:?}"))
    }

    /// Names of the emitted files, and of anything left behind.
    fn emitted(&self) -> Vec<String> {
        let entries = fs::read_dir(self.out()).expect("the folder");
        let mut names: Vec<String> =
            entries.map(|entry| entry.expect("an entry").file_name().into_string().expect("UTF-8")).collect();
        names.sort();
        names
    }

    fn solver(&self, name: &str) -> String {
        fs::read_to_string(self.out().join(format!("{name}.rs"))).expect("emitted")
    }

    fn modified(&self, name: &str) -> SystemTime {
        let data = fs::metadata(self.out().join(format!("{name}.rs"))).expect("emitted");
        data.modified().expect("a time")
    }

    /// Fails with all of the words in its message, and without any output.
    fn fails_with(&self, words: &[&str]) {
        let message = self.run().expect_err("this project is broken");
        for word in words {
            assert!(message.contains(word), "`{word}` is missing in\n{message}");
        }
        assert_eq!(self.emitted(), [""; 0], "{message}");
    }
}

fn committed(file: &str) -> String {
    fs::read_to_string(templates_folder().join(file)).expect("committed")
}

const CONICS: [&str; 2] = ["two_conics.rs", "two_conics.template.toml"];
const SEARCH_AGAIN: &str = "eliminant search ";

/// A project whose template differs from the committed one.
fn with_template(from: &str, to: &str) -> Project {
    let (project, template) = (Project::with(&CONICS), committed(CONICS[1]));
    assert!(template.contains(from), "`{from}` is not in\n{template}");
    project.write(CONICS[1], template.replacen(from, to, 1));
    project
}

#[test]
fn unchanged_output_keeps_its_time() {
    let project = Project::with(&CONICS);
    project.run().expect("a good project");
    assert_eq!(project.emitted(), ["two_conics.rs"]);
    let (solver, modified) = (project.solver("two_conics"), project.modified("two_conics"));
    std::thread::sleep(std::time::Duration::from_millis(20));
    project.run().expect("a good project");
    assert_eq!(project.modified("two_conics"), modified);
    // Another doc comment is other output; the template still belongs to the problem.
    project.write(CONICS[0], committed(CONICS[0]).replace("two general conics", "two conics"));
    project.run().expect("a good project");
    assert_ne!(project.solver("two_conics"), solver);
    assert_ne!(project.modified("two_conics"), modified);
}

#[test]
fn an_edited_problem_makes_its_template_stale() {
    let project = Project::with(&CONICS);
    project.write(CONICS[0], committed(CONICS[0]).replacen("dot(p, monomials)", "dot(p, monomials) + x", 1));
    project.fails_with(&["two_conics.rs", "an earlier version of `two_conics`", SEARCH_AGAIN]);
}

/// Examples hold templates of their own, which a change of a catalogue problem makes stale.
#[test]
fn templates_of_the_examples_belong_to_their_problems() {
    let examples = templates_folder().join("../examples");
    let own = [("own-problem/problems", None), ("own-library/problems", None)];
    for (folder, problems) in [("regenerate/templates", Some(templates_folder()))].into_iter().chain(own) {
        let folder = examples.join(folder);
        let entries = fs::read_dir(&folder).expect("a folder of the example");
        let files = entries.map(|entry| entry.expect("an entry").file_name().into_string().expect("UTF-8"));
        let names: Vec<String> =
            files.filter_map(|file| Some(file.strip_suffix(".template.toml")?.to_owned())).collect();
        assert!(!names.is_empty(), "no template in {}", folder.display());
        let problems = problems.unwrap_or_else(|| folder.clone());
        let out = tempfile::tempdir().expect("a folder");
        let solvers = Generator::new().problems(problems).only(&names).templates(&folder).out_dir(out.path());
        solvers.run().unwrap_or_else(|error| panic!("{}: {error:?}", folder.display()));
    }
}

#[test]
fn a_template_of_another_problem_is_refused() {
    let project = Project::with(&CONICS[..1]);
    project.write(CONICS[1], committed("circle_minimal.template.toml").replace("\"a", "\"x").replace('b', "y"));
    let message = project.run().expect_err("not its template");
    assert!(message.contains("two_conics.rs"), "{message}");
    let project = with_template("problem = \"two_conics\"", "problem = \"circle_minimal\"");
    project.fails_with(&["two_conics.rs", "`circle_minimal`", SEARCH_AGAIN]);
}

#[test]
fn a_template_that_is_no_toml_is_shown_with_line_and_column() {
    with_template("solutions = 4", "solutions = ").fails_with(&["two_conics.rs", "line 5", "column", SEARCH_AGAIN]);
    with_template("solutions = 4", "solutions = \"four\"").fails_with(&["line 5", "invalid type"]);
    with_template("solutions = 4", "solutions = 4\nsolution = 4").fails_with(&["unknown field `solution`"]);
    with_template("problem = \"two_conics\"\n", "").fails_with(&["missing field `problem`"]);
    with_template("presolve = \"none\"", "presolve = \"some\"").fails_with(&["presolve", "`some`", "`none`"]);
}

#[test]
fn a_template_that_does_not_hold_is_refused() {
    let text = committed(CONICS[1]);
    let list = |key: &str| {
        let line = text.lines().find(|line| line.starts_with(key)).expect("a key");
        line.split('"').skip(1).step_by(2).map(|m| format!("\"{m}\"")).collect::<Vec<_>>()
    };
    let (basis, excess) = (list("basis"), list("excess"));
    let swapped = |from: &str, to: &str| text.replacen(&format!("= [{from}"), &format!("= [{to}"), 1);
    let both = swapped(&basis[0], &excess[2]);
    let both = both.replacen(&format!(", {}]", excess[2]), &format!(", {}]", basis[0]), 1);
    let uncovered = [("\"x^2\", ", ""), ("columns = 10", "columns = 9"), ("solutions = 4", "solutions = 3")];
    let uncovered = uncovered.iter().fold(text.clone(), |text, (from, to)| text.replacen(from, to, 1));
    let dropped = text.replacen("multipliers = [\"1\", ", "multipliers = [", 1);
    for (fault, template, words) in [
        ("no monomial", swapped(&basis[0], "\"q^2\""), ["`q^2`", "not a monomial"]),
        ("another monomial in the basis", swapped(&basis[0], "\"x^7\""), ["does not hold", "columns"]),
        ("a repeated monomial", swapped(&basis[0], &basis[1]), ["does not hold", "columns"]),
        ("basis and excess exchanged", both, ["does not hold", "two_conics"]),
        ("a dropped row", dropped.clone(), ["`rows` is 6", "5 multipliers"]),
        ("a dropped row, counted", dropped.replacen("rows = 6", "rows = 5", 1), ["does not hold", "columns"]),
        ("a monomial of no column", uncovered, ["does not hold", "does not cancel"]),
        ("no such equation", text.replacen("equation = 2", "equation = 3", 1), ["does not hold", "shift"]),
        ("equation zero", text.replacen("equation = 2", "equation = 0", 1), ["`equation` is `0`", "1, 2"]),
        (
            "an exponent out of range",
            text.replacen("multipliers = [\"1\"", "multipliers = [\"x^127\"", 1),
            ["does not hold", "range"],
        ),
        ("another action", text.replacen("action = \"", "action = \"y*", 1), ["does not hold", "two_conics"]),
        (
            "more solutions than basis monomials",
            text.replacen("solutions = 4", "solutions = 5", 1),
            ["solutions", "basis"],
        ),
        (
            "too few solutions",
            text.replacen("solutions = 4", "solutions = 3", 1),
            ["says 3 solutions", "the template gives 4"],
        ),
        ("no solution", text.replacen("solutions = 4", "solutions = 0", 1), ["solutions", "two_conics"]),
    ] {
        assert_ne!(template, text, "{fault}");
        println!("{fault}");
        let project = Project::with(&CONICS);
        project.write(CONICS[1], template);
        project.fails_with(&words);
        project.fails_with(&["two_conics.rs", SEARCH_AGAIN]);
    }
}

/// Cut off, lines dropped and repeated, characters exchanged: refused, or still a template that
/// holds (`generate` verifies it).
#[test]
fn damaged_templates_never_panic() {
    let text = committed(CONICS[1]);
    let lines: Vec<&str> = text.lines().collect();
    let without = |at: usize| lines.iter().enumerate().filter(|(i, _)| *i != at).map(|(_, l)| *l).collect::<Vec<_>>();
    let mut damaged: Vec<String> = (0..text.len()).step_by(3).map(|end| text[..end].to_owned()).collect();
    damaged.extend((0..lines.len()).map(|at| without(at).join("\n")));
    damaged.extend((0..lines.len()).map(|at| format!("{}\n{}", text, lines[at])));
    for (at, character) in text.char_indices().step_by(2) {
        for other in ["\"", "9", "x", "-", ""] {
            damaged.push(format!("{}{other}{}", &text[..at], &text[at + character.len_utf8()..]));
        }
    }
    let mut refused = 0;
    for template in &damaged {
        let project = Project::with(&CONICS);
        project.write(CONICS[1], template);
        match project.run() {
            Ok(()) => assert_eq!(project.emitted(), ["two_conics.rs"]),
            Err(message) => {
                refused += 1;
                assert!(message.contains("two_conics.rs"), "{message}");
                assert_eq!(project.emitted(), [""; 0], "{message}");
            }
        }
    }
    println!("{refused} of {} damaged templates refused", damaged.len());
    assert!(refused * 2 > damaged.len());
}

/// Without a template file a bounded search runs: what is emitted is the solver of a candidate that
/// solves.
#[test]
fn a_problem_without_template_is_searched() {
    let text = "/// A circle and a parabola.\nfn meet(c: [f64; 3], p: [f64; 3]) -> (x, y) {\n    \
        (x - c[0]).pow(2) + (y - c[1]).pow(2) == c[2];\n    y == p[0] * x * x + p[1] * x + p[2];\n}\n";
    let project = Project::new();
    project.write("meet.rs", text);
    project.run().expect("a small problem");
    let solver = project.solver("meet");
    let problem = Problem::parse("meet.rs", text).expect("a good problem");
    let algebra = check(&problem).expect("finitely many");
    assert_eq!((algebra.solutions, algebra.different), (4, 4));
    let solves = SearchOptions::for_a_build();
    let found = candidates(&problem, &algebra, &solves, &Unmonitored).expect("a template").candidates;
    let emitted =
        found.iter().find(|c| generate(&problem, &c.to_file(&problem, &solves)).is_ok_and(|text| text == solver));
    let measured = stability(&emitted.expect("one of the candidates").plan, 1000, 1);
    assert_eq!((measured.failures, measured.found), (0, measured.expected));
    // The search at the next build gives the same.
    let modified = project.modified("meet");
    project.run().expect("a small problem");
    assert_eq!(project.modified("meet"), modified);
}

/// Names in the emitted code are none of the problem's.
#[test]
fn names_of_data_are_not_taken() {
    let project = Project::new();
    let text = "fn clash(c: [f64; 2], c_0: f64, v: f64) -> (x, y) {\n    \
        c_0 * v * x * x + y * y == c[0];\n    x * y + c_0 * v * y == c[1];\n}\n";
    project.write("clash.rs", text);
    project.run().expect("a small problem");
    let solver = project.solver("clash");
    for declaration in ["let c_at_0 = data[0];", "let c_at_1 = data[1];", "let mut v_2 = [one.constant(0.0);"] {
        assert!(solver.contains(declaration), "{declaration} in\n{solver}");
    }
}

#[test]
fn all_broken_problems_are_reported_and_good_ones_written() {
    let project = Project::with(&CONICS);
    project.write("one.rs", "fn one(a: f64) -> (x) {\n    b * x == 1;\n}\n");
    project.write("two.rs", "fn two(a: f64) -> (x) {\n    a * x == 1\n");
    let message = project.run().expect_err("two broken problems");
    for word in ["one.rs:2:5", "`b`", "two.rs:"] {
        assert!(message.contains(word), "`{word}` is missing in\n{message}");
    }
    assert_eq!(project.emitted(), ["two_conics.rs"]);
}

#[test]
fn problems_that_cannot_be_solved_are_refused() {
    for (name, text, word) in [
        (
            "surface",
            "fn surface(a: f64) -> (x, y) {\n    a * x * y == 1;\n    a * a * x * y == a;\n}\n",
            "infinitely many",
        ),
        ("none", "fn none(a: f64) -> (x) {\n    a * x == 1;\n    a * x == 2;\n}\n", "no common solution"),
        (
            "cones",
            "fn cones(a: f64) -> (x, y) {\n    x * x == a * y * y;\n    x * x == 2 * x * y;\n}\n",
            "only solution",
        ),
    ] {
        let project = Project::new();
        project.write(&format!("{name}.rs"), text);
        project.fails_with(&[word, &format!("{name}.rs:1")]);
    }
}

#[test]
fn files_that_are_none_are_refused() {
    let project = Project::with(&CONICS);
    project.write(CONICS[0], [0x66, 0x6e, 0xff, 0xfe, 0x20]);
    project.fails_with(&["two_conics.rs", "UTF-8"]);
    let project = Project::with(&CONICS);
    project.write(CONICS[1], [0xff, 0xfe]);
    project.fails_with(&["two_conics", "UTF-8"]);
    let project = Project::with(&CONICS);
    fs::rename(project.problems().join(CONICS[0]), project.problems().join("other.rs")).expect("renamed");
    project.fails_with(&["other.rs", "`two_conics.rs`"]);
    let project = Project::new();
    project.write("empty.rs", "");
    project.fails_with(&["empty.rs"]);
    Project::new().fails_with(&["problems", "no problem file"]);
    let project = Project::new();
    fs::remove_dir(project.problems()).expect("removed");
    project.fails_with(&["problems", "No such file"]);
}

#[test]
fn an_output_folder_that_is_missing_is_an_error() {
    let project = Project::with(&CONICS);
    fs::remove_dir(project.out()).expect("removed");
    let message = project.run().expect_err("nowhere to write");
    assert!(message.contains("out") && message.contains("two_conics.rs"), "{message}");
}
