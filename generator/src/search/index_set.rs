//! Sets of small indices.

/// A set of indices below a fixed bound, one bit each. Sets with the same bound can be sorted: the
/// order is that of their words.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct IndexSet {
    words: Vec<u64>,
}

impl IndexSet {
    /// The empty set of indices below `bound`.
    pub(super) fn new(bound: usize) -> Self {
        Self { words: vec![0; bound.div_ceil(64)] }
    }

    /// Adds an index. Returns whether it is new.
    pub(super) fn insert(&mut self, index: usize) -> bool {
        let bit = 1 << (index % 64);
        let is_new = self.words[index / 64] & bit == 0;
        self.words[index / 64] |= bit;
        is_new
    }

    pub(super) fn contains(&self, index: usize) -> bool {
        self.words[index / 64] & 1 << (index % 64) != 0
    }

    /// Adds all of a set with the same bound.
    pub(super) fn extend(&mut self, other: &Self) {
        self.words.iter_mut().zip(&other.words).for_each(|(a, b)| *a |= b);
    }

    pub(super) fn len(&self) -> usize {
        self.words.iter().map(|word| word.count_ones() as usize).sum()
    }

    /// The indices, increasing.
    pub(super) fn iter(&self) -> impl Iterator<Item = usize> + '_ {
        self.words.iter().enumerate().flat_map(|(at, &word)| {
            std::iter::successors(Some(word), |rest| Some(rest & rest.wrapping_sub(1)))
                .take_while(|rest| *rest != 0)
                .map(move |rest| 64 * at + rest.trailing_zeros() as usize)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_what_was_put_in() {
        let indices = [0, 3, 63, 64, 129];
        let mut set = IndexSet::new(130);
        assert!(indices.iter().rev().all(|&index| set.insert(index)) && !set.insert(64));
        assert!(set.iter().eq(indices));
        assert_eq!(set.len(), 5);
        let mut other = IndexSet::new(130);
        other.insert(1);
        other.extend(&set);
        assert!(other.iter().eq([0, 1, 3, 63, 64, 129]));
    }
}
