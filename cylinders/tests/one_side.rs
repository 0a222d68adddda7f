//! One line in each image: the side on which it is chooses among the circles.

#[path = "../examples/make_scene/random.rs"]
mod random;
#[path = "../examples/make_scene/scene.rs"]
#[allow(dead_code, reason = "scene files are not written here")]
mod scene;
mod scenes;

use eliminant_cylinders::{EstimateError, Method, Side, TriangulateError, View, estimate, estimate_on_side};
use random::Random;
use scene::{Photograph, Setup};

/// Views of one silhouette of the soda can from four sectors of ten, and its side.
fn views(random: &mut Random) -> (Vec<View>, Side) {
    let can = scene::soda_can();
    let setup = Setup { cameras: 10, noise: 2.0, ..scene::soda_can_setup() };
    let photographs = scene::photographs(&can, &setup, random);
    let view = |photograph: &Photograph| {
        let segment = scenes::silhouette(&can, &setup, photograph, (1.0, [0.0, 1.0]), random);
        View::from_pixel_segments(*scenes::view(&setup, &photograph.camera, &[]).camera(), &[segment])
            .expect("a segment")
    };
    let views: Vec<_> = photographs[..4].iter().map(view).collect();
    let truth = scenes::truth(&can).with_canonical_sign();
    let side = truth.residuals(0, &views[0]).expect("a camera outside")[0].side;
    (views, side)
}

fn other(side: Side) -> Side {
    if side == Side::Left { Side::Right } else { Side::Left }
}

#[test]
fn the_side_chooses_the_circle() {
    let radius = scene::soda_can().radius;
    let (mut told, mut untold, mut opposite) = (0, 0, 0);
    for seed in 0..200 {
        let (views, side) = views(&mut Random::new(seed));
        let is_right = |found: f64| (found / radius - 1.0).abs() < 0.3;
        untold += usize::from(estimate(&views, &Method::Refined).is_ok_and(|found| is_right(found.cylinder.radius)));
        if let Ok(found) = estimate_on_side(&views, side) {
            assert!(found.residuals.iter().all(|residual| residual.side == side), "seed {seed}");
            told += usize::from(is_right(found.cylinder.radius));
        }
        match estimate_on_side(&views, other(side)) {
            Ok(found) => assert!(found.residuals.iter().all(|residual| residual.side == other(side)), "seed {seed}"),
            Err(error) => {
                assert_eq!(error, EstimateError::NoneOnSide { side: other(side) });
                opposite += 1;
            }
        }
    }
    println!("of 200: right if told the side {told}, otherwise {untold}; none on the other side {opposite}");
    assert!(told > untold, "{told} {untold}");
}

#[test]
fn two_lines_are_too_few() {
    let (views, side) = views(&mut Random::new(1));
    let error = EstimateError::Triangulate(TriangulateError::TooFewLines { lines: 2 });
    assert_eq!(estimate_on_side(&views[..2], side), Err(error));
}
