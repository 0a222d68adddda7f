//! The C functions and the Rust functions of all problems that are enabled, behind one signature.

// Some problems have no numbers among their data, and a library may have no problems.
#![allow(dead_code, unreachable_pub)]

pub mod faults;

use eliminant::SecondAttempts;
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
    /// The C function for one instance, with the number that bounds second attempts.
    pub solve_with: fn(u64, &[Buffer], Room) -> i32,
    /// The C function for many.
    pub solve_batch: fn(usize, &[Buffer], Room) -> i32,
    /// The Rust function: its rows, one after another.
    pub in_rust: fn(&[Buffer]) -> Result<Vec<f64>, Code>,
    /// The same with a bound on second attempts.
    pub in_rust_with: fn(SecondAttempts, &[Buffer]) -> Result<Vec<f64>, Code>,
    /// The operations of a second attempt, of C and of Rust.
    pub operations: (u64, u64),
    /// What measures a row; nothing if it is no solution.
    pub measures: Vec<Measure>,
}

/// The functions that measure a solution in one way.
pub struct Measure {
    /// The C function: data, a solution, and where the number goes.
    pub in_c: fn(&[Buffer], Buffer, *mut f64) -> i32,
    /// The Rust function.
    pub in_rust: fn(&[Buffer], Buffer) -> Result<f64, Code>,
}

/// The functions that compute a mean.
pub struct MeanCase {
    /// The C function without its prefix.
    pub name: &'static str,
    /// How many numbers of each list a measurement has.
    pub data: &'static [usize],
    /// How many numbers the mean has.
    pub mean: usize,
    /// The C function: measurements, their lists, and room for the mean.
    pub in_c: fn(usize, &[Buffer], Buffer) -> i32,
    /// The Rust function.
    pub in_rust: fn(usize, &[Buffer]) -> Vec<f64>,
}

/// The numbers of rows, one after another.
fn numbers_of<T>(rows: &[T], put: impl Fn(&T, &mut dyn FnMut(f64))) -> Vec<f64> {
    let mut numbers = Vec::new();
    rows.iter().for_each(|row| put(row, &mut |number| numbers.push(number)));
    numbers
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

/// The data of measurement `at` in a list of so many or more.
fn take_at<T: Numbers>(list: Buffer, at: usize) -> T {
    take(Buffer { pointer: list.pointer.wrapping_add(at * T::LENGTH), length: T::LENGTH })
}

/// All means.
pub fn mean_cases() -> Vec<MeanCase> {
    include!(concat!(env!("OUT_DIR"), "/mean_cases.rs"))
}

/// All solvers.
pub fn cases() -> Vec<Case> {
    include!(concat!(env!("OUT_DIR"), "/cases.rs"))
}
