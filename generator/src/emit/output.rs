//! Prints what a problem returns beside its unknowns, and the test of its inequalities.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::derived::{self, Reader};
use super::listing::Listings;
use super::names::Names;
use super::shapes::{accessors, chart_name, parameter, type_of, value_of};
use super::{code, program, scaling, storage};
use crate::plan::Plan;
use crate::plan::output::{PlannedField, PlannedOutput};
use crate::plan::program::ProgramForm;
use crate::plan::program_table::ProgramTable;
use crate::problem::SolutionField;

/// The struct of an output, and the functions that return it; nothing without one.
pub(super) fn output(plan: &Plan, listings: &mut Listings) -> TokenStream {
    let Some(output) = &plan.output else { return quote!() };
    let (name, functions) = (format_ident!("{}", output.name), functions(plan, output));
    let fields = output.fields.iter().map(|PlannedField { name, shape, is_complex, .. }| {
        let (field, ty) = (format_ident!("{name}"), type_of(quote!(T), shape, *is_complex));
        quote!(pub #field: #ty)
    });
    let field_docs = output.fields.iter().map(|field| {
        let up_to_scale = if field.is_projective { ", which is given up to scale" } else { "" };
        format!(" The output `{}` of the problem{up_to_scale}.", field.name)
    });
    let doc = format!(" What `{}` returns beside its unknowns.", plan.name);
    let known = plan.unknowns.len() + plan.fields.iter().filter(|field| field.is_projective).count();
    let (values, coordinates) = (values(output, known), coordinates(plan, known));
    let program = coefficients(plan, output, listings);
    quote! {
        #[doc = #doc]
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct #name<T = f64> {
            #(#[doc = #field_docs] #fields,)*
        }

        #functions
        #program
        #values
        #coordinates
    }
}

/// The function from all data to the coefficients of results: statements, or a table.
fn coefficients(plan: &Plan, output: &PlannedOutput, listings: &mut Listings) -> TokenStream {
    let doc = " The coefficients of what is returned beside the unknowns, from all data.";
    let function = format_ident!("{COEFFICIENTS}");
    if output.program.form == ProgramForm::Statements {
        let name = (&function, doc);
        return code::shared_function(code::inputs_of(plan), name, &output.program, &output.coefficients, 1);
    }
    let table = ProgramTable::of_program(&output.program, plan.inputs(), &output.coefficients);
    let name = format_ident!("PROGRAM_OF_RESULTS");
    let program = program::static_program(&name, " From the data to the coefficients of results.", &table, listings);
    let [inputs, values, length] =
        [plan.inputs(), table.values, output.coefficients.len()].map(Literal::usize_unsuffixed);
    // Where there is a heap all values of the table are on it.
    let evaluate = match plan.is_on_heap() {
        true => quote! {
            let (memory, mut coefficients) = (emitted::Memory::new(), [0.0; #length]);
            #name.run(&[data], memory.filled(#values, 0.0).as_mut(), &mut coefficients);
            coefficients
        },
        false => quote!(#name.evaluate::<f64, #values, #length>(&[data])),
    };
    quote! {
        #[doc = #doc]
        fn #function(_: f64, data: &[f64; #inputs]) -> [f64; #length] {
            #evaluate
        }

        #program
    }
}

/// The functions that return an output.
fn functions(plan: &Plan, output: &PlannedOutput) -> TokenStream {
    let (name, what) = (format_ident!("{}", output.name), &output.function);
    let [of, of_each, solve_for] =
        [format_ident!("{what}_of"), format_ident!("{what}_of_each"), format_ident!("solve_for_{what}")];
    let parameters: Vec<_> = plan.data.iter().map(parameter).collect();
    let mut names = Names::of(&plan.data);
    let [solution, solutions, coefficients] = ["solution", "solutions", "coefficients"].map(|name| names.take(name));
    let [given, data, scaled] = ["given", "data", "scaled"].map(|name| names.take(name));
    let all_data =
        |otherwise: &TokenStream| derived::all_data(plan, Reader::Results, (&given, &quote!(#data)), otherwise);
    // An error of the solve comes before one of what only results are computed from.
    let (error, arguments) =
        (names.take("error"), plan.data.iter().map(|parameter| format_ident!("{}", parameter.name)));
    let for_solve = all_data(&quote!(.or_else(|#error| self::solve(#(#arguments),*).and(Err(#error)))));
    let all_data = all_data(&quote!());
    let compute = format_ident!("{COEFFICIENTS}");
    let workspace = names.take("workspace");
    let (make, made) = storage::default(plan, &workspace);
    let unread = derived::clear_unread(plan, &scaled);
    let binding = if unread.is_empty() { scaling::binding(plan, &scaled) } else { quote!(mut #scaled) };
    let copied = if plan.is_on_heap() { quote!(#workspace.memory().filled(1, #data)) } else { quote!(#data) };
    let instance = scaling::of_data(plan, &scaled, &made);
    quote! {
        /// What the problem returns for a solution.
        ///
        /// # Errors
        /// As [`solve`], for the data.
        pub fn #of<S: ::eliminant::Scalar>(
            #(#parameters,)*
            #solution: &Solution<S>,
        ) -> Result<#name<S>, ::eliminant::SolveError> {
            #all_data
            emitted::check_coefficients(&[], &#given)?;
            Ok(self::output(&self::#compute(1.0, &#data), #solution))
        }

        /// What the problem returns for each of these solutions, such as those of [`solve_batch`].
        ///
        /// # Errors
        /// As [`solve`], for the data.
        pub fn #of_each(
            #(#parameters,)*
            #solutions: &::eliminant::Solutions<Solution, MAX_SOLUTIONS>,
        ) -> Result<::eliminant::Solutions<#name, MAX_SOLUTIONS>, ::eliminant::SolveError> {
            #all_data
            emitted::check_coefficients(&[], &#given)?;
            let #coefficients = self::#compute(1.0, &#data);
            Ok(#solutions.map(|#solution| self::output(&#coefficients, &#solution)))
        }

        /// Like [`solve`], with what the problem returns for each solution.
        ///
        /// # Errors
        /// As [`solve`].
        pub fn #solve_for(
            #(#parameters),*
        ) -> Result<::eliminant::Solutions<#name, MAX_SOLUTIONS>, ::eliminant::SolveError> {
            #make
            #for_solve
            let #binding = #copied;
            #unread
            let #solutions = self::real_solutions_of(&mut #instance, &#given)?;
            let #coefficients = self::#compute(1.0, &#data);
            Ok(#solutions.map(|#solution| self::output(&#coefficients, &#solution)))
        }
    }
}

/// The function from all data to the coefficients of results.
const COEFFICIENTS: &str = "coefficients_of_results";

/// A reference to the coefficients of an instance.
fn coefficients_of(plan: &Plan, instance: &Ident) -> TokenStream {
    match storage::has_coefficients_on_heap(plan) {
        true => quote!(#instance.coefficients.as_ref()),
        false => quote!(&#instance.coefficients),
    }
}

/// The function from the coefficients and a solution to the output.
fn values(output: &PlannedOutput, coordinates: usize) -> TokenStream {
    let name = format_ident!("{}", output.name);
    let mut scalars = (0..).map(|at| {
        let at = Literal::usize_unsuffixed(at);
        quote!(scalars[#at])
    });
    let fields = output.fields.iter().map(|field| {
        let elements: Vec<TokenStream> = scalars.by_ref().take(field.scalars()).collect();
        let (name, value) = (format_ident!("{}", field.name), value_of(&field.shape, field.is_complex, &elements));
        quote!(#name: #value)
    });
    let function = format_ident!("results");
    let results = code::results(&function, [output.coefficients.len(), coordinates], output);
    let count = Literal::usize_unsuffixed(output.coefficients.len());
    quote! {
        #results

        fn output<S: ::eliminant::Scalar>(coefficients: &[f64; #count], solution: &Solution<S>) -> #name<S> {
            let scalars = self::#function(coefficients, &self::coordinates(solution));
            #name { #(#fields),* }
        }
    }
}

/// The function from a solution to the coordinates that an output is computed from.
fn coordinates(plan: &Plan, total: usize) -> TokenStream {
    let total = Literal::usize_unsuffixed(total);
    let mut scale = plan.unknowns.len()..;
    let fields = plan.fields.iter().map(|field| {
        let name = format_ident!("{}", field.name);
        match (field.is_projective, scale.clone().next()) {
            (true, Some(at)) => {
                scale.next();
                coordinates_in_chart(field, at)
            }
            _ => {
                let accessors = accessors(&field.shape, field.is_complex);
                let elements = accessors.zip(field.unknowns()).map(|(accessor, unknown)| {
                    let unknown = Literal::usize_unsuffixed(unknown);
                    quote!(x[#unknown] = solution.#name #accessor;)
                });
                quote!(#(#elements)*)
            }
        }
    });
    quote! {
        /// The unknowns; of vectors that are given up to scale the coordinates, then, of all of
        /// them, the last coordinates.
        fn coordinates<S: ::eliminant::Scalar>(solution: &Solution<S>) -> [S; #total] {
            let mut x = [S::ZERO; #total];
            #(#fields)*
            x
        }
    }
}

/// The coordinates of a vector of length 1 that is given up to scale, the last one at `last`.
fn coordinates_in_chart(field: &SolutionField, last: usize) -> TokenStream {
    let (name, chart) = (format_ident!("{}", field.name), chart_name(field));
    let factor = Literal::f64_unsuffixed(field.scale_of_chart());
    let places = field.unknowns().chain([last]).map(Literal::usize_unsuffixed);
    let rows = (0..field.scalars()).map(Literal::usize_unsuffixed);
    quote!(#(x[#places] = emitted::chart_entry(&#chart[#rows], &solution.#name).scale(#factor);)*)
}

/// The statement that drops points of an instance that do not satisfy the inequalities.
pub(super) fn filter(plan: &Plan, instance: &Ident) -> TokenStream {
    if plan.positive.is_empty() {
        return quote!();
    }
    let coefficients = coefficients_of(plan, instance);
    quote! {
        let coefficients: &[f64] = #coefficients;
        points.retain(|point| emitted::is_wanted(POSITIVE, |slot| coefficients[slot], point));
    }
}

/// The inequalities; nothing without any.
pub(super) fn inequalities(plan: &Plan) -> TokenStream {
    if plan.positive.is_empty() {
        return quote!();
    }
    let inequalities = plan.positive.iter().map(|terms| {
        let terms = terms.iter().map(|term| {
            let slot = Literal::u16_unsuffixed(term.coefficient.0);
            let exponents = term.exponents.iter().map(|&exponent| Literal::u8_unsuffixed(exponent));
            quote!((#slot, &[#(#exponents),*]))
        });
        quote!(&[#(#terms),*])
    });
    quote! {
        /// Polynomials that are positive at the solutions that are wanted.
        const POSITIVE: &[emitted::Inequality<'static>] = &[#(#inequalities),*];
    }
}
