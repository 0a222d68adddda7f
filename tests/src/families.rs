//! Families of data: what solvers are run on.

use eliminant_generator::algebra::Random;
use eliminant_generator::expression::arithmetic::Float64;
use eliminant_generator::problem::DataParameter;
use eliminant_generator::problem::draw::draw_inputs;

use crate::Case;
use crate::ground_truth::{Make, makers};

/// A family of data of one problem.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Family {
    /// Random data on the variety that the attributes of the problem describe.
    Random,
    /// Data of a scene: correspondences, ranges and matrices as the geometry of the problem makes
    /// them.
    Scene,
    /// Random data, each value times its own power of ten, with an exponent of up to so much.
    Scaled(f64),
    /// Random data with zeros, ones and repeated values: singular blocks, pivots that tie, empty
    /// rows.
    Special,
    /// Random data with one value that is not finite.
    NotFinite,
}

/// Draws data of one problem.
pub struct DataSource {
    data: Vec<DataParameter>,
    make: Make,
}

impl DataSource {
    /// The data of a problem.
    ///
    /// # Panics
    /// If there is no maker of scenes for the problem: a test checks that there is one for each.
    pub fn new(case: &Case) -> Self {
        let maker = makers().into_iter().find(|maker| maker.name == case.name);
        let make = maker.unwrap_or_else(|| panic!("no maker of scenes for {}", case.name)).make;
        Self { data: case.problem().data, make }
    }

    /// Whether the problem has no data.
    pub fn is_empty(&self) -> bool {
        self.data.iter().all(DataParameter::is_empty)
    }

    /// The data with this seed, flat as a [`Case`] takes them.
    pub fn draw(&self, family: Family, seed: u64) -> Vec<f64> {
        let mut random = Random::new(seed);
        if family == Family::Scene {
            return self.make.draw(&mut random).data;
        }
        let mut data = draw_inputs(&self.data, Float64, &mut random);
        match family {
            Family::Random | Family::Scene => {}
            Family::Scaled(range) => data.iter_mut().for_each(|x| *x *= 10f64.powf(range * random.symmetric_unit())),
            Family::Special => make_special(&mut data, &mut random),
            Family::NotFinite => {
                if !data.is_empty() {
                    let at = random.below(data.len() as u64) as usize;
                    data[at] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY][random.below(3) as usize];
                }
            }
        }
        data
    }
}

fn make_special(data: &mut [f64], random: &mut Random) {
    for at in 0..data.len() {
        match random.below(5) {
            0 => data[at] = 0.0,
            1 => data[at] = 1.0,
            2 => data[at] = data[random.below(at as u64 + 1) as usize],
            3 => data[at] = -0.0,
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases;

    /// Each family is what it says, for a problem with scalars and arrays.
    #[test]
    fn families_are_what_they_say() {
        let case = cases().into_iter().find(|case| case.name == "trilateration").expect("it is committed");
        let source = DataSource::new(&case);
        assert!(!source.is_empty());
        let range = |data: &[f64]| {
            let sizes = data.iter().map(|x| x.abs().log10());
            sizes.clone().fold(f64::NEG_INFINITY, f64::max) - sizes.fold(f64::INFINITY, f64::min)
        };
        let mut widest = [0.0_f64; 2];
        for seed in 0..100 {
            let random = source.draw(Family::Random, seed);
            assert_eq!((random.len(), random == source.draw(Family::Random, seed)), (12, true));
            assert!(random.iter().all(|x| x.abs() <= 1.0));
            let scene = source.draw(Family::Scene, seed);
            assert!(scene[9..].iter().all(|&distance| distance > 0.0), "{scene:?}");
            let scaled = source.draw(Family::Scaled(20.0), seed);
            widest = [widest[0].max(range(&random)), widest[1].max(range(&scaled))];
            let special = source.draw(Family::Special, seed);
            assert!(special.iter().zip(&random).any(|(a, b)| a == b) || special != random);
            let bad = source.draw(Family::NotFinite, seed);
            assert_eq!(bad.iter().filter(|x| !x.is_finite()).count(), 1);
        }
        assert!(widest[0] < 12.0 && widest[1] > 25.0, "{widest:?}");
    }
}
