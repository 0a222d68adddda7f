//! Exchanges of unknowns that map solutions to solutions.
//!
//! x y = a and x^2 + y^2 + x + y = b hold for (y, x) if they hold for (x, y). An exchange is a
//! permutation of the unknowns that is its own inverse, with changes of sign, and maps each
//! equation to a combination of all equations. Partners are given to unknowns in all ways that map
//! the monomials of the equations to themselves; whether equations are mapped, too, is told over
//! Z_p.
//!
//! Several exchanges are used together if their pairs are the same or have no unknown in common.
//! Larsson and Åström ("Uncovering symmetries in polynomial systems", ECCV 2016, section 4.2) treat
//! any permutation by a change of variables that diagonalises it. It is complex for those that are
//! not their own inverse, which are not used here.

use crate::algebra::{Echelon, Monomial, PRIMES, Polynomial, PrimeField};
use crate::problem::instance::Instance;
use crate::problem::{DataAttribute, Problem};

/// Exchanges must hold at two instances, as must all that is left out with them: (prime, seed).
const INSTANCES: [(u32, u64); 2] = [(PRIMES[0], 1), (PRIMES[1], 2)];

/// At most so many assignments of partners are tried.
const MOST_ASSIGNMENTS: usize = 20_000;

/// At most so many exchanges are tried on the equations.
const MOST_TRIED: usize = 20_000;

/// With more pairs and other unknowns than this, only exchanges without a change of sign are tried.
const MOST_SIGNS: usize = 8;

/// The value that an unknown has at another solution: that of the unknown with this position, with
/// the other sign if `true`.
pub type Image = (u8, bool);

/// A map of solutions to solutions that is its own inverse: the image of each unknown.
pub(super) type Exchange = Vec<Image>;

/// Two unknowns. In a reduced problem half their sum has the place of the first, and half their
/// difference that of the second.
pub type Pair = [usize; 2];

/// The pairs of unknowns that exchanges move.
#[must_use]
pub fn exchanged(problem: &Problem) -> Vec<Pair> {
    pairs_of(&exchanges(problem))
}

/// The pairs that some exchange moves.
pub(super) fn pairs_of(exchanges: &[Exchange]) -> Vec<Pair> {
    let of_one = |exchange: &Exchange| -> Vec<Pair> {
        let partners = exchange.iter().enumerate().map(|(at, &(of, _))| [at, usize::from(of)]);
        partners.filter(|[x, y]| x < y).collect()
    };
    let mut pairs: Vec<Pair> = exchanges.iter().flat_map(of_one).collect();
    pairs.sort_unstable();
    pairs.dedup();
    pairs
}

/// Exchanges that can be used together, those of the fewest unknowns first.
pub(super) fn exchanges(problem: &Problem) -> Vec<Exchange> {
    let Some(instances) = instances(problem) else { return Vec::new() };
    let spans: Vec<Span> = instances.iter().map(Span::new).collect();
    let Some(partners) = spans.first().map(|span| Partners::all(problem.unknowns.len(), &span.support)) else {
        return Vec::new();
    };
    let (mut found, mut left): (Vec<Exchange>, usize) = (Vec::new(), MOST_TRIED);
    for partners in partners {
        let mut is_found = |exchange: &Exchange| {
            left = left.saturating_sub(1);
            left > 0 && fits(exchange, &found) && spans.iter().all(|span| span.is_kept_by(exchange))
        };
        let exchange = with_signs(&partners).find(&mut is_found);
        found.extend(exchange);
    }
    found
}

/// Instances whose data satisfy no conditions but those that no measurement error violates. What
/// statements know of conditions, such as the length of a unit vector, is in their coefficients. An
/// exchange that needed more would not lead to solutions where data have errors.
pub(super) fn instances(problem: &Problem) -> Option<Vec<Instance>> {
    let mut general = problem.clone();
    for parameter in &mut general.data {
        if !matches!(parameter.attribute, DataAttribute::Symmetric | DataAttribute::Integer) {
            parameter.attribute = DataAttribute::Generic;
        }
    }
    INSTANCES.into_iter().map(|(prime, seed)| Instance::draw(&general, PrimeField::new(prime), seed)).collect()
}

/// Whether an exchange and all others are changes of sign in the same sums and differences: each
/// pair of one is a pair of the other, or both its unknowns keep their places and have one sign.
fn fits(exchange: &Exchange, others: &[Exchange]) -> bool {
    let treats_alike = |a: &Exchange, [x, y]: Pair| {
        let is_pair = usize::from(a[x].0) == y;
        is_pair || (usize::from(a[x].0), usize::from(a[y].0)) == (x, y) && a[x].1 == a[y].1
    };
    let fit =
        |a: &Exchange, b: &Exchange| pairs_of(std::slice::from_ref(b)).into_iter().all(|pair| treats_alike(a, pair));
    others.iter().all(|other| fit(exchange, other) && fit(other, exchange))
}

/// The exchanges with these partners and with changes of sign, that without any first.
fn with_signs(partners: &[usize]) -> impl Iterator<Item = Exchange> {
    let first: Vec<usize> = (0..partners.len()).filter(|&at| partners[at] >= at).collect();
    let count = if first.len() <= MOST_SIGNS { 1usize << first.len() } else { 1 };
    let place = partners.iter().enumerate().map(|(at, &of)| first.binary_search(&at.min(of)).unwrap_or(0));
    let places: Vec<(u8, usize)> = partners.iter().map(|&of| of as u8).zip(place).collect();
    (0..count).map(move |signs| places.iter().map(|&(of, place)| (of, signs >> place & 1 == 1)).collect())
}

/// The equations of an instance, as vectors over their monomials.
struct Span {
    support: Vec<Monomial>,
    equations: Vec<Polynomial<u32>>,
    nonzero: Vec<Polynomial<u32>>,
    rows: Echelon,
}

impl Span {
    fn new(instance: &Instance) -> Self {
        let mut support: Vec<Monomial> = instance.equations.iter().flat_map(Polynomial::monomials).collect();
        support.sort_unstable();
        support.dedup();
        let mut rows = Echelon::new(instance.field, support.len());
        for equation in &instance.equations {
            rows.insert_sparse(&row(&support, equation.terms().iter().copied()).unwrap_or_default());
        }
        Self { support, equations: instance.equations.clone(), nonzero: instance.nonzero.clone(), rows }
    }

    /// Whether an exchange maps each equation to a combination of them, and each factor that must
    /// not vanish to a multiple of one.
    fn is_kept_by(&self, exchange: &Exchange) -> bool {
        let field = self.rows.field();
        let image = |p: &Polynomial<u32>| {
            let term = |&(m, c): &(Monomial, u32)| {
                let (monomial, is_negated) = exchanged_monomial(&m, exchange);
                (monomial, if is_negated { field.neg(c) } else { c })
            };
            Polynomial::from_terms(p.terms().iter().map(term).collect())
        };
        let mut rows = self.rows.clone();
        let mut is_combination = |p: &Polynomial<u32>| {
            row(&self.support, image(p).terms().iter().copied()).is_some_and(|row| rows.insert_sparse(&row).is_none())
        };
        let is_factor = |p: &Polynomial<u32>| {
            let image = image(p);
            self.nonzero.iter().any(|other| are_proportional(field, &image, other))
        };
        self.equations.iter().all(&mut is_combination) && self.nonzero.iter().all(is_factor)
    }
}

/// A polynomial over these monomials; `None` if it has others.
pub(super) fn row(support: &[Monomial], terms: impl Iterator<Item = (Monomial, u32)>) -> Option<Vec<(u32, u32)>> {
    terms.map(|(m, c)| Some((support.binary_search(&m).ok()? as u32, c))).collect()
}

fn are_proportional(field: PrimeField, a: &Polynomial<u32>, b: &Polynomial<u32>) -> bool {
    let (Some(&(_, of_a)), Some(&(_, of_b))) = (a.terms().first(), b.terms().first()) else { return false };
    let is_same =
        |(&(m, c), &(n, d)): (&(Monomial, u32), &(Monomial, u32))| m == n && field.mul(c, of_b) == field.mul(d, of_a);
    a.terms().len() == b.terms().len() && a.terms().iter().zip(b.terms()).all(is_same)
}

/// The image of a monomial, and whether its sign changes.
fn exchanged_monomial(monomial: &Monomial, exchange: &Exchange) -> (Monomial, bool) {
    let mut exponents = *monomial.exponents();
    let mut is_negated = false;
    for (at, &(of, negates)) in exchange.iter().enumerate() {
        let exponent = monomial.exponent(at);
        exponents[usize::from(of)] = exponent;
        is_negated ^= negates && exponent % 2 != 0;
    }
    (Monomial::from_exponents(&exponents), is_negated)
}

/// The ways to give each unknown a partner, or itself, that map a set of monomials to itself.
struct Partners<'a> {
    support: &'a [Monomial],
    /// Unknowns with different ones are never exchanged.
    colours: Vec<Vec<Monomial>>,
    found: Vec<Vec<usize>>,
    left: usize,
}

impl<'a> Partners<'a> {
    /// Those with the fewest pairs first.
    fn all(unknowns: usize, support: &'a [Monomial]) -> Vec<Vec<usize>> {
        let colours = (0..unknowns).map(|unknown| colour(support, unknown)).collect();
        let mut partners = Partners { support, colours, found: Vec::new(), left: MOST_ASSIGNMENTS };
        for pairs in 1..=unknowns / 2 {
            partners.assign(&mut vec![None; unknowns], pairs);
        }
        partners.found
    }

    /// Gives the first unknown without a partner one in all ways, with so many pairs to come.
    fn assign(&mut self, partners: &mut Vec<Option<usize>>, pairs: usize) {
        if self.left == 0 || !self.keeps_support(partners) {
            return;
        }
        self.left -= 1;
        let Some(first) = partners.iter().position(Option::is_none) else {
            if pairs == 0 {
                self.found.push(partners.iter().flatten().copied().collect());
            }
            return;
        };
        let free = partners.iter().filter(|partner| partner.is_none()).count();
        if free > 2 * pairs {
            partners[first] = Some(first);
            self.assign(partners, pairs);
            partners[first] = None;
        }
        for other in first + 1..partners.len() {
            if pairs > 0 && partners[other].is_none() && self.colours[first] == self.colours[other] {
                (partners[first], partners[other]) = (Some(other), Some(first));
                self.assign(partners, pairs - 1);
                (partners[first], partners[other]) = (None, None);
            }
        }
    }

    /// Whether monomials of unknowns with partners are mapped to monomials that occur.
    fn keeps_support(&self, partners: &[Option<usize>]) -> bool {
        let exchange: Vec<Image> = partners.iter().enumerate().map(|(at, p)| (p.unwrap_or(at) as u8, false)).collect();
        let is_decided = |m: &&Monomial| partners.iter().enumerate().all(|(at, p)| p.is_some() || m.exponent(at) == 0);
        let occurs = |m: &Monomial| self.support.binary_search(&exchanged_monomial(m, &exchange).0).is_ok();
        self.support.iter().filter(is_decided).all(occurs)
    }
}

/// What an exchange does not change: for each monomial with the unknown, its exponent, and those of
/// the others in order.
fn colour(support: &[Monomial], unknown: usize) -> Vec<Monomial> {
    let sorted = |m: &Monomial| {
        let mut exponents = *m.exponents();
        exponents.swap(0, unknown);
        exponents[1..].sort_unstable();
        Monomial::from_exponents(&exponents)
    };
    let mut colour: Vec<Monomial> = support.iter().filter(|m| m.exponent(unknown) != 0).map(sorted).collect();
    colour.sort_unstable();
    colour
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::presolve::{Presolve, presolve};

    fn problem(equations: &str) -> Problem {
        let text = format!("fn sample(a: [f64; 9]) -> (x, y, z, w) {{ {equations} }}");
        Problem::parse("sample.rs", &text).unwrap()
    }

    fn found(equations: &str) -> Vec<Pair> {
        exchanged(&problem(equations))
    }

    #[test]
    fn exchanges_map_equations_to_combinations_of_equations() {
        let two = "x * y == a[0]; x + y + z == a[1]; z * w == a[2]; w * w + z == a[3];";
        assert_eq!(found(two), [[0, 1]]);
        // Of two spheres, of which only combinations are exchanged.
        let spheres =
            "x * x + y * y + z * z == a[0]; x * x + y * y + z * z + x + y == a[1]; z == a[2]; w * x * y == 1;";
        assert_eq!(found(spheres), [[0, 1]]);
        // The coefficients differ.
        assert_eq!(found(&two.replace("x + y", "a[4] * x + a[5] * y")), [[0; 2]; 0]);
        // The same, but with a sign.
        assert_eq!(found(&two.replace("x + y", "a[4] * x - a[4] * y")), [[0, 1]]);
        // A factor must be exchanged with another one.
        assert_eq!(found(&format!("{two} x - 1 != 0;")), [[0; 2]; 0]);
        assert_eq!(found(&format!("{two} x - 1 != 0; 2 * y - 2 != 0;")), [[0, 1]]);
    }

    /// The length of a unit vector is 1 in all statements of a problem, whatever its errors.
    #[test]
    fn data_satisfy_what_statements_know() {
        let of = |attribute: &str| {
            let text = format!(
                "fn sample({attribute} u: [f64; 2], a: f64) -> (x, y) {{ x * y == a; x * x + dot(u, u) * y * y == u[0]; }}"
            );
            exchanged(&Problem::parse("sample.rs", &text).unwrap())
        };
        assert_eq!((of("#[unit]"), of("")), (vec![[0, 1]], vec![]));
        let symmetric = "fn sample(#[symmetric] m: [[f64; 2]; 2]) -> (x, y) { x * y == m[0][0]; m[0][1] * x * x + m[1][0] * y * y == m[1][1]; }";
        assert_eq!(exchanged(&Problem::parse("sample.rs", symmetric).unwrap()), [[0, 1]]);
    }

    #[test]
    fn pairs_are_used_together_where_they_fit() {
        let each = "x * y == a[0]; x + y + z + w == a[1]; z * w == a[2]; x * y * (z + w) + z * z + w * w == a[3];";
        let reduced = presolve(&problem(each), Presolve::Paired);
        assert_eq!((&reduced.pairs[..], reduced.symmetry.order()), (&[[0, 1], [2, 3]][..], 4));
        // x with y and z with w, or x with z and y with w, but not both.
        let cycle = "x * y + z * w == a[0]; x * z + y * w == a[1]; x + y + z + w == a[2]; x * y * z * w == a[3];";
        assert_eq!(presolve(&problem(cycle), Presolve::Paired).pairs, [[0, 1], [2, 3]]);
    }
}
