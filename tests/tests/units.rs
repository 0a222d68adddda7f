//! Solutions do not depend on the units of the data: of scenes in other units, solvers find as many
//! known solutions, as precisely.

use eliminant_generator::algebra::{PRIMES, PrimeField, Random};
use eliminant_generator::expression::SymbolicPolynomial;
use eliminant_generator::problem::Problem;
use eliminant_generator::problem::instance::Instance;
use eliminant_generator::problem::scaling::{Scaling, scalings};
use eliminant_tests::ground_truth::{FOUND, Maker, makers};
use eliminant_tests::measure::affordable;
use eliminant_tests::statistics::{complex, log10, quantile};
use eliminant_tests::{Case, cases};
use rayon::prelude::*;

/// Scenes of each problem and unit, if they are affordable.
const SCENES: u64 = 1_000;
/// Operations for all scenes of one problem with many solutions, and unit.
const WORK: u64 = 300_000_000;
/// Scenes of the largest problems.
const FEWEST: u64 = 10;
/// Powers of ten of the units.
const UNITS: [i32; 8] = [-8, -6, -4, -2, 2, 4, 6, 8];
/// How much smaller the share of known solutions that are found may be than in the unit of the
/// scenes.
const LESS: f64 = 0.01;
/// By which part of it the median of log10 of the residual may be larger.
const WORSE: f64 = 0.01;

/// What a solver does on scenes in one unit.
struct Measured {
    /// The share of known solutions that are found.
    found: f64,
    /// The median of log10 of the relative residual.
    residual: f64,
}

/// Measures scenes in a unit of 2^`exponent` in one direction of scalings.
fn measured(case: &Case, maker: &Maker, scaling: &Scaling, exponent: i32, scenes: u64) -> Measured {
    let factor = |&weight: &i8| 2f64.powi(i32::from(weight) * exponent);
    let of_scene = |k| {
        let instance = maker.make.draw(&mut Random::new(7_000_000 + k));
        let data: Vec<f64> = instance.data.iter().zip(&scaling.data).map(|(x, weight)| x * factor(weight)).collect();
        let solutions = (case.solve)(&data).unwrap_or_default();
        let residuals: Vec<f64> =
            solutions.iter().map(|x| log10((case.residual)(&data, &complex(x)).unwrap_or(f64::INFINITY))).collect();
        let unscaled = |x: &Vec<f64>| -> Vec<f64> {
            x.iter().zip(&scaling.unknowns).map(|(x, weight)| x / factor(weight)).collect()
        };
        let solutions: Vec<Vec<f64>> = solutions.iter().map(unscaled).collect();
        let is_found = |truth: &&Vec<f64>| solutions.iter().any(|x| (maker.error)(&instance.data, x, truth) <= FOUND);
        (instance.truths.iter().filter(is_found).count(), instance.truths.len(), residuals)
    };
    let scenes: Vec<(usize, usize, Vec<f64>)> = (0..scenes).into_par_iter().map(of_scene).collect();
    let (found, all) = scenes.iter().fold((0, 0), |(found, all), scene| (found + scene.0, all + scene.1));
    let mut residuals: Vec<f64> = scenes.into_iter().flat_map(|scene| scene.2).collect();
    Measured { found: found as f64 / all as f64, residual: quantile(&mut residuals, 0.5) }
}

/// The values of all polynomials of a problem over Z_p, at random data and unknowns that are scaled
/// by powers of `base`.
fn values(problem: &Problem, scaling: &Scaling, base: u32, seed: u64) -> Vec<u32> {
    let (field, mut random) = (PrimeField::new(PRIMES[0]), Random::new(seed));
    let scaled = |x: u32, weight: i8| {
        let factor = field.pow(base, u32::from(weight.unsigned_abs()));
        field.mul(x, if weight < 0 { field.inverse(factor).expect("not 0") } else { factor })
    };
    // Data of which all square roots exist.
    let given = Instance::draw(problem, field, seed).expect("data").inputs;
    let all = problem.graph.all_inputs(field, &given).expect("no divisor is 0");
    let inputs = all.into_iter().zip(&scaling.data);
    let inputs: Vec<u32> = inputs.map(|(x, &weight)| scaled(x, weight)).collect();
    let unknowns = scaling.unknowns.iter();
    let unknowns: Vec<u32> =
        unknowns.map(|&weight| scaled(random.below(field.modulus().into()) as u32, weight)).collect();
    let coefficients = problem.graph.evaluate(field, &inputs).expect("no divisor is 0");
    let polynomials = problem.equations.iter().chain(&problem.nonzero).map(|statement| &statement.polynomial);
    let value = |polynomial: &SymbolicPolynomial| {
        polynomial.terms().iter().fold(0, |sum, &(monomial, coefficient)| {
            let power = |(at, &x): (usize, &u32)| field.pow(x, monomial.exponent(at) as u32);
            let product = unknowns.iter().enumerate().map(power).fold(1, |product, power| field.mul(product, power));
            field.add(sum, field.mul(coefficients[coefficient.index()], product))
        })
    };
    polynomials.map(value).collect()
}

/// A scaling multiplies each polynomial by a number that depends on no data: exactly, over Z_p.
#[test]
fn scalings_change_no_problem() {
    let field = PrimeField::new(PRIMES[0]);
    let mut count = 0;
    for case in cases() {
        let problem = case.problem();
        for scaling in scalings(&problem) {
            count += 1;
            let [first, second] = [1, 2].map(|seed| [1, 7].map(|base| values(&problem, &scaling, base, seed)));
            for at in 0..first[0].len() {
                let products = [(&first[1], &second[0]), (&second[1], &first[0])].map(|(a, b)| field.mul(a[at], b[at]));
                assert_eq!(products[0], products[1], "{}, {scaling:?}: polynomial {at}", case.name);
            }
        }
    }
    assert!(count > 60, "only {count} scalings");
}

#[test]
fn known_solutions_are_found_in_all_units() {
    let (mut faults, mut directions) = (Vec::new(), 0);
    for case in cases() {
        let plan = case.planned().plan;
        let Some(maker) = makers().into_iter().find(|maker| maker.name == case.name) else { continue };
        if !plan.derived.is_empty() {
            // Scaled measurements have other null spaces: `results.rs` has tests of their units.
            continue;
        }
        let scenes = affordable(&plan, SCENES, WORK).max(FEWEST);
        for scaling in plan.scalings.iter().filter(|scaling| scaling.unknowns.iter().any(|&weight| weight != 0)) {
            directions += 1;
            let usual = measured(&case, &maker, scaling, 0, scenes);
            let mut line = format!("{}, unknowns as {:?}, {scenes} scenes:", case.name, scaling.unknowns);
            for unit in UNITS {
                let exponent = (f64::from(unit) * 10f64.log2()).round() as i32;
                let scaled = measured(&case, &maker, scaling, exponent, scenes);
                line += &format!(" 1e{unit} {:.4} {:.2},", scaled.found, scaled.residual);
                if scaled.found < usual.found - LESS || scaled.residual > (1.0 - WORSE) * usual.residual {
                    faults.push(format!("{}, {:?} at 1e{unit}", case.name, scaling.unknowns));
                }
            }
            println!("{line} in their own unit {:.4} {:.2}", usual.found, usual.residual);
        }
    }
    assert!(directions > 25, "only {directions} units");
    assert!(faults.is_empty(), "{faults:#?}");
}
