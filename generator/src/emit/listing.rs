//! Long tables, printed beside the syntax tree: to parse and format their numbers as expressions
//! takes longer than all else, above all in build scripts, which are compiled without optimisation.
//! The formatter would also drop their comments.

use proc_macro2::Ident;
use quote::format_ident;

use super::wrap::wrapped;

/// Lines are broken before this column, where the elements allow it.
const WIDTH: usize = 120;

/// How names of listings begin: those of problems have no capitals.
const PREFIX: &str = "LISTING_";

/// The elements of arrays, in the order of their names.
#[derive(Default)]
pub(super) struct Listings(Vec<Listing>);

/// The elements of one array.
enum Listing {
    /// One after another.
    Plain(Vec<String>),
    /// In groups, each behind a comment.
    Labelled(Vec<(String, Vec<String>)>),
}

impl Listings {
    /// A name that stands for these elements until all else is formatted.
    pub(super) fn add(&mut self, elements: impl Iterator<Item = String>) -> Ident {
        self.push(Listing::Plain(elements.collect()))
    }

    /// Like [`Listings::add`], for elements in groups with a comment before each.
    pub(super) fn add_labelled(&mut self, mut groups: Vec<(String, Vec<String>)>) -> Ident {
        groups.retain(|(_, elements)| !elements.is_empty());
        self.push(Listing::Labelled(groups))
    }

    fn push(&mut self, listing: Listing) -> Ident {
        self.0.push(listing);
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
        while let Some((before, listing, after)) = self.split(rest).filter(|_| !line[indent..].starts_with("//")) {
            text.push_str(before);
            let is_alone = before.trim().is_empty();
            if is_alone {
                listing.print(indent, text);
            } else if indent + before.len() + listing.length() + after.len() <= WIDTH {
                listing.print(0, text);
            } else {
                let inner = indent + 4;
                text.push_str(&format!("\n{:inner$}", ""));
                listing.print(inner, text);
                text.push_str(&format!(",\n{:indent$}", ""));
            }
            rest = after;
        }
        text.push_str(rest);
    }

    /// What stands before the first name, its elements, and what stands behind it.
    fn split<'a>(&self, line: &'a str) -> Option<(&'a str, &Listing, &'a str)> {
        let (before, rest) = line.split_once(PREFIX)?;
        let (number, after) = rest.split_once('_')?;
        Some((before, self.0.get(number.parse::<usize>().ok()?)?, after))
    }
}

impl Listing {
    /// An upper bound for the columns that it takes on one line; with comments it needs lines of
    /// its own.
    fn length(&self) -> usize {
        match self {
            Self::Plain(elements) => elements.iter().map(|element| element.len() + 2).sum(),
            Self::Labelled(groups) => {
                if groups.is_empty() {
                    0
                } else {
                    WIDTH
                }
            }
        }
    }

    /// Prints it at the end of a text whose last line has this indentation.
    fn print(&self, indent: usize, text: &mut String) {
        match self {
            Self::Plain(elements) => wrap(elements, indent, text),
            Self::Labelled(groups) => {
                for (at, (label, elements)) in groups.iter().enumerate() {
                    if at > 0 {
                        text.push_str(&format!(",\n{:indent$}", ""));
                    }
                    for line in label.lines().flat_map(|line| wrapped(line, "")) {
                        text.push_str(&format!("// {line}\n{:indent$}", ""));
                    }
                    wrap(elements, indent, text);
                }
            }
        }
    }
}

/// Writes the elements, separated by commas, on lines with this indentation. An element that is too
/// long for a line is itself broken at its commas.
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
            "/// {few}\nlet a = ({empty}, [{few}]);\n    let b = [{many}];\n    let c = [\n        {long},\n    ];\nlet listing_of = 1;\n"
        );
        let text = listings.insert_into(&source);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[0], "/// LISTING_1_");
        assert_eq!(lines[1], "let a = (, [(0, 1), (1, 1), (2, 1)]);");
        assert_eq!(lines[2], "    let b = [");
        assert!(lines[3].starts_with("        (0, 1), (1, 1), ") && lines[3].ends_with(','), "{text}");
        assert!(lines.iter().all(|line| line.len() <= WIDTH), "{text}");
        assert_eq!(lines.last(), Some(&"let listing_of = 1;"));
        let words = |text: &str| text.split_whitespace().collect::<String>();
        let pairs: String = (0..40).map(|i| format!("({i},1),")).collect();
        assert!(words(&text).contains(&format!("letb=[{pairs}];letc=[&[")), "{text}");
        assert_eq!(text.matches("12345").count(), 40);
    }

    #[test]
    fn groups_stand_behind_their_labels() {
        let mut listings = Listings::default();
        let rows = [("columns\nrow 0", 2), ("row 1", 0), ("row 2", 1)];
        let rows = rows.map(|(label, count)| (label.to_owned(), vec!["(1, 2)".to_owned(); count]));
        let inline = listings.add_labelled(rows.to_vec());
        let alone = listings.add_labelled(rows.to_vec());
        let empty = listings.add_labelled(Vec::new());
        let source = format!("    a: &[{inline}],\n    b: &[\n        {alone},\n    ],\n    c: &[{empty}],\n");
        let expected = "    a: &[
        // columns
        // row 0
        (1, 2), (1, 2),
        // row 2
        (1, 2),
    ],
    b: &[
        // columns
        // row 0
        (1, 2), (1, 2),
        // row 2
        (1, 2),
    ],
    c: &[],
";
        assert_eq!(listings.insert_into(&source), expected);
    }
}
