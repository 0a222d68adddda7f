//! Polynomials in one indeterminate t over Z_p.

use super::PrimeField;

/// c_0 + c_1 t + .. + c_d t^d by its coefficients, the constant one first.
///
/// The last coefficient is not 0, so that equal polynomials have equal coefficients; 0 has none.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Univariate {
    coefficients: Vec<u32>,
}

impl Univariate {
    /// The polynomial 0.
    pub const ZERO: Self = Self { coefficients: Vec::new() };

    /// The polynomial with these coefficients, the constant one first. Zeros at the end are
    /// dropped.
    pub fn new(mut coefficients: Vec<u32>) -> Self {
        while coefficients.last() == Some(&0) {
            coefficients.pop();
        }
        Self { coefficients }
    }

    /// A constant.
    pub fn constant(value: u32) -> Self {
        Self::new(vec![value])
    }

    /// The indeterminate t.
    pub fn t() -> Self {
        Self { coefficients: vec![0, 1] }
    }

    /// The coefficients, the constant one first.
    pub fn coefficients(&self) -> &[u32] {
        &self.coefficients
    }

    /// The coefficient of t^exponent.
    pub fn coefficient(&self, exponent: usize) -> u32 {
        self.coefficients.get(exponent).copied().unwrap_or(0)
    }

    /// Whether this is 0.
    pub fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }

    /// The degree; 0 for the polynomial 0.
    pub fn degree(&self) -> usize {
        self.coefficients.len().saturating_sub(1)
    }

    /// c self.
    #[must_use]
    pub fn scaled(&self, field: PrimeField, c: u32) -> Self {
        Self::new(self.coefficients.iter().map(|&value| field.mul(value, c)).collect())
    }

    /// self += c t^shift other.
    pub fn add_multiple(&mut self, field: PrimeField, (c, shift): (u32, usize), other: &Self) {
        let length = self.coefficients.len().max(shift + other.coefficients.len());
        self.coefficients.resize(length, 0);
        field.add_multiple(&mut self.coefficients[shift..], c, &other.coefficients);
        *self = Self::new(std::mem::take(&mut self.coefficients));
    }

    /// The product.
    #[must_use]
    pub fn times(&self, field: PrimeField, other: &Self) -> Self {
        let (a, b) = (&self.coefficients, &other.coefficients);
        let square = u64::from(field.modulus()).pow(2);
        // Sums stay below p^2 < 2^62: one reduction modulo p for each coefficient, at the end.
        let mut sums = vec![0u64; (a.len() + b.len()).saturating_sub(1)];
        for (shift, &factor) in a.iter().enumerate().filter(|&(_, &factor)| factor != 0) {
            for (sum, &value) in sums[shift..].iter_mut().zip(b) {
                let next = *sum + u64::from(factor) * u64::from(value);
                *sum = if next >= square { next - square } else { next };
            }
        }
        Self::new(sums.into_iter().map(|sum| field.reduce(sum)).collect())
    }

    /// Quotient and remainder; the quotient by 0 is 0.
    pub fn divided_by(&self, field: PrimeField, divisor: &Self) -> (Self, Self) {
        let mut remainder = self.coefficients.clone();
        let mut quotient = vec![0; (remainder.len() + 1).saturating_sub(divisor.coefficients.len())];
        let Some(inverse) = divisor.coefficients.last().and_then(|&leading| field.inverse(leading)) else {
            return (Self::ZERO, self.clone());
        };
        for (shift, target) in quotient.iter_mut().enumerate().rev() {
            let leading = remainder[shift + divisor.degree()];
            if leading != 0 {
                *target = field.mul(leading, inverse);
                field.add_multiple(&mut remainder[shift..], field.neg(*target), &divisor.coefficients);
            }
        }
        (Self::new(quotient), Self::new(remainder))
    }

    /// The remainder of the division by a polynomial.
    #[must_use]
    pub fn modulo(&self, field: PrimeField, modulus: &Self) -> Self {
        self.divided_by(field, modulus).1
    }

    /// The quotient, where the division leaves no remainder.
    #[must_use]
    pub fn over(&self, field: PrimeField, divisor: &Self) -> Self {
        self.divided_by(field, divisor).0
    }

    /// The multiple with leading coefficient 1; 0 for 0.
    #[must_use]
    pub fn monic(&self, field: PrimeField) -> Self {
        let leading = self.coefficients.last().and_then(|&leading| field.inverse(leading));
        leading.map_or(Self::ZERO, |inverse| self.scaled(field, inverse))
    }

    /// The monic greatest common divisor, by Euclid's algorithm; 0 if both are 0.
    #[must_use]
    pub fn gcd(&self, field: PrimeField, other: &Self) -> Self {
        let (mut a, mut b) = (self.clone(), other.clone());
        while !b.is_zero() {
            let remainder = a.modulo(field, &b);
            (a, b) = (b, remainder);
        }
        a.monic(field)
    }

    /// 1 / self modulo a polynomial; `None` if the two have a common factor.
    pub fn inverse_modulo(&self, field: PrimeField, modulus: &Self) -> Option<Self> {
        // Extended Euclid on (modulus, self). Each remainder is a multiple of self modulo the
        // modulus; only the factors by which self is multiplied are kept.
        let (mut a, mut b) = (modulus.clone(), self.modulo(field, modulus));
        let (mut of_a, mut of_b) = (Self::ZERO, Self::constant(1));
        while !b.is_zero() {
            let (quotient, remainder) = a.divided_by(field, &b);
            let product = quotient.times(field, &of_b);
            of_a.add_multiple(field, (field.neg(1), 0), &product);
            (a, b) = (b, remainder);
            (of_a, of_b) = (of_b, of_a);
        }
        match a.coefficients.as_slice() {
            &[constant] => Some(of_a.scaled(field, field.inverse(constant)?).modulo(field, modulus)),
            _ => None,
        }
    }

    /// The derivative by t.
    #[must_use]
    pub fn derivative(&self, field: PrimeField) -> Self {
        let terms = self.coefficients.iter().enumerate().skip(1);
        Self::new(terms.map(|(exponent, &value)| field.mul(field.from_integer(exponent as i64), value)).collect())
    }

    /// The product of the different irreducible factors, each once, for a degree below p.
    ///
    /// With f = product of f_i^e_i the derivative f' holds each f_i just e_i - 1 times, because e_i
    /// is not divisible by p. So f / gcd(f, f') holds each once.
    #[must_use]
    pub fn squarefree_part(&self, field: PrimeField) -> Self {
        let repeated = self.gcd(field, &self.derivative(field));
        self.over(field, &repeated).monic(field)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{PRIMES, Random};

    const F: PrimeField = PrimeField::new(PRIMES[0]);

    fn of(coefficients: &[i64]) -> Univariate {
        Univariate::new(coefficients.iter().map(|&value| F.from_integer(value)).collect())
    }

    fn random(random: &mut Random, degree: usize) -> Univariate {
        Univariate::new((0..=degree).map(|_| random.below(u64::from(F.modulus())) as u32).collect())
    }

    #[test]
    fn products_are_those_by_hand() {
        assert_eq!(of(&[1, 1]).times(F, &of(&[-1, 1])), of(&[-1, 0, 1]));
        assert_eq!(of(&[1, 1]).times(F, &Univariate::ZERO), Univariate::ZERO);
        assert_eq!(of(&[5, 3, 2]).derivative(F), of(&[3, 4]));
        let mut sum = of(&[1, 2, 3]);
        sum.add_multiple(F, (F.neg(3), 1), &of(&[0, 1]));
        assert_eq!(sum, of(&[1, 2]));
    }

    #[test]
    fn division_leaves_what_it_should() {
        let mut source = Random::new(1);
        for (degree, of_divisor) in [(9, 4), (4, 4), (3, 7), (6, 0)] {
            let (a, b) = (random(&mut source, degree), random(&mut source, of_divisor));
            let (quotient, remainder) = a.divided_by(F, &b);
            assert!(remainder.is_zero() || remainder.degree() < b.degree());
            let mut back = quotient.times(F, &b);
            back.add_multiple(F, (1, 0), &remainder);
            assert_eq!(back, a);
        }
        assert_eq!(of(&[1, 2]).divided_by(F, &Univariate::ZERO), (Univariate::ZERO, of(&[1, 2])));
    }

    #[test]
    fn common_factors_are_found_and_repeated_ones_dropped() {
        let mut source = Random::new(2);
        let [a, b, c] = [3, 4, 5].map(|degree| random(&mut source, degree).monic(F));
        let (ab, ac) = (a.times(F, &b), a.times(F, &c));
        assert_eq!(ab.gcd(F, &ac), a);
        assert_eq!(ab.gcd(F, &Univariate::ZERO), ab);
        let repeated = ab.times(F, &a).times(F, &a);
        assert_eq!(repeated.squarefree_part(F), ab);
        assert_eq!(Univariate::constant(7).squarefree_part(F), Univariate::constant(1));
    }

    #[test]
    fn inverses_exist_modulo_what_has_no_common_factor() {
        let mut source = Random::new(3);
        for degree in 1..8 {
            let (modulus, a) = (random(&mut source, degree), random(&mut source, 5));
            let inverse = a.inverse_modulo(F, &modulus).expect("random polynomials have no common factor");
            assert_eq!(a.times(F, &inverse).modulo(F, &modulus), of(&[1]));
        }
        let (factor, other) = (of(&[1, 1]), of(&[2, 1]));
        assert_eq!(factor.times(F, &other).inverse_modulo(F, &factor), None);
        assert_eq!(Univariate::ZERO.inverse_modulo(F, &factor), None);
    }
}
