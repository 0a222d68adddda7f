"""Cylinder triangulation: cameras and silhouette lines to the axes and radii of cylinders.

A scene is a dict in the form of the scene files of `cylinders`, its JSON text, or the path of such
a file. `scene` makes one from arrays, `from_pycolmap` from a reconstruction.
"""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Union

import numpy as np

from . import _eliminant
from ._arrays import Array, numbers, whole
from ._progress import Progress, counted

CylinderError = _eliminant.CylinderError

Scene = Union[Mapping[str, Any], str, "os.PathLike[str]"]

__all__ = ["Cylinder", "CylinderError", "Matching", "from_pycolmap", "match", "photos", "scene", "triangulate"]

Images = Union[Mapping[str, Any], str, "os.PathLike[str]"]

BRIGHTNESS = np.array([0.299, 0.587, 0.114], dtype=np.float32)
"""Weights of red, green and blue in brightness (ITU-R BT.601, that of JPEG files)."""


class Cylinder(NamedTuple):
    """A cylinder."""

    axis_point: Array
    """The point of the axis nearest to the origin of the world."""
    direction: Array
    """The unit direction of the axis."""
    radius: float
    label: Optional[str]
    """The label of its lines; None for lines without label, and for matched cylinders."""
    warnings: List[str]
    """What makes the result doubtful."""
    report: Dict[str, Any]
    """All that is known of it: the object that the program `cylinders` writes as JSON."""


class Matching(NamedTuple):
    """Cylinders that were found among lines without labels."""

    directions: Array
    """The unit directions of the axes, of shape (k, 3). Cylinders of one direction are parallel
    before they are refined."""
    cylinders: List[Cylinder]
    """The cylinders, direction by direction, the best supported first, refined where they could be."""
    warnings: List[str]
    report: Dict[str, Any]
    """All that is known of them: the object that the program `cylinders` writes as JSON."""


def scene(
    cameras: Any,
    lines: Optional[Sequence[Any]] = None,
    *,
    segments: Optional[Sequence[Any]] = None,
    calibration: Any = None,
    labels: Optional[Sequence[Sequence[Optional[str]]]] = None,
    images: Optional[Sequence[str]] = None,
    points: Any = None,
) -> Dict[str, Any]:
    """A scene from arrays.

    `cameras` has the shape (n, 3, 4): [R t] of each view, world to camera. `lines` holds for each
    view an array of lines (a, b, c) with a x + b y + c = 0, `segments` one of end points
    (x1, y1, x2, y2). With `calibration`, of shape (3, 3) or (n, 3, 3), both are in pixels without
    distortion; without it lines are in normalised image coordinates, and segments are refused.
    `labels` names for each view the cylinder of each line, and `points`, of shape (k, 3), are points
    of the world.
    """
    poses = _shaped("cameras", cameras, (-1, 3, 4))
    if (lines is None) == (segments is None):
        raise ValueError("expected either lines or segments")
    if segments is not None and calibration is None:
        raise ValueError("segments are in pixels: they need a calibration")
    form = (
        "segments_pixels" if lines is None else "lines_normalised" if calibration is None else "lines_pixels"
    )
    given = segments if lines is None else lines
    width = 4 if lines is None else 3
    for name, each in (("lines or segments", given), ("labels", labels), ("images", images)):
        if each is not None and len(each) != len(poses):
            raise ValueError(f"there are {len(poses)} cameras, and {name} of {len(each)} views")
    views: List[Dict[str, Any]] = []
    for at, pose in enumerate(poses):
        assert given is not None
        of_view = numbers(f"lines of view {at}", given[at])
        of_view = of_view if of_view.size else of_view.reshape(0, width)
        view = {
            "camera_normalised": pose.tolist(),
            form: _shaped(f"lines of view {at}", of_view, (-1, width)).tolist(),
        }
        if labels is not None:
            view["cylinders"] = list(labels[at])
        if images is not None:
            view["image"] = images[at]
        views.append(view)
    made: Dict[str, Any] = {"views": views}
    if calibration is not None:
        matrices = numbers("calibration", calibration)
        if matrices.shape == (3, 3):
            made["K"] = matrices.tolist()
        else:
            for view, matrix in zip(views, _shaped("calibration", matrices, (len(views), 3, 3))):
                view["K"] = matrix.tolist()
    if points is not None:
        made["points"] = _shaped("points", points, (-1, 3)).tolist()
    return made


def from_pycolmap(
    reconstruction: Any,
    segments: Mapping[str, Any],
    labels: Optional[Mapping[str, Sequence[Optional[str]]]] = None,
) -> Dict[str, Any]:
    """A scene from a `pycolmap.Reconstruction` and segments in its photographs.

    `segments` maps names of images to arrays of shape (k, 4), `labels` to the cylinder of each
    segment. End points are in pixels of the photograph, and are undistorted by its camera. Images
    without segments are left out.
    """
    images = {image.name: image for image in reconstruction.images.values()}
    unknown = sorted(set(segments) - set(images))
    if unknown:
        raise ValueError(f"the reconstruction has no image {unknown[0]!r}")
    names = [name for name in images if name in segments]
    # Before version 3.12 every image of a reconstruction had a pose.
    without = [name for name in names if not getattr(images[name], "has_pose", True)]
    if without:
        raise ValueError(f"the image {without[0]!r} has no pose")
    poses, calibrations, undistorted = [], [], []
    for name in names:
        camera = reconstruction.cameras[images[name].camera_id]
        matrix = numbers("calibration", camera.calibration_matrix())
        ends = _shaped(f"segments of {name}", segments[name], (-1, 4)).reshape(-1, 2)
        rays = numbers("undistorted points", [camera.cam_from_img(end) for end in ends]).reshape(-1, 2)
        undistorted.append((rays @ matrix[:2, :2].T + matrix[:2, 2]).reshape(-1, 4))
        pose = images[name].cam_from_world
        # A method since version 3.12, an attribute before.
        poses.append((pose() if callable(pose) else pose).matrix())
        calibrations.append(matrix)
    points = [numbers("point", point.xyz) for point in reconstruction.points3D.values()]
    return scene(
        np.reshape(poses, (-1, 3, 4)),
        segments=undistorted,
        calibration=np.reshape(calibrations, (-1, 3, 3)),
        labels=None if labels is None else [labels.get(name, [None] * len(segments[name])) for name in names],
        images=names,
        points=np.reshape(points, (-1, 3)) if points else None,
    )


def triangulate(
    scene: Scene,
    *,
    method: str = "least_squares",
    parallel: bool = False,
    shared_radius: bool = False,
    radius: Optional[float] = None,
    side: Optional[str] = None,
    points: bool = False,
    threshold: Optional[float] = None,
    seed: int = 0,
    confidence: float = 0.999,
) -> List[Cylinder]:
    """The cylinders of a scene, one for each label.

    `method` is `"least_squares"`, `"refined"` on the distances in the images, with standard
    deviations in the report, or `"robust"`, by RANSAC with `threshold` in pixels, `seed` and
    `confidence`. `parallel` estimates one direction for all cylinders, `shared_radius` one radius,
    and `radius` is that of all cylinders, if it is known; the last two refine. `side`, `"left"` or
    `"right"` of the axis, whose direction with the largest entry positive points up, is that of all
    lines, for one line in each image. `points` takes those of the scene near a surface as evidence,
    too, and refines. Raises `CylinderError` where the lines determine no cylinder.
    """
    estimator = {
        "method": method,
        "is_parallel": parallel,
        "is_radius_shared": shared_radius,
        "radius": radius,
        "side": side,
        "has_points": points,
        "threshold": threshold,
        "seed": whole("seed", seed),
        "confidence": confidence,
    }
    reports = json.loads(_eliminant.triangulate_cylinders(_text(scene), estimator))
    return [_cylinder(report, report.get("label")) for report in reports]


def match(
    scene: Scene,
    *,
    threshold: Optional[float] = None,
    count: Optional[int] = None,
    least_support: Optional[int] = None,
    first_image: bool = False,
    directions: Optional[int] = None,
    direction: Any = None,
    points: bool = False,
) -> Matching:
    """Cylinders and their silhouettes among lines without labels.

    `threshold` is the largest distance of a match: pixels where all cameras have a calibration,
    radians otherwise; without it 3 pixels or 0.001 radians, or twice as much if the lines need it.
    `count` is the largest number of cylinders, all of one direction, `least_support` the least
    number of matches of one. `first_image` takes pairs of silhouettes in the first image only.
    `directions` is the largest number of directions; without it all that have cylinders are taken.
    `direction` is that of all axes, if it is known. `points` takes those of the scene near a
    surface as evidence for the refined cylinders, too.
    """
    if directions is not None and (count is not None or direction is not None):
        raise ValueError("`directions` goes with neither `count` nor `direction`")
    matcher = {
        "threshold": threshold,
        "count": None if count is None else whole("count", count),
        "least_support": None if least_support is None else whole("least_support", least_support),
        "is_first_image": first_image,
        "directions": None if directions is None else whole("directions", directions),
        "direction": _direction(direction),
        "has_points": points,
    }
    return _matching(_eliminant.match_cylinder_lines(_text(scene), matcher))


def photos(
    cameras: Scene,
    images: Images,
    *,
    threshold: float = 2.0,
    directions: Optional[int] = None,
    direction: Any = None,
    points: bool = False,
    progress: Progress = None,
) -> Matching:
    """Cylinders in photographs whose cameras are known, without lines.

    `cameras` is the folder of a COLMAP model, or a scene whose views have the names of their images
    and a calibration; its lines are not looked at. `images` is the folder of the photographs, JPEG
    or PNG, or maps their names to arrays of brightness, of shape (height, width), or of red, green
    and blue, of shape (height, width, 3), from 0 to 255. `threshold` is the largest distance of a
    line from its silhouette, in pixels, `directions` the largest number of directions, and
    `direction` that of all axes, if it is known. `points` takes those of the scene or the model near
    a surface as evidence for the refined cylinders, too. `progress` is that of
    `Problem.stability`, for the photographs in which lines are detected; matching follows.
    """
    if directions is not None and direction is not None:
        raise ValueError("`directions` does not go with `direction`")
    is_model = not isinstance(cameras, Mapping) and not _is_json(cameras) and os.path.isdir(cameras)
    is_folder = isinstance(images, (str, os.PathLike))
    given = {
        "scene": None if is_model else _text(cameras),
        "model": os.fspath(cameras) if is_model else None,  # type: ignore[arg-type]
        "folder": os.fspath(images) if is_folder else None,  # type: ignore[arg-type]
        "arrays": [] if is_folder else [(name, _brightness(name, array)) for name, array in images.items()],  # type: ignore[union-attr]
        "threshold": threshold,
        "directions": None if directions is None else whole("directions", directions),
        "direction": _direction(direction),
        "has_points": points,
    }
    with counted(progress, "lines", " photographs") as report:
        return _matching(_eliminant.cylinders_of_photographs(given, report))


def _brightness(name: str, value: Any) -> Any:
    """An image as float32 of shape (height, width)."""
    array = numbers(f"image {name}", value)
    if array.ndim == 3 and array.shape[2] in (3, 4):
        array = array[:, :, :3] @ BRIGHTNESS
    if array.ndim != 2:
        raise ValueError(f"image {name!r} has the shape {array.shape}: expected (height, width) or (height, width, 3)")
    return np.ascontiguousarray(array, dtype=np.float32)


def _direction(value: Any) -> Any:
    return None if value is None else _shaped("direction", value, (3,)).tolist()


def _matching(text: str) -> Matching:
    report = json.loads(text)
    found = [_cylinder(cylinder.get("refined") or cylinder, None) for cylinder in report["cylinders"]]
    return Matching(np.array(report["directions"]), found, report["warnings"], report)


def _cylinder(report: Dict[str, Any], label: Optional[str]) -> Cylinder:
    point, direction = np.array(report["axis_point"]), np.array(report["direction"])
    return Cylinder(point, direction, report["radius"], label, report.get("warnings", []), report)


def _shaped(name: str, value: Any, shape: Sequence[int]) -> Array:
    """The numbers of an argument, of this shape; -1 is any length."""
    array = numbers(name, value)
    if array.ndim != len(shape) or any(want not in (-1, is_) for want, is_ in zip(shape, array.shape)):
        expected = str(tuple(shape)).replace("-1", "n")
        raise ValueError(f"`{name}` has the shape {array.shape}: expected {expected}")
    return array


def _text(scene: Scene) -> str:
    """A scene as JSON."""
    if isinstance(scene, Mapping):
        try:
            return json.dumps(scene, allow_nan=False, default=_plain)
        except ValueError as error:
            raise CylinderError(f"scene: {error}") from None
    if isinstance(scene, str) and _is_json(scene):
        return scene
    if isinstance(scene, (str, os.PathLike)):
        return Path(scene).read_text(encoding="utf-8")
    raise TypeError(f"expected a scene as a dict, JSON text or a path, got {type(scene).__name__}")


def _is_json(scene: Any) -> bool:
    return isinstance(scene, str) and scene.lstrip().startswith("{")


def _plain(value: Any) -> Any:
    """Arrays and numbers of NumPy as JSON has them."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    raise TypeError(f"a scene holds a {type(value).__name__}, which is no JSON")
