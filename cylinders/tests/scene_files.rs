//! Scene files: their content is read, and every defect has its message.

use eliminant_cylinders::{CylinderLines, InputError, LineId, View, ViewError, parse_scene};
use nalgebra::{Matrix3, Vector3};

const CAMERA: &str = "[[1,0,0,0],[0,1,0,0],[0,0,1,5]]";
const K: &str = "[[1000,0,500],[0,1000,400],[0,0,1]]";

fn scene(view: &str) -> String {
    format!("{{\"K\": {K}, \"views\": [{{\"camera_normalised\": {CAMERA}, \"lines_pixels\": []}}, {{{view}}}]}}")
}

#[track_caller]
fn message(text: &str) -> String {
    parse_scene(text, "scene.json").expect_err("an error").to_string()
}

#[test]
fn pixels_and_normalised_coordinates_give_the_same_view() {
    let normalised = format!("\"camera_normalised\": {CAMERA}, \"lines_normalised\": [[2, 0, 0.4]]");
    // The plane x = -0.2 z: pixels x = 500 - 200.
    let pixels = "\"camera_pixels\": [[1000,0,500,2500],[0,1000,400,2000],[0,0,1,5]], \"lines_pixels\": [[-3, 0, 900]]";
    let [left, right] = [normalised.as_str(), pixels].map(|view| parse_scene(&scene(view), "").expect("a scene"));
    let [left, right] = [&left.views[1], &right.views[1]];
    assert!((left.camera().rotation() - right.camera().rotation()).amax() < 1e-15);
    assert!((left.camera().translation() - right.camera().translation()).amax() < 1e-14);
    assert!(left.lines()[0].cross(&right.lines()[0]).norm() < 1e-15);

    let both = format!("{normalised}, {pixels}");
    assert_eq!(&parse_scene(&scene(&both), "").expect("both forms agree").views[1], left);
}

#[test]
fn other_keys_are_ignored_and_points_are_read() {
    let text = format!(
        "{{\"views\": [{{\"name\": \"a\", \"camera_normalised\": {CAMERA}, \"lines_normalised\": []}}], \
         \"points\": [[1, 2, 3]], \"comment\": null}}"
    );
    let scene = parse_scene(&text, "").expect("a scene");
    assert_eq!(scene.points, [Vector3::new(1.0, 2.0, 3.0).into()]);
    assert_eq!(scene.views[0].camera().rotation(), &Matrix3::identity());
    assert_eq!(scene.views[0].camera().calibration(), None);
}

#[test]
fn views_have_images_labels_and_calibrations_of_their_own() {
    let view = format!(
        "\"camera_normalised\": {CAMERA}, \"lines_pixels\": [[1,0,-1],[1,0,-2],[1,0,-3],[1,0,-4]], \"image\": \"a.jpg\", \
         \"cylinders\": [\"b\", null, \"a\", \"b\"], \"K\": [[2000,0,500],[0,2000,400],[0,0,1]]"
    );
    let scene = parse_scene(&scene(&view), "").expect("a scene");
    assert_eq!(scene.views.iter().map(View::image).collect::<Vec<_>>(), [None, Some("a.jpg")]);
    let focal = |view: &View| view.camera().calibration().map(|calibration| calibration.matrix()[(0, 0)]);
    assert_eq!(scene.views.iter().map(focal).collect::<Vec<_>>(), [Some(1000.0), Some(2000.0)]);

    let lines = scene.views[1].lines();
    let expected = [(None, vec![1]), (Some("a"), vec![2]), (Some("b"), vec![0, 3])];
    let cylinders = scene.cylinders();
    assert_eq!(cylinders.len(), expected.len());
    for (cylinder, (label, indices)) in cylinders.iter().zip(expected) {
        assert_eq!(cylinder.label.as_deref(), label);
        assert_eq!(cylinder.views.len(), 2, "views keep their indices");
        assert_eq!(cylinder.views[1].image(), Some("a.jpg"));
        let ids: Vec<_> = indices.iter().map(|&line| LineId { view: 1, line }).collect();
        assert_eq!(cylinder.lines, ids);
        let own: Vec<_> = indices.iter().map(|&line| lines[line]).collect();
        assert_eq!(cylinder.views[1].lines(), own);
    }
}

#[test]
fn a_scene_without_lines_is_one_cylinder_without_lines() {
    let scene = parse_scene("{\"views\": []}", "").expect("a scene");
    assert!(!scene.has_labels());
    assert_eq!(scene.cylinders(), [CylinderLines { label: None, views: vec![], lines: vec![] }]);
}

#[test]
fn text_that_is_not_json_is_located() {
    for (text, position) in
        [("", "1:0"), ("{\"views\": [", "1:11"), ("{\n  \"views\": [}", "2:13"), ("{\"views\": [NaN]}", "1:12")]
    {
        let message = message(text);
        assert!(message.starts_with(&format!("scene.json:{position}: not JSON: ")), "{text}: {message}");
    }
    // A number beyond the range of f64.
    let message = message(&scene(&format!("\"camera_normalised\": {CAMERA}, \"lines_pixels\": [[1, 1e999, 0]]")));
    assert!(message.starts_with("scene.json:1:") && message.contains("number out of range"), "{message}");
}

#[test]
fn a_scene_cut_at_any_byte_is_refused() {
    let whole = scene(&format!("\"camera_normalised\": {CAMERA}, \"lines_pixels\": [[1,0,2]], \"cylinders\": [null]"));
    for length in 0..whole.len() {
        let error = parse_scene(&whole[..length], "scene.json").expect_err("an error");
        assert!(matches!(error, InputError::NotJson { .. }), "{error}");
    }
    assert_eq!(parse_scene(&whole, "scene.json").expect("a scene").views.len(), 2);
}

#[test]
fn json_that_is_not_a_scene_is_located() {
    for (text, expected) in [
        ("[]", "scene.json:1:2: not a scene: invalid length 0"),
        ("{}", "scene.json:1:2: not a scene: missing field `views`"),
        ("{\"views\": 3}", "scene.json:1:11: not a scene: invalid type: integer `3`, expected a sequence"),
        (
            "{\"views\": [],\n \"K\": \"no\"}",
            "scene.json:2:10: not a scene: invalid type: string \"no\", expected a sequence",
        ),
        (
            "{\"views\": [], \"points\": [[1, null, 2]]}",
            "scene.json:1:33: not a scene: invalid type: null, expected f64",
        ),
        ("{\"views\": [], \"views\": []}", "scene.json:1:21: not a scene: duplicate field `views`"),
        (
            "{\"views\": [{\"segments_pixels\": [[1, 2, 3, null]]}]}",
            "scene.json:1:46: not a scene: invalid type: null, expected f64",
        ),
    ] {
        let message = message(text);
        assert!(message.starts_with(expected), "{text}: {message}");
    }
}

#[test]
fn wrong_shapes_and_values_name_their_place() {
    let camera = format!("\"camera_normalised\": {CAMERA}");
    let cases = [
        (
            format!("{camera}, \"lines_pixels\": [[1,2,3],[1,2]]"),
            "views[1].lines_pixels[1] has 2 entries where 3 are expected",
        ),
        (
            "\"camera_pixels\": [[1,0,0,0],[0,1,0,0]], \"lines_pixels\": []".to_owned(),
            "views[1].camera_pixels has 2 entries where 3 are expected",
        ),
        (
            "\"camera_normalised\": [[1,0,0,0],[0,1,0],[0,0,1,0]], \"lines_pixels\": []".to_owned(),
            "views[1].camera_normalised[1] has 3 entries where 4 are expected",
        ),
        (camera.clone(), "views[1] needs `lines_normalised`, `lines_pixels` or `segments_pixels`"),
        ("\"lines_pixels\": []".to_owned(), "views[1] needs `camera_normalised` or `camera_pixels`"),
        (
            format!("{camera}, \"lines_normalised\": [[1,0,2],[0,0,1]]"),
            "views[1].lines_normalised: line 1 has no direction: its first two coefficients are zero",
        ),
        (format!("{camera}, \"lines_pixels\": [[0,0,0]]"), "views[1].lines_pixels: line 0 has no direction"),
        (
            "\"camera_normalised\": [[1,0,0,0],[0,1,0,0],[0,0,2,5]], \"lines_pixels\": []".to_owned(),
            "views[1].camera_normalised: the left 3x3 part of the camera is not a rotation up to scale",
        ),
        (
            "\"camera_normalised\": [[0,0,0,0],[0,0,0,0],[0,0,0,5]], \"lines_pixels\": []".to_owned(),
            "views[1].camera_normalised: the left 3x3 part of the camera is not a rotation up to scale",
        ),
        (
            format!("{camera}, \"lines_pixels\": [[1,0,-501]], \"cylinders\": [\"a\", \"b\"]"),
            "views[1].cylinders: 2 cylinder labels for 1 line(s)",
        ),
        (
            format!("{camera}, \"lines_pixels\": [], \"K\": [[1,0],[0,1]]"),
            "views[1].K has 2 entries where 3 are expected",
        ),
        (
            format!("{camera}, \"lines_normalised\": [[1,0,0]], \"lines_pixels\": [[1,0,-501]]"),
            "views[1].lines_pixels[0]: two forms of the same camera or line contradict each other",
        ),
        (
            format!("{camera}, \"segments_pixels\": [[1,2,3,4], [5,6]]"),
            "views[1].segments_pixels[1] has 2 entries where 4 are expected",
        ),
        (
            format!("{camera}, \"segments_pixels\": [[1,2,3,4], [5,6,5,6]]"),
            "views[1].segments_pixels: line 1 has no length: its end points coincide",
        ),
        (
            format!("{camera}, \"segments_pixels\": [[1e308,2,-1e308,4]]"),
            "views[1].segments_pixels: line 0 has an end point that is not finite, or out of range",
        ),
        (
            format!("{camera}, \"lines_pixels\": [[1,0,-500]], \"segments_pixels\": [[500,0,500,9], [1,2,3,4]]"),
            "views[1].segments_pixels[1]: two forms of the same camera or line contradict each other",
        ),
        (
            format!("{camera}, \"lines_pixels\": [[1,0,-500]], \"segments_pixels\": [[500,0,500.2,9]]"),
            "views[1].segments_pixels[0]: two forms of the same camera or line contradict each other",
        ),
        (
            format!("{camera}, \"lines_normalised\": [[1,0,0]], \"lines_pixels\": []"),
            "views[1].lines_pixels[0]: two forms of the same camera or line contradict each other",
        ),
        (
            format!(
                "{camera}, \"camera_pixels\": [[1000,0,500,2500],[0,1000,400,2000],[0,0,1,6]], \"lines_pixels\": []"
            ),
            "views[1].camera_pixels: two forms of the same camera or line contradict each other",
        ),
    ];
    for (view, expected) in cases {
        let message = message(&scene(&view));
        assert!(message.starts_with(&format!("scene.json: {expected}")), "{view}: {message}");
    }
}

#[test]
fn pixels_need_a_calibration() {
    let lines = format!("{{\"views\": [{{\"camera_normalised\": {CAMERA}, \"lines_pixels\": [[1,0,0]]}}]}}");
    assert_eq!(message(&lines), "scene.json: views[0] needs `K`, because its lines are in pixels");
    let segments = lines.replace("\"lines_pixels\": [[1,0,0]]", "\"segments_pixels\": [[1,0,0,1]]");
    assert_ne!(segments, lines);
    assert_eq!(message(&segments), "scene.json: views[0] needs `K`, because its lines are in pixels");
    let camera = format!("{{\"views\": [{{\"camera_pixels\": {CAMERA}, \"lines_normalised\": [[1,0,0]]}}]}}");
    assert_eq!(message(&camera), "scene.json: views[0] needs `K`, because its camera is in pixels");
}

#[test]
fn calibrations_are_checked() {
    for matrix in [
        "[[1,0,0],[0,1,0],[0,0,0]]",
        "[[1,0,0],[0,0,0],[0,0,1]]",
        "[[1,0,0],[3,1,0],[0,0,1]]",
        "[[1e308,0,0],[0,1,0],[0,0,1e-9]]",
    ] {
        let error = parse_scene(&format!("{{\"K\": {matrix}, \"views\": []}}"), "").expect_err("an error");
        let InputError::Invalid { place, source: ViewError::NotACalibration, .. } = &error else {
            panic!("{matrix}: {error}");
        };
        assert_eq!(place, "K");
    }
    assert_eq!(message("{\"K\": [[1]], \"views\": []}"), "scene.json: K has 1 entries where 3 are expected");
}
