//! Writes the table of all emitted solvers, a line `case!` for each problem of `templates/`, and
//! emits the solver of the problem that README.md shows, with the template of
//! `examples/own-problem`, so that a test can run what a reader sees.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, error, fs};

use eliminant_generator::generate::generate;
use eliminant_generator::problem::Problem;
use eliminant_generator::template::file::TemplateFile;

fn main() -> Result<(), Box<dyn error::Error>> {
    let out_dir = env::var_os("OUT_DIR").ok_or("OUT_DIR is not set: this is for build scripts")?;
    write_cases(Path::new(&out_dir))?;
    emit_problem_of_readme(Path::new(&out_dir))
}

fn write_cases(out_dir: &Path) -> Result<(), Box<dyn error::Error>> {
    println!("cargo:rerun-if-changed={}", eliminant_templates::FOLDER);
    let mut table = "vec![\n".to_owned();
    for path in problem_files()? {
        let text = fs::read_to_string(&path)?;
        let problem = Problem::parse(&path.display().to_string(), &text).map_err(|messages| messages.render())?;
        writeln!(table, "    {},", case(&problem))?;
    }
    table.push(']');
    fs::write(out_dir.join("cases.rs"), table)?;
    Ok(())
}

fn emit_problem_of_readme(out_dir: &Path) -> Result<(), Box<dyn error::Error>> {
    const README: &str = "../README.md";
    const TEMPLATE: &str = "../examples/own-problem/problems/gps.template.toml";
    println!("cargo:rerun-if-changed={README}");
    println!("cargo:rerun-if-changed={TEMPLATE}");
    let text = fs::read_to_string(README)?;
    let (_, rest) =
        text.split_once("```rust problem\n").ok_or("README.md shows no problem: a block ```rust problem")?;
    let (problem, _) = rest.split_once("```").ok_or("the problem of README.md has no end")?;
    let problem = Problem::parse("README.md", problem).map_err(|messages| messages.render())?;
    let template = TemplateFile::parse(&fs::read_to_string(TEMPLATE)?, &problem.unknowns)?;
    fs::write(out_dir.join("gps.rs"), generate(&problem, &template)?)?;
    Ok(())
}

/// All problems of the folder, sorted by their names.
fn problem_files() -> Result<Vec<PathBuf>, std::io::Error> {
    let mut files: Vec<PathBuf> = fs::read_dir(eliminant_templates::FOLDER)?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<Result<_, _>>()?;
    files.retain(|path| path.extension().is_some_and(|extension| extension == "rs"));
    files.sort();
    Ok(files)
}

/// `case!(two_conics, (p: array, q: array))`: module and data.
fn case(problem: &Problem) -> String {
    let kind = |shape: &[usize]| if shape.is_empty() { "scalar" } else { "array" };
    let data: Vec<String> =
        problem.data.iter().map(|parameter| format!("{}: {}", parameter.name, kind(&parameter.shape))).collect();
    format!("case!({}, ({}))", problem.name, data.join(", "))
}
