#!/usr/bin/env python3
"""The estimator beside `estimate_relative_pose` of the Python wheel `poselib`, on the same scenes.

    python3 -m venv VENV && VENV/bin/pip install poselib numpy
    VENV/bin/python examples/two-view/compare.py [--scenes 200] [--seed 1] [--threshold 3] [--update]

The scenes are written to a file by this example. Both sides then estimate all of them, in turns, as
often as --rounds says; the time of a scene is the shortest. Both get pixels and cameras, and
end at a pose, with the same threshold, confidence and limits on samples. Both are judged here, by
the same code. With --update the table is written to the README.md beside this file. Without the
wheel the script says so and ends well: nothing is compared.
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile
import time

try:
    import numpy as np
    import poselib
except ImportError as error:
    print(f"skipped: {error}; `pip install poselib numpy` makes the comparison possible")
    sys.exit(0)

HERE = pathlib.Path(__file__).resolve().parent
MARKS = "<!-- compare:begin -->", "<!-- compare:end -->"
OUTLIERS = 0.3, 0.6
HEAD = """\
| outliers | | time, ms | | rotation, ° | | translation, ° | | samples |
|--:|---|--:|--:|--:|--:|--:|--:|--:|
| | | median | mean | median | mean | median | mean | mean |
"""


def ours(*arguments):
    """Runs the example and returns what it prints."""
    command = ["cargo", "run", "--release", "--quiet", "--locked", "--manifest-path", HERE / "Cargo.toml", "--"]
    command += [str(argument) for argument in arguments]
    return subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE).stdout


def read(path):
    """The pairs of a file: cameras, truth, points."""
    pairs = []
    for line in path.read_text().splitlines():
        word, _, rest = line.partition(",")
        if word == "pair":
            pairs.append({"camera": [], "points": []})
        elif word in ("camera", "truth"):
            values = [float(value) for value in rest.split(",")]
            if word == "truth":
                pairs[-1]["truth"] = np.array(values)
            else:
                pairs[-1]["camera"].append({"model": "PINHOLE", "width": 0, "height": 0, "params": values})
        else:
            pairs[-1]["points"].append([float(value) for value in line.split(",")])
    for pair in pairs:
        points = np.array(pair["points"])
        pair["points"] = points[:, :2].copy(), points[:, 2:].copy()
    return pairs


def estimate_ours(path, threshold):
    """Times, samples and poses of our side, which stops at a pair without a pose."""
    lines = ours("--file", path, "--threshold", threshold).splitlines()
    rows = np.array([line.split(",")[1:] for line in lines], dtype=float)
    return rows[:, 0] * 1e-6, rows[:, 1], rows[:, 3:]


def estimate_theirs(pairs, threshold):
    """The same of the wheel."""
    times, samples, poses = [], [], []
    for pair in pairs:
        # The other options are its defaults, which are ours, too.
        options = {"max_epipolar_error": threshold}
        start = time.perf_counter()
        pose, information = poselib.estimate_relative_pose(*pair["points"], *pair["camera"], options, {})
        times.append((time.perf_counter() - start) * 1e3)
        samples.append(information["iterations"])
        poses.append(np.concatenate([pose.R.ravel(), pose.t / np.linalg.norm(pose.t)]))
    return np.array(times), np.array(samples), np.array(poses)


def angles(poses, truths):
    """Angles of rotations and of translations, in degrees."""
    found, truth = [rows[:, :9].reshape(-1, 3, 3) for rows in (poses, truths)]
    # The length of the difference of two rotations is 2 sqrt(2) sin(angle / 2): accurate near zero.
    chords = np.linalg.norm(found - truth, axis=(1, 2)) / 8**0.5
    turned, straight = poses[:, 9:], truths[:, 9:]
    sines = np.linalg.norm(np.cross(turned, straight), axis=1)
    translations = np.arctan2(sines, np.sum(turned * straight, axis=1))
    return np.degrees(2 * np.arcsin(np.minimum(chords, 1))), np.degrees(translations)


def row(outliers, name, times, samples, poses, truths):
    """A row of the table."""
    cells = [times, *angles(poses, truths)]
    digits = 2, 4, 4
    numbers = [f"{f(cell):.{n}f}" for cell, n in zip(cells, digits) for f in (np.median, np.mean)]
    return f"| {outliers:.0%} | {name} | {' | '.join(numbers)} | {np.mean(samples):.0f} |\n"


def compare(arguments, outliers):
    """The rows of both sides for a share of outliers."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "scenes.csv"
        ours("--write", path, "--scenes", arguments.scenes, "--seed", arguments.seed, "--outliers", outliers)
        pairs = read(path)
        truths = np.array([pair["truth"] for pair in pairs])
        rounds = [
            (estimate_ours(path, arguments.threshold), estimate_theirs(pairs, arguments.threshold))
            for _ in range(arguments.rounds)
        ]
    rows = ""
    for name, side in ("ours", 0), ("`poselib`", 1):
        times = np.min([each[side][0] for each in rounds], axis=0)
        rows += row(outliers, name, times, *rounds[0][side][1:], truths)
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scenes", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--threshold", type=float, default=3.0)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--update", action="store_true")
    arguments = parser.parse_args()
    title = (
        f"poselib {poselib.__version__}, {arguments.scenes} scenes a row, seed {arguments.seed}, "
        f"threshold {arguments.threshold:g} pixels:\n\n"
    )
    table = title + HEAD + "".join(compare(arguments, outliers) for outliers in OUTLIERS)
    print(table, end="")
    if arguments.update:
        readme = HERE / "README.md"
        before, rest = readme.read_text().split(MARKS[0])
        readme.write_text(before + MARKS[0] + "\n" + table + MARKS[1] + rest.split(MARKS[1])[1])


if __name__ == "__main__":
    main()
