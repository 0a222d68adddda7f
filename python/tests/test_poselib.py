"""Beside PoseLib on the same scenes: the share of truths that both sides find."""

from __future__ import annotations

import numpy as np
import pytest
import scenes

import eliminant

poselib = pytest.importorskip("poselib", reason="the wheel of poselib is not installed")

N = 1000
FOCAL = 700.0
UNIT = 1.3


def homogeneous(points: np.ndarray) -> np.ndarray:
    """Rays of length 1."""
    rays = np.concatenate([points, np.ones((*points.shape[:-1], 1))], axis=-1)
    return rays / np.linalg.norm(rays, axis=-1, keepdims=True)


def any_found(candidates: list, truth: np.ndarray) -> bool:
    """Whether one of the matrices is the true one up to scale."""
    return bool(candidates) and bool(scenes.found(np.array(candidates)[None], truth[None])[0])


def poses(candidates: list, truth: dict[str, np.ndarray], at: int) -> bool:
    """Whether one of the poses of PoseLib is the true one."""
    if not candidates:
        return False
    one = {name: array[at : at + 1] for name, array in truth.items()}
    turns, shifts = (np.array([getattr(pose, name) for pose in candidates])[None] for name in ("R", "t"))
    return bool(scenes.poses_found(turns, shifts, one)[0])


def report(what: str, ours: float, theirs: float) -> None:
    """Shown by `pytest -s`, or where the test fails."""
    print(
        f"{what}: found {100 * ours:.2f} % by eliminant, {100 * theirs:.2f} % by poselib {poselib.__version__}"
    )


def test_five_points(rng):
    views = scenes.two_views(rng, N, 5)
    first, second = homogeneous(views["first"]), homogeneous(views["second"])
    ours = scenes.found(eliminant.relpose_5pt_rays(first, second).essential, views["essential"]).mean()
    calls = (poselib.essential_matrix_5pt(first[at], second[at]) for at in range(N))
    theirs = np.mean([any_found(found, views["essential"][at]) for at, found in enumerate(calls)])
    report("five points", ours, theirs)
    assert ours >= 0.998 and ours >= theirs - 0.003


def test_three_points(rng):
    view = scenes.one_view(rng, N, 3)
    rays = homogeneous(view["image"])
    result = eliminant.pose_3pt(rays, view["points"])
    ours = scenes.poses_found(result.rotation, result.translation, view).mean()
    theirs = np.mean([poses(poselib.p3p(rays[at], view["points"][at]), view, at) for at in range(N)])
    report("three points", ours, theirs)
    assert ours >= 0.998 and ours >= theirs - 0.003


def test_four_points_with_focal_length(rng):
    """Ours takes three points and one coordinate of the fourth, theirs all of four."""
    view = scenes.one_view(rng, N, 4)
    image = FOCAL * view["image"]
    result = eliminant.pose_35pt_focal(view["points"], image[..., 0], image[:, :3, 1])
    difference = result.rotation - view["rotation"][:, None]
    distance = np.linalg.norm(difference, axis=(2, 3))
    ours = (np.nan_to_num(distance, nan=np.inf) < 1e-6).any(axis=1).mean()
    calls = (poselib.p4pf(image[at], view["points"][at], False) for at in range(N))
    theirs = np.mean([has_focal(focals, FOCAL) for _, focals in calls])
    report("four points with focal length", ours, theirs)
    assert ours >= 0.99 and ours >= theirs - 0.01


def has_focal(focals: list, truth: float) -> bool:
    """Whether one of the focal lengths is the true one."""
    return bool(focals) and float(np.min(np.abs(np.array(focals) / truth - 1))) < 1e-6


def test_six_points_with_focal_length(rng):
    views = scenes.two_views(rng, N, 6)
    result = eliminant.relpose_6pt_focal_points(FOCAL * views["first"], FOCAL * views["second"])
    ours = (np.abs(np.nan_to_num(result.focal, nan=np.inf) / FOCAL - 1).min(axis=1) < 1e-6).mean()
    # PoseLib takes images whose unit is about the focal length.
    first, second = homogeneous(UNIT * views["first"]), homogeneous(UNIT * views["second"])
    calls = (poselib.shared_focal_relpose_6pt(first[at], second[at]) for at in range(N))
    theirs = np.mean([has_focal([pair.camera1.focal() for pair in found], UNIT) for found in calls])
    report("six points with focal length", ours, theirs)
    assert ours >= 0.98 and ours >= theirs - 0.01
