//! Real roots against polynomials whose roots are known exactly.
mod support;

use eliminant::emitted::{Fixed, RealRoots, real_roots};
use support::Random;

/// Coefficients, lowest first, over the integers.
fn multiply(p: &[i128], q: &[i128]) -> Vec<i128> {
    let mut product = vec![0; p.len() + q.len() - 1];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    product
}

/// Value of the sum of |c_k| |x|^k, and of the derivative.
fn size_and_slope(c: &[f64], x: f64) -> (f64, f64) {
    let (mut size, mut value, mut slope) = (0.0, 0.0, 0.0);
    for &a in c.iter().rev() {
        size = size * x.abs() + a.abs();
        slope = slope * x + value;
        value = value * x + a;
    }
    (size, slope)
}

/// A polynomial with some real roots k/16 in [-2, 2], all different, and complex pairs on the same
/// grid; its coefficients are exact integers, rounded once.
struct Known<const D1: usize> {
    coefficients: [f64; D1],
    real: Vec<f64>,
    /// Imaginary parts, at these real parts.
    pairs: Vec<(f64, f64)>,
}

impl<const D1: usize> Known<D1> {
    fn random(random: &mut Random) -> Self {
        let degree = D1 - 1;
        let (mut product, mut real, mut pairs) = (vec![1_i128], Vec::new(), Vec::new());
        let count = random.below(degree / 2 + 1);
        for _ in 0..count {
            let (a, b) = (random.below(65) as i128 - 32, random.below(32) as i128 + 1);
            product = multiply(&product, &[a * a + b * b, -32 * a, 256]);
            pairs.push((a as f64 / 16.0, b as f64 / 16.0));
        }
        while product.len() < D1 {
            let k = random.below(65) as i128 - 32;
            if !real.contains(&(k as f64 / 16.0)) {
                real.push(k as f64 / 16.0);
                product = multiply(&product, &[-k, 16]);
            }
        }
        real.sort_by(f64::total_cmp);
        Known { coefficients: std::array::from_fn(|k| product[k] as f64), real, pairs }
    }

    /// How far rounding of the coefficients may move a simple root at x.
    fn spread(&self, x: f64) -> f64 {
        let (size, slope) = size_and_slope(&self.coefficients, x);
        f64::EPSILON * D1 as f64 * size / slope.abs()
    }

    /// Whether rounding of the coefficients leaves the real roots apart and the complex pairs
    /// complex.
    fn resolvable(&self) -> bool {
        let apart = self.real.iter().all(|&x| self.spread(x) < 1.0 / 64.0);
        let still_complex = self.pairs.iter().all(|&(re, im)| {
            // |p| at the real part is at least the product of distances; compared with its
            // rounding error.
            let (size, _) = size_and_slope(&self.coefficients, re);
            let value: f64 = self.real.iter().map(|x| (re - x).abs().max(im)).product::<f64>()
                * self.pairs.iter().map(|&(a, b)| (re - a).powi(2) + b * b).product::<f64>()
                * self.coefficients[D1 - 1].abs();
            f64::EPSILON * D1 as f64 * size < value / 64.0
        });
        apart && still_complex
    }
}

/// The real roots, ascending, and the result.
fn sorted<const D1: usize>(coefficients: &[f64; D1]) -> (Vec<f64>, RealRoots<Fixed<D1>>) {
    let found = real_roots(Fixed::<D1>, coefficients);
    let mut roots = found.roots.to_vec();
    roots.sort_by(f64::total_cmp);
    (roots, found)
}

/// How often the result is certain, and how often it is of polynomials that rounding leaves as they
/// are. A certain result must be right.
fn count_certain<const D1: usize>(seed: u64, trials: usize) -> [usize; 3] {
    let mut random = Random::new(seed);
    let (mut certain, mut certain_resolvable, mut resolvable) = (0, 0, 0);
    for _ in 0..trials {
        let known = Known::<D1>::random(&mut random);
        let (roots, found) = sorted(&known.coefficients);
        certain += usize::from(found.is_certain);
        if !known.resolvable() {
            continue;
        }
        resolvable += 1;
        if !found.is_certain {
            continue;
        }
        certain_resolvable += 1;
        assert_eq!(roots.len(), known.real.len(), "degree {}: {:?}", D1 - 1, known.coefficients);
        for (found, exact) in roots.iter().zip(&known.real) {
            let bound = 4.0 * known.spread(*exact) + 4.0 * f64::EPSILON * exact.abs();
            assert!((found - exact).abs() <= bound, "degree {}: {found} for {exact}", D1 - 1);
        }
    }
    println!(
        "degree {:2}: {certain} certain of {trials}, {certain_resolvable} of {resolvable} that can be told apart",
        D1 - 1
    );
    [certain, certain_resolvable, resolvable]
}

#[test]
fn certain_counts_are_right_for_every_degree_to_20() {
    let counts = [
        count_certain::<2>(1, 2_000),
        count_certain::<3>(2, 6_000),
        count_certain::<4>(3, 6_000),
        count_certain::<5>(4, 6_000),
        count_certain::<6>(5, 6_000),
        count_certain::<7>(6, 6_000),
        count_certain::<8>(7, 6_000),
        count_certain::<9>(8, 6_000),
        count_certain::<10>(9, 6_000),
        count_certain::<11>(10, 20_000),
        count_certain::<13>(12, 6_000),
        count_certain::<16>(15, 6_000),
        count_certain::<19>(18, 6_000),
        count_certain::<21>(20, 6_000),
    ];
    for (at, [_, certain, resolvable]) in counts.into_iter().enumerate() {
        assert!(resolvable > 300, "too few resolvable polynomials to mean anything");
        // Up to degree 15; above, 18 and more roots on [-2, 2] are close to each other.
        let share = if at < 12 { 97 } else { 85 };
        assert!(certain * 100 > resolvable * share, "{certain} of {resolvable} are certain");
    }
}

/// Of polynomials with random coefficients nearly all are certain, and their roots are sign
/// changes.
#[test]
fn random_polynomials_are_certain() {
    let mut random = Random::new(41);
    let (mut certain, mut roots, trials) = (0, 0, 20_000);
    for _ in 0..trials {
        let c: [f64; 11] = std::array::from_fn(|_| random.symmetric());
        let (found, result) = sorted(&c);
        certain += usize::from(result.is_certain);
        roots += found.len();
        let value = |x: f64| c.iter().rev().fold(0.0, |sum, c| sum * x + c);
        for x in found {
            assert!(value(x * (1.0 - 1e-9)) * value(x * (1.0 + 1e-9)) < 0.0, "{x} of {c:?}");
        }
    }
    println!("degree 10: {certain} of {trials} certain, {roots} roots");
    assert!(certain * 100 >= trials * 99, "{certain}");
    // Kac: 2/pi log 10 + 0.63 = 2.1 on average, for normal coefficients.
    assert!((roots as f64 / trials as f64 - 2.1).abs() < 0.3, "{roots}");
}

fn product<const D1: usize>(roots: &[f64]) -> [f64; D1] {
    let mut c = [0.0; D1];
    c[0] = 1.0;
    for (degree, root) in roots.iter().enumerate() {
        for k in (0..=degree + 1).rev() {
            c[k] = if k > 0 { c[k - 1] } else { 0.0 } - root * c[k];
        }
    }
    c
}

#[test]
fn units_do_not_matter() {
    for unit in [1e-150, 1e-30, 1e40, 1e150] {
        // x^3 - 6 x^2 + 11 x - 6 with x in units, coefficients far from 1 as well.
        let (roots, found) = sorted(&[-6.0 * unit, 11.0, -6.0 / unit, 1.0 / unit / unit]);
        assert!(found.is_certain && roots.len() == 3, "{unit}");
        for (found, exact) in roots.iter().zip([1.0, 2.0, 3.0]) {
            assert!((found / unit / exact - 1.0).abs() < 1e-14);
        }
    }
    let exact = [-1e4, -3e1, -1e-3, 2e-4, 0.7, 4e3];
    let (roots, found) = sorted(&product::<7>(&exact));
    assert!(found.is_certain && roots.len() == 6);
    assert!(roots.iter().zip(exact).all(|(found, exact)| (found / exact - 1.0).abs() < 1e-13), "{roots:?}");
}

/// Roots that are closer to each other than 2^-12 of the scaled variable, or pairs that close to
/// the real axis, are not certain.
#[test]
fn close_roots_are_not_certain() {
    let certain = |gap: f64| sorted(&product::<5>(&[-0.7, 0.5, 0.5 + gap, 2.5])).1.is_certain;
    assert_eq!([1e-2, 1e-3, 1e-5, 1e-7, 0.0].map(certain), [true, true, false, false, false]);
    // (x^2 + distance^2) (x - 2), moved by 0.3.
    let pair = |distance: f64| {
        let d = 0.09 + distance * distance;
        sorted(&[-2.0 * d, d + 1.2, -2.6, 1.0]).1.is_certain
    };
    assert_eq!([1e-1, 1e-2, 1e-5, 0.0].map(pair), [true, true, false, false]);
}

/// The clearance is the part by which coefficients may change before there is a root.
#[test]
fn without_roots_the_clearance_is_told() {
    for level in [1.0, 1e-2, 1e-4] {
        // (x - 0.6)^2 + level has no root.
        let (roots, found) = sorted(&[0.36 + level, -1.2, 1.0]);
        assert!(roots.is_empty() && found.is_certain, "{level}");
        assert!((0.1 * level..10.0 * level).contains(&found.clearance), "{level}: {}", found.clearance);
    }
}

#[test]
fn zero_roots_constants_and_bad_coefficients() {
    assert_eq!(sorted(&[0.0, -1.0, 2.0]).0, [0.0, 0.5]);
    assert!(sorted(&[0.0, -1.0, 2.0]).1.is_certain);
    assert_eq!(sorted(&[-2.0, 1.0, 0.0, 0.0]).0, [2.0]);
    assert!(!sorted(&[0.0, 0.0, -1.0, 2.0]).1.is_certain, "zero is a double root");
    for (coefficients, is_certain) in [([7.0, 0.0, 0.0], true), ([0.0; 3], false), ([1.0, 0.0, 1.0], true)] {
        let (roots, found) = sorted(&coefficients);
        assert!(roots.is_empty() && found.is_certain == is_certain, "{coefficients:?}");
    }
    assert!(!real_roots(Fixed::<0>, &[]).is_certain);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for k in 0..5 {
            let mut c = [1.0, -2.0, 3.0, 0.5, -1.0];
            c[k] = bad;
            let (roots, found) = sorted(&c);
            assert!(roots.is_empty() && !found.is_certain);
        }
    }
}
