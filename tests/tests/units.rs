//! Solutions do not depend on the units of the data: of scenes in other units, solvers find as many
//! known solutions, as precisely.

use eliminant_generator::algebra::{PRIMES, PrimeField, Random};
use eliminant_generator::expression::SymbolicPolynomial;
use eliminant_generator::problem::chart::entry;
use eliminant_generator::problem::draw::Draw;
use eliminant_generator::problem::instance::Instance;
use eliminant_generator::problem::{Problem, Scaling};
use eliminant_generator::search::measuring::interpreted::InterpretedSolver;
use eliminant_tests::ground_truth::{FOUND, Maker, makers};
use eliminant_tests::measure::affordable;
use eliminant_tests::statistics::{log10, quantile};
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
fn measured(
    (case, maker): (&Case, &Maker),
    solver: &InterpretedSolver,
    scaling: &Scaling,
    exponent: i32,
    scenes: u64,
) -> Measured {
    let factor = |&weight: &i8| 2f64.powi(i32::from(weight) * exponent);
    let exponents: Vec<i16> = scaling.unknowns.iter().map(|&weight| i16::from(weight) * exponent as i16).collect();
    let of_scene = |k| {
        let instance = maker.make.draw(&mut Random::new(7_000_000 + k));
        let data: Vec<f64> = instance.data.iter().zip(&scaling.data).map(|(x, weight)| x * factor(weight)).collect();
        let returned = (case.returned)(&data).unwrap_or_default();
        let residuals: Vec<f64> = returned.iter().map(|solution| log10(solution.residual)).collect();
        let mut solutions: Vec<Vec<f64>> = returned.into_iter().map(|solution| solution.unknowns).collect();
        solutions.iter_mut().for_each(|solution| solver.unscale(&exponents, solution));
        let is_found = |truth: &&Vec<f64>| solutions.iter().any(|x| (maker.error)(&instance.data, x, truth) <= FOUND);
        (instance.truths.iter().filter(is_found).count(), instance.truths.len(), residuals)
    };
    let scenes: Vec<(usize, usize, Vec<f64>)> = (0..scenes).into_par_iter().map(of_scene).collect();
    let (found, all) = scenes.iter().fold((0, 0), |(found, all), scene| (found + scene.0, all + scene.1));
    let mut residuals: Vec<f64> = scenes.into_iter().flat_map(|scene| scene.2).collect();
    Measured { found: found as f64 / all as f64, residual: quantile(&mut residuals, 0.5) }
}

/// Q e over Z_p.
fn in_chart(field: PrimeField, vector: &[u32]) -> Vec<u32> {
    let size = vector.len();
    let fraction = |(numerator, denominator): (i64, i64)| {
        let inverse = field.inverse(field.from_integer(denominator)).expect("not 0");
        field.mul(field.from_integer(numerator), inverse)
    };
    let product = |row: usize, column: usize| field.mul(fraction(entry(size, row, column)), vector[column]);
    (0..size).map(|row| (0..size).fold(0, |sum, column| field.add(sum, product(row, column)))).collect()
}

/// The values of all polynomials of a problem over Z_p, at random data and unknowns that are scaled
/// by powers of `base`, and the product of the last coordinates of vectors up to scale by which
/// their coordinates were divided.
fn values(problem: &Problem, scaling: &Scaling, base: u32, seed: u64) -> (Vec<u32>, u32) {
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
    let (mut unknowns, mut divisor) = (Vec::new(), 1);
    for of_field in &problem.fields {
        let mut vector: Vec<u32> = of_field.unknowns().map(|_| field.draw(&mut random)).collect();
        if of_field.is_projective {
            vector.push(1);
            vector = in_chart(field, &vector);
        }
        vector.iter_mut().zip(&scaling.unknowns[of_field.unknowns()]).for_each(|(x, &weight)| *x = scaled(*x, weight));
        if of_field.is_projective {
            vector = in_chart(field, &vector);
            let last = vector.pop().expect("two or more");
            let inverse = field.inverse(last).expect("not 0");
            vector.iter_mut().for_each(|x| *x = field.mul(*x, inverse));
            divisor = field.mul(divisor, last);
        }
        unknowns.extend(vector);
    }
    let coefficients = problem.graph.evaluate(field, &inputs).expect("no divisor is 0");
    let polynomials = problem.equations.iter().chain(&problem.nonzero).map(|statement| &statement.polynomial);
    let value = |polynomial: &SymbolicPolynomial| {
        polynomial.terms().iter().fold(0, |sum, &(monomial, coefficient)| {
            let power = |(at, &x): (usize, &u32)| field.pow(x, monomial.exponent(at) as u32);
            let product = unknowns.iter().enumerate().map(power).fold(1, |product, power| field.mul(product, power));
            field.add(sum, field.mul(coefficients[coefficient.index()], product))
        })
    };
    (polynomials.map(value).collect(), divisor)
}

/// A scaling multiplies each polynomial by a number that depends on no data, and by a power of the
/// last coordinates of vectors up to scale: exactly, over Z_p.
#[test]
fn scalings_change_no_problem() {
    let field = PrimeField::new(PRIMES[0]);
    let mut count = 0;
    for case in cases() {
        let problem = case.problem();
        for scaling in &problem.scalings {
            count += 1;
            let [first, second, third] = [1, 2, 3].map(|seed| [1, 7].map(|base| values(&problem, scaling, base, seed)));
            for at in 0..first[0].0.len() {
                // Times the divisor to the power of the degree.
                let is_same = |degree: u32| {
                    let of = |(values, divisor): &(Vec<u32>, u32)| field.mul(values[at], field.pow(*divisor, degree));
                    let is_same = |[a, b]: &[(Vec<u32>, u32); 2]| {
                        field.mul(of(a), of(&first[1])) == field.mul(of(b), of(&first[0]))
                    };
                    is_same(&second) && is_same(&third)
                };
                assert!((0..20).any(is_same), "{}, {scaling:?}: polynomial {at}", case.name);
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
        let (scenes, solver) = (affordable(&plan, SCENES, WORK).max(FEWEST), InterpretedSolver::of(&plan));
        for scaling in plan.scalings.iter().filter(|scaling| scaling.unknowns.iter().any(|&weight| weight != 0)) {
            directions += 1;
            let usual = measured((&case, &maker), &solver, scaling, 0, scenes);
            let mut line = format!("{}, unknowns as {:?}, {scenes} scenes:", case.name, scaling.unknowns);
            for unit in UNITS {
                let exponent = (f64::from(unit) * 10f64.log2()).round() as i32;
                let scaled = measured((&case, &maker), &solver, scaling, exponent, scenes);
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
