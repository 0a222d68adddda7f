//! Shapes in a list of unknowns, and attributes: `-> (#[projective] v: [f64; 3], s)`.
//!
//! Rust has no such type. Both are taken out before the text is parsed, so that the list is a tuple
//! of names.

use std::collections::BTreeMap;

use proc_macro2::{Delimiter, Group, Ident, Spacing, TokenStream, TokenTree};
use syn::Type;

use super::Span;
use crate::problem::diagnostic::Diagnostic;

/// What stands beside the names of unknowns, by the byte at which the name begins.
pub(super) type Shapes = BTreeMap<usize, UnknownShape>;

/// What stands beside the name of an unknown.
#[derive(Default)]
pub(super) struct UnknownShape {
    /// The type behind it.
    pub(super) ty: Option<Type>,
    /// Where `#[projective]` stands before it.
    pub(super) projective: Option<Span>,
}

/// The tokens of a file without the shapes of unknowns, and these.
pub(super) fn take_shapes(tokens: TokenStream) -> Result<(TokenStream, Shapes), Diagnostic> {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let mut shapes = Shapes::new();
    let mut kept = Vec::with_capacity(tokens.len());
    let mut rest = &tokens[..];
    while let Some(arrow) = rest.windows(2).position(is_arrow) {
        let (before, after) = rest.split_at(arrow + 2);
        kept.extend_from_slice(before);
        let end = after.iter().position(ends_signature).unwrap_or(after.len());
        let (output, after) = after.split_at(end);
        kept.extend(without_shape(output, &mut shapes)?);
        rest = after;
    }
    kept.extend_from_slice(rest);
    Ok((kept.into_iter().collect(), shapes))
}

fn is_arrow(tokens: &[TokenTree]) -> bool {
    let is = |token: &TokenTree, c: char| matches!(token, TokenTree::Punct(punct) if punct.as_char() == c);
    matches!(tokens, [minus, greater] if is(minus, '-') && is(greater, '>'))
}

/// The body of a function, or the end of a declaration without one.
fn ends_signature(token: &TokenTree) -> bool {
    match token {
        TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
        TokenTree::Punct(punct) => punct.as_char() == ';',
        _ => false,
    }
}

/// An unknown, or a list of them in parentheses.
fn without_shape(tokens: &[TokenTree], shapes: &mut Shapes) -> Result<Vec<TokenTree>, Diagnostic> {
    match tokens {
        [TokenTree::Group(group)] if group.delimiter() == Delimiter::Parenthesis => {
            let stream: Vec<TokenTree> = group.stream().into_iter().collect();
            let mut kept = Vec::with_capacity(stream.len());
            for element in stream.split_inclusive(is_comma) {
                let (unknown, comma) =
                    element.split_at(element.len() - usize::from(element.last().is_some_and(is_comma)));
                kept.extend(without_shape(unknown, shapes)?);
                kept.extend_from_slice(comma);
            }
            let mut list = Group::new(Delimiter::Parenthesis, kept.into_iter().collect());
            list.set_span(group.span());
            Ok(vec![list.into()])
        }
        [TokenTree::Punct(hash), attribute @ TokenTree::Group(_), ..] if hash.as_char() == '#' => {
            let span = hash.span().byte_range().start..attribute.span().byte_range().end;
            match (attribute.to_string().as_str(), &tokens[2..]) {
                ("[projective]", [TokenTree::Ident(name), ..]) => {
                    shapes.entry(name.span().byte_range().start).or_default().projective = Some(span);
                    without_shape(&tokens[2..], shapes)
                }
                _ => Err(Diagnostic::new("unknown attribute of an unknown", span)
                    .label("expected `#[projective]`, for a vector that is given up to scale")
                    .hint("state what the unknowns satisfy as an equation: `dot(v, v) == 1;`")),
            }
        }
        [TokenTree::Ident(name), TokenTree::Punct(colon), shape @ ..]
            if colon.as_char() == ':' && colon.spacing() == Spacing::Alone =>
        {
            let span = match shape {
                [] => colon.span().byte_range(),
                [first, .., last] => first.span().byte_range().start..last.span().byte_range().end,
                [only] => only.span().byte_range(),
            };
            let shape = syn::parse2(shape.iter().cloned().collect()).map_err(|_| no_shape(name, span))?;
            shapes.entry(name.span().byte_range().start).or_default().ty = Some(shape);
            Ok(vec![name.clone().into()])
        }
        _ => Ok(tokens.to_vec()),
    }
}

fn is_comma(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == ',')
}

fn no_shape(name: &Ident, span: Span) -> Diagnostic {
    Diagnostic::new(format!("this is no shape of the unknown `{name}`"), span)
        .label("expected `[f64; n]`, `[[f64; n]; m]`, ..")
        .hint(format!("an array of three unknowns is written `{name}: [f64; 3]`, a scalar without a shape"))
}
