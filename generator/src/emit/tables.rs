//! Prints the tables of the elimination and of the equations.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::elimination::{entries, is_filled_by_statements};
use super::listing::Listings;
use super::monomials;
use super::provenance::Provenance;
use crate::plan::system_table::SystemTable;
use crate::plan::{ActionRow, Plan, Term};

/// The tables. Rows and equations have labels as comments.
pub(super) fn tables(plan: &Plan, provenance: &Provenance, listings: &mut Listings) -> TokenStream {
    let by_statements = is_filled_by_statements(plan);
    let right = match by_statements {
        true => quote!(),
        false => {
            let right = listings.add_labelled(entries(&plan.elimination.right, 0, provenance, &provenance.basis));
            quote! {
                /// Entries of the template in the basis columns: row, column, coefficient.
                const RIGHT: &[emitted::Entry] = &[#right];
            }
        }
    };
    let blocks = plan.elimination.blocks.iter().enumerate().map(|(number, block)| {
        let number = Literal::usize_unsuffixed(number);
        let (first, needed) = (Literal::usize_unsuffixed(block.first), Literal::usize_unsuffixed(block.needed));
        let columns = provenance.pivots.get(block.first..block.first + block.size).unwrap_or_default();
        let diagonal = match by_statements {
            true => listings.add_labelled(Vec::new()),
            false => listings.add_labelled(entries(&block.diagonal, block.first, provenance, columns)),
        };
        let coupling = listings.add_labelled(entries(&block.coupling, block.first, provenance, &[]));
        quote!(emitted::Block {
            number: #number, first: #first, needed: #needed, diagonal: &[#diagonal], coupling: &[#coupling]
        })
    });
    let blocks: Vec<TokenStream> = blocks.collect();
    let action = plan.action.iter().map(|row| match row {
        ActionRow::Unit(b) => format!("emitted::ActionRow::Unit({})", b.0),
        ActionRow::Solved(pivot) => format!("emitted::ActionRow::Solved({})", pivot.0),
    });
    let label = format!("the action monomial times {}", provenance.basis.join(", "));
    let action = listings.add_labelled(vec![(label, action.collect())]);
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
    let equations = equations(plan, provenance, listings);
    quote! {
        #right

        /// The diagonal blocks of the template, in order of solution.
        static BLOCKS: [emitted::Block<'static>; #count] = [#(#blocks),*];

        /// Where the rows of the action matrix come from.
        const ACTION: [emitted::ActionRow; #basis] = [#action];

        #read
        #equations
    }
}

/// The equations, and what must not vanish.
fn equations(plan: &Plan, provenance: &Provenance, listings: &mut Listings) -> TokenStream {
    let labels = (1..).zip(&provenance.equations);
    let labels = labels.map(|(number, text)| format!("equation {number}: {text}")).collect();
    let name = (quote!(EQUATIONS), " The equations of the problem.");
    let equations = system(plan, &plan.equations, labels, name, listings);
    let monomials = monomials::are_statements(plan).then(|| monomials::monomials(plan));
    let nonzero = match plan.nonzero.is_empty() {
        true => quote!(),
        false => {
            let name = (quote!(NONZERO), " What must not vanish.");
            system(plan, &plan.nonzero, provenance.nonzero.clone(), name, listings)
        }
    };
    quote! {
        #equations
        #monomials
        #nonzero
    }
}

/// Polynomials as tables over a chain of monomials, each polynomial with its label.
fn system(
    plan: &Plan,
    polynomials: &[Vec<Term>],
    labels: Vec<String>,
    (name, doc): (TokenStream, &str),
    listings: &mut Listings,
) -> TokenStream {
    let table = SystemTable::of(polynomials, plan.unknowns.len());
    let products = table.chain.iter();
    let products =
        products.map(|(parent, unknown)| format!("emitted::Product {{ parent: {parent}, unknown: {unknown} }}"));
    let monomials = table.monomials().into_iter();
    let monomials: Vec<String> = monomials.map(|m| m.display(&plan.unknowns).to_string()).collect();
    let label = format!("monomials {}", monomials.join(", "));
    let products = listings.add_labelled(vec![(label, products.collect())]);
    let starts = std::iter::once(&0).chain(&table.ends);
    let terms = labels.into_iter().zip(starts).zip(&table.ends).map(|((label, &start), &end)| {
        let terms = table.terms[start as usize..end as usize].iter();
        let terms = terms.map(|(coefficient, monomial)| {
            format!("emitted::Term {{ coefficient: {coefficient}, monomial: {monomial} }}")
        });
        (label, terms.collect())
    });
    let terms = listings.add_labelled(terms.collect());
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
