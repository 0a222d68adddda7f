//! Errors of solves as numbers: the kind in the lower byte, the block that lost rank in the upper.

use eliminant::SolveError;

/// There was no error.
pub const SOLVED: u16 = 0;

/// The kinds of errors, as Python names them.
pub const KINDS: [(&str, u16); 8] = [
    ("SOLVED", SOLVED),
    ("NON_FINITE_INPUT", 1),
    ("DEGENERATE", 2),
    ("LOST_RANK", 3),
    ("OVERFLOW", 4),
    ("TOO_LARGE", 5),
    ("NO_CONVERGENCE", 6),
    ("OTHER", OTHER),
];

/// An error that this package does not know.
const OTHER: u16 = 7;

/// The number of an error.
pub fn of(error: &SolveError) -> u16 {
    match error {
        SolveError::NonFiniteInput => 1,
        SolveError::Degenerate { block } => 2 + 256 * (*block).min(255) as u16,
        SolveError::LostRank => 3,
        SolveError::Overflow => 4,
        SolveError::TooLarge => 5,
        SolveError::NoConvergence => 6,
        _ => OTHER,
    }
}

/// The text of an error; empty where there is none.
pub fn text(status: u16) -> String {
    let error = match status % 256 {
        SOLVED => return String::new(),
        1 => SolveError::NonFiniteInput,
        2 => SolveError::Degenerate { block: usize::from(status / 256) },
        3 => SolveError::LostRank,
        4 => SolveError::Overflow,
        5 => SolveError::TooLarge,
        6 => SolveError::NoConvergence,
        _ => return "the solver failed".to_owned(),
    };
    error.to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stand_for_errors() {
        let errors = [
            SolveError::NonFiniteInput,
            SolveError::Degenerate { block: 3 },
            SolveError::LostRank,
            SolveError::Overflow,
            SolveError::TooLarge,
            SolveError::NoConvergence,
        ];
        for error in errors {
            assert_eq!(text(of(&error)), error.to_string());
        }
        assert_eq!(text(SOLVED), "");
    }
}
