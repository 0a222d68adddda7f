//! Many instances: solutions, counts and codes into buffers of the caller.

use arrayvec::ArrayVec;
use eliminant::{Solutions, SolveError};

use crate::buffer::{check, write_rows};
use crate::code::Code;
use crate::guard::guarded;

/// Room of the caller for the results of many instances.
#[derive(Clone, Copy, Debug)]
pub struct BatchOutput {
    solutions: *mut f64,
    length: usize,
    counts: *mut usize,
    codes: *mut i32,
}

impl BatchOutput {
    /// Room for `length` numbers, and a count and a code for each instance. Nothing is written yet,
    /// and any values are allowed.
    #[must_use]
    pub fn new(solutions: *mut f64, length: usize, counts: *mut usize, codes: *mut i32) -> Self {
        Self { solutions, length, counts, codes }
    }

    /// Whether there is room for so many instances of so many numbers.
    fn check(self, instances: usize, numbers: usize) -> Result<(), Code> {
        let wanted = instances.checked_mul(numbers).ok_or(Code::WrongLength)?;
        if self.length < wanted {
            return Err(Code::ShortBuffer);
        }
        check(self.solutions, wanted)?;
        check(self.counts, instances)?;
        check(self.codes, instances)
    }

    /// Writes the result of an instance: its solutions, and NaN after them.
    ///
    /// # Safety
    /// [`BatchOutput::check`] was satisfied with more instances than `at` and MAX rows of N numbers
    /// for each, and the caller's promises about lengths hold.
    unsafe fn write<const N: usize, const MAX: usize>(self, at: usize, result: &Found<[f64; N], MAX>) {
        let (rows, code) = match result {
            Ok(found) => (&found[..], Code::Ok),
            Err(code) => (&[][..], *code),
        };
        let padded = rows.iter().copied().chain(std::iter::repeat([f64::NAN; N])).take(MAX);
        // SAFETY: the places of instance `at` are among those that were checked.
        unsafe {
            write_rows(self.solutions.add(at * N * MAX), padded);
            self.counts.add(at).write(rows.len());
            self.codes.add(at).write(code.number());
        }
    }
}

type Found<T, const MAX: usize> = Result<Solutions<T, MAX>, Code>;

/// A solver of many instances, and how a solution becomes a row.
pub trait Batch<const N: usize, const MAX: usize> {
    /// The data of an instance.
    type Data;
    /// A solution.
    type Solution: Copy;

    /// Whether data and results of so many instances fit their buffers.
    ///
    /// # Errors
    /// A code that says what does not fit.
    fn check(&self, instances: usize) -> Result<(), Code>;

    /// The data of an instance.
    ///
    /// # Safety
    /// [`Batch::check`] was satisfied with more instances than `at`, and the caller's promises
    /// about lengths hold.
    unsafe fn read(&self, at: usize) -> Self::Data;

    /// Solves all of the instances.
    fn solve(&self, data: &[Self::Data], results: &mut [Result<Solutions<Self::Solution, MAX>, SolveError>]);

    /// The row of a solution.
    ///
    /// # Errors
    /// Those of the solver.
    fn row(&self, data: &Self::Data, solution: Self::Solution) -> Result<[f64; N], SolveError>;
}

/// Solves `instances` instances, PIECE at a time, which bounds the stack that they take. It returns
/// the number of a code: what is wrong with buffers, and then nothing is written, or [`Code::Ok`].
/// Each instance then has a code of its own.
///
/// # Safety
/// Unless a pointer is null or misaligned, its buffer is as long as the caller says, those of
/// counts and codes as long as there are instances.
pub unsafe fn solve_batch<B: Batch<N, MAX>, const N: usize, const MAX: usize, const PIECE: usize>(
    batch: &B,
    instances: usize,
    output: BatchOutput,
) -> i32 {
    let numbers = const { N * MAX };
    if let Err(code) = batch.check(instances).and_then(|()| output.check(instances, numbers)) {
        return code.number();
    }
    let mut first = 0;
    while first < instances {
        let count = PIECE.min(instances - first);
        // SAFETY: all of these instances were checked.
        unsafe { solve_piece::<B, N, MAX, PIECE>(batch, first, count, output) };
        first += count;
    }
    Code::Ok.number()
}

/// Solves a piece of checked instances.
///
/// # Safety
/// As [`solve_batch`], where [`Batch::check`] and [`BatchOutput::check`] were satisfied.
unsafe fn solve_piece<B: Batch<N, MAX>, const N: usize, const MAX: usize, const PIECE: usize>(
    batch: &B,
    first: usize,
    count: usize,
    output: BatchOutput,
) {
    // SAFETY: the instances are among those that were checked.
    let data: ArrayVec<B::Data, PIECE> = (first..first + count).map(|at| unsafe { batch.read(at) }).collect();
    let solved = guarded(|| {
        let mut results: ArrayVec<_, PIECE> = data.iter().map(|_| Ok(Solutions::new())).collect();
        batch.solve(&data, &mut results);
        Ok(results)
    });
    for (at, of_instance) in data.iter().enumerate() {
        let rows = match &solved {
            Ok(results) => guarded(|| rows(batch, of_instance, &results[at])),
            Err(code) => Err(*code),
        };
        // SAFETY: the instance is among those that were checked.
        unsafe { output.write(first + at, &rows) };
    }
}

fn rows<B: Batch<N, MAX>, const N: usize, const MAX: usize>(
    batch: &B,
    data: &B::Data,
    result: &Result<Solutions<B::Solution, MAX>, SolveError>,
) -> Found<[f64; N], MAX> {
    let mut rows = Solutions::new();
    for &solution in result.as_ref().map_err(|&error| error)? {
        // There is as much room as there are solutions.
        rows.push(batch.row(data, solution)?);
    }
    Ok(rows)
}
