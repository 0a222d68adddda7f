//! Options of a solve as a number.

use eliminant::{SecondAttempts, Workspace};

/// A workspace whose second attempts are at most so many operations: never with 0, and always, with
/// paths from data nearby, with the largest number.
#[must_use]
pub fn workspace(second_attempts: u64) -> Workspace {
    Workspace::new().with_second_attempts(match second_attempts {
        0 => SecondAttempts::Never,
        u64::MAX => SecondAttempts::Always,
        operations => SecondAttempts::AtMost(operations),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_of_the_range_are_never_and_always() {
        for (number, second_attempts) in [
            (0, SecondAttempts::Never),
            (1, SecondAttempts::AtMost(1)),
            (u64::MAX - 1, SecondAttempts::AtMost(u64::MAX - 1)),
            (u64::MAX, SecondAttempts::Always),
        ] {
            assert_eq!(workspace(number).second_attempts(), second_attempts);
        }
    }
}
