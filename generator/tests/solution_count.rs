//! The number of solutions in a template file is verified like everything else in it, without
//! Gröbner bases: these tests also run without the feature `search`.

use std::fs;
use std::path::PathBuf;
use std::time::Instant;

use eliminant_generator::algebra::Monomial;
use eliminant_generator::generate::{GenerateError, plan};
use eliminant_generator::presolve::Presolve;
use eliminant_generator::problem::Problem;
use eliminant_generator::template::file::TemplateFile;
use eliminant_generator::template::{EliminationTemplate, RootMethod, Shift};

const TEMPLATES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../templates");

fn problem_files() -> Vec<PathBuf> {
    let entries = fs::read_dir(TEMPLATES).expect("the folder of templates");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let mut paths: Vec<PathBuf> = paths.filter(|path| path.extension().is_some_and(|end| end == "rs")).collect();
    paths.sort();
    paths
}

fn read(path: &PathBuf) -> (Problem, TemplateFile) {
    let text = |path: &PathBuf| fs::read_to_string(path).expect("a committed file");
    let problem = Problem::parse("problem.rs", &text(path)).expect("a problem");
    let template = text(&path.with_extension("template.toml"));
    let file = TemplateFile::parse(&template, &problem.unknowns).expect("a template file");
    (problem, file)
}

/// The bounds that the template gives, by what it says of a number that is out of the question.
fn bounds(problem: &Problem, file: &TemplateFile) -> [usize; 2] {
    let mut file = file.clone();
    file.solutions = 0;
    match plan(problem, &file) {
        Err(GenerateError::Solutions { file: 0, found }) => [found.least, found.most],
        other => panic!("{}: no solution: {:?}", problem.name, other.map(|planned| planned.plan.solutions)),
    }
}

#[test]
fn every_committed_number_is_allowed_and_others_are_not() {
    let (mut all, mut exact, mut shared) = (0, 0, Vec::new());
    for path in problem_files() {
        let (problem, mut file) = read(&path);
        let (name, solutions) = (problem.name.as_str(), file.solutions);
        let start = Instant::now();
        if let Err(error) = plan(&problem, &file) {
            panic!("{name}: {error}");
        }
        let seconds = start.elapsed().as_secs_f64();
        let [least, most] = bounds(&problem, &file);
        println!("{name}: {least} to {most}, |B| {}, verified in {seconds:.3} s", file.template.basis.len());
        assert!(least <= solutions && solutions <= most, "{name}");
        for wrong in [solutions - 1, solutions + 1] {
            file.solutions = wrong;
            let result = plan(&problem, &file);
            assert_eq!(result.is_ok(), (least..=most).contains(&wrong), "{name}: {wrong} solutions");
            assert!(result.err().is_none_or(|error| error.is_stale_template()), "{name}");
        }
        (all, exact) = (all + 1, exact + usize::from(least == most));
        if least < solutions {
            shared.push(name.to_owned());
        }
    }
    // An eigenvalue with several eigenvectors leaves bounds. Nearly always only what is no solution
    // has one, and then no number that is too small is allowed.
    println!("{exact} of {all} are exact; solutions share a value of the action in {shared:?}");
    assert!(3 * exact >= 2 * all, "{exact} of {all}");
    assert!(10 * shared.len() <= all, "{shared:?}");
}

#[test]
fn the_message_holds_both_numbers() {
    let read = |name: &str| read(&PathBuf::from(TEMPLATES).join(name).with_extension("rs"));
    // In the last two signs can be changed, and all unknowns 0 is a solution.
    for (name, wrong, solutions) in
        [("relpose_4pt_angle", 19, 20), ("pose_3pt_depths", 4, 8), ("tensor_eigenvectors", 7, 8)]
    {
        let (problem, mut file) = read(name);
        file.solutions = wrong;
        let message = plan(&problem, &file).expect_err("a wrong number of solutions").to_string();
        assert_eq!(message, format!("the template file says {wrong} solutions, the template gives {solutions}"));
    }
    let (problem, mut file) = read("katsura_5");
    let [least, most] = bounds(&problem, &file);
    file.solutions = least - 1;
    let message = plan(&problem, &file).expect_err("a wrong number of solutions").to_string();
    let range = if least < most { format!("{least} to {most}") } else { least.to_string() };
    assert!(message.ends_with(&format!("the template gives {range}")), "{message}");
}

/// A template file for a problem in x and y, with eigenvalues, that was not presolved.
fn template_file(
    problem: &Problem,
    action: [i8; 2],
    columns: [&[[i8; 2]]; 2],
    shifts: &[(usize, [i8; 2])],
) -> TemplateFile {
    let all = |list: &[[i8; 2]]| list.iter().map(|exponents| Monomial::from_exponents(exponents)).collect::<Vec<_>>();
    let shift = |&(equation, exponents): &(usize, [i8; 2])| Shift {
        equation,
        multiplier: Monomial::from_exponents(&exponents),
    };
    TemplateFile {
        problem: problem.name.clone(),
        fingerprint: problem.fingerprint(),
        solutions: 0,
        presolve: Presolve::None,
        roots: RootMethod::Eigenvalues,
        template: EliminationTemplate {
            shifts: shifts.iter().map(shift).collect(),
            action: Monomial::from_exponents(&action),
            excess: Vec::new(),
            reducible: all(columns[0]),
            basis: all(columns[1]),
        },
        zero_sets: Vec::new(),
        provenance: Vec::new(),
    }
}

/// The numbers of solutions that may stand in the file.
fn allowed(problem: &Problem, file: &TemplateFile) -> Vec<usize> {
    let is_allowed = |&solutions: &usize| plan(problem, &TemplateFile { solutions, ..file.clone() }).is_ok();
    (0..10).filter(is_allowed).collect()
}

/// x (x - a) = 0 and y = x + x^2: the origin is known, and an eigenpair gives it once more.
#[test]
fn the_origin_counts_once() {
    let text = "fn at_origin(a: [f64; 1]) -> (x, y) { x * x == a[0] * x; y == x + x * x; }";
    let problem = Problem::parse("at_origin.rs", text).expect("a problem");
    let columns: [&[[i8; 2]]; 2] = [&[[2, 0], [0, 1]], &[[1, 0], [0, 0]]];
    let file = template_file(&problem, [1, 0], columns, &[(0, [0, 0]), (1, [0, 0])]);
    assert!(problem.has_origin());
    assert_eq!(allowed(&problem, &file), [2]);
}

/// With x^2 = a as the action all vectors (1, y) are eigenvectors: y^2 = b is not used. Each of the
/// two may belong to two solutions, which differ in the sign of x.
#[test]
fn eigenvectors_that_share_an_eigenvalue_may_be_solutions() {
    let text = "fn shared(a: [f64; 2]) -> (x, y) { x * x == a[0]; y * y == a[1]; }";
    let problem = Problem::parse("shared.rs", text).expect("a problem");
    let columns: [&[[i8; 2]]; 2] = [&[[2, 0], [2, 1]], &[[0, 0], [0, 1]]];
    let file = template_file(&problem, [2, 0], columns, &[(0, [0, 0]), (0, [0, 1])]);
    assert_eq!(allowed(&problem, &file), [0, 1, 2, 3, 4]);
}
