//! Whether a plan contradicts itself: every table stays in range, and every value, pivot and
//! unknown is written before it is read.

use super::output::PlannedOutput;
use super::program::{Operation, Program, ValueId};
use super::system_table::SystemTable;
use super::{
    ActionRow, BasisId, Block, CoefficientId, Elimination, Entry, KnownMonomial, Plan, PlannedDerivation, Term,
};
use crate::presolve::MOST_LINEAR;
use crate::presolve::exchange::Image;

/// A plan that contradicts itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("inconsistent plan: {0}")]
pub struct PlanError(pub &'static str);

impl Plan {
    /// Checks that every table stays in range and that every value and pivot is written before it
    /// is read.
    ///
    /// # Errors
    /// The first contradiction.
    pub fn check(&self) -> Result<(), PlanError> {
        self.check_program()?;
        self.check_elimination()?;
        self.check_monomials()?;
        self.check_chains()?;
        self.check_unknowns()?;
        self.check_matrix()
    }

    fn check_program(&self) -> Result<(), PlanError> {
        require(self.program.is_ordered(self.inputs()), "a value is read before it is written")?;
        let has_value = self.coefficients.iter().all(|id| (id.0 as usize) < self.program.operations.len());
        require(has_value, "a coefficient has no value")?;
        let mut known = self.given();
        for PlannedDerivation { derivation, program, .. } in &self.derived {
            let has_operands = derivation.operands.len() == derivation.kind.operands()
                && derivation.operands.iter().all(|id| (id.0 as usize) < program.operations.len());
            let is_ordered = derivation.first_input == known && program.is_ordered(known);
            require(has_operands && is_ordered, "data are derived from others that are not known")?;
            known = derivation.inputs().end;
        }
        if let Some(PlannedOutput { program, coefficients, of_solution, scalars, .. }) = &self.output {
            let inputs =
                coefficients.len() + self.unknowns.len() + self.fields.iter().filter(|f| f.is_projective).count();
            let steps = [(program, coefficients, self.stated), (of_solution, scalars, inputs)];
            let is_known = |(program, values, inputs): &(&Program, &Vec<ValueId>, usize)| {
                program.is_ordered(*inputs) && values.iter().all(|id| (id.0 as usize) < program.operations.len())
            };
            require(steps.iter().all(is_known), "a result reads a value that is not known")?;
        }
        Ok(())
    }

    /// Whether the coefficients begin with the matrix of the equations, if these are stored so.
    fn check_matrix(&self) -> Result<(), PlanError> {
        let table = SystemTable::of(&self.equations, self.unknowns.len());
        let matrix = if table.is_dense() { table.matrix() } else { Vec::new() };
        let is_zero = |id: ValueId| matches!(self.program.operations[id.0 as usize], Operation::Constant(c) if c.numerator() == 0);
        let is_entry = |(own, entry): (&ValueId, &Option<u16>)| match entry {
            Some(id) => self.coefficients[usize::from(*id)] == *own,
            None => is_zero(*own),
        };
        let is_first = matrix.len() <= self.coefficients.len() && self.coefficients.iter().zip(&matrix).all(is_entry);
        require(is_first, "the matrix of the equations is not where it should be")
    }

    fn check_elimination(&self) -> Result<(), PlanError> {
        let e = &self.elimination;
        let mut next = 0;
        for block in &e.blocks {
            let tiles = block.first == next && block.size > 0 && block.needed <= block.size;
            require(tiles && self.fits(block), "the blocks do not tile the rows")?;
            next += block.size;
        }
        require(next == e.rows, "the blocks do not tile the rows")?;
        let named = e.row_shifts.len() == e.rows && e.pivot_columns.len() == e.rows;
        require(named, "a row has no shift or no pivot column")?;
        let coupled = e.blocks.iter().flat_map(|block| &block.coupling).all(|entry| e.solves(entry.column));
        require(coupled, "a block reads a pivot that is not solved")?;
        let right = e.right.iter().all(|entry| self.is_inside(entry, [e.rows, e.basis]));
        require(right, "a basis entry is out of range")
    }

    /// Whether the entries of a block are in range.
    fn fits(&self, block: &Block) -> bool {
        let diagonal = |entry: &Entry| self.is_inside(entry, [block.size, block.size]);
        let coupling = |entry: &Entry| self.is_inside(entry, [block.size, block.first]);
        block.diagonal.iter().all(diagonal) && block.coupling.iter().all(coupling)
    }

    fn is_inside(&self, entry: &Entry, [rows, columns]: [usize; 2]) -> bool {
        usize::from(entry.row) < rows && usize::from(entry.column) < columns && self.has(entry.coefficient)
    }

    fn has(&self, coefficient: CoefficientId) -> bool {
        usize::from(coefficient.0) < self.coefficients.len()
    }

    /// The action matrix and the monomials that unknowns are read from.
    fn check_monomials(&self) -> Result<(), PlanError> {
        let e = &self.elimination;
        let is_row = |row: &ActionRow| match row {
            ActionRow::Unit(b) => usize::from(b.0) < e.basis,
            ActionRow::Solved(pivot) => e.solves(pivot.0),
        };
        let action = self.action.len() == e.basis && self.action.iter().all(is_row);
        require(action, "a row of the action matrix is out of range")?;
        let is_known = |monomial: KnownMonomial| match monomial {
            KnownMonomial::Basis(b) | KnownMonomial::Image(b) => usize::from(b.0) < e.basis,
            KnownMonomial::Read(at) => usize::from(at) < self.read.len(),
        };
        let mut pairs = self.extractions.iter().flat_map(|x| &x.pairs);
        let known =
            self.read.iter().all(|pivot| e.solves(pivot.0)) && pairs.all(|&(m, xm)| is_known(m) && is_known(xm));
        require(known, "an unknown is read from a monomial that is not known")
    }

    /// Each chain follows the unit rows to a solved one, and together they are the basis.
    fn check_chains(&self) -> Result<(), PlanError> {
        let Some(chains) = &self.chains else { return Ok(()) };
        let mut listed: Vec<usize> = chains.order.iter().map(|b| usize::from(b.0)).collect();
        let lengths = chains.lengths.iter().copied().chain((0..chains.eliminated).map(|_| 1));
        let lengths: Vec<usize> = lengths.collect();
        let has_all = lengths.iter().sum::<usize>() == listed.len() && chains.eliminated <= chains.lengths.len();
        let follows = |pair: &[BasisId]| self.action[usize::from(pair[0].0)] == ActionRow::Unit(pair[1]);
        let ends = |end: &BasisId| matches!(self.action[usize::from(end.0)], ActionRow::Solved(_));
        let mut rest = chains.order.as_slice();
        listed.sort_unstable();
        let is_chain = |length: usize| {
            let (chain, behind) = rest.split_at(length);
            rest = behind;
            chain.windows(2).all(follows) && chain.last().is_some_and(ends)
        };
        let is_basis = has_all && listed.into_iter().eq(0..self.elimination.basis);
        require(is_basis && lengths.into_iter().all(is_chain), "the chains are not those of the basis")
    }

    /// The unknowns, in the order in which they become known.
    fn check_unknowns(&self) -> Result<(), PlanError> {
        let mut known = vec![false; self.unknowns.len()];
        for x in &self.extractions {
            let own = x.is_square() || x.step.get(x.unknown) == Some(&1);
            let others =
                x.step.len() == known.len() && x.others().all(|(other, e)| known[other] && matches!(e, 1 | -1));
            require(own && others, "an unknown is read with one that is not known")?;
            known[x.unknown] |= !x.pairs.is_empty();
        }
        let width = self.action_monomial.len();
        require(width == 0 || width == known.len(), "the action monomial has another number of unknowns")?;
        let is_image = |&(of, _): &Image| usize::from(of) < known.len();
        let images = self.images.iter().all(|map| map.len() == known.len() && map.iter().all(is_image));
        require(images, "a symmetry has another number of unknowns")?;
        let most = self.elimination.basis * (1 + self.images.len()) + usize::from(self.has_origin);
        require(self.solutions <= most, "the basis is smaller than the number of solutions")?;
        let is_term = |t: &Term| self.has(t.coefficient) && t.exponents.len() == self.unknowns.len();
        let reads_known =
            |t: &Term, known: &[bool]| is_term(t) && t.exponents.iter().zip(known).all(|(&e, &known)| e == 0 || known);
        if let Some(block) = &self.linear {
            let (count, rows) = (block.unknowns.len(), &block.rows);
            let has_shape = rows.iter().all(|row| row.len() == count + 1) && rows.len() >= count;
            require(has_shape && (1..=MOST_LINEAR).contains(&count), "a linear block has another shape")?;
            let terms = rows.iter().flatten().flatten().all(|t| reads_known(t, &known));
            require(terms, "a term reads something unknown")?;
            let are_unknowns = block.unknowns.iter().all(|&unknown| unknown < known.len());
            require(are_unknowns, "a linear block has another unknown")?;
            block.unknowns.iter().for_each(|&unknown| known[unknown] = true);
        }
        for recovery in &self.recoveries {
            let terms = recovery.terms.iter().all(|t| reads_known(t, &known));
            require(terms, "a term reads something unknown")?;
            known[recovery.unknown] = true;
        }
        let terms = self.equations.iter().chain(&self.nonzero).chain(&self.positive).flatten().all(is_term);
        require(terms, "a term reads something unknown")?;
        require(known.into_iter().all(|known| known), "an unknown is never recovered")
    }
}

impl Elimination {
    /// Whether a pivot is among those that its block solves for.
    fn solves(&self, pivot: u16) -> bool {
        self.blocks.iter().any(|block| {
            let end = block.first + block.size;
            (end - block.needed..end).contains(&usize::from(pivot))
        })
    }
}

fn require(condition: bool, otherwise: &'static str) -> Result<(), PlanError> {
    if condition { Ok(()) } else { Err(PlanError(otherwise)) }
}
