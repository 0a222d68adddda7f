//! Emits the solvers of the problems that features enable, their C functions and headers, and
//! tables of them for the tests.

use std::path::{Path, PathBuf};
use std::{env, error, fs};

use eliminant_capi_generator::{Field, Interface, Library, MEASURES, Mean, Row, interfaces};
use eliminant_templates::FOLDER;

fn main() -> Result<(), Box<dyn error::Error>> {
    println!("cargo:rerun-if-changed=build.rs");
    let interfaces = interfaces(Path::new(FOLDER), is_enabled)?;
    let enabled: Vec<&str> = interfaces.iter().map(|interface| interface.name.as_str()).collect();
    Library::new("eliminant").problems(FOLDER).only(enabled).run()?;
    let out_dir = env::var_os("OUT_DIR").map(PathBuf::from).ok_or("OUT_DIR is not set")?;
    let list = |print: fn(&Interface) -> String| {
        let items: String = interfaces.iter().map(print).collect();
        format!("vec![\n{items}]\n")
    };
    fs::write(out_dir.join("cases.rs"), list(cases_of_rows))?;
    fs::write(out_dir.join("mean_cases.rs"), list(cases_of_means))?;
    Ok(())
}

fn is_enabled(problem: &str) -> bool {
    env::var_os(format!("CARGO_FEATURE_{}", problem.to_uppercase())).is_some()
}

/// The entries of a problem in the table of solvers: for each kind of rows, C functions and Rust
/// functions with the same parameters.
fn cases_of_rows(interface: &Interface) -> String {
    interface.rows.iter().map(|row| case_of_row(interface, row)).collect()
}

/// The data of one instance, `data`, as arguments of C functions.
fn arguments_in_c(interface: &Interface) -> String {
    let argument = |(at, field): (usize, &Field)| match field.shape.is_empty() {
        true => format!("data[{at}].number(), "),
        false => format!("data[{at}].pointer, data[{at}].length, "),
    };
    interface.data.iter().enumerate().map(argument).collect()
}

/// So many lists of `data` as arguments of C functions.
fn lists_in_c(lists: usize) -> String {
    (0..lists).map(|at| format!("data[{at}].pointer, data[{at}].length, ")).collect()
}

/// The data of one instance as arguments of Rust functions.
fn arguments_in_rust(interface: &Interface) -> String {
    let argument = |(at, field): (usize, &Field)| match field.shape.is_empty() {
        true => format!("take(data[{at}]), "),
        false => format!("&take(data[{at}]), "),
    };
    interface.data.iter().enumerate().map(argument).collect()
}

fn case_of_row(interface: &Interface, row: &Row) -> String {
    let Interface { name, solutions, .. } = interface;
    let lengths = interface.data.iter().map(|field| format!("({}, {}), ", field.len(), field.shape.is_empty()));
    let lengths: String = lengths.collect();
    let (single, lists, reads) =
        (arguments_in_c(interface), lists_in_c(interface.data.len()), arguments_in_rust(interface));
    let put: String = row.fields.iter().map(|field| format!("Numbers::put(&row.{}, &mut to);", field.name)).collect();
    let (results, measures) = match row.suffix.is_empty() {
        true => ("Ok(found)".to_owned(), MEASURES.map(|measure| case_of_measure(interface, measure)).concat()),
        false => (format!("eliminant_c::{name}::{}_of_each({reads}&found)", row.what), String::new()),
    };
    let [solve, solve_with, solve_batch] =
        [interface.solve(row).0, interface.solve_with(row).0, interface.solve_batch(row).0];
    format!(
        "Case {{
    name: \"{name}{suffix}\",
    data: &[{lengths}],
    row: {length},
    most: {solutions},
    solve: |data, out| unsafe {{
        let _ = data;
        eliminant_c::functions::{name}::eliminant_{solve}({single}out.solutions, out.length, out.counts)
    }},
    solve_with: |second_attempts, data, out| unsafe {{
        let _ = data;
        eliminant_c::functions::{name}::eliminant_{solve_with}(
            second_attempts, {single}out.solutions, out.length, out.counts)
    }},
    solve_batch: |instances, data, out| unsafe {{
        let _ = data;
        eliminant_c::functions::{name}::eliminant_{solve_batch}(
            instances, {lists}out.solutions, out.length, out.counts, out.codes)
    }},
    in_rust: |data| {{
        let _ = data;
        let found = eliminant_c::{name}::solve{suffix}({reads}).map_err(Code::from)?;
        Ok(numbers_of(&found, |row, mut to| {{ {put} }}))
    }},
    in_rust_with: |second_attempts, data| {{
        let _ = data;
        let mut workspace = ::eliminant::Workspace::new().with_second_attempts(second_attempts);
        let found = eliminant_c::{name}::solve_in(&mut workspace, {reads}).map_err(Code::from)?;
        let found = {results}.map_err(|error: ::eliminant::SolveError| Code::from(error))?;
        Ok(numbers_of(&found, |row, mut to| {{ {put} }}))
    }},
    operations: (
        eliminant_c::functions::{name}::eliminant_{operations}(),
        eliminant_c::{name}::SECOND_ATTEMPT_OPERATIONS,
    ),
    measures: vec![{measures}],
}},
",
        suffix = row.suffix,
        length = row.len(),
        operations = interface.second_attempt_operations(),
    )
}

fn case_of_measure(interface: &Interface, measure: &str) -> String {
    let (name, function) = (&interface.name, interface.measure(measure).0);
    let (single, reads) = (arguments_in_c(interface), arguments_in_rust(interface));
    let unknowns = interface.rows.first().map_or(0, Row::len);
    format!(
        "Measure {{
        in_c: |data, solution, to| unsafe {{
            let _ = data;
            eliminant_c::functions::{name}::eliminant_{function}({single}solution.pointer, solution.length, to)
        }},
        in_rust: |data, solution| {{
            let _ = data;
            let solution = eliminant_c::{name}::Solution::from(take::<[f64; {unknowns}]>(solution));
            eliminant_c::{name}::{measure}({reads}&solution).map_err(Code::from)
        }},
    }}, "
    )
}

/// The entries of a problem in the table of means.
fn cases_of_means(interface: &Interface) -> String {
    interface.means.iter().map(|mean| case_of_mean(interface, mean)).collect()
}

fn case_of_mean(interface: &Interface, mean: &Mean) -> String {
    let (name, function) = (&interface.name, interface.mean(mean).0);
    let fields = &mean.measurement;
    let lengths: String = fields.iter().map(|field| format!("{}, ", field.len())).collect();
    let reads =
        fields.iter().enumerate().map(|(list, field)| format!("take_at::<{}>(data[{list}], at)", field.in_rust()));
    let reads = match &reads.collect::<Vec<_>>()[..] {
        [read] => read.clone(),
        reads => format!("({})", reads.join(", ")),
    };
    format!(
        "MeanCase {{
    name: \"{function}\",
    data: &[{lengths}],
    mean: {length},
    in_c: |measurements, data, mean| unsafe {{
        eliminant_c::functions::{name}::eliminant_{function}(
            measurements, {lists}mean.pointer.cast_mut(), mean.length)
    }},
    in_rust: |measurements, data| {{
        let mean = eliminant_c::{name}::{of_rust}((0..measurements).map(|at| {reads}));
        let mut numbers = Vec::new();
        Numbers::put(&mean, &mut |number| numbers.push(number));
        numbers
    }},
}},
",
        length = mean.len(),
        lists = lists_in_c(fields.len()),
        of_rust = mean.name,
    )
}
