//! What `solve_in` takes besides the data: memory that is kept from one solve to the next, and how
//! much work a solve may be.

use crate::memory::Memory;

/// Whether a solve that misses solutions is repeated at twice the precision.
///
/// A second attempt finds solutions that rounding errors of the first one lost, and takes some
/// twenty times as long. `SECOND_ATTEMPT_OPERATIONS` in the module of a solver is its work.
///
/// Some data are singular for a template though not for their problem, and no precision helps:
/// special motions of cameras, say. Solutions are then followed along paths of data that begin
/// nearby, which takes some hundred times as long as a solve, and needs the feature `alloc`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum SecondAttempts {
    /// Wherever solutions are missing, as `solve` does. Only so are solutions followed from data
    /// nearby.
    #[default]
    Always,
    /// Never: a solve takes one attempt, and misses the solutions that only a second one finds. An
    /// elimination that fails is an error.
    Never,
    /// If a second attempt is at most this many operations at twice the precision. The number is
    /// predicted from the sizes of the solver, so that the same data give the same solutions.
    AtMost(u64),
}

impl SecondAttempts {
    /// Whether a second attempt of this many operations may be made.
    #[doc(hidden)]
    #[inline]
    #[must_use]
    pub fn allows(self, operations: u64) -> bool {
        match self {
            SecondAttempts::Always => true,
            SecondAttempts::Never => false,
            SecondAttempts::AtMost(most) => operations <= most,
        }
    }
}

/// Memory for solves, and their options. One workspace serves any number of solves, of any solvers,
/// one after another; a program with several threads has one for each.
///
/// Large solvers keep their matrices in it, on the heap (feature `alloc`): a solve allocates what
/// no solve before needed. Small ones work on the stack, and take nothing from it but the options.
/// What a solve returns does not depend on solves before.
///
/// ```
/// use eliminant::{SecondAttempts, Workspace};
/// let mut workspace = Workspace::new().with_second_attempts(SecondAttempts::Never);
/// // for data in .. { let solutions = relpose_6pt_generalized::solve_in(&mut workspace, data)?; }
/// # assert_eq!(workspace.second_attempts(), SecondAttempts::Never);
/// ```
#[derive(Debug, Default)]
pub struct Workspace {
    memory: Memory,
    second_attempts: SecondAttempts,
}

impl Workspace {
    /// No memory yet, and all that `solve` does.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The same workspace with a bound on second attempts.
    #[must_use]
    pub fn with_second_attempts(mut self, second_attempts: SecondAttempts) -> Self {
        self.second_attempts = second_attempts;
        self
    }

    /// When second attempts are made.
    #[must_use]
    pub fn second_attempts(&self) -> SecondAttempts {
        self.second_attempts
    }

    /// The memory of large solvers.
    #[doc(hidden)]
    #[must_use]
    pub fn memory(&self) -> &Memory {
        &self.memory
    }
}
