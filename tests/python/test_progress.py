# SPDX-License-Identifier: GPL-2.0-or-later
"""The line that tells how far a long file is read: on a terminal, from the command, and not
otherwise."""

import io
import sys

import pytest
from raceway import progress
from raceway.cli import main
from raceway.runs.summary import summary
from raceway.runs.tables import RunTables


class Terminal(io.StringIO):
    def isatty(self):
        return True


@pytest.fixture
def slow(monkeypatch):
    """Everything is long, and read in many pieces."""
    monkeypatch.setattr(progress, "AFTER", -1.0)
    monkeypatch.setattr("raceway.runs.dump.BLOCK", 10_000)
    monkeypatch.setattr(progress, "on", False)


def test_terminal(folder, slow, monkeypatch, capsys):
    monkeypatch.setattr(sys, "stderr", Terminal())
    assert main(["summary", str(folder)]) == 0
    text = sys.stderr.getvalue()
    assert "\rreading contacts.dump: " in text and "\rreading balls.dump: " in text and "%" in text
    assert text.endswith("\r\033[K") and "\n" not in text


def test_no_terminal(folder, slow, capsys):
    assert main(["summary", str(folder)]) == 0
    assert capsys.readouterr().err == ""


def test_library_is_quiet(folder, slow, monkeypatch):
    monkeypatch.setattr(sys, "stderr", Terminal())
    summary(RunTables(folder))
    assert sys.stderr.getvalue() == ""
