//! Blocks of code in a page, and the comments that say what they are.

/// What the comment before a block says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Mark {
    /// Nothing.
    None,
    /// `<!-- file PATH -->`: the content of a file.
    File(String),
    /// `<!-- run -->`: commands.
    Run,
    /// `<!-- output -->`: lines of what the commands before it print.
    Output,
}

/// A block between lines of three backticks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    /// What stands after the backticks.
    pub language: String,
    /// The comment before it.
    pub mark: Mark,
    /// Its lines.
    pub text: String,
}

/// All blocks of a page, in their order.
#[must_use]
pub fn blocks(page: &str) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut open: Option<Block> = None;
    let mut mark = Mark::None;
    for line in page.lines() {
        match (&mut open, line.strip_prefix("```")) {
            (None, Some(language)) => {
                let mark = std::mem::replace(&mut mark, Mark::None);
                open = Some(Block { language: language.to_owned(), mark, text: String::new() });
            }
            (None, None) => mark = of_comment(line).unwrap_or(Mark::None),
            (Some(_), Some(_)) => blocks.extend(open.take()),
            (Some(block), None) => {
                block.text.push_str(line);
                block.text.push('\n');
            }
        }
    }
    blocks
}

fn of_comment(line: &str) -> Option<Mark> {
    let comment = line.strip_prefix("<!-- ")?.strip_suffix(" -->")?;
    match comment.split_once(' ') {
        Some(("file", path)) => Some(Mark::File(path.to_owned())),
        None if comment == "run" => Some(Mark::Run),
        None if comment == "output" => Some(Mark::Output),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_know_the_comment_right_before_them() {
        let page =
            "a\n<!-- file b/c -->\n```rust\nx\ny\n```\n<!-- run -->\n\n```sh\nz\n```\n<!-- output -->\n```\n```\n";
        let block = |language: &str, mark, text: &str| Block { language: language.into(), mark, text: text.into() };
        let expected = [
            block("rust", Mark::File("b/c".into()), "x\ny\n"),
            block("sh", Mark::None, "z\n"),
            block("", Mark::Output, ""),
        ];
        assert_eq!(blocks(page), expected);
    }
}
