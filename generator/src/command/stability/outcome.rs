//! What a solver did on one instance, judged by the true solutions.

use eliminant::Complex;
use serde::Serialize;

use super::condition::Condition;
use super::instance::Instance;
use super::solve::Returned;
use crate::oracle::{Judged, Truths};
use crate::plan::Plan;

/// Solutions there are, and what was returned of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub(super) struct Count {
    /// Solutions that the oracle knows.
    pub(super) expected: usize,
    /// Of these, those that no returned point approximates.
    pub(super) missed: usize,
    /// Returned points that approximate no solution, or one that others are closer to.
    pub(super) spurious: usize,
}

/// The judgement of one instance.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub(super) struct Outcome {
    /// The time of `solve`.
    pub(super) nanoseconds: Option<f64>,
    /// The error of `solve` or of `solve_complex`.
    pub(super) error: Option<String>,
    /// Whether the oracle knows all solutions.
    pub(super) is_certain: bool,
    /// Of `solve`.
    pub(super) real: Count,
    /// Of `solve_complex`.
    pub(super) complex: Count,
    /// Solutions and results that the instance came with, and how many of them `solve` did not
    /// return to 1e-6.
    pub(super) known: usize,
    pub(super) known_missed: usize,
    /// The largest relative residual of a returned point.
    pub(super) residual: Option<f64>,
    /// The largest relative distance of a returned point from its solution.
    pub(super) forward_error: Option<f64>,
    /// The relative residuals of all complex solutions.
    #[serde(skip)]
    pub(super) residuals: Vec<f64>,
    pub(super) growth: Option<f64>,
    pub(super) separation: Option<f64>,
    /// Whether `solve` made a second attempt.
    pub(super) is_repeated: bool,
    /// Whether `solve_complex` did.
    pub(super) is_repeated_complex: bool,
}

impl Outcome {
    /// Judges what was returned.
    pub(super) fn of(plan: &Plan, instance: &Instance, returned: &Returned, condition: Condition) -> Self {
        let empty = Vec::new();
        let [real, complex] = [&returned.real, &returned.complex].map(|found| found.as_ref().unwrap_or(&empty));
        let error = [&returned.real, &returned.complex].into_iter().find_map(|found| found.as_ref().err().cloned());
        let mut outcome = Self {
            nanoseconds: returned.nanoseconds,
            error,
            known: instance.solutions.len() + instance.results.len(),
            known_missed: instance.missed(plan, real),
            growth: condition.growth,
            separation: condition.separation,
            is_repeated: condition.is_repeated,
            is_repeated_complex: condition.is_repeated_complex,
            ..Self::default()
        };
        let known = instance.solutions.iter().map(|known| known.iter().map(|&x| Complex::from(x)).collect());
        let near: Vec<Vec<Complex<f64>>> = complex.iter().chain(real).cloned().chain(known).collect();
        // Data that a coefficient divides by zero with have no solutions to judge by.
        let Some(truths) = Truths::of(plan, &instance.data, &near) else { return outcome };
        outcome.is_certain = truths.is_complete();
        let [of_real, of_complex] = [truths.judge(real, true), truths.judge(complex, false)];
        outcome.real = count(truths.real(), &of_real);
        outcome.complex = count(truths.complex(), &of_complex);
        let largest = |values: &mut dyn Iterator<Item = &f64>| values.copied().reduce(f64::max);
        outcome.residual = largest(&mut of_real.residuals.iter().chain(&of_complex.residuals));
        outcome.forward_error = largest(&mut of_real.errors.iter().chain(&of_complex.errors));
        outcome.residuals = of_complex.residuals;
        outcome
    }

    /// Whether the solver failed, lost a solution, or returned one that is none.
    pub(super) fn is_faulty(&self) -> bool {
        self.error.is_some() || self.missed() + self.known_missed + self.real.spurious + self.complex.spurious > 0
    }

    /// Solutions that were missed, by `solve` or by `solve_complex`.
    pub(super) fn missed(&self) -> usize {
        self.real.missed + self.complex.missed
    }

    /// How bad it is: larger is worse. Errors come before missed real, then missed complex
    /// solutions, then points that are no solution, then the forward error.
    pub(super) fn badness(&self) -> [f64; 5] {
        let known_missed = self.real.missed.max(self.known_missed);
        [
            f64::from(u8::from(self.error.is_some())),
            known_missed as f64,
            self.complex.missed as f64,
            (self.real.spurious + self.complex.spurious) as f64,
            self.forward_error.or(self.residual).unwrap_or(0.0),
        ]
    }

    /// The judgement in a few words.
    pub(super) fn words(&self) -> String {
        let mut words = Vec::new();
        words.extend(self.error.as_ref().map(|error| format!("error: {error}")));
        let mut say = |many: usize, what: &str| {
            if many > 0 {
                words.push(format!("{many} {what}"));
            }
        };
        say(self.real.missed, "real missed");
        say(self.complex.missed, "complex missed");
        say(self.known_missed, "known missed");
        say(self.real.spurious, "real spurious");
        say(self.complex.spurious, "complex spurious");
        words.extend(self.forward_error.map(|error| format!("error {error:.1e}")));
        words.extend(self.residual.map(|residual| format!("residual {residual:.1e}")));
        words.extend(self.growth.map(|growth| format!("growth {growth:.1e}")));
        words.extend(self.separation.map(|separation| format!("separation {separation:.1e}")));
        if self.is_repeated || self.is_repeated_complex {
            words.push("second attempt".to_owned());
        }
        if !self.is_certain {
            words.push("count uncertain".to_owned());
        }
        words.join(", ")
    }
}

fn count(expected: usize, judged: &Judged) -> Count {
    Count { expected, missed: expected - judged.found.min(expected), spurious: judged.spurious }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_worse_than_lost_solutions_and_these_than_large_errors() {
        let far = Outcome { forward_error: Some(1e-3), ..Outcome::default() };
        let lost = Outcome { complex: Count { missed: 1, ..Count::default() }, ..Outcome::default() };
        let lost_real = Outcome { real: Count { missed: 1, ..Count::default() }, ..Outcome::default() };
        let failed = Outcome { error: Some("degenerate".into()), ..Outcome::default() };
        let order = [&far, &lost, &lost_real, &failed].map(Outcome::badness);
        assert!(order.is_sorted(), "{order:?}");
        assert_eq!([&far, &lost, &failed].map(Outcome::is_faulty), [false, true, true]);
        assert_eq!(lost_real.words(), "1 real missed, count uncertain");
    }
}
