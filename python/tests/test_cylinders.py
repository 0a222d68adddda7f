"""Cylinders from Python."""

from __future__ import annotations

import json
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import scenes

from eliminant import cylinders

SODA_CAN = Path(__file__).parents[2] / "cylinders" / "data" / "soda_can.json"
CALIBRATION = np.array([[3000.0, 0, 2000], [0, 3000, 1500], [0, 0, 1]])


def silhouettes(pose: np.ndarray, point: np.ndarray, direction: np.ndarray, radius: float) -> np.ndarray:
    """The two silhouette lines of a cylinder in normalised coordinates."""
    rotation, translation = pose[:, :3], pose[:, 3]
    centre = -rotation.T @ translation
    to_axis = point - centre
    to_axis = to_axis - direction * (direction @ to_axis)
    distance = np.linalg.norm(to_axis)
    towards, across = to_axis / distance, np.cross(direction, to_axis / distance)
    # The viewing planes hold the direction and touch the circle.
    sine = radius / distance
    normals = [sine * towards + side * np.sqrt(1 - sine**2) * across for side in (1, -1)]
    return np.array([rotation @ normal for normal in normals])


def views_of(rng: np.random.Generator, n: int, found: list[tuple[np.ndarray, float]], direction: np.ndarray):
    """Cameras around the origin, and the lines of the cylinders in each."""
    poses, lines = [], []
    for _ in range(n):
        turn = scenes.rotations(rng, 1)[0]
        pose = np.concatenate([turn, [[0], [0], [8]]], axis=1)
        poses.append(pose)
        lines.append(np.concatenate([silhouettes(pose, point, direction, radius) for point, radius in found]))
    return np.array(poses), lines


@pytest.fixture
def truth(rng):
    direction = rng.normal(size=3)
    direction /= np.linalg.norm(direction)
    point = rng.normal(size=3)
    return point - direction * (direction @ point), direction, 0.4


def check(cylinder: cylinders.Cylinder, point: np.ndarray, direction: np.ndarray, radius: float) -> None:
    np.testing.assert_allclose(cylinder.axis_point, point, atol=1e-6)
    assert abs(abs(cylinder.direction @ direction) - 1) < 1e-9 and abs(cylinder.radius - radius) < 1e-6


@pytest.mark.parametrize("method", ["least_squares", "refined", "robust"])
def test_triangulate_lines(rng, truth, method):
    point, direction, radius = truth
    poses, lines = views_of(rng, 6, [(point, radius)], direction)
    [cylinder] = cylinders.triangulate(cylinders.scene(poses, lines), method=method)
    check(cylinder, point, direction, radius)
    assert cylinder.label is None and len(cylinder.report["residuals"]) == 12


def pixels(lines: np.ndarray) -> np.ndarray:
    """Two points in pixels on each line."""
    ends = []
    for a, b, c in lines:
        foot, along = -c * np.array([a, b]) / (a * a + b * b), np.array([-b, a]) / np.hypot(a, b)
        ends.append(np.concatenate([foot - 0.1 * along, foot + 0.1 * along]))
    return (np.array(ends).reshape(-1, 2) @ CALIBRATION[:2, :2].T + CALIBRATION[:2, 2]).reshape(-1, 4)


def test_triangulate_labelled_segments(rng, truth):
    point, direction, radius = truth
    others = [(point, radius), (point + np.cross(direction, [0, 0, 1]), 0.3)]
    poses, lines = views_of(rng, 5, others, direction)
    scene = cylinders.scene(
        poses,
        segments=[pixels(of_view) for of_view in lines],
        calibration=CALIBRATION,
        labels=[["a", "a", "b", "b"]] * 5,
    )
    first, second = cylinders.triangulate(scene, parallel=True)
    assert (first.label, second.label) == ("a", "b")
    check(first, point, direction, radius)
    assert abs(second.radius - 0.3) < 1e-6


def test_points_are_evidence(rng, truth):
    point, direction, radius = truth
    poses, lines = views_of(rng, 5, [(point, radius)], direction)
    around = np.cross(direction, rng.normal(size=(200, 3)))
    around /= np.linalg.norm(around, axis=1, keepdims=True)
    heights = rng.uniform(-0.3, 0.3, size=(200, 1))
    on_surface = point + direction * heights + around * (radius + 0.002 * rng.normal(size=(200, 1)))
    points = np.concatenate([on_surface, point + rng.uniform(-2, 2, size=(200, 3))])
    [cylinder] = cylinders.triangulate(cylinders.scene(poses, lines, points=points), points=True)
    evidence = cylinder.report["points"]["evidence"]
    assert evidence["count"] > 50 and abs(cylinder.radius - radius) < 1e-3
    with pytest.raises(cylinders.CylinderError, match="no points"):
        cylinders.triangulate(cylinders.scene(poses, lines), points=True)
    matching = cylinders.match(cylinders.scene(poses, lines, points=points), count=1, points=True)
    assert matching.cylinders[0].report["points"]["evidence"]["count"] > 50


def test_match(rng, truth):
    point, direction, radius = truth
    others = [(point, radius), (point + 2 * np.cross(direction, [0, 0, 1]), 0.3)]
    poses, lines = views_of(rng, 8, others, direction)
    matching = cylinders.match(cylinders.scene(poses, lines), count=2)
    assert matching.directions.shape == (1, 3) and abs(abs(matching.directions[0] @ direction) - 1) < 1e-9
    assert sorted(round(cylinder.radius, 6) for cylinder in matching.cylinders) == [0.3, 0.4]
    along = cylinders.match(cylinders.scene(poses, lines), count=1, direction=direction)
    assert len(along.cylinders) == 1


def test_shared_radius_known_radius_and_side(rng, truth):
    point, direction, radius = truth
    others = [(point, radius), (point + 2 * np.cross(direction, [0, 0, 1]), radius)]
    poses, lines = views_of(rng, 5, others, direction)
    labels = [["a", "a", "b", "b"]] * 5
    scene = cylinders.scene(poses, lines, labels=labels)
    for options in ({"shared_radius": True}, {"radius": radius}, {"method": "refined", "parallel": True}):
        both = cylinders.triangulate(scene, **options)
        for cylinder, (through, _) in zip(both, others):
            foot = through - direction * (direction @ through)
            check(cylinder, foot, direction, radius)
    assert "refinement" in both[0].report


def test_one_line_in_each_image(rng, truth):
    point, direction, radius = truth
    poses, lines = views_of(rng, 6, [(point, radius)], direction)
    # All on the same side of the axis.
    scene = cylinders.scene(poses, [of_view[:1] for of_view in lines])
    found = []
    for side in ("left", "right"):
        try:
            [cylinder] = cylinders.triangulate(scene, side=side)
            found += [side] if abs(cylinder.radius - radius) < 1e-6 else []
        except cylinders.CylinderError as error:
            assert f"on its {side} side" in str(error)
    assert len(found) == 1


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"method": "robust", "parallel": True}, "least_squares or refined"),
        ({"shared_radius": True, "radius": 1.0}, "either a shared radius or a known one"),
        ({"radius": -1.0}, "a radius above 0"),
        ({"side": "above"}, "left or right"),
        ({"side": "left", "parallel": True}, "single cylinders"),
    ],
)
def test_options_that_do_not_go_together(options, message):
    with pytest.raises(ValueError, match=message):
        cylinders.triangulate({"views": []}, **options)


def photographs(poses: np.ndarray, of: list[tuple[np.ndarray, float]], direction: np.ndarray):
    """Dark cylinders before a light background, 640x480, with soft edges."""
    calibration = np.array([[600.0, 0, 320], [0, 600, 240], [0, 0, 1]])
    x, y = np.meshgrid(np.arange(640) + 0.5, np.arange(480) + 0.5)
    rays = np.stack([(x - 320) / 600, (y - 240) / 600, np.ones_like(x)], axis=-1)
    images = []
    for pose in poses:
        shade = np.full(x.shape, 200.0)
        for point, radius in of:
            normals = silhouettes(pose, point, direction, radius)
            axis = pose[:, :3] @ point + pose[:, 3]
            # Distance in pixels to the silhouettes; the inside is where the axis is.
            signed = [(rays @ n) * np.sign(axis @ n) / np.linalg.norm(n[:2]) * 600 for n in normals]
            shade -= 140 * np.clip(np.minimum(*signed) + 0.5, 0, 1)
        images.append(shade)
    return calibration, images


def test_photos(rng, truth, tmp_path):
    direction = np.array([0.05, 1.0, -0.04]) / np.linalg.norm([0.05, 1.0, -0.04])
    across = np.cross(direction, [0, 0, 1])
    across /= np.linalg.norm(across)
    of = [(1.4 * at * across, 0.25 + 0.05 * at) for at in (-1, 0, 1)]
    poses = []
    for angle in np.linspace(-0.7, 0.7, 8):
        turn = np.array([[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]])
        poses.append(np.concatenate([turn, [[0], [0], [8]]], axis=1))
    poses = np.array(poses)
    calibration, images = photographs(poses, of, direction)
    names = [f"{at}.png" for at in range(len(poses))]
    scene = cylinders.scene(poses, segments=[np.zeros((0, 4))] * 8, calibration=calibration, images=names)
    colour = [np.repeat(image[:, :, None], 3, axis=2).astype(np.uint8) for image in images]
    for given in (images, colour):
        heard = []
        found = cylinders.photos(scene, dict(zip(names, given)), progress=lambda *count: heard.append(count))
        assert heard[-1] == (8, 8)
        assert sorted(round(cylinder.radius, 2) for cylinder in found.cylinders) == [0.2, 0.25, 0.3]
        assert found.directions.shape == (1, 3) and abs(found.directions[0] @ direction) > 0.99999
    with pytest.raises(cylinders.CylinderError, match="there is no image `7.png`"):
        cylinders.photos(scene, dict(zip(names[:7], images)))
    with pytest.raises(ValueError, match="expected .height, width."):
        cylinders.photos(scene, {"0.png": np.zeros(5)})
    with pytest.raises(cylinders.CylinderError, match="0.png: .*; and 7 more"):
        cylinders.photos(scene, tmp_path)


@pytest.mark.skipif(not SODA_CAN.exists(), reason="the package is tested outside of its repository")
def test_scene_files():
    [of_path] = cylinders.triangulate(SODA_CAN)
    text = SODA_CAN.read_text(encoding="utf-8")
    for scene in (str(SODA_CAN), text, json.loads(text)):
        [cylinder] = cylinders.triangulate(scene)
        assert cylinder.report == of_path.report
    assert of_path.radius > 0


class Pinhole:
    """What `from_pycolmap` asks of a `pycolmap.Camera`: here with one coefficient of distortion."""

    def __init__(self, radial: float) -> None:
        self.radial = radial

    def calibration_matrix(self) -> np.ndarray:
        return CALIBRATION

    def cam_from_img(self, point: np.ndarray) -> np.ndarray:
        distorted = (point - CALIBRATION[:2, 2]) / np.diag(CALIBRATION)[:2]
        x = distorted
        for _ in range(50):
            x = distorted / (1 + self.radial * (x @ x))
        return x

    def img_from_cam(self, x: np.ndarray) -> np.ndarray:
        return x * (1 + self.radial * (x @ x)) * np.diag(CALIBRATION)[:2] + CALIBRATION[:2, 2]


@pytest.mark.parametrize("is_method", [False, True])
def test_pycolmap(rng, truth, is_method):
    point, direction, radius = truth
    poses, lines = views_of(rng, 5, [(point, radius)], direction)
    camera = Pinhole(0.1)
    images, segments = {}, {}
    for at, (pose, of_view) in enumerate(zip(poses, lines)):
        rigid = SimpleNamespace(matrix=lambda pose=pose: pose)
        of_world = (lambda rigid=rigid: rigid) if is_method else rigid
        images[at + 1] = SimpleNamespace(name=f"{at}.jpg", camera_id=1, cam_from_world=of_world)
        ends = (pixels(of_view).reshape(-1, 2) - CALIBRATION[:2, 2]) / np.diag(CALIBRATION)[:2]
        segments[f"{at}.jpg"] = np.array([camera.img_from_cam(end) for end in ends]).reshape(-1, 4)
    images[99] = SimpleNamespace(name="empty.jpg", camera_id=1, cam_from_world=None)
    reconstruction = SimpleNamespace(
        cameras={1: camera}, images=images, points3D={5: SimpleNamespace(xyz=point + 0.0)}
    )
    scene = cylinders.from_pycolmap(reconstruction, segments)
    assert len(scene["views"]) == 5 and scene["views"][0]["image"] == "0.jpg" and len(scene["points"]) == 1
    [cylinder] = cylinders.triangulate(scene)
    check(cylinder, point, direction, radius)
    with pytest.raises(ValueError, match="no image 'nothing.jpg'"):
        cylinders.from_pycolmap(reconstruction, {"nothing.jpg": np.zeros((1, 4))})


def test_a_reconstruction_of_pycolmap(rng, truth):
    pycolmap = pytest.importorskip("pycolmap")
    point, direction, radius = truth
    poses, lines = views_of(rng, 5, [(point, radius)], direction)
    camera = pycolmap.Camera(
        model="SIMPLE_RADIAL", width=4000, height=3000, params=[3000, 2000, 1500, 0.1], camera_id=7
    )
    reconstruction = pycolmap.Reconstruction()
    reconstruction.add_camera_with_trivial_rig(camera)
    segments = {}
    for at, (pose, of_view) in enumerate(zip(poses, lines)):
        image = pycolmap.Image(name=f"{at}.jpg", camera_id=7, image_id=at + 1)
        reconstruction.add_image_with_trivial_frame(image, pycolmap.Rigid3d(pose))
        ends = (pixels(of_view).reshape(-1, 2) - CALIBRATION[:2, 2]) / np.diag(CALIBRATION)[:2]
        rays = np.column_stack([ends, np.ones(len(ends))])
        segments[f"{at}.jpg"] = np.array([camera.img_from_cam(ray) for ray in rays]).reshape(-1, 4)
    reconstruction.add_point3D(point, pycolmap.Track(), np.zeros(3, dtype=np.uint8))
    scene = cylinders.from_pycolmap(reconstruction, segments)
    assert len(scene["views"]) == 5 and len(scene["points"]) == 1
    [cylinder] = cylinders.triangulate(scene)
    check(cylinder, point, direction, radius)
    reconstruction.add_image_with_trivial_frame(pycolmap.Image(name="loose.jpg", camera_id=7, image_id=99))
    with pytest.raises(ValueError, match="'loose.jpg' has no pose"):
        cylinders.from_pycolmap(reconstruction, {"loose.jpg": np.ones((1, 4))})


POSES = np.repeat(np.eye(3, 4)[None], 2, axis=0)


@pytest.mark.parametrize(
    "call, error, text",
    [
        (lambda: cylinders.scene(POSES), ValueError, "either lines or segments"),
        (
            lambda: cylinders.scene(POSES[0], [[]]),
            ValueError,
            r"`cameras` has the shape \(3, 4\): expected \(n, 3, 4\)",
        ),
        (lambda: cylinders.scene(POSES, [[]]), ValueError, "2 cameras, and lines or segments of 1 views"),
        (lambda: cylinders.scene(POSES, segments=[[], []]), ValueError, "they need a calibration"),
        (lambda: cylinders.scene(POSES, [np.zeros((1, 4))] * 2), ValueError, "lines of view 0"),
        (lambda: cylinders.scene(POSES, [[], []], calibration=np.eye(2)), ValueError, "`calibration`"),
        (lambda: cylinders.scene(None, []), TypeError, "`cameras` is None"),
        (lambda: cylinders.triangulate(None), TypeError, "got NoneType"),
        (lambda: cylinders.triangulate({}), cylinders.CylinderError, "missing field `views`"),
        (lambda: cylinders.triangulate("{"), cylinders.CylinderError, "not JSON"),
        (lambda: cylinders.triangulate({"views": [np.nan]}), cylinders.CylinderError, "scene:"),
        (lambda: cylinders.triangulate({"views": [object()]}), TypeError, "holds a object"),
        (lambda: cylinders.triangulate("nothing.json"), FileNotFoundError, "nothing.json"),
        (
            lambda: cylinders.triangulate(cylinders.scene(POSES, [[], []])),
            cylinders.CylinderError,
            "silhouette line",
        ),
        (lambda: cylinders.triangulate({"views": []}, method="magic"), ValueError, "expected the method"),
        (
            lambda: cylinders.triangulate({"views": []}, method="robust", threshold=-1.0),
            ValueError,
            "threshold",
        ),
        (lambda: cylinders.triangulate({"views": []}, confidence=float("nan")), ValueError, "confidence"),
        (lambda: cylinders.match({"views": []}, count=0), ValueError, "count"),
        (lambda: cylinders.match({"views": []}), cylinders.CylinderError, "scene:"),
        (
            lambda: cylinders.match(cylinders.scene(POSES, [[], []]), direction=[0, 0, 0]),
            cylinders.CylinderError,
            "all 0",
        ),
    ],
)
def test_bad_scenes(call, error, text):
    with pytest.raises(error, match=text):
        call()
