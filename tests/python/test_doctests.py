# SPDX-License-Identifier: GPL-2.0-or-later
"""The examples in docstrings and in sessions on the pages produce the results that they show."""

import doctest
import importlib
import pkgutil

import pytest
import raceway
from host import ROOT

MODULES = [
    found.name
    for found in pkgutil.walk_packages(raceway.__path__, "raceway.")
    if not found.name.endswith("__main__")
]


@pytest.mark.parametrize("name", MODULES)
def test_examples(name):
    assert doctest.testmod(importlib.import_module(name)).failed == 0


PAGES = [page for page in sorted(ROOT.glob("docs/*.rst")) if ">>> " in page.read_text()]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_pages(page, monkeypatch):
    monkeypatch.chdir(ROOT)
    found = doctest.testfile(str(page), module_relative=False)
    assert found.failed == 0 and found.attempted > 0


def test_there_are_some():
    finder = doctest.DocTestFinder(exclude_empty=True)
    assert (
        sum(
            len(test.examples)
            for name in MODULES
            for test in finder.find(importlib.import_module(name))
        )
        >= 10
    )
