//! Coefficients by monomials.

use eliminant::emitted::{Matrix, Size, Tables, filled_matrix};

/// The coefficients of all equations, one row for each monomial.
pub(crate) fn rows_of<N: Size, E: Size, K: Size>(
    tables: &Tables<'_, N, E, K>,
    coefficients: &[f64],
) -> Matrix<K, E, f64> {
    let (_, equations, monomials) = tables.sizes;
    let (mut rows, mut first) = (filled_matrix(monomials, equations, 0.0), 0);
    for (equation, &end) in tables.ends.as_ref().iter().enumerate() {
        for term in &tables.terms[first..end as usize] {
            rows[usize::from(term.monomial)][equation] += coefficients[usize::from(term.coefficient)];
        }
        first = end as usize;
    }
    rows
}
