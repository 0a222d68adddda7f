//! Emits the solvers of the problems that features enable, their C functions and headers, and a
//! table of them for the tests.

use std::path::{Path, PathBuf};
use std::{env, error, fs};

use eliminant_capi_generator::{Field, Interface, Library, Row, interfaces};
use eliminant_templates::FOLDER;

fn main() -> Result<(), Box<dyn error::Error>> {
    println!("cargo:rerun-if-changed=build.rs");
    let interfaces = interfaces(Path::new(FOLDER), is_enabled)?;
    let enabled: Vec<&str> = interfaces.iter().map(|interface| interface.name.as_str()).collect();
    Library::new("eliminant").problems(FOLDER).only(enabled).run()?;
    let out_dir = env::var_os("OUT_DIR").map(PathBuf::from).ok_or("OUT_DIR is not set")?;
    let cases: String = interfaces.iter().map(case).collect();
    fs::write(out_dir.join("cases.rs"), format!("vec![\n{cases}]\n"))?;
    Ok(())
}

fn is_enabled(problem: &str) -> bool {
    env::var_os(format!("CARGO_FEATURE_{}", problem.to_uppercase())).is_some()
}

/// The entries of the table for a problem: for each kind of rows, C functions and Rust function
/// with the same parameters.
fn case(interface: &Interface) -> String {
    interface.rows.iter().map(|row| case_of_row(interface, row)).collect()
}

fn case_of_row(interface: &Interface, row: &Row) -> String {
    let name = &interface.name;
    let each = |print: &dyn Fn(usize, &Field) -> String| {
        interface.data.iter().enumerate().map(|(at, field)| print(at, field)).collect::<String>()
    };
    let lengths = each(&|_, field| format!("({}, {}), ", field.len(), field.shape.is_empty()));
    let single = each(&|at, field| match field.shape.is_empty() {
        true => format!("data[{at}].number(), "),
        false => format!("data[{at}].pointer, data[{at}].length, "),
    });
    let lists = each(&|at, _| format!("data[{at}].pointer, data[{at}].length, "));
    let reads = each(&|at, field| match field.shape.is_empty() {
        true => format!("take(data[{at}]), "),
        false => format!("&take(data[{at}]), "),
    });
    let put = |field: &Field| format!("Numbers::put(&row.{}, &mut to);", field.name);
    let put: String = row.fields.iter().map(put).collect();
    let ((solve, _), (solve_batch, _)) = (interface.solve(row), interface.solve_batch(row));
    format!(
        "Case {{
    name: \"{name}{suffix}\",
    data: &[{lengths}],
    row: {length},
    most: {most},
    solve: |data, out| unsafe {{
        let _ = data;
        eliminant_c::functions::{name}::eliminant_{solve}({single}out.solutions, out.length, out.counts)
    }},
    solve_batch: |instances, data, out| unsafe {{
        let _ = data;
        eliminant_c::functions::{name}::eliminant_{solve_batch}(
            instances, {lists}out.solutions, out.length, out.counts, out.codes)
    }},
    in_rust: |data| {{
        let _ = data;
        let found = eliminant_c::{name}::solve{suffix}({reads}).map_err(Code::from)?;
        let mut numbers = Vec::new();
        for row in &found {{
            let mut to = |number| numbers.push(number);
            {put}
        }}
        Ok(numbers)
    }},
}},
",
        suffix = row.suffix,
        length = row.len(),
        most = interface.solutions,
    )
}
