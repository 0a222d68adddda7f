//! Long lines of reports and messages, broken at spaces.

/// Lines of a report have at most so many columns, where they can be broken.
const COLUMNS: usize = 100;

/// The text with lines that are too long broken at spaces. What follows a label stands below what
/// stands beside it:
///
/// ```text
///   basis       x^2*y, x*y^2,
///               x*y, 1
/// ```
///
/// Messages have one of [`LABELS`]. Rows of tables, which have more than one gap, and lines without
/// a label stay as they are.
pub(super) fn folded(text: &str) -> String {
    text.split_inclusive('\n').map(folded_line).collect()
}

/// What begins a message.
const LABELS: [&str; 3] = ["error: ", "warning: ", "help: "];

fn folded_line(line: &str) -> String {
    if line.trim_end().chars().count() <= COLUMNS {
        return line.to_owned();
    }
    let gaps: Vec<usize> = line.match_indices("  ").map(|(at, _)| at).collect();
    let label = LABELS.iter().find(|label| line.starts_with(**label));
    let indent = match (label, gaps.first()) {
        (Some(label), _) => label.len(),
        (None, Some(&gap)) if gap > 0 => gap + line[gap..].chars().take_while(|&c| c == ' ').count(),
        (None, _) => return line.to_owned(),
    };
    if label.is_none() && gaps.last().is_some_and(|&last| last >= indent) {
        return line.to_owned();
    }
    let (mut folded, mut width) = (line[..indent].to_owned(), indent);
    for word in line[indent..].split_inclusive(' ') {
        let length = word.trim_end().chars().count();
        if width > indent && width + length > COLUMNS {
            folded.truncate(folded.trim_end().len());
            folded.push('\n');
            folded.push_str(&" ".repeat(indent));
            width = indent;
        }
        folded.push_str(word);
        width += word.chars().count();
    }
    folded
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_beside_a_label_are_folded() {
        let words = |count: usize| vec!["monomial"; count].join(", ");
        let text = folded(&format!("basis       {}\n\nnext  {}\n", words(20), words(3)));
        let lines: Vec<&str> = text.lines().collect();
        assert!(lines.iter().all(|line| line.len() <= COLUMNS), "{text}");
        assert!(lines[1].starts_with("            monomial") && lines.len() == 5, "{text}");
        assert_eq!(text.split_whitespace().count(), 25);
        assert!(text.ends_with(&format!("\n\nnext  {}\n", words(3))), "{text}");
    }

    #[test]
    fn messages_are_folded() {
        let text = folded(&format!("warning: {}\nhelp: short\n", vec!["solutions"; 20].join(" ")));
        let lines: Vec<&str> = text.lines().collect();
        assert!(lines.len() == 4 && lines.iter().all(|line| line.len() <= COLUMNS), "{text}");
        assert!(lines[1].starts_with("         solutions") && lines[3] == "help: short", "{text}");
    }

    #[test]
    fn tables_are_not_folded() {
        let wide = "x".repeat(90);
        for line in [format!("a  {wide}  {wide}\n"), format!("    {wide} {wide}\n"), format!("{wide} {wide}\n")] {
            assert_eq!(folded(&line), line);
        }
    }
}
