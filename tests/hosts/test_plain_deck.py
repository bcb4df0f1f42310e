# SPDX-License-Identifier: GPL-2.0-or-later
"""inputs/in.bearing, the main deck in plain commands, gives the bits of inputs/in.6208."""

import pytest
import raceway
from host import ROOT, run, succeed
from scipy.io import netcdf_file

SAME = dict(models="paper", settle=1, passes=1, samples=100)
FLAWS = dict(
    flaw_outer="notch -1.5 1.0e-3 full 1.0e-4 5.0e-5",
    flaw_ball="wave 12 2.0e-7 0.2",
    flawed_ball="2 5",
)
CASES = {
    "paper": {},
    "full, two ranks": dict(models="full", ranks=2),
    "eyring, combined load": dict(
        models="eyring", lubricant="vg46", temperature=60, axial=1000, moment_x=5
    ),
    "film, given viscosity": dict(models="film", viscosity=0.05, clearance=1e-5),
    "parts left out, slices": dict(models="full", without="drag+starvation", spin_law="slices"),
    "dry": dict(lubricant="dry", models="full"),
    "angular contact": dict(bearing="7205B", axial=1000, lubricant="vg46", models="full"),
    "no cage": dict(cage="no"),
    "flaws": FLAWS,
    "housing, surroundings": dict(housing="springs", surroundings="flooded", unbalance=1e-5),
    "damping": dict(integrator="damping"),
    "vibration": dict(integrator="vibration", samples=200),
    "velocity Verlet": dict(integrator="verlet", rpm=5000),
}


def values(folder):
    """Variables of a record, as bytes."""
    with netcdf_file(folder / "record.nc", mmap=False) as file:
        return {name: one.data.tobytes() for name, one in file.variables.items()}


def same(one, other):
    one, other = values(one), values(other)
    assert one.keys() == other.keys()
    assert [name for name in one if one[name] != other[name]] == []


@pytest.mark.parametrize("name", CASES)
def test_bits_of_the_deck_with_modules(tmp_path, name):
    case = {**SAME, **CASES[name]}
    succeed("inputs/in.6208", out=tmp_path / "modules", **case)
    succeed("inputs/in.bearing", out=tmp_path / "plain", **case)
    same(tmp_path / "modules", tmp_path / "plain")
    one, other = (raceway.open(tmp_path / deck) for deck in ("modules", "plain"))
    for key in ("load_N", "rpm", "axial_N", "bearing", "lubricant", "models", "given_data"):
        assert one.settings[key] == other.settings[key]
    assert one.summary()["friction_torque_N_m"] == other.summary()["friction_torque_N_m"]


@pytest.mark.parametrize("host", ["lammps", "wheel"])
def test_hosts(tmp_path, host):
    case = dict(models="full", passes=1, axial=500)
    for folder, program in (("one", "liggghts"), ("other", host)):
        succeed("inputs/in.bearing", out=tmp_path / folder, host=program, **case)
    same(tmp_path / "one", tmp_path / "other")


@pytest.mark.parametrize("host", ["liggghts", "lammps"])
def test_goes_on(tmp_path, host):
    """One ball pass and another are two; the text dumps, too."""
    case = dict(settle=1, rpm=2000, dumps="yes", host=host)
    for folder in ("whole", "parts"):
        succeed("inputs/in.bearing", out=tmp_path / folder, passes=2 - (folder == "parts"), **case)
    succeed("inputs/in.bearing", out=tmp_path / "parts", passes=2, resume="yes", **case)
    same(tmp_path / "whole", tmp_path / "parts")
    for name in ("contacts.dump", "balls.dump", "rings.dat"):
        assert (tmp_path / "whole" / name).read_text() == (tmp_path / "parts" / name).read_text()


def test_dumps_of_the_deck_with_modules(tmp_path):
    for deck in ("6208", "bearing"):
        succeed(f"inputs/in.{deck}", out=tmp_path / deck, dumps="yes", **SAME)
    for name in ("contacts.dump", "balls.dump", "rings.dat"):
        assert (tmp_path / "6208" / name).read_text() == (tmp_path / "bearing" / name).read_text()


def test_settles_by_itself(tmp_path):
    """`settle auto`, the default: the record has how far, and the models are full."""
    succeed("inputs/in.bearing", out=tmp_path, passes=1)
    found = raceway.open(tmp_path)
    assert found.settings["models"] == "full" and found.settings["settled_passes"] >= 2
    assert found.settings["settled_torque"] < 1e-2 and found.settings["settled_load"] < 1e-3


@pytest.mark.parametrize(
    "words, says",
    [
        ({"rpm": 0}, "bearing: rpm (1/min) is 0, must be from 1 to 100000"),
        ({"load": "5kN"}, "bearing: load (N) must be a number like 5000 or 5.0e3, not '5kN'"),
        ({"lod": 1}, "bearing: -var lod: the deck has no such variable, nearest is 'load'"),
        ({"lubricant": "honey"}, "pair_style bearing: there is no 'honey' in folder inputs/lub"),
        ({"models": "papers"}, "pair_style bearing: there is no model 'papers'; there is: paper"),
        ({"without": "spinn"}, "there is no part 'spinn' to leave out"),
        ({"temperature": 80}, "has values for 40 C only, not for 80 C"),
        ({"viscosity": -1}, "pair_style bearing: viscosity (Pa s) is -1, must be from 1e-05 to"),
        ({"integrator": "euler"}, "integrator is 'euler', must be one of implicit, damping"),
        ({"cage": "maybe"}, "bearing: cage is 'maybe', must be one of yes, no"),
    ],
    ids=lambda value: "" if isinstance(value, str) else "-".join(value),
)
def test_errors(tmp_path, words, says):
    done = run("inputs/in.bearing", out=tmp_path / "run", **words)
    assert done.code != 0
    assert says in done.error, done.error
    assert not (tmp_path / "run" / "record.nc").exists()


def test_plain():
    """At most 60 lines, no include."""
    lines = (ROOT / "inputs/in.bearing").read_text().splitlines()
    assert len(lines) <= 60
    assert not [line for line in lines if line.startswith("include")]
