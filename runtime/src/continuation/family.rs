//! A problem as a family of systems over its data.

use crate::elimination::program::Program;
use crate::solution::system::{Product, Term};

/// What the data of a parameter satisfy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Condition {
    /// Nothing.
    Free,
    /// They are symmetric matrices of that order.
    Symmetric(u32),
    /// They are vectors of length 1 with that many entries.
    Unit(u32),
    /// They are 3x3 rotation matrices.
    Rotation,
    /// They are lines: a direction, and a moment at a right angle to it.
    Plucker,
    /// They are matrices of so many rows and columns, of less than full rank.
    Rank(u32, u32),
}

/// All that is needed to evaluate the equations for other data.
#[derive(Clone, Copy, Debug)]
pub struct Family<'a> {
    /// The data of the instance, one parameter after another.
    pub data: &'a [f64],
    /// The number of inputs of the program. Those after the data are for the template only.
    pub inputs: usize,
    /// What the data of each parameter satisfy, and how many there are.
    pub parameters: &'a [(Condition, u32)],
    /// From data to coefficients.
    pub program: Program<'a>,
    /// The numbers of values of the program and of coefficients.
    pub counts: (usize, usize),
    /// The number of unknowns.
    pub unknowns: usize,
    /// The tables of the equations: see [`Tables`](crate::solution::system::Tables).
    pub chain: &'a [Product],
    /// Where the terms of each equation end.
    pub ends: &'a [u32],
    /// The terms of all equations.
    pub terms: &'a [Term],
}
