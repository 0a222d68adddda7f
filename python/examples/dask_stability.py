"""A stability run on many machines: instances of one seed, divided among the workers of Dask.

    python examples/dask_stability.py relpose_5pt --trials 2000 --shards 8
    python examples/dask_stability.py relpose_5pt --scheduler tcp://host:8786

Instance k depends on the seed and k only, so the result is that of one process, number by number.
A problem travels as its text and its template. `--check` compares with one process.
"""

from __future__ import annotations

import argparse

import numpy as np
from dask.distributed import Client, LocalCluster

import eliminant


def shard(problem: eliminant.Problem, first: int, trials: int, seed: int) -> eliminant.Stability:
    """What a worker does."""
    return problem.stability(trials, seed, first=first)


def stability(
    client: Client, problem: eliminant.Problem, trials: int, seed: int = 1, shards: int = 8
) -> eliminant.Stability:
    """The figures of `trials` instances, `shards` tasks at most."""
    bounds = np.unique(np.linspace(0, trials, shards + 1).astype(int))
    tasks = [
        client.submit(shard, problem, int(first), int(end - first), seed, pure=False)
        for first, end in zip(bounds, bounds[1:])
    ]
    return eliminant.Stability.join(client.gather(tasks))


def same(a: eliminant.Stability, b: eliminant.Stability) -> bool:
    """Whether all figures are the same."""
    names = a.__dataclass_fields__
    return all(
        np.array_equal(getattr(a, name), getattr(b, name), equal_nan=name in ("residual", "forward_error"))
        for name in names
    )


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
    problem = eliminant.problem(arguments.problem)
    cluster = arguments.scheduler or LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None)
    with Client(cluster) as client:
        found = stability(client, problem, arguments.trials, arguments.seed, arguments.shards)
    print(found)
    if arguments.check:
        assert same(found, problem.stability(arguments.trials, arguments.seed)), "the figures differ"
        print("the figures of one process are the same")


if __name__ == "__main__":
    main()
