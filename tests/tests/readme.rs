//! The figures in README.md that a program can find out stand between markers, and are what it finds.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::process::Command;
use std::{env, fs};

use eliminant_tests::cases;

const UPDATE: &str = "UPDATE_GOLDEN=1 cargo test --release -p eliminant-tests --test readme";

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Every committed solver with its size.
fn solver_table() -> String {
    let mut table =
        "| problem | unknowns | solutions | template | basis | operations |\n|---|--:|--:|--:|--:|--:|\n".to_owned();
    for case in cases() {
        let (name, template, plan) = (case.name, case.template().template, case.planned().plan);
        writeln!(
            table,
            "| [`{name}`](templates/{name}.rs) | {} | {} | {} x {} | {} | {} |",
            plan.unknowns.len(),
            plan.solutions,
            template.rows(),
            template.columns(),
            template.basis.len(),
            plan.operations().total()
        )
        .expect("a string takes all");
    }
    table
}

/// The crates that a user's build compiles, by cargo's own account of `examples/own-problem`.
fn build_cost() -> String {
    let manifest = root().join("examples/own-problem/Cargo.toml");
    let tree = |edges: &str| {
        let output = Command::new(env!("CARGO"))
            .args(["tree", "--locked", "--prefix", "none", "--format", "{p}", "--no-dedupe", "--edges", edges])
            .arg("--manifest-path")
            .arg(&manifest)
            .output()
            .expect("cargo runs");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let text = String::from_utf8(output.stdout).expect("UTF-8");
        let mut crates: Vec<String> =
            text.lines().map(str::to_owned).filter(|line| !line.starts_with("own-problem ")).collect();
        crates.sort();
        crates.dedup();
        crates.len()
    };
    let (all, linked) = (tree("normal,build"), tree("normal,no-proc-macro"));
    format!(
        "A user's build compiles {all} crates, those of this project included; {} of them serve the build script only.\n",
        all - linked
    )
}

/// Replaces what stands between `<!-- name:begin -->` and `<!-- name:end -->`.
fn replaced(text: &str, name: &str, content: &str) -> String {
    let (begin, end) = (format!("<!-- {name}:begin -->\n"), format!("<!-- {name}:end -->"));
    let (before, rest) = text.split_once(&begin).unwrap_or_else(|| panic!("README.md lacks {begin}"));
    let (_, after) = rest.split_once(&end).unwrap_or_else(|| panic!("README.md lacks {end}"));
    format!("{before}{begin}{content}{end}{after}")
}

#[test]
fn generated_parts_are_up_to_date() {
    let path = root().join("README.md");
    let old = fs::read_to_string(&path).expect("README.md");
    let new = replaced(&replaced(&old, "solvers", &solver_table()), "build-cost", &build_cost());
    if old == new {
        return;
    }
    if env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(path, new).expect("README.md can be written");
        return;
    }
    let changed = new.lines().filter(|line| !old.lines().any(|other| other == *line));
    panic!("README.md is out of date. Now:\n{}\nAccept with\n    {UPDATE}", changed.collect::<Vec<_>>().join("\n"));
}

/// The problem shown in README.md is one that the language takes, and has as many solutions as it says.
#[test]
fn the_problem_shown_is_good() {
    let text = fs::read_to_string(root().join("README.md")).expect("README.md");
    let (_, rest) = text.split_once("```rust problem\n").expect("a fenced problem");
    let (problem, _) = rest.split_once("```").expect("its end");
    let committed = fs::read_to_string(root().join("examples/own-problem/problems/gps.rs")).expect("the example");
    let code = |text: &str| {
        text.lines().filter(|line| !line.trim_start().starts_with("//")).map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(code(problem), code(&committed), "README.md shows another problem than the example solves");
}

/// The catalogue has every problem with its template as it is now; its measurements are only as old as the template.
#[test]
fn the_catalogue_has_every_template() {
    let page = fs::read_to_string(root().join("templates/README.md")).expect("templates/README.md");
    for case in cases() {
        let template = case.template().template;
        let row = page.lines().find(|line| line.contains(&format!("({}.rs)", case.name))).unwrap_or_default();
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        let (size, basis) = (format!("{}x{}", template.rows(), template.columns()), template.basis.len().to_string());
        let is_current = cells.contains(&size.as_str()) && cells.contains(&basis.as_str());
        assert!(is_current, "{}: run `cargo run --release -p eliminant-tests --bin catalogue -- --update`", case.name);
    }
}
