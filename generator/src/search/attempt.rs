//! What a search tried where it found nothing, and how far it came.

use std::fmt;

use super::solving_set::Obstacle;

/// A way to grow sets of shifts of which none solves.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "command", derive(serde::Serialize, serde::Deserialize))]
pub struct Attempt {
    /// The way to grow, in words.
    pub way: String,
    /// Number of sets of shifts.
    pub sets: usize,
    /// Rows of the largest.
    pub rows: usize,
    /// Columns of the largest.
    pub columns: usize,
    /// What the largest lacks, in words.
    pub obstacle: String,
    /// How far that is from a template: (kind of obstacle, distance), smaller is closer.
    pub distance: (usize, usize),
}

impl Attempt {
    /// `unknowns` are the names of the problem; `largest` is (columns, rows).
    pub(crate) fn new(
        way: String,
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
        Self { way, sets, rows, columns, obstacle, distance }
    }
}

fn describe(obstacle: &Obstacle, unknowns: &[String]) -> String {
    match *obstacle {
        Obstacle::NothingExpressed => "no set of monomials is closed under any action monomial".to_owned(),
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
        Obstacle::Unreadable { unknown, basis } => {
            let name = unknowns.get(unknown).map_or("?", String::as_str);
            format!(
                "{basis} monomials are closed under an action monomial, but the unknown `{name}` cannot be read from them"
            )
        }
    }
}

/// Ways that are listed; the others are counted.
const LISTED: usize = 8;

/// The ways to grow, closest to a template first, as lines of a message.
pub(crate) struct Attempts<'a>(pub(crate) &'a [Attempt]);

impl fmt::Display for Attempts<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sets: usize = self.0.iter().map(|attempt| attempt.sets).sum();
        let largest = self.0.iter().map(|attempt| (attempt.columns, attempt.rows)).max().unwrap_or_default();
        write!(f, "tried {sets} sets of shifts, the largest {} x {}", largest.1, largest.0)?;
        let mut attempts: Vec<&Attempt> = self.0.iter().collect();
        attempts.sort_by_key(|attempt| attempt.distance);
        for Attempt { way, rows, columns, obstacle, .. } in attempts.iter().take(LISTED) {
            write!(f, "\n  {way}, up to {rows} x {columns}: {obstacle}")?;
        }
        match attempts.len().saturating_sub(LISTED) {
            0 => Ok(()),
            more => write!(f, "\n  and {more} ways that came no closer"),
        }
    }
}
