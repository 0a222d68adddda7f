//! Exchanges of unknowns that map solutions to solutions, turned into changes of sign.
//!
//! x y = a and x^2 + y^2 + x + y = b hold for (y, x) if they hold for (x, y). In half the sum and
//! half the difference of the two unknowns such an exchange is a change of sign, which templates
//! know how to use ([`super::symmetry`]):
//!
//! ```text
//!   x = s + d      s = (x + y) / 2      x <-> y     s -> s,  d -> -d
//!   y = s - d      d = (x - y) / 2      x <-> -y    s -> -s, d -> d
//! ```
//!
//! The exchange maps an equation to a combination of all equations, and so does each of its two
//! parts, of the terms that change their sign and of those that keep it. The parts take the place
//! of the equations: s^2 - d^2 = a; 2 s^2 + 2 d^2 + 2 s = b. They span the same polynomials, and
//! those that depend on others are left out.
//!
//! Several exchanges are used together if their pairs are the same or have no unknown in common.
//! Larsson and Åström ("Uncovering symmetries in polynomial systems", ECCV 2016, section 4.2) treat
//! any permutation by a change of variables that diagonalises it. It is complex for those that are
//! not their own inverse, which are left to the eigenvalues here.

use std::collections::BTreeMap;

use super::reduced::{MAX_TERMS, Recovery, ReducedProblem};
use super::symmetry::Symmetry;
use crate::algebra::{Echelon, Monomial, PRIMES, Polynomial, PrimeField};
use crate::expression::rational::Rational;
use crate::expression::{ExpressionGraph, ExpressionId, SymbolicPolynomial};
use crate::problem::instance::Instance;
use crate::problem::{Problem, Statement};

/// Exchanges must hold at two instances, as must all that is left out here: (prime, seed).
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
type Exchange = Vec<Image>;

/// Two unknowns. In a reduced problem half their sum has the place of the first, and half their
/// difference that of the second.
pub type Pair = [usize; 2];

/// The pairs of unknowns that exchanges move.
#[must_use]
pub fn exchanged(problem: &Problem) -> Vec<Pair> {
    pairs_of(&exchanges(problem))
}

/// Puts half the sum and half the difference in the place of the unknowns that can be exchanged.
/// Nothing changes if there are none, if that gives no more changes of sign than there are, or if
/// an equation would grow too long.
pub(super) fn pair(reduced: &mut ReducedProblem) {
    let exchanges = exchanges(&reduced.problem);
    let pairs = pairs_of(&exchanges);
    let flips: Vec<Vec<bool>> = exchanges.iter().map(|exchange| flips_of(exchange, &pairs)).collect();
    let Some(problem) = in_sums_and_differences(&reduced.problem, &pairs, &flips) else { return };
    let symmetry = Symmetry::of_problem(&problem);
    if symmetry.order() <= reduced.symmetry.order() {
        return;
    }
    reduced.problem = problem;
    reduced.symmetry = symmetry;
    let graph = &mut reduced.problem.graph;
    for &[x, y] in &pairs {
        let mut sum_with = |factor: i64| {
            let factor = graph.constant(Rational::integer(factor));
            let terms = vec![(Monomial::unknown(x), ExpressionGraph::ONE), (Monomial::unknown(y), factor)];
            SymbolicPolynomial::from_terms(terms)
        };
        // The list runs backwards: first x = s + d, where s and d have the places of x and y, then
        // y = s - d = x - 2 d.
        let (of_x, of_y) = (sum_with(1), sum_with(-2));
        reduced.recoveries.push(Recovery { unknown: y, value: of_y });
        reduced.recoveries.push(Recovery { unknown: x, value: of_x });
    }
    reduced.pairs = pairs;
}

/// What a change of sign does to the unknowns, if half the sum and half the difference have the
/// places of the pairs.
pub(crate) fn images(unknowns: usize, flip: &[usize], pairs: &[Pair]) -> Exchange {
    let changes = |unknown: usize| flip.contains(&unknown);
    let mut images: Exchange = (0..unknowns).map(|at| (at as u8, changes(at))).collect();
    for &[x, y] in pairs {
        let (of_sum, of_difference) = (changes(x), changes(y));
        // -s - d is minus the unknown itself, s - d the other one, and -s + d minus the other one.
        let [of_x, of_y] = if of_sum == of_difference { [x, y] } else { [y, x] };
        (images[x], images[y]) = ((of_x as u8, of_sum), (of_y as u8, of_sum));
    }
    images
}

fn pairs_of(exchanges: &[Exchange]) -> Vec<Pair> {
    let of_one = |exchange: &Exchange| -> Vec<Pair> {
        let partners = exchange.iter().enumerate().map(|(at, &(of, _))| [at, usize::from(of)]);
        partners.filter(|[x, y]| x < y).collect()
    };
    let mut pairs: Vec<Pair> = exchanges.iter().flat_map(of_one).collect();
    pairs.sort_unstable();
    pairs.dedup();
    pairs
}

/// The signs that an exchange changes in sums and differences.
fn flips_of(exchange: &Exchange, pairs: &[Pair]) -> Vec<bool> {
    let mut flips: Vec<bool> = exchange.iter().map(|&(_, is_negated)| is_negated).collect();
    for &[x, y] in pairs {
        let (of, is_negated) = exchange[x];
        flips[y] = is_negated == (usize::from(of) == x);
    }
    flips
}

/// Exchanges that can be used together, those of the fewest unknowns first.
fn exchanges(problem: &Problem) -> Vec<Exchange> {
    let draw = |(prime, seed)| Instance::draw(problem, PrimeField::new(prime), seed);
    let Some(instances) = INSTANCES.into_iter().map(draw).collect::<Option<Vec<Instance>>>() else {
        return Vec::new();
    };
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
fn row(support: &[Monomial], terms: impl Iterator<Item = (Monomial, u32)>) -> Option<Vec<(u32, u32)>> {
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

/// The problem in half the sums and half the differences of the pairs, split into parts that each
/// of the changes of sign keeps or negates. `None` if there are none, or if it grows too long.
fn in_sums_and_differences(problem: &Problem, pairs: &[Pair], flips: &[Vec<bool>]) -> Option<Problem> {
    if pairs.is_empty() {
        return None;
    }
    let mut paired = problem.clone();
    for statement in paired.equations.iter_mut().chain(&mut paired.nonzero) {
        statement.polynomial = substituted(&mut paired.graph, &statement.polynomial, pairs)?;
    }
    let mut values = Vec::new();
    for (prime, seed) in INSTANCES {
        let field = PrimeField::new(prime);
        values.push((field, paired.graph.evaluate(field, &Instance::draw(problem, field, seed)?.inputs)?));
    }
    // Expressions that are written in two ways may cancel all the same.
    let is_zero = |c: &ExpressionId| values.iter().all(|(_, values)| values[c.index()] == 0);
    let parts = |statement: &Statement| parts(statement, flips, &is_zero);
    let equations: Vec<Statement> = paired.equations.iter().flat_map(parts).collect();
    paired.equations = independent(equations, &values)?;
    let factors: Vec<Vec<Statement>> = paired.nonzero.iter().map(parts).collect();
    paired.nonzero = products(&mut paired.graph, factors)?;
    Some(paired)
}

/// A polynomial with x = s + d and y = s - d for all pairs, where s and d take the places of x and
/// y. Terms whose coefficients are the same are added up before they become expressions, so that
/// they cancel.
fn substituted(graph: &mut ExpressionGraph, p: &SymbolicPolynomial, pairs: &[Pair]) -> Option<SymbolicPolynomial> {
    let mut sums: BTreeMap<Monomial, BTreeMap<ExpressionId, Rational>> = BTreeMap::new();
    for &(monomial, coefficient) in p.terms() {
        let constant = graph.as_constant(coefficient);
        let (id, factor) = constant.map_or((coefficient, Rational::ONE), |constant| (ExpressionGraph::ONE, constant));
        for (monomial, count) in expanded(monomial, pairs)? {
            let sum = sums.entry(monomial).or_default().entry(id).or_insert(Rational::ZERO);
            *sum = sum.checked_add(factor.checked_mul(Rational::integer(count))?)?;
        }
        if sums.len() > MAX_TERMS {
            return None;
        }
    }
    let mut terms = Vec::new();
    for (monomial, sum) in sums {
        let mut total: Option<ExpressionId> = None;
        for (id, factor) in sum.into_iter().filter(|(_, factor)| *factor != Rational::ZERO) {
            let factor = graph.constant(factor);
            let product = graph.mul(factor, id);
            total = Some(total.map_or(product, |total| graph.add(total, product)));
        }
        terms.extend(total.filter(|&total| !graph.is_zero(total)).map(|total| (monomial, total)));
    }
    Some(SymbolicPolynomial::from_terms(terms))
}

/// The terms of a monomial, as integers times monomials; `None` if there are too many.
fn expanded(monomial: Monomial, pairs: &[Pair]) -> Option<Vec<(Monomial, i64)>> {
    let mut terms = vec![(monomial, 1)];
    for &[x, y] in pairs {
        let (a, b) = (monomial.exponent(x), monomial.exponent(y));
        if a < 0 || b < 0 {
            return None;
        }
        // (s + d)^a (s - d)^b: coefficients by increasing power of d.
        let mut power = vec![1i64];
        for sign in (0..a).map(|_| 1).chain((0..b).map(|_| -1)) {
            power.push(0);
            for k in (1..power.len()).rev() {
                power[k] = power[k].checked_add(sign * power[k - 1])?;
            }
        }
        let with = |&(m, factor): &(Monomial, i64)| {
            let mut exponents = *m.exponents();
            let term = |(k, &count): (usize, &i64)| {
                (exponents[x], exponents[y]) = (a + b - k as i8, k as i8);
                (Monomial::from_exponents(&exponents), factor * count)
            };
            power.iter().enumerate().map(term).filter(|(_, factor)| *factor != 0).collect::<Vec<_>>()
        };
        terms = terms.iter().flat_map(with).collect();
        if terms.len() > MAX_TERMS {
            return None;
        }
    }
    Some(terms)
}

/// The parts of a statement by the signs that change, without terms that are zero.
fn parts(statement: &Statement, flips: &[Vec<bool>], is_zero: &impl Fn(&ExpressionId) -> bool) -> Vec<Statement> {
    let mut parts: BTreeMap<Vec<bool>, Vec<(Monomial, ExpressionId)>> = BTreeMap::new();
    for &(m, c) in statement.polynomial.terms().iter().filter(|(_, c)| !is_zero(c)) {
        let is_negated = |flip: &Vec<bool>| {
            flip.iter().enumerate().filter(|&(at, &changes)| changes && m.exponent(at) % 2 != 0).count() % 2 == 1
        };
        parts.entry(flips.iter().map(is_negated).collect()).or_default().push((m, c));
    }
    let part = |terms| Statement { polynomial: SymbolicPolynomial::from_terms(terms), ..statement.clone() };
    parts.into_values().map(part).collect()
}

/// The equations that do not depend on those before them; `None` if these differ from instance to
/// instance. Short ones come first among the equations of a statement, and stay.
fn independent(equations: Vec<Statement>, values: &[(PrimeField, Vec<u32>)]) -> Option<Vec<Statement>> {
    let mut support: Vec<Monomial> = equations.iter().flat_map(|equation| equation.polynomial.monomials()).collect();
    support.sort_unstable();
    support.dedup();
    let mut kept: Option<Vec<bool>> = None;
    for (field, values) in values {
        let mut rows = Echelon::new(*field, support.len());
        let mut is_kept = |equation: &Statement| {
            let terms = equation.polynomial.terms().iter().map(|&(m, c)| (m, values[c.index()]));
            row(&support, terms.filter(|(_, c)| *c != 0)).is_some_and(|row| rows.insert_sparse(&row).is_some())
        };
        let here: Vec<bool> = equations.iter().map(&mut is_kept).collect();
        if kept.as_ref().is_some_and(|kept| *kept != here) {
            return None;
        }
        kept = Some(here);
    }
    let kept = kept?;
    Some(equations.into_iter().zip(kept).filter_map(|(equation, is_kept)| is_kept.then_some(equation)).collect())
}

/// Factors that must not vanish, each of one class: one that has several parts, f + g, is taken
/// times its images, of which there must be one, f - g.
fn products(graph: &mut ExpressionGraph, factors: Vec<Vec<Statement>>) -> Option<Vec<Statement>> {
    let mut products: Vec<Statement> = Vec::new();
    for parts in factors {
        let (first, polynomial) = match &parts[..] {
            [one] => (one, one.polynomial.clone()),
            [first, second] => {
                let [f, g] = [&first.polynomial, &second.polynomial];
                let (sum, difference) = (graph.polynomial_add(f, g), graph.polynomial_sub(f, g));
                (first, graph.polynomial_mul(&sum, &difference)?)
            }
            _ => return None,
        };
        products.push(Statement { polynomial, ..first.clone() });
    }
    Some(products)
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

    #[test]
    fn pairs_are_used_together_where_they_fit() {
        let each = "x * y == a[0]; x + y + z + w == a[1]; z * w == a[2]; x * y * (z + w) + z * z + w * w == a[3];";
        let reduced = presolve(&problem(each), Presolve::Paired);
        assert_eq!((&reduced.pairs[..], reduced.symmetry.order()), (&[[0, 1], [2, 3]][..], 4));
        // x with y and z with w, or x with z and y with w, but not both.
        let cycle = "x * y + z * w == a[0]; x * z + y * w == a[1]; x + y + z + w == a[2]; x * y * z * w == a[3];";
        assert_eq!(presolve(&problem(cycle), Presolve::Paired).pairs, [[0, 1], [2, 3]]);
    }

    /// One exchange in the place of two changes of sign would be a loss.
    #[test]
    fn changes_of_sign_are_not_given_up() {
        let squares = "x * x + y * y == a[0]; x * x * y * y == a[1]; z == a[2]; w == a[3];";
        let reduced = presolve(&problem(squares), Presolve::Paired);
        assert_eq!((reduced.pairs.len(), reduced.symmetry.order()), (0, 4));
        assert_eq!(found(squares), [[0, 1]]);
    }

    #[test]
    fn a_change_of_sign_is_an_exchange_of_unknowns() {
        let pairs = [[0, 2]];
        assert_eq!(images(3, &[2], &pairs), [(2, false), (1, false), (0, false)]);
        assert_eq!(images(3, &[0, 1], &pairs), [(2, true), (1, true), (0, true)]);
        assert_eq!(images(3, &[0, 2], &pairs), [(0, true), (1, false), (2, true)]);
        for flip in [vec![], vec![0], vec![1], vec![2], vec![0, 1, 2], vec![1, 2]] {
            let flips: Vec<bool> = (0..3).map(|at| flip.contains(&at)).collect();
            assert_eq!(flips_of(&images(3, &flip, &pairs), &pairs), flips);
        }
    }

    /// At x = s + d and y = s - d, the equations as stated are combinations of the parts.
    #[test]
    fn the_parts_span_the_equations() {
        let text = "x * x * y + y * z + x * w == a[0] * z * w; x * y * y + x * w + y * z == a[0] * z * w;
                    x * z + y * w + a[1] * x * x * y * y == 1; z * w + a[2] * z + a[2] * w == a[3];";
        let problem = problem(text);
        let reduced = presolve(&problem, Presolve::Paired);
        assert_eq!((&reduced.pairs[..], reduced.problem.equations.len()), (&[[0, 1], [2, 3]][..], 4));
        let instance = Instance::draw(&reduced.problem, PrimeField::new(PRIMES[0]), 5).unwrap();
        let field = instance.field;
        let mut rows: Vec<Polynomial<u32>> = instance.equations;
        let mut graph = problem.graph.clone();
        for stated in problem.polynomials() {
            let here = substituted(&mut graph, stated, &reduced.pairs).unwrap();
            let values = graph.evaluate(field, &instance.inputs).unwrap();
            rows.push(here.map(|c| Some(values[c.index()]).filter(|&value| value != 0)));
        }
        let mut support: Vec<Monomial> = rows.iter().flat_map(Polynomial::monomials).collect();
        support.sort_unstable();
        support.dedup();
        let mut echelon = Echelon::new(field, support.len());
        let is_new =
            |p: &Polynomial<u32>| echelon.insert_sparse(&row(&support, p.terms().iter().copied()).unwrap()).is_some();
        assert_eq!(rows.iter().map(is_new).collect::<Vec<_>>(), [true, true, true, true, false, false, false, false]);
    }

    #[test]
    fn powers_of_sums_and_differences() {
        let m = |exponents: &[i8]| Monomial::from_exponents(exponents);
        // (s + d)^2 (s - d) = s^3 + s^2 d - s d^2 - d^3
        let expected = [(m(&[3]), 1), (m(&[2, 1]), 1), (m(&[1, 2]), -1), (m(&[0, 3]), -1)];
        assert_eq!(expanded(m(&[2, 1]), &[[0, 1]]).unwrap(), expected);
        assert_eq!(expanded(m(&[1, 1, 1]), &[[0, 1]]).unwrap(), [(m(&[2, 0, 1]), 1), (m(&[0, 2, 1]), -1)]);
        assert_eq!(expanded(m(&[-1, 1]), &[[0, 1]]), None);
    }
}
