//! What the values of a graph depend on.

use super::graph::{Expression, ExpressionGraph, ExpressionId};
use super::product_sum::ProductSum;

impl ExpressionGraph {
    /// Which nodes these depend on, themselves included. Derived data depend on nothing here.
    pub fn needed(&self, used: &[ExpressionId]) -> Vec<bool> {
        let mut needed = vec![false; self.nodes().len()];
        used.iter().for_each(|id| needed[id.index()] = true);
        // All coefficients of a sum have the same operands, which come before the first of them.
        let mut seen = vec![false; self.product_sums().len()];
        for (at, &node) in self.nodes().iter().enumerate().rev() {
            let mut is_seen = |sum: u32| std::mem::replace(&mut seen[sum as usize], true);
            if needed[at] && !matches!(node, Expression::Coefficient { sum, .. } if is_seen(sum)) {
                // Each part by itself: a search does this for each template, and compilers leave
                // the chained iterators of `operands` as calls.
                let (scalars, sum) = self.parts(node);
                scalars.into_iter().flatten().for_each(|id| needed[id.index()] = true);
                sum.into_iter().flat_map(ProductSum::operands).for_each(|id| needed[id.index()] = true);
            }
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
