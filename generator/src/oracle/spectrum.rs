//! Eigenvalues and eigenvectors of a real matrix at 237 bits.
//!
//! ```text
//!   T S = S H    H: Hessenberg      a zero on the subdiagonal ends the part that is looked at
//! ```
//!
//! The characteristic polynomial p of H and its derivative at a number t follow from the vector x
//! that solves all rows of (H - t) x = 0 but the first (Hyman): p(t) is what the first row leaves,
//! up to a constant factor. All roots are improved together by Ehrlich and Aberth's iteration. At
//! an eigenvalue, S x is the eigenvector.

use eliminant::{Complex, emitted};
use f256::f256;

use super::number::{WideComplex, modulus, rounded, widened};
use crate::algebra::Random;

/// Sweeps over all eigenvalues at most.
const SWEEPS: usize = 80;
/// Corrections this small, relative to the largest eigenvalue, are the last ones.
const SHORTEST: f64 = 1e-55;
/// An entry of the subdiagonal this small, beside the largest entry of H, is 0.
const VANISHING: f64 = 1e-50;
/// The seed of the similarity that makes H general; any does.
const SEED: u64 = 1;

/// An eigenvalue, and an eigenvector with complex entries.
pub(super) type WidePair = (WideComplex, Vec<WideComplex>);

/// H, of which only the leading part without zeros on the subdiagonal is used, and S.
struct Reduced {
    size: usize,
    h: Vec<Vec<f256>>,
    s: Vec<Vec<f256>>,
}

/// The eigenpairs of a matrix, one for each different eigenvalue.
///
/// Where eigenvalues are shared by several eigenvectors there is one pair of them.
pub(super) fn eigenpairs(matrix: &[Vec<f256>]) -> Vec<WidePair> {
    let reduced = Reduced::of(matrix);
    let values = reduced.eigenvalues();
    values.into_iter().map(|value| (value, reduced.eigenvector(value))).collect()
}

impl Reduced {
    fn of(matrix: &[Vec<f256>]) -> Self {
        let size = matrix.len();
        let unit = |i: usize| (0..size).map(|j| if i == j { f256::ONE } else { f256::ZERO }).collect();
        let mut this = Self { size, h: matrix.to_vec(), s: (0..size).map(unit).collect() };
        let largest = this.h.iter().flatten().map(|&x| rounded(x.abs())).fold(0.0, f64::max);
        let mut random = Random::new(SEED);
        // A first vector of S that has parts of all eigenvectors.
        let factors: Vec<f256> =
            (0..size).map(|i| if i == 0 { f256::ZERO } else { f256::from(random.symmetric_unit()) }).collect();
        this.conjugate(0, &factors);
        for column in 0..size.saturating_sub(1) {
            let below = column + 1;
            let entry = |row: usize| rounded(this.h[row][column].abs());
            let pivot = (below..size).max_by(|&i, &j| entry(i).total_cmp(&entry(j))).unwrap_or(below);
            if entry(pivot) <= VANISHING * largest {
                this.size = below;
                break;
            }
            this.h.swap(below, pivot);
            this.h.iter_mut().chain(&mut this.s).for_each(|row| row.swap(below, pivot));
            let inverse = f256::ONE / this.h[below][column];
            let factors: Vec<f256> =
                (0..size).map(|row| if row > below { this.h[row][column] * inverse } else { f256::ZERO }).collect();
            this.conjugate(below, &factors);
        }
        this
    }

    /// L^-1 H L and S L for L = I + f e^T, where e is the unit vector `at`.
    fn conjugate(&mut self, at: usize, factors: &[f256]) {
        let pivot = self.h[at].clone();
        for (row, &factor) in self.h.iter_mut().zip(factors).filter(|(_, factor)| **factor != f256::ZERO) {
            row.iter_mut().zip(&pivot).for_each(|(entry, &above)| *entry -= factor * above);
        }
        for row in self.h.iter_mut().chain(&mut self.s) {
            let sum = row.iter().zip(factors).fold(f256::ZERO, |sum, (&entry, &factor)| sum + entry * factor);
            row[at] += sum;
        }
    }

    /// The vector x of (H - t) x = 0 without the first row, with its last entry 1, and its
    /// derivative by t.
    fn vectors(&self, t: WideComplex) -> (Vec<WideComplex>, Vec<WideComplex>) {
        let zero = Complex::new(f256::ZERO, f256::ZERO);
        let (mut x, mut slope) = (vec![zero; self.size], vec![zero; self.size]);
        if let Some(last) = x.last_mut() {
            *last = Complex::new(f256::ONE, f256::ZERO);
        }
        for row in (1..self.size).rev() {
            let (value, derivative) = self.row(row, t, &x, &slope);
            let inverse = -f256::ONE / self.h[row][row - 1];
            x[row - 1] = value.scale(inverse);
            slope[row - 1] = derivative.scale(inverse);
        }
        (x, slope)
    }

    /// A row of (H - t) x without its entry below the diagonal, and its derivative.
    fn row(&self, row: usize, t: WideComplex, x: &[WideComplex], slope: &[WideComplex]) -> (WideComplex, WideComplex) {
        let (mut value, mut derivative) = (-t * x[row], -t * slope[row] - x[row]);
        for j in row..self.size {
            value += x[j].scale(self.h[row][j]);
            derivative += slope[j].scale(self.h[row][j]);
        }
        (value, derivative)
    }

    /// p(t) / p'(t); `None` where that is no number.
    fn newton_step(&self, t: WideComplex) -> Option<WideComplex> {
        let (x, slope) = self.vectors(t);
        let (value, derivative) = self.row(0, t, &x, &slope);
        let step = value / derivative;
        (step.re.is_finite() && step.im.is_finite()).then_some(step)
    }

    fn eigenvalues(&self) -> Vec<WideComplex> {
        let mut values = self.starts();
        let scale = values.iter().copied().map(modulus).fold(f64::MIN_POSITIVE, f64::max);
        for _ in 0..SWEEPS {
            let mut largest = 0.0_f64;
            for at in 0..values.len() {
                let Some(step) = self.newton_step(values[at]) else { continue };
                let one = Complex::new(f256::ONE, f256::ZERO);
                let others = (0..values.len()).filter(|&other| other != at);
                let sum = others
                    .fold(Complex::new(f256::ZERO, f256::ZERO), |sum, other| sum + one / (values[at] - values[other]));
                let correction = step / (one - step * sum);
                if correction.re.is_finite() && correction.im.is_finite() {
                    values[at] -= correction;
                    largest = largest.max(modulus(correction));
                }
            }
            if largest <= SHORTEST * scale {
                break;
            }
        }
        values
    }

    /// Eigenvalues in `f64`, moved apart; without them points on a circle.
    fn starts(&self) -> Vec<WideComplex> {
        let part: Vec<Vec<f64>> =
            self.h[..self.size].iter().map(|row| row[..self.size].iter().map(|&x| rounded(x)).collect()).collect();
        let norm = part.iter().map(|row| row.iter().map(|x| x.abs()).sum::<f64>()).fold(0.0, f64::max);
        let found = emitted::eigenvalues(emitted::Dynamic(self.size), &part);
        let values: Vec<Complex<f64>> = found.unwrap_or_else(|_| vec![Complex::new(0.0, 0.0); self.size]);
        let size = values.iter().map(|value| value.norm()).fold(0.0, f64::max);
        // Far enough apart that no two start as one, and on no axis of symmetry.
        let spread = if size > 0.0 { 1e-8 * size } else { norm };
        let turned = |(at, value): (usize, Complex<f64>)| {
            let angle = 0.4 + std::f64::consts::TAU * at as f64 / self.size as f64;
            widened(value + Complex::from_polar(spread, angle))
        };
        values.into_iter().enumerate().map(turned).collect()
    }

    /// S x.
    fn eigenvector(&self, value: WideComplex) -> Vec<WideComplex> {
        let (x, _) = self.vectors(value);
        let entry = |row: &Vec<f256>| {
            row.iter().zip(&x).fold(Complex::new(f256::ZERO, f256::ZERO), |sum, (&s, x)| sum + x.scale(s))
        };
        self.s.iter().map(entry).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// |T v - a v| / |v|, largest over the pairs.
    fn worst(matrix: &[Vec<f256>], pairs: &[WidePair]) -> f64 {
        let of_pair = |(value, vector): &WidePair| {
            let size = vector.iter().copied().map(modulus).fold(0.0, f64::max);
            let row = |(row, &own): (&Vec<f256>, &WideComplex)| {
                let zero = Complex::new(f256::ZERO, f256::ZERO);
                let product = row.iter().zip(vector).fold(zero, |sum, (&entry, v)| sum + v.scale(entry));
                modulus(product - *value * own) / size
            };
            matrix.iter().zip(vector).map(row).fold(0.0, f64::max)
        };
        pairs.iter().map(of_pair).fold(0.0, f64::max)
    }

    fn matrix(entries: &[&[f64]]) -> Vec<Vec<f256>> {
        entries.iter().map(|row| row.iter().map(|&x| f256::from(x)).collect()).collect()
    }

    #[test]
    fn eigenpairs_have_sixty_digits() {
        let mut random = Random::new(7);
        for size in [1, 2, 5, 12] {
            let rows: Vec<Vec<f256>> =
                (0..size).map(|_| (0..size).map(|_| f256::from(random.symmetric_unit())).collect()).collect();
            let pairs = eigenpairs(&rows);
            assert_eq!(pairs.len(), size);
            assert!(worst(&rows, &pairs) < 1e-50, "{size}: {}", worst(&rows, &pairs));
        }
    }

    /// The roots of (t - 1) .. (t - 12): doubles lose half of the digits, 237 bits do not.
    #[test]
    fn a_companion_matrix_gives_the_integers_back() {
        let mut polynomial = vec![f256::ONE];
        for root in 1..=12u64 {
            let mut next = vec![f256::ZERO; polynomial.len() + 1];
            for (at, &c) in polynomial.iter().enumerate() {
                next[at + 1] += c;
                next[at] -= c * f256::from(root);
            }
            polynomial = next;
        }
        let entry = |i: usize, j: usize| match j {
            11 => -polynomial[i],
            _ if i == j + 1 => f256::ONE,
            _ => f256::ZERO,
        };
        let companion: Vec<Vec<f256>> = (0..12).map(|i| (0..12).map(|j| entry(i, j)).collect()).collect();
        let mut values: Vec<f64> = eigenpairs(&companion).iter().map(|(value, _)| rounded(value.re)).collect();
        values.sort_by(f64::total_cmp);
        assert_eq!(values, (1..=12).map(f64::from).collect::<Vec<_>>());
    }

    #[test]
    fn an_eigenvalue_of_several_vectors_is_found_once() {
        let pairs = eigenpairs(&matrix(&[&[2.0, 0.0, 0.0], &[0.0, 2.0, 0.0], &[0.0, 0.0, 3.0]]));
        let mut values: Vec<f64> = pairs.iter().map(|(value, _)| rounded(value.re)).collect();
        values.sort_by(f64::total_cmp);
        assert_eq!(values, [2.0, 3.0]);
    }
}
