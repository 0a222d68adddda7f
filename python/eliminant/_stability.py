"""What a solver finds on random instances or scenes, as arrays."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any, Dict, List, Sequence, Tuple

import numpy as np
import numpy.typing as npt

from . import _eliminant
from ._arrays import Array
from ._stability_summary import StabilitySummary, histogram, worst

Counts = npt.NDArray[np.int64]


@dataclass(frozen=True)
class Stability:
    """Figures of random instances or scenes, an element of each array for one instance.

    Solutions are judged by true ones. A point has a solution of its own if it is at most 0.01 away,
    relative to the solution; points left over are spurious, and solutions left over are missed.
    """

    problem: str
    """The name of the problem."""
    family: str
    """What the instances are: "random" or "scene"."""
    seed: int
    """The seed of the instances."""
    instance: Counts
    """The number of the instance."""
    real: Counts
    """Real solutions that there are."""
    real_missed: Counts
    real_spurious: Counts
    complex: Counts
    """Complex solutions that there are, the real ones included."""
    complex_missed: Counts
    complex_spurious: Counts
    attempts: Counts
    """How often the template was eliminated for all complex solutions: 2 after a second attempt."""
    is_certain: Counts
    """1 where the true solutions are as many as the problem has for general data."""
    known_missed: Counts
    """1 where the solution that a scene says is not among the returned ones, to 1e-6 of it."""
    residual: Array
    """The largest relative residual of a returned point; NaN if there is none."""
    forward_error: Array
    """The largest relative distance of a returned point from its solution; NaN if there is none."""
    status: npt.NDArray[np.uint16]
    """The error of the solver: 0, or a number for `error`."""

    @classmethod
    def of(cls, run: Tuple[str, str, int], first: int, figures: "_eliminant.Figures") -> "Stability":
        """From problem, family and seed, and what the extension module returns."""
        problem, family, seed = run
        counts, errors, status = figures
        named: Dict[str, Any] = dict(zip(_eliminant.COUNTS, counts))
        named.update(zip(_eliminant.ERRORS, errors))
        instance = np.arange(first, first + len(status), dtype=np.int64)
        return cls(problem=problem, family=family, seed=seed, instance=instance, status=status, **named)

    @staticmethod
    def join(parts: Sequence["Stability"]) -> "Stability":
        """One run from runs on parts of its instances, in the order of the instances."""
        if not parts:
            raise ValueError("there is nothing to join")
        if len({(part.problem, part.family, part.seed) for part in parts}) > 1:
            raise ValueError("the parts are of different problems, families or seeds")
        order = np.argsort(np.concatenate([part.instance for part in parts]), kind="stable")
        arrays = {
            name: np.concatenate([getattr(part, name) for part in parts])[order] for name in array_names()
        }
        first = parts[0]
        return Stability(problem=first.problem, family=first.family, seed=first.seed, **arrays)

    def summary(self) -> StabilitySummary:
        """What is left of these figures in little memory."""
        kinds, counts = np.unique(self.status[self.status != 0], return_counts=True)
        return StabilitySummary(
            problem=self.problem,
            family=self.family,
            seed=self.seed,
            instances=len(self),
            failed=self.failed,
            incomplete=self.incomplete,
            totals={name: int(getattr(self, name).sum()) for name in sorted(_eliminant.COUNTS)},
            errors={int(kind): int(count) for kind, count in zip(kinds, counts)},
            residual=histogram(self.residual),
            forward_error=histogram(self.forward_error),
            worst=worst(self.forward_error, self.instance),
        )

    def __len__(self) -> int:
        return len(self.status)

    @property
    def failed(self) -> int:
        """The number of instances on which the solver returned an error."""
        return int(np.count_nonzero(self.status))

    @property
    def incomplete(self) -> int:
        """The number of instances on which a solution was missed, or the solver failed."""
        missed = self.real_missed + self.complex_missed + self.known_missed
        return int(np.count_nonzero((self.status != 0) | (missed > 0)))

    def __repr__(self) -> str:
        with np.errstate(all="ignore"):
            worst = np.nanmax(self.forward_error) if np.isfinite(self.forward_error).any() else float("nan")
        return (
            f"<{len(self)} instances of {self.problem}: {int(self.complex.sum())} solutions, "
            f"{int(self.complex_missed.sum())} missed, {self.failed} failed, largest error {worst:.1e}>"
        )


def array_names() -> List[str]:
    """The names of all arrays."""
    return [field.name for field in fields(Stability) if field.name not in ("problem", "family", "seed")]
