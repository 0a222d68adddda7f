//! Emitted code and interpreted plan give the same bits, and fail on the same data.

use eliminant_generator::algebra::Random;
use eliminant_generator::expression::arithmetic::Float64;
use eliminant_generator::plan::Plan;
use eliminant_generator::plan::interpret;
use eliminant_generator::problem::instance::draw_inputs;
use eliminant_tests::{Case, cases};

const INSTANCES: u64 = 2_000;

fn interpreted(plan: &Plan, inputs: &[f64]) -> Option<Vec<Vec<f64>>> {
    let coefficients = interpret::coefficients(plan, Float64, inputs)?;
    Some(interpret::eliminate(plan, Float64, &coefficients)?.action)
}

fn bits(matrix: &[Vec<f64>]) -> Vec<Vec<u64>> {
    matrix.iter().map(|row| row.iter().map(|x| x.to_bits()).collect()).collect()
}

/// Runs both on instances changed by `change`; returns how many of them were solved and how many refused.
fn compare(case: &Case, seed: u64, change: impl Fn(&mut Random, &mut Vec<f64>)) -> [usize; 2] {
    let plan = case.planned().plan;
    let mut counts = [0; 2];
    for k in 0..INSTANCES {
        let mut random = Random::new(seed + k);
        let mut inputs = draw_inputs(&plan.data, Float64, &mut random);
        change(&mut random, &mut inputs);
        let (emitted, interpreted) = ((case.action_matrix)(&inputs), interpreted(&plan, &inputs));
        match (&emitted, &interpreted) {
            (Ok(emitted), Some(interpreted)) => {
                assert_eq!(bits(emitted), bits(interpreted), "{}: other bits for {inputs:?}", case.name);
                counts[0] += 1;
            }
            (Err(_), None) => counts[1] += 1,
            _ => panic!("{}: emitted {emitted:?}, interpreted {interpreted:?} for {inputs:?}", case.name),
        }
    }
    counts
}

#[test]
fn on_random_data() {
    for case in cases() {
        let [solved, refused] = compare(&case, 1_000_000, |_, _| ());
        assert_eq!((solved, refused), (INSTANCES as usize, 0), "{}", case.name);
    }
}

/// Each input times its own power of ten, over ever wider ranges.
#[test]
fn on_badly_scaled_data() {
    for case in cases() {
        for range in [4.0, 20.0, 80.0, 300.0] {
            let counts = compare(&case, 2_000_000, |random, inputs| {
                inputs.iter_mut().for_each(|x| *x *= 10f64.powf(range * random.symmetric_unit()));
            });
            println!("{} scaled by up to 1e{range}: {} solved, {} refused", case.name, counts[0], counts[1]);
        }
    }
}

/// Zeros, ones and repeated values: singular blocks, pivots that tie, rows without entries.
#[test]
fn on_special_data() {
    for case in cases() {
        let counts = compare(&case, 3_000_000, |random, inputs| {
            for at in 0..inputs.len() {
                match random.below(5) {
                    0 => inputs[at] = 0.0,
                    1 => inputs[at] = 1.0,
                    2 => inputs[at] = inputs[random.below(at as u64 + 1) as usize],
                    3 => inputs[at] = -0.0,
                    _ => {}
                }
            }
        });
        println!("{} with special values: {} solved, {} refused", case.name, counts[0], counts[1]);
        assert!(counts[1] > 0 || case.problem().data.is_empty(), "{}: nothing was degenerate", case.name);
    }
}

#[test]
fn on_data_that_are_not_finite() {
    for case in cases().into_iter().filter(|case| !case.problem().data.is_empty()) {
        compare(&case, 4_000_000, |random, inputs| {
            let at = random.below(inputs.len() as u64) as usize;
            inputs[at] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY][random.below(3) as usize];
        });
    }
}
