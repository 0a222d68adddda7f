//! Prints the units in which a template is accurate, where the problem has some.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::derived::{self, Reader};
use super::names::Names;
use super::shapes::{as_slice, parameter};
use super::storage;
use crate::plan::Plan;

/// Whether data and unknowns have units.
pub(super) fn has_units(plan: &Plan) -> bool {
    !plan.scalings.is_empty()
}

/// The table of weights; nothing without units.
pub(super) fn table(plan: &Plan) -> TokenStream {
    if !has_units(plan) {
        return quote!();
    }
    let count = Literal::usize_unsuffixed(plan.scalings.len());
    let [data, unknowns] = [plan.weights_of_data(), plan.weights_of_unknowns()].map(|weights| {
        let weights = weights.into_iter().map(Literal::i8_unsuffixed);
        quote!(&[#(#weights),*])
    });
    quote! {
        /// The scalings under which the problem stays the same: a weight per scaling for each datum
        /// and for each unknown.
        const SCALINGS: emitted::Scalings<'static> =
            emitted::Scalings { count: #count, data: #data, unknowns: #unknowns };
    }
}

/// A field of the instance for the units.
pub(super) fn field(plan: &Plan) -> (TokenStream, TokenStream) {
    let unknowns = Literal::usize_unsuffixed(plan.unknowns.len());
    let field = quote! {
        /// Exponents of the powers of two by which unknowns exceed those of the given data.
        exponents: [i16; #unknowns],
    };
    if has_units(plan) { (field, quote!(exponents,)) } else { (quote!(), quote!()) }
}

/// How instances are made: `new` in the units of the data, and `scaled` in those in which data that
/// are far from 1 are about 1. `value` is the instance with these coefficients of `data`.
pub(super) fn constructors(plan: &Plan, value: &TokenStream) -> TokenStream {
    let parameters: Vec<_> = plan.data.iter().map(parameter).collect();
    let slices: Vec<_> = plan.data.iter().map(as_slice).collect();
    let mut names = Names::of(&plan.data);
    let [given, data] = ["given", "data"].map(|name| names.take(name));
    let (storage, storage_type) = storage::field(plan);
    let kept = names.take("kept");
    let coefficients = match storage::has_coefficients_on_heap(plan) {
        true => quote!(instance.coefficients.as_ref()),
        false => quote!(&instance.coefficients),
    };
    let [count, inputs, unknowns] =
        [plan.data.len(), plan.inputs(), plan.unknowns.len()].map(Literal::usize_unsuffixed);
    let joined = derived::joined(plan, Reader::Solve, &given);
    let (mut exponents, mut scaled) = (quote!(), quote!());
    let mut no_exponents = quote!();
    if has_units(plan) {
        exponents = quote!(exponents: [i16; #unknowns],);
        no_exponents = quote!([0; #unknowns],);
        scaled = quote! {
            /// In units in which data that are far from 1 are about 1.
            fn scaled(#kept: #storage_type, #(#parameters),*) -> Result<Self, ::eliminant::SolveError> {
                let #given: [&[f64]; #count] = [#(#slices),*];
                let mut #data = #joined;
                let exponents = SCALINGS.apply(&mut #data);
                Self::of(&#given, &#data, exponents, #kept)
            }
        };
    }
    let check = match plan.is_presolved_at_run_time() {
        // Coefficients of a template whose equations cannot be solved for monomials are NaN. The
        // elimination finds out, and a second attempt may do better.
        true => {
            let stated = plan.coefficients_of_statements();
            let stated = stated.iter().map(|id| Literal::usize_unsuffixed(usize::from(id.0)));
            quote! {
                let coefficients = #coefficients;
                emitted::check_coefficients(&[#(coefficients[#stated]),*], given)?;
            }
        }
        false => quote!(emitted::check_coefficients(#coefficients, given)?;),
    };
    quote! {
        fn new(#kept: #storage_type, #(#parameters),*) -> Result<Self, ::eliminant::SolveError> {
            let #given: [&[f64]; #count] = [#(#slices),*];
            Self::of(&#given, &#joined, #no_exponents #kept)
        }

        #scaled

        /// From values of all data, one parameter after another, that were given.
        #[inline]
        fn of(
            given: &[&[f64]; #count],
            data: &[f64; #inputs],
            #exponents
            #storage: #storage_type,
        ) -> Result<Self, ::eliminant::SolveError> {
            let instance = #value;
            #check
            Ok(instance)
        }
    }
}

/// The constructor of instances that are solved.
pub(super) fn constructor(plan: &Plan) -> proc_macro2::Ident {
    format_ident!("{}", if has_units(plan) { "scaled" } else { "new" })
}

/// The function from the points of an instance to solutions.
pub(super) fn to_solution(plan: &Plan, exponents: &TokenStream) -> TokenStream {
    match has_units(plan) {
        true => quote!(|point| Solution::from_unknowns(emitted::unscaled(#exponents, point))),
        false => quote!(Solution::from_unknowns),
    }
}
