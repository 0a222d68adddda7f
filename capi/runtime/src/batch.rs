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

/// A solver of many instances, and how solutions become rows.
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

    /// The rows of the solutions of an instance. What data say beside them is computed once, and is
    /// refused even if there is no solution, as a single solve does.
    ///
    /// # Errors
    /// Those of the solver.
    fn rows(
        &self,
        data: &Self::Data,
        solutions: &Solutions<Self::Solution, MAX>,
    ) -> Result<Solutions<[f64; N], MAX>, SolveError>;
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
    let numbers = const {
        assert!(PIECE > 0, "a piece has an instance");
        N * MAX
    };
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
            Ok(results) => guarded(|| {
                let solutions = results[at].as_ref().map_err(|&error| error)?;
                Ok(batch.rows(of_instance, solutions)?)
            }),
            Err(code) => Err(*code),
        };
        // SAFETY: the instance is among those that were checked.
        unsafe { output.write(first + at, &rows) };
    }
}

#[cfg(test)]
mod tests {
    use std::ptr;

    use super::*;
    use crate::buffer::Input;

    /// The square roots of a number, at most two. 13 panics, and 14 does for its rows; -2 is
    /// refused for its rows, of which there are none.
    struct Roots(Input);

    impl Batch<1, 2> for Roots {
        type Data = f64;
        type Solution = f64;

        fn check(&self, instances: usize) -> Result<(), Code> {
            self.0.check::<f64>(instances).map(|_| ())
        }

        unsafe fn read(&self, at: usize) -> f64 {
            unsafe { self.0.read(at) }
        }

        fn solve(&self, data: &[f64], results: &mut [Result<Solutions<f64, 2>, SolveError>]) {
            for (&number, result) in data.iter().zip(results) {
                assert!(number != 13.0, "this panic belongs to the test");
                let mut roots = Solutions::new();
                if number >= 0.0 {
                    assert!(roots.push(-number.sqrt()) && roots.push(number.sqrt()));
                }
                *result = if number.is_nan() { Err(SolveError::NonFiniteInput) } else { Ok(roots) };
            }
        }

        fn rows(&self, data: &f64, solutions: &Solutions<f64, 2>) -> Result<Solutions<[f64; 1], 2>, SolveError> {
            assert!(*data != 14.0, "this panic belongs to the test");
            if *data == -2.0 { Err(SolveError::LostRank) } else { Ok(solutions.map(|solution| [solution])) }
        }
    }

    /// What a call writes for these numbers: its code, then solutions, counts and codes.
    fn call<const PIECE: usize>(numbers: &[f64]) -> (i32, Vec<f64>, Vec<usize>, Vec<i32>) {
        let n = numbers.len();
        let (mut solutions, mut counts, mut codes) = (vec![7.0; 2 * n], vec![7; n], vec![7; n]);
        let output = BatchOutput::new(solutions.as_mut_ptr(), 2 * n, counts.as_mut_ptr(), codes.as_mut_ptr());
        let roots = Roots(Input::new(numbers.as_ptr(), n));
        let code = unsafe { solve_batch::<_, 1, 2, PIECE>(&roots, n, output) };
        (code, solutions, counts, codes)
    }

    #[test]
    fn results_are_in_their_places_whatever_the_pieces() {
        let numbers = [4.0, -1.0, f64::NAN, 9.0, 16.0];
        for (code, solutions, counts, codes) in [call::<1>(&numbers), call::<2>(&numbers), call::<8>(&numbers)] {
            assert_eq!(code, 0);
            assert_eq!(counts, [2, 0, 0, 2, 2]);
            assert_eq!(codes, [0, 0, Code::NonFiniteInput.number(), 0, 0]);
            assert_eq!([&solutions[..2], &solutions[6..]].concat(), [-2.0, 2.0, -3.0, 3.0, -4.0, 4.0]);
            assert!(solutions[2..6].iter().all(|number| number.is_nan()));
        }
        assert_eq!(call::<4>(&[]).0, 0);
    }

    #[test]
    fn data_are_refused_for_rows_even_if_there_are_none() {
        let (code, _, counts, codes) = call::<2>(&[-2.0, -1.0, 4.0]);
        assert_eq!((code, counts, codes), (0, vec![0, 0, 2], vec![Code::LostRank.number(), 0, 0]));
    }

    #[test]
    fn a_panic_is_the_code_of_its_piece() {
        let (code, _, counts, codes) = call::<2>(&[4.0, 4.0, 13.0, 4.0, 14.0, 4.0]);
        let panic = Code::Panic.number();
        assert_eq!((code, counts, codes), (0, vec![2, 2, 0, 0, 0, 2], vec![0, 0, panic, panic, panic, 0]));
    }

    #[test]
    fn buffers_are_checked_before_anything_is_written() {
        let numbers = [4.0; 3];
        let (mut solutions, mut counts, mut codes) = ([7.0; 6], [7; 3], [7; 3]);
        let (to_solutions, to_counts, to_codes) = (solutions.as_mut_ptr(), counts.as_mut_ptr(), codes.as_mut_ptr());
        let given = |length, instances, output| {
            let roots = Roots(Input::new(numbers.as_ptr(), length));
            unsafe { solve_batch::<_, 1, 2, 2>(&roots, instances, output) }
        };
        let output = BatchOutput::new(to_solutions, 6, to_counts, to_codes);
        assert_eq!(given(2, 3, output), Code::WrongLength.number());
        assert_eq!(given(usize::MAX, usize::MAX, output), Code::WrongLength.number());
        let wrong = [
            (BatchOutput::new(to_solutions, 5, to_counts, to_codes), Code::ShortBuffer),
            (BatchOutput::new(ptr::null_mut(), 6, to_counts, to_codes), Code::NullPointer),
            (BatchOutput::new(to_solutions, 6, ptr::null_mut(), to_codes), Code::NullPointer),
            (BatchOutput::new(to_solutions, 6, to_counts, to_codes.wrapping_byte_add(1)), Code::MisalignedPointer),
        ];
        for (output, code) in wrong {
            assert_eq!(given(3, 3, output), code.number());
        }
        assert_eq!((solutions, counts, codes), ([7.0; 6], [7; 3], [7; 3]));
    }
}
