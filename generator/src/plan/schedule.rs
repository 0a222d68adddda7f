//! From an elimination template to a [`Plan`].

use std::collections::HashMap;

use super::block_triangular::{DiagonalBlock, block_triangular_form};
use super::coefficients::{Coefficients, planned_output};
use super::constant_pivots::{ConstantPivots, Row, eliminate_constant_pivots};
use super::straight_line::{planned_derivations, planned_measurement, straight_line_program};
use super::zeros::zeros;
use super::{
    ActionRow, BasisId, Block, Elimination, Entry, Extraction, KnownMonomial, PivotId, Plan, PlanError, PlannedBlock,
    PlannedRecovery,
};
use crate::algebra::Monomial;
use crate::expression::{ExpressionGraph, ExpressionId, SymbolicPolynomial};
use crate::presolve::pair::images;
use crate::presolve::symmetry::{Reading, Symmetry};
use crate::presolve::{LinearBlock, ReducedProblem};
use crate::problem::Problem;
use crate::problem::output::Output;
use crate::template::{EliminationTemplate, Shift};

/// Why a template cannot be turned into a plan.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ScheduleError {
    /// The template does not fit the problem.
    #[error("the template does not belong to the problem: {0}")]
    Mismatch(String),
    /// The square part of the template is singular for every instance.
    #[error("the template is structurally singular")]
    Singular,
    /// No two monomials of the basis, its image and the other reducible columns have the unknown as
    /// their ratio.
    #[error("the unknown `{0}` cannot be read from the template's monomials")]
    Unreadable(String),
    /// More coefficients, rows or basis monomials than the tables can index.
    #[error("the problem is too large: more than 65,535 {0}")]
    TooLarge(&'static str),
    /// The result contradicts itself: a fault of this crate.
    #[error(transparent)]
    Plan(#[from] PlanError),
}

/// Plans the solver of `problem` by eigenvalues, from a template for its presolved form.
/// `solutions` is the number of different complex solutions, and `zero_sets` are sets of unknowns
/// that are 0 together at one of them.
///
/// Constant pivots are eliminated here if the plan then has fewer operations.
pub fn schedule(
    problem: &Problem,
    reduced: &ReducedProblem,
    template: &EliminationTemplate,
    (solutions, zero_sets): (usize, &[Vec<usize>]),
) -> Result<Plan, ScheduleError> {
    check_shape(reduced, template)?;
    let scheduler = Scheduler { problem, reduced, template, solutions, zero_sets };
    let mut rows = template_rows(reduced, template);
    let plan = scheduler.plan(&rows, &reduced.problem.graph);
    let Some(pivots) = pivots_before_run_time(reduced) else { return plan };
    let mut graph = reduced.problem.graph.clone();
    eliminate_constant_pivots(&mut rows, template.excess.len(), &mut graph, pivots);
    match (plan, scheduler.plan(&rows, &graph)) {
        (Ok(plan), Ok(shorter)) if shorter.operations().total() < plan.operations().total() => Ok(shorter),
        (Err(ScheduleError::TooLarge(_)), Ok(shorter)) => Ok(shorter),
        (plan, _) => plan,
    }
}

/// The pivots with which a template for this problem can be eliminated before run time.
fn pivots_before_run_time(reduced: &ReducedProblem) -> Option<ConstantPivots> {
    let is_constant = |&(_, c): &(Monomial, ExpressionId)| reduced.problem.graph.as_constant(c).is_some();
    match reduced.is_solved_for_leads {
        true => Some(ConstantPivots::OfAllRows),
        false if reduced.problem.polynomials().any(|p| p.terms().iter().all(is_constant)) => {
            Some(ConstantPivots::OfConstantRows)
        }
        false => None,
    }
}

/// The rows of the template. Monomials that are no column cancel in every combination that is read,
/// and are left out.
fn template_rows(reduced: &ReducedProblem, template: &EliminationTemplate) -> Vec<Row> {
    let columns = template.excess.iter().chain(&template.reducible).chain(&template.basis);
    let position: HashMap<Monomial, usize> = columns.enumerate().map(|(at, &m)| (m, at)).collect();
    let row = |(at, shift): (usize, &Shift)| {
        let terms = reduced.problem.equations[shift.equation].polynomial.terms();
        let entry = |&(m, c): &(Monomial, ExpressionId)| Some((*position.get(&m.times(&shift.multiplier))?, c));
        Row { shift: at, entries: terms.iter().filter_map(entry).collect() }
    };
    template.shifts.iter().enumerate().map(row).collect()
}

/// The input that all plans for one template have in common.
struct Scheduler<'a> {
    problem: &'a Problem,
    reduced: &'a ReducedProblem,
    template: &'a EliminationTemplate,
    solutions: usize,
    zero_sets: &'a [Vec<usize>],
}

impl Scheduler<'_> {
    /// The plan with these rows of the template, whose entries are in `graph`.
    fn plan(&self, rows: &[Row], graph: &ExpressionGraph) -> Result<Plan, ScheduleError> {
        let Self { problem, reduced, template, .. } = self;
        let mut coefficients = Coefficients::of_equations(problem);
        let (elimination, pivots) = plan_elimination(template, rows, &mut coefficients)?;
        let action = plan_action(template, &pivots)?;
        let extra = template.extra();
        let read = extra.iter().filter_map(|m| pivots.get(m).copied()).collect();
        let symmetry = reduced.symmetry.of_template(&template.action, &template.basis).on(&reduced.kept);
        self.check_basis(&symmetry)?;
        let width = problem.unknowns.len();
        let extractions = self.extractions(&extra, &symmetry.readings(&reduced.kept))?;
        let images = symmetry.all().iter().map(|flip| images(width, flip, &reduced.pairs)).collect();
        let linear = reduced.linear.as_ref().map(|block| planned_block(block, &mut coefficients, width));
        let recoveries: Vec<_> = reduced
            .recoveries
            .iter()
            .map(|r| PlannedRecovery { unknown: r.unknown, terms: coefficients.terms(&r.value, width) })
            .collect();
        let equations = problem.polynomials().map(|p| coefficients.terms(p, width)).collect();
        let nonzero = problem.nonzero.iter().map(|s| coefficients.terms(&s.polynomial, width)).collect();
        let positive = problem.positive.iter().map(|s| coefficients.terms(&s.polynomial, width)).collect();
        let output = problem.output.as_ref().map(|output| planned_output(problem, output));
        if coefficients.used.len() > usize::from(u16::MAX) {
            return Err(ScheduleError::TooLarge("coefficients"));
        }
        let used: Vec<ExpressionId> = coefficients.used.iter().flatten().copied().collect();
        let by_results: Vec<ExpressionId> = problem.output.iter().flat_map(Output::elements).collect();
        let (mut program, values) = straight_line_program(graph, &used, elimination.rows);
        let (mut values, zero) = (values.into_iter(), coefficients.used.contains(&None).then(|| program.zero()));
        let value = |used: &Option<ExpressionId>| used.map_or(zero, |_| values.next());
        let values = coefficients.used.iter().filter_map(value).collect();
        let is_of_unknowns = reduced.separated.is_none() && reduced.pairs.is_empty();
        let plan = Plan {
            name: problem.name.clone(),
            docs: problem.docs.clone(),
            data: problem.data.clone(),
            derived: planned_derivations(graph, &used, &by_results),
            measurements: problem.measurements.iter().map(planned_measurement).collect(),
            stated: problem.graph.input_count(),
            unknowns: problem.unknowns.clone(),
            fields: problem.fields.clone(),
            solutions: self.solutions,
            has_origin: reduced.problem.has_origin(),
            zeros: zeros(problem, reduced, template, &extractions),
            program,
            coefficients: values,
            elimination,
            action,
            action_monomial: if is_of_unknowns { template.action.exponents()[..width].to_vec() } else { Vec::new() },
            read,
            chains: None,
            extractions,
            images,
            linear,
            recoveries,
            equations,
            nonzero,
            positive,
            output,
            scene: problem.scene.clone(),
            scalings: problem.scalings.clone(),
        };
        plan.check()?;
        Ok(plan)
    }

    /// Refuses a basis that is too small for the solutions that there are.
    fn check_basis(&self, symmetry: &Symmetry) -> Result<(), ScheduleError> {
        let has_origin = self.reduced.problem.has_origin();
        let most = self.template.basis.len() * symmetry.order() + usize::from(has_origin);
        if self.solutions > most {
            let what = format!("{} solutions, but its basis gives {most} at most", self.solutions);
            return Err(ScheduleError::Mismatch(what));
        }
        Ok(())
    }

    /// How the unknowns are read: in the first of the `ways` that reads all of them.
    fn extractions(&self, extra: &[Monomial], ways: &[Vec<Reading>]) -> Result<Vec<Extraction>, ScheduleError> {
        let mut missing = None;
        for readings in ways {
            let extractions: Result<Vec<Extraction>, usize> =
                readings.iter().map(|reading| self.extraction(extra, reading)).collect();
            match extractions {
                Ok(mut extractions) => {
                    extractions.sort_by_key(|x| !x.is_square());
                    return Ok(extractions);
                }
                Err(unknown) => missing = missing.or(Some(unknown)),
            }
        }
        let unknowns = &self.problem.unknowns;
        Err(ScheduleError::Unreadable(missing.map_or_else(String::new, |unknown| unknowns[unknown].clone())))
    }

    /// Reads an unknown from all pairs (m, s m) among the basis monomials. If there are none, or
    /// all m vanish at a solution where unknowns are 0, they are searched among basis and image,
    /// and then among the `extra` monomials too. The error is the unknown.
    fn extraction(&self, extra: &[Monomial], reading: &Reading) -> Result<Extraction, usize> {
        let (template, width) = (self.template, self.problem.unknowns.len());
        let ids = || (0u16..).map(BasisId);
        let basis: Vec<(Monomial, KnownMonomial)> =
            template.basis.iter().copied().zip(ids().map(KnownMonomial::Basis)).collect();
        let images = template.basis.iter().map(|b| b.times(&template.action)).zip(ids().map(KnownMonomial::Image));
        let image: Vec<_> = basis.iter().copied().chain(images).collect();
        let all: Vec<_> =
            image.iter().copied().chain(extra.iter().copied().zip((0u16..).map(KnownMonomial::Read))).collect();
        let pairs = |known: &[(Monomial, KnownMonomial)], step: &Monomial| -> Vec<(Monomial, [KnownMonomial; 2])> {
            let find = |m: Monomial| known.iter().find(|(n, _)| *n == m).map(|&(_, at)| at);
            known.iter().filter_map(|&(m, at)| Some((m, [at, find(m.times(step))?]))).collect()
        };
        let is_nonzero = |m: &Monomial, zeros: &Vec<usize>| zeros.iter().all(|&unknown| m.exponent(unknown) == 0);
        let most_pairs = |known: &[(Monomial, KnownMonomial)]| {
            let all = reading.steps.iter().map(|step| (step, pairs(known, step))).filter(|(_, x)| !x.is_empty());
            // Of steps with equally many pairs, the first is taken: `max_by_key` returns the last.
            all.rev().max_by_key(|(_, pairs)| pairs.len())
        };
        let ways: Vec<_> = [&basis, &image, &all].into_iter().filter_map(|known| most_pairs(known)).collect();
        let reads_everywhere = |(_, pairs): &&(&Monomial, Vec<(Monomial, _)>)| {
            self.zero_sets.iter().all(|zeros| pairs.iter().any(|(m, _)| is_nonzero(m, zeros)))
        };
        let (step, pairs) = ways.iter().find(reads_everywhere).or(ways.first()).ok_or(reading.unknown)?;
        Ok(Extraction {
            unknown: reading.unknown,
            step: step.exponents()[..width].to_vec(),
            pairs: pairs.iter().map(|&(_, [from, to])| (from, to)).collect(),
        })
    }
}

fn planned_block(block: &LinearBlock, coefficients: &mut Coefficients, width: usize) -> PlannedBlock {
    let mut row = |row: &Vec<SymbolicPolynomial>| row.iter().map(|entry| coefficients.terms(entry, width)).collect();
    PlannedBlock { unknowns: block.unknowns.clone(), rows: block.rows.iter().map(&mut row).collect() }
}

fn check_shape(reduced: &ReducedProblem, template: &EliminationTemplate) -> Result<(), ScheduleError> {
    let mismatch = |what: String| Err(ScheduleError::Mismatch(what));
    if template.rows() > usize::from(u16::MAX) || template.basis.len() > usize::from(u16::MAX) {
        return Err(ScheduleError::TooLarge("rows or basis monomials"));
    }
    if template.rows() != template.excess.len() + template.reducible.len() {
        return mismatch(format!(
            "{} rows for {} excess and {} reducible columns",
            template.rows(),
            template.excess.len(),
            template.reducible.len()
        ));
    }
    let equations = reduced.problem.equations.len();
    match template.shifts.iter().find(|shift| shift.equation >= equations) {
        Some(shift) => mismatch(format!("a shift of equation {}, but there are {equations}", shift.equation + 1)),
        None => Ok(()),
    }
}

fn plan_elimination(
    template: &EliminationTemplate,
    rows: &[Row],
    coefficients: &mut Coefficients,
) -> Result<(Elimination, HashMap<Monomial, PivotId>), ScheduleError> {
    let (excess, left) = (template.excess.len(), template.excess.len() + template.reducible.len());
    // Columns of constant pivots have no entry any more.
    let mut used: Vec<bool> = (0..left).map(|column| column >= excess).collect();
    rows.iter().flat_map(|row| row.entries.range(..left)).for_each(|(&column, _)| used[column] = true);
    let columns: Vec<usize> = (0..left).filter(|&column| used[column]).collect();
    if columns.len() != rows.len() {
        return Err(ScheduleError::Singular);
    }
    let position = |column: &usize| columns.binary_search(column).unwrap_or(0);
    let pattern: Vec<Vec<usize>> =
        rows.iter().map(|row| row.entries.range(..left).map(|(column, _)| position(column)).collect()).collect();
    let mut diagonal = block_triangular_form(&pattern).ok_or(ScheduleError::Singular)?;
    let is_reducible: Vec<bool> = columns.iter().map(|&column| column >= excess).collect();
    let needed = needed_last(&mut diagonal, &pattern, is_reducible);
    let mut pivot_of_column = vec![0; left];
    let pivot_columns: Vec<usize> = diagonal.iter().flat_map(|block| &block.columns).map(|&at| columns[at]).collect();
    for (pivot, &column) in pivot_columns.iter().enumerate() {
        pivot_of_column[column] = pivot;
    }
    let mut elimination = Elimination {
        rows: rows.len(),
        basis: template.basis.len(),
        right: Vec::new(),
        blocks: Vec::new(),
        row_shifts: diagonal.iter().flat_map(|block| &block.rows).map(|&row| rows[row].shift).collect(),
        pivot_columns,
    };
    for (block, needed) in diagonal.iter().zip(needed) {
        let first = elimination.blocks.last().map_or(0, |last: &Block| last.first + last.size);
        let planned = plan_block(block, first, (rows, &pivot_of_column), coefficients, &mut elimination.right);
        elimination.blocks.push(Block { needed, ..planned });
    }
    let reducible = template.reducible.iter().zip(&pivot_of_column[excess..]);
    let pivots = reducible.map(|(&m, &pivot)| (m, PivotId(pivot as u16))).collect();
    Ok((elimination, pivots))
}

/// Reorders the columns of each block so that those which something else reads come last, and
/// returns their number for each block. `is_read` says which are read after the elimination.
///
/// Back-substitution runs from the last pivot upwards and stops after the last one that is needed.
fn needed_last(blocks: &mut [DiagonalBlock], pattern: &[Vec<usize>], mut is_read: Vec<bool>) -> Vec<usize> {
    let mut block_of_column = vec![0; pattern.len()];
    for (at, block) in blocks.iter().enumerate() {
        block.columns.iter().for_each(|&column| block_of_column[column] = at);
    }
    for (at, block) in blocks.iter().enumerate() {
        for &column in block.rows.iter().flat_map(|&row| &pattern[row]) {
            is_read[column] |= block_of_column[column] != at;
        }
    }
    blocks
        .iter_mut()
        .map(|block| {
            block.columns.sort_by_key(|&column| (is_read[column], column));
            block.columns.iter().filter(|&&column| is_read[column]).count()
        })
        .collect()
}

/// The tables of one block, whose first pivot is `first`; its entries in basis columns are added to
/// `right`.
fn plan_block(
    block: &DiagonalBlock,
    first: usize,
    (rows, pivot_of_column): (&[Row], &[usize]),
    coefficients: &mut Coefficients,
    right: &mut Vec<Entry>,
) -> Block {
    let width = pivot_of_column.len();
    let mut planned = Block { first, size: block.rows.len(), needed: 0, diagonal: Vec::new(), coupling: Vec::new() };
    for (at, &row) in block.rows.iter().enumerate() {
        let (left, basis) = (rows[row].entries.range(..width), rows[row].entries.range(width..));
        for (&column, &c) in left {
            let pivot = pivot_of_column[column];
            let coefficient = coefficients.id(c);
            let row = at as u16;
            match pivot.checked_sub(first) {
                Some(column) => planned.diagonal.push(Entry { row, column: column as u16, coefficient }),
                None => planned.coupling.push(Entry { row, column: pivot as u16, coefficient }),
            }
        }
        for (&column, &c) in basis {
            let coefficient = coefficients.id(c);
            right.push(Entry { row: (first + at) as u16, column: (column - width) as u16, coefficient });
        }
    }
    planned
}

fn plan_action(
    template: &EliminationTemplate,
    pivots: &HashMap<Monomial, PivotId>,
) -> Result<Vec<ActionRow>, ScheduleError> {
    let row = |b: &Monomial| {
        let image = b.times(&template.action);
        let in_basis = template.basis.iter().position(|&m| m == image).map(|at| ActionRow::Unit(BasisId(at as u16)));
        in_basis.or_else(|| pivots.get(&image).map(|&pivot| ActionRow::Solved(pivot)))
    };
    let missing = || ScheduleError::Mismatch("the image of a basis monomial is no column".into());
    template.basis.iter().map(|b| row(b).ok_or_else(missing)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::presolve::{Presolve, presolve};

    fn m(x: i8, y: i8) -> Monomial {
        Monomial::from_exponents(&[x, y])
    }

    fn problem() -> Problem {
        let text = "fn sample(a: [f64; 3]) -> (x, y) { x * x + a[0] * x + a[1] == 0; y + a[2] * x * x == 1; }";
        Problem::parse("sample.rs", text).unwrap()
    }

    /// Both equations: y is no image of the basis, and is expressed only to be read.
    fn template() -> EliminationTemplate {
        EliminationTemplate {
            shifts: (0..2).map(|equation| Shift { equation, multiplier: Monomial::ONE }).collect(),
            action: m(1, 0),
            excess: Vec::new(),
            reducible: vec![m(2, 0), m(0, 1)],
            basis: vec![m(1, 0), m(0, 0)],
        }
    }

    fn planned(template: &EliminationTemplate, solutions: usize) -> Result<Plan, ScheduleError> {
        let problem = problem();
        let reduced = presolve(&problem, Presolve::None);
        schedule(&problem, &reduced, template, (solutions, &[]))
    }

    /// Why the template is refused after a change.
    fn refused(change: impl Fn(&mut EliminationTemplate)) -> ScheduleError {
        let mut changed = template();
        change(&mut changed);
        planned(&changed, 2).expect_err("a template that does not fit")
    }

    #[test]
    fn the_second_block_reads_the_first() {
        let plan = planned(&template(), 2).unwrap();
        let e = &plan.elimination;
        let shape = |block: &Block| (block.first, block.size, block.needed, block.coupling.len());
        assert_eq!(e.blocks.iter().map(shape).collect::<Vec<_>>(), [(0, 1, 1, 0), (1, 1, 1, 1)]);
        assert_eq!((e.row_shifts.as_slice(), e.pivot_columns.as_slice()), ([0, 1].as_slice(), [0, 1].as_slice()));
        assert_eq!(plan.action, [ActionRow::Solved(PivotId(0)), ActionRow::Unit(BasisId(0))]);
        assert_eq!(plan.read, [PivotId(1)]);
        let pairs: Vec<_> = plan.extractions.iter().map(|x| x.pairs.as_slice()).collect();
        let one = KnownMonomial::Basis(BasisId(1));
        let expected = [[(one, KnownMonomial::Basis(BasisId(0)))], [(one, KnownMonomial::Read(0))]];
        assert_eq!(pairs, expected.each_ref().map(|pairs| pairs.as_slice()));
    }

    #[test]
    fn what_does_not_fit_the_problem_is_refused() {
        let mismatch = |what: &str| ScheduleError::Mismatch(what.to_owned());
        let rows = mismatch("2 rows for 0 excess and 1 reducible columns");
        assert_eq!(refused(|t| t.reducible.truncate(1)), rows);
        let shift = mismatch("a shift of equation 3, but there are 2");
        assert_eq!(refused(|t| t.shifts[1].equation = 2), shift);
        let image = mismatch("the image of a basis monomial is no column");
        assert_eq!(refused(|t| t.basis.push(m(1, 1))), image);
        let solutions = mismatch("3 solutions, but its basis gives 2 at most");
        assert_eq!(planned(&template(), 3), Err(solutions));
        // Two rows have one pivot column, or one row has none.
        assert_eq!(refused(|t| t.shifts[1].equation = 0), ScheduleError::Singular);
        let multiple = |t: &mut EliminationTemplate| {
            t.shifts[1] = Shift { equation: 0, multiplier: m(0, 1) };
            t.reducible[1] = m(2, 2);
        };
        assert_eq!(refused(multiple), ScheduleError::Singular);
    }

    #[test]
    fn an_unknown_that_no_monomial_gives_is_named() {
        let without_y = |t: &mut EliminationTemplate| {
            t.shifts.pop();
            t.reducible.pop();
        };
        assert_eq!(refused(without_y), ScheduleError::Unreadable("y".to_owned()));
    }

    /// 65,535 rows and basis monomials can be numbered; what is wrong with these is something else.
    #[test]
    fn templates_that_the_tables_cannot_number_are_refused() {
        let most = usize::from(u16::MAX);
        let too_large = ScheduleError::TooLarge("rows or basis monomials");
        let shift = Shift { equation: 0, multiplier: Monomial::ONE };
        assert_eq!(refused(|t| t.shifts = vec![shift; most + 1]), too_large);
        assert!(matches!(refused(|t| t.shifts = vec![shift; most]), ScheduleError::Mismatch(_)));
        let basis = |count: usize| {
            refused(|t| {
                t.basis = vec![Monomial::ONE; count];
                t.shifts[0].equation = 2;
            })
        };
        assert_eq!(basis(most + 1), too_large);
        assert!(matches!(basis(most), ScheduleError::Mismatch(_)));
    }

    /// y and x change their signs together. One of them is a square root, and the other is read
    /// with it.
    #[test]
    fn square_roots_are_read_first() {
        let text = "fn signs(a: [f64; 2]) -> (y, x) { y == a[0] * x; x * x == a[1]; }";
        let problem = Problem::parse("signs.rs", text).unwrap();
        let reduced = presolve(&problem, Presolve::None);
        // In y and x: x^2 and y x by the basis 1.
        let template = EliminationTemplate {
            shifts: vec![
                Shift { equation: 0, multiplier: m(0, 1) },
                Shift { equation: 1, multiplier: Monomial::ONE },
                Shift { equation: 0, multiplier: m(1, 0) },
            ],
            action: m(0, 2),
            excess: Vec::new(),
            reducible: vec![m(0, 2), m(1, 1), m(2, 0)],
            basis: vec![Monomial::ONE],
        };
        let plan = schedule(&problem, &reduced, &template, (2, &[])).unwrap();
        assert_eq!(plan.images, [[(0, true), (1, true)]]);
        let is_square: Vec<bool> = plan.extractions.iter().map(Extraction::is_square).collect();
        assert_eq!(is_square, [true, false]);
        // Without y^2 the other unknown, x, is the square root.
        let mut other = template;
        other.shifts.pop();
        other.reducible.pop();
        let plan = schedule(&problem, &reduced, &other, (2, &[])).unwrap();
        assert_eq!(plan.extractions.iter().map(|x| x.unknown).collect::<Vec<_>>(), [1, 0]);
    }
}
