//! Prints data and arrays: parameters, their types, their elements; and lines of documentation.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use crate::problem::{DataParameter, SolutionField};

pub(super) fn doc_line(line: &str) -> String {
    if line.is_empty() { String::new() } else { format!(" {line}") }
}

/// `[[f64; 3]; 2]` for the element `f64` and the shape 2 x 3.
fn array_type(element: TokenStream, shape: &[usize]) -> TokenStream {
    shape.iter().rev().fold(element, |inner, &length| {
        let length = Literal::usize_unsuffixed(length);
        quote!([#inner; #length])
    })
}

/// The type of an array of numbers of one kind; the last dimension of complex numbers is 2.
pub(super) fn type_of(number: TokenStream, shape: &[usize], is_complex: bool) -> TokenStream {
    match shape {
        [dimensions @ .., _] if is_complex => array_type(quote!(::eliminant::Complex<#number>), dimensions),
        _ => array_type(number, shape),
    }
}

/// The value of such a type, from its scalars in flat order.
pub(super) fn value_of(shape: &[usize], is_complex: bool, scalars: &[TokenStream]) -> TokenStream {
    match (shape, scalars) {
        ([_], [re, im]) if is_complex => quote!(::eliminant::Complex { re: #re, im: #im }),
        ([length, inner @ ..], _) => {
            let rows = scalars.chunks(scalars.len() / length).map(|row| value_of(inner, is_complex, row));
            quote!([#(#rows),*])
        }
        _ => scalars.first().cloned().unwrap_or_default(),
    }
}

/// What stands behind the name of such a value for each of its scalars, in flat order: `[0][1]`, or
/// `[0].im`.
pub(super) fn accessors(shape: &[usize], is_complex: bool) -> impl Iterator<Item = TokenStream> {
    indices(shape).map(move |mut indices| {
        let part = is_complex.then(|| indices.pop()).flatten();
        let indices = indices.into_iter().map(Literal::usize_unsuffixed);
        let part = part.map(|part| if part == 0 { quote!(.re) } else { quote!(.im) });
        quote!(#([#indices])* #part)
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

/// A parameter as the functions declare it: numbers by value, arrays by reference.
pub(super) fn parameter(parameter: &DataParameter) -> TokenStream {
    let name = format_ident!("{}", parameter.name);
    let array = type_of(quote!(f64), &parameter.shape, parameter.is_complex);
    if parameter.is_number() { quote!(#name: #array) } else { quote!(#name: &#array) }
}

/// All values of a parameter as a slice.
pub(super) fn as_slice(parameter: &DataParameter) -> TokenStream {
    let name = format_ident!("{}", parameter.name);
    if parameter.is_complex {
        let accessors = accessors(&parameter.shape, true);
        return quote!(&[#(#name #accessors),*]);
    }
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
