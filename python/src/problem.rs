//! Problems of the generator: read, checked, searched, and planned by a template.

use eliminant_generator::check::check_until;
use eliminant_generator::problem::{Problem, SolutionField};
use eliminant_generator::template::file::TemplateFile;
use pyo3::prelude::*;

use crate::errors::ProblemError;
use crate::planned::Planned;
use crate::search::{self, Settings};
use crate::threads::interruptible;

/// Name and shape of each array.
type Shapes = Vec<(String, Vec<usize>)>;

/// A problem that was read.
#[pyclass(frozen, module = "eliminant._eliminant", name = "Problem")]
pub(crate) struct NativeProblem(Problem);

/// An error with a text that begins like those of the command.
fn at_fault(error: impl std::fmt::Display) -> PyErr {
    ProblemError::new_err(format!("error: {error}"))
}

#[pymethods]
impl NativeProblem {
    /// Reads a problem. Messages name `path`.
    #[new]
    fn new(path: &str, text: &str) -> PyResult<Self> {
        // The messages of a problem begin with `error:` themselves.
        Problem::parse(path, text).map(Self).map_err(|messages| ProblemError::new_err(messages.to_string()))
    }

    #[getter]
    fn name(&self) -> &str {
        &self.0.name
    }

    #[getter]
    fn docs(&self) -> String {
        let lines = self.0.docs.iter().map(|line| line.strip_prefix(' ').unwrap_or(line));
        lines.collect::<Vec<_>>().join("\n")
    }

    #[getter]
    fn equations(&self) -> usize {
        self.0.equations.len()
    }

    #[getter]
    fn data(&self) -> Shapes {
        self.0.data.iter().map(|data| (data.name.clone(), data.shape.clone())).collect()
    }

    #[getter]
    fn fields(&self) -> Shapes {
        self.0.fields.iter().map(|field| (field.name.clone(), field.shape.clone())).collect()
    }

    #[getter]
    fn results(&self) -> Shapes {
        let fields = self.0.output.iter().flat_map(|output| &output.fields);
        fields.map(|field| (field.name.clone(), field.shape.clone())).collect()
    }

    #[getter]
    fn unknowns(&self) -> Vec<String> {
        self.0.fields.iter().flat_map(SolutionField::names).collect()
    }

    /// The names of parameters, unknowns and results that are complex.
    #[getter]
    fn complex_numbers(&self) -> Vec<String> {
        let results = self.0.output.iter().flat_map(|output| &output.fields);
        let of_data = self.0.data.iter().filter(|data| data.is_complex).map(|data| &data.name);
        let of_fields = self.0.fields.iter().filter(|field| field.is_complex).map(|field| &field.name);
        let of_results = results.filter(|field| field.is_complex).map(|field| &field.name);
        of_data.chain(of_fields).chain(of_results).cloned().collect()
    }

    /// The numbers of solutions, of different ones, and of those where all unknowns are 0.
    fn check(&self, py: Python<'_>) -> PyResult<(usize, usize, usize)> {
        let count = interruptible(py, |is_over| check_until(&self.0, is_over), |_| Ok(()))?;
        let count = count.map_err(|messages| ProblemError::new_err(messages.to_string()))?;
        Ok((count.solutions, count.different, count.at_origin))
    }

    /// Searches a template. Returns its file, and whether the budget left anything out.
    fn search(
        &self,
        py: Python<'_>,
        settings: Settings,
        budget: Option<f64>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<(String, bool)> {
        search::search(py, &self.0, &settings, budget, progress)
    }

    /// The solver by a template, which is verified.
    fn planned(&self, py: Python<'_>, template: &str) -> PyResult<Planned> {
        py.detach(|| {
            let file = TemplateFile::parse(template, &self.0.unknowns).map_err(at_fault)?;
            Planned::new(&self.0, file).map_err(at_fault)
        })
    }
}
