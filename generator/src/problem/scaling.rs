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

use std::collections::{BTreeMap, BTreeSet};

use super::{DataAttribute, DataParameter, Problem};
use crate::algebra::{Echelon, PRIMES, PrimeField};
use crate::expression::{Expression, ExpressionGraph, ExpressionId};

/// Larger weights are not taken: powers of the scale would leave the range of `f64` soon.
const LARGEST: i64 = 32;

/// The runtime takes no more scalings, `eliminant::emitted::MOST_SCALINGS`.
const MOST: usize = 8;

/// A direction of scalings: the weights of all data, and of all unknowns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scaling {
    /// One weight per scalar of the data.
    pub data: Vec<i8>,
    /// One weight per unknown.
    pub unknowns: Vec<i8>,
}

/// A linear form in the weights: the column of each and its factor.
type Form = BTreeMap<usize, i64>;

/// Forms that must vanish, found while the weights of values are computed.
struct Weights<'a> {
    graph: &'a ExpressionGraph,
    of_nodes: Vec<Form>,
    conditions: BTreeSet<Vec<(usize, i64)>>,
}

fn sum(a: &Form, b: &Form, factor: i64) -> Form {
    let mut sum = a.clone();
    for (&column, &value) in b {
        *sum.entry(column).or_default() += factor * value;
    }
    sum.retain(|_, value| *value != 0);
    sum
}

impl<'a> Weights<'a> {
    /// The weights of all nodes that these depend on. The weight of input i is in column i.
    fn of(graph: &'a ExpressionGraph, used: &[ExpressionId]) -> Self {
        let needed = graph.needed(used);
        let mut weights = Self { graph, of_nodes: Vec::with_capacity(needed.len()), conditions: BTreeSet::new() };
        for (node, needed) in graph.nodes().iter().zip(needed) {
            let weight = if needed { weights.of_node(node) } else { Form::new() };
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
            Expression::Input(input) => Form::from([(input as usize, 1)]),
            Expression::Negate(a) => self.of_value(a).clone(),
            Expression::Multiply(a, b) => sum(self.of_value(a), self.of_value(b), 1),
            Expression::Divide(a, b) => sum(self.of_value(a), self.of_value(b), -1),
            Expression::Add(a, b) | Expression::Subtract(a, b) => {
                let terms = [a, b].map(|id| (id, self.of_value(id).clone()));
                self.of_sum(terms.into_iter())
            }
            Expression::Coefficient { sum: number, at } => {
                let products = self.graph.product_sums()[number as usize].terms(at as usize);
                let terms: Vec<_> = products
                    .filter(|&(_, a, b)| !self.graph.is_zero(a) && !self.graph.is_zero(b))
                    .map(|(_, a, b)| (ExpressionGraph::ONE, sum(self.of_value(a), self.of_value(b), 1)))
                    .collect();
                self.of_sum(terms.into_iter())
            }
        }
    }

    /// The weight of a sum, whose terms must have the same.
    fn of_sum(&mut self, terms: impl Iterator<Item = (ExpressionId, Form)>) -> Form {
        let mut terms = terms.filter(|&(id, _)| !self.graph.is_zero(id)).map(|(_, weight)| weight);
        let first = terms.next().unwrap_or_default();
        let differences: Vec<Form> = terms.map(|other| sum(&first, &other, -1)).collect();
        differences.into_iter().for_each(|difference| self.require(&difference));
        first
    }

    fn require(&mut self, form: &Form) {
        // The first factor positive: a form and its negative are one condition.
        let sign = form.values().next().map_or(1, |value| value.signum());
        if !form.is_empty() {
            self.conditions.insert(form.iter().map(|(&column, &value)| (column, sign * value)).collect());
        }
    }
}

/// A basis of the scalings of a problem. It is empty if none changes an unknown, if there are more
/// than the runtime takes, or if weights are large.
pub fn scalings(problem: &Problem) -> Vec<Scaling> {
    let basis = all_scalings(problem);
    let changes_unknowns = basis.iter().any(|scaling| scaling.unknowns.iter().any(|&weight| weight != 0));
    if changes_unknowns && basis.len() <= MOST { basis } else { Vec::new() }
}

fn all_scalings(problem: &Problem) -> Vec<Scaling> {
    let inputs = problem.input_count();
    let polynomials = || problem.equations.iter().chain(&problem.nonzero).map(|statement| &statement.polynomial);
    let used: Vec<ExpressionId> = polynomials().flat_map(|p| p.terms()).map(|&(_, coefficient)| coefficient).collect();
    let mut weights = Weights::of(&problem.graph, &used);
    for polynomial in polynomials() {
        let terms = polynomial.terms().iter().map(|&(monomial, coefficient)| {
            let exponents = (0..problem.unknowns.len()).map(|unknown| i64::from(monomial.exponent(unknown)));
            let of_monomial = (inputs..).zip(exponents).filter(|&(_, exponent)| exponent != 0).collect();
            (coefficient, sum(weights.of_value(coefficient), &of_monomial, 1))
        });
        let terms: Vec<_> = terms.collect();
        weights.of_sum(terms.into_iter());
    }
    problem.data.iter().for_each(|parameter| keep_on_variety(parameter, &mut weights));
    fix_unread(problem, &used, &mut weights);
    null_space(&weights.conditions, inputs, problem.unknowns.len())
}

/// Scaled data must satisfy what is stated of them.
fn keep_on_variety(parameter: &DataParameter, weights: &mut Weights<'_>) {
    let all = parameter.first_input..parameter.first_input + parameter.len();
    let columns = parameter.shape.last().copied().unwrap_or(1);
    match parameter.attribute {
        DataAttribute::Generic => {}
        DataAttribute::Rotation | DataAttribute::Unit | DataAttribute::Plucker | DataAttribute::Integer => {
            all.for_each(|input| weights.require(&Form::from([(input, 1)])));
        }
        DataAttribute::Symmetric => {
            for (row, column) in (0..columns).flat_map(|row| (0..row).map(move |column| (row, column))) {
                let [entry, mirrored] = [(row, column), (column, row)].map(|(i, j)| all.start + i * columns + j);
                weights.require(&Form::from([(entry, 1), (mirrored, -1)]));
            }
        }
        // A factor of the whole matrix keeps its rank.
        DataAttribute::Rank(_) => {
            let first = all.start;
            all.skip(1).for_each(|input| weights.require(&Form::from([(first, 1), (input, -1)])));
        }
    }
}

/// Data that no equation reads stay as they are, but the mirrored entries of symmetric ones.
fn fix_unread(problem: &Problem, used: &[ExpressionId], weights: &mut Weights<'_>) {
    let needed = problem.graph.needed(used);
    let reads: BTreeSet<usize> = problem
        .graph
        .nodes()
        .iter()
        .zip(needed)
        .filter_map(|(node, needed)| match node {
            Expression::Input(input) if needed => Some(*input as usize),
            _ => None,
        })
        .collect();
    for parameter in problem.data.iter().filter(|parameter| parameter.attribute != DataAttribute::Symmetric) {
        for input in (parameter.first_input..).take(parameter.len()).filter(|input| !reads.contains(input)) {
            weights.require(&Form::from([(input, 1)]));
        }
    }
}

/// Integer vectors that span the weights that satisfy all conditions. Unknowns come last, so that
/// the weights of data follow from theirs.
fn null_space(conditions: &BTreeSet<Vec<(usize, i64)>>, inputs: usize, unknowns: usize) -> Vec<Scaling> {
    let field = PrimeField::new(PRIMES[0]);
    let mut echelon = Echelon::new(field, inputs + unknowns);
    for condition in conditions {
        let row: Vec<(u32, u32)> =
            condition.iter().map(|&(column, value)| (column as u32, field.from_integer(value))).collect();
        echelon.insert_sparse(&row);
    }
    echelon.back_reduce();
    let free: Vec<usize> = (0..inputs + unknowns).filter(|&column| !echelon.is_pivot(column)).collect();
    let basis: Option<Vec<Scaling>> = free
        .into_iter()
        .map(|column| {
            let weights = integer_solution(&echelon, column)?;
            let satisfied = |condition: &Vec<(usize, i64)>| {
                condition.iter().map(|&(at, value)| value * i64::from(weights[at])).sum::<i64>() == 0
            };
            let (data, unknowns) = weights.split_at(inputs);
            conditions.iter().all(satisfied).then(|| Scaling { data: data.to_vec(), unknowns: unknowns.to_vec() })
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
