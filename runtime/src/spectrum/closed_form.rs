//! The real roots of polynomials of degree 2 to 4, by factors of degree 2.
//!
//! ```text
//!   y^4 + a y^3 + b y^2 + c y + d = (y^2 + p1 y + q1) (y^2 + p2 y + q2),    theta = q1 + q2
//! ```
//!
//! With the roots y1 to y4, theta = y1 y2 + y3 y4 is a root of the resolvent cubic. Its largest
//! root belongs to factors that are real: of two conjugate pairs z and w, theta = |z|^2 + |w|^2 is
//! at least the other sums of products, 2 Re(z w) and 2 Re(z conj(w)).
//!
//! Closed forms lose digits to cancellation where roots differ much in size. They are therefore
//! starts of Newton's method on the polynomial itself, and they are used only if the product of the
//! factors is the polynomial, up to rounding, and if no factor is close to a double root.
//! Everything else is left to the isolation of roots.

use crate::number::float::sqrt;

/// The most roots, which are computed side by side.
const LANES: usize = 4;

/// The product of the factors may differ from the polynomial by this, relative to the sum of the
/// moduli of its terms.
const FACTORED: f64 = 1e-11;
/// A discriminant must exceed this, relative to the moduli of its terms. Errors of 1e-11 move two
/// roots by at most 3e-6 then, relative to a distance of 6e-3.
const CLEAR_DISCRIMINANT: f64 = 1e-5;
/// Two roots must be at least so far apart, relative to the larger one.
const CLEAR_DISTANCE: f64 = 1e-2;
/// A step of this size, relative to the root, is the last but one.
const SMALL_STEP: f64 = 1e-7;
/// A step of this size, relative to the root, is the last one.
const LAST_STEP: f64 = 1e-9;
/// The largest number of steps to a root of the resolvent: 4 or 5 are usual.
const MOST_STEPS: usize = 10;
/// Steps from a start that satisfies [`FACTORED`].
const POLISH_STEPS: usize = 3;

/// The real roots of a polynomial, all of them and simple.
pub(crate) struct FewRoots {
    /// The roots, then anything.
    pub(crate) roots: [f64; LANES],
    /// How many there are.
    pub(crate) count: usize,
    /// If there are none: relative errors of the coefficients below this make none.
    pub(crate) clearance: f64,
}

/// y^2 + p y + q
#[derive(Clone, Copy)]
struct Quadratic {
    p: f64,
    q: f64,
}

/// The real roots of c\[0\] + c\[1\] y + .. of degree 2 to 4, whose first and last coefficients are
/// not zero; `None` if they are not certain.
#[inline]
pub(crate) fn few_roots(c: &[f64]) -> Option<FewRoots> {
    let mut found = FewRoots { roots: [0.0; LANES], count: 0, clearance: 1.0 };
    match *c {
        [c0, c1, c2] => found.add(&Quadratic { p: c1 / c2, q: c0 / c2 })?,
        [c0, c1, c2, c3] => {
            let unit = 1.0 / c3;
            let (root, factor) = factors_of_cubic([c2 * unit, c1 * unit, c0 * unit])?;
            found.push(root);
            found.add(&factor)?;
        }
        [c0, c1, c2, c3, c4] => {
            let unit = 1.0 / c4;
            for factor in factors_of_quartic([c3 * unit, c2 * unit, c1 * unit, c0 * unit])? {
                found.add(&factor)?;
            }
        }
        _ => return None,
    }
    found.polish(c)?;
    found.is_separate().then_some(found)
}

impl FewRoots {
    /// The roots in the order of [`real_roots`](crate::spectrum::real_roots): those in (0, 1], from
    /// infinity to 1, then the same of -y.
    #[inline(always)]
    pub(crate) fn in_order(&mut self) -> &[f64] {
        let place = |y: f64| {
            let modulus = y.abs();
            let place = if modulus > 1.0 { 2.0 + 1.0 / modulus } else { modulus };
            if y < 0.0 { 4.0 + place } else { place }
        };
        let roots = &mut self.roots[..self.count.min(LANES)];
        for last in 1..roots.len() {
            for at in (1..last + 1).rev() {
                if place(roots[at]) < place(roots[at - 1]) {
                    roots.swap(at, at - 1);
                }
            }
        }
        roots
    }

    #[inline(always)]
    fn push(&mut self, root: f64) {
        self.roots[self.count % LANES] = root;
        self.count += 1;
    }

    /// Adds the real roots of a factor; `None` if it is close to a double root.
    #[inline(always)]
    fn add(&mut self, &Quadratic { p, q }: &Quadratic) -> Option<()> {
        let (square, product) = (p * p, 4.0 * q);
        let discriminant = square - product;
        if !(discriminant.abs() > CLEAR_DISCRIMINANT * (square + product.abs())) {
            return None;
        }
        if discriminant > 0.0 {
            let larger = -0.5 * (p + sqrt(discriminant).copysign(p));
            self.push(larger);
            self.push(q / larger);
        } else {
            // The least value of y^2 + p y + q, relative to y^2 + |p y| + q: at |y| = sqrt(q).
            let twice = 2.0 * sqrt(q);
            self.clearance *= (twice - p.abs()) / (twice + p.abs());
        }
        Some(())
    }

    /// Newton's method on the polynomial, for all roots side by side.
    #[inline(always)]
    fn polish(&mut self, c: &[f64]) -> Option<()> {
        for lane in self.count..LANES {
            self.roots[lane] = self.roots[0];
        }
        for _ in 0..if self.count == 0 { 0 } else { POLISH_STEPS } {
            let (mut value, mut slope) = ([c[c.len() - 1]; LANES], [0.0; LANES]);
            for &c in c[..c.len() - 1].iter().rev() {
                for lane in 0..LANES {
                    slope[lane] = slope[lane] * self.roots[lane] + value[lane];
                    value[lane] = value[lane] * self.roots[lane] + c;
                }
            }
            let mut is_done = true;
            for lane in 0..LANES {
                let step = value[lane] / slope[lane];
                self.roots[lane] -= step;
                is_done &= step.abs() <= LAST_STEP * self.roots[lane].abs();
            }
            if is_done {
                return Some(());
            }
        }
        (self.count == 0).then_some(())
    }

    #[inline(always)]
    fn is_separate(&self) -> bool {
        let roots = &self.roots[..self.count.min(LANES)];
        let is_apart = |a: f64, b: f64| (a - b).abs() > CLEAR_DISTANCE * a.abs().max(b.abs());
        roots.iter().all(|root| root.is_finite())
            && (1..roots.len()).all(|i| roots[..i].iter().all(|&other| is_apart(roots[i], other)))
    }
}

/// The largest real root of x^3 + g x + h, by Newton's method from above, where the cubic is
/// convex; `None` if it does not converge, as to a double root.
#[inline(always)]
fn largest_root(g: f64, h: f64) -> Option<f64> {
    /// Added to a third of the bits of a number, the bits of its cube root, up to six percent: two
    /// thirds of those of 1.
    const CUBE_ROOT: u64 = 0x2a9f_7893_782d_a1ce;
    const SQRT_3: f64 = 1.732_050_807_568_877_2;
    let turn = sqrt((-g / 3.0).max(0.0));
    let (half, cube) = (0.5 * h, turn * turn * turn);
    let has_three = half.abs() <= cube && cube > 0.0;
    // The tangent of the largest root as a function of h, at h = 0, where the root is sqrt(3) turn.
    // The root is concave there. If there is only one root, it is that of x^3 + g x - |h|, or minus
    // that, and at most the cube root of |h| plus the turn.
    let (mut x, h, sign) = match has_three {
        true => (turn * (SQRT_3 - half / (3.0 * cube)), h, 1.0),
        false => (f64::from_bits(h.abs().to_bits() / 3 + CUBE_ROOT) + turn, -h.abs(), -h.signum()),
    };
    for _ in 0..MOST_STEPS {
        let square = x * x;
        let step = ((square + g) * x + h) / (3.0 * square + g);
        x -= step;
        if step.abs() <= SMALL_STEP * x {
            return Some(sign * x);
        }
    }
    None
}

/// The largest root of y^3 + a y^2 + b y + c, and the other factor.
#[inline(always)]
fn factors_of_cubic([a, b, c]: [f64; 3]) -> Option<(f64, Quadratic)> {
    let third = a / 3.0;
    let g = b - a * third;
    let h = third * (2.0 * third * third - b) + c;
    let root = largest_root(g, h)? - third;
    let (p, q) = (a + root, -c / root);
    let product = [(p - root, a, p.abs() + root.abs()), (q - root * p, b, q.abs() + (root * p).abs())];
    is_product(&product).then_some((root, Quadratic { p, q }))
}

/// Two real factors of y^4 + a y^3 + b y^2 + c y + d.
#[inline(always)]
fn factors_of_quartic([a, b, c, d]: [f64; 4]) -> Option<[Quadratic; 2]> {
    let (third, product) = (b / 3.0, a * c - 4.0 * d);
    let g = product - b * third;
    let h = third * (product + 12.0 * d - 2.0 * third * third) - a * a * d - c * c;
    let theta = largest_root(g, h)? + third;
    let (middle, centre) = (0.5 * a, 0.5 * theta);
    // p1, p2 = middle +- r and q1, q2 = centre -+ s; r s = (c - a centre) / 2 up to the sign.
    let (of_sums, of_products) = (middle * middle - b + theta, centre * centre - d);
    let mixed = 0.5 * c - middle * centre;
    let relative = |difference: f64, terms: f64| difference / terms;
    let sums_are_clearer =
        relative(of_sums, middle * middle + b.abs() + theta.abs()) >= relative(of_products, centre * centre + d.abs());
    let (r, s) = match sums_are_clearer {
        true => {
            let r = sqrt(of_sums.max(0.0));
            (r, mixed / r)
        }
        false => {
            let s = sqrt(of_products.max(0.0));
            (mixed / s, s)
        }
    };
    let [first, second] = [Quadratic { p: middle + r, q: centre - s }, Quadratic { p: middle - r, q: centre + s }];
    let (cross, other) = (first.p * second.q, second.p * first.q);
    let product = [
        (first.q + second.q + first.p * second.p, b, first.q.abs() + second.q.abs() + (first.p * second.p).abs()),
        (cross + other, c, cross.abs() + other.abs()),
        (first.q * second.q, d, d.abs()),
    ];
    is_product(&product).then_some([first, second])
}

/// Whether the sums of terms are the coefficients. The moduli of the terms come with them.
#[inline(always)]
fn is_product(coefficients: &[(f64, f64, f64)]) -> bool {
    coefficients.iter().all(|&(sum, wanted, terms)| (sum - wanted).abs() <= FACTORED * terms)
}

#[cfg(test)]
mod tests {
    use rand_xoshiro::Xoshiro256PlusPlus;
    use rand_xoshiro::rand_core::{Rng, SeedableRng};

    use super::*;

    /// In [-1, 1).
    fn uniform(random: &mut Xoshiro256PlusPlus) -> f64 {
        (random.next_u64() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// The product of real roots and conjugate pairs, lowest coefficient first.
    fn expanded(roots: &[f64], pairs: &[(f64, f64)]) -> ([f64; 5], usize) {
        let (mut product, mut degree) = ([1.0, 0.0, 0.0, 0.0, 0.0], 0);
        let factors = roots.iter().map(|&root| [-root, 1.0, 0.0]);
        let factors = factors.chain(pairs.iter().map(|&(re, im)| [re * re + im * im, -2.0 * re, 1.0]));
        for factor in factors {
            let before = product;
            product = core::array::from_fn(|k| (0..3.min(k + 1)).map(|j| factor[j] * before[k - j]).sum());
            degree += if factor[2] == 0.0 { 1 } else { 2 };
        }
        (product, degree)
    }

    #[test]
    fn roots_are_those_of_the_factors() {
        let mut random = Xoshiro256PlusPlus::seed_from_u64(1);
        for (real, pairs) in [(2, 0), (0, 1), (3, 0), (1, 1), (4, 0), (2, 1), (0, 2)] {
            let (mut found, trials) = (0, 10_000);
            for _ in 0..trials {
                let mut wanted: [f64; 4] = core::array::from_fn(|_| uniform(&mut random));
                let of_pairs: [_; 2] = core::array::from_fn(|_| (uniform(&mut random), uniform(&mut random)));
                let wanted = &mut wanted[..real];
                let (c, degree) = expanded(wanted, &of_pairs[..pairs]);
                let Some(few) = few_roots(&c[..=degree]) else { continue };
                found += 1;
                let mut roots = few.roots;
                let roots = &mut roots[..few.count];
                assert_eq!(roots.len(), wanted.len(), "{c:?}");
                roots.sort_by(f64::total_cmp);
                wanted.sort_by(f64::total_cmp);
                for (root, wanted) in roots.iter().zip(wanted) {
                    // Roots are at least a part of 1e-2 apart; rounding of coefficients moves them.
                    assert!((*root - *wanted).abs() < 1e-8, "{root} for {wanted} of {c:?}");
                }
            }
            assert!(found > trials * 8 / 10, "{found} of {trials} with {real} real roots and {pairs} pairs");
        }
    }

    #[test]
    fn double_roots_and_nearly_real_pairs_are_not_certain() {
        for (roots, pairs) in [
            (&[0.5, 0.5][..], &[][..]),
            (&[0.5, 0.5 + 1e-4], &[]),
            (&[], &[(0.5, 1e-4)]),
            (&[0.5, 0.5, -0.3], &[]),
            (&[0.25, 0.25 - 1e-5, -0.3, 0.7], &[]),
            (&[0.5, -0.3], &[(0.2, 1e-4)]),
            (&[], &[(0.2, 1e-4), (0.2, 1e-4)]),
            (&[0.5; 4], &[]),
        ] {
            let (c, degree) = expanded(roots, pairs);
            assert!(few_roots(&c[..=degree]).is_none(), "{roots:?} {pairs:?}");
        }
    }

    #[test]
    fn extreme_coefficients_are_refused_or_solved() {
        let values = [0.0, 1.0, -1.0, 1e-160, 1e160, f64::MAX, f64::MIN_POSITIVE, f64::NAN, f64::INFINITY];
        for at in 0..values.len().pow(3) {
            let value = |digit: u32| values[at / values.len().pow(digit) % values.len()];
            for c in [&[1.0, value(0), value(1), value(2), -2.0][..], &[value(0), value(1), 3.0, value(2)]] {
                if let Some(few) = few_roots(c) {
                    assert!(few.count < c.len() && few.roots[..few.count].iter().all(|root| root.is_finite()));
                }
            }
        }
    }

    #[test]
    fn without_roots_smaller_errors_make_none() {
        let mut random = Xoshiro256PlusPlus::seed_from_u64(2);
        for _ in 0..1000 {
            let pairs: [_; 2] = core::array::from_fn(|_| (uniform(&mut random), uniform(&mut random)));
            let (c, _) = expanded(&[], &pairs);
            let Some(few) = few_roots(&c) else { continue };
            assert!(few.count == 0 && few.clearance > 0.0 && few.clearance <= 1.0);
            // The least |f| relative to the sum of the moduli of its terms is at least that.
            for step in -400..=400 {
                let y = f64::from(step) * 0.01;
                let (value, size) = c.iter().rev().fold((0.0, 0.0), |(v, s), &c| (v * y + c, s * y.abs() + c.abs()));
                assert!(value > 0.99 * few.clearance * size, "{c:?} at {y}");
            }
        }
    }
}
