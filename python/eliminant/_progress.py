"""How far long work is: a bar by tqdm where it is installed, or calls of a function."""

from __future__ import annotations

import importlib
import sys
import time
from contextlib import contextmanager
from typing import Any, Callable, Iterator, Optional, Union

Progress = Optional[Union[bool, Callable[..., Any]]]
"""None is a bar where tqdm is installed and somebody looks; False is none; or a callable."""

Report = Optional[Callable[..., None]]
"""What the extension module calls many times a second."""

PATIENCE = 0.5
"""Seconds that work takes before there is a bar."""
LEAST = 0.2
"""Seconds from one look of a bar with a message to the next."""


@contextmanager
def counted(progress: Progress, title: str, unit: str) -> Iterator[Report]:
    """A report of (done, total). A callable gets these where they changed."""
    bar = _Bar(title, unit)
    try:
        yield _chosen(progress, bar.count, lambda done, total: (done, total))
    finally:
        bar.close()


@contextmanager
def told(progress: Progress) -> Iterator[Report]:
    """A report of (message, seconds). A callable gets these where the message changed."""
    bar = _Bar("", "")
    try:
        yield _chosen(progress, bar.say, lambda message, _: message)
    finally:
        bar.close()


def _chosen(progress: Progress, bar: Callable[..., None], key: Callable[..., Any]) -> Report:
    if progress is None:
        return bar
    if progress is False:
        return None
    if not callable(progress):
        raise TypeError(f"`progress` is a {type(progress).__name__}: expected a callable, None or False")
    last: Any = None

    def where_it_changed(*arguments: Any) -> None:
        nonlocal last
        if key(*arguments) != last:
            last = key(*arguments)
            progress(*arguments)

    return where_it_changed


class _Bar:
    """A bar that opens once work has taken a while, if it can."""

    def __init__(self, title: str, unit: str) -> None:
        self._look = (title, unit)
        self._start = self._last = time.monotonic()
        self._bar: Any = None
        self._is_off = False

    def count(self, done: int, total: int) -> None:
        """Shows how many are done."""
        if self._opened("{l_bar}{bar}{r_bar}", total):
            self._bar.total = total
            self._bar.update(done - self._bar.n)

    def say(self, message: str, _: float) -> None:
        """Shows a message and the time."""
        now = time.monotonic()
        if self._opened("{desc} [{elapsed}]", None) and now - self._last >= LEAST:
            self._last = now
            self._bar.set_description_str(message)

    def close(self) -> None:
        """Takes the bar away."""
        if self._bar is not None:
            self._bar.close()

    def _opened(self, form: str, total: Optional[int]) -> bool:
        seconds = time.monotonic() - self._start
        if self._bar is None and not self._is_off and seconds >= PATIENCE:
            title, unit = self._look
            self._bar = _open(desc=title, unit=unit, total=total, bar_format=form)
            self._is_off = self._bar is None
            if hasattr(self._bar, "start_t"):
                self._bar.start_t -= seconds
        return self._bar is not None


def _open(**look: Any) -> Any:
    """A bar of tqdm; None where there is none."""
    if not _somebody_looks():
        return None
    try:
        tqdm = importlib.import_module("tqdm.auto").tqdm
    except ImportError:
        return None
    return tqdm(**look, leave=False, dynamic_ncols=True)


def _somebody_looks() -> bool:
    """Whether standard error is a terminal, or this is a notebook."""
    is_terminal = getattr(sys.stderr, "isatty", None)
    if is_terminal is not None and is_terminal():
        return True
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    return hasattr(shell, "kernel")
