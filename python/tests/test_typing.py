"""Types, and what is written by tools."""

from __future__ import annotations

import importlib.util
import inspect
import subprocess
import sys
from pathlib import Path

import pytest

import eliminant

PYTHON = Path(__file__).parents[1]


def test_mypy(tmp_path):
    pytest.importorskip("mypy", reason="mypy is not installed")
    command = [sys.executable, "-m", "mypy", "--strict", "-p", "eliminant"]
    # From elsewhere, so that the installed package is checked.
    run = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path)
    assert run.returncode == 0, run.stdout + run.stderr


def test_users_see_types(tmp_path):
    pytest.importorskip("mypy", reason="mypy is not installed")
    file = tmp_path / "user.py"
    file.write_text(
        "import numpy as np\n"
        "import eliminant\n"
        "found = eliminant.trilateration(np.zeros((3, 3)), [1, 2, 3])\n"
        "reveal_type(found)\n"
        "reveal_type(found.x)\n"
        "eliminant.trilateration(1)\n"
    )
    run = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", str(file)], capture_output=True, text=True
    )
    assert "eliminant._solutions.Solutions" in run.stdout and "float64" in run.stdout
    assert 'Missing positional argument "distances"' in run.stdout and "import-untyped" not in run.stdout


def test_the_stub_names_all_that_the_extension_module_has():
    stub = (Path(eliminant.__file__).parent / "_eliminant.pyi").read_text(encoding="utf-8")
    names = [name for name in dir(eliminant._eliminant) if not name.startswith("__") and name != "_eliminant"]
    missing = [
        name
        for name in names
        if f"def {name}(" not in stub and f"class {name}" not in stub and f"{name}:" not in stub
    ]
    assert not missing


def test_the_functions_of_the_catalogue_are_those_of_the_tool():
    tool = PYTHON / "tools" / "write_solvers.py"
    if not tool.exists():
        pytest.skip("the package is tested outside of its repository")
    spec = importlib.util.spec_from_file_location("write_solvers", tool)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    written = Path(inspect.getfile(eliminant.solvers)).read_text(encoding="utf-8")
    assert written == module.module(), "run tools/write_solvers.py --write"


def test_names_are_exported():
    assert all(hasattr(eliminant, name) for name in eliminant.__all__)
    assert set(eliminant.catalogue()) <= set(eliminant.__all__)


def test_the_import_is_quick():
    """Without the time of NumPy. Imports of the standard library count."""
    clock = "time.perf_counter()"
    program = f"import time, numpy; start = {clock}; import eliminant; print({clock} - start)"
    times = [
        float(subprocess.run([sys.executable, "-c", program], capture_output=True, text=True).stdout)
        for _ in range(5)
    ]
    assert min(times) < 0.05
