//! The number of entries of vectors, and where they are kept. One kernel serves constant and
//! run-time sizes.
//!
//! | size | vector of `T` | who uses it |
//! |---|---|---|
//! | [`Fixed<N>`] | `[T; N]` | emitted solvers: loops have bounds that the compiler knows |
//! | [`AtMost<C>`] | `[T; C]`, partly in use | spectra at twice the precision: one copy for all |
//! | `Dynamic` (feature `alloc`) | `Vec<T>` | interpreted plans, with sizes known at run time |
//! | `OnHeap<Z>` (feature `alloc`) | as `Z`; matrices, lists on the heap | large emitted solvers |
//!
//! A kernel does the same operations in the same order for all sizes, so the results have the same
//! bits.

use core::ops::{Deref, DerefMut, Index, IndexMut};

use arrayvec::ArrayVec;

/// Entries in a row: an array or a `Vec`.
pub trait Vector<T>: Clone + AsRef<[T]> + AsMut<[T]> + Index<usize, Output = T> + IndexMut<usize> {}

impl<T, V: Clone + AsRef<[T]> + AsMut<[T]> + Index<usize, Output = T> + IndexMut<usize>> Vector<T> for V {}

/// What vectors, matrices and lists hold: values that outlive a solve, so that their memory can be
/// kept for the next one, by another thread, too.
pub trait Element: Clone + Send + 'static {}

impl<T: Clone + Send + 'static> Element for T {}

/// A list with room for a limited number of entries.
pub trait List<T>: Deref<Target = [T]> + DerefMut {
    /// Appends an entry. If the list is full, it stays as it is, and the result is false.
    fn push(&mut self, entry: T) -> bool;
    /// Removes the last entry.
    fn pop(&mut self) -> Option<T>;
    /// Removes the entries that are not to be kept.
    fn keep(&mut self, is_kept: impl Fn(&T) -> bool);
}

/// The number of entries of a vector. Each type that implements it keeps them in its own way.
pub trait Size: Copy {
    /// Vectors of this size.
    type Vector<T: Element>: Vector<T> + Element;
    /// The rows of matrices with this many rows.
    type Rows<V: Element>: Vector<V>;
    /// Lists of at most this size.
    type List<T: Send + 'static>: List<T>;
    /// The number of entries in use.
    fn get(self) -> usize;
    /// A vector with the same entry everywhere.
    fn filled<T: Element + Copy>(self, entry: T) -> Self::Vector<T>;
    /// The same row this many times.
    fn rows<V: Element>(self, row: V) -> Self::Rows<V>;
    /// An empty list.
    fn list<T: Send + 'static>(self) -> Self::List<T>;
}

/// A matrix with `R` rows of `C` entries.
pub type Matrix<R, C, T> = <R as Size>::Rows<<C as Size>::Vector<T>>;

/// A square matrix.
pub type Square<Z, T> = Matrix<Z, Z, T>;

/// A matrix with the same entry everywhere.
#[inline]
pub fn filled_matrix<R: Size, C: Size, T: Element + Copy>(rows: R, columns: C, entry: T) -> Matrix<R, C, T> {
    rows.rows(columns.filled(entry))
}

/// N entries; the compiler knows N.
#[derive(Clone, Copy, Debug)]
pub struct Fixed<const N: usize>;

impl<const N: usize> Size for Fixed<N> {
    type Vector<T: Element> = [T; N];
    type Rows<V: Element> = [V; N];
    type List<T: Send + 'static> = ArrayVec<T, N>;
    #[inline]
    fn get(self) -> usize {
        N
    }
    #[inline]
    fn filled<T: Element + Copy>(self, entry: T) -> [T; N] {
        [entry; N]
    }
    #[inline]
    fn rows<V: Element>(self, row: V) -> [V; N] {
        core::array::from_fn(|_| row.clone())
    }
    #[inline]
    fn list<T: Send + 'static>(self) -> ArrayVec<T, N> {
        ArrayVec::new_const()
    }
}

/// The leading entries of an array of C. The other entries stay zero. Lists have room for C
/// entries.
///
/// This size serves the kernels of the second attempt: reduction, eigenvalues and eigenvectors.
/// Other kernels read all entries of a vector.
#[derive(Clone, Copy, Debug)]
pub struct AtMost<const C: usize>(
    /// The number of entries in use.
    pub usize,
);

impl<const C: usize> Size for AtMost<C> {
    type Vector<T: Element> = [T; C];
    type Rows<V: Element> = [V; C];
    type List<T: Send + 'static> = ArrayVec<T, C>;
    #[inline]
    fn get(self) -> usize {
        self.0.min(C)
    }
    #[inline]
    fn filled<T: Element + Copy>(self, entry: T) -> [T; C] {
        Fixed::<C>.filled(entry)
    }
    #[inline]
    fn rows<V: Element>(self, row: V) -> [V; C] {
        Fixed::<C>.rows(row)
    }
    #[inline]
    fn list<T: Send + 'static>(self) -> ArrayVec<T, C> {
        ArrayVec::new_const()
    }
}

impl<T, const N: usize> List<T> for ArrayVec<T, N> {
    #[inline]
    fn push(&mut self, entry: T) -> bool {
        self.try_push(entry).is_ok()
    }
    #[inline]
    fn pop(&mut self) -> Option<T> {
        ArrayVec::pop(self)
    }
    #[inline]
    fn keep(&mut self, is_kept: impl Fn(&T) -> bool) {
        self.retain(|entry| is_kept(entry));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// How many entries find room, and what the list then holds.
    fn room<Z: Size>(size: Z) -> (usize, usize) {
        let mut list = size.list();
        let pushed = (0..5).filter(|&entry| list.push(entry)).count();
        assert!(list.iter().copied().eq(0..pushed));
        (pushed, list.len())
    }

    #[test]
    fn lists_take_no_more_than_they_have_room_for() {
        assert_eq!([room(Fixed::<0>), room(Fixed::<3>)], [(0, 0), (3, 3)]);
        assert_eq!([room(AtMost::<3>(1)), room(AtMost::<3>(3))], [(3, 3); 2]);
        #[cfg(feature = "alloc")]
        assert_eq!([0, 1, 3].map(|most| room(crate::dynamic_size::Dynamic(most))), [(0, 0), (1, 1), (3, 3)]);
    }

    #[test]
    fn vectors_have_entries_in_use() {
        assert_eq!((Fixed::<3>.get(), Fixed::<3>.filled(7)), (3, [7; 3]));
        assert_eq!([0, 2, 3, 4].map(|count| AtMost::<3>(count).get()), [0, 2, 3, 3]);
        #[cfg(feature = "alloc")]
        for count in [0, 1, 3] {
            let size = crate::dynamic_size::Dynamic(count);
            assert_eq!((size.get(), size.filled(7)), (count, std::vec![7; count]));
        }
    }
}
