//! The readers and solvers that are run.

/// Readers of scenes, segments and models.
mod cylinders;
/// The problem language.
mod problem;
/// Solvers on arbitrary numbers.
mod solvers;
/// Template files.
mod template;

use crate::target::Target;

/// All targets.
pub fn targets() -> Vec<Target> {
    [vec![problem::target(), template::target()], cylinders::targets(), solvers::targets()]
        .into_iter()
        .flatten()
        .collect()
}
