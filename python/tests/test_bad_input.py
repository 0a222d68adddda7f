"""Bad input gives a clear exception."""

from __future__ import annotations

import numpy as np
import pytest

import eliminant

CENTRES = [[0.0, 0.0, 1.0], [4.0, 0.0, 0.0], [0.0, 3.0, 0.0]]
DISTANCES = [2.0, 3.0, 3.5]

BAD = {
    "None": (None, TypeError, "`centres` is None"),
    "object": (np.array([[None] * 3] * 3), TypeError, "elements of type object"),
    "strings": ([["a", "b", "c"]] * 3, TypeError, "expected real numbers"),
    "complex": (np.ones((3, 3), dtype=complex), TypeError, "elements of type complex"),
    "bool": (np.ones((3, 3), dtype=bool), TypeError, "elements of type bool"),
    "dates": (np.zeros((3, 3), dtype="datetime64[s]"), TypeError, "elements of type datetime64"),
    "ragged": ([[1.0, 2.0], [3.0]], ValueError, "`centres`"),
    "scalar": (1.0, ValueError, r"has the shape \(\): expected \(3, 3\), or \(n, 3, 3\) for n instances"),
    "one dimension": (np.zeros(9), ValueError, "has the shape"),
    "empty": (np.zeros((0,)), ValueError, "has the shape"),
    "empty rows": (np.zeros((3, 0)), ValueError, "has the shape"),
    "empty list": ([], ValueError, "has the shape"),
    "too few rows": (np.zeros((2, 3)), ValueError, "has the shape"),
    "image points": (np.zeros((3, 2)), ValueError, "has the shape"),
    "transposed batch": (np.zeros((3, 3, 7)), ValueError, "has the shape"),
    "too many dimensions": (np.zeros((1, 1, 3, 3)), ValueError, "has the shape"),
    "dict": ({}, TypeError, "elements of type object"),
    "function": (len, TypeError, "elements of type object"),
    "NaN": (np.full((3, 3), np.nan), eliminant.SolveError, "an infinite value or a NaN"),
    "infinite": (np.full((3, 3), -np.inf), eliminant.SolveError, "an infinite value or a NaN"),
    "too large": (10**400, (TypeError, ValueError), "centres"),
}


@pytest.mark.parametrize("value, error, text", BAD.values(), ids=BAD.keys())
def test_bad_values(value, error, text):
    with pytest.raises(error, match=text):
        eliminant.trilateration(value, DISTANCES)


@pytest.mark.parametrize("value, error, text", BAD.values(), ids=BAD.keys())
def test_bad_values_for_a_problem(value, error, text):
    with pytest.raises(error, match=text):
        eliminant.problem("trilateration").solve(value, DISTANCES)


GOOD = {
    "lists": CENTRES,
    "integers": np.array(CENTRES, dtype=np.int64),
    "bytes": np.array(CENTRES, dtype=np.uint8),
    "float32": np.array(CENTRES, dtype=np.float32),
    "columns first": np.asfortranarray(CENTRES),
    "strided": np.repeat(CENTRES, 2, axis=1)[:, ::2],
    "reversed": np.array(CENTRES)[::-1][::-1],
    "other byte order": np.array(CENTRES, dtype=">f8"),
    "read-only": np.broadcast_to(np.array(CENTRES), (3, 3)),
    "not aligned": np.frombuffer(b"x" + np.array(CENTRES).tobytes(), dtype="u1")[1:].view("f8").reshape(3, 3),
}


@pytest.mark.parametrize("value", GOOD.values(), ids=GOOD.keys())
def test_arrays_in_any_layout(value):
    expected = eliminant.trilateration(np.array(CENTRES), np.array(DISTANCES))
    np.testing.assert_array_equal(eliminant.trilateration(value, DISTANCES).values, expected.values)


def test_layouts_of_batches(rng):
    centres, distances = rng.normal(size=(20, 3, 3)), 1 + rng.random((20, 3))
    expected = eliminant.trilateration(centres, distances).values
    for other in (np.asfortranarray(centres), centres.transpose(1, 2, 0).copy().transpose(2, 0, 1)):
        np.testing.assert_array_equal(eliminant.trilateration(other, distances).values, expected)
    copies = eliminant.trilateration(centres[::2].copy(), distances[::2].copy()).values
    np.testing.assert_array_equal(eliminant.trilateration(centres[::2], distances[::2]).values, copies)


def test_a_batch_of_nothing_is_empty():
    result = eliminant.trilateration(np.zeros((0, 3, 3)), np.zeros((0, 3)))
    assert result.values.shape == (0, 2, 3) and len(result.counts) == 0 and result.errors == {}
    assert eliminant.relpose_5pt_rays(np.zeros((0, 5, 2)), np.zeros((0, 5, 3))).essential.shape == (
        0,
        10,
        3,
        3,
    )
    assert eliminant.problem("trilateration").solve(np.zeros((0, 3, 3)), np.zeros((0, 3))).shape == (0, 2, 3)


def test_batches_of_different_lengths():
    with pytest.raises(ValueError, match="`distances` holds 4 instances, the arrays before it 5"):
        eliminant.trilateration(np.zeros((5, 3, 3)), np.zeros((4, 3)))


def test_the_number_of_arguments():
    with pytest.raises(TypeError):
        eliminant.trilateration(CENTRES)
    with pytest.raises(TypeError, match=r"expected 2 arrays \(centres, distances\), got 1"):
        eliminant.problem("trilateration").solve(CENTRES)


def test_the_extension_module_checks_lengths_itself():
    """What the layer above promises is not trusted."""
    native = eliminant._eliminant
    trilateration = ([name for name, *_ in native.solvers()].index("trilateration"), [])
    with pytest.raises(ValueError, match="`centres` has another shape"):
        native.solve_batch(trilateration, [np.zeros((2, 3, 3)), np.zeros((3, 3))], 3)
    with pytest.raises(ValueError, match="takes 2 arrays"):
        native.solve_one(trilateration, [np.zeros((3, 3))])
    with pytest.raises(ValueError, match="not contiguous"):
        native.solve_one(trilateration, [np.zeros((3, 6))[:, ::2], np.zeros(3)])
    with pytest.raises(IndexError):
        native.solve_one((10**6, []), [])
    with pytest.raises(ValueError):
        native.solve_batch(trilateration, [np.zeros((2, 3, 3)), np.zeros((2, 3))], 2**62)
    with pytest.raises(MemoryError):
        native.solve_batch(trilateration, [np.zeros((3, 3)), np.zeros(3)], 2**62)
    with pytest.raises(TypeError):
        native.solve_one(trilateration, [np.zeros((3, 3), dtype=np.float32), np.zeros(3)])
