#!/usr/bin/env python3
"""Our solvers beside the Python wheel `poselib`, on the same scenes.

    python3 -m venv VENV && VENV/bin/pip install poselib numpy
    VENV/bin/python tests/poselib/compare.py [--instances 10000] [--update]

The scenes and our solutions come from `cargo run --example poselib_scenes`. A truth is found if
some solution is as close as 1e-6; both sides are judged here, by the same code. With --update the
table is written to the README.md beside this file. Without the wheel the script says so and ends
well: nothing is compared.
"""

import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import time

try:
    import numpy as np
    import poselib
except ImportError as error:
    print(f"skipped: {error}; `pip install poselib numpy` makes the comparison possible")
    sys.exit(0)

FOUND = 1e-6
HERE = pathlib.Path(__file__).resolve().parent
MARKS = "<!-- poselib:begin -->", "<!-- poselib:end -->"


def relative(solutions, truth):
    """Errors of rows of numbers, relative to the length of the truth."""
    return np.linalg.norm(solutions - truth, axis=1) / np.linalg.norm(truth)


def essential_errors(solutions, truth):
    """Errors of matrices up to a factor."""
    with np.errstate(all="ignore"):
        units = solutions / np.linalg.norm(solutions, axis=1, keepdims=True)
    truth = truth / np.linalg.norm(truth)
    return np.minimum(relative(units, truth), relative(units, -truth))


def pose_errors(solutions, truth):
    """The largest error of a rotation, a translation and, if there is one, a focal length."""
    parts = [slice(0, 9), slice(9, 12), slice(12, 13)][: 3 if len(truth) > 12 else 2]
    return np.max([relative(solutions[:, part], truth[part]) for part in parts], axis=0)


def pose(camera_pose, *focal):
    """A pose as our side writes it: rotation row by row, translation, focal length."""
    return np.concatenate([camera_pose.R.ravel(), camera_pose.t, focal])


class Five:
    """Rays of five points to essential matrices."""

    title = "five-point, points to E"
    function = "essential_matrix_5pt"
    errors = staticmethod(essential_errors)

    def load(data):
        rays = data.reshape(10, 3)
        return rays[:5].copy(), rays[5:].copy()

    def solutions(found):
        return [matrix.ravel() for matrix in found]


class Six:
    """Image points of six points to poses and the focal length that both cameras share."""

    title = "six-point shared focal, points to poses"
    function = "shared_focal_relpose_6pt"
    errors = staticmethod(pose_errors)

    def load(data):
        images = data.reshape(12, 3)
        return images[:6].copy(), images[6:].copy()

    def solutions(found):
        return [pose(pair.pose, pair.camera1.focal()) for pair in found]


class Three:
    """Rays to three points to poses."""

    title = "P3P, points to poses"
    function = "p3p"
    errors = staticmethod(pose_errors)

    def load(data):
        vectors = data.reshape(6, 3)
        return vectors[:3].copy(), vectors[3:].copy()

    def solutions(found):
        return [pose(each) for each in found]


class Four:
    """Image points of four points to poses and focal length: ours takes seven of the eight
    coordinates, theirs takes all, and tells the solution that fits them best."""

    title = "3.5-point focal, points to poses"
    function = "p4pf"
    errors = staticmethod(pose_errors)

    def load(data):
        return data[:8].reshape(4, 2).copy(), data[8:].reshape(4, 3).copy(), False

    def solutions(found):
        return [pose(each, focal) for each, focal in zip(*found)]


CASES = {"five": Five, "six": Six, "three": Three, "four": Four}


def is_found(case, solutions, truth):
    """Whether some solution is the truth. What is not a number is no solution."""
    solutions = [solution for solution in solutions if np.all(np.isfinite(solution))]
    return bool(solutions) and np.min(case.errors(np.array(solutions), truth)) <= FOUND


def judge(line):
    """Both sides on one scene: found by ours, found by theirs, and the microseconds of each."""
    scene = json.loads(line)
    case = CASES[scene["case"]]
    truth = np.array(scene["truth"])
    arguments = case.load(np.array(scene["data"]))
    solve = getattr(poselib, case.function)
    microseconds = float("inf")
    for _ in range(3):
        start = time.perf_counter_ns()
        found = solve(*arguments)
        microseconds = min(microseconds, (time.perf_counter_ns() - start) / 1e3)
    ours = np.array(scene["found"]).reshape(-1, len(truth))
    key = scene["case"], scene["family"]
    sides = is_found(case, list(ours), truth), is_found(case, case.solutions(found), truth)
    return key, (*sides, scene["nanoseconds"] / 1e3, microseconds)


def table(judged):
    """A row for each problem and motion."""
    lines = [
        "| case | scenes | function of the wheel | ours found | theirs found | ours, µs | theirs, µs |",
        "|---|---|---|--:|--:|--:|--:|",
    ]
    for (name, family), rows in judged.items():
        ours, theirs, our_times, their_times = zip(*rows)
        share = [f"{100 * sum(side) / len(rows):.2f} %" for side in (ours, theirs)]
        times = [f"{statistics.median(side):.1f}" for side in (our_times, their_times)]
        case = CASES[name]
        cells = [case.title, family, f"`{case.function}`", *share, *times]
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)


def update(text):
    """Puts the text between the marks of the README.md."""
    path = HERE / "README.md"
    before, rest = path.read_text().split(MARKS[0])
    after = rest.split(MARKS[1])[1]
    path.write_text(f"{before}{MARKS[0]}\n{text}\n{MARKS[1]}{after}")


def main():
    parser = argparse.ArgumentParser(description="Our solvers beside the wheel `poselib`")
    parser.add_argument("--instances", type=int, default=10_000, help="scenes of each row")
    parser.add_argument("--seed", type=int, default=1, help="seed of the first scene")
    parser.add_argument("--program", help="the compiled example, in place of `cargo run`")
    parser.add_argument("--update", action="store_true", help="write the table to README.md")
    arguments = parser.parse_args()
    built = "cargo run --release --quiet -p eliminant-tests --example poselib_scenes --".split()
    program = [arguments.program] if arguments.program else built
    options = ["--instances", str(arguments.instances), "--seed", str(arguments.seed)]
    judged = {}
    with subprocess.Popen(program + options, stdout=subprocess.PIPE, text=True, cwd=HERE) as scenes:
        for line in scenes.stdout:
            key, row = judge(line)
            judged.setdefault(key, []).append(row)
    if scenes.returncode != 0:
        sys.exit(scenes.returncode)
    version = getattr(poselib, "__version__", "?")
    head = f"poselib {version}, {arguments.instances} scenes a row, seed {arguments.seed}:"
    text = f"{head}\n\n{table(judged)}"
    print(text)
    if arguments.update:
        update(text)


if __name__ == "__main__":
    main()
