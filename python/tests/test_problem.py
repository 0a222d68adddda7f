"""The generator from Python."""

from __future__ import annotations

import pickle
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import eliminant

GPS = """
/// Position and clock offset of a receiver.
fn gps(satellites: [[f64; 3]; 4], pseudoranges: [f64; 4]) -> (x, y, z, offset) {
    let position = [x, y, z];
    let first = sphere(position, offset, satellites[0], pseudoranges[0]);
    first == 0;
    for i in 1..4 {
        sphere(position, offset, satellites[i], pseudoranges[i]) - first == 0;
    }
}

fn sphere(position: [f64; 3], offset: f64, satellite: [f64; 3], pseudorange: f64) -> f64 {
    let sight = satellite - position;
    dot(sight, sight) - (pseudorange - offset).pow(2)
}
"""


@pytest.fixture(scope="module")
def gps() -> eliminant.Problem:
    problem = eliminant.Problem(GPS)
    problem.search()
    return problem


def test_what_a_problem_states():
    problem = eliminant.Problem(GPS)
    assert problem.name == "gps" and problem.docs == "Position and clock offset of a receiver."
    assert problem.data == (("satellites", (4, 3)), ("pseudoranges", (4,)))
    assert problem.unknowns == ("x", "y", "z", "offset") and problem.results == ()
    assert problem.template is None and "no template" in repr(problem)
    assert problem._repr_svg_() is None
    assert problem.check() == eliminant.Check(solutions=2, different=2, at_origin=0)


def test_search_and_solve(gps, rng):
    size = gps.template_size
    assert size.solutions == 2 and size.rows < size.columns and not size.is_cut
    satellites, position, offset = (
        4 * rng.normal(size=(30, 4, 3)),
        rng.normal(size=(30, 3)),
        rng.normal(size=30),
    )
    ranges = np.linalg.norm(satellites - position[:, None], axis=-1) + offset[:, None]
    batch = gps.solve(satellites, ranges)
    assert batch.values.shape == (30, 2, 4) and (batch.counts == 2).all()
    truth = np.concatenate([position, offset[:, None]], axis=1)
    assert np.abs(batch.values - truth[:, None]).max(axis=-1).min(axis=-1).max() < 1e-6
    one = gps.solve(satellites[4], ranges[4])
    np.testing.assert_array_equal(one.values, batch.of(4).values)
    np.testing.assert_array_equal(one.offset, batch.offset[4])


def test_progress_and_budget():
    heard = []
    problem = eliminant.problem("relpose_6pt_focal")
    problem.template = None
    size = problem.search(budget=3.0, progress=lambda message, seconds: heard.append((message, seconds)))
    assert size.solutions == 15 and problem.template is not None
    assert heard and all(isinstance(message, str) and seconds >= 0 for message, seconds in heard)


def test_an_exception_of_progress_ends_the_search():
    def progress(message, seconds):
        raise RuntimeError("enough")

    problem = eliminant.problem("relpose_6pt_radial")
    before = problem.template
    with pytest.raises(RuntimeError, match="enough"):
        problem.search(progress=progress)
    assert problem.template == before


@pytest.mark.parametrize(
    "options, error",
    [
        ({"budget": -1.0}, ValueError),
        ({"budget": float("nan")}, ValueError),
        ({"prefer": "beauty"}, ValueError),
        ({"max_columns": 1}, ValueError),
        ({"trials": 0}, ValueError),
        ({"trace": True, "max_columns": 100}, ValueError),
        ({"seed": -1}, ValueError),
        ({"shuffles": 2**64}, ValueError),
        ({"confirm": 1.5}, TypeError),
        ({"budget": "long"}, TypeError),
    ],
)
def test_bad_options_of_a_search(options, error):
    with pytest.raises(error):
        eliminant.Problem(GPS).search(**options)


def test_mistakes_are_shown_as_in_a_terminal():
    with pytest.raises(eliminant.ProblemError) as caught:
        eliminant.Problem("fn p(a: f64) -> (x) {\n    a * x^2 == 1;\n}\n", path="p.rs")
    assert str(caught.value).splitlines() == [
        "error: `^` is not a power",
        " --> p.rs:2:10",
        "  |",
        "2 |     a * x^2 == 1;",
        "  |          ^ powers are written `.pow(n)`",
        "  |",
        "  = help: write `x.pow(2)`",
    ]
    problem = eliminant.Problem("fn p(a: f64) -> (x, y) { a * x * y == 1; x * x * y == x / a; }")
    for call in (problem.check, problem.search):
        with pytest.raises(eliminant.ProblemError, match="infinitely many solutions"):
            call()


@pytest.mark.parametrize("text", ["", "fn", "\x00", "fn p() -> (x) { x == 0; } fn p", "\u00e4" * 1000])
def test_no_problems(text):
    with pytest.raises(eliminant.ProblemError):
        eliminant.Problem(text)


@pytest.mark.parametrize("value", [None, 3, b"fn"])
def test_no_texts(value):
    with pytest.raises(TypeError):
        eliminant.Problem(value)


def test_without_a_template_nothing_is_solved():
    problem = eliminant.Problem(GPS)
    for call in (problem.emit, problem.stability, lambda: problem.solve(np.zeros((4, 3)), np.zeros(4))):
        with pytest.raises(eliminant.ProblemError, match="has no template\nhelp: search one"):
            call()


def test_templates_are_verified(gps):
    other = eliminant.problem("trilateration")
    with pytest.raises(eliminant.ProblemError, match="belongs to `trilateration`"):
        eliminant.Problem(GPS, template=other.template)
    with pytest.raises(eliminant.ProblemError):
        eliminant.Problem(GPS, template="nonsense")
    with pytest.raises(eliminant.ProblemError, match="3 solutions"):
        eliminant.Problem(GPS, template=gps.template.replace("solutions = 2", "solutions = 3"))


def test_emit_is_rust(gps):
    source = gps.emit()
    assert (
        "pub mod gps" in source
        and "pub fn solve(" in source
        and "pub const MAX_SOLUTIONS: usize = 2;" in source
    )


def test_picture(gps):
    picture = gps._repr_svg_()
    assert picture.startswith("<svg") and "gps" in picture


def test_files(gps, tmp_path):
    gps.save(tmp_path)
    again = eliminant.Problem.from_file(tmp_path / "gps.rs")
    assert again.template == gps.template and again.path == str(tmp_path / "gps.rs")
    (tmp_path / "gps.template.toml").unlink()
    assert eliminant.Problem.from_file(tmp_path / "gps.rs").template is None
    with pytest.raises(FileNotFoundError):
        eliminant.Problem.from_file(tmp_path / "nothing.rs")


def test_pickles(gps, rng):
    again = pickle.loads(pickle.dumps(gps))
    data = rng.normal(size=(4, 3)), rng.normal(size=4)
    np.testing.assert_array_equal(again.solve(*data).values, gps.solve(*data).values)


def test_stability_of_parts_is_that_of_the_whole():
    problem = eliminant.problem("relpose_5pt")
    whole = problem.stability(60, seed=3)
    assert len(whole) == 60 and whole.failed == 0 and (whole.complex == 10).all()
    assert (whole.residual < 1e-8).all() and (whole.forward_error < 1e-3).all()
    parts = [problem.stability(25, seed=3, first=35), problem.stability(35, seed=3)]
    joined = eliminant.Stability.join(parts)
    for name in whole.__dataclass_fields__:
        np.testing.assert_array_equal(getattr(joined, name), getattr(whole, name))
    assert not np.array_equal(problem.stability(60, seed=4).residual, whole.residual)
    assert len(problem.stability(0)) == 0
    with pytest.raises(ValueError):
        eliminant.Stability.join([whole, problem.stability(1, seed=4)])


def test_the_solution_of_a_scene_is_found():
    problem = eliminant.problem("pose_3pt")
    whole = problem.stability(40, seed=3, family="scene")
    assert whole.known_missed.sum() == 0 and whole.incomplete == 0 and (whole.real >= 1).all()
    parts = [problem.stability(20, seed=3, first=at, family="scene") for at in (0, 20)]
    np.testing.assert_array_equal(eliminant.Stability.join(parts).residual, whole.residual)
    random = problem.stability(40, seed=3)
    assert (random.real == 0).any() and random.known_missed.sum() == 0
    with pytest.raises(ValueError, match="families"):
        eliminant.Stability.join([whole, random])
    with pytest.raises(ValueError, match="families"):
        eliminant.StabilitySummary.join([whole.summary(), random.summary()])
    with pytest.raises(ValueError, match="states no scene"):
        eliminant.problem("relpose_5pt").stability(3, family="scene")
    with pytest.raises(ValueError, match="noisy"):
        problem.stability(3, family="noisy")


def test_a_scene_that_says_what_is_wrong():
    text = """
fn root(square: f64) -> (x) { x * x == square; }

#[scene]
fn scene(x: f64) -> (Data, Solution) { (Data { square: x * x + 1 }, Solution { x }) }
"""
    problem = eliminant.Problem(text)
    problem.search(progress=False)
    found = problem.stability(10, family="scene")
    assert (found.known_missed == 1).all() and found.incomplete == 10


def test_summaries_of_parts_are_that_of_the_whole():
    problem = eliminant.problem("relpose_5pt")
    whole = problem.stability(60, seed=3)
    summary = whole.summary()
    bounds = [0, 7, 8, 30, 60]
    parts = [problem.stability(end - at, seed=3, first=at).summary() for at, end in zip(bounds, bounds[1:])]
    assert eliminant.StabilitySummary.join(reversed(parts)) == summary
    assert eliminant.StabilitySummary.join(parts[:3]) != summary
    assert summary.instances == 60 and summary.totals["complex"] == 600 and summary.failed == 0
    order = np.argsort(-whole.forward_error)[:10]
    assert summary.worst == tuple((whole.forward_error[at], at) for at in order)
    for name in ("residual", "forward_error"):
        errors = np.sort(getattr(whole, name))
        assert sum(getattr(summary, name).values()) == 60
        for share, least in ((0.5, errors[29]), (0.95, errors[56]), (1.0, errors[-1])):
            assert least <= summary.quantile(share, name) <= 1.26 * least
    with pytest.raises(ValueError):
        eliminant.StabilitySummary.join([summary, problem.stability(1, seed=4).summary()])
    with pytest.raises(ValueError):
        eliminant.StabilitySummary.join([])
    nothing = problem.stability(0, seed=3).summary()
    assert np.isnan(nothing.quantile(0.5)) and eliminant.StabilitySummary.join([nothing, summary]) == summary


def test_errors_of_any_size_are_in_a_bin():
    from eliminant._stability_summary import histogram

    errors = np.array([0.0, 1e-300, 1.0, 1.0, 0.5, np.nextafter(1.0, 0.0), np.inf, 1e60, np.nan])
    assert histogram(errors) == {-400: 2, -4: 1, -1: 1, 0: 2, 399: 2}


CURVES = """
fn curves(c: [[f64; 28]; 2]) -> (x, y) {
    for f in c {
        dot(f, [MONOMIALS]) == 0;
    }
}
""".replace("MONOMIALS", ", ".join(f"x.pow({i}) * y.pow({j})" for i in range(7) for j in range(7 - i)))


def test_where_growing_finds_nothing_the_trace_gives_a_template(rng):
    """Two dense curves of degree 6, and no time to grow a template."""
    problem = eliminant.Problem(CURVES)
    few = {"budget": 1e-9, "trials": 10, "confirm": 10}
    with pytest.raises(eliminant.ProblemError, match="no elimination template within 100 columns"):
        problem.search(max_columns=100, **few)
    size = problem.search(**few)
    assert size.solutions == 36 and size.is_cut
    curves = rng.normal(size=(2, 28))
    points = problem.solve(curves).values
    assert len(points) > 0
    x, y = points.T
    monomials = np.array([x**i * y**j for i in range(7) for j in range(7 - i)])
    assert (np.abs(curves @ monomials) < 1e-8 * (np.abs(curves) @ np.abs(monomials))).all()


def test_the_trace_alone():
    problem = eliminant.Problem(CURVES)
    size = problem.search(trace=True, trials=10, confirm=10, shuffles=0)
    assert size.solutions == 36 and not size.is_cut


def test_interpreted_and_emitted_solvers_agree(rng):
    """Results of the problem, and vectors that are given up to scale, too."""
    names = ("relpose_5pt_rays", "pose_3pt", "fundamental_7pt", "relpose_6pt_focal_points", "pose_4pt_focal")
    for name in names:
        problem = eliminant.problem(name)
        data = [rng.normal(size=(20, *shape)) for _, shape in problem.data]
        interpreted, emitted = problem.solve(*data), getattr(eliminant, name)(*data)
        np.testing.assert_array_equal(interpreted.counts, emitted.counts)
        assert interpreted.names == emitted.names
        for array in emitted.names:
            np.testing.assert_allclose(interpreted[array], emitted[array], rtol=1e-6, atol=1e-8)


def test_complex_numbers(rng):
    problem = eliminant.Problem("""
fn quadratic(b: Complex<f64>, c: [Complex<f64>; 1]) -> (z: Complex<f64>, x) {
    z.pow(2) + b * z + c[0] == 0;
    x == z.re;
    Other { root: -b - z, modulus: sqrt(z * conj(z)) }
}
""")
    assert problem.data == (("b", (2,)), ("c", (1, 2))) and problem.fields == (("z", (2,)), ("x", ()))
    assert problem.unknowns == ("z.re", "z.im", "x") and problem.complex_numbers == ("b", "c", "z", "root")
    problem.search()
    b, c = rng.normal(size=50) + 1j * rng.normal(size=50), rng.normal(size=(50, 1)) + 1j * rng.normal(size=(50, 1))
    batch = problem.solve(b, c)
    # There is room for conjugates of the other root, too, which never solve.
    assert (batch.counts == 2).all() and batch.z.shape == (50, 4) and batch.z.dtype == np.complex128
    roots = np.array([np.roots([1, b, c[0]]) for b, c in zip(b, c)])
    for found, true in zip(batch.z[:, :2], roots):
        assert min(np.abs(found - true).max(), np.abs(found - true[::-1]).max()) < 1e-9
    np.testing.assert_allclose(batch.root, -b[:, None] - batch.z)
    np.testing.assert_allclose(batch.modulus, np.abs(batch.z))
    np.testing.assert_allclose(batch.x, batch.z.real, atol=1e-12)
    one = problem.solve(b[3], c[3])
    np.testing.assert_array_equal(one.z, batch.z[3, :2])
    parts = problem.solve(np.stack([b.real, b.imag], axis=-1), np.stack([c.real, c.imag], axis=-1))
    np.testing.assert_array_equal(parts.z, batch.z)
    with pytest.raises(TypeError, match="complex128"):
        eliminant.problem("trilateration").solve(np.eye(3) * 1j, np.ones(3))


def test_catalogue():
    names = eliminant.catalogue()
    assert list(names) == sorted(names) and "relpose_5pt" in names and len(names) >= 49
    with pytest.raises(ValueError, match="no problem `nothing`"):
        eliminant.problem("nothing")


def test_command(tmp_path):
    run = subprocess.run(
        [sys.executable, "-m", "eliminant", "new", "mine", "--dir", str(tmp_path)], check=True
    )
    assert run.returncode == 0 and (tmp_path / "mine.rs").exists()
    wrong = subprocess.run(
        [sys.executable, "-m", "eliminant", "check", "nothing.rs"], capture_output=True, text=True
    )
    assert wrong.returncode == 1 and re.search("cannot read `nothing.rs`", wrong.stderr)


def test_the_problem_of_the_readme():
    """The problem above is that of the documents."""
    readme = Path(__file__).parents[2] / "README.md"
    if not readme.exists():
        pytest.skip("the package is tested outside of its repository")
    assert "\n".join(GPS.splitlines()[2:]) in readme.read_text(encoding="utf-8")
