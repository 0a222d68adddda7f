//! Emits the solver of the problem that README.md shows, with the template of `examples/own-problem`, so that a
//! test can run what a reader sees.

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use eliminant_generator::generate::generate;
use eliminant_generator::problem::Problem;
use eliminant_generator::template::file::TemplateFile;

fn main() -> Result<(), Box<dyn Error>> {
    emit_problem_of_readme()
}

fn emit_problem_of_readme() -> Result<(), Box<dyn Error>> {
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
    let solver = generate(&problem, &template)?;
    let out_dir = env::var_os("OUT_DIR").ok_or("OUT_DIR is not set: this is for build scripts")?;
    fs::write(Path::new(&out_dir).join("gps.rs"), solver)?;
    Ok(())
}
