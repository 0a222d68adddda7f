//! Whether a template may lose solutions at which some unknown vanishes.

use super::{Extraction, KnownMonomial, Zeros};
use crate::algebra::Monomial;
use crate::presolve::ReducedProblem;
use crate::problem::Problem;
use crate::template::EliminationTemplate;

/// Coordinates of vectors that are given up to scale are not looked at: the chart is general, and
/// zero is a value like any other.
pub(super) fn zeros(
    problem: &Problem,
    reduced: &ReducedProblem,
    template: &EliminationTemplate,
    extractions: &[Extraction],
) -> Zeros {
    let may_vanish = |&unknown: &usize| {
        let mut factors = problem.nonzero.iter().map(|factor| factor.polynomial.terms());
        let is_factor = |terms: &[(Monomial, _)]| matches!(terms, [(m, _)] if m.exponent(unknown) > 0);
        // Half a sum or a difference may vanish where the unknown does not.
        reduced.pairs.iter().flatten().any(|&other| other == unknown) || !factors.any(is_factor)
    };
    let fields = problem.fields.iter().filter(|field| !field.is_projective);
    let unknowns: Vec<usize> = fields.flat_map(|field| field.unknowns()).filter(may_vanish).collect();
    let extra = template.extra();
    let monomial = |known: KnownMonomial| match known {
        KnownMonomial::Basis(at) => template.basis[usize::from(at.0)],
        KnownMonomial::Image(at) => template.basis[usize::from(at.0)].times(&template.action),
        KnownMonomial::Read(at) => extra[usize::from(at)],
    };
    let least = |unknown: usize| template.basis.iter().map(|m| m.exponent(unknown)).min().unwrap_or(0);
    let lacks_pairs = |&unknown: &usize| template.action.exponent(unknown) < 0 || least(unknown) > 0;
    let is_misread = |&unknown: &usize| {
        let is_small = |&(from, _): &(KnownMonomial, _)| monomial(from).exponent(unknown) > least(unknown);
        extractions.iter().any(|x| x.pairs.iter().all(is_small))
    };
    Zeros { lacks_pairs: unknowns.iter().any(lacks_pairs), is_misread: unknowns.iter().any(is_misread) }
}
