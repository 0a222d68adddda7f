//! What a problem looks like from C: the functions, their parameters, and the rows that they write.

use eliminant_generator::problem::output::Output;
use eliminant_generator::problem::{DataAttribute, DataParameter, Measurement, Problem};

use crate::names::{free_name, length_name};

/// The most bytes of data and results that a batch keeps on the stack at once.
const BYTES_OF_A_PIECE: usize = 16 * 1024;
/// The most instances of a piece.
const MOST_INSTANCES: usize = 64;
/// As many instances as the widest registers hold.
const LANES: usize = 8;

/// What measures a solution: the names of the functions of solvers.
pub const MEASURES: [&str; 2] = ["relative_residual", "error_bound"];

/// A named array of numbers, or a number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Field {
    /// Its name in the problem file.
    pub name: String,
    /// Its name in C, C++ and in the emitted functions.
    pub c_name: String,
    /// Outermost dimension first; empty for a number. The last one of complex numbers is 2.
    pub shape: Vec<usize>,
    /// Whether it holds complex numbers: real parts, each with its imaginary part behind it.
    pub is_complex: bool,
    /// What its values satisfy, for people; may be empty.
    pub note: String,
}

impl Field {
    /// Number of numbers.
    pub fn len(&self) -> usize {
        self.shape.iter().product()
    }

    /// Whether it is one number, real or complex.
    pub fn is_number(&self) -> bool {
        self.shape.len() == usize::from(self.is_complex)
    }

    /// Whether it is an array of length 0.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Its type in Rust: `[[f64; 3]; 5]`.
    pub fn in_rust(&self) -> String {
        let (number, dimensions) = match &self.shape[..] {
            [dimensions @ .., _] if self.is_complex => ("::eliminant::Complex<f64>", dimensions),
            dimensions => ("f64", dimensions),
        };
        dimensions.iter().rev().fold(number.to_owned(), |inner, length| format!("[{inner}; {length}]"))
    }

    /// As C declares it: `first[5][3]`.
    pub fn declaration(&self) -> String {
        let dimensions: String = self.shape.iter().map(|length| format!("[{length}]")).collect();
        format!("{}{dimensions}", self.name)
    }
}

/// What a row of numbers holds: the unknowns, or a result of the problem.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// The name of the struct in Rust and C++: `Solution`, `Pose`.
    pub name: String,
    /// What stands at the end of names of C functions: nothing, or `_for_pose`.
    pub suffix: String,
    /// The name in snake case: `solution`, `pose`.
    pub what: String,
    /// In the order of the numbers.
    pub fields: Vec<Field>,
}

impl Row {
    /// Number of numbers.
    pub fn len(&self) -> usize {
        self.fields.iter().map(Field::len).sum()
    }

    /// Whether it has no numbers.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// Data that are the mean of what a function of the problem gives for measurements.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mean {
    /// The name in Rust and C++: `mean_of_point`.
    pub name: String,
    /// Lines of its documentation.
    pub docs: Vec<String>,
    /// A measurement.
    pub measurement: Vec<Field>,
    /// Outermost dimension first; empty for a number.
    pub shape: Vec<usize>,
}

impl Mean {
    /// Number of numbers.
    pub fn len(&self) -> usize {
        self.shape.iter().product()
    }

    /// Whether it is an array of length 0.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// The type of a parameter of a C function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Type {
    /// A number.
    Number,
    /// Data.
    Data,
    /// A length.
    Size,
    /// A number of operations.
    Operations,
    /// Room for solutions.
    Numbers,
    /// Room for counts.
    Sizes,
    /// Room for codes.
    Codes,
}

/// A parameter of a C function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameter {
    /// Its name.
    pub name: String,
    /// Its type.
    pub ty: Type,
}

impl Parameter {
    fn new(name: impl Into<String>, ty: Type) -> Self {
        Self { name: name.into(), ty }
    }

    /// As C declares it.
    pub fn in_c(&self) -> String {
        let ty = match self.ty {
            Type::Number => "double ",
            Type::Data => "const double *",
            Type::Size => "size_t ",
            Type::Operations => "uint64_t ",
            Type::Numbers => "double *",
            Type::Sizes => "size_t *",
            Type::Codes => "int32_t *",
        };
        format!("{ty}{}", self.name)
    }

    /// As Rust declares it.
    pub fn in_rust(&self) -> String {
        let ty = match self.ty {
            Type::Number => "f64",
            Type::Data => "*const f64",
            Type::Size => "usize",
            Type::Operations => "u64",
            Type::Numbers => "*mut f64",
            Type::Sizes => "*mut usize",
            Type::Codes => "*mut i32",
        };
        format!("{}: {ty}", self.name)
    }
}

/// A problem as C sees it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interface {
    /// Name of the problem.
    pub name: String,
    /// Lines of its documentation.
    pub docs: Vec<String>,
    /// The data, in the order of the problem file.
    pub data: Vec<Field>,
    /// The most solutions.
    pub solutions: usize,
    /// What functions write: the unknowns, then the result if the problem has one.
    pub rows: Vec<Row>,
    /// Which data are means of measurements.
    pub means: Vec<Mean>,
}

impl Interface {
    /// The interface of a problem with so many solutions.
    pub fn new(problem: &Problem, solutions: usize) -> Self {
        let notes: Vec<String> = problem.data.iter().map(note).collect();
        let data = problem.data.iter().zip(&notes);
        let data = data.map(|(data, note)| (&data.name, (&data.shape, data.is_complex), note.as_str()));
        let unknowns = problem.fields.iter().map(|unknown| {
            let note = if unknown.is_projective { "given up to scale: of length 1" } else { "" };
            (&unknown.name, (&unknown.shape, unknown.is_complex), note)
        });
        let solution = Row {
            name: "Solution".to_owned(),
            suffix: String::new(),
            what: "solution".to_owned(),
            fields: fields(unknowns),
        };
        let rows = [solution].into_iter().chain(problem.output.as_ref().map(row_of_output)).collect();
        let means = problem.measurements.iter().map(mean).collect();
        Self { name: problem.name.clone(), docs: problem.docs.clone(), data: fields(data), solutions, rows, means }
    }

    /// The function that solves one instance: its name without the prefix, and its parameters.
    pub fn solve(&self, row: &Row) -> (String, Vec<Parameter>) {
        let mut parameters = self.data_of_one();
        parameters.push(Parameter::new("solutions", Type::Numbers));
        parameters.push(Parameter::new("capacity", Type::Size));
        parameters.push(Parameter::new("count", Type::Sizes));
        (format!("{}_solve{}", self.name, row.suffix), parameters)
    }

    /// The function that solves one instance with a bound on second attempts.
    pub fn solve_with(&self, row: &Row) -> (String, Vec<Parameter>) {
        let mut parameters = vec![Parameter::new("second_attempts", Type::Operations)];
        parameters.extend(self.solve(row).1);
        (format!("{}_solve_with{}", self.name, row.suffix), parameters)
    }

    /// The function that returns how many operations a second attempt is.
    pub fn second_attempt_operations(&self) -> String {
        format!("{}_second_attempt_operations", self.name)
    }

    /// The function that computes one of [`MEASURES`] of a solution.
    pub fn measure(&self, measure: &str) -> (String, Vec<Parameter>) {
        let mut parameters = self.data_of_one();
        parameters.push(Parameter::new("solution", Type::Data));
        parameters.push(Parameter::new("solution_length", Type::Size));
        parameters.push(Parameter::new(measure, Type::Numbers));
        (format!("{}_{measure}", self.name), parameters)
    }

    /// The parameters that are the data of one instance.
    fn data_of_one(&self) -> Vec<Parameter> {
        let mut parameters = Vec::new();
        for field in &self.data {
            match field.shape.is_empty() {
                true => parameters.push(Parameter::new(&field.c_name, Type::Number)),
                false => parameters.extend(list(field)),
            }
        }
        parameters
    }

    /// The names of all functions, without the prefix.
    pub fn functions(&self) -> Vec<String> {
        let of_rows = self.rows.iter();
        let of_rows = of_rows.flat_map(|row| [self.solve(row).0, self.solve_with(row).0, self.solve_batch(row).0]);
        let measures = MEASURES.iter().map(|measure| self.measure(measure).0);
        let means = self.means.iter().map(|mean| self.mean(mean).0);
        of_rows.chain([self.second_attempt_operations()]).chain(measures).chain(means).collect()
    }

    /// The function that solves many instances.
    pub fn solve_batch(&self, row: &Row) -> (String, Vec<Parameter>) {
        let mut parameters = vec![Parameter::new("instances", Type::Size)];
        parameters.extend(self.data.iter().flat_map(list));
        parameters.push(Parameter::new("solutions", Type::Numbers));
        parameters.push(Parameter::new("solutions_length", Type::Size));
        parameters.push(Parameter::new("counts", Type::Sizes));
        parameters.push(Parameter::new("codes", Type::Codes));
        (format!("{}_solve_batch{}", self.name, row.suffix), parameters)
    }

    /// The function that computes a mean.
    pub fn mean(&self, mean: &Mean) -> (String, Vec<Parameter>) {
        let mut parameters = vec![Parameter::new("measurements", Type::Size)];
        parameters.extend(mean.measurement.iter().flat_map(list));
        parameters.push(Parameter::new("mean", Type::Numbers));
        parameters.push(Parameter::new("mean_length", Type::Size));
        (format!("{}_{}", self.name, mean.name), parameters)
    }

    /// How many instances of a batch are on the stack at once.
    pub fn piece(&self) -> usize {
        let of_data: usize = self.data.iter().map(Field::len).sum();
        let of_solutions = self.rows.first().map_or(0, Row::len) * self.solutions;
        // Beside the numbers, the length of a list and whether there is one.
        let bytes = size_of::<f64>() * (of_data + of_solutions + 2);
        let instances = (BYTES_OF_A_PIECE / bytes).clamp(1, MOST_INSTANCES);
        if instances > LANES { instances / LANES * LANES } else { instances }
    }
}

/// The parameters of a list of data.
fn list(field: &Field) -> [Parameter; 2] {
    [Parameter::new(&field.c_name, Type::Data), Parameter::new(length_name(&field.c_name), Type::Size)]
}

/// Fields from their names, shapes and notes. No two have the same name in C, nor does one have
/// that of another's length.
fn fields<'a>(stated: impl Iterator<Item = (&'a String, (&'a Vec<usize>, bool), &'a str)>) -> Vec<Field> {
    let mut fields: Vec<Field> = Vec::new();
    for (name, (shape, is_complex), note) in stated {
        let used: Vec<String> =
            fields.iter().flat_map(|field| [field.c_name.clone(), length_name(&field.c_name)]).collect();
        let c_name = free_name(name, &used);
        let note = match (is_complex, note) {
            (true, "") => "real and imaginary parts".to_owned(),
            (true, _) => format!("real and imaginary parts, {note}"),
            (false, _) => note.to_owned(),
        };
        fields.push(Field { name: name.clone(), c_name, shape: shape.clone(), is_complex, note });
    }
    fields
}

fn row_of_output(output: &Output) -> Row {
    Row {
        name: output.name.clone(),
        suffix: format!("_for_{}", output.function),
        what: output.function.clone(),
        fields: fields(output.fields.iter().map(|field| {
            let note = if field.is_projective { "given up to scale" } else { "" };
            (&field.name, (&field.shape, field.is_complex), note)
        })),
    }
}

fn mean(measurement: &Measurement) -> Mean {
    let data = measurement.data.iter().map(|data| (&data.name, (&data.shape, false), ""));
    Mean {
        name: format!("mean_{}", measurement.name),
        docs: measurement.docs.clone(),
        measurement: fields(data),
        shape: measurement.shape.clone(),
    }
}

fn note(data: &DataParameter) -> String {
    let note = match data.attribute {
        DataAttribute::Generic | DataAttribute::Integer => "",
        DataAttribute::Symmetric => "symmetric",
        DataAttribute::Rotation => "rotation matrices",
        DataAttribute::Unit => "of length 1",
        DataAttribute::Plucker => "direction and moment of a line",
        DataAttribute::Rank(_) => "of lower rank",
    };
    match &data.mean {
        None => note.to_owned(),
        Some(mean) if note.is_empty() => format!("the result of `mean_{}`", mean.function),
        Some(mean) => format!("{note}: the result of `mean_{}`", mean.function),
    }
}
