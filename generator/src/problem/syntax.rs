//! Text to syntax tree: limits that keep the parser safe on any input, and syntax errors in the
//! words of the language.

use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};
use syn::spanned::Spanned;

use super::Span;
use super::unknown_shapes::{Shapes, take_shapes};
use crate::problem::diagnostic::Diagnostic;

/// Longest text of a problem file, in bytes.
const MAX_TEXT: usize = 1 << 20;

/// Longest path of tokens that may lie around or before a token in one expression. The parser, the
/// evaluator and the destructor of the tree recurse at most once per token of that path.
const MAX_EXPRESSION_TOKENS: usize = 2000;

/// The bytes a part of the syntax tree came from.
pub(super) fn place(node: &impl Spanned) -> Span {
    node.span().byte_range()
}

/// Parses the text, which must not begin with a byte order mark, and takes the shapes of unknowns
/// out.
pub(super) fn parse_file(text: &str) -> Result<(syn::File, Shapes), Diagnostic> {
    if text.len() > MAX_TEXT {
        let message = format!("the file has {} bytes, at most {MAX_TEXT} are allowed", text.len());
        return Err(Diagnostic::new(message, 0..0));
    }
    let tokens: TokenStream = text.parse().map_err(|error: proc_macro2::LexError| lexical_error(&error, text))?;
    check_lengths(&tokens, 0)?;
    let (tokens, shapes) = take_shapes(tokens)?;
    let file = syn::parse2(tokens).map_err(|error| syntax_error(&error, text))?;
    Ok((file, shapes))
}

/// Checks that no expression exceeds [`MAX_EXPRESSION_TOKENS`], counted along nested brackets.
fn check_lengths(tokens: &TokenStream, before: usize) -> Result<(), Diagnostic> {
    let mut length = before;
    let mut after_block = false;
    let mut after_hash = false;
    for token in tokens.clone() {
        // Attributes, doc comments among them, do not nest.
        let hash = matches!(&token, TokenTree::Punct(punct) if punct.as_char() == '#');
        let attribute = std::mem::replace(&mut after_hash, hash) || hash;
        // A new statement, argument or item starts the count anew; `else` and operators continue
        // after a block.
        let continues = match &token {
            TokenTree::Ident(ident) => ident == "else" || ident == "as",
            TokenTree::Punct(_) => !hash,
            TokenTree::Group(group) => group.delimiter() != Delimiter::Brace,
            TokenTree::Literal(_) => false,
        };
        if after_block && !continues {
            length = before;
        }
        length += usize::from(!attribute);
        if length > MAX_EXPRESSION_TOKENS {
            return Err(Diagnostic::new("the expression is too long", token.span().byte_range())
                .label(format!("more than {MAX_EXPRESSION_TOKENS} tokens up to here"))
                .hint("name parts of it with `let`, or write the sum as a `for` loop"));
        }
        after_block = false;
        match &token {
            TokenTree::Group(group) => {
                check_lengths(&group.stream(), length)?;
                after_block = group.delimiter() == Delimiter::Brace;
            }
            TokenTree::Punct(punct) if matches!(punct.as_char(), ';' | ',') => length = before,
            _ => {}
        }
    }
    Ok(())
}

/// A text that is no sequence of Rust tokens with matching brackets.
fn lexical_error(error: &proc_macro2::LexError, text: &str) -> Diagnostic {
    if let Some(diagnostic) = unmatched_bracket(text) {
        return diagnostic;
    }
    Diagnostic::new("not a token of the language", error.span().byte_range())
        .label("neither a name, nor a number, nor an operator")
}

/// The first bracket without its partner. Only called on text that does not tokenise, so that
/// brackets in comments can at worst make this message less apt.
fn unmatched_bracket(text: &str) -> Option<Diagnostic> {
    let mut open = Vec::new();
    let mut at = 0;
    while let Some(c) = text[at..].chars().next() {
        if text[at..].starts_with("//") {
            at += text[at..].find('\n').unwrap_or(text.len() - at);
            continue;
        }
        match c {
            '(' | '[' | '{' => open.push((c, at)),
            ')' | ']' | '}' => {
                let span = at..at + 1;
                match open.pop() {
                    Some(('(', _)) if c == ')' => {}
                    Some(('[', _)) if c == ']' => {}
                    Some(('{', _)) if c == '}' => {}
                    Some((opening, from)) => {
                        return Some(
                            Diagnostic::new(format!("`{opening}` is closed by `{c}`"), span)
                                .label("this does not match")
                                .context(from..from + 1, "the bracket that is open here"),
                        );
                    }
                    None => {
                        return Some(
                            Diagnostic::new(format!("`{c}` closes nothing"), span).label("no bracket is open"),
                        );
                    }
                }
            }
            _ => {}
        }
        at += c.len_utf8();
    }
    let (opening, at) = open.pop()?;
    Some(Diagnostic::new(format!("`{opening}` is never closed"), at..at + 1).label("opened here"))
}

/// A sequence of tokens that is not Rust syntax.
fn syntax_error(error: &syn::Error, text: &str) -> Diagnostic {
    let mut span = error.span().byte_range();
    if span == (0..0) {
        // The parser ran into the end of the text.
        span = text.trim_end().len().saturating_sub(1)..text.trim_end().len();
    }
    let found = error.to_string();
    if found.contains("cannot be chained") {
        return Diagnostic::new("comparisons cannot be chained", span)
            .label("a second comparison in one statement")
            .hint("state each equation on its own: `a == b; b == c;`");
    }
    if let Some(diagnostic) = keyword_for_name(text, span.start) {
        return diagnostic;
    }
    if found == "expected curly braces" && text[..span.start].rsplit("->").next().is_some_and(is_lone_name) {
        return Diagnostic::new("unknowns without parentheses", span)
            .label("the list goes on here")
            .hint("list the unknowns in parentheses: `-> (x, y)`");
    }
    let diagnostic = Diagnostic::new(format!("syntax error: {found}"), span.clone());
    if !found.contains("expected `;`") {
        return diagnostic;
    }
    let before = text[..span.start].trim_end();
    if text[before.len()..span.start].contains('\n') {
        let last = before.chars().next_back().map_or(0, char::len_utf8);
        return diagnostic.at(before.len() - last..before.len()).label("missing after this").hint("end it with `;`");
    }
    diagnostic.label("unexpected here").hint("a product needs `*`: `2 * x`, `a * (b + c)`")
}

/// Whether this is a name and nothing else, as between an arrow and a comma.
fn is_lone_name(text: &str) -> bool {
    let name = text.trim();
    !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

/// A keyword of Rust where a name is meant: at the place of a syntax error or right before it,
/// between what can only surround a value.
fn keyword_for_name(text: &str, at: usize) -> Option<Diagnostic> {
    let is_letter = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let word_from = |start: usize| start..text[start..].find(|c| !is_letter(c)).map_or(text.len(), |end| start + end);
    let before = text.get(..at)?.trim_end();
    let previous = before.trim_end_matches(is_letter).len();
    [at, previous].into_iter().map(word_from).find_map(|span| {
        let word = &text[span.clone()];
        let (left, right) = (text[..span.start].trim_end(), text[span.end..].trim_start());
        let is_value = left.ends_with(['(', '[', ',', '+', '-', '*', '/', '='])
            && right.starts_with([')', ']', ',', '+', '-', '*', '/', '=', ';']);
        let is_keyword = !word.is_empty() && word != "_" && syn::parse_str::<Ident>(word).is_err();
        let is_keyword = is_keyword && word.starts_with(|c: char| c.is_ascii_alphabetic());
        (is_value && is_keyword)
            .then(|| Diagnostic::new(format!("`{word}` is reserved in Rust"), span).label("choose another name"))
    })
}
