//! Prints the C++ header.

use std::fmt::Write as _;

use crate::header::with_prefix;
use crate::interface::{Field, Interface, MEASURES, Mean, Row};
use crate::names::free_name;

/// What all libraries have; `@name@` and `@NAME@` stand for the prefix.
const PRELUDE: &str = include_str!("prelude.hpp");

/// The header `PREFIX.hpp` of a library: a namespace for each problem.
#[must_use]
pub fn cpp_header(prefix: &str, interfaces: &[Interface]) -> String {
    let (start, end) = PRELUDE.split_once("@problems@\n").unwrap_or((PRELUDE, ""));
    let problems: String = interfaces.iter().map(|interface| problem(prefix, interface)).collect();
    [&with_prefix(start, prefix), problems.as_str(), &with_prefix(end, prefix)].concat()
}

fn problem(prefix: &str, interface: &Interface) -> String {
    let namespace = free_name(&interface.name, &[]);
    let mut text = documentation(&interface.docs);
    let _ = writeln!(text, "namespace {namespace} {{\n");
    let _ = writeln!(text, "/// No call returns more solutions.");
    let _ = writeln!(text, "inline constexpr std::size_t max_solutions = {};\n", interface.solutions);
    for row in &interface.rows {
        text.push_str(&structure(interface, row));
        text.push_str(&functions(prefix, interface, row));
    }
    text.push_str(&measures(prefix, interface));
    for of in &interface.means {
        text.push_str(&mean(prefix, interface, of));
    }
    let _ = writeln!(text, "}} // namespace {namespace}\n");
    text
}

/// Lines of a documentation as comments.
fn documentation(lines: &[String]) -> String {
    lines.iter().map(|line| format!("{}\n", format!("/// {}", line.trim()).trim_end())).collect()
}

/// The struct of a row.
fn structure(interface: &Interface, row: &Row) -> String {
    let what = match row.suffix.is_empty() {
        true => format!("A solution of `{}`.", interface.name),
        false => format!("What `{}` returns beside its unknowns.", interface.name),
    };
    let mut text = format!("/// {what}\nstruct {} {{\n", row.name);
    for Field { c_name, shape, note, .. } in &row.fields {
        let note = if note.is_empty() { String::new() } else { format!(" ///< {note}") };
        let _ = writeln!(text, "    {} {c_name};{note}", cpp_type(shape));
    }
    let _ = writeln!(text, "}};\nstatic_assert(sizeof({}) == {} * sizeof(double), \"a row\");\n", row.name, row.len());
    text
}

/// `std::array<std::array<double, 3>, 5>`.
fn cpp_type(shape: &[usize]) -> String {
    shape.iter().rev().fold("double".to_owned(), |inner, length| format!("std::array<{inner}, {length}>"))
}

/// The call that computes a mean.
fn mean(prefix: &str, interface: &Interface, mean: &Mean) -> String {
    let mut text = documentation(&mean.docs);
    let (ty, numbers) = (cpp_type(&mean.shape), mean.len());
    let lists: String = mean.measurement.iter().map(|field| format!(", Many {}", field.c_name)).collect();
    let of_lists: String =
        mean.measurement.iter().map(|field| format!("{0}.data(), {0}.size(), ", field.c_name)).collect();
    let (name, function) = (&mean.name, interface.mean(mean).0);
    let _ = writeln!(
        text,
        "\
/// The mean over so many measurements, one after another in each list. Throws `Error` if a list
/// does not fit.
[[nodiscard]] inline {ty} {name}(std::size_t measurements{lists}) {{
    {ty} mean{{}};
    static_assert(sizeof(mean) == {numbers} * sizeof(double), \"an array of numbers\");
    const std::int32_t code =
        {prefix}_{function}(measurements, {of_lists}reinterpret_cast<double *>(&mean), {numbers});
    if (code != {upper}_OK) throw Error(code);
    return mean;
}}
",
        upper = prefix.to_uppercase(),
    );
    text
}

/// The data of one instance: as parameters, by their names, and as arguments of a C function.
struct DataOfOne {
    parameters: Vec<String>,
    names: Vec<String>,
    arguments: String,
}

impl DataOfOne {
    fn of(interface: &Interface) -> Self {
        let parameter = |field: &Field| match field.shape.is_empty() {
            true => format!("double {}", field.c_name),
            false => format!("Values<{}> {}", field.len(), field.c_name),
        };
        let argument = |field: &Field| match field.shape.is_empty() {
            true => format!("{}, ", field.c_name),
            false => list(field),
        };
        Self {
            parameters: interface.data.iter().map(parameter).collect(),
            names: interface.data.iter().map(|field| field.c_name.clone()).collect(),
            arguments: interface.data.iter().map(argument).collect(),
        }
    }
}

/// A list of data as arguments of a C function.
fn list(field: &Field) -> String {
    format!("{0}.data(), {0}.size(), ", field.c_name)
}

/// The calls that measure a solution, and the one that tells the work of a second attempt.
fn measures(prefix: &str, interface: &Interface) -> String {
    let DataOfOne { parameters, arguments, .. } = DataOfOne::of(interface);
    let parameters: String = parameters.iter().map(|parameter| format!("{parameter}, ")).collect();
    let docs = [
        "/// The largest |f| / (sum of the moduli of the terms of f) of all equations f = 0 at a\n\
         /// solution.",
        "/// A bound on the error of a solution, relative to its largest unknown. Infinite if no solution is\n\
         /// known to be near.",
    ];
    let upper = prefix.to_uppercase();
    let measure = |(measure, doc): (&str, &str)| {
        let function = interface.measure(measure).0;
        format!(
            "\
{doc} Throws `Error`.
[[nodiscard]] inline double {measure}({parameters}const Solution &solution) {{
    double number = 0.0;
    const std::int32_t code = {prefix}_{function}(
        {arguments}reinterpret_cast<const double *>(&solution), sizeof(Solution) / sizeof(double), &number);
    if (code != {upper}_OK) throw Error(code);
    return number;
}}

"
        )
    };
    let measures: String = MEASURES.into_iter().zip(docs).map(measure).collect();
    format!(
        "\
{measures}/// How many operations a second attempt has: see `SecondAttempts`.
[[nodiscard]] inline std::uint64_t second_attempt_operations() noexcept {{
    return {prefix}_{}();
}}

",
        interface.second_attempt_operations()
    )
}

/// The calls that return rows of a kind.
fn functions(prefix: &str, interface: &Interface, row: &Row) -> String {
    let Row { name, suffix, what, .. } = row;
    let DataOfOne { parameters, names, arguments } = DataOfOne::of(interface);
    let with = |first: &str, others: &[String]| [&[first.to_owned()], others].concat().join(", ");
    let (with_parameters, with_names) =
        (with("SecondAttempts second_attempts", &parameters), with("second_attempts", &names));
    let (parameters, names) = (parameters.join(", "), names.join(", "));
    let lists: String = interface.data.iter().map(|field| format!("Many {}, ", field.c_name)).collect();
    let of_lists: String = interface.data.iter().map(list).collect();
    let [(solve, _), (solve_with, _), (solve_batch, _)] =
        [interface.solve(row), interface.solve_with(row), interface.solve_batch(row)];
    let returned = format!("Solutions<{name}, max_solutions>");
    format!(
        "\
/// Real solutions of one instance: each {what}, or the code of an error.
[[nodiscard]] inline Result<{returned}> try_solve{suffix}({parameters}) noexcept {{
    return Result<{returned}>::of([&](double *to_solutions, std::size_t *to_count) {{
        return {prefix}_{solve}({arguments}to_solutions, max_solutions, to_count);
    }});
}}

/// Real solutions of one instance: each {what}. Throws `Error`.
[[nodiscard]] inline {returned} solve{suffix}({parameters}) {{
    return try_solve{suffix}({names}).value();
}}

/// As `try_solve{suffix}`, with a bound on second attempts.
[[nodiscard]] inline Result<{returned}> try_solve_with{suffix}({with_parameters}) noexcept {{
    return Result<{returned}>::of([&](double *to_solutions, std::size_t *to_count) {{
        return {prefix}_{solve_with}(
            second_attempts.operations(), {arguments}to_solutions, max_solutions, to_count);
    }});
}}

/// As `solve{suffix}`, with a bound on second attempts. Throws `Error`.
[[nodiscard]] inline {returned} solve_with{suffix}({with_parameters}) {{
    return try_solve_with{suffix}({with_names}).value();
}}

/// Many instances, one after another in each list. Throws `Error` if a list does not fit.
inline void solve_batch{suffix}(
    std::size_t instances, {lists}Batch<{name}, max_solutions> &batch) {{
    batch.fill(instances, [&](double *to_solutions, std::size_t solutions_length, std::size_t *counts,
                              std::int32_t *codes) {{
        return {prefix}_{solve_batch}(
            instances, {of_lists}to_solutions, solutions_length, counts, codes);
    }});
}}

"
    )
}
