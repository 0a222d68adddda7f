//! Prints the equations as they are evaluated for the polish and the residual.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::storage;
use crate::plan::Plan;
use crate::plan::system_table::SystemTable;

/// Monomials of more values and derivatives than this are computed from tables.
const MOST_STATEMENTS: usize = 600;

fn table(plan: &Plan) -> SystemTable {
    SystemTable::of(&plan.equations, plan.unknowns.len())
}

/// Whether values and derivatives of monomials are emitted as statements. This serves equations
/// that are stored as a matrix.
pub(super) fn are_statements(plan: &Plan) -> bool {
    let table = table(plan);
    let derivatives: usize = table.monomials().iter().map(|m| involved(plan, m).count()).sum();
    table.is_dense() && table.chain.len() + derivatives <= MOST_STATEMENTS
}

/// The unknowns in a monomial.
fn involved(plan: &Plan, monomial: &crate::algebra::Monomial) -> impl Iterator<Item = usize> {
    let monomial = *monomial;
    (0..plan.unknowns.len()).filter(move |&unknown| monomial.exponent(unknown) > 0)
}

/// The system of equations of an instance, and the statement that comes before it in a function
/// that returns a residual.
pub(super) fn system(plan: &Plan) -> (TokenStream, TokenStream) {
    let table = table(plan);
    let coefficients = storage::coefficients_of_instance(plan);
    if !table.is_dense() {
        return (quote!(), quote!(EQUATIONS.bind(#coefficients)));
    }
    let [unknowns, equations, monomials] =
        [plan.unknowns.len(), table.ends.len(), table.chain.len()].map(Literal::usize_unsuffixed);
    let source = if are_statements(plan) { quote!(Monomials) } else { quote!(EQUATIONS) };
    // A list on the heap is as long as its plan says, but the compiler does not know.
    let (before, rows) = match storage::has_coefficients_on_heap(plan) {
        true => (
            quote! {
                let Some(rows) = emitted::rows_of::<#equations, #monomials>(#coefficients) else {
                    return f64::INFINITY;
                };
            },
            quote!(rows),
        ),
        false => (quote!(), quote!(rows: emitted::rows::<#equations, #monomials, _, _>(#coefficients))),
    };
    let system = quote! {
        emitted::DenseSystem {
            sizes: (emitted::Fixed::<#unknowns>, emitted::Fixed::<#equations>, emitted::Fixed::<#monomials>),
            monomials: #source,
            #rows,
        }
    };
    (before, system)
}

/// Values and derivatives of the monomials. Each is an earlier one times an unknown, and
/// derivatives follow by the product rule, without the terms that are zero.
pub(super) fn monomials(plan: &Plan) -> TokenStream {
    let table = table(plan);
    let monomials = table.monomials();
    let (mut values, mut derivatives) = (Vec::new(), Vec::new());
    let mut visits = vec![Vec::new(); plan.unknowns.len()];
    for (k, (monomial, &(parent, unknown))) in monomials.iter().zip(&table.chain).enumerate().skip(1) {
        let (own, parent_monomial) = (Literal::usize_unsuffixed(k), &monomials[usize::from(parent)]);
        let factor = usize::from(unknown);
        let [before, by] = [usize::from(parent), factor].map(Literal::usize_unsuffixed);
        values.push(match parent {
            0 => quote!(m[#own] = x[#by];),
            _ => quote!(m[#own] = m[#before] * x[#by];),
        });
        for j in involved(plan, monomial) {
            let at = Literal::usize_unsuffixed(j);
            let value = match (parent_monomial.exponent(j) > 0, j == factor) {
                (false, _) => quote!(m[#before]),
                (true, false) => quote!(d[#before][#at] * x[#by]),
                (true, true) => quote!(d[#before][#at] * x[#by] + m[#before]),
            };
            derivatives.push(quote!(d[#own][#at] = #value;));
            visits[j].insert(0, quote!((#own, d[#own][#at])));
        }
    }
    let [unknowns, count] = [plan.unknowns.len(), monomials.len()].map(Literal::usize_unsuffixed);
    // One list serves all unknowns: a list for each would take stack where nothing is optimised.
    let most = Literal::usize_unsuffixed(visits.iter().map(Vec::len).max().unwrap_or(0));
    let visits = visits.iter().enumerate().map(|(j, terms)| {
        let [j, count] = [j, terms.len()].map(Literal::usize_unsuffixed);
        let places = (0..terms.len()).map(Literal::usize_unsuffixed);
        quote! {
            #(terms[#places] = #terms;)*
            visit(#j, &terms[..#count]);
        }
    });
    let names: Vec<String> = monomials.iter().map(|m| m.display(&plan.unknowns).to_string()).collect();
    let doc = format!(" The monomials {}.", names.join(", "));
    quote! {
        #[doc = #doc]
        struct Monomials;

        impl emitted::Monomials<emitted::Fixed<#unknowns>, emitted::Fixed<#count>> for Monomials {
            #[inline(always)]
            fn products<T: emitted::Arithmetic>(&self, x: &[T; #unknowns]) -> [T; #count] {
                let mut m = [x[0].constant(1.0); #count];
                #(#values)*
                m
            }

            #[inline(always)]
            fn for_each_gradient<T: emitted::Arithmetic>(
                &self,
                x: &[T; #unknowns],
                m: &[T; #count],
                mut visit: impl FnMut(usize, &[(u16, T)]),
            ) {
                let mut d = [[x[0].constant(0.0); #unknowns]; #count];
                #(#derivatives)*
                let mut terms = [(0, d[0][0]); #most];
                #(#visits)*
            }
        }
    }
}
