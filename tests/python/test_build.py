# SPDX-License-Identifier: GPL-2.0-or-later
"""The commands that `make` plans are checked: `make run` builds only LIGGGHTS, and host-dependent
sources share compilation units."""

import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


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
