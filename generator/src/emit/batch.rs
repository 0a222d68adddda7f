//! Prints how several instances are solved with one call.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::elimination::is_filled_by_statements;
use super::names::Names;
use super::shapes::{as_slice, type_of};
use super::{derived, instance, monomials, scaling};
use crate::plan::Plan;
use crate::plan::program::ProgramForm;
use crate::plan::system_table::SystemTable;
use crate::plan::value_layout::ValueLayout;

/// The null vector of a matrix of more polynomials needs pivots, and instances side by side would
/// have to agree on them.
const MOST_CHAINS: usize = 3;

/// Whether the runtime can compute instances side by side: all arithmetic is statements, and all
/// solutions are those of the roots of a determinant.
fn is_side_by_side(plan: &Plan) -> bool {
    let has_few_chains = plan.chains.as_ref().is_some_and(|chains| chains.lengths.len() <= MOST_CHAINS);
    has_few_chains
        && plan.program.form == ProgramForm::Statements
        && is_filled_by_statements(plan)
        && monomials::are_statements(plan)
        && plan.nonzero.is_empty()
        && !ValueLayout::of(plan).has_image
}

/// The data of an instance, and the function that solves many.
pub(super) fn batch(plan: &Plan) -> TokenStream {
    let fields = plan.data.iter().map(|parameter| {
        let (name, array) =
            (format_ident!("{}", parameter.name), type_of(quote!(f64), &parameter.shape, parameter.is_complex));
        let doc = format!(" The argument `{}` of [`solve`].", parameter.name);
        quote!(#[doc = #doc] pub #name: #array,)
    });
    let is_side_by_side = is_side_by_side(plan);
    let (call, implementation) = match is_side_by_side {
        true => (quote!(emitted::solve_batch::<Instance, _>(data, results)), implementation(plan)),
        false => {
            let arguments = plan.data.iter().map(|parameter| {
                let name = format_ident!("{}", parameter.name);
                if parameter.is_number() { quote!(of_instance.#name) } else { quote!(&of_instance.#name) }
            });
            let (workspace, call) = match plan.is_on_heap() {
                true => (
                    quote!(let workspace = &mut ::eliminant::Workspace::new();),
                    quote!(self::solve_in(workspace, #(#arguments),*)),
                ),
                false => (quote!(), quote!(self::solve(#(#arguments),*))),
            };
            let each = quote! {
                #workspace
                for (of_instance, result) in data.iter().zip(results) {
                    let _ = of_instance;
                    *result = #call;
                }
            };
            (each, quote!())
        }
    };
    let how: &[&str] = match is_side_by_side {
        true => &[
            " With the feature `lanes` of `eliminant`, as many as the registers of the processor hold are",
            " computed side by side; results are then those of [`solve`] up to rounding.",
        ],
        false => &[" This solver computes them one after another."],
    };
    quote! {
        /// The data of an instance: the arguments of [`solve`].
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Data {
            #(#fields)*
        }

        /// Solves many instances: `results[i]` becomes what [`solve`] returns for `data[i]`. If one
        /// of the lists is longer, its rest is left alone.
        ///
        #(#[doc = #how])*
        pub fn solve_batch(
            data: &[Data],
            results: &mut [Result<::eliminant::Solutions<Solution, MAX_SOLUTIONS>, ::eliminant::SolveError>],
        ) {
            #call
        }

        #implementation
    }
}

/// What the runtime asks of instances side by side.
fn implementation(plan: &Plan) -> TokenStream {
    let table = SystemTable::of(&plan.equations, plan.unknowns.len());
    let [inputs, coefficients, rows, read, equations, products] = [
        plan.inputs(),
        plan.coefficients.len(),
        plan.elimination.rows,
        plan.read.len(),
        table.ends.len(),
        table.chain.len(),
    ]
    .map(Literal::usize_unsuffixed);
    let of_read = if plan.read.is_empty() { quote!(&[]) } else { quote!(&READ) };
    let symmetries = instance::symmetries_of(plan);
    let action_monomial = plan.action_monomial.iter().map(|&exponent| Literal::i8_unsuffixed(exponent));
    let has_origin = plan.has_origin.then(|| {
        quote!(
            const HAS_ORIGIN: bool = true;
        )
    });
    let positive = (!plan.positive.is_empty()).then(|| {
        quote!(
            const POSITIVE: &'static [emitted::Inequality<'static>] = POSITIVE;
        )
    });
    let quotients = (!plan.quotients().is_empty()).then(|| {
        quote!(
            const QUOTIENTS: emitted::Quotients<'static> = QUOTIENTS;
        )
    });
    let of_data = of_data(plan);
    let constants = quote! {
        type Inputs = emitted::Fixed<#inputs>;
        type Coefficients = emitted::Fixed<#coefficients>;
        type Rows = emitted::Fixed<#rows>;
        type Read = emitted::Fixed<#read>;
        type Equations = emitted::Fixed<#equations>;
        type Products = emitted::Fixed<#products>;
        type Monomials = Monomials;

        const ACTION: &'static [emitted::ActionRow] = &ACTION;
        const READ: &'static [u16] = #of_read;
        const RATIOS: &'static [&'static [(u16, u16)]] = &RATIOS;
        const ACTION_MONOMIAL: &'static [i8] = &[#(#action_monomial),*];
        const SYMMETRIES: Option<emitted::Symmetries<'static>> = #symmetries;
        #positive
        #has_origin
        #quotients
    };
    let functions = functions(plan, [&inputs, &coefficients, &rows, &equations, &products]);
    quote! {
        impl emitted::BatchSolver for Instance {
            #constants
            #functions
        }

        #of_data
    }
}

/// The functions of the implementation, with the numbers of data, coefficients, rows of the
/// template, equations and their monomials.
fn functions(plan: &Plan, sizes: [&Literal; 5]) -> TokenStream {
    let [inputs, coefficients, rows, equations, products] = sizes;
    let [basis, unknowns] = [plan.elimination.basis, plan.unknowns.len()].map(Literal::usize_unsuffixed);
    let recovered = match plan.recovered().next() {
        None => quote!(let _ = (coefficients, x);),
        Some(_) => quote!(self::recovered(coefficients, x)),
    };
    quote! {

            fn all_sizes() -> (emitted::SizesOf<Self>, emitted::BatchSizesOf<Self>) {
                (emitted::Sizes::FIXED, emitted::BatchSizes::FIXED)
            }

            fn all_chains() -> Chains {
                Chains
            }

            fn monomials() -> Monomials {
                Monomials
            }

            #[inline(always)]
            fn coefficients<T: emitted::Arithmetic>(one: T, data: &[T; #inputs]) -> [T; #coefficients] {
                self::coefficients(one, data)
            }

            #[inline(always)]
            fn equations<T: emitted::Element>(coefficients: &[T; #coefficients]) -> &[[T; #equations]; #products] {
                emitted::rows(coefficients)
            }

            #[inline(always)]
            fn eliminated<T: emitted::Eliminated + emitted::Over<T>>(
                zero: T,
                coefficients: &[T; #coefficients],
            ) -> Result<[[T; #basis]; #rows], ::eliminant::SolveError> {
                self::eliminated(zero, coefficients)
            }

            #[inline(always)]
            fn recovered<T: emitted::Arithmetic + emitted::Over<T>>(
                coefficients: &[T; #coefficients],
                x: &mut [T; #unknowns],
            ) {
                #recovered
            }
    }
}

/// How the runtime reads the data of an instance, and solves it by itself.
fn of_data(plan: &Plan) -> TokenStream {
    let names: Vec<_> = plan.data.iter().map(|parameter| format_ident!("{}", parameter.name)).collect();
    let mut taken = Names::of(&plan.data);
    let [write, given, of_unknowns] = ["write", "given", "exponents"].map(|name| taken.take(name));
    let join = match derived::is_derived(plan) {
        // Data that cannot be derived are left to `solve`, which tells why.
        true => quote! {
            match self::derived(&#given) {
                Ok(data) => emitted::join_into(&[&data], #write),
                Err(_) => #write.fill(f64::NAN),
            }
        },
        false => quote!(emitted::join_into(&#given, #write);),
    };
    let apply = match scaling::has_units(plan) {
        true => quote!(SCALINGS.apply_into(#write, #of_unknowns);),
        false => quote!(let _ = #of_unknowns;),
    };
    let presolved = plan.is_presolved_at_run_time().then(|| {
        quote! {
            if let Some(data) = #write.first_chunk_mut() {
                self::add_presolved(data);
            }
        }
    });
    let use_exponents = (!scaling::has_units(plan)).then(|| quote!(let _ = exponents;));
    let to_solution = scaling::to_solution(plan, &quote!(exponents));
    let slices = plan.data.iter().zip(&names).map(|(parameter, name)| match parameter.shape.is_empty() {
        true => quote!(::core::slice::from_ref(#name)),
        false => as_slice(parameter),
    });
    let arguments = plan.data.iter().zip(&names).map(|(parameter, name)| match parameter.is_number() {
        true => quote!(*#name),
        false => quote!(#name),
    });
    let count = Literal::usize_unsuffixed(plan.data.len());
    quote! {
        impl emitted::BatchData<Instance> for Data {
            type Result = Result<::eliminant::Solutions<Solution, MAX_SOLUTIONS>, ::eliminant::SolveError>;

            fn inputs(&self, #write: &mut [f64], #of_unknowns: &mut [i16]) {
                let Self { #(#names),* } = self;
                let #given: [&[f64]; #count] = [#(#slices),*];
                #join
                #apply
                #presolved
            }

            fn solve(&self) -> Self::Result {
                let Self { #(#names),* } = self;
                self::solve(#(#arguments),*)
            }

            fn result(
                points: &emitted::Points<Instance, f64>,
                exponents: &emitted::Point<Instance, i16>,
            ) -> Self::Result {
                #use_exponents
                Ok(::eliminant::Solutions::from_points(points, #to_solution))
            }
        }
    }
}
