//! The scenes of the catalogue: what a problem file says of its solutions is what the solver finds.

use eliminant_generator::algebra::Random;
use eliminant_generator::generate::plan;
use eliminant_generator::problem::scene::{DrawnScene, Scene};
use eliminant_generator::problem::{DataAttribute, DataParameter, Problem};
use eliminant_generator::search::measuring::interpreted::InterpretedSolver;
use eliminant_generator::search::measuring::results::has_known;
use eliminant_generator::template::file::TemplateFile;
use eliminant_tests::templates_folder;

/// Scenes of each problem; fewer of those that take long.
const SCENES: u64 = 200;
/// Floating-point operations of all scenes of a problem.
const WORK: u64 = 400_000_000;
/// How far data may be off their conditions.
const OFF: f64 = 1e-14;

fn problems() -> Vec<Problem> {
    let entries = std::fs::read_dir(templates_folder()).expect("the folder");
    let mut files: Vec<_> = entries.map(|entry| entry.expect("an entry").path()).collect();
    files.retain(|file| file.extension().is_some_and(|extension| extension == "rs"));
    files.sort();
    let read = |file: &std::path::PathBuf| std::fs::read_to_string(file).expect("a problem file");
    let named = |file: &std::path::PathBuf| file.file_name().expect("a name").to_string_lossy().into_owned();
    files.iter().map(|file| Problem::parse(&named(file), &read(file)).expect("a problem")).collect()
}

/// How far the vectors of a parameter are off the length 1, and rotations off being orthogonal.
fn off_condition(parameter: &DataParameter, data: &[f64]) -> f64 {
    let values = &data[parameter.first_input..][..parameter.len()];
    let products = |rows: &[f64], n: usize| -> f64 {
        let dot = |i: usize, j: usize| (0..n).map(|k| rows[i * n + k] * rows[j * n + k]).sum::<f64>();
        let pairs = (0..rows.len() / n).flat_map(|i| (0..=i).map(move |j| (i, j)));
        pairs.map(|(i, j)| (dot(i, j) - f64::from(u8::from(i == j))).abs()).fold(0.0, f64::max)
    };
    match parameter.attribute {
        DataAttribute::Unit => {
            let n = *parameter.shape.last().expect("a vector");
            values.chunks(n).map(|vector| products(vector, n)).fold(0.0, f64::max)
        }
        DataAttribute::Rotation => values.chunks(9).map(|rows| products(rows, 3)).fold(0.0, f64::max),
        _ => 0.0,
    }
}

/// Of most scenes something is known; the solver must find it, on all but one scene in a hundred of
/// each problem. On the others it must not fail.
#[test]
fn solvers_find_what_scenes_say() {
    let mut problems = problems();
    let all = problems.len();
    problems.retain(|problem| problem.scene.is_some());
    let said = format!("{} of the {all} problems of the catalogue have one", problems.len());
    let readme = std::fs::read_to_string(templates_folder().join("../README.md")).expect("a file");
    assert!(readme.contains(&said), "README does not say that {said}");
    let known = problems.iter().filter(|problem| problem.scene.as_ref().is_some_and(Scene::has_truth)).count();
    assert_eq!(known, 50, "problems of which scenes say what solves them");
    let mut failures = Vec::new();
    for problem in &problems {
        let text = std::fs::read_to_string(templates_folder().join(format!("{}.template.toml", problem.name)));
        let file = TemplateFile::parse(&text.expect("a template"), &problem.unknowns).expect("a template");
        let plan = plan(problem, &file).expect("its template").plan;
        let (solver, scene) = (InterpretedSolver::of(&plan), problem.scene.as_ref().expect("it has a scene"));
        let count = (WORK / plan.operations().total() as u64).clamp(8, SCENES);
        let scenes: Vec<_> = (0..count).map(|seed| scene.draw(&mut Random::new(seed)).expect("drawn")).collect();
        let off =
            scenes.iter().flat_map(|scene| plan.data.iter().map(|parameter| off_condition(parameter, &scene.data)));
        assert!(off.fold(0.0, f64::max) <= OFF, "data of `{}` are off their conditions", problem.name);
        let is_found =
            |scene: &&DrawnScene| solver.solve(&scene.data).is_ok_and(|points| has_known(&plan, &points, scene));
        let lost = scenes.len() - scenes.iter().filter(is_found).count();
        if lost * 100 > scenes.len() {
            failures.push(format!("{}: lost on {lost} of {count} scenes", problem.name));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
