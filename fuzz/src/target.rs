//! What is run on inputs.

use std::time::Duration;

use crate::mutate::Kind;
use crate::outcome::Outcome;

/// What is run on inputs.
pub struct Target {
    /// Its name.
    pub name: &'static str,
    /// What it runs.
    pub what: &'static str,
    /// What its inputs are made of.
    pub kind: Kind,
    /// Most bytes of a mutated input.
    pub longest: usize,
    /// No input may take longer, compiled with optimisation.
    pub bound: Duration,
    /// Runs one input.
    pub run: fn(&[u8]) -> Outcome,
}
