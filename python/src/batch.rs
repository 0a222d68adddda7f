//! Batches of instances: pieces on all cores, results as arrays.

use std::sync::atomic::{AtomicBool, Ordering};

use eliminant_python_catalogue::{Found, SOLVERS, Sizes, Solver, Values, product, status};
use numpy::{Element, PyArray1, PyArrayMethods, PyReadonlyArrayDyn, PyReadwriteArray1, PyUntypedArrayMethods};
use pyo3::exceptions::{PyIndexError, PyMemoryError, PyValueError};
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::errors::SolveError;
use crate::progress::Tally;
use crate::threads::interruptible;

/// Instances that a core takes at once. Solvers that compute several side by side need no more.
const PIECE: usize = 256;
/// Operations after which a core asks whether the work is over.
const PIECE_WORK: u64 = 1 << 24;

/// What is returned for a batch: flat arrays of unknowns and results, counts, status.
pub(crate) type Solved<'py> =
    (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<i64>>, Bound<'py, PyArray1<u16>>);

/// The lists of a batch, in memory of NumPy, which takes large pages.
pub(crate) struct Lists<'py> {
    sizes: Sizes,
    unknowns: PyReadwriteArray1<'py, f64>,
    results: PyReadwriteArray1<'py, f64>,
    counts: PyReadwriteArray1<'py, i64>,
    status: PyReadwriteArray1<'py, u16>,
}

/// Solves `count` instances `of` a solver, by its number, and returns its results of these names.
/// Each array holds the data of all instances, or those that all share. Between whiles `progress`
/// is called with the number of instances that are done, and of all.
#[pyfunction]
#[pyo3(signature = (of, arrays, count, progress = None))]
pub(crate) fn solve_batch<'py>(
    py: Python<'py>,
    of: (usize, Vec<String>),
    arrays: Vec<PyReadonlyArrayDyn<'py, f64>>,
    count: usize,
    progress: Option<Py<PyAny>>,
) -> PyResult<Solved<'py>> {
    let (solver, results) = (numbered(of.0)?, of.1);
    let values = values(solver.name, solver.data, &arrays, count)?;
    let mut lists = Lists::new(py, solver.sizes.of_results(solver.results, &results), count)?;
    let mut found = lists.found()?;
    let tally = Tally::new(progress, count);
    let piece = (PIECE_WORK / solver.operations.max(1)).clamp(1, PIECE as u64) as usize;
    if count <= piece {
        py.detach(|| (solver.solve_batch)(&values, &mut found));
        tally.add(count);
    } else {
        let work = |is_over: &AtomicBool| {
            found.pieces(piece).into_par_iter().enumerate().for_each(|(number, mut found)| {
                if !is_over.load(Ordering::Relaxed) {
                    let values: Vec<Values<'_>> = values.iter().map(|values| values.from(number * piece)).collect();
                    (solver.solve_batch)(&values, &mut found);
                    tally.add(found.counts.len());
                }
            });
        };
        interruptible(py, work, |py| tally.tell(py))?;
    }
    tally.tell(py)?;
    Ok(lists.into_arrays())
}

/// Solves one instance `of` a solver, by its number, and returns its results of these names.
///
/// # Errors
/// That of the solver, as `SolveError`.
#[pyfunction]
pub(crate) fn solve_one<'py>(
    py: Python<'py>,
    of: (usize, Vec<String>),
    arrays: Vec<PyReadonlyArrayDyn<'py, f64>>,
) -> PyResult<Solved<'py>> {
    let (solver, results) = (numbered(of.0)?, of.1);
    let values = values(solver.name, solver.data, &arrays, 1)?;
    let mut lists = Lists::new(py, solver.sizes.of_results(solver.results, &results), 1)?;
    let mut found = lists.found()?;
    let solved = py.detach(|| (solver.solve)(&values, &mut found));
    solved.map_err(|error| SolveError::new_err(error.to_string()))?;
    Ok(lists.into_arrays())
}

/// The mean of this name over `count` measurements, which the solver with this number takes.
#[pyfunction]
pub(crate) fn mean<'py>(
    py: Python<'py>,
    solver: usize,
    name: &str,
    arrays: Vec<PyReadonlyArrayDyn<'py, f64>>,
    count: usize,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let solver = numbered(solver)?;
    let mean = solver.means.iter().find(|mean| mean.name == name);
    let mean = mean.ok_or_else(|| PyIndexError::new_err(format!("{} has no `{name}`", solver.name)))?;
    let values = values(name, mean.data, &arrays, count)?;
    let computed = py.detach(|| (mean.compute)(&values, count));
    Ok(PyArray1::from_vec(py, computed))
}

/// The text of a status; empty where there is no error.
#[pyfunction]
pub(crate) fn status_text(status: u16) -> String {
    status::text(status)
}

fn numbered(solver: usize) -> PyResult<&'static Solver> {
    SOLVERS.get(solver).ok_or_else(|| PyIndexError::new_err(format!("there is no solver {solver}")))
}

/// The data as slices, whose lengths are those that the solver reads.
pub(crate) fn values<'a, N: AsRef<str>, S: AsRef<[usize]>>(
    solver: &str,
    data: &[(N, S)],
    arrays: &'a [PyReadonlyArrayDyn<'_, f64>],
    count: usize,
) -> PyResult<Vec<Values<'a>>> {
    if arrays.len() != data.len() {
        return Err(PyValueError::new_err(format!("{solver} takes {} arrays", data.len())));
    }
    let of_array = |(array, (name, shape)): (&'a PyReadonlyArrayDyn<'_, f64>, &(N, S))| {
        let (name, shape) = (name.as_ref(), shape.as_ref());
        let wrong = || PyValueError::new_err(format!("`{name}` has another shape"));
        let scalars = array.as_slice().map_err(|_| PyValueError::new_err(format!("`{name}` is not contiguous")))?;
        let length = product(shape);
        let stride = if array.shape() == shape { 0 } else { length };
        let expected = if stride == 0 { Some(length) } else { length.checked_mul(count) };
        (expected == Some(scalars.len())).then_some(Values { scalars, stride }).ok_or_else(wrong)
    };
    arrays.iter().zip(data).map(of_array).collect()
}

/// As many zeros. Pages of memory are not touched before they are written.
///
/// # Errors
/// There is not so much memory.
fn zeros<T: Element>(py: Python<'_>, length: usize) -> PyResult<PyReadwriteArray1<'_, T>> {
    let no_memory = |_| PyMemoryError::new_err(format!("there is no memory for {length} numbers"));
    // NumPy would end in a panic.
    Vec::<T>::new().try_reserve_exact(length).map_err(no_memory)?;
    Ok(PyArray1::zeros(py, length, false).try_readwrite()?)
}

impl<'py> Lists<'py> {
    /// # Errors
    /// As [`zeros`].
    pub(crate) fn new(py: Python<'py>, sizes: Sizes, count: usize) -> PyResult<Self> {
        let solutions = count.saturating_mul(sizes.solutions);
        Ok(Self {
            sizes,
            unknowns: zeros(py, solutions.saturating_mul(sizes.unknowns))?,
            results: zeros(py, solutions.saturating_mul(sizes.results))?,
            counts: zeros(py, count)?,
            status: zeros(py, count)?,
        })
    }

    /// Where solutions are written.
    pub(crate) fn found(&mut self) -> PyResult<Found<'_>> {
        Ok(Found {
            sizes: self.sizes,
            unknowns: self.unknowns.as_slice_mut()?,
            results: self.results.as_slice_mut()?,
            counts: self.counts.as_slice_mut()?,
            status: self.status.as_slice_mut()?,
        })
    }

    pub(crate) fn into_arrays(self) -> Solved<'py> {
        let Self { unknowns, results, counts, status, .. } = self;
        (array(&unknowns), array(&results), array(&counts), array(&status))
    }
}

/// The array of which a list is a borrow.
fn array<'py, T: Element>(list: &Bound<'py, PyArray1<T>>) -> Bound<'py, PyArray1<T>> {
    list.clone()
}
