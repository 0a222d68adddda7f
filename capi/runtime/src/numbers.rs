//! Numbers in the order of C: arrays of any depth, row by row.

use eliminant::Complex;

/// Numbers in a fixed order: a scalar, or an array of any depth, row by row.
pub trait Numbers: Copy {
    /// How many.
    const LENGTH: usize;

    /// From its numbers, one after another.
    fn take(next: &mut impl FnMut() -> f64) -> Self;

    /// Its numbers, one after another.
    fn put(&self, to: &mut impl FnMut(f64));
}

impl Numbers for f64 {
    const LENGTH: usize = 1;

    #[inline]
    fn take(next: &mut impl FnMut() -> f64) -> Self {
        next()
    }

    #[inline]
    fn put(&self, to: &mut impl FnMut(f64)) {
        to(*self);
    }
}

impl Numbers for Complex<f64> {
    const LENGTH: usize = 2;

    #[inline]
    fn take(next: &mut impl FnMut() -> f64) -> Self {
        let (re, im) = (next(), next());
        Self { re, im }
    }

    #[inline]
    fn put(&self, to: &mut impl FnMut(f64)) {
        to(self.re);
        to(self.im);
    }
}

impl<T: Numbers, const N: usize> Numbers for [T; N] {
    const LENGTH: usize = N * T::LENGTH;

    #[inline]
    fn take(next: &mut impl FnMut() -> f64) -> Self {
        std::array::from_fn(|_| T::take(next))
    }

    #[inline]
    fn put(&self, to: &mut impl FnMut(f64)) {
        self.iter().for_each(|element| element.put(to));
    }
}

/// A row of the numbers that `put` hands over, in their order. Numbers beyond the row are left out,
/// places beyond the numbers are NaN.
#[inline]
pub fn row<const N: usize>(put: impl FnOnce(&mut dyn FnMut(f64))) -> [f64; N] {
    let mut row = [f64::NAN; N];
    let mut places = row.iter_mut();
    put(&mut |number| {
        if let Some(place) = places.next() {
            *place = number;
        }
    });
    row
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrays_are_read_and_written_row_by_row() {
        let mut count = 0.0;
        let array: [[f64; 3]; 2] = Numbers::take(&mut || {
            count += 1.0;
            count
        });
        assert_eq!(array, [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
        assert_eq!(<[[f64; 3]; 2]>::LENGTH, 6);
        assert_eq!(row::<6>(|mut to| array.put(&mut to)), [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        assert_eq!(row::<2>(|mut to| array.put(&mut to)), [1.0, 2.0]);
        assert!(row::<7>(|mut to| array.put(&mut to))[6].is_nan());
    }
}
