//! The figures in README.md that a program can find out stand between markers, and are what it
//! finds.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::process::Command;
use std::{env, fs};

use eliminant_generator::algebra::Random;
use eliminant_tests::comparison::Comparison;
use eliminant_tests::statistics::{log10, quantile};
use eliminant_tests::{Case, cases, catalogue_page};

eliminant::include_solver!("gps");

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
        "A user's build compiles {all} crates, those of this project included; {} of them serve the\n\
         build script only.\n",
        all - linked
    )
}

/// What the catalogue shows in numbers: rows against published templates, missed solutions of
/// random data, and known solutions of scenes.
fn measured() -> String {
    let [committed, fewest] = Comparison::new(&cases()).expect("tables of the catalogue").bullets();
    let (failures, recovered) = (column("failures"), column("recovered"));
    let count = |shares: &[f64], wanted: f64| shares.iter().filter(|&&share| share == wanted).count();
    let most = 100.0 * failures.iter().copied().fold(0.0, f64::max);
    let least = 100.0 * recovered.iter().copied().fold(1.0, f64::min);
    let all = failures.len();
    format!(
        "{committed}{fewest}\
         - Of random data, up to 10,000 instances of each problem, solutions are missing on no instance\n  \
         for {} of {all} problems, and on at most {most:.2} % for the others.\n\
         - Of scenes, which geometry makes, as many of each, all known solutions are found to 1e-6\n  \
         for {} of {all} problems on every scene, and on at least {least:.2} % for the others.\n",
        count(&failures, 0.0),
        count(&recovered, 1.0)
    )
}

/// A column of the catalogue that holds a share of the instances of each problem.
fn column(head: &str) -> Vec<f64> {
    let page = catalogue();
    let share = |case: &Case| catalogue_page::row(&page, case.name)?.get(head)?.parse().ok();
    cases().iter().map(|case| share(case).unwrap_or_else(|| panic!("{}: no share in `{head}`", case.name))).collect()
}

fn catalogue() -> String {
    fs::read_to_string(catalogue_page::path()).expect("templates/README.md")
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
    let parts = [("solvers", solver_table()), ("build-cost", build_cost()), ("measured", measured())];
    let new = parts.iter().fold(old.clone(), |text, (name, content)| replaced(&text, name, content));
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

/// The example solves the problem that README.md shows.
#[test]
fn the_example_is_the_problem_shown() {
    let text = fs::read_to_string(root().join("README.md")).expect("README.md");
    let (_, rest) = text.split_once("```rust problem\n").expect("a fenced problem");
    let (problem, _) = rest.split_once("```").expect("its end");
    let committed = fs::read_to_string(root().join("examples/own-problem/problems/gps.rs")).expect("the example");
    let code = |text: &str| {
        text.lines().filter(|line| !line.trim_start().starts_with("//")).map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(code(problem), code(&committed), "README.md shows another problem than the example solves");
}

/// Receivers on a sphere of radius 1, satellites on one of radius 4, clocks off by up to 1: the
/// position and the offset are found. The solver is emitted by the build script from the text of
/// README.md.
#[test]
fn the_problem_shown_is_solved() {
    const RECEIVERS: usize = 10_000;
    let (mut errors, mut both) = (Vec::new(), 0);
    for k in 0..RECEIVERS as u64 {
        let mut random = Random::new(70_000_000 + k);
        let mut on_sphere = |radius: f64| {
            let point: [f64; 3] = std::array::from_fn(|_| random.symmetric_unit());
            point.map(|x| x * radius / length(point))
        };
        let receiver = on_sphere(1.0);
        let satellites: [[f64; 3]; 4] = std::array::from_fn(|_| on_sphere(4.0));
        let offset = random.symmetric_unit();
        let pseudoranges =
            satellites.map(|satellite| length(std::array::from_fn(|i| satellite[i] - receiver[i])) + offset);
        let solutions = gps::solve(&satellites, &pseudoranges).expect("four satellites in general position");
        both += usize::from(solutions.len() == 2);
        let error = |s: &[f64; 4]| {
            length([s[0] - receiver[0], s[1] - receiver[1], s[2] - receiver[2]]).max((s[3] - offset).abs())
        };
        errors.push(solutions.iter().map(|s| error(&[s.x, s.y, s.z, s.offset])).fold(f64::INFINITY, f64::min));
    }
    let found = errors.iter().filter(|&&error| error <= 1e-9).count();
    let quantiles = [0.5, 0.99, 0.999, 1.0].map(|q| log10(quantile(&mut errors, q)));
    println!("{found} of {RECEIVERS} receivers found, two solutions on {both}, log10 error {quantiles:.1?}");
    assert!(both == RECEIVERS, "two solutions on {both} only");
    assert!(found * 1000 >= RECEIVERS * 999 && quantiles[0] <= -14.0, "{found} found, log10 error {quantiles:.1?}");
}

fn length(x: [f64; 3]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// The catalogue has every problem with its template as it is now; its measurements are only as old
/// as the template.
#[test]
fn the_catalogue_has_every_template() {
    let page = catalogue();
    for case in cases() {
        let template = case.template().template;
        let row = catalogue_page::row(&page, case.name).unwrap_or_default();
        let size = format!("{}x{}", template.rows(), template.columns());
        let is = |head: &str, cell: String| row.get(head) == Some(&cell);
        let is_current = is("template", size) && is("basis", template.basis.len().to_string());
        assert!(is_current, "{}: run `cargo run --release -p eliminant-tests --bin catalogue -- --update`", case.name);
    }
}
