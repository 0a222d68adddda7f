//! Values that depend on a solution: those of what a problem returns beside its unknowns.
//!
//! The coefficients of equations depend on data only. Results depend on the coordinates of a
//! solution, too, which are nodes of the same graph, so that equal values are one node. They have
//! no values before a system is solved: an evaluation of the graph leaves them out.

use super::graph::{Expression, ExpressionGraph, ExpressionId, FINGERPRINT_FIELDS, Fingerprint};
use super::polynomial::SymbolicPolynomial;
use crate::algebra::Random;

/// The seed of the fingerprints of coordinates and square roots; any constant does.
const SEED: u64 = 0x736f_6c75_7469_6f6e;

impl ExpressionGraph {
    /// A coordinate of the solution, by its number among the unknowns of a polynomial.
    pub fn unknown(&mut self, number: u32) -> ExpressionId {
        self.push(Expression::Unknown(number), drawn([number, 0], 0))
    }

    /// The square root of a value that depends on the solution.
    ///
    /// Its fingerprint is drawn from that of the square: roots of equal values are one node, but
    /// the product of a root with itself is another node than the square.
    pub fn root(&mut self, square: ExpressionId) -> ExpressionId {
        let fingerprint = drawn(self.fingerprint(square), 1);
        self.push(Expression::Root(square), fingerprint)
    }

    /// The value of a polynomial at the solution.
    pub fn value_of(&mut self, polynomial: &SymbolicPolynomial) -> ExpressionId {
        let mut sum = Self::ZERO;
        for (monomial, coefficient) in polynomial.terms() {
            let mut term = *coefficient;
            for (number, &exponent) in (0..).zip(monomial.exponents()) {
                for _ in 0..exponent {
                    let unknown = self.unknown(number);
                    term = self.mul(term, unknown);
                }
            }
            sum = self.add(sum, term);
        }
        sum
    }

    /// The fingerprint of a node that depends on the solution, from those of all nodes before it;
    /// `None` if a divisor is zero.
    pub(super) fn fingerprint_of_solution(&self, at: usize, all: &[Fingerprint]) -> Option<Fingerprint> {
        let of = |id: ExpressionId, k: usize| all[id.index()][k];
        let node = self.nodes()[at];
        match node {
            Expression::Unknown(_) => return Some(all[at]),
            Expression::Root(square) => return Some(drawn(all[square.index()], 1)),
            _ => {}
        }
        let mut fingerprint = all[at];
        for (k, f) in FINGERPRINT_FIELDS.into_iter().enumerate() {
            fingerprint[k] = match node {
                Expression::Add(a, b) => f.add(of(a, k), of(b, k)),
                Expression::Subtract(a, b) => f.sub(of(a, k), of(b, k)),
                Expression::Multiply(a, b) => f.mul(of(a, k), of(b, k)),
                Expression::Divide(a, b) => f.mul(of(a, k), f.inverse(of(b, k))?),
                Expression::Negate(a) => f.sub(0, of(a, k)),
                Expression::Coefficient { sum, at } => {
                    self.product_sums()[sum as usize].evaluate(f, |id| of(id, k))[at as usize]
                }
                _ => return None,
            };
        }
        Some(fingerprint)
    }
}

/// Two numbers that look random, below the primes of fingerprints.
fn drawn([a, b]: Fingerprint, kind: u64) -> Fingerprint {
    let mut random = Random::new(SEED ^ (u64::from(a) << 32 | u64::from(b)).rotate_left(1) ^ kind);
    [0, 1].map(|_| 1 + random.below((1 << 30) - 1) as u32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::rational::Rational;

    fn graph() -> ExpressionGraph {
        ExpressionGraph::new(&[vec![12_345, 67_890], vec![54_321, 9_876]])
    }

    /// Fingerprints of what depends on a solution follow those of the data: equal values are one
    /// node before and after.
    #[test]
    fn fingerprints_move_with_the_data() {
        let mut graph = graph();
        let (a, b, x) = (graph.input(0), graph.input(1), graph.unknown(0));
        let build = |graph: &mut ExpressionGraph| {
            let (scaled, shifted) = (graph.mul(a, x), graph.sub(x, b));
            let quotient = graph.div(scaled, shifted).unwrap();
            let (root, negative) = (graph.root(quotient), graph.neg(quotient));
            [scaled, shifted, quotient, root, negative]
        };
        let first = build(&mut graph);
        let before = first.map(|id| graph.fingerprint(id));
        let nodes = graph.nodes().len();
        for (k, given) in [[1_000, 2_000], [3_000, 4_000]].iter().enumerate() {
            assert!(graph.move_fingerprints(k, given));
        }
        let after = first.map(|id| graph.fingerprint(id));
        assert!(before.iter().zip(&after).all(|(before, after)| before[0] != after[0] && before[1] != after[1]));
        assert_eq!((build(&mut graph), graph.nodes().len()), (first, nodes));
        // At b = x the quotient has no value, and nothing is moved.
        let of_x = graph.fingerprint(x)[0];
        assert!(!graph.move_fingerprints(0, &[1_000, of_x]));
        assert_eq!(first.map(|id| graph.fingerprint(id)), after);
    }

    /// An evaluation leaves out what depends on a solution, and a value of the data is never the
    /// node of an expression that was written with one.
    #[test]
    fn values_of_a_solution_are_no_coefficients() {
        let mut graph = graph();
        let (a, x) = (graph.input(0), graph.unknown(0));
        let shifted = graph.add(x, a);
        let [square, of_x, two] = [(shifted, shifted), (x, x), (a, x)].map(|(left, right)| graph.mul(left, right));
        let factor = graph.constant(Rational::integer(2));
        let two = graph.mul(two, factor);
        let rest = graph.sub(square, of_x);
        let written = graph.sub(rest, two);
        let plain = graph.mul(a, a);
        assert_eq!(graph.fingerprint(written), graph.fingerprint(plain));
        assert_eq!([x, written, plain].map(|id| graph.is_of_solution(id)), [true, true, false]);
        let values = graph.evaluate(FINGERPRINT_FIELDS[0], &[7, 8]).unwrap();
        assert_eq!([x, written, plain].map(|id| values[id.index()]), [0, 0, 49]);
    }
}
