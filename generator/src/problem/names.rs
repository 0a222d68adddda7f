//! Which names a problem may use, and which name somebody who mistyped may have meant.

use proc_macro2::Ident;

use super::syntax::place;
use crate::problem::diagnostic::Diagnostic;

/// Reserved in some edition of Rust although the parser takes them as names.
const RESERVED: [&str; 4] = ["gen", "try", "union", "macro_rules"];

/// The message for a name that emitted code could not use as it stands.
pub(super) fn refuse(ident: &Ident, what: &str) -> Option<Diagnostic> {
    let name = ident.to_string();
    let span = place(ident);
    if name.starts_with("r#") || RESERVED.contains(&name.as_str()) || syn::parse_str::<Ident>(&name).is_err() {
        return Some(Diagnostic::new(format!("`{name}` is reserved in Rust"), span).label("choose another name"));
    }
    if is_snake_case(&name) {
        return None;
    }
    let message = format!("the name of {what} must be in snake_case");
    let mut diagnostic = Diagnostic::new(message, span)
        .label("expected a lower-case letter, then lower-case letters, digits and single `_`");
    let snake = snake_case(&name);
    if snake != name && snake.is_ascii() {
        diagnostic = diagnostic.hint(format!("write `{snake}`"));
    }
    Some(diagnostic)
}

fn is_snake_case(name: &str) -> bool {
    let starts_well = name.starts_with(|c: char| c.is_ascii_lowercase());
    let letters_fit = name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_');
    // Rust warns of two underscores in a row: the warning would appear in the crate that includes
    // the solver.
    starts_well && letters_fit && !name.trim_end_matches('_').contains("__")
}

/// The name that a local value of a problem has in emitted code; `None` if it cannot have one.
pub(super) fn emitted_name(name: &str) -> Option<String> {
    let name = if is_snake_case(name) { name.to_owned() } else { snake_case(name) };
    let is_free = !RESERVED.contains(&name.as_str()) && syn::parse_str::<Ident>(&name).is_ok();
    (is_snake_case(&name) && is_free).then_some(name)
}

/// The message for the name of a problem that cannot name a module beside
/// `eliminant::include_solver!`.
pub(super) fn refuse_module(ident: &Ident) -> Option<Diagnostic> {
    // A module from a macro hides no crate: Rust calls all paths ambiguous that begin with the
    // name.
    (ident == "eliminant").then(|| {
        Diagnostic::new("`eliminant` is the name of the run-time crate", place(ident))
            .label("the module of the solver would make `eliminant::include_solver!` ambiguous")
            .hint("choose another name")
    })
}

/// `TwoLines` as `two_lines`.
pub(super) fn snake_case(name: &str) -> String {
    let mut snake = String::new();
    let mut after_lowercase = false;
    for c in name.trim_matches('_').chars() {
        let begins_word = c == '_' || c.is_ascii_uppercase() && after_lowercase;
        if begins_word && !snake.ends_with('_') {
            snake.push('_');
        }
        after_lowercase = c.is_ascii_lowercase();
        if c != '_' {
            snake.push(c.to_ascii_lowercase());
        }
    }
    snake
}

/// Names of more bytes are not compared, and not more than so many candidates.
const LONGEST: usize = 64;
const MOST_CANDIDATES: usize = 200;

/// The candidate closest to a mistyped name, if any is close. Of many candidates only the first are
/// tried.
pub(super) fn closest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let most = match name.chars().count() {
        0 | 1 => 0,
        _ if name.len() > LONGEST => return None,
        length => (length / 3).max(1),
    };
    candidates
        .into_iter()
        .filter(|&candidate| candidate != name && candidate.len() <= LONGEST)
        .take(MOST_CANDIDATES)
        .map(|candidate| (edit_distance(&name.to_lowercase(), &candidate.to_lowercase()), candidate))
        .filter(|&(distance, _)| distance <= most)
        .min()
        .map(|(_, candidate)| candidate)
}

/// Number of insertions, deletions, substitutions and swaps of neighbours that turn `a` into `b`.
fn edit_distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    // distance[i][j] between the first i characters of a and the first j of b.
    let mut distance = vec![vec![0; b.len() + 1]; a.len() + 1];
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            distance[i][j] = match (i, j) {
                (0, j) => j,
                (i, 0) => i,
                (i, j) => {
                    let substitute = distance[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
                    let mut best = substitute.min(distance[i - 1][j] + 1).min(distance[i][j - 1] + 1);
                    if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                        best = best.min(distance[i - 2][j - 2] + 1);
                    }
                    best
                }
            };
        }
    }
    distance[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_count_edits() {
        for (a, b, expected) in [("", "abc", 3), ("lamda", "lambda", 1), ("grma", "gram", 1), ("x", "y", 1)] {
            assert_eq!(edit_distance(a, b), expected, "{a} {b}");
            assert_eq!(edit_distance(b, a), expected, "{b} {a}");
        }
    }

    #[test]
    fn snake_case_names_are_offered() {
        for (name, expected) in
            [("TwoLines", "two_lines"), ("X", "x"), ("_a", "a"), ("E5pt", "e5pt"), ("XYZ", "xyz"), ("a__b_C", "a_b_c")]
        {
            assert_eq!(snake_case(name), expected);
        }
    }

    #[test]
    fn local_names_are_kept_in_snake_case() {
        for (name, expected) in [("sum", Some("sum")), ("A", Some("a")), ("Gen", None), ("λ", None), ("_", None)] {
            assert_eq!(emitted_name(name).as_deref(), expected, "{name}");
        }
    }

    #[test]
    fn the_closest_name_is_suggested_only_if_close() {
        let names = ["lambda1", "lambda2", "x", "Gram"];
        assert_eq!(closest("lamda2", names), Some("lambda2"));
        assert_eq!(closest("gram", names), Some("Gram"));
        assert_eq!(closest("y", names), None);
        assert_eq!(closest("translation", names), None);
    }
}
