//! A part of the strategies of a search, so that several machines can share them.

use std::fmt;
use std::str::FromStr;

/// Every `of`-th strategy, beginning with the one at `index`. Strategies of one kind stand side by
/// side, so that each shard gets some of every kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    index: usize,
    of: usize,
}

/// The text names no shard.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("expected `i/n` with 1 <= i <= n, such as `2/4`")]
pub struct ShardError;

impl Shard {
    /// The whole search.
    pub const ALL: Self = Self { index: 0, of: 1 };

    /// Shard `number` of `of`, counted from 1.
    pub fn new(number: usize, of: usize) -> Result<Self, ShardError> {
        let index = number.checked_sub(1).filter(|&index| index < of).ok_or(ShardError)?;
        Ok(Self { index, of })
    }

    /// The number of the shard, counted from 1.
    pub fn number(&self) -> usize {
        self.index + 1
    }

    /// The number of shards.
    pub fn of(&self) -> usize {
        self.of
    }

    /// Whether the strategy at a position, counted from 0, is in the shard.
    pub fn holds(&self, position: usize) -> bool {
        position % self.of == self.index
    }
}

impl FromStr for Shard {
    type Err = ShardError;

    fn from_str(text: &str) -> Result<Self, ShardError> {
        let (number, of) = text.split_once('/').ok_or(ShardError)?;
        Self::new(number.parse().map_err(|_| ShardError)?, of.parse().map_err(|_| ShardError)?)
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.number(), self.of)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_item_is_in_one_shard() {
        for of in 1..7 {
            let shards: Vec<Shard> = (1..=of).map(|number| Shard::new(number, of).unwrap()).collect();
            assert!((0..20).all(|item| shards.iter().filter(|shard| shard.holds(item)).count() == 1));
            assert!(shards.iter().all(|shard| shard.to_string().parse() == Ok(*shard)));
        }
        for bad in ["", "1", "0/4", "5/4", "1/0", "-1/4", "1/4/4", "a/b", "99999999999999999999/4"] {
            assert_eq!(bad.parse::<Shard>(), Err(ShardError), "{bad}");
        }
    }
}
