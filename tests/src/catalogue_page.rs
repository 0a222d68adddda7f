//! The page `templates/README.md`, read.

use std::collections::BTreeMap;
use std::path::PathBuf;

use crate::templates_folder;

/// The cells of a problem by the heads of their columns.
pub type Row = BTreeMap<String, String>;

/// Where the page lies.
pub fn path() -> PathBuf {
    templates_folder().join("README.md")
}

/// The cells of a problem in all tables of a page that have a linked row of it; `None` if no table
/// has one.
pub fn row(page: &str, problem: &str) -> Option<Row> {
    let link = format!("({problem}.rs)");
    let (mut heads, mut found) = (Vec::new(), None);
    for line in page.lines() {
        let Some(line) = line.trim().strip_prefix('|').and_then(|line| line.strip_suffix('|')) else {
            heads.clear();
            continue;
        };
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        if heads.is_empty() {
            heads = cells;
        } else if cells[0].ends_with(&link) {
            let named = heads.iter().zip(cells).map(|(&head, cell)| (head.to_owned(), cell.to_owned()));
            found.get_or_insert_with(Row::new).extend(named);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_of_all_tables_are_found_by_their_heads() {
        let page = "| problem | n |\n|---|---|\n| [`b`](b.rs) | 1 |\n| [`a`](a.rs) | 2 |\n\n\
                    | problem | p99 |\n|---|---|\n| [`a`](a.rs) | -15 |\n\n| problem | n |\n|---|---|\n| a | 3 |\n";
        let cells = row(page, "a").unwrap();
        assert_eq!((cells["n"].as_str(), cells["p99"].as_str(), cells.len()), ("2", "-15", 3));
        assert_eq!(row(page, "c"), None);
    }
}
