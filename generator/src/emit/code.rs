//! Prints straight-line code.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};

use super::names::Names;
use super::parts::{Input, Locals, Statement, in_parts, names_in};
use super::shapes::indices;
use super::storage;
use crate::expression::rational::Rational;
use crate::plan::output::PlannedOutput;
use crate::plan::program::{Operation, Program, ValueId};
use crate::plan::statements::{MOST_TOGETHER, Place, Statements};
use crate::plan::{Plan, PlannedBlock, PlannedRecovery, Term};
use crate::problem::DataParameter;

/// The function from the data to the coefficients.
pub(super) fn statements(plan: &Plan) -> TokenStream {
    let doc = " The coefficients that the tables refer to, from all data, one parameter after another.";
    let code = function(inputs_of(plan), (&format_ident!("coefficients"), doc), &plan.program, &plan.coefficients);
    let [inputs, count] = [plan.inputs(), plan.coefficients.len()].map(Literal::usize_unsuffixed);
    let presolved = plan.is_presolved_at_run_time().then(|| {
        quote! {
            let mut data = *data;
            self::add_presolved(&mut data);
            let data = &data;
        }
    });
    quote! {
        // Where several instances are solved side by side, with the registers of that caller.
        #[inline(always)]
        #code

        /// Those of one instance, compiled once for all callers.
        #[inline(never)]
        fn coefficients_of(data: &[f64; #inputs]) -> [f64; #count] {
            #presolved
            self::coefficients(1.0, data)
        }
    }
}

/// A function from the data to values of a program, which is called from several places, but never
/// with several instances side by side. Its callers call so many functions like it: if it is short,
/// they get a copy.
pub(super) fn shared_function(
    given: (&[DataParameter], usize),
    name: (&Ident, &str),
    program: &Program,
    values: &[ValueId],
    functions: usize,
) -> TokenStream {
    let code = function(given, name, program, values);
    let is_short = program.steps() * functions <= MOST_TOGETHER;
    let attribute = if is_short { quote!(#[inline(always)]) } else { quote!(#[inline(never)]) };
    quote!(#attribute #code)
}

/// The data that are given, and the number of all data.
pub(super) fn inputs_of(plan: &Plan) -> (&[DataParameter], usize) {
    (&plan.data, plan.inputs())
}

/// A function from the data to values of a program, with the statements of [`Statements`].
fn function(
    (given, count): (&[DataParameter], usize),
    (name, doc): (&Ident, &str),
    program: &Program,
    values: &[ValueId],
) -> TokenStream {
    let locals = inputs(given, count);
    let mut names = Names::of(given);
    names.reserve(&locals);
    let [slots, data, one] = ["v", "data", "one"].map(|name| names.take(name));
    let values_of_locals = (0..count).map(|at| {
        let at = Literal::usize_unsuffixed(at);
        quote!(#data[#at])
    });
    let inputs: Vec<Input> =
        locals.into_iter().zip(values_of_locals).map(|(local, value)| Input { local, value }).collect();
    let code = body(program, values, (&slots, &one, &inputs), &mut names);
    let named = names_in(&code);
    let unread = [&one, &data].into_iter().filter(|name| !named.contains(&name.to_string()));
    let unread = unread.map(|name| quote!(let _ = #name;));
    let [count, length] = [count, values.len()].map(Literal::usize_unsuffixed);
    quote! {
        #[doc = #doc]
        fn #name<T: emitted::Arithmetic>(#one: T, #data: &[T; #count]) -> [T; #length] {
            #(#unread)*
            #code
        }
    }
}

/// The function from the coefficients of results, and the coordinates of a solution, to so many
/// scalars of results.
pub(super) fn results(name: &Ident, [coefficients, coordinates]: [usize; 2], output: &PlannedOutput) -> TokenStream {
    let named = |prefix: &str, count: usize, value: fn(Literal) -> TokenStream| {
        let input =
            |at: usize| Input { local: format_ident!("{prefix}_{at}"), value: value(Literal::usize_unsuffixed(at)) };
        (0..count).map(input).collect::<Vec<_>>()
    };
    let inputs = [
        named("c", coefficients, |at| quote!(one.constant(coefficients[#at]))),
        named("x", coordinates, |at| quote!(x[#at])),
    ]
    .concat();
    let mut names = Names::of(&[]);
    let [slots, one, ..] = ["v", "one", "coefficients", "x"].map(|name| names.take(name));
    names.reserve(&inputs.iter().map(|input| input.local.clone()).collect::<Vec<_>>());
    let code = body(&output.of_solution, &output.scalars, (&slots, &one, &inputs), &mut names);
    let [coefficients, coordinates, length] =
        [coefficients, coordinates, output.scalars.len()].map(Literal::usize_unsuffixed);
    quote! {
        /// The scalars of results, from their coefficients and the coordinates of a solution.
        #[allow(unused_variables)]
        fn #name<S: ::eliminant::Scalar + emitted::Arithmetic>(
            coefficients: &[f64; #coefficients],
            x: &[S; #coordinates],
        ) -> [S; #length] {
            let #one = S::ONE;
            #code
        }
    }
}

/// The statements that compute values of a program, and the array of these.
fn body(
    program: &Program,
    values: &[ValueId],
    (slots, one, inputs): (&Ident, &Ident, &[Input]),
    names: &mut Names,
) -> TokenStream {
    let planned = Statements::of(program, values);
    let (mut statements, printed) = printed(program, &planned, (slots, one, inputs), names);
    let locals = Locals { read: inputs_read(program, inputs, &planned) };
    let mut results: Vec<TokenStream> = values.iter().map(|id| printed[id.0 as usize].tokens.clone()).collect();
    let mut slot_count = planned.slots;
    if !planned.is_short {
        // What remains to be computed of them belongs to the parts, too.
        for (result, id) in results.iter_mut().zip(values) {
            let Expression { tokens: value, operations, .. } = &printed[id.0 as usize];
            let slot = Literal::usize_unsuffixed(slot_count);
            statements.push(Statement { tokens: quote!(#slots[#slot] = #value;), operations: *operations });
            *result = quote!(#slots[#slot]);
            slot_count += 1;
        }
    }
    let count = Literal::usize_unsuffixed(slot_count);
    let declaration = match slot_count {
        0 => quote!(),
        _ => quote!(let mut #slots = [#one.constant(0.0); #count];),
    };
    match planned.is_short {
        true => {
            let statements = statements.iter().map(|statement| &statement.tokens);
            let locals = locals.declared();
            quote!(#locals #declaration #(#statements)* [#(#results),*])
        }
        false => {
            let parts = in_parts(&statements, MOST_TOGETHER, one, &locals);
            quote!(#declaration #(#parts)* [#(#results),*])
        }
    }
}

/// The statements of a program, and how each of its values is read.
fn printed(
    program: &Program,
    planned: &Statements,
    (slots, one, inputs): (&Ident, &Ident, &[Input]),
    names: &mut Names,
) -> (Vec<Statement>, Vec<Expression>) {
    let mut statements = Vec::new();
    let mut printed: Vec<Expression> = Vec::with_capacity(program.operations.len());
    for (operation, &place) in program.operations.iter().zip(&planned.places) {
        let expression = Expression::of(program, *operation, &printed, (one, inputs));
        let Expression { tokens: value, operations, .. } = &expression;
        let (read, tokens) = match place {
            Place::Unread | Place::Inline => {
                printed.push(expression);
                continue;
            }
            Place::Variable(name) => {
                let name = names.take(&local_name(&program.names[name].1));
                (name.to_token_stream(), quote!(let #name = #value;))
            }
            Place::Slot(slot) => {
                let slot = Literal::usize_unsuffixed(slot);
                (quote!(#slots[#slot]), quote!(#slots[#slot] = #value;))
            }
        };
        statements.push(Statement { tokens, operations: *operations });
        printed.push(Expression::atom(read));
    }
    (statements, printed)
}

/// How tightly operators bind.
const SUM: u8 = 0;
const PRODUCT: u8 = 1;
const SIGN: u8 = 2;
const ATOM: u8 = 3;

/// Part of a statement.
struct Expression {
    tokens: TokenStream,
    /// How tightly its last operator binds.
    precedence: u8,
    /// The number of operators.
    operations: usize,
}

impl Expression {
    /// An operation on values that are printed. `one` and `inputs` are the variables of 1 and of
    /// the data.
    fn of(program: &Program, operation: Operation, printed: &[Self], (one, inputs): (&Ident, &[Input])) -> Self {
        let operand = |id: ValueId| &printed[id.0 as usize];
        match operation {
            Operation::Constant(value) => Self::constant(one, value),
            Operation::Input(input) => Self::atom(inputs[input as usize].local.to_token_stream()),
            Operation::Add(a, b) => Self::binary(operand(a), quote!(+), SUM, operand(b)),
            Operation::Subtract(a, b) => Self::binary(operand(a), quote!(-), SUM, operand(b)),
            Operation::Multiply(a, b) => Self::binary(operand(a), quote!(*), PRODUCT, operand(b)),
            Operation::Divide(a, b) => Self::binary(operand(a), quote!(/), PRODUCT, operand(b)),
            Operation::Negate(a) => Self::negated(operand(a)),
            Operation::Root(a) => Self::root(operand(a)),
            Operation::Coefficient { sum, at } => {
                let terms = program.product_sums[sum as usize].terms(at as usize);
                Self::sum(
                    one,
                    terms.map(|(negative, a, b)| {
                        let product = Self::binary(operand(a), quote!(*), PRODUCT, operand(b));
                        (negative, product)
                    }),
                )
            }
        }
    }

    fn constant(one: &Ident, value: Rational) -> Self {
        let value = constant(value);
        Self::atom(quote!(#one.constant(#value)))
    }

    fn atom(tokens: TokenStream) -> Self {
        Self { tokens, precedence: ATOM, operations: 0 }
    }

    /// Left operands bind as tightly without parentheses, right ones do not.
    fn binary(a: &Self, operator: TokenStream, precedence: u8, b: &Self) -> Self {
        let (left, right) = (a.at_least(precedence), b.at_least(precedence + 1));
        Self { tokens: quote!(#left #operator #right), precedence, operations: a.operations + b.operations + 1 }
    }

    fn negated(a: &Self) -> Self {
        let operand = a.at_least(SIGN);
        Self { tokens: quote!(-#operand), precedence: SIGN, operations: a.operations + 1 }
    }

    fn root(a: &Self) -> Self {
        let operand = a.at_least(ATOM);
        Self { tokens: quote!(#operand.sqrt()), precedence: ATOM, operations: a.operations + 1 }
    }

    /// The first term is taken as it is, the others are added one after another.
    fn sum(one: &Ident, mut terms: impl Iterator<Item = (bool, Self)>) -> Self {
        let first = match terms.next() {
            None => Self::atom(quote!(#one.constant(0.0))),
            Some((false, term)) => term,
            Some((true, term)) => Self::negated(&term),
        };
        terms.fold(first, |sum, (negative, term)| {
            let operator = if negative { quote!(-) } else { quote!(+) };
            Self::binary(&sum, operator, SUM, &term)
        })
    }

    /// In parentheses where it binds less tightly.
    fn at_least(&self, precedence: u8) -> TokenStream {
        let tokens = &self.tokens;
        if self.precedence < precedence { quote!((#tokens)) } else { tokens.clone() }
    }
}

/// `m[0][1]` as `m_0_1`.
fn local_name(name: &str) -> String {
    name.replace('[', "_").replace(']', "")
}

/// What stands for each scalar of the data, in flat order: `gram_0_2` for an element of an array.
fn inputs(data: &[DataParameter], count: usize) -> Vec<Ident> {
    let given: usize = data.iter().map(DataParameter::len).sum();
    let mut separator = "_".to_owned();
    loop {
        let of_given = data.iter().flat_map(|parameter| names(parameter, &separator));
        let derived = (0..count - given).map(|at| format!("derived{separator}{at}"));
        let names: Vec<String> = of_given.chain(derived).collect();
        let scalars = data.iter().filter(|parameter| parameter.shape.is_empty()).count();
        let taken = data.iter().filter(|parameter| names.contains(&parameter.name)).count();
        let different: BTreeSet<&String> = names.iter().collect();
        if different.len() == names.len() && taken == scalars {
            return names.iter().map(|name| format_ident!("{name}")).collect();
        }
        separator.push_str("at_");
    }
}

/// The data that are read.
fn inputs_read<'a>(program: &Program, inputs: &'a [Input], statements: &Statements) -> Vec<&'a Input> {
    let is_read = |(at, _): &(usize, &Input)| statements.reads_input(program, *at);
    inputs.iter().enumerate().filter(is_read).map(|(_, input)| input).collect()
}

/// `gram_0_2` for every scalar of a parameter, in flat order.
fn names(parameter: &DataParameter, separator: &str) -> Vec<String> {
    let name = |indices: Vec<usize>| {
        indices.iter().fold(parameter.name.clone(), |name, index| format!("{name}{separator}{index}"))
    };
    indices(&parameter.shape).map(name).collect()
}

/// A constant; fractions are divided as the interpreter does.
pub(super) fn constant(value: Rational) -> TokenStream {
    let magnitude = Literal::f64_unsuffixed((value.numerator() as f64).abs());
    let signed = if value.numerator() < 0 { quote!(-#magnitude) } else { quote!(#magnitude) };
    let denominator = Literal::f64_unsuffixed(value.denominator() as f64);
    if value.denominator() == 1 { signed } else { quote!(#signed / #denominator) }
}

/// The function that computes the unknowns that follow from those that were read.
pub(super) fn recovered(plan: &Plan) -> TokenStream {
    if plan.recovered().next().is_none() {
        return quote!();
    }
    let linear = plan.linear.as_ref().map(linear_block);
    let recoveries = plan.recoveries.iter().map(recovery);
    let unknowns = Literal::usize_unsuffixed(plan.unknowns.len());
    let (_, list) = storage::coefficients(plan, &quote!(C));
    quote! {
        /// Computes the unknowns that follow from those that were read.
        #[inline(always)]
        fn recovered<C: Copy, T: emitted::Over<C>>(coefficients: #list, x: &mut [T; #unknowns]) {
            #linear
            #(#recoveries)*
        }
    }
}

/// The unknowns of a linear block, by least squares.
fn linear_block(block: &PlannedBlock) -> TokenStream {
    let unknowns: Vec<Literal> = block.unknowns.iter().map(|&unknown| Literal::usize_unsuffixed(unknown)).collect();
    let rows = block.rows.iter().flatten().map(|entry| sum(entry, &unknowns[0]));
    quote! {
        let mut rows = [#(#rows),*];
        let mut linear = [#(x[#unknowns]),*];
        emitted::least_squares(&mut rows, &mut linear);
        [#(x[#unknowns]),*] = linear;
    }
}

/// `x[unknown] = sum of terms`.
fn recovery(recovery: &PlannedRecovery) -> TokenStream {
    let unknown = Literal::usize_unsuffixed(recovery.unknown);
    let sum = sum(&recovery.terms, &unknown);
    quote!(x[#unknown] = #sum;)
}

/// A sum of terms. `any` is an unknown, for a sum without terms.
fn sum(terms: &[Term], any: &Literal) -> TokenStream {
    if terms.is_empty() {
        return quote!(x[#any].constant(0.0));
    }
    let terms = terms.iter().map(|term| {
        let slot = Literal::u16_unsuffixed(term.coefficient.0);
        let factors = term.exponents.iter().enumerate().flat_map(|(at, &e)| {
            let at = Literal::usize_unsuffixed(at);
            std::iter::repeat_n(quote!(* x[#at]), e.into())
        });
        quote!(T::from_real(coefficients[#slot]) #(#factors)*)
    });
    quote!(#(#terms)+*)
}
