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
use super::trace::Trace;
use super::{GroebnerError, Limits, MonomialOrder};
use crate::algebra::{Echelon, Monomial, Polynomial, PrimeField};

/// The elements of the reduced Gröbner basis, by increasing leading monomial.
pub(super) fn reduced_basis(
    field: PrimeField,
    polynomials: &[Polynomial<u32>],
    order: &MonomialOrder,
    limits: &Limits,
) -> Result<Vec<BasisElement>, GroebnerError> {
    let mut state = F4::new(field, order, limits, None);
    state.complete(polynomials)?;
    state.interreduce()
}

/// The elements of the reduced grevlex basis, by increasing leading monomial, with the trace, which
/// ends with these elements.
pub(super) fn traced_basis(
    field: PrimeField,
    polynomials: &[Polynomial<u32>],
    limits: &Limits,
) -> Result<(Vec<BasisElement>, Trace), GroebnerError> {
    let mut state = F4::new(field, &MonomialOrder::GrevLex, limits, Some(Trace::default()));
    state.complete(polynomials)?;
    let elements = state.interreduce()?;
    Ok((elements, state.trace.unwrap_or_default()))
}

/// A polynomial with interned monomials, largest first, and leading coefficient 1.
type InternedPolynomial = (Vec<MonomialId>, Vec<u32>);

/// A row that elimination gives: the polynomial, and the positions of the rows of the matrix whose
/// combination it is. They are known only if the basis is traced.
type Combination = (InternedPolynomial, Vec<usize>);

/// The basis under construction.
struct F4<'a> {
    field: PrimeField,
    order: &'a MonomialOrder,
    limits: &'a Limits<'a>,
    table: MonomialTable,
    /// Per element: its monomials, largest first.
    supports: Vec<Vec<MonomialId>>,
    /// Per element: the coefficients of its monomials, the first of which is 1.
    values: Vec<Vec<u32>>,
    /// Per element: its leading monomial.
    leads: Vec<Lead>,
    pairs: PairQueue,
    /// How elements follow from the input, if that is asked for.
    trace: Option<Trace>,
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

    fn count(&self) -> usize {
        self.monomials.len()
    }

    /// A row of the matrix. Entries behind the columns belong to the rows that it is a combination
    /// of.
    fn combination(&self, row: &[(u32, u32)]) -> Combination {
        let (entries, marks) = row.split_at(row.partition_point(|&(column, _)| (column as usize) < self.count()));
        let polynomial = entries.iter().map(|&(column, value)| (self.monomials[column as usize], value)).unzip();
        (polynomial, marks.iter().map(|&(mark, _)| mark as usize - self.count()).collect())
    }
}

impl<'a> F4<'a> {
    fn new(field: PrimeField, order: &'a MonomialOrder, limits: &'a Limits<'a>, trace: Option<Trace>) -> Self {
        Self {
            field,
            order,
            limits,
            table: MonomialTable::new(order.clone()),
            supports: Vec::new(),
            values: Vec::new(),
            leads: Vec::new(),
            pairs: PairQueue::default(),
            trace,
        }
    }

    /// Adds elements until no critical pair is left, or 1 is an element.
    fn complete(&mut self, polynomials: &[Polynomial<u32>]) -> Result<(), GroebnerError> {
        let limits = self.limits;
        self.add_input(polynomials)?;
        for _ in 0..limits.max_rounds {
            limits.go_on()?;
            let pairs = self.pairs.take_least_degree();
            if self.is_unit() || pairs.is_empty() {
                return Ok(());
            }
            if pairs.iter().any(|pair| pair.lcm.degree() > limits.max_degree) {
                return Err(GroebnerError::LimitReached {
                    what: "degree",
                    limit: limits.max_degree.unsigned_abs() as usize,
                });
            }
            let mut symbolic = Symbolic::new(&mut self.table, &self.supports, &self.leads, limits);
            symbolic.add_pairs(&pairs)?;
            symbolic.close()?;
            let Symbolic { pivots, to_reduce, columns, .. } = symbolic;
            let sugar = pairs.first().map_or(0, |pair| pair.degree);
            self.eliminate(pivots, to_reduce, columns, sugar)?;
        }
        Err(GroebnerError::LimitReached { what: "rounds", limit: limits.max_rounds })
    }

    fn is_unit(&self) -> bool {
        self.leads.iter().any(|lead| lead.monomial == Monomial::ONE)
    }

    /// The echelon form of a matrix with this many rows. If the basis is traced there is a further
    /// column for each row, which is 1 in that row: it marks the rows that a row is made of.
    fn echelon(&self, columns: &Columns, rows: usize) -> Echelon {
        Echelon::new(self.field, columns.count() + if self.trace.is_some() { rows } else { 0 })
    }

    /// The mark of a row, its position among the rows, if there are marks.
    fn mark(&self, columns: &Columns, row: usize) -> Option<(u32, u32)> {
        self.trace.is_some().then(|| ((columns.count() + row) as u32, 1))
    }

    /// Adds a multiple of an element as a row that is not reduced.
    fn push_multiple(&self, echelon: &mut Echelon, columns: &Columns, row: &Multiple, at: usize) {
        let mark = self.mark(columns, at);
        let mut positions = columns.of(&row.monomials);
        let mut values = self.values[row.element].clone();
        positions.extend(mark.map(|(column, _)| column));
        values.extend(mark.map(|(_, value)| value));
        echelon.push_pivot(positions, values);
    }

    /// A multiple of an element, by the element and the multiplier.
    fn factors(&self, row: &Multiple) -> (usize, Monomial) {
        let leading = row.monomials.first().map_or(Monomial::ONE, |&id| *self.table.monomial(id));
        (row.element, leading.over(&self.leads[row.element].monomial))
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
        let mut echelon = self.echelon(&columns, rows.len());
        let mut leading = Vec::new();
        for (at, row) in rows.into_iter().enumerate() {
            let mut row: Vec<(u32, u32)> =
                row.into_iter().map(|(id, value)| (columns.positions[id.index()], value)).collect();
            self.limits.go_on()?;
            row.extend(self.mark(&columns, at));
            leading.extend(echelon.insert_sparse_reduced(&row));
        }
        let (rows, parts): (Vec<_>, Vec<_>) =
            interreduced(&mut echelon, leading, &columns, self.limits)?.into_iter().unzip();
        if let Some(trace) = &mut self.trace {
            parts.into_iter().for_each(|parts| trace.add_combination_of_generators(parts));
        }
        self.add_elements(rows, |polynomial| polynomial.iter().map(Monomial::degree).max().unwrap_or(0))
    }

    /// Adds the rows that elimination adds to the pivots, reduced, by increasing leading monomial.
    fn eliminate(
        &mut self,
        pivots: Vec<Multiple>,
        to_reduce: Vec<Multiple>,
        columns: Vec<MonomialId>,
        sugar: i32,
    ) -> Result<(), GroebnerError> {
        let columns = Columns::new(&self.table, columns);
        let mut echelon = self.echelon(&columns, pivots.len() + to_reduce.len());
        // Pivot rows need no reduction: they lead in different columns, and only reduce the others.
        for (at, row) in pivots.iter().enumerate() {
            self.push_multiple(&mut echelon, &columns, row, at);
        }
        let mut leading = Vec::new();
        for (at, row) in to_reduce.iter().enumerate() {
            self.limits.go_on()?;
            let values = self.values[row.element].iter().copied();
            let mut entries: Vec<(u32, u32)> = columns.of(&row.monomials).into_iter().zip(values).collect();
            entries.extend(self.mark(&columns, pivots.len() + at));
            leading.extend(echelon.insert_sparse_reduced(&entries));
        }
        let (rows, parts): (Vec<_>, Vec<_>) =
            interreduced(&mut echelon, leading, &columns, self.limits)?.into_iter().unzip();
        self.trace_rows(&[pivots, to_reduce].concat(), parts);
        self.add_elements(rows, |_| sugar)
    }

    /// Notes that new elements are combinations of some of the rows of a matrix.
    fn trace_rows(&mut self, rows: &[Multiple], parts: Vec<Vec<usize>>) {
        if self.trace.is_some() {
            let factors: Vec<(usize, Monomial)> = rows.iter().map(|row| self.factors(row)).collect();
            let combinations = parts.into_iter().map(|parts| parts.into_iter().map(|at| factors[at]).collect());
            if let Some(trace) = &mut self.trace {
                combinations.for_each(|parts| trace.add_combination(parts));
            }
        }
    }

    /// Adds polynomials, by increasing leading monomial. `sugar` gives their sugar if the order is
    /// not graded.
    fn add_elements(
        &mut self,
        polynomials: Vec<InternedPolynomial>,
        sugar: impl Fn(&[Monomial]) -> i32,
    ) -> Result<(), GroebnerError> {
        for (support, values) in polynomials {
            self.limits.go_on()?;
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

    /// The elements that are not redundant, their tails reduced. If 1 is an element it is the only
    /// one.
    fn interreduce(&mut self) -> Result<Vec<BasisElement>, GroebnerError> {
        if self.is_unit() {
            if let Some(trace) = &mut self.trace {
                // Nothing is read from the trace of a problem without solutions.
                trace.add_combination(Vec::new());
            }
            return Ok(vec![BasisElement::one()]);
        }
        let mut symbolic = Symbolic::new(&mut self.table, &self.supports, &self.leads, self.limits);
        symbolic.add_active_elements()?;
        symbolic.close()?;
        let Symbolic { pivots, columns, .. } = symbolic;
        let columns = Columns::new(&self.table, columns);
        let mut echelon = self.echelon(&columns, pivots.len());
        let active = self.leads.iter().filter(|lead| !lead.redundant).count();
        let mut leading = Vec::with_capacity(active);
        // The elements come first; the multiples behind them only reduce their tails.
        for (i, row) in pivots.iter().enumerate() {
            if i < active {
                leading.extend(row.monomials.first().map(|id| columns.positions[id.index()] as usize));
            }
            self.push_multiple(&mut echelon, &columns, row, i);
        }
        let (rows, parts): (Vec<_>, Vec<_>) =
            interreduced(&mut echelon, leading, &columns, self.limits)?.into_iter().unzip();
        self.trace_rows(&pivots, parts);
        let elements = rows.into_iter().map(|(support, values): InternedPolynomial| {
            BasisElement::new(support.into_iter().map(|id| *self.table.monomial(id)).zip(values).collect())
        });
        Ok(elements.collect())
    }
}

/// The rows that lead in the given columns, reduced by all rows, by increasing leading monomial.
/// Rows of which only marks are left are combinations that vanish: they are left out.
fn interreduced(
    echelon: &mut Echelon,
    mut leading: Vec<usize>,
    columns: &Columns,
    limits: &Limits,
) -> Result<Vec<Combination>, GroebnerError> {
    leading.retain(|&column| column < columns.count());
    leading.sort_unstable_by(|a, b| b.cmp(a));
    // From right to left, so that each row is reduced by rows that are reduced themselves.
    leading
        .into_iter()
        .map(|column| {
            limits.go_on()?;
            echelon.back_reduce_row(column);
            Ok(columns.combination(&echelon.row(column)))
        })
        .collect()
}
