//! Solutions at which some unknown vanishes, which a template may lose.

use super::{Extraction, KnownMonomial};
use crate::problem::Problem;
use crate::template::EliminationTemplate;

/// How a template loses solutions at which some unknown vanishes, unless it is stated that it does
/// not vanish.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Zeros {
    /// They have no eigenpair: the action monomial is divided by the unknown, or all basis
    /// monomials are multiples of it.
    pub lacks_pairs: bool,
    /// Another unknown cannot be read from their eigenpair: of each pair (m, s m) that it is read
    /// from, m has a higher power of the unknown that vanishes than some basis monomial.
    pub is_misread: bool,
}

impl Zeros {
    pub(super) fn of(problem: &Problem, template: &EliminationTemplate, extractions: &[Extraction]) -> Self {
        let factors = || problem.nonzero.iter().map(|factor| factor.polynomial.terms());
        let may_vanish = |&unknown: &usize| {
            !factors().any(|terms| matches!(terms, [(monomial, _)] if monomial.exponent(unknown) > 0))
        };
        let unknowns: Vec<usize> = (0..problem.unknowns.len()).filter(may_vanish).collect();
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
        Self { lacks_pairs: unknowns.iter().any(lacks_pairs), is_misread: unknowns.iter().any(is_misread) }
    }
}
