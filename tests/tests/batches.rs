//! `solve_batch` returns what `solve` returns, up to rounding.

use eliminant::SolveError;
use eliminant_tests::families::{DataSource, Family};
use eliminant_tests::statistics::complex;
use eliminant_tests::{Case, cases};
use rayon::iter::{IntoParallelIterator, ParallelIterator};

/// Instances of each problem and family; an odd number, so that a group stays incomplete.
const INSTANCES: u64 = 203;
/// Fewer, for solvers that take a millisecond or more.
const FEW: u64 = 13;

/// Solutions may differ by this part of their largest unknown: that much rounding moves solutions
/// of badly conditioned instances.
const DIFFERENCE: f64 = 1e-6;

/// No solution of a batch may have a larger relative residual.
const MAX_RESIDUAL: f64 = 1e-10;

fn draw(case: &Case, family: Family) -> Vec<Vec<f64>> {
    let source = DataSource::new(case);
    let (time, _) = (case.time)(&[source.draw(family, 1)]);
    let count = if time.as_secs_f64() > 1e-3 { FEW } else { INSTANCES };
    (0..count).map(|k| source.draw(family, 7_000 + k)).collect()
}

/// Whether every point of a list has one of its own in the other list.
fn are_same(a: &[Vec<f64>], b: &[Vec<f64>]) -> bool {
    let is_same = |x: &[f64], y: &[f64]| {
        let largest = x.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        x.iter().zip(y).all(|(x, y)| (x - y).abs() <= DIFFERENCE * largest)
    };
    a.len() == b.len() && a.iter().all(|x| b.iter().any(|y| is_same(x, y)))
}

#[test]
fn batches_have_the_solutions_of_their_instances() {
    let subjects: Vec<(Case, Family)> =
        cases().into_iter().flat_map(|case| [(case, Family::Random), (case, Family::Scene)]).collect();
    let failures: Vec<String> = subjects
        .into_par_iter()
        .flat_map(|(case, family)| {
            let data = draw(&case, family);
            let results = (case.solve_batch)(&data);
            assert_eq!(results.len(), data.len());
            let failure = |k: usize| {
                let (data, of_batch) = (&data[k], &results[k]);
                let alone = (case.solve)(data);
                let worst = of_batch.iter().flatten().map(|x| (case.residual)(data, &complex(x)).unwrap_or(f64::NAN));
                let residuals_are_good = worst.into_iter().all(|residual| residual <= MAX_RESIDUAL);
                let is_equal = match (&alone, of_batch) {
                    (Ok(alone), Ok(of_batch)) => are_same(alone, of_batch),
                    (alone, of_batch) => alone == of_batch,
                };
                let message = || format!("{} {family:?} {k}: {alone:?} alone, {of_batch:?} in a batch", case.name);
                (!(is_equal && residuals_are_good)).then(message)
            };
            (0..data.len()).filter_map(failure).collect::<Vec<_>>()
        })
        .collect();
    assert!(failures.is_empty(), "{} differ:\n{}", failures.len(), failures.join("\n"));
}

/// Scenes in other units, in each direction of scalings that changes unknowns. Groups are scaled
/// lane by lane.
#[test]
fn batches_in_other_units() {
    let mut directions = 0;
    for name in ["circle_minimal", "pose_3pt_depths", "relpose_6pt_focal_one_side", "three_quadrics", "two_conics"] {
        let case = cases().into_iter().find(|case| case.name == name).expect("it is in the catalogue");
        let scenes = draw(&case, Family::Scene);
        for scaling in case.planned().plan.scalings.iter().filter(|scaling| scaling.unknowns.iter().any(|&w| w != 0)) {
            directions += 1;
            // Each instance in a unit of its own, most of them far from the usual one.
            let factor = |k: usize, weight: i8| 2f64.powi(i32::from(weight) * (9 * (k as i32 % 7) - 27));
            let scaled = |(k, scene): (usize, &Vec<f64>)| -> Vec<f64> {
                scene.iter().zip(&scaling.data).map(|(x, &weight)| x * factor(k, weight)).collect()
            };
            let unscaled = |k: usize, found: &[Vec<f64>]| -> Vec<Vec<f64>> {
                let point = |x: &Vec<f64>| x.iter().zip(&scaling.unknowns).map(|(x, &w)| x / factor(k, w)).collect();
                found.iter().map(point).collect()
            };
            let data: Vec<Vec<f64>> = scenes.iter().enumerate().map(scaled).collect();
            for (k, of_batch) in (case.solve_batch)(&data).iter().enumerate() {
                let alone = (case.solve)(&data[k]).expect("a scene");
                let of_batch = of_batch.as_ref().expect("a scene");
                assert!(are_same(&unscaled(k, &alone), &unscaled(k, of_batch)), "{name} {k}: {alone:?} {of_batch:?}");
            }
        }
    }
    assert!(directions >= 9, "only {directions} units");
}

#[test]
fn one_bad_instance_leaves_the_others_alone() {
    for case in cases() {
        let source = DataSource::new(&case);
        let mut data: Vec<Vec<f64>> = (0..9).map(|k| source.draw(Family::Random, k)).collect();
        if data[0].is_empty() {
            continue;
        }
        data[3][0] = f64::NAN;
        data[6].fill(0.0);
        let alone: Vec<_> = data.iter().map(|data| (case.solve)(data)).collect();
        let results = (case.solve_batch)(&data);
        assert_eq!(results[3], Err(SolveError::NonFiniteInput), "{}", case.name);
        for (k, (alone, of_batch)) in alone.iter().zip(&results).enumerate() {
            match (alone, of_batch) {
                (Ok(alone), Ok(of_batch)) => assert!(are_same(alone, of_batch), "{} {k}", case.name),
                _ => assert_eq!(alone, of_batch, "{} {k}", case.name),
            }
        }
    }
}

/// Solvers need not read every datum, such as both halves of a symmetric matrix, but all must be
/// finite.
#[test]
fn every_datum_must_be_finite() {
    for case in cases() {
        let good = DataSource::new(&case).draw(Family::Random, 1);
        let with = |(at, bad)| {
            let mut data = good.clone();
            data[at] = bad;
            data
        };
        for bad in [f64::NAN, f64::INFINITY] {
            let data: Vec<_> = (0..good.len()).map(|at| with((at, bad))).collect();
            for (at, result) in (case.solve_batch)(&data).into_iter().enumerate() {
                assert_eq!(result, Err(SolveError::NonFiniteInput), "{} with {bad} at {at}", case.name);
            }
        }
    }
}

/// Without it, the tests above would pass if every instance were solved by itself: all results
/// would then have the same bits. Lanes round differently, because they multiply and add in one
/// step. How many instances are solved by themselves shows in the benchmark.
#[test]
#[cfg(target_arch = "x86_64")]
fn some_instances_are_computed_side_by_side() {
    if !std::is_x86_feature_detected!("avx2") {
        eprintln!("skipped: the processor has no AVX2");
        return;
    }
    for name in ["circle_least_squares", "pose_3pt_depths", "relpose_5pt", "three_quadrics"] {
        let case = cases().into_iter().find(|case| case.name == name).expect("it is in the catalogue");
        let data = draw(&case, Family::Random);
        let results = (case.solve_batch)(&data);
        let differ = data.iter().zip(&results).filter(|(data, of_batch)| (case.solve)(data) != **of_batch).count();
        assert!(differ > 0, "{name}: all instances were solved by themselves");
    }
}

#[test]
fn lists_of_any_length_are_solved() {
    let case = cases().into_iter().find(|case| case.name == "two_conics").expect("it is in the catalogue");
    let source = DataSource::new(&case);
    for count in 0..20 {
        let data: Vec<Vec<f64>> = (0..count).map(|k| source.draw(Family::Random, k)).collect();
        let results = (case.solve_batch)(&data);
        assert_eq!(results.len(), data.len());
        for (data, of_batch) in data.iter().zip(results) {
            assert!(are_same(&(case.solve)(data).unwrap(), &of_batch.unwrap()));
        }
    }
}

#[test]
fn the_longer_list_is_left_alone() {
    use eliminant_solvers::two_conics::{Data, solve_batch};
    let data = [Data { p: [1.0, 0.0, 1.0, 0.0, 0.0, -1.0], q: [1.0, 0.5, 0.0, 0.25, -1.0, 0.0] }; 3];
    let untouched = Err(SolveError::NoConvergence);
    let mut results = [const { Err(SolveError::NoConvergence) }; 5];
    solve_batch(&data, &mut results);
    assert!(results[..3].iter().all(Result::is_ok) && results[3..].iter().all(|result| *result == untouched));
    let mut results = [const { Err(SolveError::NoConvergence) }; 2];
    solve_batch(&data, &mut results);
    assert!(results.iter().all(Result::is_ok));
    solve_batch(&data, &mut []);
    solve_batch(&[], &mut results);
}
