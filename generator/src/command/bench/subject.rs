//! The crate of a solver that is timed: its source, and a function that reads its instances.

/// A solver with its instances.
pub(super) struct Subject {
    /// The module of the solver.
    pub(super) name: String,
    /// Its source.
    pub(super) source: String,
    /// The shapes of the parameters.
    pub(super) parameters: Vec<Vec<usize>>,
    /// Number of instances.
    pub(super) count: usize,
    /// The data of all instances, one after another.
    pub(super) instances: Vec<f64>,
}

impl Subject {
    /// The library: the solver, and `subject`, which reads its instances from this file.
    pub(super) fn library(&self, instances: &str) -> String {
        let Self { name, source, parameters, count, .. } = self;
        let tuple = |entry: &dyn Fn(usize) -> String| (0..parameters.len()).map(entry).collect::<String>();
        // A problem without data has the empty tuple, `()`.
        let types = tuple(&|at| format!("{}, ", array_type(&parameters[at])));
        let values = tuple(&|at| format!("{}, ", array_value(&parameters[at])));
        let arguments = tuple(&|at| format!("{}data.{at}, ", if parameters[at].is_empty() { "" } else { "&" }));
        format!(
            "#![allow(unused)]
{source}

pub fn subject() -> Box<dyn ::timing::Subject> {{
    use {name} as solver;
    type Data = ({types});
    fn read(next: &mut dyn FnMut() -> f64) -> Data {{
        ({values})
    }}
    Box::new(::timing::Timed {{
        instances: ::timing::read_all({instances:?}, {count}, read),
        residual: |data: &Data| {{
            let point = solver::Solution::from([0.5; solver::UNKNOWNS.len()]);
            solver::relative_residual({arguments}&point).is_ok()
        }},
        matrix: |data: &Data| solver::action_matrix({arguments}).is_ok(),
        solve: |data: &Data| solver::solve({arguments}).map_or(0, |found| found.len()),
    }})
}}
"
        )
    }
}

fn array_type(shape: &[usize]) -> String {
    shape.iter().rev().fold("f64".to_owned(), |inner, length| format!("[{inner}; {length}]"))
}

fn array_value(shape: &[usize]) -> String {
    shape.iter().fold("next()".to_owned(), |inner, _| format!("std::array::from_fn(|_| {inner})"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parameters_are_read_by_their_shapes() {
        assert_eq!((array_type(&[]), array_value(&[])), ("f64".into(), "next()".into()));
        assert_eq!(array_type(&[4, 3]), "[[f64; 3]; 4]");
        assert_eq!(array_value(&[4, 3]), "std::array::from_fn(|_| std::array::from_fn(|_| next()))");
    }

    #[test]
    fn without_data_the_tuple_is_empty() {
        let subject = |parameters: &[Vec<usize>]| Subject {
            name: "s".into(),
            source: String::new(),
            parameters: parameters.to_vec(),
            count: 3,
            instances: Vec::new(),
        };
        assert!(subject(&[]).library("i").contains("type Data = ();"));
        let library = subject(&[vec![2], vec![]]).library("i");
        assert!(library.contains("type Data = ([f64; 2], f64, );") && library.contains("solve(&data.0, data.1, )"));
    }
}
