//! The crate of a solver that is timed: its source, and a function that reads its instances.

use crate::command::compiled::parameters::ParameterText;
use crate::problem::DataParameter;

/// A solver with its instances.
pub(super) struct Subject {
    /// The module of the solver.
    pub(super) name: String,
    /// Its source.
    pub(super) source: String,
    /// The parameters.
    pub(super) parameters: Vec<DataParameter>,
    /// |B| if roots are eigenvalues, `None` if they are those of a determinant: there is nothing to
    /// time then.
    pub(super) eigenvalues: Option<usize>,
    /// Number of instances.
    pub(super) count: usize,
    /// The data of all instances, one after another.
    pub(super) instances: Vec<f64>,
}

impl Subject {
    /// The library: the solver, and `subject`, which reads its instances from this file.
    pub(super) fn library(&self, instances: &str) -> String {
        let Self { name, source, parameters, eigenvalues, count, .. } = self;
        let ParameterText { types, values, arguments } = ParameterText::of(parameters);
        let eigenvalues = eigenvalues.map_or("|_| true".to_owned(), |n| {
            format!(
                "|data: &Data| solver::action_matrix({arguments}).is_ok_and(|matrix| {{
            <&[[f64; {n}]; {n}]>::try_from(&matrix[..])
                .is_ok_and(|matrix| Hessenberg::reduce(matrix).and_then(|form| form.eigenvalues()).is_ok())
        }})"
            )
        });
        format!(
            "#![allow(unused)]
{source}

pub fn subject() -> Box<dyn ::timing::Subject> {{
    use {name} as solver;
    use ::eliminant::{{SecondAttempts, Workspace, emitted::Hessenberg}};
    type Data = {types};
    fn read(next: &mut dyn FnMut() -> f64) -> Data {{
        {values}
    }}
    Box::new(::timing::Timed {{
        instances: ::timing::read_all({instances:?}, {count}, read),
        residual: |data: &Data| {{
            let point = solver::Solution::from([0.5; solver::UNKNOWNS.len()]);
            solver::relative_residual({arguments}&point).is_ok()
        }},
        matrix: |data: &Data| solver::action_matrix({arguments}).is_ok(),
        eigenvalues: {eigenvalues},
        attempt: |data: &Data| {{
            let mut workspace = Workspace::new().with_second_attempts(SecondAttempts::Never);
            solver::solve_in(&mut workspace, {arguments}).is_ok()
        }},
        solve: |data: &Data| solver::solve({arguments}).map_or(0, |found| found.len()),
    }})
}}
"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_data_the_tuple_is_empty() {
        let subject = |parameters: &[DataParameter]| Subject {
            name: "s".into(),
            source: String::new(),
            parameters: parameters.to_vec(),
            eigenvalues: Some(4),
            count: 3,
            instances: Vec::new(),
        };
        let library = subject(&[]).library("i");
        assert!(library.contains("type Data = ();") && library.contains("try_from(&matrix[..])"));
        let parameters = [DataParameter::example("a", &[2], false), DataParameter::example("b", &[], false)];
        let library = subject(&parameters).library("i");
        assert!(library.contains("type Data = ([f64; 2], f64, );") && library.contains("solve(&data.0, data.1, )"));
    }
}
