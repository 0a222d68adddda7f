//! Sizes that are known at run time only: the one file of the runtime that allocates, with the
//! feature `alloc`.

extern crate alloc;

use crate::size::{List, Size};
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

    fn pop(&mut self) -> Option<T> {
        self.entries.pop()
    }
}
