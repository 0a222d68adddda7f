"""Problems of your own: from equations to a solver."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path
from typing import Any, List, NamedTuple, Optional, Tuple, Union

from . import _eliminant
from ._arrays import Shape, data, whole
from ._progress import Progress, counted, told
from ._solutions import Named, Solutions, arranged
from ._stability import Stability

ProblemError = _eliminant.ProblemError


class Check(NamedTuple):
    """The number of solutions for general data."""

    solutions: int
    """Complex solutions, with their multiplicity."""
    different: int
    """Different ones."""
    at_origin: int
    """How often all unknowns 0 counts among them."""


class Template(NamedTuple):
    """What a template is like."""

    rows: int
    columns: int
    basis: int
    """The size of the eigenvalue problem."""
    solutions: int
    action: str
    """The action monomial."""
    operations: int
    """Floating-point operations of one solve."""
    is_cut: bool = False
    """Whether the budget ended the search before its end."""


class Problem:
    """A polynomial problem in the language of problem files, with or without a template.

    `template` is the text of a template file. Messages name `path`. A problem that is wrong raises
    `ProblemError`, whose text is what the command `eliminant` prints.
    """

    def __init__(self, source: str, *, template: Optional[str] = None, path: str = "problem.rs") -> None:
        if not isinstance(source, str):
            raise TypeError(f"expected the text of a problem, got {type(source).__name__}")
        self.source = source
        self.path = path
        self._native = _eliminant.Problem(path, source)
        self._planned: Optional[_eliminant.Planned] = None
        self._template: Optional[str] = None
        self.template = template

    @classmethod
    def from_file(cls, path: Union[str, "os.PathLike[str]"]) -> "Problem":
        """Reads a problem file, and the template file NAME.template.toml beside it if there is one."""
        file = Path(path)
        beside = file.with_suffix(".template.toml")
        template = beside.read_text(encoding="utf-8") if beside.exists() else None
        return cls(file.read_text(encoding="utf-8"), template=template, path=str(file))

    def save(self, folder: Union[str, "os.PathLike[str]"]) -> List[Path]:
        """Writes the files NAME.rs and, with a template, NAME.template.toml. Returns their paths."""
        written = [Path(folder) / f"{self.name}.rs"]
        written[0].write_text(self.source, encoding="utf-8")
        if self._template is not None:
            written.append(Path(folder) / f"{self.name}.template.toml")
            written[1].write_text(self._template, encoding="utf-8")
        return written

    @property
    def name(self) -> str:
        """The name of the problem function."""
        return self._native.name

    @property
    def docs(self) -> str:
        """The doc comment."""
        return self._native.docs

    @property
    def data(self) -> Named:
        """Name and shape of each parameter. The last dimension of complex ones is 2."""
        return _named(self._native.data)

    @property
    def fields(self) -> Named:
        """Name and shape of each array of a solution. The last dimension of complex ones is 2."""
        return _named(self._native.fields)

    @property
    def unknowns(self) -> Tuple[str, ...]:
        """The names of the scalars of a solution."""
        return tuple(self._native.unknowns)

    @property
    def complex_numbers(self) -> Tuple[str, ...]:
        """The parameters, unknowns and results that are complex."""
        return tuple(self._native.complex_numbers)

    @property
    def results(self) -> Named:
        """Name and shape of what the problem returns beside its unknowns."""
        return _named(self._native.results)

    @property
    def template(self) -> Optional[str]:
        """The text of the template file. It is verified when it is set."""
        return self._template

    @template.setter
    def template(self, text: Optional[str]) -> None:
        self._planned = None if text is None else self._native.planned(text)
        self._template = text

    @property
    def template_size(self) -> Template:
        """What the template is like."""
        planned = self._solver()
        rows, columns, basis = planned.template_size
        return Template(rows, columns, basis, planned.solutions, planned.action, planned.operations)

    def check(self) -> Check:
        """Counts the solutions for general data. Raises `ProblemError` unless they are finitely many."""
        return Check(*self._native.check())

    def search(
        self,
        budget: Optional[float] = None,
        progress: Progress = None,
        *,
        prefer: str = "speed",
        seed: int = 1,
        max_columns: Optional[int] = None,
        max_basis: Optional[int] = None,
        shuffles: int = 12,
        trials: int = 300,
        confirm: int = 10_000,
        trace: bool = False,
    ) -> Template:
        """Searches a template, which the problem has afterwards.

        `budget` ends the search after about so many seconds with the best template found so far.
        `progress` is called with a message and the seconds since the start; by default they are
        shown where tqdm is installed and standard error is a terminal or this is a notebook, and
        with False they are not. The other options are those of the command `eliminant search`.
        Ctrl-C ends the search, and leaves the problem as it was.
        """
        settings = {
            "prefer": prefer,
            "seed": whole("seed", seed),
            "max_columns": None if max_columns is None else whole("max_columns", max_columns),
            "max_basis": None if max_basis is None else whole("max_basis", max_basis),
            "shuffles": whole("shuffles", shuffles),
            "trials": whole("trials", trials),
            "confirm": whole("confirm", confirm),
            "trace": bool(trace),
        }
        with told(progress) as report:
            self.template, is_cut = self._native.search(settings, budget, report)
        return self.template_size._replace(is_cut=is_cut)

    def solve(self, *values: Any, progress: Progress = None) -> Solutions:
        """The real solutions of one instance, or of a batch, by the interpreted plan.

        Operations and their order are those of the emitted solver, which is many times as fast.
        Complex parameters are complex arrays, or real ones whose last dimension holds real and
        imaginary parts. Complex unknowns and results are complex arrays. `progress` is that of
        `stability`, for a batch.
        """
        planned = self._solver()
        arrays, count = data(self.data, (), values, self.complex_numbers)
        if count < 0:
            solved = planned.solve_one(arrays)
        else:
            with counted(progress, self.name, " instances") as report:
                solved = planned.solve_batch(arrays, count, report)
        solutions = arranged(self.fields, self.results, planned.solutions, solved, count >= 0, self.unknowns)
        return solutions.with_complex(self.complex_numbers)

    def stability(
        self,
        trials: int = 1000,
        seed: int = 1,
        *,
        first: int = 0,
        family: str = "random",
        progress: Progress = None,
    ) -> Stability:
        """Solves the instances `first` to `first + trials`, and judges what is found.

        `family` is "random", or "scene" for what the function of the problem with the attribute
        `#[scene]` makes of random numbers: then `known_missed` tells where the solution that it
        says was not found.

        Instance k depends on the seed and k only, so that runs on parts of the instances, joined by
        `Stability.join`, are one run. True solutions are computed to 71 digits. `progress` is
        called with the number of instances that are done and of all; by default there is a bar
        where tqdm is installed and standard error is a terminal or this is a notebook, and with
        False there is none.
        """
        first, trials, seed = whole("first", first), whole("trials", trials), whole("seed", seed)
        planned = self._solver()
        if family not in ("random", "scene"):
            raise ValueError(f'`family` is "random" or "scene", not {family!r}')
        if family == "scene" and not planned.has_scene:
            raise ValueError(f"the problem `{self.name}` states no scene: add a function with `#[scene]`")
        with counted(progress, self.name, " instances") as report:
            figures = planned.stability(first, trials, (seed, family == "scene"), report)
        return Stability.of((self.name, family, seed), first, figures)

    def emit(self) -> str:
        """The Rust source of the solver."""
        return self._solver().emit()

    def _solver(self) -> _eliminant.Planned:
        if self._planned is None:
            raise ProblemError(
                f"error: the problem `{self.name}` has no template\nhelp: search one: `problem.search()`"
            )
        return self._planned

    def _repr_svg_(self) -> Optional[str]:
        """A picture of the template, for notebooks."""
        if self._template is None:
            return None
        with tempfile.TemporaryDirectory() as folder:
            problem, picture = self.save(folder)[0], Path(folder) / "picture.svg"
            status, _, errors = _eliminant.run_command(
                ["eliminant", "inspect", str(problem), "--svg", str(picture)]
            )
            if status != 0:
                raise ProblemError(errors.strip())
            return picture.read_text(encoding="utf-8")

    def __repr__(self) -> str:
        unknowns = ", ".join(self.unknowns)
        if self._planned is None:
            return f"<Problem {self.name}({unknowns}), no template>"
        size = self.template_size
        return f"<Problem {self.name}({unknowns}): {size.solutions} solutions, template {size.rows} x {size.columns}>"

    def __reduce__(self) -> Tuple[Any, ...]:
        return _restored, (self.source, self._template, self.path)


def _restored(source: str, template: Optional[str], path: str) -> Problem:
    return Problem(source, template=template, path=path)


def _named(shapes: List[Tuple[str, List[int]]]) -> Named:
    def shape(of: List[int]) -> Shape:
        return tuple(of)

    return tuple((name, shape(of)) for name, of in shapes)


def catalogue() -> Tuple[str, ...]:
    """The names of the problems of the catalogue."""
    return tuple(description[0] for description in _eliminant.solvers())


def problem(name: str) -> Problem:
    """A problem of the catalogue with its committed template."""
    files = _eliminant.files(name)
    if files is None:
        raise ValueError(f"there is no problem `{name}` in the catalogue: `eliminant.catalogue()` lists them")
    return Problem(files[0], template=files[1], path=f"{name}.rs")
