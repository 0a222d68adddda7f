//! Prints the tables of the elimination and of the equations.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::listing::Listings;
use crate::plan::system_table::SystemTable;
use crate::plan::{ActionRow, Entry, Plan, Term};

pub(super) fn tables(plan: &Plan, listings: &mut Listings) -> TokenStream {
    let right = entries(&plan.elimination.right, listings);
    let blocks = plan.elimination.blocks.iter().enumerate().map(|(number, block)| {
        let number = Literal::usize_unsuffixed(number);
        let (first, needed) = (Literal::usize_unsuffixed(block.first), Literal::usize_unsuffixed(block.needed));
        let (diagonal, coupling) = (entries(&block.diagonal, listings), entries(&block.coupling, listings));
        quote!(emitted::Block {
            number: #number, first: #first, needed: #needed, diagonal: &[#diagonal], coupling: &[#coupling]
        })
    });
    let blocks: Vec<TokenStream> = blocks.collect();
    let action = listings.add(plan.action.iter().map(|row| match row {
        ActionRow::Unit(b) => format!("emitted::ActionRow::Unit({})", b.0),
        ActionRow::Solved(pivot) => format!("emitted::ActionRow::Solved({})", pivot.0),
    }));
    let [basis, count, count_read] =
        [plan.elimination.basis, plan.elimination.blocks.len(), plan.read.len()].map(Literal::usize_unsuffixed);
    let read = plan.read.iter().map(|pivot| Literal::u16_unsuffixed(pivot.0));
    let read = match plan.read.is_empty() {
        true => quote!(),
        false => quote! {
            /// The pivots that unknowns are read from besides.
            const READ: [u16; #count_read] = [#(#read),*];
        },
    };
    let equations = system(plan, &plan.equations, (quote!(EQUATIONS), " The equations of the problem."), listings);
    let nonzero = match plan.nonzero.is_empty() {
        true => quote!(),
        false => system(plan, &plan.nonzero, (quote!(NONZERO), " What must not vanish."), listings),
    };
    quote! {
        /// Entries of the template in the basis columns.
        const RIGHT: &[emitted::Entry] = &[#right];

        /// The diagonal blocks of the template, in order of solution.
        static BLOCKS: [emitted::Block<'static>; #count] = [#(#blocks),*];

        /// Where the rows of the action matrix come from.
        const ACTION: [emitted::ActionRow; #basis] = [#action];

        #read
        #equations
        #nonzero
    }
}

fn entries(entries: &[Entry], listings: &mut Listings) -> Ident {
    listings.add(entries.iter().map(|entry| format!("({}, {}, {})", entry.row, entry.column, entry.coefficient.0)))
}

/// Polynomials as tables over a chain of monomials.
fn system(
    plan: &Plan,
    polynomials: &[Vec<Term>],
    (name, doc): (TokenStream, &str),
    listings: &mut Listings,
) -> TokenStream {
    let table = SystemTable::of(polynomials, plan.unknowns.len());
    let products = listings.add(
        table
            .chain
            .iter()
            .map(|(parent, unknown)| format!("emitted::Product {{ parent: {parent}, unknown: {unknown} }}")),
    );
    let terms = listings.add(table.terms.iter().map(|(coefficient, monomial)| {
        format!("emitted::Term {{ coefficient: {coefficient}, monomial: {monomial} }}")
    }));
    let ends = table.ends.iter().map(|&end| Literal::u32_unsuffixed(end));
    let [unknowns, count, monomials, coefficients] =
        [plan.unknowns.len(), polynomials.len(), table.chain.len(), plan.coefficients.len()]
            .map(Literal::usize_unsuffixed);
    quote! {
        #[doc = #doc]
        const #name: emitted::FixedTables<#unknowns, #count, #monomials> =
            emitted::Tables::new::<#coefficients>(&[#products], &[#(#ends),*], &[#terms]);
    }
}
