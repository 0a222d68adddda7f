"""Cores, processes and signals."""

from __future__ import annotations

import multiprocessing
import os
import pickle
import signal
import subprocess
import sys
import textwrap
import threading

import numpy as np
import pytest
import scenes

import eliminant
from eliminant import cylinders

INTERRUPTED = """
import os, signal, threading, time
import numpy as np
import eliminant

{setup}
threading.Timer(1.0, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
start = time.monotonic()
try:
    {call}
except KeyboardInterrupt:
    print("interrupted", time.monotonic() - start)
"""

# 4096 solutions: the Gröbner basis takes minutes.
QUADRICS = """
fn quadrics(a: [[[f64; 12]; 12]; 12], b: [f64; 12]) -> (x: [f64; 12]) {
    for k in 0..12 {
        dot(x, a[k] * x) == b[k];
    }
}
"""

SLOW = {
    "batch": (
        "data = np.random.default_rng(0).normal(size=(5000, 7, 2, 3))",
        "eliminant.relpose_7pt_generalized_scale(data, data[::-1].copy())",
    ),
    "search": ("problem = eliminant.problem('relpose_7pt_focal_radial')", "problem.search()"),
    "interpreted batch": (
        "problem, data = eliminant.problem('relpose_6pt_generalized'), np.random.rand(5000, 6, 2, 3)",
        "problem.solve(data, data[::-1].copy())",
    ),
    "check": (f"problem = eliminant.Problem({QUADRICS!r})", "problem.check()"),
    "stability": ("problem = eliminant.problem('relpose_6pt_generalized')", "problem.stability(5000)"),
}


posix = pytest.mark.skipif(not hasattr(os, "fork"), reason="signals are sent as POSIX has them")


def listen():
    """Ctrl-C ends a child even where this process was told to ignore it, such as in the background."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


@posix
@pytest.mark.parametrize("setup, call", SLOW.values(), ids=SLOW.keys())
def test_ctrl_c_ends_what_is_slow(setup, call):
    program = textwrap.dedent(INTERRUPTED).format(setup=setup, call=call)
    command = [sys.executable, "-c", program]
    run = subprocess.run(command, capture_output=True, text=True, timeout=300, preexec_fn=listen)
    words = run.stdout.split()
    assert words[:1] == ["interrupted"], run.stderr
    assert float(words[1]) < 60


@posix
def test_ctrl_c_ends_the_command(tmp_path):
    (tmp_path / "quadrics.rs").write_text(QUADRICS)
    command = [sys.executable, "-m", "eliminant", "check", "quadrics.rs"]
    run = subprocess.Popen(
        command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, preexec_fn=listen
    )
    try:
        # The Gröbner basis has begun by then.
        with pytest.raises(subprocess.TimeoutExpired):
            run.communicate(timeout=3)
        run.send_signal(signal.SIGINT)
        _, errors = run.communicate(timeout=30)
    finally:
        run.kill()
    assert run.returncode == -signal.SIGINT and b"Traceback" not in errors


def essentials(views):
    """Solutions of a batch."""
    return eliminant.relpose_5pt_rays(views["first"], views["second"]).essential


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork")
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_a_forked_child_has_threads_of_its_own(rng):
    views = scenes.two_views(rng, 1000, 5)
    expected = essentials(views)
    with multiprocessing.get_context("fork").Pool(1) as pool:
        np.testing.assert_array_equal(pool.apply_async(essentials, (views,)).get(timeout=60), expected)


def test_exceptions_travel_between_processes():
    for kind in (eliminant.SolveError, eliminant.ProblemError, cylinders.CylinderError):
        again = pickle.loads(pickle.dumps(kind("text")))
        assert type(again) is kind and str(again) == "text"


def test_the_interpreter_runs_beside_a_batch(rng):
    """The lock is released: another thread counts meanwhile."""
    views = scenes.two_views(rng, 50_000, 5)
    counted, is_over = [0], threading.Event()

    def count():
        while not is_over.is_set():
            counted[0] += 1

    thread = threading.Thread(target=count)
    before = counted[0]
    thread.start()
    essentials(views)
    is_over.set()
    thread.join()
    assert counted[0] > before + 100


def test_many_threads_call(rng):
    views = scenes.two_views(rng, 600, 5)
    expected = essentials(views)
    results = [None] * 8

    def work(at):
        results[at] = essentials(views)

    threads = [threading.Thread(target=work, args=(at,)) for at in range(len(results))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for result in results:
        np.testing.assert_array_equal(result, expected)


@pytest.mark.parametrize("threads", ["1", "3"])
def test_results_do_not_depend_on_the_number_of_threads(rng, threads, tmp_path):
    views = scenes.two_views(rng, 700, 5)
    np.savez(tmp_path / "views.npz", first=views["first"], second=views["second"])
    program = (
        "import sys, numpy as np, eliminant\n"
        "views = np.load(sys.argv[1] + '/views.npz')\n"
        "found = eliminant.relpose_5pt_rays(views['first'], views['second'])\n"
        "np.save(sys.argv[1] + '/found.npy', found.values)\n"
    )
    environment = {**os.environ, "RAYON_NUM_THREADS": threads}
    subprocess.run([sys.executable, "-c", program, str(tmp_path)], check=True, env=environment)
    expected = eliminant.relpose_5pt_rays(views["first"], views["second"]).values
    np.testing.assert_array_equal(np.load(tmp_path / "found.npy"), expected)
