//! The data of a problem: parameters, their shapes, and the conditions that they satisfy.

use std::ops::Range;

/// How the parts of a complex number are written.
pub(super) const PARTS: [&str; 2] = [".re", ".im"];

/// What the data of one parameter satisfy, so that random instances are drawn on the right variety.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DataAttribute {
    /// No condition.
    Generic,
    /// `#[symmetric]`: a square matrix with m\[i\]\[j\] = m\[j\]\[i\].
    Symmetric,
    /// `#[rotation]`: a 3x3 rotation matrix (or an array of them).
    Rotation,
    /// `#[unit]`: a vector of length 1 (or an array of them).
    Unit,
    /// `#[plucker]`: direction and moment of a line, orthogonal vectors of length 3 (or an array of
    /// such pairs).
    Plucker,
    /// `#[integer]`: small integers.
    Integer,
    /// `#[rank(2)]`: a matrix of that rank, less than the number of its rows and of its columns (or
    /// an array of them).
    Rank(usize),
}

/// One parameter of the problem function: an array of scalars, flattened row by row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DataParameter {
    /// Its name.
    pub name: String,
    /// Outermost dimension first: `[[f64; 3]; 4]` is \[4, 3\]; empty for a scalar. The last one of
    /// complex numbers is 2: `[Complex<f64>; 4]` is \[4, 2\].
    pub shape: Vec<usize>,
    /// `Complex<f64>`: real parts, each with its imaginary part behind it.
    pub is_complex: bool,
    /// What its values satisfy.
    pub attribute: DataAttribute,
    /// `#[mean(f)]`: they are means of what f gives for measurements.
    pub mean: Option<MeanOf>,
    /// Index of its first scalar among all inputs.
    pub first_input: usize,
    /// Where it was declared.
    pub span: Range<usize>,
}

/// The function that says what a measurement gives, of which data are the mean.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeanOf {
    /// Its name.
    pub function: String,
    /// Where the data name it.
    pub span: Range<usize>,
}

impl DataParameter {
    /// The last two dimensions, 1 where there are fewer: the rows and columns of a matrix.
    pub(crate) fn last_dimensions(&self) -> [usize; 2] {
        [1, 0].map(|from_last| self.shape.iter().rev().nth(from_last).copied().unwrap_or(1))
    }

    /// Number of scalars.
    pub fn len(&self) -> usize {
        self.shape.iter().product()
    }

    /// The scalars as a problem file names them.
    pub(crate) fn names(&self) -> Vec<String> {
        element_names(&self.name, &self.shape, self.is_complex)
    }

    /// Whether it is one number, real or complex.
    pub fn is_number(&self) -> bool {
        self.shape.len() == usize::from(self.is_complex)
    }

    /// Whether there are no scalars (an array of length 0).
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// One for tests of what prints parameters.
    #[cfg(test)]
    pub(crate) fn example(name: &str, shape: &[usize], is_complex: bool) -> Self {
        let (name, shape) = (name.to_owned(), shape.to_vec());
        Self { name, shape, is_complex, attribute: DataAttribute::Generic, mean: None, first_input: 0, span: 0..0 }
    }
}

/// The scalars of an array as a problem file names them: `x`, or `v[0]`, `v[1]`, .., or `z.re` and
/// `z.im`.
pub(super) fn element_names(name: &str, shape: &[usize], is_complex: bool) -> Vec<String> {
    let dimensions = &shape[..shape.len() - usize::from(is_complex)];
    let parts: &[&str] = if is_complex { &PARTS } else { &[""] };
    let elements = (0..dimensions.iter().product()).map(|at| element_name(dimensions, at));
    elements.flat_map(|element| parts.iter().map(move |part| format!("{name}{element}{part}"))).collect()
}

/// The element with a flat index as a problem file writes it: `[1][2]`, or nothing for a scalar.
pub(crate) fn element_name(shape: &[usize], index: usize) -> String {
    let mut size: usize = shape.iter().product();
    let mut rest = index;
    let mut name = String::new();
    for &length in shape {
        size /= length;
        name.push_str(&format!("[{}]", rest / size));
        rest %= size;
    }
    name
}
