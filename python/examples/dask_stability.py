"""A stability run on many machines: instances of one seed, divided among the workers of Dask.

    python examples/dask_stability.py relpose_5pt --trials 2000 --shards 8
    python examples/dask_stability.py relpose_5pt --scheduler tcp://host:8786

Instance k depends on the seed and k only, so the result is that of one process, number by number.
A problem travels as its text and its template, and a summary comes back: memory does not grow with
the number of instances. `--check` compares with one process.
"""

from __future__ import annotations

import argparse
import time

import numpy as np
from dask.distributed import Client, LocalCluster, as_completed

import eliminant

PART = 10_000
"""Instances whose figures a worker holds at once."""


def shard(problem: eliminant.Problem, first: int, end: int, seed: int) -> eliminant.StabilitySummary:
    """What a worker does."""
    parts = (
        problem.stability(min(PART, end - at), seed, first=at, progress=False) for at in range(first, end, PART)
    )
    return eliminant.StabilitySummary.join(part.summary() for part in parts)


def stability(
    client: Client, problem: eliminant.Problem, trials: int, seed: int = 1, shards: int = 8
) -> eliminant.StabilitySummary:
    """The figures of `trials` instances, `shards` tasks at most."""
    bounds = [int(bound) for bound in np.unique(np.linspace(0, trials, shards + 1).astype(int))]
    tasks = [client.submit(shard, problem, *ends, seed, pure=False) for ends in zip(bounds, bounds[1:])]
    finished = as_completed(tasks, with_results=True)
    return eliminant.StabilitySummary.join(summary for _, summary in finished)


def main() -> None:
    """Runs on the workers of a scheduler, or on two of this machine."""
    parser = argparse.ArgumentParser(description="Stability of a problem of the catalogue, by Dask")
    parser.add_argument("problem", choices=eliminant.catalogue(), metavar="PROBLEM")
    parser.add_argument("--trials", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--shards", type=int, default=8)
    parser.add_argument("--scheduler", help="address of a scheduler; by default two workers of this machine")
    parser.add_argument("--check", action="store_true", help="compare with one process")
    arguments = parser.parse_args()
    problem, start = eliminant.problem(arguments.problem), time.monotonic()
    cluster = arguments.scheduler or LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None)
    with Client(cluster) as client:
        found = stability(client, problem, arguments.trials, arguments.seed, arguments.shards)
    print(found)
    shares = ", ".join(f"{share:.2%} {found.quantile(share):.1e}" for share in (0.5, 0.99, 0.9999))
    print(f"share of instances and its largest error: {shares}; {time.monotonic() - start:.0f} s")
    if arguments.check:
        whole = problem.stability(arguments.trials, arguments.seed, progress=False).summary()
        assert found == whole, "the figures differ"
        print("the figures of one process are the same")


if __name__ == "__main__":
    main()
