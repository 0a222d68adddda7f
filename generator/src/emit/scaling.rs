//! Prints the units in which a template is accurate, where the problem has some.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::derived;
use super::names::Names;
use super::shapes::parameter;
use super::storage;
use crate::plan::Plan;
use crate::problem::SolutionField;

/// Whether data and unknowns have units.
pub(super) fn has_units(plan: &Plan) -> bool {
    !plan.scalings.is_empty()
}

/// The table of weights; nothing without units.
pub(super) fn table(plan: &Plan) -> TokenStream {
    if !has_units(plan) {
        return quote!();
    }
    let count = Literal::usize_unsuffixed(plan.scalings.len());
    let in_vectors = Literal::u32_unsuffixed(plan.unknowns_in_vectors());
    let [data, unknowns] = [plan.weights_of_data(), plan.weights_of_unknowns()].map(|weights| {
        let weights = weights.into_iter().map(Literal::i8_unsuffixed);
        quote!(&[#(#weights),*])
    });
    quote! {
        /// The scalings under which the problem stays the same: a weight per scaling for each datum
        /// and for each unknown.
        const SCALINGS: emitted::Scalings<'static> =
            emitted::Scalings { count: #count, data: #data, unknowns: #unknowns, in_vectors: #in_vectors };
    }
}

/// A field of the instance for the units.
pub(super) fn field(plan: &Plan) -> (TokenStream, TokenStream) {
    let unknowns = Literal::usize_unsuffixed(plan.unknowns.len());
    let field = quote! {
        /// Exponents of the powers of two by which unknowns exceed those of the given data.
        exponents: [i16; #unknowns],
    };
    if has_units(plan) { (field, quote!(exponents,)) } else { (quote!(), quote!()) }
}

/// How instances are made: `new` in the units of the data, and, where there are units, `scaled` in
/// those in which data that are far from 1 are about 1. `value` is the instance with these
/// coefficients of `data`.
pub(super) fn constructors(plan: &Plan, value: &TokenStream) -> TokenStream {
    let (storage, storage_type) = storage::field(plan);
    let [count, inputs, unknowns] =
        [plan.data.len(), plan.inputs(), plan.unknowns.len()].map(Literal::usize_unsuffixed);
    let ([changed, unchanged], all) = match plan.is_on_heap() {
        true => {
            let owned = storage::data(plan).0;
            ([quote!(mut data: #owned), quote!(data: #owned)], quote!(&mut data[0]))
        }
        false => ([quote!(data: &mut [f64; #inputs]), quote!(data: &[f64; #inputs])], quote!(data)),
    };
    let mut names = Names::of(&plan.data);
    let [given, data, kept, instance] = ["given", "data", "kept", "instance"].map(|name| names.take(name));
    let parameters: Vec<_> = plan.data.iter().map(parameter).collect();
    let checked = |name: &str, binding: &TokenStream, made: &TokenStream| {
        let name = format_ident!("{name}");
        let all_data = derived::data_of_solve(plan, &given, (&data, binding), &quote!(#kept));
        quote! {
            fn #name(#kept: #storage_type, #(#parameters),*) -> Result<Self, ::eliminant::SolveError> {
                #all_data
                let #instance = #made;
                #instance.check(&#given)?;
                Ok(#instance)
            }
        }
    };
    let (mut exponents, mut no_exponents, mut scaled) = (quote!(), quote!(), quote!());
    if has_units(plan) {
        (exponents, no_exponents) = (quote!(exponents: [i16; #unknowns],), quote!([0; #unknowns],));
        let constructor = checked("scaled", &binding(plan, &data), &of_data(plan, &data, &quote!(#kept)));
        scaled = quote! {
            /// In units in which data that are far from 1 are about 1.
            #constructor

            /// As `scaled`, from all data, which are scaled.
            #[inline(always)]
            fn scaled_of(#changed, #storage: #storage_type) -> Self {
                let exponents = SCALINGS.apply(#all);
                Self::of(data, exponents, #storage)
            }
        };
    }
    let whole = if plan.is_on_heap() { quote!(#data) } else { quote!(&#data) };
    let new = checked("new", &quote!(#data), &quote!(Self::of(#whole, #no_exponents #kept)));
    let check = check(plan);
    quote! {
        #new
        #scaled

        /// From values of all data, one parameter after another.
        #[inline(always)]
        fn of(#unchanged, #exponents #storage: #storage_type) -> Self {
            #value
        }

        /// Whether the data that are `given` and the coefficients that must be finite are so.
        #[inline]
        fn check(&self, given: &[&[f64]; #count]) -> Result<(), ::eliminant::SolveError> {
            #check
        }
    }
}

/// What tells whether the data that are `given` and the coefficients that must be finite are so. If
/// others are not, the elimination finds out.
fn check(plan: &Plan) -> TokenStream {
    let coefficients = storage::coefficients_of_instance(plan);
    let Some(required) = plan.required_coefficients() else {
        return quote!(emitted::check_coefficients(#coefficients, given));
    };
    let required = required.iter().map(|id| Literal::usize_unsuffixed(usize::from(id.0)));
    quote! {
        let coefficients = #coefficients;
        emitted::check_coefficients(&[#(coefficients[#required]),*], given)
    }
}

/// How all `data` of the problem are bound for [`of_data`].
pub(super) fn binding(plan: &Plan, data: &Ident) -> TokenStream {
    if has_units(plan) && !plan.is_on_heap() { quote!(mut #data) } else { quote!(#data) }
}

/// The instance that is solved, from all `data` of the problem, which are scaled: an array, or its
/// only row on the heap.
pub(super) fn of_data(plan: &Plan, data: &Ident, storage: &TokenStream) -> TokenStream {
    match (has_units(plan), plan.is_on_heap()) {
        (true, true) => quote!(Instance::scaled_of(#data, #storage)),
        (true, false) => quote!(Instance::scaled_of(&mut #data, #storage)),
        (false, true) => quote!(Instance::of(#data, #storage)),
        (false, false) => quote!(Instance::of(&#data, #storage)),
    }
}

/// The constructor of instances that are solved.
pub(super) fn constructor(plan: &Plan) -> Ident {
    format_ident!("{}", if has_units(plan) { "scaled" } else { "new" })
}

/// The function from the points of an instance to solutions.
pub(super) fn to_solution(plan: &Plan, exponents: &TokenStream) -> TokenStream {
    match (has_units(plan), plan.vectors_with_units().next()) {
        (false, _) => quote!(Solution::from_unknowns),
        (true, None) => quote!(|point| Solution::from_unknowns(emitted::unscaled(#exponents, point))),
        (true, Some(_)) => quote!(|point| Solution::from_scaled(#exponents, point)),
    }
}

/// The unknowns that an `instance` is solved for, from a solution.
pub(super) fn to_unknowns(plan: &Plan, solution: &Ident, instance: &Ident) -> TokenStream {
    match (has_units(plan), plan.vectors_with_units().next()) {
        (false, _) => quote!(#solution.to_unknowns()),
        (true, None) => quote!(emitted::scaled(&#instance.exponents, #solution.to_unknowns())),
        (true, Some(_)) => quote!(#solution.to_scaled(&#instance.exponents)),
    }
}

/// Solutions from the unknowns of the scaled problem, and back, where elements of a vector up to
/// scale have different units. These do not go through the chart, where small ones would lose
/// digits; nothing without such vectors.
pub(super) fn points(plan: &Plan) -> TokenStream {
    let vectors: Vec<&SolutionField> = plan.vectors_with_units().collect();
    if vectors.is_empty() {
        return quote!();
    }
    let range = |field: &SolutionField| {
        let [first, end] = [field.unknowns().start, field.unknowns().end].map(Literal::usize_unsuffixed);
        quote!(#first..#end)
    };
    let count = Literal::usize_unsuffixed(plan.unknowns.len());
    let others = plan.fields.iter().filter(|field| !field.is_projective).map(range);
    let others = others.map(|range| quote!(emitted::unscale(&exponents[#range], &mut unknowns[#range]);));
    let others: Vec<_> = others.collect();
    let (binding, to_unknowns) = match others.is_empty() {
        true => (quote!(unknowns), quote!(solution.to_unknowns())),
        false => (
            quote!(mut unknowns),
            quote! {
                let mut unknowns = solution.to_unknowns();
                #(#others)*
                unknowns
            },
        ),
    };
    let vectors: Vec<_> = vectors
        .into_iter()
        .map(|field| {
            let (name, range) = (format_ident!("{}", field.name), range(field));
            quote!(emitted::unscale_vector(&exponents[#range], &mut solution.#name);)
        })
        .collect();
    quote! {
        impl<T: ::eliminant::Scalar> Solution<T> {
            /// The solution of the problem as it was given, from the unknowns of the scaled one.
            #[inline]
            fn from_scaled(exponents: &[i16; #count], #binding: [T; #count]) -> Self {
                #(#others)*
                let mut solution = Self::from_unknowns(unknowns);
                #(#vectors)*
                solution
            }

            /// The unknowns of the scaled problem.
            #[inline]
            fn to_scaled(self, exponents: &[i16; #count]) -> [T; #count] {
                let (exponents, mut solution) = (exponents.map(|exponent| -exponent), self);
                #(#vectors)*
                #to_unknowns
            }
        }
    }
}
