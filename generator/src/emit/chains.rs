//! Prints the arithmetic of M(x), the matrix of polynomials whose determinant has the eigenvalues
//! for roots: see `runtime/src/spectrum/hidden_variable.rs`.
//!
//! Each polynomial has a length of its own. Code in which all lengths are constants is several
//! times as fast as loops over tables.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::storage;
use crate::plan::chains::{ChainPlace, Minor};
use crate::plan::{Chains, Plan};

/// The chains of the basis, if real solutions are found by a determinant.
pub(super) fn chains(plan: &Plan) -> TokenStream {
    let Some(chains) = &plan.chains else { return quote!() };
    let [basis, count, width, coefficients] =
        [chains.order.len(), chains.lengths.len(), chains.width(), chains.order.len() + 1]
            .map(Literal::usize_unsuffixed);
    let polynomials = chains.sources().into_iter().map(|source| match source {
        Some(b) => {
            let b = Literal::usize_unsuffixed(b);
            quote!(-row[#b])
        }
        None => quote!(zero),
    });
    let values = (0..chains.lengths.len()).map(|column| {
        let entry = entry(chains, &quote!(row), column);
        quote!(emitted::value_at(#entry, x))
    });
    let (table, determinant, vector) = (table(chains), determinant(chains), vector(chains));
    let generics = storage::generics(plan);
    quote! {
        /// How the basis falls into chains.
        struct Chains;

        impl emitted::ChainedBasis for Chains {
            type Basis = emitted::Fixed<#basis>;
            type Count = emitted::Fixed<#count>;
            type Width = emitted::Fixed<#width>;
            type Coefficients = emitted::Fixed<#coefficients>;

            fn sizes(&self) -> (Self::Basis, Self::Count, Self::Width, Self::Coefficients) {
                (emitted::Fixed, emitted::Fixed, emitted::Fixed, emitted::Fixed)
            }

            #table

            #[inline(always)]
            fn polynomials<T: emitted::Arithmetic>(&self, row: &[T; #basis]) -> [T; #width] {
                let zero = row[0].constant(0.0);
                [#(#polynomials),*]
            }

            #[inline(always)]
            fn determinant<T: emitted::Arithmetic>(&self, rows: &[[T; #width]; #count]) -> [T; #coefficients] {
                #determinant
            }

            #[inline(always)]
            fn row_at<T: emitted::Arithmetic>(&self, row: &[T; #width], x: T) -> [T; #count] {
                [#(#values),*]
            }

            #vector
        }

        impl #generics emitted::HiddenVariableSolver for Instance #generics {
            type Chains = Chains;

            fn chains(&self) -> Chains {
                Chains
            }
        }
    }
}

/// The polynomial of this column of a row of M(x).
fn entry(chains: &Chains, row: &TokenStream, column: usize) -> TokenStream {
    let (first, degree) = chains.columns()[column];
    let [length, width, first] = [degree + 1, chains.width(), first].map(Literal::usize_unsuffixed);
    quote!(emitted::entry::<#length, #first, #width, T>(#row))
}

/// Where the monomials are.
fn table(chains: &Chains) -> TokenStream {
    let [ends, leading, degrees, heads] =
        [chains.ends(), chains.leading(), chains.degrees(), chains.heads()].map(|list| {
            let list = list.into_iter().map(Literal::usize_unsuffixed);
            quote!(&[#(#list),*])
        });
    quote! {
        fn table(&self) -> emitted::ChainTable<'_> {
            emitted::ChainTable { ends: #ends, leading: #leading, degrees: #degrees, heads: #heads }
        }
    }
}

/// All minors of the first rows, each by expansion along its last row. The name of a minor lists
/// its columns.
fn determinant(chains: &Chains) -> TokenStream {
    let minors = chains.minors();
    let last = minors.last().map(|&minor| name(minor));
    let last = if minors.len() == 1 { quote!(*#last) } else { quote!(#last) };
    let minors = minors.into_iter().map(|minor| expansion(chains, minor));
    let zero = match chains.lengths.len() {
        1 => quote!(),
        _ => quote!(let zero = rows[0][0].constant(0.0);),
    };
    quote! {
        #zero
        #(#minors)*
        #last
    }
}

fn name(minor: Minor) -> Ident {
    let columns: Vec<String> = minor.columns().map(|column| column.to_string()).collect();
    format_ident!("m{}", columns.concat())
}

fn expansion(chains: &Chains, minor: Minor) -> TokenStream {
    let (name_of_minor, row) = (name(minor), Literal::usize_unsuffixed(minor.row()));
    let entry = |column: usize| entry(chains, &quote!(&rows[#row]), column);
    if minor.row() == 0 {
        let entries = minor.columns().map(entry);
        return quote!(let #name_of_minor = #(#entries)*;);
    }
    let degrees = chains.degrees();
    let length = Literal::usize_unsuffixed(minor.columns().map(|column| degrees[column]).sum::<usize>() + 1);
    let products = minor.products().map(|(is_negative, column, others)| {
        let (entry, known) = (entry(column), name(others));
        let known = if others.row() == 0 { quote!(#known) } else { quote!(&#known) };
        let add = if is_negative { quote!(subtract_product) } else { quote!(add_product) };
        quote!(T::#add(&mut #name_of_minor, #entry, #known);)
    });
    quote! {
        let mut #name_of_minor = [zero; #length];
        #(#products)*
    }
}

/// The values of the basis monomials: a head times a power of x.
fn vector(chains: &Chains) -> TokenStream {
    let [basis, count] = [chains.order.len(), chains.lengths.len()].map(Literal::usize_unsuffixed);
    let longest = chains.lengths.iter().copied().max().unwrap_or(1);
    let power = |power: usize| if power == 1 { format_ident!("x") } else { format_ident!("x{power}") };
    let powers = (2..longest).map(|exponent| {
        let (own, before) = (power(exponent), power(exponent - 1));
        quote!(let #own = #before * x;)
    });
    let values = chains.places().into_iter().map(|place| match place {
        ChainPlace::Kept { chain, power: 0 } => {
            let chain = Literal::usize_unsuffixed(chain);
            quote!(heads[#chain])
        }
        ChainPlace::Kept { chain, power: exponent } => {
            let (chain, factor) = (Literal::usize_unsuffixed(chain), power(exponent));
            quote!(heads[#chain] * #factor)
        }
        ChainPlace::Eliminated(number) => {
            let number = Literal::usize_unsuffixed(number);
            quote!(eliminated[#number])
        }
    });
    let unread = if longest == 1 { quote!(let _ = x;) } else { quote!() };
    let none = if chains.eliminated == 0 { quote!(let _ = eliminated;) } else { quote!() };
    quote! {
        #[inline(always)]
        fn vector<T: emitted::Arithmetic>(&self, x: T, heads: &[T; #count], eliminated: &[T; #count]) -> [T; #basis] {
            #unread
            #none
            #(#powers)*
            [#(#values),*]
        }
    }
}
