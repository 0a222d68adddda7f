"""Minimal solvers of computer vision, and a generator of solvers for polynomial problems."""

from ._eliminant import ProblemError, SolveError, __version__
from ._problem import Check, Problem, Template, catalogue, problem
from ._solutions import Solutions, Status
from ._stability import Stability
from ._stability_summary import StabilitySummary
from .solvers import *  # noqa: F403
from .solvers import __all__ as _names

__all__ = [
    "Check",
    "Problem",
    "ProblemError",
    "Solutions",
    "SolveError",
    "Stability",
    "StabilitySummary",
    "Status",
    "Template",
    "__version__",
    "catalogue",
    "problem",
    *_names,
]
