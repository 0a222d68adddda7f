//! The list of solutions that a solver returns.

use arrayvec::ArrayVec;
use core::ops::{Deref, DerefMut};

/// Up to `MAX` solutions, stored in place; `MAX` is the number of complex solutions of the problem, so it suffices.
///
/// Reads like a slice (`len`, `iter`, indexing, ..) and iterates by value or by reference.
#[derive(Clone, Debug, PartialEq)]
pub struct Solutions<T, const MAX: usize>(ArrayVec<T, MAX>);

impl<T, const MAX: usize> Solutions<T, MAX> {
    /// No solutions.
    #[inline]
    #[must_use]
    pub fn new() -> Self {
        Solutions(ArrayVec::new_const())
    }

    /// Appends a solution; false, and nothing happens, when there are `MAX` already.
    #[inline]
    pub fn push(&mut self, solution: T) -> bool {
        self.0.try_push(solution).is_ok()
    }

    /// The images of all solutions, in their order.
    #[inline]
    #[must_use]
    pub fn map<U>(&self, f: impl Fn(T) -> U) -> Solutions<U, MAX>
    where
        T: Copy,
    {
        let mut images = Solutions::new();
        for &solution in self {
            images.push(f(solution));
        }
        images
    }
}

impl<T, const MAX: usize> Default for Solutions<T, MAX> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T, const MAX: usize> Deref for Solutions<T, MAX> {
    type Target = [T];
    #[inline]
    fn deref(&self) -> &[T] {
        &self.0
    }
}

impl<T, const MAX: usize> DerefMut for Solutions<T, MAX> {
    #[inline]
    fn deref_mut(&mut self) -> &mut [T] {
        &mut self.0
    }
}

impl<T, const MAX: usize> IntoIterator for Solutions<T, MAX> {
    type Item = T;
    type IntoIter = arrayvec::IntoIter<T, MAX>;
    #[inline]
    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl<'a, T, const MAX: usize> IntoIterator for &'a Solutions<T, MAX> {
    type Item = &'a T;
    type IntoIter = core::slice::Iter<'a, T>;
    #[inline]
    fn into_iter(self) -> Self::IntoIter {
        self.0.iter()
    }
}

/// Keeps the first `MAX` items.
impl<T, const MAX: usize> FromIterator<T> for Solutions<T, MAX> {
    fn from_iter<I: IntoIterator<Item = T>>(items: I) -> Self {
        Solutions(items.into_iter().take(MAX).collect())
    }
}
