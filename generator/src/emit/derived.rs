//! Prints how data are derived from data before a solve.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::code;
use super::listing::Listings;
use super::program::static_program;
use super::shapes::as_slice;
use crate::expression::derivation::DerivationKind;
use crate::plan::program_table::ProgramTable;
use crate::plan::{LEAST_PIVOT_OF_PRESOLVE, Plan, PlannedDerivation};

/// Who reads derived data.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Reader {
    /// A solve.
    Solve,
    /// What is returned beside the unknowns, which may read what a solve reads, too.
    Results,
    /// The template alone: presolve derives them.
    Template,
}

/// The derivations for this reader, with their numbers.
fn derivations(plan: &Plan, reader: Reader) -> impl Iterator<Item = (usize, &PlannedDerivation)> {
    let has_results = reader == Reader::Results && plan.output.is_some();
    let is_wanted = move |planned: &PlannedDerivation| has_results || !planned.is_for_results;
    plan.derived_by(reader == Reader::Template).filter(move |(_, planned)| is_wanted(planned))
}

/// Whether the problem derives data for a solve.
pub(super) fn is_derived(plan: &Plan) -> bool {
    derivations(plan, Reader::Solve).next().is_some()
}

/// The statements that make a list of the data that are `given` and bind an array of all data of
/// the problem that this reader reads. There is room for those that presolve derives, and for those
/// that this reader does not read. `otherwise` is a call on the result of a derivation that may
/// fail, or nothing.
pub(super) fn all_data(
    plan: &Plan,
    reader: Reader,
    (given, binding): (&Ident, &TokenStream),
    otherwise: &TokenStream,
) -> TokenStream {
    let given_data = given_data(plan, given);
    let joined = match derivations(plan, reader).next() {
        None => quote!(emitted::joined(&#given)),
        Some(_) => {
            let function = format_ident!("{}", function_name(plan, reader));
            quote!(self::#function(&#given) #otherwise?)
        }
    };
    quote! {
        #given_data
        let #binding = #joined;
    }
}

/// The same for a solve, which makes an instance of them. Where there is a heap they are on it.
pub(super) fn data_of_solve(
    plan: &Plan,
    given: &Ident,
    (data, binding): (&Ident, &TokenStream),
    storage: &TokenStream,
) -> TokenStream {
    if !plan.is_on_heap() {
        return all_data(plan, Reader::Solve, (given, binding), &quote!());
    }
    let given_data = given_data(plan, given);
    let joined = match is_derived(plan) {
        true => quote!(self::derived(&#given)),
        false => quote!(Ok(emitted::joined(&#given))),
    };
    quote! {
        #given_data
        let #data = #storage.memory().kept(|| #joined)?;
    }
}

/// The statement that makes a list of the data that are `given`.
fn given_data(plan: &Plan, given: &Ident) -> TokenStream {
    let (slices, count) = (plan.data.iter().map(as_slice), Literal::usize_unsuffixed(plan.data.len()));
    quote!(let #given: [&[f64]; #count] = [#(#slices),*];)
}

/// The statements that make the `data` of results those of a solve: what only results read is 0.
/// Otherwise it would decide how far the data of a solve are from general ones.
pub(super) fn clear_unread(plan: &Plan, data: &Ident) -> TokenStream {
    let unread = plan.derived.iter().filter(|planned| planned.is_for_results);
    let data = if plan.is_on_heap() { quote!(#data[0]) } else { quote!(#data) };
    let statements = unread.map(|planned| {
        let [first, end] = bounds(planned);
        quote!(#data[#first..#end].fill(0.0);)
    });
    quote!(#(#statements)*)
}

/// The name of the function that derives data: results have their own if they read more.
fn function_name(plan: &Plan, reader: Reader) -> &'static str {
    let reads_more = plan.derived.iter().any(|planned| planned.is_for_results);
    if reader == Reader::Results && reads_more { "derived_for_results" } else { "derived" }
}

/// The functions that derive data, and the functions that compute what they are derived from.
pub(super) fn functions(plan: &Plan, listings: &mut Listings) -> TokenStream {
    let inputs = Literal::usize_unsuffixed(plan.inputs());
    let is_read = |(_, planned): &(usize, &PlannedDerivation)| plan.output.is_some() || !planned.is_for_results;
    let operands = plan.derived.iter().enumerate().filter(is_read).map(|(number, planned)| {
        let PlannedDerivation { derivation, program, .. } = planned;
        let name = (&name(number), " What data are derived from.");
        code::shared_function(code::inputs_of(plan), name, program, &derivation.operands, plan.derived.len())
    });
    let readers = [Reader::Solve, Reader::Results].into_iter().filter(|&reader| {
        let is_shared = reader == Reader::Results && function_name(plan, reader) == function_name(plan, Reader::Solve);
        !is_shared && derivations(plan, reader).next().is_some()
    });
    let derived = readers.map(|reader| {
        let (name, steps) = (format_ident!("{}", function_name(plan, reader)), steps(plan, reader));
        let doc = match reader {
            Reader::Results => " those that are derived from them, also for what is returned beside the unknowns.",
            _ => " those that are derived from them, if a solve reads them. Others are 0.",
        };
        quote! {
            /// All data of the problem: those that are given, one parameter after another, and
            #[doc = #doc]
            fn #name(given: &[&[f64]]) -> Result<[f64; #inputs], ::eliminant::SolveError> {
                let mut data = emitted::joined(given);
                emitted::check_coefficients(&[], given)?;
                #steps
                Ok(data)
            }
        }
    });
    let presolved = plan.is_presolved_at_run_time().then(|| {
        let (steps, first) = (steps(plan, Reader::Template), Literal::usize_unsuffixed(plan.stated));
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
    let tables = derivations(plan, Reader::Template).map(|(number, planned)| {
        let PlannedDerivation { derivation, program, .. } = planned;
        let table = ProgramTable::of_program(program, plan.inputs(), &derivation.operands);
        let doc = " What data are derived from, for twice the precision.";
        static_program(&name_of_table(number), doc, &table, listings)
    });
    let tables: TokenStream = tables.collect();
    quote!(#(#operands)* #(#derived)* #presolved #tables)
}

/// The function that computes the operands of a derivation.
fn name(number: usize) -> Ident {
    format_ident!("operands_of_derived_{number}")
}

/// The name of the table of its operations, for twice the precision.
fn name_of_table(number: usize) -> Ident {
    format_ident!("OPERANDS_OF_DERIVED_{number}")
}

/// Matrices of so many entries are taken by code that is compiled for their size.
const MOST_OF_SMALL: usize = 160;

/// The derivations for this reader.
fn steps(plan: &Plan, reader: Reader) -> TokenStream {
    let presolve = reader == Reader::Template;
    let least = Literal::f64_unsuffixed(if presolve { LEAST_PIVOT_OF_PRESOLVE } else { 0.0 });
    let steps = derivations(plan, reader).map(|(number, planned)| {
        let (PlannedDerivation { derivation, .. }, [first, end]) = (planned, bounds(planned));
        let operands = name(number);
        let operands = match presolve {
            true => {
                let values = ProgramTable::values_of(&planned.program, plan.inputs());
                let (table, values) = (name_of_table(number), Literal::usize_unsuffixed(values));
                quote! {
                    R::by_precision(
                        &*data,
                        |data| self::#operands(R::ONE, data),
                        |data| #table.evaluate_on::<R, #values, _>(data),
                    )
                }
            }
            false => quote!(self::#operands(1.0, &data)),
        };
        let results = quote!(&mut data[#first..#end]);
        let is_small = derivation.kind.operands() <= MOST_OF_SMALL;
        let step = match derivation.kind {
            DerivationKind::SquareRoot => quote!(emitted::square_root(&#operands, #results)),
            DerivationKind::Solve { size, right } => {
                let [size, right] = [size, right].map(Literal::usize_unsuffixed);
                match is_small {
                    true => quote!(emitted::solve_small::<_, #size, #right>(&mut #operands, #least, #results)),
                    false => quote!(emitted::solve_linear(&mut #operands, #size, #least, #results)),
                }
            }
            DerivationKind::NullSpace { rows, columns } => {
                let [rows, columns] = [rows, columns].map(Literal::usize_unsuffixed);
                match is_small {
                    true => quote!(emitted::null_space_small::<#rows, #columns>(&mut #operands, #results)),
                    false => quote!(emitted::null_space(&mut #operands, #rows, #results)),
                }
            }
            DerivationKind::Least { keys, .. } => {
                let keys = Literal::usize_unsuffixed(keys);
                quote!(emitted::least(&#operands, #keys, #results))
            }
        };
        match planned.is_tentative {
            // What is derived from it is not chosen.
            true => quote! {
                if #step.is_err() {
                    data[#first..#end].fill(f64::NAN);
                }
            },
            false => quote!(#step?;),
        }
    });
    let tentative = derivations(plan, reader).filter(|(_, planned)| planned.is_tentative);
    let cleared = tentative.map(|(_, planned)| {
        let [first, end] = bounds(planned);
        quote!(data[#first..#end].fill(0.0);)
    });
    quote!(#(#steps)* #(#cleared)*)
}

/// Where the results of a derivation stand among the data.
fn bounds(planned: &PlannedDerivation) -> [Literal; 2] {
    let range = planned.derivation.inputs();
    [range.start, range.end].map(Literal::usize_unsuffixed)
}
