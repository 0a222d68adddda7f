//! Minors of a matrix of polynomials.

use super::reduced::MAX_TERMS;
use crate::algebra::Monomial;
use crate::expression::{ExpressionGraph, SignedProduct, SymbolicPolynomial};

/// No matrix with more minors is expanded.
const MOST_MINORS: usize = 20;

/// Products of so many terms are formed in loops.
const LONG_PRODUCT: usize = 100;

/// All minors of as many rows as there are columns, with the first of their rows. Those of the
/// first k columns, one for each set of k rows, are expanded along their last column.
pub(super) fn minors(
    graph: &mut ExpressionGraph,
    rows: &[Vec<SymbolicPolynomial>],
) -> Option<Vec<(usize, SymbolicPolynomial)>> {
    let columns = rows.first()?.len();
    let sets = |size: usize| (0u32..1 << rows.len()).filter(move |set| set.count_ones() as usize == size);
    if sets(columns).count() > MOST_MINORS {
        return None;
    }
    let one = graph.term(ExpressionGraph::ONE, Monomial::ONE);
    let mut minors: Vec<(u32, SymbolicPolynomial)> = vec![(0, one)];
    for column in 0..columns {
        let mut next = Vec::new();
        for set in sets(column + 1) {
            let members = (0..rows.len()).filter(|&row| set >> row & 1 == 1);
            let products: Vec<SignedProduct<'_>> = members
                .filter_map(|row| {
                    let at = minors.binary_search_by_key(&(set & !(1 << row)), |&(set, _)| set).ok()?;
                    let position = (set & ((1 << row) - 1)).count_ones() as usize;
                    Some(((column + position) % 2 == 1, &rows[row][column], &minors[at].1))
                })
                .filter(|(_, entry, minor)| !entry.is_zero() && !minor.is_zero())
                .collect();
            next.push((set, sum(graph, &products)?));
        }
        minors = next;
    }
    Some(minors.into_iter().map(|(set, minor)| (set.trailing_zeros() as usize, minor)).collect())
}

/// The sum of products, as [`ExpressionGraph::polynomial_product_sum`] where factors are long.
pub(super) fn sum(graph: &mut ExpressionGraph, products: &[SignedProduct<'_>]) -> Option<SymbolicPolynomial> {
    if products.iter().any(|(_, entry, minor)| entry.terms().len() * minor.terms().len() >= LONG_PRODUCT) {
        return graph.polynomial_product_sum(products);
    }
    products.iter().try_fold(SymbolicPolynomial::ZERO, |sum, (is_negative, entry, minor)| {
        let product = graph.polynomial_mul(entry, minor)?;
        let sum =
            if *is_negative { graph.polynomial_sub(&sum, &product) } else { graph.polynomial_add(&sum, &product) };
        (sum.terms().len() <= MAX_TERMS).then_some(sum)
    })
}
