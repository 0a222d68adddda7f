//! Motions of cameras as vehicles, robots and turntables make them: their data have structure, so
//! that entries of null vectors vanish or are equal. No solver of two cameras may lose a solution
//! because of it. Problems with radial distortion are not among them: they set the last entry of
//! the fundamental matrix to 1, and it vanishes for planar motions.

use eliminant_generator::algebra::Random;
use eliminant_tests::equations::Equations;
use eliminant_tests::ground_truth::{FOUND, KnownInstance, Make, Maker, Motion, makers};
use eliminant_tests::measure::affordable;
use eliminant_tests::statistics::complex;
use eliminant_tests::{Case, cases};
use rayon::prelude::*;

/// Scenes of each motion and problem.
const SCENES: u64 = 1_000;
/// Operations for the scenes of one motion and problem.
const WORK: u64 = 400_000_000;
/// The part of the scenes of which the true solution may be missing.
const LOST: f64 = 3e-3;
/// Motions of which the true solution is lost, and why.
const EXCEPTIONS: [(&str, Motion, &str); 2] = [
    ("relpose_4pt_angle", Motion::HalfTurn, WITHOUT_TERMS),
    ("relpose_5pt_generalized_angle", Motion::HalfTurn, WITHOUT_TERMS),
];
const WITHOUT_TERMS: &str = "u = v = 0 and the cosine is rounding: so are all terms of an equation, \
                             and no residual relative to them tells a solution";
/// The smallest singular value of the scaled Jacobian at which a solution counts as isolated. For
/// some motions solutions fill curves, such as focal lengths where optical axes are parallel.
const ISOLATED: f64 = 1e-8;
/// The exact solution of the rounded data may be so far from the truth.
const KNOWN: f64 = 1e-8;

/// What became of the truth of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Fate {
    Found,
    Lost,
    /// It is not isolated, or not known to the digits that the claim is about.
    Undetermined,
}

fn fate(maker: &Maker, case: &Case, instance: &KnownInstance) -> Fate {
    let Ok(found) = (case.solve)(&instance.data).or_else(|_| Ok::<_, ()>(Vec::new())) else { return Fate::Lost };
    let is_found =
        |truth: &Vec<f64>| found.iter().any(|solution| (maker.error)(&instance.data, solution, truth) <= FOUND);
    if instance.truths.iter().all(is_found) {
        return Fate::Found;
    }
    let Some(equations) = Equations::new(&case.problem(), &instance.data) else { return Fate::Undetermined };
    let is_determined = |truth: &Vec<f64>| {
        let size = truth.iter().map(|x| x * x).sum::<f64>().sqrt();
        let exact = equations.refined(&complex(truth));
        exact.is_solution()
            && exact.moved <= KNOWN
            && equations.smallest_singular_value(&exact.point, &vec![size; truth.len()]) > ISOLATED
    };
    let is_lost = instance.truths.iter().filter(|truth| !is_found(truth)).any(is_determined);
    if is_lost { Fate::Lost } else { Fate::Undetermined }
}

#[test]
fn no_motion_is_special() {
    let mut faults = Vec::new();
    for (maker, case) in makers().iter().zip(cases()) {
        let Make::TwoCameras(make) = maker.make else { continue };
        assert_eq!(maker.name, case.name);
        let scenes = affordable(&case.planned().plan, SCENES, WORK);
        for motion in Motion::ALL {
            let fates: Vec<Fate> = (0..scenes)
                .into_par_iter()
                .map(|k| fate(maker, &case, &make(&mut Random::new(31_000_000 + k), motion)))
                .collect();
            let [found, lost, undetermined] = [Fate::Found, Fate::Lost, Fate::Undetermined]
                .map(|wanted| fates.iter().filter(|f| **f == wanted).count());
            println!("{}, {motion:?}: {found} of {scenes} found, {lost} lost, {undetermined} undetermined", case.name);
            let is_known = EXCEPTIONS.iter().any(|exception| (exception.0, exception.1) == (case.name, motion));
            if (lost as f64 > LOST * scenes as f64) != is_known {
                faults.push((case.name, motion, lost, scenes));
            }
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
}
