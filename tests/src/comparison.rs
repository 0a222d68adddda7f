//! Rows of our templates against those of the smallest published ones.

use std::cmp::Ordering;

use crate::Case;
use crate::published::{Published, fewest_rows, published, published_name};

/// What holds of the problems that have a published template, as two bullets of Markdown: one on the committed templates,
/// which are the fastest, and one on those with the fewest rows. The problems with more rows are listed below each.
///
/// # Errors
/// If a committed table is malformed.
pub fn comparison(cases: &[Case]) -> Result<String, csv::Error> {
    let published = published()?;
    let (mut committed, mut fewest) = (Tally::default(), Tally::default());
    for case in cases {
        let theirs = published.iter().find(|p| Some(&p.name) == published_name(case).as_ref()).and_then(smallest);
        let Some(theirs) = theirs else { continue };
        let rows = case.template().template.rows();
        let found = fewest_rows(case.name)?.and_then(|size| rows_of(&size));
        committed.count(case.name, rows, theirs);
        fewest.count(case.name, found.map_or(rows, |found| found.min(rows)), theirs);
    }
    Ok(format!("{}{}", committed.bullet("The committed template"), fewest.bullet("The template with the fewest rows")))
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

#[derive(Default)]
struct Tally {
    fewer: usize,
    same: usize,
    /// Each with both numbers of rows.
    more: Vec<String>,
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
        let all = self.fewer + self.same + self.more.len();
        let (fewer, same, more) = (self.fewer, self.same, self.more.len());
        let colon = if more == 0 { "." } else { ":" };
        let mut text = format!(
            "- {which} has fewer rows than the smallest published one for {fewer} of {all} problems,\n  \
             as many for {same} and more for {more}{colon}\n"
        );
        self.more.iter().for_each(|line| text += &format!("  - {line}\n"));
        text
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
        let text = tally.bullet("Ours");
        assert!(
            text.contains("for 1 of 3 problems,\n  as many for 1 and more for 1:\n  - `c`: 3 rows, published 2\n"),
            "{text}"
        );
    }
}
