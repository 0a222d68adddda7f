//! Real roots of a determinant are no fewer than the real eigenvalues of the action matrix, also
//! where this is so large that the coefficients of the determinant have few digits.

use eliminant_generator::algebra::Random;
use eliminant_generator::template::RootMethod;
use eliminant_tests::cases;
use eliminant_tests::ground_truth::{FOUND, makers};
use eliminant_tests::measure::affordable;
use rayon::prelude::*;

/// Scenes of each problem.
const SCENES: u64 = 10_000;
/// Operations for the scenes of one problem.
const WORK: u64 = 3_000_000_000;

#[test]
fn no_known_solution_of_scenes_is_missing_among_real_roots_alone() {
    let (mut problems, mut faults) = (0, Vec::new());
    for (maker, case) in makers().iter().zip(cases()) {
        assert_eq!(maker.name, case.name);
        let plan = case.planned().plan;
        if plan.roots() != RootMethod::Determinant {
            continue;
        }
        problems += 1;
        let is_lost = |&seed: &u64| {
            let instance = maker.make.draw(&mut Random::new(seed));
            let is_near = |x: &[f64], truth: &[f64]| (maker.error)(&instance.data, x, truth) <= FOUND;
            let real = (case.solve)(&instance.data).unwrap_or_default();
            instance.truths.iter().filter(|truth| !real.iter().any(|x| is_near(x, truth))).any(|truth| {
                let all = (case.solve_complex)(&instance.data).unwrap_or_default();
                let mut real = all.iter().filter(|x| x.iter().all(|x| x.im == 0.0));
                real.any(|x| is_near(&x.iter().map(|x| x.re).collect::<Vec<f64>>(), truth))
            })
        };
        let lost: Vec<u64> = (1..=affordable(&plan, SCENES, WORK)).into_par_iter().filter(is_lost).collect();
        if !lost.is_empty() {
            faults.push((case.name, lost));
        }
    }
    assert!(problems > 10, "only {problems} problems");
    assert!(faults.is_empty(), "{faults:?}");
}
