//! The part of the page `speed.md` that follows from its table of instructions and from that of the
//! README beside peers: how far the aims are.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use crate::replaced;

/// What stands before and after the part in the page.
const MARKS: [&str; 2] = ["<!-- reach:begin -->\n", "<!-- reach:end -->\n"];

/// The ratios to the peers that this project aims at.
const AIMS: [(&str, f64); 11] = [
    ("circle, least squares, 20 lines", 20.0),
    ("circle, minimal, 3 lines", 10.0),
    ("circle, closed form, through its trait", 50.0),
    ("five-point, points to E", 2.0),
    ("six-point shared focal, points to poses", 3.0),
    ("3.5-point focal, points to poses", 3.0),
    ("shared radial distortion, points to F", 3.0),
    ("generalised six-point, rays to poses", 3.0),
    ("generalised pose and scale, points to poses", 1.0),
    ("three quadrics (re3q3)", 1.5),
    ("P3P, points to poses", 1.0),
];

/// The page with its part written anew, from the text of the README.
///
/// # Errors
/// A message, where a table or a row of one is missing.
pub fn reach(readme: &str, page: &str) -> Result<String, String> {
    let (ratios, stages) = (column(readme, "ratio"), [column(page, "ours"), column(page, "operations")]);
    let mut table = "| case | aim | reached | at most | instructions, aim | today |\n\
                     |---|--:|--:|--:|--:|--:|\n"
        .to_owned();
    for (case, aim) in AIMS {
        let ratio = ratios.get(case).ok_or_else(|| format!("README.md: no ratio of {case}"))?;
        let [instructions, operations] =
            stages.each_ref().map(|column| column.get(case).ok_or_else(|| format!("speed.md: no row of {case}")));
        let today = instructions? / operations?;
        let wanted = today * ratio / aim;
        // No operation takes less than one instruction.
        let wanted = if wanted < 1.0 { "–".to_owned() } else { format!("{wanted:.1}") };
        let _ = writeln!(table, "| {case} | {aim} | {ratio:.2} | {:.1} | {wanted} | {today:.1} |", ratio * today);
    }
    replaced(page, MARKS, &table).ok_or_else(|| "speed.md: the part does not begin or does not end".to_owned())
}

/// The numbers of a column, by case: of the first table with the columns `case` and this one, and
/// of the first one of this name.
fn column(text: &str, name: &str) -> BTreeMap<String, f64> {
    let cells =
        |line: &str| -> Vec<String> { line.trim_matches('|').split('|').map(|c| c.trim().to_owned()).collect() };
    let mut lines = text.lines();
    let is_header = |line: &&str| line.starts_with("| case ") && cells(line).iter().any(|cell| cell == name);
    let Some(at) = lines.find(is_header).and_then(|line| cells(line).iter().position(|cell| cell == name)) else {
        return BTreeMap::new();
    };
    lines
        .take_while(|line| line.starts_with('|'))
        .filter_map(|line| {
            let row = cells(line);
            Some((row[0].clone(), row.get(at)?.parse().ok()?))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_those_of_the_first_table_that_has_them() {
        let text = "| case | x |\n|--|--|\n| a | 1 |\n\n| case  | ours, ns | ours | operations | operations |\n|--|--|--|--|--|\n\
                    | a | 9 | 20 | 10 | 7 |\n\n| a | 3 | 3 | 3 | 3 |\n";
        let expected = |value| BTreeMap::from([("a".to_owned(), value)]);
        assert_eq!([column(text, "ours"), column(text, "operations")], [expected(20.0), expected(10.0)]);
        assert!(column(text, "ratio").is_empty());
    }
}
