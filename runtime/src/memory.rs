//! Memory of large solvers on the heap, kept from one solve to the next. Only with the feature
//! `alloc`; without it, no memory is on the heap.

#[cfg(feature = "alloc")]
pub use on_heap::{HeapList, HeapMatrix, HeapRows, Memory, OnHeap, Precise};

/// Memory on the heap: there is none without the feature `alloc`.
#[cfg(not(feature = "alloc"))]
#[derive(Debug, Default)]
pub struct Memory(());

#[cfg(feature = "alloc")]
mod on_heap {
    extern crate alloc;

    use alloc::boxed::Box;
    use alloc::vec::Vec;
    use core::any::Any;
    use core::cell::RefCell;
    use core::fmt;
    use core::ops::{Deref, DerefMut, Index, IndexMut};

    use crate::number::double_double::DoubleDouble;
    use crate::size::{Element, List, Size};

    /// Memory that matrices and lists on the heap come from and return to. A solve that takes as
    /// much as one before allocates nothing.
    ///
    /// Memory is kept apart by the type of its entries: rows of N numbers serve rows of N numbers.
    #[derive(Default)]
    pub struct Memory {
        /// A [`Shelf`] for each type of entries.
        shelves: RefCell<Vec<Box<dyn Any + Send>>>,
    }

    /// Lists without entries, whose memory is free.
    struct Shelf<T>(Vec<Vec<T>>);

    impl Memory {
        /// No memory yet.
        #[must_use]
        pub const fn new() -> Self {
            Memory { shelves: RefCell::new(Vec::new()) }
        }

        /// `count` times the same entry.
        #[must_use]
        pub fn filled<V: Element>(&self, count: usize, entry: V) -> HeapRows<'_, V> {
            let mut rows = self.take();
            rows.resize(count, entry);
            HeapRows { rows, memory: self }
        }

        /// One entry, such as an array, as the only row. A function of its own: the array is on
        /// the stack no longer than it takes to make it.
        ///
        /// # Errors
        /// That of `make`.
        #[inline(never)]
        pub fn kept<V: Element, E>(&self, make: impl FnOnce() -> Result<V, E>) -> Result<HeapRows<'_, V>, E> {
            Ok(self.filled(1, make()?))
        }

        /// The list that was given back last, or one without memory.
        fn take<T: Send + 'static>(&self) -> Vec<T> {
            // No call is made while the memory is borrowed, so it never is borrowed already.
            let Ok(mut shelves) = self.shelves.try_borrow_mut() else { return Vec::new() };
            let shelf = shelves.iter_mut().find_map(|shelf| shelf.downcast_mut::<Shelf<T>>());
            shelf.and_then(|shelf| shelf.0.pop()).unwrap_or_default()
        }

        fn give_back<T: Send + 'static>(&self, mut entries: Vec<T>) {
            entries.clear();
            let Ok(mut shelves) = self.shelves.try_borrow_mut() else { return };
            match shelves.iter_mut().find_map(|shelf| shelf.downcast_mut::<Shelf<T>>()) {
                Some(shelf) => shelf.0.push(entries),
                None => shelves.push(Box::new(Shelf(Vec::from([entries])))),
            }
        }
    }

    impl fmt::Debug for Memory {
        fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
            formatter.debug_struct("Memory").finish_non_exhaustive()
        }
    }

    /// The rows of a matrix, or entries of any other kind. Their memory returns to where it came
    /// from.
    #[derive(Debug)]
    pub struct HeapRows<'w, V: Element> {
        rows: Vec<V>,
        memory: &'w Memory,
    }

    /// A matrix with rows of N numbers, as a caller keeps it.
    pub type HeapMatrix<const N: usize> = Vec<[f64; N]>;

    /// Coefficients at twice the precision, computed when they are first needed.
    pub type Precise<'w> = core::cell::OnceCell<HeapRows<'w, DoubleDouble>>;

    impl<V: Element> HeapRows<'_, V> {
        /// The rows, whose memory does not return.
        #[must_use]
        pub fn into_vec(mut self) -> Vec<V> {
            core::mem::take(&mut self.rows)
        }
    }

    impl<V: Element> Drop for HeapRows<'_, V> {
        fn drop(&mut self) {
            self.memory.give_back(core::mem::take(&mut self.rows));
        }
    }

    impl<V: Element> Clone for HeapRows<'_, V> {
        fn clone(&self) -> Self {
            let mut rows = self.memory.take();
            rows.extend_from_slice(&self.rows);
            HeapRows { rows, memory: self.memory }
        }
    }

    impl<V: Element> AsRef<[V]> for HeapRows<'_, V> {
        #[inline]
        fn as_ref(&self) -> &[V] {
            &self.rows
        }
    }

    impl<V: Element> AsMut<[V]> for HeapRows<'_, V> {
        #[inline]
        fn as_mut(&mut self) -> &mut [V] {
            &mut self.rows
        }
    }

    impl<V: Element> Index<usize> for HeapRows<'_, V> {
        type Output = V;
        #[inline]
        fn index(&self, at: usize) -> &V {
            &self.rows[at]
        }
    }

    impl<V: Element> IndexMut<usize> for HeapRows<'_, V> {
        #[inline]
        fn index_mut(&mut self, at: usize) -> &mut V {
            &mut self.rows[at]
        }
    }

    /// A list on the heap. Its memory returns to where it came from.
    #[derive(Debug)]
    pub struct HeapList<'w, T: Send + 'static> {
        entries: Vec<T>,
        most: usize,
        memory: &'w Memory,
    }

    impl<T: Send + 'static> Drop for HeapList<'_, T> {
        fn drop(&mut self) {
            self.memory.give_back(core::mem::take(&mut self.entries));
        }
    }

    impl<T: Send + 'static> Deref for HeapList<'_, T> {
        type Target = [T];
        #[inline]
        fn deref(&self) -> &[T] {
            &self.entries
        }
    }

    impl<T: Send + 'static> DerefMut for HeapList<'_, T> {
        #[inline]
        fn deref_mut(&mut self) -> &mut [T] {
            &mut self.entries
        }
    }

    impl<T: Send + 'static> List<T> for HeapList<'_, T> {
        fn push(&mut self, entry: T) -> bool {
            let has_room = self.entries.len() < self.most;
            if has_room {
                self.entries.push(entry);
            }
            has_room
        }

        fn pop(&mut self) -> Option<T> {
            self.entries.pop()
        }

        fn keep(&mut self, is_kept: impl Fn(&T) -> bool) {
            self.entries.retain(is_kept);
        }
    }

    /// The same size. Rows of matrices and lists are on the heap; each row and each vector is what
    /// it is for the size `Z`.
    #[derive(Clone, Copy, Debug)]
    pub struct OnHeap<'w, Z> {
        /// The number of entries.
        pub size: Z,
        /// Where the memory comes from.
        pub memory: &'w Memory,
    }

    impl<'w, Z: Size> Size for OnHeap<'w, Z> {
        type Vector<T: Element> = Z::Vector<T>;
        type Rows<V: Element> = HeapRows<'w, V>;
        type List<T: Send + 'static> = HeapList<'w, T>;
        #[inline]
        fn get(self) -> usize {
            self.size.get()
        }
        #[inline]
        fn filled<T: Element + Copy>(self, entry: T) -> Z::Vector<T> {
            self.size.filled(entry)
        }
        #[inline]
        fn rows<V: Element>(self, row: V) -> HeapRows<'w, V> {
            self.memory.filled(self.get(), row)
        }
        #[inline]
        fn list<T: Send + 'static>(self) -> HeapList<'w, T> {
            HeapList { entries: self.memory.take(), most: self.get(), memory: self.memory }
        }
    }

    #[cfg(test)]
    mod tests {
        use super::*;
        use crate::size::{AtMost, Fixed};

        #[test]
        fn memory_returns_and_serves_again() {
            let memory = Memory::new();
            let size = OnHeap { size: Fixed::<3>, memory: &memory };
            let first = size.rows([1.0; 2]);
            let place = first.as_ref().as_ptr();
            let copy = first.clone();
            assert_ne!(place, copy.as_ref().as_ptr());
            drop(first);
            // Entries of another type do not take it.
            let other = size.rows([1.0; 4]);
            let again = size.rows([2.0; 2]);
            assert_eq!((again.as_ref(), again.as_ref().as_ptr()), (&[[2.0; 2]; 3][..], place));
            assert_eq!((copy.as_ref(), other.as_ref()), (&[[1.0; 2]; 3][..], &[[1.0; 4]; 3][..]));
        }

        #[test]
        fn lists_are_empty_again_and_hold_no_more_than_they_may() {
            let memory = Memory::new();
            for _ in 0..2 {
                let mut list = OnHeap { size: AtMost::<9>(2), memory: &memory }.list();
                assert!(list.is_empty() && list.push(1) && list.push(2) && !list.push(3));
                assert_eq!((list.pop(), &list[..]), (Some(2), &[1][..]));
            }
        }

        #[test]
        fn memory_moves_to_other_threads() {
            fn can_move<T: Send>(_: &T) {}
            can_move(&Memory::new());
        }
    }
}
