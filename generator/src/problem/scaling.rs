//! Scalings of data and unknowns under which a problem stays the same: its units.
//!
//! ```text
//!   data d_i -> 2^(w_i s) d_i,  unknowns x_j -> 2^(u_j s) x_j,  every equation -> 2^(..) equation
//! ```
//!
//! The weights (w, u) are the integer points of a vector space. Every value that is computed from
//! the data has a weight that is linear in w: a product has the sum of the weights of its factors,
//! and the terms of a sum must have the same weight, which is an equation for w. So must the terms
//! of a polynomial in the unknowns, with the weights of its monomials.
//!
//! A vector of unknowns that is given up to scale has a weight for each element, relative to that
//! of the last. The chart in which it is solved for mixes its elements, so that the statements are
//! read without it here, as homogeneous ones in all elements.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use super::{DataAttribute, DataParameter, Scaling};
use crate::algebra::{Echelon, PRIMES, PrimeField};
use crate::expression::derivation::DerivationKind;
use crate::expression::product_sum::Product;
use crate::expression::{Expression, ExpressionGraph, ExpressionId, SymbolicPolynomial};

/// Larger weights are not taken: powers of the scale would leave the range of `f64` soon.
const LARGEST: i64 = 32;

/// Values of larger weights, which helpers that call helpers can make, have no scalings.
const LARGEST_OF_VALUES: i64 = 1 << 40;

/// The runtime takes no more scalings, `eliminant::emitted::MOST_SCALINGS`.
const MOST: usize = 8;

/// What a problem states: what must stay the same.
pub(super) struct Stated<'a> {
    pub data: &'a [DataParameter],
    pub graph: &'a ExpressionGraph,
    /// In the unknowns, then the last elements of vectors that are given up to scale.
    pub polynomials: Vec<&'a SymbolicPolynomial>,
    /// The number of unknowns.
    pub unknowns: usize,
    /// The number of vectors that are given up to scale.
    pub vectors: usize,
}

/// A linear form in the weights: columns, in order, with their factors. None is 0.
type Form = Vec<(usize, i64)>;

/// Forms that must vanish, found while the weights of values are computed.
struct Weights<'a> {
    graph: &'a ExpressionGraph,
    of_nodes: Vec<Form>,
    /// Of the coefficients of sums of products, once one of them is asked for.
    of_sums: Vec<Vec<Form>>,
    conditions: BTreeSet<Form>,
    /// Whether some weight is too large.
    is_too_large: bool,
}

/// a + factor b
fn sum(a: &[(usize, i64)], b: &[(usize, i64)], factor: i64) -> Form {
    let mut sum = Form::with_capacity(a.len() + b.len());
    let (mut a, mut b) = (a, b);
    while let ([(of_a, x), rest_of_a @ ..], [(of_b, y), rest_of_b @ ..]) = (a, b) {
        match of_a.cmp(of_b) {
            Ordering::Less => {
                sum.push((*of_a, *x));
                a = rest_of_a;
            }
            Ordering::Greater => {
                sum.push((*of_b, factor.saturating_mul(*y)));
                b = rest_of_b;
            }
            Ordering::Equal => {
                let both = x.saturating_add(factor.saturating_mul(*y));
                if both != 0 {
                    sum.push((*of_a, both));
                }
                (a, b) = (rest_of_a, rest_of_b);
            }
        }
    }
    sum.extend_from_slice(a);
    sum.extend(b.iter().map(|&(column, y)| (column, factor.saturating_mul(y))));
    sum
}

impl<'a> Weights<'a> {
    /// The weights of all nodes that these depend on. The weight of input i is in column i.
    fn of(graph: &'a ExpressionGraph, used: &[ExpressionId]) -> Self {
        let needed = graph.needed(used);
        let mut weights = Self {
            graph,
            of_nodes: Vec::with_capacity(needed.len()),
            of_sums: vec![Vec::new(); graph.product_sums().len()],
            conditions: BTreeSet::new(),
            is_too_large: false,
        };
        for (node, needed) in graph.nodes().iter().zip(needed) {
            let weight = if needed { weights.of_node(node) } else { Form::new() };
            weights.is_too_large |= weight.iter().any(|(_, value)| value.abs() > LARGEST_OF_VALUES);
            weights.of_nodes.push(weight);
        }
        weights
    }

    fn of_value(&self, id: ExpressionId) -> &Form {
        &self.of_nodes[id.index()]
    }

    fn of_node(&mut self, node: &Expression) -> Form {
        match *node {
            Expression::Constant(_) => Form::new(),
            // Equations do not depend on their solutions.
            Expression::Unknown(_) | Expression::Root(_) => Form::new(),
            Expression::Input(input) => vec![(input as usize, 1)],
            Expression::Negate(a) => self.of_value(a).clone(),
            Expression::Multiply(a, b) => sum(self.of_value(a), self.of_value(b), 1),
            Expression::Divide(a, b) => sum(self.of_value(a), self.of_value(b), -1),
            Expression::Add(a, b) | Expression::Subtract(a, b) => {
                let terms = [a, b].map(|id| (id, self.of_value(id).clone()));
                self.of_sum(terms.into_iter())
            }
            Expression::Coefficient { sum, at } => {
                let (sum, at) = (sum as usize, at as usize);
                if self.of_sums[sum].is_empty() {
                    self.of_sums[sum] = self.of_product_sum(sum);
                }
                self.of_sums[sum][at].clone()
            }
        }
    }

    /// The weights of all coefficients of a sum of products.
    fn of_product_sum(&mut self, number: usize) -> Vec<Form> {
        let graph = self.graph;
        let products = &graph.product_sums()[number];
        let mut weights: Vec<Option<Form>> = vec![None; products.length];
        let pairs = products.products.iter().flat_map(Product::pairs);
        for (place, a, b) in pairs.filter(|&(_, a, b)| !graph.is_zero(a) && !graph.is_zero(b)) {
            let term = sum(self.of_value(a), self.of_value(b), 1);
            match &weights[place] {
                Some(first) if *first == term => {}
                Some(first) => self.require(&sum(first, &term, -1)),
                None => weights[place] = Some(term),
            }
        }
        weights.into_iter().map(Option::unwrap_or_default).collect()
    }

    /// The weight of a sum, whose terms must have the same.
    fn of_sum(&mut self, terms: impl Iterator<Item = (ExpressionId, Form)>) -> Form {
        let mut terms = terms.filter(|&(id, _)| !self.graph.is_zero(id)).map(|(_, weight)| weight);
        let first = terms.next().unwrap_or_default();
        let differences: Vec<Form> = terms.map(|other| sum(&first, &other, -1)).collect();
        differences.into_iter().for_each(|difference| self.require(&difference));
        first
    }

    fn require(&mut self, form: &[(usize, i64)]) {
        // The first factor positive: a form and its negative are one condition.
        let sign = form.first().map_or(1, |(_, value)| value.signum());
        if !form.is_empty() {
            self.conditions.insert(form.iter().map(|&(column, value)| (column, sign * value)).collect());
        }
    }
}

/// A basis of the scalings of a problem. It is empty if none changes an unknown, if there are more
/// than the runtime takes, or if weights are large.
pub(super) fn scalings(stated: &Stated<'_>) -> Vec<Scaling> {
    let basis = all_scalings(stated);
    let changes_unknowns = basis.iter().any(|scaling| scaling.unknowns.iter().any(|&weight| weight != 0));
    if changes_unknowns && basis.len() <= MOST { basis } else { Vec::new() }
}

fn all_scalings(stated: &Stated<'_>) -> Vec<Scaling> {
    let inputs = stated.graph.input_count();
    let polynomials = || stated.polynomials.iter();
    let used: Vec<ExpressionId> = polynomials().flat_map(|p| p.terms()).map(|&(_, coefficient)| coefficient).collect();
    let mut weights = Weights::of(stated.graph, &used);
    for polynomial in polynomials() {
        let terms = polynomial.terms().iter().map(|&(monomial, coefficient)| {
            let exponents = (0..stated.unknowns + stated.vectors).map(|unknown| i64::from(monomial.exponent(unknown)));
            let of_monomial: Form = (inputs..).zip(exponents).filter(|&(_, exponent)| exponent != 0).collect();
            (coefficient, sum(weights.of_value(coefficient), &of_monomial, 1))
        });
        let terms: Vec<_> = terms.collect();
        weights.of_sum(terms.into_iter());
    }
    stated.data.iter().for_each(|parameter| keep_on_variety(parameter, &mut weights));
    fix_unread(stated, &mut weights);
    keep_orthonormal(stated.graph, &mut weights);
    let last = inputs + stated.unknowns..inputs + stated.unknowns + stated.vectors;
    last.for_each(|column| weights.require(&[(column, 1)]));
    if weights.is_too_large {
        return Vec::new();
    }
    null_space(&weights.conditions, inputs, stated)
}

/// Scaled data must satisfy what is stated of them.
fn keep_on_variety(parameter: &DataParameter, weights: &mut Weights<'_>) {
    let all = parameter.first_input..parameter.first_input + parameter.len();
    let columns = parameter.shape.last().copied().unwrap_or(1);
    match parameter.attribute {
        DataAttribute::Generic => {}
        DataAttribute::Rotation | DataAttribute::Unit | DataAttribute::Integer => {
            all.for_each(|input| weights.require(&[(input, 1)]));
        }
        // Directions and moments have a factor each, which all lines share.
        DataAttribute::Plucker => {
            let first = all.start;
            for input in all.skip(1).filter(|input| input - first != 3) {
                let of_its_kind = first + (input - first) / 3 % 2 * 3;
                weights.require(&[(of_its_kind, 1), (input, -1)]);
            }
        }
        DataAttribute::Symmetric => {
            for (row, column) in (0..columns).flat_map(|row| (0..row).map(move |column| (row, column))) {
                let [entry, mirrored] = [(row, column), (column, row)].map(|(i, j)| all.start + i * columns + j);
                weights.require(&sum(&[(entry, 1)], &[(mirrored, 1)], -1));
            }
        }
        // Factors of rows and columns keep the rank of a matrix.
        DataAttribute::Rank(_) => {
            let size = columns * parameter.shape.iter().rev().nth(1).copied().unwrap_or(1);
            for input in all.clone().filter(|input| (input - all.start) % size > 0) {
                let matrix = all.start + (input - all.start) / size * size;
                let (row, column) = ((input - matrix) / columns, (input - matrix) % columns);
                let corners = [(matrix, 1), (matrix + column, -1), (matrix + row * columns, -1), (input, 1)];
                let mut form = Form::new();
                corners.iter().for_each(|&(at, factor)| form = sum(&form, &[(at, 1)], factor));
                weights.require(&form);
            }
        }
    }
}

/// The vectors that span a null space have length 1. What changes one of them changes all alike.
fn keep_orthonormal(graph: &ExpressionGraph, weights: &mut Weights<'_>) {
    for derivation in graph.derivations() {
        let DerivationKind::NullSpace { columns, .. } = derivation.kind else { continue };
        let first = derivation.inputs().start;
        for input in derivation.inputs().skip(columns) {
            weights.require(&[(first + (input - first) % columns, 1), (input, -1)]);
        }
    }
}

/// Data that no equation reads stay as they are, but those whose weights follow from others: the
/// mirrored entries of symmetric matrices, and those of lines.
fn fix_unread(stated: &Stated<'_>, weights: &mut Weights<'_>) {
    // The weight of an input that is read is that of its own column, and of no other input.
    let nodes = stated.graph.nodes().iter().zip(&weights.of_nodes);
    let reads = nodes.filter(|(node, _)| matches!(node, Expression::Input(_)));
    let reads: BTreeSet<usize> = reads.flat_map(|(_, weight)| weight.iter().map(|&(column, _)| column)).collect();
    let follows =
        |parameter: &&DataParameter| matches!(parameter.attribute, DataAttribute::Symmetric | DataAttribute::Plucker);
    let parameters = stated.data.iter().filter(|parameter| !follows(parameter));
    let given = parameters.flat_map(|parameter| parameter.first_input..parameter.first_input + parameter.len());
    let derived = stated.data.iter().map(DataParameter::len).sum()..stated.graph.input_count();
    for input in given.chain(derived).filter(|input| !reads.contains(input)) {
        weights.require(&[(input, 1)]);
    }
}

/// Integer vectors that span the weights that satisfy all conditions. Unknowns come last, so that
/// the weights of data follow from theirs.
fn null_space(conditions: &BTreeSet<Form>, inputs: usize, stated: &Stated<'_>) -> Vec<Scaling> {
    let field = PrimeField::new(PRIMES[0]);
    let columns = inputs + stated.unknowns + stated.vectors;
    let mut echelon = Echelon::new(field, columns);
    for condition in conditions {
        let row: Vec<(u32, u32)> =
            condition.iter().map(|&(column, value)| (column as u32, field.from_integer(value))).collect();
        echelon.insert_sparse(&row);
    }
    echelon.back_reduce();
    let free: Vec<usize> = (0..columns).filter(|&column| !echelon.is_pivot(column)).collect();
    let basis: Option<Vec<Scaling>> = free
        .into_iter()
        .map(|column| {
            let weights = integer_solution(&echelon, column)?;
            let satisfied = |condition: &Form| {
                condition.iter().map(|&(at, value)| value * i64::from(weights[at])).sum::<i64>() == 0
            };
            let unknowns = weights[inputs..inputs + stated.unknowns].to_vec();
            conditions.iter().all(satisfied).then(|| Scaling { data: weights[..inputs].to_vec(), unknowns })
        })
        .collect();
    basis.unwrap_or_default()
}

/// The solution in which this free column is positive and all other free ones are 0, in lowest
/// integers.
fn integer_solution(echelon: &Echelon, free: usize) -> Option<Vec<i8>> {
    let field = echelon.field();
    let mut values = vec![0; echelon.columns()];
    values[free] = 1;
    for pivot in echelon.pivot_columns() {
        let entry = echelon.row(pivot).into_iter().find(|&(column, _)| column as usize == free);
        values[pivot] = entry.map_or(0, |(_, value)| field.neg(value));
    }
    let signed = |value: u32| {
        let value = i64::from(value);
        if value > i64::from(field.modulus()) / 2 { value - i64::from(field.modulus()) } else { value }
    };
    (1..=LARGEST).find_map(|scale| {
        let scaled = values.iter().map(|&value| signed(field.mul(value, field.from_integer(scale))));
        scaled.map(|value| i8::try_from(value).ok().filter(|value| i64::from(value.abs()) <= LARGEST)).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::Problem;

    fn of_text(text: &str) -> Vec<Scaling> {
        Problem::parse("problem.rs", text).expect("a problem").scalings
    }

    #[cfg(feature = "search")]
    #[test]
    fn the_runtime_takes_as_many() {
        assert_eq!(MOST, eliminant::emitted::MOST_SCALINGS);
    }

    #[test]
    fn lengths_have_a_unit() {
        let found = of_text(
            "fn f(a: [f64; 2], r: f64, k: f64) -> (x, y) { x * y == a[0] * a[1]; x * x + y * y == r * r; k * x == y; }",
        );
        // The two lengths whose product is an area may change against each other.
        let area = Scaling { data: vec![-1, 1, 0, 0], unknowns: vec![0, 0] };
        let lengths = Scaling { data: vec![2, 0, 1, 0], unknowns: vec![1, 1] };
        assert_eq!(found, [area, lengths]);
    }

    #[test]
    fn data_with_conditions_and_constants_have_none() {
        for text in [
            "fn f(#[unit] u: [f64; 2]) -> (x, y) { u[0] * x == u[1]; y * y == u[0]; }",
            "fn f(#[integer] n: f64) -> x { x * x == n; }",
            "fn f(a: f64) -> x { x * x + x + 1 == a; }",
            "fn f(a: f64) -> (x, y) { x * a == 1 + a; y * y == x; }",
        ] {
            assert_eq!(of_text(text), [], "{text}");
        }
    }

    #[test]
    fn mirrored_entries_have_one_weight() {
        let found = of_text(
            "fn f(#[symmetric] m: [[f64; 2]; 2]) -> (x, y) { let w = m * [x, y]; w[0] == 1; w[1] == x * x * y; }",
        );
        // The weights of m00 x, m01 y are 0; those of m01 x, m11 y and x^2 y are the same.
        assert_eq!(found, [Scaling { data: vec![2, -1, -1, -4], unknowns: vec![-2, 1] }]);
    }

    #[test]
    fn matrices_keep_their_rank() {
        let found = of_text(
            "fn f(#[rank(1)] m: [[f64; 2]; 2], c: f64) -> (x, y) {
                x * x == m[0][0] * c; y * x == m[0][1]; y == m[1][0] + m[1][1];
            }",
        );
        // A factor of the first row and one of the second, with those of the columns that follow.
        let first = Scaling { data: vec![1, 1, 0, 0, 1], unknowns: vec![1, 0] };
        let all = Scaling { data: vec![1, 1, 1, 1, -1], unknowns: vec![0, 1] };
        assert_eq!(found, [first, all]);
    }

    #[test]
    fn lines_have_a_unit() {
        let found = of_text(
            "fn f(#[plucker] l: [[[f64; 3]; 2]; 2]) -> x { x * (l[0][0][0] + l[1][0][1]) == l[0][1][0] + l[1][1][2]; }",
        );
        let all = Scaling { data: vec![1; 12], unknowns: vec![0] };
        let directions = Scaling { data: [-1, -1, -1, 0, 0, 0].repeat(2), unknowns: vec![1] };
        assert_eq!(found, [all, directions]);
    }

    /// The scale of a vector is no unit. Its elements have units of their own.
    #[test]
    fn elements_of_a_vector_up_to_scale_have_units() {
        let found = of_text(
            "fn f(#[unit] u: [f64; 2], a: [f64; 2]) -> (#[projective] line: [f64; 3], s) {
                dot([u[0], u[1]], [line[0], line[1]]) == 0;
                a[0] * line[0] + a[1] * line[1] == line[2];
                s * line[0] == line[2];
            }",
        );
        assert_eq!(found, [Scaling { data: vec![0, 0, 1, 1], unknowns: vec![-1, -1, 1] }]);
    }

    #[test]
    fn weights_that_are_large_are_none() {
        assert_eq!(of_text("fn f(a: f64) -> x { x == a.pow(32) * a; }"), []);
        let doubled: String = (0..60).map(|k| format!("let a{} = a{k} * a{k};", k + 1)).collect();
        let powers = format!("fn f(a: f64) -> x {{ let a0 = a; {doubled} x * x == a60; }}");
        assert_eq!(of_text(&powers), []);
    }
}
