//! What a search tried if it found nothing, and how far it came.

use std::fmt;

use super::solving_set::Obstacle;

/// Most rows of a traced set that is reduced: its elimination takes minutes.
pub(crate) const MOST_TRACED_ROWS: usize = 50_000;

/// A strategy none of whose sets of shifts solves.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "command", derive(serde::Serialize, serde::Deserialize))]
pub struct FailedStrategy {
    /// The strategy in words.
    pub strategy: String,
    /// Number of sets of shifts.
    pub sets: usize,
    /// Rows of the largest set.
    pub rows: usize,
    /// Columns of the largest set.
    pub columns: usize,
    /// What the largest set lacks, in words.
    pub obstacle: String,
    /// Distance from a template: (kind of obstacle, how much is missing). Smaller is closer.
    pub distance: (usize, usize),
}

impl FailedStrategy {
    /// `unknowns` are the names of the problem; `largest` is (columns, rows).
    pub(crate) fn new(
        strategy: String,
        sets: usize,
        largest: (usize, usize),
        obstacle: Option<&Obstacle>,
        unknowns: &[String],
    ) -> Self {
        let (columns, rows) = largest;
        let (obstacle, distance) = match obstacle {
            Some(obstacle) => (describe(obstacle, unknowns), obstacle.distance()),
            None if sets == 0 => ("the equations alone have more columns".to_owned(), (usize::MAX, 0)),
            None => ("no template that was found holds for other data".to_owned(), (0, 0)),
        };
        Self { strategy, sets, rows, columns, obstacle, distance }
    }
}

impl FailedStrategy {
    /// A strategy by the trace of a Gröbner basis that needs too many rows.
    pub(crate) fn too_large(strategy: String, sets: usize, (columns, rows): (usize, usize)) -> Self {
        let obstacle = format!(
            "the trace of the Gröbner basis has more rows than are reduced ({MOST_TRACED_ROWS}), or is too long to be looked at"
        );
        Self { strategy, sets, rows, columns, obstacle, distance: (usize::MAX, 0) }
    }
}

fn describe(obstacle: &Obstacle, unknowns: &[String]) -> String {
    match *obstacle {
        Obstacle::NoClosedSet => "no set of monomials is closed under any action monomial".to_owned(),
        Obstacle::TooFew { basis, solutions } => {
            format!(
                "the largest set of monomials that is closed under an action monomial has {basis}; there are {solutions} solutions"
            )
        }
        Obstacle::TooMany { basis, limit } => {
            format!(
                "the smallest set of monomials that is closed under an action monomial has {basis}, more than the {limit} allowed"
            )
        }
        Obstacle::Vanishing { basis } => {
            format!(
                "the set of {basis} monomials that is closed under an action monomial vanishes at a solution where unknowns are 0"
            )
        }
        Obstacle::Unreadable { unknown, basis } => {
            let name = unknowns.get(unknown).map_or("?", String::as_str);
            format!(
                "{basis} monomials are closed under an action monomial, but the unknown `{name}` cannot be read from them"
            )
        }
    }
}

/// Number of strategies that are listed; the others are counted.
const LISTED: usize = 8;

/// Failed strategies as lines of a message, the closest to a template first.
pub(crate) struct FailedStrategies<'a>(pub(crate) &'a [FailedStrategy]);

impl fmt::Display for FailedStrategies<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sets: usize = self.0.iter().map(|failed| failed.sets).sum();
        let largest = self.0.iter().map(|failed| (failed.columns, failed.rows)).max().unwrap_or_default();
        match sets {
            0 if self.0.is_empty() => write!(f, "no strategy came to its end")?,
            0 => write!(f, "no set of shifts was small enough to try")?,
            _ => write!(f, "tried {sets} sets of shifts, the largest {} x {}", largest.1, largest.0)?,
        }
        let mut closest: Vec<&FailedStrategy> = self.0.iter().collect();
        closest.sort_by_key(|failed| failed.distance);
        // What fails for one reason, at one size, is said once.
        let mut reasons: Vec<(&FailedStrategy, usize)> = Vec::new();
        for failed in closest {
            let is_alike = |first: &FailedStrategy| {
                (first.rows, first.columns, &first.obstacle) == (failed.rows, failed.columns, &failed.obstacle)
            };
            match reasons.iter_mut().find(|(first, _)| is_alike(first)) {
                Some((_, others)) => *others += 1,
                None => reasons.push((failed, 0)),
            }
        }
        for (FailedStrategy { strategy, rows, columns, obstacle, .. }, others) in reasons.iter().take(LISTED) {
            let size = if *rows > 0 { format!(", up to {rows} x {columns}") } else { String::new() };
            let others = match others {
                0 => String::new(),
                1 => ", and one more".to_owned(),
                _ => format!(", and {others} more"),
            };
            write!(f, "\n  {strategy}{size}{others}: {obstacle}")?;
        }
        match reasons.iter().skip(LISTED).map(|(_, others)| 1 + others).sum::<usize>() {
            0 => Ok(()),
            more => write!(f, "\n  and {more} strategies that came no closer"),
        }
    }
}
