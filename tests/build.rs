//! Writes the table of all emitted solvers: a line `case!` for each problem of `templates/`.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, error, fs};

use eliminant_generator::problem::Problem;

fn main() -> Result<(), Box<dyn error::Error>> {
    println!("cargo:rerun-if-changed={}", eliminant_templates::FOLDER);
    let mut table = "vec![\n".to_owned();
    for path in problem_files()? {
        let text = fs::read_to_string(&path)?;
        let problem = Problem::parse(&path.display().to_string(), &text).map_err(|messages| messages.render())?;
        writeln!(table, "    {},", case(&problem))?;
    }
    table.push(']');
    let out_dir = env::var_os("OUT_DIR").ok_or("OUT_DIR is not set: this is for build scripts")?;
    fs::write(Path::new(&out_dir).join("cases.rs"), table)?;
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
