//! Prints straight-line code as a table.

use std::collections::BTreeMap;

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::code;
use super::listing::Listings;
use crate::plan::Plan;
use crate::plan::code::{Code, Operation, ValueId};
use crate::problem::DataParameter;

/// The function from the data to the coefficients, and the table that it executes.
///
/// The run-time library keeps all data behind the constants, also those that no step reads.
pub(super) fn table(plan: &Plan, listings: &mut Listings) -> TokenStream {
    let code = &plan.code;
    let steps = code.operations.iter().filter(|operation| operation.is_step()).count();
    let constants: Vec<TokenStream> = code.operations.iter().filter_map(as_constant).collect();
    let inputs: usize = plan.data.iter().map(DataParameter::len).sum();
    let positions = positions(plan, constants.len(), inputs);
    let position = |id: ValueId| positions[id.0 as usize];
    let scalar = |operation: &&Operation| !matches!(operation, Operation::Coefficient { .. });
    let operands = listings.add(code.operations.iter().filter(scalar).filter_map(|&operation| {
        let mut operands = code.operands(operation);
        let a = operands.next()?;
        let (a, b) = (position(a), position(operands.next().unwrap_or(a)));
        Some(format!("({a}, {b})"))
    }));
    let runs = runs(code).into_iter().map(|(operation, steps)| {
        let (operation, steps) = (format_ident!("{operation}"), Literal::usize_unsuffixed(steps));
        quote!(eliminant::Run { operation: eliminant::Operation::#operation, steps: #steps })
    });
    let product_sums = product_sums(code, &positions, listings);
    let results = listings.add(plan.coefficients.iter().map(|&id| position(id).to_string()));
    let (values, length) = (constants.len() + inputs + steps, plan.coefficients.len());
    quote! {
        /// The coefficients that the tables refer to.
        fn coefficients<R: eliminant::Real>(data: &[f64; #inputs]) -> [R; #length] {
            PROGRAM.evaluate::<R, #values, #length>(&[data])
        }

        /// From the data to the coefficients.
        static PROGRAM: eliminant::Program = eliminant::Program {
            constants: &[#(#constants),*],
            runs: &[#(#runs),*],
            operands: &[#operands],
            product_sums: #product_sums,
            results: &[#results],
        };
    }
}

/// The sums of products in the order of the code. Equal lists of factors, and of places, are printed once.
fn product_sums(code: &Code, positions: &[usize], listings: &mut Listings) -> TokenStream {
    let (mut factors, mut places) = (Lists::default(), Lists::default());
    let (mut sums, mut products) = (Vec::new(), Vec::new());
    for operation in &code.operations {
        let Operation::Coefficient { sum, at: 0 } = *operation else { continue };
        let of_sum = &code.product_sums[sum as usize];
        for product in &of_sum.products {
            let mut factor = |ids: &[ValueId]| factors.number(ids.iter().map(|id| positions[id.0 as usize]).collect());
            let (left, right) = (factor(&product.left), factor(&product.right));
            let places = places.number(product.to.iter().map(|&to| to as usize).collect());
            let negative = product.negative;
            products.push(format!(
                "eliminant::PolynomialProduct {{ negative: {negative}, left: {left}, right: {right}, places: {places} }}"
            ));
        }
        let (count, length) = (of_sum.products.len(), of_sum.length);
        sums.push(format!("eliminant::ProductSum {{ products: {count}, length: {length} }}"));
    }
    let (factors, places) = (listings.add(factors.printed()), listings.add(places.printed()));
    let (sums, products) = (listings.add(sums.into_iter()), listings.add(products.into_iter()));
    quote!(eliminant::ProductSums {
        sums: &[#sums],
        products: &[#products],
        factors: &[#factors],
        places: &[#places],
    })
}

/// Different lists of numbers, each printed once.
#[derive(Default)]
struct Lists {
    numbers: BTreeMap<Vec<usize>, usize>,
}

impl Lists {
    fn number(&mut self, list: Vec<usize>) -> usize {
        let next = self.numbers.len();
        *self.numbers.entry(list).or_insert(next)
    }

    fn printed(self) -> impl Iterator<Item = String> {
        let mut lists: Vec<(usize, Vec<usize>)> =
            self.numbers.into_iter().map(|(list, number)| (number, list)).collect();
        lists.sort_unstable();
        lists.into_iter().map(|(_, list)| format!("&{list:?}"))
    }
}

fn as_constant(operation: &Operation) -> Option<TokenStream> {
    match operation {
        Operation::Constant(value) => Some(code::constant(*value)),
        _ => None,
    }
}

/// Where the table keeps each value of the plan.
fn positions(plan: &Plan, constants: usize, inputs: usize) -> Vec<usize> {
    let (mut next_constant, mut next_step) = (0, constants + inputs);
    let take = |next: &mut usize| {
        *next += 1;
        *next - 1
    };
    let position = |operation: &Operation| match operation {
        Operation::Constant(_) => take(&mut next_constant),
        Operation::Input(input) => constants + *input as usize,
        _ => take(&mut next_step),
    };
    plan.code.operations.iter().map(position).collect()
}

/// Names of operations and numbers of consecutive steps, a sum of products being one; no step reads a result of its own run.
fn runs(code: &Code) -> Vec<(&'static str, usize)> {
    let mut runs: Vec<(&str, usize)> = Vec::new();
    let mut start = 0;
    for (at, &operation) in code.operations.iter().enumerate() {
        let Some(name) = name(operation) else { continue };
        let independent = code.operands(operation).all(|id| (id.0 as usize) < start);
        match runs.last_mut() {
            Some((last, steps)) if *last == name && independent => *steps += 1,
            _ => {
                runs.push((name, 1));
                start = at;
            }
        }
    }
    runs
}

/// The variant of the run-time library's `Operation` that a step is.
fn name(operation: Operation) -> Option<&'static str> {
    Some(match operation {
        // The others of a sum of products are computed with its first.
        Operation::Constant(_) | Operation::Input(_) | Operation::Coefficient { at: 1.., .. } => return None,
        Operation::Add(..) => "Add",
        Operation::Subtract(..) => "Subtract",
        Operation::Multiply(..) => "Multiply",
        Operation::Divide(..) => "Divide",
        Operation::Negate(_) => "Negate",
        Operation::Coefficient { at: 0, .. } => "ProductSum",
    })
}
