//! Eigenpairs at twice the precision, for action matrices whose eigenvalues lose too many digits in `f64`.

use nalgebra::{Complex, DVector};
use qd::Quad;

use super::twice::rounded;

type Precise = Complex<Quad>;

/// 2^-104.
const ROUNDING: f64 = f64::EPSILON * f64::EPSILON;
/// QR sweeps for each eigenvalue at most, on the average.
const SWEEPS: usize = 30;
/// So many sweeps without a result are followed by an exceptional one.
const STALLED: usize = 10;
/// Steps of inverse iteration.
const INVERSE_ITERATIONS: usize = 2;

/// A real matrix A in Hessenberg form, by elimination with pivoting (Wilkinson 1965, chapter 6):
///
/// ```text
///                      [ x x x x x ]
///   A = P H P^-1,  H = [ x x x x x ]
///                      [   x x x x ]
///                      [     x x x ]
///                      [       x x ]
/// ```
pub(super) struct Hessenberg {
    h: Vec<Vec<Quad>>,
    /// For each column the row that was swapped up and the multiples of it that were subtracted from the rows below.
    steps: Vec<(usize, Vec<Quad>)>,
}

impl Hessenberg {
    pub(super) fn of(mut h: Vec<Vec<Quad>>) -> Self {
        let n = h.len();
        let mut steps = Vec::new();
        for k in 0..n.saturating_sub(2) {
            let size = |i: &usize| h[*i][k].0.abs();
            let pivot = (k + 1..n).max_by(|a, b| size(a).total_cmp(&size(b))).unwrap_or(k + 1);
            h.swap(k + 1, pivot);
            h.iter_mut().for_each(|row| row.swap(k + 1, pivot));
            let multipliers: Vec<Quad> = match h[k + 1][k] {
                zero if zero.0 == 0.0 => vec![0.0.into(); n - k - 2],
                head => (k + 2..n).map(|i| h[i][k] / head).collect(),
            };
            for (i, &multiplier) in (k + 2..n).zip(&multipliers) {
                let (above, below) = h.split_at_mut(i);
                let (source, target) = (&above[k + 1][k..], &mut below[0][k..]);
                target.iter_mut().zip(source).for_each(|(x, &s)| *x -= multiplier * s);
                for row in &mut h {
                    let from = row[i];
                    row[k + 1] += multiplier * from;
                }
            }
            steps.push((pivot, multipliers));
        }
        Self { h, steps }
    }

    /// By the QR iteration with single shifts; `None` where it does not end.
    pub(super) fn eigenvalues(&self) -> Option<Vec<Precise>> {
        let mut h: Vec<Vec<Precise>> = self.h.iter().map(|row| row.iter().map(|&x| x.into()).collect()).collect();
        let norm = self.norm();
        let mut values = Vec::new();
        let (mut left, mut stalled) = (SWEEPS * h.len(), 0);
        while values.len() < h.len() {
            let high = h.len() - values.len();
            let is_coupled = |k: usize| {
                let sum = size(h[k - 1][k - 1]) + size(h[k][k]);
                size(h[k][k - 1]) > ROUNDING * if sum > 0.0 { sum } else { norm }
            };
            let low = (1..high).rev().find(|&k| !is_coupled(k)).unwrap_or(0);
            if low == high - 1 {
                values.push(h[low][low]);
                stalled = 0;
                continue;
            }
            left = left.checked_sub(1)?;
            stalled += 1;
            let shift = match stalled % STALLED {
                0 => h[high - 1][high - 1] + Quad::from(size(h[high - 1][high - 2])),
                _ => shift(&h, high),
            };
            sweep(&mut h, low, high, shift);
        }
        Some(values)
    }

    /// The eigenvector of A, of length 1, by inverse iteration on H.
    pub(super) fn vector(&self, value: Precise) -> Option<DVector<Complex<f64>>> {
        let n = self.h.len();
        let mut shifted: Vec<Vec<Precise>> = self.h.iter().map(|row| row.iter().map(|&x| x.into()).collect()).collect();
        (0..n).for_each(|i| shifted[i][i] -= value);
        let mut vector: Vec<Precise> = (0..n).map(|i| Quad::from(1.0 / (1.0 + i as f64)).into()).collect();
        // The elimination is made on the first right-hand side, too, and repeated for the next.
        for _ in 0..INVERSE_ITERATIONS {
            solve(shifted.clone(), &mut vector, ROUNDING * self.norm());
            let largest = vector.iter().map(|&x| size(x)).fold(0.0, f64::max);
            if !(largest > 0.0 && largest.is_finite()) {
                return None;
            }
            let inverse = Quad::from(1.0 / largest);
            vector.iter_mut().for_each(|x| *x *= inverse);
        }
        for (k, (pivot, multipliers)) in self.steps.iter().enumerate().rev() {
            for (i, &multiplier) in (k + 2..n).zip(multipliers) {
                let head = vector[k + 1];
                vector[i] += head * multiplier;
            }
            vector.swap(k + 1, *pivot);
        }
        let rounded = DVector::from_iterator(n, vector.into_iter().map(round));
        let norm = rounded.norm();
        (norm > 0.0 && norm.is_finite()).then(|| rounded / Complex::from(norm))
    }

    /// The largest sum of moduli in a row.
    fn norm(&self) -> f64 {
        self.h.iter().map(|row| row.iter().map(|x| x.0.abs()).sum()).fold(f64::MIN_POSITIVE, f64::max)
    }
}

/// To `f64`.
pub(super) fn round(x: Precise) -> Complex<f64> {
    Complex::new(rounded(x.re), rounded(x.im))
}

fn size(x: Precise) -> f64 {
    x.re.0.abs() + x.im.0.abs()
}

/// The eigenvalue of the last 2 x 2 block that is nearer to its corner.
fn shift(h: &[Vec<Precise>], high: usize) -> Precise {
    let last = high - 1;
    let corner = h[last][last];
    // How far it is from the corner need not be known to more digits.
    let half = round(h[last - 1][last - 1] - corner) * 0.5;
    let product = round(h[last - 1][last] * h[last][last - 1]);
    let root = (half * half + product).sqrt();
    let far = if (half + root).norm() >= (half - root).norm() { half + root } else { half - root };
    let correction = if far == Complex::ZERO { far } else { -product / far };
    corner + Precise::new(correction.re.into(), correction.im.into())
}

/// One QR step with a shift on the rows and columns low..high.
fn sweep(h: &mut [Vec<Precise>], low: usize, high: usize, shift: Precise) {
    (low..high).for_each(|i| h[i][i] -= shift);
    let mut rotations = Vec::new();
    for k in low..high - 1 {
        let (a, b) = (h[k][k], h[k + 1][k]);
        let norm = (a.norm_sqr() + b.norm_sqr()).sqrt();
        let zero = Quad::from(0.0);
        let (c, s) = if norm == zero { (Quad::from(1.0).into(), zero.into()) } else { (a / norm, b / norm) };
        let (above, below) = h.split_at_mut(k + 1);
        for (x, y) in above[k][k..high].iter_mut().zip(&mut below[0][k..high]) {
            (*x, *y) = (c.conj() * *x + s.conj() * *y, c * *y - s * *x);
        }
        rotations.push((c, s));
    }
    for (k, (c, s)) in (low..).zip(rotations) {
        for row in &mut h[low..high.min(k + 2)] {
            (row[k], row[k + 1]) = (row[k] * c + row[k + 1] * s, row[k + 1] * c.conj() - row[k] * s.conj());
        }
    }
    (low..high).for_each(|i| h[i][i] += shift);
}

/// Solves a Hessenberg system; pivots smaller than `least` are replaced by it.
fn solve(mut h: Vec<Vec<Precise>>, right: &mut [Precise], least: f64) {
    let n = h.len();
    for k in 0..n {
        if k + 1 < n && size(h[k + 1][k]) > size(h[k][k]) {
            h.swap(k, k + 1);
            right.swap(k, k + 1);
        }
        if size(h[k][k]) < least {
            h[k][k] = Quad::from(least).into();
        }
        if k + 1 < n {
            let multiplier = h[k + 1][k] / h[k][k];
            let (above, below) = h.split_at_mut(k + 1);
            above[k][k..].iter().zip(&mut below[0][k..]).for_each(|(&x, y)| *y -= multiplier * x);
            let above = right[k];
            right[k + 1] -= multiplier * above;
        }
    }
    for k in (0..n).rev() {
        let sum = (k + 1..n).fold(right[k], |sum, j| sum - h[k][j] * right[j]);
        right[k] = sum / h[k][k];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// P A P^-1 for A with the real eigenvalues 1, 1 + 1e-12, 2, 3 .. and the pair 1 +- 2i: a block triangular A, P lower triangular with entries 1.
    fn hidden(n: usize) -> Vec<Vec<Quad>> {
        let mut a = vec![vec![Quad::from(0.0); n]; n];
        for (i, row) in a.iter_mut().enumerate() {
            (i + 1..n).for_each(|j| row[j] = Quad::from(((3 * i + 5 * j) % 7) as f64 - 3.0));
            row[i] = Quad::from((i as f64).max(1.0));
        }
        a[1][1] = Quad::from(1.0) + Quad::from(1e-12);
        (a[n - 2][n - 2], a[n - 2][n - 1]) = (1.0.into(), 2.0.into());
        (a[n - 1][n - 2], a[n - 1][n - 1]) = ((-2.0).into(), 1.0.into());
        // Rows are summed up from above; columns lose the next one.
        for i in 1..n {
            for j in 0..n {
                let above = a[i - 1][j];
                a[i][j] += above;
            }
        }
        for row in &mut a {
            for j in 0..n - 1 {
                let next = row[j + 1];
                row[j] -= next;
            }
        }
        a
    }

    #[test]
    fn close_eigenvalues_are_told_apart() {
        let n = 9;
        let matrix = hidden(n);
        let hessenberg = Hessenberg::of(matrix.clone());
        let mut values = hessenberg.eigenvalues().unwrap();
        values.sort_by(|a, b| (a.re.0, a.im.0).partial_cmp(&(b.re.0, b.im.0)).unwrap());
        let is = |expected: Precise| {
            let distance = values.iter().map(|&value| size(value - expected)).fold(f64::INFINITY, f64::min);
            assert!(distance < 1e-17, "{expected:?}: {distance:e}");
        };
        let whole = |re: f64, im: f64| Precise::new(re.into(), im.into());
        [2.0, 3.0, 4.0, 5.0, 6.0].into_iter().for_each(|value| is(whole(value, 0.0)));
        [whole(1.0, 2.0), whole(1.0, -2.0), whole(1.0, 0.0)].into_iter().for_each(is);
        is(whole(1.0, 0.0) + Quad::from(1e-12));
        for value in values {
            let vector = hessenberg.vector(value).unwrap();
            for (i, row) in matrix.iter().enumerate() {
                let image: Complex<f64> = row.iter().zip(&vector).map(|(&a, v)| v * rounded(a)).sum();
                assert!((image - vector[i] * round(value)).norm() < 1e-12, "{value:?}");
            }
        }
    }

    #[test]
    fn a_companion_matrix_of_roots_of_unity_takes_an_exceptional_shift() {
        let n = 6;
        let entry = |i: usize, j: usize| Quad::from(f64::from(u8::from((j + 1) % n == i)));
        let matrix = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
        let values = Hessenberg::of(matrix).eigenvalues().unwrap();
        assert!(values.iter().all(|value| size(value.powi(6) - Quad::from(1.0)) < 1e-25), "{values:?}");
    }
}
