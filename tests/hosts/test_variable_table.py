# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs obey the table of variables: its ranges, its defaults, and which data must be given."""

import re

import pytest
from host import ROOT, refuses, run, succeed
from raceway import core
from raceway.sweeps.points import deck_variables
from raceway.sweeps.variable_table import DATA, needed, rows
from recorded_runs import differ

RANGES = {row["name"]: row for row in rows() if row["range"]}


def test_one_row_for_a_variable():
    assert len({row["name"] for row in rows()}) == len(rows())


def ends(name):
    """Return the values at the ends of the range of a variable, and values outside it."""
    low, high, *more = RANGES[name]["range"].split()
    if low == "one_of":
        return [high, *more], ["nonsense", ""]
    inside = [low, high, *more[1:]]
    outside = [1.1 * float(high), float(low) - 0.1 * abs(float(low) or 1)]
    outside += [float(low) + 0.5] if more == ["whole"] else []
    return inside, [*(f"{value:.17g}" for value in outside), "nan", "0x10", "+1", "much"]


@pytest.mark.parametrize("name", RANGES)
def test_range(tmp_path, name):
    """The range of a variable is that of the table, and a run refuses a value beyond it."""
    inside, outside = ends(name)
    assert [value for value in inside if core.wrong_value(name, value)] == []
    assert [value for value in outside if not core.wrong_value(name, value)] == []
    kind, value = RANGES[name]["of"], outside[0]
    deck = "inputs/in.many" if kind == "in.many" else "inputs/in.6208"
    words = {"bearing": 7208} if kind == "usual data" else {}
    words |= {"lubricant": "vg46"} if kind == "oil over temperature" else {}
    end = run(deck, out=tmp_path / "run", **words, **{name: value})
    shown = f"'{value}'" if value == "nonsense" else f"{float(value):.6g}"
    unit = RANGES[name]["unit"]
    assert end.code > 0
    assert f"{name}{f' ({unit})' if unit else ''} is {shown}, must be " in end.error, end.error


# {kind of data: file that has all data of this kind}
WHOLE = {
    "bearing data": "bearings/6208",
    "usual data": "bearings/7208",
    "oil data": "lubricants/mineral",
}
NEEDED = [(kind, name) for kind in WHOLE for name in needed(kind) if name != "pocket_play"]
NEEDED += [("usual data", "balls"), ("usual data", "ball_diameter")]


@pytest.mark.parametrize(("kind", "name"), NEEDED)
def test_missing(tmp_path, kind, name):
    """Data to which no default applies must be given, except for the play of a pocket, which is
    estimated."""
    file = tmp_path / "mine"
    text = (ROOT / "inputs" / WHOLE[kind]).read_text()
    file.write_text(re.sub(rf"^variable {name} .*\n", "", text, flags=re.M))
    command, variable = (
        ("pair_style bearing", "lubricant") if kind == "oil data" else ("bearing",) * 2
    )
    says = f"{command}: '{file}' has no variable {name}"
    refuses("inputs/in.6208", says, out=tmp_path / "run", **{variable: file})


SHORT = {"passes": 1, "samples": 20, "settle": 1, "rpm": 3000, "models": None}  # None: not given
RING, VIBRATION = "bearing/cage/ring", "bearing/vibration"
# {name: (variables of a scene, styles whose variables it does not have)}
SCENES = {
    "ring": ({}, {VIBRATION}),
    "chain": ({"cage": "chain", "models": "paper"}, {RING, VIBRATION}),
    "housing": ({"housing": "springs"}, {VIBRATION}),
    "vibration": ({"integrator": "vibration", "models": "paper"}, {RING}),
    "verlet": ({"integrator": "verlet", "models": "paper"}, {RING, VIBRATION}),
    "heat": ({"heat": "yes", "warm_time": 10, "lubricant": "vg46"}, {VIBRATION}),
    "surroundings": ({"surroundings": "cavitated"}, {VIBRATION}),
}


@pytest.mark.parametrize("scene", SCENES)
def test_default(tmp_path, scene):
    """A run that is given all defaults of the table is bitwise identical to one without them."""
    own, absent = SCENES[scene]
    own = SHORT | own
    of = {row["name"]: row["of"] for row in rows()}
    known = deck_variables(ROOT / "inputs/in.6208").items()
    defaults = {name: value for name, value in known if value and of[name] not in absent | DATA}
    assert len(defaults) > 50
    given = {name: value for name, value in own.items() if value is not None}
    for folder, words in (("short", own), ("whole", defaults | given)):
        succeed("inputs/in.6208", **words | {"out": tmp_path / folder})
    assert differ(tmp_path / "short", tmp_path / "whole") == []


@pytest.mark.parametrize(
    ("kind", "name", "value"),
    [
        ("bearing", "bore_diameter", "40"),  # mm instead of m
        ("bearing", "bore_diameter", "5mm"),
        ("bearing", "outside_diameter", "80"),
        ("bearing", "bearing_width", "-18e-3"),
        ("lubricant", "oil_density_40", "0.8629"),  # g/cm3 instead of kg/m3
    ],
)
def test_data_that_are_not_needed_are_checked(tmp_path, kind, name, value):
    """The bore and the outside diameter enter the starvation of a contact."""
    source = "bearings/6208" if kind == "bearing" else "lubricants/vg46"
    file = tmp_path / "mine"
    text = (ROOT / "inputs" / source).read_text()
    file.write_text(re.sub(rf"^(variable {name} +index) \S+", rf"\1 {value}", text, flags=re.M))
    says = (f"'{file}': {name}", "must be ")
    refuses("inputs/in.6208", *says, out=tmp_path / "run", **{kind: file})
