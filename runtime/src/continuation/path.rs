//! The path of the data, from general data to those that were given.

extern crate alloc;

use alloc::vec::Vec;
use num_complex::Complex;

use crate::continuation::family::{Condition, Family};
use crate::number::Scalar;

/// How far the path is from the real axis, relative to its length.
const BEND: f64 = 1.0;

/// An entry is moved in proportion to its size, or to this part of the largest of its parameter.
const SMALL: f64 = 0.25;

/// Data d(t) for t from 1 to 0, all of them with the conditions of the problem.
///
/// ```text
///   s(t) = t + i t (1 - t)          complex in between, 1 and 0 at the ends
///   free          d + s e
///   symmetric     the same, with symmetric e
///   unit          (d + s e) / sqrt((d + s e)^T (d + s e))
///   rotation      (I - s [a])^-1 (I + s [a]) d      Cayley's map of a skew-symmetric matrix
///   line          direction and moment d + s e, without the part of the moment along the direction
///   rank          (I + s A) d (I + s B)
/// ```
///
/// The numbers e, a, A and B are drawn from a seed.
pub(crate) struct DataPath {
    target: Vec<f64>,
    parameters: Vec<(Condition, u32)>,
    size: f64,
    seed: u64,
}

impl DataPath {
    /// A path to the data of the family, whose beginning differs from them by that part of them.
    pub(crate) fn new(family: &Family<'_>, size: f64, seed: u64) -> Self {
        Self { target: family.data.into(), parameters: family.parameters.into(), size, seed }
    }

    /// The data that were given.
    pub(crate) fn target(&self) -> &[f64] {
        &self.target
    }

    /// The beginning, which is real.
    pub(crate) fn start(&self) -> Vec<f64> {
        self.at(1.0).iter().map(|x| x.re).collect()
    }

    /// The data at t.
    pub(crate) fn at(&self, t: f64) -> Vec<Complex<f64>> {
        let s = Complex { re: t, im: BEND * t * (1.0 - t) }.scale(self.size);
        let mut data: Vec<Complex<f64>> = self.target.iter().map(|&x| x.into()).collect();
        if t == 0.0 {
            return data;
        }
        let mut first = 0;
        for &(condition, length) in &self.parameters {
            let end = (first + length as usize).min(data.len());
            let draws = Draws { seed: self.seed, first };
            move_parameter(condition, &mut data[first..end], s, draws);
            first = end;
        }
        data
    }
}

/// Numbers from -1 to 1, each by its position.
#[derive(Clone, Copy)]
struct Draws {
    seed: u64,
    first: usize,
}

impl Draws {
    /// By the finaliser of SplitMix64 (Steele, Lea, Flood, "Fast splittable pseudorandom number
    /// generators", OOPSLA 2014).
    fn at(self, position: usize) -> f64 {
        let mut z = (self.first + position) as u64 + (self.seed << 32) + 1;
        z = z.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) as i64 as f64 / 9_223_372_036_854_775_808.0
    }
}

fn move_parameter(condition: Condition, data: &mut [Complex<f64>], s: Complex<f64>, draws: Draws) {
    match condition {
        Condition::Free => shift(data, s, |at| draws.at(at)),
        Condition::Symmetric(order) => {
            let order = (order as usize).max(1);
            shift(data, s, |at| {
                let (block, row, column) = (at / (order * order), at / order % order, at % order);
                draws.at((block * order + row.min(column)) * order + row.max(column))
            });
        }
        Condition::Unit(length) => {
            shift(data, s, |at| draws.at(at));
            for vector in data.chunks_mut((length as usize).max(1)) {
                let factor = dot(vector, vector).sqrt().reciprocal();
                vector.iter_mut().for_each(|x| *x *= factor);
            }
        }
        Condition::Rotation => {
            for (number, rotation) in data.chunks_exact_mut(9).enumerate() {
                let axis = [0, 1, 2].map(|at| s.scale(draws.at(9 * number + at)));
                turn(rotation, axis);
            }
        }
        Condition::Plucker => {
            shift(data, s, |at| draws.at(at));
            for line in data.chunks_exact_mut(6) {
                let (direction, moment) = line.split_at_mut(3);
                let part = dot(direction, moment) * dot(direction, direction).reciprocal();
                moment.iter_mut().zip(direction).for_each(|(m, d)| *m -= part * *d);
            }
        }
        Condition::Rank(rows, columns) => {
            let [rows, columns] = [rows, columns].map(|count| (count as usize).max(1));
            for (number, matrix) in data.chunks_exact_mut(rows * columns).enumerate() {
                // Beyond the numbers that others draw.
                let draw = |at: usize| s.scale(draws.at((number + 1) * 65_536 + at));
                let moved: Vec<_> = (0..rows * columns)
                    .map(|at| {
                        let (row, column) = (at / columns, at % columns);
                        let sum = |i: usize| {
                            (0..rows).fold(matrix[row * columns + i], |sum, k| {
                                sum + draw(row * rows + k) * matrix[k * columns + i]
                            })
                        };
                        (0..columns).fold(sum(column), |total, k| total + sum(k) * draw(4_096 + k * columns + column))
                    })
                    .collect();
                matrix.copy_from_slice(&moved);
            }
        }
    }
}

/// Adds s times a number of the size of each entry.
fn shift(data: &mut [Complex<f64>], s: Complex<f64>, draw: impl Fn(usize) -> f64) {
    let largest = data.iter().map(|x| x.magnitude()).fold(0.0, f64::max);
    let least = if largest > 0.0 { SMALL * largest } else { 1.0 };
    for (at, x) in data.iter_mut().enumerate() {
        *x += s.scale(draw(at) * x.magnitude().max(least));
    }
}

/// The product without conjugation, which is analytic.
fn dot(a: &[Complex<f64>], b: &[Complex<f64>]) -> Complex<f64> {
    a.iter().zip(b).fold(Complex::ZERO, |sum, (a, b)| sum + a * b)
}

/// Turns a rotation matrix by Cayley's map of a vector.
fn turn(rotation: &mut [Complex<f64>], a: [Complex<f64>; 3]) {
    let square = dot(&a, &a);
    let one: Complex<f64> = Complex::ONE;
    let (cosine, inverse) = (one - square, (one + square).reciprocal());
    for column in 0..3 {
        let x = [0, 1, 2].map(|row| rotation[3 * row + column]);
        let along = dot(&a, &x);
        for row in 0..3 {
            let (next, last) = ((row + 1) % 3, (row + 2) % 3);
            let cross = a[next] * x[last] - a[last] * x[next];
            let turned = x[row] * cosine + (a[row] * along + cross).scale(2.0);
            rotation[3 * row + column] = turned * inverse;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elimination::program::{ProductSums, Program};
    use alloc::vec;

    fn path(condition: Condition, data: &[f64]) -> DataPath {
        let lists = ProductSums { sums: &[], products: &[], factors: &[], places: &[] };
        let program = Program { constants: &[], runs: &[], operands: &[], product_sums: lists, results: &[] };
        let family = Family {
            data,
            inputs: data.len(),
            parameters: &[(condition, data.len() as u32)],
            program,
            counts: (0, 0),
            unknowns: 0,
            chain: &[],
            ends: &[],
            terms: &[],
        };
        DataPath::new(&family, 0.25, 3)
    }

    fn near(x: Complex<f64>, y: f64) -> bool {
        (x - y).modulus() < 1e-14
    }

    const TURN: [f64; 9] = [0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];

    #[test]
    fn paths_end_at_the_data_and_begin_at_real_ones() {
        let matrix = [1.0, 2.0, 3.0, 2.0, 4.0, 6.0];
        for (condition, data) in [
            (Condition::Free, vec![0.0, 1.0, -2.0]),
            (Condition::Symmetric(2), vec![1.0, 2.0, 2.0, 3.0]),
            (Condition::Unit(2), vec![0.6, 0.8, 0.0, 1.0]),
            (Condition::Rotation, TURN.to_vec()),
            (Condition::Plucker, vec![0.0, 0.0, 1.0, 2.0, 1.0, 0.0]),
            (Condition::Rank(2, 3), matrix.to_vec()),
        ] {
            let path = path(condition, &data);
            assert_eq!(path.at(0.0), data.iter().map(|&x| x.into()).collect::<Vec<_>>());
            assert!(path.at(1.0).iter().all(|x| x.im == 0.0), "{condition:?}");
            let start = path.start();
            let moved = start.iter().zip(&data).filter(|(a, b)| (**a - **b).abs() > 1e-4).count();
            assert!(2 * moved > data.len(), "{condition:?}: {start:?}");
            assert!(path.at(0.5).iter().any(|x| x.im.abs() > 1e-4), "{condition:?}");
        }
    }

    #[test]
    fn data_keep_their_conditions() {
        for t in [1.0, 0.7, 0.1] {
            let unit = path(Condition::Unit(3), &[0.6, 0.8, 0.0, 0.0, 0.0, 1.0]).at(t);
            assert!(unit.chunks(3).all(|vector| near(dot(vector, vector), 1.0)));
            let symmetric = path(Condition::Symmetric(2), &[1.0, 2.0, 2.0, 3.0]).at(t);
            assert_eq!(symmetric[1], symmetric[2]);
            let line = path(Condition::Plucker, &[0.0, 0.0, 1.0, 2.0, 1.0, 0.0]).at(t);
            assert!(near(dot(&line[..3], &line[3..]), 0.0));
            let rank = path(Condition::Rank(2, 3), &[1.0, 2.0, 3.0, 2.0, 4.0, 6.0]).at(t);
            assert!([0, 1].iter().all(|&k| near(rank[k] * rank[k + 4] - rank[k + 1] * rank[k + 3], 0.0)));
            let rotation = path(Condition::Rotation, &TURN).at(t);
            for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
                let product = dot(&rotation[3 * i..3 * i + 3], &rotation[3 * j..3 * j + 3]);
                assert!(near(product, f64::from(u8::from(i == j))), "{t}: {product}");
            }
        }
    }
}
