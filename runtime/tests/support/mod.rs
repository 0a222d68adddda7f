//! Seeded random numbers for the counts over many instances, and points that stand for solutions.
#![allow(missing_docs)]
#![allow(dead_code)]

pub(crate) mod conics;
pub(crate) mod rows;
#[cfg(feature = "alloc")]
pub(crate) mod two_conics;

use eliminant::{Complex, Scalar};
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{Rng, SeedableRng};

pub(crate) struct Random(Xoshiro256PlusPlus);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Random(Xoshiro256PlusPlus::seed_from_u64(seed))
    }

    /// Uniform in [0, 1).
    pub(crate) fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 * 2.0_f64.powi(-53)
    }

    /// Uniform in [-1, 1).
    pub(crate) fn symmetric(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// Uniform in 0..count.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        ((self.unit() * count as f64) as usize).min(count - 1)
    }

    pub(crate) fn matrix<const N: usize, const M: usize>(&mut self) -> [[f64; M]; N] {
        std::array::from_fn(|_| std::array::from_fn(|_| self.symmetric()))
    }
}

/// The distance to the next of some points, up to the sign of imaginary parts, which `Scalar` does
/// not show.
pub(crate) fn distance_to_next<S: Scalar>(points: &[[Complex<f64>; 2]], unknowns: &[S; 2]) -> f64 {
    let parts = unknowns.map(|x| (x.real(), (x - S::from_f64(x.real())).modulus()));
    let distance = |point: &[Complex<f64>; 2]| {
        let square = |j: usize| (parts[j].0 - point[j].re).powi(2) + (parts[j].1 - point[j].im.abs()).powi(2);
        (square(0) + square(1)).sqrt()
    };
    points.iter().map(distance).fold(f64::INFINITY, f64::min)
}
