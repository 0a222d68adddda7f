//! Eigenvalues by the double-shift QR iteration (Francis 1961), with a bound on the number of
//! iterations.
//!
//! Deflation (Ahues and Tisseur 1997), the two exceptional shifts and the start of the bulge at two
//! small consecutive subdiagonals follow the description of LAPACK's `dlahqr`. Only eigenvalues are
//! wanted, so a sweep touches only the active diagonal block. Eigenvectors come one at a time from
//! inverse iteration.

use crate::error::SolveError;
use crate::number::Real;
use crate::size::{Size, Square};
use crate::spectrum::hessenberg::Hessenberg;
use crate::spectrum::reflection::{reflect_three, reflect_two, reflection};
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
        let reflection = (tau, tau * v1, tau * v2, v1, v2);
        let rows = &mut h.as_mut()[low..high];
        if three {
            reflect_three::<Z, R>(rows, (k - low, k..high), reflection);
        } else {
            reflect_two::<Z, R>(rows, (k - low, k..high), reflection);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Scalar;
    use crate::number::double_double::DoubleDouble;
    use crate::size::Fixed;
    use proptest::prelude::*;
    use proptest::test_runner::RngSeed;

    /// The first row of the last block of [[a, b], [c, d]].
    fn last_block([[a, b], [c, d]]: [[f64; 2]; 2]) -> usize {
        active_block::<Fixed<2>, f64>(&[[a, b], [c, d]], 2)
    }

    /// Setting c to zero moves the eigenvalue near d by b c / (a - d), which must be rounding of d.
    #[test]
    fn what_moves_no_eigenvalue_is_deflated() {
        for unit in [1e-8, 1e-3, 1.0, 1e5] {
            for (a, b, d) in [
                (1.0, 1.0, 1e-10),
                (1.0, -1.0, -1e-10),
                (-1.0, 30.0, 1e-3),
                (1e-6, 1.0, 1.0),
                (2.0, 1e4, -3.0),
                (1.0, 1.0, 1.0 + 1e-6),
                (1.0 + 1e-6, -2.0, 1.0),
            ] {
                let at = |part: f64| {
                    let c = part * f64::EPSILON * f64::abs(d) * f64::abs(a - d) / f64::abs(b);
                    last_block([[a * unit, b * unit], [c * unit, d * unit]])
                };
                assert_eq!([at(0.9), at(-0.9), at(1.1), at(-1.1)], [1, 1, 0, 0], "{a} {b} {d} {unit}");
            }
        }
    }

    /// Whatever b, c must be rounding of the diagonal.
    #[test]
    fn what_is_not_small_beside_the_diagonal_is_not_deflated() {
        for unit in [1e-8, 1.0, 1e5] {
            for (a, d) in [(1.0, 2.0), (-1.0, 2.0), (1.0, -2.0), (2.5, 0.5)] {
                let at = |part: f64| {
                    let c = part * f64::EPSILON * 3.0;
                    last_block([[a * unit, 0.0], [c * unit, d * unit]])
                };
                assert_eq!([at(0.9), at(-0.9), at(1.1), at(-1.1)], [1, 1, 0, 0], "{a} {d} {unit}");
            }
        }
        assert_eq!(last_block([[1.0, 1e300], [f64::MIN_POSITIVE, 2.0]]), 1, "subnormal numbers are zero");
        assert_eq!(last_block([[1.0, 1e300], [2.0 * f64::MIN_POSITIVE, 2.0]]), 0);
    }

    /// Between two zeros of the diagonal the subdiagonal is compared with its neighbours.
    #[test]
    fn beside_zeros_the_neighbours_decide() {
        let first_row = |above: f64, c: f64, below: f64, high: usize| {
            let h = [[7.0, 0.0, 0.0, 0.0], [above, 0.0, 0.0, 0.0], [0.0, c, 0.0, 0.0], [0.0, 0.0, below, 7.0]];
            active_block::<Fixed<4>, f64>(&h, high)
        };
        for (above, below, size) in [(1.0, 2.0, 3.0), (-1.0, 2.0, 3.0), (3.0, -0.5, 3.5)] {
            let c = f64::EPSILON * size;
            assert_eq!([first_row(above, 0.9 * c, below, 4), first_row(above, -0.9 * c, below, 4)], [2; 2]);
            assert_eq!([first_row(above, 1.1 * c, below, 4), first_row(above, -1.1 * c, below, 4)], [0; 2]);
            // What lies below the leading rows does not count.
            let c = f64::EPSILON * f64::abs(above);
            assert_eq!([first_row(above, 0.9 * c, below, 3), first_row(above, 1.1 * c, below, 3)], [2, 0]);
        }
        let h = [[0.0, 0.0, 0.0], [0.9 * f64::EPSILON, 0.0, 0.0], [0.0, 1.0, 5.0]];
        assert_eq!(active_block::<Fixed<3>, f64>(&h, 3), 1);
        assert_eq!(active_block::<Fixed<3>, f64>(&h, 2), 0);
    }

    /// The same cases every time.
    fn config() -> ProptestConfig {
        ProptestConfig { cases: 2_000, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..Default::default() }
    }

    /// Numbers that are often 0 or 1.
    fn entry() -> impl Strategy<Value = f64> {
        prop_oneof![1 => Just(0.0), 1 => Just(1.0), 4 => -1.0..1.0_f64]
    }

    /// H, with entries of a square array above the second subdiagonal.
    fn hessenberg<const N: usize>(mut h: [[f64; N]; N]) -> [[f64; N]; N] {
        (2..N).for_each(|i| h[i][..i - 1].fill(0.0));
        h
    }

    /// The traces of H, H^2, .., H^N of leading rows and columns between `low` and `high`.
    fn traces<const N: usize>(h: &[[f64; N]; N], low: usize, high: usize) -> [f64; N] {
        let mut power = *h;
        core::array::from_fn(|_| {
            let trace = (low..high).map(|i| power[i][i]).sum();
            let mut next = [[0.0; N]; N];
            for (i, j, k) in
                (low..high).flat_map(|i| (low..high).flat_map(move |j| (low..high).map(move |k| (i, j, k))))
            {
                next[i][j] += power[i][k] * h[k][j];
            }
            power = next;
            trace
        })
    }

    proptest! {
        #![proptest_config(config())]
        /// Their sum is the trace, their product the determinant, up to cancellation.
        #[test]
        fn pairs_have_trace_and_determinant(m in prop::array::uniform4(entry()), exponent in -150..150_i32) {
            let [a, b, c, d] = m.map(|x| x * 10.0_f64.powi(exponent));
            let [(x, p), (y, q)] = eigenvalues_2x2(a, b, c, d);
            let (sum, size) = (x + y - a - d, m.iter().fold(0.0, |sum, x| sum + x.abs()) * 10.0_f64.powi(exponent));
            prop_assert!(sum.abs() <= 4.0 * f64::EPSILON * size, "{x} {y}");
            // In units of the size, where nothing overflows.
            let unit = if size > 0.0 { size } else { 1.0 };
            let [a, b, c, d, x, y, p, q] = [a, b, c, d, x, y, p, q].map(|x| x / unit);
            prop_assert!((x * y - p * q - (a * d - b * c)).abs() <= 8.0 * f64::EPSILON, "{x} {y} {p} {q}");
            prop_assert!(p == -q && p >= 0.0 && (p == 0.0 || x == y), "{x} {y} {p} {q}");
        }

        /// A sweep is a similarity of the active block and leaves it in Hessenberg form.
        #[test]
        fn sweeps_are_similarities(
            entries in prop::array::uniform7(prop::array::uniform7(-1.0..1.0_f64)),
            shifts in prop::array::uniform3(-1.0..1.0_f64),
            low in 0..3_usize,
            rows in 3..5_usize,
            small in 0..6_usize,
        ) {
            let (before, high) = (&mut hessenberg(entries), low + rows);
            // Two small subdiagonals in a row let the bulge start below.
            if small > 3 {
                (before[low + 1][low], before[low + 2][low + 1]) = (1e-9, 1e-9);
            }
            let [x, y, im] = shifts;
            let pair = if small % 2 == 0 { [(x, im), (x, -im)] } else { [(x, 0.0), (y, 0.0)] };
            let mut h = *before;
            sweep::<Fixed<7>, f64>(&mut h, low, high, pair);
            for (i, j) in (0..7).flat_map(|i| (0..7).map(move |j| (i, j))) {
                let inside = (low..high).contains(&i) && (low..high).contains(&j);
                prop_assert!(inside || h[i][j] == before[i][j], "{i} {j} is outside");
                prop_assert!(!inside || i <= j + 1 || h[i][j] == 0.0, "{i} {j} is below the subdiagonal");
            }
            for (new, old) in traces(&h, low, high).into_iter().zip(traces(before, low, high)) {
                prop_assert!((new - old).abs() <= 1e-12, "{new} {old}");
            }
        }

        /// With its eigenvalues as shifts a block of three rows comes apart in a sweep or two.
        #[test]
        fn exact_shifts_deflate(entries in prop::array::uniform3(prop::array::uniform3(-1.0..1.0_f64))) {
            let mut h = hessenberg(entries);
            let form = Hessenberg::reduce(&h).unwrap();
            let values = form.eigenvalues().unwrap();
            let complex = values.iter().position(|value| value.im > 0.0).unwrap_or(1);
            let first = values[complex];
            let other = if first.im > 0.0 { first.conj() } else { values[0] };
            for _ in 0..2 {
                sweep::<Fixed<3>, f64>(&mut h, 0, 3, [(first.re, first.im), (other.re, other.im)]);
            }
            prop_assert!(h[1][0].abs().min(h[2][1].abs()) < 1e-6, "{h:?}");
        }
    }

    /// The bulge starts in row 1 if its part in column 0 is rounding: the subdiagonal left of it
    /// times the first column of H^2 below its head, beside the head times the diagonal around.
    /// Here that column is (1, 1, 1) squares of the unit, so the subdiagonal is compared with half
    /// of that rounding. The shifts are zero.
    #[test]
    fn the_bulge_starts_where_it_leaves_rounding_behind() {
        for (corner, a) in [(7.0, 0.0), (-7.0, 0.0), (0.25, 2.0), (-9.0, 2.0), (0.5, -6.0), (40.0, -6.0)] {
            for unit in [1e-6, 1.0, 1e6] {
                let around = f64::abs(corner) + f64::abs(a) + f64::abs(1.0 - a);
                let start = |part: f64| {
                    let left = part * 0.5 * f64::EPSILON * around;
                    let rows = [
                        [corner, 0.3, 0.0, 0.0],
                        [left, a, 1.0 - a * a, 0.0],
                        [0.0, 1.0, 1.0 - a, 0.2],
                        [0.0, 0.0, 1.0, -1.0],
                    ];
                    let h = rows.map(|row| row.map(|x| x * unit));
                    let (row, v) = bulge_start::<Fixed<4>, f64>(&h, 0, 4, [(0.0, 0.0); 2]);
                    let is_level = v.iter().all(|x| (x / v[0] - 1.0).abs() < 1e-14);
                    assert!(row == 0 || (is_level && v[0] > 0.0), "{v:?}");
                    row
                };
                assert_eq!([0.9, -0.9, 1.1, -1.1].map(start), [1, 1, 0, 0], "{corner} {a} {unit}");
            }
        }
    }

    #[test]
    fn shifts_are_the_trailing_eigenvalues_or_exceptional() {
        let shifts = |h: &[[f64; 3]; 3], stalled| choose_shifts::<Fixed<3>, f64>(h, 0, 3, stalled);
        let rotation = [[5.0, 1.0, 2.0], [0.5, 1.0, -2.0], [0.0, 2.0, 1.0]];
        assert_eq!(shifts(&rotation, 1).map(|(x, p)| (x, p.round())), [(1.0, 2.0), (1.0, -2.0)]);
        // Eigenvalues 3 and 1, or 1 and 3: the one nearer to the corner, twice.
        assert_eq!(
            shifts(&[[5.0, 1.0, 2.0], [0.5, 3.0, 1e-9], [0.0, 1e-9, 1.0]], 9).map(|(x, y)| (x.round(), y)),
            [(1.0, 0.0); 2]
        );
        assert_eq!(
            shifts(&[[5.0, 1.0, 2.0], [0.5, 1.0, 1e-9], [0.0, 1e-9, 3.0]], 11).map(|(x, y)| (x.round(), y)),
            [(3.0, 0.0); 2]
        );
        // The further one is close to the negative corner, or closer to zero than the other to it.
        let opposite = shifts(&[[5.0, 1.0, 2.0], [0.5, -0.996, 0.1], [0.0, 0.1, 1.0]], 1);
        assert!(opposite.iter().all(|&(x, p)| (x - 1.005).abs() < 1e-3 && p == 0.0), "{opposite:?}");
        let small = shifts(&[[5.0, 1.0, 2.0], [0.5, 0.01, 0.5], [0.0, 0.5, 1.0]], 1);
        assert!(small.iter().all(|&(x, p)| (x - 1.209).abs() < 1e-3 && p == 0.0), "{small:?}");
        // After ten sweeps at the top, after twenty at the bottom: x + 0.75 s with a product of
        // -0.4375 s^2 aside.
        for (stalled, corner, size) in [(10, 5.0, 2.5), (30, 5.0, 2.5), (20, 1.0, 2.5), (40, 1.0, 2.5)] {
            let [(x, p), (y, q)] = shifts(&rotation, stalled);
            let diagonal = corner + 0.75 * size;
            assert!((x - diagonal).abs() < 1e-15 && (y - diagonal).abs() < 1e-15, "{x} {y}");
            assert!((p * p - 0.4375 * size * size).abs() < 1e-14 && p == -q, "{p} {q}");
        }
        // Subdiagonals count by their moduli.
        let signs = [[5.0, 1.0, 2.0], [-0.5, 1.0, -2.0], [0.0, -2.0, 1.0]];
        assert_eq!([10, 20].map(|stalled| shifts(&signs, stalled)), [10, 20].map(|stalled| shifts(&rotation, stalled)));
    }

    /// Products of entries of very different sizes are divided first.
    #[test]
    fn pairs_do_not_overflow_needlessly() {
        let halves = [0.0, 1e-100, -1e-100];
        for (half, (b, c)) in halves.into_iter().flat_map(|half| [(1e250, 1e-250), (1e-250, 1e250)].map(|m| (half, m)))
        {
            let [(x, p), (y, q)] = eigenvalues_2x2(half, b, c, -half);
            assert!((x.abs() - 1.0).abs() < 1e-15 && (x + y).abs() < 1e-15 && p == 0.0 && q == 0.0, "{x} {y}");
            let [(x, p), (y, q)] = eigenvalues_2x2(half, b, -c, -half);
            assert!(x.abs() < 1e-15 && y.abs() < 1e-15 && (p - 1.0).abs() < 1e-15 && q == -p, "{p} {q}");
        }
        let [(x, _), (y, _)] = eigenvalues_2x2(1e200, 1e-200, 1e-200, -1e200);
        assert!((x / 1e200 - 1.0).abs() < 1e-15 && (y / 1e200 + 1.0).abs() < 1e-15, "{x} {y}");
    }

    #[test]
    fn twice_the_precision_gives_twice_the_digits() {
        // x^2 - 2 x + 1 - 2^-80: 1 + 2^-40 and 1 - 2^-40.
        let one = DoubleDouble::ONE;
        let tiny = DoubleDouble::from_f64(2.0_f64.powi(-80));
        let [(x, p), (y, q)] = eigenvalues_2x2(one, tiny, one, one);
        let root = DoubleDouble::from_f64(2.0_f64.powi(-40));
        assert_eq!([x - one, y - one, p, q], [root, -root, DoubleDouble::ZERO, DoubleDouble::ZERO]);
    }
}
