//! Values of the problem language: arrays of polynomials, with exact and bounded arithmetic.

use crate::algebra::{MAX_UNKNOWNS, Monomial, Polynomial};
use crate::expression::rational::Rational;
use crate::expression::{ExpressionGraph, ExpressionId, SignedProduct, SymbolicPolynomial};
use crate::problem::diagnostic::Diagnostic;

/// The place of the imaginary unit among the unknowns of a monomial: the last one.
pub(super) const IMAGINARY_UNIT: usize = MAX_UNKNOWNS - 1;

/// Largest number of elements of one array.
pub(super) const MAX_ELEMENTS: usize = 10_000;

/// Largest total degree of a polynomial, intermediate ones included.
pub(super) const MAX_DEGREE: i32 = 32;

/// Largest amount of work of one problem file: half a second, not hours. Each operation on a term,
/// each term or element that is copied and each evaluation of an expression counts; the largest
/// problem of the catalogue takes less than a fifth.
const MAX_WORK: usize = 2_000_000;

/// A product of polynomials stays one operation if it has at least this many products of
/// coefficients that depend on data. Fewer are cheaper as scalar operations, because equal ones are
/// shared.
const LONG_PRODUCT: usize = 100;

/// An array of polynomials in the unknowns; a scalar has no dimensions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Value {
    /// Outermost dimension first.
    shape: Vec<usize>,
    /// Row by row; as many as the product of the dimensions.
    elements: Vec<SymbolicPolynomial>,
}

/// An operation that the shapes, the degree or the amount of work forbid: a message whose place the
/// caller knows.
pub(super) type Checked<T> = Result<T, Diagnostic>;

/// A message without its place.
pub(super) fn fault(message: impl Into<String>) -> Diagnostic {
    Diagnostic::new(message, 0..0)
}

/// A shape as it is written in a signature.
pub(super) fn describe(shape: &[usize]) -> String {
    match shape {
        [] => "a scalar".to_owned(),
        _ => format!("`{}`", shape.iter().rev().fold("f64".to_owned(), |inner, n| format!("[{inner}; {n}]"))),
    }
}

/// What it takes to copy a polynomial.
fn polynomial_weight(polynomial: &SymbolicPolynomial) -> usize {
    1 + polynomial.terms().len()
}

impl Value {
    /// A scalar.
    pub(super) fn scalar(polynomial: SymbolicPolynomial) -> Self {
        Self { shape: Vec::new(), elements: vec![polynomial] }
    }

    /// An array of the given shape.
    pub(super) fn array(shape: Vec<usize>, elements: Vec<SymbolicPolynomial>) -> Self {
        debug_assert_eq!(shape.iter().product::<usize>(), elements.len());
        Self { shape, elements }
    }

    /// The array of values of one shape; `None` if there are none or their shapes differ.
    pub(super) fn stack(items: Vec<Self>) -> Option<Self> {
        let inner = items.first()?.shape.clone();
        if items.iter().any(|item| item.shape != inner) {
            return None;
        }
        let shape = [&[items.len()][..], &inner].concat();
        Some(Self::array(shape, items.into_iter().flat_map(|item| item.elements).collect()))
    }

    /// Outermost dimension first.
    pub(super) fn shape(&self) -> &[usize] {
        &self.shape
    }

    /// The elements, row by row.
    pub(super) fn elements(&self) -> &[SymbolicPolynomial] {
        &self.elements
    }

    /// What it takes to copy the value.
    pub(super) fn weight(&self) -> usize {
        self.elements.iter().map(polynomial_weight).sum()
    }

    /// The polynomial of a scalar.
    pub(super) fn as_scalar(&self) -> Option<&SymbolicPolynomial> {
        match self.shape[..] {
            [] => self.elements.first(),
            _ => None,
        }
    }

    /// Whether this is the scalar 0.
    pub(super) fn is_scalar_zero(&self) -> bool {
        self.as_scalar().is_some_and(SymbolicPolynomial::is_zero)
    }

    /// The values along the outermost dimension; empty for a scalar.
    pub(super) fn rows(&self) -> impl Iterator<Item = Self> + '_ {
        let inner = self.shape.get(1..).unwrap_or(&[]);
        let size = inner.iter().product::<usize>().max(1);
        let rows = if self.shape.is_empty() { &[] } else { &self.elements[..] };
        rows.chunks(size).map(move |row| Self::array(inner.to_vec(), row.to_vec()))
    }

    /// First element and shape of the sub-array at `indices`; or the position of the offending
    /// index and why.
    pub(super) fn locate(&self, indices: &[i64]) -> Result<(usize, &[usize]), (usize, Diagnostic)> {
        let mut first = 0;
        let mut shape = &self.shape[..];
        for (position, &index) in indices.iter().enumerate() {
            let Some((&length, inner)) = shape.split_first() else {
                let message = match position {
                    0 => "a scalar cannot be indexed".to_owned(),
                    _ => format!("{} has no index number {}", describe(&self.shape), position + 1),
                };
                return Err((position, fault(message).label("one index too many")));
            };
            let Some(index) = usize::try_from(index).ok().filter(|&index| index < length) else {
                let label = format!("the indices of {} run from 0 to {}", describe(shape), length - 1);
                return Err((position, fault(format!("index {index} is out of range")).label(label)));
            };
            first += index * inner.iter().product::<usize>();
            shape = inner;
        }
        Ok((first, shape))
    }

    /// The sub-array at `indices`.
    pub(super) fn select(&self, indices: &[i64]) -> Result<Self, (usize, Diagnostic)> {
        let (first, shape) = self.locate(indices)?;
        let size: usize = shape.iter().product();
        Ok(Self::array(shape.to_vec(), self.elements[first..first + size].to_vec()))
    }

    /// Replaces elements from `first` on, a place found by [`Value::locate`].
    pub(super) fn replace(&mut self, first: usize, part: &Self) {
        self.elements[first..first + part.elements.len()].clone_from_slice(&part.elements);
    }

    /// The transpose of a matrix.
    pub(super) fn transpose(&self) -> Checked<Self> {
        let [rows, columns] = self.shape[..] else {
            return Err(fault("only a matrix has a transpose")
                .label(format!("this is {}", describe(&self.shape)))
                .hint("a vector needs none: `dot(a, b)` is the scalar product, `a * m` takes `a` as a row"));
        };
        let elements = (0..columns).flat_map(|j| (0..rows).map(move |i| (i, j)));
        let elements = elements.map(|(i, j)| self.elements[i * columns + j].clone()).collect();
        Ok(Self::array(vec![columns, rows], elements))
    }
}

/// Polynomial arithmetic that refuses to grow without bound.
pub(super) struct Algebra {
    /// The coefficients.
    pub(super) graph: ExpressionGraph,
    /// Whether polynomials may hold i.
    pub(super) has_imaginary_unit: bool,
    work_left: usize,
}

impl Algebra {
    /// Arithmetic over `graph`.
    pub(super) fn new(graph: ExpressionGraph) -> Self {
        Self { graph, has_imaginary_unit: false, work_left: MAX_WORK }
    }

    /// Whether the work allowed is used up.
    pub(super) fn is_exhausted(&self) -> bool {
        self.work_left == 0
    }

    /// Gives up: nothing more is computed or reported.
    pub(super) fn exhaust(&mut self) {
        self.work_left = 0;
    }

    /// Takes note of work about to be done.
    pub(super) fn charge(&mut self, work: usize) -> Checked<()> {
        self.work_left = self.work_left.saturating_sub(work);
        match self.work_left {
            0 => Err(fault("the problem is too large to be expanded")
                .label(format!("more than {MAX_WORK} steps up to here"))
                .hint("use fewer iterations and calls, smaller arrays, or unknowns for subexpressions")),
            _ => Ok(()),
        }
    }

    /// A constant polynomial.
    pub(super) fn constant(&mut self, value: Rational) -> SymbolicPolynomial {
        let constant = self.graph.constant(value);
        self.coefficient(constant, value.is_zero())
    }

    /// A polynomial of degree 0.
    pub(super) fn data(&self, coefficient: ExpressionId) -> SymbolicPolynomial {
        self.coefficient(coefficient, self.graph.is_zero(coefficient))
    }

    fn coefficient(&self, coefficient: ExpressionId, is_zero: bool) -> SymbolicPolynomial {
        match is_zero {
            true => Polynomial::ZERO,
            false => Polynomial::from_terms(vec![(Monomial::ONE, coefficient)]),
        }
    }

    /// The value of a polynomial that depends on neither unknowns nor data.
    pub(super) fn as_constant(&self, polynomial: &SymbolicPolynomial) -> Option<Rational> {
        match polynomial.terms() {
            [] => Some(Rational::ZERO),
            &[(Monomial::ONE, coefficient)] => self.graph.as_constant(coefficient),
            _ => None,
        }
    }

    /// The index of an unknown, if the polynomial is just that.
    pub(super) fn as_unknown(&self, polynomial: &SymbolicPolynomial) -> Option<usize> {
        let &[(monomial, coefficient)] = polynomial.terms() else { return None };
        let is_one = self.graph.as_constant(coefficient) == Some(Rational::ONE);
        (is_one && monomial.degree() == 1).then(|| monomial.exponents().iter().position(|&e| e == 1))?
    }

    fn add_polynomials(&mut self, p: &SymbolicPolynomial, q: &SymbolicPolynomial) -> Checked<SymbolicPolynomial> {
        self.charge(polynomial_weight(p) + polynomial_weight(q))?;
        Ok(self.graph.polynomial_add(p, q))
    }

    fn multiply_polynomials(&mut self, p: &SymbolicPolynomial, q: &SymbolicPolynomial) -> Checked<SymbolicPolynomial> {
        self.sum_of_products(&[(false, p, q)])
    }

    /// p q ± p' q' ± ..
    pub(super) fn sum_of_products(&mut self, products: &[SignedProduct<'_>]) -> Checked<SymbolicPolynomial> {
        if self.has_imaginary_unit && products.iter().any(|(_, p, q)| self.is_complex(p) || self.is_complex(q)) {
            return self.complex_sum_of_products(products);
        }
        let mut is_long = false;
        for (_, p, q) in products {
            self.charge(1 + p.terms().len() * q.terms().len())?;
            let degree = p.degree() + q.degree();
            if degree > MAX_DEGREE {
                return Err(fault(format!("the degree is {degree}, at most {MAX_DEGREE} is allowed")));
            }
            is_long |= self.terms_with_data(p) * self.terms_with_data(q) >= LONG_PRODUCT;
        }
        let sum = match is_long {
            true => self.graph.polynomial_product_sum(products),
            false => self.expanded_sum_of_products(products)?,
        };
        sum.ok_or_else(|| fault("an exponent is too large"))
    }

    fn expanded_sum_of_products(&mut self, products: &[SignedProduct<'_>]) -> Checked<Option<SymbolicPolynomial>> {
        let mut sum = Polynomial::ZERO;
        for &(negative, p, q) in products {
            let Some(product) = self.graph.polynomial_mul(p, q) else { return Ok(None) };
            let signed = if negative { self.graph.polynomial_neg(&product) } else { product };
            sum = if sum.is_zero() { signed } else { self.add_polynomials(&sum, &signed)? };
        }
        Ok(Some(sum))
    }

    fn terms_with_data(&self, p: &SymbolicPolynomial) -> usize {
        p.terms().iter().filter(|(_, c)| self.graph.as_constant(*c).is_none()).count()
    }

    /// -a
    pub(super) fn negate(&mut self, a: &Value) -> Value {
        let elements = a.elements.iter().map(|p| self.graph.polynomial_neg(p)).collect();
        Value::array(a.shape.clone(), elements)
    }

    /// a + b
    pub(super) fn add(&mut self, a: &Value, b: &Value) -> Checked<Value> {
        if a.shape != b.shape {
            let diagnostic = fault("the shapes of the operands differ");
            return Err(match a.shape.is_empty() || b.shape.is_empty() {
                true => diagnostic.hint("write the scalar as an array: `[s; 3]`, or `s * identity(3)` for a matrix"),
                false => diagnostic.hint("element-wise operations need equal shapes"),
            });
        }
        let pairs = a.elements.iter().zip(&b.elements);
        let sums = pairs.map(|(p, q)| self.add_polynomials(p, q)).collect::<Checked<_>>()?;
        Ok(Value::array(a.shape.clone(), sums))
    }

    /// a - b
    pub(super) fn subtract(&mut self, a: &Value, b: &Value) -> Checked<Value> {
        let negative = self.negate(b);
        self.add(a, &negative)
    }

    /// a b: scaling, or the product of matrices and vectors; a vector on the left is a row, on the
    /// right a column.
    pub(super) fn multiply(&mut self, a: &Value, b: &Value) -> Checked<Value> {
        if let Some(factor) = a.as_scalar() {
            let scaled = b.elements.iter().map(|p| self.multiply_polynomials(factor, p)).collect::<Checked<_>>()?;
            return Ok(Value::array(b.shape.clone(), scaled));
        }
        if b.as_scalar().is_some() {
            return self.multiply(b, a);
        }
        let (rows, inner, columns, shape) = match (&a.shape[..], &b.shape[..]) {
            (&[m, k], &[l, n]) if k == l => (m, k, n, vec![m, n]),
            (&[m, k], &[l]) if k == l => (m, k, 1, vec![m]),
            (&[k], &[l, n]) if k == l => (1, k, n, vec![n]),
            (&[_], &[_]) => {
                return Err(
                    fault("the product of two vectors has several meanings").hint("write `dot(a, b)` or `cross(a, b)`")
                );
            }
            (&[_] | &[_, _], &[_] | &[_, _]) => {
                return Err(fault("the shapes do not fit for a product")
                    .hint("the last dimension of the left factor must equal the first of the right one"));
            }
            _ => return Err(fault("only scalars, vectors and matrices can be multiplied")),
        };
        let mut elements = Vec::with_capacity(rows * columns);
        for i in 0..rows {
            for j in 0..columns {
                let products = (0..inner).map(|k| (false, &a.elements[i * inner + k], &b.elements[k * columns + j]));
                elements.push(self.sum_of_products(&products.collect::<Vec<_>>())?);
            }
        }
        Ok(Value::array(shape, elements))
    }

    /// Sum of the products of corresponding elements of two vectors.
    pub(super) fn dot(&mut self, a: &Value, b: &Value) -> Checked<SymbolicPolynomial> {
        let products = a.elements.iter().zip(&b.elements).map(|(p, q)| (false, p, q));
        self.sum_of_products(&products.collect::<Vec<_>>())
    }

    /// a^n
    pub(super) fn power(&mut self, a: &SymbolicPolynomial, n: u32) -> Checked<SymbolicPolynomial> {
        let one = self.constant(Rational::ONE);
        (0..n).try_fold(one, |product, _| self.multiply_polynomials(&product, a))
    }

    /// The derivative by the unknown with the given index.
    pub(super) fn derivative(&mut self, p: &SymbolicPolynomial, unknown: usize) -> Checked<SymbolicPolynomial> {
        self.charge(p.terms().len())?;
        Ok(self.graph.polynomial_derivative(p, unknown))
    }

    /// The determinant of an n x n matrix: n 2^(n-1) products. Minors of the first k rows, one for
    /// each set of k columns, are expanded along their last row.
    pub(super) fn determinant(&mut self, matrix: &[SymbolicPolynomial], n: usize) -> Checked<SymbolicPolynomial> {
        let mut minors: Vec<(u32, SymbolicPolynomial)> = vec![(0, self.constant(Rational::ONE))];
        for row in 0..n {
            let mut next = Vec::new();
            for columns in (0u32..1 << n).filter(|set| set.count_ones() as usize == row + 1) {
                let own = (0..n).filter(|&column| columns >> column & 1 == 1).filter_map(|column| {
                    let rest = columns & !(1 << column);
                    let at = minors.binary_search_by_key(&rest, |&(set, _)| set).ok()?;
                    // The sign of the entry is that of row + its position among the columns.
                    let position = (columns & ((1 << column) - 1)).count_ones() as usize;
                    Some(((row + position) % 2 == 1, &matrix[row * n + column], &minors[at].1))
                });
                let minor = self.sum_of_products(&own.collect::<Vec<_>>())?;
                next.push((columns, minor));
            }
            minors = next;
        }
        Ok(minors.pop().map_or(Polynomial::ZERO, |(_, determinant)| determinant))
    }
}
