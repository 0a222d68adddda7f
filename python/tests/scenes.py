"""Scenes whose truth is known, n at a time."""

from __future__ import annotations

import numpy as np


def rotations(rng: np.random.Generator, n: int) -> np.ndarray:
    """Random rotations, of shape (n, 3, 3)."""
    q = rng.normal(size=(n, 4))
    q /= np.linalg.norm(q, axis=1, keepdims=True)
    w, x, y, z = q.T
    entries = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(entries), -1, 0)


def small_rotations(rng: np.random.Generator, n: int, most: float = 0.5) -> np.ndarray:
    """Rotations by at most about `most` radians."""
    v = rng.uniform(-most / 2, most / 2, size=(n, 3))
    q = np.concatenate([np.ones((n, 1)), v], axis=1)
    q /= np.linalg.norm(q, axis=1, keepdims=True)
    w, xyz = q[:, 0], q[:, 1:]
    skew = cross_matrix(xyz)
    return np.eye(3) + 2 * w[:, None, None] * skew + 2 * skew @ skew


def cross_matrix(v: np.ndarray) -> np.ndarray:
    """The matrices of v x."""
    x, y, z = np.moveaxis(v, -1, 0)
    zero = np.zeros_like(x)
    return np.moveaxis(np.array([[zero, -z, y], [z, zero, -x], [-y, x, zero]]), (0, 1), (-2, -1))


def two_views(rng: np.random.Generator, n: int, points: int) -> dict[str, np.ndarray]:
    """Points in front of two cameras: images of shape (n, points, 2), motion, essential matrix."""
    rotation = small_rotations(rng, n)
    translation = rng.normal(size=(n, 3)) * [1, 1, 0.3]
    x = rng.uniform(-2, 2, size=(n, points, 3)) + [0, 0, 7]
    y = x @ rotation.transpose(0, 2, 1) + translation[:, None]
    essential = cross_matrix(translation) @ rotation
    return {
        "first": x[..., :2] / x[..., 2:],
        "second": y[..., :2] / y[..., 2:],
        "rotation": rotation,
        "translation": translation,
        "essential": essential / np.linalg.norm(essential, axis=(1, 2), keepdims=True),
    }


def one_view(rng: np.random.Generator, n: int, points: int) -> dict[str, np.ndarray]:
    """Points of the world in front of a camera: images of shape (n, points, 2), and the pose."""
    rotation = rotations(rng, n)
    seen = rng.uniform(-2, 2, size=(n, points, 3)) + [0, 0, 6]
    translation = rng.normal(size=(n, 3))
    world = (seen - translation[:, None]) @ rotation
    return {
        "image": seen[..., :2] / seen[..., 2:],
        "points": world,
        "rotation": rotation,
        "translation": translation,
    }


def found(matrices: np.ndarray, truth: np.ndarray, tolerance: float = 1e-6) -> np.ndarray:
    """For which instances one of the matrices, of shape (n, most, ..), is the true one up to scale."""
    n, most = matrices.shape[:2]
    a, b = matrices.reshape(n, most, -1), truth.reshape(n, 1, -1)
    a = a / np.linalg.norm(a, axis=-1, keepdims=True)
    b = b / np.linalg.norm(b, axis=-1, keepdims=True)
    distance = np.minimum(np.linalg.norm(a - b, axis=-1), np.linalg.norm(a + b, axis=-1))
    return (np.nan_to_num(distance, nan=np.inf) < tolerance).any(axis=1)


def poses_found(
    rotations: np.ndarray, translations: np.ndarray, truth: dict[str, np.ndarray], tolerance: float = 1e-6
) -> np.ndarray:
    """For which instances one of the poses, of shape (n, most, ..), is the true one."""
    turn = np.linalg.norm(rotations - truth["rotation"][:, None], axis=(-1, -2))
    size = np.linalg.norm(truth["translation"], axis=-1)[:, None]
    shift = np.linalg.norm(translations - truth["translation"][:, None], axis=-1) / size
    return (np.nan_to_num(np.maximum(turn, shift), nan=np.inf) < tolerance).any(axis=1)
