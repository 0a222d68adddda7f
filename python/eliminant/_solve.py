"""Calls of the solvers of the catalogue."""

from __future__ import annotations

from typing import Any, Dict, Iterable, NamedTuple, Optional, Tuple

from . import _eliminant
from ._arrays import Array, Shape, data
from ._progress import Progress, counted
from ._solutions import Named, Solutions, arranged


class Solver(NamedTuple):
    """What is known of a solver."""

    number: int
    name: str
    data: Named
    fields: Named
    results: Named
    most: int
    docs: str


class Mean(NamedTuple):
    """Data of a solver that are means over measurements."""

    solver: int
    name: str
    data: Named
    shape: Shape
    docs: str


def _shapes(named: Any) -> Named:
    return tuple((name, tuple(shape)) for name, shape in named)


def _solvers() -> Dict[str, Solver]:
    solvers = {}
    for number, (name, parameters, fields, results, most, docs) in enumerate(_eliminant.solvers()):
        solvers[name] = Solver(number, name, _shapes(parameters), _shapes(fields), _shapes(results), most, docs)
    return solvers


SOLVERS = _solvers()
"""All solvers by their names."""


def _means() -> Dict[str, Mean]:
    means = {}
    names = list(SOLVERS)
    for solver, name, measurement, shape, docs in _eliminant.means():
        means[f"{names[solver]}_{name}"] = Mean(solver, name, _shapes(measurement), tuple(shape), docs)
    return means


MEANS = _means()
"""All means over measurements, by the names of their functions."""

HOMOGENEOUS: Dict[str, Tuple[str, ...]] = {
    "pose_1pt_2line": ("ray",),
    "pose_2pt_1line": ("rays",),
    "pose_2pt_upright": ("rays",),
    "pose_3pt": ("rays",),
    "pose_5pt_refraction": ("rays",),
    "pose_npt_direct_least_squares_mean_of_point": ("ray",),
    "pose_npt_least_squares_cayley_mean_of_point": ("ray",),
    "relpose_3pt_angle_zero_screw": ("first", "second"),
    "relpose_3pt_upright": ("first", "second"),
    "relpose_4pt_angle": ("first", "second"),
    "relpose_5pt_rays": ("first", "second"),
}
"""Data that are rays of image points by the documentation of their problem.

An image point (x, y) is the ray (x, y, 1). The rays of generalized cameras have points and
directions in space, and are not among them.
"""


def solve(
    name: str, *values: Any, results: Optional[Iterable[str]] = None, progress: Progress = None
) -> Solutions:
    """The real solutions of one instance, or of a batch.

    `results` has the names of the results to compute, all by default.

    Raises `SolveError` where the data of one instance are not finite, or degenerate. In a batch the
    status of the instance says so.
    """
    solver = SOLVERS[name]
    arrays, count = data(solver.data, HOMOGENEOUS.get(name, ()), values)
    wanted = _wanted(solver, results)
    of = (solver.number, [name for name, _ in wanted])
    if count < 0:
        solved = _eliminant.solve_one(of, arrays)
    else:
        with counted(progress, name, " instances") as report:
            solved = _eliminant.solve_batch(of, arrays, count, report)
    return arranged(solver.fields, wanted, solver.most, solved, count >= 0)


def _wanted(solver: Solver, names: Optional[Iterable[str]]) -> Named:
    """The results of these names."""
    if names is None:
        return solver.results
    wanted = {names} if isinstance(names, str) else set(names)
    known = [name for name, _ in solver.results]
    for name in sorted(wanted.difference(known), key=str):
        raise ValueError(f"`{solver.name}` has no result `{name}`: there are {', '.join(known) or 'none'}")
    return tuple(result for result in solver.results if result[0] in wanted)


def mean(name: str, *values: Any) -> Array:
    """The mean over measurements. Without any it is not a number."""
    of = MEANS[name]
    arrays, count = data(of.data, HOMOGENEOUS.get(name, ()), values)
    computed: Array = _eliminant.mean(of.solver, of.name, arrays, 1 if count < 0 else count)
    return computed.reshape(of.shape)
