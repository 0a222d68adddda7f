//! Lines of documentation and comments.

/// The longest line, without what marks it as a comment.
const WIDTH: usize = 96;

/// A text as lines broken at blanks, all but the first with this indentation.
pub(super) fn wrapped(text: &str, indentation: &str) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let mut line = String::new();
    for word in text.split(' ') {
        if !line.is_empty() && line.len() + 1 + word.len() > WIDTH {
            lines.push(std::mem::replace(&mut line, indentation.to_owned()));
        } else if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(word);
    }
    lines.push(line);
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_break_at_blanks() {
        let text = (0..100).map(|number| format!("`x^{number}`")).collect::<Vec<_>>().join(", ");
        let lines = wrapped(&format!("- basis: {text}"), "  ");
        assert!(lines.len() > 5 && lines.iter().all(|line| line.len() <= WIDTH), "{lines:?}");
        assert!(lines[0].starts_with("- basis: `x^0`, ") && lines[1..].iter().all(|line| line.starts_with("  `")));
        let joined = lines.iter().map(|line| line.trim_start()).collect::<Vec<_>>().join(" ");
        assert_eq!(joined, format!("- basis: {text}"));
        assert_eq!(wrapped("", "  "), [""]);
        assert_eq!(wrapped(&"x".repeat(200), "  "), ["x".repeat(200)]);
    }
}
