//! Eigenvalues by the double-shift QR iteration (Francis 1961), with a bound on the number of
//! iterations.
//!
//! Deflation (Ahues and Tisseur 1997), the two exceptional shifts and the start of the bulge at two
//! small consecutive subdiagonals follow the description of LAPACK's `dlahqr`. Only eigenvalues are
//! wanted, so a sweep touches only the active diagonal block. Eigenvectors come one at a time from
//! inverse iteration.

use crate::error::SolveError;
use crate::number::{Real, float};
use crate::size::{Size, Square};
use crate::spectrum::hessenberg::Hessenberg;
use num_complex::Complex;

/// The iteration stops after this many sweeps per eigenvalue on average; two or three are usual.
const SWEEPS_PER_EIGENVALUE: usize = 30;

impl<Z: Size, R: Real> Hessenberg<Z, R> {
    /// All eigenvalues of A, followed by zeros beyond its order. Complex eigenvalues come in
    /// conjugate pairs, the one with positive imaginary part first.
    ///
    /// # Errors
    /// [`SolveError::NoConvergence`] after 30 max(N, 10) sweeps.
    pub fn eigenvalues(&self) -> Result<Z::Vector<Complex<f64>>, SolveError> {
        let mut h = self.matrix.clone();
        let mut values = self.size.filled(Complex { re: 0.0, im: 0.0 });
        let mut high = self.size.get();
        let mut remaining = SWEEPS_PER_EIGENVALUE * high.max(10);
        let mut stalled = 0;
        while high > 0 {
            let low = active_block::<Z, R>(&h, high);
            match high - low {
                1 => values[low] = h[low][low].to_complex(),
                2 => {
                    let pair = eigenvalues_2x2(h[low][low], h[low][low + 1], h[low + 1][low], h[low + 1][low + 1]);
                    let [first, second] = pair;
                    values[low] = Complex { re: first.0.real(), im: first.1.real() };
                    values[low + 1] = Complex { re: second.0.real(), im: second.1.real() };
                }
                _ => {
                    if remaining == 0 {
                        return Err(SolveError::NoConvergence);
                    }
                    remaining -= 1;
                    stalled += 1;
                    let shifts = choose_shifts::<Z, R>(&h, low, high, stalled);
                    sweep::<Z, R>(&mut h, low, high, shifts);
                    continue;
                }
            }
            high = low;
            stalled = 0;
        }
        for value in values.as_mut() {
            *value = Complex { re: value.re * self.unit, im: value.im * self.unit };
        }
        Ok(values)
    }
}

/// The first row of the last unreduced diagonal block of the leading `high` rows. A subdiagonal
/// entry counts as zero if setting it to zero moves the eigenvalues of the 2x2 block around it by
/// less than rounding (Ahues and Tisseur).
#[inline]
fn active_block<Z: Size, R: Real>(h: &Square<Z, R>, high: usize) -> usize {
    let mut k = high - 1;
    while k > 0 {
        let subdiagonal = h[k][k - 1].modulus();
        if subdiagonal <= f64::MIN_POSITIVE {
            break;
        }
        let mut size = h[k - 1][k - 1].modulus() + h[k][k].modulus();
        if size == 0.0 {
            if k >= 2 {
                size += h[k - 1][k - 2].modulus();
            }
            if k + 1 < high {
                size += h[k + 1][k].modulus();
            }
        }
        if subdiagonal <= R::EPSILON * size {
            let superdiagonal = h[k - 1][k].modulus();
            let difference = (h[k - 1][k - 1] - h[k][k]).modulus();
            let (ab, ba) = ordered(subdiagonal, superdiagonal);
            let (aa, bb) = ordered(h[k][k].modulus(), difference);
            let sum = aa + ab;
            if ba * (ab / sum) <= f64::MIN_POSITIVE.max(R::EPSILON * (bb * (aa / sum))) {
                break;
            }
        }
        k -= 1;
    }
    k
}

/// The larger number and the smaller one.
#[inline]
fn ordered(x: f64, y: f64) -> (f64, f64) {
    if x > y { (x, y) } else { (y, x) }
}

/// Eigenvalues of [[a, b], [c, d]] as real and imaginary parts, without needless cancellation or
/// overflow.
#[inline]
fn eigenvalues_2x2<R: Real>(a: R, b: R, c: R, d: R) -> [(R, R); 2] {
    let half = (a - d).scale(0.5);
    let (large, small) = if b.modulus() > c.modulus() { (b, c) } else { (c, b) };
    let scale = if half.modulus() > large.modulus() { half } else { large };
    if scale == R::ZERO {
        return [(a, R::ZERO), (d, R::ZERO)];
    }
    let scale = scale.with_sign_of(R::ONE);
    let discriminant = (half / scale) * half + (large / scale) * small;
    if discriminant.real() < 0.0 {
        let (mean, root) = (d + half, scale.sqrt() * (-discriminant).sqrt());
        return [(mean, root), (mean, -root)];
    }
    // The eigenvalue further from d comes first; the other one follows from their product.
    let shift = half + (scale.sqrt() * discriminant.sqrt()).with_sign_of(half);
    let other = if shift == R::ZERO { d } else { d - (large / shift) * small };
    [(d + shift, R::ZERO), (other, R::ZERO)]
}

/// The two shifts of a sweep: the eigenvalues of the trailing 2x2 block, or twice the nearer one if
/// they are real. After ten sweeps without a deflation, exceptional shifts are taken, because the
/// usual ones stall on some matrices (orthogonal ones).
#[inline]
fn choose_shifts<Z: Size, R: Real>(h: &Square<Z, R>, low: usize, high: usize, stalled: usize) -> [(R, R); 2] {
    let last = high - 1;
    let exceptional = |corner: R, size: f64| {
        let diagonal = corner + R::from_f64(0.75 * size);
        eigenvalues_2x2(diagonal, R::from_f64(-0.4375 * size), R::from_f64(size), diagonal)
    };
    if stalled % 20 == 10 {
        return exceptional(h[low][low], h[low + 1][low].modulus() + h[low + 2][low + 1].modulus());
    }
    if stalled.is_multiple_of(20) {
        return exceptional(h[last][last], h[last][last - 1].modulus() + h[last - 1][last - 2].modulus());
    }
    let corner = h[last][last];
    let [first, second] = eigenvalues_2x2(h[last - 1][last - 1], h[last - 1][last], h[last][last - 1], corner);
    if first.1 != R::ZERO {
        return [first, second];
    }
    let nearer = if (first.0 - corner).modulus() <= (second.0 - corner).modulus() { first } else { second };
    [nearer, nearer]
}

/// One implicit double-shift QR sweep on the unreduced block low..high of at least three rows.
#[inline]
fn sweep<Z: Size, R: Real>(h: &mut Square<Z, R>, low: usize, high: usize, shifts: [(R, R); 2]) {
    let (start, mut v) = bulge_start::<Z, R>(h, low, high, shifts);
    for k in start..high - 1 {
        let three = k + 2 < high;
        if k > start {
            v = [h[k][k - 1], h[k + 1][k - 1], if three { h[k + 2][k - 1] } else { R::ZERO }];
        }
        let (beta, tau, v1, v2) = reflection(v);
        if k > start {
            h[k][k - 1] = beta;
            h[k + 1][k - 1] = R::ZERO;
            if three {
                h[k + 2][k - 1] = R::ZERO;
            }
        } else if k > low {
            h[k][k - 1] *= R::ONE - tau;
        }
        if tau == R::ZERO {
            continue;
        }
        let (t1, t2) = (tau * v1, tau * v2);
        if three {
            let [row0, row1, row2] = match h.as_mut()[k..].first_chunk_mut::<3>() {
                Some(rows) => rows,
                None => return,
            };
            for j in k..high {
                let sum = row0[j] + v1 * row1[j] + v2 * row2[j];
                row0[j] -= sum * tau;
                row1[j] -= sum * t1;
                row2[j] -= sum * t2;
            }
            for row in &mut h.as_mut()[low..high.min(k + 4)] {
                let sum = row[k] + v1 * row[k + 1] + v2 * row[k + 2];
                row[k] -= sum * tau;
                row[k + 1] -= sum * t1;
                row[k + 2] -= sum * t2;
            }
        } else {
            let [row0, row1] = match h.as_mut()[k..].first_chunk_mut::<2>() {
                Some(rows) => rows,
                None => return,
            };
            for j in k..high {
                let sum = row0[j] + v1 * row1[j];
                row0[j] -= sum * tau;
                row1[j] -= sum * t1;
            }
            for row in &mut h.as_mut()[low..high] {
                let sum = row[k] + v1 * row[k + 1];
                row[k] -= sum * tau;
                row[k + 1] -= sum * t1;
            }
        }
    }
}

/// The row in which the bulge starts, and its first column: the first column of (H - s1)(H - s2),
/// scaled.
#[inline]
fn bulge_start<Z: Size, R: Real>(h: &Square<Z, R>, low: usize, high: usize, [s1, s2]: [(R, R); 2]) -> (usize, [R; 3]) {
    let mut m = high - 3;
    loop {
        let below = h[m + 1][m].modulus();
        let sum = R::from_f64((h[m][m] - s2.0).modulus() + s2.1.modulus() + below);
        let ratio = h[m + 1][m] / sum;
        let mut v = [
            ratio * h[m][m + 1] + (h[m][m] - s1.0) * ((h[m][m] - s2.0) / sum) - s1.1 * (s2.1 / sum),
            ratio * (h[m][m] + h[m + 1][m + 1] - s1.0 - s2.0),
            ratio * h[m + 2][m + 1],
        ];
        let size = v[0].modulus() + v[1].modulus() + v[2].modulus();
        if size > 0.0 {
            let size = R::from_f64(size);
            v = [v[0] / size, v[1] / size, v[2] / size];
        }
        if m == low {
            return (m, v);
        }
        let around = h[m - 1][m - 1].modulus() + h[m][m].modulus() + h[m + 1][m + 1].modulus();
        if h[m][m - 1].modulus() * (v[1].modulus() + v[2].modulus()) <= R::EPSILON * v[0].modulus() * around {
            return (m, v);
        }
        m -= 1;
    }
}

/// The reflection I - tau w w^T, w = (1, w1, w2), that maps v to (beta, 0, 0). Returns beta, tau,
/// w1, w2.
#[inline]
fn reflection<R: Real>(v: [R; 3]) -> (R, R, R, R) {
    let size = v[0].modulus().max(v[1].modulus()).max(v[2].modulus());
    // Squares of numbers of usual size need no scaling; tiny numbers need it.
    let scale = if size < 1e-140 && size > 0.0 { float::power_of_two(float::exponent(size).max(-1021)) } else { 1.0 };
    let unit = R::from_f64(scale);
    let [x, y, z] = [v[0] / unit, v[1] / unit, v[2] / unit];
    let tail = y * y + z * z;
    if tail == R::ZERO {
        return (v[0], R::ZERO, R::ZERO, R::ZERO);
    }
    let beta = -(x * x + tail).sqrt().with_sign_of(x);
    let inverse = (x - beta).reciprocal();
    (beta.scale(scale), (beta - x) / beta, y * inverse, z * inverse)
}
