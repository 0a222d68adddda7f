//! Polynomial systems from the literature, and their translation to the crate `groebner`.

use eliminant_generator::algebra::{Monomial, Polynomial, PrimeField};
use groebner::{MonomialOrder, PrimeField as OracleField};

/// The prime of every comparison.
pub(crate) const PRIME: u32 = 2147483647;
/// The same prime field in the crate `groebner`.
pub(crate) type OracleElement = OracleField<{ PRIME as u64 }>;
/// A polynomial of the crate `groebner`.
pub(crate) type OraclePolynomial = groebner::Polynomial<OracleElement>;

/// A polynomial system.
pub(crate) struct System {
    pub(crate) name: String,
    pub(crate) unknowns: usize,
    pub(crate) polynomials: Vec<Polynomial<u32>>,
}

impl System {
    /// From polynomials given by integer coefficients and exponents.
    fn new(name: String, unknowns: usize, polynomials: Vec<Vec<(i64, Vec<i8>)>>) -> Self {
        let field = PrimeField::new(PRIME);
        let polynomial = |terms: Vec<(i64, Vec<i8>)>| {
            let terms = terms.into_iter().map(|(c, e)| (Monomial::from_exponents(&e), field.from_integer(c)));
            Polynomial::collect(field, terms)
        };
        Self { name, unknowns, polynomials: polynomials.into_iter().map(polynomial).collect() }
    }

    /// The system in the crate `groebner`.
    pub(crate) fn for_oracle(&self, order: &MonomialOrder) -> Vec<OraclePolynomial> {
        self.polynomials.iter().map(|polynomial| to_oracle(polynomial, self.unknowns, order)).collect()
    }
}

/// A polynomial in the crate `groebner`.
pub(crate) fn to_oracle(polynomial: &Polynomial<u32>, unknowns: usize, order: &MonomialOrder) -> OraclePolynomial {
    let term = |&(monomial, value): &(Monomial, u32)| {
        let exponents: Vec<u32> = monomial.exponents()[..unknowns].iter().map(|&e| e as u32).collect();
        (groebner::Monomial::new(exponents), OracleElement::new(u64::from(value)))
    };
    OraclePolynomial::new(polynomial.terms().iter().map(term).collect(), unknowns, order.clone())
}

/// A polynomial from the crate `groebner`.
pub(crate) fn from_oracle(polynomial: &OraclePolynomial) -> Polynomial<u32> {
    let term = |(monomial, value): &(groebner::Monomial, OracleElement)| {
        let exponents: Vec<i8> = monomial.exps().iter().map(|&e| e as i8).collect();
        (Monomial::from_exponents(&exponents), value.value() as u32)
    };
    Polynomial::from_terms(polynomial.terms.iter().map(term).collect())
}

fn unit(unknowns: usize, factors: &[usize]) -> Vec<i8> {
    let mut exponents = vec![0; unknowns];
    factors.iter().for_each(|&i| exponents[i] += 1);
    exponents
}

/// Katsura's system for a magnet, u_{-n}, .., u_n with u_{-i} = u_i: unknowns u_0..u_n, 2^n
/// solutions.
pub(crate) fn katsura(n: usize) -> System {
    let unknowns = n + 1;
    let mut polynomials = Vec::new();
    for m in 0..n {
        let mut terms = vec![(-1, unit(unknowns, &[m]))];
        for i in -(n as i64)..=n as i64 {
            let j = (m as i64 - i).unsigned_abs() as usize;
            if j <= n {
                terms.push((1, unit(unknowns, &[i.unsigned_abs() as usize, j])));
            }
        }
        polynomials.push(terms);
    }
    let mut sum = vec![(1, unit(unknowns, &[0])), (-1, unit(unknowns, &[]))];
    sum.extend((1..=n).map(|i| (2, unit(unknowns, &[i]))));
    polynomials.push(sum);
    System::new(format!("katsura-{n}"), unknowns, polynomials)
}

/// The cyclic n-roots.
pub(crate) fn cyclic(n: usize) -> System {
    let mut polynomials: Vec<Vec<(i64, Vec<i8>)>> = (1..n)
        .map(|length| {
            let term = |start: usize| unit(n, &(start..start + length).map(|i| i % n).collect::<Vec<_>>());
            (0..n).map(|start| (1, term(start))).collect()
        })
        .collect();
    polynomials.push(vec![(1, vec![1; n]), (-1, vec![0; n])]);
    System::new(format!("cyclic-{n}"), n, polynomials)
}

/// Noonburg's neural network: 1 - c x_i + x_i * (sum of the other squares), with c = 11/10.
pub(crate) fn noon(n: usize) -> System {
    let polynomials = (0..n)
        .map(|i| {
            let mut terms = vec![(10, unit(n, &[])), (-11, unit(n, &[i]))];
            terms.extend((0..n).filter(|&j| j != i).map(|j| (10, unit(n, &[i, j, j]))));
            terms
        })
        .collect();
    System::new(format!("noon-{n}"), n, polynomials)
}

/// Morgan's economics problem: (x_i + sum_j x_j x_{i+j}) x_n = i, sum of x_i for i < n = -1.
pub(crate) fn eco(n: usize) -> System {
    let mut polynomials: Vec<Vec<(i64, Vec<i8>)>> = (0..n - 1)
        .map(|i| {
            let mut terms = vec![(-(i as i64) - 1, unit(n, &[])), (1, unit(n, &[i, n - 1]))];
            terms.extend((0..n - 1).filter(|j| i + j + 1 < n - 1).map(|j| (1, unit(n, &[j, i + j + 1, n - 1]))));
            terms
        })
        .collect();
    let mut sum = vec![(1, unit(n, &[]))];
    sum.extend((0..n - 1).map(|i| (1, unit(n, &[i]))));
    polynomials.push(sum);
    System::new(format!("eco-{n}"), n, polynomials)
}

/// The twisted cubic's tangent surface and a quadric: four unknowns, two equations, no finite
/// solution set.
pub(crate) fn positive_dimensional() -> System {
    let discriminant = vec![
        (1, vec![0, 2, 2, 0]),
        (-4, vec![1, 0, 3, 0]),
        (-4, vec![0, 3, 0, 1]),
        (18, vec![1, 1, 1, 1]),
        (-27, vec![2, 0, 0, 2]),
    ];
    let quadric = vec![(1, vec![1, 0, 0, 1]), (2, vec![0, 1, 1, 0]), (-3, vec![0, 0, 0, 0])];
    System::new("discriminant and quadric".into(), 4, vec![discriminant, quadric])
}
