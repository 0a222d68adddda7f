//! The tables of `templates/README.md`, which hold what was measured and published.

use std::collections::BTreeMap;

/// The cells of all tables whose first column is `problem`: for each problem, by column.
pub(crate) struct Measured {
    cells: BTreeMap<String, BTreeMap<String, String>>,
}

/// The columns of published templates.
pub(crate) const PUBLISHED: [&str; 3] = ["Larsson 2017", "greedy 2022", "redundant 2023"];

impl Measured {
    /// Of a text in Markdown.
    pub(crate) fn of(text: &str) -> Self {
        let mut cells: BTreeMap<String, BTreeMap<String, String>> = BTreeMap::new();
        let mut columns: Vec<String> = Vec::new();
        for line in text.lines() {
            let row: Vec<String> =
                line.trim().trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect();
            if !line.starts_with('|') {
                columns.clear();
            } else if columns.is_empty() {
                columns = row;
            } else if columns[0] == "problem"
                && let Some(problem) = row[0].split('`').nth(1)
            {
                let named = columns.iter().cloned().zip(row.iter().cloned()).skip(1);
                cells.entry(problem.to_owned()).or_default().extend(named);
            }
        }
        Self { cells }
    }

    /// A cell that is not empty.
    pub(crate) fn cell(&self, problem: &str, column: &str) -> Option<&str> {
        self.cells.get(problem)?.get(column).map(String::as_str).filter(|cell| !cell.is_empty())
    }

    /// The published template with the fewest rows, of this form of the problem or of another one,
    /// which is named in brackets: `148x211 (toa3d_46)`.
    pub(crate) fn smallest_published(&self, problem: &str) -> Option<&str> {
        let cells = PUBLISHED.iter().filter_map(|column| self.cell(problem, column));
        cells.filter(|cell| rows(cell).is_some()).min_by_key(|cell| rows(cell))
    }

    /// All problems, by name.
    pub(crate) fn problems(&self) -> impl Iterator<Item = &str> {
        self.cells.keys().map(String::as_str)
    }
}

/// The rows of a template, `148x211` or `148x211 (toa3d_46)`.
pub(crate) fn rows(size: &str) -> Option<usize> {
    size.split('x').next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_found_by_problem_and_column() {
        let text = "
| problem | n | Larsson 2017 | greedy 2022 |
|---------|---|--------------|-------------|
| [`a`](a.rs) | 3 | 10x20 | 9x30 (b) |
| [`b`](b.rs) | 4 | | |

| problem | median |
|--|--|
| [`a`](a.rs) | -15.1 |
";
        let measured = Measured::of(text);
        assert_eq!([measured.cell("a", "n"), measured.cell("a", "median")], [Some("3"), Some("-15.1")]);
        assert_eq!([measured.smallest_published("a"), measured.smallest_published("b")], [Some("9x30 (b)"), None]);
        assert_eq!([measured.cell("b", "median"), measured.cell("c", "n")], [None, None]);
    }
}
