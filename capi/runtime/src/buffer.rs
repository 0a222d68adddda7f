//! Buffers of the caller. They are read and written number by number through raw pointers: no
//! reference to them is made, so that buffers that overlap are no undefined behaviour.

use crate::code::Code;
use crate::numbers::Numbers;

/// Data of the caller: a pointer, and how many numbers it promises.
#[derive(Clone, Copy, Debug)]
pub struct Input {
    pointer: *const f64,
    length: usize,
}

impl Input {
    /// Nothing is read yet, and any values are allowed.
    #[must_use]
    pub fn new(pointer: *const f64, length: usize) -> Self {
        Self { pointer, length }
    }

    /// Whether this can hold the data of so many instances, and no others.
    ///
    /// # Errors
    /// A code that says what is wrong with pointer or length.
    pub fn check<T: Numbers>(self, instances: usize) -> Result<Self, Code> {
        let wanted = T::LENGTH.checked_mul(instances).ok_or(Code::WrongLength)?;
        if self.length != wanted {
            return Err(Code::WrongLength);
        }
        check(self.pointer, wanted)?;
        Ok(self)
    }

    /// The data of an instance.
    ///
    /// # Safety
    /// [`Input::check`] was satisfied with more instances than `at`, and the caller's promise about
    /// the length holds.
    #[inline]
    #[must_use]
    pub unsafe fn read<T: Numbers>(self, at: usize) -> T {
        let mut next = at * T::LENGTH;
        T::take(&mut || {
            // SAFETY: `next` is below the length that was checked.
            let number = unsafe { self.pointer.add(next).read() };
            next += 1;
            number
        })
    }

    /// The data of the only instance.
    ///
    /// # Errors
    /// As [`Input::check`].
    ///
    /// # Safety
    /// Unless the pointer is null or misaligned, so many numbers as promised can be read there.
    #[inline]
    pub unsafe fn read_one<T: Numbers>(self) -> Result<T, Code> {
        // SAFETY: one instance was checked, and its index is 0.
        self.check::<T>(1).map(|checked| unsafe { checked.read(0) })
    }
}

/// Whether so many values can be at an address. Without any, no address is looked at.
pub(crate) fn check<T>(pointer: *const T, count: usize) -> Result<(), Code> {
    match () {
        () if count == 0 => Ok(()),
        () if pointer.is_null() => Err(Code::NullPointer),
        () if !pointer.is_aligned() => Err(Code::MisalignedPointer),
        // No object is larger: the address of its end would overflow.
        () if count > isize::MAX.unsigned_abs() / size_of::<T>() => Err(Code::WrongLength),
        () => Ok(()),
    }
}

/// Writes the numbers of rows, one after another.
///
/// # Safety
/// So many numbers can be written there.
pub(crate) unsafe fn write_rows<const N: usize>(pointer: *mut f64, rows: impl Iterator<Item = [f64; N]>) {
    for (at, number) in rows.flatten().enumerate() {
        // SAFETY: there is room for all of them.
        unsafe { pointer.add(at).write(number) };
    }
}

#[cfg(test)]
mod tests {
    use std::ptr;

    use super::*;

    #[test]
    fn pointers_and_lengths_are_checked() {
        let numbers = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        let input = |length| Input::new(numbers.as_ptr(), length);
        let read = |input: Input| unsafe { input.read_one::<[[f64; 3]; 2]>() };
        assert_eq!(read(input(6)), Ok([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]));
        for length in [0, 5, 7, usize::MAX] {
            assert_eq!(read(input(length)), Err(Code::WrongLength));
        }
        assert_eq!(read(Input::new(ptr::null(), 6)), Err(Code::NullPointer));
        let between = numbers.as_ptr().cast::<u8>().wrapping_add(1).cast();
        assert_eq!(read(Input::new(between, 6)), Err(Code::MisalignedPointer));
        assert_eq!(unsafe { input(6).check::<[f64; 3]>(2).map(|checked| checked.read(1)) }, Ok([4.0, 5.0, 6.0]));
        assert_eq!(input(6).check::<[f64; 3]>(usize::MAX).err(), Some(Code::WrongLength));
        assert_eq!(unsafe { Input::new(ptr::null(), 0).read_one::<[f64; 0]>() }, Ok([]));
        let half = usize::MAX / 4;
        assert_eq!(input(half).check::<f64>(half).err(), Some(Code::WrongLength));
    }
}
