//! Data of a solver in the source of a program that reads them as a stream of numbers.

use crate::problem::DataParameter;

/// The parameters of a solver as source text.
pub(in crate::command) struct ParameterText {
    /// The tuple of their types; `()` without data.
    pub(in crate::command) types: String,
    /// The tuple of their values, read by calls of `next()`.
    pub(in crate::command) values: String,
    /// The arguments of a call, from the tuple `data`, each with a comma behind it.
    pub(in crate::command) arguments: String,
}

impl ParameterText {
    /// Of these parameters.
    pub(in crate::command) fn of(parameters: &[DataParameter]) -> Self {
        let list = |entry: &dyn Fn(usize) -> String| (0..parameters.len()).map(entry).collect::<String>();
        Self {
            types: format!("({})", list(&|at| format!("{}, ", type_of(&parameters[at])))),
            values: format!("({})", list(&|at| format!("{}, ", value_of(&parameters[at])))),
            arguments: list(&|at| format!("{}data.{at}, ", if parameters[at].is_number() { "" } else { "&" })),
        }
    }
}

/// The type and the value of a number, and the dimensions of the array that holds them.
fn number(parameter: &DataParameter) -> (&'static str, &'static str, &[usize]) {
    match &parameter.shape[..] {
        [dimensions @ .., _] if parameter.is_complex => {
            ("::eliminant::Complex<f64>", "::eliminant::Complex::new(next(), next())", dimensions)
        }
        dimensions => ("f64", "next()", dimensions),
    }
}

fn type_of(parameter: &DataParameter) -> String {
    let (number, _, dimensions) = number(parameter);
    dimensions.iter().rev().fold(number.to_owned(), |inner, length| format!("[{inner}; {length}]"))
}

fn value_of(parameter: &DataParameter) -> String {
    let (_, number, dimensions) = number(parameter);
    dimensions.iter().fold(number.to_owned(), |inner, _| format!("std::array::from_fn(|_| {inner})"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parameters_are_read_by_their_shapes() {
        let parameter = |shape: &[usize], is_complex| DataParameter::example("a", shape, is_complex);
        let [number, matrix] = [parameter(&[], false), parameter(&[4, 3], false)];
        assert_eq!((type_of(&number), value_of(&number)), ("f64".into(), "next()".into()));
        assert_eq!(type_of(&matrix), "[[f64; 3]; 4]");
        assert_eq!(value_of(&matrix), "std::array::from_fn(|_| std::array::from_fn(|_| next()))");
        let text = ParameterText::of(&[parameter(&[2], false), number]);
        assert_eq!((&text.types[..], &text.arguments[..]), ("([f64; 2], f64, )", "&data.0, data.1, "));
        let text = ParameterText::of(&[parameter(&[2], true), parameter(&[3, 2], true)]);
        assert_eq!(text.types, "(::eliminant::Complex<f64>, [::eliminant::Complex<f64>; 3], )");
        assert_eq!(text.arguments, "data.0, &data.1, ");
        assert_eq!(ParameterText::of(&[]).types, "()");
    }
}
