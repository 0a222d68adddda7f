//! What a solver finds on random instances, judged by true solutions in numbers of 237 bits.

use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

use eliminant::Complex;
use eliminant_generator::algebra::Random;
use eliminant_generator::oracle::Truths;
use eliminant_generator::plan::Plan;
use eliminant_generator::problem::scene::{DrawnScene, Scene};
use eliminant_generator::search::measuring::interpreted::InterpretedSolver;
use eliminant_generator::search::measuring::results::has_known;
use eliminant_generator::search::measuring::{random_instance, seed_of};
use eliminant_python_catalogue::status;
use numpy::PyArray1;
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::progress::Tally;
use crate::threads::interruptible;

/// The figures of each instance, in the order of [`COUNTS`], those of [`ERRORS`], and the status.
pub(crate) type Figures<'py> =
    (Vec<Bound<'py, PyArray1<i64>>>, Vec<Bound<'py, PyArray1<f64>>>, Bound<'py, PyArray1<u16>>);

/// The names of the counts: what there is, was missed and does not belong there, of real and of
/// complex solutions; attempts of `solve_complex`; whether all true solutions are known; whether
/// what a scene says of its solution was not found.
pub(crate) const COUNTS: [&str; 9] = [
    "real",
    "real_missed",
    "real_spurious",
    "complex",
    "complex_missed",
    "complex_spurious",
    "attempts",
    "is_certain",
    "known_missed",
];

/// The names of the errors: the largest relative residual, and the largest relative distance from
/// a true solution.
pub(crate) const ERRORS: [&str; 2] = ["residual", "forward_error"];

/// What a solver did on one instance.
#[derive(Clone, Default)]
struct Outcome {
    counts: [i64; COUNTS.len()],
    errors: [f64; ERRORS.len()],
    status: u16,
}

/// Random instances, or scenes. Instance k depends on the seed and on k only.
pub(crate) struct RandomInstances<'a> {
    pub(crate) numbers: Range<usize>,
    pub(crate) seed: u64,
    /// The scene of the problem, if scenes are wanted.
    pub(crate) scene: Option<&'a Scene>,
}

impl RandomInstances<'_> {
    /// Instance k; `None` if its scene cannot be drawn.
    fn draw(&self, plan: &Plan, k: usize) -> Option<DrawnScene> {
        match self.scene {
            Some(scene) => scene.draw(&mut Random::new(seed_of(self.seed, k))),
            None => Some(DrawnScene { data: random_instance(plan, self.seed, k), solution: None, results: None }),
        }
    }
}

/// Solves instances and judges what is found.
pub(crate) fn figures<'py>(
    py: Python<'py>,
    plan: &Plan,
    solver: &InterpretedSolver,
    instances: &RandomInstances<'_>,
    tally: &Tally,
) -> PyResult<Figures<'py>> {
    let work = |is_over: &AtomicBool| -> Vec<Outcome> {
        let outcome = |k: usize| match is_over.load(Ordering::Relaxed) {
            true => Outcome::default(),
            false => {
                let drawn = instances.draw(plan, k);
                let outcome = drawn.map_or_else(Outcome::unsolved, |instance| Outcome::of(plan, solver, &instance));
                tally.add(1);
                outcome
            }
        };
        instances.numbers.clone().into_par_iter().map(outcome).collect()
    };
    let outcomes = interruptible(py, work, |py| tally.tell(py))?;
    tally.tell(py)?;
    let counts = (0..COUNTS.len()).map(|at| outcomes.iter().map(|outcome| outcome.counts[at]).collect());
    let errors = (0..ERRORS.len()).map(|at| outcomes.iter().map(|outcome| outcome.errors[at]).collect());
    Ok((
        counts.map(|list| PyArray1::from_vec(py, list)).collect(),
        errors.map(|list| PyArray1::from_vec(py, list)).collect(),
        PyArray1::from_vec(py, outcomes.iter().map(|outcome| outcome.status).collect()),
    ))
}

impl Outcome {
    /// Of data that no scene gives, or that a coefficient divides by zero with: there are no
    /// solutions to judge by.
    fn unsolved() -> Self {
        Self { errors: [f64::NAN; ERRORS.len()], ..Self::default() }
    }

    fn of(plan: &Plan, solver: &InterpretedSolver, instance: &DrawnScene) -> Self {
        let data = &instance.data;
        let real = solver.solve(data);
        let is_known_missed = !has_known(plan, real.as_deref().unwrap_or_default(), instance);
        let (complex, attempts) = match solver.instance(data) {
            Ok(mut instance) => (instance.solve_complex(), instance.attempts()),
            Err(error) => (Err(error), 0),
        };
        let error = real.as_ref().err().or(complex.as_ref().err());
        let status = error.map_or(status::SOLVED, status::of);
        let real: Vec<Vec<Complex<f64>>> =
            real.unwrap_or_default().into_iter().map(|point| point.into_iter().map(Complex::from).collect()).collect();
        let complex = complex.unwrap_or_default();
        let near: Vec<Vec<Complex<f64>>> = complex.iter().chain(&real).cloned().collect();
        let Some(truths) = Truths::of(plan, data, &near) else { return Self { status, ..Self::unsolved() } };
        let (of_real, of_complex) = (truths.judge(&real, true), truths.judge(&complex, false));
        let largest = |lists: [&[f64]; 2]| lists.concat().into_iter().reduce(f64::max).unwrap_or(f64::NAN);
        let missed = |expected: usize, found: usize| expected.saturating_sub(found);
        let counts = [
            truths.real(),
            missed(truths.real(), of_real.found),
            of_real.spurious,
            truths.complex(),
            missed(truths.complex(), of_complex.found),
            of_complex.spurious,
            attempts,
            usize::from(truths.is_complete()),
            usize::from(is_known_missed),
        ];
        Self {
            counts: counts.map(|count| count as i64),
            errors: [
                largest([&of_real.residuals, &of_complex.residuals]),
                largest([&of_real.errors, &of_complex.errors]),
            ],
            status,
        }
    }
}
