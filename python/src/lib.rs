//! Python module `eliminant._eliminant`: solvers on arrays, and the generator. The package
//! `eliminant` makes it pleasant.

use eliminant_python_catalogue::{self as catalogue, status};
use pyo3::prelude::*;

/// The exceptions of this package.
mod errors;

/// Work on all cores that Ctrl-C can end.
mod threads;

/// How many things of a batch are done, as Python hears it.
mod progress;

/// Batches of instances: pieces on all cores, results as arrays.
mod batch;

/// Problems with a template, interpreted.
mod planned;

/// What a solver finds on random instances.
mod stability;

/// A search that reports to Python.
mod search;

/// Problems of the generator.
mod problem;

/// The command `eliminant` as a function.
mod command;

/// Cylinder triangulation.
mod cylinders;

/// Cylinders in photographs.
mod photos;

/// Name and shape of each array.
fn named(arrays: &[catalogue::Named]) -> Vec<(&'static str, Vec<usize>)> {
    arrays.iter().map(|&(name, shape)| (name, shape.to_vec())).collect()
}

/// What Python sees of a solver: name, data, fields, results, most solutions, documentation.
type Description = (
    &'static str,
    Vec<(&'static str, Vec<usize>)>,
    Vec<(&'static str, Vec<usize>)>,
    Vec<(&'static str, Vec<usize>)>,
    usize,
    &'static str,
);

/// All solvers, in the order of their numbers.
#[pyfunction]
fn solvers() -> Vec<Description> {
    let describe = |solver: &catalogue::Solver| {
        let [data, fields, results] = [solver.data, solver.fields, solver.results].map(named);
        (solver.name, data, fields, results, solver.sizes.solutions, solver.docs)
    };
    catalogue::SOLVERS.iter().map(describe).collect()
}

/// What Python sees of a mean: number of the solver, name, measurement, shape, documentation.
type MeanDescription = (usize, &'static str, Vec<(&'static str, Vec<usize>)>, Vec<usize>, &'static str);

/// All means over measurements, in the order of their solvers.
#[pyfunction]
fn means() -> Vec<MeanDescription> {
    let solvers = catalogue::SOLVERS.iter().enumerate();
    let of_solver = |(number, solver): (usize, &'static catalogue::Solver)| {
        let describe =
            move |mean: &'static catalogue::Mean| (number, mean.name, named(mean.data), mean.shape.to_vec(), mean.docs);
        solver.means.iter().map(describe)
    };
    solvers.flat_map(of_solver).collect()
}

/// The problem file and the template file of a solver.
#[pyfunction]
fn files(name: &str) -> Option<[&'static str; 2]> {
    catalogue::SOLVERS.iter().find(|solver| solver.name == name).map(|solver| solver.files)
}

#[pymodule]
fn _eliminant(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add("SolveError", module.py().get_type::<errors::SolveError>())?;
    module.add("ProblemError", module.py().get_type::<errors::ProblemError>())?;
    module.add("CylinderError", module.py().get_type::<errors::CylinderError>())?;
    module.add_function(wrap_pyfunction!(cylinders::triangulate_cylinders, module)?)?;
    module.add_function(wrap_pyfunction!(cylinders::match_cylinder_lines, module)?)?;
    module.add_function(wrap_pyfunction!(photos::cylinders_of_photographs, module)?)?;
    module.add("COUNTS", stability::COUNTS.to_vec())?;
    module.add("ERRORS", stability::ERRORS.to_vec())?;
    module.add_class::<problem::NativeProblem>()?;
    module.add_class::<planned::Planned>()?;
    module.add_function(wrap_pyfunction!(command::run_command, module)?)?;
    module.add("STATUS", status::KINDS.to_vec())?;
    module.add_function(wrap_pyfunction!(solvers, module)?)?;
    module.add_function(wrap_pyfunction!(files, module)?)?;
    module.add_function(wrap_pyfunction!(means, module)?)?;
    module.add_function(wrap_pyfunction!(batch::mean, module)?)?;
    module.add_function(wrap_pyfunction!(batch::solve_batch, module)?)?;
    module.add_function(wrap_pyfunction!(batch::solve_one, module)?)?;
    module.add_function(wrap_pyfunction!(batch::status_text, module)?)?;
    Ok(())
}
