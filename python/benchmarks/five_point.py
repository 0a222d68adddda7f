"""Five-point instances in a batch beside PoseLib, all cores to all cores.

    python benchmarks/five_point.py

Both sides get rays as arrays. Ours and the pool return all essential matrices as arrays; ours
returns rotations and translations of all solutions besides if it is not told to leave them out. The
loop drops what is returned. PoseLib solves an instance a call: in a loop, and in a pool of as many
processes as there are cores, which inherit the rays and return one array for each of their chunks.
The sides take turns; times are medians over the rounds. CPU seconds are those of all threads and
processes of a side, so that other programs on the machine matter less.
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

SIDES = ("eliminant", "with poses", "poselib, pool", "poselib, loop")
MOST = 10
DATA: dict[str, np.ndarray] = {}


def rays(points: np.ndarray) -> np.ndarray:
    """Rays of length 1."""
    rays = np.concatenate([points, np.ones((*points.shape[:-1], 1))], axis=-1)
    return rays / np.linalg.norm(rays, axis=-1, keepdims=True)


def poselib_chunk(bounds: tuple[int, int]) -> tuple[np.ndarray, float]:
    """The essential matrices of some instances, filled up with NaN, and the CPU seconds."""
    import poselib

    start = time.process_time()
    first, second, solve = DATA["first"], DATA["second"], poselib.essential_matrix_5pt
    found = np.full((bounds[1] - bounds[0], MOST, 3, 3), np.nan)
    for at in range(*bounds):
        matrices = solve(first[at], second[at])
        if matrices:
            found[at - bounds[0], : len(matrices)] = matrices
    return found, time.process_time() - start


def poselib_pool(pool, chunks: list[tuple[int, int]]) -> tuple[np.ndarray, float]:
    """The essential matrices of all instances, and the CPU seconds of the processes."""
    found = pool.map(poselib_chunk, chunks, chunksize=1)
    return np.concatenate([part for part, _ in found]), sum(cpu for _, cpu in found)


def poselib_loop(n: int) -> None:
    """Calls alone: what is returned is dropped."""
    import poselib

    solve = poselib.essential_matrix_5pt
    for first, second in zip(DATA["first"][:n], DATA["second"][:n]):
        solve(first, second)


def measured(work) -> tuple[np.ndarray, tuple[float, float]]:
    """What a call returns, its seconds, and the CPU seconds of all threads."""
    start, cpu = time.perf_counter(), time.process_time()
    result, of_others = work()
    return result, (time.perf_counter() - start, time.process_time() - cpu + of_others)


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
    first, second = DATA["first"], DATA["second"]
    times: dict[str, list[tuple[float, float]]] = {name: [] for name in SIDES}
    found = {}
    with multiprocessing.get_context("fork").Pool(cores) as pool:
        pool.map(poselib_chunk, [(0, 10)] * cores)
        sides = (
            lambda: (eliminant.relpose_5pt_rays(first, second, results=["essential"]).essential, 0.0),
            lambda: (eliminant.relpose_5pt_rays(first, second).essential, 0.0),
            lambda: poselib_pool(pool, chunks),
            lambda: (poselib_loop(n), 0.0),
        )
        for _ in range(arguments.rounds):
            for name, side in zip(SIDES, sides):
                found[name], took = measured(side)
                times[name].append(took)
    print(f"{cores} cores of {processor()}; {n} instances, medians of {arguments.rounds} rounds\n")
    print("| side          | seconds | times ours | CPU seconds | times ours | found    |")
    print("|---------------|---------|------------|-------------|------------|----------|")
    medians = {name: [statistics.median(each) for each in zip(*list_)] for name, list_ in times.items()}
    for name, (took, cpu) in medians.items():
        ratios = [value / ours for value, ours in zip((took, cpu), medians[SIDES[0]])]
        share = (
            ""
            if found[name] is None
            else f"{100 * scenes.found(found[name], views['essential']).mean():.2f} %"
        )
        print(
            f"| {name:13} | {took:7.3f} | {ratios[0]:10.2f} | {cpu:11.3f} | {ratios[1]:10.2f} | {share:>8} |"
        )


if __name__ == "__main__":
    main()
