//! Poses and targets as users have them: a camera that looks straight down, points in a plane or at
//! the corners of a square. Their data have structure, and rotations by a half turn are infinite in
//! some charts. No solver of a pose may lose a solution because of it.

use eliminant_tests::cases;
use eliminant_tests::fate::{FEW_SCENES, Fates, scenes_of};
use eliminant_tests::ground_truth::{Make, View, makers};

/// Problems and views.
type Exception = (&'static [&'static str], &'static [View], &'static str);

/// Where the truth is no isolated solution, and why.
const DEGENERATE: [Exception; 3] = [
    (
        &["pose_35pt_focal", "pose_4pt_focal"],
        &[View::Frontal, View::SquareHeadOn],
        "where all depths are equal, only their ratio to the focal length is determined",
    ),
    (
        &["pose_4pt_focal_radial", "pose_4pt_focal_radial_cut"],
        &[View::Plane, View::Frontal, View::Square, View::SquareHeadOn],
        "four points in a plane do not determine the third row of the camera, which they are stated to give",
    ),
    (
        &["pose_npt_weak_perspective"],
        &[View::Frontal, View::SquareHeadOn],
        "two poses show a tilted plane alike: they are one solution, counted twice, where it is not tilted",
    ),
];

/// Where the true solution is lost, and why.
const LOST: [Exception; 1] = [(
    &["pose_6pt_rolling_shutter"],
    &[View::Plane, View::Frontal, View::Square, View::SquareHeadOn],
    "the elimination is singular for points in a plane",
)];

/// Problems and views of which more true solutions are lost than chance has it, and at most which
/// part. A camera at the origin has unknowns of 0.
const PARTLY_LOST: [(&str, View, f64); 2] =
    [("pose_3pt_upright_error_bound", View::AtOrigin, 0.1), ("pose_4pt_upright_error_bound", View::Plane, 5e-3)];

fn is_among(exceptions: &[Exception], name: &str, view: View) -> bool {
    exceptions.iter().any(|(names, views, _)| names.contains(&name) && views.contains(&view))
}

#[test]
fn no_view_is_special() {
    let mut faults = Vec::new();
    for (maker, case) in makers().iter().zip(cases()) {
        let Make::KnownPoints(make) = maker.make else { continue };
        assert_eq!(maker.name, case.name);
        let scenes = scenes_of(&case);
        for view in View::ALL {
            let scenes = if is_among(&LOST, case.name, view) { scenes.min(FEW_SCENES) } else { scenes };
            let fates = Fates::of(maker, &case, scenes, |random| make(random, view));
            println!("{}, {view:?}: {fates:?}", case.name);
            let known = [&LOST[..], &DEGENERATE[..]].map(|exceptions| is_among(exceptions, case.name, view));
            let part = PARTLY_LOST.iter().find(|(name, kind, _)| *name == case.name && *kind == view);
            let loses = part.map_or(fates.loses(), |(.., part)| fates.loses_more_than(*part));
            if [loses, fates.is_degenerate()] != known {
                faults.push((case.name, view, fates));
            }
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
}
