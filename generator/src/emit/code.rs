//! Prints straight-line code.

use std::collections::BTreeSet;

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::parameter;
use crate::expression::rational::Rational;
use crate::plan::program::{Operation, ValueId};
use crate::plan::statements::{Place, Statements};
use crate::plan::{Plan, PlannedRecovery};
use crate::problem::DataParameter;

/// The function from the data to the coefficients, with the statements of [`Statements`].
pub(super) fn statements(plan: &Plan) -> TokenStream {
    let parameters = plan.data.iter().map(parameter);
    let planned = Statements::of(&plan.program, &plan.coefficients);
    let (inputs, locals) = inputs(plan, &planned);
    let values = format_ident!("{}", name_of_values(plan));
    let mut statements: Vec<TokenStream> = Vec::new();
    let mut printed: Vec<Expression> = Vec::with_capacity(plan.program.operations.len());
    for (operation, &place) in plan.program.operations.iter().zip(&planned.places) {
        let operand = |id: ValueId| &printed[id.0 as usize];
        let expression = match *operation {
            Operation::Constant(value) => Expression::atom(constant(value)),
            Operation::Input(input) => Expression::atom(inputs[input as usize].clone()),
            Operation::Add(a, b) => Expression::binary(operand(a), quote!(+), SUM, operand(b)),
            Operation::Subtract(a, b) => Expression::binary(operand(a), quote!(-), SUM, operand(b)),
            Operation::Multiply(a, b) => Expression::binary(operand(a), quote!(*), PRODUCT, operand(b)),
            Operation::Divide(a, b) => Expression::binary(operand(a), quote!(/), PRODUCT, operand(b)),
            Operation::Negate(a) => Expression::negated(operand(a)),
            Operation::Coefficient { sum, at } => {
                let terms = plan.program.product_sums[sum as usize].terms(at as usize);
                Expression::sum(terms.map(|(negative, a, b)| {
                    let product = Expression::binary(operand(a), quote!(*), PRODUCT, operand(b));
                    (negative, product)
                }))
            }
        };
        printed.push(match place {
            Place::Unread | Place::Inline => expression,
            Place::Slot(slot) => {
                let (slot, value) = (Literal::usize_unsuffixed(slot), expression.tokens);
                statements.push(quote!(#values[#slot] = #value;));
                Expression::atom(quote!(#values[#slot]))
            }
        });
    }
    let count = planned.slots;
    let declaration = match count {
        0 => quote!(),
        _ => quote!(let mut #values = [0.0; #count];),
    };
    let results = plan.coefficients.iter().map(|id| &printed[id.0 as usize].tokens);
    let length = plan.coefficients.len();
    quote! {
        /// The coefficients that the tables refer to.
        fn coefficients(#(#parameters),*) -> [f64; #length] {
            #(#locals)*
            #declaration
            #(#statements)*
            [#(#results),*]
        }
    }
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
}

impl Expression {
    fn atom(tokens: TokenStream) -> Self {
        Self { tokens, precedence: ATOM }
    }

    /// Left operands bind as tightly without parentheses, right ones do not.
    fn binary(a: &Self, operator: TokenStream, precedence: u8, b: &Self) -> Self {
        let (left, right) = (a.at_least(precedence), b.at_least(precedence + 1));
        Self { tokens: quote!(#left #operator #right), precedence }
    }

    fn negated(a: &Self) -> Self {
        let operand = a.at_least(SIGN);
        Self { tokens: quote!(-#operand), precedence: SIGN }
    }

    /// The first term is taken as it is, the others are added one after another.
    fn sum(mut terms: impl Iterator<Item = (bool, Self)>) -> Self {
        let first = match terms.next() {
            None => Self::atom(quote!(0.0)),
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

/// A name for the intermediate values that no parameter has.
fn name_of_values(plan: &Plan) -> String {
    let mut name = "v".to_owned();
    while plan.data.iter().any(|parameter| parameter.name == name) {
        name.push('_');
    }
    name
}

/// What stands for each scalar of the data, in flat order, and declarations of those that are read: `let gram_0_2 = gram[0][2];`.
fn inputs(plan: &Plan, statements: &Statements) -> (Vec<TokenStream>, Vec<TokenStream>) {
    let mut separator = "_".to_owned();
    let names = loop {
        let names: Vec<String> = plan.data.iter().flat_map(|parameter| names(parameter, &separator)).collect();
        let scalars = plan.data.iter().filter(|parameter| parameter.shape.is_empty()).count();
        let taken = plan.data.iter().filter(|parameter| names.contains(&parameter.name)).count();
        let different: BTreeSet<&String> = names.iter().collect();
        if different.len() == names.len() && taken == scalars {
            break names;
        }
        separator.push_str("at_");
    };
    let idents: Vec<_> = names.iter().map(|name| format_ident!("{name}")).collect();
    let elements = plan.data.iter().filter(|parameter| !parameter.shape.is_empty()).flat_map(|parameter| {
        let elements = elements(parameter).into_iter().enumerate();
        elements.map(|(at, element)| (parameter.first_input + at, element))
    });
    let locals = elements.filter(|(input, _)| statements.reads_input(&plan.program, *input)).map(|(input, element)| {
        let local = &idents[input];
        quote!(let #local = #element;)
    });
    (idents.iter().map(|ident| quote!(#ident)).collect(), locals.collect())
}

/// `gram_0_2` for every scalar of a parameter, in flat order.
fn names(parameter: &DataParameter, separator: &str) -> Vec<String> {
    let name = |indices: Vec<usize>| {
        indices.iter().fold(parameter.name.clone(), |name, index| format!("{name}{separator}{index}"))
    };
    indices(parameter).map(name).collect()
}

/// `gram[0][2]` for every scalar of a parameter, in flat order.
fn elements(parameter: &DataParameter) -> Vec<TokenStream> {
    let name = format_ident!("{}", parameter.name);
    let element = |indices: Vec<usize>| {
        let indices = indices.into_iter().map(Literal::usize_unsuffixed);
        quote!(#name #([#indices])*)
    };
    indices(parameter).map(element).collect()
}

/// The indices of every scalar of a parameter, in flat order.
fn indices(parameter: &DataParameter) -> impl Iterator<Item = Vec<usize>> {
    (0..parameter.len()).map(|flat| {
        let mut rest = flat;
        let mut indices = Vec::new();
        for &length in parameter.shape.iter().rev() {
            indices.push(rest % length);
            rest /= length;
        }
        indices.reverse();
        indices
    })
}

/// A constant in parentheses where it is not a plain positive number; fractions are divided as the interpreter does.
pub(super) fn constant(value: Rational) -> TokenStream {
    let magnitude = Literal::f64_unsuffixed((value.numerator() as f64).abs());
    let signed = if value.numerator() < 0 { quote!(-#magnitude) } else { quote!(#magnitude) };
    let denominator = Literal::f64_unsuffixed(value.denominator() as f64);
    match (value.denominator(), value.numerator() < 0) {
        (1, false) => signed,
        (1, true) => quote!((#signed)),
        _ => quote!((#signed / #denominator)),
    }
}

/// `x[unknown] = sum of terms`, for real and complex numbers.
pub(super) fn recovery(recovery: &PlannedRecovery) -> TokenStream {
    let unknown = recovery.unknown;
    let terms = recovery.terms.iter().map(|term| {
        let slot = usize::from(term.coefficient.0);
        let factors = term.exponents.iter().enumerate().flat_map(|(at, &e)| (0..e).map(move |_| quote!(* x[#at])));
        quote!(S::from_f64(self.coefficients[#slot]) #(#factors)*)
    });
    if recovery.terms.is_empty() {
        return quote!(x[#unknown] = S::ZERO;);
    }
    quote!(x[#unknown] = #(#terms)+*;)
}
