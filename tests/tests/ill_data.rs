//! No data make a solver panic, hang, or return something that is no solution.

use eliminant::SolveError;
use eliminant_generator::algebra::Random;
use eliminant_generator::expression::arithmetic::Float64;
use eliminant_generator::plan::interpret;
use eliminant_generator::problem::instance::draw_inputs;
use eliminant_generator::problem::{DataAttribute, DataParameter};
use eliminant_tests::statistics::complex;
use eliminant_tests::{Case, cases};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestRunner};

/// No solution may have a larger relative residual.
const MAX_RESIDUAL: f64 = 1e-10;

/// Data that satisfy these are no longer what they are when they are scaled.
const HAVE_NO_SCALE: [DataAttribute; 2] = [DataAttribute::Unit, DataAttribute::Rotation];

/// Operations that one test may take for one problem, without the polish; large templates see fewer cases.
const WORK: usize = 200_000_000;

/// Problems whose equations the unit of their data changes so much that it must be that of the random ones within ten orders of magnitude.
const HAVE_A_UNIT: [&str; 16] = [
    "calibration_6_receivers_4_senders",
    "fundamental_9pt_two_radials",
    "orbit_5_lines_of_sight",
    "platform_forward_kinematics",
    "pose_3pt_depths",
    "pose_3pt_upright_error_bound",
    "pose_4pt_upright_error_bound",
    "pose_5pt_refraction",
    "pose_5tdoa_two_receivers",
    "relpose_5pt_semi_generalized_focal",
    "relpose_6pt_radial",
    "relpose_7pt_focal_radial",
    "relpose_7pt_focal_radial_one_side",
    "relpose_7pt_focal_radial_one_side_eliminated",
    "triangulation_3view",
    "triangulation_3view_relaxed",
];

/// A case with the shapes of its data.
struct Subject {
    case: Case,
    data: Vec<DataParameter>,
    solutions: usize,
    /// Of one solve.
    operations: usize,
}

fn subjects() -> Vec<Subject> {
    let subject = |case: Case| {
        let plan = case.planned().plan;
        Subject { operations: plan.operations().total(), solutions: plan.solutions, data: case.problem().data, case }
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

    /// What must hold whatever the data are; `Err` says what does not. The number of solutions otherwise.
    fn check(&self, data: &[f64]) -> Result<usize, String> {
        let (real, all) = ((self.case.solve)(data), (self.case.solve_complex)(data));
        let finite = data.iter().all(|x| x.is_finite());
        for error in [real.as_ref().err(), all.as_ref().err(), (self.case.action_matrix)(data).as_ref().err()] {
            match (error, finite) {
                (Some(SolveError::NonFiniteInput), true) => return Err("finite data are refused as not finite".into()),
                (Some(SolveError::NonFiniteInput), false) | (_, true) => {}
                (other, false) => return Err(format!("data that are not finite give {other:?}")),
            }
        }
        let real: Vec<_> = real.unwrap_or_default().iter().map(|x| complex(x)).collect();
        let all = all.unwrap_or_default();
        for found in [&real, &all] {
            if found.len() > self.solutions {
                return Err(format!("{} solutions of {}", found.len(), self.solutions));
            }
            for x in found {
                if !x.iter().all(|x| x.re.is_finite() && x.im.is_finite()) {
                    return Err(format!("a solution is not finite: {x:?}"));
                }
                let residual = (self.case.residual)(data, x);
                if !residual.is_ok_and(|residual| residual <= MAX_RESIDUAL) {
                    return Err(format!("the residual of {x:?} is {residual:?}"));
                }
            }
        }
        Ok(all.len())
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

/// The lower half is not read, so that a caller who fills the upper half only gets the right result.
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
    assert_eq!(unread, 2 * 15 + 36);
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
        // A block of zeros is singular; a coefficient that divides by the data is not finite.
        let refused = matches!(zeros, Err(SolveError::Degenerate { .. } | SolveError::Overflow));
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
        // Repeated measurements: the second half of the data repeats the first, exactly, scaled, and up to rounding.
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

/// One common factor of all data but unit vectors and rotations, down to subnormal numbers and up to overflow. Up to ten orders of magnitude all solutions are
/// found, but for problems that have a unit: there the factor moves the solutions, monomials of a basis differ by powers of it, and an eigenvector
/// in `f64` does not hold both.
#[test]
fn huge_and_tiny_data_are_refused_or_solved() {
    for subject in subjects() {
        let mut solved = Vec::new();
        let exponents: Vec<i32> = (-320..=300).step_by(5).chain([-154, -150, 150, 154]).collect();
        let seeds = subject.affordable(20 * exponents.len()).div_ceil(exponents.len()) as u64;
        for exponent in exponents {
            for seed in 0..seeds {
                let scale = 10f64.powi(exponent / 2) * 10f64.powi(exponent - exponent / 2);
                let data = subject.scaled(subject.random(seed), scale);
                if subject.assert(&format!("scale 1e{exponent}"), &data) == subject.solutions {
                    solved.push(exponent);
                }
            }
        }
        let range = (solved.iter().min(), solved.iter().max());
        println!("{}: all solutions found at scales 10^ {range:?}", subject.case.name);
        let has_a_unit = HAVE_A_UNIT.contains(&subject.case.name);
        assert!(!(has_a_unit && subject.is_homogeneous()), "{}: a factor does not change it", subject.case.name);
        let demanded: &[i32] = if has_a_unit { &[0] } else { &[0, -10, 10] };
        assert!(demanded.iter().all(|exponent| solved.contains(exponent)), "{}", subject.case.name);
    }
}

fn run(cases: u32, seed: u64, values: BoxedStrategy<f64>) {
    for subject in subjects().into_iter().filter(|subject| subject.inputs() > 0) {
        let cases = subject.affordable(cases as usize) as u32;
        let config = Config { cases, rng_seed: RngSeed::Fixed(seed), failure_persistence: None, ..Config::default() };
        let data = proptest::collection::vec(values.clone(), subject.inputs());
        let result =
            TestRunner::new(config).run(&data, |data| subject.check(&data).map(|_| ()).map_err(TestCaseError::fail));
        result.unwrap_or_else(|fault| panic!("{}: {fault}", subject.case.name));
    }
}

#[test]
fn arbitrary_bits() {
    run(5_000, 1, any::<u64>().prop_map(f64::from_bits).boxed());
}

/// Finite, of a size whose cubes are finite, too: the elimination is reached.
#[test]
fn arbitrary_finite_values() {
    let value = (any::<u64>(), -90i32..90).prop_map(|(bits, exponent)| {
        let mantissa = f64::from_bits((bits & 0x800f_ffff_ffff_ffff) | 0x3ff0_0000_0000_0000);
        mantissa * 2f64.powi(exponent)
    });
    run(5_000, 2, value.boxed());
}

/// Many zeros, ties, and values of wildly different size.
#[test]
fn mixtures_of_special_values() {
    let special = prop_oneof![
        6 => Just(0.0),
        4 => Just(1.0),
        2 => Just(-1.0),
        2 => (-3i32..4).prop_map(f64::from),
        4 => -1.0..1.0,
        1 => prop::sample::select(vec![1e150, 1e-150, -1e150, 5e-324, f64::MIN_POSITIVE, f64::MAX, 1e-8, 1e8, -0.0]),
    ];
    run(10_000, 3, special.boxed());
}
