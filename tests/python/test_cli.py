# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the command line: what it prints, to which stream, and with which exit code."""

import argparse
import json
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest
import raceway
from commands import reply
from raceway.cli import _parser, main
from raceway.commands import GROUPS
from raceway.runs.statics import statics
from raceway.runs.summary import summary
from raceway.runs.summary_table import table
from raceway.runs.tables import RunTables


def figures(folder):
    """Return the results of a run, and the results of statics at its operating point."""
    tables = RunTables(folder)
    found = summary(tables)
    return found | statics(tables, found)


def test_summary(folder, capsys):
    assert main(["summary", str(folder)]) == 0
    printed = capsys.readouterr()
    assert printed.out == table(figures(folder)) + "\n"
    assert printed.err == ""


def test_json(folder, capsys):
    assert main(["summary", str(folder), "--json"]) == 0
    assert json.loads(capsys.readouterr().out) == figures(folder)


def test_plot(folder, tmp_path, capsys):
    assert main(["plot", str(folder)]) == 0
    assert (folder / "overview.png").read_bytes()[:4] == b"\x89PNG"
    assert main(["plot", str(folder), "--out", str(tmp_path / "other.png")]) == 0
    assert (tmp_path / "other.png").stat().st_size > 10_000
    assert capsys.readouterr().out.split() == [
        str(folder / "overview.png"),
        str(tmp_path / "other.png"),
    ]


@pytest.mark.parametrize("command", ["summary", "plot"])
def test_unusable_run(folder, capsys, command):
    (folder / "run.yaml").write_text("bearing: 6208\n")
    assert main([command, str(folder)]) == 1
    printed = capsys.readouterr()
    assert printed.out == ""
    assert printed.err.startswith("raceway: run has not finished: ")


@pytest.mark.parametrize(
    "arguments, said",
    [
        (["sumary", "x"], "argument COMMAND: there is no 'sumary'; did you mean summary?"),
        (["xyzzy"], "argument COMMAND: there is no 'xyzzy'\n"),
        (["static", "--laod", "5"], "there is no option --laod; did you mean --load"),
        (["static", "--laod=5"], "there is no option --laod; did you mean --load"),
        (["static", "--load", "5", "--qqq"], "there is no option --qqq\n"),
        (["static", "--models", "ful"], "no 'ful'; did you mean full? (choose from paper, full"),
        (["summary", "x", "y"], "unrecognized arguments: y"),
    ],
)
def test_a_wrong_word_names_the_nearest(arguments, said, capsys):
    assert said in reply(capsys, arguments, code=2)


def test_alone_it_prints_the_commands_by_group(capsys):
    """Each command appears exactly once, under one heading, and every name in a group is a
    command."""
    assert main([]) == 0
    text = capsys.readouterr().out
    assert text == _parser().format_help() and "Exit codes: 0 done; 1 " in text
    listed = [name for names in GROUPS.values() for name in names]
    assert len(listed) == len(set(listed)) and set(listed) <= set(subcommands())
    assert all(f"\n{heading}:\n" in text for heading in GROUPS)
    for name in subcommands():
        assert len(re.findall(rf"\n    {name} ", text)) == 1


def subcommands():
    """Return {name: parser} for all subcommands."""
    return next(
        action.choices
        for action in _parser()._actions
        if isinstance(action, argparse._SubParsersAction)
    )


@pytest.mark.parametrize("name", subcommands())
def test_help_teaches(name):
    """The help of every subcommand contains examples that the parser accepts, and lists the exit
    codes."""
    text = subcommands()[name].format_help()
    examples = [
        re.split(r"  +|\|", line.strip())[0]
        for line in text.splitlines()
        if line.startswith(f"  raceway {name}")
    ]
    assert examples and "Exit codes: 0 " in text
    for example in examples:
        _parser().parse_args(shlex.split(example)[1:])


@pytest.mark.parametrize("option", ["bearing", "load", "models", "phase", "clearance"])
def test_two_dashes_are_no_value(capsys, option):
    said = reply(capsys, ["static", "--rpm", "10", f"--{option}=--"], code=2)
    assert f"argument --{option}: expected a value, not '--'" in said


def run_module(*arguments, **options):
    environment = {
        **os.environ,
        "PYTHONPATH": str(Path(raceway.__file__).parents[1]),
        "PYTHONDONTWRITEBYTECODE": "1",
    }
    return subprocess.run(
        [sys.executable, "-m", "raceway", *arguments],
        env=environment,
        text=True,
        timeout=60,
        capture_output=True,
        **options,
    )


def test_as_a_program(folder, tmp_path):
    done = run_module("summary", str(folder))
    assert (done.returncode, done.stderr) == (0, "")
    failed = run_module("summary", str(tmp_path))
    assert failed.returncode == 1
    assert "Traceback" not in failed.stderr and "has no record.nc" in failed.stderr
    assert run_module("--version").stdout == f"raceway {raceway.__version__}\n"


def test_nobody_listens(folder):
    """`raceway summary DIR | head -0` must not cause a traceback."""
    reading, writing = os.pipe()
    os.close(reading)
    environment = {**os.environ, "PYTHONPATH": str(Path(raceway.__file__).parents[1])}
    done = subprocess.run(
        [sys.executable, "-B", "-m", "raceway", "summary", str(folder)],
        env=environment,
        stdout=writing,
        stderr=subprocess.PIPE,
        timeout=60,
    )
    os.close(writing)
    assert done.stderr == b""
