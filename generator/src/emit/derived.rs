//! Prints how data are derived from data before a solve.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::code;
use crate::expression::derivation::DerivationKind;
use crate::plan::{LEAST_PIVOT_OF_PRESOLVE, Plan, PlannedDerivation};

/// Whether the problem derives data.
pub(super) fn is_derived(plan: &Plan) -> bool {
    plan.derived_by(false).next().is_some()
}

/// The data of the problem as one array, from a list of those that are `given`. There is room for
/// those that presolve derives.
pub(super) fn joined(plan: &Plan, given: &Ident) -> TokenStream {
    if is_derived(plan) { quote!(self::derived(&#given)?) } else { quote!(emitted::joined(&#given)) }
}

/// The functions that derive data, and the functions that compute what they are derived from.
pub(super) fn functions(plan: &Plan) -> TokenStream {
    let inputs = Literal::usize_unsuffixed(plan.inputs());
    let operands = plan.derived.iter().enumerate().map(|(number, PlannedDerivation { derivation, program })| {
        code::function(plan, (&name(number), " What data are derived from."), program, &derivation.operands)
    });
    let derived = is_derived(plan).then(|| {
        let steps = steps(plan, false);
        quote! {
            /// All data of the problem: those that are given, one parameter after another, and
            /// those that are derived from them.
            fn derived(given: &[&[f64]]) -> Result<[f64; #inputs], ::eliminant::SolveError> {
                let mut data = emitted::joined(given);
                emitted::check_coefficients(&[], given)?;
                #steps
                Ok(data)
            }
        }
    });
    let presolved = plan.is_presolved_at_run_time().then(|| {
        let (steps, first) = (steps(plan, true), Literal::usize_unsuffixed(plan.stated));
        quote! {
            /// Adds what presolve derives: equations that are solved for some of their monomials.
            /// Where that fails it is NaN, so that the template is singular.
            fn add_presolved<R: emitted::Real>(data: &mut [R; #inputs]) {
                let derive = |data: &mut [R; #inputs]| {
                    #steps
                    Ok::<(), ::eliminant::SolveError>(())
                };
                if derive(data).is_err() {
                    data[#first..].fill(R::from_f64(f64::NAN));
                }
            }
        }
    });
    quote!(#(#operands)* #derived #presolved)
}

/// The function that computes the operands of a derivation.
fn name(number: usize) -> Ident {
    format_ident!("operands_of_derived_{number}")
}

/// The derivations of the problem, or those of presolve.
fn steps(plan: &Plan, presolve: bool) -> TokenStream {
    let steps = plan.derived_by(presolve).map(|(number, PlannedDerivation { derivation, .. })| {
        let (operands, range) = (name(number), derivation.inputs());
        let [first, end] = [range.start, range.end].map(Literal::usize_unsuffixed);
        let least = Literal::f64_unsuffixed(if presolve { LEAST_PIVOT_OF_PRESOLVE } else { 0.0 });
        let (function, size, least) = match derivation.kind {
            DerivationKind::SquareRoot => {
                return quote!(emitted::square_root(&self::#operands(1.0, &data), &mut data[#first..#end])?;);
            }
            DerivationKind::Solve { size, .. } => (quote!(solve_linear), size, quote!(#least,)),
            DerivationKind::NullSpace { rows, .. } => (quote!(null_space), rows, quote!()),
        };
        let size = Literal::usize_unsuffixed(size);
        // Those of presolve are added to data that are borrowed, in any precision.
        let (one, data) = if presolve { (quote!(R::ONE), quote!(data)) } else { (quote!(1.0), quote!(&data)) };
        quote!(emitted::#function(&mut self::#operands(#one, #data), #size, #least &mut data[#first..#end])?;)
    });
    quote!(#(#steps)*)
}
