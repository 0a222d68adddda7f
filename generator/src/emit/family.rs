//! Prints a problem as a family over its data, by which solutions are followed from data nearby
//! where a template stands for nothing.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::storage;
use crate::plan::Plan;
use crate::plan::program_table::ProgramTable;
use crate::problem::{DataAttribute, DataParameter};

/// What the data of each parameter satisfy; nothing without data.
pub(super) fn table(plan: &Plan) -> TokenStream {
    if plan.inputs() == 0 {
        return quote!();
    }
    let parameters = plan.data.iter().map(|parameter| {
        let (condition, length) = (condition(parameter), parameter.len() as u32);
        let length = Literal::u32_unsuffixed(length);
        quote!((emitted::Condition::#condition, #length))
    });
    // Derived data are as free as general ones: the path of a solution need not stay where they are
    // derived.
    let derived = (plan.stated - plan.given()) as u32;
    let derived = (derived > 0).then(|| {
        let length = Literal::u32_unsuffixed(derived);
        quote!((emitted::Condition::Free, #length))
    });
    let count = Literal::usize_unsuffixed(plan.data.len() + derived.iter().len());
    quote! {
        /// What the data of each parameter satisfy, and how many there are.
        const PARAMETERS: [(emitted::Condition, u32); #count] = [#(#parameters,)* #derived];
    }
}

fn condition(parameter: &DataParameter) -> TokenStream {
    let [rows, columns] = parameter.last_dimensions().map(Literal::usize_unsuffixed);
    match parameter.attribute {
        DataAttribute::Generic | DataAttribute::Integer => quote!(Free),
        DataAttribute::Symmetric => quote!(Symmetric(#columns)),
        DataAttribute::Unit => quote!(Unit(#columns)),
        DataAttribute::Rotation => quote!(Rotation),
        DataAttribute::Plucker => quote!(Plucker),
        DataAttribute::Rank(_) => quote!(Rank(#rows, #columns)),
    }
}

/// The methods of an instance for it.
pub(super) fn methods(plan: &Plan) -> TokenStream {
    if plan.inputs() == 0 {
        return quote!();
    }
    let counts =
        [ProgramTable::values_of(&plan.program, plan.inputs()), plan.coefficients.len()].map(Literal::usize_unsuffixed);
    let ([values, coefficients], unknowns) = (counts, Literal::usize_unsuffixed(plan.unknowns.len()));
    let workspace = storage::has_coefficients_on_heap(plan).then(|| quote!(let workspace = self.workspace;));
    let forget = storage::has_coefficients_on_heap(plan).then(|| quote!(self.precise.take();));
    let attempts = storage::allowed_attempts(plan);
    let (compute, (_, kept)) = (storage::coefficients_of_data(plan), storage::data(plan));
    let (inputs, stated) = (Literal::usize_unsuffixed(plan.inputs()), Literal::usize_unsuffixed(plan.stated));
    let data = if plan.is_presolved_at_run_time() { quote!(&#kept[..#stated]) } else { quote!(&#kept) };
    quote! {
        fn family(&self) -> Option<emitted::Family<'_>> {
            let is_allowed = #attempts == ::eliminant::SecondAttempts::Always;
            is_allowed.then_some(emitted::Family {
                data: #data,
                inputs: #inputs,
                parameters: &PARAMETERS,
                program: PROGRAM,
                counts: (#values, #coefficients),
                unknowns: #unknowns,
                chain: EQUATIONS.chain,
                ends: EQUATIONS.ends,
                terms: EQUATIONS.terms,
            })
        }

        fn move_to(&mut self, data: &[f64]) {
            emitted::join_into(&[data], &mut #kept);
            let data = &#kept;
            #workspace
            self.coefficients = #compute;
            #forget
        }
    }
}
