//! Motions of cameras as vehicles, robots and turntables make them: their data have structure, so
//! that entries of null vectors vanish or are equal. No solver may lose them.

use eliminant_generator::algebra::Random;
use eliminant_solvers::relpose_5pt;
use eliminant_tests::ground_truth::special_motions::{MOTIONS, five_points};
use eliminant_tests::ground_truth::{combination, projective_error};
use rayon::prelude::*;

/// Scenes of each motion.
const SCENES: u64 = 1_000;
/// Scenes of which the true solution may be missing.
const LOST: usize = 3;
/// A truth counts as found if a solution is this close, up to scale.
const FOUND: f64 = 1e-6;

/// Whether the essential matrix is among the solutions.
fn is_found(basis: &[f64], essential: &[f64]) -> bool {
    let matrices = std::array::from_fn(|k| std::array::from_fn(|i| std::array::from_fn(|j| basis[9 * k + 3 * i + j])));
    let Ok(found) = relpose_5pt::solve(&matrices) else { return false };
    found.iter().any(|s| projective_error(&combination(basis, &s.weights), essential) <= FOUND)
}

#[test]
fn five_points_of_special_motions() {
    let mut faults = Vec::new();
    for (name, motion) in MOTIONS {
        let is_lost = |k: &u64| {
            let random = &mut Random::new(31_000_000 + k);
            let motion = motion(random);
            let (basis, essential) = five_points(random, motion);
            !is_found(&basis, &essential)
        };
        let lost = (0..SCENES).into_par_iter().filter(is_lost).count();
        println!("{name}: the truth is missing in {lost} of {SCENES} scenes");
        if lost > LOST {
            faults.push((name, lost));
        }
    }
    assert!(faults.is_empty(), "{faults:?}");
}
