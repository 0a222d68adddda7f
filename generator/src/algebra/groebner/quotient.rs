//! The quotient ring of a zero-dimensional ideal: normal forms as vectors, multiplication as
//! matrices.

use std::collections::{BTreeMap, HashMap};
use std::sync::OnceLock;

use super::{BasisElement, GroebnerBasis, GroebnerError, Limits};
use crate::algebra::{DenseMatrix, Monomial, Polynomial, PrimeField};

/// `K[x]/I` as a vector space over its standard monomials b_0 = 1, .., b_{d-1}, with multiplication
/// by the unknowns.
///
/// ```text
///   M_x (d x d):  row k holds the normal form of x b_k       nf(x b_k) = sum_j M_x[k][j] b_j
///
///            b_0  b_1  b_2
///   x b_0  [  0    1    0  ]     x b_0 = b_1 is a standard monomial: a unit row
///   x b_1  [  0    0    1  ]
///   x b_2  [  *    *    *  ]     x b_2 is not: its normal form
/// ```
///
/// At a solution the vector of the b_k is an eigenvector of M_x, whose eigenvalue is the value of
/// x.
#[derive(Clone, Debug)]
pub struct QuotientRing {
    field: PrimeField,
    standard: Vec<Monomial>,
    /// Per unknown x: M_x.
    multiplication: Vec<DenseMatrix>,
    /// Per unknown x: the inverse of M_x, or `None` if it is singular. It is computed when it is
    /// needed first.
    inverses: Vec<OnceLock<Option<DenseMatrix>>>,
}

impl QuotientRing {
    /// The quotient by the ideal of a Gröbner basis in the given number of unknowns. If there are
    /// no solutions it is the zero ring, of dimension 0.
    ///
    /// The normal forms of the products of unknowns and standard monomials are found in increasing
    /// order, each from earlier ones (Faugère, Gianni, Lazard & Mora, JSC 1993, section 2).
    ///
    /// # Errors
    /// [`GroebnerError::NotZeroDimensional`], [`GroebnerError::LimitReached`] for more than
    /// [`Limits::max_quotient_dimension`] solutions, or [`GroebnerError::Ended`].
    pub fn new(basis: &GroebnerBasis, unknowns: usize, limits: &Limits) -> Result<Self, GroebnerError> {
        let unknowns = basis.count_unknowns(unknowns);
        if let Some(dimension @ 1..) = basis.dimension(unknowns) {
            return Err(GroebnerError::NotZeroDimensional { dimension });
        }
        let limit = limits.max_quotient_dimension;
        let too_large = GroebnerError::LimitReached { what: "solutions", limit };
        let standard = basis.quotient_basis(unknowns, limit).ok_or(too_large)?;
        let multiplication = multiplication_by_unknowns(basis, unknowns, &standard, limits)?;
        let inverses = vec![OnceLock::new(); unknowns];
        Ok(Self { field: basis.field(), standard, multiplication, inverses })
    }

    /// The number d of solutions, counted with multiplicity.
    pub fn dimension(&self) -> usize {
        self.standard.len()
    }

    /// The standard monomials, increasing.
    pub fn standard_monomials(&self) -> &[Monomial] {
        &self.standard
    }

    /// The field of the coefficients.
    pub fn field(&self) -> PrimeField {
        self.field
    }

    /// The number of unknowns.
    pub fn unknowns(&self) -> usize {
        self.multiplication.len()
    }

    /// The normal form of an unknown times the polynomial with the given normal form.
    pub(super) fn times_unknown(&self, vector: &[u32], unknown: usize) -> Vec<u32> {
        self.multiplication[unknown].row_vector_times(vector)
    }

    /// The normal forms of monomials, one per row, as coefficients of
    /// [`QuotientRing::standard_monomials`]. A Laurent monomial has one if its unknowns with
    /// negative exponents vanish at no solution. `None` if it does not, or if a monomial has
    /// unknowns beyond those of the ring.
    pub fn normal_forms(&self, monomials: &[Monomial]) -> Option<DenseMatrix> {
        let mut one = vec![0; self.dimension()];
        one.iter_mut().take(1).for_each(|value| *value = 1);
        let mut known = HashMap::from([(Monomial::ONE, one)]);
        let mut forms = DenseMatrix::zeros(self.field, monomials.len(), self.dimension());
        for (i, monomial) in monomials.iter().enumerate() {
            // Divide by single unknowns down to a monomial that is known, and multiply up again.
            let mut at = *monomial;
            let mut steps = Vec::new();
            while !known.contains_key(&at) {
                let last = at.exponents().iter().rposition(|&e| e != 0)?;
                let step = Step { unknown: last, inverse: at.exponent(last) < 0 };
                at = step.undo(&at);
                steps.push(step);
            }
            let mut vector = known.get(&at)?.clone();
            for step in steps.into_iter().rev() {
                vector = self.step_matrix(step)?.row_vector_times(&vector);
                at = step.apply(&at);
                known.insert(at, vector.clone());
            }
            forms.row_mut(i).copy_from_slice(&vector);
        }
        Some(forms)
    }

    /// The normal form of a polynomial as coefficients of the standard monomials; `None` as in
    /// [`QuotientRing::normal_forms`].
    pub fn normal_form(&self, polynomial: &Polynomial<u32>) -> Option<Vec<u32>> {
        let monomials: Vec<Monomial> = polynomial.monomials().collect();
        let coefficients: Vec<u32> = polynomial.terms().iter().map(|&(_, value)| value).collect();
        Some(self.normal_forms(&monomials)?.row_vector_times(&coefficients))
    }

    /// The matrix of multiplication by a monomial: row k holds the normal form of it times b_k.
    /// `None` as in [`QuotientRing::normal_forms`].
    pub fn multiplication_matrix(&self, monomial: &Monomial) -> Option<DenseMatrix> {
        let mut matrix = DenseMatrix::identity(self.field, self.dimension());
        for (unknown, &exponent) in monomial.exponents().iter().enumerate().filter(|&(_, &exponent)| exponent != 0) {
            let factor = self.step_matrix(Step { unknown, inverse: exponent < 0 })?;
            for _ in 0..exponent.unsigned_abs() {
                matrix = matrix.times(factor)?;
            }
        }
        Some(matrix)
    }

    fn step_matrix(&self, step: Step) -> Option<&DenseMatrix> {
        let matrix = self.multiplication.get(step.unknown)?;
        if step.inverse { self.inverses[step.unknown].get_or_init(|| matrix.inverse()).as_ref() } else { Some(matrix) }
    }
}

/// Multiplication by an unknown or its reciprocal.
#[derive(Clone, Copy)]
struct Step {
    unknown: usize,
    inverse: bool,
}

impl Step {
    fn apply(self, monomial: &Monomial) -> Monomial {
        let unknown = Monomial::unknown(self.unknown);
        if self.inverse { monomial.over(&unknown) } else { monomial.times(&unknown) }
    }

    fn undo(self, monomial: &Monomial) -> Monomial {
        Self { inverse: !self.inverse, ..self }.apply(monomial)
    }
}

/// M_x for every unknown x.
fn multiplication_by_unknowns(
    basis: &GroebnerBasis,
    unknowns: usize,
    standard: &[Monomial],
    limits: &Limits,
) -> Result<Vec<DenseMatrix>, GroebnerError> {
    let field = basis.field();
    let dimension = standard.len();
    let index: HashMap<Monomial, usize> = standard.iter().enumerate().map(|(k, &monomial)| (monomial, k)).collect();
    let leading: HashMap<Monomial, &BasisElement> =
        basis.elements().iter().map(|element| (element.leading_monomial(), element)).collect();
    // The products x_i b_k in increasing order, each with all its factorisations (i, k).
    let mut products = BTreeMap::new();
    for (k, monomial) in standard.iter().enumerate() {
        for i in 0..unknowns {
            let product = monomial.times(&Monomial::unknown(i));
            products.entry(basis.order().key(&product)).or_insert((product, Vec::new())).1.push((i, k));
        }
    }
    let mut matrices = vec![DenseMatrix::zeros(field, dimension, dimension); unknowns];
    for (product, factorisations) in products.into_values() {
        limits.go_on()?;
        let mut form = vec![0; dimension];
        if let Some(&k) = index.get(&product) {
            form[k] = 1;
        } else if let Some(element) = leading.get(&product) {
            for (monomial, value) in element.terms().iter().skip(1) {
                index.get(monomial).into_iter().for_each(|&k| form[k] = field.neg(*value));
            }
        } else if let Some((x_j, form_over_x_j)) = factorisations
            .first()
            .and_then(|first| smaller_product(&product, first, basis, (standard, &index), &matrices))
        {
            // nf(x_i b_k) = M_j applied to nf(x_i b_k / x_j). The monomials of that normal form
            // times x_j are smaller than the product: their rows of M_j are known.
            form = matrices[x_j].row_vector_times(&form_over_x_j);
        }
        for (i, k) in factorisations {
            matrices[i].row_mut(k).copy_from_slice(&form);
        }
    }
    Ok(matrices)
}

/// For a product x_i b_k that a leading monomial divides properly: an unknown x_j such that x_i b_k
/// / x_j is still reducible, and the normal form of this quotient. It is x_i (b_k / x_j), which was
/// treated before.
fn smaller_product(
    product: &Monomial,
    &(i, k): &(usize, usize),
    basis: &GroebnerBasis,
    (standard, index): (&[Monomial], &HashMap<Monomial, usize>),
    matrices: &[DenseMatrix],
) -> Option<(usize, Vec<u32>)> {
    let divisor =
        basis.elements().iter().map(BasisElement::leading_monomial).find(|leading| leading.divides(product))?;
    let j = product.over(&divisor).exponents().iter().position(|&e| e > 0)?;
    let quotient = index.get(&standard[k].over(&Monomial::unknown(j)))?;
    Some((j, matrices[i].row(*quotient).to_vec()))
}
