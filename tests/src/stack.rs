//! How much stack a solve takes: solves in threads with little of it, on data with and without a
//! second attempt.

use std::io;
use std::panic::resume_unwind;
use std::thread::Builder;

use eliminant::Workspace;
use eliminant_generator::algebra::Random;
use eliminant_generator::expression::arithmetic::Float64;
use eliminant_generator::problem::draw::draw_inputs;
use eliminant_generator::search::measuring::interpreted::InterpretedSolver;

use crate::Case;

/// The stack of a thread in which all solvers work: 256 KiB for a solve, and 16 KiB for the thread
/// itself and for what the caller does there.
pub const SUFFICIENT_STACK: usize = (256 + 16) * 1024;

/// Instances that are drawn to find some with a second attempt: random ones, special ones, and some
/// near special ones.
const DRAWS: u64 = 400;
/// The operations of all attempts to find some.
const WORK_OF_DRAWS: u64 = 600_000_000;

/// A function of a solver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Call {
    /// `solve`
    Real,
    /// `solve_complex`
    Complex,
    /// `solve_in`
    RealIn,
    /// `solve_complex_in`
    ComplexIn,
}

/// All functions that solve.
pub const CALLS: [Call; 4] = [Call::Real, Call::Complex, Call::RealIn, Call::ComplexIn];

/// Data of a solver on which its functions are called.
#[derive(Clone, Debug)]
pub struct Instances {
    /// Random data.
    pub random: Vec<f64>,
    /// Data on which `solve` makes a second attempt, if some were found.
    pub real_twice: Option<Vec<f64>>,
    /// Data on which `solve_complex` makes a second attempt, if some were found.
    pub complex_twice: Option<Vec<f64>>,
}

impl Instances {
    /// The instances of a solver, the same every time.
    pub fn of(case: &Case) -> Self {
        let plan = case.planned().plan;
        let solver = InterpretedSolver::of(&plan);
        let draw = |k: u64| {
            let mut random = Random::new(11_000_000 + k);
            let mut data = draw_inputs(&plan.data, Float64, &mut random);
            if k.is_multiple_of(3) {
                return data;
            }
            // Special data have zeros and equal values, and others nearly so.
            let near = if k % 3 == 1 { 0.0 } else { 1e-8 };
            for at in 0..data.len() {
                match random.below(8) {
                    0 => data[at] *= near,
                    1 => data[at] = data[random.below(at as u64 + 1) as usize] + near * data[at],
                    _ => {}
                }
            }
            data
        };
        let mut instances = Self { random: draw(0), real_twice: None, complex_twice: None };
        let mut work = WORK_OF_DRAWS;
        for k in 1..DRAWS {
            let data = draw(k);
            let (Ok(mut real), Ok(mut complex)) = (solver.instance(&data), solver.instance(&data)) else { continue };
            if instances.complex_twice.is_none() {
                let _ = complex.solve_complex();
                if complex.attempts() > 1 {
                    instances.complex_twice = Some(data.clone());
                }
            }
            let _ = real.solve();
            // An attempt by a determinant is followed by one by eigenvalues, before one at twice
            // the precision.
            let usual = if plan.chains.is_some() { 2 } else { 1 };
            if instances.real_twice.is_none() && real.attempts() > usual {
                instances.real_twice = Some(data);
            }
            let spent = plan.operations().total() as u64 * if complex.attempts() > 1 { 20 } else { 2 };
            work = work.saturating_sub(spent);
            if instances.real_twice.is_some() && instances.complex_twice.is_some() || work == 0 {
                break;
            }
        }
        instances
    }

    /// The data for a function, those with a second attempt last.
    pub fn for_call(&self, call: Call) -> impl Iterator<Item = &Vec<f64>> {
        let twice = match call {
            Call::Real | Call::RealIn => &self.real_twice,
            Call::Complex | Call::ComplexIn => &self.complex_twice,
        };
        std::iter::once(&self.random).chain(twice)
    }

    /// Calls a function on all of its data, in a thread with that many bytes of stack. A thread
    /// that needs more ends the process. Returns the number of solutions.
    ///
    /// # Errors
    /// The thread cannot be started.
    pub fn run(&self, case: Case, call: Call, stack: usize) -> io::Result<usize> {
        let data: Vec<Vec<f64>> = self.for_call(call).cloned().collect();
        let thread = Builder::new().stack_size(stack).spawn(move || {
            let mut workspace = Workspace::new();
            let solutions = data.iter().map(|data| match call {
                Call::Real => (case.solve)(data).map_or(0, |found| found.len()),
                Call::Complex => (case.solve_complex)(data).map_or(0, |found| found.len()),
                Call::RealIn => (case.solve_in)(&mut workspace, data).map_or(0, |found| found.len()),
                Call::ComplexIn => (case.solve_complex_in)(&mut workspace, data).map_or(0, |found| found.len()),
            });
            solutions.sum()
        })?;
        thread.join().map_or_else(|panic| resume_unwind(panic), Ok)
    }
}
