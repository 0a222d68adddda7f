"""Writes `eliminant/solvers.py`: a function for each problem of the catalogue.

python tools/write_solvers.py          prints it
python tools/write_solvers.py --write  writes it
"""

from __future__ import annotations

import re
import sys
import textwrap
from pathlib import Path

from eliminant._solve import HOMOGENEOUS, SOLVERS, Solver

TARGET = Path(__file__).parents[1] / "eliminant" / "solvers.py"

HEAD = '''"""The solvers of the catalogue.

Each takes the data of one instance, or arrays of the data of n instances. Data of one instance in
a batch hold for all. Batches are solved on all cores, without the lock of the interpreter.

Written by `tools/write_solvers.py` from the problems in `templates/`.
"""

from __future__ import annotations

import numpy.typing as npt

from ._solutions import Solutions
from ._solve import solve as _solve
'''


def shape_text(shape: tuple[int, ...]) -> str:
    """The shape as Python writes it."""
    return str(tuple(shape))


def docstring(solver: Solver) -> str:
    """What the problem says, then shapes."""
    # Brackets are escaped for the documentation of Rust.
    lines = [re.sub(r"\\\\([\[\]])", r"\1", line) for line in solver.docs.splitlines()]
    lines += ["", "Data, for one instance, or with n in front for a batch:", ""]
    for name, shape in solver.data:
        note = ", or image points, one coordinate less" if name in HOMOGENEOUS.get(solver.name, ()) else ""
        lines.append(f"- `{name}`: {shape_text(shape)}{note}")
    if not solver.data:
        lines[-2:] = ["There are no data."]
    lines += ["", f"Solutions, of which there are at most {solver.most}:", ""]
    lines += [f"- `{name}`: {shape_text(shape)}" for name, shape in solver.fields]
    if solver.results:
        lines += ["", "Results of each solution:", ""]
        lines += [f"- `{name}`: {shape_text(shape)}" for name, shape in solver.results]
    return textwrap.indent("\n".join(lines), "    ")


def function(solver: Solver) -> str:
    """The function of a solver."""
    names = [name for name, _ in solver.data]
    parameters = ", ".join(f"{name}: npt.ArrayLike" for name in names)
    raw = "r" if "\\" in docstring(solver) else ""
    opening = f"def {solver.name}({parameters}) -> Solutions:"
    if len(opening) > 100:
        parameters = "".join(f"    {name}: npt.ArrayLike,\n" for name in names)
        opening = f"def {solver.name}(\n{parameters}) -> Solutions:"
    call = ", ".join([f'"{solver.name}"', *names])
    return f'{opening}\n    {raw}"""{docstring(solver).strip()}\n    """\n    return _solve({call})\n'


def module() -> str:
    """The text of the module."""
    names = "".join(f'    "{name}",\n' for name in SOLVERS)
    functions = "\n\n".join(function(solver) for solver in SOLVERS.values())
    return f"{HEAD}\n__all__ = [\n{names}]\n\n\n{functions}"


if __name__ == "__main__":
    if sys.argv[1:] == ["--write"]:
        TARGET.write_text(module(), encoding="utf-8")
    else:
        sys.stdout.write(module())
