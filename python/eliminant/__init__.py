"""Minimal solvers of computer vision, and a generator of solvers for polynomial problems."""

from ._eliminant import SolveError, __version__
from ._solutions import Solutions, Status

__all__ = ["SolveError", "Solutions", "Status", "__version__"]
