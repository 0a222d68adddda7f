//! The prime field Z_p, p below 2^31.
//!
//! Elements are `u32` in `0..p`. A product of two fits a `u64` with two bits to spare, so that sums
//! of products can be reduced modulo p late (see [`super::Echelon`]).

/// Primes just below 2^31, largest first. Searches use the first, checks the others.
pub const PRIMES: [u32; 6] = [2147483647, 2147483629, 2147483587, 2147483579, 2147483563, 2147483549];

/// The field of integers modulo a prime p < 2^31.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PrimeField {
    modulus: u32,
    /// floor(2^64 / p), for division by multiplication (Barrett).
    reciprocal: u64,
}

impl PrimeField {
    /// The field with `prime` elements. `prime` must be a prime below 2^31, such as one of
    /// [`PRIMES`].
    pub const fn new(prime: u32) -> Self {
        assert!(prime > 2 && prime < 1 << 31);
        Self { modulus: prime, reciprocal: u64::MAX / prime as u64 }
    }

    /// The prime p.
    pub const fn modulus(self) -> u32 {
        self.modulus
    }

    /// The image of an integer.
    pub const fn from_integer(self, value: i64) -> u32 {
        value.rem_euclid(self.modulus as i64) as u32
    }

    /// The image of an unsigned integer.
    #[inline]
    pub const fn reduce(self, value: u64) -> u32 {
        // The estimated quotient is at most one too small, and the remainder then below 2p < 2^32.
        let quotient = ((value as u128 * self.reciprocal as u128) >> 64) as u64;
        let remainder = (value - quotient * self.modulus as u64) as u32;
        if remainder >= self.modulus { remainder - self.modulus } else { remainder }
    }

    /// a + b.
    #[inline]
    pub const fn add(self, a: u32, b: u32) -> u32 {
        let sum = a + b;
        if sum >= self.modulus { sum - self.modulus } else { sum }
    }

    /// a - b.
    #[inline]
    pub const fn sub(self, a: u32, b: u32) -> u32 {
        if a >= b { a - b } else { a + self.modulus - b }
    }

    /// -a.
    #[inline]
    pub const fn neg(self, a: u32) -> u32 {
        if a == 0 { 0 } else { self.modulus - a }
    }

    /// a b.
    #[inline]
    pub const fn mul(self, a: u32, b: u32) -> u32 {
        self.reduce(a as u64 * b as u64)
    }

    /// a += factor b, entry by entry.
    ///
    /// The quotient of factor * b by p is estimated by floor(factor 2^32 / p) b / 2^32 (Shoup): one
    /// precomputed value for all entries, and 32-bit steps that a compiler can vectorise.
    pub fn add_multiple(self, a: &mut [u32], factor: u32, b: &[u32]) {
        let p = self.modulus;
        let ratio = ((u64::from(factor) << 32) / u64::from(p)) as u32;
        // From -p..p to 0..p.
        let wrap = |value: i32| value.wrapping_add(p as i32 & (value >> 31));
        for (a, &b) in a.iter_mut().zip(b) {
            let quotient = ((u64::from(ratio) * u64::from(b)) >> 32) as u32;
            // The quotient is at most one too small: the product is below 2p < 2^32.
            let product = factor.wrapping_mul(b).wrapping_sub(quotient.wrapping_mul(p));
            let product = wrap(product.wrapping_sub(p) as i32);
            *a = wrap((*a as i32).wrapping_add(product).wrapping_sub(p as i32)) as u32;
        }
    }

    /// The sum of the products of values at the same position, as far as both lists go.
    pub fn dot(self, a: &[u32], b: &[u32]) -> u32 {
        let square = u64::from(self.modulus).pow(2);
        // The sum stays below p^2 < 2^62: one reduction modulo p, at the end.
        let mut sum = 0u64;
        for (&a, &b) in a.iter().zip(b) {
            sum += u64::from(a) * u64::from(b);
            if sum >= square {
                sum -= square;
            }
        }
        self.reduce(sum)
    }

    /// a^n, with 0^0 = 1.
    pub const fn pow(self, mut a: u32, mut n: u32) -> u32 {
        let mut result = 1;
        while n > 0 {
            if n & 1 == 1 {
                result = self.mul(result, a);
            }
            a = self.mul(a, a);
            n >>= 1;
        }
        result
    }

    /// The smaller square root, if `a` has one (Shanks, "Five number-theoretic algorithms", 1973).
    pub fn square_root(self, a: u32) -> Option<u32> {
        let (half, a) = ((self.modulus - 1) / 2, self.reduce(u64::from(a)));
        if a == 0 {
            return Some(0);
        }
        if self.pow(a, half) != 1 {
            return None;
        }
        // p - 1 = odd 2^twos, and the powers of `unit` are the elements of an order of a power of
        // 2.
        let twos = (self.modulus - 1).trailing_zeros();
        let odd = (self.modulus - 1) >> twos;
        let unit = (2..).find(|&candidate| self.pow(candidate, half) != 1).map_or(1, |n| self.pow(n, odd));
        // root^2 = a rest, where the order of the rest is a power of 2 that falls.
        let (mut root, mut rest) = (self.pow(a, odd.div_ceil(2)), self.pow(a, odd));
        let (mut unit, mut twos) = (unit, twos);
        while rest != 1 {
            let order = (1..twos).find(|&order| self.pow(rest, 1 << order) == 1)?;
            let factor = self.pow(unit, 1 << (twos - order - 1));
            root = self.mul(root, factor);
            unit = self.mul(factor, factor);
            rest = self.mul(rest, unit);
            twos = order;
        }
        Some(root.min(self.modulus - root))
    }

    /// 1 / a, or `None` for a = 0.
    pub const fn inverse(self, a: u32) -> Option<u32> {
        // Extended Euclid on (p, a), keeping only the cofactor of a.
        let (mut r0, mut r1) = (self.modulus as i64, a as i64);
        let (mut t0, mut t1) = (0i64, 1i64);
        while r1 != 0 {
            let quotient = r0 / r1;
            (r0, r1) = (r1, r0 - quotient * r1);
            (t0, t1) = (t1, t0 - quotient * t1);
        }
        if r0 == 1 { Some(self.from_integer(t0)) } else { None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_listed_primes_are_prime() {
        for p in PRIMES {
            assert!((2u64..).take_while(|d| d * d <= u64::from(p)).all(|d| u64::from(p) % d != 0), "{p}");
        }
    }

    #[test]
    fn half_of_all_elements_have_square_roots() {
        for p in PRIMES {
            let field = PrimeField::new(p);
            let mut found = 0;
            for a in (0..1000).chain(p - 1000..p) {
                if let Some(root) = field.square_root(a) {
                    assert_eq!(field.mul(root, root), a, "{a} modulo {p}");
                    found += 1;
                }
                let square = field.mul(a, a);
                assert_eq!(field.square_root(square), Some(a.min((p - a) % p)), "{a} modulo {p}");
            }
            assert!((900..1100).contains(&found), "{found} of 2000 modulo {p}");
        }
    }

    #[test]
    fn multiples_are_added_entry_by_entry() {
        for p in PRIMES {
            let field = PrimeField::new(p);
            let values = [0, 1, 2, 65537, p / 2, p - 2, p - 1];
            for factor in values {
                for start in values {
                    let mut sums = [start; 7];
                    field.add_multiple(&mut sums, factor, &values);
                    assert_eq!(sums, values.map(|value| field.add(start, field.mul(factor, value))));
                }
            }
        }
    }

    #[test]
    fn dot_products_are_sums_of_products() {
        for p in PRIMES {
            let field = PrimeField::new(p);
            let values = [p - 1, 1, p - 2, 65537, 0, p / 2, p - 1, p - 1];
            let sum = values.iter().fold(0, |sum, &value| field.add(sum, field.mul(value, value)));
            assert_eq!(field.dot(&values, &values), sum);
            assert_eq!(field.dot(&values, &[]), 0);
        }
    }

    #[test]
    fn inverses_invert() {
        for p in PRIMES {
            let field = PrimeField::new(p);
            assert_eq!(field.inverse(0), None);
            for a in [1, 2, 3, 65537, p - 1, p / 2] {
                assert_eq!(field.mul(a, field.inverse(a).unwrap()), 1);
            }
        }
    }
}
