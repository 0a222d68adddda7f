//! One instance: solutions into a buffer of the caller.

use eliminant::Solutions;

use crate::buffer::{check, write_rows};
use crate::code::Code;
use crate::guard::guarded;

/// Room of the caller for the solutions of one instance, and where their number goes.
#[derive(Clone, Copy, Debug)]
pub struct Output {
    solutions: *mut f64,
    capacity: usize,
    count: *mut usize,
}

impl Output {
    /// Room for `capacity` rows. Nothing is written yet, and any values are allowed.
    #[must_use]
    pub fn new(solutions: *mut f64, capacity: usize, count: *mut usize) -> Self {
        Self { solutions, capacity, count }
    }

    fn check<const N: usize>(self) -> Result<(), Code> {
        let numbers = self.capacity.checked_mul(N).ok_or(Code::WrongLength)?;
        check(self.solutions, numbers)
    }
}

/// Solves one instance, and returns the number of a code. The count is 0 unless solutions were
/// found. If there are more than there is room for, it is their number, and the first are written.
///
/// # Safety
/// Unless a pointer is null or misaligned, one count and `capacity` rows of N numbers can be
/// written.
pub unsafe fn solve<const N: usize, const MAX: usize>(
    output: Output,
    solve: impl FnOnce() -> Result<Solutions<[f64; N], MAX>, Code>,
) -> i32 {
    if let Err(code) = check(output.count, 1) {
        return code.number();
    }
    // SAFETY: the pointer is checked, and the caller promises room for one count.
    unsafe { output.count.write(0) };
    match output.check::<N>().and_then(|()| guarded(solve)) {
        Ok(found) => {
            let written = found.len().min(output.capacity);
            // SAFETY: the pointers are checked, and there is room for the rows that are written.
            unsafe {
                write_rows(output.solutions, found.iter().take(written).copied());
                output.count.write(found.len());
            }
            if written < found.len() { Code::ShortBuffer.number() } else { Code::Ok.number() }
        }
        Err(code) => code.number(),
    }
}

#[cfg(test)]
mod tests {
    use std::ptr;

    use super::*;

    fn two() -> Result<Solutions<[f64; 2], 4>, Code> {
        let mut solutions = Solutions::new();
        assert!(solutions.push([1.0, 2.0]) && solutions.push([3.0, 4.0]));
        Ok(solutions)
    }

    #[test]
    fn no_more_rows_are_written_than_there_is_room_for() {
        for (capacity, code) in [(0, Code::ShortBuffer), (1, Code::ShortBuffer), (2, Code::Ok), (3, Code::Ok)] {
            let (mut rows, mut count) = ([0.0; 6], 7);
            let output = Output::new(rows.as_mut_ptr(), capacity, &raw mut count);
            assert_eq!(unsafe { solve(output, two) }, code.number());
            assert_eq!(count, 2);
            let written = 2 * capacity.min(2);
            assert_eq!(rows[..written], [1.0, 2.0, 3.0, 4.0][..written]);
            assert!(rows[written..].iter().all(|&number| number == 0.0));
        }
    }

    #[test]
    fn errors_are_codes_and_the_count_is_none() {
        let (mut rows, mut count) = ([0.0; 4], 7);
        let mut call = |rows: *mut f64, capacity, found| {
            count = 7;
            let code = unsafe { solve(Output::new(rows, capacity, &raw mut count), || found) };
            (code, count)
        };
        assert_eq!(call(ptr::null_mut(), 2, two()), (Code::NullPointer.number(), 0));
        assert_eq!(call(ptr::null_mut(), 0, two()), (Code::ShortBuffer.number(), 2));
        assert_eq!(call(rows.as_mut_ptr(), usize::MAX, two()), (Code::WrongLength.number(), 0));
        assert_eq!(call(rows.as_mut_ptr(), 2, Err(Code::LostRank)), (Code::LostRank.number(), 0));
        let between = rows.as_mut_ptr().cast::<u8>().wrapping_add(4).cast();
        assert_eq!(call(between, 1, two()), (Code::MisalignedPointer.number(), 0));
        let without_count = Output::new(rows.as_mut_ptr(), 2, ptr::null_mut());
        assert_eq!(unsafe { solve(without_count, two) }, Code::NullPointer.number());
    }

    #[test]
    fn a_panic_is_a_code() {
        let (mut rows, mut count) = ([0.0; 2], 7);
        let output = Output::new(rows.as_mut_ptr(), 1, &raw mut count);
        let code = unsafe { solve::<2, 4>(output, || panic!("this panic belongs to the test")) };
        assert_eq!((code, count), (Code::Panic.number(), 0));
    }
}
