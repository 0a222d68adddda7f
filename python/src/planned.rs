//! Problems with a template: solved by the interpreted plan, with the kernels that ship.

use std::sync::atomic::{AtomicBool, Ordering};

use eliminant::SolveError as Error;
use eliminant::emitted::{chart_entry, vector_of};
use eliminant_generator::expression::arithmetic::Float64;
use eliminant_generator::generate::{GenerateError, generate, plan};
use eliminant_generator::plan::interpret;
use eliminant_generator::plan::output::PlannedElement;
use eliminant_generator::plan::{Plan, Term};
use eliminant_generator::problem::{Problem, SolutionField};
use eliminant_generator::search::measuring::interpreted::InterpretedSolver;
use eliminant_generator::template::file::TemplateFile;
use numpy::PyReadonlyArrayDyn;
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::batch::{Lists, Solved, values};
use crate::catalogue::{Found, Sizes, Values};
use crate::errors::{ProblemError, SolveError};
use crate::progress::Tally;
use crate::stability::{Figures, RandomInstances, figures};
use crate::threads::interruptible;

/// A problem, its template, and the plan of its solver.
#[pyclass(frozen, module = "eliminant._eliminant")]
pub(crate) struct Planned {
    problem: Problem,
    file: TemplateFile,
    plan: Plan,
    solver: InterpretedSolver,
    data: Vec<(String, Vec<usize>)>,
    sizes: Sizes,
}

impl Planned {
    pub(crate) fn new(problem: &Problem, file: TemplateFile) -> Result<Self, GenerateError> {
        let plan = plan(problem, &file)?.plan;
        let outputs = plan.output.iter().flat_map(|output| &output.fields);
        let sizes = Sizes {
            unknowns: plan.fields.iter().map(SolutionField::scalars).sum(),
            results: outputs.map(|field| field.elements.len()).sum(),
            solutions: plan.solutions,
        };
        let data = plan.data.iter().map(|data| (data.name.clone(), data.shape.clone())).collect();
        Ok(Self { problem: problem.clone(), file, solver: InterpretedSolver::of(&plan), plan, data, sizes })
    }

    /// Solves one instance.
    fn solve(&self, values: &[Values<'_>], at: usize, found: &mut Found<'_>) -> Result<(), Error> {
        let data: Vec<f64> = values.iter().flat_map(|values| values.instance(at)).copied().collect();
        let points = self.solver.solve(&data)?;
        let solutions: Vec<Vec<f64>> = points.iter().map(|point| self.solution(point)).collect();
        found.write(at, solutions.iter().map(Vec::as_slice));
        self.write_results(&data, &points, &solutions, at, found);
        Ok(())
    }

    /// The scalars of a solution: vectors that are given up to scale have length 1.
    fn solution(&self, point: &[f64]) -> Vec<f64> {
        let mut solution = Vec::with_capacity(self.sizes.unknowns);
        for field in &self.plan.fields {
            let unknowns = &point[field.unknowns()];
            match field.chart() {
                None => solution.extend(unknowns),
                Some(chart) => {
                    let mut vector = vec![0.0; field.scalars()];
                    vector_of(&chart, unknowns, &mut vector);
                    solution.extend(vector);
                }
            }
        }
        solution
    }

    /// Writes what the problem returns for each solution, if it returns anything.
    fn write_results(
        &self,
        data: &[f64],
        points: &[Vec<f64>],
        solutions: &[Vec<f64>],
        at: usize,
        found: &mut Found<'_>,
    ) {
        let Some(output) = &self.plan.output else { return };
        let Some(coefficients) = interpret::coefficients_of_results(&self.plan, output, Float64, data) else { return };
        for (number, (point, solution)) in points.iter().zip(solutions).enumerate() {
            let mut x = self.variables(point, solution);
            output.parts.iter().for_each(|part| x.push(value(part, &coefficients, &x)));
            let elements = output.fields.iter().flat_map(|field| &field.elements);
            for (place, element) in found.result(at, number).iter_mut().zip(elements) {
                *place = value(element, &coefficients, &x);
            }
        }
    }

    /// What the polynomials of results hold: the unknowns, of vectors that are given up to scale
    /// their coordinates; then the last coordinate of each of these.
    fn variables(&self, point: &[f64], solution: &[f64]) -> Vec<f64> {
        let (mut x, mut last, mut first) = (point.to_vec(), Vec::new(), 0);
        for field in &self.plan.fields {
            let scalars = &solution[first..first + field.scalars()];
            first += field.scalars();
            if let Some(chart) = field.chart() {
                let factor = field.scale_of_chart();
                let coordinates: Vec<f64> = chart.iter().map(|row| factor * chart_entry(row, scalars)).collect();
                if let Some((of_last, others)) = coordinates.split_last() {
                    x[field.unknowns()].copy_from_slice(others);
                    last.push(*of_last);
                }
            }
        }
        x.extend(last);
        x
    }
}

/// The value of a scalar of the results.
fn value(element: &PlannedElement, coefficients: &[f64], x: &[f64]) -> f64 {
    let sum = |terms: &[Term]| terms.iter().map(|term| product(term, coefficients, x)).sum::<f64>();
    let quotient = match &element.denominator {
        Some(divisor) => sum(&element.numerator) / sum(divisor),
        None => sum(&element.numerator),
    };
    if element.is_root { quotient.sqrt() } else { quotient }
}

fn product(term: &Term, coefficients: &[f64], x: &[f64]) -> f64 {
    let powers = term.exponents.iter().zip(x).map(|(&exponent, x)| x.powi(exponent.into()));
    coefficients[usize::from(term.coefficient.0)] * powers.product::<f64>()
}

#[pymethods]
impl Planned {
    /// Solves `count` instances. Between whiles `progress` is called with the number of those that
    /// are done, and of all.
    #[pyo3(signature = (arrays, count, progress = None))]
    fn solve_batch<'py>(
        &self,
        py: Python<'py>,
        arrays: Vec<PyReadonlyArrayDyn<'py, f64>>,
        count: usize,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Solved<'py>> {
        let values = values(&self.problem.name, &self.data, &arrays, count)?;
        let mut lists = Lists::new(py, self.sizes, count)?;
        let found = lists.found()?;
        let tally = Tally::new(progress, count);
        let work = |is_over: &AtomicBool| {
            found.pieces(1).into_par_iter().enumerate().for_each(|(at, mut found)| {
                if is_over.load(Ordering::Relaxed) || found.is_empty() {
                    return;
                }
                let values: Vec<Values<'_>> = values.iter().map(|values| values.from(at)).collect();
                if let Err(error) = self.solve(&values, 0, &mut found) {
                    found.fail(0, &error);
                }
                tally.add(1);
            });
        };
        interruptible(py, work, |py| tally.tell(py))?;
        tally.tell(py)?;
        Ok(lists.into_arrays())
    }

    /// Solves one instance.
    fn solve_one<'py>(&self, py: Python<'py>, arrays: Vec<PyReadonlyArrayDyn<'py, f64>>) -> PyResult<Solved<'py>> {
        let values = values(&self.problem.name, &self.data, &arrays, 1)?;
        let mut lists = Lists::new(py, self.sizes, 1)?;
        let mut found = lists.found()?;
        let solved = interruptible(py, |_| self.solve(&values, 0, &mut found), |_| Ok(()))?;
        solved.map_err(|error| SolveError::new_err(error.to_string()))?;
        Ok(lists.into_arrays())
    }

    /// The Rust source of the solver.
    fn emit(&self, py: Python<'_>) -> PyResult<String> {
        let source = py.detach(|| generate(&self.problem, &self.file));
        source.map_err(|error| ProblemError::new_err(format!("error: {error}")))
    }

    /// Solves random instances from `first` on, and judges what is found. Between whiles `progress`
    /// is called with the number of those that are done, and of all.
    #[pyo3(signature = (first, trials, seed, progress = None))]
    fn stability<'py>(
        &self,
        py: Python<'py>,
        first: usize,
        trials: usize,
        seed: u64,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Figures<'py>> {
        let random = RandomInstances { numbers: first..first.saturating_add(trials), seed };
        figures(py, &self.plan, &self.solver, random, &Tally::new(progress, trials))
    }

    #[getter]
    fn solutions(&self) -> usize {
        self.plan.solutions
    }

    /// Rows, columns and size of the basis of the template.
    #[getter]
    fn template_size(&self) -> (usize, usize, usize) {
        let template = &self.file.template;
        (template.rows(), template.columns(), template.basis.len())
    }

    #[getter]
    fn action(&self) -> String {
        self.file.template.action.display(&self.problem.unknowns).to_string()
    }

    #[getter]
    fn operations(&self) -> usize {
        self.plan.operations().total()
    }
}
