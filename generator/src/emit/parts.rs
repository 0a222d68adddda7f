//! Long straight-line code as several functions.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::quote;

/// A statement that reads and writes elements of arrays.
pub(super) struct Statement {
    pub(super) tokens: TokenStream,
    /// The number of operators.
    pub(super) operations: usize,
}

/// A scalar that a program reads: a local variable, and its value.
#[derive(Clone)]
pub(super) struct Input {
    pub(super) local: Ident,
    pub(super) value: TokenStream,
}

/// Local variables for what a program reads.
pub(super) struct Locals<'a> {
    pub(super) read: Vec<&'a Input>,
}

impl Locals<'_> {
    /// Declarations of all: `let gram_0_2 = data[2];`.
    pub(super) fn declared(&self) -> TokenStream {
        self.read.iter().map(|input| input.declared()).collect()
    }

    /// Declarations of those that the code names.
    fn named_in(&self, code: &TokenStream) -> TokenStream {
        let names = names_in(code);
        let named = self.read.iter().filter(|input| names.contains(&input.local.to_string()));
        named.map(|input| input.declared()).collect()
    }
}

impl Input {
    fn declared(&self) -> TokenStream {
        let Self { local, value } = self;
        quote!(let #local = #value;)
    }
}

/// All names in the code.
pub(super) fn names_in(code: &TokenStream) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    let mut open = vec![code.clone()];
    while let Some(code) = open.pop() {
        for token in code {
            match token {
                TokenTree::Ident(ident) => drop(names.insert(ident.to_string())),
                TokenTree::Group(group) => open.push(group.stream()),
                _ => {}
            }
        }
    }
    names
}

/// Statements in functions of their own, of about as many operations each, and about `most` at
/// most. `one` is the variable of 1.
pub(super) fn in_parts(statements: &[Statement], most: usize, one: &Ident, locals: &Locals) -> Vec<TokenStream> {
    let all: usize = statements.iter().map(|statement| statement.operations).sum();
    let of_part = all.div_ceil(all.div_ceil(most).max(1)).max(1);
    let mut parts: Vec<TokenStream> = Vec::new();
    let mut before = 0;
    for statement in statements {
        let part = before / of_part;
        parts.resize_with(parts.len().max(part + 1), TokenStream::new);
        parts[part].extend(statement.tokens.clone());
        before += statement.operations;
    }
    let part = |code: TokenStream| {
        let locals = locals.named_in(&code);
        quote! {
            #one.apart(#[inline(always)] || {
                #locals
                #code
            });
        }
    };
    parts.into_iter().filter(|part| !part.is_empty()).map(part).collect()
}

#[cfg(test)]
mod tests {
    use quote::format_ident;

    use super::*;

    /// Three statements of five operations in parts of up to eight: two and one, each with the data
    /// that it reads.
    #[test]
    fn parts_are_of_about_equal_length() {
        let one = format_ident!("one");
        let inputs = [("a", quote!(data[0])), ("b", quote!(data[4]))];
        let inputs = inputs.map(|(name, value)| Input { local: format_ident!("{name}"), value });
        let locals = Locals { read: inputs.iter().collect() };
        let statement = |tokens| Statement { tokens, operations: 5 };
        let statements = [quote!(v[0] = a;), quote!(v[1] = (a * v[0]);), quote!(v[2] = b;)].map(statement);
        let parts = in_parts(&statements, 8, &one, &locals);
        let expected = [
            quote!(one.apart(#[inline(always)] || { let a = data[0]; v[0] = a; v[1] = (a * v[0]); });),
            quote!(one.apart(#[inline(always)] || { let b = data[4]; v[2] = b; });),
        ];
        let text = |code: &TokenStream| code.to_string();
        assert_eq!(parts.iter().map(text).collect::<Vec<_>>(), expected.iter().map(text).collect::<Vec<_>>());
    }
}
