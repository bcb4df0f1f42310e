# SPDX-License-Identifier: GPL-2.0-or-later
"""What docs/static.rst shows is what comes out, and so are the examples in docstrings."""

import doctest
import re
import shlex
from pathlib import Path

import pytest
from raceway import lubrication, static
from raceway.cli import main

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/static.rst"


def consoles():
    """(command line, what it prints) of the page's console blocks."""
    for block in re.findall(r"\.\. code-block:: console\n\n((?:   .*\n|\n)+)", PAGE.read_text()):
        first, *rest = re.sub(r"(?m)^   ", "", block).strip().splitlines()
        yield first.removeprefix("$ raceway "), "\n".join(rest) + "\n"


@pytest.mark.parametrize("command, shown", list(consoles()))
def test_commands(command, shown, capsys, monkeypatch):
    monkeypatch.chdir(ROOT)
    main(shlex.split(command))
    printed = capsys.readouterr()
    assert doctest.OutputChecker().check_output(shown, printed.out + printed.err, doctest.ELLIPSIS), printed.out + printed.err


def test_there_are_commands():
    assert len(list(consoles())) == 3


def test_python(monkeypatch):
    monkeypatch.chdir(ROOT)
    result = doctest.testfile(str(PAGE), module_relative=False)
    assert result.attempted > 10 and result.failed == 0


@pytest.mark.parametrize("module", [static, lubrication])
def test_docstrings(module):
    result = doctest.testmod(module)
    assert result.attempted and result.failed == 0
