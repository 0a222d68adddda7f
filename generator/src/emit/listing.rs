//! Long tables, printed beside the syntax tree: to parse and format their numbers as expressions takes longer than all else, above all in build scripts,
//! which are compiled without optimisation.

use proc_macro2::Ident;
use quote::format_ident;

/// Lines are broken before this column, where the elements allow it.
const WIDTH: usize = 120;

/// The elements of arrays, in the order of their names.
#[derive(Default)]
pub(super) struct Listings(Vec<Vec<String>>);

impl Listings {
    /// A name that stands for these elements until all else is formatted.
    pub(super) fn add(&mut self, elements: impl Iterator<Item = String>) -> Ident {
        self.0.push(elements.collect());
        format_ident!("{PREFIX}{}_", self.0.len() - 1)
    }

    /// The formatted source, with the elements in place of their names.
    pub(super) fn insert_into(&self, source: &str) -> String {
        let mut text = String::with_capacity(2 * source.len());
        for line in source.lines() {
            self.insert_into_line(line, &mut text);
            text.push('\n');
        }
        text
    }

    fn insert_into_line(&self, line: &str, text: &mut String) {
        let indent = line.len() - line.trim_start().len();
        let mut rest = line;
        while let Some((before, elements, after)) = self.split(rest).filter(|_| !line[indent..].starts_with("//")) {
            text.push_str(before);
            let is_alone = before.trim().is_empty();
            let length: usize = elements.iter().map(|element| element.len() + 2).sum();
            if is_alone || indent + before.len() + length + after.len() <= WIDTH {
                wrap(elements, indent, text);
            } else {
                let inner = indent + 4;
                text.push_str(&format!("\n{:inner$}", ""));
                wrap(elements, inner, text);
                text.push_str(&format!(",\n{:indent$}", ""));
            }
            rest = after;
        }
        text.push_str(rest);
    }

    /// What stands before the first name, its elements, and what stands behind it.
    fn split<'a>(&self, line: &'a str) -> Option<(&'a str, &[String], &'a str)> {
        let (before, rest) = line.split_once(PREFIX)?;
        let (number, after) = rest.split_once('_')?;
        Some((before, self.0.get(number.parse::<usize>().ok()?)?, after))
    }
}

/// How names of listings begin: those of problems have no capitals.
const PREFIX: &str = "LISTING_";

/// Writes the elements, separated by commas, on lines with this indentation. An element that is too long for a line is itself broken at its commas.
fn wrap(elements: &[String], indent: usize, text: &mut String) {
    let mut column = indent;
    for (at, element) in elements.iter().enumerate() {
        let pieces =
            if indent + element.len() + 1 > WIDTH { element.split(", ").collect() } else { vec![element.as_str()] };
        for (part, piece) in pieces.into_iter().enumerate() {
            if at + part > 0 {
                // With the commas before and behind it.
                let is_full = column + piece.len() + 3 > WIDTH;
                text.push(',');
                text.push_str(&if is_full { format!("\n{:indent$}", "") } else { " ".to_owned() });
                column = if is_full { indent } else { column + 2 };
            }
            text.push_str(piece);
            column += piece.len();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_take_the_place_of_names() {
        let mut listings = Listings::default();
        let empty = listings.add(std::iter::empty());
        let few = listings.add((0..3).map(|i| format!("({i}, 1)")));
        let many = listings.add((0..40).map(|i| format!("({i}, 1)")));
        let long = listings.add(std::iter::once(format!("&[{}]", vec!["12345"; 40].join(", "))));
        let source = format!(
            "/// {few}\nlet a = ({empty}, [{few}]);\n    let b = [{many}];\n    let c = [\n        {long},\n    ];\nlet listing_0_of = 1;\n"
        );
        let text = listings.insert_into(&source);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[0], "/// LISTING_1_");
        assert_eq!(lines[1], "let a = (, [(0, 1), (1, 1), (2, 1)]);");
        assert_eq!(lines[2], "    let b = [");
        assert!(lines[3].starts_with("        (0, 1), (1, 1), ") && lines[3].ends_with(','), "{text}");
        assert!(lines.iter().all(|line| line.len() <= WIDTH), "{text}");
        assert_eq!(lines.last(), Some(&"let listing_0_of = 1;"));
        let words = |text: &str| text.split_whitespace().collect::<String>();
        let pairs: String = (0..40).map(|i| format!("({i},1),")).collect();
        assert!(words(&text).contains(&format!("letb=[{pairs}];letc=[&[")), "{text}");
        assert_eq!(text.matches("12345").count(), 40);
    }
}
