//! Bounds that all problems keep, but for stated exceptions.

/// A bound on a measured value, such as a share of instances.
pub struct Bounds {
    /// What is bounded, for messages.
    pub what: &'static str,
    /// The bound for every problem without an exception.
    pub usual: f64,
    /// The problems that need another bound.
    pub exceptions: &'static [Exception],
}

/// A problem that needs another bound than the usual one.
pub struct Exception {
    /// The name of the problem.
    pub problem: &'static str,
    /// The bound for this problem.
    pub bound: f64,
    /// The value measured when the exception was made, and why it is above the usual bound.
    pub reason: &'static str,
}

/// An exception is out of date if the measured value keeps the usual bound by this factor.
const CLEARLY: f64 = 20.0;

impl Bounds {
    /// Adds a fault if the value measured for the problem is above its bound, or if the problem no
    /// longer needs its exception. A value that is not a number is above every bound.
    pub fn check(&self, problem: &str, measured: f64, faults: &mut Vec<String>) {
        let exception = self.exceptions.iter().find(|exception| exception.problem == problem);
        let bound = exception.map_or(self.usual, |exception| exception.bound);
        let holds = measured <= bound;
        if !holds {
            let reason =
                exception.map_or(String::new(), |exception| format!(", with an exception: {}", exception.reason));
            faults.push(format!("{problem}: {}: {measured:.3e}, allowed is {bound:.1e}{reason}", self.what));
        } else if exception.is_some() && measured * CLEARLY < self.usual {
            faults.push(format!("{problem}: {}: {measured:.3e} needs no exception; remove it", self.what));
        }
    }

    /// Adds a fault for each exception that names none of the problems.
    pub fn check_names(&self, problems: &[&str], faults: &mut Vec<String>) {
        let unknown = self.exceptions.iter().filter(|exception| !problems.contains(&exception.problem));
        faults.extend(unknown.map(|exception| format!("no problem `{}`: {}", exception.problem, self.what)));
    }
}

/// The share of cases that are against a claim. One case is taken for chance: of a few hundred it
/// says nothing about a share of 1 in 1000.
pub fn share(against: usize, of: usize) -> f64 {
    against.saturating_sub(1) as f64 / of as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOUNDS: Bounds = Bounds {
        what: "lost",
        usual: 1e-3,
        exceptions: &[Exception { problem: "hard", bound: 1e-2, reason: "5e-3, because it is hard" }],
    };

    fn faults(problem: &str, measured: f64) -> Vec<String> {
        let mut faults = Vec::new();
        BOUNDS.check(problem, measured, &mut faults);
        faults
    }

    #[test]
    fn bounds_are_checked_and_exceptions_must_be_needed() {
        for (problem, measured) in [("easy", 0.0), ("easy", 1e-3), ("hard", 5e-3), ("hard", 1e-3)] {
            assert!(faults(problem, measured).is_empty(), "{problem} {measured}");
        }
        for (problem, measured, word) in [
            ("easy", 2e-3, "allowed is 1.0e-3"),
            ("easy", f64::NAN, "NaN"),
            ("hard", 2e-2, "because it is hard"),
            ("hard", 0.0, "needs no exception"),
        ] {
            let faults = faults(problem, measured);
            assert!(faults.len() == 1 && faults[0].contains(word), "{problem} {measured}: {faults:?}");
        }
        let mut faults = Vec::new();
        BOUNDS.check_names(&["easy", "hard"], &mut faults);
        assert!(faults.is_empty());
        BOUNDS.check_names(&["easy"], &mut faults);
        assert_eq!(faults.len(), 1);
    }

    #[test]
    fn one_case_is_chance() {
        assert_eq!((share(0, 200), share(1, 200), share(3, 200)), (0.0, 0.0, 0.01));
        assert!(share(1, 0).is_nan());
    }
}
