# SPDX-License-Identifier: GPL-2.0-or-later
"""Run the Python sessions shown in docs/static.rst; tests/docs/test_examples.py runs its
commands."""

import doctest

from host import ROOT


def test_python(monkeypatch):
    monkeypatch.chdir(ROOT)
    result = doctest.testfile(str(ROOT / "docs/static.rst"), module_relative=False)
    assert result.attempted > 10 and result.failed == 0
