//! Searches that are shared between machines, that time or a person ends, and that find nothing.
#![cfg(feature = "command")]

mod support;

use std::fs;
use std::path::Path;
use std::process::Command;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use eliminant_generator::check::check;
use eliminant_generator::problem::Problem;
use eliminant_generator::search::monitor::{Monitor, Stage, Unmonitored};
use eliminant_generator::search::{SearchError, SearchOptions, candidates};
use support::{TWO_CONICS, eliminant, folder, json, names, status, stderr, stdout, two_conics};

const TEMPLATE: &str = "two_conics.template.toml";

fn search(folder: &Path, more: &[&str]) -> std::process::Output {
    eliminant(folder, &[&["search", "two_conics.rs", "--trials", "50", "--confirm", "1000"], more].concat())
}

fn must_search(folder: &Path, more: &[&str]) -> String {
    let output = search(folder, more);
    assert_eq!(status(&output), 0, "{}", stderr(&output));
    stdout(&output)
}

#[test]
fn four_shards_merged_give_the_bytes_of_one_search() {
    let folder = two_conics("four_shards_merged_give_the_bytes_of_one_search");
    let files: Vec<String> = (1..=4).map(|number| format!("two_conics.shard-{number}-of-4.json")).collect();
    for prefer in ["speed", "size", "stability"] {
        must_search(&folder, &["--prefer", prefer]);
        let alone = fs::read_to_string(folder.join(TEMPLATE)).unwrap();
        fs::remove_file(folder.join(TEMPLATE)).unwrap();
        for shard in ["1/4", "2/4", "3/4", "4/4"] {
            let text = must_search(&folder, &["--prefer", prefer, "--shard", shard]);
            assert!(text.starts_with(&format!("shard {shard}:")), "{text}");
        }
        assert!(!folder.join(TEMPLATE).exists(), "only the merge writes a template");
        let merge = |order: [usize; 4]| {
            let mut arguments = vec!["search", "two_conics.rs", "--merge"];
            arguments.extend(order.map(|at| files[at].as_str()));
            let output = eliminant(&folder, &arguments);
            assert_eq!(status(&output), 0, "{}", stderr(&output));
            fs::read_to_string(folder.join(TEMPLATE)).unwrap()
        };
        assert_eq!(merge([0, 1, 2, 3]), alone, "{prefer}");
        assert_eq!(merge([2, 0, 3, 1]), alone, "{prefer}");
    }
}

#[test]
fn a_template_of_shards_that_were_cut_short_says_so() {
    let folder = two_conics("a_template_of_shards_that_were_cut_short_says_so");
    for shard in ["1/2", "2/2"] {
        must_search(&folder, &["--shard", shard, "--out", &shard.replace('/', "-of-")]);
    }
    let text = fs::read_to_string(folder.join("2-of-2")).unwrap();
    let cut = text.replace("\"is_cut\": false", "\"is_cut\": true");
    assert_ne!(cut, text);
    fs::write(folder.join("2-of-2"), cut).unwrap();
    let merged = eliminant(&folder, &["search", "two_conics.rs", "--merge", "1-of-2", "2-of-2"]);
    assert!(stdout(&merged).contains("warning: the end of shards ended the search"), "{}", stdout(&merged));
    assert!(fs::read_to_string(folder.join(TEMPLATE)).unwrap().ends_with("\nended_early = \"shards\"\n"));
    let checked = eliminant(&folder, &["search", "--check", "two_conics.rs"]);
    assert_eq!(status(&checked), 1);
    // Nothing was left out, so that the rest is the same.
    let expected =
        "two_conics.rs: comes of a search that was ended early (shards), which cannot be repeated\n1 template";
    assert!(stdout(&checked).starts_with(expected), "{}", stdout(&checked));
}

#[test]
fn the_number_of_threads_does_not_matter() {
    let folder = two_conics("the_number_of_threads_does_not_matter");
    let written = |threads: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_eliminant"));
        command.current_dir(&folder).env("RAYON_NUM_THREADS", threads);
        let output = command.args(["search", "two_conics.rs", "--trials", "50", "--confirm", "1000"]).output().unwrap();
        assert_eq!(status(&output), 0, "{}", stderr(&output));
        fs::read_to_string(folder.join(TEMPLATE)).unwrap()
    };
    let one = written("1");
    assert_eq!(written("2"), one);
    assert_eq!(written("5"), one);
}

#[test]
fn shards_that_do_not_belong_together_are_refused() {
    let folder = two_conics("shards_that_do_not_belong_together_are_refused");
    let shard = |out: &str, more: &[&str]| must_search(&folder, &[&["--out", out], more].concat());
    shard("a.json", &["--shard", "1/2"]);
    shard("b.json", &["--shard", "2/2"]);
    shard("third.json", &["--shard", "2/3"]);
    shard("seed.json", &["--shard", "2/2", "--seed", "7"]);
    fs::write(folder.join("broken.json"), "{}").unwrap();
    let text = fs::read_to_string(folder.join("b.json")).unwrap();
    fs::write(folder.join("other.json"), text.replacen("two_conics", "three_conics", 1)).unwrap();
    // A template that was tampered with is checked like any other.
    fs::write(folder.join("false.json"), text.replace("multipliers = [", "multipliers = [\\\"x^3\\\", ")).unwrap();
    fs::write(folder.join(TEMPLATE), "old").unwrap();
    for (files, expected) in [
        (vec!["a.json"], vec!["2/2 are missing", "--shard i/n"]),
        (vec!["a.json", "a.json"], vec!["`a.json`", "1/2 again"]),
        (vec!["a.json", "third.json"], vec!["`third.json`", "not of the same search"]),
        (vec!["a.json", "seed.json"], vec!["`seed.json`", "other options"]),
        (vec!["broken.json"], vec!["`broken.json`", "not a file of a shard"]),
        (vec!["a.json", "other.json"], vec!["`other.json`", "another problem"]),
        (vec!["a.json", "false.json"], vec!["`false.json`", "`rows`"]),
        (vec!["a.json", "missing.json"], vec!["`missing.json`", "no such file"]),
    ] {
        let output = eliminant(&folder, &[vec!["search", "two_conics.rs", "--merge"], files.clone()].concat());
        assert_eq!(status(&output), 1, "{files:?}");
        assert!(expected.iter().all(|part| stderr(&output).contains(part)), "{files:?}: {}", stderr(&output));
        assert_eq!(fs::read_to_string(folder.join(TEMPLATE)).unwrap(), "old", "{files:?}");
    }
    for wrong in
        [&["--shard", "3/2"][..], &["--shard", "x"], &["--shard", "1/2", "--merge", "a.json"], &["--budget", "0"]]
    {
        assert_eq!(status(&search(&folder, wrong)), 2, "{wrong:?}");
    }
}

#[test]
fn the_strategies_of_a_failed_search_are_told() {
    let folder = two_conics("the_strategies_of_a_failed_search_are_told");
    fs::write(folder.join(TEMPLATE), "old").unwrap();
    let output = search(&folder, &["--max-columns", "7"]);
    assert_eq!(status(&output), 1);
    let message = stderr(&output);
    for part in ["within 7 columns", "tried", "the largest 2 x 6", "degree with weights [1, 1], up to 2 x 6, and "] {
        assert!(message.contains(part), "{part}: {message}");
    }
    assert!(["closed under", "cannot be read"].iter().any(|reason| message.contains(reason)), "{message}");
    assert!(message.contains("help: `--max-columns 21` looks further"), "{message}");
    assert!(!message.contains("of its own"), "{message}");
    // A factor of several terms hides what could be done with an unknown.
    let problem = TWO_CONICS.trim_end().strip_suffix('}').unwrap();
    fs::write(folder.join("two_conics.rs"), format!("{problem}    x + y + 1 != 0;\n}}\n")).unwrap();
    let with_factor = search(&folder, &["--max-columns", "7"]);
    assert!(stderr(&with_factor).contains("help: rows can be divided by a factor"), "{}", stderr(&with_factor));
    fs::write(folder.join("two_conics.rs"), TWO_CONICS).unwrap();
    // Shards that find nothing say so, and so does the merge.
    for shard in ["1/2", "2/2"] {
        must_search(&folder, &["--max-columns", "7", "--shard", shard, "--out", &shard.replace('/', "-of-")]);
    }
    let merged = eliminant(&folder, &["search", "two_conics.rs", "--merge", "1-of-2", "2-of-2"]);
    assert_eq!(status(&merged), 1);
    assert!(stderr(&merged).contains("degree with weights [1, 1], up to 2 x 6, and "), "{}", stderr(&merged));
    assert_eq!(fs::read_to_string(folder.join(TEMPLATE)).unwrap(), "old");
}

#[test]
fn a_budget_that_does_not_bind_changes_nothing() {
    let folder = two_conics("a_budget_that_does_not_bind_changes_nothing");
    must_search(&folder, &[]);
    let free = fs::read_to_string(folder.join(TEMPLATE)).unwrap();
    let report = json(&folder, &["search", "two_conics.rs", "--trials", "50", "--confirm", "1000", "--budget", "3600"]);
    assert!(report["cut"].is_null(), "{report}");
    assert_eq!(fs::read_to_string(folder.join(TEMPLATE)).unwrap(), free);
    // No time at all, and a limit on columns: nothing can be found, and nothing is touched.
    let output = search(&folder, &["--budget", "1e-9", "--max-columns", "600"]);
    assert_eq!(status(&output), 1);
    assert!(stderr(&output).contains("the search ended early"), "{}", stderr(&output));
    assert_eq!(fs::read_to_string(folder.join(TEMPLATE)).unwrap(), free);
    assert_eq!(names(&folder), ["two_conics.rs", TEMPLATE]);
    // Without a limit there is a template by the trace of a Gröbner basis.
    let traced = json(&folder, &["search", "two_conics.rs", "--budget", "1e-9"]);
    assert_eq!((&traced["rows"], &traced["basis"]), (&6.into(), &4.into()), "{traced}");
}

/// A monitor that ends the search after this number of questions.
struct Impatient(AtomicUsize, usize);

impl Monitor for Impatient {
    fn say(&self, _: &str) {}

    fn is_over(&self, stage: Stage) -> bool {
        stage == Stage::Searching && self.0.fetch_add(1, Ordering::Relaxed) >= self.1
    }
}

#[test]
fn wherever_a_search_ends_what_it_has_found_holds() {
    let problem = Problem::parse("two_conics.rs", TWO_CONICS).unwrap();
    let algebra = check(&problem).unwrap();
    let options = SearchOptions::default();
    let all = candidates(&problem, &algebra, &options, &Unmonitored).unwrap();
    assert!(!all.is_cut && all.untried == 0);
    let (mut nothing, mut some) = (0, 0);
    for questions in 0..60 {
        match candidates(&problem, &algebra, &options, &Impatient(0.into(), questions)) {
            Err(SearchError::NotFound { is_over, .. }) => {
                nothing += 1;
                assert!(is_over);
            }
            Err(error) => panic!("{error}"),
            Ok(found) => {
                some += 1;
                assert!(found.is_cut && found.untried > 0);
                // Candidates are verified; that a plan follows from each says that it is whole.
                assert!(found.candidates.iter().all(|candidate| candidate.plan.check().is_ok()));
            }
        }
    }
    assert!(nothing > 0 && some > 0, "{nothing} {some}");
}

/// A monitor that counts the steps of each part of the work.
#[derive(Default)]
struct Counting(Mutex<Vec<[usize; 2]>>);

impl Monitor for Counting {
    fn say(&self, _: &str) {}

    fn begin(&self, _: &str, steps: usize) {
        self.0.lock().unwrap().push([steps, 0]);
    }

    fn step(&self) {
        self.0.lock().unwrap().last_mut().unwrap()[1] += 1;
    }

    fn is_over(&self, _: Stage) -> bool {
        false
    }
}

#[test]
fn a_search_tells_how_much_is_done_and_how_much_is_left() {
    let problem = Problem::parse("two_conics.rs", TWO_CONICS).unwrap();
    let counting = Counting::default();
    let found = candidates(&problem, &check(&problem).unwrap(), &SearchOptions::default(), &counting).unwrap();
    let parts = counting.0.into_inner().unwrap();
    let [[growing, grown], [planning, planned]] = parts[..] else { panic!("{parts:?}") };
    assert_eq!((growing, grown, planned), (found.strategies, found.strategies, planning));
    assert!(planning >= found.candidates.len());
}

#[cfg(unix)]
mod interrupted {
    use std::process::{Child, Stdio};
    use std::thread::sleep;
    use std::time::{Duration, Instant};

    use super::*;

    const SLOW: &str = include_str!("../../templates/relpose_6pt_focal.rs");
    /// Nothing is found within minutes.
    const SLOWEST: &str = include_str!("../../templates/relpose_7pt_focal_radial.rs");

    /// A search that takes long, begun, of the problem `name`, called `slow`, with an old template
    /// in its folder.
    fn begin(folder: &Path, problem: &str, name: &str) -> Child {
        fs::write(folder.join("slow.rs"), problem.replace(name, "slow")).unwrap();
        fs::write(folder.join("slow.template.toml"), "old").unwrap();
        let mut command = Command::new(env!("CARGO_BIN_EXE_eliminant"));
        command.current_dir(folder).args(["search", "slow.rs", "--shuffles", "10000", "--trials", "100"]);
        command.args(["--confirm", "200"]).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
    }

    fn interrupt(child: &Child) {
        assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    }

    #[test]
    fn ctrl_c_twice_leaves_the_old_template() {
        let folder = folder("ctrl_c_twice_leaves_the_old_template");
        let child = begin(&folder, SLOWEST, "relpose_7pt_focal_radial");
        for _ in 0..2 {
            sleep(Duration::from_secs(1));
            interrupt(&child);
        }
        let output = child.wait_with_output().unwrap();
        // 1 if the first ended the search before the second came; no code at all if the command did
        // not listen.
        assert!(matches!(output.status.code(), Some(130 | 1)), "{}", stderr(&output));
        assert_eq!(names(&folder), ["slow.rs", "slow.template.toml"]);
        assert_eq!(fs::read_to_string(folder.join("slow.template.toml")).unwrap(), "old");
    }

    #[test]
    fn ctrl_c_is_answered_soon_at_any_time() {
        let folder = folder("ctrl_c_is_answered_soon_at_any_time");
        for (problem, name) in [(SLOW, "relpose_6pt_focal"), (SLOWEST, "relpose_7pt_focal_radial")] {
            for seconds in [0.2, 1.0, 4.0] {
                let child = begin(&folder, problem, name);
                sleep(Duration::from_secs_f64(seconds));
                interrupt(&child);
                let start = Instant::now();
                let output = child.wait_with_output().unwrap();
                let took = start.elapsed();
                println!("{name} after {seconds} s: {:?} in {took:?}", output.status.code());
                assert!(took < Duration::from_secs(5), "{name} after {seconds} s: {took:?}");
                // All of a template is written or nothing.
                assert_eq!(names(&folder), ["slow.rs", "slow.template.toml"]);
                let template = fs::read_to_string(folder.join("slow.template.toml")).unwrap();
                match output.status.code() {
                    Some(0) => assert!(template.ends_with("\nended_early = \"interrupt\"\n"), "{template}"),
                    // No code is that of a command that did not listen yet.
                    Some(1 | 130) | None => assert_eq!(template, "old", "{}", stderr(&output)),
                    Some(code) => panic!("{code}: {}", stderr(&output)),
                }
            }
        }
    }

    #[test]
    fn ctrl_c_keeps_the_best_found_so_far() {
        let folder = folder("ctrl_c_keeps_the_best_found_so_far");
        let child = begin(&folder, SLOW, "relpose_6pt_focal");
        sleep(Duration::from_secs(5));
        interrupt(&child);
        let output = child.wait_with_output().unwrap();
        let template = fs::read_to_string(folder.join("slow.template.toml")).unwrap();
        if status(&output) == 0 {
            assert!(stdout(&output).contains("Ctrl-C ended the search"), "{}", stdout(&output));
            let good = eliminant(&folder, &["stability", "slow.rs", "--trials", "10", "--interpreted"]);
            assert_eq!(status(&good), 0, "{}", stderr(&good));
        } else {
            // On a slow machine nothing may have been found yet, or not been verified.
            let reasons = ["the search ended early", "Ctrl-C ended the search"];
            assert!(reasons.iter().any(|reason| stderr(&output).contains(reason)), "{}", stderr(&output));
            assert_eq!(template, "old");
        }
    }
}
