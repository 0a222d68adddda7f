//! `eliminant stability`: figures, files, baseline and page.
#![cfg(feature = "command")]

#[path = "support/shares.rs"]
mod shares;
mod support;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

use serde_json::{Value, json};
use shares::SHARES;
use support::{TWO_CONICS, eliminant, folder, json, names, status, stderr, stdout, two_conics};

const TEMPLATE: &str = "two_conics.template.toml";
const TEMPLATES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../templates");

/// Of 16 solutions, 4 differ by more than exchanges of x with y and of z with w.
const EXCHANGES: &str = "/// Two pairs.
fn exchanges(a: [f64; 6]) -> (x, y, z, w) {
    x * y + a[0] * z * w == a[1];
    x + y + z + w == a[2];
    x * x + y * y + a[3] * (z * z + w * w) == a[4];
    z * z * w * w + a[5] * (z + w) == 1;
}
";

/// A folder with committed problems and their templates.
fn problems(test: &str, problems: &[&str]) -> PathBuf {
    let folder = folder(test);
    for problem in problems {
        for end in ["rs", "template.toml"] {
            let name = format!("{problem}.{end}");
            fs::copy(Path::new(TEMPLATES).join(&name), folder.join(&name)).unwrap();
        }
    }
    folder
}

/// The rows of a report of one family.
fn rows<'a>(report: &'a Value, family: &str) -> Vec<&'a Value> {
    report["rows"].as_array().unwrap().iter().filter(|row| row["family"] == family).collect()
}

fn sum(rows: &[&Value], pointer: &str) -> u64 {
    rows.iter().map(|row| row.pointer(pointer).and_then(Value::as_u64).unwrap()).sum()
}

#[test]
fn every_instance_is_judged() {
    let folder = problems("every_instance_is_judged", &["two_conics"]);
    let arguments = ["stability", "two_conics.rs", "--trials", "120", "--seed", "7", "--interpreted"];
    let report = json(&folder, &arguments);
    assert_eq!((&report["trials"], &report["seed"], &report["bits"]), (&120.into(), &7.into(), &237.into()));
    assert_eq!(
        (&report["solvers"][0]["problem"], &report["solvers"][0]["solutions"]),
        (&"two_conics".into(), &4.into())
    );
    for (family, levels) in [("random", 1), ("scaled", 8), ("degenerate", 6), ("noisy", 0)] {
        let rows = rows(&report, family);
        assert_eq!(rows.len(), levels, "{family}");
        // Conics have no condition that noise could violate.
        assert_eq!(sum(&rows, "/instances"), if levels > 0 { 120 } else { 0 }, "{family}");
    }
    let random = rows(&report, "random");
    for (pointer, expected) in [("/complex/expected", 480), ("/failed", 0), ("/uncertain", 0), ("/complex/missed", 0)] {
        assert_eq!(sum(&random, pointer), expected, "{pointer}: {report}");
    }
    let histogram: Vec<u64> = random[0]["histogram"].as_array().unwrap().iter().map(|n| n.as_u64().unwrap()).collect();
    assert_eq!(histogram.iter().sum::<u64>(), 480);
    let quantile = |row: &Value, pointer: &str| row.pointer(pointer).and_then(Value::as_f64).unwrap();
    let quantiles = ["median", "p99", "max"].map(|part| quantile(random[0], &format!("/residual/{part}")));
    assert!(quantiles.is_sorted() && quantiles[0] < -14.5 && quantiles[2] <= -10.0, "{report}");
    // Nearly equal conics have nearly undetermined solutions, which are refined. Those that
    // are not enlarge rounding by at most 1e6, or several times that. Other units change nothing.
    let degenerate = rows(&report, "degenerate");
    let errors: Vec<f64> = degenerate.iter().map(|row| quantile(row, "/forward_error/max")).collect();
    assert_eq!((&degenerate[0]["level"], &degenerate[5]["level"]), (&json!(-12.0), &json!(-2.0)));
    assert!(errors.iter().all(|error| *error < -9.0), "{errors:?}");
    assert!(rows(&report, "scaled").iter().all(|row| quantile(row, "/residual/median") < -14.5), "{report}");
    assert_eq!(json(&folder, &arguments)["rows"], report["rows"], "the same again");
    let text = stdout(&eliminant(&folder, &arguments));
    assert!(text.contains("problem     two_conics: 4 solutions") && text.contains("random"), "{text}");
    assert_eq!(names(&folder), ["two_conics.rs", "two_conics.template.toml"], "files are written on request only");
}

/// Emitted code returns the bits of the interpreted plan, and has times.
#[test]
fn emitted_code_is_judged_as_the_interpreted_plan() {
    let folder = problems("emitted_code_is_judged_as_the_interpreted_plan", &["two_conics", "trilateration"]);
    // A linear form in the place of an unknown, and a solution known beforehand by what presolve
    // eliminated; unknowns that can be exchanged.
    for (name, text, presolve) in [("shares", SHARES, "separated"), ("exchanges", EXCHANGES, "paired")] {
        fs::write(folder.join(name).with_extension("rs"), text).unwrap();
        assert_eq!(status(&eliminant(&folder, &["search", &format!("{name}.rs"), "--trials", "20"])), 0);
        let template = fs::read_to_string(folder.join(name).with_extension("template.toml")).unwrap();
        assert!(template.contains(&format!("presolve = \"{presolve}\"")), "{template}");
    }
    let runtime = concat!(env!("CARGO_MANIFEST_DIR"), "/../runtime");
    let arguments = ["stability", ".", "--trials", "24", "--runtime", runtime];
    let emitted = json(&folder, &arguments);
    let interpreted = json(&folder, &[&arguments[..], &["--interpreted"]].concat());
    assert_eq!((&emitted["is_emitted"], &interpreted["is_emitted"]), (&true.into(), &false.into()));
    let without_times = |report: &Value| {
        let mut rows = report["rows"].clone();
        rows.as_array_mut().unwrap().iter_mut().for_each(|row| row["nanoseconds"] = Value::Null);
        rows
    };
    assert_eq!(without_times(&emitted), without_times(&interpreted));
    let random = rows(&emitted, "random");
    assert_eq!([sum(&random, "/complex/missed"), sum(&random, "/complex/spurious")], [0, 0], "{emitted}");
    for solutions in [7, 16] {
        assert!(random.iter().any(|row| row["complex"]["expected"] == 24 * solutions), "{emitted}");
    }
    for row in emitted["rows"].as_array().unwrap() {
        let times = ["median", "p99", "max"].map(|part| row["nanoseconds"][part].as_f64().unwrap());
        assert!(times.is_sorted() && times[0] > 0.0, "{row}");
    }
    let failed = eliminant(&folder, &["stability", "two_conics.rs", "--runtime", "nowhere"]);
    assert!(status(&failed) == 1 && stderr(&failed).contains("`nowhere`"), "{}", stderr(&failed));
}

#[test]
fn worst_instances_are_replayed() {
    let folder = problems("worst_instances_are_replayed", &["two_conics", "trilateration"]);
    let measure = ["stability", ".", "--interpreted", "--trials", "60"];
    json(&folder, &[&measure[..], &["--worst", "worst.jsonl", "--csv", "figures.csv"]].concat());
    let lines: Vec<Value> = fs::read_to_string(folder.join("worst.jsonl"))
        .unwrap()
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    assert_eq!(lines.len(), 10, "five of each problem");
    let replay = ["stability", ".", "--interpreted", "--replay", "worst.jsonl"];
    let report = json(&folder, &replay);
    let replayed = report["replayed"].as_array().unwrap();
    assert_eq!(replayed.len(), 10);
    for (line, seen) in lines.iter().zip(replayed) {
        assert_eq!((&seen["words"], &seen["data"]), (&line["note"], &line["data"]), "{seen}");
    }
    let text = stdout(&eliminant(&folder, &replay));
    assert!(text.contains(lines[0]["note"].as_str().unwrap()), "{text}");
    let csv = fs::read_to_string(folder.join("figures.csv")).unwrap();
    let columns: Vec<usize> = csv.lines().map(|line| line.split(',').count()).collect();
    assert!(csv.starts_with("problem,family,level,instances,") && columns.iter().all(|&n| n == columns[0]), "{csv}");
    // A scene of `trilateration`, and of both random, scaled and degenerate data.
    assert_eq!(columns.len(), 1 + 1 + 2 * (1 + 8 + 6));
}

#[test]
fn instances_of_a_file_come_with_known_solutions() {
    let folder = problems("instances_of_a_file_come_with_known_solutions", &["trilateration"]);
    // Distances from (1, 2, 3): 3 and the roots of 22 and 11.
    let line = |solution: &str| {
        format!(
            "{{\"problem\": \"trilateration\", \"family\": \"axes\", \"level\": 1, \
             \"data\": [0, 0, 1, 4, 0, 0, 0, 3, 0, 3, {}, {}], \"solutions\": [[{solution}]]}}\n",
            22f64.sqrt(),
            11f64.sqrt()
        )
    };
    fs::write(folder.join("known.jsonl"), line("1, 2, 3") + &line("1, 2, 3.5") + "\n").unwrap();
    let report = json(&folder, &["stability", ".", "--interpreted", "--instances", "known.jsonl"]);
    assert_eq!(report["rows"].as_array().unwrap().len(), 1, "{report}");
    let row = &report["rows"][0];
    assert_eq!((&row["family"], &row["level"], &row["instances"]), (&"axes".into(), &json!(1.0), &2.into()));
    assert_eq!((&row["real"]["expected"], &row["known"], &row["known_missed"]), (&4.into(), &2.into(), &1.into()));
}

#[test]
fn known_vectors_have_any_length() {
    let folder = folder("known_vectors_have_any_length");
    let problem = "fn pair(a: [f64; 3]) -> (#[projective] v: [f64; 2], w) {
        a[0] * v[0] * v[0] + a[1] * v[1] * v[1] == a[2] * v[0] * v[1];
        w * v[0] == v[1];
    }";
    fs::write(folder.join("pair.rs"), problem).unwrap();
    assert_eq!(status(&eliminant(&folder, &["search", "pair.rs"])), 0);
    // 2 + w^2 = 3 w: w is 1 or 2. The third one is none.
    let line = |solution: &str| {
        format!("{{\"problem\": \"pair\", \"family\": \"f\", \"data\": [2, 1, 3], \"solutions\": [[{solution}]]}}\n")
    };
    let lines = line("1, 1, 1") + &line("-0.5, -1, 2") + &line("1, 2, 1");
    fs::write(folder.join("known.jsonl"), lines).unwrap();
    let report = json(&folder, &["stability", ".", "--interpreted", "--instances", "known.jsonl"]);
    assert_eq!((&report["rows"][0]["known"], &report["rows"][0]["known_missed"]), (&3.into(), &1.into()), "{report}");
    // Of many wrong lines a few are shown.
    fs::write(folder.join("wrong.jsonl"), line("1, 2, 3, 4").repeat(30)).unwrap();
    let shown = stderr(&eliminant(&folder, &["stability", ".", "--interpreted", "--instances", "wrong.jsonl"]));
    assert_eq!(shown.matches("a solution of `pair` has 3 numbers, not 4").count(), 5, "{shown}");
    assert!(shown.contains("25 more lines are wrong"), "{shown}");
}

#[test]
fn a_problem_without_data_is_solved_once() {
    let folder = folder("a_problem_without_data_is_solved_once");
    fs::write(folder.join("plain.rs"), "fn plain() -> (x, y) { x * x + 2 * y == 7; y * y - x * y == 3; }").unwrap();
    json(&folder, &["search", "plain.rs"]);
    let report = json(&folder, &["stability", "plain.rs", "--interpreted"]);
    assert_eq!(report["rows"].as_array().unwrap().len(), 1, "{report}");
    let row = &report["rows"][0];
    assert_eq!(
        (&row["family"], &row["instances"], &row["complex"]["expected"]),
        (&"random".into(), &1.into(), &4.into())
    );
}

#[test]
fn figures_are_compared_with_the_accepted_ones() {
    let folder = problems("figures_are_compared_with_the_accepted_ones", &["two_conics", "trilateration"]);
    let stability = |options: &[&str]| {
        eliminant(&folder, &[&["stability", ".", "--interpreted", "--families", "random,scaled"][..], options].concat())
    };
    let missing = stability(&["--check", "--trials", "10"]);
    assert!(status(&missing) == 1 && stderr(&missing).contains("stability.toml"), "{}", stderr(&missing));
    assert_eq!(status(&stability(&["--update-baseline", "--trials", "400"])), 0);
    let accepted = fs::read_to_string(folder.join("stability.toml")).unwrap();
    assert_eq!(accepted.matches("[[figures]]").count(), 4, "{accepted}");
    // Another sample is not worse.
    let good = stability(&["--check", "--trials", "100", "--seed", "9"]);
    assert_eq!(status(&good), 0, "{}{}", stdout(&good), stderr(&good));
    assert!(stdout(&good).contains("4 sets of figures compared with"), "{}", stdout(&good));
    // Bounds that no solver meets: only what they are of is named.
    let mut table: toml::Table = toml::from_str(&accepted).unwrap();
    let figures = table["figures"].as_array_mut().unwrap();
    let row = figures.iter_mut().find(|row| row["problem"].as_str() == Some("two_conics")).unwrap();
    row["error_median"]["high"] = toml::Value::Float(-17.0);
    fs::write(folder.join("stability.toml"), toml::to_string(&table).unwrap()).unwrap();
    let worse = stability(&["--check", "--trials", "100"]);
    let named: Vec<String> =
        stdout(&worse).lines().filter(|line| line.starts_with("worse: ")).map(str::to_owned).collect();
    assert!(status(&worse) == 1 && named.len() == 1, "{}", stdout(&worse));
    assert!(named[0].starts_with("worse: two_conics, random: median forward error"), "{named:?}");
    // What is updated are the figures that were measured.
    assert_eq!(status(&stability(&["--update-baseline", "--trials", "400"])), 0);
    assert_eq!(fs::read_to_string(folder.join("stability.toml")).unwrap(), accepted);
}

#[test]
fn faults_of_files_are_named_all_at_once() {
    let folder = two_conics("faults_of_files_are_named_all_at_once");
    fs::copy(Path::new(TEMPLATES).join(TEMPLATE), folder.join(TEMPLATE)).unwrap();
    fs::write(folder.join("lonely.rs"), TWO_CONICS.replace("two_conics", "lonely")).unwrap();
    let instances = "{\"problem\": \"two_conics\", \"family\": \"f\", \"data\": [1, 2]}\nno json\n\
                     {\"problem\": \"other\", \"family\": \"f\", \"data\": []}\n\
                     {\"problem\": \"two_conics\", \"family\": \"f\", \"data\": [], \"tada\": 1}\n";
    fs::write(folder.join("bad.jsonl"), instances).unwrap();
    fs::write(folder.join("empty.jsonl"), "\n").unwrap();
    fs::write(folder.join("bad.toml"), "figures = 3").unwrap();
    fs::create_dir(folder.join("nothing")).unwrap();
    let before = names(&folder);
    for (arguments, parts) in [
        (&["missing.rs", "lonely.rs"][..], &["`missing.rs`", "`lonely.template.toml`"][..]),
        (&["two_conics.rs", "./two_conics.rs"], &["two files state the problem `two_conics`"]),
        (&["nothing"], &["no problem", "`nothing`"]),
        (
            &["two_conics.rs", "--instances", "bad.jsonl"],
            &[
                "`bad.jsonl`:1: `two_conics` takes 12 numbers",
                "`bad.jsonl`:2:",
                "`other`",
                "`bad.jsonl`:4: unknown field",
            ],
        ),
        (&["two_conics.rs", "--replay", "empty.jsonl"], &["`empty.jsonl`:1: there is no instance"]),
        (&["two_conics.rs", "--check", "--baseline", "bad.toml"], &["`bad.toml`", "--update-baseline"]),
        (&["two_conics.rs", "--trials", "2", "--html", "nowhere/page.html"], &["`nowhere/page.html`"]),
    ] {
        let output = eliminant(&folder, &[&["stability", "--interpreted"], arguments].concat());
        assert_eq!(status(&output), 1, "{arguments:?}: {}", stderr(&output));
        for part in parts {
            assert!(stderr(&output).contains(part), "{arguments:?} does not say {part}: {}", stderr(&output));
        }
    }
    assert_eq!(names(&folder), before);
}

/// The first browser of these that is installed.
fn browser() -> Option<PathBuf> {
    let folders: Vec<PathBuf> = std::env::split_paths(&std::env::var_os("PATH")?).collect();
    let names = ["chromium", "chromium-browser", "google-chrome", "chrome"];
    names.iter().flat_map(|name| folders.iter().map(move |folder| folder.join(name))).find(|path| path.is_file())
}

/// The page opens in a browser: its script runs to the end, without an error, and fills the table
/// and draws the charts.
#[test]
fn the_page_opens_in_a_browser() {
    let folder = problems("the_page_opens_in_a_browser", &["two_conics", "trilateration"]);
    let report = json(
        &folder,
        &["stability", ".", "--interpreted", "--trials", "40", "--html", "page.html", "--worst", "w.jsonl"],
    );
    let page = fs::read_to_string(folder.join("page.html")).unwrap();
    assert!(page.starts_with("<!doctype html>") && page.ends_with("</html>\n"));
    let (_, data) = page.split_once("id=\"report\">").unwrap();
    let embedded: Value = serde_json::from_str(data.split_once("</script>").unwrap().0).unwrap();
    assert_eq!(embedded["rows"], report["rows"]);
    let Some(browser) = browser() else {
        println!("skipped: no Chromium is installed to open the page");
        return;
    };
    let dom = |view: &str| {
        let output = Command::new(&browser)
            .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--dump-dom"])
            .arg(format!("--user-data-dir={}", folder.join("profile").display()))
            .arg(format!("file://{}{view}", folder.join("page.html").display()))
            .output()
            .unwrap();
        stdout(&output)
    };
    check_page(&dom(""));
    // Sorted by the level: both problems take turns.
    let sorted = dom("#family=scaled&sort=2");
    let table = between(&sorted, "id=\"figures\"", "</table>");
    let levels: Vec<&str> = table.split("<tr").skip(2).map(|row| row.split("<td").nth(3).unwrap_or_default()).collect();
    let numbers: Vec<i32> =
        levels.iter().map(|cell| between(cell, ">", "<").parse().unwrap_or_else(|_| panic!("{cell}"))).collect();
    assert!(numbers.len() == 16 && numbers.is_sorted() && numbers[0] == -8 && numbers[1] == -8, "{numbers:?}");
}

/// What stands between two marks.
fn between<'a>(text: &'a str, from: &str, to: &str) -> &'a str {
    text.split_once(from).and_then(|(_, rest)| rest.split(to).next()).unwrap_or_default()
}

/// The script ran to its end, filled the tables and drew the charts of two problems.
fn check_page(dom: &str) {
    let root = dom.split('>').find(|tag| tag.trim_start().starts_with("<html")).unwrap_or_default();
    assert!(root.contains("data-ready=\"true\"") && !root.contains("data-error"), "{root}");
    let table = between(dom, "id=\"figures\"", "</table>");
    // The family `random`, which is chosen at first, has a row for each problem.
    assert_eq!((table.matches("<tr").count(), table.matches("<button").count() > 10), (3, true), "{table}");
    assert!(table.contains("two_conics") && table.contains("trilateration"), "{table}");
    let charts = between(dom, "id=\"histograms\"", "<h2>");
    assert_eq!((charts.matches("<svg").count(), charts.matches("<rect").count() >= 4), (2, true), "{charts}");
    // Scaled and degenerate, of both problems.
    assert_eq!(between(dom, "id=\"levels\"", "<h2>").matches("<svg").count(), 4);
    assert_eq!(between(dom, "id=\"worst\"", "</table>").matches("<tr").count(), 11);
}

#[cfg(unix)]
#[test]
fn ctrl_c_ends_it_and_writes_nothing() {
    let folder = problems("ctrl_c_ends_it_and_writes_nothing", &["two_conics"]);
    let mut command = Command::new(env!("CARGO_BIN_EXE_eliminant"));
    command.current_dir(&folder).args(["stability", "two_conics.rs", "--interpreted", "--csv", "figures.csv"]);
    command.args(["--trials", "1000000", "--work", "1000"]);
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    std::thread::sleep(Duration::from_secs(3));
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert!(status(&output) == 1 && stderr(&output).contains("Ctrl-C"), "{}", stderr(&output));
    assert_eq!(names(&folder), ["two_conics.rs", "two_conics.template.toml"]);
}
