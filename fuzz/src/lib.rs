//! Fuzzing: readers and solvers get inputs that are mutated from a committed corpus.
//!
//! ```text
//! corpora/TARGET/* --> mutate --> target --> outcome: kinds of behaviour, or a fault
//!        ^                                     |
//!        '------- inputs of new kinds <--------'
//! ```
//!
//! No input may make a target panic or take longer than its bound, and what a solver returns must
//! be finite and solve the equations. There is no instrumentation: what an input is told by is what
//! a caller can see, such as the words of the error message and the sizes of what was read. The
//! same seed gives the same inputs.

/// One run of many mutated inputs.
pub mod campaign;
/// The committed inputs, and how new ones are chosen and shortened.
pub mod corpus;
/// Inputs to neighbouring inputs.
pub mod mutate;
/// What a target says of an input.
pub mod outcome;
/// What is run on inputs.
pub mod target;
/// The readers and solvers that are run.
pub mod targets;
