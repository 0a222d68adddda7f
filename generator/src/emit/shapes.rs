//! Prints data and arrays: parameters, their types, their elements; and lines of documentation.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use crate::problem::{DataParameter, SolutionField};

pub(super) fn doc_line(line: &str) -> String {
    if line.is_empty() { String::new() } else { format!(" {line}") }
}

/// `[[f64; 3]; 2]` for the element `f64` and the shape 2 x 3.
pub(super) fn array_type(element: TokenStream, shape: &[usize]) -> TokenStream {
    shape.iter().rev().fold(element, |inner, &length| {
        let length = Literal::usize_unsuffixed(length);
        quote!([#inner; #length])
    })
}

/// The indices of every scalar of an array, in flat order.
pub(super) fn indices(shape: &[usize]) -> impl Iterator<Item = Vec<usize>> {
    (0..shape.iter().product()).map(|flat: usize| {
        let mut rest = flat;
        let mut indices = Vec::new();
        for &length in shape.iter().rev() {
            indices.push(rest % length);
            rest /= length;
        }
        indices.reverse();
        indices
    })
}

/// A parameter as the functions declare it: scalars by value, arrays by reference.
pub(super) fn parameter(parameter: &DataParameter) -> TokenStream {
    let name = format_ident!("{}", parameter.name);
    let array = array_type(quote!(f64), &parameter.shape);
    if parameter.shape.is_empty() { quote!(#name: #array) } else { quote!(#name: &#array) }
}

/// All values of a parameter as a slice.
pub(super) fn as_slice(parameter: &DataParameter) -> TokenStream {
    let name = format_ident!("{}", parameter.name);
    match parameter.shape.len() {
        0 => quote!(&[#name]),
        1 => quote!(#name),
        depth => {
            let flattened = (1..depth).fold(quote!(#name), |inner, _| quote!(#inner.as_flattened()));
            quote!(#flattened)
        }
    }
}

/// The constant that holds the chart of a vector.
pub(super) fn chart_name(field: &SolutionField) -> Ident {
    format_ident!("CHART_OF_{}", field.name.to_uppercase())
}
