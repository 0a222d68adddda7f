"""The examples for many machines, on two workers of this one."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

import eliminant

EXAMPLES = Path(__file__).parents[1] / "examples"


def run(example: str, *arguments: str) -> str:
    """What an example prints."""
    pytest.importorskip("distributed", reason="dask[distributed] is not installed")
    path = EXAMPLES / example
    if not path.exists():
        pytest.skip("the package is tested outside of its repository")
    process = subprocess.run(
        [sys.executable, str(path), *arguments], capture_output=True, text=True, timeout=300
    )
    assert process.returncode == 0, process.stderr
    return process.stdout


def test_two_workers_give_the_figures_of_one_process():
    arguments = ["trilateration", "--trials", "203", "--seed", "5", "--shards", "5", "--check"]
    printed = run("dask_stability.py", *arguments)
    assert "203 instances" in printed and "the figures of one process are the same" in printed


def test_two_workers_find_the_template_of_one_process(tmp_path):
    problem = eliminant.problem("two_conics")
    problem.template = None
    problem.save(tmp_path)
    options = ["--trials", "50", "--confirm", "1000", "--seed", "3"]
    printed = run("dask_search.py", str(tmp_path / "two_conics.rs"), "--shards", "3", "--check", *options)
    assert "one process finds the same template" in printed
    found = eliminant.Problem.from_file(tmp_path / "two_conics.rs")
    assert found.template_size.solutions == 4 and 'seed = "3"' in found.template
