//! Camera models of COLMAP: forward distortion against the numbers of pycolmap 4.2.1
//! (`Camera.img_from_cam`), and the inverse against the forward direction, for random lenses.

use eliminant_cylinders::colmap::{Encoding, parse_colmap};
use eliminant_cylinders::distortion::{Distortion, Projection};
use eliminant_cylinders::photograph::Photograph;
use nalgebra::Point2;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// Ideal points in normalised coordinates.
const IDEAL: [[f64; 2]; 3] = [[0.3, -0.4], [-0.7, 0.2], [0.05, 0.9]];

/// A model with its parameters, and the pixels at which COLMAP shows the ideal points.
type Known = (&'static str, &'static [f64], [[f64; 2]; 3]);

const KNOWN: [Known; 13] = [
    (
        "FULL_OPENCV",
        &[800.0, 810.0, 640.0, 480.0, -0.2, 0.05, 0.001, -0.002, 0.01, -0.05, 0.02, 0.003],
        [
            [870.4996754262597, 168.48793817454924],
            [117.39542075622376, 631.3660247098067],
            [674.7271714236953, 1137.2533241968465],
        ],
    ),
    (
        "OPENCV",
        &[800.0, 810.0, 640.0, 480.0, -0.2, 0.05, 0.001, -0.002],
        [[867.87, 172.03799999999995], [128.8548, 628.05099], [673.5843125, 1116.4247203125]],
    ),
    (
        "FOV",
        &[800.0, 810.0, 640.0, 480.0, 0.9],
        [[880.0, 156.0], [116.1076931440706, 631.5545601976082], [675.3267094654689, 1123.8292800081708]],
    ),
    (
        "OPENCV_FISHEYE",
        &[800.0, 810.0, 640.0, 480.0, 0.05, -0.01, 0.004, -0.001],
        [
            [864.8484537322579, 176.4545874614518],
            [147.01320269161283, 622.6140377927834],
            [673.3526230117221, 1087.8515543886363],
        ],
    ),
    (
        "SIMPLE_RADIAL_FISHEYE",
        &[800.0, 640.0, 480.0, 0.05],
        [
            [864.9429302010981, 180.07609306520249],
            [146.3624873973198, 621.0392893150515],
            [673.429333643466, 1081.7280055823867],
        ],
    ),
    (
        "RADIAL_FISHEYE",
        &[800.0, 640.0, 480.0, 0.05, -0.01],
        [
            [864.8400856327179, 180.21321915637617],
            [147.12153011407912, 620.822419967406],
            [673.3350601422377, 1080.0310825602776],
        ],
    ),
    (
        "THIN_PRISM_FISHEYE",
        &[800.0, 810.0, 640.0, 480.0, 0.05, -0.01, 0.001, -0.002, 0.004, -0.001, 0.003, -0.0015],
        [
            [864.6076883342859, 176.92472489481327],
            [145.99109494962795, 622.8409860578623],
            [673.8255252550366, 1088.406146520515],
        ],
    ),
    (
        "RAD_TAN_THIN_PRISM_FISHEYE",
        &[
            800.0, 810.0, 640.0, 480.0, 0.05, -0.01, 0.004, -0.001, 0.0005, -0.0001, 0.001, -0.002, 0.003, -0.0015,
            0.0007, 0.0002,
        ],
        [
            [865.9563390284375, 175.60562013403575],
            [149.0777596007756, 621.9332727709814],
            [674.6807068147461, 1085.5463518352203],
        ],
    ),
    (
        "SIMPLE_DIVISION",
        &[800.0, 640.0, 480.0, -0.1],
        [
            [874.2824712167275, 167.62337171103007],
            [106.89735174881855, 632.3150423574805],
            [677.1905091254483, 1149.4291642580697],
        ],
    ),
    (
        "DIVISION",
        &[800.0, 810.0, 640.0, 480.0, -0.1],
        [
            [874.2824712167275, 163.71866385741794],
            [106.89735174881855, 634.2189803869489],
            [677.1905091254483, 1157.7970288112956],
        ],
    ),
    (
        "SIMPLE_FISHEYE",
        &[800.0, 640.0, 480.0],
        [
            [862.5508523203869, 183.26553023948406],
            [155.94655286519304, 618.3009848956592],
            [672.5534163336254, 1065.961494005257],
        ],
    ),
    (
        "FISHEYE",
        &[800.0, 810.0, 640.0, 480.0],
        [
            [862.5508523203869, 179.55634936747765],
            [155.94655286519304, 620.0297472068548],
            [672.5534163336254, 1073.2860126803228],
        ],
    ),
    (
        "EUCM",
        &[800.0, 810.0, 640.0, 480.0, 0.6, 1.2],
        [
            [861.3807182281683, 181.13603039197272],
            [160.31684875282622, 618.765483039361],
            [672.1748210056851, 1066.3861128286103],
        ],
    ),
];

/// The photograph of a text model with this camera.
fn photograph(model: &str, parameters: &[f64]) -> Photograph {
    let parameters: Vec<_> = parameters.iter().map(f64::to_string).collect();
    let cameras = format!("1 {model} 1280 960 {}\n", parameters.join(" "));
    let files =
        [("cameras.txt", cameras.as_str()), ("images.txt", "1 1 0 0 0 0 0 0 1 a.jpg\n\n"), ("points3D.txt", "")];
    let model = parse_colmap(Encoding::Text, files.map(|(name, text)| (name, text.as_bytes()))).expect("a model");
    model.photographs[0].clone()
}

#[test]
fn points_are_seen_where_colmap_sees_them() {
    for (model, parameters, seen) in KNOWN {
        let photograph = photograph(model, parameters);
        let calibration = photograph.camera.calibration().expect("a calibration");
        for (ideal, seen) in IDEAL.map(Point2::from).iter().zip(seen.map(Point2::from)) {
            let found = calibration.point_to_pixels(&photograph.distortion.distort(ideal));
            assert!((found - seen).norm() < 1e-9, "{model}: {found} {seen}");
            let straight = photograph.undistort(&seen).expect("inside the image");
            assert!((straight - calibration.point_to_pixels(ideal)).norm() < 1e-8, "{model}: {straight}");
        }
    }
}

#[test]
fn a_fisheye_has_no_ideal_point_at_ninety_degrees() {
    let lens = photograph("FISHEYE", &[800.0, 800.0, 640.0, 480.0]);
    let at = |angle: f64| Point2::new(640.0 + 800.0 * angle.to_radians(), 480.0);
    assert!(lens.undistort(&at(89.0)).is_some());
    assert_eq!(lens.undistort(&at(90.1)), None);
}

#[test]
fn parameters_out_of_range_are_refused() {
    for (model, parameters) in [("FOV", "800 800 640 480 3.2"), ("EUCM", "800 800 640 480 1.5 1")] {
        let cameras = format!("1 {model} 1280 960 {parameters}\n");
        let files = [("cameras.txt", cameras.as_str()), ("images.txt", "1 1 0 0 0 0 0 0 1 a.jpg\n\n"), ("p.txt", "")];
        let error =
            parse_colmap(Encoding::Text, files.map(|(name, text)| (name, text.as_bytes()))).expect_err("refused");
        assert!(error.to_string().starts_with("cameras.txt:1: camera 1: the distortion is not defined"), "{error}");
    }
}

fn projection() -> impl Strategy<Value = Projection> {
    prop_oneof![
        Just(Projection::Perspective),
        Just(Projection::Equidistant),
        (0.0..2.5).prop_map(Projection::FieldOfView),
        (-0.5..0.2).prop_map(Projection::Division),
        (0.0..1.0, 0.5..2.0).prop_map(|(a, b)| Projection::Unified(a, b)),
    ]
}

prop_compose! {
    /// Lenses that are distorted as strongly as real ones, or more.
    fn lens()(
        projection in projection(),
        radial in prop::array::uniform6(-0.1..0.1),
        denominator in prop::array::uniform3(-0.1..0.1),
        tangential in prop::array::uniform2(-0.01..0.01),
        prism in prop::array::uniform4(-0.01..0.01),
        radial_first in any::<bool>(),
    ) -> Distortion {
        Distortion { projection, radial, denominator, tangential, prism, radial_first }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..Default::default() })]

    /// A point is seen before the fold, and then found again; or the inverse refuses it.
    #[test]
    fn the_inverse_finds_the_point_again(lens in lens(), x in -0.6..0.6, y in -0.6..0.6) {
        let ideal = Point2::new(x, y);
        let seen = lens.distort(&ideal);
        let found = lens.undistort(&seen);
        prop_assert!(found.is_some_and(|found| (found - ideal).norm() < 1e-9), "{ideal} {found:?}");
    }

    /// Whatever the inverse returns is seen there, for any lens and any point.
    #[test]
    fn what_the_inverse_finds_is_seen_there(
        lens in lens(), strength in 0.0..100.0, x in -20.0..20.0, y in -20.0..20.0,
    ) {
        let lens = Distortion { radial: lens.radial.map(|k| k * strength), ..lens };
        let seen = Point2::new(x, y);
        if let Some(ideal) = lens.undistort(&seen) {
            // The projection is steep far from the axis: the bound is relative to the ideal point.
            let error = (lens.distort(&ideal) - seen).norm();
            prop_assert!(error < 1e-8 * (1.0 + seen.coords.norm()), "{error}");
        }
    }
}
