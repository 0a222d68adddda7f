//! The list of solutions that a solver returns.

use arrayvec::ArrayVec;
use core::iter::FusedIterator;
use core::ops::{Deref, DerefMut};

/// Up to `MAX` solutions, stored in place. `MAX` is the number of complex solutions of general
/// data, so there is room for all.
///
/// The list reads like a slice (`len`, `iter`, indexing, ..) and iterates by value or by reference.
/// With the feature `serde` it is serialised as a sequence.
#[derive(Clone, Debug, PartialEq)]
pub struct Solutions<T, const MAX: usize>(ArrayVec<T, MAX>);

impl<T, const MAX: usize> Solutions<T, MAX> {
    /// An empty list.
    #[inline]
    #[must_use]
    pub fn new() -> Self {
        Solutions(ArrayVec::new_const())
    }

    /// Appends a solution. If there are `MAX` already, the list stays as it is, and the result is
    /// false.
    #[inline]
    pub fn push(&mut self, solution: T) -> bool {
        self.0.try_push(solution).is_ok()
    }

    /// The images of all solutions, in the order of the solutions.
    #[inline]
    #[must_use]
    pub fn map<U>(&self, f: impl Fn(T) -> U) -> Solutions<U, MAX>
    where
        T: Copy,
    {
        Solutions::from_points(&self.0, f)
    }

    /// The images of the solutions that have an image, in the order of the solutions.
    #[inline]
    #[must_use]
    pub fn filter_map<U>(&self, f: impl Fn(T) -> Option<U>) -> Solutions<U, MAX>
    where
        T: Copy,
    {
        let mut images = ArrayVec::new_const();
        for image in self.0.iter().filter_map(|&solution| f(solution)) {
            // There is as much room as there are solutions.
            let _ = images.try_push(image);
        }
        Solutions(images)
    }

    /// The images of the points that the kernels found, in the order of the points.
    #[doc(hidden)]
    #[inline]
    #[must_use]
    pub fn from_points<P: Copy>(points: &ArrayVec<P, MAX>, f: impl Fn(P) -> T) -> Self {
        let mut images = ArrayVec::new_const();
        for &point in points {
            // There is as much room as there are points.
            let _ = images.try_push(f(point));
        }
        Solutions(images)
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

/// The solutions by value, in their order: see [`Solutions::into_iter`].
#[derive(Clone, Debug)]
pub struct IntoIter<T, const MAX: usize>(arrayvec::IntoIter<T, MAX>);

impl<T, const MAX: usize> Iterator for IntoIter<T, MAX> {
    type Item = T;
    #[inline]
    fn next(&mut self) -> Option<T> {
        self.0.next()
    }
    #[inline]
    fn size_hint(&self) -> (usize, Option<usize>) {
        self.0.size_hint()
    }
}

impl<T, const MAX: usize> DoubleEndedIterator for IntoIter<T, MAX> {
    #[inline]
    fn next_back(&mut self) -> Option<T> {
        self.0.next_back()
    }
}

impl<T, const MAX: usize> ExactSizeIterator for IntoIter<T, MAX> {}
impl<T, const MAX: usize> FusedIterator for IntoIter<T, MAX> {}

impl<T, const MAX: usize> IntoIterator for Solutions<T, MAX> {
    type Item = T;
    type IntoIter = IntoIter<T, MAX>;
    #[inline]
    fn into_iter(self) -> Self::IntoIter {
        IntoIter(self.0.into_iter())
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

/// The list is serialised as a sequence.
#[cfg(feature = "serde")]
impl<T: serde::Serialize, const MAX: usize> serde::Serialize for Solutions<T, MAX> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.iter())
    }
}

/// A sequence of at most `MAX` solutions is read; a longer one is an error.
#[cfg(feature = "serde")]
impl<'de, T: serde::Deserialize<'de>, const MAX: usize> serde::Deserialize<'de> for Solutions<T, MAX> {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Visitor<T, const MAX: usize>(core::marker::PhantomData<T>);
        impl<'de, T: serde::Deserialize<'de>, const MAX: usize> serde::de::Visitor<'de> for Visitor<T, MAX> {
            type Value = Solutions<T, MAX>;
            fn expecting(&self, formatter: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                write!(formatter, "at most {MAX} solutions")
            }
            fn visit_seq<A: serde::de::SeqAccess<'de>>(self, mut sequence: A) -> Result<Self::Value, A::Error> {
                let mut solutions = Solutions::new();
                while let Some(solution) = sequence.next_element()? {
                    if !solutions.push(solution) {
                        return Err(serde::de::Error::invalid_length(MAX + 1, &self));
                    }
                }
                Ok(solutions)
            }
        }
        deserializer.deserialize_seq(Visitor::<T, MAX>(core::marker::PhantomData))
    }
}
