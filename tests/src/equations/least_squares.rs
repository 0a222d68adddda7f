//! Least squares of small complex systems.

use eliminant::Complex;

/// A row, a column or a right side.
type Vector = Vec<Complex<f64>>;

/// Orthogonalised columns of this length, relative to the column, are dependent.
const DEPENDENT: f64 = 1e-15;

/// The x that minimises |matrix x - right|, by modified Gram-Schmidt on the matrix with the right
/// side as its last column, which is as stable as Householder's method (Björck 1967); `None` if
/// there are fewer rows than columns, columns are dependent, or values are not finite.
pub(super) fn least_squares(mut matrix: Vec<Vector>, mut right: Vector) -> Option<Vector> {
    let columns = matrix.first().map(Vec::len).filter(|&columns| columns <= matrix.len())?;
    let product =
        |a: &[Complex<f64>], b: &[Complex<f64>]| a.iter().zip(b).map(|(a, b)| a.conj() * b).sum::<Complex<f64>>();
    let mut orthogonal: Vec<Vector> = (0..columns).map(|j| matrix.iter().map(|row| row[j]).collect()).collect();
    // The triangular factor takes the place of the matrix.
    matrix.truncate(columns);
    let mut sums = vec![Complex::ZERO; columns];
    let sizes: Vec<f64> = orthogonal.iter().map(|column| product(column, column).re).collect();
    for k in 0..columns {
        let size = product(&orthogonal[k], &orthogonal[k]).re;
        if !(size > DEPENDENT * DEPENDENT * sizes[k] && size.is_finite()) {
            return None;
        }
        let (done, rest) = orthogonal.split_at_mut(k + 1);
        let unit = &done[k];
        let remove = |column: &mut Vector| {
            let factor = product(unit, column) / size;
            column.iter_mut().zip(unit).for_each(|(entry, unit)| *entry -= factor * unit);
            factor
        };
        for (j, column) in rest.iter_mut().enumerate() {
            matrix[k][k + 1 + j] = remove(column);
        }
        sums[k] = remove(&mut right);
    }
    for k in (0..columns).rev() {
        for j in k + 1..columns {
            let known = sums[j];
            sums[k] -= matrix[k][j] * known;
        }
    }
    sums.iter().all(|x| x.re.is_finite() && x.im.is_finite()).then_some(sums)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn complex(re: f64, im: f64) -> Complex<f64> {
        Complex::new(re, im)
    }

    #[test]
    fn the_residual_is_orthogonal_to_the_columns() {
        let matrix: Vec<Vector> = (0..5)
            .map(|i| {
                (0..3).map(|j| complex((1.0 + i as f64 * j as f64).sin(), (i as f64 - 2.0 * j as f64).cos())).collect()
            })
            .collect();
        let right: Vector = (0..5).map(|i| complex(f64::from(i), 1.0 - f64::from(i * i))).collect();
        let x = least_squares(matrix.clone(), right.clone()).expect("independent columns");
        let rest: Vector = matrix
            .iter()
            .zip(&right)
            .map(|(row, right)| row.iter().zip(&x).map(|(a, x)| a * x).sum::<Complex<f64>>() - right)
            .collect();
        for j in 0..3 {
            let product: Complex<f64> = matrix.iter().zip(&rest).map(|(row, rest)| row[j].conj() * rest).sum();
            assert!(product.norm() < 1e-13, "{product}");
        }
        assert!(rest.iter().any(|rest| rest.norm() > 0.1));
    }

    #[test]
    fn dependent_columns_are_refused() {
        let matrix = vec![vec![complex(1.0, 1.0), complex(0.0, 2.0)], vec![complex(2.0, 0.0), complex(2.0, 2.0)]];
        // The second column is 1 + i times the first.
        assert_eq!(least_squares(matrix, vec![Complex::ONE; 2]), None);
    }
}
