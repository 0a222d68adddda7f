//! Rows of our templates against those of the smallest published ones.

use std::cmp::Ordering;

use crate::Case;
use crate::published::{Published, fewest_rows, published, published_name};

/// How many rows templates have, of the problems for which one is published.
#[derive(Default)]
pub struct Comparison {
    /// The committed templates, which are taken for speed.
    pub committed: Tally,
    /// The templates with the fewest rows.
    pub fewest: Tally,
}

impl Comparison {
    /// Compares the templates of all cases.
    ///
    /// # Errors
    /// If a committed table is malformed.
    pub fn new(cases: &[Case]) -> Result<Self, csv::Error> {
        let published = published()?;
        let mut comparison = Self::default();
        for case in cases {
            let theirs = published.iter().find(|p| Some(&p.name) == published_name(case).as_ref()).and_then(smallest);
            let Some(theirs) = theirs else { continue };
            let rows = case.template().template.rows();
            let found = fewest_rows(case.name)?.and_then(|size| rows_of(&size));
            comparison.committed.count(case.name, rows, theirs);
            comparison.fewest.count(case.name, found.map_or(rows, |found| found.min(rows)), theirs);
        }
        Ok(comparison)
    }

    /// Two bullets of Markdown, and below each a list of the problems with more rows.
    pub fn listed(&self) -> String {
        let part = |bullet: String, tally: &Tally| format!("{bullet}{}", tally.list());
        let [committed, fewest] = self.bullets();
        part(committed, &self.committed) + &part(fewest, &self.fewest)
    }

    /// Two bullets of Markdown.
    pub fn bullets(&self) -> [String; 2] {
        [
            self.committed.bullet("The committed template, taken for speed,"),
            self.fewest.bullet("The template with the fewest rows"),
        ]
    }
}

/// The rows of the smallest published template.
fn smallest(published: &Published) -> Option<usize> {
    let sizes = [&published.larsson_2017, &published.greedy_2022, &published.smallest_2023, &published.shipped_2023];
    sizes.into_iter().filter_map(|size| rows_of(size)).min()
}

/// The rows of `10x20` or `12x36 (4pra)`.
fn rows_of(size: &str) -> Option<usize> {
    size.split_once('x')?.0.parse().ok()
}

/// For how many problems our template has fewer or as many rows as the smallest published one.
#[derive(Default)]
pub struct Tally {
    /// Problems with fewer rows.
    pub fewer: usize,
    /// Problems with as many rows.
    pub same: usize,
    /// Problems with more rows, each with both numbers.
    pub more: Vec<String>,
}

impl Tally {
    fn count(&mut self, name: &str, ours: usize, theirs: usize) {
        match ours.cmp(&theirs) {
            Ordering::Less => self.fewer += 1,
            Ordering::Equal => self.same += 1,
            Ordering::Greater => self.more.push(format!("`{name}`: {ours} rows, published {theirs}")),
        }
    }

    fn bullet(&self, which: &str) -> String {
        let (fewer, same, more) = (self.fewer, self.same, self.more.len());
        format!(
            "- {which} has fewer rows than the smallest published one\n  \
             for {fewer} of {} problems, as many for {same} and more for {more}.\n",
            fewer + same + more
        )
    }

    fn list(&self) -> String {
        self.more.iter().map(|line| format!("  - {line}\n")).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn problems_with_more_rows_are_named() {
        let mut tally = Tally::default();
        assert_eq!(rows_of("12x36 (4pra)"), Some(12));
        assert_eq!((rows_of(""), rows_of("none")), (None, None));
        [("a", 1, 2), ("b", 2, 2), ("c", 3, 2)]
            .into_iter()
            .for_each(|(name, ours, theirs)| tally.count(name, ours, theirs));
        assert!(tally.bullet("Ours").ends_with("for 1 of 3 problems, as many for 1 and more for 1.\n"));
        assert_eq!(tally.list(), "  - `c`: 3 rows, published 2\n");
    }
}
