//! The number of entries of vectors, and where they are kept. One kernel serves constant and
//! run-time sizes.
//!
//! | size | vector of `T` | who uses it |
//! |---|---|---|
//! | [`Fixed<N>`] | `[T; N]` | emitted solvers: loops have bounds that the compiler knows |
//! | [`AtMost<C>`] | `[T; C]`, partly in use | spectra at twice the precision: one copy, many sizes |
//! | `Dynamic` (feature `alloc`) | `Vec<T>` | interpreted plans, with sizes known at run time |
//!
//! A kernel does the same operations in the same order for all three sizes, so the results have the
//! same bits.

use core::ops::{Deref, DerefMut, Index, IndexMut};

use arrayvec::ArrayVec;

/// Entries in a row: an array or a `Vec`.
pub trait Vector<T>: Clone + AsRef<[T]> + AsMut<[T]> + Index<usize, Output = T> + IndexMut<usize> {}

impl<T, V: Clone + AsRef<[T]> + AsMut<[T]> + Index<usize, Output = T> + IndexMut<usize>> Vector<T> for V {}

/// A list with room for a limited number of entries.
pub trait List<T>: Deref<Target = [T]> + DerefMut {
    /// Appends an entry. If the list is full, it stays as it is, and the result is false.
    fn push(&mut self, entry: T) -> bool;
}

/// The number of entries of a vector. Each type that implements it keeps them in its own way.
pub trait Size: Copy {
    /// Vectors of this size.
    type Vector<T: Clone>: Vector<T>;
    /// Lists of at most this size.
    type List<T>: List<T>;
    /// The number of entries in use.
    fn get(self) -> usize;
    /// A vector with the same entry everywhere.
    fn filled<T: Clone>(self, entry: T) -> Self::Vector<T>;
    /// An empty list.
    fn list<T>(self) -> Self::List<T>;
}

/// A matrix with `R` rows of `C` entries.
pub type Matrix<R, C, T> = <R as Size>::Vector<<C as Size>::Vector<T>>;

/// A square matrix.
pub type Square<Z, T> = Matrix<Z, Z, T>;

/// A matrix with the same entry everywhere.
#[inline]
pub fn filled_matrix<R: Size, C: Size, T: Clone>(rows: R, columns: C, entry: T) -> Matrix<R, C, T> {
    rows.filled(columns.filled(entry))
}

/// N entries; the compiler knows N.
#[derive(Clone, Copy, Debug)]
pub struct Fixed<const N: usize>;

impl<const N: usize> Size for Fixed<N> {
    type Vector<T: Clone> = [T; N];
    type List<T> = ArrayVec<T, N>;
    #[inline]
    fn get(self) -> usize {
        N
    }
    #[inline]
    fn filled<T: Clone>(self, entry: T) -> [T; N] {
        core::array::from_fn(|_| entry.clone())
    }
    #[inline]
    fn list<T>(self) -> ArrayVec<T, N> {
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
    type Vector<T: Clone> = [T; C];
    type List<T> = ArrayVec<T, C>;
    #[inline]
    fn get(self) -> usize {
        self.0.min(C)
    }
    #[inline]
    fn filled<T: Clone>(self, entry: T) -> [T; C] {
        Fixed::<C>.filled(entry)
    }
    #[inline]
    fn list<T>(self) -> ArrayVec<T, C> {
        ArrayVec::new_const()
    }
}

impl<T, const N: usize> List<T> for ArrayVec<T, N> {
    #[inline]
    fn push(&mut self, entry: T) -> bool {
        self.try_push(entry).is_ok()
    }
}

#[cfg(feature = "alloc")]
pub use dynamic::{BoundedVec, Dynamic};

#[cfg(feature = "alloc")]
mod dynamic {
    use super::{List, Size};
    use alloc::vec;
    use alloc::vec::Vec;
    use core::ops::{Deref, DerefMut};

    /// A number of entries that is known at run time.
    #[derive(Clone, Copy, Debug)]
    pub struct Dynamic(
        /// The number of entries.
        pub usize,
    );

    impl Size for Dynamic {
        type Vector<T: Clone> = Vec<T>;
        type List<T> = BoundedVec<T>;
        fn get(self) -> usize {
            self.0
        }
        fn filled<T: Clone>(self, entry: T) -> Vec<T> {
            vec![entry; self.0]
        }
        fn list<T>(self) -> BoundedVec<T> {
            BoundedVec { entries: Vec::new(), most: self.0 }
        }
    }

    /// A `Vec` that holds a limited number of entries.
    #[derive(Clone, Debug)]
    pub struct BoundedVec<T> {
        entries: Vec<T>,
        most: usize,
    }

    impl<T> Deref for BoundedVec<T> {
        type Target = [T];
        fn deref(&self) -> &[T] {
            &self.entries
        }
    }

    impl<T> DerefMut for BoundedVec<T> {
        fn deref_mut(&mut self) -> &mut [T] {
            &mut self.entries
        }
    }

    impl<T> List<T> for BoundedVec<T> {
        fn push(&mut self, entry: T) -> bool {
            let has_room = self.entries.len() < self.most;
            if has_room {
                self.entries.push(entry);
            }
            has_room
        }
    }
}
