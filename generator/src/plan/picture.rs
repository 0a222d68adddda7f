//! The layout that all drawings of a template share.
//!
//! ```text
//!                    excess E   reducible R   basis B
//! f1 * x*y         |  # .     |  . . # .    | o . o . |   # in a diagonal block
//! f2               |  + #     |  + . . #    | . o . o |   + at an earlier pivot, o in the basis
//! ```
//!
//! Rows and pivot columns stand in the order of solution.

use super::Plan;
use crate::algebra::Monomial;
use crate::template::{EliminationTemplate, Shift};

/// The part of the template that a column belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Columns of monomials that are neither reducible nor in the basis.
    Excess,
    /// Columns of the action monomial times basis monomials.
    Reducible,
    /// Columns of basis monomials.
    Basis,
}

impl Part {
    /// The parts from the left to the right.
    pub const ALL: [Self; 3] = [Self::Excess, Self::Reducible, Self::Basis];

    /// Colours that people with impaired colour vision tell apart (Okabe and Ito): of an entry in a
    /// diagonal block or the basis, of coupling, of the band behind them.
    #[must_use]
    pub fn colours(self) -> [&'static str; 3] {
        match self {
            Self::Excess => ["#0072b2", "#7fb8d8", "#eef5fa"],
            Self::Reducible => ["#d55e00", "#eaae7f", "#fdf3ec"],
            Self::Basis => ["#009e73", "#7fceb9", "#ecf7f4"],
        }
    }

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Excess => "excess",
            Self::Reducible => "reducible",
            Self::Basis => "basis",
        }
    }
}

/// The entry of a row in a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cell {
    /// The entry is zero for every instance.
    Empty,
    /// The entry is in a diagonal block.
    Diagonal,
    /// The entry is at a pivot that an earlier block has solved.
    Coupling,
    /// The entry is in a basis column.
    Right,
}

/// A template as it is drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// The shift of each row, such as `f2 * x*y`.
    pub rows: Vec<String>,
    /// The columns: excess, reducible, basis.
    pub columns: Vec<(Part, String)>,
    /// One cell for each row and column.
    pub cells: Vec<Vec<Cell>>,
    /// Number of rows of each diagonal block, in order of solution.
    pub blocks: Vec<usize>,
}

impl Picture {
    /// The picture of a template, with the order of solution of its plan.
    #[must_use]
    pub fn new(template: &EliminationTemplate, plan: &Plan) -> Self {
        let names = &plan.unknowns;
        let elimination = &plan.elimination;
        let excess = template.excess.len();
        // Excess pivots first, then reducible ones, each in the order of solution.
        let mut pivots: Vec<usize> = (0..elimination.rows).collect();
        pivots.sort_by_key(|&pivot| elimination.pivot_columns[pivot] >= excess);
        let mut column_of_pivot = vec![0; elimination.rows];
        pivots.iter().enumerate().for_each(|(column, &pivot)| column_of_pivot[pivot] = column);

        let show = |monomial: &Monomial| monomial.display(names).to_string();
        let pivot_column = |&pivot: &usize| match elimination.pivot_columns[pivot] {
            at if at < excess => (Part::Excess, show(&template.excess[at])),
            at => (Part::Reducible, show(&template.reducible[at - excess])),
        };
        let basis = template.basis.iter().map(|monomial| (Part::Basis, show(monomial)));
        let columns: Vec<_> = pivots.iter().map(pivot_column).chain(basis).collect();

        let mut cells = vec![vec![Cell::Empty; columns.len()]; elimination.rows];
        for block in &elimination.blocks {
            for entry in &block.diagonal {
                let pivot = block.first + usize::from(entry.column);
                cells[block.first + usize::from(entry.row)][column_of_pivot[pivot]] = Cell::Diagonal;
            }
            for entry in &block.coupling {
                cells[block.first + usize::from(entry.row)][column_of_pivot[usize::from(entry.column)]] =
                    Cell::Coupling;
            }
        }
        for entry in &elimination.right {
            cells[usize::from(entry.row)][elimination.rows + usize::from(entry.column)] = Cell::Right;
        }
        Self {
            rows: elimination.row_shifts.iter().map(|&at| label(&template.shifts[at], names)).collect(),
            columns,
            cells,
            blocks: elimination.blocks.iter().map(|block| block.size).collect(),
        }
    }

    /// Number of entries that are not zero for general data.
    #[must_use]
    pub fn entries(&self) -> usize {
        self.cells.iter().flatten().filter(|&&cell| cell != Cell::Empty).count()
    }

    /// The columns of one part.
    pub fn columns_of(&self, part: Part) -> impl Iterator<Item = usize> + '_ {
        (0..self.columns.len()).filter(move |&column| self.columns[column].0 == part)
    }
}

/// Equations count from 1, in the order in which they are left after presolve.
fn label(shift: &Shift, names: &[String]) -> String {
    let equation = shift.equation + 1;
    match shift.multiplier == Monomial::ONE {
        true => format!("f{equation}"),
        false => format!("f{equation} * {}", shift.multiplier.display(names)),
    }
}
