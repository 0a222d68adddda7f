//! Prints how data are computed that are means over measurements.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::code;
use super::names::Names;
use super::shapes::{as_slice, doc_line, type_of};
use crate::plan::{Plan, PlannedMeasurement};
use crate::problem::DataParameter;

/// The functions that compute means of the plan.
pub(super) fn functions(plan: &Plan) -> TokenStream {
    let functions = plan.measurements.iter().map(function);
    quote!(#(#functions)*)
}

/// The function that takes the mean, and the one for a measurement.
fn function(measurement: &PlannedMeasurement) -> TokenStream {
    let PlannedMeasurement { name, docs, data, shape, program, elements } = measurement;
    let inputs: usize = data.iter().map(DataParameter::len).sum();
    let [mean, given] = [format_ident!("mean_{name}"), format_ident!("given_{name}")];
    let compute = code::shared_function((data, inputs), (&given, " What one measurement gives."), program, elements, 1);
    let docs = docs.iter().map(|line| doc_line(line));
    let listed: Vec<String> = data.iter().map(|parameter| format!("`{}`", parameter.name)).collect();
    let doc = format!(
        " The mean over measurements ({}), by reference or by value; of none it is not a number.",
        listed.join(", ")
    );
    let arguments: Vec<_> = data.iter().map(|parameter| format_ident!("{}", parameter.name)).collect();
    let types: Vec<_> = data.iter().map(|parameter| type_of(quote!(f64), &parameter.shape, false)).collect();
    let kinds: Vec<_> = (1..=types.len()).map(|at| format_ident!("T{at}")).collect();
    let (item, pattern) = match (&kinds[..], &arguments[..]) {
        ([kind], [argument]) => (quote!(#kind), quote!(#argument)),
        _ => (quote!((#(#kinds),*)), quote!((#(#arguments),*))),
    };
    let mut names = Names::of(data);
    let [measurements, means, count, values] =
        ["measurements", "means", "count", "values"].map(|name| names.take(name));
    let slices = data.iter().zip(&arguments).map(|(parameter, argument)| match parameter.shape.is_empty() {
        true => quote!(&[*#argument]),
        false => as_slice(parameter),
    });
    let ty = type_of(quote!(f64), shape, false);
    let zero = shape.iter().rev().fold(quote!(0.0), |inner, &length| {
        let length = Literal::usize_unsuffixed(length);
        quote!([#inner; #length])
    });
    let all = match shape.len().checked_sub(1) {
        None => quote!(::core::iter::once(&mut #means)),
        Some(inner) => {
            let flatten = (0..inner).map(|_| quote!(.flatten()));
            quote!(#means.iter_mut() #(#flatten)*)
        }
    };
    quote! {
        #(#[doc = #docs])*
        #[doc = ""]
        #[doc = #doc]
        pub fn #mean<#(#kinds: ::core::borrow::Borrow<#types>),*>(#measurements: impl IntoIterator<Item = #item>) -> #ty {
            let (mut #means, mut #count): (#ty, f64) = (#zero, 0.0);
            for #pattern in #measurements {
                #(let #arguments: &#types = ::core::borrow::Borrow::borrow(&#arguments);)*
                let #values = self::#given(1.0, &emitted::joined(&[#(#slices),*]));
                #all.zip(#values).for_each(|(mean, value)| *mean += value);
                #count += 1.0;
            }
            #all.for_each(|mean| *mean /= #count);
            #means
        }

        #compute
    }
}
