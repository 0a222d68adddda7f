//! Random values of data, on the variety that their attributes describe.

use super::data::{DataAttribute, DataParameter};
use crate::algebra::{PrimeField, Random};
use crate::expression::arithmetic::{Arithmetic, Float64};
use crate::expression::rational::Rational;

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
pub(super) const MAX_REDRAWS: usize = 64;

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
