//! The accepted figures of problems, and which of them got worse beyond the error of sampling.
//!
//! Instances are a sample. A share of k of n instances lies, with a confidence of 99.9 %, between
//! the bounds of Wilson's interval; a quantile of a distribution between two values of the sample,
//! whose ranks follow from the binomial distribution. A figure got worse if its whole interval lies
//! above that of the baseline. If nothing changed this happens for at most one figure in 2,000, and
//! for one in 100,000 if one sample has at most four times the size of the other.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::figures::{forward_errors, is_incomplete, is_wrong, residuals};
use super::outcome::Outcome;
use crate::command::error::CommandError;
use crate::command::files::{read_text, write};

/// The half-width of the intervals in standard deviations of a normal distribution: 99.9 %.
const DEVIATIONS: f64 = 3.29;
/// Values that are rounded may move by this.
const ROUNDING: f64 = 0.1;

/// The file.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Baseline {
    #[serde(default)]
    figures: Vec<Accepted>,
}

/// The figures of one problem and family, over all levels.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Accepted {
    problem: String,
    family: String,
    instances: usize,
    /// Instances that lack a solution, or on which a solver failed.
    incomplete: usize,
    /// Instances on which a point was returned that is no solution.
    wrong: usize,
    /// Bounds of the median and of the 90 % quantile of log10 of the largest residual of an
    /// instance, and of the largest forward error. Few instances bound a quantile on one side, or
    /// on none.
    residual_median: Bounds,
    residual_p90: Bounds,
    error_median: Bounds,
    error_p90: Bounds,
}

/// The interval of a quantile.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Bounds {
    #[serde(default, skip_serializing_if = "Option::is_none")]
    low: Option<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    high: Option<f64>,
}

/// A figure that got worse.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub(super) struct Worse {
    pub(super) problem: String,
    pub(super) family: String,
    /// Which figure, and both of its values.
    pub(super) figure: String,
}

const HEAD: &str = "# What the solvers of this folder do on random instances, accepted as good. Written by
#   eliminant stability FILES --update-baseline
# and compared by `--check`. A quantile of log10 lies between its bounds with 99.9 % confidence.
";

/// Wilson's interval of a share of `count` of `all`.
fn share(count: usize, all: usize) -> (f64, f64) {
    let (n, z) = (all.max(1) as f64, DEVIATIONS);
    let p = count as f64 / n;
    let centre = p + z * z / (2.0 * n);
    let half = z * (p * (1.0 - p) / n + z * z / (4.0 * n * n)).sqrt();
    let scale = 1.0 + z * z / n;
    ((centre - half) / scale, (centre + half) / scale)
}

impl Bounds {
    /// Of the q-quantile: the values, in increasing order, of the ranks n q -+ z sqrt(n q (1 - q)).
    fn of(values: &[f64], q: f64) -> Self {
        let n = values.len() as f64;
        let half = DEVIATIONS * (n * q * (1.0 - q)).sqrt();
        let (low, high) = ((n * q - half).floor(), (n * q + half).ceil());
        Self {
            low: (low >= 1.0).then(|| values[low as usize - 1]),
            high: (high <= n && n > 0.0).then(|| values[high as usize - 1]),
        }
    }
}

impl Accepted {
    /// Of the instances of one problem and family.
    pub(super) fn of(problem: &str, family: &str, outcomes: &[&Outcome]) -> Self {
        let count = |is: fn(&Outcome) -> bool| outcomes.iter().filter(|outcome| is(outcome)).count();
        let (residuals, errors) = (residuals(outcomes), forward_errors(outcomes));
        Self {
            problem: problem.to_owned(),
            family: family.to_owned(),
            instances: outcomes.len(),
            incomplete: count(is_incomplete),
            wrong: count(is_wrong),
            residual_median: Bounds::of(&residuals, 0.5),
            residual_p90: Bounds::of(&residuals, 0.9),
            error_median: Bounds::of(&errors, 0.5),
            error_p90: Bounds::of(&errors, 0.9),
        }
    }

    /// Which figures are worse than the accepted ones.
    fn worse_than(&self, accepted: &Self) -> Vec<String> {
        let mut worse = Vec::new();
        for (name, now, before) in [
            ("instances that lack a solution", self.incomplete, accepted.incomplete),
            ("instances with a point that is no solution", self.wrong, accepted.wrong),
        ] {
            if share(now, self.instances).0 > share(before, accepted.instances).1 {
                worse.push(format!(
                    "{name}: {now} of {}, accepted are {before} of {}",
                    self.instances, accepted.instances
                ));
            }
        }
        for (name, now, before) in [
            ("median residual", self.residual_median, accepted.residual_median),
            ("90 % quantile of the residual", self.residual_p90, accepted.residual_p90),
            ("median forward error", self.error_median, accepted.error_median),
            ("90 % quantile of the forward error", self.error_p90, accepted.error_p90),
        ] {
            if let (Some(low), Some(high)) = (now.low, before.high)
                && low > high + ROUNDING
            {
                worse.push(format!("{name}: at least 1e{low:.2}, accepted is at most 1e{high:.2}"));
            }
        }
        worse
    }
}

impl Baseline {
    /// Reads a baseline.
    pub(super) fn read(path: &Path) -> Result<Self, CommandError> {
        let text = read_text(path)?;
        toml::from_str(&text)
            .map_err(|error| CommandError::Baseline { path: path.to_owned(), reason: error.to_string() })
    }

    /// Writes it with these figures in place of those of the same problems and families.
    pub(super) fn update(mut self, path: &Path, now: &[Accepted]) -> Result<(), CommandError> {
        let is_same = |a: &Accepted, b: &Accepted| (&a.problem, &a.family) == (&b.problem, &b.family);
        self.figures.retain(|old| !now.iter().any(|new| is_same(old, new)));
        self.figures.extend_from_slice(now);
        self.figures.sort_by(|a, b| (&a.problem, &a.family).cmp(&(&b.problem, &b.family)));
        let text = toml::to_string(&self)
            .map_err(|error| CommandError::Baseline { path: path.to_owned(), reason: error.to_string() })?;
        write(path, &format!("{HEAD}\n{text}"))
    }

    /// The figures that got worse, and how many problems and families were compared.
    ///
    /// # Errors
    /// A problem is not in the baseline.
    pub(super) fn compare(&self, path: &Path, now: &[Accepted]) -> Result<(Vec<Worse>, usize), CommandError> {
        let (mut worse, mut compared) = (Vec::new(), 0);
        for new in now {
            let Some(old) = self.figures.iter().find(|old| (&old.problem, &old.family) == (&new.problem, &new.family))
            else {
                let reason = format!("it has no figures of `{}`, family {}", new.problem, new.family);
                return Err(CommandError::Baseline { path: path.to_owned(), reason });
            };
            compared += 1;
            let named = |figure| Worse { problem: new.problem.clone(), family: new.family.clone(), figure };
            worse.extend(new.worse_than(old).into_iter().map(named));
        }
        Ok((worse, compared))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::Random;
    use crate::command::stability::outcome::Count;

    /// Outcomes with residuals around 10^`level`, of which a share lacks a solution.
    fn outcomes(seed: u64, count: usize, level: f64, lost: f64) -> Vec<Outcome> {
        let mut random = Random::new(seed);
        let mut draw = || {
            let residual = Some(10f64.powf(level + 2.0 * random.symmetric_unit()));
            let missed = usize::from(0.5 + 0.5 * random.symmetric_unit() < lost);
            Outcome { residual, complex: Count { expected: 4, missed, spurious: 0 }, ..Outcome::default() }
        };
        (0..count).map(|_| draw()).collect()
    }

    fn accepted(seed: u64, count: usize, level: f64, lost: f64) -> Accepted {
        let outcomes = outcomes(seed, count, level, lost);
        Accepted::of("p", "random", &outcomes.iter().collect::<Vec<_>>())
    }

    #[test]
    fn other_samples_of_the_same_are_not_worse() {
        let baseline = accepted(1, 1000, -15.0, 0.01);
        for seed in 2..200 {
            for count in [20, 100, 1000] {
                let worse = accepted(seed, count, -15.0, 0.01).worse_than(&baseline);
                assert!(worse.is_empty(), "{seed}, {count}: {worse:?}");
            }
        }
    }

    #[test]
    fn what_is_worse_is_named() {
        let baseline = accepted(1, 1000, -15.0, 0.01);
        let worse = accepted(2, 100, -14.0, 0.01).worse_than(&baseline);
        assert!(worse.iter().any(|figure| figure.starts_with("median residual")), "{worse:?}");
        let worse = accepted(2, 200, -15.0, 0.2).worse_than(&baseline);
        assert!(worse.len() == 1 && worse[0].contains("lack a solution"), "{worse:?}");
        assert_eq!(accepted(3, 200, -17.0, 0.0).worse_than(&baseline), Vec::<String>::new());
    }

    #[test]
    fn intervals_are_those_of_tables() {
        // Wilson's interval of 10 of 100 at 95 % is 0.055 .. 0.174; at 99.9 % it is wider.
        let (low, high) = share(10, 100);
        assert!(low < 0.055 && low > 0.03 && high > 0.174 && high < 0.26, "{low} {high}");
        assert_eq!(share(0, 1000).0, 0.0);
        let values: Vec<f64> = (1..=100).map(f64::from).collect();
        // 50 -+ 3.29 * 5.
        assert_eq!(Bounds::of(&values, 0.5), Bounds { low: Some(33.0), high: Some(67.0) });
        assert_eq!(Bounds::of(&values[..5], 0.9), Bounds { low: Some(2.0), high: None });
        assert_eq!(Bounds::of(&[], 0.5), Bounds::default());
    }

    #[test]
    fn files_say_what_they_hold() {
        let baseline = Baseline { figures: vec![accepted(1, 20, -15.0, 0.0)] };
        let text = toml::to_string(&baseline).unwrap();
        assert_eq!(toml::from_str::<Baseline>(&text).unwrap(), baseline);
        let missing =
            baseline.compare(Path::new("b.toml"), &[Accepted { problem: "q".into(), ..accepted(1, 20, -15.0, 0.0) }]);
        assert!(missing.unwrap_err().to_string().contains("no figures of `q`"));
    }
}
