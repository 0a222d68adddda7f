"""Writes `eliminant/solvers.py`: a function for each problem of the catalogue.

python tools/write_solvers.py          prints it
python tools/write_solvers.py --write  writes it
"""

from __future__ import annotations

import re
import sys
import textwrap
from pathlib import Path

from eliminant._solve import HOMOGENEOUS, MEANS, SOLVERS, Mean, Solver

TARGET = Path(__file__).parents[1] / "eliminant" / "solvers.py"

HEAD = '''"""The solvers of the catalogue.

Each takes the data of one instance, or arrays of the data of n instances. Data of one instance in
a batch hold for all. Batches are solved on all cores, without the lock of the interpreter.
`progress` is called with the number of instances that are done and of all; by default a long batch
has a bar where tqdm is installed and standard error is a terminal or this is a notebook, and with
False it has none. `results` has the names of the results to return, all by default; each
array that is left out saves the time to fill it.

Written by `tools/write_solvers.py` from the problems in `templates/`.
"""

from __future__ import annotations

from typing import Iterable, Optional

import numpy.typing as npt

from ._arrays import Array
from ._progress import Progress
from ._solutions import Solutions
from ._solve import mean as _mean
from ._solve import solve as _solve
'''


def shape_text(shape: tuple[int, ...]) -> str:
    """The shape as Python writes it."""
    return str(tuple(shape))


def lines_of(docs: str) -> list[str]:
    """The lines of a documentation. Brackets are escaped for that of Rust."""
    return [re.sub(r"\\\\([\[\]])", r"\1", line) for line in docs.splitlines()]


def docstring(solver: Solver) -> str:
    """What the problem says, then shapes."""
    lines = lines_of(solver.docs)
    if f"{solver.name}_rays" in SOLVERS:
        lines += ["", f"Of rays or image points it is `{solver.name}_rays`."]
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


def docstring_of_mean(name: str, mean: Mean) -> str:
    """What the problem says of a measurement, then shapes."""
    lines = lines_of(mean.docs)
    lines += ["", "Data, for one measurement, or with n in front for a mean over n:", ""]
    for parameter, shape in mean.data:
        note = ", or image points, one coordinate less" if parameter in HOMOGENEOUS.get(name, ()) else ""
        lines.append(f"- `{parameter}`: {shape_text(shape)}{note}")
    lines += ["", f"The mean has the shape {shape_text(mean.shape)}."]
    return textwrap.indent("\n".join(lines), "    ")


def function(name: str, names: list[str], docs: str, returned: str, options: dict[str, str]) -> str:
    """The function of this name with these parameters, which calls that of what is returned."""
    call = {"Solutions": "_solve", "Array": "_mean"}[returned]
    typed = [f"{parameter}: npt.ArrayLike" for parameter in names]
    typed += ["*"] * bool(options) + [f"{option}: {kind} = None" for option, kind in options.items()]
    arguments = [f'"{name}"', *names, *(f"{option}={option}" for option in options)]
    parameters = ", ".join(typed)
    raw = "r" if "\\" in docs else ""
    opening = f"def {name}({parameters}) -> {returned}:"
    if len(opening) > 100:
        parameters = "".join(f"    {parameter},\n" for parameter in typed)
        opening = f"def {name}(\n{parameters}) -> {returned}:"
    return f'{opening}\n    {raw}"""{docs.strip()}\n    """\n    return {call}({", ".join(arguments)})\n'


def module() -> str:
    """The text of the module."""
    functions = {}
    for name, solver in SOLVERS.items():
        options = {"results": "Optional[Iterable[str]]"} if solver.results else {}
        options["progress"] = "Progress"
        functions[name] = function(name, [at for at, _ in solver.data], docstring(solver), "Solutions", options)
    for name, mean in MEANS.items():
        functions[name] = function(name, [at for at, _ in mean.data], docstring_of_mean(name, mean), "Array", {})
    names = "".join(f'    "{name}",\n' for name in sorted(functions))
    text = "\n\n".join(functions[name] for name in sorted(functions))
    return f"{HEAD}\n__all__ = [\n{names}]\n\n\n{text}"


if __name__ == "__main__":
    if sys.argv[1:] == ["--write"]:
        TARGET.write_text(module(), encoding="utf-8")
    else:
        sys.stdout.write(module())
