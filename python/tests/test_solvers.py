"""Solvers of the catalogue: ground truth, batches and single instances."""

from __future__ import annotations

import pickle
import re

import numpy as np
import pytest
import scenes

import eliminant
from eliminant._solve import HOMOGENEOUS, MEANS, SOLVERS

FAST = [name for name in SOLVERS if SOLVERS[name].most <= 24]


def test_five_point_finds_the_motion(rng):
    views = scenes.two_views(rng, 2000, 5)
    result = eliminant.relpose_5pt_rays(views["first"], views["second"])
    assert result.values.shape == (2000, 10, 4) and result.essential.shape == (2000, 10, 3, 3)
    assert scenes.found(result.essential, views["essential"]).mean() > 0.998
    assert not result.errors


def test_image_points_are_rays(rng):
    views = scenes.two_views(rng, 10, 5)
    rays = [np.concatenate([views[name], np.ones((10, 5, 1))], axis=-1) for name in ("first", "second")]
    points, by_rays = (
        eliminant.relpose_5pt_rays(*data) for data in ([views["first"], views["second"]], rays)
    )
    np.testing.assert_array_equal(points.values, by_rays.values)
    one = eliminant.relpose_5pt_rays(views["first"][0], views["second"][0])
    assert one.essential.shape == (len(one), 3, 3)


def test_pose_of_three_points(rng):
    view = scenes.one_view(rng, 1000, 3)
    result = eliminant.pose_3pt(view["image"], view["points"])
    assert scenes.poses_found(result.rotation, result.translation, view).mean() > 0.998


@pytest.mark.parametrize("method", ["direct_least_squares", "least_squares_cayley", "least_squares_quaternion"])
def test_pose_of_any_number_of_points(method, rng):
    solve = getattr(eliminant, f"pose_npt_{method}")
    mean_of_point = getattr(eliminant, f"pose_npt_{method}_mean_of_point")
    for n in (6, 50):
        view = scenes.one_view(rng, 1, n)
        image, points = view["image"][0], view["points"][0]
        means = mean_of_point(image, points)
        result = solve(means)
        assert scenes.poses_found(result.rotation[None], result.translation[None], view).all()
        # The mean of one measurement, and of a measurement for all.
        of_first, of_same = mean_of_point(image[0], points[0]), mean_of_point(image[0], points[[0, 0]])
        np.testing.assert_array_equal(of_first, of_same)
        parts = [mean_of_point(image[:2], points[:2]), mean_of_point(image[2:], points[2:])]
        np.testing.assert_allclose((2 * parts[0] + (n - 2) * parts[1]) / n, means, rtol=1e-9, atol=1e-12)
    with pytest.raises(ValueError, match="has the shape"):
        mean_of_point(points, points[:, :2])
    with pytest.raises(eliminant.SolveError):
        solve(np.full_like(means, np.nan))


def test_seven_points_give_the_fundamental_matrix(rng):
    views = scenes.two_views(rng, 500, 7)
    result = eliminant.fundamental_7pt(views["first"], views["second"])
    # The camera matrices are the identity here.
    assert scenes.found(result.fundamental, views["essential"]).mean() > 0.99


def test_six_points_give_the_focal_length(rng):
    views = scenes.two_views(rng, 500, 6)
    result = eliminant.relpose_6pt_focal_points(800 * views["first"], 800 * views["second"])
    error = np.abs(np.nan_to_num(result.focal, nan=np.inf) / 800 - 1).min(axis=1)
    assert (error < 1e-6).mean() > 0.98


def test_trilateration(rng):
    centres, point = rng.normal(size=(50, 3, 3)), rng.normal(size=(50, 3))
    distances = np.linalg.norm(centres - point[:, None], axis=-1)
    result = eliminant.trilateration(centres, distances)
    np.testing.assert_array_equal(result.counts, 2)
    assert np.abs(result.values - point[:, None]).max(axis=-1).min(axis=-1).max() < 1e-9
    np.testing.assert_array_equal(np.stack([result.x, result.y, result["z"]], axis=-1), np.asarray(result))


def test_a_problem_without_data():
    result = eliminant.katsura_5()
    assert result.values.shape == (len(result), 6) and len(result) == result.counts > 0
    # The last equation: 2 (x + y + z + t + u) + v = 1.
    total = 2 * (result.x + result.y + result.z + result.t + result.u) + result.v
    np.testing.assert_allclose(total, 1, atol=1e-12)


@pytest.mark.parametrize("name", SOLVERS)
def test_every_solver_takes_its_data(name, rng):
    """Random data are in general no scene: what counts is that single and batch agree."""
    solver = SOLVERS[name]
    if not solver.data:
        pytest.skip("the problem has no data")
    n = 6 if name in FAST else 2
    problem = eliminant.problem(name)
    assert (
        problem.data == solver.data and problem.fields == solver.fields and problem.results == solver.results
    )
    data = [rng.normal(size=(n, *shape)) for _, shape in solver.data]
    batch = getattr(eliminant, name)(*data)
    assert batch.values.shape == (n, solver.most, len(batch.unknowns)) and batch.is_batch
    # A result with the name of an unknown is that unknown.
    assert batch.names == tuple(dict.fromkeys(array for array, _ in (*solver.fields, *solver.results)))
    for at in range(n):
        if batch.status[at]:
            with pytest.raises(eliminant.SolveError, match=re.escape(batch.error(at))):
                getattr(eliminant, name)(*[array[at] for array in data])
            continue
        one, of_batch = getattr(eliminant, name)(*[array[at] for array in data]), batch.of(at)
        assert len(one) == batch.counts[at] and one.values.shape == of_batch.values.shape
        assert np.isnan(batch.values[at, len(one) :]).all() and np.isfinite(one.values).all()
        order = [np.lexsort(values.T) for values in (one.values, of_batch.values)]
        np.testing.assert_allclose(one.values[order[0]], of_batch.values[order[1]], rtol=1e-6, atol=1e-8)


def test_batches_of_all_lengths_agree(rng):
    """Pieces of 256 on all cores, and rests."""
    views = scenes.two_views(rng, 1000, 5)
    all_of_them = eliminant.relpose_5pt_rays(views["first"], views["second"])
    for n in (1, 7, 256, 257, 999):
        part = eliminant.relpose_5pt_rays(views["first"][:n], views["second"][:n])
        np.testing.assert_array_equal(part.counts, all_of_them.counts[:n])
        np.testing.assert_allclose(part.values, all_of_them.values[:n], rtol=1e-6, atol=1e-9)


def test_results_that_are_asked_for(rng):
    """Arrays that are left out change no other, of batches of one piece and of several."""
    views = scenes.two_views(rng, 600, 5)
    first, second = views["first"], views["second"]
    for n in (3, 600):
        every = eliminant.relpose_5pt_rays(first[:n], second[:n])
        for names in (["essential"], ["translation", "essential"], "rotation", iter(["rotation"]), []):
            some = eliminant.relpose_5pt_rays(first[:n], second[:n], results=names)
            np.testing.assert_array_equal(some.values, every.values)
            for name in set(some.names):
                np.testing.assert_array_equal(some[name], every[name])
    some = eliminant.relpose_5pt_rays(first, second, results=["translation", "essential"])
    assert some.names == ("weights", "essential", "translation")
    one = eliminant.relpose_5pt_rays(first[0], second[0], results=["translation"])
    assert one.names == ("weights", "translation") and one.translation.shape == (len(one), 3)
    with pytest.raises(ValueError, match="no result `poses`: there are essential, rotation, translation"):
        eliminant.relpose_5pt_rays(first, second, results=["rotation", "poses"])
    with pytest.raises(TypeError):
        eliminant.relpose_5pt_rays(first, second, results=3)


def test_a_shared_argument_holds_for_all_instances(rng):
    view = scenes.one_view(rng, 5, 3)
    points = view["points"][0]
    shared = eliminant.pose_3pt(view["image"], points)
    repeated = eliminant.pose_3pt(view["image"], np.repeat(points[None], 5, axis=0))
    np.testing.assert_array_equal(shared.values, repeated.values)
    np.testing.assert_array_equal(shared.rotation, repeated.rotation)


def test_instances_with_errors_do_not_stop_a_batch(rng):
    views = scenes.two_views(rng, 600, 5)
    first, second = views["first"].copy(), views["second"].copy()
    first[3, 0, 0], second[400, 2, 1] = np.nan, np.inf
    first[5], second[5] = first[5, :1], second[5, :1]
    result = eliminant.relpose_5pt_rays(first, second)
    assert set(result.errors) >= {3, 400}
    assert result.counts[3] == result.counts[400] == 0 and np.isnan(result.values[3]).all()
    assert result.status[3] == eliminant.Status.NON_FINITE_INPUT
    assert result.error(3) == "the data hold an infinite value or a NaN" and result.error(4) is None
    with pytest.raises(eliminant.SolveError, match="infinite value"):
        result.of(3)
    with pytest.raises(eliminant.SolveError, match="infinite value"):
        eliminant.relpose_5pt_rays(first[3], second[3])


def test_solutions_are_like_arrays(rng):
    views = scenes.two_views(rng, 4, 5)
    result = eliminant.relpose_5pt_rays(views["first"], views["second"])
    assert len(result) == 4 and result.shape == (4, 10, 4) and result[0].shape == (10, 4)
    assert "essential" in dir(result) and "essential" in repr(result)
    with pytest.raises(AttributeError, match="no unknown or result `nothing`"):
        result.nothing
    again = pickle.loads(pickle.dumps(result))
    np.testing.assert_array_equal(again.essential, result.essential)
    one = result.of(0)
    assert not one.is_batch and sum(1 for _ in one) == result.counts[0]
    with pytest.raises(TypeError):
        one.of(0)


def test_docstrings_say_shapes_and_sources():
    docs = eliminant.relpose_5pt_rays.__doc__
    assert "(5, 3)" in docs and "essential" in docs and "at most 10" in docs
    assert "Hartley, Zisserman" in eliminant.fundamental_7pt.__doc__
    assert all(getattr(eliminant, name).__doc__ for name in SOLVERS)


def test_rays_of_image_points_are_those_that_the_problems_say():
    """The list of data that take image points, too, against the documentation of the problems."""
    says = re.compile(
        r"`(?P<a>\w+)(\[k\])?`( and `(?P<b>\w+)(\[k\])?`)? (is|are|hold) the rays? of (the )?points?\b"
    )
    expected = {}
    for name, taken in [*SOLVERS.items(), *MEANS.items()]:
        text = " ".join(taken.docs.split())
        shapes = dict(taken.data)
        # Rays with a point in space have two rows, or centres beside them.
        is_of_image = {n: shape[-1:] == (3,) and len(shape) < 3 and "centres" not in shapes for n, shape in shapes.items()}
        names = tuple(n for m in says.finditer(text) for n in (m["a"], m["b"]) if n and is_of_image[n])
        if names:
            expected[name] = names
    assert HOMOGENEOUS == expected
