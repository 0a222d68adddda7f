//! Prints what users see: the solution and the functions that return it.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::names::Names;
use super::shapes::{accessors, chart_name, doc_line, parameter, type_of, value_of};
use super::{derived, output, scaling, storage};
use crate::plan::Plan;
use crate::problem::SolutionField;
use crate::template::RootMethod;

/// The struct `Solution`, its conversions, and the constants that describe it.
pub(super) fn solution(plan: &Plan) -> TokenStream {
    let doc = format!(" A solution of `{}`: real, or complex with `T = Complex<f64>`.", plan.name);
    let names: Vec<_> = plan.fields.iter().map(|field| format_ident!("{}", field.name)).collect();
    let types = plan.fields.iter().map(|field| type_of(quote!(T), &field.shape, field.is_complex));
    let field_docs = plan.fields.iter().map(|field| {
        let kind = if field.is_complex { "complex " } else { "" };
        match (field.is_projective, &field.shape[usize::from(field.is_complex)..]) {
            (true, _) => format!(" The unknowns `{}`, given up to scale: of length 1.", field.name),
            (false, []) => format!(" The {kind}unknown `{}`.", field.name),
            (false, _) => format!(" The {kind}unknowns `{}`.", field.name),
        }
    });
    let elements = plan.fields.iter().zip(&names).flat_map(|(field, name)| {
        accessors(&field.shape, field.is_complex).map(move |accessor| quote!(self.#name #accessor))
    });
    let first = plan.fields.iter().scan(0, |next, field| {
        let first = *next;
        *next += field.scalars();
        Some(first)
    });
    let values = plan.fields.iter().zip(first).map(|(field, first)| value_of_unknowns(field, first));
    let texts: Vec<String> = plan.fields.iter().flat_map(SolutionField::names).collect();
    let [scalars, solutions] = [texts.len(), plan.solutions].map(Literal::usize_unsuffixed);
    let (points, points_with_units) = (points(plan), scaling::points(plan));
    quote! {
        #[doc = #doc]
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Solution<T = f64> {
            #(#[doc = #field_docs] pub #names: #types,)*
        }

        /// The names of the unknowns, in the order of [`Solution::to_array`].
        pub const UNKNOWNS: [&str; #scalars] = [#(#texts),*];

        /// The number of complex solutions for general data. No call returns more.
        pub const MAX_SOLUTIONS: usize = #solutions;

        impl<T: Copy> Solution<T> {
            /// The unknowns in the order of [`UNKNOWNS`].
            pub fn to_array(self) -> [T; #scalars] {
                [#(#elements),*]
            }
        }

        impl<T: Copy> From<[T; #scalars]> for Solution<T> {
            fn from(unknowns: [T; #scalars]) -> Self {
                Self { #(#names: #values),* }
            }
        }

        impl<T: Copy> From<Solution<T>> for [T; #scalars] {
            fn from(solution: Solution<T>) -> Self {
                solution.to_array()
            }
        }

        #points
        #points_with_units
    }
}

/// Solutions from the unknowns that are solved for, and back. They differ where vectors are given
/// up to scale: their unknowns are coordinates in a chart.
fn points(plan: &Plan) -> TokenStream {
    let unknowns = Literal::usize_unsuffixed(plan.unknowns.len());
    let names: Vec<_> = plan.fields.iter().map(|field| format_ident!("{}", field.name)).collect();
    let charts = plan.fields.iter().filter_map(|field| {
        let (name, size) = (chart_name(field), Literal::usize_unsuffixed(field.scalars()));
        let doc = format!(" From coordinates, the last of which is 1, to `{}`, up to scale, and back.", field.name);
        let rows = field.chart()?.into_iter().map(|row| {
            let entries = row.into_iter().map(Literal::f64_unsuffixed);
            quote!([#(#entries),*])
        });
        Some(quote!(#[doc = #doc] const #name: [[f64; #size]; #size] = [#(#rows),*];))
    });
    let values = plan.fields.iter().map(|field| {
        let (chart, coordinates) = (chart_name(field), coordinates(field));
        match field.is_projective {
            true => quote!(emitted::from_chart(&#chart, &unknowns[#coordinates])),
            false => value_of_unknowns(field, field.first_unknown),
        }
    });
    let of_fields = plan.fields.iter().zip(&names).map(|(field, name)| {
        let (chart, coordinates) = (chart_name(field), coordinates(field));
        if field.is_projective {
            return quote!(emitted::to_chart(&#chart, &self.#name, &mut unknowns[#coordinates]););
        }
        let accessors = accessors(&field.shape, field.is_complex);
        let elements = accessors.zip(field.unknowns()).map(|(accessor, unknown)| {
            let unknown = Literal::usize_unsuffixed(unknown);
            quote!(unknowns[#unknown] = self.#name #accessor;)
        });
        quote!(#(#elements)*)
    });
    quote! {
        #(#charts)*

        impl<T: ::eliminant::Scalar> Solution<T> {
            /// The solution of the unknowns that are solved for: coordinates of a vector that is
            /// given up to scale.
            #[doc(hidden)]
            #[inline]
            pub fn from_unknowns(unknowns: [T; #unknowns]) -> Self {
                Self { #(#names: #values),* }
            }

            /// The unknowns that are solved for.
            #[doc(hidden)]
            #[inline]
            pub fn to_unknowns(self) -> [T; #unknowns] {
                let mut unknowns = [T::ZERO; #unknowns];
                #(#of_fields)*
                unknowns
            }
        }
    }
}

/// The range of the unknowns of a field.
fn coordinates(field: &SolutionField) -> TokenStream {
    let [first, end] = [field.unknowns().start, field.unknowns().end].map(Literal::usize_unsuffixed);
    quote!(#first..#end)
}

/// The unknowns from one on as the value of a field: `[unknowns[3], unknowns[4]]`.
fn value_of_unknowns(field: &SolutionField, first: usize) -> TokenStream {
    let scalars = (first..first + field.scalars()).map(|unknown| {
        let unknown = Literal::usize_unsuffixed(unknown);
        quote!(unknowns[#unknown])
    });
    value_of(&field.shape, field.is_complex, &scalars.collect::<Vec<_>>())
}

/// The functions from the data to solutions, and what measures a solution.
pub(super) fn functions(plan: &Plan) -> TokenStream {
    // An empty line between what the problem says and what is true for all.
    let end = (!plan.docs.is_empty()).then(String::new);
    let docs = plan.docs.iter().map(|line| doc_line(line)).chain(end);
    let parameters: Vec<_> = plan.data.iter().map(parameter).collect();
    let arguments: Vec<_> = plan.data.iter().map(|parameter| format_ident!("{}", parameter.name)).collect();
    let mut names = Names::of(&plan.data);
    let names = ["instance", "solution", "workspace"].map(|name| names.take(name));
    let workspace = &names[2];
    let measures = measures(plan, &parameters, &arguments, &names);
    let (collected, [real, complex]) = (collected(plan, &parameters, &arguments, &names), results());
    let ((make, made), given) = (storage::default(plan, workspace), storage::of_workspace(plan, workspace));
    let wanted = (!plan.positive.is_empty())
        .then_some(" Those that do not satisfy the inequalities of the problem are left out.");
    let wanted = wanted.iter();
    let operations = Literal::u64_unsuffixed(plan.operations_of_second_attempt() as u64);
    quote! {
        #(#[doc = #docs])*
        /// Returns the real solutions, polished on the equations of the problem: `Ok` and empty if
        /// there is none.
        #(#[doc = #wanted])*
        ///
        /// # Errors
        /// The data are not finite, or degenerate: see [`SolveError`](::eliminant::SolveError).
        pub fn solve(#(#parameters),*) -> #real {
            #make
            self::real_solutions(#made, #(#arguments),*)
        }

        /// Like [`solve`], with all complex solutions. Where solutions are missing, all is computed
        /// once more at twice the precision, which takes many times as long. Solutions are missing,
        /// too, where data make some of them coincide or move to infinity.
        ///
        /// # Errors
        /// As [`solve`].
        pub fn solve_complex(#(#parameters),*) -> #complex {
            #make
            self::complex_solutions(#made, #(#arguments),*)
        }

        /// Like [`solve`], in memory that solves before have left, and with the options of the
        /// workspace.
        ///
        /// # Errors
        /// As [`solve`].
        pub fn solve_in(#workspace: &mut ::eliminant::Workspace, #(#parameters),*) -> #real {
            self::real_solutions(#given, #(#arguments),*)
        }

        /// Like [`solve_complex`], in memory that solves before have left, and with the options of
        /// the workspace.
        ///
        /// # Errors
        /// As [`solve`].
        pub fn solve_complex_in(#workspace: &mut ::eliminant::Workspace, #(#parameters),*) -> #complex {
            self::complex_solutions(#given, #(#arguments),*)
        }

        /// The work of a second attempt: about as many operations at twice the precision. See
        /// [`SecondAttempts`](::eliminant::SecondAttempts).
        pub const SECOND_ATTEMPT_OPERATIONS: u64 = #operations;

        #collected
        #measures
    }
}

/// What the functions return: real and complex solutions.
fn results() -> [TokenStream; 2] {
    [quote!(Solution), quote!(Solution<::eliminant::Complex<f64>>)]
        .map(|solution| quote!(Result<::eliminant::Solutions<#solution, MAX_SOLUTIONS>, ::eliminant::SolveError>))
}

/// The functions that collect solutions, wherever matrices are kept. The names are those of an
/// instance, of a solution and of a workspace.
fn collected(plan: &Plan, parameters: &[TokenStream], arguments: &[Ident], names: &[Ident; 3]) -> TokenStream {
    let [instance, _, workspace] = names;
    let roots = match plan.roots() {
        RootMethod::Eigenvalues => quote!(real_solutions),
        RootMethod::Determinant => quote!(real_solutions_by_determinant),
    };
    let (constructor, kept) = (scaling::constructor(plan), storage::parameter(plan));
    let ([real, complex], to_solution) = (results(), scaling::to_solution(plan, &quote!(&#instance.exponents)));
    let filter = output::filter(plan, instance);
    let binding = if plan.positive.is_empty() { quote!(points) } else { quote!(mut points) };
    let mut names = Names::of(&plan.data);
    let [given, data] = ["given", "data"].map(|name| names.take(name));
    let binding_of_data = scaling::binding(plan, &data);
    let all_data = derived::data_of_solve(plan, &given, (&data, &binding_of_data), &quote!(#workspace));
    let made = scaling::of_data(plan, &data, &quote!(#workspace));
    let (count, lifetime) = (Literal::usize_unsuffixed(plan.data.len()), storage::elided(plan));
    quote! {
        fn real_solutions(#workspace: #kept, #(#parameters),*) -> #real {
            #all_data
            self::real_solutions_of(&mut #made, &#given)
        }

        fn real_solutions_of(#instance: &mut Instance #lifetime, given: &[&[f64]; #count]) -> #real {
            #instance.check(given)?;
            let #binding = emitted::#roots(#instance)?;
            #filter
            Ok(::eliminant::Solutions::from_points(&points, #to_solution))
        }

        fn complex_solutions(#workspace: #kept, #(#parameters),*) -> #complex {
            let mut #instance = Instance::#constructor(#workspace, #(#arguments),*)?;
            let points = emitted::complex_solutions(&mut #instance)?;
            Ok(::eliminant::Solutions::from_points(&points, #to_solution))
        }
    }
}

/// The functions that measure: the action matrix, and the residual of a solution. The names are
/// those of an instance, of a solution and of a workspace.
fn measures(plan: &Plan, parameters: &[TokenStream], arguments: &[Ident], names: &[Ident; 3]) -> TokenStream {
    let [instance, solution, workspace] = names;
    let basis = Literal::usize_unsuffixed(plan.elimination.basis);
    let constructor = scaling::constructor(plan);
    let to_unknowns = scaling::to_unknowns(plan, solution, instance);
    let (make, made) = storage::default(plan, workspace);
    let (matrix, convert) = match plan.has_basis_on_heap() {
        true => (quote!(emitted::HeapMatrix<#basis>), quote!(.map(emitted::HeapRows::into_vec))),
        false => (quote!([[f64; #basis]; #basis]), quote!()),
    };
    quote! {
        /// The matrix of multiplication by the action monomial on the basis, as the elimination
        /// gives it.
        ///
        /// # Errors
        /// As [`solve`].
        pub fn action_matrix(#(#parameters),*) -> Result<#matrix, ::eliminant::SolveError> {
            #make
            emitted::SolverInstance::action_matrix(&mut Instance::new(#made, #(#arguments),*)?) #convert
        }

        /// The relative residual of a solution: the largest |f| / (sum of the moduli of the terms
        /// of f) of all equations f = 0.
        ///
        /// # Errors
        /// As [`solve`], for the data.
        pub fn relative_residual<S: ::eliminant::Scalar>(
            #(#parameters,)*
            #solution: &Solution<S>,
        ) -> Result<f64, ::eliminant::SolveError> {
            #make
            let #instance = Instance::#constructor(#made, #(#arguments),*)?;
            Ok(emitted::SolverInstance::polish(&#instance, &mut #to_unknowns, 0))
        }

        /// A bound on the error of a solution: the largest error of an unknown that is solved for,
        /// relative to the largest of them, from steps of Newton's method whose residuals are
        /// computed at twice the precision. Infinity if no solution is known to be near: the
        /// Jacobian has lost rank, or the steps do not shorten.
        ///
        /// # Errors
        /// As [`solve`], for the data.
        pub fn error_bound<S: ::eliminant::Scalar>(
            #(#parameters,)*
            #solution: &Solution<S>,
        ) -> Result<f64, ::eliminant::SolveError> {
            #make
            let #instance = Instance::new(#made, #(#arguments),*)?;
            Ok(emitted::SolverInstance::error_bound(&#instance, &#solution.to_unknowns()))
        }
    }
}
