//! Chooses among the templates that a search found, by their cost and by what they do on random real instances.
//!
//! The candidates come in order of operations. The cheapest one of each combination of presolved form, action monomial and basis is measured
//! until [`MEASURED`] are; if none of these is acceptable, more are, up to [`MEASURED_AT_MOST`].
//!
//! A candidate is *acceptable* if
//! - no instance failed,
//! - at most one instance in [`INCOMPLETE_ONE_IN`] lacks a solution,
//! - the 99 % quantile of its log10 relative residual is at most [`GOOD_RESIDUAL`], or at most 1 above the best one measured.
//!
//! Among the acceptable ones whose operations are within [`SIMILAR_COST`] of the cheapest of them, the one with the fewest instances that lack a
//! solution is chosen, and among these the cheapest. Where none is acceptable: the one with the fewest instances that failed or lack a solution, and among these
//! the one with the smallest 99 % quantile.

use crate::search::Candidate;
use crate::stability::{Stability, stability};

/// Candidates that are measured in any case.
pub const MEASURED: usize = 8;
/// No more candidates are measured.
pub const MEASURED_AT_MOST: usize = 32;
/// One instance in so many may lack a solution.
pub const INCOMPLETE_ONE_IN: usize = 1000;
/// A 99 % quantile of the log10 relative residual that is good enough.
pub const GOOD_RESIDUAL: f64 = -12.0;

/// Candidates whose operations differ by no more than this factor cost the same for the choice.
pub const SIMILAR_COST: f64 = 1.1;

/// A candidate with what it does on random real instances.
#[derive(Clone, Debug)]
pub struct Measured {
    /// The candidate.
    pub candidate: Candidate,
    /// Its measurement.
    pub stability: Stability,
}

/// Candidates that were measured, cheapest first, and the one to use.
#[derive(Clone, Debug)]
pub struct Choice {
    /// At least one.
    pub measured: Vec<Measured>,
    /// Index into `measured`.
    pub chosen: usize,
}

/// Measures the cheapest different candidates on `trials` instances each and chooses one; `None` where there is no candidate.
/// `candidates` are in order of operations; `progress` hears of each measurement.
pub fn choose(candidates: &[Candidate], trials: usize, seed: u64, progress: &dyn Fn(&str)) -> Option<Choice> {
    let mut measured: Vec<Measured> = Vec::new();
    let different = different(candidates);
    for candidate in different.iter().take(MEASURED_AT_MOST) {
        if measured.len() >= MEASURED && measured.iter().any(|m| is_complete(&m.stability)) {
            break;
        }
        let t = &candidate.template;
        progress(&format!("measuring template {} ({} x {})", measured.len() + 1, t.rows(), t.columns()));
        let stability = stability(&candidate.plan, trials, seed, &|| ());
        measured.push(Measured { candidate: (*candidate).clone(), stability });
    }
    let figures: Vec<_> = measured.iter().map(|m| (m.candidate.plan.operations().total(), &m.stability)).collect();
    let chosen = pick(&figures)?;
    Some(Choice { measured, chosen })
}

/// The first candidate of each combination of presolved form, action monomial and basis.
fn different(candidates: &[Candidate]) -> Vec<&Candidate> {
    let mut seen = Vec::new();
    let mut different = Vec::new();
    for candidate in candidates {
        let mut basis = candidate.template.basis.clone();
        basis.sort_unstable();
        let key = (candidate.presolve, candidate.template.action, basis);
        if !seen.contains(&key) {
            seen.push(key);
            different.push(candidate);
        }
    }
    different
}

/// No failure, and hardly an instance that lacks a solution.
fn is_complete(stability: &Stability) -> bool {
    stability.failures == 0 && stability.incomplete * INCOMPLETE_ONE_IN <= stability.trials
}

/// The rule at the top of this module; the measurements, each with its operations, are in order of these.
fn pick(measured: &[(usize, &Stability)]) -> Option<usize> {
    let p99 = |at: usize| measured[at].1.quantile(0.99).unwrap_or(f64::INFINITY);
    let unsolved = |at: usize| measured[at].1.incomplete + measured[at].1.failures;
    let complete: Vec<usize> = (0..measured.len()).filter(|&at| is_complete(measured[at].1)).collect();
    let best = complete.iter().map(|&at| p99(at)).fold(f64::INFINITY, f64::min);
    let acceptable: Vec<usize> = complete.into_iter().filter(|&at| p99(at) <= GOOD_RESIDUAL.max(best + 1.0)).collect();
    match acceptable.first() {
        Some(&cheapest) => {
            let most = measured[cheapest].0 as f64 * SIMILAR_COST;
            let similar = acceptable.into_iter().filter(|&at| measured[at].0 as f64 <= most);
            similar.min_by_key(|&at| (unsolved(at), at))
        }
        None => (0..measured.len()).min_by(|&a, &b| unsolved(a).cmp(&unsolved(b)).then(p99(a).total_cmp(&p99(b)))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1000 trials whose residuals are all 10^`residual`.
    fn measured(residual: f64, incomplete: usize, failures: usize) -> Stability {
        Stability { residuals_log10: vec![residual; 100], trials: 1000, incomplete, failures, ..Stability::default() }
    }

    /// Each costs twice as much as the one before.
    fn pick_of(all: &[Stability]) -> Option<usize> {
        pick(&all.iter().enumerate().map(|(at, stability)| (100 << at, stability)).collect::<Vec<_>>())
    }

    #[test]
    fn the_cheapest_acceptable_candidate_wins() {
        assert_eq!(pick_of(&[measured(-13.0, 0, 0), measured(-16.0, 0, 0)]), Some(0));
        assert_eq!(pick_of(&[measured(-13.0, 2, 0), measured(-13.0, 1, 0)]), Some(1));
        assert_eq!(pick_of(&[measured(-15.0, 0, 1), measured(-13.0, 0, 0)]), Some(1));
        assert_eq!(pick_of(&[measured(-11.0, 0, 0), measured(-15.0, 0, 0)]), Some(1));
    }

    #[test]
    fn among_similar_costs_the_most_complete_wins() {
        let (a, b, c) = (measured(-15.0, 1, 0), measured(-13.0, 0, 0), measured(-16.0, 0, 0));
        assert_eq!(pick(&[(100, &a), (105, &b), (105, &c)]), Some(1));
        assert_eq!(pick(&[(100, &a), (111, &b)]), Some(0));
    }

    #[test]
    fn where_all_residuals_are_large_close_to_the_best_will_do() {
        assert_eq!(pick_of(&[measured(-8.0, 0, 0), measured(-9.5, 0, 0), measured(-10.0, 0, 0)]), Some(1));
    }

    #[test]
    fn without_an_acceptable_candidate_the_most_complete_wins_then_the_most_precise() {
        assert_eq!(pick_of(&[measured(-15.0, 300, 0), measured(-14.0, 100, 100), measured(-15.0, 0, 200)]), Some(2));
        assert_eq!(pick_of(&[]), None);
    }
}
