//! Data of a solver in the source of a program that reads them as a stream of numbers.

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
    /// From the shapes of the parameters.
    pub(in crate::command) fn of(shapes: &[Vec<usize>]) -> Self {
        let list = |entry: &dyn Fn(usize) -> String| (0..shapes.len()).map(entry).collect::<String>();
        Self {
            types: format!("({})", list(&|at| format!("{}, ", array_type(&shapes[at])))),
            values: format!("({})", list(&|at| format!("{}, ", array_value(&shapes[at])))),
            arguments: list(&|at| format!("{}data.{at}, ", if shapes[at].is_empty() { "" } else { "&" })),
        }
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
        let text = ParameterText::of(&[vec![2], vec![]]);
        assert_eq!((&text.types[..], &text.arguments[..]), ("([f64; 2], f64, )", "&data.0, data.1, "));
        assert_eq!(ParameterText::of(&[]).types, "()");
    }
}
