//! Prints straight-line code as a table.

use std::collections::BTreeMap;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::code;
use super::listing::Listings;
use super::shapes::doc_line;
use super::storage;
use super::wrap::wrapped;
use crate::plan::Plan;
use crate::plan::program::{Operation, ProgramForm, ValueId};
use crate::plan::program_table::ProgramTable;
use crate::problem::DataParameter;

/// The name of the function that executes the table: where statements compute the coefficients, it
/// is for twice the precision only.
pub(super) fn name_of_table_function(plan: &Plan) -> Ident {
    match plan.program.form {
        ProgramForm::Statements => format_ident!("precise_coefficients"),
        ProgramForm::Table => format_ident!("coefficients"),
    }
}

/// The function from the data to the coefficients, and the table that it executes.
pub(super) fn table(plan: &Plan, listings: &mut Listings) -> TokenStream {
    let table = ProgramTable::of(plan);
    let program = static_program(&format_ident!("PROGRAM"), " From the data to the coefficients.", &table, listings);
    let [inputs, values, length] =
        [plan.inputs(), table.values, plan.coefficients.len()].map(Literal::usize_unsuffixed);
    let is_on_heap = storage::has_coefficients_on_heap(plan);
    let (memory, evaluate) = match (is_on_heap, plan.is_presolved_at_run_time()) {
        (true, true) => (
            quote!(, memory: &'w emitted::Memory),
            quote! {
                let mut data = data.map(R::from_f64);
                self::add_presolved(&mut data);
                PROGRAM.evaluate_on_heap_on((#values, #length), &data, memory)
            },
        ),
        (false, true) => (
            quote!(),
            quote! {
                let mut data = data.map(R::from_f64);
                self::add_presolved(&mut data);
                PROGRAM.evaluate_on::<R, #values, #length>(&data)
            },
        ),
        (true, false) => (
            quote!(, memory: &'w emitted::Memory),
            quote!(PROGRAM.evaluate_on_heap((#values, #length), &[data], memory)),
        ),
        (false, false) => (quote!(), quote!(PROGRAM.evaluate::<R, #values, #length>(&[data]))),
    };
    let ((list, _), lifetime) = (storage::coefficients(plan, &quote!(R)), is_on_heap.then(|| quote!('w,)));
    let (function, names) = (name_of_table_function(plan), names_of_coefficients(plan));
    let names = names.iter().map(|line| doc_line(line));
    quote! {
        /// The coefficients that the tables refer to.
        #(#[doc = #names])*
        fn #function<#lifetime R: emitted::Real>(data: &[f64; #inputs] #memory) -> #list {
            #evaluate
        }

        #program
    }
}

/// A table.
pub(super) fn static_program(name: &Ident, doc: &str, table: &ProgramTable, listings: &mut Listings) -> TokenStream {
    let constants = table.constants.iter().map(|&value| code::constant(value));
    let operands = listings.add(table.operands.iter().map(|(a, b)| format!("({a}, {b})")));
    let runs = table.runs.iter().map(|&(kind, steps)| {
        let (kind, steps) = (format_ident!("{kind:?}"), Literal::u32_unsuffixed(steps));
        quote!(emitted::Run { operation: emitted::Operation::#kind, steps: #steps })
    });
    let product_sums = product_sums(table, listings);
    let results = listings.add(table.results.iter().map(u32::to_string));
    quote! {
        #[doc = #doc]
        static #name: emitted::Program<'static> = emitted::Program {
            constants: &[#(#constants),*],
            runs: &[#(#runs),*],
            operands: &[#operands],
            product_sums: #product_sums,
            results: &[#results],
        };
    }
}

/// Lines that say which coefficients are data or values with names in the problem.
fn names_of_coefficients(plan: &Plan) -> Vec<String> {
    let inputs: Vec<String> = plan.data.iter().flat_map(DataParameter::names).collect();
    let named: BTreeMap<ValueId, &str> = plan.program.names.iter().map(|(id, name)| (*id, name.as_str())).collect();
    let name = |id: &ValueId| match plan.program.operations[id.0 as usize] {
        Operation::Input(input) => inputs.get(input as usize).map(String::as_str),
        _ => named.get(id).copied(),
    };
    let coefficients = plan.coefficients.iter().enumerate();
    let names = coefficients.filter_map(|(at, id)| Some(format!("{at} is `{}`", name(id)?)));
    let names: Vec<String> = names.collect();
    if names.is_empty() {
        return Vec::new();
    }
    let lines = wrapped(&format!("By name: {}.", names.join(", ")), "");
    std::iter::once(String::new()).chain(lines).collect()
}

/// The sums of products in the order of the code.
fn product_sums(table: &ProgramTable, listings: &mut Listings) -> TokenStream {
    let printed = |lists: &[Vec<u32>]| lists.iter().map(|list| format!("&{list:?}")).collect::<Vec<_>>();
    let factors = listings.add(printed(&table.factors).into_iter());
    let places = listings.add(printed(&table.places).into_iter());
    let sums = listings.add(
        table
            .sums
            .iter()
            .map(|(products, length)| format!("emitted::ProductSum {{ products: {products}, length: {length} }}")),
    );
    let products = listings.add(table.products.iter().map(|product| {
        let (negative, left, right, places) = (product.negative, product.left, product.right, product.places);
        format!("emitted::PolynomialProduct {{ negative: {negative}, left: {left}, right: {right}, places: {places} }}")
    }));
    quote!(emitted::ProductSums {
        sums: &[#sums],
        products: &[#products],
        factors: &[#factors],
        places: &[#places],
    })
}
