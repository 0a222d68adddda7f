"""What a solver finds on any number of random instances or scenes, in little memory."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, Iterable, Tuple, TypeVar

import numpy as np
import numpy.typing as npt

from ._arrays import Array

BINS_OF_A_DECADE = 10
"""Bins of a histogram from one power of ten to the next."""
DECADES = 40
"""Errors are told apart from 1e-40 to 1e40."""
EDGES: Array = 10.0 ** (np.arange(-DECADES * BINS_OF_A_DECADE, DECADES * BINS_OF_A_DECADE + 1) / BINS_OF_A_DECADE)
"""The edges of the bins. Errors are compared with these, so that a bin depends on its error only."""
WORST = 10
"""Instances that are kept for the largeness of their errors."""

Histogram = Dict[int, int]
Key = TypeVar("Key", int, str)


@dataclass(frozen=True)
class StabilitySummary:
    """Figures of random instances or scenes, summed up. Those of parts join to those of the whole, in any
    order, number by number."""

    problem: str
    """The name of the problem."""
    family: str
    """What the instances are: "random" or "scene"."""
    seed: int
    """The seed of the instances."""
    instances: int
    """How many there are."""
    failed: int
    """The number of instances on which the solver returned an error."""
    incomplete: int
    """The number of instances on which a solution was missed, or the solver failed."""
    totals: Dict[str, int]
    """The sums of the arrays of `Stability` that count, by their names."""
    errors: Dict[int, int]
    """How often each `status` other than 0 occurs."""
    residual: Histogram
    """How many largest relative residuals lie in each bin: bin k is from 10**(k / 10) to the next
    edge. Instances without a returned point are in none."""
    forward_error: Histogram
    """The same for the largest relative distances from the true solutions."""
    worst: Tuple[Tuple[float, int], ...]
    """The ten largest of these distances with the numbers of their instances."""

    @staticmethod
    def join(parts: "Iterable[StabilitySummary]") -> "StabilitySummary":
        """One summary of parts that share no instance. They are taken one at a time."""
        parts = iter(parts)
        whole = next(parts, None)
        if whole is None:
            raise ValueError("there is nothing to join")
        for part in parts:
            whole = whole._with(part)
        return whole

    def quantile(self, share: float, of: str = "forward_error") -> float:
        """An error that this share of the instances with points does not exceed: the upper edge of
        the bin in which the share is reached, so at most 1.26 times too large."""
        histogram: Histogram = getattr(self, of)
        bins = sorted(histogram)
        if not bins:
            return float("nan")
        reached = np.cumsum([histogram[at] for at in bins])
        at = bins[min(int(np.searchsorted(reached, share * reached[-1])), len(bins) - 1)]
        return float(10.0 ** ((at + 1) / BINS_OF_A_DECADE))

    def _with(self, other: "StabilitySummary") -> "StabilitySummary":
        if (self.problem, self.family, self.seed) != (other.problem, other.family, other.seed):
            raise ValueError("the parts are of different problems, families or seeds")
        return StabilitySummary(
            problem=self.problem,
            family=self.family,
            seed=self.seed,
            instances=self.instances + other.instances,
            failed=self.failed + other.failed,
            incomplete=self.incomplete + other.incomplete,
            totals=_sum(self.totals, other.totals),
            errors=_sum(self.errors, other.errors),
            residual=_sum(self.residual, other.residual),
            forward_error=_sum(self.forward_error, other.forward_error),
            worst=_largest((*self.worst, *other.worst)),
        )

    def __repr__(self) -> str:
        return (
            f"<{self.instances} instances of {self.problem}: {self.totals['complex']} solutions, "
            f"{self.totals['complex_missed']} missed, {self.failed} failed, "
            f"largest error {self.worst[0][0] if self.worst else float('nan'):.1e}>"
        )


def histogram(errors: Array) -> Histogram:
    """How many errors lie in each bin. Those beyond the edges are in the first and the last bin."""
    known = errors[~np.isnan(errors)]
    at = np.clip(np.searchsorted(EDGES, known, side="right") - 1, 0, len(EDGES) - 2)
    bins, counts = np.unique(at - DECADES * BINS_OF_A_DECADE, return_counts=True)
    return {int(bin): int(count) for bin, count in zip(bins, counts)}


def worst(errors: Array, instances: npt.NDArray[np.int64]) -> Tuple[Tuple[float, int], ...]:
    """The largest errors with the numbers of their instances."""
    known = np.flatnonzero(~np.isnan(errors))
    order = known[np.lexsort((instances[known], -errors[known]))][:WORST]
    return _largest((float(errors[at]), int(instances[at])) for at in order)


def _largest(errors: Iterable[Tuple[float, int]]) -> Tuple[Tuple[float, int], ...]:
    return tuple(sorted(errors, key=lambda error: (-error[0], error[1]))[:WORST])


def _sum(a: Dict[Key, int], b: Dict[Key, int]) -> Dict[Key, int]:
    return {key: a.get(key, 0) + b.get(key, 0) for key in sorted(a.keys() | b.keys())}
