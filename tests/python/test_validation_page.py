# SPDX-License-Identifier: GPL-2.0-or-later
"""The tests that docs/validation.rst names for T1 to T12 exist."""

import re

import pytest
from host import ROOT

ROW = re.compile(r"\* - (T\d+)\n +- .*\n +- ``(.*)``\n +- ``(.*)``")
ROWS = ROW.findall((ROOT / "docs/validation.rst").read_text())


def test_all_are_there():
    assert [row[0] for row in ROWS] == [f"T{number}" for number in range(1, 13)]


@pytest.mark.parametrize(("number", "engine", "package"), ROWS)
def test_named_tests_exist(number, engine, package):
    """The cells contain entries `file: names`, separated by semicolons, where each name is part of
    the name of a test."""
    for folder, words in (("tests/physics", engine), ("tests/python", package)):
        for one in words.split("; "):
            name, _, wanted = one.partition(": ")
            path = ROOT / ("tests" if "/" in name else folder) / f"{name}.py"
            tests = re.findall(r"^def test_(\w+)", path.read_text(), re.M)
            for part in filter(None, wanted.split(", ")):
                assert any(part in test for test in tests), (one, part)
