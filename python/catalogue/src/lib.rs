//! All solvers of the catalogue behind function pointers on flat data.
//!
//! A crate apart from what speaks to Python: its code is compiled beside that of the solvers, of
//! which it needs no more than their interface.

use eliminant::{Solutions, SolveError};
use eliminant_solvers as solvers;

use crate::flat::{Flat, len};

/// Arrays of any depth from flat values and back.
mod flat;

/// Errors of solves as numbers.
pub mod status;

/// A parameter of a solver, or a named array of a solution: name and shape.
pub type Named = (&'static str, &'static [usize]);

/// Data of one parameter for some instances: the scalars of an instance at a time, or those that
/// all instances share.
#[derive(Clone, Copy)]
pub struct Values<'a> {
    /// The scalars of the instances, one instance after another.
    pub scalars: &'a [f64],
    /// The number of scalars from an instance to the next: 0 if all share them.
    pub stride: usize,
}

impl Values<'_> {
    fn of<T: Flat>(&self, instance: usize) -> T {
        T::from_flat(&self.scalars[instance * self.stride..][..T::LEN])
    }

    /// The scalars of an instance, if an array holds no more than those of its instances.
    pub fn instance(&self, instance: usize) -> &[f64] {
        let rest = &self.scalars[instance * self.stride..];
        if self.stride == 0 { rest } else { &rest[..self.stride] }
    }

    /// Those from an instance on.
    pub fn from(self, instance: usize) -> Self {
        Self { scalars: &self.scalars[instance * self.stride..], ..self }
    }
}

/// Where the solutions of some instances are written, each list for one instance after another.
pub struct Found<'a> {
    /// The sizes of the lists.
    pub sizes: Sizes,
    /// The unknowns of each solution, NaN where there are fewer than the problem can have.
    pub unknowns: &'a mut [f64],
    /// The results of each solution, as the unknowns.
    pub results: &'a mut [f64],
    /// The number of solutions of each instance.
    pub counts: &'a mut [i64],
    /// The status of each instance.
    pub status: &'a mut [u16],
}

/// One solver of the catalogue.
pub struct Solver {
    /// Name of the problem.
    pub name: &'static str,
    /// The data.
    pub data: &'static [Named],
    /// The arrays of a solution, in the order of its unknowns.
    pub fields: &'static [Named],
    /// The arrays that the problem returns for a solution.
    pub results: &'static [Named],
    /// Which data are means over measurements.
    pub means: &'static [Mean],
    /// The number of unknowns of a solution, of scalars of its results, and of solutions.
    pub sizes: Sizes,
    /// The doc comment of the problem.
    pub docs: &'static str,
    /// The problem file and the template file.
    pub files: [&'static str; 2],
    /// Roughly the floating-point operations of a solve.
    pub operations: u64,
    /// Solves a list of instances by `solve_batch`. The lists of `Found` have their lengths.
    pub solve_batch: fn(&[Values<'_>], &mut Found<'_>),
    /// Solves one instance by `solve`.
    pub solve: fn(&[Values<'_>], &mut Found<'_>) -> Result<(), SolveError>,
}

/// Data of a problem that are means over measurements.
pub struct Mean {
    /// Its name: `mean_of_point`.
    pub name: &'static str,
    /// A measurement.
    pub data: &'static [Named],
    /// The shape of the mean.
    pub shape: &'static [usize],
    /// What a measurement gives.
    pub docs: &'static str,
    /// The mean over so many measurements, row by row.
    pub compute: fn(&[Values<'_>], usize) -> Vec<f64>,
}

/// The scalars of an array.
fn scalars<T: Flat>(array: &T) -> Vec<f64> {
    let mut scalars = vec![0.0; T::LEN];
    array.write(&mut scalars);
    scalars
}

/// The sizes of what is returned for an instance.
#[derive(Clone, Copy)]
pub struct Sizes {
    /// The unknowns of a solution.
    pub unknowns: usize,
    /// The scalars of the results that are wanted.
    pub results: usize,
    /// The solutions that an instance can have.
    pub solutions: usize,
    /// A bit for each array of the results that is wanted.
    pub wanted: u64,
}

impl Sizes {
    /// Of the arrays with these names, of a solver that returns them.
    pub fn of_results(self, results: &[Named], names: &[String]) -> Self {
        let is_wanted = |name: &str| names.iter().any(|wanted| wanted == name);
        let wanted = (0..).zip(results).filter(|(_, (name, _))| is_wanted(name));
        let (wanted, results) =
            wanted.fold((0, 0), |(bits, sum), (at, (_, shape))| (bits | 1 << at, sum + product(shape)));
        Self { wanted, results, ..self }
    }

    /// Whether the array of this number is wanted.
    fn is_wanted(self, array: u32) -> bool {
        self.wanted >> array & 1 == 1
    }
}

/// Solvers take arrays by reference and scalars by value.
macro_rules! argument {
    ($value:expr, array) => {
        &$value
    };
    ($value:expr, scalar) => {
        $value
    };
}

/// The entry of a solver. `table.rs` has one for each problem.
macro_rules! solver {
    ($name:ident {
        data: ($($data:ident: $kind:ident $shape:expr),*),
        fields: [$($field:expr),*],
        results: $results:ident $(($($result:ident: $result_shape:expr),*))?,
        means: $means:expr,
        docs: $docs:expr,
        source: $source:expr,
        template: $template:expr,
    }) => {
        Solver {
            name: stringify!($name),
            data: &[$((stringify!($data), &$shape)),*],
            fields: &[$($field),*],
            results: &[$($((stringify!($result), &$result_shape)),*)?],
            means: $means,
            sizes: Sizes {
                unknowns: solvers::$name::UNKNOWNS.len(),
                results: 0 $($(+ product(&$result_shape))*)?,
                solutions: solvers::$name::MAX_SOLUTIONS,
                wanted: u64::MAX,
            },
            docs: $docs,
            files: [include_str!($source), include_str!($template)],
            operations: solvers::$name::SECOND_ATTEMPT_OPERATIONS,
            solve_batch: |_values, found| {
                let data: Vec<solvers::$name::Data> = (0..found.counts.len())
                    .map(|_at| typed!(_values, _at, $name, ($($data),*)))
                    .collect();
                let mut solved = vec![Ok(Solutions::new()); data.len()];
                solvers::$name::solve_batch(&data, &mut solved);
                for (at, (_data, solved)) in data.iter().zip(&solved).enumerate() {
                    match solved {
                        Ok(solutions) => {
                            found.write(at, solutions.iter().map(|solution| solution.to_array()));
                            results!(found, at, solutions, _data, $name, $results,
                                ($($data: $kind),*), ($($($result),*)?));
                        }
                        Err(error) => found.fail(at, error),
                    }
                }
            },
            solve: |_values, found| {
                let _data = typed!(_values, 0, $name, ($($data),*));
                let solutions = solvers::$name::solve($(argument!(_data.$data, $kind)),*)?;
                found.write(0, solutions.iter().map(|solution| solution.to_array()));
                results!(found, 0, &solutions, _data, $name, $results,
                    ($($data: $kind),*), ($($($result),*)?));
                Ok(())
            },
        }
    };
}

/// The `Data` of a solver for one instance.
macro_rules! typed {
    ($values:ident, $at:expr, $name:ident, ($($data:ident),*)) => {{
        let mut _values = $values.iter();
        solvers::$name::Data { $($data: next(&mut _values, $at)),* }
    }};
}

/// Writes what is wanted of the results for each solution.
macro_rules! results {
    ($found:ident, $at:expr, $solutions:expr, $of:ident, $name:ident, none, $arguments:tt, $results:tt) => {};
    ($found:ident, $at:expr, $solutions:expr, $of:ident, $name:ident, $function:ident,
        ($($data:ident: $kind:ident),*), ($($result:ident),*)) => {
        if $found.sizes.wanted != 0 {
            match solvers::$name::$function($(argument!($of.$data, $kind),)* $solutions) {
                Ok(results) => {
                    for (number, result) in results.iter().enumerate() {
                        let (sizes, mut place, mut array) = ($found.sizes, $found.result($at, number), 0);
                        $(if sizes.is_wanted(array) {
                            let (values, rest) = place.split_at_mut(len(&result.$result));
                            result.$result.write(values);
                            place = rest;
                        }
                        array += 1;)*
                        let _ = (place, array);
                    }
                }
                // Data whose solutions are known have results, so this is not met.
                Err(error) => $found.fail($at, &error),
            }
        }
    };
}

/// All solvers, in the order of their names.
#[rustfmt::skip]
pub static SOLVERS: &[Solver] = include!(concat!(env!("OUT_DIR"), "/table.rs"));

/// The number of scalars of an array.
pub const fn product(shape: &[usize]) -> usize {
    let (mut product, mut at) = (1, 0);
    while at < shape.len() {
        product *= shape[at];
        at += 1;
    }
    product
}

/// The data of the next parameter for an instance.
fn next<T: Flat>(values: &mut std::slice::Iter<'_, Values<'_>>, instance: usize) -> T {
    match values.next() {
        Some(values) => values.of(instance),
        None => T::from_flat(&vec![f64::NAN; T::LEN]),
    }
}

impl<'a> Found<'a> {
    /// The lists of `piece` instances each, in order; of fewer in the last.
    pub fn pieces(self, piece: usize) -> Vec<Found<'a>> {
        let (mut rest, mut pieces) = (self, Vec::new());
        while rest.counts.len() > piece {
            let (first, others) = rest.split(piece);
            pieces.push(first);
            rest = others;
        }
        pieces.push(rest);
        pieces
    }

    /// Whether there are no instances.
    pub fn is_empty(&self) -> bool {
        self.counts.is_empty()
    }

    /// The lists of the first instances, and of the others.
    fn split(self, instances: usize) -> (Self, Self) {
        let Sizes { unknowns, results, solutions, .. } = self.sizes;
        let (unknowns, other_unknowns) = self.unknowns.split_at_mut(instances * solutions * unknowns);
        let (results, other_results) = self.results.split_at_mut(instances * solutions * results);
        let (counts, other_counts) = self.counts.split_at_mut(instances);
        let (status, other_status) = self.status.split_at_mut(instances);
        let others = Self {
            sizes: self.sizes,
            unknowns: other_unknowns,
            results: other_results,
            counts: other_counts,
            status: other_status,
        };
        (Self { sizes: self.sizes, unknowns, results, counts, status }, others)
    }

    /// Writes the solutions of an instance, whose results follow.
    pub fn write(&mut self, at: usize, solutions: impl Iterator<Item = impl AsRef<[f64]>>) {
        let all = of_instance(self.unknowns, at, self.sizes.unknowns * self.sizes.solutions);
        let mut count = 0;
        for (place, solution) in all.chunks_mut(self.sizes.unknowns).zip(solutions) {
            place.copy_from_slice(solution.as_ref());
            count += 1;
        }
        all[count * self.sizes.unknowns..].fill(f64::NAN);
        let results = of_instance(self.results, at, self.sizes.results * self.sizes.solutions);
        results[count * self.sizes.results..].fill(f64::NAN);
        self.counts[at] = count as i64;
        self.status[at] = status::SOLVED;
    }

    /// Notes why an instance has no solutions.
    pub fn fail(&mut self, at: usize, error: &SolveError) {
        self.write(at, std::iter::empty::<[f64; 0]>());
        self.status[at] = status::of(error);
    }

    /// The place of the results of a solution.
    pub fn result(&mut self, at: usize, number: usize) -> &mut [f64] {
        let length = self.sizes.results;
        &mut of_instance(self.results, at, length * self.sizes.solutions)[number * length..][..length]
    }
}

/// The part of a list that belongs to an instance.
fn of_instance(list: &mut [f64], at: usize, length: usize) -> &mut [f64] {
    &mut list[at * length..(at + 1) * length]
}
