//! Batches of instances: pieces on all cores, results as arrays.

use std::sync::atomic::{AtomicBool, Ordering};

use numpy::{PyArray1, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::exceptions::{PyIndexError, PyMemoryError, PyValueError};
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::catalogue::{Found, SOLVERS, Sizes, Solver, Values, product};
use crate::threads::interruptible;
use crate::errors::SolveError;
use crate::status;

/// Instances that a core takes at once. Solvers that compute several side by side need no more.
const PIECE: usize = 256;
/// Operations after which a core asks whether the work is over.
const PIECE_WORK: u64 = 1 << 24;

/// What is returned for a batch: flat arrays of unknowns and results, counts, status.
pub(crate) type Solved<'py> =
    (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<i64>>, Bound<'py, PyArray1<u16>>);

/// The lists of a batch.
pub(crate) struct Lists {
    unknowns: Vec<f64>,
    results: Vec<f64>,
    counts: Vec<i64>,
    status: Vec<u16>,
}

/// Solves `count` instances by the solver with this number. Each array holds the data of all
/// instances, or those that all share.
#[pyfunction]
pub(crate) fn solve_batch<'py>(
    py: Python<'py>,
    solver: usize,
    arrays: Vec<PyReadonlyArrayDyn<'py, f64>>,
    count: usize,
) -> PyResult<Solved<'py>> {
    let solver = numbered(solver)?;
    let values = values(solver.name, solver.data, &arrays, count)?;
    let mut lists = Lists::new(solver.sizes, count)?;
    let piece = (PIECE_WORK / solver.operations.max(1)).clamp(1, PIECE as u64) as usize;
    if count <= piece {
        py.detach(|| (solver.solve_batch)(&values, &mut lists.found(solver.sizes)));
    } else {
        interruptible(py, |is_over| solve_pieces(solver, &values, &mut lists, piece, is_over), |_| Ok(()))?;
    }
    Ok(lists.into_arrays(py))
}

/// Solves one instance.
///
/// # Errors
/// That of the solver, as `SolveError`.
#[pyfunction]
pub(crate) fn solve_one<'py>(
    py: Python<'py>,
    solver: usize,
    arrays: Vec<PyReadonlyArrayDyn<'py, f64>>,
) -> PyResult<Solved<'py>> {
    let solver = numbered(solver)?;
    let values = values(solver.name, solver.data, &arrays, 1)?;
    let mut lists = Lists::new(solver.sizes, 1)?;
    let solved = py.detach(|| (solver.solve)(&values, &mut lists.found(solver.sizes)));
    solved.map_err(|error| SolveError::new_err(error.to_string()))?;
    Ok(lists.into_arrays(py))
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

/// Solves the pieces of a batch on all cores, until it is over.
fn solve_pieces(solver: &Solver, values: &[Values<'_>], lists: &mut Lists, piece: usize, is_over: &AtomicBool) {
    lists.found(solver.sizes).pieces(piece).into_par_iter().enumerate().for_each(|(number, mut found)| {
        if !is_over.load(Ordering::Relaxed) {
            let values: Vec<Values<'_>> = values.iter().map(|values| values.from(number * piece)).collect();
            (solver.solve_batch)(&values, &mut found);
        }
    });
}

/// As many zeros. Pages of memory are not touched before they are written.
fn zeros<T: Clone + Default>(length: usize) -> PyResult<Vec<T>> {
    let no_memory = |_| PyMemoryError::new_err(format!("there is no memory for {length} numbers"));
    Vec::<T>::new().try_reserve_exact(length).map_err(no_memory)?;
    Ok(vec![T::default(); length])
}

impl Lists {
    /// # Errors
    /// There is not so much memory.
    pub(crate) fn new(sizes: Sizes, count: usize) -> PyResult<Self> {
        let solutions = count.saturating_mul(sizes.solutions);
        Ok(Self {
            unknowns: zeros(solutions.saturating_mul(sizes.unknowns))?,
            results: zeros(solutions.saturating_mul(sizes.results))?,
            counts: zeros(count)?,
            status: zeros(count)?,
        })
    }

    pub(crate) fn found(&mut self, sizes: Sizes) -> Found<'_> {
        Found {
            sizes,
            unknowns: &mut self.unknowns,
            results: &mut self.results,
            counts: &mut self.counts,
            status: &mut self.status,
        }
    }

    pub(crate) fn into_arrays(self, py: Python<'_>) -> Solved<'_> {
        let Self { unknowns, results, counts, status } = self;
        (
            PyArray1::from_vec(py, unknowns),
            PyArray1::from_vec(py, results),
            PyArray1::from_vec(py, counts),
            PyArray1::from_vec(py, status),
        )
    }
}
