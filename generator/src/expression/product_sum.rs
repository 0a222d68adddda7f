//! Sums of products of polynomials, kept whole: a few loops instead of thousands of scalar
//! operations.

use super::arithmetic::Arithmetic;

/// The coefficients of a polynomial p q ± p' q' ± .., where p, q, .. are given by the values of
/// their coefficients.
///
/// ```text
///   coefficient k = sum of ± left[i] * right[j]
///                   over all products, i and j with places[i * |right| + j] = k
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProductSum<Id> {
    /// The products, in the order of summation.
    pub products: Vec<Product<Id>>,
    /// The number of coefficients of the sum.
    pub length: usize,
}

/// One product of a [`ProductSum`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Product<Id> {
    /// Whether it is subtracted.
    pub negative: bool,
    /// The coefficients of the left factor.
    pub left: Vec<Id>,
    /// The coefficients of the right factor.
    pub right: Vec<Id>,
    /// For each coefficient of the left factor, the positions in the sum of its products with those
    /// of the right factor.
    pub places: Vec<u32>,
}

impl<Id: Copy> Product<Id> {
    /// (k, left\[i\], right\[j\]): the products of coefficients, each with the coefficient of the
    /// sum that it is added to.
    pub fn pairs(&self) -> impl Iterator<Item = (usize, Id, Id)> + '_ {
        let factors = self.left.iter().flat_map(|&left| self.right.iter().map(move |&right| (left, right)));
        factors.zip(&self.places).map(|((left, right), &place)| (place as usize, left, right))
    }
}

impl<Id: Copy> ProductSum<Id> {
    /// All values that the sum reads; a value that several products read comes several times.
    pub fn operands(&self) -> impl Iterator<Item = Id> + '_ {
        self.products.iter().flat_map(|product| product.left.iter().chain(&product.right)).copied()
    }

    /// Multiplications, additions and subtractions.
    pub fn operations(&self) -> usize {
        let pairs: usize = self.products.iter().map(|product| product.places.len()).sum();
        (2 * pairs).saturating_sub(self.length)
    }

    /// The products whose sum coefficient `at` is: whether each is subtracted, and its two factors.
    pub fn terms(&self, at: usize) -> impl Iterator<Item = (bool, Id, Id)> + '_ {
        self.products.iter().flat_map(move |product| {
            let own = product.pairs().filter(move |&(place, ..)| place == at);
            own.map(|(_, left, right)| (product.negative, left, right))
        })
    }

    /// The values of the coefficients. The first product of each is taken as it is, the others are
    /// added one after another.
    pub fn evaluate<A: Arithmetic>(&self, f: A, value: impl Fn(Id) -> A::Value) -> Vec<A::Value> {
        let mut sums: Vec<Option<A::Value>> = vec![None; self.length];
        for product in &self.products {
            for (place, left, right) in product.pairs() {
                let term = f.mul(value(left), value(right));
                sums[place] = Some(match (sums[place], product.negative) {
                    (None, false) => term,
                    (None, true) => f.neg(term),
                    (Some(sum), false) => f.add(sum, term),
                    (Some(sum), true) => f.sub(sum, term),
                });
            }
        }
        sums.into_iter().map(|sum| sum.unwrap_or(f.zero())).collect()
    }

    /// The same sum with each value replaced.
    #[must_use]
    pub fn map<To>(&self, to: impl Fn(Id) -> To) -> ProductSum<To> {
        let all = |ids: &[Id]| ids.iter().map(|&id| to(id)).collect();
        let product = |product: &Product<Id>| Product {
            negative: product.negative,
            left: all(&product.left),
            right: all(&product.right),
            places: product.places.clone(),
        };
        ProductSum { products: self.products.iter().map(product).collect(), length: self.length }
    }
}
