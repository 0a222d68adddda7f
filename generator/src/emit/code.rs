//! Prints straight-line code.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::parameter;
use crate::plan::{Operation, Plan, PlannedRecovery, ValueId};
use crate::problem::DataParameter;
use crate::rational::Rational;

/// The function from the data to the coefficients.
pub(super) fn coefficients(plan: &Plan) -> TokenStream {
    let parameters = plan.data.iter().map(parameter);
    let inputs: Vec<TokenStream> = plan.data.iter().flat_map(elements).collect();
    let prefix = value_prefix(plan);
    let operand = |id: &ValueId| match plan.code[id.0 as usize] {
        Operation::Constant(value) => constant(value),
        Operation::Input(input) => inputs[input as usize].clone(),
        _ => {
            let name = format_ident!("{prefix}{}", id.0);
            quote!(#name)
        }
    };
    let steps = plan.code.iter().enumerate().filter_map(|(at, operation)| {
        let name = format_ident!("{prefix}{at}");
        let value = match operation {
            Operation::Constant(_) | Operation::Input(_) => return None,
            Operation::Add(a, b) => binary(operand(a), quote!(+), operand(b)),
            Operation::Subtract(a, b) => binary(operand(a), quote!(-), operand(b)),
            Operation::Multiply(a, b) => binary(operand(a), quote!(*), operand(b)),
            Operation::Divide(a, b) => binary(operand(a), quote!(/), operand(b)),
            Operation::Negate(a) => {
                let a = operand(a);
                quote!(-#a)
            }
        };
        Some(quote!(let #name = #value;))
    });
    let results = plan.coefficients.iter().map(operand);
    let count = plan.coefficients.len();
    quote! {
        /// The coefficients that the tables refer to.
        fn coefficients(#(#parameters),*) -> [f64; #count] {
            #(#steps)*
            [#(#results),*]
        }
    }
}

/// A prefix for the names of intermediate values that no parameter starts with.
fn value_prefix(plan: &Plan) -> String {
    let mut prefix = "v".to_owned();
    while plan.data.iter().any(|parameter| parameter.name.starts_with(&prefix)) {
        prefix.push('_');
    }
    prefix
}

fn binary(a: TokenStream, operator: TokenStream, b: TokenStream) -> TokenStream {
    quote!(#a #operator #b)
}

/// `gram[0][2]` for every scalar of a parameter, in flat order.
fn elements(parameter: &DataParameter) -> Vec<TokenStream> {
    let name = format_ident!("{}", parameter.name);
    let element = |flat: usize| {
        let mut rest = flat;
        let mut indices = Vec::new();
        for &length in parameter.shape.iter().rev() {
            indices.push(rest % length);
            rest /= length;
        }
        let indices = indices.iter().rev().map(|&index| Literal::usize_unsuffixed(index));
        quote!(#name #([#indices])*)
    };
    (0..parameter.len()).map(element).collect()
}

/// A constant in parentheses where it is not a plain positive number; fractions are divided as the interpreter does.
fn constant(value: Rational) -> TokenStream {
    let magnitude = Literal::f64_unsuffixed((value.numerator() as f64).abs());
    let signed = if value.numerator() < 0 { quote!(-#magnitude) } else { quote!(#magnitude) };
    let denominator = Literal::f64_unsuffixed(value.denominator() as f64);
    match (value.denominator(), value.numerator() < 0) {
        (1, false) => signed,
        (1, true) => quote!((#signed)),
        _ => quote!((#signed / #denominator)),
    }
}

/// `x[unknown] = sum of terms`, for real and complex numbers.
pub(super) fn recovery(recovery: &PlannedRecovery) -> TokenStream {
    let unknown = recovery.unknown;
    let terms = recovery.terms.iter().map(|term| {
        let slot = usize::from(term.coefficient.0);
        let factors = term.exponents.iter().enumerate().flat_map(|(at, &e)| (0..e).map(move |_| quote!(* x[#at])));
        quote!(S::from_f64(self.coefficients[#slot]) #(#factors)*)
    });
    if recovery.terms.is_empty() {
        return quote!(x[#unknown] = S::ZERO;);
    }
    quote!(x[#unknown] = #(#terms)+*;)
}
