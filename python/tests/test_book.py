"""The page of the book does what it says."""

from __future__ import annotations

import contextlib
import io
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "book" / "src" / "python.md"


def test_the_page_of_the_book(monkeypatch):
    """Blocks of Python run one after another; each output is that of the block before it."""
    if not PAGE.exists():
        pytest.skip("the package is tested outside of its repository")
    monkeypatch.chdir(ROOT)
    page = PAGE.read_text(encoding="utf-8")
    blocks = re.findall(r"(<!-- output -->\n)?```(\w+)\n(.*?)```", page, flags=re.DOTALL)
    names: dict[str, object] = {}
    printed, ran, compared = "", 0, 0
    for is_output, language, text in blocks:
        if is_output:
            assert printed == text
            compared += 1
        elif language == "python":
            with contextlib.redirect_stdout(io.StringIO()) as out:
                exec(compile(text, str(PAGE), "exec"), names)
            printed = out.getvalue()
            ran += 1
    assert ran >= 6 and compared == ran
