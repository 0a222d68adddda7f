//! The elimination of an interpreted plan.

use eliminant::SolveError;
use eliminant::emitted;

use crate::plan::{ActionRow, Plan};

/// The template's tables, owned.
#[derive(Clone, Debug)]
pub(super) struct Elimination {
    rows: usize,
    right: Vec<emitted::Entry>,
    blocks: Vec<Block>,
    pub(super) action: Vec<emitted::ActionRow>,
    pub(super) read: Vec<u16>,
}

#[derive(Clone, Debug)]
struct Block {
    first: u16,
    size: usize,
    needed: u16,
    diagonal: Vec<emitted::Entry>,
    coupling: Vec<emitted::Entry>,
}

impl Elimination {
    pub(super) fn of(plan: &Plan) -> Self {
        let entries = |entries: &[crate::plan::Entry]| {
            entries.iter().map(|entry| (entry.row, entry.column, entry.coefficient.0)).collect()
        };
        let block = |block: &crate::plan::Block| Block {
            first: block.first as u16,
            size: block.size,
            needed: block.needed as u16,
            diagonal: entries(&block.diagonal),
            coupling: entries(&block.coupling),
        };
        let action = |row: &ActionRow| match row {
            ActionRow::Unit(b) => emitted::ActionRow::Unit(b.0),
            ActionRow::Solved(pivot) => emitted::ActionRow::Solved(pivot.0),
        };
        Self {
            rows: plan.elimination.rows,
            right: entries(&plan.elimination.right),
            blocks: plan.elimination.blocks.iter().map(block).collect(),
            action: plan.action.iter().map(action).collect(),
            read: plan.read.iter().map(|pivot| pivot.0).collect(),
        }
    }

    /// The solved rows of all pivots.
    pub(super) fn solve<R: emitted::Real + emitted::Over<C>, C: Copy>(
        &self,
        basis: usize,
        coefficients: &[C],
    ) -> Result<Vec<Vec<R>>, SolveError> {
        let mut right = vec![vec![R::ZERO; basis]; self.rows];
        emitted::fill::<R, C, _>(&mut right, &self.right, coefficients);
        for (number, block) in self.blocks.iter().enumerate() {
            let n = block.size;
            let (mut matrix, mut row_scale, mut smallest) = (vec![R::ZERO; n * n], vec![0.0; n], vec![0.0; n]);
            let memory =
                emitted::BlockMemory { matrix: &mut matrix, row_scale: &mut row_scale, smallest: &mut smallest };
            let tables = emitted::Block {
                number: number as u16,
                first: block.first,
                needed: block.needed,
                diagonal: &block.diagonal,
                coupling: &block.coupling,
            };
            tables.eliminate_in(memory, &mut right, coefficients)?;
        }
        Ok(right)
    }
}
