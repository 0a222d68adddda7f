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
//! The cheapest acceptable one is chosen. Where there is none: the one with the fewest instances that failed or lack a solution, and among
//! these the one with the smallest 99 % quantile.

use crate::search::Candidate;
use crate::stability::{Stability, stability};

/// Candidates that are measured in any case.
pub const MEASURED: usize = 8;
/// No more candidates are measured.
pub const MEASURED_AT_MOST: usize = 32;
/// One instance in so many may lack a solution.
pub const INCOMPLETE_ONE_IN: usize = 100;
/// A 99 % quantile of the log10 relative residual that is good enough.
pub const GOOD_RESIDUAL: f64 = -12.0;

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
    let stabilities: Vec<&Stability> = measured.iter().map(|m| &m.stability).collect();
    let chosen = pick(&stabilities)?;
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

/// The rule at the top of this module; the measurements are in order of operations.
fn pick(measured: &[&Stability]) -> Option<usize> {
    let p99 = |stability: &Stability| stability.quantile(0.99).unwrap_or(f64::INFINITY);
    let best = measured.iter().filter(|s| is_complete(s)).map(|s| p99(s)).fold(f64::INFINITY, f64::min);
    let acceptable = |stability: &&Stability| is_complete(stability) && p99(stability) <= GOOD_RESIDUAL.max(best + 1.0);
    measured.iter().position(acceptable).or_else(|| {
        let unsolved = |stability: &Stability| stability.incomplete + stability.failures;
        let worse = |&a: &usize, &b: &usize| {
            let (a, b) = (measured[a], measured[b]);
            unsolved(a).cmp(&unsolved(b)).then(p99(a).total_cmp(&p99(b)))
        };
        (0..measured.len()).min_by(worse)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1000 trials whose residuals are all 10^`residual`.
    fn measured(residual: f64, incomplete: usize, failures: usize) -> Stability {
        Stability { residuals_log10: vec![residual; 100], trials: 1000, incomplete, failures, ..Stability::default() }
    }

    fn pick_of(all: &[Stability]) -> Option<usize> {
        pick(&all.iter().collect::<Vec<_>>())
    }

    #[test]
    fn the_cheapest_acceptable_candidate_wins() {
        assert_eq!(pick_of(&[measured(-13.0, 0, 0), measured(-16.0, 0, 0)]), Some(0));
        assert_eq!(pick_of(&[measured(-13.0, 11, 0), measured(-13.0, 10, 0)]), Some(1));
        assert_eq!(pick_of(&[measured(-15.0, 0, 1), measured(-13.0, 0, 0)]), Some(1));
        assert_eq!(pick_of(&[measured(-11.0, 0, 0), measured(-15.0, 0, 0)]), Some(1));
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
