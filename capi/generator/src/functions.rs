//! Prints the `extern "C"` functions.

use std::fmt::Write as _;

use crate::interface::{Field, Interface, MEASURES, Mean, Parameter, Row};

/// The functions of a library. The solvers stand beside the module `functions` that this is.
pub(crate) fn functions(prefix: &str, interfaces: &[Interface]) -> String {
    let problems: String = interfaces.iter().map(|interface| problem(prefix, interface)).collect();
    format!(
        r#"
/// The functions of the C library, for each problem.
pub mod functions {{
/// The text of a code.
#[unsafe(no_mangle)]
pub extern "C" fn {prefix}_error_text(code: i32) -> *const ::core::ffi::c_char {{
    ::eliminant_capi_runtime::error_text(code).as_ptr()
}}

/// The version of the library.
#[unsafe(no_mangle)]
pub extern "C" fn {prefix}_version() -> *const ::core::ffi::c_char {{
    c"{version}".as_ptr()
}}
{problems}}}

/// The C header and the C++ header, each with its name.
pub const HEADERS: [(&str, &str); 2] = [
    ("{prefix}.h", include_str!(concat!(env!("OUT_DIR"), "/{prefix}.h"))),
    ("{prefix}.hpp", include_str!(concat!(env!("OUT_DIR"), "/{prefix}.hpp"))),
];
"#,
        version = env!("CARGO_PKG_VERSION"),
    )
}

/// A module with the functions of a problem, and what they have in common.
fn problem(prefix: &str, interface: &Interface) -> String {
    let Interface { name, data, solutions, .. } = interface;
    let unknowns = interface.rows.first().map_or(0, Row::len);
    let list = |print: &dyn Fn(&Field) -> String| data.iter().map(print).collect::<String>();
    let buffers = list(&|field| format!("{}: border::Input, ", field.c_name));
    let checks = list(&|field| {
        let ty = field.in_rust();
        format!("        self.{0}.check::<{ty}>(instances)?;\n", field.c_name)
    });
    let reads = list(&|field| format!("{}: unsafe {{ self.{}.read(at) }}, ", field.name, field.c_name));
    let rows: String = interface.rows.iter().map(|row| functions_of_row(prefix, interface, row)).collect();
    let measures: String = MEASURES.iter().map(|measure| function_of_measure(prefix, interface, measure)).collect();
    let means: String = interface.means.iter().map(|mean| function_of_mean(prefix, interface, mean)).collect();
    format!(
        r#"
/// The C functions of `{name}`.
#[allow(clippy::too_many_arguments, non_snake_case)]
pub mod {name} {{
use super::super::{name} as solver;
use ::eliminant_capi_runtime as border;

// What the headers say.
const _: () = assert!(solver::MAX_SOLUTIONS == {solutions} && solver::UNKNOWNS.len() == {unknowns});

/// The data of many instances.
struct Inputs {{ {buffers} }}

impl Inputs {{
    #[allow(unused_variables)]
    fn check(&self, instances: usize) -> Result<(), border::Code> {{
{checks}        Ok(())
    }}

    #[allow(unused_variables)]
    unsafe fn read(&self, at: usize) -> solver::Data {{
        // SAFETY: the caller has checked the buffers.
        solver::Data {{ {reads} }}
    }}
}}

/// How many operations a second attempt is.
#[unsafe(no_mangle)]
pub extern "C" fn {prefix}_{operations}() -> u64 {{
    solver::SECOND_ATTEMPT_OPERATIONS
}}
{rows}{measures}{means}}}
"#,
        operations = interface.second_attempt_operations(),
    )
}

/// The function that measures a solution.
fn function_of_measure(prefix: &str, interface: &Interface, measure: &str) -> String {
    let (name, parameters) = interface.measure(measure);
    format!(
        r#"
{doc}pub unsafe extern "C" fn {prefix}_{name}({parameters}) -> i32 {{
    // SAFETY: the caller promises what the functions of the border need.
    unsafe {{
        border::value(({measure}, 1), || {{
            {data}
            let solution = border::Input::new(solution, solution_length).read_one::<[f64; {length}]>()?;
            Ok(solver::{measure}({arguments}&solver::Solution::from(solution))?)
        }})
    }}
}}
"#,
        doc = doc("Measures a solution."),
        parameters = rust_parameters(&parameters),
        data = data_of_one(interface),
        length = interface.rows.first().map_or(0, Row::len),
        arguments = arguments(interface),
    )
}

/// The function that computes a mean.
fn function_of_mean(prefix: &str, interface: &Interface, mean: &Mean) -> String {
    let (name, parameters) = interface.mean(mean);
    let (mut inputs, mut checks, mut reads) = (String::new(), String::new(), Vec::new());
    for field in &mean.measurement {
        let (list, ty) = (&field.c_name, field.in_rust());
        let _ = write!(inputs, "let {list} = border::Input::new({list}, {list}_length);\n    ");
        let _ = write!(checks, "{list}.check::<{ty}>(measurements)?;\n            ");
        reads.push(format!("{list}.read::<{ty}>(at)"));
    }
    let item = match &reads[..] {
        [read] => read.clone(),
        _ => format!("({})", reads.join(", ")),
    };
    format!(
        r#"
{doc}pub unsafe extern "C" fn {prefix}_{name}({parameters}) -> i32 {{
    {inputs}// SAFETY: the caller promises what the functions of the border need; what is read was checked.
    unsafe {{
        border::value((mean, mean_length), || {{
            {checks}Ok(solver::{function}((0..measurements).map(|at| {item})))
        }})
    }}
}}
"#,
        doc = doc("Computes a mean over measurements."),
        parameters = rust_parameters(&parameters),
        function = mean.name,
    )
}

/// The functions that return rows of a kind.
fn functions_of_row(prefix: &str, interface: &Interface, row: &Row) -> String {
    let (batch, rows) = (format!("BatchOf{}", row.name), rows(interface, row));
    let (length, solutions) = (row.len(), interface.solutions);
    let result = if row.suffix.is_empty() { "solution" } else { "result" };
    let single = single(prefix, interface, row) + &with_options(prefix, interface, row);
    let of_batch = of_batch(prefix, interface, row);
    format!(
        r#"
/// Many instances, with the {result} as a row.
struct {batch}(Inputs);

impl border::Batch<{length}, {solutions}> for {batch} {{
    type Data = solver::Data;
    type Solution = solver::Solution;

    fn check(&self, instances: usize) -> Result<(), border::Code> {{
        self.0.check(instances)
    }}

    unsafe fn read(&self, at: usize) -> solver::Data {{
        // SAFETY: the caller has checked the buffers.
        unsafe {{ self.0.read(at) }}
    }}

    fn solve(
        &self,
        data: &[solver::Data],
        results: &mut [Result<::eliminant::Solutions<solver::Solution, {solutions}>, ::eliminant::SolveError>],
    ) {{
        solver::solve_batch(data, results);
    }}

    #[allow(unused_variables)]
    fn rows(
        &self,
        data: &solver::Data,
        solutions: &::eliminant::Solutions<solver::Solution, {solutions}>,
    ) -> Result<::eliminant::Solutions<[f64; {length}], {solutions}>, ::eliminant::SolveError> {{
        {rows}
    }}
}}
{single}{of_batch}"#
    )
}

/// The expression of type `Result` that makes rows of `solutions`.
fn rows(interface: &Interface, row: &Row) -> String {
    let to_array = to_array(row);
    match row.suffix.is_empty() {
        true => format!("Ok(solutions.map({to_array}))"),
        false => {
            let arguments = arguments(interface);
            format!("Ok(solver::{}_of_each({arguments}solutions)?.map({to_array}))", row.what)
        }
    }
}

/// The function from a solution, or what is returned for it, to a row.
fn to_array(row: &Row) -> String {
    match row.suffix.is_empty() {
        true => "solver::Solution::to_array".to_owned(),
        false => format!("|result| border::row(|mut to| {{ {} }})", put(row)),
    }
}

/// The statements that put the fields of `result` to a row.
fn put(row: &Row) -> String {
    let put = |field: &Field| format!("border::Numbers::put(&result.{}, &mut to);", field.name);
    row.fields.iter().map(put).collect::<Vec<_>>().join(" ")
}

/// `data.NAME`, as solvers take it.
fn arguments(interface: &Interface) -> String {
    let argument = |field: &Field| {
        let reference = if field.is_number() { "" } else { "&" };
        format!("{reference}data.{}, ", field.name)
    };
    interface.data.iter().map(argument).collect()
}

/// The statement that reads the data of one instance.
fn data_of_one(interface: &Interface) -> String {
    let read = |field: &Field| match field.shape.is_empty() {
        true if field.name == field.c_name => format!("{}, ", field.name),
        true => format!("{}: {}, ", field.name, field.c_name),
        false => {
            let list = &field.c_name;
            format!("{}: border::Input::new({list}, {list}_length).read_one()?, ", field.name)
        }
    };
    let reads: String = interface.data.iter().map(read).collect();
    format!("#[allow(unused_variables)]\n            let data = solver::Data {{ {reads} }};")
}

/// The function that solves one instance.
fn single(prefix: &str, interface: &Interface, row: &Row) -> String {
    let (suffix, arguments, to_array) = (&row.suffix, arguments(interface), to_array(row));
    let rows = format!("Ok(solver::solve{suffix}({arguments})?.map({to_array}))");
    function_of_one(prefix, interface, row, (interface.solve(row), "Solves one instance.", &rows))
}

/// The function that solves one instance with a bound on second attempts.
fn with_options(prefix: &str, interface: &Interface, row: &Row) -> String {
    let (arguments, rows) = (arguments(interface), rows(interface, row));
    let rows = format!(
        "let workspace = &mut border::workspace(second_attempts);
            let solutions = &solver::solve_in(workspace, {arguments})?;
            {rows}"
    );
    let doc = "Solves one instance with a bound on second attempts.";
    function_of_one(prefix, interface, row, (interface.solve_with(row), doc, &rows))
}

/// A function that writes rows of one instance: its name and parameters, what it does, and the rows
/// that it computes from `data`.
fn function_of_one(
    prefix: &str,
    interface: &Interface,
    row: &Row,
    ((name, parameters), what, rows): ((String, Vec<Parameter>), &str, &str),
) -> String {
    format!(
        r#"
{doc}pub unsafe extern "C" fn {prefix}_{name}({parameters}) -> i32 {{
    let output = border::Output::new(solutions, capacity, count);
    // SAFETY: the caller promises what the functions of the border need.
    unsafe {{
        border::solve::<{length}, {solutions}>(output, || {{
            {data}
            {rows}
        }})
    }}
}}
"#,
        doc = doc(what),
        parameters = rust_parameters(&parameters),
        length = row.len(),
        solutions = interface.solutions,
        data = data_of_one(interface),
    )
}

fn of_batch(prefix: &str, interface: &Interface, row: &Row) -> String {
    let (name, parameters) = interface.solve_batch(row);
    let mut inputs = String::new();
    for Field { c_name, .. } in &interface.data {
        let _ = write!(inputs, "{c_name}: border::Input::new({c_name}, {c_name}_length), ");
    }
    format!(
        r#"
{doc}pub unsafe extern "C" fn {prefix}_{name}({parameters}) -> i32 {{
    let batch = BatchOf{struct_name}(Inputs {{ {inputs} }});
    let output = border::BatchOutput::new(solutions, solutions_length, counts, codes);
    // SAFETY: the caller promises what the functions of the border need.
    unsafe {{ border::solve_batch::<_, _, _, {piece}>(&batch, instances, output) }}
}}
"#,
        doc = doc("Solves many instances."),
        parameters = rust_parameters(&parameters),
        struct_name = row.name,
        piece = interface.piece(),
    )
}

fn doc(what: &str) -> String {
    format!(
        "/// {what}\n///\n/// # Safety\n/// Pointers are null, or their buffers as long as the lengths beside them say.\n\
         #[unsafe(no_mangle)]\n"
    )
}

fn rust_parameters(parameters: &[Parameter]) -> String {
    parameters.iter().map(Parameter::in_rust).collect::<Vec<_>>().join(", ")
}
