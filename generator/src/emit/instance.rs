//! Prints an instance: the coefficients for given data, and what the runtime asks of them.

use std::collections::BTreeSet;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::listing::Listings;
use super::provenance::Provenance;
use super::{chains, code, elimination, family, monomials, program, scaling, storage};
use crate::plan::value_layout::ValueLayout;
use crate::plan::{CoefficientId, Plan};

/// The version of the runtime's hidden interface that is emitted for.
pub const RUNTIME_VERSION: u32 = 14;

/// That the origin of the unknowns that presolve kept is a solution, if it is one, and how
/// solutions are lost at which an unknown vanishes.
fn lost_points(plan: &Plan) -> TokenStream {
    let origin = plan.has_origin.then(|| {
        quote! {
            fn has_origin(&self) -> bool {
                true
            }
        }
    });
    let lacks_pairs = plan.zeros.lacks_pairs.then(|| {
        quote! {
            fn loses_zeros(&self) -> bool {
                true
            }
        }
    });
    let is_misread = plan.zeros.is_misread.then(|| {
        quote! {
            fn misreads_zeros(&self) -> bool {
                true
            }
        }
    });
    quote!(#origin #lacks_pairs #is_misread)
}

/// The value of the action monomial, if it is one of the unknowns.
fn action_value(plan: &Plan) -> TokenStream {
    if plan.action_monomial.is_empty() {
        return quote!();
    }
    let unknowns = Literal::usize_unsuffixed(plan.unknowns.len());
    let exponents = plan.action_monomial.iter().map(|&exponent| Literal::i8_unsuffixed(exponent));
    quote! {
        fn action_value<S: ::eliminant::Scalar>(&self, x: &[S; #unknowns]) -> Option<S> {
            Some(emitted::monomial_value(x, &[#(#exponents),*]))
        }
    }
}

/// How unknowns follow if a template stands for solutions up to symmetries; nothing if it does not.
fn symmetries(plan: &Plan) -> TokenStream {
    if plan.images.is_empty() {
        return quote!();
    }
    let symmetries = symmetries_of(plan);
    quote! {
        fn symmetries(&self) -> Option<emitted::Symmetries<'_>> {
            #symmetries
        }
    }
}

/// The symmetries, or `None`.
pub(super) fn symmetries_of(plan: &Plan) -> TokenStream {
    if plan.images.is_empty() {
        return quote!(None);
    }
    let steps = plan.steps().into_iter().map(|exponents| {
        let exponents = exponents.into_iter().map(Literal::i8_unsuffixed);
        quote!(&[#(#exponents),*])
    });
    let images = plan.images.iter().map(|map| {
        let map = map.iter().map(|&(of, is_negated)| {
            let of = Literal::u8_unsuffixed(of);
            quote!((#of, #is_negated))
        });
        quote!(&[#(#map),*])
    });
    quote!(Some(emitted::Symmetries { steps: &[#(#steps),*], images: &[#(#images),*] }))
}

/// The coefficients at twice the precision.
fn precise_coefficients(plan: &Plan) -> TokenStream {
    let (function, (_, data)) = (program::name_of_table_function(plan), storage::data(plan));
    match storage::has_coefficients_on_heap(plan) {
        true => quote!(self.precise.get_or_init(|| self::#function(&#data, self.workspace.memory()))),
        false => quote!(self::#function::<emitted::DoubleDouble>(&#data)),
    }
}

/// The coefficients for given data, and what they are for.
pub(super) fn instance(plan: &Plan, provenance: &Provenance, listings: &mut Listings) -> TokenStream {
    let (list, _) = storage::coefficients(plan, &quote!(f64));
    let ((data, _), compute) = (storage::data(plan), storage::coefficients_of_data(plan));
    let (units_field, units) = scaling::field(plan);
    let (basis, count_read) =
        (Literal::usize_unsuffixed(plan.elimination.basis), Literal::usize_unsuffixed(plan.read.len()));
    let (read_field, no_read) = match plan.read.is_empty() {
        true => (quote!(), quote!()),
        false => (
            quote! {
                /// Monomials that unknowns are read from, as combinations of the basis; known after
                /// the elimination.
                read: [[f64; #basis]; #count_read],
            },
            quote!(read: [[0.0; #basis]; #count_read],),
        ),
    };
    let action_matrix = elimination::action_matrix(plan);
    let eliminated = elimination::eliminated(plan, provenance, listings);
    let (ratios, recovered) = (ratios(plan), code::recovered(plan));
    let (solver_instance, chains) = (solver_instance(plan, &action_matrix), chains::chains(plan));
    let ((storage, storage_type), generics) = (storage::field(plan), storage::generics(plan));
    let (precise_field, no_precise) = storage::precise_field(plan);
    let value = match plan.is_on_heap() {
        true => quote! {
            let kept = data;
            let data = &kept[0];
            Self { coefficients: #compute, data: kept, #units #no_read #no_precise #storage }
        },
        false => quote!(Self { coefficients: #compute, data: *data, #units #no_read #no_precise #storage }),
    };
    let (constructors, scalings) = (scaling::constructors(plan, &value), scaling::table(plan));
    let (parameters, quotients) = (family::table(plan), quotients(plan));
    let (version, handshake) = (Literal::u32_unsuffixed(RUNTIME_VERSION), storage::handshake(plan));
    quote! {
        /// A compile error if the runtime has another version.
        const _: () = emitted::check_version(#version);

        #handshake

        /// The coefficients of all equations for given data.
        struct Instance #generics {
            coefficients: #list,
            /// All data, one parameter after another.
            data: #data,
            #units_field
            #read_field
            #precise_field
            #storage: #storage_type,
        }

        impl #generics Instance #generics {
            #constructors
        }

        #scalings
        #quotients
        #parameters
        #solver_instance
        #ratios
        #recovered
        #eliminated
        #chains
    }
}

/// The quotients of the template, if it has some.
fn quotients(plan: &Plan) -> TokenStream {
    let slots = |slots: &BTreeSet<CoefficientId>| {
        let slots = slots.iter().map(|id| Literal::u16_unsuffixed(id.0));
        quote!(&[#(#slots),*])
    };
    let quotients = plan.quotients();
    if quotients.is_empty() {
        return quote!();
    }
    let [own, stated] = [slots(&quotients), slots(&plan.coefficients_of_statements())];
    quote! {
        /// Coefficients that only the template has and that are quotients of data, beside those of
        /// the equations.
        const QUOTIENTS: emitted::Quotients<'static> = emitted::Quotients { own: #own, stated: #stated };
    }
}

/// What tells whether these are large, if there are some.
fn has_large_quotients(plan: &Plan) -> TokenStream {
    if plan.quotients().is_empty() {
        return quote!();
    }
    let coefficients = storage::coefficients_of_instance(plan);
    quote! {
        fn has_large_quotients(&self) -> bool {
            let coefficients = #coefficients;
            QUOTIENTS.are_large(|slot| coefficients[slot])
        }
    }
}

/// The sizes, as values.
fn sizes(plan: &Plan) -> TokenStream {
    if !plan.has_basis_on_heap() {
        return quote!(emitted::Sizes::FIXED);
    }
    let basis = storage::basis(plan).1;
    quote! {
        emitted::Sizes {
            basis: #basis,
            unknowns: emitted::Fixed,
            values: emitted::Fixed,
            solutions: emitted::Fixed,
        }
    }
}

/// That the coefficients can be computed at twice the precision for a second attempt.
fn has_precise_coefficients(plan: &Plan) -> TokenStream {
    match plan.has_precise_coefficients() {
        false => quote!(),
        true => quote! {
            fn has_precise_coefficients(&self) -> bool {
                true
            }
        },
    }
}

/// The methods that judge a point by the equations, and make it better.
fn judgement(plan: &Plan) -> TokenStream {
    let (of_system, system) = monomials::system(plan);
    let [unknowns, equations] = [plan.unknowns.len(), plan.equations.len()].map(Literal::usize_unsuffixed);
    let sizes = quote!((emitted::Fixed::<#unknowns>, emitted::Fixed::<#equations>));
    let (coefficients, precise) = (storage::coefficients_of_instance(plan), precise_coefficients(plan));
    let admissible = match plan.nonzero.is_empty() {
        true => quote! {
            let _ = x;
            true
        },
        false => quote!(NONZERO.bind(#coefficients).exceeds(x, emitted::VANISHING)),
    };
    quote! {
        fn polish<S: ::eliminant::Scalar>(&self, x: &mut [S; #unknowns], steps: usize) -> f64 {
            #of_system
            emitted::polish_precisely(x, #sizes, &#system, steps, || #precise)
        }

        fn error_bound<S: ::eliminant::Scalar>(&self, x: &[S; #unknowns]) -> f64 {
            #of_system
            emitted::error_bound(x, #sizes, &#system, #precise.as_ref())
        }

        fn is_admissible<S: ::eliminant::Scalar>(&self, x: &[S; #unknowns]) -> bool {
            #admissible
        }
    }
}

/// What the runtime asks of an instance.
fn solver_instance(plan: &Plan, action_matrix: &TokenStream) -> TokenStream {
    let layout = ValueLayout::of(plan);
    let [basis, unknowns, values, solutions] =
        [plan.elimination.basis, plan.unknowns.len(), layout.len(), plan.solutions].map(Literal::usize_unsuffixed);
    let (lost, symmetries, second_attempts) = (lost_points(plan), symmetries(plan), storage::second_attempts(plan));
    let (generics, basis_type, all_sizes) = (storage::generics(plan), storage::basis(plan).0, sizes(plan));
    let (precise, judgement, has_image) = (has_precise_coefficients(plan), judgement(plan), layout.has_image);
    let (large_quotients, action_value) = (has_large_quotients(plan), action_value(plan));
    let family = family::methods(plan);
    let read = match plan.read.is_empty() {
        true => quote!(&[[0.0; 0]; 0]),
        false => quote!(&self.read),
    };
    let coefficients = storage::coefficients_of_instance(plan);
    let recover = match plan.recovered().next() {
        None => quote!(let _ = x;),
        Some(_) => quote!(self::recovered(#coefficients, x)),
    };
    quote! {
        impl #generics emitted::SolverInstance for Instance #generics {
            type Basis = #basis_type;
            type Unknowns = emitted::Fixed<#unknowns>;
            type Values = emitted::Fixed<#values>;
            type Solutions = emitted::Fixed<#solutions>;

            fn sizes(&self) -> emitted::SizesOf<Self> {
                #all_sizes
            }
            fn ratios(&self, unknown: usize) -> &[(u16, u16)] {
                RATIOS[unknown]
            }
            #lost
            #action_value
            #symmetries
            #precise
            #large_quotients
            #second_attempts
            #action_matrix

            fn monomial_values<S: ::eliminant::Scalar>(&self, value: S, vector: &[S; #basis]) -> [S; #values] {
                emitted::monomial_values(emitted::Fixed, (value, vector), #has_image, #read)
            }

            fn recover<S: ::eliminant::Scalar>(&self, x: &mut [S; #unknowns]) {
                #recover
            }

            #judgement
            #family
        }
    }
}

/// Where unknowns are read from.
fn ratios(plan: &Plan) -> TokenStream {
    let layout = ValueLayout::of(plan);
    let pairs = (0..plan.unknowns.len()).map(|unknown| {
        let pairs = layout.ratios(plan, unknown).into_iter().map(|(m, xm)| {
            let [m, xm] = [m, xm].map(Literal::u16_unsuffixed);
            quote!((#m, #xm))
        });
        quote!(&[#(#pairs),*])
    });
    let unknowns = Literal::usize_unsuffixed(plan.unknowns.len());
    quote! {
        /// For each unknown x, the positions of (m, x m) among the monomial values.
        const RATIOS: [&[(u16, u16)]; #unknowns] = [#(#pairs),*];
    }
}
