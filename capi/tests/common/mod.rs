//! The C functions and the Rust functions of all problems that are enabled, behind one signature.

// Some problems have no numbers among their data, and a library may have no problems.
#![allow(dead_code, unreachable_pub)]

use eliminant_capi_runtime::{Code, Numbers};

/// A list of data as a caller passes it.
#[derive(Clone, Copy, Debug)]
pub struct Buffer {
    /// Where it is.
    pub pointer: *const f64,
    /// How long the caller says that it is.
    pub length: usize,
}

impl Buffer {
    /// The number that a parameter without a shape gets.
    pub fn number(self) -> f64 {
        match self.pointer.is_null() || self.length == 0 {
            true => f64::NAN,
            // It is of a list of the test, though perhaps not aligned.
            false => unsafe { self.pointer.read_unaligned() },
        }
    }
}

/// Room for results as a caller passes it.
#[derive(Clone, Copy, Debug)]
pub struct Room {
    /// Where solutions go.
    pub solutions: *mut f64,
    /// The capacity, or the length of the room for a batch.
    pub length: usize,
    /// Where counts go.
    pub counts: *mut usize,
    /// Where codes go.
    pub codes: *mut i32,
}

/// The functions of a problem that return one kind of rows.
pub struct Case {
    /// The problem, and what its rows are.
    pub name: &'static str,
    /// The length of each list of data, and whether it is a number.
    pub data: &'static [(usize, bool)],
    /// The length of a row.
    pub row: usize,
    /// The most solutions.
    pub most: usize,
    /// The C function for one instance.
    pub solve: fn(&[Buffer], Room) -> i32,
    /// The C function for many.
    pub solve_batch: fn(usize, &[Buffer], Room) -> i32,
    /// The Rust function: its rows, one after another.
    pub in_rust: fn(&[Buffer]) -> Result<Vec<f64>, Code>,
}

/// Data of the right length.
fn take<T: Numbers>(buffer: Buffer) -> T {
    let mut at = 0;
    T::take(&mut || {
        at += 1;
        // Tests pass lists of the right length.
        unsafe { buffer.pointer.add(at - 1).read() }
    })
}

/// All of them.
pub fn cases() -> Vec<Case> {
    include!(concat!(env!("OUT_DIR"), "/cases.rs"))
}
