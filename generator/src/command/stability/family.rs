//! Families of instances that are drawn from what a problem states of its data.

use std::cell::Cell;

use super::instance::Instance;
use crate::algebra::Random;
use crate::expression::arithmetic::{Arithmetic, Float64};
use crate::expression::rational::Rational;
use crate::plan::Plan;
use crate::problem::draw::{Draw, draw_inputs};
use crate::problem::scene::DrawnScene;
use crate::problem::{DataAttribute, DataParameter, Scaling};
use crate::search::measuring::results::in_charts;
use crate::search::measuring::{random_instance, seed_of};

/// Which instances are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, clap::ValueEnum)]
pub(super) enum Family {
    /// Data drawn on their variety, uniformly where nothing else is stated
    Random,
    /// What the function of the problem file with the attribute `#[scene]` makes of drawn numbers,
    /// with the solution or the result that it says
    Scene,
    /// The same in other units, along the scalings under which the problem stays the same; the
    /// level is the power of ten
    Scaled,
    /// Two data nearly the same, or one coordinate of all data of a parameter nearly 0; the level
    /// is the power of ten of the distance
    Degenerate,
    /// Data with a condition, such as rotations, off it by a relative error; the level is its power
    /// of ten
    Noisy,
}

impl Family {
    /// All families, in the order of reports.
    pub(super) const ALL: [Self; 5] = [Self::Random, Self::Scene, Self::Scaled, Self::Degenerate, Self::Noisy];

    /// The name in reports and files.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::Scene => "scene",
            Self::Scaled => "scaled",
            Self::Degenerate => "degenerate",
            Self::Noisy => "noisy",
        }
    }

    /// The powers of ten that its instances take in turns.
    fn levels(self) -> &'static [i32] {
        match self {
            Self::Random | Self::Scene => &[],
            Self::Scaled => &[-8, -6, -4, -2, 2, 4, 6, 8],
            Self::Degenerate => &[-2, -4, -6, -8, -10, -12],
            Self::Noisy => &[-12, -9, -6, -3],
        }
    }

    /// `count` instances; none if the problem has no data of this kind, or no scene. Instance k
    /// depends on (seed, k) only.
    pub(super) fn instances(self, plan: &Plan, count: usize, seed: u64) -> Vec<Instance> {
        if plan.inputs() == 0 {
            // Without data there is one instance.
            let nothing = DrawnScene { data: Vec::new(), solution: None, results: None };
            return self.instance(plan, None, nothing).filter(|_| self == Self::Random).into_iter().collect();
        }
        let levels = self.levels();
        let draw = |k: usize| {
            // Each level meets all variants in turns.
            let (level, variant) = match levels.len() {
                0 => (None, k),
                many => (Some(levels[k % many]), k / many),
            };
            let drawn = self.draw(plan, level.unwrap_or(0), (seed, k, variant))?;
            self.instance(plan, level, drawn)
        };
        (0..count).map_while(draw).collect()
    }

    fn instance(self, plan: &Plan, level: Option<i32>, drawn: DrawnScene) -> Option<Instance> {
        let solutions: Option<Vec<_>> = drawn.solution.iter().map(|known| in_charts(plan, known).ok()).collect();
        Some(Instance {
            problem: plan.name.clone(),
            family: self.name().to_owned(),
            level: level.map(f64::from),
            data: drawn.data,
            solutions: solutions?,
            results: drawn.results.into_iter().collect(),
            note: None,
        })
    }

    fn draw(self, plan: &Plan, level: i32, (seed, k, variant): (u64, usize, usize)) -> Option<DrawnScene> {
        let mut random = Random::new(seed_of(seed, k));
        let data = match self {
            Self::Scene => return plan.scene.as_ref()?.draw(&mut random),
            Self::Random => Some(random_instance(plan, seed, k)),
            Self::Scaled => scaled(plan, level, variant, random_instance(plan, seed, k)),
            Self::Degenerate => degenerate(plan, 10f64.powi(level), variant, &mut random),
            Self::Noisy => noisy(plan, 10f64.powi(level), random_instance(plan, seed, k), &mut random),
        };
        data.map(|data| DrawnScene { data, solution: None, results: None })
    }
}

/// Binary exponents of factors of data are at most this: their squares stay in the range of `f64`.
const MOST: i32 = 400;

/// Data in units of 10^`level`, along one of the scalings that change unknowns. Those that change
/// elements of a vector up to scale are left out: points are judged by its coordinates in a chart,
/// which do not keep the digits of small elements.
fn scaled(plan: &Plan, level: i32, variant: usize, mut data: Vec<f64>) -> Option<Vec<f64>> {
    if !plan.derived.is_empty() {
        // The scalings are those of all data; given ones do not take derived ones along.
        return None;
    }
    let is_in_chart = |unknown: usize| plan.vectors_with_units().any(|field| field.unknowns().contains(&unknown));
    let has_weight = |scaling: &Scaling, unknown: usize| scaling.unknowns[unknown] != 0;
    let changing: Vec<_> = plan
        .scalings
        .iter()
        .filter(|scaling| {
            let mut changed = (0..plan.unknowns.len()).filter(|&unknown| has_weight(scaling, unknown)).peekable();
            changed.peek().is_some() && !changed.any(is_in_chart)
        })
        .collect();
    let scaling = changing.get(variant % changing.len().max(1))?;
    let largest = scaling.data.iter().map(|weight| i32::from(weight.abs())).max().unwrap_or(1).max(1);
    let exponent = ((f64::from(level) * 10f64.log2()).round() as i32).clamp(-MOST / largest, MOST / largest);
    // Powers of two change no digit.
    data.iter_mut().zip(&scaling.data).for_each(|(x, &weight)| *x *= 2f64.powi(i32::from(weight) * exponent));
    Some(data)
}

/// Data that satisfy conditions, each entry off by a relative error; `None` if no data have any.
fn noisy(plan: &Plan, size: f64, mut data: Vec<f64>, random: &mut Random) -> Option<Vec<f64>> {
    let has_condition = |parameter: &&DataParameter| {
        !matches!(parameter.attribute, DataAttribute::Generic | DataAttribute::Integer) && !parameter.is_empty()
    };
    plan.data.iter().find(has_condition)?;
    for parameter in plan.data.iter().filter(has_condition) {
        for x in data.iter_mut().skip(parameter.first_input).take(parameter.len()) {
            *x *= 1.0 + size * random.symmetric_unit();
        }
    }
    Some(data)
}

/// A vector, matrix or line among the data: the numbers that are drawn for it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Element {
    parameter: usize,
    attribute: DataAttribute,
    first: usize,
    draws: usize,
}

/// The vectors, matrices and lines of the data, and how many numbers are drawn for all.
fn elements(plan: &Plan) -> (Vec<Element>, usize) {
    let (mut elements, mut first) = (Vec::new(), 0);
    for (at, parameter) in plan.data.iter().enumerate() {
        let count = Cell::new(0);
        draw_inputs(std::slice::from_ref(parameter), Scripted { draws: &[], next: &count }, &mut Random::new(0));
        let own = match parameter.attribute {
            DataAttribute::Generic | DataAttribute::Integer | DataAttribute::Unit => 1,
            DataAttribute::Rotation | DataAttribute::Symmetric | DataAttribute::Rank(_) | DataAttribute::Plucker => 2,
        };
        let outer = parameter.shape.len().saturating_sub(own);
        let many = parameter.shape[..outer].iter().product::<usize>().max(1);
        let draws = count.get() / many;
        elements.extend((0..many).map(|k| Element {
            parameter: at,
            attribute: parameter.attribute,
            first: first + k * draws,
            draws,
        }));
        first += count.get();
    }
    elements.retain(|element| element.draws > 0);
    (elements, first)
}

/// Data at a distance from degenerate ones. The numbers from which data on their variety are made
/// are moved, so that the data stay on it: in turns, those of one element towards those of another
/// of its kind, and the last one of each element of a parameter towards 0.
fn degenerate(plan: &Plan, distance: f64, variant: usize, random: &mut Random) -> Option<Vec<f64>> {
    let (elements, count) = elements(plan);
    let mut draws: Vec<f64> = (0..count).map(|_| random.symmetric_unit()).collect();
    let pick = |random: &mut Random, many: usize| random.below(many as u64) as usize;
    let is_pair = |&(a, b): &(usize, usize)| {
        (elements[a].attribute, elements[a].draws) == (elements[b].attribute, elements[b].draws)
    };
    let pairs: Vec<(usize, usize)> =
        (0..elements.len()).flat_map(|b| (0..b).map(move |a| (a, b))).filter(is_pair).collect();
    match variant % 2 {
        0 if !pairs.is_empty() => {
            let (a, b) = pairs[pick(random, pairs.len())];
            for at in 0..elements[a].draws {
                let [from, to] = [a, b].map(|element| elements[element].first + at);
                draws[to] = draws[from] + distance * (draws[to] - draws[from]);
            }
        }
        _ if elements.is_empty() => return None,
        _ => {
            let parameter = elements[pick(random, elements.len())].parameter;
            for element in elements.iter().filter(|element| element.parameter == parameter) {
                draws[element.first + element.draws - 1] *= distance;
            }
        }
    }
    Some(draw_inputs(&plan.data, Scripted { draws: &draws, next: &Cell::new(0) }, random))
}

/// Numbers of `f64` of which "random" ones are those of a list, as long as it is.
#[derive(Clone, Copy)]
struct Scripted<'a> {
    draws: &'a [f64],
    next: &'a Cell<usize>,
}

impl Draw for Scripted<'_> {
    fn draw(self, random: &mut Random) -> f64 {
        let at = self.next.replace(self.next.get() + 1);
        self.draws.get(at).copied().unwrap_or_else(|| random.symmetric_unit())
    }
}

impl Arithmetic for Scripted<'_> {
    type Value = f64;

    fn constant(self, value: Rational) -> Option<f64> {
        Float64.constant(value)
    }
    fn add(self, a: f64, b: f64) -> f64 {
        a + b
    }
    fn sub(self, a: f64, b: f64) -> f64 {
        a - b
    }
    fn mul(self, a: f64, b: f64) -> f64 {
        a * b
    }
    fn div(self, a: f64, b: f64) -> Option<f64> {
        Float64.div(a, b)
    }
    fn pivot_size(self, a: f64) -> f64 {
        a.abs()
    }
    fn rounding(self) -> f64 {
        f64::EPSILON
    }
    fn zero(self) -> f64 {
        0.0
    }
    fn one(self) -> f64 {
        1.0
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::command::files::Loaded;

    fn committed(name: &str) -> Plan {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../templates/{name}.rs"));
        Loaded::read(&file, None).unwrap_or_else(|error| panic!("{error}")).planned.plan
    }

    /// The squared lengths of the unit vectors among the data of an instance.
    fn lengths(plan: &Plan, data: &[f64]) -> Vec<f64> {
        let units = plan.data.iter().filter(|parameter| parameter.attribute == DataAttribute::Unit);
        let vectors = units.flat_map(|parameter| data[parameter.first_input..][..parameter.len()].chunks(2));
        vectors.map(|vector| vector.iter().map(|x| x * x).sum()).collect()
    }

    /// Nearly degenerate data stay on their variety; noise leaves it by its own size.
    #[test]
    fn unit_vectors_keep_their_length_but_for_noise() {
        let plan = committed("relpose_5pt_generalized_angle");
        for (family, off) in [(Family::Random, 0.0), (Family::Degenerate, 0.0), (Family::Noisy, 3.0)] {
            let instances = family.instances(&plan, 24, 3);
            assert_eq!(instances.len(), 24, "{family:?}");
            for instance in instances {
                let most = off * 10f64.powf(instance.level.unwrap_or(0.0)) + 2e-15;
                let lengths = lengths(&plan, &instance.data);
                assert!(
                    !lengths.is_empty() && lengths.iter().all(|x| (x - 1.0).abs() <= most),
                    "{family:?} {lengths:?}"
                );
            }
        }
    }

    /// Two conics whose coefficients differ by about 10^level, and conics whose last coefficient is
    /// that small, in turns.
    #[test]
    fn degenerate_data_are_as_near_as_their_level_says() {
        let plan = committed("two_conics");
        for (k, instance) in Family::Degenerate.instances(&plan, 24, 3).into_iter().enumerate() {
            let distance = 10f64.powf(instance.level.expect("a level"));
            let (p, q) = instance.data.split_at(6);
            let apart = p.iter().zip(q).map(|(p, q)| (p - q).abs()).fold(0.0, f64::max);
            let near = if k / 6 % 2 == 0 { apart } else { p[5].abs().min(q[5].abs()) };
            assert!(near <= 2.1 * distance && near > 1e-4 * distance, "{k}: {near:e} at {distance:e}");
        }
    }

    #[test]
    fn scaled_data_keep_their_digits() {
        let plan = committed("trilateration");
        let random = Family::Random.instances(&plan, 8, 3);
        for (scaled, usual) in Family::Scaled.instances(&plan, 8, 3).iter().zip(&random) {
            let factor = scaled.data[0] / usual.data[0];
            let unit = 10f64.powf(scaled.level.expect("a level"));
            assert!((factor / unit).log2().abs() <= 0.51, "{factor:e} {unit:e}");
            assert!(scaled.data.iter().zip(&usual.data).all(|(a, b)| *a == factor * b), "powers of two");
        }
    }

    #[test]
    fn families_without_data_are_empty() {
        let plan = committed("katsura_5");
        let counts = Family::ALL.map(|family| family.instances(&plan, 5, 1).len());
        assert_eq!(counts, [1, 0, 0, 0, 0]);
    }
}
