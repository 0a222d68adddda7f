"""The example for many machines, on two workers of this one."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLE = Path(__file__).parents[1] / "examples" / "dask_stability.py"


def test_two_workers_give_the_figures_of_one_process():
    pytest.importorskip("distributed", reason="dask[distributed] is not installed")
    if not EXAMPLE.exists():
        pytest.skip("the package is tested outside of its repository")
    arguments = ["trilateration", "--trials", "203", "--seed", "5", "--shards", "5", "--check"]
    run = subprocess.run(
        [sys.executable, str(EXAMPLE), *arguments], capture_output=True, text=True, timeout=300
    )
    assert run.returncode == 0, run.stderr
    assert "203 instances" in run.stdout and "the figures of one process are the same" in run.stdout
