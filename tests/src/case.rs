//! The emitted solvers behind function pointers on flat data, with the problems and plans they came
//! from.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use eliminant::{Complex, SolveError, Workspace};
use eliminant_generator::generate::{Planned, plan};
use eliminant_generator::problem::Problem;
use eliminant_generator::template::file::TemplateFile;
use eliminant_solvers as solvers;
use rayon::prelude::*;

/// Solutions as lists of unknowns.
pub type Found<T> = Result<Vec<Vec<T>>, SolveError>;

/// The relative residual of a complex solution for given data.
pub type Residual = fn(&[f64], &[Complex<f64>]) -> Result<f64, SolveError>;

/// A solution in all that tests ask of it.
#[derive(Clone, Debug)]
pub struct Returned<T> {
    /// The unknowns.
    pub unknowns: Vec<T>,
    /// The same with all elements of vectors up to scale.
    pub elements: Vec<T>,
    /// `relative_residual` of the solution itself, infinity where that is an error: coordinates of
    /// vectors up to scale do not keep the digits of small elements.
    pub residual: f64,
}

/// Solutions, from one solve.
pub type ReturnedBy<T> = Result<Vec<Returned<T>>, SolveError>;

/// One emitted solver. Data are flat, parameters one after another, arrays row by row. Solutions
/// are the unknowns that are solved for: of a vector that is given up to scale, its coordinates.
#[derive(Clone, Copy)]
pub struct Case {
    /// Name of the problem.
    pub name: &'static str,
    /// `solve`.
    pub solve: fn(&[f64]) -> Found<f64>,
    /// `solve_complex`.
    pub solve_complex: fn(&[f64]) -> Found<Complex<f64>>,
    /// `solve_in`.
    pub solve_in: fn(&mut Workspace, &[f64]) -> Found<f64>,
    /// `solve_complex_in`.
    pub solve_complex_in: fn(&mut Workspace, &[f64]) -> Found<Complex<f64>>,
    /// `SECOND_ATTEMPT_OPERATIONS`.
    pub second_attempt_operations: u64,
    /// `action_matrix`.
    pub action_matrix: fn(&[f64]) -> Found<f64>,
    /// `relative_residual` of a complex solution.
    pub residual: Residual,
    /// `solve`, with elements and residuals.
    pub returned: fn(&[f64]) -> ReturnedBy<f64>,
    /// `solve_complex`, with elements and residuals.
    pub returned_complex: fn(&[f64]) -> ReturnedBy<Complex<f64>>,
    /// The time that `solve` takes for all of these data, one after the other, and the number of
    /// real solutions that it returns. Data are not flat while the time is taken.
    pub time: fn(&[Vec<f64>]) -> (Duration, usize),
    /// `solve_batch`.
    pub solve_batch: fn(&[Vec<f64>]) -> Vec<Found<f64>>,
    /// The time that `solve_batch` takes for all of these data, on one core or, in pieces of
    /// [`PIECE`] instances, on all.
    pub time_batch: fn(&[Vec<f64>], Cores) -> Duration,
}

/// Where a batch is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cores {
    /// On the core of the caller.
    One,
    /// On all of them.
    All,
}

/// The number of instances that a core takes at once.
pub const PIECE: usize = 256;

/// Arrays of any depth from their flat values.
trait FromFlat {
    fn take(values: &mut impl Iterator<Item = f64>) -> Self;
}

impl FromFlat for f64 {
    fn take(values: &mut impl Iterator<Item = f64>) -> Self {
        values.next().unwrap_or(f64::NAN)
    }
}

impl<T: FromFlat, const N: usize> FromFlat for [T; N] {
    fn take(values: &mut impl Iterator<Item = f64>) -> Self {
        std::array::from_fn(|_| T::take(values))
    }
}

/// Solvers take arrays by reference and scalars by value.
macro_rules! argument {
    ($data:ident: array) => {
        &$data
    };
    ($data:ident: scalar) => {
        $data
    };
}

/// The same where arrays and scalars are behind references.
macro_rules! referenced {
    ($data:ident: array) => {
        $data
    };
    ($data:ident: scalar) => {
        *$data
    };
}

/// The `Data` of a solver from flat lists.
macro_rules! typed {
    ($instances:ident, $name:ident, ($($data:ident),*)) => {
        $instances
            .iter()
            .map(|flat| {
                let mut _values = flat.iter().copied();
                $(let $data = FromFlat::take(&mut _values);)*
                solvers::$name::Data { $($data),* }
            })
            .collect::<Vec<_>>()
    };
}

/// All of the solutions that a function returns.
macro_rules! returned {
    ($name:ident, $solve:ident, ($($data:ident: $kind:ident),*)) => {
        |flat| {
            let mut _values = flat.iter().copied();
            $(let $data = FromFlat::take(&mut _values);)*
            let found = solvers::$name::$solve($(argument!($data: $kind)),*)?;
            let returned = found.iter().map(|x| Returned {
                unknowns: x.to_unknowns().to_vec(),
                elements: x.to_array().to_vec(),
                residual: solvers::$name::relative_residual($(argument!($data: $kind),)* x).unwrap_or(f64::INFINITY),
            });
            Ok(returned.collect())
        }
    };
}

/// `case!(name, (points: array, length: scalar))`; `()` for a problem without data.
macro_rules! case {
    ($name:ident, ($($data:ident: $kind:ident),*)) => {
        Case {
            name: stringify!($name),
            solve: |flat| {
                let mut _values = flat.iter().copied();
                $(let $data = FromFlat::take(&mut _values);)*
                let found = solvers::$name::solve($(argument!($data: $kind)),*)?;
                Ok(found.iter().map(|s| s.to_unknowns().to_vec()).collect())
            },
            solve_complex: |flat| {
                let mut _values = flat.iter().copied();
                $(let $data = FromFlat::take(&mut _values);)*
                let found = solvers::$name::solve_complex($(argument!($data: $kind)),*)?;
                Ok(found.iter().map(|s| s.to_unknowns().to_vec()).collect())
            },
            solve_in: |workspace, flat| {
                let mut _values = flat.iter().copied();
                $(let $data = FromFlat::take(&mut _values);)*
                let found = solvers::$name::solve_in(workspace, $(argument!($data: $kind)),*)?;
                Ok(found.iter().map(|s| s.to_unknowns().to_vec()).collect())
            },
            solve_complex_in: |workspace, flat| {
                let mut _values = flat.iter().copied();
                $(let $data = FromFlat::take(&mut _values);)*
                let found = solvers::$name::solve_complex_in(workspace, $(argument!($data: $kind)),*)?;
                Ok(found.iter().map(|s| s.to_unknowns().to_vec()).collect())
            },
            returned: returned!($name, solve, ($($data: $kind),*)),
            returned_complex: returned!($name, solve_complex, ($($data: $kind),*)),
            second_attempt_operations: solvers::$name::SECOND_ATTEMPT_OPERATIONS,
            action_matrix: |flat| {
                let mut _values = flat.iter().copied();
                $(let $data = FromFlat::take(&mut _values);)*
                let action = solvers::$name::action_matrix($(argument!($data: $kind)),*)?;
                Ok(action.iter().map(|row| row.to_vec()).collect())
            },
            residual: |flat, point| {
                let mut _values = flat.iter().copied();
                $(let $data = FromFlat::take(&mut _values);)*
                let unknowns = std::array::from_fn(|k| point.get(k).copied().unwrap_or_default());
                let solution = solvers::$name::Solution::from_unknowns(unknowns);
                solvers::$name::relative_residual($(argument!($data: $kind),)* &solution)
            },
            time: |instances| {
                let typed = typed!(instances, $name, ($($data),*));
                let start = Instant::now();
                let found = typed.iter().map(|solvers::$name::Data { $($data),* }| {
                    solvers::$name::solve($(referenced!($data: $kind)),*).map_or(0, |found| found.len())
                });
                let count = found.sum();
                (start.elapsed(), count)
            },
            solve_batch: |instances| {
                let typed = typed!(instances, $name, ($($data),*));
                let mut results = vec![Ok(eliminant::Solutions::new()); typed.len()];
                solvers::$name::solve_batch(&typed, &mut results);
                let lists = |found: &eliminant::Solutions<solvers::$name::Solution, _>| {
                    found.iter().map(|s| s.to_unknowns().to_vec()).collect()
                };
                results.iter().map(|found| found.as_ref().map(lists).map_err(|&error| error)).collect()
            },
            time_batch: |instances, cores| {
                let typed = typed!(instances, $name, ($($data),*));
                let mut results = vec![Ok(eliminant::Solutions::new()); typed.len()];
                let start = Instant::now();
                match cores {
                    Cores::One => solvers::$name::solve_batch(&typed, &mut results),
                    Cores::All => typed
                        .par_chunks(PIECE)
                        .zip(results.par_chunks_mut(PIECE))
                        .for_each(|(data, results)| solvers::$name::solve_batch(data, results)),
                }
                start.elapsed()
            },
        }
    };
}

/// All emitted solvers, in the order of their names: one for each problem of `templates/`.
pub fn cases() -> Vec<Case> {
    include!(concat!(env!("OUT_DIR"), "/cases.rs"))
}

/// The folder with problems and templates.
pub fn templates_folder() -> PathBuf {
    PathBuf::from(eliminant_templates::FOLDER)
}

impl Case {
    /// The problem.
    ///
    /// # Panics
    /// Where the committed file cannot be read: this is for tests.
    pub fn problem(&self) -> Problem {
        let path = templates_folder().join(format!("{}.rs", self.name));
        let text = std::fs::read_to_string(&path).expect("the problem file is committed");
        Problem::parse(&path.display().to_string(), &text).unwrap_or_else(|messages| panic!("{}", messages.render()))
    }

    /// The template file.
    ///
    /// # Panics
    /// As [`Case::problem`].
    pub fn template(&self) -> TemplateFile {
        let path = templates_folder().join(format!("{}.template.toml", self.name));
        let text = std::fs::read_to_string(&path).expect("the template file is committed");
        TemplateFile::parse(&text, &self.problem().unknowns).unwrap_or_else(|error| panic!("{error}"))
    }

    /// The plan that the solver was emitted from.
    ///
    /// # Panics
    /// As [`Case::problem`].
    pub fn planned(&self) -> Planned {
        plan(&self.problem(), &self.template()).unwrap_or_else(|error| panic!("{error}"))
    }
}
