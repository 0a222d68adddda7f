//! The F4 algorithm: Gröbner bases by row reduction of matrices of polynomials.
//!
//! Faugère, "A new efficient algorithm for computing Gröbner bases (F4)", JPAA 1999, without its
//! `Simplify`.
//!
//! 1. The polynomials are brought to echelon form; their critical pairs are formed.
//! 2. All pairs of least degree are taken (the sugar degree of Giovini et al., ISSAC 1991, for
//!    orders that are not graded). Both halves of each S-polynomial become rows of a matrix.
//! 3. Symbolic preprocessing adds a multiple of a basis element for each monomial that one can
//!    reduce.
//! 4. After row reduction, rows that lead in a new column are new elements: no old leading monomial
//!    divides theirs. They form new pairs.
//! 5. Without pairs left the basis is a Gröbner basis, by Buchberger's criterion. Its tails are
//!    reduced.

use super::basis::BasisElement;
use super::monomial_table::{MonomialId, MonomialTable};
use super::pairs::{Lead, PairQueue};
use super::symbolic::{Multiple, Symbolic};
use super::{GroebnerError, Limits, MonomialOrder};
use crate::algebra::{Echelon, Monomial, Polynomial, PrimeField};

/// The elements of the reduced Gröbner basis, by increasing leading monomial.
pub(super) fn reduced_basis(
    field: PrimeField,
    polynomials: &[Polynomial<u32>],
    order: &MonomialOrder,
    limits: &Limits,
) -> Result<Vec<BasisElement>, GroebnerError> {
    let mut state = F4 {
        field,
        order,
        limits,
        table: MonomialTable::new(order.clone()),
        supports: Vec::new(),
        values: Vec::new(),
        leads: Vec::new(),
        pairs: PairQueue::default(),
    };
    state.add_input(polynomials)?;
    for _ in 0..limits.max_rounds {
        if state.is_unit() {
            return Ok(vec![BasisElement::one()]);
        }
        let pairs = state.pairs.take_least_degree();
        if pairs.is_empty() {
            return state.interreduce();
        }
        if pairs.iter().any(|pair| pair.lcm.degree() > limits.max_degree) {
            return Err(GroebnerError::LimitReached {
                what: "degree",
                limit: limits.max_degree.unsigned_abs() as usize,
            });
        }
        let mut symbolic = Symbolic::new(&mut state.table, &state.supports, &state.leads, limits.max_matrix_entries);
        symbolic.add_pairs(&pairs)?;
        symbolic.close()?;
        let Symbolic { pivots, to_reduce, columns, .. } = symbolic;
        let sugar = pairs.first().map_or(0, |pair| pair.degree);
        let rows = state.eliminate(pivots, to_reduce, columns);
        state.add_elements(rows, |_| sugar)?;
    }
    Err(GroebnerError::LimitReached { what: "rounds", limit: limits.max_rounds })
}

/// A polynomial with interned monomials, largest first, and leading coefficient 1.
type InternedPolynomial = (Vec<MonomialId>, Vec<u32>);

/// The basis under construction.
struct F4<'a> {
    field: PrimeField,
    order: &'a MonomialOrder,
    limits: &'a Limits,
    table: MonomialTable,
    /// Per element: its monomials, largest first.
    supports: Vec<Vec<MonomialId>>,
    /// Per element: the coefficients of its monomials, the first of which is 1.
    values: Vec<Vec<u32>>,
    /// Per element: its leading monomial.
    leads: Vec<Lead>,
    pairs: PairQueue,
}

/// The sorted columns of a matrix.
struct Columns {
    /// The monomial of each column, largest first.
    monomials: Vec<MonomialId>,
    /// Per interned monomial: its column, if it has one.
    positions: Vec<u32>,
}

impl Columns {
    fn new(table: &MonomialTable, mut monomials: Vec<MonomialId>) -> Self {
        monomials.sort_unstable_by_key(|&id| std::cmp::Reverse(table.key(id)));
        let mut positions = vec![u32::MAX; table.len()];
        for (position, id) in monomials.iter().enumerate() {
            positions[id.index()] = position as u32;
        }
        Self { monomials, positions }
    }

    fn of(&self, row: &[MonomialId]) -> Vec<u32> {
        row.iter().map(|id| self.positions[id.index()]).collect()
    }

    fn polynomial(&self, row: &[(u32, u32)]) -> InternedPolynomial {
        row.iter().map(|&(column, value)| (self.monomials[column as usize], value)).unzip()
    }
}

impl F4<'_> {
    fn is_unit(&self) -> bool {
        self.leads.iter().any(|lead| lead.monomial == Monomial::ONE)
    }

    /// Starts with the echelon form of the input.
    fn add_input(&mut self, polynomials: &[Polynomial<u32>]) -> Result<(), GroebnerError> {
        let mut rows = Vec::with_capacity(polynomials.len());
        for polynomial in polynomials {
            let mut row = Vec::with_capacity(polynomial.terms().len());
            for &(monomial, value) in polynomial.terms() {
                row.push((self.table.intern(monomial)?, self.field.reduce(u64::from(value))));
            }
            rows.push(row);
        }
        let mut monomials: Vec<MonomialId> = rows.iter().flatten().map(|&(id, _)| id).collect();
        monomials.sort_unstable_by_key(|id| id.index());
        monomials.dedup();
        let columns = Columns::new(&self.table, monomials);
        let mut echelon = Echelon::new(self.field, columns.monomials.len());
        let mut leading = Vec::new();
        for row in rows {
            let row: Vec<(u32, u32)> =
                row.into_iter().map(|(id, value)| (columns.positions[id.index()], value)).collect();
            leading.extend(echelon.insert_sparse_reduced(&row));
        }
        let rows = interreduced(&mut echelon, leading, &columns);
        self.add_elements(rows, |polynomial| polynomial.iter().map(Monomial::degree).max().unwrap_or(0))
    }

    /// The rows that elimination adds to the pivots, reduced, by increasing leading monomial.
    fn eliminate(
        &self,
        pivots: Vec<Multiple>,
        to_reduce: Vec<Multiple>,
        columns: Vec<MonomialId>,
    ) -> Vec<InternedPolynomial> {
        let columns = Columns::new(&self.table, columns);
        let mut echelon = Echelon::new(self.field, columns.monomials.len());
        // Pivot rows need no reduction: they lead in different columns, and only reduce the others.
        for row in pivots {
            echelon.push_pivot(columns.of(&row.monomials), self.values[row.element].clone());
        }
        let mut leading = Vec::new();
        for row in to_reduce {
            let row: Vec<(u32, u32)> =
                columns.of(&row.monomials).into_iter().zip(self.values[row.element].iter().copied()).collect();
            leading.extend(echelon.insert_sparse_reduced(&row));
        }
        interreduced(&mut echelon, leading, &columns)
    }

    /// Adds polynomials, by increasing leading monomial. `sugar` gives their sugar if the order is
    /// not graded.
    fn add_elements(
        &mut self,
        polynomials: Vec<InternedPolynomial>,
        sugar: impl Fn(&[Monomial]) -> i32,
    ) -> Result<(), GroebnerError> {
        for (support, values) in polynomials {
            let monomials: Vec<Monomial> = support.iter().map(|&id| *self.table.monomial(id)).collect();
            let Some(&monomial) = monomials.first() else {
                continue;
            };
            let order = self.order;
            let degree = |m: &Monomial| order.grade(m).unwrap_or_else(|| m.degree());
            let sugar = order.grade(&monomial).unwrap_or_else(|| sugar(&monomials));
            self.leads.push(Lead { monomial, sugar, degree: degree(&monomial), redundant: false });
            self.supports.push(support);
            self.values.push(values);
            self.pairs.update(&mut self.leads, degree, self.limits.max_pairs)?;
        }
        Ok(())
    }

    /// Reduces the tails of the elements that are not redundant.
    fn interreduce(&mut self) -> Result<Vec<BasisElement>, GroebnerError> {
        let mut symbolic = Symbolic::new(&mut self.table, &self.supports, &self.leads, self.limits.max_matrix_entries);
        symbolic.add_active_elements()?;
        symbolic.close()?;
        let Symbolic { pivots, columns, .. } = symbolic;
        let columns = Columns::new(&self.table, columns);
        let mut echelon = Echelon::new(self.field, columns.monomials.len());
        let active = self.leads.iter().filter(|lead| !lead.redundant).count();
        let mut leading = Vec::with_capacity(active);
        // The elements come first; the multiples behind them only reduce their tails.
        for (i, row) in pivots.into_iter().enumerate() {
            let row_columns = columns.of(&row.monomials);
            if i < active {
                leading.extend(row_columns.first().map(|&column| column as usize));
            }
            echelon.push_pivot(row_columns, self.values[row.element].clone());
        }
        let elements = interreduced(&mut echelon, leading, &columns).into_iter().map(|(support, values)| {
            BasisElement::new(support.into_iter().map(|id| *self.table.monomial(id)).zip(values).collect())
        });
        Ok(elements.collect())
    }
}

/// The rows that lead in the given columns, reduced by all rows, by increasing leading monomial.
fn interreduced(echelon: &mut Echelon, mut leading: Vec<usize>, columns: &Columns) -> Vec<InternedPolynomial> {
    leading.sort_unstable_by(|a, b| b.cmp(a));
    // From right to left, so that each row is reduced by rows that are reduced themselves.
    leading
        .into_iter()
        .map(|column| {
            echelon.back_reduce_row(column);
            columns.polynomial(&echelon.row(column))
        })
        .collect()
}
