//! Strategies: in which formulation, and in which order, multiples of the equations are stacked.

use super::formulation::Formulation;
use super::grow::{Growth, linear_groups};
use crate::presolve::Presolve;

/// A formulation of the problem and a way to grow its set of shifts.
pub(crate) struct Strategy<'a> {
    pub(crate) formulation: &'a Formulation,
    pub(crate) growth: Growth,
}

impl Strategy<'_> {
    /// The strategy in words.
    pub(crate) fn describe(&self) -> String {
        let presolve = self.formulation.presolve;
        let combined = if presolve.combines() { "equations combined, " } else { "" };
        let unknowns = &self.formulation.reduced.problem.unknowns;
        let name = |at: u8| unknowns.get(usize::from(at)).map_or("", String::as_str);
        let eliminated = match presolve {
            Presolve::Eliminated => "linear equations solved, ",
            Presolve::Solved => "solved for their highest monomials, ",
            Presolve::Hiding(at) => &format!("solved for the highest monomials beside {}, ", name(at)),
            Presolve::Determinants(at) => &format!("{} and others eliminated by determinants, ", name(at)),
            Presolve::None => "",
            Presolve::Separated => "by a linear form, ",
            Presolve::Paired => "in sums and differences, ",
            Presolve::Constant | Presolve::Combined => "after presolve with constant coefficients, ",
            Presolve::Linear | Presolve::CombinedLinear => "after presolve, ",
            Presolve::Square | Presolve::CombinedSquare => "after presolve and division by squares, ",
        };
        let symmetry = if self.formulation.symmetry.is_none() { "" } else { "up to sign, " };
        format!("{combined}{eliminated}{symmetry}{}", self.growth)
    }
}

/// All strategies in the order in which they begin: by total degree first, which is quick and
/// nearly always finds something, by other weights last, of which there are most. A search that is
/// ended early skips the last ones.
pub(crate) fn strategies(formulations: &[Formulation]) -> Vec<Strategy<'_>> {
    let of = |formulation| growths(formulation).into_iter().map(move |growth| Strategy { formulation, growth });
    let mut strategies: Vec<Strategy<'_>> = formulations.iter().flat_map(of).collect();
    strategies.sort_by_key(|strategy| match &strategy.growth {
        Growth::Degree(weights) if weights.iter().all(|&weight| weight == 1) => 0,
        Growth::Degree(_) => 2,
        _ => 1,
    });
    strategies
}

/// The strategies by the trace of a Gröbner basis, one for each formulation: those with the fewest
/// unknowns first, of these the one that tells all solutions apart by a linear form, then those
/// that use sign changes, and those that solve for monomials at run time last.
pub(crate) fn traced_strategies(formulations: &[Formulation]) -> Vec<Strategy<'_>> {
    let mut formulations: Vec<&Formulation> = formulations.iter().collect();
    formulations.sort_by_key(|formulation| {
        let reduced = &formulation.reduced;
        let is_separated = reduced.separated.is_some();
        (formulation.presolve.solves_at_run_time(), reduced.kept.len(), !is_separated, formulation.symmetry.is_none())
    });
    formulations.into_iter().map(|formulation| Strategy { formulation, growth: Growth::Trace }).collect()
}

/// Weights 1 and 2 in all ways for up to four unknowns, weight 2 for one unknown at a time for
/// more; bigraded by each group of unknowns in which the equations are linear; neighbours; best
/// shift, of polynomials and of Laurent polynomials.
fn growths(formulation: &Formulation) -> Vec<Growth> {
    let (kept, all) = (&formulation.reduced.kept, formulation.reduced.problem.unknowns.len());
    let mut growths = vec![Growth::Degree(vec![1; all])];
    let n = kept.len();
    // Bit k of a number stands for weight 2 of the k-th unknown.
    let heavy_sets: Vec<usize> = match n {
        1 => vec![],
        2..=4 => (1..(1 << n) - 1).collect(),
        _ => (0..n).map(|at| 1 << at).collect(),
    };
    for heavy in heavy_sets {
        let mut weights = vec![1; all];
        kept.iter().enumerate().filter(|(at, _)| heavy >> at & 1 == 1).for_each(|(_, &unknown)| weights[unknown] = 2);
        growths.push(Growth::Degree(weights));
    }
    for group in linear_groups(&formulation.instance.equations, kept) {
        growths.extend([0, 1].map(|extra_degree| Growth::Bigraded { group: group.clone(), extra_degree }));
    }
    growths.push(Growth::Neighbours);
    growths.push(Growth::BestShift(0));
    growths.push(Growth::BestShift(1));
    growths.extend([0, 1].map(Growth::Laurent));
    growths
}
