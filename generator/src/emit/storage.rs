//! Prints where the matrices of a solver are kept: on the stack, or on the heap, in the workspace
//! of a solve.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use crate::plan::Plan;
use crate::plan::program::ProgramForm;

/// The field of the instance that says so, with its type, inside of `impl<'w>`.
pub(super) fn field(plan: &Plan) -> (TokenStream, TokenStream) {
    match plan.is_on_heap() {
        true => (quote!(workspace), quote!(&'w ::eliminant::Workspace)),
        false => (quote!(second_attempts), quote!(::eliminant::SecondAttempts)),
    }
}

/// The type of the field as that of a parameter.
pub(super) fn parameter(plan: &Plan) -> TokenStream {
    match plan.is_on_heap() {
        true => quote!(&::eliminant::Workspace),
        false => quote!(::eliminant::SecondAttempts),
    }
}

/// The parameters of the type of instances where it is defined and implemented: `<'w>` or nothing.
pub(super) fn generics(plan: &Plan) -> TokenStream {
    if plan.is_on_heap() { quote!(<'w>) } else { quote!() }
}

/// The parameters of the type of instances where it is named: `<'_>` or nothing.
pub(super) fn elided(plan: &Plan) -> TokenStream {
    if plan.is_on_heap() { quote!(<'_>) } else { quote!() }
}

/// The value of the field for a solve without a workspace, as a statement that makes it and an
/// expression of it.
pub(super) fn default(plan: &Plan, name: &Ident) -> (TokenStream, TokenStream) {
    match plan.is_on_heap() {
        true => (quote!(let #name = ::eliminant::Workspace::new();), quote!(&#name)),
        false => (quote!(), quote!(::eliminant::SecondAttempts::Always)),
    }
}

/// The value of the field for a solve in a workspace.
pub(super) fn of_workspace(plan: &Plan, workspace: &Ident) -> TokenStream {
    if plan.is_on_heap() { quote!(#workspace) } else { quote!(#workspace.second_attempts()) }
}

/// Whether coefficients are on the heap: those that a table computes are, because they are many.
pub(super) fn has_coefficients_on_heap(plan: &Plan) -> bool {
    plan.is_on_heap() && plan.program.form == ProgramForm::Table
}

/// The type of that many coefficients of type R, and of a reference to them.
pub(super) fn coefficients(plan: &Plan, number: &TokenStream) -> (TokenStream, TokenStream) {
    let count = Literal::usize_unsuffixed(plan.coefficients.len());
    match has_coefficients_on_heap(plan) {
        true => (quote!(emitted::HeapRows<'w, #number>), quote!(&[#number])),
        false => (quote!([#number; #count]), quote!(&[#number; #count])),
    }
}

/// The field of an instance for its coefficients at twice the precision, and its value where they
/// are not needed yet: several points that are refined share them. Only those on the heap are kept;
/// others would take their place on the stack in each solve.
pub(super) fn precise_field(plan: &Plan) -> (TokenStream, TokenStream) {
    match has_coefficients_on_heap(plan) {
        true => (
            quote! {
                /// The coefficients at twice the precision, once a point is refined.
                precise: emitted::Precise<'w>,
            },
            quote!(precise: emitted::Precise::new(),),
        ),
        false => (quote!(), quote!()),
    }
}

/// How the coefficients are computed from `data`.
pub(super) fn coefficients_of_data(plan: &Plan) -> TokenStream {
    match plan.program.form {
        ProgramForm::Statements => quote!(self::coefficients_of(data)),
        ProgramForm::Table if plan.is_on_heap() => quote!(self::coefficients(data, workspace.memory())),
        ProgramForm::Table => quote!(self::coefficients(data)),
    }
}

/// The type of all data of an instance, and where they are in it. There may be many, because
/// choices are among derived ones, and what is not optimised copies them with each move: where
/// there is a heap they are on it.
pub(super) fn data(plan: &Plan) -> (TokenStream, TokenStream) {
    let inputs = Literal::usize_unsuffixed(plan.inputs());
    match plan.is_on_heap() {
        true => (quote!(emitted::HeapRows<'w, [f64; #inputs]>), quote!(self.data[0])),
        false => (quote!([f64; #inputs]), quote!(self.data)),
    }
}

/// A reference to the coefficients of an instance.
pub(super) fn coefficients_of_instance(plan: &Plan) -> TokenStream {
    match has_coefficients_on_heap(plan) {
        true => quote!(self.coefficients.as_ref()),
        false => quote!(&self.coefficients),
    }
}

/// The sizes of an instance: their types, and how they are made of it.
pub(super) fn basis(plan: &Plan) -> (TokenStream, TokenStream) {
    let basis = Literal::usize_unsuffixed(plan.elimination.basis);
    match plan.has_basis_on_heap() {
        true => (
            quote!(emitted::OnHeap<'w, emitted::Fixed<#basis>>),
            quote!(emitted::OnHeap { size: emitted::Fixed, memory: self.workspace.memory() }),
        ),
        false => (quote!(emitted::Fixed<#basis>), quote!(emitted::Fixed::<#basis>)),
    }
}

/// Which second attempts an instance may make.
pub(super) fn allowed_attempts(plan: &Plan) -> TokenStream {
    match plan.is_on_heap() {
        true => quote!(self.workspace.second_attempts()),
        false => quote!(self.second_attempts),
    }
}

/// What the runtime asks about second attempts.
pub(super) fn second_attempts(plan: &Plan) -> TokenStream {
    let field = allowed_attempts(plan);
    let memory = plan.is_on_heap().then(|| {
        quote! {
            fn memory(&self) -> Option<&emitted::Memory> {
                Some(self.workspace.memory())
            }
        }
    });
    quote! {
        fn allows_second_attempt(&self) -> bool {
            #field.allows(SECOND_ATTEMPT_OPERATIONS)
        }
        #memory
    }
}

/// A compile error where the solver needs a heap and the runtime has none.
pub(super) fn handshake(plan: &Plan) -> TokenStream {
    let name = &plan.name;
    if plan.is_on_heap() { quote!(::eliminant::needs_alloc!(#name);) } else { quote!() }
}

/// Lines for the header of the module.
pub(super) fn described(plan: &Plan) -> String {
    let kilobytes = plan.working_memory().div_ceil(1024);
    let place = match plan.is_on_heap() {
        true => "on the heap (feature `alloc` of `eliminant`); a solve takes less than 256 KiB of the stack",
        false => {
            "on the stack, of which a solve takes less than 256 KiB; nothing is allocated, but for data at which the \
             template is singular (feature `alloc`)"
        }
    };
    format!("- memory: about {kilobytes} KiB for matrices, {place}")
}
