//! No data make a solver panic, hang, or return something that is no solution.

use std::sync::LazyLock;

use eliminant::{Complex, SolveError};
use eliminant_generator::algebra::Random;
use eliminant_generator::expression::arithmetic::Float64;
use eliminant_generator::plan::interpret;
use eliminant_generator::problem::draw::draw_inputs;
use eliminant_generator::problem::{DataAttribute, DataParameter, SolutionField};
use eliminant_tests::bounds::share;
use eliminant_tests::measure::are_distinct;
use eliminant_tests::statistics::complex;
use eliminant_tests::{Case, cases};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestRunner};
use rayon::iter::{IntoParallelIterator, ParallelIterator};

/// No solution may have a larger relative residual.
const MAX_RESIDUAL: f64 = 1e-10;

/// Data that satisfy these are no longer what they are when they are scaled.
const HAVE_NO_SCALE: [DataAttribute; 2] = [DataAttribute::Unit, DataAttribute::Rotation];

/// Operations that one test may take for one problem, without the polish; large templates see fewer
/// cases.
const WORK: usize = 50_000_000;

/// Random instances at each scale, if they are affordable.
const SCALED: usize = 100;
/// Instances at each scale that are tried of the largest problems.
const FEWEST: usize = 4;
/// Exponents of the scales at which nearly all instances must be solved completely.
const SCALES: [i32; 11] = [-10, -8, -6, -4, -2, 0, 2, 4, 6, 8, 10];
/// The share of instances that may lack a solution at each scale.
const INCOMPLETE: f64 = 0.05;

/// Problems of which solutions of extreme data are vectors up to scale whose small entries are lost
/// in the chart. All others keep the bound on residuals as it is.
const ROUNDED: [&str; 3] = ["pose_1pt_2line", "pose_2pt_1line", "pose_4pt_focal"];

/// Problems whose data have a unit: the exponents between which they are solved, and the share of
/// instances that are solved at the next exponents outside. A factor of the data is no factor of
/// the equations: it moves the solutions, the monomials of the basis differ by powers of it, and an
/// eigenvector in `f64` does not hold both.
const UNITS: [(&str, i32, i32); 13] = [
    // 0.75 at 4.
    ("calibration_6_receivers_4_senders", -4, 2),
    // 0.35 at 8: images in another unit have another distortion.
    ("fundamental_8pt_radial", -10, 6),
    // 0.63 at 8.
    ("pose_3pt_depths", -10, 6),
    // 3 of 5 at 6, and 0.76 at -10: images in another unit are other images.
    ("pose_3pt_upright_error_bound", -10, 4),
    ("pose_4pt_upright_error_bound", -8, 10),
    // 0.04 at 4: the mean of 1 stays 1, so that the square of the points' mean outgrows the means
    // of their squares.
    ("pose_npt_least_squares_quaternion", -10, 2),
    // 0.08 at 10, as before: the covariance, their difference, loses its rank.
    ("pose_npt_weak_perspective", -10, 8),
    // 0.30 at -6: images in another unit are other images.
    ("relpose_3pt_depths", -4, 10),
    // 0.92 of 600 instances at -6, which few do not tell.
    ("relpose_6pt_radial", -6, 4),
    // 0.06 at -4 and 0.00 at 4: the second camera is calibrated.
    ("relpose_7pt_focal_radial_one_side", -2, 2),
    // 0.00 at -4 and 0.73 at 4: as before.
    ("relpose_7pt_focal_radial_one_side_eliminated", -2, 2),
    // 0.36 at 4: images in pixels, with cameras of another unit, are other images.
    ("triangulation_3view", -10, 2),
    // 0.05 at 8.
    ("triangulation_3view_relaxed", -10, 6),
];

/// A case with the shapes of its data.
struct Subject {
    case: Case,
    data: Vec<DataParameter>,
    solutions: usize,
    /// Of one solve.
    operations: usize,
    /// Those of the unknowns that are given up to scale.
    up_to_scale: Vec<SolutionField>,
    /// The largest of an equation.
    degree: i32,
}

/// Every problem. To plan them takes seconds, and the tests of this file share what they plan.
fn subjects() -> &'static [Subject] {
    static SUBJECTS: LazyLock<Vec<Subject>> = LazyLock::new(planned);
    &SUBJECTS
}

fn planned() -> Vec<Subject> {
    let subject = |case: Case| {
        let (plan, problem) = (case.planned().plan, case.problem());
        Subject {
            operations: plan.operations().total(),
            solutions: plan.solutions,
            degree: problem.polynomials().map(|equation| equation.degree()).max().unwrap_or(0),
            up_to_scale: problem.fields.into_iter().filter(|field| field.is_projective).collect(),
            data: problem.data,
            case,
        }
    };
    cases().into_iter().map(subject).collect()
}

impl Subject {
    /// How many of so many cases are tried.
    fn affordable(&self, cases: usize) -> usize {
        cases.min((WORK / self.operations).max(cases / 200))
    }

    /// Of so many cases that are like their neighbours, one in how many is tried.
    fn stride(&self, cases: usize) -> usize {
        cases.div_ceil((10 * WORK / self.operations).max(1))
    }

    fn inputs(&self) -> usize {
        self.data.iter().map(DataParameter::len).sum()
    }

    fn random(&self, seed: u64) -> Vec<f64> {
        draw_inputs(&self.data, Float64, &mut Random::new(seed))
    }

    /// All data that have a scale, times a factor.
    fn scaled(&self, mut data: Vec<f64>, factor: f64) -> Vec<f64> {
        for parameter in self.data.iter().filter(|parameter| !HAVE_NO_SCALE.contains(&parameter.attribute)) {
            data[parameter.first_input..][..parameter.len()].iter_mut().for_each(|x| *x *= factor);
        }
        data
    }

    /// Whether a factor of the data multiplies every equation by a power of it.
    fn is_homogeneous(&self) -> bool {
        let plan = self.case.planned().plan;
        let data = self.random(4);
        let coefficients = |data: &[f64]| interpret::coefficients(&plan, Float64, data).expect("random data");
        let (before, after) = (coefficients(&data), coefficients(&self.scaled(data, 2.0)));
        plan.equations.iter().all(|terms| {
            let ratios: Vec<f64> = terms
                .iter()
                .map(|term| usize::from(term.coefficient.0))
                .filter(|&at| before[at] != 0.0)
                .map(|at| after[at] / before[at])
                .collect();
            ratios.iter().all(|ratio| (ratio / ratios[0] - 1.0).abs() < 1e-9)
        })
    }

    /// How much the rounding of vectors of length 1 changes a term of an equation, relative to it.
    /// Coordinates in the chart are sums of all entries, wrong by a rounding of the largest, which
    /// may be all that there is of a small one.
    fn rounding(&self, x: &[Complex<f64>]) -> f64 {
        if !ROUNDED.contains(&self.case.name) {
            return 0.0;
        }
        let of_field = |field: &SolutionField| {
            // The last coordinate is 1.
            let sizes = x[field.unknowns()].iter().map(|x| x.re.hypot(x.im)).chain([1.0]);
            let largest = sizes.clone().fold(0.0, f64::max);
            let smallest = sizes.fold(largest, f64::min);
            field.scalars() as f64 * f64::EPSILON * largest / smallest
        };
        f64::from(self.degree) * self.up_to_scale.iter().map(of_field).fold(0.0, f64::max)
    }

    /// What must hold whatever the data are; `Err` says what does not. The number of solutions
    /// otherwise.
    fn check(&self, data: &[f64]) -> Result<usize, String> {
        let (real, all) = ((self.case.returned)(data), (self.case.returned_complex)(data));
        let finite = data.iter().all(|x| x.is_finite());
        for error in [real.as_ref().err(), all.as_ref().err(), (self.case.action_matrix)(data).as_ref().err()] {
            match (error, finite) {
                (Some(SolveError::NonFiniteInput), true) => return Err("finite data are refused as not finite".into()),
                (Some(SolveError::NonFiniteInput), false) | (_, true) => {}
                (other, false) => return Err(format!("data that are not finite give {other:?}")),
            }
        }
        let real = real.unwrap_or_default().into_iter().map(|real| (complex(&real.unknowns), real.residual)).collect();
        let all = all.unwrap_or_default().into_iter().map(|all| (all.unknowns, all.residual)).collect();
        let found: [Vec<(Vec<Complex<f64>>, f64)>; 2] = [real, all];
        for found in &found {
            if found.len() > self.solutions {
                return Err(format!("{} solutions of {}", found.len(), self.solutions));
            }
            for (x, residual) in found {
                if !x.iter().all(|x| x.re.is_finite() && x.im.is_finite()) {
                    return Err(format!("a solution is not finite: {x:?}"));
                }
                // False for NaN, too.
                let is_solution = *residual <= MAX_RESIDUAL + self.rounding(x);
                if !is_solution {
                    return Err(format!("the residual of {x:?} is {residual}"));
                }
            }
        }
        Ok(found[1].len())
    }

    /// On how many random instances, all their data times a power of ten, all complex solutions are
    /// found.
    fn complete(&self, exponent: i32, instances: usize) -> usize {
        let factor = power_of_ten(exponent);
        let is_complete = |seed: &usize| {
            let data = self.scaled(self.random(1000 + *seed as u64), factor);
            (self.case.solve_complex)(&data).is_ok_and(|all| all.len() == self.solutions && are_distinct(&all))
        };
        (0..instances).into_par_iter().filter(is_complete).count()
    }

    fn assert(&self, what: &str, data: &[f64]) -> usize {
        self.check(data).unwrap_or_else(|fault| panic!("{}, {what}: {fault}\n{data:?}", self.case.name))
    }
}

#[test]
fn a_value_that_is_not_finite_is_refused_wherever_it_stands() {
    for subject in subjects() {
        let data = subject.random(1);
        for at in 0..data.len() {
            for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let mut data = data.clone();
                data[at] = bad;
                subject.assert(&format!("{bad} at {at}"), &data);
            }
        }
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            subject.assert("nothing finite", &vec![bad; data.len()]);
        }
    }
}

/// The lower half is not read, so that a caller who fills the upper half only gets the right
/// result.
#[test]
fn the_upper_half_of_symmetric_data_is_enough() {
    let mut unread = 0;
    for subject in subjects() {
        let n = subject.data.first().and_then(|parameter| parameter.shape.last()).copied().unwrap_or(1);
        let mut data = subject.random(2);
        let expected = (subject.case.solve)(&data).expect("random data are not degenerate");
        for parameter in subject.data.iter().filter(|parameter| parameter.attribute == DataAttribute::Symmetric) {
            for at in (0..parameter.len()).filter(|at| at / n > at % n) {
                data[parameter.first_input + at] = 0.0;
                unread += 1;
            }
        }
        assert_eq!((subject.case.solve)(&data).as_ref(), Ok(&expected), "{}", subject.case.name);
    }
    assert_eq!(unread, 2 * 15);
}

/// Data without a finite number of solutions: an error, or solutions of the equations as they are.
#[test]
fn degenerate_data_are_refused_or_solved() {
    for subject in subjects() {
        let (n, random) = (subject.inputs(), subject.random(3));
        for value in [0.0, -0.0, 1.0, -1.0, f64::MIN_POSITIVE, 5e-324, f64::MAX, f64::EPSILON] {
            subject.assert(&format!("all {value}"), &vec![value; n]);
        }
        let zeros = (subject.case.solve)(&vec![0.0; n]);
        // A block of zeros is singular, and so is a matrix from which data are derived; a
        // coefficient that divides by the data is not finite.
        let refused = matches!(zeros, Err(SolveError::Degenerate { .. } | SolveError::LostRank | SolveError::Overflow));
        assert!(refused || subject.data.is_empty(), "{}: {zeros:?}", subject.case.name);
        let stride = subject.stride(8 * n).max(1);
        for at in (0..n).step_by(stride) {
            let mut one = vec![0.0; n];
            one[at] = 1.0;
            subject.assert("a single one", &one);
            let mut hole = random.clone();
            hole[at] = 0.0;
            subject.assert("a zero", &hole);
        }
        // Repeated measurements: the second half of the data repeats the first, exactly, scaled,
        // and up to rounding.
        for factor in [1.0, -1.0, 2.0, 1.0 + f64::EPSILON, 1.0 + 1e-12, 1.0 + 1e-8] {
            for period in (1..n).step_by(stride) {
                let repeated: Vec<f64> =
                    (0..n).map(|at| random[at % period] * factor.powi((at / period) as i32)).collect();
                subject.assert(&format!("period {period}, factor {factor}"), &repeated);
            }
        }
    }
}

/// Gram matrices of fewer rows than they have columns, and of rows that repeat.
#[test]
fn rank_deficient_gram_matrices_are_refused_or_solved() {
    let is_gram = |parameter: &DataParameter| parameter.attribute == DataAttribute::Symmetric;
    for subject in subjects().iter().filter(|subject| subject.data.first().is_some_and(is_gram)) {
        let n = subject.data[0].shape[0];
        for seed in 0..500 {
            let mut random = Random::new(seed);
            let rank = random.below(n as u64) as usize;
            let rows: Vec<Vec<f64>> = (0..rank).map(|_| (0..n).map(|_| random.symmetric_unit()).collect()).collect();
            let repeats = 1.0 + random.below(3) as f64;
            let entry = |at: usize| rows.iter().map(|row| repeats * row[at / n] * row[at % n]).sum();
            subject.assert(&format!("rank {rank}"), &(0..n * n).map(entry).collect::<Vec<f64>>());
        }
    }
}

/// A power of ten as a factor, subnormal numbers included.
fn power_of_ten(exponent: i32) -> f64 {
    10f64.powi(exponent / 2) * 10f64.powi(exponent - exponent / 2)
}

/// One common factor of all data but unit vectors and rotations, down to subnormal numbers and up
/// to overflow.
#[test]
fn huge_and_tiny_data_are_refused_or_solved() {
    for subject in subjects() {
        let exponents: Vec<i32> = (-320..=300).step_by(10).chain([-154, -150, 150, 154]).collect();
        let seeds = subject.affordable(10 * exponents.len()).div_ceil(exponents.len()) as u64;
        let mut solved = Vec::new();
        for exponent in exponents {
            for seed in 0..seeds {
                let data = subject.scaled(subject.random(seed), power_of_ten(exponent));
                if subject.assert(&format!("scale 1e{exponent}"), &data) == subject.solutions {
                    solved.push(exponent);
                }
            }
        }
        let range = (solved.iter().min(), solved.iter().max());
        println!("{}: all solutions are found on some instance at scales 10^ {range:?}", subject.case.name);
    }
}

/// Up to ten orders of magnitude from the unit of random data, all complex solutions are found on
/// nearly all instances, at every scale and for every problem. Where a problem has a unit this
/// holds for the scales that [`UNITS`] states.
#[test]
fn scaled_data_are_solved_completely() {
    let mut faults = Vec::new();
    for subject in subjects() {
        let unit = UNITS.iter().find(|(name, ..)| *name == subject.case.name);
        let (low, high) = unit.map_or((SCALES[0], SCALES[10]), |&(_, low, high)| (low, high));
        let few = (WORK / 4 / subject.operations).clamp(FEWEST, SCALED);
        let mut shares = Vec::new();
        for exponent in SCALES.into_iter().filter(|exponent| (low..=high).contains(exponent)) {
            // Of few instances chance decides: where they look bad, the same bound holds for more.
            let (mut wanted, mut incomplete) = (few, few - subject.complete(exponent, few));
            if share(incomplete, wanted) > INCOMPLETE {
                (wanted, incomplete) = (SCALED, SCALED - subject.complete(exponent, SCALED));
            }
            shares.push(format!("{:.2} at {exponent}", 1.0 - incomplete as f64 / wanted as f64));
            if share(incomplete, wanted) > INCOMPLETE {
                faults.push(format!("{}: {incomplete} of {wanted} at 1e{exponent} lack solutions", subject.case.name));
            }
        }
        println!("{}: of {few} instances or more all solutions are found on {}", subject.case.name, shares.join(", "));
        let outside = [low - 2, high + 2].into_iter().filter(|exponent| SCALES.contains(exponent));
        if unit.is_some() && outside.clone().all(|exponent| subject.complete(exponent, few) == few) {
            let outside: Vec<i32> = outside.collect();
            faults.push(format!("{}: is solved at {outside:?}, too; widen its range", subject.case.name));
        }
        if unit.is_some() && subject.is_homogeneous() {
            faults.push(format!("{}: a factor of the data does not change the problem", subject.case.name));
        }
    }
    let names: Vec<&str> = cases().iter().map(|case| case.name).collect();
    faults
        .extend(UNITS.iter().filter(|(name, ..)| !names.contains(name)).map(|(name, ..)| format!("no problem {name}")));
    assert!(faults.is_empty(), "{faults:#?}");
}

fn run(cases: u32, seed: u64, values: fn() -> BoxedStrategy<f64>) {
    subjects().into_par_iter().filter(|subject| subject.inputs() > 0).for_each(|subject| {
        let cases = subject.affordable(cases as usize) as u32;
        let config = Config { cases, rng_seed: RngSeed::Fixed(seed), failure_persistence: None, ..Config::default() };
        let data = proptest::collection::vec(values(), subject.inputs());
        let result =
            TestRunner::new(config).run(&data, |data| subject.check(&data).map(|_| ()).map_err(TestCaseError::fail));
        result.unwrap_or_else(|fault| panic!("{}: {fault}", subject.case.name));
    });
}

#[test]
fn arbitrary_bits() {
    run(1_000, 1, || any::<u64>().prop_map(f64::from_bits).boxed());
}

/// Finite, of a size whose cubes are finite, too: the elimination is reached.
#[test]
fn arbitrary_finite_values() {
    run(1_000, 2, || {
        let value = (any::<u64>(), -90i32..90).prop_map(|(bits, exponent)| {
            let mantissa = f64::from_bits((bits & 0x800f_ffff_ffff_ffff) | 0x3ff0_0000_0000_0000);
            mantissa * 2f64.powi(exponent)
        });
        value.boxed()
    });
}

/// Many zeros, ties, and values of wildly different size.
#[test]
fn mixtures_of_special_values() {
    // Most of these data are degenerate, and each such solve follows solutions from data nearby.
    run(500, 3, || {
        let tiny_and_huge = vec![1e150, 1e-150, -1e150, 5e-324, f64::MIN_POSITIVE, f64::MAX, 1e-8, 1e8, -0.0];
        let special = prop_oneof![
            6 => Just(0.0),
            4 => Just(1.0),
            2 => Just(-1.0),
            2 => (-3i32..4).prop_map(f64::from),
            4 => -1.0..1.0,
            1 => prop::sample::select(tiny_and_huge),
        ];
        special.boxed()
    });
}
