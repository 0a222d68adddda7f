//! Real roots against polynomials whose roots are known exactly.
mod support;

use eliminant::emitted::{Fixed, Hessenberg, real_roots, real_roots_monic};
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

/// Wrong counts among all and among resolvable ones, and how many were resolvable.
fn count_wrong<const D1: usize>(seed: u64, trials: usize) -> [usize; 3] {
    let mut random = Random::new(seed);
    let (mut wrong, mut wrong_resolvable, mut resolvable) = (0, 0, 0);
    for _ in 0..trials {
        let known = Known::<D1>::random(&mut random);
        let roots = real_roots(&known.coefficients);
        let right = roots.len() == known.real.len();
        wrong += usize::from(!right);
        if known.resolvable() {
            resolvable += 1;
            wrong_resolvable += usize::from(!right);
            if right {
                for (found, exact) in roots.iter().zip(&known.real) {
                    let bound = 4.0 * known.spread(*exact) + 4.0 * f64::EPSILON * exact.abs();
                    assert!((found - exact).abs() <= bound, "degree {}: {found} for {exact}", D1 - 1);
                }
            }
        }
    }
    println!("degree {:2}: {wrong} wrong of {trials}, {wrong_resolvable} of {resolvable} resolvable", D1 - 1);
    [wrong, wrong_resolvable, resolvable]
}

#[test]
fn counts_are_right_for_every_degree_to_20() {
    let counts = [
        count_wrong::<2>(1, 2_000),
        count_wrong::<3>(2, 6_000),
        count_wrong::<4>(3, 6_000),
        count_wrong::<5>(4, 6_000),
        count_wrong::<6>(5, 6_000),
        count_wrong::<7>(6, 6_000),
        count_wrong::<8>(7, 6_000),
        count_wrong::<9>(8, 6_000),
        count_wrong::<10>(9, 6_000),
        count_wrong::<11>(10, 20_000),
        count_wrong::<12>(11, 6_000),
        count_wrong::<13>(12, 6_000),
        count_wrong::<14>(13, 6_000),
        count_wrong::<15>(14, 6_000),
        count_wrong::<16>(15, 6_000),
        count_wrong::<17>(16, 6_000),
        count_wrong::<18>(17, 6_000),
        count_wrong::<19>(18, 6_000),
        count_wrong::<20>(19, 6_000),
        count_wrong::<21>(20, 6_000),
    ];
    for (k, [_, wrong, resolvable]) in counts.iter().enumerate() {
        assert_eq!(*wrong, 0, "degree {}", k + 1);
        assert!(*resolvable > 300, "degree {}: too few resolvable polynomials to mean anything", k + 1);
    }
    // To degree 8 rounding spoils none.
    assert!(counts[..8].iter().all(|[wrong, ..]| *wrong == 0));
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
fn wilkinson() {
    // To 13 the coefficients are exact in f64 and the roots well enough separated.
    let exact: Vec<f64> = (1..=13).map(f64::from).collect();
    let c: [f64; 14] = product(&exact);
    let roots = real_roots(&c);
    assert_eq!(roots.len(), 13);
    for (found, exact) in roots.iter().zip(&exact) {
        let (size, slope) = size_and_slope(&c, *exact);
        assert!((found - exact).abs() <= 14.0 * f64::EPSILON * size / slope.abs());
    }
}

#[test]
fn roots_of_very_different_sizes() {
    let exact = [-1e12, -3e5, -1e-9, 2e-14, 1.0, 4e8];
    let roots = real_roots(&product::<7>(&exact));
    assert_eq!(roots.len(), exact.len());
    for (found, exact) in roots.iter().zip(exact) {
        assert!((found / exact - 1.0).abs() < 1e-14, "{found} for {exact}");
    }
    for unit in [1e-150, 1e-30, 1e40, 1e150] {
        // x^3 - 6 x^2 + 11 x - 6 with x in units, coefficients far from 1 as well.
        let c = [-6.0 * unit, 11.0, -6.0 / unit, 1.0 / unit / unit];
        let roots = real_roots(&c);
        assert_eq!(roots.len(), 3, "{unit}");
        for (found, exact) in roots.iter().zip([1.0, 2.0, 3.0]) {
            assert!((found / unit / exact - 1.0).abs() < 1e-14);
        }
    }
}

#[test]
fn vanishing_leading_coefficients_lower_the_degree() {
    assert_eq!(real_roots(&[-2.0, 1.0, 0.0, 0.0]).as_slice(), [2.0]);
    assert_eq!(real_roots(&[-2.0, 1.0, 1e-30]).as_slice(), [2.0]);
    let near = real_roots(&[6.0, -5.0, 1.0, 1e-40, -1e-40]);
    assert_eq!(near.len(), 2);
    assert!((near[0] - 2.0).abs() < 1e-14 && (near[1] - 3.0).abs() < 1e-14);
    // Small, but its root is in reach of the others.
    let far = real_roots(&[-2.0, 1.0, 1e-12]);
    assert_eq!(far.len(), 2);
    assert!((far[0] / -1e12 - 1.0).abs() < 1e-11 && (far[1] - 2.0).abs() < 1e-11);
    // Widely spread roots are roots, however small the leading coefficient looks: 1e6 five times
    // apart.
    let exact = [1.0, 1e6, 1e12, 1e18];
    let roots = real_roots(&product::<5>(&exact).map(|c| c * 1e-40));
    assert_eq!(roots.len(), 4);
}

#[test]
fn zero_roots_constants_and_bad_coefficients() {
    assert_eq!(real_roots(&[0.0, 0.0, -1.0, 1.0]).as_slice(), [0.0, 1.0]);
    assert_eq!(real_roots(&[0.0, 0.0, 0.0, 5.0]).as_slice(), [0.0]);
    assert!(real_roots::<0>(&[]).is_empty());
    assert!(real_roots(&[7.0]).is_empty());
    assert!(real_roots(&[0.0; 6]).is_empty());
    assert!(real_roots(&[1.0, 0.0, 0.0, 0.0]).is_empty());
    assert!(real_roots(&[1.0, 0.0, 1.0]).is_empty());
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for k in 0..5 {
            let mut c = [1.0, -2.0, 3.0, 0.5, -1.0];
            c[k] = bad;
            assert!(real_roots(&c).is_empty());
            let mut lower = [1.0, -2.0, 3.0, 0.5];
            lower[k % 4] = bad;
            assert!(real_roots_monic(Fixed::<4>, &lower).is_empty());
        }
    }
    assert!(real_roots_monic(Fixed::<0>, &[]).is_empty());
}

#[test]
fn multiple_roots_are_not_lost() {
    // A double root at every k/16 of [-2, 2], 1 and -1 among them, with simple and complex company.
    for k in -32..=32_i128 {
        let c = multiply(&multiply(&[-k, 16], &[-k, 16]), &multiply(&[-53, 16], &[2, 2, 1]));
        let c: [f64; 6] = std::array::from_fn(|i| c[i] as f64);
        let exact = k as f64 / 16.0;
        let roots = real_roots(&c);
        assert!(roots.iter().any(|x| (x - exact).abs() < 1e-7), "{k}: {roots:?}");
        assert!(roots.iter().any(|x| (x - 53.0 / 16.0).abs() < 1e-12), "{k}: {roots:?}");
        assert!(roots.iter().all(|x| (x - exact).abs() < 1e-7 || (x - 53.0 / 16.0).abs() < 1e-12), "{k}: {roots:?}");
    }
    // (x - 1)^5: every root returned is near 1, and there is one.
    let roots = real_roots(&[-1.0, 5.0, -10.0, 10.0, -5.0, 1.0]);
    assert!(!roots.is_empty() && roots.iter().all(|x| (x - 1.0).abs() < 2e-3), "{roots:?}");
    assert_eq!(real_roots(&[1.0, -2.0, 1.0]).as_slice(), [1.0]);
}

#[test]
fn clusters_come_apart_when_they_can() {
    for gap in [1e-2, 1e-3, 1e-4, 1e-5] {
        let exact = [-0.7, 0.5, 0.5 + gap, 2.5];
        let roots = real_roots(&product::<5>(&exact));
        assert_eq!(roots.len(), 4, "{gap}");
        for (found, exact) in roots.iter().zip(exact) {
            assert!((found - exact).abs() < 1e-14 / gap);
        }
    }
}

#[test]
fn monic_and_general_agree() {
    let mut random = Random::new(40);
    for _ in 0..1_000 {
        let lower: [f64; 9] = std::array::from_fn(|_| random.symmetric());
        let mut all = [1.0; 10];
        all[..9].copy_from_slice(&lower);
        assert_eq!(real_roots_monic(Fixed::<9>, &lower).as_slice(), real_roots(&all).as_slice());
    }
}

#[test]
fn real_eigenvalues_by_the_characteristic_polynomial() {
    let mut random = Random::new(41);
    let (mut different, trials) = (0, 5_000);
    for _ in 0..trials {
        let h = Hessenberg::reduce(&random.matrix::<10, 10>()).unwrap();
        let mut by_iteration: Vec<f64> =
            h.eigenvalues().unwrap().iter().filter(|v| v.im == 0.0).map(|v| v.re).collect();
        by_iteration.sort_by(f64::total_cmp);
        let by_roots = real_roots_monic(Fixed::<10>, &h.characteristic_polynomial());
        let same = by_roots.len() == by_iteration.len()
            && by_roots.iter().zip(&by_iteration).all(|(x, y)| (x - y).abs() < 1e-6);
        different += usize::from(!same);
    }
    // Two real eigenvalues, or a pair of complex ones, within 1e-6 of each other are that rare.
    println!("10 x 10: {different} of {trials} differ");
    assert!(different <= trials / 1000, "{different}");
}
