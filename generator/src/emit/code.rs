//! Prints straight-line code.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::parameter;
use crate::plan::{Operation, Plan, PlannedRecovery, ValueId};
use crate::problem::DataParameter;
use crate::rational::Rational;

/// The function from the data to the coefficients, with a statement for each step. Intermediate values stand in one array: as thousands of variables of their own, each
/// with its debug information, they overflow the stack of the compiler.
pub(super) fn statements(plan: &Plan) -> TokenStream {
    let parameters = plan.data.iter().map(parameter);
    let inputs: Vec<TokenStream> = plan.data.iter().flat_map(elements).collect();
    let values = format_ident!("{}", name_of_values(plan));
    let mut slots = Vec::with_capacity(plan.code.len());
    let mut count = 0usize;
    for operation in &plan.code {
        slots.push(count);
        count += usize::from(operation.is_step());
    }
    let slot = |at: usize| {
        let index = Literal::usize_unsuffixed(slots[at]);
        quote!(#values[#index])
    };
    let operand = |id: &ValueId| match plan.code[id.0 as usize] {
        Operation::Constant(value) => constant(value),
        Operation::Input(input) => inputs[input as usize].clone(),
        _ => slot(id.0 as usize),
    };
    let steps = plan.code.iter().enumerate().filter_map(|(at, operation)| {
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
        let target = slot(at);
        Some(quote!(#target = #value;))
    });
    let declaration = match count {
        0 => quote!(),
        _ => quote!(let mut #values = [0.0; #count];),
    };
    let results = plan.coefficients.iter().map(operand);
    let length = plan.coefficients.len();
    quote! {
        /// The coefficients that the tables refer to.
        fn coefficients(#(#parameters),*) -> [f64; #length] {
            #declaration
            #(#steps)*
            [#(#results),*]
        }
    }
}

/// A name for the intermediate values that no parameter has.
fn name_of_values(plan: &Plan) -> String {
    let mut name = "v".to_owned();
    while plan.data.iter().any(|parameter| parameter.name == name) {
        name.push('_');
    }
    name
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
pub(super) fn constant(value: Rational) -> TokenStream {
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
