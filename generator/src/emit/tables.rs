//! Prints the tables of the elimination and of the equations.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::listing::Listings;
use super::runtime;
use crate::plan::{ActionRow, Entry, Plan, Term};

/// The tables, and the types of their entries.
pub(super) fn tables(plan: &Plan, listings: &mut Listings) -> TokenStream {
    let runtime = runtime();
    let right = entries(&plan.elimination.right, listings);
    let blocks = plan.elimination.blocks.iter().map(|block| {
        let (first, needed) = (Literal::usize_unsuffixed(block.first), Literal::usize_unsuffixed(block.needed));
        let (diagonal, coupling) = (entries(&block.diagonal, listings), entries(&block.coupling, listings));
        quote!(Block { first: #first, needed: #needed, diagonal: &[#diagonal], coupling: &[#coupling] })
    });
    let blocks: Vec<TokenStream> = blocks.collect();
    let count = plan.elimination.blocks.len();
    let action = listings.add(plan.action.iter().map(|row| match row {
        ActionRow::Unit(b) => format!("ActionRow::Unit({})", b.0),
        ActionRow::Solved(pivot) => format!("ActionRow::Solved({})", pivot.0),
    }));
    let (basis, count_read) = (plan.elimination.basis, plan.read.len());
    let read = plan.read.iter().map(|pivot| Literal::u16_unsuffixed(pivot.0));
    let read = match count_read {
        0 => quote!(),
        _ => quote! {
            /// The pivots that unknowns are read from besides.
            const READ: [u16; #count_read] = [#(#read),*];
        },
    };
    let equations = system(plan, &plan.equations, quote!(EQUATIONS), " The equations of the problem.", listings);
    let nonzero = match plan.nonzero.is_empty() {
        true => quote!(),
        false => system(plan, &plan.nonzero, quote!(NONZERO), " What must not vanish.", listings),
    };
    quote! {
        use #runtime::{ActionRow, Block, Entry, Product, Tables, Term};

        /// Entries of the template in the basis columns.
        const RIGHT: &[Entry] = &[#right];

        /// The diagonal blocks of the template, in order of solution.
        static BLOCKS: [Block; #count] = [#(#blocks),*];

        /// Where the rows of the action matrix come from.
        const ACTION: [ActionRow; #basis] = [#action];

        #read
        #equations
        #nonzero
    }
}

fn entries(entries: &[Entry], listings: &mut Listings) -> Ident {
    listings.add(entries.iter().map(|entry| format!("({}, {}, {})", entry.row, entry.column, entry.coefficient.0)))
}

/// Polynomials as tables over a chain of monomials, each an earlier one times an unknown.
fn system(
    plan: &Plan,
    polynomials: &[Vec<Term>],
    name: TokenStream,
    doc: &str,
    listings: &mut Listings,
) -> TokenStream {
    let chain = Chain::of(polynomials, plan.unknowns.len());
    let products = listings.add(
        chain.products.iter().map(|(parent, unknown)| format!("Product {{ parent: {parent}, unknown: {unknown} }}")),
    );
    let terms = listings.add(polynomials.iter().flatten().map(|term| {
        let (coefficient, monomial) = (term.coefficient.0, chain.position(&term.exponents));
        format!("Term {{ coefficient: {coefficient}, monomial: {monomial} }}")
    }));
    let ends = polynomials.iter().scan(0, |end, polynomial| {
        *end += polynomial.len();
        Some(Literal::usize_unsuffixed(*end))
    });
    let (unknowns, count) = (plan.unknowns.len(), polynomials.len());
    let (monomials, coefficients) = (chain.products.len(), plan.coefficients.len());
    quote! {
        #[doc = #doc]
        const #name: Tables<#unknowns, #count, #monomials, #coefficients> =
            Tables::new(&[#products], &[#(#ends),*], &[#terms]);
    }
}

/// All monomials of some polynomials and the intermediate products that lead to them; the first is 1.
struct Chain {
    /// Sorted by degree, then exponents.
    monomials: Vec<Vec<u8>>,
    /// (position of an earlier monomial, unknown) for each.
    products: Vec<(usize, usize)>,
}

impl Chain {
    fn of(polynomials: &[Vec<Term>], unknowns: usize) -> Self {
        let mut monomials: Vec<Vec<u8>> = polynomials.iter().flatten().map(|term| term.exponents.clone()).collect();
        monomials.push(vec![0; unknowns]);
        let mut at = 0;
        while at < monomials.len() {
            if let Some((parent, _)) = parent(&monomials[at])
                && !monomials.contains(&parent)
            {
                monomials.push(parent);
            }
            at += 1;
        }
        monomials.sort_unstable_by_key(|m| (m.iter().map(|&e| u32::from(e)).sum::<u32>(), m.clone()));
        monomials.dedup();
        let find = |monomial: &[u8]| monomials.iter().position(|m| m == monomial).unwrap_or(0);
        let product = |m: &Vec<u8>| parent(m).map_or((0, 0), |(parent, unknown)| (find(&parent), unknown));
        let products = monomials.iter().map(product).collect();
        Self { monomials, products }
    }

    fn position(&self, monomial: &[u8]) -> usize {
        self.monomials.iter().position(|m| m == monomial).unwrap_or(0)
    }
}

/// The monomial divided by its last unknown, and that unknown; `None` for 1.
fn parent(monomial: &[u8]) -> Option<(Vec<u8>, usize)> {
    let unknown = monomial.iter().rposition(|&e| e > 0)?;
    let mut parent = monomial.to_vec();
    parent[unknown] -= 1;
    Some((parent, unknown))
}
