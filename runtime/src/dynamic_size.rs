//! Sizes that are known at run time only, with the feature `alloc`.

extern crate alloc;

use crate::size::{Element, List, Size};
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
    type Vector<T: Element> = Vec<T>;
    type Rows<V: Element> = Vec<V>;
    type List<T: Send + 'static> = BoundedVec<T>;
    fn get(self) -> usize {
        self.0
    }
    fn filled<T: Element + Copy>(self, entry: T) -> Vec<T> {
        vec![entry; self.0]
    }
    fn rows<V: Element>(self, row: V) -> Vec<V> {
        vec![row; self.0]
    }
    fn list<T: Send + 'static>(self) -> BoundedVec<T> {
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

    fn keep(&mut self, is_kept: impl Fn(&T) -> bool) {
        self.entries.retain(is_kept);
    }
}
