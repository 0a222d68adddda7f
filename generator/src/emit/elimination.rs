//! Prints the fill and the elimination of the template.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::listing::Listings;
use super::provenance::Provenance;
use super::{program, storage};
use crate::plan::{Entry, Plan};

/// A template of more entries than this is filled from tables, which takes about nine instructions
/// an entry where statements take two.
const MOST_STATEMENTS: usize = 512;

/// Whether entries are written by statements.
pub(super) fn is_filled_by_statements(plan: &Plan) -> bool {
    let elimination = &plan.elimination;
    if plan.is_on_heap() {
        return false;
    }
    let diagonals: usize = elimination.blocks.iter().map(|block| block.diagonal.len()).sum();
    elimination.right.len() + diagonals <= MOST_STATEMENTS && !elimination.blocks.iter().any(|block| block.is_large())
}

/// The coefficients for an elimination in the precision R.
fn coefficients_of_precision(plan: &Plan) -> TokenStream {
    if !plan.has_precise_coefficients() {
        return quote!(let coefficients = &self.coefficients;);
    }
    let function = program::name_of_table_function(plan);
    let (count, (_, data)) = (Literal::usize_unsuffixed(plan.coefficients.len()), storage::data(plan));
    let (size, arguments) = match storage::has_coefficients_on_heap(plan) {
        true => (quote!(emitted::OnHeap<'w, emitted::Fixed<#count>>), quote!(&#data, self.workspace.memory())),
        false => (quote!(emitted::Fixed<#count>), quote!(&#data)),
    };
    quote! {
        let coefficients = &R::of::<#size>(&self.coefficients, || {
            self::#function(#arguments)
        });
    }
}

/// Fill and elimination.
pub(super) fn action_matrix(plan: &Plan) -> TokenStream {
    let (right, memory) = match plan.is_on_heap() {
        true => (quote!(right.as_ref()), quote!(, self.workspace.memory())),
        false => (quote!(&right), quote!()),
    };
    let list =
        if storage::has_coefficients_on_heap(plan) { quote!(coefficients.as_ref()) } else { quote!(coefficients) };
    let (basis_type, basis_size) = storage::basis(plan);
    let [basis, count_read] = [plan.elimination.basis, plan.read.len()].map(Literal::usize_unsuffixed);
    let coefficients = coefficients_of_precision(plan);
    let precision = if plan.has_precise_coefficients() { quote!(R) } else { quote!(f64) };
    let read = match plan.read.is_empty() {
        true => quote!(),
        false => quote! {
            self.read = emitted::solved_rows(
                (emitted::Fixed::<#count_read>, emitted::Fixed::<#basis>),
                &READ,
                #right,
            );
        },
    };
    quote! {
        fn action_matrix<R: emitted::Real>(
            &mut self,
        ) -> Result<emitted::Square<#basis_type, R>, ::eliminant::SolveError> {
            #coefficients
            let right = self::eliminated::<#precision, R>(R::ZERO, #list #memory)?;
            #read
            Ok(emitted::action_matrix(#basis_size, &ACTION, #right))
        }
    }
}

/// The function from the coefficients to the basis columns of the solved template.
pub(super) fn eliminated(plan: &Plan, provenance: &Provenance, listings: &mut Listings) -> TokenStream {
    let [rows, basis, count] =
        [plan.elimination.rows, plan.elimination.basis, plan.coefficients.len()].map(Literal::usize_unsuffixed);
    let (fill, blocks) = match is_filled_by_statements(plan) {
        true => by_statements(plan, provenance, listings),
        false => by_tables(plan),
    };
    let kind = if is_filled_by_statements(plan) { quote!(Eliminated) } else { quote!(Real) };
    if plan.is_on_heap() {
        return quote! {
            /// The basis columns of the solved template, on the heap. `zero` is 0.
            fn eliminated<'w, C: Copy, T: emitted::Real + emitted::Over<C>>(
                zero: T,
                coefficients: &[C],
                memory: &'w emitted::Memory,
            ) -> Result<emitted::HeapRows<'w, [T; #basis]>, ::eliminant::SolveError> {
                let mut right = memory.filled(#rows, [zero; #basis]);
                #fill
                #blocks
                Ok(right)
            }
        };
    }
    quote! {
        /// The basis columns of the solved template. `zero` is 0.
        #[inline(always)]
        fn eliminated<C: Copy, T: emitted::#kind + emitted::Over<C>>(
            zero: T,
            coefficients: &[C; #count],
        ) -> Result<[[T; #basis]; #rows], ::eliminant::SolveError> {
            let mut right = [[zero; #basis]; #rows];
            #fill
            #blocks
            Ok(right)
        }
    }
}

/// The fill of the basis columns, and the elimination of all blocks.
fn by_tables(plan: &Plan) -> (TokenStream, TokenStream) {
    let right = if plan.is_on_heap() { quote!(right.as_mut()) } else { quote!(&mut right) };
    let blocks = plan.elimination.blocks.iter().enumerate().map(|(at, block)| {
        let (at, size) = (Literal::usize_unsuffixed(at), Literal::usize_unsuffixed(block.size));
        match (block.is_large(), plan.is_on_heap()) {
            (true, true) => {
                quote!(BLOCKS[#at].eliminate_on_heap::<T, C, _>(#size, #right, coefficients, memory)?;)
            }
            (true, false) => quote!(BLOCKS[#at].eliminate_large::<T, C, _, #size>(#right, coefficients)?;),
            (false, _) => quote!(BLOCKS[#at].eliminate::<T, C, _, #size>(#right, coefficients)?;),
        }
    });
    let blocks = quote!(#(#blocks)*);
    (quote!(emitted::fill::<T, C, _>(#right, RIGHT, coefficients);), blocks)
}

/// The same with a statement for each entry.
fn by_statements(plan: &Plan, provenance: &Provenance, listings: &mut Listings) -> (TokenStream, TokenStream) {
    let right = listings.add_labelled(entries(&plan.elimination.right, 0, provenance, &provenance.basis));
    let blocks = plan.elimination.blocks.iter().enumerate().map(|(at, block)| {
        let columns = provenance.pivots.get(block.first..block.first + block.size).unwrap_or_default();
        let diagonal = listings.add_labelled(entries(&block.diagonal, block.first, provenance, columns));
        let matrix = format_ident!("block_{at}");
        let (at, size) = (Literal::usize_unsuffixed(at), Literal::usize_unsuffixed(block.size));
        quote! {
            let mut #matrix = [[zero; #size]; #size];
            emitted::fill_entries!(#matrix, coefficients, [#diagonal]);
            BLOCKS[#at].eliminate_filled::<T, C, _, #size>(&mut #matrix, &mut right, coefficients)?;
        }
    });
    let blocks = quote!(#(#blocks)*);
    (quote!(emitted::fill_entries!(right, coefficients, [#right]);), blocks)
}

/// Entries row by row, each row with its label, the first also with the monomials of the columns.
pub(super) fn entries(
    entries: &[Entry],
    first: usize,
    provenance: &Provenance,
    columns: &[String],
) -> Vec<(String, Vec<String>)> {
    let group = |row: &[Entry]| {
        let at = first + usize::from(row[0].row);
        let label = format!("row {at}: {}", provenance.rows.get(at).map_or("", String::as_str));
        let entry = |entry: &Entry| format!("({}, {}, {})", entry.row, entry.column, entry.coefficient.0);
        (label, row.iter().map(entry).collect())
    };
    let mut groups: Vec<(String, Vec<String>)> = entries.chunk_by(|a, b| a.row == b.row).map(group).collect();
    if let (Some((label, _)), false) = (groups.first_mut(), columns.is_empty()) {
        *label = format!("columns {}\n{label}", columns.join(", "));
    }
    groups
}
