"""A search on many machines: each task searches a share of the strategies, by the workers of Dask.

    python examples/dask_search.py problems/two_circles.rs --shards 4
    python examples/dask_search.py problems/two_circles.rs --scheduler tcp://host:8786 --seed 2

The template is written beside the problem. It is the one, byte by byte, that one process finds
within the same limit on columns (600 unless `--max-columns` is given), on any number of workers.
Other options are those of `python -m eliminant search`. `--check` compares with one process.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

from dask.distributed import Client, LocalCluster

COLUMNS = "600"
"""The limit on columns that a share of a search has by default."""


def eliminant(folder: str, *arguments: str) -> None:
    """The command, in a folder. It is a process of its own, so that a worker keeps its signals."""
    command = [sys.executable, "-m", "eliminant", *arguments]
    run = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if run.returncode:
        raise RuntimeError(run.stderr)


def shard(name: str, source: str, share: str, options: list[str]) -> str:
    """What a worker does: the text of the file by which a share hands over what it found."""
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, name).write_text(source, encoding="utf-8")
        eliminant(folder, "search", name, "--shard", share, "--out", "shard.json", *options)
        return Path(folder, "shard.json").read_text(encoding="utf-8")


def merged(name: str, source: str, shares: list[str]) -> str:
    """The template that all shares lead to."""
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, name).write_text(source, encoding="utf-8")
        files = [f"{at}.json" for at in range(len(shares))]
        for file, share in zip(files, shares):
            Path(folder, file).write_text(share, encoding="utf-8")
        eliminant(folder, "search", name, "--out", "template.toml", "--merge", *files)
        return Path(folder, "template.toml").read_text(encoding="utf-8")


def search(client: Client, path: Path, shards: int, options: list[str]) -> str:
    """The text of the template file of a problem file."""
    source = path.read_text(encoding="utf-8")
    tasks = [
        client.submit(shard, path.name, source, f"{at}/{shards}", options, pure=False)
        for at in range(1, shards + 1)
    ]
    return merged(path.name, source, client.gather(tasks))


def alone(path: Path, options: list[str]) -> str:
    """The template that one process finds."""
    limit = [] if "--max-columns" in options else ["--max-columns", COLUMNS]
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, path.name).write_bytes(path.read_bytes())
        eliminant(folder, "search", path.name, "--out", "template.toml", *limit, *options)
        return Path(folder, "template.toml").read_text(encoding="utf-8")


def main() -> None:
    """Runs on the workers of a scheduler, or on two of this machine."""
    parser = argparse.ArgumentParser(
        description="A search for a template, by Dask",
        epilog="Other options are those of `python -m eliminant search`.",
        allow_abbrev=False,
    )
    parser.add_argument("problem", type=Path, metavar="NAME.rs")
    parser.add_argument("--shards", type=int, default=4)
    parser.add_argument("--scheduler", help="address of a scheduler; by default two workers of this machine")
    parser.add_argument("--check", action="store_true", help="compare with one process")
    arguments, options = parser.parse_known_args()
    path = arguments.problem
    cluster = arguments.scheduler or LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None)
    with Client(cluster) as client:
        template = search(client, path, arguments.shards, options)
    written = path.with_suffix(".template.toml")
    written.write_text(template, encoding="utf-8")
    print(written)
    if arguments.check:
        assert template == alone(path, options), "the templates differ"
        print("one process finds the same template")


if __name__ == "__main__":
    main()
