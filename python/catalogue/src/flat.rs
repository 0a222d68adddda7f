//! Arrays of any depth from flat values and back.

/// A scalar, or an array of such.
pub(crate) trait Flat: Sized {
    /// The number of scalars.
    const LEN: usize;

    /// From as many values as there are scalars, row by row.
    fn from_flat(values: &[f64]) -> Self;

    /// Writes the scalars row by row.
    fn write(&self, values: &mut [f64]);
}

impl Flat for f64 {
    const LEN: usize = 1;

    #[inline]
    fn from_flat(values: &[f64]) -> Self {
        values[0]
    }

    #[inline]
    fn write(&self, values: &mut [f64]) {
        values[0] = *self;
    }
}

impl<T: Flat, const N: usize> Flat for [T; N] {
    const LEN: usize = N * T::LEN;

    #[inline]
    fn from_flat(values: &[f64]) -> Self {
        std::array::from_fn(|at| T::from_flat(&values[at * T::LEN..(at + 1) * T::LEN]))
    }

    #[inline]
    fn write(&self, values: &mut [f64]) {
        for (element, values) in self.iter().zip(values.chunks_mut(T::LEN)) {
            element.write(values);
        }
    }
}

/// The number of scalars of a value that is written.
pub(crate) fn len<T: Flat>(_: &T) -> usize {
    T::LEN
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrays_survive_the_way_there_and_back() {
        let values: Vec<f64> = (0..12).map(f64::from).collect();
        let array = <[[[f64; 2]; 3]; 2]>::from_flat(&values);
        assert_eq!((array[1][0], len(&array)), ([6.0, 7.0], 12));
        let mut back = vec![0.0; 12];
        array.write(&mut back);
        assert_eq!(back, values);
    }
}
