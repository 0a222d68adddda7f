//! Writes the table of all solvers, an entry `solver!` for each problem of the catalogue.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, error, fs};

use eliminant_generator::problem::{Measurement, Problem};

fn main() -> Result<(), Box<dyn error::Error>> {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-changed={}", eliminant_templates::FOLDER);
    let out_dir = env::var_os("OUT_DIR").ok_or("OUT_DIR is not set: this is for build scripts")?;
    let mut table = "&[\n".to_owned();
    for path in problem_files()? {
        let text = fs::read_to_string(&path)?;
        let problem = Problem::parse(&path.display().to_string(), &text).map_err(|messages| messages.render())?;
        table.push_str(&entry(&problem, &path)?);
    }
    table.push(']');
    fs::write(Path::new(&out_dir).join("table.rs"), table)?;
    Ok(())
}

/// All problems of the catalogue, sorted by their names.
fn problem_files() -> Result<Vec<PathBuf>, std::io::Error> {
    let mut files: Vec<PathBuf> = fs::read_dir(eliminant_templates::FOLDER)?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<Result<_, _>>()?;
    files.retain(|path| path.extension().is_some_and(|extension| extension == "rs"));
    files.sort();
    Ok(files)
}

/// The entry of a problem: module, data, fields of its solutions, results, documentation, files.
fn entry(problem: &Problem, path: &Path) -> Result<String, std::fmt::Error> {
    let kind = |shape: &[usize]| if shape.is_empty() { "scalar" } else { "array" };
    let mut text = format!("solver!({} {{\n", problem.name);
    let data = problem.data.iter().map(|data| format!("{}: {} {:?}", data.name, kind(&data.shape), data.shape));
    writeln!(text, "    data: ({}),", data.collect::<Vec<_>>().join(", "))?;
    let fields = problem.fields.iter().map(|field| format!("({:?}, &{:?})", field.name, field.shape));
    writeln!(text, "    fields: [{}],", fields.collect::<Vec<_>>().join(", "))?;
    match &problem.output {
        None => writeln!(text, "    results: none,")?,
        Some(output) => {
            let fields = output.fields.iter().map(|field| format!("{}: {:?}", field.name, field.shape));
            let fields = fields.collect::<Vec<_>>().join(", ");
            writeln!(text, "    results: {}_of_each({fields}),", output.function)?;
        }
    }
    let means = problem.measurements.iter().map(|measurement| mean(&problem.name, measurement));
    writeln!(text, "    means: &[{}],", means.collect::<Vec<_>>().join(", "))?;
    let docs: Vec<&str> = problem.docs.iter().map(|line| line.strip_prefix(' ').unwrap_or(line)).collect();
    writeln!(text, "    docs: {:?},", docs.join("\n"))?;
    writeln!(text, "    source: {:?},", path)?;
    writeln!(text, "    template: {:?},", path.with_extension("template.toml"))?;
    text.push_str("}),\n");
    Ok(text)
}

/// The entry of a mean.
fn mean(problem: &str, measurement: &Measurement) -> String {
    let Measurement { name, docs, data, shape, .. } = measurement;
    let named = data.iter().map(|data| format!("({:?}, &{:?})", data.name, data.shape));
    let read = data.iter().enumerate().map(|(number, data)| {
        let ty = data.shape.iter().rev().fold("f64".to_owned(), |inner, length| format!("[{inner}; {length}]"));
        format!("values[{number}].of::<{ty}>(at)")
    });
    let (named, read) = (named.collect::<Vec<_>>().join(", "), read.collect::<Vec<_>>());
    let item = if let [read] = &read[..] { read.clone() } else { format!("({})", read.join(", ")) };
    format!(
        "Mean {{ name: \"mean_{name}\", data: &[{named}], shape: &{shape:?}, docs: {:?}, compute: |values, count| \
         scalars(&solvers::{problem}::mean_{name}((0..count).map(|at| {item}))) }}",
        docs.join("\n"),
    )
}
