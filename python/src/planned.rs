//! Problems with a template: solved by the interpreted plan, with the kernels that ship.

use std::sync::atomic::{AtomicBool, Ordering};

use eliminant::SolveError as Error;
use eliminant_generator::generate::{GenerateError, generate, plan};
use eliminant_generator::plan::Plan;
use eliminant_generator::plan::output::PlannedField;
use eliminant_generator::problem::{Problem, SolutionField};
use eliminant_generator::search::measuring::interpreted::InterpretedSolver;
use eliminant_generator::search::measuring::results::{results_of, scalars_of};
use eliminant_generator::template::file::TemplateFile;
use eliminant_python_catalogue::{Found, Sizes, Values};
use numpy::PyReadonlyArrayDyn;
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::batch::{Lists, Solved, values};
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
            results: outputs.map(PlannedField::scalars).sum(),
            solutions: plan.solutions,
            wanted: u64::MAX,
        };
        let data = plan.data.iter().map(|data| (data.name.clone(), data.shape.clone())).collect();
        Ok(Self { problem: problem.clone(), file, solver: InterpretedSolver::of(&plan), plan, data, sizes })
    }

    /// Solves one instance.
    fn solve(&self, values: &[Values<'_>], at: usize, found: &mut Found<'_>) -> Result<(), Error> {
        let data: Vec<f64> = values.iter().flat_map(|values| values.instance(at)).copied().collect();
        let points = self.solver.solve(&data)?;
        let solutions: Vec<Vec<f64>> = points.iter().map(|point| scalars_of(&self.plan, point)).collect();
        found.write(at, solutions.iter().map(Vec::as_slice));
        let results = results_of(&self.plan, &data, &points);
        for number in 0..points.len() {
            match results.get(number) {
                Some(results) => found.result(at, number).copy_from_slice(results),
                None => found.result(at, number).fill(f64::NAN),
            }
        }
        Ok(())
    }
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

    /// Solves instances from `first` on, `drawn` by a seed, as scenes if the flag says so, and
    /// judges what is found. Between whiles `progress` is called with the number of those that are
    /// done, and of all.
    #[pyo3(signature = (first, trials, drawn, progress = None))]
    fn stability<'py>(
        &self,
        py: Python<'py>,
        first: usize,
        trials: usize,
        drawn: (u64, bool),
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Figures<'py>> {
        let (seed, is_scene) = drawn;
        let scene = self.plan.scene.as_ref().filter(|_| is_scene);
        let instances = RandomInstances { numbers: first..first.saturating_add(trials), seed, scene };
        figures(py, &self.plan, &self.solver, &instances, &Tally::new(progress, trials))
    }

    /// Whether the problem states a scene.
    #[getter]
    fn has_scene(&self) -> bool {
        self.plan.scene.is_some()
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
