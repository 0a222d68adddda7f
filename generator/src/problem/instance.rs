//! Random data on the variety that the attributes of a problem describe, and the polynomials they
//! give.

use super::{DataAttribute, DataParameter, Problem};
use crate::algebra::{Polynomial, PrimeField, Random};
use crate::expression::arithmetic::{Arithmetic, Float64};
use crate::expression::derivation::DerivationKind;
use crate::expression::rational::Rational;
use crate::expression::{ExpressionGraph, ExpressionId, FINGERPRINT_FIELDS, NoValue, SymbolicPolynomial};

/// A field from which random elements are drawn.
pub trait Draw: Arithmetic {
    /// A generic element: uniform in Z_p, uniform in [-1, 1) over the reals.
    fn draw(self, random: &mut Random) -> Self::Value;
}

impl Draw for PrimeField {
    fn draw(self, random: &mut Random) -> u32 {
        random.below(u64::from(self.modulus())) as u32
    }
}

impl Draw for Float64 {
    fn draw(self, random: &mut Random) -> f64 {
        random.symmetric_unit()
    }
}

/// Values of all inputs of `data`, in order, drawn on their variety.
pub fn draw_inputs<A: Draw>(data: &[DataParameter], arithmetic: A, random: &mut Random) -> Vec<A::Value> {
    let mut inputs = Vec::new();
    for parameter in data {
        draw_parameter(parameter, arithmetic, random, &mut inputs);
    }
    inputs
}

fn draw_parameter<A: Draw>(parameter: &DataParameter, f: A, random: &mut Random, inputs: &mut Vec<A::Value>) {
    let count = parameter.len();
    let first = inputs.len();
    match parameter.attribute {
        DataAttribute::Generic => inputs.extend((0..count).map(|_| f.draw(random))),
        DataAttribute::Integer => inputs.extend((0..count).map(|_| {
            let value = random.below(21) as i64 - 10;
            f.constant(Rational::integer(value)).unwrap_or(f.zero())
        })),
        DataAttribute::Symmetric => {
            let n = parameter.shape.last().copied().unwrap_or(1);
            for at in 0..count {
                let (block, row, column) = (at / (n * n), at / n % n, at % n);
                let value = match row > column {
                    true => inputs[first + block * n * n + column * n + row],
                    false => f.draw(random),
                };
                inputs.push(value);
            }
        }
        DataAttribute::Rotation => {
            for _ in 0..count / 9 {
                inputs.extend(draw_rotation(f, random));
            }
        }
        DataAttribute::Unit => {
            let n = parameter.shape.last().copied().unwrap_or(1);
            for _ in 0..count / n.max(1) {
                draw_unit(f, random, n, inputs);
            }
        }
        DataAttribute::Plucker => {
            for _ in 0..count / 6 {
                inputs.extend(draw_line(f, random));
            }
        }
        DataAttribute::Rank(rank) => {
            let [.., rows, columns] = parameter.shape[..] else { return };
            for _ in 0..count / (rows * columns) {
                draw_of_rank(f, random, rank, [rows, columns], inputs);
            }
        }
    }
}

/// Limit on redraws of a parametrisation whose denominator vanished (probability about 1/p each).
const MAX_REDRAWS: usize = 64;

/// A rotation by the Cayley map of three drawn parameters: the quaternion (1, x, y, z), not
/// normalised.
fn draw_rotation<A: Draw>(f: A, random: &mut Random) -> [A::Value; 9] {
    for _ in 0..MAX_REDRAWS {
        let q = [f.one(), f.draw(random), f.draw(random), f.draw(random)];
        let product = |i: usize, j: usize| f.mul(q[i], q[j]);
        let [ww, xx, yy, zz] = [product(0, 0), product(1, 1), product(2, 2), product(3, 3)];
        let norm = f.add(f.add(ww, xx), f.add(yy, zz));
        let twice = |a: A::Value, b: A::Value| f.add(f.add(a, b), f.add(a, b));
        let minus = |i: usize, j: usize| f.neg(product(i, j));
        let matrix = [
            f.sub(f.add(ww, xx), f.add(yy, zz)),
            twice(product(1, 2), minus(0, 3)),
            twice(product(1, 3), product(0, 2)),
            twice(product(1, 2), product(0, 3)),
            f.sub(f.add(ww, yy), f.add(xx, zz)),
            twice(product(2, 3), minus(0, 1)),
            twice(product(1, 3), minus(0, 2)),
            twice(product(2, 3), product(0, 1)),
            f.sub(f.add(ww, zz), f.add(xx, yy)),
        ];
        if let Some(inverse) = f.div(f.one(), norm) {
            return matrix.map(|entry| f.mul(entry, inverse));
        }
    }
    let (o, z) = (f.one(), f.zero());
    [o, z, z, z, o, z, z, z, o]
}

/// A unit vector of length n by stereographic projection of n - 1 drawn parameters t:
/// (2 t, |t|^2 - 1) / (|t|^2 + 1).
fn draw_unit<A: Draw>(f: A, random: &mut Random, n: usize, inputs: &mut Vec<A::Value>) {
    for _ in 0..MAX_REDRAWS {
        let t: Vec<_> = (1..n).map(|_| f.draw(random)).collect();
        let square = t.iter().fold(f.zero(), |sum, &x| f.add(sum, f.mul(x, x)));
        if let Some(inverse) = f.div(f.one(), f.add(square, f.one())) {
            inputs.extend(t.iter().map(|&x| f.mul(f.add(x, x), inverse)));
            inputs.push(f.mul(f.sub(square, f.one()), inverse));
            return;
        }
    }
    inputs.extend((0..n).map(|i| if i == 0 { f.one() } else { f.zero() }));
}

/// Direction d and moment p x d of the line through the point p.
fn draw_line<A: Draw>(f: A, random: &mut Random) -> [A::Value; 6] {
    let [p, d]: [[A::Value; 3]; 2] = [0; 2].map(|_| [0; 3].map(|_| f.draw(random)));
    let moment = |i: usize, j: usize| f.sub(f.mul(p[i], d[j]), f.mul(p[j], d[i]));
    [d[0], d[1], d[2], moment(1, 2), moment(2, 0), moment(0, 1)]
}

/// The product of a rows x rank and a rank x columns matrix, both generic.
fn draw_of_rank<A: Draw>(f: A, random: &mut Random, rank: usize, shape: [usize; 2], inputs: &mut Vec<A::Value>) {
    let [rows, columns] = shape;
    let left: Vec<_> = (0..rows * rank).map(|_| f.draw(random)).collect();
    let right: Vec<_> = (0..rank * columns).map(|_| f.draw(random)).collect();
    for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
        let term = |k: usize| f.mul(left[row * rank + k], right[k * columns + column]);
        inputs.push((0..rank).fold(f.zero(), |sum, k| f.add(sum, term(k))));
    }
}

/// The seed of the fingerprint points; any constant does.
const FINGERPRINT_SEED: u64 = 0x656c_696d_696e_616e;

/// The two points at which expressions are told apart, see [`crate::expression::ExpressionGraph`].
pub fn fingerprint_points(data: &[DataParameter]) -> [Vec<u32>; 2] {
    let mut random = Random::new(FINGERPRINT_SEED);
    FINGERPRINT_FIELDS.map(|field| draw_inputs(data, field, &mut random))
}

/// Draws data over Z_p, and the values of all nodes, so that all square roots exist there: where
/// one does not, some of what it depends on is drawn again, as long as the roots before it exist.
/// `None` if that does not end.
fn draw_with_roots(problem: &Problem, f: PrimeField, random: &mut Random) -> Option<(Vec<u32>, Vec<u32>)> {
    let mut inputs = draw_inputs(&problem.data, f, random);
    let (mut next, mut missing) = (inputs.clone(), 0);
    for _ in 0..=MAX_REDRAWS * problem.graph.derivations().len() {
        match problem.graph.try_evaluate(f, &next) {
            Ok(values) => return Some((next, values)),
            Err(NoValue::Derivation(number)) if number >= missing => (inputs, missing) = (next, number),
            Err(NoValue::Derivation(_)) => {}
            Err(_) => return None,
        }
        next = inputs.clone();
        let operands = &problem.graph.derivations()[missing].operands;
        let which = redrawn(&problem.graph, missing, operands, random);
        redraw(&problem.data, (f, random), &mut next, &which);
    }
    None
}

/// Which of the given inputs are drawn again where the derivation of this number, of these
/// operands, has no value: those that it depends on and no square root before it does. If there are
/// none, one of all that it depends on.
pub(super) fn redrawn(
    graph: &ExpressionGraph,
    number: usize,
    operands: &[ExpressionId],
    random: &mut Random,
) -> Vec<bool> {
    let given = graph.derivations().first().map_or(graph.input_count(), |first| first.first_input);
    let mut own = graph.given_inputs_of(operands, given);
    let roots = graph.derivations()[..number].iter().filter(|before| before.kind == DerivationKind::SquareRoot);
    let before: Vec<ExpressionId> = roots.flat_map(|root| root.operands.iter().copied()).collect();
    let fixed = graph.given_inputs_of(&before, given);
    if own.iter().zip(&fixed).any(|(&own, &fixed)| own && !fixed) {
        own.iter_mut().zip(fixed).for_each(|(own, fixed)| *own &= !fixed);
        return own;
    }
    let all: Vec<usize> = (0..given).filter(|&input| own[input]).collect();
    let chosen = all.get(random.below(all.len().max(1) as u64) as usize).copied();
    (0..given).map(|input| Some(input) == chosen).collect()
}

/// Draws these inputs again; data that satisfy a condition all together.
pub(super) fn redraw<A: Draw>(
    data: &[DataParameter],
    (f, random): (A, &mut Random),
    inputs: &mut [A::Value],
    which: &[bool],
) {
    for parameter in data {
        let range = parameter.first_input..parameter.first_input + parameter.len();
        if !which[range.clone()].contains(&true) {
            continue;
        }
        let mut drawn = Vec::new();
        draw_parameter(parameter, f, random, &mut drawn);
        let is_free = parameter.attribute == DataAttribute::Generic;
        for (input, value) in range.zip(drawn).filter(|&(input, _)| which[input] || !is_free) {
            inputs[input] = value;
        }
    }
}

/// A problem with random data over Z_p.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Instance {
    /// The field.
    pub field: PrimeField,
    /// The values of the inputs.
    pub inputs: Vec<u32>,
    /// The equations.
    pub equations: Vec<Polynomial<u32>>,
    /// The polynomials that must not vanish.
    pub nonzero: Vec<Polynomial<u32>>,
}

impl Instance {
    /// Draws one. The support equals that of the problem: an instance on which a coefficient that
    /// depends on the data vanishes is drawn again; `None` if that never ends (for tiny domains
    /// such as `#[integer]` data it may).
    pub fn draw(problem: &Problem, field: PrimeField, seed: u64) -> Option<Self> {
        let mut random = Random::new(seed);
        (0..MAX_REDRAWS).find_map(|_| {
            let (inputs, values) = draw_with_roots(problem, field, &mut random)?;
            let image = |polynomial: &SymbolicPolynomial| {
                let image = polynomial.map(|c| Some(values[c.index()]).filter(|&value| value != 0));
                (image.terms().len() == polynomial.terms().len()).then_some(image)
            };
            Some(Self {
                field,
                equations: problem.polynomials().map(image).collect::<Option<_>>()?,
                nonzero: problem.nonzero.iter().map(|factor| image(&factor.polynomial)).collect::<Option<_>>()?,
                inputs,
            })
        })
    }
}
