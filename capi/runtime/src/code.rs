//! The codes that C functions return.

use std::ffi::CStr;

use eliminant::SolveError;

/// What a C function returns. The numbers do not change from version to version.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum Code {
    /// All went well.
    Ok = 0,
    /// A pointer is null, and numbers had to be read or written there.
    NullPointer = 1,
    /// A pointer is not a multiple of the alignment of what it points to.
    MisalignedPointer = 2,
    /// A list of data has another length than its documentation says.
    WrongLength = 3,
    /// There are more solutions than there is room for.
    ShortBuffer = 4,
    /// [`SolveError::NonFiniteInput`].
    NonFiniteInput = 5,
    /// [`SolveError::Degenerate`].
    Degenerate = 6,
    /// [`SolveError::LostRank`].
    LostRank = 7,
    /// [`SolveError::Overflow`].
    Overflow = 8,
    /// [`SolveError::TooLarge`].
    TooLarge = 9,
    /// [`SolveError::NoConvergence`].
    NoConvergence = 10,
    /// The solver panicked. Solvers do not: it is an error of the library.
    Panic = 11,
    /// An error that this version does not know.
    Other = 12,
}

impl Code {
    /// All codes, in the order of their numbers.
    pub const ALL: [Code; 13] = [
        Code::Ok,
        Code::NullPointer,
        Code::MisalignedPointer,
        Code::WrongLength,
        Code::ShortBuffer,
        Code::NonFiniteInput,
        Code::Degenerate,
        Code::LostRank,
        Code::Overflow,
        Code::TooLarge,
        Code::NoConvergence,
        Code::Panic,
        Code::Other,
    ];

    /// The number that crosses the border.
    #[must_use]
    pub const fn number(self) -> i32 {
        self as i32
    }

    /// A sentence for people.
    #[must_use]
    pub const fn text(self) -> &'static CStr {
        match self {
            Code::Ok => c"no error",
            Code::NullPointer => c"a pointer is null",
            Code::MisalignedPointer => c"a pointer is not aligned to what it points to",
            Code::WrongLength => c"a list of data has another length than is documented",
            Code::ShortBuffer => c"there are more solutions than there is room for",
            Code::NonFiniteInput => c"the data hold an infinite value or a NaN",
            Code::Degenerate => c"degenerate data: the elimination lost rank",
            Code::LostRank => c"degenerate data: a matrix from which data are derived has lost rank",
            Code::Overflow => c"a number computed from the data is not finite: a division by zero or an overflow",
            Code::TooLarge => c"the problem needs larger arrays than are set aside",
            Code::NoConvergence => c"the eigenvalue iteration reached its limit",
            Code::Panic => c"the solver panicked, which is an error of the library",
            Code::Other => c"an error that this version does not know",
        }
    }
}

impl From<SolveError> for Code {
    fn from(error: SolveError) -> Self {
        match error {
            SolveError::NonFiniteInput => Code::NonFiniteInput,
            SolveError::Degenerate { .. } => Code::Degenerate,
            SolveError::LostRank => Code::LostRank,
            SolveError::Overflow => Code::Overflow,
            SolveError::TooLarge => Code::TooLarge,
            SolveError::NoConvergence => Code::NoConvergence,
            _ => Code::Other,
        }
    }
}

/// The text of a number that a C function returned; one that says so for any other number.
#[must_use]
pub fn error_text(number: i32) -> &'static CStr {
    Code::ALL.into_iter().find(|code| code.number() == number).map_or(c"this is no code of the library", Code::text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_places_and_texts_differ() {
        for (at, code) in Code::ALL.into_iter().enumerate() {
            assert_eq!(usize::try_from(code.number()), Ok(at));
            assert_eq!(error_text(code.number()), code.text());
            assert!(Code::ALL[..at].iter().all(|other| other.text() != code.text()), "{code:?}");
        }
        for other in [-1, Code::ALL.len() as i32, i32::MIN, i32::MAX] {
            assert_eq!(error_text(other), c"this is no code of the library");
        }
    }
}
