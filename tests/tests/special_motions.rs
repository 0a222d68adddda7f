//! Motions of cameras as vehicles, robots and turntables make them: their data have structure, so
//! that entries of null vectors vanish or are equal. No solver of two cameras may lose a solution
//! because of it.

use eliminant_tests::cases;
use eliminant_tests::fate::{FEW_SCENES, Fates, scenes_of};
use eliminant_tests::ground_truth::{Make, Motion, makers};

/// Problems and motions of which the true solution is lost, and why.
const LOST: [(&[&str], &[Motion], &str); 3] = [
    (
        &["relpose_4pt_angle", "relpose_5pt_generalized_angle", "relpose_3pt_angle_zero_screw"],
        &[Motion::HalfTurn],
        "u = v = 0 and the cosine is rounding: so are all terms of an equation, and no residual relative to them \
         tells a solution",
    ),
    (
        &[
            "fundamental_8pt_radial",
            "fundamental_8pt_radial_one_side",
            "fundamental_9pt_two_radials",
            "relpose_6pt_radial",
            "relpose_7pt_focal_radial_one_side",
            "relpose_7pt_focal_radial_one_side_eliminated",
        ],
        &[Motion::Forward],
        "points move along lines through the centre of distortion, whatever the distortion is: it is not determined",
    ),
    (
        &["relpose_7pt_focal_radial"],
        &[
            Motion::Planar,
            Motion::Forward,
            Motion::Sideways,
            Motion::Translation,
            Motion::HalfTurn,
            Motion::QuarterTurn,
            Motion::Turntable,
        ],
        "the last entry of the fundamental matrix is set to 1, and it vanishes",
    ),
];

#[test]
fn no_motion_is_special() {
    let mut faults = Vec::new();
    for (maker, case) in makers().iter().zip(cases()) {
        let Make::TwoCameras(make) = maker.make else { continue };
        assert_eq!(maker.name, case.name);
        let scenes = scenes_of(&case);
        for motion in Motion::ALL {
            let is_known = |(names, motions, _): &(&[&str], &[Motion], &str)| {
                names.contains(&case.name) && motions.contains(&motion)
            };
            let is_lost = LOST.iter().any(is_known);
            let scenes = if is_lost { scenes.min(FEW_SCENES) } else { scenes };
            let fates = Fates::of(maker, &case, scenes, |random| make(random, motion));
            println!("{}, {motion:?}: {fates:?}", case.name);
            if fates.loses() != is_lost {
                faults.push((case.name, motion, fates));
            }
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
}
