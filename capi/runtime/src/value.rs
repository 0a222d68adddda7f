//! One value, a number or an array: means over measurements, and what measures a solution.

use crate::buffer::check;
use crate::code::Code;
use crate::guard::guarded;
use crate::numbers::Numbers;

/// Computes a value into room of the caller, a pointer and how many numbers it promises, and
/// returns the number of a code. Nothing is written unless it is that of no error.
///
/// # Safety
/// Unless the pointer is null or misaligned, so many numbers can be written there.
pub unsafe fn value<T: Numbers>(
    (pointer, length): (*mut f64, usize),
    compute: impl FnOnce() -> Result<T, Code>,
) -> i32 {
    let room = if length == T::LENGTH { check(pointer, length) } else { Err(Code::WrongLength) };
    match room.and_then(|()| guarded(compute)) {
        Ok(value) => {
            let mut at = 0;
            value.put(&mut |number| {
                // SAFETY: the pointer is checked, and there is room for as many numbers as T has.
                unsafe { pointer.add(at).write(number) };
                at += 1;
            });
            Code::Ok.number()
        }
        Err(code) => code.number(),
    }
}

#[cfg(test)]
mod tests {
    use std::ptr;

    use super::*;

    #[test]
    fn a_value_is_written_whole_or_not_at_all() {
        let matrix = [[1.0, 2.0], [3.0, 4.0]];
        let mut room = [7.0; 4];
        let to = room.as_mut_ptr();
        let call = |to, length, computed| unsafe { value::<[[f64; 2]; 2]>((to, length), || computed) };
        for (to, length, computed, code) in [
            (to, 3, Ok(matrix), Code::WrongLength),
            (to, 5, Ok(matrix), Code::WrongLength),
            (ptr::null_mut(), 4, Ok(matrix), Code::NullPointer),
            (to.wrapping_byte_add(1), 4, Ok(matrix), Code::MisalignedPointer),
            (to, 4, Err(Code::WrongLength), Code::WrongLength),
        ] {
            assert_eq!(call(to, length, computed), code.number());
        }
        assert_eq!(room, [7.0; 4]);
        assert_eq!(call(to, 4, Ok(matrix)), Code::Ok.number());
        assert_eq!(room, [1.0, 2.0, 3.0, 4.0]);
        let code = unsafe { value::<f64>((to, 1), || panic!("this panic belongs to the test")) };
        assert_eq!((code, room[0]), (Code::Panic.number(), 1.0));
    }
}
