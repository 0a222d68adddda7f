//! What the values of a graph depend on.

use super::derivation::DerivationKind;
use super::graph::{Expression, ExpressionGraph, ExpressionId};
use super::product_sum::ProductSum;

impl ExpressionGraph {
    /// Which nodes these depend on, themselves included. Derived data depend on nothing here.
    pub fn needed(&self, used: &[ExpressionId]) -> Vec<bool> {
        self.needed_by_way_of_derivations(used, |_| false)
    }

    /// Which nodes these depend on, also by way of data that are derived in ways that count.
    pub(crate) fn needed_by_way_of_derivations(
        &self,
        used: &[ExpressionId],
        counts: impl Fn(DerivationKind) -> bool,
    ) -> Vec<bool> {
        let mut needed = vec![false; self.nodes().len()];
        used.iter().for_each(|id| needed[id.index()] = true);
        // Operands stand before their results: one pass meets all.
        let mut derivations = self.derivations().iter().filter(|derivation| counts(derivation.kind)).rev().peekable();
        // All coefficients of a sum have the same operands, which come before the first of them.
        let mut seen = vec![false; self.product_sums().len()];
        for (at, &node) in self.nodes().iter().enumerate().rev() {
            if !needed[at] {
                continue;
            }
            let mut mark = |id: ExpressionId| needed[id.index()] = true;
            match node {
                Expression::Coefficient { sum, .. } if std::mem::replace(&mut seen[sum as usize], true) => continue,
                Expression::Input(input) => {
                    while derivations.next_if(|derivation| derivation.first_input > input as usize).is_some() {}
                    let derivation = derivations.next_if(|derivation| derivation.inputs().contains(&(input as usize)));
                    derivation.into_iter().flat_map(|derivation| &derivation.operands).for_each(|&id| mark(id));
                }
                _ => {}
            }
            // Each part by itself: a search does this for each template, and compilers leave the
            // chained iterators of `operands` as calls.
            let (scalars, sum) = self.parts(node);
            scalars.into_iter().flatten().for_each(&mut mark);
            sum.into_iter().flat_map(ProductSum::operands).for_each(mark);
        }
        needed
    }

    /// What a node is computed from; for a coefficient all operands of its sum.
    pub fn operands(&self, node: Expression) -> impl Iterator<Item = ExpressionId> + '_ {
        let (scalars, sum) = self.parts(node);
        scalars.into_iter().flatten().chain(sum.into_iter().flat_map(ProductSum::operands))
    }

    /// The operands of a node, and the sum of which it is a coefficient.
    fn parts(&self, node: Expression) -> ([Option<ExpressionId>; 2], Option<&ProductSum<ExpressionId>>) {
        match node {
            Expression::Constant(_) | Expression::Input(_) | Expression::Unknown(_) => ([None, None], None),
            Expression::Negate(a) | Expression::Root(a) => ([Some(a), None], None),
            Expression::Add(a, b)
            | Expression::Subtract(a, b)
            | Expression::Multiply(a, b)
            | Expression::Divide(a, b) => ([Some(a), Some(b)], None),
            Expression::Coefficient { sum, .. } => ([None, None], self.product_sums().get(sum as usize)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Derived data depend on what they are derived from, also through other derived data, if that
    /// way counts; data between them are not read.
    #[test]
    fn derivations_lead_to_given_data() {
        let mut graph = ExpressionGraph::new(&[vec![3, 5, 7, 11], vec![3, 5, 7, 11]]);
        let quotient = DerivationKind::Solve { size: 1, right: 1 };
        let given: Vec<ExpressionId> = (0..4).map(|input| graph.input(input)).collect();
        let first = graph.derive(quotient, &[given[0], given[1]]).expect("3 is invertible")[0];
        let other = graph.derive(quotient, &[given[2], given[3]]).expect("7 is invertible")[0];
        let last = graph.derive(quotient, &[first, given[2]]).expect("5 / 3 is invertible")[0];
        assert_eq!(graph.given_inputs_of(&[first], 4), [true, true, false, false]);
        assert_eq!(graph.given_inputs_of(&[other], 4), [false, false, true, true]);
        assert_eq!(graph.given_inputs_of(&[last], 4), [true, true, true, false]);
        assert_eq!(graph.given_inputs_of(&[last, other], 4), [true; 4]);
        let roots_only = graph.needed_by_way_of_derivations(&[last], |kind| kind == DerivationKind::SquareRoot);
        assert_eq!(roots_only, graph.needed(&[last]));
        assert!(given.iter().all(|id| !roots_only[id.index()]));
    }
}
