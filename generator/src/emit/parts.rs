//! Long straight-line code as several functions.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, TokenStream, TokenTree};
use quote::quote;

/// A statement that reads and writes elements of arrays.
pub(super) struct Statement {
    pub(super) tokens: TokenStream,
    /// The number of operators.
    pub(super) operations: usize,
}

/// Local variables for scalars of the data.
pub(super) struct Locals<'a> {
    pub(super) data: &'a Ident,
    /// Their positions in the data, and their names.
    pub(super) read: Vec<(usize, &'a Ident)>,
}

impl Locals<'_> {
    /// Declarations of all: `let gram_0_2 = data[2];`.
    pub(super) fn declared(&self) -> TokenStream {
        self.read.iter().map(|local| self.declaration(local)).collect()
    }

    /// Declarations of those that the code names.
    fn named_in(&self, code: &TokenStream) -> TokenStream {
        let names = names_in(code);
        let named = self.read.iter().filter(|(_, local)| names.contains(&local.to_string()));
        named.map(|local| self.declaration(local)).collect()
    }

    fn declaration(&self, &(input, local): &(usize, &Ident)) -> TokenStream {
        let (at, data) = (Literal::usize_unsuffixed(input), self.data);
        quote!(let #local = #data[#at];)
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
        let [data, one, a, b] = ["data", "one", "a", "b"].map(|name| format_ident!("{name}"));
        let locals = Locals { data: &data, read: vec![(0, &a), (4, &b)] };
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
