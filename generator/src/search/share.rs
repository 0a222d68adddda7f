//! A part of the work of a search, so that several machines can do it.

use std::fmt;
use std::str::FromStr;

/// Every `of`-th item of the work, beginning with the item at `index`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Share {
    index: usize,
    of: usize,
}

/// Text that names no share.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("expected `i/n` with 1 <= i <= n, such as `2/4`")]
pub struct ShareError;

impl Share {
    /// All of it.
    pub const ALL: Self = Self { index: 0, of: 1 };

    /// Part `number` of `of`, counted from 1.
    pub fn new(number: usize, of: usize) -> Result<Self, ShareError> {
        let index = number.checked_sub(1).filter(|&index| index < of).ok_or(ShareError)?;
        Ok(Self { index, of })
    }

    /// Which part it is, counted from 1.
    pub fn number(&self) -> usize {
        self.index + 1
    }

    /// How many parts there are.
    pub fn of(&self) -> usize {
        self.of
    }

    /// Whether the item at a position, counted from 0, is in it.
    pub fn holds(&self, position: usize) -> bool {
        position % self.of == self.index
    }
}

impl FromStr for Share {
    type Err = ShareError;

    fn from_str(text: &str) -> Result<Self, ShareError> {
        let (number, of) = text.split_once('/').ok_or(ShareError)?;
        Self::new(number.parse().map_err(|_| ShareError)?, of.parse().map_err(|_| ShareError)?)
    }
}

impl fmt::Display for Share {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.number(), self.of)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_item_is_in_one_share() {
        for of in 1..7 {
            let shares: Vec<Share> = (1..=of).map(|number| Share::new(number, of).unwrap()).collect();
            assert!((0..20).all(|item| shares.iter().filter(|share| share.holds(item)).count() == 1));
            assert!(shares.iter().all(|share| share.to_string().parse() == Ok(*share)));
        }
        for bad in ["", "1", "0/4", "5/4", "1/0", "-1/4", "1/4/4", "a/b", "99999999999999999999/4"] {
            assert_eq!(bad.parse::<Share>(), Err(ShareError), "{bad}");
        }
    }
}
