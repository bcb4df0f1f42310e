# SPDX-License-Identifier: GPL-2.0-or-later
"""The commands that `make` plans are checked: `make run` builds only LIGGGHTS, host-dependent
sources share compilation units, and goals of one call do not write the same files at once."""

import itertools
import re
import subprocess

import pytest
from host import ROOT


def plan(*words):
    """Return the commands that `make` would run."""
    return subprocess.run(
        ["make", "-n", *words], cwd=ROOT, text=True, capture_output=True, check=True
    ).stdout


@pytest.fixture(scope="module")
def everything():
    """Return the commands that `make build` would run in an empty tree."""
    return plan("-B", "build")


def compiled(commands):
    """Return {object: source} for all calls to the C++ compiler."""
    return {
        made: source
        for source, made in re.findall(r" -c (\S+\.cpp) -o (\S+\.o)$", commands, re.MULTILINE)
    }


def test_make_run_builds_liggghts_alone():
    run = plan("-B", "run")
    assert "build/liggghts -in inputs/in.6208" in run
    assert not re.search(r"lammps|test,docs|raceway_physics", run)


def test_every_source_is_compiled_once_for_a_host(everything):
    """A source that includes no host headers is compiled once for all hosts. Every other source is
    compiled once for each of the three hosts, either alone or in a unit with other sources."""
    made = compiled(everything)
    rooms = ("core/*", "contacts", "deck", "ranks", "styles")
    sources = {
        str(p.relative_to(ROOT))
        for room in rooms
        for p in (ROOT / "src-package").glob(f"{room}/*.cpp")
        if p.parent.name != "interface"
    }
    alone = [source for source in made.values() if source in sources]
    units = {source for source in made.values() if source.startswith("build/units/")}
    units.remove("build/units/interface.cpp")  # belongs to the library for Python
    inside = [
        source
        for unit in units
        for source in re.findall(r'#include "(.*)"', (ROOT / unit).read_text())
    ]
    assert sorted([*alone, *inside]) == sorted(sources)
    for unit in units:
        hosts = 1 if "/core_" in unit else 3
        assert list(made.values()).count(unit) == hosts, unit


def test_an_edit_of_one_part_makes_few_objects_again(everything):
    """After an edit to one part, only a few objects, counted over all hosts, are rebuilt. The
    compiler lists the headers of each object during the build."""
    again = [
        made
        for made in compiled(everything)
        if "parts/part_drag.h" in (ROOT / made).with_suffix(".d").read_text()
    ]
    assert 0 < len(again) <= 15, again


GOALS = ("run", "liggghts", "lammps", "build", "interfaces")


@pytest.mark.parametrize("goals", list(itertools.permutations(GOALS, 2)), ids=" ".join)
def test_goals_of_one_call_follow_each_other(goals, tmp_path):
    """Each goal calls make, here a script in its place, to compile. The calls are never made side
    by side, since they write the same objects. The packages of LAMMPS are installed for its goals
    alone, in any order of the goals."""
    script, log = tmp_path / "make", tmp_path / "log"
    script.write_text(f'#!/bin/sh\necho "start $*" >> {log}\nsleep 0.1\necho end >> {log}\n')
    script.chmod(0o755)
    plan("-j4", *goals, f"MAKE={script}")  # runs the calls of make alone
    lines = log.read_text().splitlines()
    assert [line.split()[0] for line in lines] == ["start", "end"] * (len(lines) // 2), lines
    lammps = {"lammps", "build"} & set(goals)
    assert any("liblammps-dev" in line for line in lines) == bool(lammps)


def test_units_are_written_by_several_calls_at_once():
    """The file of a unit is written as a whole, even if several calls of make write it."""
    units = [f"build/units/{path.name}" for path in (ROOT / "build/units").glob("*.cpp")]
    before = {unit: (ROOT / unit).stat().st_mtime_ns for unit in units}
    calls = [
        subprocess.Popen(["make", "-s", *units], cwd=ROOT, stderr=subprocess.PIPE, text=True)
        for _ in range(6)
    ]
    said = [call.communicate()[1] for call in calls]
    assert units and not any(call.returncode for call in calls), said
    assert {unit: (ROOT / unit).stat().st_mtime_ns for unit in units} == before
