//! Prints straight-line code as a table.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::code;
use crate::plan::{Operation, Plan, ValueId};
use crate::problem::DataParameter;

/// The function from the data to the coefficients, and the table that it executes.
///
/// The run-time library keeps all data behind the constants, also those that no step reads.
pub(super) fn table(plan: &Plan) -> TokenStream {
    let steps = plan.code.iter().filter(|operation| operation.is_step()).count();
    let constants: Vec<TokenStream> = plan.code.iter().filter_map(as_constant).collect();
    let inputs: usize = plan.data.iter().map(DataParameter::len).sum();
    let positions = positions(plan, constants.len(), inputs);
    let position = |id: ValueId| Literal::usize_unsuffixed(positions[id.0 as usize]);
    let operands = plan.code.iter().filter_map(|operation| {
        let (a, b) = match operation.operands() {
            [Some(a), b] => (position(a), position(b.unwrap_or(a))),
            _ => return None,
        };
        Some(quote!((#a, #b)))
    });
    let runs = runs(&plan.code).into_iter().map(|(operation, steps)| {
        let (operation, steps) = (format_ident!("{operation}"), Literal::usize_unsuffixed(steps));
        quote!(eliminant::Run { operation: eliminant::Operation::#operation, steps: #steps })
    });
    let results = plan.coefficients.iter().map(|&id| position(id));
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
            operands: &[#(#operands),*],
            results: &[#(#results),*],
        };
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
    plan.code.iter().map(position).collect()
}

/// Names of operations and numbers of consecutive steps; no step reads a result of its own run.
fn runs(code: &[Operation]) -> Vec<(&'static str, usize)> {
    let mut runs: Vec<(&str, usize)> = Vec::new();
    let mut start = 0;
    for (at, operation) in code.iter().enumerate() {
        let Some(name) = name(*operation) else { continue };
        let independent = operation.operands().iter().flatten().all(|id| (id.0 as usize) < start);
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
        Operation::Constant(_) | Operation::Input(_) => return None,
        Operation::Add(..) => "Add",
        Operation::Subtract(..) => "Subtract",
        Operation::Multiply(..) => "Multiply",
        Operation::Divide(..) => "Divide",
        Operation::Negate(_) => "Negate",
    })
}
