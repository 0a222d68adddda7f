"""Five-point instances in a batch beside PoseLib, all cores to all cores.

    python benchmarks/five_point.py

Both sides get rays as arrays and return all essential matrices as arrays. PoseLib solves an instance
a call: in a loop, and in a pool of as many processes as there are cores, which inherit the rays and
return one array for each of their chunks. The sides take turns; times are medians over the rounds.
"""

from __future__ import annotations

import argparse
import multiprocessing
import os
import platform
import statistics
import sys
import time
from pathlib import Path

import numpy as np

import eliminant

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))
import scenes  # noqa: E402

MOST = 10
DATA: dict[str, np.ndarray] = {}


def rays(points: np.ndarray) -> np.ndarray:
    """Rays of length 1."""
    rays = np.concatenate([points, np.ones((*points.shape[:-1], 1))], axis=-1)
    return rays / np.linalg.norm(rays, axis=-1, keepdims=True)


def poselib_chunk(bounds: tuple[int, int]) -> np.ndarray:
    """The essential matrices of some instances, filled up with NaN."""
    import poselib

    first, second, solve = DATA["first"], DATA["second"], poselib.essential_matrix_5pt
    found = np.full((bounds[1] - bounds[0], MOST, 3, 3), np.nan)
    for at in range(*bounds):
        matrices = solve(first[at], second[at])
        if matrices:
            found[at - bounds[0], : len(matrices)] = matrices
    return found


def poselib_loop(n: int) -> None:
    """Calls alone: what is returned is dropped."""
    import poselib

    solve = poselib.essential_matrix_5pt
    for first, second in zip(DATA["first"][:n], DATA["second"][:n]):
        solve(first, second)


def seconds(work) -> tuple[float, object]:
    """The time of a call, and what it returns."""
    start = time.perf_counter()
    result = work()
    return time.perf_counter() - start, result


def processor() -> str:
    """The name of the processor."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
        return next(line.split(":")[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or platform.machine()


def main() -> None:
    """Prints the table."""
    parser = argparse.ArgumentParser(description="Five-point instances in a batch beside PoseLib")
    parser.add_argument("--instances", type=int, default=100_000)
    parser.add_argument("--rounds", type=int, default=7)
    arguments = parser.parse_args()
    n, cores = (
        arguments.instances,
        len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count(),
    )
    views = scenes.two_views(np.random.default_rng(1), n, 5)
    DATA["first"], DATA["second"] = rays(views["first"]), rays(views["second"])
    # Processes are forked before any thread of ours starts.
    chunks = np.linspace(0, n, 8 * cores + 1).astype(int)
    chunks = [(int(a), int(b)) for a, b in zip(chunks, chunks[1:])]
    times: dict[str, list[float]] = {"eliminant": [], "poselib, pool": [], "poselib, loop": []}
    with multiprocessing.get_context("fork").Pool(cores) as pool:
        pool.map(poselib_chunk, [(0, 10)] * cores)
        for _ in range(arguments.rounds):
            took, ours = seconds(lambda: eliminant.relpose_5pt_rays(DATA["first"], DATA["second"]).essential)
            times["eliminant"].append(took)
            took, theirs = seconds(lambda: np.concatenate(pool.map(poselib_chunk, chunks, chunksize=1)))
            times["poselib, pool"].append(took)
            times["poselib, loop"].append(seconds(lambda: poselib_loop(n))[0])
    shares = [scenes.found(found, views["essential"]).mean() for found in (ours, theirs)]
    medians = {name: statistics.median(list_) for name, list_ in times.items()}
    print(f"{cores} cores of {processor()}; {n} instances, medians of {arguments.rounds} rounds\n")
    print("| side          | cores | seconds | million/s | times ours | found    |")
    print("|---------------|-------|---------|-----------|------------|----------|")
    for name, used, share in zip(times, (cores, cores, 1), (*shares, shares[1])):
        took = medians[name]
        ratio = took / medians["eliminant"]
        print(
            f"| {name:13} | {used:5} | {took:7.3f} | {n / took / 1e6:9.3f} | {ratio:10.2f} | {100 * share:6.2f} % |"
        )


if __name__ == "__main__":
    main()
