# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the cases of `raceway paper` and of the program that runs them, here a shell script."""

import shutil

import numpy as np
import pytest
from commands import reply
from host import ROOT
from raceway.inputs import InputError
from raceway.paper import cases, runner

PLAN = """
cases:
  few: {deck: inputs/in.6208, with: {load: [1000, 2000], entrainment: 0.41, passes: 1}}
  same: {deck: inputs/in.6208, with: {load: 2000, clearance_ratio: 0, entrainment: 0.41, passes: 1}}
  free: {deck: inputs/in.axial, with: {total_curvature: 0.08, clearance_ratio: 0.0035}}
products: {8a: [few], 9: [few, same], A.4: [free]}
"""
# this script logs its call, and fails for the load stated in the file `bad`
PROGRAM = """#!/bin/sh
echo "$@" >> runs.txt
bad=$(cat bad 2>/dev/null || echo none)
case "$*" in *"-var load $bad"*) echo 'ERROR: no such load (x.cpp:1)'; exit 1;; esac
echo done
"""


@pytest.fixture
def tree(tmp_path, monkeypatch):
    """Return a source tree that has a plan with three cases, and a script as its program."""
    for folder in ("bearings", "lubricants"):
        shutil.copytree(ROOT / "inputs" / folder, tmp_path / "inputs" / folder)
    for deck in ("in.6208", "in.axial"):
        shutil.copy(ROOT / "inputs" / deck, tmp_path / "inputs")
    (tmp_path / "inputs/paper").mkdir()
    (tmp_path / "inputs/paper/cases.yaml").write_text(PLAN)
    (tmp_path / "build").mkdir()
    (tmp_path / "build/liggghts").write_text(PROGRAM)
    (tmp_path / "build/liggghts").chmod(0o755)
    (tmp_path / "build/libraceway_liggghts.so").write_text("")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def ran(tree):
    path = tree / "runs.txt"
    return len(path.read_text().splitlines()) if path.exists() else 0


def run_all(tree):
    plan, told = cases.plan(tree), []
    outcome = runner.Runner(tree, tree / "store").run_all(
        plan.needed(plan.products), 2, lambda *what: told.append(what)
    )
    return outcome, told


def test_names_become_the_decks(tree):
    plan = cases.plan(tree)
    few, free = plan.cases["few"], plan.cases["free"][0]
    assert [dict(case.settings)["load"] for case in few] == ["1000", "2000"]
    assert all(("models", "paper") in case.settings for case in few)
    assert all(("settle", "1") in case.settings for case in few)
    # rad/s, U_r = omega r_pitch (1 - gamma^2)/2
    spin = 2 * 0.41 / (30.3e-3 * (1 - (6.3 / 30.3) ** 2))
    # the setting has 12 digits
    assert float(dict(few[0].settings)["rpm"]) == pytest.approx(spin * 30 / np.pi, rel=1e-11)
    # table A.1: B = 0.08 is a groove of 6.804 mm; table 3: P_d/D = 0.0035 is 44.1 um
    assert dict(free.settings) == {
        "clearance": "4.41e-05",
        "inner_groove": "0.006804",
        "outer_groove": "0.006804",
    }


def test_same_settings_are_one_case(tree):
    plan = cases.plan(tree)
    assert plan.cases["same"][0] == plan.cases["few"][1]
    assert len(plan.needed(["8a", "9"])) == 2


def test_the_plan_of_the_repository():
    plan = cases.plan(ROOT)
    assert set("6a 6b 8a 8b 9 10a 10b 11 12a 12b A.2 A.4 table-3 table-A.1".split()) <= set(
        plan.products
    )
    for case in plan.needed(plan.products):
        assert (ROOT / case.deck).is_file()


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("cases: {}", "'products'"),
        ("[1", "cases.yaml"),
        ("cases: {}\nproducts: {1: [none]}", "unknown cases: none"),
        (PLAN.replace("load: [1000, 2000]", "bearing: 6299"), "cannot read .*6299"),
    ],
)
def test_broken_plan(tree, text, message):
    (tree / "inputs/paper/cases.yaml").write_text(text)
    with pytest.raises(InputError, match=message):
        cases.plan(tree)


def test_runs_are_kept(tree):
    first, told = run_all(tree)
    assert ran(tree) == 3 and len(told) == 3 and not first.failures
    again, _ = run_all(tree)
    assert ran(tree) == 3 and again.folders == first.folders


def test_a_new_program_runs_again(tree):
    run_all(tree)
    (tree / "build/libraceway_liggghts.so").write_text("another")
    runs = runner.Runner(tree, tree / "store")
    runs.forget()
    assert not list((tree / "store").iterdir())
    run_all(tree)
    assert ran(tree) == 6


def test_failure_is_named_and_the_rest_runs(tree):
    (tree / "bad").write_text("1000")
    outcome, told = run_all(tree)
    assert len(outcome.folders) == 2 and len(told) == 3
    ((case, message),) = outcome.failures.items()
    assert (
        dict(case.settings)["load"] == "1000"
        and message == "exit code 1: ERROR: no such load (x.cpp:1)"
    )
    # there are no incomplete files
    assert not [path for path in (tree / "store").rglob("*") if path.name.startswith(".")]
    (tree / "bad").unlink()
    assert not run_all(tree)[0].failures


def test_command_names_the_failure(tree, capsys):
    (tree / "bad").write_text("1000")
    error = reply(capsys, "paper --figure 8a --jobs 1", code=1)
    assert "in.6208 load=1000 entrainment=0.41: exit code 1: ERROR" in error
    assert "1 of 2 cases failed; not made: 8a" in error


def test_command_lists(tree, capsys):
    lines = reply(capsys, "paper --list").splitlines()
    assert [line.split()[0] for line in lines] == ["8a", "9", "A.4"] and lines[0].endswith(
        "(2 runs)"
    )
    assert ran(tree) == 0


def test_command_refuses(tree, capsys, monkeypatch):
    assert "no figure or table 7; there are 8a, 9, A.4" in reply(capsys, "paper --figure 7", code=1)
    assert "not a positive whole number" in reply(capsys, "paper --jobs 0", code=2)
    (tree / "build/liggghts").unlink()
    assert "build/liggghts is missing: run `make build`" in reply(capsys, "paper", code=1)
    monkeypatch.chdir("/")
    assert "run this command in Raceway's source tree" in reply(capsys, "paper", code=1)
