"""How far long work is: calls of a function, and bars by tqdm."""

from __future__ import annotations

import os
import struct
import subprocess
import sys
import textwrap

import pytest
import scenes

import eliminant

LONG = {
    "batch": (
        "data = np.random.default_rng(0).normal(size=(40, 7, 2, 3))",
        "eliminant.relpose_7pt_generalized_scale(data, data[::-1].copy())",
        "instances",
    ),
    "interpreted batch": (
        "problem, data = eliminant.problem('relpose_6pt_generalized'), np.random.rand(40, 6, 2, 3)",
        "problem.solve(data, data[::-1].copy())",
        "instances",
    ),
    "stability": ("problem = eliminant.problem('relpose_5pt')", "problem.stability(200)", "instances"),
    "search": ("problem = eliminant.problem('relpose_6pt_focal')", "problem.search(budget=2.0)", "strategies"),
}

PROGRAM = """
import sys
import numpy as np
import eliminant
from eliminant import _progress

_progress.PATIENCE = 0.0
if sys.argv[1] == "without":
    sys.modules["tqdm"] = sys.modules["tqdm.auto"] = None
{setup}
{call}
"""


def on_a_terminal(program: str, *arguments: str) -> str:
    """What a program writes to standard error, which is a terminal."""
    import fcntl
    import pty
    import termios

    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 100, 0, 0))
    run = subprocess.Popen([sys.executable, "-c", program, *arguments], stderr=theirs)
    os.close(theirs)
    written = b""
    while True:
        try:
            part = os.read(ours, 4096)
        except OSError:  # Linux says so that nobody has the terminal open.
            part = b""
        if not part:
            break
        written += part
    os.close(ours)
    text = written.decode("utf-8", "replace")
    assert run.wait(timeout=60) == 0, text
    return text


terminals = pytest.mark.skipif(os.name != "posix", reason="there are no terminals of POSIX")


@terminals
@pytest.mark.parametrize("setup, call, word", LONG.values(), ids=LONG.keys())
def test_long_work_has_a_bar(setup, call, word):
    pytest.importorskip("tqdm", reason="tqdm is not installed")
    assert word in on_a_terminal(textwrap.dedent(PROGRAM).format(setup=setup, call=call), "with")


@terminals
@pytest.mark.parametrize("setup, call, _", LONG.values(), ids=LONG.keys())
def test_without_tqdm_there_is_none(setup, call, _):
    assert on_a_terminal(textwrap.dedent(PROGRAM).format(setup=setup, call=call), "without") == ""


@terminals
def test_a_bar_is_not_wanted_or_not_seen():
    setup, call, _ = LONG["stability"]
    program = textwrap.dedent(PROGRAM).format(setup=setup, call=call)
    assert on_a_terminal(program.replace("200", "200, progress=False"), "with") == ""
    run = subprocess.run([sys.executable, "-c", program, "with"], capture_output=True, text=True, check=True)
    assert run.stderr == ""


def heard_by(call) -> list:
    """The arguments of all calls of `progress`."""
    heard: list = []
    call(lambda *arguments: heard.append(arguments))
    return heard


def test_a_callable_hears_how_much_is_done(rng):
    views = scenes.two_views(rng, 5000, 5)
    problem = eliminant.problem("trilateration")
    data = rng.normal(size=(3000, 3, 3)), rng.normal(size=(3000, 3))
    calls = {
        5000: lambda progress: eliminant.relpose_5pt_rays(
            views["first"], views["second"], progress=progress
        ),
        10: lambda progress: eliminant.trilateration(data[0][:10], data[1][:10], progress=progress),
        3000: lambda progress: problem.solve(*data, progress=progress),
        500: lambda progress: problem.stability(500, progress=progress),
    }
    for total, call in calls.items():
        heard = heard_by(call)
        assert heard[-1] == (total, total) and {of for _, of in heard} == {total}
        done = [done for done, _ in heard]
        assert done == sorted(set(done)), "each number once, increasing"


def test_a_message_is_heard_once():
    problem = eliminant.problem("relpose_6pt_focal")
    heard = heard_by(lambda progress: problem.search(budget=3.0, progress=progress))
    messages = [message for message, _ in heard]
    assert all(a != b for a, b in zip(messages, messages[1:]))


def test_what_is_no_callable_is_refused():
    problem = eliminant.problem("trilateration")
    for wrong in (True, 1, "bar"):
        with pytest.raises(TypeError, match="progress"):
            problem.stability(1, progress=wrong)


def test_an_exception_of_progress_ends_a_batch(rng):
    def progress(done, total):
        raise RuntimeError("enough")

    data = rng.normal(size=(40, 7, 2, 3))
    with pytest.raises(RuntimeError, match="enough"):
        eliminant.relpose_7pt_generalized_scale(data, data[::-1].copy(), progress=progress)
