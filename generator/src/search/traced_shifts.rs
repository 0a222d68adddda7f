//! Sets of shifts that solve because a Gröbner basis says so.
//!
//! Let B be the monomials that no leading monomial divides, and a an unknown or a product of two.
//! The normal form of each monomial of aB \ B is a combination of B, and F4 finds the difference as
//! a combination of multiples of the equations. These multiples are rows that express aB \ B in B:
//! a template, if only a large one, exists whenever the equations have finitely many solutions, and
//! its size is that of the largest matrices of F4 together. It need not be grown towards.
//!
//! Where signs can be changed, B falls into classes of equal parity, and a maps each class to
//! itself. One class then suffices.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::AtomicBool;

use super::formulation::Formulation;
use crate::algebra::{GeneratorMultiple, GroebnerError, Limits, Monomial, TracedBasis};
use crate::template::Shift;

/// No further set is looked at after this many were too large.
const MOST_TOO_LARGE: usize = 3;

/// Shifts from which an action monomial solves.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct TracedShifts {
    pub(crate) action: Monomial,
    /// Increasing.
    pub(crate) shifts: Vec<Shift>,
}

/// The sets of shifts by the trace of a formulation, one for each action monomial without
/// reciprocals and each class of basis monomials, those with the fewest shifts first. There is none
/// if the equations have infinitely many solutions before factors that must not vanish are divided
/// out.
///
/// # Errors
/// The Gröbner basis is too large, or the flag was set meanwhile.
pub(crate) fn traced_shifts(
    formulation: &Formulation,
    interruption: Option<&AtomicBool>,
) -> Result<Vec<TracedShifts>, GroebnerError> {
    let limits = Limits { is_over: interruption, ..Limits::default() };
    let traced = TracedBasis::new(formulation.instance.field, &formulation.instance.equations, &limits)?;
    let width = formulation.reduced.problem.unknowns.len();
    let standard = on_kept(formulation, &traced, width, limits.max_quotient_dimension);
    let Some(standard) = standard else { return Ok(Vec::new()) };
    let (mut sets, mut too_large) = (Vec::new(), Vec::new());
    for class in classes(formulation, standard) {
        if too_large.len() >= MOST_TOO_LARGE || class.len() < formulation.requirements(usize::MAX).solutions {
            continue;
        }
        for &action in formulation.actions.iter().filter(|action| action.is_polynomial()) {
            let image = class.iter().map(|m| m.times(&action)).chain(to_read(formulation, &class));
            match traced.multiples_for(image, &limits) {
                Ok(multiples) => sets.push(TracedShifts { action, shifts: shifts_of(multiples) }),
                Err(error) => too_large.push(error),
            }
            if too_large.len() >= MOST_TOO_LARGE {
                break;
            }
        }
    }
    sets.sort_by_key(|set| set.shifts.len());
    match too_large.pop() {
        Some(error) if sets.is_empty() => Err(error),
        _ => Ok(sets),
    }
}

fn shifts_of(multiples: BTreeSet<GeneratorMultiple>) -> Vec<Shift> {
    multiples.into_iter().map(|(equation, multiplier)| Shift { equation, multiplier }).collect()
}

/// The standard monomials in the unknowns that presolve kept; `None` if they are not finitely many.
fn on_kept(formulation: &Formulation, traced: &TracedBasis, width: usize, limit: usize) -> Option<Vec<Monomial>> {
    let mut basis = traced.basis().leading_monomials();
    // Unknowns that were eliminated do not occur, so no leading monomial would bound them.
    basis.extend((0..width).filter(|at| !formulation.reduced.kept.contains(at)).map(Monomial::unknown));
    let is_standard = |m: &Monomial| !basis.iter().any(|leading| leading.divides(m));
    let mut standard: Vec<Monomial> = [Monomial::ONE].into_iter().filter(is_standard).collect();
    let mut last: Vec<usize> = vec![0; standard.len()];
    let mut next = 0;
    while next < standard.len() {
        for unknown in last[next]..width {
            let product = standard[next].checked_mul(&Monomial::unknown(unknown))?;
            if is_standard(&product) {
                standard.push(product);
                last.push(unknown);
            }
        }
        if standard.len() > limit {
            return None;
        }
        next += 1;
    }
    Some(standard)
}

/// The monomials by their parities under the sign changes that are used.
fn classes(formulation: &Formulation, standard: Vec<Monomial>) -> Vec<Vec<Monomial>> {
    let flips = formulation.symmetry.generators();
    let parity = |m: &Monomial| -> Vec<bool> {
        flips.iter().map(|flip| flip.iter().map(|&at| i32::from(m.exponent(at))).sum::<i32>() % 2 != 0).collect()
    };
    let mut classes: BTreeMap<Vec<bool>, Vec<Monomial>> = BTreeMap::new();
    standard.into_iter().for_each(|m| classes.entry(parity(&m)).or_default().push(m));
    classes.into_values().collect()
}

/// Monomials whose normal forms give an unknown that no ratio of two basis monomials gives, by the
/// first way to read the unknowns.
fn to_read(formulation: &Formulation, class: &[Monomial]) -> Vec<Monomial> {
    let mut monomials = Vec::new();
    for reading in formulation.readings.first().into_iter().flatten() {
        let products = || {
            class
                .iter()
                .flat_map(|m| reading.steps.iter().map(move |step| m.times(step)))
                .filter(Monomial::is_polynomial)
        };
        if !products().any(|product| class.contains(&product)) {
            monomials.extend(products().min());
        }
    }
    monomials
}
